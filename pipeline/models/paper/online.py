"""Online identification (§ 4.1): the weights of eq. 40 over a stream of samples, their convergence and their tracking.

The model is linear in its weights once the lag T_z is known, so recursive least squares can follow a joint while it
runs. Two questions decide whether that is of use: how long a stream must be until the curves are those of the whole
log, and how fast and how noisily they follow a joint that changes.

The information is carried as the triangular factor R of the exponentially weighted normal equations and updated by
Givens rotations (QR-RLS; Haykin, Adaptive Filter Theory, ch. 15). Unlike the covariance form P ← (P − K ψᵀP)/λ it
never loses symmetry or definiteness, however long the stream is and however poorly it excites.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
import scipy.linalg

from pipeline.compiled import compiled
from pipeline.errors import InputError
from pipeline.numerics.arrays import FloatArray
from pipeline.numerics.metrics import rms


@compiled
def _rotate_in(factor: FloatArray, row: FloatArray, forget: float) -> None:
    """Rotate one row [ψᵀ y] into the triangular factor, whose past is first scaled by `forget` = √λ."""
    p = factor.shape[1]
    for i in range(p):
        for j in range(i, p):
            factor[i, j] *= forget
        radius = np.hypot(factor[i, i], row[i])
        if row[i] == 0.0 or radius == 0.0:
            continue
        c, s = factor[i, i] / radius, row[i] / radius
        factor[i, i] = radius
        for j in range(i + 1, p):
            above = factor[i, j]
            factor[i, j] = c * above + s * row[j]
            row[j] = c * row[j] - s * above


@dataclass
class RecursiveLeastSquares:
    """Weights of a linear regression over a stream, old samples forgotten exponentially.

    Minimises Σ_n λ^(N−n) (y_n − ψ_nᵀθ)² + λ^N δ² ‖S θ‖² with S the scales of the columns: with λ = 1 the batch
    solution of eq. 40, ridge δ.

    Parameters
    ----------
    scales : FloatArray, shape (p,)
        Typical size of each regressor column; carries the units, so that δ is a pure number.
    forgetting : float
        λ in (0, 1]; the memory is 1/(1 − λ) samples.
    ridge : float
        δ, weight of the starting value θ = 0.

    Raises
    ------
    InputError
        λ outside (0, 1], a scale or a ridge that is not positive.
    """

    scales: FloatArray
    forgetting: float = 1.0
    ridge: float = 1e-6

    def __post_init__(self) -> None:
        if not 0.0 < self.forgetting <= 1.0:
            raise InputError(f"the forgetting factor must lie in (0, 1], it is {self.forgetting:g}")
        if not (np.all(self.scales > 0.0) and self.ridge > 0.0):
            raise InputError("scales and ridge of the recursive least squares must be positive")
        p = len(self.scales)
        self._factor = np.zeros((p + 1, p + 1))
        self._factor[:p, :p] = np.diag(self.ridge * self.scales)
        self.samples = 0

    def update(self, regressor: FloatArray, target: float) -> None:
        """Take in one sample.

        Parameters
        ----------
        regressor : FloatArray, shape (p,)
            ψ.
        target : float
            y.

        Notes
        -----
        Cost: p rotations of p/2 pairs on average, 4 products each, no allocation beyond the row: 3 µs for p = 40, of
        the 1000 µs that a 1 kHz loop has.
        """
        row = np.empty(len(regressor) + 1)
        row[:-1], row[-1] = regressor, target
        _rotate_in(self._factor, row, np.sqrt(self.forgetting))
        self.samples += 1

    @property
    def weights(self) -> FloatArray:
        """θ of now, shape (p,): one triangular solve, p² products."""
        p = len(self.scales)
        solution: FloatArray = scipy.linalg.solve_triangular(
            self._factor[:p, :p] / self.scales, self._factor[:p, p], check_finite=False
        )
        return solution / self.scales


@dataclass(frozen=True)
class OnlineRun:
    """One stream through recursive least squares, looked at K times.

    Attributes
    ----------
    samples : FloatArray, shape (K,)
        Samples taken in so far.
    curve_error : FloatArray, shape (K,)
        RMS over q of the estimated less the true restoring force, over the range of the true one.
    prediction_error : FloatArray, shape (K,)
        RMS since the last look of the acceleration predicted before its sample was taken in, over the RMS of all.
    """

    samples: FloatArray
    curve_error: FloatArray
    prediction_error: FloatArray


LOOKS = 120
"""Number of times at which the errors are measured."""


def follow(
    regressors: FloatArray, target: FloatArray, force: FloatArray, true_force: FloatArray, *, forgetting: float
) -> OnlineRun:
    """Feed a stream to recursive least squares.

    Parameters
    ----------
    regressors : FloatArray, shape (N, P)
        Rows of eq. 40.
    target : FloatArray, shape (N,)
        m q̈ [N].
    force : FloatArray, shape (G, P)
        Rows that give the restoring force F [N] at G displacements.
    true_force : FloatArray, shape (N, G)
        What F is at each sample: constant rows, or those of a joint that drifts.
    forgetting : float
        λ in (0, 1]; the memory is 1/(1 − λ) samples.

    Notes
    -----
    Cost: P² products a sample (10 µs for P = 40, the call from Python included), a triangular solve each look.
    """
    scales = np.maximum(np.sqrt(np.mean(regressors**2, axis=0)), 1e-300)
    stream = RecursiveLeastSquares(scales, forgetting=forgetting, ridge=1e-3)
    edges = np.unique(np.linspace(0, len(target), LOOKS + 1).astype(int))
    span, usual = np.ptp(true_force[0]), max(rms(target), 1e-300)
    weights, rows = np.zeros(len(scales)), []
    for first, last in pairwise(edges):
        error = target[first:last] - regressors[first:last] @ weights
        for n in range(first, last):
            stream.update(regressors[n], float(target[n]))
        weights = stream.weights
        miss = rms(force @ weights - true_force[last - 1])
        rows.append((float(last), miss / span, rms(error) / usual))
    return OnlineRun(*(np.array(column) for column in zip(*rows, strict=True)))


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
    planted: FloatArray = target + (growth - 1.0) * (regressors[:, :count] @ weights[:count])
    return planted, growth


def memories(forgetting: Sequence[float], interval: float) -> list[str]:
    """Memory of each λ as a time, for legends: ``all`` or seconds."""
    return ["all" if value >= 1.0 else f"{interval / (1.0 - value):.3g} s" for value in forgetting]
