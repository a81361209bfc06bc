"""A figure drawn with matplotlib, for a paper, the page and notebooks; the same numbers give the same bytes."""

import io
import math
import re
import warnings
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cache
from importlib.resources import as_file, files
from pathlib import Path
from typing import Any, Literal

import numpy as np
from markupsafe import Markup, escape

from ..errors import InputError
from ..numerics.arrays import FloatArray
from ..system.machine import import_configured
from ..system.names import Typeface
from ..system.package import full_name
from ..units.quantity import axis_scale, scale
from .figure import (
    MARKS,
    MOST_PLAIN,
    MOST_POWERS,
    Cells,
    Dash,
    Figure,
    Panel,
    Style,
    axis_label,
    entries,
    line_kind,
    log_label,
    shown,
    slot,
    slot_colour,
    slot_dashes,
    swatches,
    thinned,
    writable,
    x_range,
    y_range,
)

import_configured("matplotlib")
import matplotlib as mpl  # noqa: E402
from matplotlib import rc_params_from_file, ticker  # noqa: E402
from matplotlib.artist import Artist  # noqa: E402
from matplotlib.axes import Axes  # noqa: E402
from matplotlib.collections import LineCollection  # noqa: E402
from matplotlib.figure import Figure as Canvas  # noqa: E402

SERIF = ("STIXGeneral", "DejaVu Serif", "DejaVu Sans")
SANS = ("DejaVu Sans Figures", "DejaVu Sans")
FONT = "dejavu-sans-figures.ttf"
"""The first is an asset that `tests/reporting/figure_font.py` cuts out of the second: it embeds three times as fast."""
PAGE_WIDTH, COLUMN_WIDTH = 7.16, 3.5  # in, of a journal's page and column
LETTERS = 8.0  # pt
BUCKETS = 700  # of a long record: about a pixel's width each
BAND_OPACITY = 0.2
WIDTHS = {"line": 0.8, "wide": 1.7, "trace": 0.4}
CELL_COLOURS = ("#dceaf5", "#fbe3d3", "#e4e4e4", "#f0b088")
SMOOTHING = 0.8  # cells over which the edge between two classes of cells is smoothed
_MARK_COLOURS = {"mark": ("#b0b7c0", "-"), "snap": ("#8a5a9e", (0, (5, 4)))}
_DASHES: dict[str, tuple[float, ...]] = {"solid": (), "dashed": (3.0, 2.0), "dotted": (1.0, 1.6)}
_MARKERS = {"dot": "o", "ring": "o", "cross": "x"}
_STYLE: Any = {"svg.hashsalt": "debist", "pdf.fonttype": 42}  # outlines: journals refuse fonts of type 3
_DOTS_PER_INCH = 200  # of figures as PNG
_INLINE = re.compile(r' style="([^"]*)"')
_MARKER = re.compile(r"<defs>\s*<path [^>]*>\s*</defs>")
_STROKE = re.compile(r' stroke(?:-[a-z]+)?="[^"]*"')
_HEAD = re.compile(r'<svg .*?(viewBox="[^"]*").*?>', re.DOTALL)
_LEFT_OUT = re.compile(r"<metadata>.*?</metadata>|<style .*?</style>|<!--.*?-->| id=\"(?:figure|axes|patch|line2d|text|"
                       r"matplotlib|xtick|ytick|FillBetween|LineCollection|PathCollection|QuadContourSet)[^\"]*\"",
                       re.DOTALL)  # fmt: skip


@cache
def sans() -> tuple[str, ...]:
    """The families of the figures' font, which is made known to matplotlib once a process."""
    from matplotlib.font_manager import fontManager

    with as_file(files(full_name("reporting")) / "assets" / FONT) as path:
        fontManager.addfont(path)
    return SANS


@cache
def _style() -> dict[str, Any]:
    """The settings of the style sheet."""
    with as_file(files(full_name("reporting")) / "assets" / "figures.mplstyle") as path:
        settings: Any = rc_params_from_file(path, use_default_template=False)
    return dict(settings)


@dataclass(frozen=True)
class Look:
    """Typography and size of a figure.

    Attributes
    ----------
    typeface : {"sans", "serif"}
    width : float
        Inches.
    panel_height : float
        Inches, of a panel of the usual height.
    legend : bool
        Above the panels; the page writes its own beside the drawing.
    letters : bool
        (a), (b), … above the panels, if there are several.
    """

    typeface: Typeface = "sans"
    width: float = PAGE_WIDTH
    panel_height: float = 1.2
    legend: bool = True
    letters: bool = True

    @property
    def families(self) -> tuple[str, ...]:
        """Fonts, the first that has a letter is taken."""
        return sans() if self.typeface == "sans" else SERIF

    @property
    def settings(self) -> Any:
        """Settings of matplotlib. Names come from logs, so nothing is ever read as mathtext."""
        return {**_style(), "font.family": list(self.families)}


def paper_look(figure: Figure, typeface: Typeface = "sans") -> Look:
    """A page's width for records over time and for panels beside one another, else a column's."""
    if figure.columns > 1 and len(figure.panels) > 1:
        return Look(typeface, panel_height=1.75)
    return Look(typeface) if figure.x_unit == "s" else Look(typeface, COLUMN_WIDTH, 1.85)


def plotted(figure: Figure, models: Sequence[str], look: Look | None = None, canvas: Canvas | None = None) -> Canvas:
    """The figure on a canvas of matplotlib.

    Parameters
    ----------
    figure : Figure
        Its hidden lines are left out.
    models : sequence of str
        All models of the run, for their colours.
    look : Look, optional
        That of a paper if left out.
    canvas : matplotlib.figure.Figure, optional
        An empty one to draw on, such as ``pyplot.figure()``; its size is set.
    """
    look, figure = look or paper_look(figure), shown(figure)
    columns = min(figure.columns, len(figure.panels))
    rows = -(-len(figure.panels) // columns)
    with mpl.rc_context(look.settings):
        canvas = Canvas() if canvas is None else canvas
        canvas.set_layout_engine("constrained")
        own = any(panel.x is not None for panel in figure.panels)
        heights = [0.5 if panel.low else 1.0 for panel in figure.panels] if columns == 1 else [1.0] * rows
        axes = canvas.subplots(
            rows, columns, sharex=columns == 1 and not own, squeeze=False, gridspec_kw={"height_ratios": heights}
        )
        for number, (panel, on) in enumerate(zip(figure.panels, axes.flat, strict=False)):
            _panel(
                figure,
                panel,
                on,
                models,
                labelled=number >= len(figure.panels) - 1 or columns > 1 or own,
                wide=look.width / columns > 5.0,
            )
            if look.letters and len(figure.panels) > 1:
                on.set_title(f"({chr(ord('a') + number)})", loc="left")
        for spare in axes.flat[len(figure.panels) :]:
            spare.remove()
        lines = _legend(canvas, figure, models, look) if look.legend else 0
        above = 0.17 * lines + 0.16 * rows * (look.letters and len(figure.panels) > 1)
        height = sum(heights) * look.panel_height * figure.tall + 0.45 * (rows - 1) * (columns > 1)
        canvas.set_size_inches(look.width, height + above + 0.5)
    return canvas


def _panel(figure: Figure, panel: Panel, on: Axes, models: Sequence[str], *, labelled: bool, wide: bool) -> None:
    low, high = x_range(figure, panel)
    x_log = figure.x_log or panel.x_log
    x_name, x_symbol = panel.x or (figure.x_name, figure.x_unit)
    bottom, top = y_range(panel)
    # A logarithmic axis has powers of ten anyway.
    x_unit, fx = (scale if x_log else axis_scale)(x_symbol, max(abs(low), abs(high)))
    y_unit, fy = (scale if panel.log else axis_scale)(panel.unit, max(abs(bottom), abs(top)))
    _axis(on, "x", low * fx, high * fx, about=10 if wide else 6, log=x_log, whole=figure.whole)
    _axis(on, "y", bottom * fy, top * fy, about=3 if panel.low else 5, log=panel.log, whole=panel.whole)
    if panel.names:
        on.yaxis.set_major_locator(ticker.FixedLocator(range(len(panel.names))))
        on.yaxis.set_major_formatter(ticker.FixedFormatter([writable(name) for name in panel.names]))
    on.set_ylabel(axis_label(panel.name, y_unit))
    if labelled:
        on.set_xlabel(axis_label(x_name, x_unit))
    for start, stop in figure.gaps:
        on.axvspan(start * fx, stop * fx, color="#e6e6e6", linewidth=0, zorder=0.1)
    if panel.cells is not None:
        _cells(on, panel.cells, fx, fy)
    for zero, is_log, (first, last) in ((on.axhline, panel.log, (bottom, top)), (on.axvline, x_log, (low, high))):
        if not is_log and first < 0.0 < last:
            zero(0.0, color="#a9b1bb", linewidth=0.4, zorder=0.5)
    for name, positions in figure.marks.items():
        colour, dashes = _MARK_COLOURS[MARKS.get(name, Style("mark")).kind]
        on.add_collection(
            LineCollection(
                [np.array([[at * fx, 0.0], [at * fx, 1.0]]) for at in positions],
                colors=colour,
                linestyles=[dashes],
                linewidths=0.4,
                zorder=0.6,
                transform=on.get_xaxis_transform(),
            ),
            autolim=False,
        )
    _content(on, panel, models, fx, fy)


def _content(on: Axes, panel: Panel, models: Sequence[str], fx: float, fy: float) -> None:
    for band in panel.bands:
        colour = slot_colour(slot(band.role, models))
        on.fill_between(
            band.x * fx, band.low * fy, band.high * fy, color=colour, alpha=BAND_OPACITY, linewidth=0, zorder=1
        )
    for line in panel.lines:
        thin = thinned(line, BUCKETS)
        kind = line_kind(line)
        where = slot(line.role, models)
        on.plot(
            thin.x * fx,
            thin.y * fy,
            color=slot_colour(where),
            linewidth=WIDTHS[kind],
            dashes=_dashes(where, line.dash, WIDTHS[kind]),
            zorder=2,
            solid_joinstyle="round",
        )
    for points in panel.points:
        colour = slot_colour(slot(points.role, models))
        fill = {"dot": colour, "ring": "#ffffff"}.get(points.marker, "none")
        on.plot(
            points.x * fx,
            points.y * fy,
            linestyle="none",
            marker=_MARKERS[points.marker],
            markerfacecolor=fill,
            markeredgecolor="#ffffff" if points.marker == "dot" else colour,
            zorder=3,
            clip_on=False,
        )


def _dashes(where: str, dash: Dash, width: float) -> Any:
    """Dash pattern, on and off in widths of the line, as matplotlib counts them; a solid line has none."""
    points = slot_dashes(where) if dash == "role" else _DASHES[dash]
    return tuple(length / width for length in points) if points else (None, None)


def _axis(on: Axes, which: Literal["x", "y"], low: float, high: float, *, about: int, log: bool, whole: bool) -> None:
    """Limits and round ticks, `about` so many and at least three, on an axis that is logarithmic or counts things."""
    axis = on.xaxis if which == "x" else on.yaxis
    if log:
        (on.set_xscale if which == "x" else on.set_yscale)("log")
        inside = math.floor(math.log10(high)) - math.ceil(math.log10(low)) + 1
        between = (1.0,) if inside > 2 else (1.0, 2.0, 5.0)  # where there are few powers of ten
        axis.set_major_locator(ticker.LogLocator(subs=between, numticks=MOST_POWERS))
        axis.set_minor_locator(ticker.NullLocator())
        powers = high > MOST_PLAIN * low
        axis.set_major_formatter(ticker.FuncFormatter(lambda value, _: log_label(value, powers=powers)))
    else:
        axis.set_major_locator(
            ticker.MaxNLocator(
                about, steps=[1, 2, 5, 10] if whole else [1, 2, 2.5, 5, 10], min_n_ticks=3, integer=whole
            )
        )
    (on.set_xlim if which == "x" else on.set_ylim)(low, high)


def _cells(on: Axes, cells: Cells, fx: float, fy: float) -> None:
    """Areas of the classes, each over those before it, so that no gap is left; edges run smoothly between the cells."""
    from scipy.ndimage import gaussian_filter

    classes = [number for number in range(len(cells.labels)) if (cells.index == number).any()]
    where = [cells.index < 0, *(cells.index == number for number in classes)]
    share = [gaussian_filter(area.astype(float), SMOOTHING) for area in where]
    for place, number in enumerate(classes, start=1):
        ahead: FloatArray = np.max(share[place:], axis=0) - np.max(share[:place], axis=0)
        on.contourf(cells.x * fx, cells.y * fy, ahead, levels=[0.0, 2.0], colors=[CELL_COLOURS[number]], zorder=0.2)


def _legend(canvas: Canvas, figure: Figure, models: Sequence[str], look: Look) -> int:
    """The legend over the panels, none of a single line; the number of its rows."""
    named = entries(figure, models, marks=True)
    if len(named) < 2:
        return 0
    # Letters are about half as wide as high; a sample takes four of them.
    width = max(len(label) for label, _ in named) * 0.48 * LETTERS / 72.0 + 0.45
    columns = max(1, min(len(named), int((look.width - 0.3) / width)))
    canvas.legend(
        [_sample(style) for _, style in named],
        [writable(label) for label, _ in named],
        loc="outside upper center",
        ncols=columns,
    )
    return -(-len(named) // columns)


def _sample(style: Style) -> Artist:
    from matplotlib.lines import Line2D
    from matplotlib.patches import Patch

    if style.kind.startswith("cell"):
        return Patch(facecolor=CELL_COLOURS[int(style.kind[4:])])
    if style.kind in _MARK_COLOURS:
        colour, _ = _MARK_COLOURS[style.kind]
        return Line2D([], [], color=colour, marker="|", markersize=8, linestyle="none")
    colour = slot_colour(style.slot)
    if style.kind == "band":
        return Patch(facecolor=colour, alpha=BAND_OPACITY)
    if style.kind in _MARKERS:
        return Line2D(
            [],
            [],
            linestyle="none",
            marker=_MARKERS[style.kind],
            color=colour,
            markerfacecolor={"dot": colour, "ring": "#ffffff"}.get(style.kind, "none"),
        )
    width = WIDTHS[style.kind]
    return Line2D([], [], color=colour, linewidth=width, dashes=_dashes(style.slot, style.dash, width))


Format = Literal["svg", "pdf", "png"]
_METADATA: dict[Format, dict[str, Any]] = {
    "svg": {"Date": None, "Creator": "debist"},
    "pdf": {"CreationDate": None, "Creator": "debist", "Producer": "debist"},
    "png": {"Software": "debist"},
}
WHOLE = Look(width=8.4, panel_height=2.6, legend=False)
PART = Look(width=5.6, panel_height=2.5, legend=False, letters=False)


def _lay_out(canvas: Canvas) -> None:
    """Find the places of a figure's parts, which saving would otherwise draw it once more for."""
    if (engine := canvas.get_layout_engine()) is not None:
        engine.execute(canvas)
    canvas.set_layout_engine(None)


def form_of(target: Path) -> Format:
    """The format by a file's ending.

    Raises
    ------
    InputError
        Figures are not written so.
    """
    if target.suffix not in (endings := [f".{form}" for form in _METADATA]):
        raise InputError(f"{target}: figures are written as {', '.join(endings)}")
    return target.suffix[1:]  # type: ignore[return-value]


def paper_figure(figure: Figure, models: Sequence[str], *formats: Format, typeface: Typeface = "sans") -> list[bytes]:
    """The figure as the bytes of a file of each format, without a date in it.

    Letters come from the first of the font families that has them. In an SVG they are outlines: as text they would be
    set in another font where that one is not installed, and run into one another.

    Cost: 0.1 s for the layout, which all share, 0.1 s for each file.
    """
    from matplotlib.text import Text

    look = paper_look(figure, typeface)
    files = []
    with mpl.rc_context({**look.settings, **_STYLE, "svg.fonttype": "path"}), warnings.catch_warnings():
        warnings.filterwarnings("ignore", "Glyph .* missing from font", UserWarning)  # it is drawn as a box
        canvas = plotted(figure, models, look)
        for text in canvas.findobj(Text):
            text.set_fontfamily(look.families)
        _lay_out(canvas)
        for form in formats:
            buffer = io.BytesIO()
            canvas.savefig(buffer, format=form, metadata=_METADATA[form], dpi=_DOTS_PER_INCH)
            files.append(buffer.getvalue())
    return files


def page_chart(figure: Figure, models: Sequence[str]) -> list[Markup]:
    """The figure as one ``<svg>``, or as one for each of panels beside another."""
    if figure.columns == 1:
        return [_svg(figure, models, PART if figure.half else WHOLE)]
    several = len(figure.panels) > 1
    return [
        _svg(
            replace(figure, title=figure.title + f": {panel.name}" * several, panels=(panel,), columns=1), models, PART
        )
        for panel in figure.panels
    ]


def _svg(figure: Figure, models: Sequence[str], look: Look) -> Markup:
    from matplotlib.backends.backend_svg import FigureCanvasSVG

    text = io.StringIO()
    # The salt keeps the names of shapes that are used twice apart from those of other figures on the page.
    with mpl.rc_context({**look.settings, "svg.fonttype": "none", "svg.hashsalt": f"{figure.name} {figure.title}"}):
        canvas = plotted(figure, models, look)
        FigureCanvasSVG(canvas)  # whose letters the layout measures
        _lay_out(canvas)
        canvas.savefig(text, format="svg", metadata={"Date": None}, transparent=True)
    plain = _LEFT_OUT.sub("", text.getvalue()).replace("xlink:href=", "href=")
    drawn = _INLINE.sub(lambda match: _attributes(match[1]), plain)
    # A marker takes the stroke of where it is used: the theme's style does not reach into its shape.
    drawn = _MARKER.sub(lambda match: _STROKE.sub("", match[0]), drawn)
    head = _HEAD.search(drawn)
    assert head is not None  # noqa: S101 - matplotlib writes one
    inside = drawn[head.end() : drawn.rindex("</svg>")]
    opened = f'<svg class="chart" {head[1]} role="img" aria-label="{escape(writable(figure.title))}">'
    return Markup(f"{opened}<title>{escape(writable(figure.title))}</title>{inside}</svg>")  # noqa: S704 - texts are escaped


def chart(figure: Figure, models: Sequence[str]) -> dict[str, Any]:
    """A figure for a template: the figure, its drawings and its legend."""
    return {"figure": figure, "drawings": page_chart(figure, models), "legend": swatches(figure, models, marks=True)}


def _attributes(style: str) -> str:
    """A style as presentation attributes; the style sheet sets the letters, except their anchor."""
    pairs = (map(str.strip, part.split(":", 1)) for part in style.split(";") if ":" in part)
    return "".join(f' {key}="{escape(value)}"' for key, value in pairs if key != "font")
