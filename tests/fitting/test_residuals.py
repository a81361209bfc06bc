import numpy as np
import pytest

from pipeline.fitting.posterior import SIGNIFICANCE, surely_smaller, whiteness


@pytest.mark.parametrize("memory", [0.5, 0.9])
def test_the_correlation_time_of_an_autoregressive_residual_is_recovered(memory):
    rng = np.random.default_rng(7)
    noise, x = rng.standard_normal(20000), np.zeros(20000)
    for i in range(1, len(x)):
        x[i] = memory * x[i - 1] + noise[i]
    found = whiteness(x)
    assert found.integrated_correlation_time == pytest.approx((1 + memory) / (1 - memory), rel=0.2)
    assert found.lag_one == pytest.approx(memory, abs=0.02)


def test_white_noise_is_worth_its_samples_and_zeros_do_no_harm():
    noise = whiteness(np.random.default_rng(8).standard_normal(5000))
    assert noise.integrated_correlation_time == pytest.approx(1.0, abs=0.15)
    assert whiteness(np.zeros(10)).integrated_correlation_time == 1.0


def test_a_smaller_error_is_sure_only_if_it_is_smaller_everywhere():
    rng = np.random.default_rng(9)
    reference = rng.standard_normal(2000)
    assert surely_smaller(0.9 * reference, reference)
    assert not surely_smaller(reference, reference)
    assert not surely_smaller(reference, 0.9 * reference)
    mixed = reference.copy()
    mixed[500:1000] *= 0.3  # two segments, one of which gains what the other one loses
    mixed[1500:] *= 1.35
    assert not surely_smaller(mixed, reference) and not surely_smaller(reference, mixed)


@pytest.mark.parametrize("memory", [0.0, 0.9])
def test_equal_models_are_told_apart_as_often_as_the_level_says(memory):
    rng = np.random.default_rng(10)
    claims = []
    for _ in range(400):
        errors = rng.standard_normal((2, 600))
        for i in range(1, 600):
            errors[:, i] += memory * errors[:, i - 1]
        claims.append(surely_smaller(*errors))
    assert np.mean(claims) == pytest.approx(SIGNIFICANCE, abs=0.04)
