"""State estimator: an extended Kalman filter on the identified joint, fed by the laser once in a period.

The estimate holds the joint's state x, its stop operators z (exact in a step), the
voltages of both converters, which lag behind their commands, and a moment d on the slope that stands for everything
that the model does not know (external forces, friction of another kind, a drifting barrier). The voltages act as such
a moment, so that they can balance it. d changes as a random walk, so that the estimate of q has no steady error.

Corrected are displacement, slope, their rates, interior shape and d; their covariance P moves with the Jacobian at the
estimate, because about the saddle a beam's slope may be unstable at a given displacement, and then the sign of the
correction changes. Maxwell strains and creep follow from the motion alone: their own dynamics forget every error.

Python here is of the subset that `pipeline.export` translates: the C controller holds these functions.
"""

import math
from typing import NamedTuple

import numpy as np

from pipeline.compiled import compiled
from pipeline.control.joint_kernels import STATES, advance_stops, body_rates, inertias
from pipeline.joint.condensed_statics import rest_state
from pipeline.numerics.arrays import FloatArray

PERIOD = 1e-3
"""Of the controller [s]."""
CORRECTED = 5
"""Leading states that readings correct: q, q̇, τ, τ̇, β."""
FILTER = CORRECTED + 1
"""Numbers of the filter: these and d."""
READING = 3e-6
"""Standard deviation [m] of a reading: noise, resolution, and the laser's linearity as it changes with the motion."""
SHAKE = 1e-3
"""Standard deviation [N·√s] of a white force on q."""
TWIST = 2e-4
"""Standard deviation [N·m·√s] of the unknown moment's white part."""
WALK = 2e-3
"""Standard deviation [N·m/√s] of its random walk."""
LARGEST = 1e-3
"""Innovation [m] above which a reading counts as much as this."""


class Observer(NamedTuple):
    """Constants of the estimator.

    Attributes
    ----------
    k, p, basis, weights : FloatArray
        Constants of the joint, prepared constants, RBF basis and weights (`pipeline.joint.condensed_kernels`).
    gain, offset : float
        Of the laser: reading = gain × q + offset [m].
    wall : float
        Displacement [m] that no motion passes.
    kept : FloatArray, shape (2,)
        Share of a converter's voltage that is left after a period, and its mean over the period, under a command 0.
    noise : FloatArray, shape (4,)
        `READING`, `SHAKE`, `TWIST`, `WALK`.
    certain : FloatArray, shape (FILTER,)
        Variances of the filter's numbers after a long rest.
    steps, bounds : FloatArray, shape (FILTER,)
        Steps of the differences, and magnitudes that no estimate passes.
    """

    k: FloatArray
    p: FloatArray
    basis: FloatArray
    weights: FloatArray
    gain: float
    offset: float
    wall: float
    kept: FloatArray
    noise: FloatArray
    certain: FloatArray
    steps: FloatArray
    bounds: FloatArray


@compiled
def estimate_from_rest(reading: float, c: Observer, x: FloatArray, z: FloatArray, d: FloatArray) -> None:
    """Fill the estimate as after a long rest at a reading [m]: friction holds what is left of the force."""
    none = np.zeros(2)
    rest, stops = rest_state((reading - c.offset) / c.gain, none, c.k, c.p, c.basis, c.weights)
    x[:] = rest
    z[:] = stops
    d[0] = 0.0


@compiled
def estimated_rates(
    x: FloatArray, u1: float, u2: float, moment: float, z: FloatArray, start: FloatArray, c: Observer, dx: FloatArray
) -> None:
    """Rates of the state under squared voltages [V²] and a moment [N·m] on the slope, shape (STATES,)."""
    body_rates(x, u1, u2, z, start, c.p, c.basis, c.weights, dx)
    mass, cross, inertia = inertias(x, c.p)
    scale = moment / (mass * inertia - cross * cross)
    dx[1] -= cross * scale
    dx[3] += mass * scale


@compiled
def predict(x: FloatArray, z: FloatArray, d: FloatArray, volts: FloatArray, v: FloatArray, c: Observer) -> None:
    """Move the estimate over one period under the commands `v`, shape (2,) [V], by one classical Runge-Kutta step."""
    begin, y, total = x.copy(), x.copy(), np.zeros(STATES)
    dx, u = np.zeros(STATES), np.zeros(2)
    for side in range(2):
        mean = v[side] + (volts[side] - v[side]) * c.kept[1]
        u[side] = mean * mean
        volts[side] = v[side] + (volts[side] - v[side]) * c.kept[0]
    for stage in range(4):
        estimated_rates(y, u[0], u[1], d[0], z, begin, c, dx)
        share = 2.0 if stage == 1 or stage == 2 else 1.0
        ahead = PERIOD if stage == 2 else 0.5 * PERIOD
        for i in range(STATES):
            total[i] += share * dx[i]
            y[i] = begin[i] + ahead * dx[i]
    for i in range(STATES):
        x[i] = begin[i] + PERIOD / 6.0 * total[i]
    if abs(x[0]) > c.wall:
        x[0] = c.wall if x[0] > 0.0 else -c.wall
        x[1] = 0.0
    advance_stops(z, begin, x, c.k)


@compiled
def spread_out(x: FloatArray, z: FloatArray, d: FloatArray, u1: float, u2: float, c: Observer, p: FloatArray) -> None:
    """Move the covariance `p`, shape (FILTER, FILTER), over one period from the state `x` on."""
    a, step, y = np.zeros((FILTER, FILTER)), np.zeros((FILTER, FILTER)), x.copy()
    rates, dx = np.zeros(STATES), np.zeros(STATES)
    estimated_rates(x, u1, u2, d[0], z, x, c, rates)
    for j in range(CORRECTED):
        y[j] = x[j] + c.steps[j]
        estimated_rates(y, u1, u2, d[0], z, x, c, dx)
        y[j] = x[j]
        for i in range(CORRECTED):
            a[i, j] = PERIOD * (dx[i] - rates[i]) / c.steps[j]
    mass, cross, inertia = inertias(x, c.p)
    determinant = mass * inertia - cross * cross
    shake, twist, walk = c.noise[1] * c.noise[1], c.noise[2] * c.noise[2], c.noise[3] * c.noise[3]
    push_q, push_tau = inertia / determinant, -cross / determinant
    twist_q, twist_tau = -cross / determinant, mass / determinant
    a[1, CORRECTED] = PERIOD * twist_q
    a[3, CORRECTED] = PERIOD * twist_tau
    for i in range(FILTER):  # exp(a) to the third order: 1 + a (1 + a/2 (1 + a/3))
        for j in range(FILTER):
            step[i, j] = a[i, j] / 3.0
    for order in range(2):
        share = 0.5 if order == 0 else 1.0
        _after_one(a, share, step)
    for i in range(FILTER):
        step[i, i] += 1.0
    _turned(step, p)
    p[1, 1] += PERIOD * (shake * push_q * push_q + twist * twist_q * twist_q)
    mixed = PERIOD * (shake * push_q * push_tau + twist * twist_q * twist_tau)
    p[1, 3] += mixed
    p[3, 1] += mixed
    p[3, 3] += PERIOD * (shake * push_tau * push_tau + twist * twist_tau * twist_tau)
    p[CORRECTED, CORRECTED] += PERIOD * walk


@compiled
def _after_one(a: FloatArray, share: float, step: FloatArray) -> None:
    """Replace `step` by share × a (1 + step), shapes (FILTER, FILTER)."""
    product = np.zeros((FILTER, FILTER))
    for i in range(FILTER):
        for j in range(FILTER):
            total = a[i, j]
            for n in range(FILTER):
                total += a[i, n] * step[n, j]
            product[i, j] = share * total
    for i in range(FILTER):
        for j in range(FILTER):
            step[i, j] = product[i, j]


@compiled
def _turned(step: FloatArray, p: FloatArray) -> None:
    """Replace `p` by step p stepᵀ, shapes (FILTER, FILTER), symmetric to the last bit."""
    half = np.zeros((FILTER, FILTER))
    for i in range(FILTER):
        for j in range(FILTER):
            total = 0.0
            for n in range(FILTER):
                total += step[i, n] * p[n, j]
            half[i, j] = total
    for i in range(FILTER):
        for j in range(i + 1):
            total = 0.0
            for n in range(FILTER):
                total += half[i, n] * step[j, n]
            p[i, j] = total
            p[j, i] = total


@compiled
def correct(x: FloatArray, z: FloatArray, d: FloatArray, p: FloatArray, reading: float, c: Observer) -> None:
    """Correct estimate and covariance by a reading [m] at the same time."""
    miss = (reading - c.offset) / c.gain - x[0]
    miss = min(LARGEST, max(-LARGEST, miss))
    begin, column = x.copy(), np.zeros(FILTER)
    total = p[0, 0] + c.noise[0] * c.noise[0]
    for i in range(FILTER):
        column[i] = p[i, 0]
    for i in range(CORRECTED):
        x[i] = min(c.bounds[i], max(-c.bounds[i], x[i] + miss * column[i] / total))
    d[0] = min(c.bounds[CORRECTED], max(-c.bounds[CORRECTED], d[0] + miss * column[CORRECTED] / total))
    for i in range(FILTER):
        for j in range(FILTER):
            p[i, j] -= column[i] * column[j] / total
    advance_stops(z, begin, x, c.k)


def converter_shares(lag: float) -> FloatArray:
    """`Observer.kept` of converters with the time constant `lag` [s]."""
    if lag <= 0.0:
        return np.zeros(2)
    left = math.exp(-PERIOD / lag)
    return np.array([left, (1.0 - left) * lag / PERIOD])


def make_observer(
    k: FloatArray,
    p: FloatArray,
    basis: FloatArray,
    weights: FloatArray,
    gain: float,
    offset: float,
    wall: float,
    lag: float,
) -> Observer:
    """The estimator of a joint whose converters have the time constant `lag` [s]."""
    return Observer(
        k, p, basis, weights, gain, offset, wall, converter_shares(lag),
        noise=np.array([READING, SHAKE, TWIST, WALK]),
        certain=np.array([1e-11, 1e-6, 1e-5, 1e-3, 1e-4, 1e-8]),
        steps=np.array([1e-7, 1e-5, 1e-6, 1e-4, 1e-6, 1.0]),
        bounds=np.array([wall, 4.0, 0.8, 60.0, 3.0, 0.01]),
    )  # fmt: skip
