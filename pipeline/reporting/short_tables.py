"""Short tables for people, with models as rows: errors on the worst validation log, and means over the folds."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from pipeline.reporting.tables import BEST, HEADINGS, RBFS_EXPLANATION, TIED, ScoreRow, basis_functions
from pipeline.scoring.cross_validation import NRMSE_COLUMNS

_SHARES = {"well_agreement": "well", "switch_accuracy": "pulses"}
_SHARES_SAID = {"well": "Well: share of time in the measured well.", "pulses": "Pulses: share that ends in it."}
FOLD_EXPLANATION = (
    "Free-run NRMSE in % of the range in all data, each stretch of a fold from its measured first state; a run that "
    "diverged counts as 100. Mean over folds [95 % interval, t-test corrected for shared training data]. * lowest, all "
    "others higher fold by fold; ≈ not told apart from the lowest."
)
_MARKS = {"lowest": BEST, "tied": TIED, "": ""}


@dataclass(frozen=True)
class Headline:
    """The table as text: where the errors were measured, the headings, and a line of cells for each model."""

    where: str
    heading: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]

    @property
    def explanation(self) -> str:
        """What its columns mean; that of errors is a line of its own."""
        errors = "NRMSE in % of the measured range, free run from the first sample, worst log."
        shares = " ".join(text for name, text in _SHARES_SAID.items() if name in self.heading)
        acting = RBFS_EXPLANATION if "RBFs" in self.heading else ""
        return "\n".join(line for line in (errors, shares, acting) if line)


def headline_table(scores: Sequence[ScoreRow]) -> Headline:
    """The worst validation log of each model; the worst training log where there is no validation log.

    Shares of wells and pulses, and counts of basis functions, are left out where no model has any.

    Parameters
    ----------
    scores : sequence of records
        Rows of ``scores.parquet``, null as None.
    """
    role = "validation" if any(row["role"] == "validation" for row in scores) else "train"
    judged = [row for row in scores if row["role"] == role]
    shares = [share for share in _SHARES if any(r.get(share) is not None for r in judged if r["signal"] == "q")]
    signals = tuple(signal for signal in HEADINGS if any(row["signal"] == signal for row in judged))
    acting = ["RBFs"] * any(row.get("basis_functions") is not None for row in judged)
    rows = []
    for model in dict.fromkeys(str(row["model"]) for row in judged):
        own = [row for row in judged if row["model"] == model]
        errors = [_worst([row["nrmse"] for row in own if row["signal"] == signal]) for signal in signals]
        of_q = [row for row in own if row["signal"] == "q"]
        if any(row["status"] != "ok" for row in of_q):
            errors[0] = "diverged"
        least = (_least([row.get(share) for row in of_q]) for share in shares)
        rows.append((model, *errors, *least, *(basis_functions(of_q[0]) for _ in acting)))
    logs = list(dict.fromkeys(str(row["log"]) for row in judged))
    named = f"log {logs[0]}" if len(logs) == 1 else f"logs {', '.join(logs)}"
    word = "validation" if role == "validation" else "training"
    errors_of = (f"{HEADINGS[signal]} [%]" for signal in signals)
    heading = ("model", *errors_of, *(_SHARES[share] for share in shares), *acting)
    return Headline(f"free runs on the {word} {named}", heading, tuple(rows))


def _worst(errors: Sequence[float | None]) -> str:
    known = [error for error in errors if error is not None]
    return f"{100.0 * max(known):.2f}" if known and len(known) == len(errors) else "–"


def _least(shares: Sequence[float | None]) -> str:
    known = [share for share in shares if share is not None]
    return f"{100.0 * min(known):.0f} %" if known else "–"


def fold_table(summary: Sequence[Mapping[str, Any]]) -> tuple[list[str], list[list[str]]]:
    """Header and rows.

    Parameters
    ----------
    summary : sequence of records
        Per model: ``nrmse``, ``nrmse_qdot``, ``nrmse_qddot`` with ``_low``, ``_high`` and ``_rank``, the q errors of
        the ``folds``, ``well_agreement`` and how many folds ``diverged``. Without wells their column is left out.
    """
    wells = any(record["well_agreement"] is not None for record in summary)
    errors = [f"{HEADINGS[s]} [%]" for s in NRMSE_COLUMNS.values()]
    header = ["model", *errors, *["wells [%]"] * wells, "diverged", "q, fold by fold"]
    return header, [_row(record, wells=wells) for record in summary]


def _row(record: Mapping[str, Any], *, wells: bool) -> list[str]:
    folds = " ".join("refused" if value is None else f"{100 * value:.2f}" for value in record["folds"])
    agreement = record["well_agreement"]
    share = ["–" if agreement is None else f"{100 * agreement:.1f}"] * wells
    return [record["model"], *(_cell(record, key) for key in NRMSE_COLUMNS), *share, str(record["diverged"]), folds]


def _cell(record: Mapping[str, Any], key: str) -> str:
    if record[key] is None:
        return "–"
    low, high = record[f"{key}_low"], record[f"{key}_high"]
    band = "" if low is None else f" [{100 * low:.2f}, {100 * high:.2f}]"
    return f"{100 * record[key]:.2f}{band}{_MARKS[record[f'{key}_rank']]}"
