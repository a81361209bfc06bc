"""Least squares of eq. 40: the descent on the lag time T_z of eq. 37, and the weights over a stream of samples (§ 4.1).

For a given T_z the weights follow from linear least squares. So the cost is a function of T_z alone, and its gradient
needs no derivative of the weights (variable projection, Golub & Pereyra 1973, doi:10.1137/0710036). Only the damping
block of the regressor depends on T_z; the Gram matrix of the rest is computed once.

The model is linear in its weights once T_z is known, so recursive least squares can follow a joint while it runs. Two
questions decide whether that is of use: how long a stream must be until the curves are those of the whole log, and how
fast and how noisily they follow a joint that changes. The information is carried as the triangular factor R of the
exponentially weighted normal equations (QR-RLS; Haykin, Adaptive Filter Theory, ch. 15). Unlike the covariance form
P ← (P − K ψᵀP)/λ it never loses symmetry or definiteness, however long the stream is and however poorly it excites.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
import scipy.linalg

from ...numerics.arrays import FloatArray
from ...numerics.linear_filters import first_order_lag
from ...numerics.metrics import rms
from ...settings.models import LAG_START
from ..model_file import LONGEST_LAG, SHORTEST_LAG

CHUNK = 2048
LAG = 1  # the damping curve is the second one
MOST_STEPS = 60  # accepted ones after which a search has not converged
FLAT = 1e-7  # relative fall of the cost below which it no longer falls


@dataclass(frozen=True)
class LagSegment:
    """One gap-free segment: bells φ (N, M), signals [−q, −z, u] (N, S) with z yet to fill, target, velocity."""

    basis: FloatArray
    signals: FloatArray
    target: FloatArray
    qdot: FloatArray
    interval: float


def _accumulate(segment: LagSegment, first: FloatArray, second: FloatArray) -> FloatArray:
    """Sums Σ_n first_n,j second_n,j φ_a φ_b, shape (columns, M, M)."""
    m = segment.basis.shape[1]
    row, column = np.tril_indices(m)
    sums = np.zeros((first.shape[1], row.size))
    for start in range(0, len(first), CHUNK):
        part = slice(start, start + CHUNK)
        products = np.take(segment.basis[part], row, axis=1) * np.take(segment.basis[part], column, axis=1)
        sums += (first[part] * second[part]).T @ products
    blocks = np.empty((first.shape[1], m, m))
    blocks[:, row, column] = sums
    blocks[:, column, row] = sums
    return blocks


class _NormalEquations:
    """Gram matrix, right side and Σy² over all segments; `update` redoes the damping block for another T_z."""

    def __init__(self, segments: Sequence[LagSegment]) -> None:
        self.segments = segments
        self.m = segments[0].basis.shape[1]
        self.curves = segments[0].signals.shape[1]
        self.gram = np.zeros((self.curves, self.m, self.curves, self.m))
        self.right = np.zeros((self.curves, self.m))
        self.energy = sum(float(x.target @ x.target) for x in segments)
        self.samples = sum(len(x.target) for x in segments)
        fixed = [i for i in range(self.curves) if i != LAG]
        pairs = [(i, j) for i in fixed for j in fixed if j <= i]
        first, second = (list(each) for each in zip(*pairs, strict=True))
        for x in segments:
            blocks = _accumulate(x, x.signals[:, first], x.signals[:, second])
            for (i, j), block in zip(pairs, blocks, strict=True):
                self.gram[i, :, j, :] += block
                if i != j:
                    self.gram[j, :, i, :] += block
            self.right[fixed] += (x.signals[:, fixed] * x.target[:, None]).T @ x.basis

    def update(self, time_constant: float) -> None:
        """Fill z into the signals and redo the damping rows. Cost: about 0.4 µs per sample for M = 10."""
        self.gram[LAG] = 0.0
        self.right[LAG] = 0.0
        for x in self.segments:
            z, _ = first_order_lag(x.qdot, x.interval, time_constant)
            x.signals[:, LAG] = -z
            for j, block in enumerate(_accumulate(x, x.signals, x.signals[:, [LAG]] * np.ones(self.curves))):
                self.gram[LAG, :, j, :] += block
            self.right[LAG] += (x.signals[:, LAG] * x.target) @ x.basis
        for j in range(self.curves):
            self.gram[j, :, LAG, :] = self.gram[LAG, :, j, :].T

    def solve(self) -> tuple[FloatArray, tuple[float, int, float]]:
        """Weights (curves, M) by column-scaled pseudo-inverse; and the cost, rank and condition number."""
        p = self.curves * self.m
        gram = self.gram.reshape(p, p)
        norms = np.sqrt(np.diag(gram))
        scale = np.where(norms > 0.0, norms, 1.0)
        values, vectors = np.linalg.eigh(gram / np.outer(scale, scale))
        significant = values > p * np.finfo(float).eps * values[-1]
        coordinates = vectors[:, significant].T @ (self.right.ravel() / scale)
        weights = vectors[:, significant] @ (coordinates / values[significant]) / scale
        cost = 0.5 * (self.energy - float(coordinates @ (coordinates / values[significant]))) / self.samples
        condition = float(np.sqrt(values[-1] / values[significant][0]))
        return weights.reshape(self.curves, self.m), (cost, int(significant.sum()), condition)

    def gradient(self, weights: FloatArray, time_constant: float) -> float:
        """Derivative of the cost along ln T_z at fixed weights: the total one where the weights are optimal."""
        total = 0.0
        for x in self.segments:
            _, sensitivity = first_order_lag(x.qdot, x.interval, time_constant)
            curves = x.basis @ weights.T
            residual = x.target - np.einsum("ij,ij->i", curves, x.signals)
            total += float(np.sum(residual * curves[:, LAG] * sensitivity))
        return total / self.samples


def search_lag(segments: Sequence[LagSegment]) -> tuple[float, bool, FloatArray]:
    """Descend from `LAG_START` along the gradient in ln T_z until the cost no longer falls (after eq. 40).

    Barzilai-Borwein steps, halved until the cost falls; the logarithm keeps T_z positive.

    Parameters
    ----------
    segments : sequence of LagSegment
        Their `signals` are used as work space: the damping column holds −z at the returned T_z afterwards.

    Returns
    -------
    float
        T_z [s].
    bool
        True if the descent converged.
    FloatArray, shape (accepted steps + 1, 4)
        T_z [s], cost (½·mean squared residual), rank and condition number (of what the rank counts) of the start and of
        every accepted step; costs fall from row to row.

    Notes
    -----
    Cost: one Gram update (0.4 µs per sample at M = 10) and one gradient (20 ns) per evaluation, about ten of them.
    """
    equations = _NormalEquations(segments)
    low, high = np.log((SHORTEST_LAG, LONGEST_LAG))

    def evaluate(x: float) -> tuple[FloatArray, tuple[float, int, float]]:
        """Weights and criteria at the logarithm of a lag."""
        equations.update(float(np.exp(x)))
        return equations.solve()

    x = float(np.log(LAG_START))
    weights, (cost, *conditioning) = evaluate(x)
    slope = equations.gradient(weights, float(np.exp(x)))
    history = [(float(np.exp(x)), cost, *conditioning)]
    step = 0.5
    converged = False
    while len(history) <= MOST_STEPS and not converged:
        trial = float(np.clip(x - np.sign(slope) * step, low, high))
        trial_weights, (trial_cost, *conditioning) = evaluate(trial)
        if trial_cost < cost:
            trial_slope = equations.gradient(trial_weights, float(np.exp(trial)))
            bend = (trial_slope - slope) / (trial - x)
            converged = cost - trial_cost <= FLAT * cost
            step = min(abs(trial_slope / bend), 1.5) if bend > 0.0 else min(2.0 * step, 1.5)
            x = trial
            cost = trial_cost
            slope = trial_slope
            history.append((float(np.exp(x)), cost, *conditioning))
        else:
            step *= 0.3
            converged = step < 1e-4 or trial == x
    equations.update(float(np.exp(x)))
    return float(np.exp(x)), converged, np.array(history)


RIDGE = 1e-3
"""δ, weight of the starting value θ = 0."""
LOOKS = 120
"""Number of times at which the errors are measured."""


def follow(
    regressors: FloatArray, target: FloatArray, force: FloatArray, true_force: FloatArray, *, forgetting: float
) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Feed a stream to recursive least squares, which minimises Σ_n λ^(N−n) (y_n − ψ_nᵀθ)² + λ^N δ² ‖S θ‖².

    S has the RMS of each column, so that the ridge δ is a pure number.

    Parameters
    ----------
    regressors : FloatArray, shape (N, P)
        Rows of eq. 40.
    target : FloatArray, shape (N,)
        m q̈ [N].
    force : FloatArray, shape (G, P)
        Rows that give the restoring force F [N] at G displacements.
    true_force : FloatArray, shape (N, G)
        F at each sample: constant rows, or those of a joint that drifts.
    forgetting : float
        λ in (0, 1]; the memory is 1/(1 − λ) samples.

    Returns
    -------
    samples : FloatArray, shape (K,)
        Samples taken in at each of K looks.
    curve_error : FloatArray, shape (K,)
        RMS over q of the estimated less the true restoring force, over the range of the true one.
    prediction_error : FloatArray, shape (K,)
        RMS since the last look of the acceleration predicted before its sample was taken in, over the RMS of all.
    """
    scales = np.maximum(np.sqrt(np.mean(regressors**2, axis=0)), 1e-300)
    factor = np.column_stack([np.diag(RIDGE * scales), np.zeros(len(scales))])
    stream = np.column_stack([regressors, target])
    span = np.ptp(true_force[0])
    usual = max(rms(target), 1e-300)
    weights = np.zeros(len(scales))
    rows = []
    for first, last in pairwise(np.unique(np.linspace(0, len(target), LOOKS + 1).astype(int))):
        error = target[first:last] - regressors[first:last] @ weights
        forgotten = forgetting ** (0.5 * np.arange(last - first, -1, -1))[:, None]
        block = np.vstack([forgotten[0] * factor, forgotten[1:] * stream[first:last]])
        factor = scipy.linalg.qr(block, mode="r")[0][: len(scales)]
        weights = scipy.linalg.solve_triangular(factor[:, :-1] / scales, factor[:, -1]) / scales
        rows.append((float(last), rms(force @ weights - true_force[last - 1]) / span, rms(error) / usual))
    samples, curve_error, prediction_error = np.array(rows).T
    return samples, curve_error, prediction_error


def drifted(
    regressors: FloatArray, target: FloatArray, weights: FloatArray, count: int, share: float
) -> tuple[FloatArray, FloatArray]:
    """The motion of a joint whose restoring force grows by a `share` of itself from first to last sample.

    Parameters
    ----------
    regressors : FloatArray, shape (N, P)
        Rows of eq. 40, of which the first `count` columns belong to c(q) q.
    target : FloatArray, shape (N,)
        m q̈ [N].
    weights : FloatArray, shape (P,)
        Of the whole log.
    count : int
        Columns of c(q) q.
    share : float
        Growth of c(q) q, as a share.

    Returns
    -------
    target : FloatArray, shape (N,)
        m q̈ with the drift planted.
    growth : FloatArray, shape (N,)
        Factor of the restoring force at each sample.
    """
    growth = 1.0 + share * np.linspace(0.0, 1.0, len(target))
    return target + (growth - 1.0) * (regressors[:, :count] @ weights[:count]), growth
