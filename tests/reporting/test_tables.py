"""The NRMSE table: what is marked best, how divergence prints, and that no form lets text break out."""

import csv
import io
from typing import Any

import pytest

from pipeline.reporting.tables import NrmseTable, nrmse_table, render, separate_best


def record(model: str, nrmse: float | None, spread: float = 0.001, **changes: Any) -> dict[str, Any]:
    band = (None, None) if nrmse is None else (nrmse - spread, nrmse + spread)
    plain = {
        "log": "a_log", "role": "train", "model": model, "signal": "q", "nrmse": nrmse, "status": "ok",
        "diverged_at_s": None, "nrmse_low": band[0], "nrmse_high": band[1],
        "well_agreement": 0.9876, "switch_accuracy": 1.0,
    }  # fmt: skip
    return plain | changes


DIVERGED = record("sindy", None, status="diverged", diverged_at_s=5.494, well_agreement=0.1, switch_accuracy=0.0)


def best(table: NrmseTable) -> set[str]:
    return {row.model for row in table.rows if row.cells[0].best}


def test_a_lead_beyond_the_intervals_is_marked() -> None:
    assert best(nrmse_table([record("rbf", 0.01), record("sindy", 0.02), record("narx", 0.03)])) == {"rbf"}


def test_a_lead_inside_the_noise_is_not() -> None:
    assert best(nrmse_table([record("rbf", 0.010, 0.006), record("sindy", 0.02, 0.006)])) == set()


def test_a_diverged_rival_is_no_competitor() -> None:
    assert separate_best({"rbf": record("rbf", 0.01), "sindy": DIVERGED}) is None
    assert separate_best({"rbf": record("rbf", 0.01), "narx": record("narx", 0.05), "sindy": DIVERGED}) == "rbf"


def test_without_intervals_nothing_is_ranked() -> None:
    rows = [record("rbf", 0.01), record("sindy", 0.5, nrmse_low=None, nrmse_high=None)]
    assert best(nrmse_table(rows)) == set()


def test_each_log_is_ranked_by_itself() -> None:
    rows = [
        record("rbf", 0.01), record("sindy", 0.02),
        record("rbf", 0.02, role="validation"), record("sindy", 0.01, role="validation"),
    ]  # fmt: skip
    table = nrmse_table(rows)
    assert [(r.role, r.model) for r in table.rows if r.cells[0].best] == [("train", "rbf"), ("validation", "sindy")]


@pytest.mark.parametrize("form", ["text", "csv", "latex", "markdown"])
def test_divergence_and_undefined_are_words_and_never_nan(form: Any) -> None:
    text = render(nrmse_table([DIVERGED, record("rbf", None)]), form)
    assert "diverged at t = 5.49 s" in text and "undefined" in text
    assert "nan" not in text.lower() and "None" not in text


def test_terminal_columns_line_up_under_combining_dots() -> None:
    rows = [record("rbf", 0.01), record("rbf", 0.02, signal="qdot"), record("rbf", 0.03, signal="qddot")]
    heading, line, _ = render(nrmse_table(rows), "text").split("\n")
    visible = "".join(c for c in heading if not 0x300 <= ord(c) <= 0x36F)
    assert visible.index("wells") == line.index("98.8")


def test_csv_reads_back_and_disarms_formulas() -> None:
    lines = list(csv.reader(io.StringIO(render(nrmse_table([record('=cmd("x")', 0.0123)]), "csv"))))
    assert lines[1][1] == '\'=cmd("x")'
    assert lines[1][2] == "1.23 [1.13, 1.33]"
    assert len(lines[0]) == len(lines[1])


def test_latex_and_markdown_escape_their_own_characters() -> None:
    rows = [record("m_1%", 0.01), record("a|b", 0.02)]
    assert r"\textbf{1.00 [0.90, 1.10]}" in render(nrmse_table(rows), "latex")
    assert r"m\_1\%" in render(nrmse_table(rows), "latex")
    assert r"a\|b" in render(nrmse_table(rows), "markdown")


def test_times_stand_beside_the_errors() -> None:
    table = nrmse_table([record("rbf", 0.01)], times={"rbf": {"fit_s": 1.234, "simulate_s": None}})
    assert [cell.text for cell in table.rows[0].cells[-2:]] == ["1.23", "–"]
