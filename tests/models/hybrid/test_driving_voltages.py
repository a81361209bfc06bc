"""Voltages between the samples: work is kept, delays shift, and fine ones agree with what they were made of."""

import numpy as np
import pytest

from pipeline.models.hybrid.driving_voltages import DrivingVoltages
from pipeline.models.hybrid.parameters import Instruments
from pipeline.numerics.linear_filters import first_order_lag

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
def test_a_delay_is_a_shift(refined: bool) -> None:
    def driving(shift: float) -> DrivingVoltages:
        times = FINE_TIMES.reshape(SAMPLES, REFINED) if refined else FINE_TIMES[::REFINED]
        v = 2e3 * np.exp(-(((times - shift - 0.2) / 0.05) ** 2))
        return DrivingVoltages(np.stack([v, v], axis=-1), DT)

    late = driving(0.0).squared(3, seen(0.003), LARGE)
    np.testing.assert_allclose(late, driving(0.003).squared(3, seen(), LARGE), atol=4e6 * 2e-3)


@pytest.mark.parametrize("refined", [False, True])
def test_a_probe_that_is_off_is_corrected_and_the_force_is_held_above_twice_the_trained_voltage(refined: bool) -> None:
    v = np.full((SAMPLES, REFINED, 2) if refined else (SAMPLES, 2), 2510.0)
    np.testing.assert_allclose(DrivingVoltages(v, DT).squared(2, seen(probe=10.0), 3e3), 2500.0**2)
    np.testing.assert_allclose(DrivingVoltages(v, DT).squared(2, seen(), 1e3), 2000.0**2)


@pytest.mark.parametrize("charging", [0.3e-3, 2e-3, 15e-3])
@pytest.mark.parametrize("refined", [False, True])
def test_electrodes_charge_with_their_time_constant(refined: bool, charging: float) -> None:
    times = FINE_TIMES.reshape(SAMPLES, REFINED) if refined else FINE_TIMES[::REFINED]
    v = 1e3 + 2e3 * np.exp(-(((times - 0.2) / 0.04) ** 2))
    squares = DrivingVoltages(np.stack([v, v], axis=-1), DT).squared(3, seen(charging=charging), LARGE)
    dense = np.linspace(0.0, DT * (SAMPLES - 1), 240_001)
    charged, _ = first_order_lag(1e3 + 2e3 * np.exp(-(((dense - 0.2) / 0.04) ** 2)), dense[1], charging)
    np.testing.assert_allclose(squares[1:-1, 0], charged[1000:-1000:1000] ** 2, atol=9e6 * 2e-3)
    assert np.argmax(charged) > np.argmax(dense >= 0.2)
