import numpy as np
import pytest

from pipeline.numerics.identification.residuals import whiteness


@pytest.mark.parametrize("memory", [0.5, 0.9])
def test_the_correlation_time_of_an_autoregressive_residual_is_recovered(memory):
    rng = np.random.default_rng(7)
    noise, x = rng.standard_normal(20000), np.zeros(20000)
    for i in range(1, len(x)):
        x[i] = memory * x[i - 1] + noise[i]
    found = whiteness(x)
    assert found.correlation_time == pytest.approx((1 + memory) / (1 - memory), rel=0.2)
    assert found.lag_one == pytest.approx(memory, abs=0.02)


def test_white_noise_is_worth_its_samples_and_zeros_do_no_harm():
    assert whiteness(np.random.default_rng(8).standard_normal(5000)).correlation_time == pytest.approx(1.0, abs=0.15)
    assert whiteness(np.zeros(10)).correlation_time == 1.0
