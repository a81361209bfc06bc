"""The page of a fleet: a sortable table, distributions of facts and errors, outliers marked, links to single pages."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any
from urllib.parse import quote

import numpy as np

from pipeline.numerics.arrays import FloatArray
from pipeline.reporting.page import render
from pipeline.reporting.strip_chart import WIDE, Strip, strip_chart
from pipeline.si_prefix import scale, significant

# A robust z-score beyond 3.5 marks an outlier (Iglewicz & Hoaglin 1993); with fewer than 6 values none is marked.
OUTLIER, LEAST_VALUES = 3.5, 6
ERROR = "NRMSE of q"
_TO_SIGMA = 1.4826  # from the median absolute deviation to the standard deviation of a normal distribution

FACTS = (
    "well_left",
    "well_right",
    "barrier_left",
    "barrier_right",
    "switch_v1_to_right",
    "switch_v1_to_left",
    "switch_v2_to_right",
    "switch_v2_to_left",
    "frequency_left",
    "frequency_right",
    "damping_left",
    "damping_right",
)


@dataclass(frozen=True)
class Member:
    """One prototype of a fleet.

    Attributes
    ----------
    name : str
    reason : str
        Why its run failed; empty if it did not.
    datasheet : mapping or None
        Its ``datasheet.json``; None if it has none.
    link : str or None
        Its page relative to the fleet's page; None if there is none.
    """

    name: str
    reason: str
    datasheet: Mapping[str, Any] | None
    link: str | None


@dataclass(frozen=True)
class Quantity:
    """One column: a fact or an error of every member, in the unit that is shown; NaN where unknown."""

    title: str
    unit: str
    values: "np.ndarray[tuple[int], np.dtype[np.float64]]"
    outliers: "np.ndarray[tuple[int], np.dtype[np.bool_]]"


def fleet_report(members: Sequence[Member], page_name: str) -> str:
    """The page as HTML; the same members give the same bytes. About 2 kB for each member."""
    quantities = _quantities(members)
    done = [member for member in members if member.datasheet is not None]
    strips = [
        Strip(q.title, q.unit, [m.name for m in members], q.values, q.outliers)
        for q in quantities
        if np.count_nonzero(np.isfinite(q.values)) > 1
    ]
    context = {
        "title": page_name,
        "count": len(members),
        "done": len(done),
        "failed": [member for member in members if member.reason],
        "grades": _grades(done),
        "headings": [f"{q.title} in {q.unit}" if q.unit not in ("", "1") else q.title for q in quantities],
        "rows": [_row(member, i, quantities) for i, member in enumerate(members)],
        "strips": [(strip.title, strip_chart(strip)) for strip in strips],
        "models": _models(done),
    }
    return render("fleet.html.j2", ("tables.js",), context)


def outliers(values: "np.ndarray[tuple[int], np.dtype[np.float64]]") -> "np.ndarray[tuple[int], np.dtype[np.bool_]]":
    """Which values lie further from the median than 3.5 robust standard deviations, shape (n,)."""
    known = values[np.isfinite(values)]
    if known.size < LEAST_VALUES:
        return np.zeros(values.size, dtype=np.bool_)
    middle = float(np.median(known))
    sigma = _TO_SIGMA * float(np.median(np.abs(known - middle)))
    with np.errstate(invalid="ignore"):
        return np.asarray(np.abs(values - middle) > OUTLIER * sigma if sigma > 0.0 else values != middle) & np.isfinite(
            values
        )


def _quantities(members: Sequence[Member]) -> list[Quantity]:
    errors = np.array([_headline(m, "nrmse") for m in members])
    switches = np.array([_headline(m, "switch_accuracy") for m in members])
    columns = [Quantity(ERROR, "%", 100.0 * errors, outliers(np.log10(errors)))]
    columns.append(Quantity("switches correct", "%", 100.0 * switches, np.zeros(len(members), dtype=np.bool_)))
    for key in FACTS:
        facts = [_fact(member, key) for member in members]
        units = {fact["unit"] for fact in facts if fact is not None}
        if not units:
            continue
        unit = sorted(units)[0]
        # Devices of another kind (an angle among lengths) have no value in this column.
        values = np.array([_value(f) if f is not None and f["unit"] == unit else np.nan for f in facts])
        shown, factor = scale(unit, _largest(members, key, unit))
        columns.append(Quantity(_title(key), shown, values * factor, outliers(values)))
    return [q for q in columns if np.isfinite(q.values).any()]


def _largest(members: Sequence[Member], key: str, unit: str) -> float:
    """Of a fact and its twin on the other side, so that both have one unit."""
    kind = key.partition("_")[0]
    facts = [_fact(member, twin) for member in members for twin in FACTS if twin.startswith(kind)]
    known = [abs(_value(fact)) for fact in facts if fact is not None and fact["unit"] == unit]
    return float(np.nanmax(known, initial=0.0))


def _decimals(values: FloatArray) -> int | None:
    """Of a column whose values are of one size, so that its points stand under one another; else None."""
    known = np.abs(values[np.isfinite(values)])
    if not known.size or known.min() <= 0.0 or known.max() > WIDE * known.min():
        return None
    return max(0, 2 - math.floor(math.log10(float(np.median(known)))))


def _text(value: float, decimals: int | None) -> str:
    text = significant(value) if decimals is None else f"{value:.{decimals}f}"
    return text.replace("-", "−")


def _title(key: str) -> str:
    if key.startswith("switch"):
        _, name, _, side = key.split("_")
        return f"switching {name}, to {side}"
    kind, side = key.split("_")
    return f"{'rest' if kind == 'well' else kind} {side}"


def _fact(member: Member, key: str) -> Mapping[str, Any] | None:
    facts = member.datasheet["facts"] if member.datasheet is not None else ()
    return next((fact for fact in facts if fact["key"] == key), None)


def _value(fact: Mapping[str, Any]) -> float:
    value = fact["value"] if fact["value"] is not None else fact["measured"]
    return float("nan") if value is None else float(value)


def _headline(member: Member, key: str) -> float:
    """The worst score of q of the judged model: on validation logs, else on those of training; NaN if undefined."""
    if member.datasheet is None:
        return float("nan")
    rows = [s for s in member.datasheet["scores"] if s["signal"] == "q"]
    rows = [s for s in rows if s["model"] == member.datasheet["judged_model"]]
    judged = [s for s in rows if s["role"] == "validation"] or rows
    values = [s[key] for s in judged]
    if not values or any(value is None for value in values):
        return float("nan")
    return float(min(values) if key == "switch_accuracy" else max(values))


def _diverged(member: Member) -> bool:
    """Whether the judged model diverged on a log."""
    sheet = member.datasheet
    return sheet is not None and any(
        s["status"] == "diverged" for s in sheet["scores"] if s["model"] == sheet["judged_model"]
    )


def _row(member: Member, index: int, quantities: Sequence[Quantity]) -> dict[str, Any]:
    verdict = member.datasheet["verdict"] if member.datasheet is not None else None
    cells = []
    diverged = _diverged(member)
    for q in quantities:
        value = float(q.values[index])
        known = bool(np.isfinite(value))
        unknown = "diverged" if diverged and q.title == ERROR else "–"
        cells.append(
            {
                "text": _text(value, _decimals(q.values)) if known else unknown,
                "value": repr(value) if known else "",
                "outlier": bool(q.outliers[index]),
            }
        )
    return {
        "name": member.name,
        "link": f"./{quote(member.link)}" if member.link is not None else None,
        "reason": member.reason,
        "data": verdict["data"] if verdict else "",
        "model": verdict["model"] if verdict else "",
        "cells": cells,
    }


def _grades(done: Sequence[Member]) -> list[tuple[str, str, int]]:
    counts = []
    for about in ("data", "model"):
        for grade in ("good", "fair", "poor"):
            number = sum(m.datasheet["verdict"][about] == grade for m in done if m.datasheet is not None)
            if number:
                counts.append((about, grade, number))
    return counts


def _models(done: Sequence[Member]) -> list[dict[str, Any]]:
    """For every model the distribution of its NRMSE of q over all validation logs of the fleet."""
    errors: dict[str, list[float | None]] = {}
    for member in done:
        for s in member.datasheet["scores"] if member.datasheet is not None else ():
            if s["signal"] == "q" and s["role"] == "validation":
                errors.setdefault(s["model"], []).append(s["nrmse"])
    rows = []
    for model, values in errors.items():
        known = 100.0 * np.array([v for v in values if v is not None])
        quartiles = [float(x) for x in np.quantile(known, [0.5, 0.25, 0.75, 1.0])] if known.size else [float("nan")] * 4
        cells = [
            {"text": significant(x) if np.isfinite(x) else "–", "value": repr(x) if np.isfinite(x) else ""}
            for x in quartiles
        ]
        rows.append({"model": model, "logs": len(values), "undefined": len(values) - known.size, "cells": cells})
    return rows
