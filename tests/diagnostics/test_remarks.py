"""A remark on a log has its grade where it is made: no words of the log change it."""

from dataclasses import replace
from pathlib import Path

import pytest

from pipeline.diagnostics.data_quality import data_checks
from pipeline.scoring.wells import NoWells
from pipeline.settings.prototype import parse_prototype
from pipeline.workflow.si_log import read_si
from pipeline.workflow.steps.ingest import examined
from tests.reporting.synthetic import run_data


def _graded(tmp_path: Path, rows: list[str]) -> dict[str, str]:
    """The grade of each remark on a log of such rows, by its text."""
    path = tmp_path / "log.csv"
    path.write_text("\n".join(["time;q;u", *rows, ""]))
    channels = {name: {"channel": name, "unit": unit} for name, unit in (("time", "s"), ("q", "mm"))}
    channels["v1"] = {"channel": "u", "unit": "V"}
    prototype = parse_prototype({"name": "P", "logs": {"train": [path.name]}, "channels": channels}, "P.toml")
    notes = examined(read_si(path, prototype), prototype, "log")[1]
    data = run_data()
    log = replace(data.logs[0], record_notes={"raw_step": 0.01, **notes})
    checks = data_checks(replace(data, logs=(log,)), NoWells("not looked for"))
    return {check.statement.removeprefix(f"{log.title}: "): check.grade for check in checks if check.name == "remark"}


@pytest.mark.parametrize("text", ["kept by hand", "masked", "split there", "a clock of its own"])
def test_words_of_a_log_do_not_grade_a_remark(tmp_path: Path, text: str) -> None:
    rows = [f"{i / 100:.2f};{i % 7};{i % 5}" for i in range(400)]
    rows[200] = text
    grades = _graded(tmp_path, rows)
    assert [grade for remark, grade in grades.items() if "1 line left out" in remark and text in remark] == ["fair"]


def test_what_fits_leave_out_is_dealt_with(tmp_path: Path) -> None:
    rows = [f"{i / 100:.2f};{'nan' if i == 40 else i % 7};{i % 5}" for i in range(400)]
    grades = _graded(tmp_path, rows)
    assert [grade for remark, grade in grades.items() if "not finite" in remark] == ["good"]
