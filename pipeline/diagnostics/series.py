"""Facts of one device over several runs, each with its standard error, and their changes, also in words."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from ..fitting.trends import Trend, smoothed, trend
from ..models.base import DynamicModel, HasCurveDraws, HasCurves
from ..numerics.arrays import FloatArray
from ..numerics.metrics import NORMAL_90, NORMAL_95
from ..signals.log import Log
from ..units.quantity import quantity
from .calibrated import calibrated
from .instruments import InstrumentTest
from .sentences import READINGS

ALARM = 0.05
"""Probability that any change is claimed in a series of an unchanged device."""
DRAWS = 64
PLACES = 121
COLUMNS = ("fact", "first run", "last run", "from all runs", "change")
"""Headings of `series_rows`."""
_WIDE = 10.0
"""Standard errors by which the facts of one device hardly scatter: three simulated devices scatter by more."""
_LEFT_OUT = ("asymmetry", "stable")
"""Prefixes of the keys of facts that follow from others, or that another run may number otherwise."""
_QUANTITIES = {
    "charging time": "charging time of the electrodes",
    "creep stiffness 0": "creep within 60 ms, stiffness",
    "creep stiffness 1": "creep within 1 s, stiffness",
    "laser offset, change": "zero of the laser",
}
"""Quantities of `hybrid` that age, and their names for readers."""


@dataclass(frozen=True)
class SeriesFact:
    """One fact over the runs that have it, in SI.

    Attributes
    ----------
    key, title, unit : str
    at, values, errors : FloatArray, shape (n,)
        Times, values, and standard errors of the single runs.
    smooth, smooth_errors : FloatArray, shape (n,)
        The same from all runs together, where the device changes little (`pipeline.fitting.trends.smoothed`).
    trend : Trend
    """

    key: str
    title: str
    unit: str
    at: FloatArray
    values: FloatArray
    errors: FloatArray
    smooth: FloatArray
    smooth_errors: FloatArray
    trend: Trend


@dataclass(frozen=True)
class Series:
    """Runs of one device in the order of their times.

    Attributes
    ----------
    names : tuple of str
        Folders of the runs.
    at : tuple of float
        Times, in `unit`.
    unit : str
        "day", or "run" where no times were given.
    facts : tuple of SeriesFact
    """

    names: tuple[str, ...]
    at: tuple[float, ...]
    unit: str
    facts: tuple[SeriesFact, ...]


@dataclass(frozen=True)
class RunFact:
    """A fact of one run: key, title and unit, value and standard error in SI."""

    key: str
    title: str
    unit: str
    value: float
    error: float


def facts_of(
    sheet: Mapping[str, Any], model: DynamicModel, between: tuple[float, float] | None, gain_unit: str
) -> Iterator[RunFact]:
    """The facts of a run that have an interval.

    Parameters
    ----------
    sheet : mapping
        Its datasheet.
    model : DynamicModel
        The model that the datasheet's facts come from.
    between : (float, float) or None
        Displacements [m] between which capacitance gains are averaged, equal for all runs; None: they are left out.
    gain_unit : str
        Unit of the slopes of its capacitances.
    """
    for fact in sheet["facts"]:
        if fact["low"] is not None and fact["value"] is not None and not fact["key"].startswith(_LEFT_OUT):
            yield RunFact(fact["key"], fact["title"], fact["unit"], fact["value"], _error(fact["low"], fact["high"]))
    if between is not None and isinstance(model, HasCurves) and isinstance(model, HasCurveDraws):
        q = np.linspace(*between, PLACES)
        yield from _gains(model.curves(q), model.curve_ensemble(q, DRAWS), gain_unit)
    for fitted in calibrated(model):
        if fitted.name in _QUANTITIES:
            key = fitted.name.partition(",")[0].replace(" ", "_")
            error = _error(fitted.low, fitted.high)
            yield RunFact(key, _QUANTITIES[fitted.name], fitted.unit, fitted.value, error)


def instrument_facts(instruments: InstrumentTest, parts: Sequence[Log], displacement: str) -> Iterator[RunFact]:
    """Changes of the instruments in a later run against the first run, by the first run's model.

    Empty where no instrument explains the change of the device; the facts show it then.

    Parameters
    ----------
    instruments : InstrumentTest
        Of the first run.
    parts : sequence of Log
        The parts of all training logs of the later run.
    displacement : str
        SI unit of q.
    """
    reading = instruments.of(parts)
    if reading.status != "measured" or reading.exchange != "none":
        return
    units = {"zero_q": displacement, "delay": "s"}
    for name, value, error in zip(instruments.quantities, reading.estimate, reading.standard_error, strict=True):
        # The force of a joint goes with C v², so that 2 % of capacitance read as 1 % of voltage.
        either = " or of the device" if name.startswith("gain_v") else ""
        title = f"instruments: {READINGS.get(name, name)}{either}, change since the first run"
        yield RunFact(f"reading_{name}", title, units.get(name, "1"), float(value), float(error))


def common_stroke(sheets: Sequence[Mapping[str, Any]]) -> tuple[float, float] | None:
    """The displacements [m] that lie between the rests of every run; None where one has not two."""
    rests = [{f["key"]: f["value"] for f in sheet["facts"] if f["key"].startswith("well_")} for sheet in sheets]
    if any(len(run) < 2 or None in run.values() for run in rests):
        return None
    left = max(run["well_left"] for run in rests)
    right = min(run["well_right"] for run in rests)
    return (left, right) if left < right else None


def _gains(curves: Mapping[str, FloatArray], draws: Mapping[str, FloatArray], unit: str) -> Iterator[RunFact]:
    """Mean slope of each capacitance between the wells."""
    for key in (key for key in curves if key.startswith("dC")):
        low, high = np.quantile(draws[key].mean(axis=1), [0.05, 0.95])
        title = f"capacitance gain ∂C{key[2]}/∂q, mean over the stroke"
        yield RunFact(f"gain_v{key[2]}", title, unit, float(curves[key].mean()), _error(low, high))


def _error(low: float, high: float) -> float:
    """Standard error of a central 90 % interval."""
    return float(high - low) / (2.0 * NORMAL_90)


def facts_over_time(at: Sequence[float], runs: Sequence[Sequence[RunFact]]) -> tuple[SeriesFact, ...]:
    """Each fact that at least two runs have, with its change; `at` are the times of the runs, ascending."""
    by_fact: dict[tuple[str, str, str], list[tuple[float, float, float]]] = {}
    for time, facts in zip(at, runs, strict=True):
        for fact in facts:
            if np.isfinite(fact.value) and fact.error > 0.0:
                by_fact.setdefault((fact.key, fact.title, fact.unit), []).append((time, fact.value, fact.error))
    several = {named: np.array(rows).T for named, rows in by_fact.items() if len(rows) > 1}
    return tuple(
        SeriesFact(*named, t, y, errors, *smoothed(t, y, errors), trend(t, y, errors, ALARM / len(several)))
        for named, (t, y, errors) in several.items()
    )


def series_rows(series: Series) -> list[tuple[str, ...]]:
    """A row of texts for each fact: first and last value, the last one from all runs, and the change."""
    return [
        (
            fact.title,
            *(_shown(fact, fact.values[i], fact.errors[i]) for i in (0, -1)),
            _shown(fact, fact.smooth[-1], fact.smooth_errors[-1]),
            _change(fact, series.unit),
        )
        for fact in series.facts
    ]


def _change(fact: SeriesFact, unit: str) -> str:
    """Trend of a fact in words; `unit` is that of the time."""
    change = fact.trend
    if change.kind == "unknown" or change.slope is None:
        return f"{len(fact.at)} runs: too few"
    if change.kind == "step":
        step = quantity(change.step, fact.unit, change.step_error, float(np.abs(fact.values).max()))
        return f"step of {step} between {unit}s {change.after:g} and {change.before:g}"
    slope = quantity(change.slope, fact.unit, change.slope_error)
    return f"{slope} a {unit}" if change.kind == "line" else f"none shown ({slope} a {unit})"


def conclusion(series: Series) -> str:
    """A sentence on the whole series."""
    if series.facts and all(fact.trend.kind == "unknown" for fact in series.facts):
        return f"{len(series.names)} runs: too few to show a drift; it takes four, a step six"
    changed = [fact.title for fact in series.facts if fact.trend.kind in ("line", "step")]
    scattered = [fact.title for fact in series.facts if fact.title not in changed and _scatter(fact) > _WIDE]
    text = f"changed: {', '.join(changed)}" if changed else "no fact changed by more than chance explains"
    doubt = f"; scattered by over {_WIDE:g} times their errors: {', '.join(scattered)}; are these runs of one device?"
    return text + (doubt if scattered else "")


def _scatter(fact: SeriesFact) -> float:
    """RMS deviation from the weighted mean over the standard errors."""
    deviations = fact.values - np.average(fact.values, weights=fact.errors**-2.0)
    return float(np.sqrt(np.mean((deviations / fact.errors) ** 2)))


def _shown(fact: SeriesFact, value: float, error: float) -> str:
    return quantity(float(value), fact.unit, NORMAL_95 * float(error))
