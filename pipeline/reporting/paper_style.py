"""Colours and widths on paper, in points; the page has its own in ``style.css``, by the same names."""

from dataclasses import dataclass

from pipeline.reporting.palette import slot_colour, slot_dashes
from pipeline.reporting.shapes import Style

LETTERS = "#16191d"
GROUND = "#ffffff"
BAND_OPACITY = 0.2


@dataclass(frozen=True)
class PaperStyle:
    """How a shape is drawn: None draws no outline, or no inside.

    Attributes
    ----------
    stroke, fill : str or None
        Colours.
    width : float
        Of the stroke [pt].
    dashes : tuple of float
        On and off [pt]; empty for a solid line.
    opacity : float
        Of the inside.
    """

    stroke: str | None = None
    fill: str | None = None
    width: float = 0.0
    dashes: tuple[float, ...] = ()
    opacity: float = 1.0


_FIXED = {
    "frame": PaperStyle("#6a737f", width=0.5),
    "grid": PaperStyle("#dfe3e8", width=0.3),
    "zero": PaperStyle("#a9b1bb", width=0.4),
    "gap": PaperStyle(fill="#e6e6e6"),
    "mark": PaperStyle("#b0b7c0", width=0.4),
    "snap": PaperStyle("#8a5a9e", width=0.5, dashes=(2.5, 2.0)),
    "cell0": PaperStyle(fill="#dceaf5"),
    "cell1": PaperStyle(fill="#fbe3d3"),
    "cell2": PaperStyle(fill="#e4e4e4"),
}
_WIDTHS = {"line": 0.8, "wide": 1.7, "trace": 0.4, "dot": 0.6, "ring": 1.0, "cross": 1.0}


def paper_style(style: Style) -> PaperStyle:
    """How a shape of this style is drawn."""
    if style.kind in _FIXED:
        return _FIXED[style.kind]
    colour = slot_colour(style.slot)
    if style.kind == "band":
        return PaperStyle(fill=colour, opacity=BAND_OPACITY)
    dashes: tuple[float, ...] = ()
    if style.kind in ("line", "wide", "trace"):
        dashes = (3.0, 2.0) if style.dashed else slot_dashes(style.slot)
    # A dot's light edge parts it from the lines that it lies on.
    stroke = GROUND if style.kind == "dot" else colour
    fill = {"dot": colour, "ring": GROUND}.get(style.kind)
    return PaperStyle(stroke, fill, _WIDTHS[style.kind], dashes)
