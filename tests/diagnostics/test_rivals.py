"""Which other model the assessment names where the main model is worse, or diverged."""

from dataclasses import replace
from typing import Any

from pipeline.diagnostics.grades import Check
from pipeline.diagnostics.model_quality import model_checks
from pipeline.scoring.wells import NoWells
from tests.reporting.synthetic import run_data


def _rival(**errors: float | None) -> list[Check]:
    """The finding on a rival where models have these NRMSE on the validation log; None where they diverged."""
    data = run_data()
    log = data.role("validation")[0]
    row: dict[str, Any] = {"log": log.name, "role": "validation", "signal": "q", "switch_accuracy": None}
    scores = [
        row | {"model": name, "nrmse": error, "status": "diverged" if error is None else "ok", "diverged_at_s": 5.0}
        for name, error in errors.items()
    ]
    checks = model_checks(replace(data, scores=tuple(scores)), "rbf", None, NoWells("not looked for"))
    return [check for check in checks if check.name == "rival"]


def test_a_headline_that_diverged_has_the_best_that_did_not_for_a_rival() -> None:
    (check,) = _rival(rbf=None, sindy=0.2, narx=0.078)
    assert check.statement == "narx predicts the validation log other with 7.80 %, where rbf diverged"
    assert check.grade == "poor" and "--model narx" in check.advice
