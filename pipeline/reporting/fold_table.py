"""The table of a cross-validation: mean over folds with its interval, and nothing ranked inside its own noise."""

from collections.abc import Mapping, Sequence
from typing import Any

from pipeline.reporting.tables import BEST, HEADINGS, TIED

EXPLANATION = (
    "Free-run NRMSE in % of the range in all data, each stretch of a fold from its measured first state; a run that "
    "diverged counts as 100. Mean over folds [95 % interval, t-test corrected for shared training data]. * lowest, all "
    "others higher fold by fold; ≈ not told apart from the lowest."
)

_SIGNALS = {"nrmse": "q", "nrmse_qdot": "qdot", "nrmse_qddot": "qddot"}
_MARKS = {"lowest": BEST, "tied": TIED, "": ""}


def fold_table(summary: Sequence[Mapping[str, Any]]) -> tuple[list[str], list[list[str]]]:
    """Header and rows.

    Parameters
    ----------
    summary : sequence of records
        Per model: ``nrmse``, ``nrmse_qdot``, ``nrmse_qddot`` with ``_low``, ``_high`` and ``_rank``, the q errors of
        the ``folds``, ``well_agreement`` and how many folds ``diverged``.
    """
    header = ["model", *(f"{HEADINGS[s]} [%]" for s in _SIGNALS.values()), "wells [%]", "diverged", "q, fold by fold"]
    return header, [_row(record) for record in summary]


def _row(record: Mapping[str, Any]) -> list[str]:
    folds = " ".join("refused" if value is None else f"{100 * value:.2f}" for value in record["folds"])
    agreement = record["well_agreement"]
    wells = "–" if agreement is None else f"{100 * agreement:.1f}"
    return [record["model"], *(_cell(record, key) for key in _SIGNALS), wells, str(record["diverged"]), folds]


def _cell(record: Mapping[str, Any], key: str) -> str:
    if record[key] is None:
        return "–"
    low, high = record[f"{key}_low"], record[f"{key}_high"]
    band = "" if low is None else f" [{100 * low:.2f}, {100 * high:.2f}]"
    return f"{100 * record[key]:.2f}{band}{_MARKS[record[f'{key}_rank']]}"
