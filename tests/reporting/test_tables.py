"""The NRMSE table: what is marked best, how divergence prints, and that no form lets text break out."""

import csv
import io
from typing import Any

import pytest

from pipeline.reporting.tables import (
    NrmseTable,
    leaders,
    nrmse_table,
    render,
    scores_csv,
)


def record(model: str, nrmse: float | None, above: float | None = None, **changes: Any) -> dict[str, Any]:
    """A row of the scores; `above` is the lower end of the paired interval, None for the lowest."""
    band = (None, None) if nrmse is None else (nrmse - 0.001, nrmse + 0.001)
    plain = {
        "log": "a_log", "role": "train", "model": model, "signal": "q", "nrmse": nrmse, "status": "ok",
        "diverged_at_s": None, "nrmse_low": band[0], "nrmse_high": band[1], "above_lowest_low": above,
        "well_agreement": 0.9876, "switch_accuracy": 1.0, "switch_accuracy_low": 0.839, "switch_accuracy_high": 1.0,
    }  # fmt: skip
    return plain | changes


DIVERGED = record("sindy", None, status="diverged", diverged_at_s=5.494, well_agreement=0.1, switch_accuracy=0.0)


def marks(table: NrmseTable) -> dict[str, str]:
    return {row.model: "*" * row.cells[0].best + "≈" * row.cells[0].tied for row in table.rows}


def test_a_lead_that_the_log_tells_from_all_others_is_marked() -> None:
    rows = [record("rbf", 0.01), record("sindy", 0.02, 0.004), record("narx", 0.03, 0.01)]
    assert marks(nrmse_table(rows)) == {"rbf": "*", "sindy": "", "narx": ""}


def test_a_lead_inside_the_noise_makes_a_tie_and_no_best() -> None:
    rows = [record("rbf", 0.010), record("sindy", 0.011, -0.002), record("narx", 0.03, 0.01)]
    assert marks(nrmse_table(rows)) == {"rbf": "≈", "sindy": "≈", "narx": ""}
    assert "1.10 [1.00, 1.20] ≈" in render(nrmse_table(rows), "markdown")


def test_a_diverged_rival_is_no_competitor() -> None:
    assert leaders({"rbf": record("rbf", 0.01), "sindy": DIVERGED}) == set()
    assert leaders({"rbf": record("rbf", 0.01), "narx": record("narx", 0.05, 0.01), "sindy": DIVERGED}) == {"rbf"}


def test_each_log_is_ranked_by_itself() -> None:
    rows = [
        record("rbf", 0.01), record("sindy", 0.02, 0.001),
        record("rbf", 0.02, 0.001, role="validation"), record("sindy", 0.01, role="validation"),
    ]  # fmt: skip
    table = nrmse_table(rows)
    assert [(r.role, r.model) for r in table.rows if r.cells[0].best] == [("train", "rbf"), ("validation", "sindy")]


@pytest.mark.parametrize("form", ["latex", "markdown"])
def test_divergence_and_undefined_are_words_and_never_nan(form: Any) -> None:
    text = render(nrmse_table([DIVERGED, record("rbf", None)]), form)
    assert "diverged at t = 5.49 s" in text and "undefined" in text
    assert "nan" not in text.lower() and "None" not in text


def test_csv_reads_back_as_numbers_and_disarms_formulas() -> None:
    times = {'=cmd("x")': {"fit_s": 1.5, "simulate_s": None}}
    lines = list(csv.DictReader(io.StringIO(scores_csv([record('=cmd("x")', 0.0123), DIVERGED], times))))
    assert lines[0]["model"] == '\'=cmd("x")'
    assert [float(lines[0][key]) for key in ("nrmse", "nrmse_low", "fit_s")] == pytest.approx([0.0123, 0.0113, 1.5])
    assert lines[0]["simulate_s"] == lines[1]["nrmse"] == "" and lines[1]["status"] == "diverged"


def test_latex_and_markdown_escape_their_own_characters() -> None:
    rows = [record("m_1%", 0.01), record("a|b", 0.02, 0.001)]
    assert r"\textbf{1.00 [0.90, 1.10]}" in render(nrmse_table(rows), "latex")
    assert r"m\_1\%" in render(nrmse_table(rows), "latex")
    assert r"a\|b" in render(nrmse_table(rows), "markdown")
