"""Advice on a validation log that has a larger error follows from what was measured."""

from dataclasses import replace
from typing import Any

import pytest

from pipeline.diagnostics.model_quality import instrument_findings, model_checks
from pipeline.diagnostics.sentences import sentences
from pipeline.scoring.wells import Wells
from pipeline.system.names import log_title
from tests.reporting.synthetic import WELL, run_data

WELLS = Wells(-WELL, WELL, 0.0)
LOG = log_title("validation", "other")


def _row(quantity: str, estimate: float, *, beyond: bool = True, **other: Any) -> dict[str, Any]:
    row = {
        "log": "other", "role": "validation", "model": "rbf", "quantity": quantity, "estimate": estimate,
        "standard_error": 1e-3 * abs(estimate), "correction": 1.0 - estimate, "limit": 1e-6, "beyond": beyond,
        "residual_ratio": 1.1, "exchanged": "none", "status": "measured",
    }  # fmt: skip
    return row | other


def test_instruments_are_findings_with_their_numbers() -> None:
    rows = (_row("gain_v1", -0.05), _row("zero_q", 3e-4), _row("clock", 0.01, beyond=False), _row("delay", 0.005))
    found = list(instrument_findings(replace(run_data(), instruments=rows), "rbf"))
    assert [(f.code, f.subject, f.log, f.severity) for f in found] == [
        ("instrument", quantity, LOG, "fair") for quantity in ("gain_v1", "zero_q", "delay")
    ]
    numbers = found[1].numbers["estimate"]
    assert (numbers.value, numbers.unit, numbers.error) == (3e-4, "m", pytest.approx(3e-7))
    assert not list(instrument_findings(replace(run_data(), instruments=rows), "hybrid"))


def test_findings_reach_the_assessment() -> None:
    rows = tuple(row | {"nrmse": 0.04 if row["role"] == "validation" else 0.002} for row in run_data().scores)
    data = replace(run_data(), scores=rows, instruments=(_row("gain_v2", 0.03),))
    checks = {check.name: check for check in model_checks(data, "rbf", None, WELLS)}
    assert checks["instrument"].about == "data" and checks["instrument"].subject == "gain_v2"
    assert "generalisation" not in checks


def test_two_training_logs_that_disagree_are_reported_without_blame() -> None:
    rows = [_row("gain_v1", sign * 0.02, role="train", log=log) for log, sign in (("a", 1.0), ("b", -1.0))]
    (found,) = instrument_findings(replace(run_data(), instruments=tuple(rows)), "rbf")
    assert (found.code, found.subject, found.numbers["estimate"].value) == ("disagreement", "gain_v1", 0.02)
    text, _ = sentences(found)
    assert "training log a" in text and "training log b" in text
