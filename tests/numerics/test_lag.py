import numpy as np
import pytest
from scipy.integrate import solve_ivp

from pipeline.numerics.linear_filters import first_order_lag


@pytest.mark.parametrize("time_constant", [3e-3, 0.02, 0.4])
def test_matches_an_adaptive_integrator_on_a_piecewise_linear_input(time_constant):
    rng = np.random.default_rng(1)
    t = 0.01 * np.arange(60)
    x = np.cumsum(rng.standard_normal(60))
    z, _ = first_order_lag(x, 0.01, time_constant)
    truth = solve_ivp(
        lambda s, y: (np.interp(s, t, x) - y) / time_constant, (0, t[-1]), [x[0]], t_eval=t, rtol=1e-9, atol=1e-10,
        max_step=1e-3,
    )  # fmt: skip
    assert z == pytest.approx(truth.y[0], abs=2e-6)


def test_sensitivity_is_the_derivative_with_respect_to_the_logarithm_of_the_time_constant():
    x = np.sin(np.arange(200) * 0.1)
    _, sensitivity = first_order_lag(x, 0.01, 0.03)
    step = 1e-5
    above, _ = first_order_lag(x, 0.01, 0.03 * np.exp(step))
    below, _ = first_order_lag(x, 0.01, 0.03 * np.exp(-step))
    assert sensitivity == pytest.approx((above - below) / (2 * step), abs=1e-8)
