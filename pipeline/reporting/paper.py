"""Figures for a paper: SVG, PDF or PNG, the same bytes for the same figure, without any date in them."""

import io
import re
import warnings
from collections.abc import Sequence
from typing import Any, Literal

from pipeline.reporting.figure import Figure
from pipeline.reporting.plotted import Typeface, paper_look, plotted

Format = Literal["svg", "pdf", "png"]

PNG_DOTS_PER_INCH = 200.0
SVG: dict[str, Any] = {"svg.fonttype": "none", "svg.hashsalt": "debist"}
_FILES: Any = {**SVG, "pdf.fonttype": 42, "pdf.compression": 6}  # outlines: journals refuse fonts of type 3
_METADATA: dict[str, dict[str, Any]] = {
    "svg": {"Date": None, "Creator": "debist"},
    "pdf": {"CreationDate": None, "Creator": "debist", "Producer": "debist"},
    "png": {"Software": "debist"},
}
_UNWRITABLE = re.compile("[^\t\n\r\x20-\x7e\xa0-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")  # XML 1.0, section 2.2


def paper_figure(figure: Figure, models: Sequence[str], *formats: Format, typeface: Typeface = "sans") -> list[bytes]:
    """The figure in each of the formats. Cost: 0.1 to 0.4 s each."""
    import matplotlib as mpl

    look, written = paper_look(figure, typeface), []
    with mpl.rc_context({**look.settings, **_FILES}), warnings.catch_warnings():
        warnings.filterwarnings("ignore", "Glyph .* missing from font", UserWarning)  # it is drawn as a box
        canvas = plotted(figure, models, look)
        for kind in formats:
            buffer = io.BytesIO()
            canvas.savefig(buffer, format=kind, metadata=_METADATA[kind], dpi=PNG_DOTS_PER_INCH)
            written.append(buffer.getvalue())
    return written
