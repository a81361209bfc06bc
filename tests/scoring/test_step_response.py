"""Rise and settling times of responses known in closed form."""

import numpy as np
import pytest

from pipeline.device.device import JOINT
from pipeline.scoring.scores import response_errors, step_response
from pipeline.scoring.wells import Wells

DT = 0.001
T = DT * np.arange(3000)
WELLS = Wells(-0.01, 0.01, 0.0)


def test_first_order_lag() -> None:
    """1 − e^(−t/T): rises in T ln 9 and settles to 10 % in T ln 10."""
    rise, settling = step_response(1 - np.exp(-T / 0.1), DT)
    assert rise == pytest.approx(0.1 * np.log(9.0), abs=2 * DT)
    assert settling == pytest.approx(0.1 * np.log(10.0), abs=2 * DT)


def test_a_response_that_swings_on_has_no_settling_time() -> None:
    assert step_response(np.concatenate([[0.0], 1 + 0.5 * np.sin(15.7 * T)]), DT)[1] is None


def test_a_lag_of_the_simulation_is_what_is_reported() -> None:
    v = np.zeros((3000, 1))
    v[200:] = 3000.0

    def switch(time_constant: float) -> np.ndarray:
        return np.where(T < 0.2, -0.01, 0.01 - 0.02 * np.exp(-(T - 0.2) / time_constant))

    errors = response_errors(switch(0.10), switch(0.15), v, DT, WELLS, np.random.default_rng(0), plant=JOINT)
    assert (errors.switches, errors.followed) == (1, 1)
    assert errors.rise_s == pytest.approx(0.05 * np.log(9.0), abs=3 * DT)
    assert errors.settling_s == pytest.approx(0.05 * np.log(10.0), abs=3 * DT)
    assert errors.rise_interval is None  # one switch


@pytest.mark.parametrize("run", [np.full(3000, -0.01), np.full(3000, np.nan)], ids=["stays", "diverged"])
def test_a_switch_that_is_missed_has_no_times(run: np.ndarray) -> None:
    v = np.zeros((3000, 1))
    v[200:] = 3000.0
    errors = response_errors(np.where(T < 0.3, -0.01, 0.01), run, v, DT, WELLS, np.random.default_rng(0), plant=JOINT)
    assert (errors.switches, errors.followed, errors.rise_s, errors.settling_s) == (1, 0, None, None)


@pytest.mark.parametrize("fault", ["stays", "masked"])
def test_a_step_without_a_measured_switch_is_not_counted(fault: str) -> None:
    v = np.zeros((3000, 1))
    v[200:] = 3000.0
    measured = np.where(T < 0.3, -0.01, -0.012 if fault == "stays" else 0.01)
    if fault == "masked":
        measured[1000] = np.nan
    errors = response_errors(
        measured, np.where(T < 0.3, -0.01, 0.01), v, DT, WELLS, np.random.default_rng(0), plant=JOINT
    )
    assert (errors.switches, errors.followed) == (0, 0)
