import numpy as np
import pytest

from pipeline.identification.residuals import surely_smaller, whiteness


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
    assert surely_smaller(0.9 * reference, reference, 50)
    assert not surely_smaller(reference, reference, 50)
    lucky = reference.copy()
    lucky[:50] = 0.0  # one block alone, however much it gains, is a lottery
    reference[:50] *= 10.0
    assert not surely_smaller(lucky, reference, 50)
    assert not surely_smaller(0.0 * reference[:90], reference[:90], 50)


def test_equal_models_are_told_apart_as_seldom_as_two_standard_errors_say():
    rng = np.random.default_rng(10)
    claims = [surely_smaller(*rng.standard_normal((2, 1000)), 20) for _ in range(400)]
    assert np.mean(claims) == pytest.approx(0.025, abs=0.025)


def test_by_sign_one_block_in_which_both_failed_does_not_hide_the_rest():
    rng = np.random.default_rng(11)
    reference = rng.standard_normal(2000)
    better = 0.8 * reference
    reference[:50] *= 40.0
    better[:50] = 1.01 * reference[:50] * rng.choice([-1.0, 1.0], 50)
    better[:25] *= 0.97
    assert not surely_smaller(better, reference, 50)
    assert surely_smaller(better, reference, 50, by_sign=True)
    claims = [surely_smaller(*rng.standard_normal((2, 1000)), 20, by_sign=True) for _ in range(400)]
    assert np.mean(claims) < 0.07
