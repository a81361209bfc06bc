"""Braking curves: the largest speeds from which full braking still stops at a target, by simulation of the model."""

import numpy as np

from pipeline.compiled import compiled
from pipeline.control.controller import move
from pipeline.control.law import CONTROLLER_STATE, PLACES, REACHES, Law
from pipeline.control.linear import LinearModel
from pipeline.generated.condensed_joint import STATES
from pipeline.numerics.arrays import FloatArray

REACH = 1e-3
"""Distance [m] between entries of a braking curve."""
RESERVE = 0.65
"""Share of the largest moment with which the braking curves brake; the rest is left to the feedback."""


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
