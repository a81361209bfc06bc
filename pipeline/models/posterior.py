"""What identified models with a Gaussian posterior share: its factor, repeatable draws, their curves and bands."""

from collections.abc import Callable, Iterable

import numpy as np
import scipy.linalg
from scipy.special import stdtrit

from pipeline.identification.descent import Prior
from pipeline.identification.homotopy import HomotopyFit
from pipeline.identification.residuals import whiteness
from pipeline.models.kind import FITTED_SHARE
from pipeline.numerics.arrays import FloatArray

NORMAL = 1.959964
"""Quantile 0.975 of the normal distribution."""


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


def band_inflation(best: dict[str, FloatArray], early: dict[str, FloatArray], drawn: dict[str, FloatArray]) -> float:
    """How much wider than the posterior's the 95 % bands of the curves must be, from one deleted block of the data.

    The posterior knows noise. What a model cannot be shows in how far its curves move when a quarter of the data is
    left out: for independent data the estimate from a share s of them has 1/s of the variance of that from all, so the
    difference of the two has (1 − s)/s of it (delete-a-group jackknife, Kott 2001). One such difference has as many
    degrees of freedom as the curves have independent ways to vary, ν = (tr C)²/tr C² of their posterior correlation C,
    so bands are those of Student's t.

    Parameters
    ----------
    best, early : dict of str to FloatArray, shape (n,)
        Curves of the estimate from all data and of that from the first `FITTED_SHARE` of them.
    drawn : dict of str to FloatArray, shape (R, n)
        Those of R draws from the posterior.

    Returns
    -------
    float
        Factor on the distance of the draws from the best; at least 1.
    """
    names = [name for name in best if np.any(drawn[name] != best[name])]
    if not names:
        return 1.0
    deviations = np.hstack([drawn[name] - best[name] for name in names])
    spread = np.sqrt(np.mean(deviations**2, axis=0))
    moved, kept = np.concatenate([early[name] - best[name] for name in names]), spread > 0.0
    strengths = np.linalg.svd(deviations[:, kept] / spread[kept], compute_uv=False) ** 2
    freedom = strengths.sum() ** 2 / np.sum(strengths**2)
    excess = FITTED_SHARE / (1.0 - FITTED_SHARE) * np.mean((moved[kept] / spread[kept]) ** 2)
    return float(np.sqrt(1.0 + excess) * stdtrit(freedom, 0.975)) / NORMAL
