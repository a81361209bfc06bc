"""Figures for paper, drawn with matplotlib: one size of panel, panel letters, the same numbers give the same bytes."""

import io
import re
import string
import warnings
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any, Literal

from markupsafe import Markup, escape

from pipeline.errors import InputError
from pipeline.reporting.figure import Figure, writable
from pipeline.reporting.plotted import Look, Typeface, paper_look, plotted

Format = Literal["svg", "pdf", "png"]
FORMATS = (".svg", ".pdf", ".png")
_METADATA: dict[str, dict[str, Any]] = {
    ".svg": {"Date": None, "Creator": "debist"},
    ".pdf": {"CreationDate": None, "Creator": "debist", "Producer": "debist"},
    ".png": {"Software": "debist"},
}
_STYLE: Any = {"svg.hashsalt": "debist", "pdf.fonttype": 42}  # outlines: journals refuse fonts of type 3
_DOTS_PER_INCH = 200
WHOLE, PART = (
    Look(width=8.4, panel_height=2.6, legend=False),
    Look(width=5.6, panel_height=2.5, legend=False, letters=False),
)
_INLINE = re.compile(r' style="([^"]*)"')
_HEAD = re.compile(r"<svg .*?>", re.DOTALL)
_LEFT_OUT = re.compile(r"<metadata>.*?</metadata>|<style .*?</style>|<!--.*?-->| id=\"(?:figure|axes|patch|line2d|text|"
                       r"matplotlib|xtick|ytick|FillBetween|LineCollection|PathCollection|QuadContourSet)[^\"]*\"",
                       re.DOTALL)  # fmt: skip


def new_figure(rows: int, columns: int, width: float = 7.0, height: float = 3.0, *, share_x: bool = False) -> Any:
    """A figure of rows × columns panels, `height` inches each, and its axes as an array (rows, columns)."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(width, height * rows), layout="constrained")
    return figure, figure.subplots(rows, columns, squeeze=False, sharex=share_x)


def label(axes: Any, x: str, y: str, title: str = "") -> None:
    """Axis labels with their units, a title on the left and a light grid."""
    axes.set_xlabel(x)
    axes.set_ylabel(y)
    if title:
        axes.set_title(title, fontsize="medium", loc="left")
    axes.grid(visible=True, linewidth=0.3)


def letter(figure: Any) -> None:
    """Mark the panels (a), (b), … where there is more than one."""
    if len(figure.axes) > 1:
        for name, axes in zip(string.ascii_lowercase, figure.axes, strict=False):
            axes.annotate(
                f"({name})", (0.0, 1.0), xycoords="axes fraction", xytext=(-6, 5), textcoords="offset points",
                ha="right", fontsize="small", annotation_clip=False,
            )  # fmt: skip


def drawn(
    figure: Any, *endings: str, families: Sequence[str] | None = None, letters: Literal["path", "none"] = "path"
) -> list[bytes]:
    """The figure as the bytes of SVG, PDF or PNG files, without a date in them.

    In an SVG, letters are outlines ("path") or text ("none"), in the first of the font families that has them.

    Cost: 0.1 s for the layout, which all share, 0.1 s for each file.
    """
    import matplotlib as mpl
    from matplotlib.text import Text

    from pipeline.reporting.figure_font import register

    files, known = [], families or register()
    with mpl.rc_context(_STYLE | {"font.family": known, "svg.fonttype": letters}), warnings.catch_warnings():
        warnings.filterwarnings("ignore", "Glyph .* missing from font", UserWarning)  # it is drawn as a box
        for text in figure.findobj(Text):
            text.set_fontfamily(known)
        figure.get_layout_engine().execute(figure)
        figure.set_layout_engine("none")
        for ending in endings:
            buffer = io.BytesIO()
            figure.savefig(buffer, format=ending[1:], metadata=_METADATA.get(ending), dpi=_DOTS_PER_INCH)
            files.append(buffer.getvalue())
    return files


def save(figure: Any, target: Path) -> None:
    """Write the figure.

    Raises
    ------
    InputError
        The file's ending is none of `FORMATS`.
    """
    if target.suffix not in FORMATS:
        raise InputError(f"{target}: figures are written as {', '.join(FORMATS)}")
    target.write_bytes(drawn(figure, target.suffix)[0])


def paper_figure(figure: Figure, models: Sequence[str], *formats: Format, typeface: Typeface = "sans") -> list[bytes]:
    """The figure in each of the formats. Cost: 0.1 to 0.4 s each."""
    import matplotlib as mpl

    look = paper_look(figure, typeface)
    with mpl.rc_context(look.settings):
        canvas = plotted(figure, models, look)
        return drawn(canvas, *(f".{kind}" for kind in formats), families=look.families, letters="none")


def page_chart(figure: Figure, models: Sequence[str]) -> list[Markup]:
    """The figure as one ``<svg>``, or as one for each of panels beside another."""
    if figure.columns > 1 or figure.half:
        parts = [_single(figure, number) for number in range(len(figure.panels))]
        return [_svg(part, models, PART) for part in parts]
    return [_svg(figure, models, WHOLE)]


def _single(figure: Figure, number: int) -> Figure:
    panel = figure.panels[number]
    title = figure.title if len(figure.panels) == 1 else f"{figure.title}: {panel.name}"
    return replace(figure, title=title, panels=(panel,), columns=1)


def _svg(figure: Figure, models: Sequence[str], look: Look) -> Markup:
    import matplotlib as mpl

    text = io.StringIO()
    # The salt keeps the names of shapes that are used twice apart from those of other figures on the page.
    with mpl.rc_context({**look.settings, "svg.fonttype": "none", "svg.hashsalt": f"{figure.name} {figure.title}"}):
        plotted(figure, models, look).savefig(text, format="svg", metadata={"Date": None}, transparent=True)
    drawn = _INLINE.sub(lambda found: _attributes(found[1]), _LEFT_OUT.sub("", text.getvalue()))
    drawn = drawn.replace("xlink:href=", "href=")
    head = _HEAD.search(drawn)
    assert head is not None  # noqa: S101 - matplotlib writes one
    box = re.search(r'viewBox="[^"]*"', head[0])
    inside = drawn[head.end() : drawn.rindex("</svg>")]
    opened = f'<svg class="chart" {box[0] if box else ""} role="img" aria-label="{escape(writable(figure.title))}">'
    return Markup(f"{opened}<title>{escape(writable(figure.title))}</title>{inside}</svg>")  # noqa: S704 - texts are escaped


def _attributes(style: str) -> str:
    """A style as presentation attributes; how letters are set says the style sheet, but for their anchor."""
    pairs = (part.split(":", 1) for part in style.split(";") if ":" in part)
    named = [(key.strip(), value.strip()) for key, value in pairs]
    return "".join(f' {key}="{escape(value)}"' for key, value in named if key != "font")
