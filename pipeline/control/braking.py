"""Simulated motions of the model for the controller's design: a snap, and braking curves.

A braking curve holds the largest speeds from which full braking still stops at a target.
"""

import numpy as np

from ..generated.condensed_joint import STATES
from ..numerics.arrays import FloatArray
from ..numerics.compiled import compiled
from .controller import move
from .feedback import RESERVE
from .law import CONTROLLER_STATE, CORRECTED, NUMBERS, PLACES, REACHES, Law
from .plant import LinearModel

LONGEST = 600
"""Periods of a motion of the model, at most."""
EVERY = 2
"""Periods from one braked instant to the next."""
SPEEDS = (1.0, 2.0)
"""Speeds, over the largest of a snap, with which motions begin that are braked."""
LEVELS = (1.0, 0.5)
"""Shares of the largest moment that push them."""
_SLEW = NUMBERS.index("slew")
_LEVER = NUMBERS.index("lever")


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
    half = 0.5 * (start[0] + end)
    s[:STATES] = start
    for _ in range(LONGEST):
        move(s, v * ((s[0] - half) * (end - half) < 0.0), law)
        largest = np.maximum(largest, np.abs(s[:CORRECTED]))
        if (s[0] - end) * (end - half) > 0.0:
            break
    return largest


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
            braked_from = _where_braked(motion, towards * (turns - place))
            if braked_from is None:
                continue
            stop = towards * braked(law, braked_from, push, brake, towards)
            stop[:, 0] = stop[-1, 0] - stop[:, 0]
            if stop[0, 0] > reaches[1]:
                begins[i] = np.vstack([begins[i], stop[:1]])
                if len(lasts[i]) == 1 and len(stop) > 2 * settles:
                    lasts[i] = np.vstack([lasts[i], stop[settles:-1]])
    first = np.array([_curve(points, reaches) for points in begins])
    later = [_curve(points, reaches) if len(points) > 1 else curve for points, curve in zip(lasts, first, strict=True)]
    return first, np.maximum(first, later)


def _where_braked(motion: FloatArray, beyond: FloatArray) -> FloatArray | None:
    """State of a motion from which a brake stops at a place, on lines between the states; None if none does.

    Parameters
    ----------
    motion : FloatArray, shape (N, CONTROLLER_STATE)
        The motion.
    beyond : FloatArray, shape (N,)
        Distance [m] behind the place at which a brake from each state stops.
    """
    cross = np.flatnonzero((beyond[1:] > 0.0) & (beyond[:-1] <= 0.0))
    if not cross.size:
        return None
    row = int(cross[0])
    share = -beyond[row] / (beyond[row + 1] - beyond[row])
    return np.asarray((1.0 - share) * motion[row] + share * motion[row + 1])


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
        motion[i] = s
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
