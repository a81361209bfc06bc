"""Errors of the logs' instruments for readers: a table of those beyond their limit, and a figure of all."""

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from ..diagnostics.sentences import READINGS, correction_text, shown, unit_of
from ..settings.logs import LogPart
from ..signals.findings import Number
from ..system.names import log_title
from .figure import Band, Figure, Line, Panel, Points

Row = Mapping[str, Any]
Parts = Mapping[tuple[str, str], LogPart]

_ROOM = 0.1  # rows, above and below
RELATIVE = "Errors are relative to the training logs: where one of those is wrong, correct it instead."


@dataclass(frozen=True)
class InstrumentTable:
    """Instruments beyond their limit.

    Attributes
    ----------
    rows : tuple of tuple of str
        Lines of the table; none where all is quiet.
    explanation : str
        The sentence below them.
    entries : tuple of str
        Lines of settings to write in [logs], one for each log that is off.
    """

    rows: tuple[tuple[str, ...], ...]
    explanation: str
    entries: tuple[str, ...] = ()

    heading = ("log", "instrument", "reads too much by", "limit")


def instrument_table(rows: Sequence[Row], parts: Parts, displacement: str) -> InstrumentTable:
    """The table of a run.

    Parameters
    ----------
    rows : sequence of records
        Rows of ``instruments.parquet``; shown are those of the model that comes first.
    parts : mapping of (role, name) to LogPart
        Settings of each log.
    displacement : str
        SI unit of q.
    """
    rows = main_rows(rows)
    logs = list(dict.fromkeys((row["role"], row["log"]) for row in rows))
    lines = list[tuple[str, ...]]()
    entries = list[str]()
    for log in logs:
        own = [row for row in rows if (row["role"], row["log"]) == log]
        lines += _log_lines(own, log_title(*log), displacement)
        as_wired = (own[0]["status"], own[0]["exchanged"]) == ("measured", "none")
        if as_wired and any(row["beyond"] for row in own):
            entries.append(entry(parts[log], own, displacement))
    if not logs:
        return InstrumentTable((), "Instruments: there is no second log to compare with a training log.")
    if not lines:
        quantities = len({row["quantity"] for row in rows})  # the first log has them all
        limits = ", ".join(f"{_name(r)} {_shown(r, 'limit', displacement)}" for r in rows[:quantities])
        return InstrumentTable((), f"Instruments: no reading is off by more than its limit ({limits}).")
    differing = {row["log"] for row in rows if row["role"] == "train" and row["beyond"]}
    one_of_them = " Training logs differ: correct one of them, the farthest off, and run again."
    return InstrumentTable(tuple(lines), RELATIVE + one_of_them * (len(differing) > 1), tuple(entries))


def _name(row: Row) -> str:
    return READINGS.get(row["quantity"], str(row["quantity"]))


def main_rows(rows: Sequence[Row]) -> list[Row]:
    """The rows of the model that comes first."""
    return [row for row in rows if row["model"] == rows[0]["model"]]


def _log_lines(rows: Sequence[Row], title: str, displacement: str) -> list[tuple[str, ...]]:
    """Lines of one log; the first one names it."""
    first = rows[0]
    if first["status"] == "another device":
        return [(title, "another device", f"{first['residual_ratio']:.2g} times what the training logs leave", "")]
    if first["status"] == "not measured":
        return [(title, "not measured", "the model does not follow the log", "")]
    lines = list[tuple[str, ...]]()
    if first["exchanged"] != "none":
        words = {"inputs": "v1 and v2 exchanged", "sign": "q mirrored", "both": "v1 and v2 exchanged, q mirrored"}
        lines.append((title, words[first["exchanged"]], "", ""))
    for row in rows:
        if row["beyond"]:
            lines.append(
                (
                    title,
                    _name(row),
                    _shown(row, "estimate", displacement, row["standard_error"]),
                    _shown(row, "limit", displacement),
                )
            )
            title = ""
    return lines


def _shown(row: Row, key: str, displacement: str, error: float | None = None) -> str:
    return shown(Number(row[key], unit_of(row["quantity"], displacement), error))


def entry(part: LogPart, rows: Sequence[Row], displacement: str) -> str:
    """Corrected entry of the log for [logs]: the present one, with the corrections of instruments beyond limits."""
    texts = {
        row["quantity"]: correction_text(row["correction"], unit_of(row["quantity"], displacement))
        for row in rows
        if row["beyond"]
    }
    gains = {name: f"{gain:g}" for name, gain in part.gain if gain != 1.0}
    gains |= {name.removeprefix("gain_"): text for name, text in texts.items() if name.startswith("gain_")}
    gains = {name: gain for name, gain in gains.items() if float(gain) != 1.0}  # corrections that cancel say nothing
    usual = LogPart(file=part.file)
    stated = {key: f'"{getattr(part, key)}"' for key in ("start", "stop") if getattr(part, key) is not None}
    if gains:
        stated["gain"] = f"{{ {', '.join(f'{name} = {gain}' for name, gain in sorted(gains.items()))} }}"
    for key, name in (("zero", "zero_q"), ("delay", "delay")):
        text = texts.get(name, getattr(part, key))
        if float(text.split()[0]) if name in texts else text != getattr(usual, key):
            stated[key] = f'"{text}"'
    clock = texts.get("clock", f"{part.clock:g}")
    if float(clock) != 1.0:
        stated["clock"] = clock
    stated = {"file": json.dumps(part.file, ensure_ascii=False)} | stated
    return f"{{ {', '.join(f'{key} = {text}' for key, text in stated.items())} }}"


def instruments_figure(rows: Sequence[Row]) -> Figure | None:
    """Errors of all logs in units of their limits, a line for each quantity; None where nothing was measured."""
    from ..diagnostics.instruments import SIGNIFICANCE

    measured = [row for row in main_rows(rows) if row["status"] == "measured"] if rows else []
    if not measured:
        return None
    names = list(dict.fromkeys(_name(row) for row in reversed(measured)))
    logs = list(dict.fromkeys((row["role"], row["log"]) for row in reversed(measured)))
    of_log = dict(zip(logs, np.linspace(-0.5, 0.5, len(logs) + 2)[1:-1].tolist(), strict=True))
    y = np.array([names.index(_name(row)) + of_log[row["role"], row["log"]] for row in measured])
    limits = np.array([row["limit"] for row in measured])
    beyond = np.array([row["beyond"] for row in measured])
    at = np.array([row["estimate"] for row in measured]) / limits
    half = SIGNIFICANCE * np.array([row["standard_error"] for row in measured]) / limits
    ends = np.column_stack([at - half, at + half, np.full(len(at), np.nan)]).ravel()  # one interrupted line
    bars = Line(f"± {SIGNIFICANCE:g} standard errors", "measured", ends, np.repeat(y, 3), dash="solid")
    off = [Points("a log that is off", "measured", at[beyond], y[beyond], "cross")] if beyond.any() else []
    points = [Points("a log", "measured", at[~beyond], y[~beyond]), *off]
    return Figure(
        "instruments",
        "Instruments of the logs",
        caption=f"Each line has a mark for every log, in the order of the settings from the top. {RELATIVE}",
        x_name="error of the reading over its limit",
        x_unit="1",
        panels=(
            Panel(
                "",
                "1",
                (bars,),
                (Band("limit", "reference", np.array([-1.0, 1.0]), np.full(2, -0.5), np.full(2, len(names) - 0.5)),),
                tuple(points),
                y_limits=(-0.5 - _ROOM, len(names) - 0.5 + _ROOM),
                names=tuple(names),
            ),
        ),
        half=True,
    )
