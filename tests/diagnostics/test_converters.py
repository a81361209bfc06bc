"""The converters' lag is what was planted, and nothing is told where no step tells it."""

import numpy as np
import pytest

from pipeline.diagnostics.events import LEAST_STEPS, converter_lag, step_lags
from pipeline.numerics.arrays import FloatArray
from pipeline.rig.bench import Converter

RATE = 30_000.0
PULSES = ((0.2, 0.3, 2000.0), (0.8, 0.1, 2800.0), (1.3, 0.25, 1500.0))  # begin, length [s], voltage [V]


def commanded() -> tuple[FloatArray, FloatArray]:
    t = np.arange(0.0, 2.0, 1.0 / RATE)
    u = np.zeros_like(t)
    for begin, length, volts in PULSES:
        u[(t >= begin) & (t < begin + length)] = volts
    return t, u


def measured(lag: float, each: int, noise: float = 5.0) -> tuple[FloatArray, FloatArray]:
    """The answer of a rig's converter with a probe's noise [V], as means over `each` samples."""
    t, u = commanded()
    v = Converter(lag, power_limit=100.0).drive(u, 1.0 / RATE) + np.random.default_rng(3).normal(0.0, noise, t.size)
    return t[::each], v.reshape(-1, each).mean(axis=1)


@pytest.mark.parametrize("each", [1, 5, 30])
@pytest.mark.parametrize("lag", [2e-3, 4e-3, 7e-3, 10e-3])
def test_the_planted_lag_is_found_at_every_rate(lag: float, each: int) -> None:
    found = converter_lag([measured(lag, each), measured(lag, each)])
    assert found is not None
    assert found.lag == pytest.approx(lag, rel=0.02)
    assert found.steps == 4 * len(PULSES)
    assert found.scatter < 0.05


def test_ramps_and_sines_are_no_steps() -> None:
    t, _ = commanded()
    ramps = np.interp(t, [0.2, 0.22, 0.5, 0.52, 0.8, 0.83, 1.2, 1.23], 2000.0 * np.array([0, 1, 1, 0, 0, 1, 1, 0]))
    for v in (ramps, 1000.0 + 1000.0 * np.sin(40.0 * t), np.zeros_like(t), np.full_like(t, np.nan)):
        assert step_lags(t, v).size == 0


def test_edges_within_few_samples_are_no_decays() -> None:
    t = 0.01 * np.arange(1000)
    v = sum(1500.0 * (np.tanh((t - on) / 0.01) - np.tanh((t - on - 0.5) / 0.01)) for on in np.arange(0.303, 9.0, 1.001))
    assert converter_lag([(t, np.asarray(v))]) is None


def test_too_few_steps_tell_nothing() -> None:
    t, v = measured(3e-3, 5)
    half = t < 0.7
    assert 0 < step_lags(t[half], v[half]).size < LEAST_STEPS
    assert converter_lag([(t[half], v[half])]) is None
