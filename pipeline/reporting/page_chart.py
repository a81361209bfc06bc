"""A figure on the page: SVG of matplotlib, whose colours the style sheet replaces in the dark and on paper.

The page's content-security policy allows no inline style, so that every style becomes presentation attributes, which
the style sheet overrides by their value: ``[stroke="#0072b2"]`` takes the first model's colour of the present theme.
"""

import io
import re
from collections.abc import Sequence
from dataclasses import replace

from markupsafe import Markup, escape

from pipeline.reporting.figure import Figure, writable
from pipeline.reporting.plotted import Look, plotted

WHOLE, PART = (
    Look(width=8.4, panel_height=2.6, legend=False),
    Look(width=5.6, panel_height=2.5, legend=False, letters=False),
)
_STYLE = re.compile(r' style="([^"]*)"')
_HEAD = re.compile(r"<svg .*?>", re.DOTALL)
_LEFT_OUT = re.compile(r"<metadata>.*?</metadata>|<style .*?</style>|<!--.*?-->| id=\"(?:figure|axes|patch|line2d|text|"
                       r"matplotlib|xtick|ytick|FillBetween|LineCollection|PathCollection|QuadContourSet)[^\"]*\"",
                       re.DOTALL)  # fmt: skip


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
    drawn = _STYLE.sub(lambda found: _attributes(found[1]), _LEFT_OUT.sub("", text.getvalue()))
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
