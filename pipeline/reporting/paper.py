"""Figures for a paper, by matplotlib: SVG, PDF or PNG, the same bytes for the same figure.

Names come from logs, so nothing is ever read as mathtext: a channel called ``$\\frac{1}{$`` stands there as it is.
"""

import io
from collections.abc import Sequence
from dataclasses import replace
from typing import Any, Literal

import numpy as np

from pipeline.reporting.axis_ticks import linear_ticks, log_ticks
from pipeline.reporting.figure import Figure, Panel, thinned, x_range, y_range
from pipeline.reporting.figure_font import register
from pipeline.reporting.palette import colour, dashes
from pipeline.reporting.si_prefix import scale, significant

Format = Literal["svg", "pdf", "png"]

COLUMN_INCHES = 3.5  # a column of an IEEE paper
PANEL_INCHES = 1.35
BUCKETS = 700
_CELLS = ("#DCEAF5", "#FBE3D3", "#E8E8E8")
_STYLE: Any = {
    "font.size": 8,
    "text.parse_math": False,
    "svg.fonttype": "none",
    "svg.hashsalt": "debist",
    "pdf.fonttype": 42,
    "pdf.compression": 1,
    "axes.linewidth": 0.6,
    "lines.linewidth": 0.9,
    "axes.unicode_minus": True,
}


def paper_figure(figure: Figure, models: Sequence[str], *formats: Format) -> list[bytes]:
    """Draw the figure once and write it in each of the formats, without any date in it."""
    import matplotlib as mpl
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure as Canvas

    with mpl.rc_context({**_STYLE, "font.family": register()}):
        columns = min(figure.columns, len(figure.panels))
        rows = -(-len(figure.panels) // columns)
        size = (COLUMN_INCHES * (2 if columns > 1 else 1.6), PANEL_INCHES * figure.tall * rows + 0.9)
        canvas = Canvas(figsize=size)
        FigureCanvasAgg(canvas)
        axes = canvas.subplots(rows, columns, squeeze=False, sharex=columns == 1)
        canvas.subplots_adjust(
            left=0.72 / size[0], right=1 - 0.12 / size[0], bottom=0.45 / size[1], top=1 - 0.42 / size[1],
            hspace=0.12 if columns == 1 else 0.45, wspace=0.32,
        )  # fmt: skip
        for number, panel in enumerate(figure.panels):
            _draw(axes.flat[number], figure, panel, models, lowest=columns > 1 or number == rows - 1)
        for unused in axes.flat[len(figure.panels) :]:
            unused.set_axis_off()
        _legend(canvas, axes)
        return [_saved(canvas, kind) for kind in formats]


def _saved(canvas: Any, kind: Format) -> bytes:
    metadata: dict[str, dict[str, Any]] = {
        "svg": {"Date": None, "Creator": "debist"},
        "pdf": {"CreationDate": None, "Creator": "debist", "Producer": "debist"},
        "png": {"Software": "debist"},
    }
    buffer = io.BytesIO()
    canvas.savefig(buffer, format=kind, metadata=metadata[kind], dpi=200)
    return buffer.getvalue()


def _draw(axes: Any, figure: Figure, panel: Panel, models: Sequence[str], *, lowest: bool) -> None:
    x_low, x_high = x_range(figure)
    shown = tuple(line for line in panel.lines if line.label not in figure.hidden)
    y_low, y_high = y_range(replace(panel, lines=shown))
    x_unit, fx = scale(figure.x_unit, max(abs(x_low), abs(x_high)))
    y_unit, fy = scale(panel.unit, max(abs(y_low), abs(y_high)))
    if panel.cells is not None:
        from matplotlib.colors import BoundaryNorm, ListedColormap

        classes = np.ma.masked_less(panel.cells.index, 0)
        norm = BoundaryNorm(np.arange(-0.5, len(_CELLS)), len(_CELLS))
        axes.pcolormesh(
            panel.cells.x * fx, panel.cells.y * fy, classes, cmap=ListedColormap(_CELLS), norm=norm, shading="nearest"
        )
    for start, stop in figure.gaps:
        axes.axvspan(start * fx, stop * fx, color="#E0E0E0", linewidth=0)
    for positions in figure.marks.values():
        axes.vlines(positions * fx, 0, 1, transform=axes.get_xaxis_transform(), color="#B0B0B0", linewidth=0.4)
    for band in panel.bands:
        axes.fill_between(
            band.x * fx, band.low * fy, band.high * fy, color=colour(band.role, models), alpha=0.2, linewidth=0
        )
    for line in shown:
        thin = thinned(line, BUCKETS)
        pattern = (3, 2) if line.dashed else dashes(line.role, models)
        style: Any = (0, pattern) if pattern else "-"
        axes.plot(thin.x * fx, thin.y * fy, color=colour(line.role, models), linestyle=style, label=line.label)
    for points in panel.points:
        drawn = colour(points.role, models)
        marker = "x" if points.marker == "cross" else "o"
        face = "none" if points.marker == "ring" else drawn
        axes.plot(
            points.x * fx, points.y * fy, marker, color=drawn, markerfacecolor=face, markersize=4, label=points.label
        )
    axes.set_xscale("log" if figure.x_log else "linear")
    axes.set_yscale("log" if panel.log else "linear")
    axes.set_xlim(x_low * fx, x_high * fx)
    axes.set_ylim(y_low * fy, y_high * fy)
    # matplotlib writes powers of ten as mathtext, which is switched off.
    if figure.x_log:
        _label_powers(axes.xaxis, x_low * fx, x_high * fx)
    if panel.log:
        _label_powers(axes.yaxis, y_low * fy, y_high * fy)
    else:
        axes.set_yticks(linear_ticks(y_low * fy, y_high * fy, 5)[0])
    axes.grid(linewidth=0.3, color="#D8D8D8")
    axes.set_ylabel(f"{panel.name} in {y_unit}" if y_unit not in ("", "1") else panel.name)
    if lowest:
        axes.set_xlabel(f"{figure.x_name} in {x_unit}" if x_unit not in ("", "1") else figure.x_name)


def _label_powers(axis: Any, low: float, high: float) -> None:
    ticks = log_ticks(low, high)
    axis.set_ticks(ticks, labels=[significant(float(tick), 1) for tick in ticks])
    axis.set_ticks([], minor=True)


def _legend(canvas: Any, axes: Any) -> None:
    known: dict[str, Any] = {}
    for one in axes.flat:
        handles, labels = one.get_legend_handles_labels()
        for handle, label in zip(handles, labels, strict=True):
            known.setdefault(label, handle)
    if len(known) > 1:
        canvas.legend(
            known.values(), known.keys(), loc="upper center", ncols=min(5, len(known)), frameon=False,
            borderaxespad=0.2, handlelength=2.2, columnspacing=1.2,
        )  # fmt: skip
