"""What identified models with a Gaussian posterior share: reproducible draws, and curves of each."""

from collections.abc import Callable, Iterable

import numpy as np

from pipeline.numerics.arrays import FloatArray


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
