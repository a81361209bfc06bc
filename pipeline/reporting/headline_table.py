"""The table that answers first: models as rows, the errors of q and its derivatives on the worst validation log."""

from collections.abc import Sequence
from dataclasses import dataclass

from pipeline.reporting.tables import HEADINGS, Record

_SHARES = {"well_agreement": "well", "switch_accuracy": "pulses"}
EXPLANATION = (
    "NRMSE in % of the measured range, free run from the first sample, worst log.\n"
    "Well: share of time in the measured well. Pulses: share that ends in it."
)


@dataclass(frozen=True)
class Headline:
    """The table as text: where the errors were measured, the headings, and a line of cells for each model."""

    where: str
    heading: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]


def headline_table(scores: Sequence[Record]) -> Headline:
    """The worst validation log of each model; the worst training log where there is no validation log.

    Parameters
    ----------
    scores : sequence of records
        Rows of ``scores.parquet``, null as None.
    """
    role = "validation" if any(row["role"] == "validation" for row in scores) else "train"
    judged = [row for row in scores if row["role"] == role]
    signals = tuple(signal for signal in HEADINGS if any(row["signal"] == signal for row in judged))
    rows = []
    for model in dict.fromkeys(str(row["model"]) for row in judged):
        own = [row for row in judged if row["model"] == model]
        errors = [_worst([row["nrmse"] for row in own if row["signal"] == signal]) for signal in signals]
        of_q = [row for row in own if row["signal"] == "q"]
        if any(row["status"] != "ok" for row in of_q):
            errors[0] = "diverged"
        rows.append((model, *errors, *(_least([row.get(share) for row in of_q]) for share in _SHARES)))
    logs = list(dict.fromkeys(str(row["log"]) for row in judged))
    named = f"log {logs[0]}" if len(logs) == 1 else f"logs {', '.join(logs)}"
    word = "validation" if role == "validation" else "training"
    heading = ("model", *(f"{HEADINGS[signal]} [%]" for signal in signals), *_SHARES.values())
    return Headline(f"free runs on the {word} {named}", heading, tuple(rows))


def _worst(errors: Sequence[float | None]) -> str:
    known = [error for error in errors if error is not None]
    return f"{100.0 * max(known):.2f}" if known and len(known) == len(errors) else "–"


def _least(shares: Sequence[float | None]) -> str:
    known = [share for share in shares if share is not None]
    return f"{100.0 * min(known):.0f} %" if known else "–"
