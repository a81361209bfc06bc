"""The NRMSE table: what is marked best, and how divergence prints."""

from typing import Any

from pipeline.reporting.tables import NrmseTable, leaders, lines, main_table, nrmse_table


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
    assert lines(nrmse_table(rows))[2][2] == "1.10 [1.00, 1.20] ≈"


def test_a_diverged_rival_is_no_competitor() -> None:
    assert leaders({"rbf": record("rbf", 0.01), "sindy": DIVERGED}) == set()
    assert leaders({"rbf": record("rbf", 0.01), "narx": record("narx", 0.05, 0.01), "sindy": DIVERGED}) == {"rbf"}


def test_each_log_is_ranked_by_itself() -> None:
    rows = [
        record("rbf", 0.01), record("sindy", 0.02, 0.001),
        record("rbf", 0.02, 0.001, role="validation"), record("sindy", 0.01, role="validation"),
    ]  # fmt: skip
    table = nrmse_table(rows)
    best = [(row.log.split()[0], row.model) for row in table.rows if row.cells[0].best]
    assert best == [("training", "rbf"), ("validation", "sindy")]


def test_divergence_and_undefined_are_words_and_never_nan() -> None:
    text = "\n".join(" ".join(line) for line in lines(nrmse_table([DIVERGED, record("rbf", None)])))
    assert "diverged at t = 5.49 s" in text and "undefined" in text
    assert "nan" not in text.lower() and "None" not in text


def test_the_lowest_error_is_best_where_two_print_alike() -> None:
    rows = [record("rbf", 0.00652), record("narx", 0.00651), DIVERGED, record("arx", None)]
    table = main_table(rows)
    assert [row[:2] for row in table.rows] == [("rbf", "0.65"), ("narx", "0.65"), ("sindy", "diverged"), ("arx", "–")]
    assert table.best == "narx"
