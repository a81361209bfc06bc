"""Voltages between the samples: work is kept, delays shift, and fine ones agree with what they were made of."""

import numpy as np
import pytest

from pipeline.models.hybrid.log_reading import DrivingVoltages, Instruments

DT, SAMPLES, REFINED = 0.01, 41, 10
LARGE = 1e9
FINE_TIMES = DT / REFINED * np.arange(SAMPLES * REFINED)


def seen(delay: float = 0.0, charging: float = 1e-9, probe: float = 0.0) -> Instruments:
    """Electrodes that charge at once, unless told."""
    return Instruments(0.0, delay, charging, np.full(2, probe))


def fine(values: np.ndarray) -> np.ndarray:
    """Voltages of one side at the fine times, the other side at zero, as (N, r, 2)."""
    return np.column_stack([values, np.zeros_like(values)]).reshape(SAMPLES, REFINED, 2)


@pytest.mark.parametrize("steps", [1, 2, 3, 7])
def test_no_work_is_lost_between_half_steps(steps: int) -> None:
    v = 3e3 * np.random.default_rng(steps).uniform(size=len(FINE_TIMES))
    v[:40], v[-60:] = 0.0, 0.0
    squares = DrivingVoltages(fine(v), DT).squared(steps, seen(), LARGE)
    assert squares.shape == (2 * steps * (SAMPLES - 1) + 1, 2)
    dense = np.linspace(0.0, DT * (SAMPLES - 1), 400_001)
    exact = np.mean(np.interp(dense, FINE_TIMES, v) ** 2) * dense[-1]
    assert np.sum(squares[:, 0]) * DT / (2 * steps) == pytest.approx(exact, rel=1e-5)
    assert not squares[:, 1].any()


@pytest.mark.parametrize("refined", [False, True])
def test_a_probe_that_is_off_is_corrected_and_the_force_is_held_above_twice_the_trained_voltage(refined: bool) -> None:
    v = np.full((SAMPLES, REFINED, 2) if refined else (SAMPLES, 2), 2510.0)
    np.testing.assert_allclose(DrivingVoltages(v, DT).squared(2, seen(probe=10.0), 3e3), 2500.0**2)
    np.testing.assert_allclose(DrivingVoltages(v, DT).squared(2, seen(), 1e3), 2000.0**2)
