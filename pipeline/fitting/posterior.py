"""Residuals and posterior of a fit: whiteness, covariance factors, repeatable draws, and the curves of the draws."""

from collections.abc import Callable, Collection, Sequence
from dataclasses import dataclass

import numpy as np
import scipy.linalg
from scipy.special import stdtrit

from ..numerics.arrays import FloatArray, IntArray
from ..numerics.metrics import NORMAL_95
from .descent import PARAMETER_STEP, Prior
from .homotopy import HomotopyFit

SIGNIFICANCE = 0.16
"""Share of equal models that the test separates: one standard error, one-sided."""
GROUPS = 10
"""Groups of data whose estimates are compared."""
ALONE = 0.03
"""Share of the precision in some direction that the other groups must supply to be compared with one."""
SINGULAR = 1e-10
"""Smallest share of a precision that is more than rounding."""


@dataclass(frozen=True)
class Whiteness:
    """Autocorrelation of a residual.

    Attributes
    ----------
    integrated_correlation_time : float
        Integrated autocorrelation time τ [samples]: N samples carry the information of N/τ independent ones.
    lag_one : float
        Correlation of neighbours; 0 for white noise.
    """

    integrated_correlation_time: float
    lag_one: float


def whiteness(residual: FloatArray) -> Whiteness:
    """Autocorrelation time by Geyer's initial positive sequence (1992, doi:10.1214/ss/1177011137).

    Parameters
    ----------
    residual : FloatArray, shape (N,)
        Residual in the order of time; N ≥ 2. Cost: two FFTs of length 2 N.
    """
    centred = residual - residual.mean()
    n = len(centred)
    correlation = np.fft.irfft(np.abs(np.fft.rfft(centred, 2 * n)) ** 2)[:n]
    correlation = correlation / max(float(correlation[0]), np.finfo(float).tiny)
    pairs = correlation[: n - n % 2].reshape(-1, 2).sum(axis=1)
    stop = int(np.argmax(pairs <= 0.0)) if np.any(pairs <= 0.0) else len(pairs)
    return Whiteness(max(1.0, 2.0 * float(pairs[:stop].sum()) - 1.0), float(correlation[1]))


def surely_smaller(errors: FloatArray, reference: FloatArray) -> bool:
    """True if the mean square of `errors` is significantly smaller than that of `reference`.

    The test of Diebold and Mariano (1995, doi:10.1080/07350015.1995.10524599): the mean difference of the squares over
    its standard error. Neighbours err together, so N samples with the autocorrelation time τ count as N/τ. As these may
    be few, the ratio is compared with Student's t of N/τ − 1 degrees of freedom (Harvey, Leybourne and Newbold 1997,
    doi:10.1016/S0169-2070(96)00719-4).

    Parameters
    ----------
    errors, reference : FloatArray, shape (N,)
        Errors of two models over the same samples, in the order of time. Cost: two FFTs of length 2 N.
    """
    gain = reference**2 - errors**2
    count = len(gain) / whiteness(gain).integrated_correlation_time
    if count < 2.0:
        return False
    return bool(gain.mean() > stdtrit(count - 1.0, 1.0 - SIGNIFICANCE) * gain.std() / np.sqrt(count))


def posterior_factor(fit: HomotopyFit, prior: Prior) -> FloatArray:
    """Factor S of the Gauss-Newton posterior covariance S Sᵀ = (JᵀJ/(s² τ) + AᵀA)⁻¹, shape (P, P).

    Residuals of a free run are coloured, so N of them carry less than N samples' information: τ is their integrated
    autocorrelation time in samples. S is the symmetric root of the scaled covariance, which changes as little as the
    data do. With the eigenvectors alone, their signs and order would give other draws on another machine.
    """
    precision = prior.matrix.T @ prior.matrix
    if np.isfinite(fit.hessian).all():  # else the sensitivities exploded, and the prior is all that is known
        variance = max(float(np.mean(fit.residual**2)), 1e-12)
        precision = precision + fit.hessian / (variance * whiteness(fit.residual).integrated_correlation_time)
    scale = 1.0 / np.sqrt(np.diag(precision))
    values, vectors = scipy.linalg.eigh(scale[:, None] * precision * scale)
    values = np.maximum(values, len(values) * np.finfo(float).eps * values[-1])
    return np.asarray(scale[:, None] * (vectors / np.sqrt(values)) @ vectors.T)


def log_evidence(fit: HomotopyFit, prior: Prior, correlation: float) -> float:
    """Logarithm of the marginal likelihood of a fit by Laplace's method, but for a constant of the data.

    Parameters
    ----------
    fit : HomotopyFit
        At the minimum, with the variance s² of its residual.
    prior : Prior
        A proper one: as many independent rows as parameters.
    correlation : float
        Samples that carry the information of an independent one.
    """
    variance = float(np.mean(fit.residual**2))
    believed = prior.matrix.T @ prior.matrix
    precision = believed + fit.hessian / (variance * correlation)
    fitted = len(fit.residual) / correlation * np.log(variance) + np.sum(prior.residual(fit.theta) ** 2)
    return 0.5 * float(np.linalg.slogdet(believed)[1] - np.linalg.slogdet(precision)[1] - fitted)


def posterior_draws(mean: FloatArray, spread: FloatArray, count: int, seed: int) -> FloatArray:
    """Draws from the normal distribution of covariance S Sᵀ about `mean`, shape (count, P).

    Parameters
    ----------
    mean : FloatArray, shape (P,)
        The parameters.
    spread : FloatArray, shape (P, rank)
        S.
    count : int
        Their number.
    seed : int
        The same seed gives the same draws.
    """
    return np.asarray(mean + np.random.default_rng(seed).standard_normal((count, spread.shape[1])) @ spread.T)


def outcome_draws(
    outcome: Callable[[FloatArray], FloatArray], mean: FloatArray, spread: FloatArray, count: int, seed: int
) -> FloatArray:
    """Outcomes of draws from the covariance S Sᵀ about `mean`, θ acting to first order, shape (count, n).

    The slope along each column of S is that between the two points at one standard deviation. An outcome is simulated
    and evaluated by a search, whose rounding a small step would multiply.

    Parameters
    ----------
    outcome : callable
        Parameter vector (P,) → numbers, shape (n,); those that do not exist at some point are NaN in all draws.
    mean : FloatArray, shape (P,)
        θ.
    spread : FloatArray, shape (P, R)
        S. Cost: 2 R + 1 outcomes.
    count, seed : int
        Number of draws, and the seed that repeats them.
    """
    slopes = np.stack([0.5 * (outcome(mean + column) - outcome(mean - column)) for column in spread.T], axis=1)
    return posterior_draws(outcome(mean), slopes, count, seed)


def first_order_curves(
    curves: Callable[[FloatArray], dict[str, FloatArray]],
    mean: FloatArray,
    spread: FloatArray,
    count: int,
    seed: int,
    nonnegative: Collection[str] = (),
) -> dict[str, FloatArray]:
    """Curves of draws from the covariance S Sᵀ about `mean`, θ acting to first order; each of shape (count, n).

    θ itself, drawn so, leaves the curved valley in which the data hold it. Curves of the hybrid model were then three
    times as wide, those of data-driven joints of their own class up to twenty times, and their middle was off the
    truth. Curves whose names are `nonnegative` are cut at zero. Cost: the curves of as many parameter vectors as S has
    rows that are not zero, and one.

    Parameters
    ----------
    curves : callable
        Parameter vector (P,) → curves by name, each of shape (n,).
    mean : FloatArray, shape (P,)
        θ.
    spread : FloatArray, shape (P, R)
        S.
    count, seed : int
        Number of draws, and the seed that repeats them.
    nonnegative : collection of str
        Names of curves that are cut at zero.
    """
    best = curves(mean)
    moved = np.flatnonzero(np.any(spread, axis=1))
    ahead = [curves(mean + step) for step in PARAMETER_STEP * np.eye(len(mean))[moved]]
    deviations = posterior_draws(np.zeros(len(moved)), spread[moved], count, seed) / PARAMETER_STEP
    drawn = {
        name: middle + deviations @ np.array([each[name] - middle for each in ahead]).reshape(len(moved), middle.size)
        for name, middle in best.items()
    }
    return drawn | {name: np.maximum(drawn[name], 0.0) for name in nonnegative}


def robust_spread(
    residual: FloatArray, jacobian: FloatArray, noise: float, prior: Prior, groups: Sequence[IntArray] | None = None
) -> FloatArray:
    """Factor E of the covariance E Eᵀ of an estimate as its data show it, shape (P, P + groups).

    The posterior contains noise only. Structural errors show where groups of the data ask for different estimates.

    1. The data are groups in a row, with the precision H_k = JᵀJ/s² and the slope g_k = Jᵀr/s² of each. A is
       the precision of all data and the prior. The covariance of the estimate is A⁻¹ (Σ g_k g_kᵀ + PᵀP) A⁻¹.
    2. The estimate has followed each group, so its slopes are too small. (1 − A⁻¹ H_k)⁻¹ A⁻¹ g_k is how far the
       estimate moves when the group is left out (jackknife, CR3). With the power −½ the expectation is A⁻¹ where the
       model is right (CR2; Bell and McCaffrey 2002).
    3. CR3 is used. In directions where the other groups have less than `ALONE` of the precision CR2 is used, because
       an estimate without the group would be the prior there.

    Moves are scaled: 1.96 standard deviations are the bounds of Student's t with one degree of freedom less than there
    are groups.

    Parameters
    ----------
    residual, jacobian : FloatArray, shapes (N,) and (N, P)
        Of the estimate, in the order of the data.
    noise : float
        s, the standard deviation that the estimate took its residuals to have beside the prior.
    prior : Prior
        P, with which the estimate was made.
    groups : sequence of IntArray, optional
        The rows of each group; `GROUPS` equal ones in a row by default.

    Returns
    -------
    FloatArray
        The prior's where sensitivities overflow. Cost: 2 N P² + 30 P³ flops a group.
    """
    if not np.isfinite(jacobian).all():
        return np.asarray(np.linalg.pinv(prior.matrix), dtype=np.float64)
    if groups is None:
        groups = np.array_split(np.arange(len(residual)), GROUPS)
    hessians = np.stack([jacobian[at].T @ jacobian[at] for at in groups]) / noise**2
    slopes = np.stack([jacobian[at].T @ residual[at] for at in groups]) / noise**2
    precision = hessians.sum(axis=0) + prior.matrix.T @ prior.matrix
    scale = 1.0 / np.sqrt(np.diag(precision))
    values, vectors = scipy.linalg.eigh(scale[:, None] * precision * scale)
    root = scale[:, None] * vectors / np.sqrt(np.maximum(values, SINGULAR * values[-1]))
    shares, turns = np.linalg.eigh(root.T @ hessians @ root)
    others = np.maximum(1.0 - shares, SINGULAR)
    others = np.maximum(others, np.sqrt(others * ALONE))
    pulls = np.swapaxes(turns, 1, 2) @ (slopes @ root)[:, :, None] / others[:, :, None]
    moves = (turns @ pulls)[:, :, 0] @ root.T
    size = stdtrit(len(groups) - 1, 0.975) / NORMAL_95
    return np.hstack([root @ (root.T @ prior.matrix.T), size * moves.T])
