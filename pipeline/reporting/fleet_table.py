"""The table of a fleet: a few numbers of every prototype, as columns for the page's script.

And one value of every member along an axis: a strip of stacked dots, or bars of counts for a large fleet.
"""

import base64
import math
import zlib
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from markupsafe import Markup

from pipeline.numerics.arrays import FloatArray
from pipeline.reporting.figure import linear_ticks, log_ticks, tick_labels
from pipeline.runs.columns import FACT_COLUMNS
from pipeline.si_prefix import significant

FACTS = {column.key: column.fleet for column in FACT_COLUMNS if column.fleet}
"""Facts of the fleet's table and their headings."""
GRADES = ("", "good", "fair", "poor", "failed")
_KEPT_BITS = 0xFFFFFC00
"""Stored bits of a 32-bit float: 13 of the fraction, a relative step of 1.2e-4; tables show three digits."""


@dataclass(frozen=True, slots=True)
class Summary:
    """What the page shows of one prototype of a fleet.

    Attributes
    ----------
    name : str
    reason : str
        Why its run failed; empty if it did not.
    link : str or None
        Its page relative to the fleet's page; None if there is none.
    done : bool
        Whether it has a datasheet.
    data, model : str
        Grades of the verdict; empty if it has none.
    why : str
        The finding that decides the lower of both grades, and how many more there are; empty where both are good.
    diverged : bool
        Whether the judged model diverged on a log.
    error, switches : float
        Worst NRMSE of q and worst switch accuracy of the judged model; NaN if undefined.
    training : bool
        Whether these are of the training logs, as there is no other.
    facts : dict of str to (float, str)
        Value [SI] and unit of every known one of `FACTS`.
    validation : tuple of (str, float or None)
        Model and NRMSE of q of every validation log.
    """

    name: str
    reason: str
    link: str | None
    done: bool
    data: str
    model: str
    why: str
    diverged: bool
    error: float
    switches: float
    training: bool
    facts: dict[str, tuple[float, str]]
    validation: tuple[tuple[str, float | None], ...]


def failed(name: str, reason: str) -> Summary:
    """A prototype without a datasheet."""
    return Summary(name, reason, None, False, "", "", "", False, float("nan"), float("nan"), False, {}, ())


def summary(name: str, sheet: Mapping[str, Any], link: str | None) -> Summary:
    """The numbers of a prototype's ``datasheet.json`` that the page shows."""
    scores, judged = sheet["scores"], sheet["judged_model"]
    return Summary(
        name,
        "",
        link,
        True,
        str(sheet["verdict"]["data"]),
        str(sheet["verdict"]["model"]),
        _why(sheet["verdict"].get("checks", ())),
        any(s["status"] == "diverged" for s in scores if s["model"] == judged),
        _headline(scores, judged, "nrmse"),
        _headline(scores, judged, "switch_accuracy"),
        {s["role"] for s in _of_headline(scores, judged)} == {"train"},
        {fact["key"]: (_value(fact), str(fact["unit"])) for fact in sheet["facts"] if fact["key"] in FACTS},
        tuple((s["model"], s["nrmse"]) for s in scores if s["signal"] == "q" and s["role"] == "validation"),
    )


def _why(checks: Sequence[Mapping[str, Any]]) -> str:
    failing = [check for grade in ("poor", "fair") for check in checks if check["grade"] == grade]
    more = f" (and {len(failing) - 1} more)" if failing[1:] else ""
    return f"{failing[0]['about']}: {failing[0]['statement']}{more}" if failing else ""


def _value(fact: Mapping[str, Any]) -> float:
    value = fact["value"] if fact["value"] is not None else fact["measured"]
    return float("nan") if value is None else float(value)


def _of_headline(scores: Any, judged: str) -> list[Mapping[str, Any]]:
    return [s for s in scores if s["signal"] == "q" and s["model"] == judged]


def _headline(scores: Any, judged: str, key: str) -> float:
    """The worst score of q of the judged model: on validation logs, else on those of training; NaN if undefined."""
    rows = _of_headline(scores, judged)
    values = [s[key] for s in [s for s in rows if s["role"] == "validation"] or rows]
    defined = [float(value) for value in values if value is not None]
    if key == "switch_accuracy":  # a log without pulses has none
        return min(defined, default=float("nan"))
    return max(defined) if defined and len(defined) == len(values) else float("nan")


@dataclass(frozen=True)
class FleetColumn:
    """One column: a fact or a score of every member, in the unit that is shown (NaN: unknown), and what stands out.

    Scores of training logs are marked, and left out of distributions.
    """

    title: str
    unit: str
    values: np.ndarray[tuple[int], np.dtype[np.float64]]
    outliers: np.ndarray[tuple[int], np.dtype[np.bool_]]
    scored: bool = False

    @property
    def heading(self) -> str:
        """Title and unit."""
        return f"{self.title} in {self.unit}" if self.unit not in ("", "1") else self.title


def fleet_columns(members: Sequence[Summary], quantities: Sequence[FleetColumn]) -> dict[str, Any]:
    """The table as JSON values; what is long is deflated and in base 64.

    ``names`` and ``whys``: of all, a line each; ``reasons``: a line for each that failed, in order; ``grades``: a byte
    each for data, model, whether a page exists, and 1 where the model diverged, 2 where its error is of training;
    ``suffix``: what a link adds to a name; and for each quantity ``values`` (four byte planes of 32-bit floats, NaN
    where unknown), ``outliers`` (a byte each), ``decimals`` and whether it is ``scored``.
    """
    grade = {text: code for code, text in enumerate(GRADES)}
    failed = [member for member in members if member.reason]
    flags = [
        (
            grade.get(m.data, 0),
            4 if m.reason else grade.get(m.model, 0),
            1 if m.link else 0,
            m.diverged + 2 * m.training,
        )
        for m in members
    ]
    suffixes = {m.link.removeprefix(m.name) for m in members if m.link is not None}
    return {
        "count": len(members),
        "names": _deflated("\n".join(_line(m.name) for m in members).encode()),
        "reasons": _deflated("\n".join(_line(m.reason) for m in failed).encode()),
        "whys": _deflated("\n".join(_line(m.why) for m in members).encode()),
        "grades": _deflated(np.array(flags, dtype=np.uint8).T.tobytes()),
        "suffix": suffixes.pop() if len(suffixes) == 1 else "",
        "quantities": [
            {
                "values": _floats(q.values),
                "outliers": _deflated(q.outliers.astype(np.uint8).tobytes()),
                "decimals": decimals(q.values),
                "scored": q.scored,
            }
            for q in quantities
        ],
    }


def decimals(values: FloatArray) -> int | None:
    """Of a column whose values are of one size, so that its points stand under one another; else None."""
    sizes = np.abs(values[np.isfinite(values)])
    if not sizes.size or sizes.min() <= 0.0 or sizes.max() > WIDE * sizes.min():
        return None
    return max(0, 2 - math.floor(math.log10(float(np.median(sizes)))))


def _line(text: str) -> str:
    return " ".join(text.split())


def _floats(values: FloatArray) -> str:
    bits = (values.astype("<f4").view("<u4") + np.uint32(0x200)) & np.uint32(_KEPT_BITS)
    bits[~np.isfinite(values)] = 0x7FC00000
    return _deflated(bits.view(np.uint8).reshape(-1, 4).T.tobytes())


def _deflated(content: bytes) -> str:
    return base64.b64encode(zlib.compress(content, 6)).decode("ascii")


WIDTH, LEFT, RIGHT, BASE, RADIUS = 380.0, 14.0, 366.0, 74.0, 4.0
HIGHEST = 14  # dots in a stack before they overlap
WIDE = 20.0  # ratio of the largest to the least value beyond which the axis is logarithmic
BARS, TOP = 60, 10.0


def strip_chart(strip: FleetColumn, names: Sequence[str]) -> Markup:
    """Stacked dots as an ``<svg>``; every dot carries its member's name and value as a title, outliers are open."""
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
                kind, float(places[k]), y, RADIUS - 0.5, names[i], significant(float(values[k])), strip.unit, mark
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


def labelled(strip: FleetColumn, middle: float, parts: Sequence[Markup]) -> Markup:
    """The drawing with its label; `middle` is the median."""
    text = Markup('<text class="label mid" x="{}" y="{}">{}</text>').format(
        (LEFT + RIGHT) / 2, BASE + 36, strip.heading
    )
    return Markup('<svg class="chart strip" viewBox="0 0 {:.0f} {:.0f}" role="img" aria-label="{}">{}</svg>').format(
        WIDTH,
        BASE + 44,
        f"distribution of {strip.heading}, median {significant(middle)}",
        Markup("").join([*parts, text]),
    )


def _ticks(low: float, high: float, log: bool) -> list[tuple[FloatArray, str]]:
    if log:
        places = log_ticks(low, high)
        return [(np.array(v), text) for v, text in zip(places, tick_labels(places), strict=True)]
    values, decimals = linear_ticks(low, high, 6)
    return [(np.array(v), f"{v + 0.0:.{decimals}f}".replace("-", "−")) for v in values]


def _f(value: FloatArray) -> float:
    return float(value)


def histogram(strip: FleetColumn) -> Markup:
    """The distribution as an ``<svg>``; outliers have a colour of their own, the upright line is the median."""
    finite = np.isfinite(strip.values)
    values, marked = strip.values[finite], strip.outliers[finite]
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
