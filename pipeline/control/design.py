"""Design of the controller on the identified joint: equilibria, regulator gains and braking curves as tables."""

import math
from dataclasses import dataclass

import numpy as np
from scipy.linalg import expm, solve_discrete_are

from pipeline.codegen.numba_writer import kernel
from pipeline.compiled import compiled
from pipeline.control.controller import PERIOD, move
from pipeline.control.law import CONTROLLER_STATE, FEEDBACK, NUMBERS, PLACES, REACHES, RESTS, TARGETS, Law
from pipeline.control.linear import LinearModel, equilibria, held, jacobian
from pipeline.control.plant import Plant, inertias, still
from pipeline.errors import InputError
from pipeline.generated.condensed_joint import STATES, STOPS
from pipeline.generated.condensed_joint_jacobian import PREPARE
from pipeline.joint.condensed_kernels import INDEX
from pipeline.joint.condensed_statics import rest_state
from pipeline.joint.correction_table import CURVES, table_span, tabulate
from pipeline.numerics.arrays import FloatArray

BEYOND = 1.5e-3
"""How far beyond the wells targets may lie [m]."""
REACH = 1e-3
"""Distance [m] between entries of a braking curve."""
RESERVE = 0.65
"""Share of the largest moment with which the braking curves brake; the rest is left to the feedback."""
STABLE, UNSTABLE = (0.2e-3, 0.3, 1e6, 0.2), (0.14e-3, 10.0, 5.0, 10.0)
"""Displacement [m], speed [m/s], rate of the slope [1/s] and share of the largest moment that weigh alike in the
regulator of a stable target and of an unstable one."""
COMMON = (0.05, 0.9)
"""Least and largest mean share of the largest squared voltage on both sides at an unstable target."""
SLOW = 15.0
"""Unstable pole [1/s] up to which both sides are charged: a quarter of the slowest zero in the right half plane."""
NEAR, FAST = 1.5e-3, 0.12
"""Distance [m] and speed [m/s] within which the regulator takes over; it lets go at twice that distance."""
STEEPNESS = 1.0 / 0.04
"""Share of the largest moment for each m/s off the braking curve [s/m]."""
SURE = 0.92
"""Share of the largest voltage with which the joint must pass its barrier slowly; else it is pumped."""
READING = 3e-6
"""Standard deviation [m] of a reading: noise, resolution, and the laser's linearity as it changes with the motion."""
SHAKE = 1e-3
"""Standard deviation [N·√s] of a white force on q."""
TWIST = 5e-4
"""Standard deviation [N·m·√s] of the unknown moment's white part."""
WALK = 2.5e-4
"""Standard deviation [N·m/√s] of its random walk."""
CALM = (1.7e-6, 3.4e-7, 4.5e-6)
"""The same three near an unstable target: a slow estimate, because a model's fast swing of the slope may be wrong."""
CERTAIN = (1e-11, 1e-6, 1e-5, 1e-3, 1e-4, 1e-8)
"""Variances of the filter's numbers after a long rest."""
BOUNDS = (4.0, 0.8, 60.0, 3.0, 0.01)
"""Magnitudes that no estimate of q̇ [m/s], τ, τ̇ [1/s], β and d [N·m] passes."""
NODES = 2
"""Of the table of the corrections in a width σ."""


@dataclass(frozen=True)
class Settings:
    """What a user may choose.

    Attributes
    ----------
    highest : float
        Largest voltage [V].
    lag : float
        Time constant of the converters [s].
    """

    highest: float
    lag: float = 4e-3


def design(plant: Plant, settings: Settings) -> Law:
    """The controller of a plant.

    Raises
    ------
    InputError
        The joint is not bistable, or the voltage limit is no voltage of the trained range.

    Notes
    -----
    Cost: 0.5 s.
    """
    if not 0.0 < settings.highest <= plant.highest * (1.0 + 1e-9):
        raise InputError(
            f"a largest voltage of {settings.highest:g} V lies outside the trained range 0 to {plant.highest:.0f} V"
        )
    wells = three(plant)
    left, saddle, right = (float(each.x[0]) for each in wells)
    places = np.linspace(left - BEYOND, right + BEYOND, TARGETS)
    path = [held_at(plant, float(q), wells[1].x) for q in places]
    slow = [slow_switching_voltage(path, wells, side) > SURE * settings.highest for side in (0, 1)]
    common = np.zeros(TARGETS)
    for i, (x, _) in enumerate(path):
        path[i], common[i] = charged(plant, x, path[i][1], settings.highest)
    per_square = np.array([moments_per_square(plant, x, u) for x, u in path])
    holding = np.array([m @ (u * (1.0, -1.0)) for m, (_, u) in zip(per_square, path, strict=True)])
    gains = [
        regulator(plant, x, u, settings, UNSTABLE if c else STABLE) for (x, u), c in zip(path, common, strict=True)
    ]
    body = body_law(plant, acting_lag(plant, settings))
    numbers = dict(zip(NUMBERS, body.numbers.tolist(), strict=True)) | {
        "highest": settings.highest, "first": places[0], "per_step": 1.0 / (places[1] - places[0]),
        "per_reach": 1.0 / REACH, "steepness": STEEPNESS, "saddle": saddle,
        "pumped_right": float(slow[0]), "pumped_left": float(slow[1]), "near": NEAR, "fast": FAST,
    }  # fmt: skip
    braking = [braking_curves(body, wells, plant.constants.k[0], places, side, settings.highest) for side in (0, 1)]
    return body._replace(
        numbers=np.array([numbers[name] for name in NUMBERS], dtype=np.float64),
        targets=np.column_stack([[x for x, _ in path], holding, gains, per_square * settings.highest**2, common]),
        braking=np.concatenate(braking),
    )


def body_law(plant: Plant, lag: float) -> Law:
    """What estimator and motion need of a plant whose converters have the time constant `lag` [s], without tables."""
    k, p, basis, weights = plant.constants
    farthest, kept = 0.9 * plant.wall, math.exp(-PERIOD / lag)
    grid = np.linspace(-farthest, farthest, RESTS)
    rests = []
    for q in grid:
        x, z = rest_state(q, np.zeros(2), k, p, basis, weights)
        rests.append((x[2], x[4], z[0]))
    centres = weights.shape[1]
    first, per_metre = table_span(basis, centres, NODES)
    curves = tabulate(basis, weights[None], NODES)[0, :, :, :CURVES] if centres else np.zeros((1, 6, CURVES))
    numbers = {
        "gain": plant.gain, "offset": plant.offset, "wall": plant.wall, "farthest": farthest,
        "kept": kept, "kept_mean": (1.0 - kept) * lag / PERIOD,
        "reading_variance": READING**2, "shake": SHAKE**2, "twist": TWIST**2, "walk": WALK**2,
        **{f"calm_{name}": value**2 for name, value in zip(("shake", "twist", "walk"), CALM, strict=True)},
        **{f"certain_{i}": value for i, value in enumerate(CERTAIN)},
        **{f"bound_{i}": value for i, value in enumerate((plant.wall, *BOUNDS))},
        "arm": k[INDEX["friction_arm"]], **{f"travel_{i}": k[INDEX[f"stop_travel_{i}"]] for i in range(STOPS)},
        "curve_first": first, "curve_per_metre": per_metre, "curve_last": len(curves) - 1.0,
        "rest_per_metre": 1.0 / (grid[1] - grid[0]),
    }  # fmt: skip
    return Law(
        np.array([numbers.get(name, 0.0) for name in NUMBERS], dtype=np.float64),
        p, prepare_slopes(k), np.ascontiguousarray(curves), np.array(rests),
        np.zeros((TARGETS, 0)), np.zeros((2 * TARGETS, 0)),
    )  # fmt: skip


@compiled
def prepare_slopes(k: FloatArray) -> FloatArray:
    """Constants prepared for the Jacobian of a joint with the constants k."""
    found = np.empty(_SLOPES)
    _prepare_slopes((k, found))
    return found


_SLOPES = PREPARE.outputs["p"]
_prepare_slopes = kernel(PREPARE)


def acting_lag(plant: Plant, settings: Settings) -> float:
    """Time constant [s] from command to force: the converters' own, and the delay that the identification found."""
    return max(settings.lag + plant.delay, _LEAST_LAG)


_LEAST_LAG = 0.5e-3


def three(plant: Plant) -> list[LinearModel]:
    """Left well, unstable equilibrium between, right well, without voltage.

    Raises
    ------
    InputError
        The joint has not two wells with one unstable equilibrium between them.
    """
    found = equilibria(plant, np.zeros(2))
    stable = [each for each in found if each.stable]
    between = [each for each in found if not each.stable and len(stable) > 1 and stable[0].q < each.q < stable[-1].q]
    if len(stable) < 2 or not between:
        raise InputError("the identified joint has not two wells; there is nothing to switch between")
    middle = 0.5 * (stable[0].q + stable[-1].q)
    return [stable[0], min(between, key=lambda each: abs(each.q - middle)), stable[-1]]


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


def held_at(plant: Plant, q: float, saddle: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Equilibrium at q [m], shape (STATES,), and the squared voltages [V²] that hold it, shape (2,).

    Where the beam has several shapes at one displacement, the one that needs the least voltage.
    """
    c = plant.constants
    relaxed, _ = rest_state(q, np.zeros(2), c.k, c.p, c.basis, c.weights)
    best: tuple[FloatArray, FloatArray] | None = None
    for start in (relaxed, still(q, float(saddle[2]), float(saddle[4]))):
        for side in (0, 1):
            answer = held(plant, start, np.zeros(2), np.eye(2)[side])
            if answer is None or answer[1] < -_ROUNDING:
                continue
            u = max(answer[1], 0.0) * np.eye(2)[side]
            if best is None or u.sum() < best[1].sum():
                best = answer[0], u
    return (relaxed, np.zeros(2)) if best is None else best


_ROUNDING = 1e3  # V²


def charged(plant: Plant, x: FloatArray, u: FloatArray, highest: float) -> tuple[tuple[FloatArray, FloatArray], float]:
    """The equilibrium at the same place with both sides charged, if it is unstable; and the mean share of `highest`².

    The charge grows until the unstable pole is `SLOW`, or the difference of both sides needs the rest.
    """

    def growth(x: FloatArray, u: FloatArray) -> float:
        return float(np.linalg.eigvals(jacobian(x, u, plant.constants)[0]).real.max())

    if growth(x, u) < _UNSTABLE:
        return (x, u), 0.0
    found, share = (x, u), _LEAST_COMMON
    for common in np.geomspace(*COMMON, 13):
        answer = held(plant, x, common * highest**2 * np.ones(2), np.array([0.5, -0.5]))
        if answer is None:
            break
        x, difference = answer[0], answer[1] / highest**2
        if abs(difference) <= 2.0 * min(common, 1.0 - common):
            left = common + 0.5 * difference
            found, share = (x, highest**2 * np.array([left, left - difference])), float(common)
            if growth(*found) < SLOW:
                break
    return found, share


_UNSTABLE, _LEAST_COMMON = 0.5, 0.02  # 1/s, share


def regulator(
    plant: Plant, x: FloatArray, u: FloatArray, settings: Settings, weights: tuple[float, float, float, float]
) -> FloatArray:
    """Gains of the linear-quadratic regulator about an equilibrium under squared voltages, shape (FEEDBACK,).

    The moment that acts follows the commanded one with the converters' lag; it is the last state. Both sides act along
    the same direction but for a few percent; the mean of both stands for it.
    """
    a, b = jacobian(x, u, plant.constants)
    per_square = moments_per_square(plant, x, u)
    along = 0.5 * (b[:, 0] / per_square[0] - b[:, 1] / per_square[1])
    n, lag = STATES, acting_lag(plant, settings)
    whole = np.zeros((n + 2, n + 2))
    whole[:n, :n], whole[:n, n] = a, along
    whole[n, n], whole[n, n + 1] = -1.0 / lag, 1.0 / lag
    step = expm(PERIOD * whole)
    weight = np.full(FEEDBACK, 1e-9)
    off, speed, turning, moment = weights
    weight[0], weight[1], weight[3] = 1.0 / off**2, 1.0 / speed**2, 1.0 / turning**2
    effort = 1.0 / (moment * float(np.mean(per_square)) * settings.highest**2) ** 2
    drive = step[:-1, -1:]
    cost = solve_discrete_are(step[:-1, :-1], drive, np.diag(weight), np.array([[effort]]))
    gain: FloatArray = np.linalg.solve(effort + drive.T @ cost @ drive, drive.T @ cost @ step[:-1, :-1])[0]
    return gain


def braking_curves(
    body: Law, wells: list[LinearModel], length: float, places: FloatArray, side: int, highest: float
) -> FloatArray:
    """Largest speeds [m/s] from which full braking stops at each place, shape (len(places), REACHES).

    Found by simulation: motions towards the places, slow and fast ones, are braked at every instant; the instant at
    which one turns round at a place gives one point of that place's curve.
    """
    towards = 1.0 if side == 0 else -1.0
    start = wells[0 if side == 0 else 2].x
    brake = np.zeros(2)
    brake[1 - side] = highest * np.sqrt(RESERVE)
    points: list[list[tuple[float, float]]] = [[(0.0, 0.0)] for _ in places]
    for x0, speed, level in [
        *((start, speed, 1.0) for speed in (0.0, 0.1, 0.2, 0.35, 0.5, 0.75, 1.0, 1.4)),
        *((start, 0.0, level) for level in (0.25, 0.5, 0.75)),
        *((wells[1].x, speed, level) for speed in (0.02, 0.1, 0.2) for level in (0.0, 0.5, 1.0)),
    ]:
        push, s = np.zeros(2), np.zeros(CONTROLLER_STATE)
        push[side] = highest * np.sqrt(level)
        s[:STATES], s[PLACES["volts"]] = x0, push
        s[1], s[3] = towards * speed, towards * speed * 1.25 / length
        motion, turns = braked(body, s, push, brake, towards)
        for i, place in enumerate(places):
            beyond = towards * (turns - place)
            cross = np.flatnonzero((beyond[1:] > 0.0) & (beyond[:-1] <= 0.0))
            if cross.size:
                row = int(cross[0])
                share = -beyond[row] / (beyond[row + 1] - beyond[row])
                q, v = (1.0 - share) * motion[row] + share * motion[row + 1]
                if towards * (place - q) > 0.2e-3:
                    points[i].append((towards * (place - q), towards * v))
    reaches = np.linspace(0.0, REACH * (REACHES - 1), REACHES)
    return np.array([_curve(each, reaches) for each in points])


def _curve(points: list[tuple[float, float]], reaches: FloatArray) -> FloatArray:
    """Speeds at `reaches` [m] from points (distance, speed), on lines; beyond the last point as √distance."""
    distance, speed = np.array(sorted(points)).T
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
def braked(
    body: Law, s: FloatArray, push: FloatArray, brake: FloatArray, towards: float
) -> tuple[FloatArray, FloatArray]:
    """(q, q̇) of a motion under `push` [V] every 2 ms, and where it would turn round if braked there with `brake` [V].

    It ends when it turns round by itself; `s` is moved along.
    """
    motion, turns, count = np.empty((300, 2)), np.empty(300), 0
    for i in range(300):
        motion[i, 0], motion[i, 1] = s[0], s[1]
        end = s.copy()
        for _ in range(300):
            if towards * end[1] <= 0.0:
                break
            move(end, brake, body)
        turns[i] = end[0]
        count = i + 1
        for _ in range(2):
            move(s, push, body)
        if towards * s[1] <= 0.0:
            break
    return motion[:count], turns[:count]
