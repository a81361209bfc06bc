"""The table of targets: equilibria held there, charge of both sides, and gains of the linear-quadratic regulator."""

import numpy as np
from scipy.linalg import expm, solve_discrete_are

from pipeline.control.estimator import PERIOD
from pipeline.control.law import FEEDBACK
from pipeline.control.linear import LinearModel, held, held_at, jacobian
from pipeline.control.plant import Plant, inertias
from pipeline.generated.condensed_joint import STATES
from pipeline.numerics.arrays import FloatArray

STABLE, UNSTABLE = (0.2e-3, 0.3, 1e6, 0.2), (0.14e-3, 10.0, 5.0, 10.0)
"""Displacement [m], speed [m/s], rate of the slope [1/s] and share of the largest moment that weigh alike in the
regulator of a stable target and of an unstable one."""
COMMON = (0.05, 0.9)
"""Least and largest mean share of the largest squared voltage on both sides at an unstable target."""
SLOW = 15.0
"""Unstable pole [1/s] up to which both sides are charged: a quarter of the slowest zero in the right half plane."""


def target_table(
    plant: Plant, wells: list[LinearModel], places: FloatArray, highest: float, lag: float
) -> tuple[FloatArray, tuple[float, float]]:
    """Rows as `pipeline.control.law.TARGET_COLUMNS` names them, and what switches the joint slowly.

    Parameters
    ----------
    plant : Plant
        The joint.
    wells : list of LinearModel
        Left well, saddle, right well.
    places : FloatArray, shape (TARGETS,)
        Targets [m].
    highest : float
        Largest voltage [V].
    lag : float
        Time constant [s] from command to force.

    Returns
    -------
    table : FloatArray, shape (TARGETS, columns)
        SI.
    slow : tuple of float
        Voltages [V] with which left and right side carry the joint slowly from their well to the saddle.
    """
    path = [held_at(plant, float(q), wells[1].x) for q in places]
    slow = slow_switching_voltage(path, wells, 0), slow_switching_voltage(path, wells, 1)
    rows = []
    for x, u in path:
        (y, acting), common = charged(plant, x, u, highest)
        per_square = moments_per_square(plant, y, acting)
        holding = per_square @ (acting * (1.0, -1.0))
        gains = regulator(plant, y, acting, highest, lag, UNSTABLE if common else STABLE)
        rows.append(np.concatenate([y, [holding], gains, per_square * highest**2, [common]]))
    return np.array(rows), slow


def moments_per_square(plant: Plant, x: FloatArray, u: FloatArray) -> FloatArray:
    """Moment of each side on the slope in its own direction [N·m/V²] at a state under squared voltages, shape (2,)."""
    _, b = jacobian(x, u, plant.constants)
    _, cross, inertia = inertias(x, plant.constants.p)
    left, right = cross * b[1] + inertia * b[3]
    return np.asarray(np.maximum(np.array([left, -right]), 1e-12))


def slow_switching_voltage(path: list[tuple[FloatArray, FloatArray]], wells: list[LinearModel], side: int) -> float:
    """Voltage [V] with which a side carries the joint slowly from its well to the saddle."""
    start, saddle = float(wells[0 if side == 0 else 2].x[0]), float(wells[1].x[0])
    low, high = min(start, saddle), max(start, saddle)
    needed = [float(u[side]) for x, u in path if low < float(x[0]) < high]
    return float(np.sqrt(max(needed, default=0.0)))


def growth(plant: Plant, x: FloatArray, u: FloatArray) -> float:
    """Largest real part [1/s] of the poles about an equilibrium under squared voltages."""
    return float(np.linalg.eigvals(jacobian(x, u, plant.constants)[0]).real.max())


def charged(plant: Plant, x: FloatArray, u: FloatArray, highest: float) -> tuple[tuple[FloatArray, FloatArray], float]:
    """The equilibrium at the same place with both sides charged, if it is unstable; and the mean share of `highest`².

    The charge grows until the unstable pole is `SLOW`, or the difference of both sides needs the rest.
    """
    if growth(plant, x, u) < _UNSTABLE:
        return (x, u), 0.0
    found, share = (x, u), _LEAST_COMMON
    for common in np.linspace(*COMMON, 18):
        answer = held(plant, x, common * highest**2 * np.ones(2), np.array([0.5, -0.5]))
        if answer is None:
            break
        x, difference = answer[0], answer[1] / highest**2
        if abs(difference) <= 2.0 * min(common, 1.0 - common):
            left = common + 0.5 * difference
            found, share = (x, highest**2 * np.array([left, left - difference])), float(common)
            if growth(plant, *found) < SLOW:
                break
    return found, share


_UNSTABLE, _LEAST_COMMON = 0.5, 0.02  # 1/s, share


def regulator(
    plant: Plant, x: FloatArray, u: FloatArray, highest: float, lag: float, weights: tuple[float, float, float, float]
) -> FloatArray:
    """Gains of the linear-quadratic regulator about an equilibrium under squared voltages, shape (FEEDBACK,).

    The moment that acts follows the commanded one with the converters' lag; it is the last state. Both sides act along
    the same direction but for a few percent; the mean of both stands for it.
    """
    a, b = jacobian(x, u, plant.constants)
    per_square = moments_per_square(plant, x, u)
    along = 0.5 * (b[:, 0] / per_square[0] - b[:, 1] / per_square[1])
    n = STATES
    whole = np.zeros((n + 2, n + 2))
    whole[:n, :n], whole[:n, n] = a, along
    whole[n, n], whole[n, n + 1] = -1.0 / lag, 1.0 / lag
    step = expm(PERIOD * whole)
    weight = np.full(FEEDBACK, 1e-9)
    off, speed, turning, moment = weights
    weight[0], weight[1], weight[3] = 1.0 / off**2, 1.0 / speed**2, 1.0 / turning**2
    effort = 1.0 / (moment * float(np.mean(per_square)) * highest**2) ** 2
    drive = step[:-1, -1:]
    cost = solve_discrete_are(step[:-1, :-1], drive, np.diag(weight), np.array([[effort]]))
    gain: FloatArray = np.linalg.solve(effort + drive.T @ cost @ drive, drive.T @ cost @ step[:-1, :-1])[0]
    return gain
