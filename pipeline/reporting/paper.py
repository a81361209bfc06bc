"""Figures for a paper: SVG, PDF or PNG, the same bytes for the same figure, without any date in them.

All three are the same drawing; matplotlib only writes the last two. Names come from logs, so nothing is ever read as
mathtext: a channel called ``$\\frac{1}{$`` stands there as it is.
"""

import io
import warnings
from collections.abc import Sequence
from typing import Any, Literal

from pipeline.reporting.drawing import lay_out, paper_sheet
from pipeline.reporting.figure import Figure
from pipeline.reporting.svg import svg_file

Format = Literal["svg", "pdf", "png"]

POINTS_PER_INCH = 72.0
PNG_DOTS_PER_INCH = 200.0
_STYLE: Any = {"pdf.fonttype": 42, "pdf.compression": 1}
_METADATA: dict[str, dict[str, Any]] = {
    "pdf": {"CreationDate": None, "Creator": "debist", "Producer": "debist"},
    "png": {"Software": "debist"},
}


def paper_figure(figure: Figure, models: Sequence[str], *formats: Format) -> list[bytes]:
    """The figure in each of the formats."""
    canvas = _canvas(figure, models) if any(kind != "svg" for kind in formats) else None
    return [svg_file(figure, models).encode() if kind == "svg" else _saved(canvas, kind) for kind in formats]


def _canvas(figure: Figure, models: Sequence[str]) -> Any:
    """A matplotlib figure that holds the drawing as its only artist."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure as Canvas

    from pipeline.reporting.drawing_artist import DrawingArtist

    drawing = lay_out(figure, models, paper_sheet(figure))
    canvas = Canvas(figsize=(drawing.width / POINTS_PER_INCH, drawing.height / POINTS_PER_INCH))
    FigureCanvasAgg(canvas)
    canvas.add_artist(DrawingArtist(drawing))
    return canvas


def _saved(canvas: Any, kind: Format) -> bytes:
    import matplotlib as mpl

    buffer = io.BytesIO()
    with mpl.rc_context(_STYLE), warnings.catch_warnings():
        warnings.filterwarnings("ignore", "Glyph .* missing from font", UserWarning)  # it is drawn as a box
        canvas.savefig(buffer, format=kind, metadata=_METADATA[kind], dpi=PNG_DOTS_PER_INCH)
    return buffer.getvalue()
