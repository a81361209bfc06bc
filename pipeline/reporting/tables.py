"""Tables of scores and of a series of runs, as records and as text; nothing is ranked inside its own noise."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from ..numerics.metrics import NORMAL_95
from ..scoring.intervals import BLOCK, FEWEST_BLOCKS, MEMORIES
from ..scoring.scores import SHORTEST_HORIZON
from ..store.columns import SCORE_COLUMNS, TIME_COLUMNS, Column
from ..system.names import log_title
from ..units.quantity import moment, prefixed, quantity
from ..units.units import ALPHA_UNIT, HORIZONS, SIGNALS

if TYPE_CHECKING:
    from ..diagnostics.series import Series, SeriesFact

ScoreRow = Mapping[str, Any]

HEADINGS = {"q": "q", "phi": "φ", "qdot": "q̇", "qddot": "q̈"}

_ERRORS = (
    "NRMSE in % of the measured range (eq. 41) of a free run from the first sample; a run that diverged has no error "
    "and no rank. Brackets: 95 % intervals, the spread had other segments been recorded, by moving-block bootstrap "
    f"(blocks longer than errors hang together: {BLOCK:g} s or {MEMORIES} correlation times, and at most "
    f"1/{FEWEST_BLOCKS} of the log). * lowest of the log, all others higher in the paired bootstrap (both "
    "resampled at the same blocks); ≈ not distinguishable from the lowest: no order among these."
)
_SOON, *_AHEAD = (words for _, words in HORIZONS.values())
_LISTED = f"{', '.join([_SOON, *_AHEAD[:-1]])} and {_AHEAD[-1]}"
_HORIZONS = (
    f"NRMSE of q after {_LISTED} (none of less than {SHORTEST_HORIZON:g} samples or more than the log) from restarts "
    "in the measured state, hidden states from all of the measurement before (of the analytical models: at rest)."
)
TIED = " ≈"
BEST = " *"
_OF_ROWS = {
    "sindy-default": "sindy-default is pysindy with its defaults: quadratic terms, the strong form, no hidden state, "
    "no choice by free runs; sindy is the attempt at a good model."
}
_CONVERGED = 0.05
"""Largest error of the curve of a stream that has converged, over the range of the curve."""
SERIES_COLUMNS = ("fact", "first run", "last run", "from all runs", "change")
"""Headings of `series_rows`."""
_WIDE = 10.0
"""Standard errors by which the facts of one device hardly scatter: three simulated devices scatter by more."""


def notes_of(columns: Iterable[Column]) -> list[str]:
    """The sentences that explain these columns, each once."""
    return list(dict.fromkeys(column.cell.note for column in columns if column.cell and column.cell.note))


def notes_on(models: Iterable[str]) -> list[str]:
    """The sentences that explain rows of models that are no attempt at a good one."""
    return [_OF_ROWS[model] for model in dict.fromkeys(models) if model in _OF_ROWS]


def _columns(table: str, rows: Sequence[ScoreRow] | None = None) -> tuple[Column, ...]:
    """The columns of a table; given its rows, without optional columns that are empty."""
    columns = (column for column in SCORE_COLUMNS if column.cell and column.cell.table == table)
    return tuple(
        column
        for column in columns
        if rows is None or not notes_of([column]) or any(row.get(column.key) is not None for row in rows)
    )


@dataclass(frozen=True)
class TableCell:
    """One number of the table.

    Attributes
    ----------
    number : str
        As printed, e.g. ``2.31``, ``undefined`` or ``diverged at t = 5.49 s``.
    interval : str
        Its interval as printed, e.g. ``[1.90, 2.84]``; empty for none.
    is_number : bool
        True if `number` is one, by which a table can be sorted.
    diverged : bool
        True if it states when the free run diverged.
    best : bool
        Lowest of its log and signal, significantly lower than all others.
    tied : bool
        Lowest, or not significantly above the lowest, with others.
    """

    number: str
    interval: str = ""
    is_number: bool = False
    diverged: bool = False
    best: bool = False
    tied: bool = False

    @property
    def text(self) -> str:
        """Number and interval."""
        return f"{self.number} {self.interval}".rstrip()


@dataclass(frozen=True)
class Row:
    """One model on one log; `log` is its title."""

    log: str
    model: str
    cells: tuple[TableCell, ...]


@dataclass(frozen=True)
class NrmseTable:
    """Rows grouped by log, in the order of the records; `signals` head the first cells, `extras` the others."""

    signals: tuple[str, ...]
    extras: tuple[Column, ...]
    rows: tuple[Row, ...]

    @property
    def explanation(self) -> str:
        """Meaning of the columns."""
        notes = [*notes_of(self.extras), *notes_on(row.model for row in self.rows)]
        return " ".join([_ERRORS if self.signals else _HORIZONS, *notes])


def nrmse_table(scores: Sequence[ScoreRow], times: Mapping[str, ScoreRow] | None = None) -> NrmseTable:
    """Table 2 of a run.

    Parameters
    ----------
    scores : sequence of records
        Rows of ``scores.parquet`` (null as None); limits of intervals may be missing.
    times : mapping of model to record, optional
        ``fit_s`` and ``simulate_s``: processor time [s] of the fit and of one free run; either may be None.
    """
    signals = tuple(s for s in SIGNALS if any(r["signal"] == s for r in scores))
    extras = _columns("errors", scores) + (TIME_COLUMNS if times is not None else ())
    groups: dict[tuple[str, str], dict[str, dict[str, ScoreRow]]] = {}
    for r in scores:
        groups.setdefault((r["role"], r["log"]), {}).setdefault(r["model"], {})[r["signal"]] = r
    rows = []
    for (role, log), models in groups.items():
        front = {s: leaders({m: by[s] for m, by in models.items() if s in by}) for s in signals}
        for model, by_signal in models.items():
            of_q = {**by_signal["q"], **(times or {}).get(model, {})}
            errors = (_error(by_signal.get(s), model, front[s]) for s in signals)
            rows.append(Row(log_title(role, log), model, (*errors, *(_cell(of_q, column) for column in extras))))
    return NrmseTable(signals, extras, tuple(rows))


def behaviour_table(scores: Sequence[ScoreRow]) -> NrmseTable:
    """Errors by horizon and the notes of each run, with their intervals; `scores` as in `nrmse_table`."""
    of_q = [row for row in scores if row["signal"] == "q"]
    columns = _columns("behaviour", of_q)
    return NrmseTable(
        (),
        columns,
        tuple(
            Row(log_title(r["role"], r["log"]), r["model"], tuple(_cell(r, column) for column in columns)) for r in of_q
        ),
    )


def leaders(by_model: Mapping[str, ScoreRow]) -> set[str]:
    """The model of the lowest NRMSE, and all models not significantly above it; one alone is the best.

    Models that diverged are no competitors. Empty where there is nothing to be apart from: fewer than two models, or
    one without a paired interval (`above_lowest_low`), as in a record of less than three blocks.
    """
    field = {m: r for m, r in by_model.items() if r["nrmse"] is not None}
    if len(field) < 2:
        return set()
    lowest = min(field, key=lambda m: float(field[m]["nrmse"]))
    above = {m: r.get("above_lowest_low") for m, r in field.items() if m != lowest}
    if None in above.values():
        return set()
    return {lowest} | {m for m, low in above.items() if low is not None and low <= 0.0}


def _error(record: ScoreRow | None, model: str, front: set[str]) -> TableCell:
    if record is None:
        return TableCell("–")
    if record["status"] == "diverged":
        return TableCell(f"diverged at t = {moment(record['diverged_at_s'])}", diverged=True)
    if record["nrmse"] is None:
        return TableCell("undefined")
    return replace(_number(record, "nrmse", 100.0, 2), best=front == {model}, tied=len(front) > 1 and model in front)


def _cell(record: ScoreRow, column: Column) -> TableCell:
    """A score as the tables print it, with its interval; a dash for none."""
    if column.cell is None:
        raise ValueError(f"the column {column.key} is not for tables that people read")
    if column.cell.out_of and record.get(column.key) is not None:
        return TableCell(f"{record[column.key]} of {record[column.cell.out_of]}")
    return _number(record, column.key, column.cell.factor, column.cell.digits)


def _number(record: ScoreRow, key: str, factor: float, digits: int | None) -> TableCell:
    value, low, high = (record.get(name) for name in (key, f"{key}_low", f"{key}_high"))
    if value is None:
        return TableCell("–")
    form = ".3g" if digits is None else f".{digits}f"
    band = f"[{factor * low:{form}}, {factor * high:{form}}]" if low is not None and high is not None else ""
    return TableCell(f"{factor * value:{form}}", band, is_number=True)


def lines(table: NrmseTable) -> list[list[str]]:
    """Heading and rows as strings."""
    heading = [
        "log",
        "model",
        *(f"{HEADINGS[s]} [%]" for s in table.signals),
        *(column.heading for column in table.extras),
    ]
    return [
        heading,
        *(
            [row.log, row.model, *(cell.text + BEST * cell.best + TIED * cell.tied for cell in row.cells)]
            for row in table.rows
        ),
    ]


def disarmed(value: Any) -> Any:
    """A CSV cell that no spreadsheet takes for a formula."""
    if isinstance(value, str) and value.lstrip()[:1] in ("=", "+", "-", "@"):
        return f"'{value}"
    return "" if value is None else value


@dataclass(frozen=True)
class MainTable:
    """The table as text: the logs it is of, headings, a line of cells for each model, and an explanation.

    `best` is the model with the lowest error of q; empty where no model has one.
    """

    where: str
    heading: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]
    explanation: str
    best: str


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
    extras = tuple(column for column in _columns("errors") if any(row.get(column.key) is not None for row in judged))
    signals = tuple(signal for signal in HEADINGS if any(row["signal"] == signal for row in judged))
    rows = []
    errors_of_q: dict[str, float] = {}
    for model in dict.fromkeys(str(row["model"]) for row in judged):
        own = [row for row in judged if row["model"] == model]
        worst = [_worst([row["nrmse"] for row in own if row["signal"] == signal]) for signal in signals]
        cells = [prefixed(error, "%", 2) for error in worst]
        of_q = [row for row in own if row["signal"] == "q"]
        if any(row["status"] != "ok" for row in of_q):
            cells[0] = "diverged"
        elif worst[0] is not None:
            errors_of_q[model] = worst[0]
        rows.append((model, *cells, *(_least(of_q, column) for column in extras)))
    logs = list(dict.fromkeys(str(row["log"]) for row in judged))
    named = f"log {logs[0]}" if len(logs) == 1 else f"logs {', '.join(logs)}"
    word = "validation" if role == "validation" else "training"
    meaning = "NRMSE in % of the measured range, free run from the first sample, worst log."
    notes = " ".join([*notes_of(extras), *notes_on(row[0] for row in rows)])
    return MainTable(
        where=f"free runs on the {word} {named}",
        heading=("model", *(f"{HEADINGS[signal]} [%]" for signal in signals), *(column.title for column in extras)),
        rows=tuple(rows),
        explanation=f"{meaning}\n{notes}" if notes else meaning,
        best=min(errors_of_q, key=errors_of_q.__getitem__, default=""),
    )


def _worst(errors: Sequence[float | None]) -> float | None:
    """The largest of the errors; None where one is not defined, or where there is none."""
    defined = [error for error in errors if error is not None]
    return max(defined) if defined and len(defined) == len(errors) else None


def _least(rows: Sequence[ScoreRow], column: Column) -> str:
    """The least value of a column over the logs, without decimals."""
    values = [row[column.key] for row in rows if row.get(column.key) is not None]
    if not values or column.cell is None:
        return "–"
    return f"{column.cell.factor * min(values):.0f}" + (" %" if column.cell.unit == "%" else "")


def study_conclusion(
    name: str, columns: Mapping[str, Any], units: Mapping[str, str], notes: Mapping[str, Any]
) -> tuple[dict[str, Any], str]:
    """The columns of a study as they are printed, by their headings, and a conclusion, which may be empty.

    Of each stream of `online` only the end is printed.

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


def _online_conclusion(columns: Mapping[str, Any]) -> tuple[dict[str, Any], str]:
    """A row for each stream: its errors at the end, and the time after which its curve stayed within `_CONVERGED`."""
    rows = []
    for forgetting, drift in dict.fromkeys(zip(columns["forgetting"], columns["drift"], strict=True)):
        stream = (columns["forgetting"] == forgetting) & (columns["drift"] == drift)
        t = columns["t"][stream]
        curve = columns["curve_error"][stream]
        outside = np.flatnonzero(~(curve <= _CONVERGED))  # NaN is no success
        converged = outside[-1] + 1 if outside.size else 0
        rows.append(
            {
                "forgetting": forgetting,
                "drift": drift,
                "stream [s]": t[-1],
                "within 5 % from [s]": t[converged] if converged < t.size else np.nan,
                "curve error": curve[-1],
                "prediction error": columns["prediction_error"][stream][-1],
            }
        )
    texts = []
    for drift in dict.fromkeys(row["drift"] for row in rows):
        best = min((row for row in rows if row["drift"] == drift), key=lambda row: row["curve error"])
        case = f"with a drift of {100.0 * drift:g} %" if drift else "without drift"
        error = f"{100.0 * best['curve error']:.2g} % off at the end"
        texts.append(f"{case}, λ = {best['forgetting']:g} follows the curve best: {error}")
    return {title: tuple(row[title] for row in rows) for title in rows[0]}, "; ".join(texts)


def series_rows(series: "Series") -> list[tuple[str, ...]]:
    """A row of texts for each fact: first and last value, the last one from all runs, and the change."""
    return [
        (
            fact.title,
            *(_with_95(fact, fact.values[i], fact.errors[i]) for i in (0, -1)),
            _with_95(fact, fact.smooth[-1], fact.smooth_errors[-1]),
            _trend_text(fact, series.unit),
        )
        for fact in series.facts
    ]


def _trend_text(fact: "SeriesFact", unit: str) -> str:
    """Trend of a fact in words; `unit` is that of the time."""
    change = fact.trend
    if change.kind == "unknown" or change.slope is None:
        return f"{len(fact.at)} runs: too few"
    if change.kind == "step":
        step = quantity(change.step, fact.unit, change.step_error, float(np.abs(fact.values).max()))
        return f"step of {step} between {unit}s {change.after:g} and {change.before:g}"
    slope = quantity(change.slope, fact.unit, change.slope_error)
    return f"{slope} a {unit}" if change.kind == "line" else f"none shown ({slope} a {unit})"


def series_conclusion(series: "Series") -> str:
    """A sentence on the whole series."""
    if series.facts and all(fact.trend.kind == "unknown" for fact in series.facts):
        return f"{len(series.names)} runs: too few to show a drift; it takes four, a step six"
    changed = [fact.title for fact in series.facts if fact.trend.kind in ("line", "step")]
    scattered = [fact.title for fact in series.facts if fact.title not in changed and _scatter(fact) > _WIDE]
    text = f"changed: {', '.join(changed)}" if changed else "no fact changed by more than chance explains"
    doubt = f"; scattered by over {_WIDE:g} times their errors: {', '.join(scattered)}; are these runs of one device?"
    return text + (doubt if scattered else "")


def _scatter(fact: "SeriesFact") -> float:
    """RMS deviation from the weighted mean over the standard errors."""
    deviations = fact.values - np.average(fact.values, weights=fact.errors**-2.0)
    return float(np.sqrt(np.mean((deviations / fact.errors) ** 2)))


def _with_95(fact: "SeriesFact", value: float, error: float) -> str:
    return quantity(float(value), fact.unit, NORMAL_95 * float(error))
