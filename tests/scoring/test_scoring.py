"""Scores of a free run: definitions, divergence, masks and where the wells are unknown."""

import numpy as np
import pytest

from pipeline.device.device import JOINT
from pipeline.numerics.metrics import nrmse
from pipeline.scoring.scores import Score, score_run
from pipeline.scoring.wells import Wells

DT = 0.01
T = DT * np.arange(2000)
Q = 0.01 * np.sign(np.sin(0.6 * T + 0.1)) + 0.001 * np.sin(17.0 * T)
V = np.where(np.sin(0.6 * T + 0.1)[:, None] * np.array([1.0, -1.0]) > 0.8, 3000.0, 0.0)
WELLS = Wells(-0.01, 0.01, 0.0)


def scored(calculated: np.ndarray, **changes: object) -> dict[str, Score]:
    settings: dict[str, object] = {"status": "ok", "diverged_at_s": None, "wells": WELLS, "plant": JOINT}
    rng = np.random.default_rng(0)
    rows = score_run(
        {"q": (Q, calculated), "qdot": (17 * Q, 17 * calculated)},
        V,
        DT,
        rng=rng,
        **(settings | changes),  # type: ignore[arg-type]
    )
    return {row.signal: row for row in rows}


def test_a_perfect_run() -> None:
    rows = scored(Q)
    assert rows["q"].nrmse == 0.0
    assert rows["q"].well_agreement == rows["q"].switch_accuracy == 1.0
    assert rows["q"].n == Q.size


def test_nrmse_lies_in_its_interval_and_is_that_of_eq_41() -> None:
    calculated = Q + 0.002 * np.random.default_rng(1).normal(size=Q.size)
    row = scored(calculated)["q"]
    assert row.nrmse == nrmse(Q, calculated)
    assert row.nrmse_interval is not None
    assert row.nrmse_interval.low < row.nrmse < row.nrmse_interval.high


def test_shares_carry_intervals_that_hold_them() -> None:
    lost = np.where(T > 9.0, -Q, Q)
    row = scored(lost)["q"]
    assert row.well_agreement_interval is not None and row.switch_accuracy_interval is not None
    assert row.well_agreement_interval.low < row.well_agreement < row.well_agreement_interval.high
    assert row.switch_accuracy_interval.low < row.switch_accuracy < row.switch_accuracy_interval.high


def test_a_diverged_run_is_not_flattered_by_the_part_before() -> None:
    calculated = Q.copy()
    calculated[1500:] = np.nan
    row = scored(calculated, status="diverged", diverged_at_s=15.0)["q"]
    assert (row.nrmse, row.rmse, row.nrmse_interval) == (None, None, None)
    assert (row.status, row.diverged_at_s, row.n) == ("diverged", 15.0, 1500)
    assert row.well_agreement == pytest.approx(0.75, abs=0.01)
