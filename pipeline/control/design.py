"""Design of the controller on the identified joint: its numbers, and the tables that it reads.

Targets: equilibria held there, charge of both sides, gains of the linear-quadratic regulator. Braking curves: the
largest speeds from which full braking still stops at a target, by simulation of the model.
"""

import math
from dataclasses import dataclass

import numpy as np
from scipy.linalg import expm, solve_discrete_are

from ..errors import InputError
from ..generated.condensed_joint import SHAPE_RATES, STATES, STOP_ELEMENTS
from ..models.hybrid.kernels import INDEX, tabulate
from ..models.hybrid.statics import rest_state
from ..numerics.arrays import FloatArray
from ..numerics.compiled import compiled, copy_into
from ..numerics.metrics import BAND
from .controller import move
from .estimator import PERIOD
from .feedback import RESERVE
from .law import BEYOND, CONTROLLER_STATE, CORRECTED, FEEDBACK, NUMBERS, PLACES, REACHES, RESTS, SIDES, TARGETS, Law
from .plant import (
    ASSUMED_LAG,
    ControlledJoint,
    LinearModel,
    held,
    held_at,
    inertia,
    jacobian,
    prepare_slopes,
    wells_and_saddle,
)

COMMON = 0.05
"""Step of the mean share of the largest squared voltage on both sides at an unstable target."""
SLOW = 15.0
"""Unstable pole [1/s] up to which both sides are charged: a quarter of the slowest zero in the right half plane."""


def target_table(
    plant: ControlledJoint, wells: list[LinearModel], places: FloatArray, highest: float, lag: float, reach: FloatArray
) -> tuple[FloatArray, tuple[float, float]]:
    """Rows as `pipeline.control.law.TARGET_COLUMNS` names them, and what switches the joint slowly.

    Parameters
    ----------
    plant : ControlledJoint
        The joint.
    wells : list of LinearModel
        Left well, saddle, right well.
    places : FloatArray, shape (TARGETS,)
        Targets [m].
    highest : float
        Largest voltage [V].
    lag : float
        Time constant [s] from command to force, the mean of both sides.
    reach : FloatArray, shape (CORRECTED,)
        Of the leading states, what weighs as the largest moment.

    Returns
    -------
    table : FloatArray, shape (TARGETS, columns)
        SI.
    slow : tuple of float
        Voltages [V] with which left and right side carry the joint slowly from their well to the saddle.
    """
    path = [held_at(plant, float(q), wells[1].x) for q in places]
    rows = []
    for x, u in path:
        (y, acting), common = charged(plant, x, u, highest)
        per_square = moments_per_square(plant, y, acting)
        holding = per_square @ (acting * (1.0, -1.0))
        gains = regulator(plant, y, acting, highest, lag, reach)
        rows.append(np.concatenate([y, [holding], gains, per_square * highest**2, [common]]))
    return np.array(rows), (slow_switching_voltage(path, wells, 0), slow_switching_voltage(path, wells, 1))


def moments_per_square(plant: ControlledJoint, x: FloatArray, u: FloatArray) -> FloatArray:
    """Moment of each side on the slope in its own direction [N·m/V²] at a state under squared voltages, shape (2,)."""
    _, b = jacobian(x, u, plant.constants)
    left, right = inertia(x, plant.constants.p)[1] @ b[SHAPE_RATES]
    return np.asarray(np.maximum(np.array([left, -right]), 1e-12))


def slow_switching_voltage(path: list[tuple[FloatArray, FloatArray]], wells: list[LinearModel], side: int) -> float:
    """Voltage [V] with which a side carries the joint slowly from its well to the saddle."""
    start = float(wells[0 if side == 0 else 2].x[0])
    saddle = float(wells[1].x[0])
    needed = [float(u[side]) for x, u in path if min(start, saddle) < float(x[0]) < max(start, saddle)]
    return float(np.sqrt(max(needed, default=0.0)))


def charged(
    plant: ControlledJoint, x: FloatArray, u: FloatArray, highest: float
) -> tuple[tuple[FloatArray, FloatArray], float]:
    """The equilibrium at the same place with both sides charged, if it is unstable; and the mean share of `highest`².

    The charge grows until the unstable pole is `SLOW`, or the difference of both sides needs the rest.

    Parameters
    ----------
    plant : ControlledJoint
        The joint.
    x : FloatArray, shape (STATES,)
        Equilibrium.
    u : FloatArray, shape (2,)
        Squared voltages that hold it [V²].
    highest : float
        Largest voltage [V].
    """
    equilibrium = (x, u)
    share = 0.0
    apart = np.array([0.5, -0.5])
    for common in np.arange(COMMON, 1.0, COMMON).tolist():
        a, _ = jacobian(*equilibrium, plant.constants)
        if np.linalg.eigvals(a).real.max() < (SLOW if share else 0.0):
            break
        answer = held(plant, x, common * highest**2 * np.ones(2), apart)
        if answer is None:
            break
        x, difference = answer
        if abs(difference) <= 2.0 * min(common, 1.0 - common) * highest**2:
            equilibrium = (x, common * highest**2 + difference * apart)
            share = common
    return equilibrium, share


def regulator(
    plant: ControlledJoint, x: FloatArray, u: FloatArray, highest: float, lag: float, reach: FloatArray
) -> FloatArray:
    """Gains of the linear-quadratic regulator about an equilibrium under squared voltages, shape (FEEDBACK,).

    Weights are Bryson's: each leading state over its `reach`, the moment over the largest one. The moment that acts
    follows the commanded one with the converters' lag; it is the last state. Both sides act along
    the same direction to within a few percent; the mean of both is used.

    Parameters
    ----------
    plant : ControlledJoint
        The joint.
    x : FloatArray, shape (STATES,)
        Equilibrium.
    u : FloatArray, shape (2,)
        Squared voltages that hold it [V²].
    highest : float
        Largest voltage [V].
    lag : float
        Time constant from command to force [s].
    reach : FloatArray, shape (CORRECTED,)
        Of the leading states, what weighs as the largest moment.
    """
    a, b = jacobian(x, u, plant.constants)
    per_square = moments_per_square(plant, x, u)
    n = STATES
    whole = np.zeros((n + 2, n + 2))
    whole[:n, :n] = a
    whole[:n, n] = 0.5 * (b[:, 0] / per_square[0] - b[:, 1] / per_square[1])
    whole[n, n:] = -1.0 / lag, 1.0 / lag
    step = expm(PERIOD * whole)
    weight = np.append(1.0 / reach**2, np.zeros(FEEDBACK - CORRECTED))
    control_weight = 1.0 / (float(np.mean(per_square)) * highest**2) ** 2
    drive = step[:-1, -1:]
    cost = solve_discrete_are(step[:-1, :-1], drive, np.diag(weight), np.array([[control_weight]]))
    return np.asarray(np.linalg.solve(control_weight + drive.T @ cost @ drive, drive.T @ cost @ step[:-1, :-1])[0])


@compiled
def reached(law: Law, start: FloatArray, end: float, v: FloatArray) -> FloatArray:
    """Largest magnitudes of the leading states, shape (CORRECTED,), in a snap of the model.

    Parameters
    ----------
    law : Law
        With the model; its tables are not needed.
    start : FloatArray, shape (STATES,)
        A well, without voltage.
    end : float
        The other well [m].
    v : FloatArray, shape (2,)
        Voltages [V] until the joint is half way there; then there are none. At most `LONGEST` periods are looked at.
    """
    s = np.zeros(CONTROLLER_STATE)
    largest = np.zeros(CORRECTED)
    none = np.zeros(2)
    half = 0.5 * (start[0] + end)
    copy_into(s[:STATES], start)
    for _ in range(LONGEST):
        move(s, v if (s[0] - half) * (end - half) < 0.0 else none, law)
        for i in range(CORRECTED):
            largest[i] = max(largest[i], abs(s[i]))
        if (s[0] - end) * (end - half) > 0.0:
            break
    return largest


LONGEST = 600
"""Periods of a motion of the model, at most."""
EVERY = 2
"""Periods from one braked instant to the next."""
SPEEDS = (1.0, 2.0)
"""Speeds, over the largest of a snap, with which motions begin that are braked."""
LEVELS = (1.0, 0.5)
"""Shares of the largest moment that push them."""


def braking_curves(
    law: Law, wells: list[LinearModel], slope: float, places: FloatArray, side: int, highest: float, fastest: float
) -> tuple[FloatArray, FloatArray]:
    """Speeds [m/s] of the mass centre at which a brake begins, and during it, to stop at each place.

    Both have the shape (len(places), REACHES), for distances up to that of the wells.

    Motions towards the places, slow and fast ones, are simulated and braked at every instant. The instant at which one
    stops at a place is a point of that place's first curve. The second curve is the brake of the first motion that
    stops there, after its first periods: that motion is the one from rest under full voltage.

    Parameters
    ----------
    law : Law
        With the model.
    wells : list[LinearModel]
        Left well, saddle, right well.
    slope : float
        τ/q of slow motions [1/m].
    places : FloatArray, shape (TARGETS,)
        Targets [m].
    side : int
        That pushes: 0 left, 1 right.
    highest : float
        Largest voltage [V].
    fastest : float
        Largest speed of a snap [m/s].
    """
    towards = 1.0 if side == 0 else -1.0
    start = wells[0 if side == 0 else 2].x
    brake = highest * np.sqrt(RESERVE) * np.eye(2)[1 - side]
    settles = round(law.number("settles"))
    reaches = np.linspace(0.0, float(wells[2].x[0] - wells[0].x[0]), REACHES)
    begins = [np.zeros((1, 2)) for _ in places]
    lasts = begins.copy()
    for x0, speed, level in [
        *((start, 0.0, level) for level in LEVELS),
        *((start, speed, 1.0) for speed in SPEEDS),
        *((wells[1].x, 0.5 * speed, level) for speed in SPEEDS for level in (0.0, *LEVELS)),
    ]:
        push = highest * np.sqrt(level) * np.eye(2)[side]
        s = np.zeros(CONTROLLER_STATE)
        s[:STATES] = x0
        s[PLACES["volts"]] = push
        s[1] = towards * fastest * speed
        s[3] = towards * fastest * speed * slope
        motion, turns = pushed(law, s, push, brake, towards)
        for i, place in enumerate(places):
            beyond = towards * (turns - place)
            cross = np.flatnonzero((beyond[1:] > 0.0) & (beyond[:-1] <= 0.0))
            if not cross.size:
                continue
            row = int(cross[0])
            share = -beyond[row] / (beyond[row + 1] - beyond[row])
            stop = towards * braked(law, (1.0 - share) * motion[row] + share * motion[row + 1], push, brake, towards)
            stop[:, 0] = stop[-1, 0] - stop[:, 0]
            if stop[0, 0] > reaches[1]:
                begins[i] = np.vstack([begins[i], stop[:1]])
                if len(lasts[i]) == 1 and len(stop) > 2 * settles:
                    lasts[i] = np.vstack([lasts[i], stop[settles:-1]])
    first = np.array([_curve(points, reaches) for points in begins])
    later = [_curve(points, reaches) if len(points) > 1 else curve for points, curve in zip(lasts, first, strict=True)]
    return first, np.maximum(first, later)


def _curve(points: FloatArray, reaches: FloatArray) -> FloatArray:
    """Speeds at `reaches` [m] from points (distance, speed), on lines; beyond the last point as √distance."""
    distance, speed = points[np.argsort(points[:, 0])].T
    speed = np.maximum.accumulate(speed)
    if len(distance) == 1:
        return np.sqrt(2.0 * reaches)  # never needs braking: 1 m/s²
    curve = np.interp(reaches, distance, speed)
    first = reaches < distance[1]
    curve[first] = speed[1] * np.sqrt(reaches[first] / distance[1])
    last = reaches > distance[-1]
    curve[last] = speed[-1] * np.sqrt(reaches[last] / distance[-1])
    return np.asarray(curve)


@compiled
def pushed(
    law: Law, s: FloatArray, push: FloatArray, brake: FloatArray, towards: float
) -> tuple[FloatArray, FloatArray]:
    """States of a motion under `push` [V], and where it would turn round if braked there with `brake` [V].

    There is one in `EVERY` periods. The motion ends when it turns round by itself; the tip may move backwards at first.
    `s` is moved along.

    Parameters
    ----------
    law : Law
        With the model.
    s : FloatArray, shape (CONTROLLER_STATE,)
        The joint's state; moved on.
    push : FloatArray, shape (2,)
        Voltages [V].
    brake : FloatArray, shape (2,)
        Voltages of the brake [V].
    towards : float
        1 to the right, −1 to the left.
    """
    most = LONGEST // EVERY
    motion = np.empty((most, s.size))
    turns = np.empty(most)
    forwards = False
    for i in range(most):
        copy_into(motion[i], s)
        turns[i] = braked(law, s, push, brake, towards)[-1, 0]
        for _ in range(EVERY):
            move(s, push, law)
        if forwards and towards * s[1] <= 0.0:
            return motion[: i + 1], turns[: i + 1]
        forwards = towards * s[1] > 0.0
    return motion, turns


@compiled
def braked(law: Law, s: FloatArray, push: FloatArray, brake: FloatArray, towards: float) -> FloatArray:
    """Displacement [m] and the mass centre's speed [m/s] every period under `brake` [V] after `push` [V], to the turn.

    A voltage changes by at most the slew limit in a period.

    Parameters
    ----------
    law : Law
        With the model.
    s : FloatArray, shape (CONTROLLER_STATE,)
        The joint's state.
    push : FloatArray, shape (2,)
        Voltages before [V].
    brake : FloatArray, shape (2,)
        Voltages of the brake [V].
    towards : float
        1 to the right, −1 to the left.
    """
    end = s.copy()
    v = push.copy()
    motion = np.empty((LONGEST, 2))
    slew = law.numbers[_SLEW]
    for i in range(LONGEST):
        motion[i, 0] = end[0]
        motion[i, 1] = end[1] + law.numbers[_LEVER] * end[3]
        if towards * end[1] <= 0.0:
            return motion[: i + 1]
        for side in range(2):
            v[side] = min(max(brake[side], v[side] - slew), v[side] + slew)
        move(end, v, law)
    return motion


_SLEW = NUMBERS.index("slew")
_LEVER = NUMBERS.index("lever")


WEIGHT = 0.2
"""Share of what a state reaches in a snap that weighs as the largest moment does in the regulators."""
NEAR = 0.07
"""Distance, over that of the wells, within which the regulator begins; it stops at twice that distance."""
STEEPNESS = 2.0
"""Share of the largest moment for a speed off the braking curve that is the largest one of a snap."""
SETTLES = 0.14
"""Part of a snap's time after which a brake has taken hold: the slope has followed the moment."""
READING = 1.5e-4
"""Standard deviation of a reading over the wells' distance: noise, resolution, and the laser's linearity as it changes
with the motion."""
PUSH = 1.2e-4
WALK = 1e-2
"""Standard deviations of a white force on q [√s], over the largest moment through the wells' distance, and of the
random walk of the unknown moment [1/√s], over the largest one."""
BOUND = 10.0
"""Magnitude that no estimate passes, over what it reaches in a snap, or over the largest moment."""
NODES = 2
"""Points of the table of the corrections in a width σ."""


@dataclass(frozen=True)
class Settings:
    """Choices of the user.

    Attributes
    ----------
    highest : float
        Largest voltage [V].
    lags : tuple of float
        Time constants of the left and the right converter [s].
    slew, average : float or None
        Largest rate [V/s] of each voltage, and its largest mean over `MEMORY` [V]; None is no limit.
    """

    highest: float
    lags: tuple[float, float] = (ASSUMED_LAG, ASSUMED_LAG)
    slew: float | None = None
    average: float | None = None


def design(plant: ControlledJoint, settings: Settings) -> Law:
    """The controller of a plant.

    Raises
    ------
    InputError
        The joint is not bistable, the voltage limit lies outside the trained range, or it moves the joint in no well by
        the standard deviation of a reading.

    Notes
    -----
    Cost: 0.5 s.
    """
    wells = movable_wells(plant, settings.highest)
    left, saddle, right = (float(well.x[0]) for well in wells)
    between = TARGETS - 1 - 2 * BEYOND
    places: FloatArray = left + (right - left) / between * np.arange(-BEYOND, between + BEYOND + 1.0)
    lags = acting_lags(plant, settings)
    distance = right - left
    mass = inertia(wells[1].x, plant.constants.p)
    slew = min(settings.highest, np.inf if settings.slew is None else PERIOD * settings.slew)
    law = condensed_joint_law(plant, lags)
    reach = np.maximum(
        reached(law, wells[0].x, right, np.array([plant.highest, 0.0])),
        reached(law, wells[2].x, left, np.array([0.0, plant.highest])),
    )
    fastest = float(reach[1])
    snap_time = distance / fastest
    targets, slow = target_table(plant, wells, places, settings.highest, sum(lags) / 2.0, WEIGHT * reach)
    moment = float(np.mean(moments_per_square(plant, wells[1].x, np.zeros(2)))) * plant.highest**2
    numbers = dict(zip(NUMBERS, law.numbers.tolist(), strict=True)) | {
        "highest": settings.highest,
        "first": places[0],
        "per_step": 1.0 / (places[1] - places[0]),
        "per_reach": (REACHES - 1) / distance,
        "steepness": STEEPNESS / fastest,
        "saddle": saddle,
        "pumped_right": float(slow[0] > settings.highest),
        "pumped_left": float(slow[1] > settings.highest),
        "near": NEAR * distance,
        "lever": mass[0, 1] / mass[0, 0],
        "settles": SETTLES * snap_time / PERIOD + settings.highest / slew - 1.0,
        "slew": slew,
        "allowed": min(settings.highest, np.inf if settings.average is None else settings.average),
        "fade": PERIOD / snap_time,
        "slow": BAND * fastest,
        "band": BAND * distance,
        "same": BAND * distance / (places[1] - places[0]),
        **filter_numbers(distance, reach, moment),
    }
    slope = plant.constants.k[INDEX["slope_ratio"]] / plant.constants.k[INDEX["l"]]
    law = law._replace(numbers=np.array([numbers[name] for name in NUMBERS], dtype=np.float64), targets=targets)
    (begins_left, lasts_left), (begins_right, lasts_right) = (
        braking_curves(law, wells, slope, places, side, settings.highest, fastest) for side in (0, 1)
    )
    return law._replace(braking=np.concatenate([begins_left, begins_right, lasts_left, lasts_right]))


def movable_wells(plant: ControlledJoint, highest: float) -> list[LinearModel]:
    """Left well, saddle and right well of a joint that voltages up to `highest` [V] can move; raises as `design`."""
    if not 0.0 < highest <= plant.highest * (1.0 + 1e-9):
        raise InputError(
            f"a largest voltage of {highest:g} V lies outside the trained range 0 to {plant.highest:.0f} V"
        )
    left, saddle, right = wells_and_saddle(plant)
    noise = READING * (float(right.x[0]) - float(left.x[0]))
    moved = max(np.abs(well.c @ np.linalg.solve(well.a, well.b_squared)).max() for well in (left, right))
    if moved * highest**2 < noise:
        raise InputError(
            f"a largest voltage of {highest:g} V does not move the joint by the noise of a reading, "
            f"{1e6 * noise:.2g} µm; allow a larger one"
        )
    return [left, saddle, right]


def filter_numbers(distance: float, reach: FloatArray, moment: float) -> dict[str, float]:
    """Numbers of the estimator's filter by name.

    Parameters
    ----------
    distance : float
        Of the wells [m].
    reach : FloatArray, shape (CORRECTED,)
        Largest magnitudes of the leading states in a snap.
    moment : float
        Largest moment [N·m].
    """
    scale = np.append(reach, moment)
    unknown = np.append(READING * distance, scale[1:])
    return {
        "reading_variance": (READING * distance) ** 2,
        "push": (PUSH * moment / distance) ** 2,
        "walk": (WALK * moment) ** 2,
        **{f"unknown_{i}": value**2 for i, value in enumerate(unknown)},
        **{f"bound_{i}": BOUND * value for i, value in enumerate(scale)},
    }


def condensed_joint_law(plant: ControlledJoint, lags: tuple[float, float]) -> Law:
    """Control law for a plant whose converters have the time constants `lags` [s], without feedback tables."""
    k, p, basis, weights = plant.constants
    farthest = 0.9 * plant.wall
    decays = [math.exp(-PERIOD / lag) for lag in lags]
    grid = np.linspace(-farthest, farthest, RESTS)
    rests = [rest_state(q, np.zeros(2), k, p, basis, weights, 0.0) for q in grid]
    first, per_metre, curves = tabulate(basis, weights, NODES)
    numbers = {
        "offset": plant.instruments.offset,
        "wall": plant.wall,
        "farthest": farthest,
        **{f"kept_{side}": left for side, left in zip(SIDES, decays, strict=True)},
        **{f"kept_mean_{x}": (1.0 - left) * lag / PERIOD for x, left, lag in zip(SIDES, decays, lags, strict=True)},
        "arm": k[INDEX["friction_arm"]],
        "length": k[INDEX["l"]],
        **{f"travel_{i}": k[INDEX[f"stop_travel_{i}"]] for i in set(STOP_ELEMENTS)},
        "curve_first": first,
        "curve_per_metre": per_metre,
        "curve_last": len(curves) - 1.0,
        "rest_per_metre": 1.0 / (grid[1] - grid[0]),
    }
    return Law(
        numbers=np.array([numbers.get(name, 0.0) for name in NUMBERS], dtype=np.float64),
        prepared=p,
        slopes=prepare_slopes(k),
        curves=np.ascontiguousarray(curves),
        rests=np.array([(x[2], x[4], z[0]) for x, z in rests]),
        targets=np.zeros((TARGETS, 0)),
        braking=np.zeros((4 * TARGETS, 0)),
    )


def acting_lags(plant: ControlledJoint, settings: Settings) -> tuple[float, float]:
    """Time constants [s] from command to force: the converters', and delay and charging time of the identification."""
    own = plant.instruments
    left, right = (max(lag + own.delay + own.charging, 0.5 * PERIOD) for lag in settings.lags)
    return left, right
