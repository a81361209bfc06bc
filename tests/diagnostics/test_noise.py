"""The noise that the report states, against noise that was added."""

from dataclasses import replace

import numpy as np
import pytest

from pipeline.diagnostics.data_quality import data_checks
from pipeline.diagnostics.run_data import LogData, RunData
from pipeline.scoring.wells import NoWells
from pipeline.signals.log import log_of
from tests.reporting.synthetic import run_data

SPAN, NOISE, INTERVAL = 0.02, 2e-6, 1e-3


def fast_run(raw_step: float) -> RunData:
    """A log whose motion takes five samples a period, and a free run that misses slow drifts only."""
    t = INTERVAL * np.arange(20_000)
    motion = 0.5 * SPAN * np.sin(2.0 * np.pi * t / (5.3 * INTERVAL))
    q = motion + NOISE * np.random.default_rng(5).standard_normal(t.size)
    columns = {"t": t, "q": q, "v1": np.sin(t), "v2": np.zeros(t.size), "segment": np.zeros(t.size, dtype=np.int32)}
    free = {"t": t, "q": motion + 1e-4 * np.sin(2.0 * t), "qdot": 0.0 * t, "qddot": 0.0 * t}
    log = LogData(
        "train", "fast", "fast.csv", columns, log_of({**columns, "qdot": 0.0 * t, "qddot": 0.0 * t}), {"rbf": free},
        {"rbf": {"status": "ok", "diverged_at_s": None}}, {"raw_step": raw_step}, {},
    )  # fmt: skip
    return replace(run_data(), logs=(log,))


def noise_share(data: RunData) -> float:
    """What the check of the noise says, a share of the range."""
    check = next(check for check in data_checks(data, NoWells("moves all the time")) if check.name == "noise")
    return float(check.statement.split("RMS, ")[1].split(" %")[0]) / 100.0


def test_fast_motion_is_not_taken_for_noise_where_a_model_follows_it():
    assert noise_share(fast_run(INTERVAL)) == pytest.approx(NOISE / SPAN, rel=0.1)


def test_noise_that_decimation_took_away_is_not_denied():
    assert noise_share(fast_run(0.1 * INTERVAL)) > 10.0 * NOISE / SPAN
