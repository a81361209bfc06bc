"""What identified models with a Gaussian posterior share: factors of its covariance, repeatable draws, their curves."""

from collections.abc import Callable, Iterable

import numpy as np
import scipy.linalg
from scipy.special import stdtrit

from pipeline.identification.descent import Prior
from pipeline.identification.homotopy import HomotopyFit
from pipeline.identification.residuals import whiteness
from pipeline.numerics.arrays import FloatArray

NORMAL = 1.959964
"""Quantile 0.975 of the normal distribution."""

GROUPS = 10
"""Groups of data that the jackknife leaves out in turn."""


def posterior_factor(fit: HomotopyFit, prior: Prior) -> FloatArray:
    """Factor S of the Gauss-Newton posterior covariance S Sᵀ = (JᵀJ/(s² τ) + AᵀA)⁻¹, shape (P, P).

    Residuals of a free run are coloured, so N of them carry less than N samples' information: τ is their integrated
    autocorrelation time in samples. S is the symmetric root of the scaled covariance, which changes as little as
    the data do: with the eigenvectors alone, their signs and order would give other draws on another machine.
    """
    tau = whiteness(fit.residual).correlation_time
    noise = max(float(np.mean(fit.residual**2)), 1e-12)
    a = prior.matrix
    precision = a.T @ a
    if np.isfinite(fit.hessian).all():  # else the sensitivities exploded, and the prior is all that is known
        precision = precision + fit.hessian / (noise * tau)
    scale = 1.0 / np.sqrt(np.diag(precision))
    values, vectors = scipy.linalg.eigh(scale[:, None] * precision * scale)
    values = np.maximum(values, len(values) * np.finfo(float).eps * values[-1])
    spread: FloatArray = scale[:, None] * (vectors / np.sqrt(values)) @ vectors.T
    return spread


def posterior_draws(mean: FloatArray, spread: FloatArray, count: int, seed: int) -> FloatArray:
    """Draws from the normal distribution of covariance S Sᵀ about `mean`, shape (count, P).

    Parameters
    ----------
    mean : FloatArray, shape (P,)
        The parameters.
    spread : FloatArray, shape (P, rank)
        S.
    count : int
        How many.
    seed : int
        The same seed gives the same draws.
    """
    standard = np.random.default_rng(seed).standard_normal((count, spread.shape[1]))
    drawn: FloatArray = mean + standard @ spread.T
    return drawn


def curves_of_draws(
    draws: Iterable[FloatArray], curves: Callable[[FloatArray], dict[str, FloatArray]]
) -> dict[str, FloatArray]:
    """The curves of every draw, each of shape (count, n)."""
    drawn = [curves(theta) for theta in draws]
    return {name: np.array([each[name] for each in drawn]) for name in drawn[0]}


def jackknife_spread(residual: FloatArray, jacobian: FloatArray, prior: Prior) -> FloatArray:
    """Factor E of the covariance E Eᵀ of an estimate as its data show it, shape (P, P + `GROUPS`).

    The posterior knows noise; what a model cannot be shows in how far the estimate moves when a part of the data is
    left out. With the data in groups in a row, H and g being the precision JᵀJ/(s² τ) and the slope Jᵀr/(s² τ) of each,
    the estimate without one moves by (A − H_k)⁻¹ g_k to first order, A being the whole precision. The delete-a-group
    jackknife (Kott 2001) makes a covariance of these moves; that of the prior's mean, A⁻¹ PᵀP A⁻¹, is added. The moves
    are scaled so that 1.96 standard deviations are the bounds of Student's t with `GROUPS` − 1 degrees of freedom.

    Parameters
    ----------
    residual, jacobian : FloatArray, shapes (N,) and (N, P)
        Of the estimate, in the order of the data.
    prior : Prior
        P, with which the estimate was made.

    Returns
    -------
    FloatArray
        Cost: 2 N P² + 4 P³ flops.
    """
    weight = 1.0 / (whiteness(residual).correlation_time * max(float(np.mean(residual**2)), 1e-12))
    groups = np.array_split(np.arange(len(residual)), GROUPS)
    hessians = np.stack([weight * jacobian[at].T @ jacobian[at] for at in groups])
    slopes = np.stack([weight * jacobian[at].T @ residual[at] for at in groups])
    precision = hessians.sum(axis=0) + prior.matrix.T @ prior.matrix
    moves = np.linalg.solve(precision - hessians, slopes[:, :, None])[:, :, 0]
    moves -= moves.mean(axis=0)
    size = stdtrit(GROUPS - 1, 0.975) / NORMAL * np.sqrt((GROUPS - 1) / GROUPS)
    return np.hstack([np.linalg.solve(precision, prior.matrix.T), size * moves.T])
