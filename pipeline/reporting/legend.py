"""The legend of a figure: every label once, measurements first, then the models in their order."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Literal

from markupsafe import Markup

from .figure import Dash, Figure, Panel, line_kind

Kind = Literal[
    "mark", "snap", "cell0", "cell1", "cell2", "cell3", "band", "line", "wide", "trace", "dot", "ring", "cross"
]
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


def dashes(role: str, models: Sequence[str]) -> tuple[float, ...]:
    """Dash pattern of a role."""
    return slot_dashes(slot(role, models))


@dataclass(frozen=True)
class Style:
    """What is drawn, and the colour class (`pipeline.reporting.legend.slot`) of whom it shows."""

    kind: Kind
    slot: str = ""
    dash: Dash = "role"


@dataclass(frozen=True)
class LegendEntry:
    """A label and what it names."""

    label: str
    style: Style


CHOSEN = "chosen for the logs"
MARKS = {
    "voltage switched": Style("mark"),
    "voltage steps": Style("mark"),
    "input steps": Style("mark"),
    "device snaps over": Style("snap"),
    CHOSEN: Style("snap"),
}


def entries(figure: Figure, models: Sequence[str], *, marks: bool = False) -> list[LegendEntry]:
    """Everything that is drawn, hidden lines too, each label once; with the `marks` along the axis or without."""
    styles: dict[str, Style] = {}
    for panel in figure.panels:
        for label, style in _of(panel, models):
            styles.setdefault(label, style)
    ordered = sorted((LegendEntry(*item) for item in styles.items()), key=lambda entry: _place(entry.style))
    return ordered + [LegendEntry(name, MARKS[name]) for name in figure.marks if marks and name in MARKS]


def _of(panel: Panel, models: Sequence[str]) -> Iterator[tuple[str, Style]]:
    if panel.cells is not None:
        for number, label in enumerate(panel.cells.labels):
            if (panel.cells.index == number).any():
                yield label, Style(f"cell{number}")  # type: ignore[arg-type]
    for band in panel.bands:
        yield band.label, Style("band", slot(band.role, models))
    for line in panel.lines:
        yield line.label, Style(line_kind(line), slot(line.role, models), line.dash)
    for points in panel.points:
        yield points.label, Style(points.marker, slot(points.role, models))


def _place(style: Style) -> tuple[int, int]:
    """Areas, lines of the measurement, lines of the models in their order, points."""
    model = int(style.slot[1:]) if style.slot[:1] == "m" and style.slot[1:].isdigit() else -1
    group = 0 if style.kind.startswith("cell") else 2 if style.kind in ("dot", "ring", "cross") else 1
    return group, model


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


def swatches(figure: Figure, models: Sequence[str], *, marks: bool = False) -> list[tuple[str, Markup]]:
    """Label and sample of everything that is drawn, each label once, for the page: 30 by 12 units, with classes."""
    return [_swatch(entry) for entry in entries(figure, models, marks=marks)]


def event_swatches(figure: Figure) -> list[tuple[str, Markup]]:
    """Label and sample of the upright lines of a figure."""
    return [_swatch(LegendEntry(name, MARKS[name])) for name in figure.marks if name in MARKS]


def _swatch(entry: LegendEntry) -> tuple[str, Markup]:
    style = entry.style
    dashed = "dash" if style.dash in ("dashed", "dotted") else ""
    names = " ".join(part for part in (style.kind, style.slot, dashed) if part)
    shape = _SHAPES.get(style.kind.rstrip("0123"), _LINE)
    return entry.label, Markup(shape).format(names)  # noqa: S704 - a literal above
