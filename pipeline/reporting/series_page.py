"""The page of a series: the facts of one device over time."""

from collections.abc import Sequence

import numpy as np

from ..diagnostics.series import Series, SeriesFact
from ..numerics.arrays import FloatArray
from ..numerics.metrics import NORMAL_95
from ..units.quantity import quantity
from .figure import Band, Figure, Line, Panel, Points, error_bars
from .page import render
from .plotted import chart

COLUMNS = ("fact", "first run", "last run", "from all runs", "change")


def series_rows(series: Series) -> list[tuple[str, ...]]:
    """A row of texts for each fact: first and last value, the last one from all runs, and the change."""
    return [
        (
            fact.title,
            *(_shown(fact, fact.values[i], fact.errors[i]) for i in (0, -1)),
            _shown(fact, fact.smooth[-1], fact.smooth_errors[-1]),
            change(fact, series.unit),
        )
        for fact in series.facts
    ]


def change(fact: SeriesFact, unit: str) -> str:
    """Trend of a fact in words; `unit` is that of the time."""
    trend = fact.trend
    if trend.kind == "unknown" or trend.slope is None:
        return f"{len(fact.at)} runs: too few"
    if trend.kind == "step":
        step = quantity(trend.step, fact.unit, trend.step_error, float(np.abs(fact.values).max()))
        return f"step of {step} between {unit}s {trend.after:g} and {trend.before:g}"
    slope = quantity(trend.slope, fact.unit, trend.slope_error)
    return f"{slope} a {unit}" if trend.kind == "line" else f"none shown ({slope} a {unit})"


def conclusion(series: Series) -> str:
    """A sentence on the whole series."""
    if series.facts and all(fact.trend.kind == "unknown" for fact in series.facts):
        return f"{len(series.names)} runs: too few to show a drift; it takes four, a step six"
    changed = [fact.title for fact in series.facts if fact.trend.kind in ("line", "step")]
    scattered = [fact.title for fact in series.facts if fact.title not in changed and _scatter(fact) > _WIDE]
    text = f"changed: {', '.join(changed)}" if changed else "no fact changed by more than chance explains"
    doubt = f"; scattered by over {_WIDE:g} times their errors: {', '.join(scattered)}; are these runs of one device?"
    return text + (doubt if scattered else "")


_WIDE = 10.0
"""Standard errors by which the facts of one device hardly scatter: three simulated devices scatter by more."""


def _scatter(fact: SeriesFact) -> float:
    """RMS deviation from the weighted mean over the standard errors."""
    deviations = fact.values - np.average(fact.values, weights=fact.errors**-2.0)
    return float(np.sqrt(np.mean((deviations / fact.errors) ** 2)))


def _shown(fact: SeriesFact, value: float, error: float) -> str:
    return quantity(float(value), fact.unit, NORMAL_95 * float(error))


def series_page(series: Series) -> str:
    """The page as HTML; the same series gives the same bytes."""
    charts = [chart(_figure(fact, series.unit), ("all",)) for fact in series.facts]
    context = {
        "names": [f"{name} ({series.unit} {at:g})" for name, at in zip(series.names, series.at, strict=True)],
        "columns": COLUMNS,
        "rows": series_rows(series),
        "conclusion": conclusion(series),
        "charts": charts,
    }
    return render("series.html.j2", (), context)


def _figure(fact: SeriesFact, unit: str) -> Figure:
    """Values of the runs with their intervals, the values from all runs as a band, and the line or step."""
    at = fact.at
    bars = error_bars("95 % interval", fact.values, NORMAL_95 * fact.errors, at, upright=True)
    wide = NORMAL_95 * fact.smooth_errors
    panel = Panel(
        "value",
        fact.unit,
        (bars, *_drawn_change(fact)),
        (Band("from all runs", "all", at, fact.smooth - wide, fact.smooth + wide),),
        (Points("run", "measured", at, fact.values),),
    )
    return Figure(
        fact.key,
        fact.title,
        caption=change(fact, unit),
        x_name="time" if unit == "day" else "run",
        x_unit="d" if unit == "day" else "1",
        panels=(panel,),
        half=True,
    )


def _drawn_change(fact: SeriesFact) -> Sequence[Line]:
    trend = fact.trend
    shapes = {"line": (trend.slope, fact.at), "step": (trend.step, fact.at >= (trend.at or 0.0))}
    size, shape = shapes.get(trend.kind, (None, fact.at))
    if size is None:
        return ()
    change: FloatArray = size * shape.astype(np.float64)
    weights = fact.errors**-2.0
    level = float(weights @ (fact.values - change) / weights.sum())
    return (Line(trend.kind, "all", fact.at, level + change),)
