"""The two wells of a bistable record, found in the data; its snaps, and in which well a free run and the record end."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ..device.device import Device
from ..numerics.arrays import BoolArray, FloatArray, IntArray, runs_of, samples_of
from ..numerics.metrics import signal_range
from ..signals.log import Log
from .intervals import decorrelation_lag

RESTING_VOLTAGE = 0.1  # of the largest voltage: above probe offset and noise, and 1 % of the force of a squared input
MIDDLE, FEW = 0.25, 0.05  # of the range of rest positions to either side; share of rests that may lie between
LONGEST_WINDOW = 0.4  # s, the end of a rest that is looked at; one period of the 2.8 Hz ring-down
SHORTEST_REST = 0.3  # s; in a shorter pause nothing comes to rest in a well
CLUSTER_GAP = 0.5  # of the range of rest positions: two wells leave the middle empty
WELL_REACHED = 0.5  # of the way from the barrier to a well: beyond it the device has snapped over
SHORT_PAUSE = 0.1  # s; where no rest shows the other well, a joint that rings about it in such a pause does, roughly
# Of the range of q in such a window: a joint that swings further hardly shows where it would rest; beyond half of the
# range it is in no well; where slow passages over the barrier fill the gap, rests this calm alone count.
LARGEST_SWING = 0.25
WITHIN_WELL = 0.5
CALM = 0.05
LEAST_SAMPLES = 20  # of a rest of another device: its sample interval may be longer than the joint's whole rest
STANDS = 0.02  # of the range of q: what moves less in the time over which q remembers where it was stands still
TURNS = 3  # passages of q through the middle of its rest, each from half a standard deviation out: it rings
SURE = 0.9  # probability of a well beyond which an outcome counts as decided


@dataclass(frozen=True)
class Wells:
    """Rest positions at zero voltage and the barrier between them, in the unit of q."""

    left: float
    right: float
    barrier: float

    def side(self, q: FloatArray) -> BoolArray:
        """True to the right of the barrier; False for NaN."""
        with np.errstate(invalid="ignore"):
            return np.asarray(q > self.barrier)


@dataclass(frozen=True)
class NoWells:
    """Reason why no two wells are defined.

    Attributes
    ----------
    reason : str
        In words.
    one_cluster : bool
        True if the device rests, and in one place only.
    """

    reason: str
    one_cluster: bool = False


def rests(v: FloatArray, interval: float, shortest: float = SHORTEST_REST, *, plant: Device) -> list[slice]:
    """Rows of at least the `shortest` time [s] in which all inputs are below `RESTING_VOLTAGE` of their `peaks`.

    They follow a pulse, but for those that begin with the first sample.

    Parameters
    ----------
    v : FloatArray, shape (N, K)
        Inputs.
    interval, shortest : float
        Sample interval and shortest rest [s].
    plant : Device
        Its inputs, and whether it is the joint.
    """
    quiet = np.all(np.abs(v) <= RESTING_VOLTAGE * plant.peaks(v), axis=1)
    return [rows for rows in runs_of(quiet) if (rows.stop - rows.start) * interval >= shortest]


def places_of_rest(
    q: FloatArray, v: FloatArray, interval: float, shortest: float = SHORTEST_REST, *, plant: Device
) -> list[slice]:
    """The `rests` of a device in which q comes to rest too, as the joint does in each of them.

    Another device may be slow. A rest of it counts if it has `LEAST_SAMPLES` and q stands or rings in its second half.
    q stands if it drifts by less than `STANDS` of its range within its correlation time in the log. It rings if it
    swings about one place by no more than `LARGEST_SWING` of its range.

    Parameters
    ----------
    q : FloatArray, shape (N,)
        Displacement, NaN where masked.
    v : FloatArray, shape (N, K)
        Inputs.
    interval, shortest : float
        Sample interval and shortest rest [s].
    plant : Device
        Its inputs, and whether it is the joint.
    """
    resting = rests(v, interval, shortest, plant=plant)
    span = signal_range(q)
    if plant.joint or not span:
        return resting
    memory = decorrelation_lag(q)
    return [rest for rest in resting if rest.stop - rest.start >= LEAST_SAMPLES and _stands(q[rest] / span, memory)]


def _stands(q: FloatArray, memory: int) -> bool:
    """True if q of a rest, over its range in the log, is as calm as `places_of_rest` requires."""
    rows = np.flatnonzero(np.isfinite(q[q.size // 2 :]))
    end = q[q.size // 2 :][rows]
    if rows.size < 2:
        return False
    if abs(float(np.polyfit(rows, end, 1)[0])) * memory <= STANDS:
        return True
    apart = q[np.isfinite(q)] - np.median(end)
    sides = np.sign(apart[np.abs(apart) > np.std(end) / 2.0])
    return bool(np.count_nonzero(np.diff(sides)) >= TURNS and np.ptp(end) <= LARGEST_SWING)


def end_of_rest(rest: slice, interval: float) -> slice:
    """Rows of the last `LONGEST_WINDOW` of a rest, or of the whole of a shorter one."""
    return slice(max(rest.start, rest.stop - samples_of(LONGEST_WINDOW, interval)), rest.stop)


def find_wells(
    records: Sequence[tuple[FloatArray, FloatArray, float]], shortest: float = SHORTEST_REST, *, plant: Device
) -> Wells | NoWells:
    """Two clusters of rest positions at zero voltage, with nothing in between.

    The rest position is the median of q over the last 0.4 s of each rest, so a ring-down that has not died away
    averages out. The largest gap between sorted rest positions must be at least half of their range and reach across a
    tenth of the range of q; the barrier is its middle. Rests in which q still swings by more than a quarter of its
    range within 0.4 s count only where the others show no two wells. Those in which it swings by more than half never
    count. Where these show no two wells either, rests in which q swings by less than a twentieth of its range decide
    alone. A slow joint on its way over the barrier swings little in 0.4 s, but more than that.

    Parameters
    ----------
    records : sequence of (q, v, interval)
        Displacement, shape (N,), NaN where masked; inputs, shape (N, K); sample interval [s]. Give all logs of a
        device: one that visits a single well is then scored by the wells of the others.
    shortest : float
        Shortest rest [s].
    plant : Device
        Its inputs, and whether it is the joint.

    Returns
    -------
    Wells or NoWells
    """
    pairs: list[tuple[float, float]] = []
    low = min(float(np.min(q, where=np.isfinite(q), initial=np.inf)) for q, _, _ in records)
    high = max(float(np.max(q, where=np.isfinite(q), initial=-np.inf)) for q, _, _ in records)
    for q, v, interval in records:
        for rest in places_of_rest(q, v, interval, shortest, plant=plant):
            end = q[end_of_rest(rest, interval)]
            if np.any(np.isfinite(end)):
                shortened = min(1.0, len(end) * interval / LONGEST_WINDOW)
                pairs.append((float(np.nanmedian(end)), float(np.nanmax(end) - np.nanmin(end)) / shortened))
    seen = [
        _clusters([position for position, swing in pairs if swing <= share * (high - low)], high - low)
        for share in (LARGEST_SWING, WITHIN_WELL, CALM)
    ]
    return next((wells for wells in seen if isinstance(wells, Wells)), seen[1])


def wells_of(logs: Sequence[Log], plant: Device) -> Wells | NoWells:
    """The wells of a device, the joint or another, from all its logs."""
    return find_wells([(log.q, log.v, log.interval) for log in logs], plant=plant)


def _clusters(positions: Sequence[float], span: float) -> Wells | NoWells:
    """Two wells from rest positions, on a device that moves over `span`."""
    if len(positions) < 2:
        return NoWells("the device is never at rest twice with its inputs at zero")
    ordered = np.sort(positions)
    spread = float(ordered[-1] - ordered[0])
    between = (ordered > ordered[0] + MIDDLE * spread) & (ordered < ordered[-1] - MIDDLE * spread)
    if np.mean(between) <= FEW:  # a slow joint may hang at its barrier
        ordered = ordered[~between]
    gaps = np.diff(ordered)
    k = int(np.argmax(gaps))
    if gaps[k] < CLUSTER_GAP * (ordered[-1] - ordered[0]) or gaps[k] <= 0.1 * span:
        return NoWells("the rest positions form one cluster: not bistable, or only one well is visited", True)
    left, right = (float(np.median(places)) for places in np.split(ordered, [k + 1]))
    return Wells(left, right, float(ordered[k] + ordered[k + 1]) / 2.0)


def snaps(q: FloatArray, wells: Wells | NoWells) -> IntArray:
    """Rows at which q has crossed the barrier on its way from one well to the other, shape (n,); NaN is passed over.

    A way counts when it reaches from half way into one well to half way into the other, and it crosses the barrier
    where it does so last.
    """
    if isinstance(wells, NoWells):
        return np.empty(0, dtype=np.int64)
    finite = np.flatnonzero(np.isfinite(q))
    near = np.zeros(finite.size, dtype=np.int8)
    near[q[finite] > wells.barrier + WELL_REACHED * (wells.right - wells.barrier)] = 1
    near[q[finite] < wells.barrier - WELL_REACHED * (wells.barrier - wells.left)] = -1
    visits = np.flatnonzero(near)
    crossed = []
    for i in np.flatnonzero(near[visits][1:] != near[visits][:-1]):
        way = finite[visits[i] : visits[i + 1] + 1]
        side = wells.side(q[way])
        crossed.append(int(way[np.flatnonzero(side[1:] != side[:-1])[-1] + 1]))
    return np.array(crossed, dtype=np.int64)


def in_same_well(measured: FloatArray, calculated: FloatArray, wells: Wells) -> FloatArray:
    """1 where both are on the same side of the barrier, 0 where not, NaN where nothing is measured, shape (N,).

    A calculated NaN (after divergence) agrees with nothing. The mean over the rows measured is the well agreement.
    """
    same = (wells.side(measured) == wells.side(calculated)) & np.isfinite(calculated)
    return np.where(np.isfinite(measured), same.astype(np.float64), np.nan)


def switch_accuracy(
    measured: FloatArray, calculated: FloatArray, v: FloatArray, interval: float, wells: Wells, plant: Device
) -> tuple[int, int]:
    """Compare the wells in which both rest after each voltage pulse.

    A pulse counts if it is followed by at least 0.3 s without voltage, and the measurement stays on one side of the
    barrier at their end (up to 0.4 s). The simulation is correct if it stays on that side too. Pauses inside a chirp
    are shorter, so a chirp counts as one pulse. After a divergence everything is wrong.

    Parameters
    ----------
    measured, calculated : FloatArray, shape (N,)
        q, NaN where masked, and q of the free run, NaN after divergence.
    v : FloatArray, shape (N, K)
        Inputs.
    interval : float
        Sample interval [s].
    wells : Wells
        The wells of the device.
    plant : Device
        Its inputs, and whether it is the joint.

    Returns
    -------
    correct : int
        Pulses after which the simulation rests in the well in which the measurement does.
    pulses : int
        Pulses after which the measurement rests in one well.
    """
    right = []
    for rest in places_of_rest(measured, v, interval, plant=plant):
        rows = end_of_rest(rest, interval)
        finite = np.isfinite(measured[rows])
        side = wells.side(measured[rows])[finite]
        if rest.start > 0 and finite.any() and side.any() == side.all():
            simulated = calculated[rows][finite]
            right.append(bool(np.all(np.isfinite(simulated)) and np.all(wells.side(simulated) == side[0])))
    return sum(right), len(right)


def pulse_outcomes(ensemble: FloatArray, rests: list[slice], wells: Wells) -> tuple[FloatArray, BoolArray]:
    """Probability of the right-hand well after each pulse: the share of an ensemble of a model's free runs.

    Near the separatrix an arbitrarily small error decides the well, so a single simulation says less than it seems to.
    Each member of the ensemble is a draw from the posterior of the parameters.

    Parameters
    ----------
    ensemble : FloatArray, shape (count, N)
        q of each member; NaN after divergence, which counts for neither well.
    rests : list of slice
        Rests without voltage, as `rests` finds them.
    wells : Wells
        The two wells.

    Returns
    -------
    right_hand : FloatArray, shape (R,)
        Probability of the right-hand well (Laplace's rule, so never exactly 0 or 1).
    ambiguous : BoolArray, shape (R,)
        True where neither well has the probability `SURE`: the outcome hinges on less than the model knows.
    """
    right_hand = np.empty(len(rests))
    for i, rest in enumerate(rests):
        end = ensemble[:, rest.stop - 1]
        finite = np.isfinite(end)
        right_hand[i] = (np.count_nonzero(wells.side(end[finite])) + 1.0) / (np.count_nonzero(finite) + 2.0)
    return right_hand, np.maximum(right_hand, 1.0 - right_hand) < SURE
