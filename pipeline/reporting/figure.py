"""Contents of figures and their legends, apart from their drawing: the page, the viewer and the paper share these."""

import math
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Literal, TypeVar

import numpy as np
from markupsafe import Markup

from ..numerics.arrays import FloatArray, IntArray
from ..units.quantity import power, significant

_UNWRITABLE = re.compile("[^\t\n\r\x20-\x7e\xa0-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")  # XML 1.0, section 2.2
MARGIN = 0.04  # of the range of y, above and below

# Origin of a line: "measured", "raw", "reference", or the name of a model; it decides colour and dashes.
Role = str
Dash = Literal["role", "solid", "dashed", "dotted"]
MOST_POWERS = 6  # labels along a logarithmic axis
MOST_PLAIN = 1e3  # ratio of its ends beyond which they are powers of ten
# Class on the page, colour on paper, dash pattern (on, off in points). Order: models as they come.
MODEL_COLOURS = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#999933", "#882255", "#56B4E9", "#8C6D31")
MODEL_DASHES: tuple[tuple[float, ...], ...] = (
    (),
    (6, 2),
    (2, 2),
    (7, 2, 2, 2),
    (4, 1),
    (1, 1.5),
    (9, 2, 2, 2, 2, 2),
    (3, 4),
)
# Nearly black: matplotlib writes no colour for a black inside, which the page then could not replace.
FIXED = {"measured": "#010101", "raw": "#8C8C8C", "v1": "#E69F00", "v2": "#7A4FA3", "reference": "#8C8C8C"}
_SHAPES = {
    "cell": '<rect class="{}" width="30" height="12"/>',
    "band": '<rect class="{}" width="30" height="12"/>',
    "dot": '<circle class="{}" cx="15" cy="6" r="4.3"/>',
    "ring": '<circle class="{}" cx="15" cy="6" r="4.3"/>',
    "cross": '<path class="{}" d="M11 2L19 10M11 10L19 2"/>',
    "mark": '<path class="{}" d="M15 0V12"/>',
    "snap": '<path class="{}" d="M15 0V12"/>',
}
_LINE = '<path class="{}" d="M0 6H30"/>'


def log_label(value: float, *, powers: bool) -> str:
    """Label of a round number on a logarithmic axis, as a power of ten where it is one and `powers` are wanted.

    So is one that would be too long as a number.
    """
    exponent = round(math.log10(value))
    # With the digits that it needs, at most three.
    digits = next((d for d in (1, 2) if math.isclose(float(f"{value:.{d - 1}e}"), value, rel_tol=1e-9)), 3)
    plain = significant(value, digits)
    short = plain.replace(".", "").isdecimal() and not powers
    return plain if short or not math.isclose(value, 10.0**exponent, rel_tol=1e-9) else f"10{power(exponent)}"


@dataclass(frozen=True)
class Line:
    """y over x, both of shape (n,) in SI; NaN interrupts it.

    It has the dashes of its role unless it is given others. `parts` are two series of the same page whose difference is
    y: the page then stores nothing for it. A `wide` line stays visible under others that lie on it.
    """

    label: str
    role: Role
    x: FloatArray
    y: FloatArray
    dash: Dash = "role"
    parts: tuple[FloatArray, FloatArray] | None = None
    wide: bool = False


@dataclass(frozen=True)
class Band:
    """The area between two curves over x, each of shape (n,)."""

    label: str
    role: Role
    x: FloatArray
    low: FloatArray
    high: FloatArray


Drawn = TypeVar("Drawn", Line, Band)


@dataclass(frozen=True)
class Points:
    """Marked points; the marker identifies them without its colour."""

    label: str
    role: Role
    x: FloatArray
    y: FloatArray
    marker: Literal["dot", "ring", "cross"] = "dot"


@dataclass(frozen=True)
class Cells:
    """A grid of cells coloured by class: `index[i, j]` at ``(x[j], y[i])``; negative cells stay empty."""

    labels: tuple[str, ...]
    x: FloatArray
    y: FloatArray
    index: np.ndarray[tuple[int, int], np.dtype[np.int8]]


@dataclass(frozen=True)
class Panel:
    """One pair of axes.

    Attributes
    ----------
    name, unit : str
        Quantity and SI unit of the vertical axis.
    log : bool
        Logarithmic y.
    x : (str, str) or None
        Name and unit [SI] of a horizontal axis of its own; None: that of the figure.
    x_log : bool
        That axis is logarithmic.
    x_limits, y_limits : (float, float) or None
        Visible part of the axes, in SI; None: everything.
    low : bool
        Half as high as others.
    whole : bool
        The vertical axis counts things.
    names : tuple of str
        Texts at 0, 1, … of the vertical axis in place of numbers.
    """

    name: str
    unit: str
    lines: tuple[Line, ...] = ()
    bands: tuple[Band, ...] = ()
    points: tuple[Points, ...] = ()
    cells: Cells | None = None
    log: bool = False
    x: tuple[str, str] | None = None
    x_log: bool = False
    x_limits: tuple[float, float] | None = None
    y_limits: tuple[float, float] | None = None
    low: bool = False
    whole: bool = False
    names: tuple[str, ...] = ()


@dataclass(frozen=True)
class Figure:
    """Panels over one another with one horizontal axis.

    Attributes
    ----------
    name : str
        File name of the paper figure, without ending.
    title, caption : str
        Contents, and how to read them.
    x_name, x_unit : str
        The horizontal axis, in SI.
    marks : mapping of str to FloatArray
        Positions on the x axis by what happens there, e.g. voltage switches.
    gaps : tuple of (float, float)
        Segments of x without data.
    columns : int
        Panels beside one another.
    tall : float
        Height of a panel, over the usual one.
    half : bool
        On the page half as wide as the others.
    whole : bool
        The horizontal axis counts things.
    hidden : tuple of str
        Labels of lines that the viewer shows on request only and the paper figure leaves out.
    """

    name: str
    title: str
    caption: str
    x_name: str
    x_unit: str
    panels: tuple[Panel, ...]
    marks: Mapping[str, FloatArray] = field(default_factory=dict)
    gaps: tuple[tuple[float, float], ...] = ()
    x_log: bool = False
    columns: int = 1
    tall: float = 1.0
    half: bool = False
    whole: bool = False
    hidden: tuple[str, ...] = ()


def axis_label(name: str, unit: str) -> str:
    """``q in mm``; the name alone of a pure number."""
    return writable(name if unit in ("", "1") else f"{name} in {unit}")


def writable(text: str) -> str:
    """The text without the characters that XML cannot hold."""
    return _UNWRITABLE.sub("\ufffd", text)


def shown(figure: Figure) -> Figure:
    """The figure without its hidden lines."""
    return replace(
        figure,
        panels=tuple(
            replace(panel, lines=tuple(line for line in panel.lines if line.label not in figure.hidden))
            for panel in figure.panels
        ),
        hidden=(),
    )


def window(figure: Figure, start: float, stop: float) -> Figure:
    """The figure between two values of x, which are the ends of its axis."""

    def cut(part: Drawn, *columns: str) -> Drawn:
        """The samples of a line or a band in the window."""
        rows = (part.x >= start) & (part.x <= stop)
        return replace(part, **{name: getattr(part, name)[rows] for name in ("x", *columns)})

    panels = tuple(
        replace(
            panel,
            lines=tuple(cut(line, "y") for line in panel.lines),
            bands=tuple(cut(band, "low", "high") for band in panel.bands),
            x_limits=(start, stop),
        )
        for panel in figure.panels
    )
    return replace(
        figure,
        panels=panels,
        marks={name: at[(at >= start) & (at <= stop)] for name, at in figure.marks.items()},
        gaps=tuple((max(a, start), min(b, stop)) for a, b in figure.gaps if a < stop and b > start),
    )


def of_models(figure: Figure, models: Sequence[str], wanted: Sequence[str]) -> Figure:
    """The figure with the lines of the `wanted` ones of all `models`, and with all lines of no model."""

    def kept(role: Role) -> bool:
        """True if lines and areas of this role stay."""
        return role not in models or role in wanted

    return replace(
        figure,
        panels=tuple(
            replace(
                panel,
                lines=tuple(line for line in panel.lines if kept(line.role)),
                bands=tuple(band for band in panel.bands if kept(band.role)),
                points=tuple(points for points in panel.points if kept(points.role)),
            )
            for panel in figure.panels
        ),
        hidden=(),
    )


def is_path(line: Line) -> bool:
    """True if the line is a path in a plane, whose x goes back and forth."""
    return bool(np.any(np.diff(line.x) <= 0.0))


def line_kind(line: Line) -> Literal["line", "wide", "trace"]:
    """Strength of a line; paths in a plane, which cross themselves, are drawn finest."""
    return "wide" if line.wide else "trace" if is_path(line) else "line"


def extreme_places(y: FloatArray, count: int) -> IntArray:
    """Places of the least and the largest sample of every bucket of `count` samples, shape (2 ceil(N / count),).

    A bucket without samples gives two places without one.
    """
    padded = np.full(-(-y.size // count) * count, np.nan)
    padded[: y.size] = y
    rows = padded.reshape(-1, count)
    finite = np.isfinite(rows)
    ends = (np.where(finite, rows, np.inf).argmin(axis=1), np.where(finite, rows, -np.inf).argmax(axis=1))
    places = np.sort(np.stack(ends, axis=1), axis=1) + count * np.arange(len(rows))[:, None]
    return np.minimum(places.ravel(), y.size - 1)


def thinned(line: Line, buckets: int) -> Line:
    """The least and the largest sample of each bucket at their places, so that no peak is lost; short ones as they are.

    A bucket without samples interrupts the line.
    """
    if line.y.size <= 4 * buckets or is_path(line):
        return line
    places = extreme_places(line.y, -(-line.y.size // buckets))
    return replace(line, x=line.x[places], y=line.y[places])


def x_range(figure: Figure, of: Panel | None = None) -> tuple[float, float]:
    """Least and largest x of all that is drawn, or of a panel with a horizontal axis of its own."""
    if of is not None and of.x_limits is not None:
        return of.x_limits
    panels = (of,) if of is not None and of.x is not None else figure.panels
    return _range(
        [
            *(line.x for panel in panels for line in panel.lines),
            *(band.x for panel in panels for band in panel.bands),
            *(points.x for panel in panels for points in panel.points),
            *(panel.cells.x for panel in panels if panel.cells is not None),
        ]
    )


def y_range(panel: Panel) -> tuple[float, float]:
    """Least and largest y of a panel, with a margin of 4 %; cells fill it."""
    if panel.y_limits is not None:
        return panel.y_limits
    low, high = _range(
        [
            *(line.y for line in panel.lines),
            *(points.y for points in panel.points),
            *(edge for band in panel.bands for edge in (band.low, band.high)),
            *([panel.cells.y] if panel.cells is not None else []),
        ]
    )
    if panel.log:
        return low, high * (high / low) ** MARGIN
    margin = 0.0 if panel.cells is not None else MARGIN * (high - low)
    return low - margin, high + margin


def _range(arrays: list[FloatArray]) -> tuple[float, float]:
    ends = [(float(finite.min()), float(finite.max())) for a in arrays if (finite := a[np.isfinite(a)]).size]
    low, high = (min(a for a, _ in ends), max(b for _, b in ends)) if ends else (0.0, 1.0)
    if high > low:
        return low, high
    pad = abs(low) * 0.05 or 1.0
    return low - pad, high + pad


def slot(role: str, models: Sequence[str]) -> str:
    """Name of the colour class of a role: ``measured``, ``raw``, ``v1`` … or ``m0`` to ``m7`` for models."""
    if role in FIXED:
        return role
    return f"m{models.index(role) % len(MODEL_COLOURS)}" if role in models else "reference"


def slot_colour(name: str) -> str:
    """Colour of a slot on paper."""
    return FIXED[name] if name in FIXED else MODEL_COLOURS[int(name[1:])]


def slot_dashes(name: str) -> tuple[float, ...]:
    """Dash pattern of a slot; empty for a solid line."""
    return () if name in FIXED else MODEL_DASHES[int(name[1:])]


@dataclass(frozen=True)
class Style:
    """Look of a line or area, with the colour class (`pipeline.reporting.figure.slot`) of its model or log."""

    kind: str
    slot: str = ""
    dash: Dash = "role"


MARKS = {
    "voltage switched": Style("mark"),
    "voltage steps": Style("mark"),
    "input steps": Style("mark"),
    "device snaps over": Style("snap"),
}


def entries(figure: Figure, models: Sequence[str], *, marks: bool = False) -> list[tuple[str, Style]]:
    """Everything that is drawn, hidden lines too, each label once; with the `marks` along the axis or without."""
    styles: dict[str, Style] = {}
    for panel in figure.panels:
        for label, style in _of(panel, models):
            styles.setdefault(label, style)
    return [
        *sorted(styles.items(), key=lambda entry: _place(entry[1])),
        *((name, MARKS[name]) for name in figure.marks if marks and name in MARKS),
    ]


def _of(panel: Panel, models: Sequence[str]) -> Iterator[tuple[str, Style]]:
    if panel.cells is not None:
        for number, label in enumerate(panel.cells.labels):
            if (panel.cells.index == number).any():
                yield label, Style(f"cell{number}")
    yield from ((band.label, Style("band", slot(band.role, models))) for band in panel.bands)
    yield from ((line.label, Style(line_kind(line), slot(line.role, models), line.dash)) for line in panel.lines)
    yield from ((points.label, Style(points.marker, slot(points.role, models))) for points in panel.points)


def _place(style: Style) -> tuple[int, int]:
    """Areas, lines of the measurement, lines of the models in their order, points."""
    model = int(style.slot[1:]) if style.slot[:1] == "m" and style.slot[1:].isdigit() else -1
    group = 0 if style.kind.startswith("cell") else 2 if style.kind in ("dot", "ring", "cross") else 1
    return group, model


def swatches(figure: Figure, models: Sequence[str], *, marks: bool = False) -> list[tuple[str, Markup]]:
    """Label and sample of everything that is drawn, each label once, for the page: 30 by 12 units, with classes."""
    return [swatch(*entry) for entry in entries(figure, models, marks=marks)]


def swatch(label: str, style: Style) -> tuple[str, Markup]:
    """The label with its sample."""
    dashed = "dash" if style.dash in ("dashed", "dotted") else ""
    names = " ".join(part for part in (style.kind, style.slot, dashed) if part)
    return label, Markup(_SHAPES.get(style.kind.rstrip("0123"), _LINE)).format(names)  # noqa: S704 - literals above
