"""Advice on a validation log that has a larger error follows from what was measured."""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from pipeline.device_facts.causes import causes, instrument_findings
from pipeline.device_facts.model_quality import model_checks
from pipeline.device_facts.run_data import RunData
from pipeline.diagnostics.findings import Finding, worst
from pipeline.diagnostics.sentences import CODES, sentences
from pipeline.names import log_title
from pipeline.scoring.wells import NoWells, Wells, snaps
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


def _worst(data: RunData, **changes: Any) -> dict[str, Any]:
    (row,) = (s for s in data.scores if s["role"] == "validation" and s["model"] == "rbf")
    return {**row, **changes}


def test_instruments_are_findings_with_their_numbers() -> None:
    rows = (_row("gain_v1", -0.05), _row("zero_q", 3e-4), _row("clock", 0.01, beyond=False), _row("delay", 0.005))
    found = instrument_findings(replace(run_data(), instruments=rows), "rbf")
    assert [(f.code, f.subject, f.log, f.severity) for f in found] == [
        ("instrument", quantity, LOG, "fair") for quantity in ("gain_v1", "zero_q", "delay")
    ]
    numbers = found[1].numbers["estimate"]
    assert (numbers.value, numbers.unit, numbers.error) == (3e-4, "m", pytest.approx(3e-7))
    assert not instrument_findings(replace(run_data(), instruments=rows), "hybrid")


def test_of_another_device_no_instrument_is_advised() -> None:
    rows = (_row("gain_v1", -0.26, status="another device", residual_ratio=9.0), _row("clock", -0.18))
    (found,) = instrument_findings(replace(run_data(), instruments=rows), "rbf")
    assert (found.code, found.severity, found.numbers["residual_ratio"].value) == ("another_device", "poor", 9.0)


@pytest.mark.parametrize(
    ("instruments", "outside", "codes"),
    [
        ((), 0.0, ["generalisation"]),
        ((_row("gain_v1", -0.05),), 0.0, []),
        ((_row("gain_v1", -0.05, status="another device"),), 0.0, []),
        ((), 0.2, []),
    ],
)
def test_the_ratio_alone_is_told_where_nothing_else_was_measured(instruments, outside, codes) -> None:
    data = replace(run_data(), instruments=instruments)
    found = causes(data, _worst(data, outside_training=outside), 20.0, WELLS)
    assert [finding.code for finding in found] == codes


def test_fewer_basis_functions_are_advised_where_they_act() -> None:
    data = run_data()
    for model, fewer in (("rbf-paper", True), ("rbf", False), ("hybrid", False)):
        (found,) = causes(data, _worst(data, model=model), 20.0, NoWells("none"))
        assert ("basis functions" in sentences(found)[1]) == fewer


def test_one_passage_over_the_barrier_is_named_with_its_time() -> None:
    data = run_data()
    log = data.role("validation")[0]
    q = log.kinematics["q"]
    row = int(snaps(q, WELLS)[-1])
    late = log.predictions["rbf"]["q"].copy()
    late[row : row + 40] = q[row - 1]
    changed = replace(log, predictions={**log.predictions, "rbf": {**log.predictions["rbf"], "q": late}})
    (found,) = causes(replace(data, logs=(data.logs[0], changed)), _worst(data), 20.0, WELLS)
    assert found.code == "one_passage" and found.numbers["share"].value > 0.8
    assert found.numbers["time"].value == pytest.approx(float(log.kinematics["t"][row]), abs=0.5)
    everywhere = {**log.predictions["rbf"], "q": q + 1e-3 * np.sin(log.kinematics["t"])}
    changed = replace(log, predictions={"rbf": everywhere})
    (found,) = causes(replace(data, logs=(data.logs[0], changed)), _worst(data), 20.0, WELLS)
    assert found.code == "generalisation"


def test_findings_reach_the_assessment() -> None:
    rows = tuple(row | {"nrmse": 0.04 if row["role"] == "validation" else 0.002} for row in run_data().scores)
    data = replace(run_data(), scores=rows, instruments=(_row("gain_v2", 0.03),))
    checks = {check.name: check for check in model_checks(data, "rbf", None, WELLS)}
    assert checks["instrument"].about == "data" and checks["instrument"].subject == "gain_v2"
    assert "generalisation" not in checks


def test_every_code_has_sentences_and_the_worst_counts() -> None:
    for exchanged in ("inputs", "sign", "both"):
        statement, advice = sentences(Finding("exchanged", "poor", LOG, exchanged))
        assert LOG in statement and advice
    assert {"instrument", "another_device", "generalisation", "one_passage", "outside", "exchanged"} <= CODES.keys()
    assert worst([]) == "good" and worst([Finding("a", "fair"), Finding("b", "poor")]) == "poor"


def test_two_training_logs_that_disagree_are_reported_without_blame() -> None:
    rows = [_row("gain_v1", sign * 0.02, role="train", log=log) for log, sign in (("a", 1.0), ("b", -1.0))]
    (found,) = instrument_findings(replace(run_data(), instruments=tuple(rows)), "rbf")
    assert (found.code, found.subject, found.numbers["estimate"].value) == ("disagreement", "gain_v1", 0.02)
    text, _ = sentences(found)
    assert "training log a" in text and "training log b" in text
