"""The NRMSE table as records and as text: terminal, CSV, LaTeX, Markdown; nothing is ranked inside its own noise."""

import csv
import io
import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any, Literal

from ..scoring.horizons import SHORTEST_HORIZON
from ..scoring.intervals import BLOCK, FEWEST_BLOCKS, MEMORIES
from ..store.columns import SCORE_COLUMNS, TIME_COLUMNS, Column
from ..system.names import log_title
from ..units.quantity import moment
from ..units.units import HORIZONS, SIGNALS

ScoreRow = Mapping[str, Any]
Form = Literal["latex", "markdown"]
Format = Literal["csv", "latex", "markdown"]

HEADINGS = {"q": "q", "phi": "φ", "qdot": "q̇", "qddot": "q̈"}
LATEX_HEADINGS = {"q": "$q$", "phi": r"$\varphi$", "qdot": r"$\dot q$", "qddot": r"$\ddot q$"}

_ERRORS = (
    "NRMSE in % of the measured range (eq. 41) of a free run from the first sample; a run that diverged has no error "
    "and no rank. Brackets: 95 % intervals, the spread had other segments been recorded, by moving-block bootstrap "
    f"(blocks longer than errors hang together: {BLOCK:g} s or {MEMORIES} correlation times, and at most "
    f"1/{FEWEST_BLOCKS} of the log). * lowest of the log, all others higher in the paired bootstrap (both "
    "resampled at the same blocks); ≈ not told apart from the lowest, so no order among these."
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


def notes_of(columns: Iterable[Column]) -> list[str]:
    """The sentences that explain these columns, each once."""
    return list(dict.fromkeys(column.cell.note for column in columns if column.cell and column.cell.note))


def notes_on(models: Iterable[str]) -> list[str]:
    """The sentences that explain rows of models that are no attempt at a good one."""
    return [_OF_ROWS[model] for model in dict.fromkeys(models) if model in _OF_ROWS]


def _columns(table: str, rows: Sequence[ScoreRow] | None = None) -> tuple[Column, ...]:
    """The columns of a table; with its rows, without those that not every device has and no row has a value of."""
    columns = (column for column in SCORE_COLUMNS if column.cell and column.cell.table == table)
    return tuple(
        column for column in columns
        if rows is None or not notes_of([column]) or any(row.get(column.key) is not None for row in rows)
    )  # fmt: skip


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
        Whether `number` is one, by which a table can be sorted.
    diverged : bool
        Whether it states when the free run diverged.
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
    """One model on one log."""

    role: str
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
        """What its columns mean."""
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
            rows.append(Row(role, log, model, (*errors, *(_cell(of_q, column) for column in extras))))
    return NrmseTable(signals, extras, tuple(rows))


def behaviour_table(scores: Sequence[ScoreRow]) -> NrmseTable:
    """Errors by horizon and times of the switches, each with its interval; `scores` as in `nrmse_table`."""
    of_q = [row for row in scores if row["signal"] == "q"]
    columns = _columns("behaviour", of_q)
    rows = (Row(r["role"], r["log"], r["model"], tuple(_cell(r, column) for column in columns)) for r in of_q)
    return NrmseTable((), columns, tuple(rows))


def leaders(by_model: Mapping[str, ScoreRow]) -> set[str]:
    """The model of the lowest NRMSE and those not significantly above it; one alone is the best.

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
    number = _number(record, "nrmse", 100.0, 2)
    return replace(number, best=front == {model}, tied=len(front) > 1 and model in front)


def _cell(record: ScoreRow, column: Column) -> TableCell:
    """A score as the tables print it, with its interval; a dash for none."""
    if column.cell is None:
        raise ValueError(f"the column {column.key} is not for tables that people read")
    if column.cell.out_of and record.get(column.key) is not None:
        return TableCell(f"{record[column.key]} of {record[column.cell.out_of]}")
    return _number(record, column.key, column.cell.factor, column.cell.digits)


def _number(record: ScoreRow, key: str, factor: float, digits: int | None) -> TableCell:
    name, unit = (key.removesuffix("_s"), "_s") if key.endswith("_s") else (key, "")
    value, low, high = (record.get(k) for k in (key, f"{name}_low{unit}", f"{name}_high{unit}"))
    if value is None:
        return TableCell("–")
    form = ".3g" if digits is None else f".{digits}f"
    band = f"[{factor * low:{form}}, {factor * high:{form}}]" if low is not None and high is not None else ""
    return TableCell(f"{factor * value:{form}}", band, is_number=True)


def render(table: NrmseTable, form: Form) -> str:
    """The table as text of the given form, ending with a line break."""
    return (_latex if form == "latex" else _markdown)(table)


def lines(table: NrmseTable, best: str = f"{{}}{BEST}") -> list[list[str]]:
    """Heading and rows as strings; `best` wraps or follows the best ones through ``{}``."""
    heading = [
        "log",
        "model",
        *(f"{HEADINGS[s]} [%]" for s in table.signals),
        *(column.heading for column in table.extras),
    ]
    rows = [[log_title(r.role, r.log), r.model, *(_marked(c, best) for c in r.cells)] for r in table.rows]
    return [heading, *rows]


def _marked(cell: TableCell, best: str) -> str:
    return best.format(cell.text) if cell.best else cell.text + TIED * cell.tied


def scores_csv(scores: Sequence[ScoreRow], times: Mapping[str, ScoreRow]) -> str:
    """Every number of the scores, one row per log, model and signal; SI units and fractions, empty where undefined.

    Formulas are disarmed: a spreadsheet would run a name that begins with =.
    """
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    names = [*scores[0], *(column.key for column in TIME_COLUMNS)]
    writer.writerow(map(disarmed, names))
    for score in scores:
        row = {**times.get(score["model"], {}), **score}
        writer.writerow([disarmed(row.get(name)) for name in names])
    return out.getvalue()


def disarmed(value: Any) -> Any:
    """A CSV cell that no spreadsheet takes for a formula."""
    if isinstance(value, str) and value.lstrip()[:1] in ("=", "+", "-", "@"):
        return f"'{value}"
    return "" if value is None else value


def _markdown(table: NrmseTable) -> str:
    heading, *rows = lines(table, "**{}**")
    rule = ["---", "---", *["---:"] * (len(heading) - 2)]
    named = [[*map(_in_markdown, line[:2]), *line[2:]] for line in rows]
    return "".join("| " + " | ".join(line) + " |\n" for line in (heading, rule, *named))


def _in_markdown(name: str) -> str:
    """A name without markup: no HTML, link, code, column or line break."""
    return re.sub(r"[\\`*_<>&|\[\]~!]", r"\\\g<0>", _one_line(name))


def _one_line(text: str) -> str:
    return "".join(c if c.isprintable() else " " for c in text)


def _latex(table: NrmseTable) -> str:
    """A booktabs table, one block per log."""
    columns = "ll" + "r" * (len(table.signals) + len(table.extras))
    extras = [_escape(column.heading) for column in table.extras]
    heading = ["log", "model", *(rf"{LATEX_HEADINGS[s]} [\%]" for s in table.signals), *extras]
    body = []
    last = ""
    for r in table.rows:
        place = log_title(r.role, r.log)
        if last and place != last:
            body.append(r"\midrule")
        cells = [rf"\textbf{{{_escape(c.text)}}}" if c.best else _escape(c.text + TIED * c.tied) for c in r.cells]
        body.append(" & ".join([_escape(place) if place != last else "", _escape(r.model), *cells]) + r" \\")
        last = place
    head = [rf"\begin{{tabular}}{{{columns}}}", r"\toprule", " & ".join(heading) + r" \\", r"\midrule"]
    return "\n".join([*head, *body, r"\bottomrule", r"\end{tabular}"]) + "\n"


def _escape(text: str) -> str:
    special = {c: f"\\{c}" for c in "&%$#_{}"} | {
        "\\": r"\textbackslash{}",
        "~": r"\textasciitilde{}",
        "–": "--",
        "≈": r"$\approx$",
    }
    return "".join(special.get(c, c) for c in _one_line(text.replace("^", "")))
