"""A voltage sequence that determines the weights of eq. 40 as well as possible.

The sequence is built burst by burst. At each step candidates are drawn (pulses, both sides on, chirps, random steps,
multisines) and played on a simulator from the start. The one that adds most to the criterion per second is kept. This
is a greedy D-optimal design with experiments as candidates (Fedorov 1972; Wynn 1970, doi:10.1214/aoms/1177696809).

The simulator is not the device, and near the separatrix a little more voltage sends the joint into the other well. The
criterion is therefore the mean over several simulators that differ as devices of one drawing do (Pronzato & Walter
1985, doi:10.1016/0025-5564(85)90068-9).
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import partial
from itertools import islice

import numpy as np

from ...device.device import JOINT
from ...device.parameters import JointParameters
from ...errors import InputError
from ...fitting.information import FEW, Conditioning, Coverage, ScaledRegressor, conditioning, coverage, log_information
from ...models.analytical.reduced_order import reduce_joint, simulate_reduced
from ...models.analytical.statics import equilibria
from ...numerics.arrays import FloatArray
from ...rig.bench import Converter
from ...rig.excitation import (
    BURSTS,
    Burst,
    BurstKind,
    alternating_pulses,
    command,
    draw_burst,
    draw_pause,
    random_excitation,
)
from ...scoring.wells import NoWells, Wells, find_wells, snaps
from ...settings.models import CENTRES, SMOOTHING

Simulator = Callable[[FloatArray, FloatArray], tuple[FloatArray, FloatArray]]
"""Times (N,) [s] and voltages (N, 2) [V] to q (N,) [m] and q̇ (N,) [m/s], from rest; NaN after a divergence."""


INTERVAL = 5e-3  # s, of the simulated samples
_SHORTEST = 0.3  # s, of room that is worth another burst
_FADE_OUT = 0.2  # s without voltage at the end
_RELATIVE = 0.03  # of the stiffness, rubber and permittivity, uniform
_FREE_LENGTH = 0.3e-3  # m, of each membrane, uniform
_MOST_DRAWS = 40


@dataclass(frozen=True)
class Requirements:
    """Requirements on the sequence.

    Attributes
    ----------
    duration, rest : float
        Length of the sequence and of the rest before it [s].
    voltage : float
        Largest voltage of either side [V].
    kinds : tuple of str
        Bursts that may be used.
    candidates : int
        Bursts drawn for each place.
    basis_functions : int
        M of every curve.
    """

    duration: float = 37.5
    rest: float = 1.0
    voltage: float = 3000.0
    kinds: tuple[BurstKind, ...] = BURSTS
    candidates: int = 24
    basis_functions: int = CENTRES

    def __post_init__(self) -> None:
        if not self.rest + 4.0 <= self.duration <= 3600.0:
            raise InputError(f"--duration {self.duration:g} s: a sequence lasts {self.rest + 4.0:g} to 3600 s")
        if not 0.0 < self.voltage <= 20e3:
            raise InputError(f"the largest voltage comes to {self.voltage:g} V; it must lie above 0 and up to 20 kV")


@dataclass(frozen=True)
class Assessment:
    """Effect of a sequence on the simulated joints.

    Attributes
    ----------
    criterion : float
        Mean log det of the information per weight [nats] plus the share of cells covered.
    log_information : float
        Its first part.
    covered : float
        Share of the cells (centre × left, right, none acting) with at least 20 samples, mean over the simulators.
    visits : Coverage
        Samples at 10 ms per centre, of the first simulator.
    conditioning : Conditioning
        Of the first simulator's regressor on unit-norm columns.
    crossings : tuple of int
        Passages from well to well by each simulator.
    """

    criterion: float
    log_information: float
    covered: float
    visits: Coverage
    conditioning: Conditioning
    crossings: tuple[int, ...]


@dataclass(frozen=True)
class Design:
    """A designed sequence, and how it compares with alternating full pulses of the same length.

    Attributes
    ----------
    wanted : Requirements
        The requirements.
    bursts : list of Burst
        The sequence.
    weights : ScaledRegressor
        Regressor that it was designed for.
    wells : Wells
        Of the device as drawn.
    designed, plain : Assessment
        Of the sequence, and of `alternating_pulses`.
    """

    wanted: Requirements
    bursts: list[Burst]
    weights: ScaledRegressor
    wells: Wells
    designed: Assessment
    plain: Assessment

    @property
    def efficiency(self) -> float:
        """Relative D-efficiency: how many plain sequences carry the information of this one, per weight."""
        return float(np.exp(self.designed.log_information - self.plain.log_information))


def drawn_simulators(parameters: JointParameters, rng: np.random.Generator, count: int) -> list[Simulator]:
    """The joint as drawn, and `count` − 1 joints with tolerances that still rest in two wells.

    Raises
    ------
    InputError
        The drawing has no two wells, or too few of the joints made after it have.

    Notes
    -----
    Cost: some 50 ms a joint; a run of 37.5 s takes 4 ms.
    """
    if (first := _simulator(parameters)) is None:
        raise InputError("the parameter set has no two wells at zero voltage; see `debist physics equilibria`")
    made = (_simulator(_made(parameters, rng)) for _ in range(_MOST_DRAWS))
    simulators = [first, *islice((simulator for simulator in made if simulator is not None), count - 1)]
    if len(simulators) < count:
        raise InputError(
            f"only {len(simulators)} of {_MOST_DRAWS} joints made after the drawing have two wells; "
            "take fewer `joints`, or a drawing that is less near the edge"
        )
    return simulators


def _made(parameters: JointParameters, rng: np.random.Generator) -> JointParameters:
    """A joint as a workshop makes it: both membranes each with its own tolerances."""
    names = ("E", "left.Y", "right.Y", "left.eps_r", "right.eps_r")
    values = {name: parameters.value(name) * (1.0 + rng.uniform(-_RELATIVE, _RELATIVE)) for name in names}
    lengths = ("left.l0", "right.l0")
    values |= {name: parameters.value(name) + rng.uniform(-_FREE_LENGTH, _FREE_LENGTH) for name in lengths}
    return parameters.with_values(values)


def _simulator(parameters: JointParameters) -> Simulator | None:
    """Motion of the reduced joint from rest in its left well; None without two wells."""
    stable = [rest.q for rest in equilibria(parameters, np.zeros(2)) if rest.stable]
    if len(stable) < 2:
        return None
    reduced = reduce_joint(parameters)

    def simulate(t: FloatArray, v: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Displacement [m] and velocity [m/s], shape (N,), at t [s] under the voltages v [V], shape (N, 2)."""
        motion = simulate_reduced(reduced, t, v, min(stable), 0.0)
        return motion.q, motion.qdot

    return simulate


def design_excitation(
    simulators: Sequence[Simulator],
    rng: np.random.Generator,
    wanted: Requirements,
    *,
    report: Callable[[float], None] | None = None,
) -> Design:
    """Design a sequence for the devices that `simulators` stand for.

    Parameters
    ----------
    simulators : sequence of Simulator
        The first stands for the device as drawn.
    rng : Generator
        Draws the candidates.
    wanted : Requirements
        Length, limits, shapes, effort.
    report : callable, optional
        Receives the share that is designed.

    Raises
    ------
    InputError
        The first simulator does not follow full pulses, or no pulse switches it.

    Notes
    -----
    Cost: about 20 places × candidates × simulators runs of half the length on average.
    """
    plain = alternating_pulses(duration=wanted.duration, rest=wanted.rest, voltage=wanted.voltage)
    weights = _weights(simulators[0], plain, wanted)
    wells = probed_wells(simulators[0], wanted.voltage)
    bursts = _greedy_bursts(partial(_criterion, simulators, weights), rng, wanted, report=report)
    return Design(
        wanted=wanted,
        bursts=bursts,
        weights=weights,
        wells=wells,
        designed=assess(simulators, weights, wells, bursts, wanted.duration),
        plain=assess(simulators, weights, wells, plain, wanted.duration),
    )


def _greedy_bursts(
    criterion: Callable[[list[Burst], float], float],
    rng: np.random.Generator,
    wanted: Requirements,
    *,
    report: Callable[[float], None] | None = None,
) -> list[Burst]:
    """Bursts that are chosen one after the other, each the candidate that adds most per second to the criterion.

    Parameters
    ----------
    criterion : callable
        Bursts and their end [s] → value; −∞ refuses them.
    rng : numpy.random.Generator
        Draws the candidates.
    wanted : Requirements
        Duration, kinds of bursts and candidates.
    report : callable, optional
        Receives the share that is done.

    Raises
    ------
    InputError
        No candidate is accepted.
    """
    bursts = [
        Burst(
            shape="pulse",
            start=wanted.rest,
            duration=1.2,
            left=wanted.voltage,
            right=0.0,
        )
    ]
    end = wanted.rest + 1.2 + 0.5
    side = 1
    before = criterion(bursts, end)
    while wanted.duration - _FADE_OUT - end > _SHORTEST:
        best = None
        best_rate = -np.inf
        for _ in range(wanted.candidates):
            burst, stop = _candidate(rng, wanted, end, side)
            value = criterion([*bursts, burst], stop)
            rate = (value - before) / (stop - end)
            if rate > best_rate:
                best = (burst, stop, value)
                best_rate = rate
        if best is None:
            raise InputError("no candidate could be simulated; take another parameter set or a lower voltage")
        burst, end, before = best
        bursts.append(burst)
        side = 1 - side
        if report is not None:
            report(end / wanted.duration)
    return bursts


def assess(
    simulators: Sequence[Simulator], weights: ScaledRegressor, wells: Wells, bursts: list[Burst], duration: float
) -> Assessment:
    """Play a sequence on every simulator; the information of its motions on the weights.

    Parameters
    ----------
    simulators : sequence of Simulator
        Joints on which the sequence is played.
    weights : ScaledRegressor
        Regressor of the weights.
    wells : Wells
        Wells of the joints.
    bursts : list of Burst
        The sequence.
    duration : float
        Its length [s].
    """
    runs = [_simulated(simulate, bursts, duration) for simulate in simulators]
    information = [weights.information(*run, INTERVAL) for run in runs]
    coverages = [_coverage(weights, run) for run in runs]
    mean = float(np.mean([log_information(matrix) for matrix in information]))
    covered = float(np.mean([_covered(coverage) for coverage in coverages]))
    return Assessment(
        criterion=mean + covered,
        log_information=mean,
        covered=covered,
        visits=coverages[0],
        conditioning=conditioning(information[0]),
        crossings=tuple(len(snaps(q, wells)) for q, _, _ in runs),
    )


def _candidate(rng: np.random.Generator, wanted: Requirements, start: float, side: int) -> tuple[Burst, float]:
    """A burst at `start` [s] that fits, and the end [s] of the pause behind it; three of four follow the turn."""
    kind = wanted.kinds[int(rng.integers(len(wanted.kinds)))]
    turn = side if rng.random() < 0.75 else 1 - side
    burst = draw_burst(rng, kind, start, turn, wanted.voltage)
    last = wanted.duration - _FADE_OUT
    if start + burst.duration > last:
        burst = replace(burst, duration=last - start)
    return burst, min(start + burst.duration + draw_pause(rng), wanted.duration)


def _simulated(simulate: Simulator, bursts: list[Burst], duration: float) -> tuple[FloatArray, FloatArray, FloatArray]:
    """q, q̇ and the voltages behind usual converters; cut where the simulation diverged."""
    t: FloatArray = INTERVAL * np.arange(round(duration / INTERVAL), dtype=np.float64)
    commands = command(bursts, t)
    converted = [Converter().drive(np.ascontiguousarray(commands[:, side]), INTERVAL) for side in (0, 1)]
    v: FloatArray = np.stack(converted, axis=1)
    q, qdot = simulate(t, v)
    valid = np.isfinite(q) & np.isfinite(qdot)
    count = t.size if valid.all() else int(np.argmin(valid))
    return q[:count], qdot[:count], v[:count]


def _criterion(
    simulators: Sequence[Simulator], weights: ScaledRegressor, bursts: list[Burst], duration: float
) -> float:
    """Mean criterion; −∞ where a simulation diverges, for then nothing is known of the device either."""
    values = []
    for simulate in simulators:
        run = _simulated(simulate, bursts, duration)
        if len(run[0]) < round(duration / INTERVAL):
            return -np.inf
        values.append(log_information(weights.information(*run, INTERVAL)) + _covered(_coverage(weights, run)))
    return float(np.mean(values))


def _coverage(weights: ScaledRegressor, run: tuple[FloatArray, FloatArray, FloatArray]) -> Coverage:
    """Visits at 10 ms, the interval on which models are identified."""
    q, _, v = run
    every = slice(None, None, round(1e-2 / INTERVAL))
    return coverage(weights.centres, [q[every]], [v[every]])


def _covered(visits: Coverage) -> float:
    """Share of the centres, and of the pairs (input, centre), with at least `FEW` visits."""
    return float(np.mean(np.concatenate((visits.visits[None], visits.driven)) >= FEW))


def probed_wells(simulate: Simulator, voltage: float) -> Wells:
    """The wells of the device as drawn, as drawn pulses of up to `voltage` [V] show them.

    Their lengths and heights differ: equal pulses may leave a joint swinging so that it always falls back.

    Raises
    ------
    InputError
        The pulses do not take the joint from well to well.
    """
    bursts = random_excitation(np.random.default_rng(0), excitation="pulses", top=voltage)
    q, _, v = _simulated(simulate, bursts, bursts[-1].start + bursts[-1].duration)
    wells = find_wells([(q, v, INTERVAL)], plant=JOINT)
    if isinstance(wells, NoWells):
        raise InputError(
            f"pulses of up to {voltage:g} V do not take the joint from well to well; raise --max-voltage "
            "or --max-field, or see `debist physics curves` for what it needs"
        )
    return wells


def _weights(simulate: Simulator, plain: list[Burst], wanted: Requirements) -> ScaledRegressor:
    """The weights over the range that full pulses reach on the device as drawn."""
    q, qdot, _ = _simulated(simulate, plain, wanted.duration)
    if q.size < wanted.duration / INTERVAL - 1:
        raise InputError("the simulator follows no full pulse; take another parameter set or a lower voltage")
    return ScaledRegressor.over(
        q, qdot, np.full(2, wanted.voltage), basis_functions=wanted.basis_functions, smoothing=SMOOTHING
    )
