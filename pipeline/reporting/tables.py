"""The NRMSE table as records and as text: terminal, CSV, LaTeX, Markdown; nothing is ranked inside its own noise."""

import csv
import io
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Literal

Record = Mapping[str, Any]
Format = Literal["text", "csv", "latex", "markdown"]

SIGNALS = ("q", "phi", "qdot", "qddot")
HEADINGS = {"q": "q", "phi": "φ", "qdot": "q̇", "qddot": "q̈"}
LATEX_HEADINGS = {"q": "$q$", "phi": r"$\varphi$", "qdot": r"$\dot q$", "qddot": r"$\ddot q$"}

EXPLANATION = (
    "NRMSE in % of the measured range (eq. 41) of a free run from the first sample. Brackets: 95 % moving-block "
    "bootstrap (2 s blocks), the spread had other stretches been recorded. Best (marked) only where the interval lies "
    "below those of all other models of the log; a run that diverged has no error and no rank. "
    "Wells: share of samples in the right well. Switches: share of pulses after which both rest in the same well."
)


@dataclass(frozen=True)
class Cell:
    """One number of the table.

    Attributes
    ----------
    text : str
        As printed, e.g. ``2.31 [1.90, 2.84]``, ``undefined`` or ``diverged at t = 5.49 s``.
    best : bool
        Lowest of its log and signal, its interval apart from all others.
    """

    text: str
    best: bool = False


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


def nrmse_table(scores: Sequence[Record], times: Mapping[str, Record] | None = None) -> NrmseTable:
    """Table 2 of a run.

    Parameters
    ----------
    scores : sequence of records
        Rows of ``scores.parquet`` (null as None); `nrmse_low` and `nrmse_high` may be missing.
    times : mapping of model to record, optional
        ``fit_s`` and ``simulate_s``: processor time [s] of the fit and of one free run; either may be None.
    """
    signals = tuple(s for s in SIGNALS if any(r["signal"] == s for r in scores))
    groups: dict[tuple[str, str], dict[str, dict[str, Record]]] = {}
    for r in scores:
        groups.setdefault((r["role"], r["log"]), {}).setdefault(r["model"], {})[r["signal"]] = r
    rows = []
    for (role, log), models in groups.items():
        best = {s: separate_best({m: by[s] for m, by in models.items() if s in by}) for s in signals}
        for model, by_signal in models.items():
            cells = [_cell(by_signal.get(s), best[s] == model) for s in signals]
            cells += [Cell(_percent(by_signal["q"].get(key))) for key in ("well_agreement", "switch_accuracy")]
            if times is not None:
                cells += [Cell(_seconds(times.get(model, {}).get(key))) for key in ("fit_s", "simulate_s")]
            rows.append(Row(role, log, model, tuple(cells)))
    extras = ("wells", "switches") + (("fit [s]", "run [s]") if times is not None else ())
    return NrmseTable(signals, extras, tuple(rows))


def separate_best(by_model: Mapping[str, Record]) -> str | None:
    """The model whose NRMSE is lowest and whose interval lies wholly below those of all others, or None.

    Models that diverged are no competitors. A model without an interval, or a field of one, gives None: there is
    nothing to be apart from.
    """
    field = {m: r for m, r in by_model.items() if r["nrmse"] is not None}
    if len(field) < 2 or any(r.get("nrmse_high") is None or r.get("nrmse_low") is None for r in field.values()):
        return None
    first, *others = sorted(field, key=lambda m: float(field[m]["nrmse"]))
    apart = all(field[first]["nrmse_high"] < field[m]["nrmse_low"] for m in others)
    return first if apart else None


def _cell(record: Record | None, best: bool) -> Cell:
    if record is None:
        return Cell("–")
    if record["status"] == "diverged":
        return Cell(f"diverged at t = {record['diverged_at_s']:.2f} s")
    if record["nrmse"] is None:
        return Cell("undefined")
    low, high = record.get("nrmse_low"), record.get("nrmse_high")
    band = f" [{100 * low:.2f}, {100 * high:.2f}]" if low is not None and high is not None else ""
    return Cell(f"{100 * record['nrmse']:.2f}{band}", best)


def _percent(share: float | None) -> str:
    return "–" if share is None else f"{100 * share:.1f}"


def _seconds(value: float | None) -> str:
    return "–" if value is None else f"{value:.3g}"


def render(table: NrmseTable, form: Format) -> str:
    """The table as text of the given form, ending with a line break; CSV quotes and disarms formulas."""
    writers = {"text": _text, "csv": _csv, "latex": _latex, "markdown": _markdown}
    return writers[form](table)


def _lines(table: NrmseTable, mark: str) -> list[list[str]]:
    """Heading and rows as strings; `mark` wraps or follows the best ones through ``{}``."""
    heading = ["log", "model", *(f"{HEADINGS[s]} [%]" for s in table.signals)]
    heading += [f"{e} [%]" if "[" not in e else e for e in table.extras]
    rows = [
        [f"{r.role}/{r.log}", r.model, *(mark.format(c.text) if c.best else c.text for c in r.cells)]
        for r in table.rows
    ]
    return [heading, *rows]


def _text(table: NrmseTable) -> str:
    lines = _lines(table, "{} *")
    widths = [max(_width(line[k]) for line in lines) for k in range(len(lines[0]))]
    return "".join(
        "  ".join(cell + " " * (width - _width(cell)) for cell, width in zip(line, widths, strict=True)).rstrip() + "\n"
        for line in lines
    )


def _width(text: str) -> int:
    """Columns on a terminal: the combining dots over q take none."""
    return sum(not 0x300 <= ord(c) <= 0x36F for c in text)


def _csv(table: NrmseTable) -> str:
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    for line in _lines(table, "{}"):
        writer.writerow([f"'{cell}" if cell[:1] in ("=", "+", "-", "@", "\t", "\r") else cell for cell in line])
    return out.getvalue()


def _markdown(table: NrmseTable) -> str:
    heading, *rows = [[cell.replace("|", "\\|") for cell in line] for line in _lines(table, "**{}**")]
    rule = ["---", "---", *["---:"] * (len(heading) - 2)]
    return "".join("| " + " | ".join(line) + " |\n" for line in (heading, rule, *rows))


def _latex(table: NrmseTable) -> str:
    """A booktabs table, one block per log."""
    columns = "ll" + "r" * (len(table.signals) + len(table.extras))
    heading = ["log", "model", *(LATEX_HEADINGS[s] for s in table.signals), *map(_escape, table.extras)]
    body, last = [], ""
    for r in table.rows:
        place = f"{r.role}/{r.log}"
        if last and place != last:
            body.append(r"\midrule")
        cells = [rf"\textbf{{{_escape(c.text)}}}" if c.best else _escape(c.text) for c in r.cells]
        body.append(" & ".join([_escape(place) if place != last else "", _escape(r.model), *cells]) + r" \\")
        last = place
    head = [rf"\begin{{tabular}}{{{columns}}}", r"\toprule", " & ".join(heading) + r" \\", r"\midrule"]
    return "\n".join([*head, *body, r"\bottomrule", r"\end{tabular}"]) + "\n"


def _escape(text: str) -> str:
    special = {c: f"\\{c}" for c in "&%$#_{}"} | {"\\": r"\textbackslash{}", "~": r"\textasciitilde{}", "–": "--"}
    return "".join(special.get(c, c) for c in text.replace("^", ""))
