"""Bands of curves hold what they say, whether the posterior is right or far too sure."""

from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from pipeline.fitting.descent import Prior
from pipeline.fitting.posterior import outcome_draws, posterior_factor, robust_spread


def covered(wrong: float, prior: float, seed: int) -> bool:
    """Whether a slope is within the 95 % bounds of the jackknife where a model misses steps of that amplitude."""
    random, x = np.random.default_rng(seed), np.linspace(-1.0, 1.0, 400)
    rows = np.column_stack([np.ones_like(x), x])
    missed = wrong * np.repeat(random.standard_normal(20), 20)
    y = rows @ np.array([0.3, 0.7]) + missed + 0.1 * random.standard_normal(400)
    believed = Prior(prior * np.eye(2), np.zeros(2))
    found = np.linalg.solve(rows.T @ rows, rows.T @ y)
    residual = rows @ found - y
    spread = robust_spread(residual, rows, float(np.std(residual)), believed)
    return bool(np.abs(found[1] - 0.7) < 1.96 * np.sqrt(np.sum(spread[1] ** 2)))


@pytest.mark.parametrize("wrong", [0.0, 0.1, 1.0])
def test_bounds_hold_the_truth_whatever_a_model_misses(wrong: float) -> None:
    assert 0.9 < np.mean([covered(wrong, 1e-6, seed) for seed in range(300)]) < 0.99


def test_what_data_say_nothing_of_is_as_wide_as_believed() -> None:
    rows = np.column_stack([np.linspace(-1.0, 1.0, 100), np.zeros(100)])
    residual = np.random.default_rng(1).standard_normal(100)
    spread = robust_spread(residual, rows, 1.0, Prior(np.diag([1e-3, 0.5]), np.zeros(2)))
    assert np.sqrt(np.sum(spread[1] ** 2)) == pytest.approx(2.0)


def test_what_one_part_of_the_data_alone_tells_is_as_sure_as_the_noise_and_not_as_what_was_believed() -> None:
    rows = np.zeros((400, 2))
    rows[:, 0], rows[:20, 1] = 1.0, 3.0
    believed = Prior(np.diag([1e-3, 1e-2]), np.zeros(2))
    y = rows @ np.array([0.3, 5.0]) + 0.1 * np.random.default_rng(2).standard_normal(400)
    precision = rows.T @ rows / 0.01 + believed.matrix.T @ believed.matrix
    found = np.linalg.solve(precision, rows.T @ y / 0.01)
    spread = robust_spread(rows @ found - y, rows, 0.1, believed)
    sure = np.sqrt(np.linalg.inv(precision)[1, 1])
    assert np.sqrt(np.sum(spread[1] ** 2)) < 10.0 * sure < 0.01 * 1e2


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


def test_draws_of_an_outcome_have_the_covariance_of_its_slopes_whatever_its_curvature() -> None:
    random = np.random.default_rng(6)
    spread, slopes, mean = random.standard_normal((5, 7)), random.standard_normal((3, 5)), random.standard_normal(5)

    def outcome(theta: np.ndarray) -> np.ndarray:
        away = theta - mean
        return np.array([2.0, 3.0, 4.0]) + slopes @ away + np.sum(away**2)

    drawn = outcome_draws(outcome, mean, spread, 40_000, 1)
    truth = slopes @ spread @ spread.T @ slopes.T
    np.testing.assert_allclose(drawn.mean(axis=0), [2.0, 3.0, 4.0], atol=0.02 * np.sqrt(truth.max()))
    np.testing.assert_allclose(np.cov(drawn.T), truth, atol=0.03 * truth.max())


def test_an_outcome_that_does_not_exist_nearby_has_no_draws() -> None:
    drawn = outcome_draws(
        lambda theta: np.array([np.sqrt(theta[0]) if theta[0] > 0.0 else np.nan, theta[0]]),
        np.array([0.5]), np.array([[1.0]]), 10, 1,
    )  # fmt: skip
    assert np.isnan(drawn[:, 0]).all()
    assert np.isfinite(drawn[:, 1]).all()
