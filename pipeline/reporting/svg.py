"""Figures as SVG for the page: classes instead of colours, so that style sheet, dark mode and print decide them."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np
from markupsafe import Markup, escape

from pipeline.numerics.arrays import FloatArray
from pipeline.reporting.axis_ticks import linear_ticks, log_ticks
from pipeline.reporting.figure import Band, Cells, Figure, Line, Panel, Points, thinned, x_range, y_range
from pipeline.reporting.palette import slot
from pipeline.reporting.si_prefix import scale, significant

WIDTH, WIDE, PANEL_HEIGHT = 820.0, 1140.0, 220.0  # wide: with columns
LEFT, RIGHT, TOP, BOTTOM, BETWEEN = 74.0, 14.0, 10.0, 44.0, 16.0
SEAM = 0.4  # rows of cells overlap, so that no gap shows between them
BUCKETS = 700  # a pixel's width each


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


def svg(figure: Figure, models: Sequence[str]) -> Markup:
    """The figure as one ``<svg>`` element without any inline style."""
    columns = min(figure.columns, len(figure.panels))
    rows = -(-len(figure.panels) // columns)
    below = BETWEEN if columns == 1 else BOTTOM
    panel_height = PANEL_HEIGHT * figure.tall
    height = TOP + rows * panel_height + (rows - 1) * below + BOTTOM
    low, high = x_range(figure)
    width = WIDTH if columns == 1 else WIDE
    cell = width / columns
    parts: list[Markup] = []
    for number, panel in enumerate(figure.panels):
        row, column = divmod(number, columns)
        top = TOP + row * (panel_height + below)
        x = _Scale(low, high, column * cell + LEFT, (column + 1) * cell - RIGHT, figure.x_log)
        bounds = y_range(panel)
        y = _Scale(bounds[0], bounds[1], top + panel_height, top, panel.log)
        lowest = row == rows - 1 or columns > 1
        parts += _frame(figure, panel, x, y, lowest)
        parts += _content(figure, panel, x, y, models)
    title = Markup("<title>{}</title>").format(figure.title)
    return Markup('<svg class="chart{}" viewBox="0 0 {} {}" role="img" aria-label="{}">{}{}</svg>').format(
        " wide" if columns > 1 else "", f"{width:.0f}", f"{height:.0f}", figure.title, title, Markup("").join(parts)
    )


def _frame(figure: Figure, panel: Panel, x: _Scale, y: _Scale, lowest: bool) -> Iterable[Markup]:
    x_unit, x_factor = scale(figure.x_unit, max(abs(x.low), abs(x.high)))
    y_unit, y_factor = scale(panel.unit, max(abs(y.low), abs(y.high)))
    for at, text in _ticks(x, x_factor, 8 if x.stop - x.start > 500 else 5):
        yield _line("grid", at, y.stop, at, y.start)
        if lowest:
            yield _text("tick mid", at, y.start + 16, text)
    for at, text in _ticks(y, y_factor, 5):
        yield _line("grid", x.start, at, x.stop, at)
        yield _text("tick end", x.start - 6, at + 4, text)
    if not x.log and x.low < 0.0 < x.high:
        yield _line("zero", float(x(np.array(0.0))), y.stop, float(x(np.array(0.0))), y.start)
    if not y.log and y.low < 0.0 < y.high:
        yield _line("zero", x.start, float(y(np.array(0.0))), x.stop, float(y(np.array(0.0))))
    yield Markup('<rect class="frame" x="{}" y="{}" width="{}" height="{}"/>').format(
        _n(x.start), _n(y.stop), _n(x.stop - x.start), _n(y.start - y.stop)
    )
    if lowest:
        yield _text("label mid", (x.start + x.stop) / 2, y.start + 36, _label(figure.x_name, x_unit))
    middle = (y.start + y.stop) / 2
    yield Markup('<text class="label mid" transform="translate({} {}) rotate(-90)">{}</text>').format(
        _n(x.start - 56), _n(middle), _label(panel.name, y_unit)
    )


def _label(name: str, unit: str) -> str:
    return name if unit in ("", "1") else f"{name} in {unit}"


def _ticks(axis: _Scale, factor: float, about: int) -> list[tuple[float, str]]:
    if axis.log:
        values = log_ticks(axis.low * factor, axis.high * factor)
        return [(float(axis(np.array(v / factor))), significant(float(v), 1)) for v in values]
    values, decimals = linear_ticks(axis.low * factor, axis.high * factor, about)
    return [(float(axis(np.array(v / factor))), f"{v + 0.0:.{decimals}f}".replace("-", "−")) for v in values]


def _content(figure: Figure, panel: Panel, x: _Scale, y: _Scale, models: Sequence[str]) -> Iterable[Markup]:
    for start, stop in figure.gaps:
        left, right = float(x(np.array(start))), float(x(np.array(stop)))
        yield Markup('<rect class="gap" x="{}" y="{}" width="{}" height="{}"/>').format(
            _n(left), _n(y.stop), _n(max(right - left, 0.5)), _n(y.start - y.stop)
        )
    if panel.cells is not None:
        yield from _cells(panel.cells, x, y)
    for positions in figure.marks.values():
        d = "".join(f"M{_n(float(at))} {_n(y.stop)}V{_n(y.start)}" for at in x(positions))
        yield Markup('<path class="mark" d="{}"/>').format(d)
    for band in panel.bands:
        yield _band(band, x, y, models)
    for line in panel.lines:
        dash = " dash" if line.dashed else ""
        yield Markup('<path class="line {}{}" d="{}"/>').format(
            slot(line.role, models), dash, _path(thinned(line, BUCKETS), x, y)
        )
    for points in panel.points:
        yield from _points(points, x, y, models)


def _cells(cells: Cells, x: _Scale, y: _Scale) -> Iterable[Markup]:
    """Runs of equal cells of a row as one rectangle."""
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
            yield Markup('<rect class="cell{}" x="{}" y="{}" width="{}" height="{}"/>').format(
                int(values[first]), _n(left), _n(top), _n(right - left), _n(bottom - top + SEAM)
            )


def _band(band: Band, x: _Scale, y: _Scale, models: Sequence[str]) -> Markup:
    there = [f"{_n(a)} {_n(b)}" for a, b in zip(x(band.x), y(band.high), strict=True)]
    back = [f"{_n(a)} {_n(b)}" for a, b in zip(x(band.x)[::-1], y(band.low)[::-1], strict=True)]
    return Markup('<path class="band {}" d="M{}Z"/>').format(slot(band.role, models), "L".join(there + back))


def _path(line: Line, x: _Scale, y: _Scale) -> str:
    known = np.isfinite(line.x) & np.isfinite(line.y)
    starts = known & ~np.r_[False, known[:-1]]
    inside = [(a, b, s) for a, b, k, s in zip(x(line.x), y(line.y), known, starts, strict=True) if k]
    return "".join(f"{'M' if s else 'L'}{_n(a)} {_n(b)}" for a, b, s in inside)


def _points(points: Points, x: _Scale, y: _Scale, models: Sequence[str]) -> Iterable[Markup]:
    for a, b in zip(x(points.x), y(points.y), strict=True):
        if points.marker == "cross":
            d = f"M{_n(a - 5)} {_n(b - 5)}l10 10m0 -10l-10 10"
            yield Markup('<path class="line {}" d="{}"/>').format(slot(points.role, models), d)
        else:
            yield Markup('<circle class="{} {}" cx="{}" cy="{}" r="5"/>').format(
                points.marker, slot(points.role, models), _n(a), _n(b)
            )


def _line(name: str, x1: float, y1: float, x2: float, y2: float) -> Markup:
    return Markup('<path class="{}" d="M{} {}L{} {}"/>').format(name, _n(x1), _n(y1), _n(x2), _n(y2))


def _text(name: str, x: float, y: float, text: str) -> Markup:
    return Markup('<text class="{}" x="{}" y="{}">{}</text>').format(name, _n(x), _n(y), escape(text))


def _n(value: float) -> str:
    return f"{value:.1f}".removesuffix(".0")
