"""A drawing as a matplotlib artist: its renderers write PDF and PNG, with fonts embedded, and lay nothing out."""

from typing import Any

import numpy as np
from matplotlib.artist import Artist
from matplotlib.backend_bases import GraphicsContextBase, RendererBase
from matplotlib.colors import to_rgba
from matplotlib.font_manager import FontProperties
from matplotlib.path import Path
from matplotlib.transforms import Affine2D

from pipeline.numerics.arrays import FloatArray
from pipeline.reporting.figure_font import register
from pipeline.reporting.paper_style import LETTERS, PaperStyle, paper_style
from pipeline.reporting.shapes import Area, Box, Disc, Drawing, Stroke, Text

POINTS_PER_INCH = 72.0


class DrawingArtist(Artist):
    """Draws the shapes of a drawing in units of points.

    Parameters
    ----------
    drawing : Drawing
        Its y counts downwards, that of a renderer upwards.
    """

    def __init__(self, drawing: Drawing) -> None:
        super().__init__()
        self._drawing = drawing
        self._font = FontProperties(family=list(register()), size=drawing.text)

    def draw(self, renderer: RendererBase) -> None:
        """Draw all shapes, the first at the bottom."""
        figure: Any = self.get_figure(root=True)
        zoom = figure.dpi / POINTS_PER_INCH
        place = Affine2D().scale(zoom, -zoom).translate(0.0, zoom * self._drawing.height)
        for shape in self._drawing.shapes:
            if isinstance(shape, Text):
                self._write(renderer, shape, place, zoom)
            else:
                style = paper_style(shape.style)
                renderer.draw_path(_pen(renderer, style), _path(shape), place, _inside(style))

    def _write(self, renderer: RendererBase, text: Text, place: Affine2D, zoom: float) -> None:
        width, _, _ = renderer.get_text_width_height_descent(text.text, self._font, ismath=False)
        back = {"start": 0.0, "mid": width / 2.0, "end": width}[text.anchor]
        x, y = place.transform((text.x, text.y))
        x, y = (x, y - back) if text.turned else (x - back, y)
        if renderer.flipy():
            y = zoom * self._drawing.height - y
        pen = renderer.new_gc()
        pen.set_foreground(LETTERS)
        renderer.draw_text(pen, x, y, text.text, self._font, 90.0 if text.turned else 0.0, ismath=False)


def _pen(renderer: RendererBase, style: PaperStyle) -> GraphicsContextBase:
    pen = renderer.new_gc()
    pen.set_linewidth(style.width if style.stroke is not None else 0.0)
    if style.stroke is not None:
        pen.set_foreground(style.stroke)
    pen.set_joinstyle("round")
    if style.dashes:
        pen.set_dashes(0.0, list(style.dashes))
    pen.set_alpha(style.opacity)
    return pen


def _inside(style: PaperStyle) -> tuple[float, float, float, float] | None:
    return None if style.fill is None else to_rgba(style.fill, style.opacity)


def _path(shape: Stroke | Area | Box | Disc) -> Path:
    if isinstance(shape, Stroke):
        return _joined(shape.paths)
    if isinstance(shape, Area):
        return Path(np.vstack([shape.outline, shape.outline[:1]]), closed=True)
    if isinstance(shape, Box):
        left, top, right, bottom = shape.x, shape.y, shape.x + shape.width, shape.y + shape.height
        return Path(np.array([[left, top], [right, top], [right, bottom], [left, bottom], [left, top]]), closed=True)
    return Path.circle((shape.x, shape.y), shape.radius)


def _joined(paths: tuple[FloatArray, ...]) -> Path:
    """Stretches as one path, each begun anew."""
    points = np.concatenate(paths) if paths else np.empty((0, 2))
    codes = np.full(len(points), Path.LINETO, dtype=np.uint8)
    codes[np.cumsum([0, *(len(path) for path in paths[:-1])])[: len(paths)]] = Path.MOVETO
    return Path(points, codes)
