"""The legend of a figure: every label once, measurements first, then the models in their order."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from pipeline.reporting.figure import Figure, Panel, line_kind
from pipeline.reporting.figure_font import text_width
from pipeline.reporting.palette import slot
from pipeline.reporting.shapes import Area, Box, Disc, Shape, Stroke, Style, Text

SAMPLE, GAP, BETWEEN, ROW = 2.4, 0.5, 1.4, 1.5  # in heights of the letters
CHOSEN = "chosen for the logs"
MARKS = {"voltage switched": Style("mark"), "device snaps over": Style("snap"), CHOSEN: Style("snap")}


@dataclass(frozen=True)
class Entry:
    """A label and what it names."""

    label: str
    style: Style


def entries(figure: Figure, models: Sequence[str], *, marks: bool = False) -> list[Entry]:
    """Everything that is drawn, hidden lines too, each label once; with the `marks` along the axis or without."""
    found: dict[str, Style] = {}
    for panel in figure.panels:
        for label, style in _of(panel, models):
            found.setdefault(label, style)
    known = sorted((Entry(*one) for one in found.items()), key=lambda entry: _place(entry.style))
    return known + [Entry(name, MARKS[name]) for name in figure.marks if marks and name in MARKS]


def _of(panel: Panel, models: Sequence[str]) -> Iterator[tuple[str, Style]]:
    if panel.cells is not None:
        for number, label in enumerate(panel.cells.labels):
            if (panel.cells.index == number).any():
                yield label, Style(f"cell{number}")  # type: ignore[arg-type]
    for band in panel.bands:
        yield band.label, Style("band", slot(band.role, models))
    for line in panel.lines:
        yield line.label, Style(line_kind(line), slot(line.role, models), line.dashed)
    for points in panel.points:
        yield points.label, Style(points.marker, slot(points.role, models))


def _place(style: Style) -> tuple[int, int]:
    """Areas, lines of the measurement, lines of the models in their order, points."""
    model = int(style.slot[1:]) if style.slot[:1] == "m" and style.slot[1:].isdigit() else -1
    group = 0 if style.kind.startswith("cell") else 2 if style.kind in ("dot", "ring", "cross") else 1
    return group, model


def legend(figure: Figure, models: Sequence[str], left: float, width: float, text: float) -> tuple[list[Shape], float]:
    """The legend in rows from `left`, starting at the top, and its height; none of a single line.

    Parameters
    ----------
    figure : Figure
        Its hidden lines are left out.
    models : sequence of str
        All models of the run.
    left, width : float
        Where the rows start, and how long they may be.
    text : float
        Height of the letters.
    """
    shown = [entry for entry in entries(figure, models, marks=True) if entry.label not in figure.hidden]
    if len(shown) < 2:
        return [], 0.0
    shapes: list[Shape] = []
    x, row = left, 0
    for entry in shown:
        size = (SAMPLE + GAP + text_width(entry.label)) * text
        if x > left and x + size > left + width:
            x, row = left, row + 1
        base = (row * ROW + 1.2) * text
        shapes += sample(entry.style, x, base - 0.36 * text, SAMPLE * text, text)
        shapes.append(Text(entry.label, x + (SAMPLE + GAP) * text, base))
        x += size + BETWEEN * text
    return shapes, ((row + 1) * ROW + 0.2) * text


def sample(style: Style, x: float, y: float, width: float, text: float) -> list[Shape]:
    """What a legend shows beside a label, from `x` over `width`, its middle at `y`."""
    if style.kind.startswith("cell"):
        return [Box(style, x, y - 0.45 * text, width, 0.9 * text)]
    if style.kind == "band":
        low, high = y + 0.45 * text, y - 0.45 * text
        return [Area(style, np.array([[x, high], [x + width, high], [x + width, low], [x, low]]))]
    if style.kind in ("dot", "ring"):
        return [Disc(style, x + width / 2, y, 0.36 * text)]
    if style.kind in ("mark", "snap"):
        return [Stroke(style, (np.array([[x + width / 2, y + 0.5 * text], [x + width / 2, y - 0.5 * text]]),))]
    if style.kind == "cross":
        return [Stroke(style, cross(x + width / 2, y, 0.36 * text))]
    return [Stroke(style, (np.array([[x, y], [x + width, y]]),))]


def cross(x: float, y: float, arm: float) -> tuple[np.ndarray[tuple[int, int], np.dtype[np.float64]], ...]:
    """Two strokes that cross at a point."""
    return (
        np.array([[x - arm, y - arm], [x + arm, y + arm]]),
        np.array([[x - arm, y + arm], [x + arm, y - arm]]),
    )
