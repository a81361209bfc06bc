"""The table of instruments: what it advises can be pasted, on top of what stands there, and makes the readings true."""

import tomllib
from typing import Any

import pytest

from pipeline.reporting.instrument_table import entry, instrument_table
from pipeline.settings.logs import LogPart
from pipeline.settings.prototype import parse_prototype
from pipeline.workflow.run_contents import corrections

VALUES = {"gain_v1": 1.0530, "zero_q": -3.2e-4, "gain_q": 0.98042, "delay": -2.54e-3, "clock": 0.99003}


def _rows(*beyond: str, **other: Any) -> list[dict[str, Any]]:
    row = {
        "log": "long", "role": "validation", "model": "hybrid", "estimate": 0.02, "standard_error": 1e-3,
        "limit": 5e-3, "residual_ratio": 1.2, "exchanged": "none", "status": "measured",
    }  # fmt: skip
    return [{**row, "quantity": q, "correction": x, "beyond": q in beyond, **other} for q, x in VALUES.items()]


def test_the_entry_is_a_line_of_settings_with_these_corrections() -> None:
    part = LogPart.model_validate({"file": '2"/long.mat', "stop": "9 s", "gain": {"v2": 1.02}, "delay": "1 ms"})
    log = tomllib.loads(f"log = {entry(part, _rows(*VALUES), 'm')}")["log"]
    channels = {name: {"channel": name, "unit": "mm" if name == "q" else "kV"} for name in ("q", "v1", "v2")}
    document = {"name": "P", "logs": {"train": ["train.mat"], "validation": [log]}, "channels": channels}
    by = list(corrections(parse_prototype(document, "P.toml")).values())[1]
    assert by.gains == (1.053, 1.02)
    assert (by.zero, by.gain_q, by.delay, by.clock) == pytest.approx((-3.2e-4, 0.98042, -2.54e-3, 0.99003))
    assert (log["file"], log["stop"]) == (part.file, "9 s")


def test_what_is_not_beyond_its_limit_stays_as_it_stands() -> None:
    part = LogPart.model_validate({"file": "long.mat", "zero": "0.1 mm"})
    assert entry(part, _rows("clock"), "m") == '{ file = "long.mat", zero = "0.1 mm", clock = 0.99003 }'


def test_corrections_that_cancel_are_not_written() -> None:
    part = LogPart.model_validate({"file": "long.mat", "gain": {"q": 1.05}, "zero": "0.1 mm", "clock": 1.01})
    unity = [{**row, "correction": 0.0 if row["quantity"] == "zero_q" else 1.0} for row in _rows(*VALUES)]
    rows = [row for row in unity if row["quantity"] != "delay"]
    assert entry(part, rows, "m") == '{ file = "long.mat" }'


@pytest.mark.parametrize(
    ("rows", "words"),
    [
        (_rows("gain_v1", "clock"), [("gain of v1",), ("clock",)]),
        (_rows("gain_v1", status="another device"), [("another device",)]),
        (_rows(exchanged="both"), [("v1 and v2 exchanged, q mirrored",)]),
        (_rows(), []),
    ],
)
def test_only_what_is_off_has_a_line(rows: list[dict[str, Any]], words: list[tuple[str]]) -> None:
    table = instrument_table(rows, {("validation", "long"): LogPart(file="long.mat")}, "m")
    assert [line[1:2] for line in table.rows] == words
    assert table.explanation.startswith("Errors are relative" if words else "Instruments: no reading is off")


@pytest.mark.parametrize(
    ("other", "advised"),
    [
        ({}, ['{ file = "long.mat", clock = 0.99003 }']),
        ({"exchanged": "inputs"}, []),
        ({"status": "another device"}, []),
    ],
)
def test_a_log_as_it_was_wired_has_its_line_of_settings(other: dict[str, str], advised: list[str]) -> None:
    table = instrument_table(_rows("clock", **other), {("validation", "long"): LogPart(file="long.mat")}, "m")
    assert list(table.entries) == advised


def test_of_training_logs_that_differ_one_is_to_be_corrected() -> None:
    logs = [_rows("clock", role="train", log=log) for log in ("first", "second")]
    parts = {("train", log): LogPart(file=f"{log}.mat") for log in ("first", "second")}
    table = instrument_table([*logs[0], *logs[1]], parts, "m")
    assert "correct one of them" in table.explanation
