"""Facts of one device over several runs, each with its standard error, and their change: none, a line, or one step.

A change is found by weighted least squares with the standard errors of the measurements, raised where the scatter about
the better model is larger (Birge 1932, doi:10.1103/PhysRev.40.207). Line and steps each move a constant along one
direction. The null distribution of the largest gain among them is simulated for the times and errors at hand.
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any, Literal

import numpy as np
from scipy.special import stdtrit

from ..models.base import DynamicModel, HasCurveDraws, HasCurves
from ..numerics.arrays import FloatArray
from ..numerics.metrics import NORMAL_90, NORMAL_95
from ..signals.findings import Number
from ..signals.log import Log
from .calibrated import calibrated
from .instruments import InstrumentTest
from .sentences import READINGS, unit_of

ALARM = 0.05
"""Probability that any change is claimed in a series of an unchanged device."""
DRAWS = 64
PLACES = 121
FEWEST = 4
FEWEST_STEP = FEWEST + 2
"""Measurements from which a line and a step are looked for: three lie near some line by chance."""
_SIMULATED = 20_000
_SEED = 2026
_WALKS = np.concatenate([[0.0], np.geomspace(1e-3, 1e4, 57)])
"""Variances of the random walk over the whole time, in mean squared errors."""
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
class Trend:
    """Change of a quantity over time.

    Attributes
    ----------
    kind : {"unknown", "none", "line", "step"}
        "unknown" with fewer than `FEWEST` measurements, "none" where chance explains what is seen.
    slope, slope_error : float or None
        Of the straight line a unit of time, and half of its 95 % interval; None where unknown.
    step, step_error : float or None
        Size of the best step and half of its 95 % interval at that place; None below `FEWEST_STEP` measurements.
    at : float or None
        Time of the first measurement after the best step; None likewise.
    after, before : float or None
        Times of the measurements between which the step lies with 95 %; None likewise.
    """

    kind: Literal["unknown", "none", "line", "step"]
    slope: float | None = None
    slope_error: float | None = None
    step: float | None = None
    step_error: float | None = None
    at: float | None = None
    after: float | None = None
    before: float | None = None


@dataclass(frozen=True)
class SeriesFact:
    """One fact over the runs that have it, in SI.

    Attributes
    ----------
    key, title, unit : str
    at, values, errors : FloatArray, shape (n,)
        Times, values, and standard errors of the single runs.
    smooth, smooth_errors : FloatArray, shape (n,)
        The same from all runs together, where the device changes little (`smoothed`).
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


RunFact = tuple[str, str, Number]
"""A fact of one run: key, title, and value with its standard error in SI."""


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
            yield fact["key"], fact["title"], Number(fact["value"], fact["unit"], _error(fact["low"], fact["high"]))
    if between is not None and isinstance(model, HasCurves) and isinstance(model, HasCurveDraws):
        q = np.linspace(*between, PLACES)
        yield from _gains(model.curves(q), model.curve_ensemble(q, DRAWS), gain_unit)
    for fitted in calibrated(model):
        if fitted.name in _QUANTITIES:
            key = fitted.name.partition(",")[0].replace(" ", "_")
            number = Number(fitted.value, fitted.unit, _error(fitted.low, fitted.high))
            yield key, _QUANTITIES[fitted.name], number


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
    for name, value, error in zip(instruments.quantities, reading.estimate, reading.standard_error, strict=True):
        # The force of a joint goes with C v², so that 2 % of capacitance read as 1 % of voltage.
        what = f"{READINGS.get(name, name)} or of the device" if name.startswith("gain_v") else READINGS.get(name, name)
        title = f"instruments: {what}, change since the first run"
        yield f"reading_{name}", title, Number(float(value), unit_of(name, displacement), float(error))


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
        gain = Number(float(curves[key].mean()), unit, _error(low, high))
        yield f"gain_v{key[2]}", f"capacitance gain ∂C{key[2]}/∂q, mean over the stroke", gain


def _error(low: float, high: float) -> float:
    """Standard error of a central 90 % interval."""
    return float(high - low) / (2.0 * NORMAL_90)


def facts_over_time(at: Sequence[float], runs: Sequence[Sequence[RunFact]]) -> tuple[SeriesFact, ...]:
    """Each fact that at least two runs have, with its change; `at` are the times of the runs, ascending."""
    by_fact: dict[tuple[str, str, str], list[tuple[float, float, float]]] = {}
    for time, facts in zip(at, runs, strict=True):
        for key, title, number in facts:
            error = number.error or 0.0
            if np.isfinite(number.value) and error > 0.0:
                by_fact.setdefault((key, title, number.unit), []).append((time, number.value, error))
    several = {named: np.array(rows).T for named, rows in by_fact.items() if len(rows) > 1}
    return tuple(
        SeriesFact(*named, t, y, errors, *smoothed(t, y, errors), trend(t, y, errors, ALARM / len(several)))
        for named, (t, y, errors) in several.items()
    )


def trend(t: FloatArray, y: FloatArray, errors: FloatArray, alarm: float) -> Trend:
    """The change that n measurements show.

    Parameters
    ----------
    t, y, errors : FloatArray, shape (n,)
        Times, ascending, values, and their standard errors.
    alarm : float
        Probability with which a change may be claimed where there is none.
    """
    n = len(t)
    if n < FEWEST:
        return Trend("unknown")
    places = np.arange(2, n - 1) if n >= FEWEST_STEP else np.arange(0)
    shapes = np.array([t - t[0], *(np.arange(n) >= place for place in places)], dtype=np.float64)
    constant = 1.0 / errors
    weighted = shapes / errors
    constant /= np.linalg.norm(constant)
    free = weighted - np.outer(weighted @ constant, constant)
    lengths = np.linalg.norm(free, axis=1)
    directions = free / lengths[:, None]
    left = y / errors - (y / errors @ constant) * constant
    moved = directions @ left
    misfits = np.maximum(left @ left - moved**2, 0.0)
    scatter = np.maximum(misfits / (n - 2), 1.0)
    half = stdtrit(n - 2, 0.975) * np.sqrt(scatter) / lengths
    chance = _chance(directions, constant, float((moved**2 / scatter).max()))
    line = Trend("line" if chance < alarm else "none", float(moved[0] / lengths[0]), float(half[0]))
    if not len(places):
        return line
    best = 1 + int(np.argmin(misfits[1:]))
    near = places[misfits[1:] <= misfits[best] + NORMAL_95**2 * scatter[best]]
    # The place of a step is one more number to choose (BIC).
    stepped = chance < alarm and misfits[best] / scatter.min() + np.log(n) < misfits[0] / scatter.min()
    return replace(
        line,
        kind="step" if stepped else line.kind,
        step=float(moved[best] / lengths[best]),
        step_error=float(half[best]),
        at=float(t[places[best - 1]]),
        after=float(t[near[0] - 1]),
        before=float(t[near[-1]]),
    )


def _chance(directions: FloatArray, constant: FloatArray, gain: float) -> float:
    """Share of simulated measurements without a change whose largest gain is at least this one."""
    noise = np.random.default_rng(_SEED).standard_normal((_SIMULATED, len(constant)))
    noise -= np.outer(noise @ constant, constant)
    squares = (noise @ directions.T) ** 2
    left = np.sum(noise**2, axis=1)[:, None] - squares
    largest = np.max(squares / np.maximum(left, np.finfo(float).tiny), axis=1) * (len(constant) - 2)
    return float((1 + np.count_nonzero(largest >= gain)) / (1 + _SIMULATED))


def smoothed(t: FloatArray, y: FloatArray, errors: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Values of a device that changes little, from all measurements together, and their standard errors.

    The prior is a random walk from anywhere, whose speed is the one with the largest likelihood; both results have
    shape (n,). It is the Rauch–Tung–Striebel smoother, written with covariances.
    """
    size = float(np.mean(errors**2))
    walk = np.minimum.outer(t - t[0], t - t[0]) / max(float(t[-1] - t[0]), np.finfo(float).tiny)
    moved = (y - y.mean()) / np.sqrt(size)
    noise = np.diag(errors**2 / size)
    priors = [speed * walk + 1e6 for speed in _WALKS]  # nearly the same variance anywhere
    unlikely = [moved @ np.linalg.solve(p + noise, moved) + np.linalg.slogdet(p + noise)[1] for p in priors]
    prior = priors[int(np.argmin(unlikely))]
    gain = np.linalg.solve(prior + noise, prior).T
    variances = np.maximum(np.diag(gain @ noise), 0.0)  # (P − P (P + N)⁻¹ P) = P (P + N)⁻¹ N
    return y.mean() + np.sqrt(size) * (gain @ moved), np.sqrt(size * variances)
