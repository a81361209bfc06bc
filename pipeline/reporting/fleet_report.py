"""The page of a fleet: a sortable table, distributions of facts and errors, outliers marked, links to single pages."""

from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import replace
from typing import Any
from urllib.parse import quote

import numpy as np
from markupsafe import Markup

from pipeline.numerics.metrics import robust_std
from pipeline.reporting.fleet_table import FACTS, FleetColumn, Summary, decimals, fleet_columns, histogram, strip_chart
from pipeline.reporting.page import json_for_script, render
from pipeline.si_prefix import scale, significant

# A robust z-score beyond 3.5 marks an outlier (Iglewicz & Hoaglin 1993); with fewer than 6 values none is marked.
OUTLIER, LEAST_VALUES = 3.5, 6
ERROR, TRAINING = "NRMSE of q", " (training)"
LISTED = 400
"""Members up to which every one has a row of markup and a dot in the distributions."""


def fleet_report(members: Iterable[Summary], page_name: str) -> str:
    """The page as HTML; the same members give the same bytes.

    Up to `LISTED` members it is a table of 2 kB for each, which needs no script. More are columns of numbers, 60 bytes
    for each, of which a script shows those rows that are in sight; distributions are then histograms.
    """
    fleet = list(members)
    quantities, many = _quantities(fleet), len(fleet) > LISTED
    done, failed = [member for member in fleet if member.done], [member for member in fleet if member.reason]
    shown = [(q, decimals(q.values)) for q in quantities]
    context = {
        "title": page_name,
        "count": len(fleet),
        "done": len(done),
        "failed": failed[:LISTED],
        "failures": len(failed),
        "grades": _grades(done),
        "bare": sum(not member.model for member in done),
        "headings": [q.heading for q in quantities],
        "rows": [] if many else [_row(member, i, shown) for i, member in enumerate(fleet)],
        "columns": json_for_script(fleet_columns(fleet, quantities)) if many else "",
        "strips": [
            (q.title, _distribution(q, fleet, many))
            for q in quantities
            if np.isfinite(_validated(q, fleet).values).sum() > 1
        ],
        "models": _models(done),
    }
    return render("fleet.html.j2", ("series.js", "tables.js", "fleet_table.js") if many else ("tables.js",), context)


def _distribution(q: FleetColumn, members: Sequence[Summary], many: bool) -> Markup:
    shown = _validated(q, members)
    return histogram(shown) if many else strip_chart(shown, [member.name for member in members])


def _validated(q: FleetColumn, members: Sequence[Summary]) -> FleetColumn:
    """The same without errors on training logs, which say nothing beside those on others."""
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
    errors, switches = np.array([m.error for m in members]), np.array([m.switches for m in members])
    trained = np.array([m.training for m in members])
    unusual = outliers(np.log10(np.where(trained, np.nan, errors)))
    columns = [
        FleetColumn(ERROR, "%", 100.0 * errors, unusual, scored=True),
        FleetColumn("switches correct", "%", 100.0 * switches, np.zeros_like(unusual), scored=True),
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
        "reason": member.reason,
        "why": member.why,
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


def _models(done: Sequence[Summary]) -> list[dict[str, Any]]:
    """For every model the distribution of its NRMSE of q over all validation logs of the fleet."""
    errors: dict[str, list[float | None]] = {}
    for member in done:
        for model, error in member.validation:
            errors.setdefault(model, []).append(error)
    rows = []
    for model, values in errors.items():
        defined = 100.0 * np.array([v for v in values if v is not None])
        quartiles = (
            [float(x) for x in np.quantile(defined, [0.5, 0.25, 0.75, 1.0])] if defined.size else [float("nan")] * 4
        )
        cells = [
            {"text": significant(x) if np.isfinite(x) else "–", "value": repr(x) if np.isfinite(x) else ""}
            for x in quartiles
        ]
        rows.append({"model": model, "logs": len(values), "undefined": len(values) - defined.size, "cells": cells})
    return rows
