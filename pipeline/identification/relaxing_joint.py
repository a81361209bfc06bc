"""Equation of motion of the data-driven joint, its free run and exact forward sensitivities.

In the dimensionless displacement x (±1 spans the training data) and its velocity p, with u the inputs:

    ẋ  = p + 2λ e,                                   e = x_measured − x
    μ(x) (ṗ − λ² e) = F(x) − d(x) p − ½ μ'(x) p² − Σ_l h_l(x) w_l − Σ_j f_j s_j + Σ_k g_k(x) u_k
    ẇ_l = h_l(x) p − r_l w_l + Σ_k b_lk u_k
    ds_j = (dx − |dx| s_j)/δ_j

* `F, d, h_l, g_k` are weights times a common basis: 1, x, x², x³ and Gaussians. The Gaussians (and with them every
  curve but F) continue as constants outside [low, high], where F goes on as its cubic: the joint stays confined.
  For a turning arm sin q and cos q stand for x and x², the torque of any weight on it, and the cubic gets a wall
  past the data: such a torque falls beyond 90°, where a run that has left the data would not come back.
* `w_l` are relaxing elements that couple to the motion through a position-dependent lever h_l: a Maxwell branch
  whose strain is a function S_l(x), h_l = S_l', or an overdamped second coordinate (an S shape of the beam) after
  static condensation. The same lever stands in both equations, so the element cannot create energy; the constant
  b_lk is the reciprocal of a capacitance that changes linearly with the hidden coordinate.
* `s_j` are Dahl friction states (doi:10.21236/ada041920), the smooth stop operator: rate-independent, passive.
* μ = 1 + a (x − x₀)² is the inertia of a tip that moves on an arc, with its velocity-dependent term.
* λ > 0 ties the simulation to the measurement (an observer); λ = 0 is the free run.

Sensitivities are those of the discrete scheme itself, so Gauss-Newton sees the exact Jacobian of what it minimises.
"""

from typing import NamedTuple

import numpy as np

from pipeline.compiled import compiled
from pipeline.numerics.arrays import FloatArray, IntArray

POLYNOMIALS = 4
"""Basis functions 1, x, x², x³ before the Gaussians (1, sin q, cos q, x³ with a wall for a turning arm)."""

WALL = 0.1
"""How far past the data, in half ranges, the wall of a turning arm is as strong as the cubic is at their ends."""

FORCE, DAMPING, INPUT = 0, 1, 2
"""Rows of the curve weights: F, d, then g_1 … g_K, then h_1 … h_L."""

WEIGHT, RATE, COUPLING, SLIP_FORCE, SLIP_LENGTH, INERTIA, INERTIA_CENTRE, INPUT_SHAPE = range(8)
"""What a parameter is: the `kind` of `Directions`."""

ESCAPE = 5.0
"""|x| beyond which a run counts as diverged: two operating ranges past the data."""


class Coefficients(NamedTuple):
    """Everything in the equation of motion but the inputs.

    curves (2+K+L, 4+M) · rates (L,) [1/s] · coupling (L, K) · slip_force (D,), slip_length (D,) · inertia (2,) = a, x₀
    · centres (M,) · bend = 1/(2σ²) · low, high: ends of the Gaussians' range · arm (2,): the angle q [rad] of a
    turning arm is arm[0] + arm[1] x; zeros for another joint.
    """

    curves: FloatArray
    rates: FloatArray
    coupling: FloatArray
    slip_force: FloatArray
    slip_length: FloatArray
    inertia: FloatArray
    centres: FloatArray
    bend: float
    low: float
    high: float
    arm: FloatArray


class Directions(NamedTuple):
    """What the sensitivities are taken with respect to, P entries each.

    kind, first, second (P,) name the coefficient (curve row and basis column for `WEIGHT`, element and input for
    `COUPLING`, …); factor (P,) is the derivative of a curve weight, of the inertia or of the logarithm of a
    slip length with respect to the parameter. Rates and slip forces are taken by their logarithms.
    """

    kind: IntArray
    first: IntArray
    second: IntArray
    factor: FloatArray


def no_directions() -> Directions:
    """For a simulation without sensitivities."""
    none = np.empty(0, dtype=np.int64)
    return Directions(none, none, none, np.empty(0))


@compiled
def basis_at(x: float, c: Coefficients, values: FloatArray, slopes: FloatArray) -> None:
    """The basis and its derivative at x."""
    values[0], values[1], values[2], values[3] = 1.0, x, x * x, x * x * x
    slopes[0], slopes[1], slopes[2], slopes[3] = 0.0, 1.0, 2.0 * x, 3.0 * x * x
    if c.arm[1] != 0.0:
        q, past = c.arm[0] + c.arm[1] * x, (x - min(max(x, -1.0), 1.0)) / WALL
        values[1], values[2], values[3] = np.sin(q), np.cos(q), x * x * x + past * past * past
        slopes[1], slopes[2] = c.arm[1] * values[2], -c.arm[1] * values[1]
        slopes[3] = 3.0 * (x * x + past * past / WALL)
    inside = min(max(x, c.low), c.high)
    moving = 1.0 if inside == x else 0.0
    for i in range(len(c.centres)):
        distance = inside - c.centres[i]
        bell = np.exp(-c.bend * distance * distance)
        values[POLYNOMIALS + i] = bell
        slopes[POLYNOMIALS + i] = -2.0 * c.bend * distance * bell * moving


@compiled
def basis(x: FloatArray, c: Coefficients) -> FloatArray:
    """The basis at all x, shape (N, 4 + M)."""
    values, slopes = np.empty((len(x), c.curves.shape[1])), np.empty(c.curves.shape[1])
    for n in range(len(x)):
        basis_at(x[n], c, values[n], slopes)
    return values


@compiled
def _forcing(
    k: FloatArray,
    y: FloatArray,
    slip: FloatArray,
    u: FloatArray,
    du: FloatArray,
    node: int,
    basis: FloatArray,
    values: FloatArray,
    total: float,
    mu: float,
    c: Coefficients,
    along: Directions,
) -> None:
    """Add the explicit derivatives of the right side with respect to the parameters to the slopes `k`."""
    inputs, elements = u.shape[1], len(c.rates)
    arm, p, inverse = y[0] - c.inertia[1], y[1], 1.0 / mu
    for m in range(len(along.kind)):
        kind, i, j = along.kind[m], along.first[m], along.second[m]
        if kind == WEIGHT:
            bell = basis[j] * along.factor[m]
            if i == FORCE:
                k[1, m] += bell * inverse
            elif i == DAMPING:
                k[1, m] -= bell * p * inverse
            elif i < INPUT + inputs:
                k[1, m] += bell * u[node, i - INPUT] * inverse
            else:
                element = 2 + i - INPUT - inputs
                k[1, m] -= bell * y[element] * inverse
                k[element, m] += bell * p
        elif kind == RATE:
            k[2 + i, m] -= c.rates[i] * y[2 + i]
        elif kind == COUPLING:
            k[2 + i, m] += u[node, j]
        elif kind == SLIP_FORCE:
            k[1, m] -= c.slip_force[i] * slip[i] * inverse
        elif kind == INERTIA:
            k[1, m] -= along.factor[m] * (total * arm * arm * inverse + arm * p * p) * inverse
        elif kind == INERTIA_CENTRE:
            k[1, m] += c.inertia[0] * (2.0 * total * arm * inverse + p * p) * inverse
        elif kind == INPUT_SHAPE:
            for n in range(inputs):
                k[1, m] += values[INPUT + n] * du[i, node, n] * inverse
                for element in range(elements):
                    k[2 + element, m] += c.coupling[element, n] * du[i, node, n]


@compiled
def _slope(
    y: FloatArray,
    sensitivity: FloatArray,
    slip: FloatArray,
    slip_sensitivity: FloatArray,
    u: FloatArray,
    du: FloatArray,
    node: int,
    error: float,
    gain: float,
    c: Coefficients,
    along: Directions,
    work: FloatArray,
    slope: FloatArray,
    k: FloatArray,
) -> float:
    """Right side and its derivative along the sensitivities; returns the acceleration without the observer."""
    inputs, elements, parameters = u.shape[1], len(c.rates), k.shape[1]
    basis, basis_slope, values, slopes = work[0], work[1], work[2], work[3]
    x, p = y[0], y[1]
    basis_at(x, c, basis, basis_slope)
    for i in range(c.curves.shape[0]):
        value = change = 0.0
        for j in range(c.curves.shape[1]):
            value += c.curves[i, j] * basis[j]
            change += c.curves[i, j] * basis_slope[j]
        values[i], slopes[i] = value, change
    arm = x - c.inertia[1]
    mu, mu_slope = 1.0 + c.inertia[0] * arm * arm, 2.0 * c.inertia[0] * arm
    total = values[FORCE] - values[DAMPING] * p - 0.5 * mu_slope * p * p
    by_x = slopes[FORCE] - slopes[DAMPING] * p - c.inertia[0] * p * p
    for n in range(inputs):
        total += values[INPUT + n] * u[node, n]
        by_x += slopes[INPUT + n] * u[node, n]
    for n in range(elements):
        total -= values[INPUT + inputs + n] * y[2 + n]
        by_x -= slopes[INPUT + inputs + n] * y[2 + n]
    for n in range(len(slip)):
        total -= c.slip_force[n] * slip[n]
    slope[0] = p + 2.0 * gain * error
    slope[1] = total / mu + gain * gain * error
    by_x = by_x / mu - total * mu_slope / (mu * mu) - gain * gain
    by_p = -(values[DAMPING] + mu_slope * p) / mu
    for m in range(parameters):
        k[0, m] = sensitivity[1, m] - 2.0 * gain * sensitivity[0, m]
        k[1, m] = by_x * sensitivity[0, m] + by_p * sensitivity[1, m]
    for n in range(len(slip)):
        by_slip = -c.slip_force[n] / mu
        for m in range(parameters):
            k[1, m] += by_slip * slip_sensitivity[n, m]
    for n in range(elements):
        lever, bend, row = values[INPUT + inputs + n], slopes[INPUT + inputs + n] * p, 2 + n
        slope[row] = lever * p - c.rates[n] * y[row]
        for i in range(inputs):
            slope[row] += c.coupling[n, i] * u[node, i]
        for m in range(parameters):
            k[1, m] -= lever / mu * sensitivity[row, m]
            k[row, m] = bend * sensitivity[0, m] + lever * sensitivity[1, m] - c.rates[n] * sensitivity[row, m]
    _forcing(k, y, slip, u, du, node, basis, values, total, mu, c, along)
    acceleration: float = total / mu
    return acceleration


@compiled
def _slide(
    slip: FloatArray,
    sensitivity: FloatArray,
    travel: float,
    travel_sensitivity: FloatArray,
    c: Coefficients,
    along: Directions,
    new_slip: FloatArray,
    new_sensitivity: FloatArray,
) -> None:
    """Dahl states after a monotonous `travel`, exactly: s → ±1 exponentially in the distance."""
    for n in range(len(slip)):
        side = 1.0 if travel >= 0.0 else -1.0
        decay = np.exp(-abs(travel) / c.slip_length[n])
        gap = (slip[n] - side) * decay
        for m in range(sensitivity.shape[1]):
            new_sensitivity[n, m] = sensitivity[n, m] * decay - gap * side * travel_sensitivity[m] / c.slip_length[n]
            if along.kind[m] == SLIP_LENGTH and along.first[m] == n:
                new_sensitivity[n, m] += along.factor[m] * gap * abs(travel) / c.slip_length[n]
        new_slip[n] = side + gap


@compiled
def _advance(
    y: FloatArray, s: FloatArray, by: float, slope: FloatArray, k: FloatArray, new_y: FloatArray, new_s: FloatArray
) -> None:
    """State and sensitivities moved along their slopes, without temporary arrays."""
    for i in range(len(y)):
        new_y[i] = y[i] + by * slope[i]
        for m in range(s.shape[1]):
            new_s[i, m] = s[i, m] + by * k[i, m]


@compiled
def _clear(y: FloatArray, s: FloatArray) -> None:
    y[:] = 0.0
    s[:] = 0.0


@compiled
def _rest(y: FloatArray, sensitivity: FloatArray, u: FloatArray, c: Coefficients, along: Directions) -> None:
    """Relaxing elements at rest under constant inputs: w = Σ b u / r."""
    for n in range(len(c.rates)):
        for i in range(len(u)):
            y[2 + n] += c.coupling[n, i] * u[i] / c.rates[n]
    for m in range(len(along.kind)):
        row = 2 + along.first[m]
        if along.kind[m] == RATE:
            sensitivity[row, m] = -y[row]
        elif along.kind[m] == COUPLING:
            sensitivity[row, m] = u[along.second[m]] / c.rates[along.first[m]]


@compiled
def observed_run(
    u: FloatArray,
    du: FloatArray,
    measured: FloatArray,
    observe: FloatArray,
    gain: float,
    start: tuple[float, float],
    interval: float,
    steps: int,
    c: Coefficients,
    along: Directions,
    rested: FloatArray,
    held: bool,
) -> tuple[FloatArray, FloatArray, int]:
    """Integrate the joint over a record, tied to the measurement with the observer gain λ.

    Classical Runge-Kutta for the smooth states; the friction states are held at their middle value during a step
    and then moved by the distance travelled (second order).

    Parameters
    ----------
    u : FloatArray, shape (2·steps·(N−1)+1, K)
        Inputs at every half step.
    du : FloatArray, shape (R, 2·steps·(N−1)+1, K)
        Their derivatives with respect to the R parameters of kind `INPUT_SHAPE`.
    measured, observe : FloatArray, shape (N,)
        Measured x (finite; linear between samples) and the share of the gain that acts (0 in gaps).
    gain : float
        λ [1/s]; 0 for the free run.
    start : (float, float)
        x(0), p(0) [1/s].
    interval : float
        Sample interval [s].
    steps : int
        Runge-Kutta steps per interval.
    c : Coefficients
        The joint.
    along : Directions
        P parameters; `no_directions()` for a plain simulation.
    rested : FloatArray, shape (K,)
        Inputs under which the relaxing elements were at rest before the first sample.
    held : bool
        Whether inputs are constant from node to node and jump there, instead of continuous.

    Returns
    -------
    states : FloatArray, shape (N, 3 + L + D)
        x, p, ṗ (without the observer's part), w, s; NaN after divergence.
    sensitivity : FloatArray, shape (N, P)
        ∂x/∂θ.
    valid : int
        Samples within the bounds. Cost: 4·steps·N stages of M exponentials, 2·(2+K+L)·(4+M) products and about
        3·(2+L+D)·P products for the sensitivities: 8 µs per step for P = 99, 0.6 µs without.
    """
    count, elements, slips, parameters = len(measured), len(c.rates), len(c.slip_force), len(along.kind)
    size, step = 2 + elements, interval / steps
    states = np.full((count, 3 + elements + slips), np.nan)
    sensitivity = np.zeros((count, parameters))
    work = np.zeros((4, max(c.curves.shape[0], c.curves.shape[1])))
    y, y_stage, slope, y_sum = np.zeros(size), np.zeros(size), np.zeros(size), np.zeros(size)
    s, s_stage = np.zeros((size, parameters)), np.zeros((size, parameters))
    k, s_sum = np.zeros((size, parameters)), np.zeros((size, parameters))
    slip, slip_middle = np.zeros(slips), np.zeros(slips)
    d_slip, d_middle = np.zeros((slips, parameters)), np.zeros((slips, parameters))
    y[0], y[1] = start
    _rest(y, s, rested, c, along)
    for n in range(count):
        if not (abs(y[0]) < ESCAPE and np.isfinite(y[1])):
            return states, sensitivity, n
        sensitivity[n] = s[0]
        states[n, 0], states[n, 1] = y[0], y[1]
        states[n, 3 : 3 + elements], states[n, 3 + elements :] = y[2:], slip
        last = n == count - 1
        following = n if last else n + 1
        for part in range(steps):
            _slide(slip, d_slip, 0.5 * step * y[1], 0.5 * step * s[1], c, along, slip_middle, d_middle)
            _clear(y_sum, s_sum)
            for stage in range(4):
                share = 0.0 if stage == 0 else (1.0 if stage == 3 else 0.5)
                _advance(y, s, share * step, slope, k, y_stage, s_stage)
                node = 2 * (n * steps + part) + (min(stage, 1) if held else int(2 * share))
                where = (part + share) / steps
                seen = measured[n] + where * (measured[following] - measured[n])
                tie = gain * min(observe[n], observe[following])
                error = seen - y_stage[0]
                acceleration = _slope(
                    y_stage, s_stage, slip_middle, d_middle, u, du, node, error, tie, c, along, work, slope, k
                )
                if stage == 0 and part == 0:
                    states[n, 2] = acceleration
                if last:
                    return states, sensitivity, count
                _advance(y_sum, s_sum, step / 6.0 if stage == 0 or stage == 3 else step / 3.0, slope, k, y_sum, s_sum)
            _advance(y, s, 1.0, y_sum, s_sum, y, s)
            _slide(slip, d_slip, y_sum[0], s_sum[0], c, along, slip, d_slip)
    return states, sensitivity, count
