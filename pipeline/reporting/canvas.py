"""Figures as files for a paper and as SVG on the page: the same numbers give the same bytes."""

import io
import re
import warnings
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

from markupsafe import Markup, escape

from ..errors import InputError
from ..system.names import Typeface
from .figure import Figure, writable
from .legend import swatches
from .plotted import Look, paper_look, plotted, sans

if TYPE_CHECKING:
    from matplotlib.figure import Figure as Canvas

Format = Literal["svg", "pdf", "png"]
FORMATS = (".svg", ".pdf", ".png")
_METADATA: dict[str, dict[str, Any]] = {
    ".svg": {"Date": None, "Creator": "debist"},
    ".pdf": {"CreationDate": None, "Creator": "debist", "Producer": "debist"},
    ".png": {"Software": "debist"},
}
_STYLE: Any = {"svg.hashsalt": "debist", "pdf.fonttype": 42}  # outlines: journals refuse fonts of type 3
_DOTS_PER_INCH = 200
WHOLE = Look(width=8.4, panel_height=2.6, legend=False)
PART = Look(width=5.6, panel_height=2.5, legend=False, letters=False)
_INLINE = re.compile(r' style="([^"]*)"')
_MARKER = re.compile(r"<defs>\s*<path [^>]*>\s*</defs>")
_STROKE = re.compile(r' stroke(?:-[a-z]+)?="[^"]*"')
_HEAD = re.compile(r"<svg .*?>", re.DOTALL)
_LEFT_OUT = re.compile(r"<metadata>.*?</metadata>|<style .*?</style>|<!--.*?-->| id=\"(?:figure|axes|patch|line2d|text|"
                       r"matplotlib|xtick|ytick|FillBetween|LineCollection|PathCollection|QuadContourSet)[^\"]*\"",
                       re.DOTALL)  # fmt: skip


def drawn(figure: Any, *endings: str, families: Sequence[str] | None = None) -> list[bytes]:
    """The figure as the bytes of SVG, PDF or PNG files, without a date in them.

    Letters come from the first of the font families that has them. In an SVG they are outlines: as text they would be
    set in another font where that one is not installed, and run into one another.

    Cost: 0.1 s for the layout, which all share, 0.1 s for each file.
    """
    import matplotlib as mpl
    from matplotlib.text import Text

    files = []
    fonts = families or sans()
    with mpl.rc_context(_STYLE | {"font.family": fonts, "svg.fonttype": "path"}), warnings.catch_warnings():
        warnings.filterwarnings("ignore", "Glyph .* missing from font", UserWarning)  # it is drawn as a box
        for text in figure.findobj(Text):
            text.set_fontfamily(fonts)
        _lay_out(figure)
        for ending in endings:
            buffer = io.BytesIO()
            figure.savefig(buffer, format=ending[1:], metadata=_METADATA.get(ending), dpi=_DOTS_PER_INCH)
            files.append(buffer.getvalue())
    return files


def _lay_out(canvas: "Canvas") -> None:
    """Find the places of a figure's parts, which saving would otherwise draw it once more for."""
    engine = canvas.get_layout_engine()
    if engine is not None:
        engine.execute(canvas)
    canvas.set_layout_engine(None)


def form_of(target: Path) -> Format:
    """The format by a file's ending.

    Raises
    ------
    InputError
        It is not in `FORMATS`.
    """
    if target.suffix not in FORMATS:
        raise InputError(f"{target}: figures are written as {', '.join(FORMATS)}")
    form: Format = target.suffix[1:]  # type: ignore[assignment]
    return form


def save(figure: "Figure | Canvas", target: Path, models: Sequence[str]) -> None:
    """Write a figure; errors as for `form_of`."""
    form = form_of(target)
    contents = paper_figure(figure, models, form) if isinstance(figure, Figure) else drawn(figure, target.suffix)
    target.write_bytes(contents[0])


def paper_figure(figure: Figure, models: Sequence[str], *formats: Format, typeface: Typeface = "sans") -> list[bytes]:
    """The figure in each of the formats. Cost: 0.1 to 0.4 s each."""
    import matplotlib as mpl

    look = paper_look(figure, typeface)
    with mpl.rc_context(look.settings):
        canvas = plotted(figure, models, look)
        return drawn(canvas, *(f".{kind}" for kind in formats), families=look.families)


def page_chart(figure: Figure, models: Sequence[str]) -> list[Markup]:
    """The figure as one ``<svg>``, or as one for each of panels beside another."""
    if figure.columns > 1:
        return [_svg(_single(figure, number), models, PART) for number in range(len(figure.panels))]
    return [_svg(figure, models, PART if figure.half else WHOLE)]


def _single(figure: Figure, number: int) -> Figure:
    panel = figure.panels[number]
    title = figure.title if len(figure.panels) == 1 else f"{figure.title}: {panel.name}"
    return replace(figure, title=title, panels=(panel,), columns=1)


def _svg(figure: Figure, models: Sequence[str], look: Look) -> Markup:
    import matplotlib as mpl
    from matplotlib.backends.backend_svg import FigureCanvasSVG

    text = io.StringIO()
    # The salt keeps the names of shapes that are used twice apart from those of other figures on the page.
    with mpl.rc_context({**look.settings, "svg.fonttype": "none", "svg.hashsalt": f"{figure.name} {figure.title}"}):
        canvas = plotted(figure, models, look)
        FigureCanvasSVG(canvas)  # whose letters the layout measures
        _lay_out(canvas)
        canvas.savefig(text, format="svg", metadata={"Date": None}, transparent=True)
    drawn = _INLINE.sub(lambda match: _attributes(match[1]), _LEFT_OUT.sub("", text.getvalue()))
    drawn = drawn.replace("xlink:href=", "href=")
    # A marker takes the stroke of where it is used: the theme's style does not reach into its shape.
    drawn = _MARKER.sub(lambda match: _STROKE.sub("", match[0]), drawn)
    head = _HEAD.search(drawn)
    assert head is not None  # noqa: S101 - matplotlib writes one
    box = re.search(r'viewBox="[^"]*"', head[0])
    inside = drawn[head.end() : drawn.rindex("</svg>")]
    opened = f'<svg class="chart" {box[0] if box else ""} role="img" aria-label="{escape(writable(figure.title))}">'
    return Markup(f"{opened}<title>{escape(writable(figure.title))}</title>{inside}</svg>")  # noqa: S704 - texts are escaped


def chart(figure: Figure, models: Sequence[str]) -> dict[str, Any]:
    """A figure for a template: the figure, its drawings and its legend."""
    return {"figure": figure, "drawings": page_chart(figure, models), "legend": swatches(figure, models, marks=True)}


def _attributes(style: str) -> str:
    """A style as presentation attributes; the style sheet sets the letters, except their anchor."""
    pairs = (part.split(":", 1) for part in style.split(";") if ":" in part)
    named = [(key.strip(), value.strip()) for key, value in pairs]
    return "".join(f' {key}="{escape(value)}"' for key, value in named if key != "font")
