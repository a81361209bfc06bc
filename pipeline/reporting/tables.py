"""The NRMSE table as records and as text: terminal, CSV, LaTeX, Markdown; nothing is ranked inside its own noise."""

import csv
import io
import re
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any, Literal

from pipeline.names import log_title
from pipeline.scoring.horizons import SHORTEST_HORIZON, WARM_UP, WARM_UP_SAMPLES
from pipeline.scoring.intervals import BLOCK, FEWEST, FEWEST_BLOCKS, MEMORIES
from pipeline.scoring.step_responses import SETTLED
from pipeline.scoring.wells import SURE
from pipeline.si_prefix import moment
from pipeline.units import HORIZONS, SIGNALS

ScoreRow = Mapping[str, Any]
Form = Literal["latex", "markdown"]
Format = Literal["csv", "latex", "markdown"]

HEADINGS = {"q": "q", "phi": "φ", "qdot": "q̇", "qddot": "q̈"}
LATEX_HEADINGS = {"q": "$q$", "phi": r"$\varphi$", "qdot": r"$\dot q$", "qddot": r"$\ddot q$"}

_ERRORS = (
    "NRMSE in % of the measured range (eq. 41) of a free run from the first sample; a run that diverged has no error "
    "and no rank. Brackets: 95 % intervals, the spread had other stretches been recorded, by moving-block bootstrap "
    f"(blocks longer than errors hang together: {BLOCK:g} s or {MEMORIES} correlation times, and at most "
    f"1/{FEWEST_BLOCKS} of the log). * lowest of the log, all others higher in the paired bootstrap (both "
    "resampled at the same blocks); ≈ not told apart from the lowest, so no order among these."
)
_SOON, *_AHEAD = (words for _, words in HORIZONS.values())
_LISTED = f"{', '.join([_SOON, *_AHEAD[:-1]])} and {_AHEAD[-1]}"
_HORIZONS = (
    f"NRMSE of q after {_LISTED} (none of less than {SHORTEST_HORIZON:g} samples or more than the log) from restarts "
    f"in the measured state, hidden states from up to {WARM_UP:g} s or {WARM_UP_SAMPLES} samples of the measurement "
    "before"
)
_WELLS, _SWITCHES, _OUTSIDE, _AMBIGUOUS = "wells", "switches", "outside", "ambiguous [pulses]"
_RBFS = "RBFs [per curve]"
RBFS_EXPLANATION = "RBFs: basis functions that act; hybrid with 0 is its fitted equations alone."
_TIMES = ("rise [ms]", "settling [ms]")
_COLUMNS = {
    (_WELLS,): "Wells: share of samples in the measured well.",
    (_SWITCHES,): "Switches: share of pulses after which both rest in the same well, interval by Bayesian bootstrap of "
    "the pulses.",
    (_RBFS,): RBFS_EXPLANATION,
    _TIMES: f"Rise (10–90 %) and settling time (±{100.0 * SETTLED:.0f} %): median error over the switches that the "
    f"model follows, interval by bootstrap of the switches (none with fewer than {FEWEST}).",
    (_OUTSIDE,): "Outside: share of samples in states (q, q̇) that no training sample was near.",
    (_AMBIGUOUS,): "Ambiguous: pulses that end so close to the barrier that, among runs drawn from the model's own "
    f"uncertainty, fewer than {10.0 * SURE:.0f} in ten come to rest in one well.",
}
"""What columns mean that not every device has; one without a number in any row is left out with its sentence."""

TIED, BEST = " ≈", " *"


def _said(of: str, extras: Collection[str]) -> str:
    """What a table is `of`, and what its further columns mean."""
    return " ".join([of, *(text for names, text in _COLUMNS.items() if not set(names).isdisjoint(extras))])


EXPLANATION = _said(_ERRORS, (_WELLS, _SWITCHES, _RBFS))
BEHAVIOUR_EXPLANATION = _said(f"{_HORIZONS}, and of the free run.", (*_TIMES, _OUTSIDE, _AMBIGUOUS))


@dataclass(frozen=True)
class Cell:
    """One number of the table.

    Attributes
    ----------
    text : str
        As printed, e.g. ``2.31 [1.90, 2.84]``, ``undefined`` or ``diverged at t = 5.49 s``.
    best : bool
        Lowest of its log and signal, all others told apart from it.
    tied : bool
        Lowest, or not told apart from the lowest, with others.
    """

    text: str
    best: bool = False
    tied: bool = False


@dataclass(frozen=True)
class Row:
    """One model on one log."""

    role: str
    log: str
    model: str
    cells: tuple[Cell, ...]


@dataclass(frozen=True)
class NrmseTable:
    """Rows grouped by log, in the order of the records; `signals` head the first cells, `extras` the others."""

    signals: tuple[str, ...]
    extras: tuple[str, ...]
    rows: tuple[Row, ...]

    @property
    def explanation(self) -> str:
        """What its columns mean."""
        if self.signals:
            return _said(_ERRORS, self.extras)
        return _said(
            f"{_HORIZONS}, and of the free run." if "free run" in self.extras else f"{_HORIZONS}.", self.extras
        )

    def without_empty(self) -> "NrmseTable":
        """The same without columns, of those that not every device has, that no row has a number in."""
        first = len(self.signals)
        may_go = {name for names in _COLUMNS for name in names}
        kept = [
            k
            for k, name in enumerate(self.extras)
            if name not in may_go or any(row.cells[first + k].text != "–" for row in self.rows)
        ]
        rows = [replace(r, cells=(*r.cells[:first], *(r.cells[first + k] for k in kept))) for r in self.rows]
        return replace(self, extras=tuple(self.extras[k] for k in kept), rows=tuple(rows))


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
    groups: dict[tuple[str, str], dict[str, dict[str, ScoreRow]]] = {}
    for r in scores:
        groups.setdefault((r["role"], r["log"]), {}).setdefault(r["model"], {})[r["signal"]] = r
    rows = []
    for (role, log), models in groups.items():
        front = {s: leaders({m: by[s] for m, by in models.items() if s in by}) for s in signals}
        for model, by_signal in models.items():
            cells = [_cell(by_signal.get(s), model, front[s]) for s in signals]
            cells += [_share(by_signal["q"], key) for key in ("well_agreement", "switch_accuracy")]
            cells.append(Cell(basis_functions(by_signal["q"])))
            if times is not None:
                cells += [Cell(_seconds(times.get(model, {}).get(key))) for key in ("fit_s", "simulate_s")]
            rows.append(Row(role, log, model, tuple(cells)))
    extras = (_WELLS, _SWITCHES, _RBFS) + (("fit [s]", "run [s]") if times is not None else ())
    return NrmseTable(signals, extras, tuple(rows)).without_empty()


def behaviour_table(scores: Sequence[ScoreRow], *, free_run: bool = True) -> NrmseTable:
    """Errors by horizon and times of the switches, each with its interval; `scores` as in `nrmse_table`.

    The `free_run` is left out where another table beside has it.
    """
    rows = []
    for r in (r for r in scores if r["signal"] == "q"):
        steps = [_quantity(r, f"nrmse_{horizon}", 100.0) for horizon in HORIZONS]
        whole = [_cell(r, r["model"], set())] if free_run else []
        times = [_quantity(r, f"{name}_error", 1e3, "_s", digits=0) for name in ("rise", "settling")]
        trust = [_quantity(r, "outside_training", 100.0, digits=1), _ambiguous(r)]
        rows.append(Row(r["role"], r["log"], r["model"], (*steps, *whole, *times, *trust)))
    longest = ("free run",) if free_run else ()
    extras = (*(words for _, words in HORIZONS.values()), *longest, *_TIMES, _OUTSIDE, _AMBIGUOUS)
    return NrmseTable((), extras, tuple(rows)).without_empty()


def leaders(by_model: Mapping[str, ScoreRow]) -> set[str]:
    """The model of the lowest NRMSE and those that the log does not tell from it; one alone is the best.

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


def _cell(record: ScoreRow | None, model: str, front: set[str]) -> Cell:
    if record is None:
        return Cell("–")
    if record["status"] == "diverged":
        return Cell(f"diverged at t = {moment(record['diverged_at_s'])}")
    if record["nrmse"] is None:
        return Cell("undefined")
    text = _quantity(record, "nrmse", 100.0).text
    return Cell(text, best=front == {model}, tied=len(front) > 1 and model in front)


def _quantity(record: ScoreRow, key: str, factor: float, unit: str = "", digits: int = 2) -> Cell:
    """A number of a record with its interval, such as ``2.31 [1.90, 2.84]``."""
    value, low, high = (record.get(f"{key}{part}{unit}") for part in ("", "_low", "_high"))
    if value is None:
        return Cell("–")
    band = f" [{factor * low:.{digits}f}, {factor * high:.{digits}f}]" if low is not None and high is not None else ""
    return Cell(f"{factor * value:.{digits}f}{band}")


def _share(record: ScoreRow, key: str) -> Cell:
    return _quantity(record, key, 100.0, digits=1)


def basis_functions(record: ScoreRow) -> str:
    """How many basis functions act in each curve of a model; a dash for one that has none by its nature."""
    count = record.get("basis_functions")
    return "–" if count is None else str(count)


def _ambiguous(record: ScoreRow) -> Cell:
    """How many outcomes hinge on less than the model knows, such as ``2 of 14``."""
    count = record.get("outcomes")
    return Cell(f"{record['ambiguous_outcomes']} of {count}") if count else Cell("–")


def _seconds(value: float | None) -> str:
    return "–" if value is None else f"{value:.3g}"


def render(table: NrmseTable, form: Form) -> str:
    """The table as text of the given form, ending with a line break."""
    return (_latex if form == "latex" else _markdown)(table)


def lines(table: NrmseTable, best: str = f"{{}}{BEST}") -> list[list[str]]:
    """Heading and rows as strings; `best` wraps or follows the best ones through ``{}``."""
    heading = ["log", "model", *(f"{HEADINGS[s]} [%]" for s in table.signals), *map(with_unit, table.extras)]
    rows = [[log_title(r.role, r.log), r.model, *(_marked(c, best) for c in r.cells)] for r in table.rows]
    return [heading, *rows]


def with_unit(heading: str) -> str:
    """The heading with the unit of its numbers: per cent where it names none."""
    return heading if "[" in heading else f"{heading} [%]"


def _marked(cell: Cell, best: str) -> str:
    return best.format(cell.text) if cell.best else cell.text + TIED * cell.tied


def scores_csv(scores: Sequence[ScoreRow], times: Mapping[str, ScoreRow]) -> str:
    """Every number of the scores, one row per log, model and signal; SI units and fractions, empty where undefined.

    Formulas are disarmed: a spreadsheet would run a name that begins with =.
    """
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    names = [*scores[0], "fit_s", "simulate_s"]
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
    extras = [_escape(with_unit(extra)) for extra in table.extras]
    heading = ["log", "model", *(rf"{LATEX_HEADINGS[s]} [\%]" for s in table.signals), *extras]
    body, last = [], ""
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
