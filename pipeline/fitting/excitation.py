"""Excitation of a log: wells, basis centres, voltage levels, frequencies; the facts behind "what to add".

Data are unfit for training where they show nothing of places, inputs or wells: curves would be invented there.
The training logs of thirty joints and a quarter drone have at least 4 samples at each of ten centres and a condition
number of at most 81; the bounds leave room below and above.
"""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ..device.device import Device
from ..errors import DataRefusedError, InputError
from ..numerics.arrays import BoolArray, FloatArray, IntArray
from ..scoring.wells import NoWells, Wells, find_wells, snaps
from ..settings.models import CENTRES, SMOOTHING
from ..signals.findings import Finding, Number, refusal
from ..signals.noise import REACH, is_idle
from .information import ACTING, Conditioning, Coverage, ScaledRegressor, conditioning, coverage

_POWER_SHARE = 0.95
_SHORTEST = 64
_WINDOW = 8.0
"""Samples of a segment that is worth a spectrum, and length [s] of its windows."""
_RINGING_ABOVE = 4
_RINGING_BELOW = 0.8
"""Line of the spectrum and share of the Nyquist frequency between which a peak is the device's: below it is the
excitation's, above it is noise or folded over."""
_BAND = 0.1
"""Half width of a peak, and of the bands half its frequency beside it, as a share of its frequency."""


@dataclass(frozen=True)
class Excitation:
    """Excitation of one log, in SI.

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
        Share of an input's acting time in which it is as far from its largest value as from zero, a tenth of it at
        least.
    together : float
        Share of the time in which two inputs act at once; 0 for one input.
    conditioning : Conditioning
        Of the regressor of eq. 40 with these centres, on unit-norm columns.
    interval : float
        Sample interval [s].
    signals : FloatArray, shape (N, K)
        The inputs as they act.
    displacement : FloatArray, shape (n,)
        Of the longest segment.
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
    displacement: FloatArray

    # Spectra are evaluated when asked for: the library takes longer to load than all the rest.
    @cached_property
    def bandwidth(self) -> FloatArray:
        """Frequency [Hz] below which 95 % of the power of an input's changes lies, shape (K,); 0 for a constant one."""
        return np.array([_bandwidth(column, self.interval) for column in self.signals.T])

    @cached_property
    def ringing(self) -> float | None:
        """Frequency [Hz] of the highest inner peak of the velocity's spectrum; None where the device does not ring.

        That is the spectrum of q times f², not that of differences, in which white noise of q has a peak as well.
        """
        frequency, power = _spectrum(self.displacement, self.interval)
        power *= frequency**2
        last = int(np.searchsorted(frequency, _RINGING_BELOW * 0.5 / self.interval)) - 1
        if last <= _RINGING_ABOVE:
            return None
        peak = _RINGING_ABOVE + int(np.argmax(power[_RINGING_ABOVE : last + 1]))
        if peak in (_RINGING_ABOVE, last):  # the spectrum falls, or rises, all along
            return None
        ratio = frequency / frequency[peak]
        width = max(_BAND, float(ratio[1]))
        places = (1.0, 0.5, min(1.5, float(ratio[-1]) - _BAND))
        most, *beside = (power[np.abs(ratio - place) <= width].mean() for place in places)
        return float(frequency[peak]) if np.mean(beside) < 0.5 * most else None


def examine_excitation(
    q: FloatArray,
    v: FloatArray,
    segment: IntArray,
    interval: float,
    plant: Device,
    *,
    basis_functions: int = CENTRES,
    smoothing: float = SMOOTHING,
) -> Excitation:
    """Examine a uniform record.

    Parameters
    ----------
    q : FloatArray, shape (N,)
        Displacement; NaN where masked.
    v : FloatArray, shape (N, K)
        Inputs, finite.
    segment : IntArray, shape (N,)
        Number of the gap-free segment; negative where masked.
    interval : float
        Sample interval [s].
    plant : Device
        Its inputs, and whether it is the joint.
    basis_functions, smoothing : int, float
        M and σ_n of the curves that are to be identified.

    Raises
    ------
    InputError
        No valid segment, or a displacement that never changes.
    """
    valid = (segment >= 0) & np.isfinite(q)
    parts = [segment == number for number in np.unique(segment[valid])]
    parts = [rows for rows in parts if np.count_nonzero(rows) >= _SHORTEST]
    if not parts:
        raise InputError(
            f"no gap-free segment of a training log has {_SHORTEST} samples of {interval:g} s; there is nothing to "
            "identify: shorten [ingest] sample_interval, or record longer"
        )
    motions = [(q[rows], np.gradient(q[rows], interval), v[rows]) for rows in parts]
    largest = np.abs(v[valid]).max(axis=0)
    weights = ScaledRegressor.over(
        np.concatenate([each[0] for each in motions]),
        np.concatenate([each[1] for each in motions]),
        largest,
        basis_functions=basis_functions,
        smoothing=smoothing,
        inputs=plant.action,
    )
    information: FloatArray = np.sum([weights.information(*each, interval) for each in motions], axis=0)
    wells = find_wells([(q, v, interval)], plant=plant)
    acting: BoolArray = np.abs(v) > ACTING * np.maximum(largest, np.finfo(float).tiny)
    return Excitation(
        centres=weights.centres,
        visits=coverage(weights.centres, [each[0] for each in motions], [each[2] for each in motions]),
        wells=wells,
        switches=_switches(q[valid], wells),
        largest=largest,
        intermediate=((np.abs(v) < (1.0 - ACTING) * largest) & acting).sum(axis=0) / np.maximum(acting.sum(axis=0), 1),
        together=float(np.mean(acting.all(axis=1))) if v.shape[1] > 1 else 0.0,
        conditioning=conditioning(information),
        interval=interval,
        signals=plant.acting(v),
        displacement=max(motions, key=lambda each: each[0].size)[0],
    )


def _switches(q: FloatArray, wells: Wells | NoWells) -> tuple[int, int]:
    """Passages to the right-hand and to the left-hand well."""
    if isinstance(wells, NoWells):
        return 0, 0
    to_right = wells.side(q[snaps(q, wells)])
    return int(np.count_nonzero(to_right)), int(np.count_nonzero(~to_right))


def _spectrum(x: FloatArray, interval: float) -> tuple[FloatArray, FloatArray]:
    """Frequencies [Hz] and power of x without its mean (Welch's average)."""
    from scipy.signal import welch

    size = min(x.size, max(round(_WINDOW / interval), _SHORTEST))
    frequency, power = welch(x, 1.0 / interval, nperseg=size, detrend="constant")
    return np.asarray(frequency, dtype=np.float64), np.asarray(power, dtype=np.float64)


def _bandwidth(x: FloatArray, interval: float) -> float:
    if np.ptp(x) == 0.0:
        return 0.0
    frequency, power = _spectrum(x, interval)
    cumulated = np.cumsum(power)
    return float(frequency[np.searchsorted(cumulated, _POWER_SHARE * cumulated[-1])])


LEAST_VISITS = 3
"""Samples nearest to a basis centre, below which its weight is the ridge's choice."""
LARGEST_CONDITION = 1e4
"""Condition number of unit-norm columns: beyond it, an error of 0.01 % in the data is one of 100 % in some weight."""


def excitation_findings(
    q: FloatArray,
    v: FloatArray,
    segment: IntArray,
    interval: float,
    plant: Device,
    *,
    basis_functions: int,
    smoothing: float,
    bistable: bool,
) -> list[Finding]:
    """Objections to a model from these training data.

    Parameters
    ----------
    q : FloatArray, shape (N,)
        Displacement of all training logs, one after the other; NaN where masked.
    v : FloatArray, shape (N, K)
        Inputs.
    segment : IntArray, shape (N,)
        Number of the gap-free segment, different for each log; negative where masked.
    interval : float
        Sample interval [s].
    plant : Device
        Its inputs, and whether it is the joint.
    basis_functions, smoothing : int, float
        M and σ_n of the curves that are to be identified.
    bistable : bool
        True if the device is known to have two wells.

    Raises
    ------
    DataRefusedError
        No segment is long enough to identify anything.

    Notes
    -----
    Cost: one pass of the regressor, O(N M²).
    """
    valid = (segment >= 0) & np.isfinite(q)
    if not valid.any() or is_idle(q[valid]):
        return [refusal("idle", "idle")]
    acting = plant.acting(v)
    undriven = [k for k in range(v.shape[1]) if is_idle(v[valid, k]) and not _moves(acting[:, k], q, segment)]
    findings = [refusal("undriven", "undriven", subject=f"v{k + 1}") for k in undriven]
    try:
        excitation = examine_excitation(
            q, v, segment, interval, plant, basis_functions=basis_functions, smoothing=smoothing
        )
    except InputError as error:
        raise DataRefusedError(str(error)) from error
    return findings + _of_places(
        excitation, basis_functions, plant.displacement.symbol, conditioned=not undriven, bistable=bistable
    )


def _of_places(
    excitation: Excitation, centres: int, displacement: str, *, conditioned: bool, bistable: bool
) -> list[Finding]:
    findings = []
    fewest = int(excitation.visits.visits.min())
    condition = excitation.conditioning
    if fewest < LEAST_VISITS:
        numbers = {
            "place": Number(float(excitation.centres[int(np.argmin(excitation.visits.visits))]), displacement),
            "visits": Number(fewest),
            "least": Number(LEAST_VISITS),
            "centres": Number(centres),
        }
        findings.append(refusal("visits", "visits", numbers))
    if conditioned and (condition.silent or condition.condition > LARGEST_CONDITION):
        numbers = {
            "condition": Number(condition.condition),
            "most": Number(LARGEST_CONDITION),
            "silent": Number(condition.silent),
        }
        findings.append(refusal("rank", "rank", numbers))
    if bistable and isinstance(excitation.wells, NoWells) and excitation.wells.one_cluster:
        findings.append(refusal("one-well", "one_well"))
    return findings


def _moves(u: FloatArray, q: FloatArray, segment: IntArray) -> bool:
    """True if an input that looks like noise, such as one drawn anew for each sample, still moves q.

    The second differences of q are regressed on place, way and input; Student's t of the input decides, beyond `REACH`.
    """
    inner = (segment[:-2] == segment[2:]) & (segment[1:-1] >= 0) & np.isfinite(q[:-2] + q[1:-1] + q[2:])
    way = (q[2:] - q[:-2])[inner]
    turn = (q[2:] - 2.0 * q[1:-1] + q[:-2])[inner]
    regressors = np.column_stack([np.ones(len(way)), q[1:-1][inner], way])
    regressors, _ = np.linalg.qr(regressors)
    left = [signal - regressors @ (regressors.T @ signal) for signal in (u[1:-1][inner], turn)]
    size = float(np.linalg.norm(left[0]) * np.linalg.norm(left[1]))
    share = float(left[0] @ left[1]) / size if size > 0.0 else 0.0
    return bool(abs(share) * np.sqrt(len(way)) > REACH * np.sqrt(1.0 - min(1.0, share * share)))
