"""The page of a fleet: a sortable table of its worst and odd prototypes, distributions, links to single pages."""

import math
from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any
from urllib.parse import quote

import numpy as np

from ..numerics.arrays import FloatArray
from ..numerics.metrics import robust_std
from ..store.columns import FACT_COLUMNS
from ..system.names import slug
from ..units.quantity import scale, significant
from .figure import Band, Figure, Line, Panel, Points, axis_label
from .page import render
from .plotted import chart

FACTS = {column.key: column.fleet for column in FACT_COLUMNS if column.fleet}
"""Facts of the fleet's table and their headings."""
WIDE = 20.0
"""Ratio of the largest to the least value beyond which an axis is logarithmic, and numbers have own decimals."""
# A robust z-score beyond 3.5 marks an outlier (Iglewicz & Hoaglin 1993); with fewer than 6 values none is marked.
OUTLIER = 3.5
LEAST_VALUES = 6
ERROR = "NRMSE of q"
TRAINING = " (training)"
LISTED = 200
"""Rows of the page; `fleet-facts.parquet` and `fleet.parquet` have all prototypes."""


@dataclass(frozen=True, slots=True)
class Summary:
    """Entries of one prototype on the fleet's page.

    Attributes
    ----------
    name : str
    reason : str
        Cause of its failure; empty if it did not fail.
    link : str or None
        Its page relative to the fleet's page; None if there is none.
    done : bool
        True if it has a datasheet.
    data, model : str
        Grades of the assessment; empty if it has none.
    why : str
        The finding that decides the lower of both grades, and how many more there are; empty where both are good.
    diverged : bool
        True if the judged model diverged on a log.
    error, switches : float
        Worst NRMSE of q and worst switch accuracy of the judged model; NaN if undefined.
    training : bool
        True if these are of the training logs, as there is no other.
    facts : dict of str to (float, str)
        Value [SI] and unit of every known one of `FACTS`.
    instruments : float
        Largest error of an instrument of any log over its limit; NaN where none was measured.
    off : bool
        True if one is beyond its limit, or a log is of another device.
    """

    name: str
    reason: str
    link: str | None = None
    done: bool = False
    data: str = ""
    model: str = ""
    why: str = ""
    diverged: bool = False
    error: float = float("nan")
    switches: float = float("nan")
    training: bool = False
    facts: dict[str, tuple[float, str]] = field(default_factory=dict)
    instruments: float = float("nan")
    off: bool = False


def summary(name: str, sheet: Mapping[str, Any], link: str | None) -> Summary:
    """The numbers of a prototype's ``datasheet.json`` that the page shows."""
    scores = sheet["scores"]
    judged = sheet["judged_model"]
    of_q = [s for s in scores if s["signal"] == "q" and s["model"] == judged]
    instruments = [row for row in sheet.get("instruments", ()) if row["model"] == judged]
    errors = [abs(row["estimate"]) / row["limit"] for row in instruments if row["estimate"] is not None]
    checks = sheet["verdict"].get("checks", ())
    failing = [check for grade in ("poor", "fair") for check in checks if check["grade"] == grade]
    more = f" (and {len(failing) - 1} more)" if failing[1:] else ""
    return Summary(
        name=name,
        reason="",
        link=link,
        done=True,
        data=str(sheet["verdict"]["data"]),
        model=str(sheet["verdict"]["model"]),
        why=f"{failing[0]['about']}: {failing[0]['statement']}{more}" if failing else "",
        diverged=any(s["status"] == "diverged" for s in scores if s["model"] == judged),
        error=_worst(of_q, "nrmse"),
        switches=_worst(of_q, "switch_accuracy"),
        training={s["role"] for s in of_q} == {"train"},
        facts={fact["key"]: (_value(fact), str(fact["unit"])) for fact in sheet["facts"] if fact["key"] in FACTS},
        instruments=max(errors, default=float("nan")),
        off=any(row["beyond"] or row["status"] == "another device" for row in instruments),
    )


def _value(fact: Mapping[str, Any]) -> float:
    value = fact["value"] if fact["value"] is not None else fact["measured"]
    return float("nan") if value is None else float(value)


def _worst(scores: Sequence[Mapping[str, Any]], key: str) -> float:
    """The worst score on validation logs, else on those of training; NaN if undefined."""
    validation = [s for s in scores if s["role"] == "validation"]
    values = [s[key] for s in validation or scores]
    defined = [float(value) for value in values if value is not None]
    if key == "switch_accuracy":  # a log without pulses has none
        return min(defined, default=float("nan"))
    return max(defined) if defined and len(defined) == len(values) else float("nan")


@dataclass(frozen=True)
class FleetColumn:
    """One column: a fact or a score of every member, in the shown unit (NaN: unknown), and the members that stand out.

    Scores of training logs are marked, and left out of distributions.
    """

    title: str
    unit: str
    values: np.ndarray[tuple[int], np.dtype[np.float64]]
    outliers: np.ndarray[tuple[int], np.dtype[np.bool_]]
    scored: bool = False


def decimals(values: FloatArray) -> int | None:
    """Decimals for a column whose values are of one size, so that its points align; else None."""
    sizes = np.abs(values[np.isfinite(values)])
    if not sizes.size or sizes.min() <= 0.0 or sizes.max() > WIDE * sizes.min():
        return None
    return max(0, 2 - math.floor(math.log10(float(np.median(sizes)))))


def distribution(column: FleetColumn) -> Figure:
    """The histogram of a column, with its median and the odd values; on a logarithmic axis where sizes differ much."""
    finite = np.isfinite(column.values)
    values = column.values[finite]
    odd = values[column.outliers[finite]]
    log = bool(values.min() > 0.0 and values.max() > WIDE * values.min())
    edges = np.histogram_bin_edges(np.log10(values) if log else values, "sturges")
    edges = 10.0**edges if log else edges
    counts = np.histogram(values, edges)[0].astype(np.float64)
    of_odd = counts[np.clip(np.searchsorted(edges, odd, side="right") - 1, 0, counts.size - 1)]
    outline = np.repeat(counts, 2)
    middle = float(np.median(values))
    return Figure(
        slug(column.title),
        column.title,
        caption="",
        x_name=column.title,
        x_unit=column.unit,
        panels=(
            Panel(
                "prototypes",
                "1",
                lines=(
                    Line(
                        "median",
                        "reference",
                        np.array([middle, middle]),
                        np.array([0.0, float(counts.max())]),
                        dash="solid",
                    ),
                ),
                bands=(Band("prototypes", "v1", np.repeat(edges, 2)[1:-1], np.zeros_like(outline), outline),),
                points=(Points("odd", "v2", odd, of_odd, marker="ring"),) if odd.size else (),
                whole=True,
            ),
        ),
        x_log=log,
        half=True,
    )


def fleet_report(members: Iterable[Summary], page_name: str) -> str:
    """The page as HTML; the same members give the same bytes.

    Cost: 0.2 s for the drawing of each quantity that six prototypes have, else some milliseconds.
    """
    fleet = list(members)
    quantities = _quantities(fleet)
    done = [member for member in fleet if member.done]
    shown = [(q, decimals(q.values)) for q in quantities]
    return render(
        "fleet.html.j2",
        ("tables.js",),
        {
            "title": page_name,
            "count": len(fleet),
            "done": len(done),
            "failures": sum(bool(member.reason) for member in fleet),
            "grades": [
                (about, grade, count)
                for about in ("data", "model")
                for grade in ("good", "fair", "poor")
                if (count := sum(getattr(member, about) == grade for member in done))
            ],
            "bare": sum(not member.model for member in done),
            "headings": [axis_label(q.title, q.unit) for q in quantities],
            "rows": [_row(fleet[i], i, shown) for i in _listed(fleet, quantities)],
            "charts": [chart(distribution(q), ()) for q in (_validated(q, fleet) for q in quantities) if _varies(q)],
        },
    )


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
    """True if a distribution can be drawn: enough values for an outlier, and two that differ."""
    finite = q.values[np.isfinite(q.values)]
    return finite.size >= LEAST_VALUES and bool(np.ptp(finite) > 0.0)


def _validated(q: FleetColumn, members: Sequence[Summary]) -> FleetColumn:
    """The scores without errors on training logs, which must not stand beside those on other logs."""
    return replace(q, values=np.where([member.training and q.scored for member in members], np.nan, q.values))


def outliers(values: np.ndarray[tuple[int], np.dtype[np.float64]]) -> np.ndarray[tuple[int], np.dtype[np.bool_]]:
    """Mask of the values further from the median than 3.5 robust standard deviations, shape (n,)."""
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
    unusual = outliers(np.log10(np.where([m.training for m in members], np.nan, errors)))
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


def _row(member: Summary, index: int, quantities: Sequence[tuple[FleetColumn, int | None]]) -> dict[str, Any]:
    cells = []
    for q, places in quantities:
        value = float(q.values[index])
        defined = bool(np.isfinite(value))
        text = significant(value) if places is None else f"{value:.{places}f}"
        of_training = TRAINING if member.training and q.scored else ""
        unknown = "diverged" if member.diverged and q.title == ERROR else "–"
        cells.append(
            {
                "text": text.replace("-", "−") + of_training if defined else unknown,
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
