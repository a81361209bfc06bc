"""Design of the controller on the identified joint: its numbers, and the tables that it reads.

Targets are equilibria of the model: the voltages that hold it there, the charge of both sides, and the gains of the
linear-quadratic regulator. Braking curves come from simulation (`pipeline.control.braking`).
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
from ..numerics.metrics import BAND
from .braking import braking_curves, reached
from .estimator import PERIOD
from .law import BEYOND, CORRECTED, FEEDBACK, NUMBERS, REACHES, RESTS, SIDES, TARGETS, Law
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


def target_table(
    plant: ControlledJoint, wells: list[LinearModel], places: FloatArray, highest: float, lag: float, reach: FloatArray
) -> tuple[FloatArray, tuple[float, float]]:
    """Rows of `pipeline.control.law.TARGET_COLUMNS`, and the voltages that switch the joint slowly.

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
        Deviations of the leading states that weigh as much as the largest moment.

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
        Deviations of the leading states that weigh as much as the largest moment.
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
