"""The layout of a figure: axes, ticks, legend and data as shapes, alike on the page and on paper."""

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np

from pipeline.numerics.arrays import FloatArray
from pipeline.reporting.axis_ticks import linear_ticks, log_ticks, tick_label
from pipeline.reporting.figure import Band, Cells, Figure, Panel, Points, line_kind, thinned, x_range, y_range
from pipeline.reporting.legend import MARKS, cross, legend
from pipeline.reporting.palette import slot
from pipeline.reporting.shapes import Area, Box, Disc, Drawing, Shape, Stroke, Style, Text
from pipeline.si_prefix import axis_scale, scale

# Distances in heights of the letters.
LEFT, RIGHT, TOP, BOTTOM, BETWEEN = 6.2, 1.2, 0.9, 3.7, 1.3
TICK_BELOW, LABEL_BELOW, TICK_BESIDE, LABEL_BESIDE = 1.35, 3.0, 0.5, 4.7
MARKER = 0.42
SEAM = 0.4  # rows of cells overlap, so that no gap shows between them
_UNWRITABLE = re.compile("[^\t\n\r\x20-\x7e\xa0-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")  # XML 1.0, section 2.2
BUCKETS = 700  # of a long record: about a pixel's width each


@dataclass(frozen=True)
class Sheet:
    """What a figure is drawn on, in drawing units.

    Attributes
    ----------
    width, panel_height : float
    text : float
        Height of the letters.
    legend : bool
        Whether the drawing has its own legend; the page writes it beside.
    """

    width: float
    panel_height: float
    text: float
    legend: bool = False


PAGE = Sheet(820.0, 220.0, 12.0)  # CSS pixels
PAGE_PANEL = Sheet(560.0, 230.0, 12.0)
# Printed at their own size: letters of 8 points, a page's width (7.16 in) or a column's (3.5 in).
PAPER = Sheet(515.5, 84.0, 8.0, legend=True)
PAPER_COLUMNS = replace(PAPER, panel_height=120.0)
PAPER_COLUMN = Sheet(252.0, 130.0, 8.0, legend=True)


@dataclass(frozen=True)
class _Scale:
    """From values to drawing units along one axis."""

    low: float
    high: float
    start: float
    stop: float
    log: bool = False

    def __call__(self, values: FloatArray) -> FloatArray:
        ends = np.array([self.low, self.high])
        (low, high), at = (np.log10(ends), np.log10(values)) if self.log else (ends, values)
        drawn: FloatArray = self.start + (at - low) / (high - low) * (self.stop - self.start)
        return drawn

    def at(self, value: float) -> float:
        return float(self(np.array(value)))


def paper_sheet(figure: Figure) -> Sheet:
    """A page's width for records over time and for panels beside one another, else a column's."""
    if figure.columns > 1 and len(figure.panels) > 1:
        return PAPER_COLUMNS
    return PAPER if figure.x_unit == "s" else PAPER_COLUMN


def lay_out(figure: Figure, models: Sequence[str], sheet: Sheet) -> Drawing:
    """The figure as shapes.

    Parameters
    ----------
    figure : Figure
        Its hidden lines are left out.
    models : sequence of str
        All models of the run, for their colours.
    sheet : Sheet
        What it is drawn on.
    """
    em = sheet.text
    figure = replace(figure, panels=tuple(_shown(panel, figure.hidden) for panel in figure.panels))
    columns = min(figure.columns, len(figure.panels))
    rows = -(-len(figure.panels) // columns)
    below = (BETWEEN if columns == 1 else BOTTOM + BETWEEN / 2) * em
    height = sheet.panel_height * figure.tall
    shapes: list[Shape] = []
    top = TOP * em
    if sheet.legend:
        keys, taken = legend(figure, models, LEFT * em, sheet.width - (LEFT + RIGHT) * em, em)
        shapes += keys
        top += taken
    low, high = x_range(figure)
    cell = sheet.width / columns
    for number, panel in enumerate(figure.panels):
        row, column = divmod(number, columns)
        begin = top + row * (height + below)
        x = _Scale(low, high, column * cell + LEFT * em, (column + 1) * cell - RIGHT * em, figure.x_log)
        bounds = y_range(panel)
        y = _Scale(bounds[0], bounds[1], begin + height, begin, panel.log)
        shapes += _ground(figure, panel, x, y)
        shapes += _frame(figure, panel, x, y, em, lowest=row == rows - 1 or columns > 1)
        shapes += _content(panel, x, y, models, em)
    whole = top + rows * height + (rows - 1) * below + BOTTOM * em
    return Drawing(_writable(figure.title), sheet.width, whole, em, tuple(map(_written, shapes)))


def _writable(text: str) -> str:
    """The text without what a file in XML cannot hold."""
    return _UNWRITABLE.sub("\ufffd", text)


def _written(shape: Shape) -> Shape:
    return replace(shape, text=_writable(shape.text)) if isinstance(shape, Text) else shape


def _shown(panel: Panel, hidden: Sequence[str]) -> Panel:
    return replace(panel, lines=tuple(line for line in panel.lines if line.label not in hidden))


def _ground(figure: Figure, panel: Panel, x: _Scale, y: _Scale) -> Iterator[Shape]:
    """What lies under the grid: gaps and cells."""
    for start, stop in figure.gaps:
        left = x.at(start)
        yield Box(Style("gap"), left, y.stop, max(x.at(stop) - left, 0.5), y.start - y.stop)
    if panel.cells is not None:
        yield from _cells(panel.cells, x, y)


def _frame(figure: Figure, panel: Panel, x: _Scale, y: _Scale, em: float, *, lowest: bool) -> Iterator[Shape]:
    # A logarithmic axis has powers of ten anyway.
    x_unit, x_factor = (scale if x.log else axis_scale)(figure.x_unit, max(abs(x.low), abs(x.high)))
    y_unit, y_factor = (scale if y.log else axis_scale)(panel.unit, max(abs(y.low), abs(y.high)))
    for at, text in _ticks(x, x_factor, 6.0 * em, 6, 8):
        yield _line("grid", at, y.stop, at, y.start)
        if lowest:
            yield Text(text, at, y.start + TICK_BELOW * em, anchor="mid")
    for at, text in _ticks(y, y_factor, 3.0 * em, 4, 6):
        yield _line("grid", x.start, at, x.stop, at)
        yield Text(text, x.start - TICK_BESIDE * em, at + 0.35 * em, anchor="end")
    if not x.log and x.low < 0.0 < x.high:
        yield _line("zero", x.at(0.0), y.stop, x.at(0.0), y.start)
    if not y.log and y.low < 0.0 < y.high:
        yield _line("zero", x.start, y.at(0.0), x.stop, y.at(0.0))
    yield Box(Style("frame"), x.start, y.stop, x.stop - x.start, y.start - y.stop)
    if lowest:
        middle = (x.start + x.stop) / 2
        yield Text(axis_label(figure.x_name, x_unit), middle, y.start + LABEL_BELOW * em, "label", "mid")
    middle = (y.start + y.stop) / 2
    yield Text(axis_label(panel.name, y_unit), x.start - LABEL_BESIDE * em, middle, "label", "mid", turned=True)
    for name, positions in figure.marks.items():
        style = MARKS.get(name, Style("mark"))
        yield Stroke(style, tuple(np.array([[at, y.stop], [at, y.start]]) for at in x(positions)))


def axis_label(name: str, unit: str) -> str:
    """``q in mm``; the name alone of a pure number."""
    return name if unit in ("", "1") else f"{name} in {unit}"


def _ticks(axis: _Scale, factor: float, apart: float, least: int, most: int) -> list[tuple[float, str]]:
    """Places and labels of ticks about so far `apart`, but `least` to `most` of them."""
    about = max(least, min(most, int(abs(axis.stop - axis.start) / apart)))
    if axis.log:
        values = log_ticks(axis.low * factor, axis.high * factor)
        return [(axis.at(float(v) / factor), tick_label(float(v))) for v in values]
    values, decimals = linear_ticks(axis.low * factor, axis.high * factor, about)
    return [(axis.at(float(v) / factor), f"{v + 0.0:.{decimals}f}".replace("-", "−")) for v in values]


def _content(panel: Panel, x: _Scale, y: _Scale, models: Sequence[str], em: float) -> Iterator[Shape]:
    for band in panel.bands:
        yield from _band(band, x, y, models)
    for line in panel.lines:
        style = Style(line_kind(line), slot(line.role, models), line.dashed)
        thin = thinned(line, BUCKETS)
        yield Stroke(style, _pieces(np.column_stack((x(thin.x), y(thin.y)))))
    for points in panel.points:
        yield from _points(points, x, y, models, MARKER * em)


def _pieces(points: FloatArray) -> tuple[FloatArray, ...]:
    """The stretches between missing points."""
    known = np.isfinite(points).all(axis=1)
    edges = np.flatnonzero(np.diff(np.concatenate(([0], known.astype(np.int8), [0])))).reshape(-1, 2)
    return tuple(points[a:b] for a, b in edges)


def _cells(cells: Cells, x: _Scale, y: _Scale) -> Iterator[Shape]:
    """Runs of equal cells of a row as one box."""
    width, height = float(cells.x[1] - cells.x[0]), float(cells.y[1] - cells.y[0])
    for row, values in zip(cells.y, cells.index, strict=True):
        edges = np.flatnonzero(np.diff(values)) + 1
        for first, last in zip(np.r_[0, edges], np.r_[edges, len(values)], strict=True):
            if values[first] < 0:
                continue
            left = float(np.clip(x(cells.x[first] - width / 2), x.start, x.stop))
            right = float(np.clip(x(cells.x[last - 1] + width / 2), x.start, x.stop))
            top = float(np.clip(y(row + height / 2), y.stop, y.start))
            bottom = float(np.clip(y(row - height / 2), y.stop, y.start))
            style = Style(f"cell{int(values[first])}")  # type: ignore[arg-type]
            yield Box(style, left, top, right - left, min(bottom + SEAM, y.start) - top)


def _band(band: Band, x: _Scale, y: _Scale, models: Sequence[str]) -> Iterator[Shape]:
    edges = np.column_stack((x(band.x), y(band.low), y(band.high)))
    for piece in _pieces(edges):
        if len(piece) > 1:
            outline = np.vstack([piece[:, [0, 2]], piece[::-1, :2]])
            yield Area(Style("band", slot(band.role, models)), outline)


def _points(points: Points, x: _Scale, y: _Scale, models: Sequence[str], radius: float) -> Iterator[Shape]:
    style = Style(points.marker, slot(points.role, models))
    for a, b in zip(x(points.x), y(points.y), strict=True):
        if points.marker == "cross":
            yield Stroke(style, cross(float(a), float(b), radius))
        else:
            yield Disc(style, float(a), float(b), radius)


def _line(kind: str, x1: float, y1: float, x2: float, y2: float) -> Stroke:
    return Stroke(Style(kind), (np.array([[x1, y1], [x2, y2]]),))  # type: ignore[arg-type]
