"""Linear regression on radial basis functions: centres and regressor (eqs. 34 to 40), and its pseudo-inverse.

The least squares needs memory that does not grow with the number of samples.
"""

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Literal

import numpy as np
import scipy.linalg

from ..codegen.numba_writer import formula
from ..errors import InputError
from ..generated.terms import GAUSSIAN
from ..numerics.arrays import FloatArray
from ..numerics.compiled import compiled

_gaussian = formula(GAUSSIAN)


def basis_centres(low: float, high: float, count: int) -> FloatArray:
    """Equidistant centres ξ_i from `low` to `high`, shape (count,) (eq. 39).

    Raises
    ------
    InputError
        Fewer than two centres, or an empty range.
    """
    if count < 2:
        raise InputError(f"{count} basis functions cannot span a range; at least 2 are needed")
    if not high > low:
        raise InputError(f"the operating range from {low:g} to {high:g} is empty")
    return np.linspace(low, high, count)


def basis_width(centres: FloatArray, smoothing: float) -> float:
    """Standard deviation σ = σ_n Δξ of the bells, in the unit of the centres (after eq. 38)."""
    if not smoothing > 0.0:
        raise InputError(f"the smoothing factor σ_n must be positive, it is {smoothing:g}")
    return smoothing * float(centres[1] - centres[0])


def basis_values(q: FloatArray, centres: FloatArray, width: float) -> FloatArray:
    """Values φ_i(q) of the Gaussian about each centre (eq. 38).

    Parameters
    ----------
    q : FloatArray, shape (N,)
        Places of the evaluation.
    centres : FloatArray, shape (M,)
        ξ_i, in the unit of q.
    width : float
        σ = σ_n Δξ, in the unit of q.

    Returns
    -------
    FloatArray, shape (N, M)
        Cost: N·M exponentials, about 5 ns each.
    """
    return _values(np.ascontiguousarray(q), centres, width)


@compiled
def _values(q: FloatArray, centres: FloatArray, width: float) -> FloatArray:
    values = np.empty((len(q), len(centres)))
    for n in range(len(q)):
        for i in range(len(centres)):
            distance = (q[n] - centres[i]) / width
            values[n, i] = _gaussian((distance * distance,))[0]
    return values


InputAction = Literal["squared", "linear"]


def input_signal(v: FloatArray, action: InputAction) -> FloatArray:
    """Factor of the input curves: v² for an electrostatic input (eq. 33), v for a force-like one.

    An electrostatic force is even in the voltage, so a negative voltage acts like a positive one.
    """
    return v * v if action == "squared" else v


def curve_signals(q: FloatArray, z: FloatArray, u: FloatArray) -> FloatArray:
    """Signals that the curves c, d, g_1 … g_K multiply in eq. 40: [−q, −z, u], shape (N, 2 + K)."""
    return np.column_stack((-q, -z, u))


def regressor(basis: FloatArray, signals: FloatArray) -> FloatArray:
    """Regressor ψᵀ of eq. 40, curve by curve, shape (N, S·M).

    Parameters
    ----------
    basis : FloatArray, shape (N, M)
        φ_i(q_n).
    signals : FloatArray, shape (N, S)
        One column per curve.
    """
    return (signals[:, :, None] * basis[:, None, :]).reshape(len(basis), -1)


@dataclass(frozen=True)
class LinearFit:
    """Weights of least norm among those of least squared residual, and how well they are determined.

    Attributes
    ----------
    weights : FloatArray, shape (p,)
    rank : int
        Numerical rank of the regressor with unit-norm columns.
    condition : float
        Ratio of its largest to its smallest singular value; infinite if a column is zero.
    residual_rms : float
        RMS of the residual, in the unit of the right side.
    samples : int
        Rows of the regressor.
    spread : FloatArray, shape (p, rank)
        Factor S of the pseudo-inverse of the normal matrix, S Sᵀ = (ψ ψᵀ)⁺: times the variance of the residual it is
        the covariance of the weights.
    """

    weights: FloatArray
    rank: int
    condition: float
    residual_rms: float
    samples: int
    spread: FloatArray


def triangular_factor(blocks: Iterable[FloatArray]) -> tuple[FloatArray, int]:
    """R of the QR factorisation of stacked blocks of rows, and the number of rows.

    Blocks are folded in one by one (sequential tall-skinny QR, Demmel et al. 2012, doi:10.1137/080731992), which
    is as accurate as one QR of the whole and needs the memory of one block.

    Parameters
    ----------
    blocks : iterable of FloatArray, shape (n_i, p)
        Rows; overwritten.

    Returns
    -------
    factor : FloatArray, shape (p, p)
    rows : int
        Cost: 2 N p² flops in blocked Householder form; 1.1e6 × 41 take about a second.
    """
    factor: FloatArray | None = None
    rows = 0
    for block in blocks:
        rows += len(block)
        stacked = block if factor is None else np.vstack((factor, block))
        (upper,) = scipy.linalg.qr(stacked, mode="r", check_finite=False, overwrite_a=True)
        factor = np.asarray(upper[: block.shape[1]], dtype=np.float64)
    if factor is None:
        raise ValueError("no rows to factorise")
    missing = np.zeros((factor.shape[1] - factor.shape[0], factor.shape[1]))
    return np.vstack((factor, missing)), rows


def pseudo_inverse_fit(factor: FloatArray, rows: int) -> LinearFit:
    """Least squares from the triangular factor of [X y] (eq. 40: pseudo-inverse, rank checked).

    Columns are scaled to unit norm first, because the curves carry different units (N/m, N s/m, N/V²) and neither
    the rank nor the condition number may depend on them. Singular values below max(rows, p) times the machine
    epsilon and the largest (as `numpy.linalg.matrix_rank`) count as zero; columns that are zero get the weight zero.

    Parameters
    ----------
    factor : FloatArray, shape (p + 1, p + 1)
        Upper triangular; the right side is the last column.
    rows : int
        Number of samples behind the factor.
    """
    p = factor.shape[1] - 1
    matrix = factor[:, :p]
    right = factor[:, p]
    norms = np.linalg.norm(matrix, axis=0)
    scale = np.where(norms > 0.0, norms, 1.0)
    left, singular, rows_v = np.linalg.svd(matrix / scale, full_matrices=False)
    rank = int(np.count_nonzero(singular > max(rows, p) * np.finfo(float).eps * singular[0]))
    weights = rows_v[:rank].T @ ((left.T[:rank] @ right) / singular[:rank]) / scale
    with np.errstate(divide="ignore"):
        condition = float(singular[0] / singular[-1]) if singular[-1] > 0.0 else np.inf
    return LinearFit(
        weights=weights,
        rank=rank,
        condition=condition,
        residual_rms=float(np.linalg.norm(right - matrix @ weights) / np.sqrt(rows)),
        samples=rows,
        spread=rows_v[:rank].T / singular[:rank] / scale[:, None],
    )
