"""The feedback law: push, brake on a curve that was simulated beforehand, then a linear-quadratic regulator.

Two membranes that only attract act as one moment of either sign on the beam's slope: one side at a time, its squared
voltage as large as the moment needs. With the target at q* and the distance s = q* − q

* far from the target the joint is pushed towards it, until its speed reaches the braking curve: the largest speed at
  the distance from which full braking still stops at the target. On the curve the moment is proportional to the
  speed's error (a proximate time-optimal servomechanism; M. L. Workman, dissertation, Stanford 1987);
* where the largest voltage does not suffice to push the joint over its barrier (`Law.pumped`), it is pushed towards the
  barrier and away from it in turn, along its own velocity: every half swing then adds energy;
* near the target a linear-quadratic regulator with the whole estimated state, with the equilibrium and gains of the
  target, holds it, at an unstable equilibrium too. What the estimator calls an unknown moment is balanced.

Python here is of the subset that `pipeline.export` translates.
"""

import math
from typing import NamedTuple

import numpy as np

from pipeline.compiled import compiled
from pipeline.control.observer import FILTER, Observer, correct, estimate_from_rest, predict, spread_out
from pipeline.generated.condensed_joint import STATES, STOPS
from pipeline.numerics.arrays import FloatArray

# The controller's state, all numbers in one array.
_Z = STATES
_VOLTS = STATES + STOPS
_FORCE = _VOLTS + 2
_LOST = _FORCE + 1
_TARGET = _LOST + 1
_NEAR = _TARGET + 1
_PHASE = _NEAR + 1
_DWELL = _PHASE + 1
_SPREAD = _DWELL + 1
CONTROLLER_STATE = _SPREAD + FILTER * FILTER
"""Length of the controller's state: x, z, voltages, unknown moment, periods without a reading, target, regulating,
phase and time of the pump, the filter's covariance."""

RAMP = 40.0
"""Periods in which the voltages of a controller without readings go to zero."""
STILL = 5e-3
"""Speed [m/s] below which a joint that is pumped has come to the end of its swing."""
DWELL = 80.0
"""Periods that a push of the pump lasts at least, so that it gets the joint moving."""
FEEDBACK = STATES + 1
"""Numbers of which the regulator makes a force: the deviation of x, and that of the force that acts."""


class Law(NamedTuple):
    """Constants of the law; displacements are the joint's own, not the laser's.

    Attributes
    ----------
    observer : Observer
        The estimator's constants.
    highest : float
        Largest voltage [V].
    first, step : float
        First target and distance of the targets [m] of the tables.
    rests : FloatArray, shape (T, STATES)
        Equilibria at these targets.
    holding : FloatArray, shape (T,)
        Moments [N·m] that hold them.
    gains : FloatArray, shape (T, FEEDBACK)
        Of the regulator [N·m per unit of state].
    moments : FloatArray, shape (2, T)
        Moment of each side at the largest voltage [N·m], positive in its own direction.
    reach : float
        Distance between the entries of the braking curves [m].
    braking : FloatArray, shape (2 T, R)
        Largest speed [m/s] at distances from a target when it comes from the left (rows 0 to T − 1), from the right.
    steepness : float
        Share of the largest moment for each m/s off the braking curve [s/m].
    saddle : float
        Displacement [m] of the unstable equilibrium.
    pumped : FloatArray, shape (2,)
        1 where the largest voltage does not push the joint from the left, from the right over its barrier.
    near, fast : float
        Distance [m] and speed [m/s] within which the regulator takes over; it lets go at twice that distance.
    farthest : float
        Readings [m] beyond this are none.
    """

    observer: Observer
    highest: float
    first: float
    step: float
    rests: FloatArray
    holding: FloatArray
    gains: FloatArray
    moments: FloatArray
    reach: float
    braking: FloatArray
    steepness: float
    saddle: float
    pumped: FloatArray
    near: float
    fast: float
    farthest: float


@compiled
def table_row(place: float, count: int) -> int:
    """Lower row of two between which `place`, counted in rows, lies; the first or the last two outside."""
    lower = 0
    for i in range(1, count - 1):
        if place >= i:
            lower = i
    return lower


@compiled
def table_share(place: float, lower: int, count: int) -> float:
    """Share of the upper of both rows; a table is held beyond its ends."""
    share: float = min(count - 1.0, max(0.0, place)) - lower
    return share


@compiled
def begin_control(reading: float, c: Law, s: FloatArray) -> None:
    """Fill the controller's state, shape (CONTROLLER_STATE,), from the first reading [m], all voltages being zero."""
    x, z, d = np.zeros(STATES), np.zeros(STOPS), np.zeros(1)
    q = 0.0
    if math.isfinite(reading):
        q = min(c.farthest, max(-c.farthest, reading))
    estimate_from_rest(q, c.observer, x, z, d)
    for i in range(STATES):
        s[i] = x[i]
    for i in range(STOPS):
        s[_Z + i] = z[i]
    for i in range(_VOLTS, CONTROLLER_STATE):
        s[i] = 0.0
    s[_TARGET] = x[0]
    s[_PHASE] = 1.0
    for i in range(FILTER):
        s[_SPREAD + i * FILTER + i] = c.observer.certain[i]


@compiled
def largest_moments(q: float, c: Law) -> tuple[float, float]:
    """Moments [N·m] of left and right at the largest voltage, each in its own direction, at q [m]."""
    place = (q - c.first) / c.step
    lower = table_row(place, c.rests.shape[0])
    share = table_share(place, lower, c.rests.shape[0])
    left = (1.0 - share) * c.moments[0, lower] + share * c.moments[0, lower + 1]
    right = (1.0 - share) * c.moments[1, lower] + share * c.moments[1, lower + 1]
    return left, right


@compiled
def braking_speed(target: float, distance: float, from_left: bool, c: Law) -> float:
    """Largest speed [m/s] at a distance [m] from a target from which it is still reached without overshoot."""
    count = c.rests.shape[0]
    place, reach = (target - c.first) / c.step, distance / c.reach
    lower = table_row(place, count)
    share = table_share(place, lower, count)
    part = table_row(reach, c.braking.shape[1])
    more = table_share(reach, part, c.braking.shape[1])
    row = lower
    if not from_left:
        row = lower + count
    one = (1.0 - more) * c.braking[row, part] + more * c.braking[row, part + 1]
    other = (1.0 - more) * c.braking[row + 1, part] + more * c.braking[row + 1, part + 1]
    speed: float = (1.0 - share) * one + share * other
    return speed


@compiled
def regulated(x: FloatArray, acting: float, d: float, target: float, c: Law) -> float:
    """Moment [N·m] of the linear-quadratic regulator at a target [m]."""
    place = (target - c.first) / c.step
    lower = table_row(place, c.rests.shape[0])
    share = table_share(place, lower, c.rests.shape[0])
    hold = (1.0 - share) * c.holding[lower] + share * c.holding[lower + 1]
    moment = hold - d
    for i in range(STATES):
        rest = (1.0 - share) * c.rests[lower, i] + share * c.rests[lower + 1, i]
        gain = (1.0 - share) * c.gains[lower, i] + share * c.gains[lower + 1, i]
        moment -= gain * (x[i] - rest)
    gain = (1.0 - share) * c.gains[lower, STATES] + share * c.gains[lower + 1, STATES]
    result: float = moment - gain * (acting - hold + d)
    return result


@compiled
def far_effort(x: FloatArray, target: float, c: Law, s: FloatArray) -> float:
    """Share of the largest moment far from the target, −1 to 1: push, pump or brake; keeps the pump's phase in `s`."""
    q, speed = x[0], x[1]
    towards = 1.0 if target > q else -1.0
    effort = c.steepness * (braking_speed(target, abs(target - q), target > q, c) - towards * speed) * towards
    pumped = c.pumped[0] > 0.5
    if target < q:
        pumped = c.pumped[1] > 0.5
    if pumped and (c.saddle - q) * towards > 0.0 and (target - c.saddle) * towards > 0.0:
        s[_DWELL] += 1.0
        if s[_DWELL] > DWELL and speed * towards * s[_PHASE] < STILL:
            s[_PHASE] = -s[_PHASE]
            s[_DWELL] = 0.0
        effort = s[_PHASE] * towards
    else:
        s[_PHASE] = 1.0
        s[_DWELL] = 0.0
    limited: float = min(1.0, max(-1.0, effort))
    return limited


@compiled
def control(s: FloatArray, reading: float, target: float, c: Law, v: FloatArray) -> None:
    """One period: correct the estimate, fill the voltages `v`, shape (2,) [V], predict; `s` is the controller's state.

    Whatever reading and target are, the voltages lie within 0 … `Law.highest`; without a reading they go to zero in
    `RAMP` periods, and the estimate begins anew when readings come back.
    """
    x, z, d, volts = np.zeros(STATES), np.zeros(STOPS), np.zeros(1), np.zeros(2)
    p = np.zeros((FILTER, FILTER))
    seen = math.isfinite(reading) and abs(reading) < c.farthest
    if seen and s[_LOST] >= RAMP:
        begin_control(reading, c, s)
    for i in range(STATES):
        x[i] = s[i]
    for i in range(STOPS):
        z[i] = s[_Z + i]
    d[0] = s[_FORCE]
    volts[0] = s[_VOLTS]
    volts[1] = s[_VOLTS + 1]
    for i in range(FILTER):
        for j in range(FILTER):
            p[i, j] = s[_SPREAD + i * FILTER + j]
    share = 1.0
    if seen:
        s[_LOST] = 0.0
        correct(x, z, d, p, reading, c.observer)
    else:
        s[_LOST] = min(RAMP, s[_LOST] + 1.0)
        share = 1.0 - s[_LOST] / RAMP
    if math.isfinite(target):
        place = (target - c.observer.offset) / c.observer.gain
        s[_TARGET] = min(c.first + (c.rests.shape[0] - 1) * c.step, max(c.first, place))
    away = abs(s[_TARGET] - x[0])
    if away < c.near and abs(x[1]) < c.fast:
        s[_NEAR] = 1.0
    if away > 2.0 * c.near:
        s[_NEAR] = 0.0
    left, right = largest_moments(x[0], c)
    effort = 0.0
    if s[_NEAR] > 0.5:
        squared = c.highest * c.highest
        acting = (left * volts[0] * volts[0] - right * volts[1] * volts[1]) / squared
        moment = regulated(x, acting, d[0], s[_TARGET], c)
        effort = moment / left
        if moment < 0.0:
            effort = moment / right
    else:
        effort = far_effort(x, s[_TARGET], c, s)
    v[0] = share * c.highest * math.sqrt(min(1.0, max(0.0, effort)))
    v[1] = share * c.highest * math.sqrt(min(1.0, max(0.0, -effort)))
    u1, u2 = volts[0] * volts[0], volts[1] * volts[1]
    before, held = x.copy(), z.copy()
    predict(x, z, d, volts, v, c.observer)
    u1, u2 = 0.5 * (u1 + volts[0] * volts[0]), 0.5 * (u2 + volts[1] * volts[1])
    spread_out(before, held, d, u1, u2, c.observer, p)
    sound = math.isfinite(d[0])
    for i in range(FILTER):
        for j in range(FILTER):
            sound = sound and math.isfinite(p[i, j])
            s[_SPREAD + i * FILTER + j] = p[i, j]
    for i in range(STATES):
        sound = sound and math.isfinite(x[i])
        s[i] = x[i]
    for i in range(STOPS):
        s[_Z + i] = z[i]
    s[_FORCE] = d[0]
    s[_VOLTS] = volts[0]
    s[_VOLTS + 1] = volts[1]
    if not sound:
        begin_control(0.0, c, s)
        s[_LOST] = RAMP
        v[0] = 0.0
        v[1] = 0.0
