"""A controller and a virtual joint in one loop, compiled: the joint moves between two calls of the controller.

Once in a period the controller is given the laser's reading and a target and answers with two commanded voltages,
which are held until the next call. A command is limited to what the converters can give, 0 to `highest`, a NaN to 0.
"""

from typing import Any, NamedTuple

import numpy as np
from llvmlite import ir

from pipeline.compiled import compiled, intrinsic, types
from pipeline.numerics.arrays import FloatArray, IntArray
from pipeline.rig.bench import bent, charged
from pipeline.rig.midpoint import KEEP, advance, at_rest, read_tip, workspace
from pipeline.rig.parameters import RigParameters

HALVES = 2
"""Time steps of the joint in a period of the controller, and rows of the log."""
PERIOD = 1e-3
"""Period of the controller [s]."""
GONE, FROZEN = 1.0, 2.0
"""Marks of a laser that gives no value, and of one that gives its last."""
GIVE = 0.3e-3
"""How far [m] a wire gives way before it slides."""
FINE = 10
"""Steps of a converter in a time step of the joint."""


class Surroundings(NamedTuple):
    """What lies between controller and joint, and what disturbs both.

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
    push, spring : FloatArray, shape (N,)
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
    push: FloatArray
    spring: FloatArray
    drag: float


def _call_step(context, address, memory, q, target, v):  # type: ignore[no-untyped-def]  # numba's own form
    """Call ``void step(void *state, double q, double target, double v[2])`` at an address."""

    def generate(target_context, builder, signature, arguments):  # type: ignore[no-untyped-def]
        """LLVM code: a call of the address."""
        word, real = ir.IntType(64), ir.DoubleType()
        kind = ir.FunctionType(ir.VoidType(), [word, real, real, word])
        builder.call(builder.inttoptr(arguments[0], kind.as_pointer()), arguments[1:])
        return target_context.get_dummy_value()

    return types.void(types.intp, types.intp, types.float64, types.float64, types.intp), generate


call_step: Any = intrinsic(_call_step)


@compiled
def _charge(
    v: FloatArray, membranes: FloatArray, command: FloatArray, h: float, around: Surroundings, charge: FloatArray
) -> None:
    """Move voltages of converters, `v`, and membranes over a time step of `h` [s]; fill `charge` with means of squares.

    The squares are those of the membranes' voltages.
    """
    dt = h / FINE
    for side in range(2):
        decay = -np.expm1(-dt / around.lag[side])
        total, rate, power = 0.0, around.rate_limit[side], around.power_over_capacitance[side]
        for _ in range(FINE):
            before = membranes[side]
            v[side] = charged(v[side], command[side], decay, rate, power, dt)
            now = v[side] + (before - v[side]) * around.charge_left
            total += (before * before + before * now + now * now) / 3.0
            membranes[side] = now
        charge[side] = total / FINE


@compiled
def laser_reading(q: float, row: int, around: Surroundings) -> float:
    """What the laser shows [m] of a displacement at a row of the log."""
    if around.lost[row] == GONE:
        return np.nan
    reading = q + bent(q, around.linearity, around.rail, around.linearity_phase)
    shown = min(max(reading + around.noise[row], -around.rail), around.rail)
    return float(np.round(shown / around.resolution) * around.resolution)


@compiled
def close_loop(
    p: RigParameters, start: FloatArray, around: Surroundings, target: FloatArray, address: int, memory: int,
    out: FloatArray, refused: IntArray,
) -> int:  # fmt: skip
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
    address, memory : int
        Of the controller's step function and of its state.
    out : FloatArray, shape (N, 9)
        Filled: the laser's reading [m], the converters' voltages [V], the commands [V]; then q [m], q̇ [m/s], φ [rad]
        and the rate of φ [rad/s] without any instrument. Rows are `PERIOD` / `HALVES` apart.
    refused : IntArray, shape (2,)
        Raised by the commands that are no numbers, and by those beyond the converters' range.

    Returns
    -------
    int
        Newton iterations; −1 if they failed, as when a membrane is stretched beyond its rubber law.

    Notes
    -----
    Cost: 9 ms for a second of motion, and the controller's own time.
    """
    n, h = start.size, PERIOD / HALVES
    state, work = at_rest(p, start), workspace(p, n)
    inverse, vm, total = np.zeros((n, n)), np.zeros(n), 0
    pose, rate, v, membranes, command = np.zeros(2), np.zeros(2), np.zeros(2), np.zeros(2), np.zeros(2)
    read_tip(state, p, work, pose, rate)
    reading, anchor = 0.0, pose[0]
    for row in range(out.shape[0]):
        read_tip(state, p, work, pose, rate)
        if row == 0 or around.lost[row] != FROZEN:
            reading = laser_reading(pose[0], row, around)
        anchor = min(max(anchor, pose[0] - GIVE), pose[0] + GIVE)
        if row % HALVES == 0:
            call_step(address, memory, reading, target[row], command.ctypes.data)
            for side in range(2):
                asked = command[side]
                command[side] = min(max(asked, 0.0), around.highest) if asked == asked else 0.0
                if asked - asked != 0.0:  # NaN or infinite
                    refused[0] += 1
                elif asked != command[side]:
                    refused[1] += 1
        out[row, 0] = reading
        for side in range(2):
            out[row, 1 + side], out[row, 3 + side] = v[side], command[side]
            out[row, 5 + 2 * side], out[row, 6 + 2 * side] = pose[side], rate[side]
        _charge(v, membranes, command, h, around, state.charge)
        state.hand[0], state.hand[1] = around.push[row] - around.drag * (pose[0] - anchor) / GIVE, around.spring[row]
        taken = advance(h, row % KEEP == 0, state, p, work, inverse, vm)
        if taken < 0:
            return -1
        total += taken
    return total
