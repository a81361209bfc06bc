"""Bands of curves hold what they say, whether the posterior is right or far too sure."""

from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from pipeline.models.posterior import band_inflation, curves_of_draws, posterior_draws, posterior_factor

Q = np.linspace(-1.0, 1.0, 17)
SHAPES = np.array([np.ones_like(Q), Q])
"""Curves are two weights times these."""


def curves(weights: np.ndarray) -> dict[str, np.ndarray]:
    return {"F": weights @ SHAPES}


def held(too_sure: float, seed: int) -> tuple[float, float]:
    """Shares of the true curve within the bands, widened and not, where errors are so many times the posterior's."""
    random = np.random.default_rng(seed)
    parts = too_sure * 2.0 * random.standard_normal((4, 2))  # what each quarter alone would give, about the truth
    best, early = curves(parts.mean(axis=0)), curves(parts[:3].mean(axis=0))
    draws = posterior_draws(parts.mean(axis=0), np.eye(2), 64, seed)
    drawn = curves_of_draws(draws, curves)
    error, spread = np.abs(best["F"]), np.std(drawn["F"], axis=0)
    wider = band_inflation(best, early, drawn)
    assert wider >= 1.0
    return float(np.mean(error < 1.96 * wider * spread)), float(np.mean(error < 1.96 * spread))


@pytest.mark.parametrize("too_sure", [1.0, 5.0, 25.0])
def test_widened_bands_hold_whatever_the_posterior_claims(too_sure: float) -> None:
    shares = np.array([held(too_sure, seed) for seed in range(200)]).mean(axis=0)
    assert shares[0] > 0.9
    assert shares[1] < 0.6 or too_sure == 1.0


def test_curves_that_nothing_moves_need_no_wider_bands() -> None:
    best = curves(np.array([1.0, 2.0]))
    assert band_inflation(best, best, {"F": np.tile(best["F"], (8, 1))}) == 1.0


def test_the_factor_is_a_root_of_the_covariance_that_hardly_moves_with_the_data() -> None:
    """Also where two directions are known equally well, so that no eigenvector is distinguished."""
    random = np.random.default_rng(5)
    turn = np.linalg.qr(random.standard_normal((6, 6)))[0]
    hessian = turn @ np.diag([9.0, 9.0, 9.0, 4.0, 4.0, 1.0]) @ turn.T
    prior: Any = SimpleNamespace(matrix=np.eye(6))
    residual = random.standard_normal(4000)

    def factor(change: np.ndarray) -> np.ndarray:
        fit: Any = SimpleNamespace(residual=residual, hessian=hessian + change)
        return posterior_factor(fit, prior)

    nudge = 1e-9 * random.standard_normal((6, 6))
    found, moved = factor(np.zeros((6, 6))), factor(nudge + nudge.T)
    assert np.abs(moved - found).max() < 1e-8
    precision = np.linalg.inv(found @ found.T)
    data = precision - np.eye(6)
    np.testing.assert_allclose(data / data[0, 0], hessian / hessian[0, 0], atol=1e-9)
