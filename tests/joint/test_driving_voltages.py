"""Voltages between the samples: work is kept, delays shift, and fine ones agree with what they were made of."""

import numpy as np
import pytest

from pipeline.errors import InputError
from pipeline.joint.driving_voltages import DrivingVoltages

DT, SAMPLES, REFINED = 0.01, 41, 10
NO_PROBE, LARGE = np.zeros(2), 1e9
FINE_TIMES = DT / REFINED * np.arange(SAMPLES * REFINED)


def fine(values: np.ndarray) -> np.ndarray:
    """Voltages of one side at the fine times, the other side at zero, as (N, r, 2)."""
    return np.column_stack([values, np.zeros_like(values)]).reshape(SAMPLES, REFINED, 2)


@pytest.mark.parametrize("steps", [1, 2, 3, 7])
def test_no_work_is_lost_between_half_steps(steps: int) -> None:
    v = 3e3 * np.random.default_rng(steps).uniform(size=len(FINE_TIMES))
    v[:40], v[-60:] = 0.0, 0.0
    squares = DrivingVoltages(fine(v), DT).squared(steps, 0.0, NO_PROBE, LARGE)
    assert squares.shape == (2 * steps * (SAMPLES - 1) + 1, 2)
    dense = np.linspace(0.0, DT * (SAMPLES - 1), 400_001)
    exact = np.mean(np.interp(dense, FINE_TIMES, v) ** 2) * dense[-1]
    assert np.sum(squares[:, 0]) * DT / (2 * steps) == pytest.approx(exact, rel=1e-5)
    assert not squares[:, 1].any()


def test_an_edge_between_two_half_steps_is_seen_by_its_place() -> None:
    def impulse(place: float) -> float:
        v = 3e3 * (place <= FINE_TIMES)
        return float(np.sum(DrivingVoltages(fine(v), DT).squared(1, 0.0, NO_PROBE, LARGE)[:, 0])) * DT / 2

    # Half a millisecond of 3 kV, though the half steps are 5 ms apart.
    assert impulse(0.2015) - impulse(0.2025) == pytest.approx(9e6 * 1e-3, rel=1e-9)


@pytest.mark.parametrize("refined", [False, True])
def test_a_delay_is_a_shift(refined: bool) -> None:
    def driving(shift: float) -> DrivingVoltages:
        times = FINE_TIMES.reshape(SAMPLES, REFINED) if refined else FINE_TIMES[::REFINED]
        v = 2e3 * np.exp(-(((times - shift - 0.2) / 0.05) ** 2))
        return DrivingVoltages(np.stack([v, v], axis=-1), DT)

    late = driving(0.0).squared(3, 0.003, NO_PROBE, LARGE)
    np.testing.assert_allclose(late, driving(0.003).squared(3, 0.0, NO_PROBE, LARGE), atol=4e6 * 2e-3)


def test_fine_and_coarse_voltages_of_a_smooth_signal_agree() -> None:
    v = 2e3 * np.sin(20.0 * FINE_TIMES)
    coarse = np.column_stack([v[::REFINED], np.zeros(SAMPLES)])
    fine_squares, squares = (DrivingVoltages(x, DT).squared(3, 0.0, NO_PROBE, LARGE) for x in (fine(v), coarse))
    np.testing.assert_allclose(fine_squares[1:-1], squares[1:-1], atol=4e6 * 2e-3)


@pytest.mark.parametrize("refined", [False, True])
def test_a_probe_that_is_off_is_corrected_and_the_force_is_held_above_twice_the_trained_voltage(refined: bool) -> None:
    v = np.full((SAMPLES, REFINED, 2) if refined else (SAMPLES, 2), 2510.0)
    np.testing.assert_allclose(DrivingVoltages(v, DT).squared(2, 0.0, np.full(2, 10.0), 3e3), 2500.0**2)
    np.testing.assert_allclose(DrivingVoltages(v, DT).squared(2, 0.0, NO_PROBE, 1e3), 2000.0**2)


def test_one_voltage_is_refused() -> None:
    with pytest.raises(InputError, match="two membranes"):
        DrivingVoltages(np.zeros((SAMPLES, 1)), DT)
