"""One closed-loop experiment on a virtual joint: controller and scenario in, log and truth out.

Once in a period the controller is given the laser's reading and a target and answers with two commanded voltages,
which are held until the next call. A command is limited to what the converters can give, 0 to `highest`, a NaN to 0.
"""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np

from ..errors import InputError
from ..numerics.arrays import FloatArray
from ..numerics.compiled import compiled
from .bench import Bench, Converter, Laser, Probe, Readings, bent, charge_left, charged
from .excitation import MAX_VOLTAGE
from .joint import barrier, rest, wells
from .midpoint import Load, at_rest, march
from .parameters import RigParameters

HALVES = 2
"""Time steps of the joint in a period of the controller, and rows of the log."""
PERIOD = 1e-3
"""Period of the controller [s]."""
GONE = 1.0
FROZEN = 2.0
"""Marks of a laser that gives no value, and of one that gives its last."""
FINE = 10
"""Steps of a converter in a time step of the joint."""


class Surroundings(NamedTuple):
    """Converters and laser between controller and joint, and the disturbances of both.

    Attributes
    ----------
    lag, rate_limit, power_over_capacitance : FloatArray, shape (2,)
        Of the converters: time constant [s], largest slope [V/s], largest v v̇ while charging [V²/s].
    charge_left : float
        Share of a membrane's missing charge that is still missing after 1/`FINE` of a row (`bench.charge_left`).
    noise : FloatArray, shape (N,)
        Error of the laser [m] at each row, without its linearity.
    linearity, linearity_phase, rail, resolution : float
        Of the laser [m] (phase in rad), see `pipeline.rig.bench.Laser`.
    lost : FloatArray, shape (N,)
        `GONE` where the laser gives no value (NaN), `FROZEN` where it gives its last one, else 0.
    force, spring : FloatArray, shape (N,)
        External force [N] on q, and stiffness [N/m] of a repelling spring, from each row to the next.
    """

    lag: FloatArray
    rate_limit: FloatArray
    power_over_capacitance: FloatArray
    charge_left: float
    noise: FloatArray
    linearity: float
    linearity_phase: float
    rail: float
    resolution: float
    lost: FloatArray
    force: FloatArray
    spring: FloatArray


@compiled
def _charge(
    v: FloatArray, membranes: FloatArray, command: FloatArray, around: Surroundings, shown: FloatArray, load: FloatArray
) -> None:
    """Move voltages of converters, `v`, and membranes over the steps of a period, whose number is that of rows.

    Parameters
    ----------
    v, membranes : FloatArray, shape (2,)
        Voltages [V]; moved.
    command : FloatArray, shape (2,)
        Commanded voltages [V].
    around : Surroundings
        Converters.
    shown, load : FloatArray, shape (HALVES, 2)
        Filled: voltages of the converters where steps begin, and means of the squares of those of the membranes.
    """
    dt = PERIOD / HALVES / FINE
    for side in range(2):
        decay = -np.expm1(-dt / around.lag[side])
        for step in range(len(shown)):
            shown[step, side] = v[side]
            total = 0.0
            for _ in range(FINE):
                before = membranes[side]
                v[side] = charged(
                    v[side], command[side], decay, around.rate_limit[side], around.power_over_capacitance[side], dt
                )
                now = v[side] + (before - v[side]) * around.charge_left
                total += (before * before + before * now + now * now) / 3.0
                membranes[side] = now
            load[step, side] = total / FINE


@compiled
def laser_reading(q: float, row: int, around: Surroundings) -> float:
    """Reading of the laser [m] for a displacement at a row of the log."""
    if around.lost[row] == GONE:
        return np.nan
    reading = q + bent(q, around.linearity, around.rail, around.linearity_phase) + around.noise[row]
    shown = min(max(reading, -around.rail), around.rail)
    return float(np.round(shown / around.resolution) * around.resolution)


Step = Callable[[float, float], tuple[float, float]]
"""Commands [V] for a reading and a target [m]."""
Controller = Callable[[float], Step]
"""Makes the step function of a run for the first reading [m]."""


def played(t: FloatArray, u: FloatArray) -> Controller:
    """An open-loop controller that gives `u`, shape (N, 2) [V], each row from its time `t` [s] on."""
    rows = np.clip(np.searchsorted(t, np.arange(0.0, t[-1] + PERIOD, PERIOD) + 1e-9, side="right") - 1, 0, t.size - 1)
    commands = u[rows].tolist()

    def begin(_q: float) -> Step:
        """From the first row on; zero volts after the last."""
        left = iter(commands)
        return lambda _q, _target: next(left, (0.0, 0.0))

    return begin


@dataclass(frozen=True)
class Scenario:
    """Reference, disturbances and instruments of a closed-loop run.

    Attributes
    ----------
    t, target : FloatArray, shape (n,)
        From each time [s] on the controller gets this target [m], until the next; the first time is 0.
    duration : float
        Length [s].
    highest : float
        Largest voltage of the converters [V].
    side : int
        Well in which the joint rests at first: −1 left, +1 right.
    lag : float or None
        Time constant [s] of both converters; None leaves the bench's own.
    noise : float
        Factor on the laser's noise.
    gain : float
        Factor from the commands of the converters to their voltages.
    mass : float
        Factor on the moving mass.
    barrier : float
        Share by which the energy barrier has changed at the end, on a line from the start.
    pushes : tuple of (float, float, float)
        Start [s], force [N] and length [s] of external forces on q.
    hands : tuple of (float, float, float)
        Start [s], greatest force [N] and length [s] of forces that rise and fall as half a sine, as a hand pushes.
    shakes : tuple of (float, float, float, float)
        Start [s], amplitude [N], frequency [Hz] and length [s] of forces on q, as of a table that shakes.
    drag : float
        Force [N] with which a wire resists once it slides; before that it gives way by `GIVE`.
    friction : float
        Factor on the joint's own friction.
    lost, frozen : tuple of (float, float)
        Start and length [s] of times in which the laser gives no value, or its last one.
    seed : int
        Draws the instruments' noise.
    """

    t: FloatArray
    target: FloatArray
    duration: float
    highest: float = MAX_VOLTAGE
    side: int = -1
    lag: float | None = None
    noise: float = 1.0
    gain: float = 1.0
    mass: float = 1.0
    barrier: float = 0.0
    pushes: tuple[tuple[float, float, float], ...] = ()
    hands: tuple[tuple[float, float, float], ...] = ()
    shakes: tuple[tuple[float, float, float, float], ...] = ()
    drag: float = 0.0
    friction: float = 1.0
    lost: tuple[tuple[float, float], ...] = ()
    frozen: tuple[tuple[float, float], ...] = ()
    seed: int = 1


@dataclass(frozen=True)
class ClosedLoop(Readings):
    """A closed-loop run, all of shape (N,) and SI: the logged signals, and those that no instrument shows.

    `q`, `v1`, `v2` are readings, `target` what the controller got, `command1` and `command2` what it returned
    within the converters' range. `commands_not_finite` counts its answers that are not finite: NaN acts as 0 V, an
    infinite one as the end of the range. `commands_clipped` counts those beyond the range.
    """

    target: FloatArray
    command1: FloatArray
    command2: FloatArray
    true_q: FloatArray
    commands_not_finite: int = 0
    commands_clipped: int = 0


def run_loop(
    p: RigParameters, bench: Bench, scenario: Scenario, controller: Controller, start: FloatArray | None = None
) -> ClosedLoop:
    """Run a controller on a joint, from rest in a well or from the coordinates `start`, shape (n,).

    Parameters
    ----------
    p : RigParameters
        The joint.
    bench : Bench
        Instruments and converters.
    scenario : Scenario
        Targets and disturbances.
    controller : Controller
        Controller of the voltages.
    start : FloatArray, shape (n,), optional
        Coordinates at the start.

    Raises
    ------
    InputError
        The joint cannot follow, or the controller's Python failed.

    Notes
    -----
    Cost: 35 ms for a second of motion, 10 ms for the rest at the start, and the controller's own time.
    """
    rng = np.random.default_rng(scenario.seed)
    changed = p._replace(
        mass=p.mass * scenario.mass,
        slip_force=p.slip_force * scenario.friction,
        slip_stiffness=p.slip_stiffness * scenario.friction,
        # What a converter gives too much of acts as more capacitance: forces go with C v².
        capacitance=p.capacitance * scenario.gain**2,
    )
    start = rest(changed, side=scenario.side) if start is None else start
    rows = HALVES * round(scenario.duration / PERIOD)
    t = np.arange(rows) / (HALVES / PERIOD)
    around = _surroundings(p, bench, scenario, t, rng)
    target = scenario.target[np.searchsorted(scenario.t, t + 1e-9, side="right") - 1]
    state, work = at_rest(changed, start, scenario.drag)
    load = Load(np.zeros((rows, 2)), around.force, around.spring)
    v, membranes = np.zeros((2, 2))
    poses, rates = np.empty((2, HALVES + 1, 3))
    q, readings = np.empty((2, rows))
    volts, commands = np.empty((2, rows, 2))
    answers = np.empty((rows // HALVES, 2))
    q[0] = work.pose[0]
    reading = laser_reading(q[0], 0, around)
    with _controlling():
        step = controller(reading)
    for row in range(rows):
        reading = reading if around.lost[row] == FROZEN else laser_reading(q[row], row, around)
        readings[row] = reading
        if row % HALVES:
            continue
        period = slice(row, row + HALVES)
        with _controlling():
            answers[row // HALVES] = step(reading, target[row])
        commands[period] = [min(max(0.0, asked), scenario.highest) for asked in answers[row // HALVES]]  # NaN: 0 V
        _charge(v, membranes, commands[row], around, volts[period], load.charge[period])
        if not march(changed, state, work, Load(*(x[period] for x in load)), PERIOD / HALVES, row, poses, rates):
            raise InputError("the virtual joint cannot follow: a membrane is stretched beyond its rubber law")
        q[row : row + HALVES + 1] = poses[: rows - row, 0]
    left, right = (bench.probes[side].read(t, volts[:, side], rng) for side in (0, 1))
    return ClosedLoop(
        t=t,
        q=readings,
        v1=left,
        v2=right,
        target=target,
        command1=commands[:, 0],
        command2=commands[:, 1],
        true_q=q,
        commands_not_finite=int(np.count_nonzero(~np.isfinite(answers))),
        commands_clipped=int(np.count_nonzero(np.isfinite(answers) & (answers != commands[::HALVES]))),
    )


@contextmanager
def _controlling() -> Iterator[None]:
    """Context for calls of a controller: what it raises becomes an InputError."""
    try:
        yield
    except Exception as error:
        raise InputError(f"the controller failed: {type(error).__name__}: {error}") from error


def _surroundings(
    p: RigParameters, bench: Bench, scenario: Scenario, t: FloatArray, rng: np.random.Generator
) -> Surroundings:
    """Instruments of the bench and disturbances of the scenario, at the rows of the log."""
    laser = bench.laser
    converters = bench.converters
    phase = rng.uniform(0.0, 2.0 * np.pi, 2)
    hum = laser.hum * np.sin(2.0 * np.pi * laser.mains * t + phase[1])
    noise = hum + scenario.noise * laser.noise * rng.standard_normal(t.size)
    lost = np.zeros(t.size)
    for spans, mark in ((scenario.lost, GONE), (scenario.frozen, FROZEN)):
        for start, length in spans:
            lost[(t >= start) & (t < start + length)] = mark
    spring = np.zeros(t.size)
    if scenario.barrier:
        middle = 0.5 * np.diff(wells(p))[0]
        spring = 2.0 * scenario.barrier * barrier(p) / middle**2 * t / t[-1]
    return Surroundings(
        lag=np.array([c.lag if scenario.lag is None else scenario.lag for c in converters]),
        rate_limit=np.array([c.rate_limit for c in converters]),
        power_over_capacitance=np.array([c.power_limit / c.capacitance for c in converters]),
        charge_left=charge_left(bench.charging, PERIOD / HALVES / FINE),
        noise=noise,
        linearity=laser.linearity,
        linearity_phase=float(phase[0]),
        rail=laser.rail,
        resolution=laser.resolution,
        lost=lost,
        force=_tip_force(scenario, t),
        spring=spring,
    )


def _tip_force(scenario: Scenario, t: FloatArray) -> FloatArray:
    """External force [N] on q at each row: constant, half a sine, and a sine."""
    waves = [
        *((start, force, length, 0.0, 0.5 * np.pi) for start, force, length in scenario.pushes),
        *((start, force, length, 0.5 / length, 0.0) for start, force, length in scenario.hands),
        *((start, force, length, frequency, 0.0) for start, force, frequency, length in scenario.shakes),
    ]
    total = np.zeros(t.size)
    for start, force, length, frequency, phase in waves:
        during = (t >= start) & (t < start + length)
        total[during] += force * np.sin(2.0 * np.pi * frequency * (t[during] - start) + phase)
    return total


def bench_from_json(values: dict[str, Any]) -> Bench:
    """The bench back from `dataclasses.asdict`."""
    left, right = (Converter(**entry) for entry in values["converters"])
    first, second = (Probe(**entry) for entry in values["probes"])
    return Bench(
        rate=values["rate"],
        converters=(left, right),
        laser=Laser(**values["laser"]),
        probes=(first, second),
        charging=float(values.get("charging", 0.0)),
    )
