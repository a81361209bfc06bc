import numpy as np
import pytest

from pipeline.identification.residuals import ONE_ERROR, TWO_ERRORS, surely_smaller, whiteness


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


def test_a_smaller_error_is_sure_only_if_it_is_smaller_everywhere():
    rng = np.random.default_rng(9)
    reference = rng.standard_normal(2000)
    assert surely_smaller(0.9 * reference, reference)
    assert not surely_smaller(reference, reference)
    assert not surely_smaller(reference, 0.9 * reference)
    lucky, unlucky = reference.copy(), reference.copy()
    lucky[:50], unlucky[:50] = 0.0, 10.0  # one stretch alone, however much it gains, is one sample
    assert not surely_smaller(lucky, unlucky)


@pytest.mark.parametrize("memory", [0.0, 0.9])
def test_equal_models_are_told_apart_as_often_as_the_level_says(memory):
    rng = np.random.default_rng(10)
    claims = []
    for _ in range(400):
        errors = rng.standard_normal((2, 600))
        for i in range(1, 600):
            errors[:, i] += memory * errors[:, i - 1]
        claims.append([surely_smaller(*errors, level) for level in (TWO_ERRORS, ONE_ERROR)])
    assert np.mean(claims, axis=0) == pytest.approx([TWO_ERRORS, ONE_ERROR], abs=0.025)
