"""Short tables for people, with models as rows: errors on the worst validation log, and means over the folds."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from ..scoring.cross_validation import NRMSE_COLUMNS
from ..store.columns import SCORE_COLUMNS, Column
from ..units.units import ALPHA_UNIT
from .tables import BEST, HEADINGS, TIED, ScoreRow, notes_of, notes_on

_EXTRAS = tuple(column for column in SCORE_COLUMNS if column.cell and column.cell.table == "errors")
FOLD_EXPLANATION = (
    "Free-run NRMSE in % of the range in all data, each segment of a fold from its measured first state; a run that "
    "diverged counts as 100. Mean over folds [95 % interval, t-test corrected for shared training data]. * lowest, all "
    "others higher fold by fold; ≈ not told apart from the lowest."
)
_MARKS = {"lowest": BEST, "tied": TIED, "": ""}


@dataclass(frozen=True)
class MainTable:
    """The table as text: where the errors were measured, the headings, and a line of cells for each model."""

    where: str
    signals: tuple[str, ...]
    extras: tuple[Column, ...]
    rows: tuple[tuple[str, ...], ...]

    @property
    def heading(self) -> tuple[str, ...]:
        """The headings of its columns."""
        errors = (f"{HEADINGS[signal]} [%]" for signal in self.signals)
        return ("model", *errors, *(column.title for column in self.extras))

    @property
    def best(self) -> str:
        """The model with the lowest error of q; empty where no model has one."""
        errors = {row[0]: float(row[1]) for row in self.rows if row[1].replace(".", "", 1).isdigit()}
        return min(errors, key=lambda model: errors[model], default="")

    @property
    def explanation(self) -> str:
        """What its columns mean; that of errors is a line of its own."""
        errors = "NRMSE in % of the measured range, free run from the first sample, worst log."
        notes = [*notes_of(self.extras), *notes_on(row[0] for row in self.rows)]
        return "\n".join(part for part in (errors, " ".join(notes)) if part)


def main_table(scores: Sequence[ScoreRow]) -> MainTable:
    """The worst validation log of each model; the worst training log where there is no validation log.

    φ is computed from q, so its error repeats that of q: it is left out, as in the tables of the page.
    Shares of wells and pulses, and counts of basis functions, are left out where no model has any.

    Parameters
    ----------
    scores : sequence of records
        Rows of ``scores.parquet``, null as None.
    """
    role = "validation" if any(row["role"] == "validation" for row in scores) else "train"
    judged = [row for row in scores if row["role"] == role and row["signal"] != "phi"]
    extras = tuple(column for column in _EXTRAS if any(row.get(column.key) is not None for row in judged))
    signals = tuple(signal for signal in HEADINGS if any(row["signal"] == signal for row in judged))
    rows = []
    for model in dict.fromkeys(str(row["model"]) for row in judged):
        own = [row for row in judged if row["model"] == model]
        errors = [_worst([row["nrmse"] for row in own if row["signal"] == signal]) for signal in signals]
        of_q = [row for row in own if row["signal"] == "q"]
        if any(row["status"] != "ok" for row in of_q):
            errors[0] = "diverged"
        rows.append((model, *errors, *(_least(of_q, column) for column in extras)))
    logs = list(dict.fromkeys(str(row["log"]) for row in judged))
    named = f"log {logs[0]}" if len(logs) == 1 else f"logs {', '.join(logs)}"
    word = "validation" if role == "validation" else "training"
    return MainTable(f"free runs on the {word} {named}", signals, extras, tuple(rows))


def _worst(errors: Sequence[float | None]) -> str:
    defined = [error for error in errors if error is not None]
    return f"{100.0 * max(defined):.2f}" if defined and len(defined) == len(errors) else "–"


def _least(rows: Sequence[ScoreRow], column: Column) -> str:
    """The least value of a column over the logs, without decimals."""
    values = [row[column.key] for row in rows if row.get(column.key) is not None]
    if not values or column.cell is None:
        return "–"
    return f"{column.cell.factor * min(values):.0f}" + (" %" if column.cell.unit == "%" else "")


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
    low = record[f"{key}_low"]
    high = record[f"{key}_high"]
    band = "" if low is None else f" [{100 * low:.2f}, {100 * high:.2f}]"
    return f"{100 * record[key]:.2f}{band}{_MARKS[record[f'{key}_rank']]}"


def study_conclusion(
    name: str, columns: Mapping[str, Any], units: Mapping[str, str], notes: Mapping[str, Any]
) -> tuple[dict[str, Any], str]:
    """The columns of a study as they are printed, by their headings, and what follows of them, if anything does.

    Of each stream of `online` its end alone is left.

    Parameters
    ----------
    name : str
        The study.
    columns : mapping of str to array, each of shape (n,)
        Its table.
    units : mapping of str to str
        Units of the columns.
    notes : mapping
        Notes of the study.
    """
    if name == "online":
        return _online_conclusion(columns)
    shown = {f"{column} [{units[column]}]": values for column, values in columns.items()}
    if name != "alpha":
        return shown, ""
    chosen = notes["automatic_alpha"] / ALPHA_UNIT[units["misfit"]][1]
    return shown, (
        f"by the noise of {notes['log']}, alpha is {chosen:.3g} {units['alpha']}, without reweighting; "
        "`debist differentiate` prints the alpha of each log in use"
    )


_CONVERGED = 0.05
"""Error of the curve from which on a stream has converged."""


def _online_conclusion(columns: Mapping[str, Any]) -> tuple[dict[str, Any], str]:
    """A row for each stream: its errors at the end, and from when on its curve was as good as `_CONVERGED`."""
    rows = []
    for forgetting, drift in dict.fromkeys(zip(columns["forgetting"], columns["drift"], strict=True)):
        stream = (columns["forgetting"] == forgetting) & (columns["drift"] == drift)
        t = columns["t"][stream]
        curve = columns["curve_error"][stream]
        late = np.flatnonzero(~(curve <= _CONVERGED))  # NaN is no success
        since = t[0] if not late.size else t[late[-1] + 1] if late[-1] + 1 < t.size else np.nan
        rows.append((forgetting, drift, t[-1], since, curve[-1], columns["prediction_error"][stream][-1]))
    titles = ("forgetting", "drift", "stream [s]", "within 5 % from [s]", "curve error", "prediction error")
    texts = []
    for drift in dict.fromkeys(row[1] for row in rows):
        best = min((row for row in rows if row[1] == drift), key=lambda row: row[4])
        case = f"with a drift of {100.0 * drift:g} %" if drift else "without drift"
        texts.append(f"{case}, λ = {best[0]:g} follows the curve best: {100.0 * best[4]:.2g} % off at the end")
    return dict(zip(titles, zip(*rows, strict=True), strict=True)), "; ".join(texts)
