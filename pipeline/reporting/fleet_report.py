"""The page of a fleet: a sortable table of its worst and odd prototypes, distributions, links to single pages."""

from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import replace
from typing import Any
from urllib.parse import quote

import numpy as np

from ..numerics.metrics import robust_std
from ..units.quantity import scale, significant
from .canvas import chart
from .fleet_table import FACTS, FleetColumn, Summary, decimals, distribution
from .page import render

# A robust z-score beyond 3.5 marks an outlier (Iglewicz & Hoaglin 1993); with fewer than 6 values none is marked.
OUTLIER = 3.5
LEAST_VALUES = 6
ERROR = "NRMSE of q"
TRAINING = " (training)"
LISTED = 200
"""Rows of the page; `fleet-facts.parquet` and `fleet.parquet` have all prototypes."""


def fleet_report(members: Iterable[Summary], page_name: str) -> str:
    """The page as HTML; the same members give the same bytes.

    Cost: 0.2 s for the drawing of each quantity that six prototypes have, else some milliseconds.
    """
    fleet = list(members)
    quantities = _quantities(fleet)
    done = [member for member in fleet if member.done]
    shown = [(q, decimals(q.values)) for q in quantities]
    context = {
        "title": page_name,
        "count": len(fleet),
        "done": len(done),
        "failures": sum(bool(member.reason) for member in fleet),
        "grades": _grades(done),
        "bare": sum(not member.model for member in done),
        "headings": [q.heading for q in quantities],
        "rows": [_row(fleet[i], i, shown) for i in _listed(fleet, quantities)],
        "charts": [chart(distribution(q), ()) for q in (_validated(q, fleet) for q in quantities) if _varies(q)],
    }
    return render("fleet.html.j2", ("tables.js",), context)


def _listed(members: Sequence[Summary], quantities: Sequence[FleetColumn]) -> list[int]:
    """The rows of the page: all, or those that failed, are odd, or have the largest errors, in their order."""
    if len(members) <= LISTED:
        return list(range(len(members)))
    odd = np.any([q.outliers for q in quantities], axis=0) if quantities else np.zeros(len(members), dtype=np.bool_)
    ranks = [
        (not member.reason, not odd[i], -np.nan_to_num(member.error, nan=np.inf), i) for i, member in enumerate(members)
    ]
    return sorted(i for *_, i in sorted(ranks)[:LISTED])


def _varies(q: FleetColumn) -> bool:
    """Whether there is a distribution to draw: as many values as an outlier needs, of which two differ."""
    finite = q.values[np.isfinite(q.values)]
    return finite.size >= LEAST_VALUES and bool(np.ptp(finite) > 0.0)


def _validated(q: FleetColumn, members: Sequence[Summary]) -> FleetColumn:
    """The same without errors on training logs, which must not stand beside those on others."""
    trained = np.array([member.training and q.scored for member in members])
    return replace(q, values=np.where(trained, np.nan, q.values))


def outliers(values: np.ndarray[tuple[int], np.dtype[np.float64]]) -> np.ndarray[tuple[int], np.dtype[np.bool_]]:
    """Which values lie further from the median than 3.5 robust standard deviations, shape (n,)."""
    finite = values[np.isfinite(values)]
    if finite.size < LEAST_VALUES:
        return np.zeros(values.size, dtype=np.bool_)
    middle = float(np.median(finite))
    sigma = robust_std(finite - middle)
    with np.errstate(invalid="ignore"):
        return np.asarray(np.abs(values - middle) > OUTLIER * sigma if sigma > 0.0 else values != middle) & np.isfinite(
            values
        )


def _quantities(members: Sequence[Summary]) -> list[FleetColumn]:
    errors = np.array([m.error for m in members])
    switches = np.array([m.switches for m in members])
    trained = np.array([m.training for m in members])
    unusual = outliers(np.log10(np.where(trained, np.nan, errors)))
    columns = [
        FleetColumn(ERROR, "%", 100.0 * errors, unusual, scored=True),
        FleetColumn("switches correct", "%", 100.0 * switches, np.zeros_like(unusual), scored=True),
        FleetColumn(
            "largest instrument error over its limit",
            "1",
            np.array([m.instruments for m in members]),
            np.array([m.off for m in members], dtype=np.bool_),
        ),
    ]
    largest: dict[tuple[str, str], float] = {}
    for member in members:
        for key, (value, unit) in member.facts.items():
            kind = key.partition("_")[0], unit
            largest[kind] = float(np.fmax(largest.get(kind, 0.0), abs(value)))
    for key, heading in FACTS.items():
        units = Counter(m.facts[key][1] for m in members if key in m.facts)
        if not units:
            continue
        unit = min(units, key=lambda symbol: (-units[symbol], symbol == "1", symbol))
        # Devices of another kind (an angle among lengths) have no value in this column.
        values = np.array([m.facts[key][0] if key in m.facts and m.facts[key][1] == unit else np.nan for m in members])
        # A fact and its twin on the other side have one unit.
        shown, factor = scale(unit, largest[key.partition("_")[0], unit])
        columns.append(FleetColumn(heading, shown, values * factor, outliers(values)))
    return [q for q in columns if np.isfinite(q.values).any()]


def _text(value: float, places: int | None) -> str:
    text = significant(value) if places is None else f"{value:.{places}f}"
    return text.replace("-", "−")


def _row(member: Summary, index: int, quantities: Sequence[tuple[FleetColumn, int | None]]) -> dict[str, Any]:
    cells = []
    for q, places in quantities:
        value = float(q.values[index])
        defined = bool(np.isfinite(value))
        of_training = TRAINING if member.training and q.scored else ""
        unknown = "diverged" if member.diverged and q.title == ERROR else "–"
        cells.append(
            {
                "text": _text(value, places) + of_training if defined else unknown,
                "value": repr(value) if defined else "",
                "outlier": bool(q.outliers[index]),
            }
        )
    return {
        "name": member.name,
        "link": f"./{quote(member.link)}" if member.link is not None else None,
        "failed": bool(member.reason),
        "why": member.reason or member.why,
        "data": member.data,
        "model": member.model,
        "cells": cells,
    }


def _grades(done: Sequence[Summary]) -> list[tuple[str, str, int]]:
    counts = []
    for about in ("data", "model"):
        for grade in ("good", "fair", "poor"):
            number = sum((member.data if about == "data" else member.model) == grade for member in done)
            if number:
                counts.append((about, grade, number))
    return counts
