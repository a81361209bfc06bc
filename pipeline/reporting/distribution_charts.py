"""One value of every member of a fleet along an axis: a strip of stacked dots, or bars of counts for a large fleet."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from markupsafe import Markup

from pipeline.numerics.arrays import BoolArray, FloatArray
from pipeline.reporting.figure import linear_ticks, log_ticks, tick_label
from pipeline.si_prefix import significant

WIDTH, LEFT, RIGHT, BASE, RADIUS = 380.0, 14.0, 366.0, 74.0, 4.0
HIGHEST = 14  # dots in a stack before they overlap
WIDE = 20.0  # ratio of the largest to the least value beyond which the axis is logarithmic
BARS, TOP = 60, 10.0


@dataclass(frozen=True)
class Strip:
    """A quantity of a fleet: title and unit, and for every member its name, value (NaN if unknown) and outlier mark."""

    title: str
    unit: str
    names: Sequence[str]
    values: FloatArray
    outliers: BoolArray


def strip_chart(strip: Strip) -> Markup:
    """The strip as an ``<svg>``; every dot carries its member's name and value as a title, outliers are open."""
    rows = np.flatnonzero(np.isfinite(strip.values))
    values = strip.values[rows]
    x, parts = axis_of(values, strip.unit)
    middle = float(np.median(values))
    parts.append(Markup('<path class="line reference" d="M{0:.1f} 8V{1}"/>').format(_f(x(np.array(middle))), BASE))
    stacks: dict[int, int] = {}
    places = x(values)
    for k in np.argsort(values, kind="stable"):
        column = round(float(places[k]) / (2 * RADIUS))
        level = stacks.get(column, 0)
        stacks[column] = level + 1
        y = BASE - RADIUS - 1 - (level % HIGHEST) * 2 * RADIUS * min(1.0, 8 / HIGHEST)
        i = int(rows[k])
        kind = "ring v2" if strip.outliers[i] else "dot v1"
        mark = " (outlier)" if strip.outliers[i] else ""
        parts.append(
            Markup('<circle class="{}" cx="{:.1f}" cy="{:.1f}" r="{}"><title>{}: {} {}{}</title></circle>').format(
                kind, float(places[k]), y, RADIUS - 0.5, strip.names[i], significant(float(values[k])), strip.unit, mark
            )
        )
    return labelled(strip, middle, parts)


def axis_of(values: FloatArray, unit: str) -> tuple[Callable[[FloatArray], FloatArray], list[Markup]]:
    """Where values lie along the axis, and the axis drawn; it is logarithmic where they are of very different size."""
    low, high = float(values.min()), float(values.max())
    log = low > 0.0 and high > WIDE * low
    if not log:
        pad = 0.04 * (high - low) or abs(low) * 0.05 or 1.0
        # A share neither falls below 0 nor rises above 100 %, and neither does its axis.
        bounds = (0.0, 100.0) if unit == "%" and low >= 0.0 and high <= 100.0 else (-np.inf, np.inf)
        low, high = max(low - pad, bounds[0]), min(high + pad, bounds[1])

    def x(v: FloatArray) -> FloatArray:
        """Places along the axis."""
        share = np.log(v / low) / np.log(high / low) if log else (v - low) / (high - low)
        place: FloatArray = LEFT + RADIUS + share * (RIGHT - LEFT - 2 * RADIUS)
        return place

    parts = [Markup('<path class="frame" d="M{} {}H{}"/>').format(LEFT, BASE, RIGHT)]
    for at, text in _ticks(low, high, log):
        parts.append(Markup('<text class="tick mid" x="{:.1f}" y="{}">{}</text>').format(_f(x(at)), BASE + 16, text))
    return x, parts


def labelled(strip: Strip, middle: float, parts: Sequence[Markup]) -> Markup:
    """The drawing with its label; `middle` is the median."""
    label = f"{strip.title} in {strip.unit}" if strip.unit not in ("", "1") else strip.title
    text = Markup('<text class="label mid" x="{}" y="{}">{}</text>').format((LEFT + RIGHT) / 2, BASE + 36, label)
    return Markup('<svg class="chart strip" viewBox="0 0 {:.0f} {:.0f}" role="img" aria-label="{}">{}</svg>').format(
        WIDTH, BASE + 44, f"distribution of {label}, median {significant(middle)}", Markup("").join([*parts, text])
    )


def _ticks(low: float, high: float, log: bool) -> list[tuple[FloatArray, str]]:
    if log:
        return [(np.array(v), tick_label(float(v))) for v in log_ticks(low, high)]
    values, decimals = linear_ticks(low, high, 6)
    return [(np.array(v), f"{v + 0.0:.{decimals}f}".replace("-", "−")) for v in values]


def _f(value: FloatArray) -> float:
    return float(value)


def histogram(strip: Strip) -> Markup:
    """The distribution as an ``<svg>``; outliers have a colour of their own, the upright line is the median."""
    known = np.isfinite(strip.values)
    values, marked = strip.values[known], strip.outliers[known]
    x, ticks = axis_of(values, strip.unit)
    places = x(values)
    edges = np.linspace(LEFT + RADIUS, RIGHT - RADIUS, BARS + 1)
    counts = np.histogram(places, edges)[0]
    outliers = np.histogram(places[marked], edges)[0]
    height = (BASE - TOP) / max(1, int(counts.max()))
    parts = [*ticks]
    for i in np.flatnonzero(counts):
        text = f"{counts[i]} prototypes" + (f", {outliers[i]} outliers" if outliers[i] else "")
        left, width = edges[i], edges[1] - edges[0] - 0.6
        inner = counts[i] - outliers[i]
        bar = Markup('<path class="{}" d="M{:.1f} {:.1f}v{:.1f}h{:.1f}v{:.1f}z"><title>{}</title></path>')
        if inner:
            parts.append(bar.format("bar v1", left, BASE, -inner * height, width, inner * height, text))
        if outliers[i]:  # at least a pixel: one outlier among a hundred thousand shall be seen
            tall = max(1.5, outliers[i] * height)
            parts.append(bar.format("bar v2", left, BASE - inner * height, -tall, width, tall, text))
    middle = float(np.median(values))
    at = float(x(np.array(middle)))
    parts.append(Markup('<path class="line reference" d="M{0:.1f} 8V{1}"/>').format(at, BASE))
    return labelled(strip, middle, parts)
