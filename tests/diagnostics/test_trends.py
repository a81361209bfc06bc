"""A change is claimed where there is one, and hardly ever where there is none."""

import numpy as np
import pytest

from pipeline.diagnostics.series import smoothed, trend

T = np.array([0.0, 2.0, 3.0, 7.0, 12.0, 13.0, 20.0, 30.0])
ERRORS = np.array([1.0, 0.5, 2.0, 1.0, 1.0, 5.0, 1.0, 0.7])


def measured(change: np.ndarray, seed: int, noise: float = 1.0) -> np.ndarray:
    return 40.0 + change + noise * ERRORS * np.random.default_rng(seed).standard_normal(len(T))


@pytest.mark.parametrize(
    "noise", [pytest.param(0.2, marks=pytest.mark.long), 1.0, pytest.param(3.0, marks=pytest.mark.long)]
)
def test_no_change_is_claimed_of_a_quantity_that_does_not_change(noise: float) -> None:
    """Whether the stated errors are right, five times too large or three times too small."""
    alarms = [trend(T, measured(0.0 * T, seed, noise), ERRORS, 0.05).kind != "none" for seed in range(200)]
    assert np.mean(alarms) < 0.09  # 0.05 and 2.6 standard errors of 200 cases


@pytest.mark.parametrize("noise", [1.0, 3.0])
def test_a_drift_is_claimed_and_lies_in_its_interval(noise: float) -> None:
    drifts = [trend(T, measured(2.0 * T, seed, noise), ERRORS, 0.003) for seed in range(100)]
    assert np.mean([each.kind == "line" for each in drifts]) > 0.9
    assert np.mean([abs(each.slope - 2.0) < each.slope_error for each in drifts]) >= 0.9


def test_a_step_is_claimed_with_its_size_and_its_place() -> None:
    steps = [trend(T, measured(15.0 * (T > 5.0), seed), ERRORS, 0.003) for seed in range(100)]
    stepped = [each for each in steps if each.kind == "step"]
    assert len(stepped) > 90
    assert np.mean([abs(each.step - 15.0) < each.step_error for each in stepped]) >= 0.9
    assert np.mean([each.after <= 3.0 and each.before >= 7.0 for each in stepped]) >= 0.9


def test_all_measurements_together_are_surer_of_what_does_not_change_and_follow_what_does() -> None:
    still, error = smoothed(T, np.full(len(T), 40.0), ERRORS)
    np.testing.assert_allclose(still, 40.0)
    np.testing.assert_allclose(error, np.sum(ERRORS**-2.0) ** -0.5, rtol=1e-3)
    moved, error = smoothed(T, 40.0 + 100.0 * T, ERRORS)
    np.testing.assert_allclose(moved, 40.0 + 100.0 * T, atol=5.0)
    assert np.all(error <= ERRORS) and error[5] < 0.9 * ERRORS[5] + 1.0
    misses = []
    for seed in range(50):
        walk = np.cumsum(np.append(0.0, np.sqrt(np.diff(T)) * np.random.default_rng([1, seed]).standard_normal(7)))
        value, error = smoothed(T, measured(walk, seed), ERRORS)
        misses.append((value - 40.0 - walk) / error)
    assert 0.7 < np.std(misses) < 1.4
