"""Figures drawn with matplotlib: hidden lines are left out, axes have round ticks, letters do not touch."""

import matplotlib as mpl
import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg

from pipeline.reporting.figure import (
    Cells,
    Figure,
    Line,
    Panel,
)
from pipeline.reporting.plotted import BUCKETS, CELL_COLOURS, Look, paper_look, plotted

MODELS = ("rbf", "sindy", "narx")
X = np.linspace(0.0, 10.0, 400)


def _figure(*lines: Line, **more: object) -> Figure:
    return Figure("f", "", "", "t", "s", (Panel("q", "m", lines),), **more)  # type: ignore[arg-type]


def _drawn(figure: Figure, models: tuple[str, ...] = MODELS, look: Look | None = None):
    with mpl.rc_context((look or paper_look(figure)).settings):
        canvas = plotted(figure, models, look)
        FigureCanvasAgg(canvas)
        canvas.draw_without_rendering()  # places everything
    return canvas


def test_a_hidden_line_is_not_drawn_and_sets_no_axis():
    near, far = Line("rbf", "rbf", X, np.sin(X)), Line("sindy", "sindy", X, 1e9 * X)
    (hidden,) = _drawn(_figure(near, far, hidden=("sindy",))).axes
    (alone,) = _drawn(_figure(near)).axes
    assert hidden.get_ylim() == alone.get_ylim()
    assert len(hidden.get_legend_handles_labels()[0]) == len(alone.get_legend_handles_labels()[0])


def test_a_long_record_keeps_its_extremes():
    y = np.zeros(100_000)
    y[54_321], y[12_345] = 7.0, -5.0
    (on,) = _drawn(_figure(Line("a", "v1", np.arange(100_000.0), y))).axes
    drawn = next(line.get_ydata() for line in on.lines if len(line.get_ydata()) > 4)
    assert len(drawn) <= 2 * BUCKETS
    assert max(drawn) == 7.0 * 1.0 and min(drawn) == -5.0


def test_missing_samples_interrupt_a_line():
    y = np.where((X > 3.0) & (X < 4.0), np.nan, X)
    (on,) = _drawn(_figure(Line("a", "v1", X, y))).axes
    (line,) = [each for each in on.lines if len(each.get_xdata()) == X.size]
    assert np.isnan(line.get_ydata()).sum() == np.isnan(y).sum()


def test_the_edge_between_cells_is_smooth():
    """A slanting boundary on a coarse grid is drawn within a cell of its place, without steps along the grid."""
    x = np.linspace(-1.0, 1.0, 41)
    index = (x[None, :] > 0.3 * x[:, None]).astype(np.int8)
    cells = Cells(("left", "right"), x, x, index)
    (on,) = _drawn(Figure("f", "", "", "q", "m", (Panel("p", "m", cells=cells),)), ()).axes
    areas = [area for area in on.collections if mpl.colors.to_hex(area.get_facecolor()[0]) in CELL_COLOURS]
    assert len(areas) == 2
    edge = np.concatenate([path.vertices for path in areas[1].get_paths()])
    factor = on.get_xlim()[1] / x[-1]
    inner = edge[(np.abs(edge[:, 1]) < 0.9 * factor) & (np.abs(edge[:, 0]) < 0.8 * factor)] / factor
    assert len(inner) > 30
    assert np.abs(inner[:, 0] - 0.3 * inner[:, 1]).max() < 0.05
    steps = np.diff(inner[np.argsort(inner[:, 1])], axis=0)
    steps = steps[np.hypot(*steps.T) > 1e-3]
    assert np.abs(steps[:, 0]).max() < 0.045  # less than a cell: no staircase
