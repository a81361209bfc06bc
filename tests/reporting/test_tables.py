"""The NRMSE table: what is marked best, how divergence prints, and that no form lets text break out."""

import csv
import io
from typing import Any

import pytest

from pipeline.reporting.short_tables import fold_table, headline_table
from pipeline.reporting.tables import (
    BEHAVIOUR_EXPLANATION,
    EXPLANATION,
    NrmseTable,
    behaviour_table,
    leaders,
    nrmse_table,
    render,
    scores_csv,
)
from pipeline.scoring.intervals import FEWEST
from pipeline.scoring.step_responses import SETTLED
from pipeline.scoring.wells import SURE


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


def test_without_paired_intervals_nothing_is_ranked() -> None:
    assert set(marks(nrmse_table([record("rbf", 0.01), record("sindy", 0.5)])).values()) == {""}


def test_each_log_is_ranked_by_itself() -> None:
    rows = [
        record("rbf", 0.01), record("sindy", 0.02, 0.001),
        record("rbf", 0.02, 0.001, role="validation"), record("sindy", 0.01, role="validation"),
    ]  # fmt: skip
    table = nrmse_table(rows)
    assert [(r.role, r.model) for r in table.rows if r.cells[0].best] == [("train", "rbf"), ("validation", "sindy")]


def test_shares_stand_with_their_intervals() -> None:
    assert nrmse_table([record("rbf", 0.01)]).rows[0].cells[2].text == "100.0 [83.9, 100.0]"


def test_horizons_and_times_of_switches_stand_with_their_intervals() -> None:
    changes = {
        "nrmse_1s": 0.031, "nrmse_1s_low": 0.02, "nrmse_1s_high": 0.04, "nrmse_one_step": 1e-4,
        "rise_error_s": 0.004, "rise_error_low_s": 0.001, "rise_error_high_s": 0.01,
        "outside_training": 0.021, "outcomes": 14, "ambiguous_outcomes": 2,
    }  # fmt: skip
    table = behaviour_table([record("rbf", 0.05, **changes), record("rbf", 0.4, signal="qdot")])
    assert [cell.text for cell in table.rows[0].cells] == [
        "0.01", "–", "3.10 [2.00, 4.00]", "4 [1, 10]", "2.1", "2 of 14",
    ]  # fmt: skip
    assert "settling [ms]" not in [column.heading for column in table.extras]
    assert len(table.rows) == 1


def test_columns_of_wells_and_their_sentences_go_where_no_row_has_any() -> None:
    none = {key: None for key in record("rbf", 0.01) if key.startswith(("well_", "switch_"))}
    rows = [record("rbf", 0.01, **none), record("sindy", 0.02, **none)]
    for table in (nrmse_table(rows), behaviour_table(rows), headline_table(rows)):
        assert not any(word in table.explanation.lower() for word in ("well", "switch", "pulse", "rise", "ambiguous"))
    assert nrmse_table(rows).extras == ()
    assert headline_table(rows).heading == ("model", "q [%]")
    assert headline_table([rows[0], record("sindy", 0.02)]).heading == ("model", "q [%]", "wells", "switches")
    every = nrmse_table([rows[0], record("sindy", 0.02, basis_functions=3)])
    assert every.explanation == EXPLANATION
    assert [column.heading for column in every.extras] == ["wells [%]", "switches [%]", "RBFs [per curve]"]


def test_the_sentences_name_the_limits_that_the_scores_use() -> None:
    assert f"±{100.0 * SETTLED:.0f} %" in BEHAVIOUR_EXPLANATION
    assert f"fewer than {FEWEST})" in BEHAVIOUR_EXPLANATION
    assert f"fewer than {10.0 * SURE:.0f} in ten" in BEHAVIOUR_EXPLANATION


def test_how_many_basis_functions_act_stands_beside_the_errors() -> None:
    rows = [record("hybrid", 0.01, basis_functions=0), record("rbf", 0.02, basis_functions=12), record("sindy", 0.03)]
    short, long = headline_table(rows), nrmse_table(rows)
    assert [row[-1] for row in short.rows] == ["0", "12", "–"] == [row.cells[-1].text for row in long.rows]
    assert short.heading[-1] == "RBFs" and long.extras[-1].heading == "RBFs [per curve]"
    assert "equations alone" in short.explanation and "equations alone" in long.explanation
    assert "pysindy" not in short.explanation
    rows.append(record("sindy-default", 0.4))
    assert all("pysindy with its defaults" in table(rows).explanation for table in (headline_table, nrmse_table))


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


def test_times_stand_beside_the_errors() -> None:
    table = nrmse_table([record("rbf", 0.01)], times={"rbf": {"fit_s": 1.234, "simulate_s": None}})
    assert [cell.text for cell in table.rows[0].cells[-2:]] == ["1.23", "–"]


def test_folds_stand_in_percent_with_their_intervals_and_ranks() -> None:
    errors = {f"{key}{end}": value for key in ("nrmse", "nrmse_qdot", "nrmse_qddot") for end, value in
              (("", 0.0123), ("_low", 0.01), ("_high", 0.02), ("_rank", "tied"))}  # fmt: skip
    known = {"model": "narx", "well_agreement": 0.987, "diverged": 1, "folds": [0.01, None]}
    lost = {key: None for key in errors} | {"nrmse_rank": ""}
    header, (first, second) = fold_table([known | errors, known | lost | {"well_agreement": None}])
    assert header[0] == "model" and len(header) == len(first) == len(second)
    assert first == ["narx", *3 * ["1.23 [1.00, 2.00] ≈"], "98.7", "1", "1.00 refused"]
    assert second[1:5] == ["–"] * 4
