"""Drawings as SVG: on the page with classes, which style sheet, dark mode and print colour; in a file with colours."""

from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace

import numpy as np
from markupsafe import Markup, escape

from pipeline.numerics.arrays import FloatArray
from pipeline.reporting.drawing import PAGE, PAGE_PANEL, lay_out, paper_sheet
from pipeline.reporting.figure import Figure
from pipeline.reporting.figure_font import FAMILIES
from pipeline.reporting.legend import entries, sample
from pipeline.reporting.paper_style import LETTERS, paper_style
from pipeline.reporting.shapes import Area, Box, Drawing, Shape, Stroke, Style, Text

SWATCH = (30.0, 12.0)  # width and height of a legend's sample on the page
_ANCHORS = {"start": "start", "mid": "middle", "end": "end"}

# From a style, or a text, to the attributes of its element.
Look = Callable[[Style | Text], Markup]


def page_figure(figure: Figure, models: Sequence[str]) -> list[Markup]:
    """The figure for the page, without any inline style: one ``<svg>``, or one for each of panels beside another."""
    if figure.columns > 1 or figure.half:
        parts = [_single(figure, number) for number in range(len(figure.panels))]
        return [_page(lay_out(part, models, PAGE_PANEL)) for part in parts]
    return [_page(lay_out(figure, models, PAGE))]


def _single(figure: Figure, number: int) -> Figure:
    panel = figure.panels[number]
    title = figure.title if len(figure.panels) == 1 else f"{figure.title}: {panel.name}"
    return replace(figure, title=title, panels=(panel,), columns=1)


def _page(drawing: Drawing) -> Markup:
    inside = Markup("").join(_elements(drawing.shapes, _classes, 1))
    return Markup('<svg class="chart" viewBox="0 0 {:.0f} {:.0f}" role="img" aria-label="{}">{}{}</svg>').format(
        drawing.width, drawing.height, drawing.title, _title(drawing.title), inside
    )


def swatches(figure: Figure, models: Sequence[str], *, marks: bool = False) -> list[tuple[str, Markup]]:
    """Label and sample of everything that is drawn, each label once; see `legend.entries`."""
    width, height = SWATCH
    return [
        (
            entry.label,
            Markup("").join(_elements(sample(entry.style, 0.0, height / 2, width, height), _classes, 1)),
        )
        for entry in entries(figure, models, marks=marks)
    ]


def svg_file(figure: Figure, models: Sequence[str]) -> str:
    """The figure as an SVG document for a paper: its own colours, text as text, sizes in points, no date."""
    drawing = lay_out(figure, models, paper_sheet(figure))
    inside = Markup("").join(_elements(drawing.shapes, _coloured(models), 2))
    families = ", ".join(f"'{name}'" for name in FAMILIES)
    head = Markup(
        '<svg xmlns="http://www.w3.org/2000/svg" width="{0}pt" height="{1}pt" viewBox="0 0 {0} {1}" '
        'font-family="{2}, Verdana, sans-serif" font-size="{3:g}" fill="none" stroke-linejoin="round">'
    ).format(f"{drawing.width:.6g}", f"{drawing.height:.6g}", families, drawing.text)
    ground = Markup('<rect width="100%" height="100%" fill="#ffffff"/>')
    lines = Markup("\n").join([head + _title(drawing.title), ground, inside, Markup("</svg>")])
    return f'<?xml version="1.0" encoding="utf-8"?>\n{lines}\n'


def _title(title: str) -> Markup:
    return Markup("<title>{}</title>").format(title)


def _classes(of: Style | Text) -> Markup:
    parts = (of.kind, of.anchor) if isinstance(of, Text) else (of.kind, of.slot, "dash" if of.dashed else "")
    return Markup('class="{}"').format(" ".join(part for part in parts if part not in ("", "start")))


def _coloured(models: Sequence[str]) -> Look:
    """Presentation attributes, which every program that reads SVG understands; style sheets are not."""

    def look(of: Style | Text) -> Markup:
        if isinstance(of, Text):
            anchor = Markup(' text-anchor="{}"').format(_ANCHORS[of.anchor]) if of.anchor != "start" else ""
            return Markup('fill="{}"{}').format(LETTERS, anchor)
        found = paper_style(of)
        pairs = [
            ("stroke", found.stroke),
            ("stroke-width", f"{found.width:g}" if found.stroke else None),
            ("stroke-dasharray", " ".join(f"{d:g}" for d in found.dashes) or None),
            ("fill", found.fill),
            ("fill-opacity", f"{found.opacity:g}" if found.opacity < 1.0 else None),
        ]
        return Markup(" ").join(Markup('{}="{}"').format(key, value) for key, value in pairs if value is not None)

    return look


def _elements(shapes: Iterable[Shape], look: Look, decimals: int) -> Iterable[Markup]:
    for shape in shapes:
        yield _element(shape, look, decimals)


def _element(shape: Shape, look: Look, decimals: int) -> Markup:
    def n(value: float) -> str:
        return f"{round(value, decimals) + 0.0:.{decimals}f}".rstrip("0").rstrip(".")

    if isinstance(shape, Text):
        place = 'transform="translate({} {}) rotate(-90)"' if shape.turned else 'x="{}" y="{}"'
        at = Markup(place).format(n(shape.x), n(shape.y))  # noqa: S704 - one of the two literals above
        return Markup("<text {} {}>{}</text>").format(look(shape), at, escape(shape.text))
    attributes = look(shape.style)
    if isinstance(shape, Stroke):
        d = "".join(_path(path, decimals) for path in shape.paths)
        return Markup('<path {} d="{}"/>').format(attributes, d) if d else Markup()
    if isinstance(shape, Area):
        return Markup('<path {} d="{}Z"/>').format(attributes, _path(shape.outline, decimals))
    if isinstance(shape, Box):
        places = tuple(map(n, (shape.x, shape.y, shape.width, shape.height)))
        return Markup('<rect {} x="{}" y="{}" width="{}" height="{}"/>').format(attributes, *places)
    return Markup('<circle {} cx="{}" cy="{}" r="{}"/>').format(attributes, n(shape.x), n(shape.y), n(shape.radius))


def _path(points: FloatArray, decimals: int) -> str:
    """``M`` and the points of one stretch, without those inside a level part."""
    at = np.round(points, decimals) + 0.0
    y = at[:, 1]
    level = (y[1:-1] == y[:-2]) & (y[1:-1] == y[2:])
    forward = (at[1:-1, 0] - at[:-2, 0]) * (at[2:, 0] - at[1:-1, 0]) > 0.0
    kept = at[np.concatenate(([True], ~(level & forward), [True]))] if len(at) > 2 else at
    form = f"%.{decimals}f %.{decimals}f"
    return "M" + " ".join([form % (a, b) for a, b in kept.tolist()])
