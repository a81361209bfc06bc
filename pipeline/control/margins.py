"""Margins of the loop that holds the unstable equilibrium: gain, delay, friction.

The joint is its exact linear model there, with both converters; the controller is differentiated as it runs. The loop
is cut at the laser's reading. A beam whose friction sticks is stiffer than one whose friction slides, so both are
examined, and the joint without the friction that the controller counts on.
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from scipy.linalg import expm

from ..generated.condensed_joint import SHAPE, STATES, STOPS
from ..numerics.arrays import FloatArray
from .controller import begin_control, control, go_on
from .estimator import MEMORY, PERIOD, direction, travel
from .feedback import INTEGRAL
from .law import CONTROLLER_STATE, CORRECTED, FILTER, NUMBERS, PLACES, SIDES, Law
from .plant import ControlledJoint, full_jacobian

FACTOR = 20.0
"""Largest factor that is tried on gain and friction; 1 over it is the least on the gain."""
_PRECISION = 0.02
"""Relative error of the factors, and of the grid of frequencies."""
_ENTRIES = np.concatenate([np.arange(CONTROLLER_STATE)[PLACES[name]] for name in ("x", "volts", "moment", "level")])
_GRID = np.exp(np.arange(-np.log(MEMORY), np.log(np.pi / PERIOD), _PRECISION))  # rad/s

Matrices = tuple[FloatArray, FloatArray, FloatArray, FloatArray]
"""A, B, C, D of a system in discrete time."""


@dataclass(frozen=True)
class Margins:
    """Differences from the model, each alone, at which the loop at the unstable equilibrium becomes unstable.

    Attributes
    ----------
    gain_low, gain_high : float
        Factors on the gain from the voltages to the reading; held within 1/`FACTOR` and `FACTOR`.
    delay_s : float
        Time [s] by which everything may come later.
    friction_high : float
        Factor on the joint's friction; held at `FACTOR`. The lower end is none at all.
    """

    gain_low: float
    gain_high: float
    delay_s: float
    friction_high: float


def margins(plant: ControlledJoint, law: Law, saddle: float) -> Margins | None:
    """The margins at the unstable equilibrium `saddle` (reading, m); None where the loop does not hold it.

    Limits on the voltages' rate and mean are left out: small motions meet none.

    Notes
    -----
    Cost: 0.3 s.
    """
    limits = np.isin(NUMBERS, ("slew", "allowed"))
    law = law._replace(numbers=np.where(limits, law.number("highest"), law.numbers))
    sliding = law._replace(numbers=np.where(np.char.startswith(NUMBERS, "travel"), np.inf, law.numbers))
    targets = np.full(round(INTEGRAL / PERIOD), saddle)
    s = np.zeros(CONTROLLER_STATE)
    joint = np.zeros(CONTROLLER_STATE)
    begin_control(saddle, sliding, s)
    begin_control(saddle, sliding, joint)
    go_on(sliding, s, sliding, joint, targets)
    if abs(joint[0] + law.number("offset") - saddle) > law.number("near"):
        return None
    free = stepped(plant, law, joint, 0.0)
    slippery = differentiated(sliding, s, saddle)
    go_on(law, s, law, joint, targets)
    sticky = differentiated(law, s, saddle)
    loops = [(free, slippery), (free, sticky), (stepped(plant, law, joint, 1.0), sticky)]
    if not all(_stable(*loop) for loop in loops):
        return None
    low, high = (
        [_edge(lambda k, loop=loop: _stable(*loop, gain=k), end) for loop in loops]  # type: ignore[misc]
        for end in (1.0 / FACTOR, FACTOR)
    )
    friction = _edge(lambda f: _stable(stepped(plant, law, joint, f), sticky), FACTOR)
    return Margins(max(low), min(high), min(_delay(*loop) for loop in loops), friction)


def stepped(plant: ControlledJoint, law: Law, joint: FloatArray, friction: float) -> Matrices:
    """Reading over commanded voltages about a joint at rest, over a period, with a factor on friction that sticks.

    Parameters
    ----------
    plant : ControlledJoint
        The joint.
    law : Law
        With the converters.
    joint : FloatArray, shape (CONTROLLER_STATE,)
        The joint at rest.
    friction : float
        Factor on friction that sticks.
    """
    volts = joint[PLACES["volts"]]
    n = STATES
    a, b = full_jacobian(joint[PLACES["x"]], volts**2, plant.constants)
    whole = np.zeros((n + 4, n + 4))
    whole[:n, :n] = a[:, :n] + friction * a[:, n:] @ _stops(law)
    whole[:n, n : n + 2] = 2.0 * b * volts
    for side, name in enumerate(SIDES):
        rate = -np.log(law.number(f"kept_{name}")) / PERIOD
        whole[n + side, [n + side, n + 2 + side]] = -rate, rate
    step = expm(PERIOD * whole)
    return step[: n + 2, : n + 2], step[: n + 2, n + 2 :], np.eye(1, n + 2), np.zeros((1, 2))


def _stops(law: Law) -> FloatArray:
    """Stop operators that stick over the joint's state, shape (STOPS, STATES)."""
    moved = np.zeros((STOPS, STATES))
    n = dict(zip(NUMBERS, law.numbers.tolist(), strict=True))
    for i in range(STOPS):
        moved[i, SHAPE] = np.array(direction(i, n)) / travel(i, n)
    return moved


def differentiated(law: Law, s: FloatArray, target: float) -> Matrices:
    """Voltages over the reading of a controller in the state `s` at its target (reading, m), as it runs."""
    at = s[PLACES["x"]][0] + law.number("offset")
    size = len(_ENTRIES)
    stops = _stops(law)
    step = float(np.sqrt(np.finfo(float).eps))
    *reach, moment = (law.number(f"bound_{i}") for i in range(FILTER))
    units = [*reach, *np.ones(STATES - CORRECTED), *np.full(2, law.number("highest")), moment, moment]  # of `_ENTRIES`

    def after(moved: FloatArray, reading: float) -> FloatArray:
        """The state's entries and the voltages after a period."""
        v = np.zeros(2)
        state = moved.copy()
        control(state, reading, target, law, v)
        return np.concatenate([state[_ENTRIES], v])

    columns = []
    for entry, unit in zip(_ENTRIES, units, strict=True):
        length = step * unit
        move = np.zeros(CONTROLLER_STATE)
        move[entry] = length
        if entry < STATES:
            move[PLACES["z"]] = length * stops[:, entry]
        columns.append((after(s + move, at) - after(s - move, at)) / (2.0 * length))
    length = step * units[0]
    columns.append((after(s, at + length) - after(s, at - length)) / (2.0 * length))
    by = np.array(columns).T
    return by[:size, :size], by[:size, size:], by[size:, :size], by[size:, size:]


def _stable(joint: Matrices, controller: Matrices, gain: float = 1.0) -> bool:
    a, b, c, _ = joint
    e, f, g, h = controller
    closed = np.block([[a + gain * b @ h @ c, gain * b @ g], [f @ c, e]])
    return bool(np.abs(np.linalg.eigvals(closed)).max() < 1.0)


def _edge(holds: Callable[[float], bool], end: float) -> float:
    """The last factor from 1 towards `end` with which the loop holds."""
    inside = 1.0
    for factor in np.geomspace(1.0, end, round(abs(np.log(end)) / _PRECISION)).tolist():
        if not holds(factor):
            return inside
        inside = factor
    return end


def _delay(joint: Matrices, controller: Matrices) -> float:
    """Delay [s] that takes a stable loop to its border: of all frequencies with the gain 1 the least phase over ω."""
    z = np.exp(1j * _GRID * PERIOD)
    loop = -np.squeeze(_response(joint, z) @ _response(controller, z))
    over = np.abs(loop) > 1.0
    crossings = np.flatnonzero(over[1:] != over[:-1])
    phase = np.mod(np.angle(loop[crossings]) + np.pi, 2.0 * np.pi)
    return float(np.min(phase / _GRID[crossings], initial=np.inf))


def _response(system: Matrices, z: "np.ndarray[tuple[int], np.dtype[np.complex128]]") -> FloatArray:
    a, b, c, d = system
    inverse = np.linalg.solve(z[:, None, None] * np.eye(len(a)) - a, np.broadcast_to(b, (z.size, *b.shape)))
    return np.asarray(c @ inverse + d)
