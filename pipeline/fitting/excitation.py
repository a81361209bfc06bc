"""Excitation of a log: wells, basis centres, largest inputs; the facts behind "what to add".

Data are unfit for training where they show nothing of places, inputs or wells: curves would be invented there.
The training logs of thirty joints and a quarter drone have at least 4 samples at each of ten centres and a condition
number of at most 81; the bounds leave room below and above.
"""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from ..device.device import Device
from ..errors import DataRefusedError, InputError
from ..numerics.arrays import FloatArray, IntArray
from ..scoring.wells import NoWells, Wells, find_wells, snaps
from ..settings.models import CENTRES, SMOOTHING
from ..signals.findings import Finding, Number, refusal
from ..signals.noise import REACH, is_idle
from .information import Conditioning, Coverage, ScaledRegressor, conditioning, coverage

_SHORTEST = 64
"""Samples of a segment that shows a motion."""
LEAST_VISITS = 3
"""Samples nearest to a basis centre, below which its weight is the ridge's choice."""
LARGEST_CONDITION = 1e4
"""Condition number of unit-norm columns: beyond it, an error of 0.01 % in the data is one of 100 % in some weight."""


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
    conditioning : Conditioning
        Of the regressor of eq. 40 with these centres, on unit-norm columns.
    """

    centres: FloatArray
    visits: Coverage
    wells: Wells | NoWells
    switches: tuple[int, int]
    largest: FloatArray
    conditioning: Conditioning


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
    wells = find_wells([(q, v, interval)], plant=plant)
    return Excitation(
        centres=weights.centres,
        visits=coverage(weights.centres, [each[0] for each in motions], [each[2] for each in motions]),
        wells=wells,
        switches=_switches(q[valid], wells),
        largest=largest,
        conditioning=conditioning(np.sum([weights.information(*each, interval) for each in motions], axis=0)),
    )


def _switches(q: FloatArray, wells: Wells | NoWells) -> tuple[int, int]:
    """Passages to the right-hand and to the left-hand well."""
    if isinstance(wells, NoWells):
        return 0, 0
    to_right = wells.side(q[snaps(q, wells)])
    return int(np.count_nonzero(to_right)), int(np.count_nonzero(~to_right))


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
    undriven = [k for k in range(v.shape[1]) if is_idle(v[valid, k]) and not _moves(plant.acting(v)[:, k], q, segment)]
    try:
        excitation = examine_excitation(
            q, v, segment, interval, plant, basis_functions=basis_functions, smoothing=smoothing
        )
    except InputError as error:
        raise DataRefusedError(str(error)) from error
    return [
        *(refusal("undriven", "undriven", subject=f"v{k + 1}") for k in undriven),
        *_of_places(
            excitation, basis_functions, plant.displacement.symbol, conditioned=not undriven, bistable=bistable
        ),
    ]


def _of_places(
    excitation: Excitation, centres: int, displacement: str, *, conditioned: bool, bistable: bool
) -> Iterator[Finding]:
    fewest = int(excitation.visits.visits.min())
    condition = excitation.conditioning
    if fewest < LEAST_VISITS:
        place = float(excitation.centres[int(np.argmin(excitation.visits.visits))])
        yield refusal(
            "visits",
            "visits",
            {
                "place": Number(place, displacement),
                "visits": Number(fewest),
                "least": Number(LEAST_VISITS),
                "centres": Number(centres),
            },
        )
    if conditioned and (condition.silent or condition.condition > LARGEST_CONDITION):
        yield refusal(
            "rank",
            "rank",
            {
                "condition": Number(condition.condition),
                "most": Number(LARGEST_CONDITION),
                "silent": Number(condition.silent),
            },
        )
    if bistable and isinstance(excitation.wells, NoWells) and excitation.wells.one_cluster:
        yield refusal("one-well", "one_well")


def _moves(u: FloatArray, q: FloatArray, segment: IntArray) -> bool:
    """True if an input that looks like noise, such as one drawn anew for each sample, still moves q.

    The second differences of q are regressed on place, way and input; Student's t of the input decides, beyond `REACH`.
    """
    inner = (segment[:-2] == segment[2:]) & (segment[1:-1] >= 0) & np.isfinite(q[:-2] + q[1:-1] + q[2:])
    way = (q[2:] - q[:-2])[inner]
    turn = (q[2:] - 2.0 * q[1:-1] + q[:-2])[inner]
    regressors, _ = np.linalg.qr(np.column_stack([np.ones(len(way)), q[1:-1][inner], way]))
    left = [signal - regressors @ (regressors.T @ signal) for signal in (u[1:-1][inner], turn)]
    size = float(np.linalg.norm(left[0]) * np.linalg.norm(left[1]))
    share = float(left[0] @ left[1]) / size if size > 0.0 else 0.0
    return bool(abs(share) * np.sqrt(len(way)) > REACH * np.sqrt(1.0 - min(1.0, share * share)))
