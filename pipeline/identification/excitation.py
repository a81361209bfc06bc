"""What a log excites: wells, basis centres, voltage levels, frequencies; the facts behind "what to add"."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from pipeline.errors import InputError
from pipeline.identification.coverage import Coverage, coverage
from pipeline.identification.information import Conditioning, Weights, conditioning
from pipeline.identification.rbf import InputLaw, input_signal
from pipeline.numerics.arrays import BoolArray, FloatArray, IntArray
from pipeline.scoring.wells import NoWells, Wells, find_wells

ACTING = 0.1
"""Share of its largest value above which an input acts, as in `coverage`."""
_INTERMEDIATE = (0.15, 0.85)  # of the largest value: neither off nor full
_POWER_SHARE = 0.95
_SHORTEST = 64  # samples of a stretch that is worth a spectrum
_WINDOW = 8.0  # s
_LEAST_RINGING = 0.5  # Hz; below it a peak of the velocity's spectrum is the excitation's, not the joint's


@dataclass(frozen=True)
class Excitation:
    """What one log excites, in SI.

    Attributes
    ----------
    centres : FloatArray, shape (M,)
        Basis centres over the range of q.
    visits : Coverage
        Samples nearest to each centre, and those under each input.
    wells : Wells or NoWells
        Rest positions without input.
    switches : (int, int)
        Passages of the barrier to the right and to the left; zeros without two wells.
    largest : FloatArray, shape (K,)
        Largest magnitude of each input.
    intermediate : FloatArray, shape (K,)
        Share of an input's acting time in which it is between 15 and 85 % of its largest value.
    together : float
        Share of the time in which two inputs act at once; 0 for one input.
    conditioning : Conditioning
        Of the regressor of eq. 40 with these centres, on unit-norm columns.
    interval : float
        Sample interval [s].
    signals : FloatArray, shape (N, K)
        The inputs as they act.
    velocity : FloatArray, shape (n,)
        Of the longest stretch.
    """

    centres: FloatArray
    visits: Coverage
    wells: Wells | NoWells
    switches: tuple[int, int]
    largest: FloatArray
    intermediate: FloatArray
    together: float
    conditioning: Conditioning
    interval: float
    signals: FloatArray
    velocity: FloatArray

    # Spectra are evaluated when asked for: the library takes longer to load than all the rest.
    @cached_property
    def bandwidth(self) -> FloatArray:
        """Frequency [Hz] below which 95 % of the power of an input's changes lies, shape (K,); 0 for a constant one."""
        return np.array([_bandwidth(column, self.interval) for column in self.signals.T])

    @cached_property
    def ringing(self) -> float | None:
        """Frequency [Hz] at which the velocity has most power above 0.5 Hz."""
        return _ringing(self.velocity, self.interval)


def examine_excitation(
    q: FloatArray,
    v: FloatArray,
    segment: IntArray,
    interval: float,
    *,
    inputs: InputLaw = "squared",
    basis_functions: int = 10,
    smoothing: float = 0.5,
) -> Excitation:
    """Examine a uniform record.

    Parameters
    ----------
    q : FloatArray, shape (N,)
        Displacement; NaN where masked.
    v : FloatArray, shape (N, K)
        Inputs, finite.
    segment : IntArray, shape (N,)
        Number of the gap-free stretch; negative where masked.
    interval : float
        Sample interval [s].
    inputs : {"squared", "linear"}
        How the inputs act.
    basis_functions, smoothing : int, float
        M and σ_n of the curves that are to be identified.

    Raises
    ------
    InputError
        No valid stretch, or a displacement that never changes.
    """
    valid = (segment >= 0) & np.isfinite(q)
    stretches = [segment == number for number in np.unique(segment[valid])]
    stretches = [rows for rows in stretches if np.count_nonzero(rows) >= _SHORTEST]
    if not stretches:
        raise InputError(f"no gap-free stretch has {_SHORTEST} samples of {interval:g} s; there is nothing to identify")
    motions = [(q[rows], np.gradient(q[rows], interval), v[rows]) for rows in stretches]
    largest = np.abs(v[valid]).max(axis=0)
    weights = Weights.over(
        np.concatenate([each[0] for each in motions]),
        np.concatenate([each[1] for each in motions]),
        largest,
        basis_functions=basis_functions,
        smoothing=smoothing,
        inputs=inputs,
    )
    information: FloatArray = np.sum([weights.information(*each, interval) for each in motions], axis=0)
    wells = find_wells([(q, v, interval)])
    acting: BoolArray = np.abs(v) > ACTING * np.maximum(largest, np.finfo(float).tiny)
    return Excitation(
        centres=weights.centres,
        visits=coverage(weights.centres, [each[0] for each in motions], [each[2] for each in motions]),
        wells=wells,
        switches=(0, 0) if isinstance(wells, NoWells) else _switches(q[valid], wells),
        largest=largest,
        intermediate=_intermediate(np.abs(v), largest, acting),
        together=float(np.mean(acting.all(axis=1))) if v.shape[1] > 1 else 0.0,
        conditioning=conditioning(information),
        interval=interval,
        signals=input_signal(v, inputs),
        velocity=max(motions, key=lambda each: each[0].size)[1],
    )


def _switches(q: FloatArray, wells: Wells) -> tuple[int, int]:
    """Passages from one well's side to the other, counted when a quarter of the way beyond the barrier."""
    margin = 0.25 * (wells.right - wells.left) / 2.0
    side = np.where(q > wells.barrier + margin, 1, np.where(q < wells.barrier - margin, -1, 0))
    steps = np.diff(side[side != 0])
    return int(np.count_nonzero(steps > 0)), int(np.count_nonzero(steps < 0))


def _intermediate(magnitude: FloatArray, largest: FloatArray, acting: BoolArray) -> FloatArray:
    low, high = _INTERMEDIATE
    between = (magnitude > low * largest) & (magnitude < high * largest) & acting
    share: FloatArray = between.sum(axis=0) / np.maximum(acting.sum(axis=0), 1)
    return share


def _spectrum(x: FloatArray, interval: float) -> tuple[FloatArray, FloatArray]:
    """Frequencies [Hz] and power of x without its mean (Welch's average)."""
    from scipy.signal import welch

    frequency, power = welch(x, 1.0 / interval, nperseg=min(x.size, round(_WINDOW / interval)), detrend="constant")
    return np.asarray(frequency, dtype=np.float64), np.asarray(power, dtype=np.float64)


def _bandwidth(x: FloatArray, interval: float) -> float:
    if np.ptp(x) == 0.0:
        return 0.0
    frequency, power = _spectrum(x, interval)
    cumulated = np.cumsum(power)
    return float(frequency[np.searchsorted(cumulated, _POWER_SHARE * cumulated[-1])])


def _ringing(qdot: FloatArray, interval: float) -> float | None:
    frequency, power = _spectrum(qdot, interval)
    fast = frequency >= _LEAST_RINGING
    return float(frequency[fast][np.argmax(power[fast])]) if power[fast].any() else None
