"""What the assessment says of rows that are no measurement, and of how to mend it."""

from dataclasses import replace

import numpy as np
import pytest

from pipeline.diagnostics.data_quality import data_checks
from pipeline.diagnostics.grades import Check
from pipeline.scoring.wells import NoWells
from tests.reporting.synthetic import run_data


def _masked(share: float, **notes: float) -> Check:
    data, logs = run_data(), []
    for number, log in enumerate(data.logs):
        valid = np.arange(len(log.motion.t)) >= share * len(log.motion.t)
        said = {"raw_step": 1e-4} | (notes if number else {})
        logs.append(replace(log, motion=replace(log.motion, valid=valid), record_notes=said))
    checks = data_checks(replace(data, logs=tuple(logs)), NoWells("not looked for"))
    return next(check for check in checks if check.name == "masked")


def test_what_masked_the_rows_is_named_with_its_advice() -> None:
    lost = _masked(0.12, masked_without_target=971, gaps=3)
    assert lost.statement == "12.0 % of the rows are masked, by 971 samples without a target"
    assert "target" in lost.advice and 'lost = "keep"' in lost.advice and "recorder" not in lost.advice
    rails = _masked(0.05, masked_at_rails=40, masked_spikes=1)
    assert rails.statement == "5.00 % of the rows are masked, by 40 samples at the ends of q's range and 1 spike"
    assert 'rails = "keep"' in rails.advice and "recorder" not in rails.advice
    gap = _masked(0.05, gaps_in_time=1, gaps=1)
    assert gap.statement.endswith("masked, by 1 gap in the recording") and "repair the recorder" in gap.advice
    assert "samples that are not finite" in _masked(0.05, gaps=1).statement


def test_what_was_cut_off_at_the_ends_of_a_log_is_masked_as_well() -> None:
    """6 s of 60 s are left in neither of two records of 30 s."""
    cut = _masked(0.0, masked_without_target=6000, cut_off_s=6.0)
    assert cut.grade == "fair"
    assert float(cut.statement.split(" %")[0]) == pytest.approx(100.0 * 6.0 / 66.0, abs=0.06)
