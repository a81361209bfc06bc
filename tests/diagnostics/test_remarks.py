"""A remark on a log has its grade where it is made: no words of the log change it. A refusal names open remarks."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from pipeline.diagnostics.data_quality import data_checks
from pipeline.errors import DataRefusedError
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


def test_a_start_that_one_channel_of_tdms_restates_is_named_where_the_others_are_missing(tmp_path: Path) -> None:
    import nptdms

    path = tmp_path / "log.tdms"
    first = {"wf_increment": 0.01, "wf_start_time": np.datetime64("2024-05-12T10:00:00")}
    later = {"wf_start_time": np.datetime64("2024-05-12T10:00:40")}
    t = np.arange(600) / 100.0
    with nptdms.TdmsWriter(path) as writer:
        for of_q, of_v in ((first, first), (later, {})):
            q = nptdms.ChannelObject("rig", "q", np.sin(3.0 * t), of_q)
            writer.write_segment([q, nptdms.ChannelObject("rig", "v", np.cos(t), of_v)])
    channels = {"q": {"channel": "q", "unit": "mm"}, "v1": {"channel": "v", "unit": "kV"}}
    prototype = parse_prototype({"name": "P", "logs": {"train": [path.name]}, "channels": channels}, "P.toml")
    with pytest.raises(DataRefusedError, match=r"v1 is missing .*'q' begins anew at 40 s, by the wf_start_time"):
        examined(read_si(path, prototype), prototype, "log")
