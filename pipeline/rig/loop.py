"""One closed-loop experiment on a virtual joint: controller and scenario in, log and truth out.

Once in a period the controller is given the laser's reading and a target and answers with two commanded voltages,
which are held until the next call. A command is limited to what the converters can give, 0 to `highest`, a NaN to 0.
"""

import ctypes
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from llvmlite import ir

from ..errors import InputError
from ..numerics.arrays import FloatArray, IntArray
from ..numerics.compiled import compiled, inner, intrinsic, types
from .bench import Bench, Converter, Laser, Probe, Readings, bent, charge_left, charged
from .excitation import MAX_VOLTAGE
from .joint import barrier, rest, tip_displacement, wells
from .midpoint import KEEP, advance, at_rest, locate_tip
from .parameters import RigParameters

HALVES = 2
"""Time steps of the joint in a period of the controller, and rows of the log."""
PERIOD = 1e-3
"""Period of the controller [s]."""
GONE = 1.0
FROZEN = 2.0
"""Marks of a laser that gives no value, and of one that gives its last."""
GIVE = 0.3e-3
"""Distance [m] by which a wire gives way before it slides."""
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
    highest : float
        Largest voltage [V] that a converter gives.
    noise : FloatArray, shape (N,)
        Error of the laser [m] at each row, without its linearity.
    linearity, linearity_phase, rail, resolution : float
        Of the laser [m] (phase in rad), see `pipeline.rig.bench.Laser`.
    lost : FloatArray, shape (N,)
        `GONE` where the laser gives no value (NaN), `FROZEN` where it gives its last one, else 0.
    force, spring : FloatArray, shape (N,)
        External force [N] on q, and stiffness [N/m] of a repelling spring, from each row to the next.
    drag : float
        Force [N] of a wire that slides; before that it gives way by `GIVE`.
    """

    lag: FloatArray
    rate_limit: FloatArray
    power_over_capacitance: FloatArray
    charge_left: float
    highest: float
    noise: FloatArray
    linearity: float
    linearity_phase: float
    rail: float
    resolution: float
    lost: FloatArray
    force: FloatArray
    spring: FloatArray
    drag: float


def _call_step(context, address, q, target, v):  # type: ignore[no-untyped-def]  # numba's own form
    """Call ``void step(double q, double target, double v[2])`` at an address."""

    def generate(target_context, builder, signature, arguments):  # type: ignore[no-untyped-def]
        """LLVM code: a call of the address."""
        kind = ir.FunctionType(ir.VoidType(), [ir.DoubleType(), ir.DoubleType(), ir.IntType(64)])
        builder.call(builder.inttoptr(arguments[0], kind.as_pointer()), arguments[1:])
        return target_context.get_dummy_value()

    return types.void(types.intp, types.float64, types.float64, types.intp), generate


call_step: Any = intrinsic(_call_step)


@inner
def _charge(
    v: FloatArray, membranes: FloatArray, command: FloatArray, h: float, around: Surroundings, charge: FloatArray
) -> None:
    """Move voltages of converters, `v`, and membranes over a time step of `h` [s]; fill `charge` with means of squares.

    The squares are those of the membranes' voltages.
    """
    dt = h / FINE
    for side in range(2):
        decay = -np.expm1(-dt / around.lag[side])
        total = 0.0
        for _ in range(FINE):
            before = membranes[side]
            v[side] = charged(
                v[side], command[side], decay, around.rate_limit[side], around.power_over_capacitance[side], dt
            )
            now = v[side] + (before - v[side]) * around.charge_left
            total += (before * before + before * now + now * now) / 3.0
            membranes[side] = now
        charge[side] = total / FINE


@compiled
def laser_reading(q: float, row: int, around: Surroundings) -> float:
    """Reading of the laser [m] for a displacement at a row of the log."""
    if around.lost[row] == GONE:
        return np.nan
    reading = q + bent(q, around.linearity, around.rail, around.linearity_phase) + around.noise[row]
    shown = min(max(reading, -around.rail), around.rail)
    return float(np.round(shown / around.resolution) * around.resolution)


@compiled
def close_loop(
    p: RigParameters,
    start: FloatArray,
    around: Surroundings,
    target: FloatArray,
    address: int,
    out: FloatArray,
    refused: IntArray,
) -> bool:
    """Run the loop from rest and fill `out`.

    Parameters
    ----------
    p : RigParameters
        The joint.
    start : FloatArray, shape (n,)
        Its coordinates at rest.
    around : Surroundings
        Instruments and disturbances, on the rows of `out`.
    target : FloatArray, shape (N,)
        Target that the controller gets [m].
    address : int
        Of the controller's step function.
    out : FloatArray, shape (N, 6)
        Filled: the laser's reading [m], the converters' voltages [V], the commands [V], and q [m] without any
        instrument. Rows are `PERIOD` / `HALVES` apart.
    refused : IntArray, shape (2,)
        Raised by the commands that are no numbers, and by those beyond the converters' range.

    Returns
    -------
    bool
        False if Newton's method failed, as when a membrane is stretched beyond its rubber law.

    Notes
    -----
    Cost: 9 ms for a second of motion, and the controller's own time.
    """
    h = PERIOD / HALVES
    state, work = at_rest(p, start)
    v = np.zeros(2)
    membranes = np.zeros(2)
    command = np.zeros(2)
    reading = 0.0
    anchor = work.pose[0]
    for row in range(out.shape[0]):
        locate_tip(state.x, state.v, p, work)
        q = work.pose[0]
        if row == 0 or around.lost[row] != FROZEN:
            reading = laser_reading(q, row, around)
        anchor = min(max(anchor, q - GIVE), q + GIVE)
        if row % HALVES == 0:
            call_step(address, reading, target[row], command.ctypes.data)
            for side in range(2):
                asked = command[side]
                command[side] = min(max(asked, 0.0), around.highest) if asked == asked else 0.0
                if asked - asked != 0.0:  # NaN or infinite
                    refused[0] += 1
                elif asked != command[side]:
                    refused[1] += 1
        out[row, 0], out[row, 5] = reading, q
        for side in range(2):
            out[row, 1 + side], out[row, 3 + side] = v[side], command[side]
        _charge(v, membranes, command, h, around, state.charge)
        state.hand[0] = around.force[row] - around.drag * (q - anchor) / GIVE
        state.hand[1] = around.spring[row]
        if not advance(h, row % KEEP == 0, state, p, work):
            return False
    return True


_STEP = ctypes.CFUNCTYPE(None, ctypes.c_double, ctypes.c_double, ctypes.POINTER(ctypes.c_double))
Step = Callable[[float, float], tuple[float, float]]


class Controller:
    """A controller from a function that gets the first reading [m] and returns the step function.

    Attributes
    ----------
    address : int
        Of its step for compiled code, while this object is alive.
    failure : list of Exception
        Errors of its Python; the voltages are zero from there on.
    """

    def __init__(self, beginning: Callable[[float], Step]) -> None:
        self._beginning = beginning
        self._called = _STEP(self._answer)
        self.address = ctypes.cast(self._called, ctypes.c_void_p).value or 0
        self.failure: list[Exception] = []

    def begin(self, q: float) -> None:
        """Make the step function for the first reading [m]."""
        self._step = self._beginning(q)

    def _answer(self, q: float, target: float, v: Any) -> None:
        """Write the voltages [V] for a reading and a target [m] into `v`; zero from the first failure on."""
        left = right = 0.0
        try:
            if not self.failure:
                left, right = self._step(q, target)
        except Exception as error:  # it cannot pass through the compiled loop
            self.failure.append(error)
        v[0], v[1] = left, right


def played(t: FloatArray, u: FloatArray) -> Controller:
    """An open-loop controller that gives `u`, shape (N, 2) [V], each row from its time `t` [s] on."""
    rows = np.clip(np.searchsorted(t, np.arange(0.0, t[-1] + PERIOD, PERIOD) + 1e-9, side="right") - 1, 0, t.size - 1)
    commands = iter(u[rows].tolist())

    def step(_q: float, _target: float) -> tuple[float, float]:
        """The next row; zero volts after the last."""
        left, right = next(commands, (0.0, 0.0))
        return left, right

    return Controller(lambda _q: step)


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
    Cost: 9 ms for a second of motion, 10 ms for the rest at the start, and the controller's own time.
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
    controller.begin(laser_reading(tip_displacement(p, start), 0, around))
    out = np.zeros((rows, 6))
    refused = np.zeros(2, dtype=np.int64)
    follows = close_loop(changed, start, around, target, controller.address, out, refused)
    if controller.failure:
        error = controller.failure[0]
        raise InputError(f"the controller failed: {type(error).__name__}: {error}") from error
    if not follows:
        raise InputError("the virtual joint cannot follow: a membrane is stretched beyond its rubber law")
    left, right = (bench.probes[side].read(t, out[:, 1 + side], rng) for side in (0, 1))
    return ClosedLoop(
        t=t,
        q=out[:, 0],
        v1=left,
        v2=right,
        target=target,
        command1=out[:, 3],
        command2=out[:, 4],
        true_q=out[:, 5],
        commands_not_finite=int(refused[0]),
        commands_clipped=int(refused[1]),
    )


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
        highest=scenario.highest,
        noise=noise,
        linearity=laser.linearity,
        linearity_phase=float(phase[0]),
        rail=laser.rail,
        resolution=laser.resolution,
        lost=lost,
        force=_tip_force(scenario, t),
        spring=spring,
        drag=scenario.drag,
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
