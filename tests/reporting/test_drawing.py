"""Figures drawn with matplotlib: hidden lines are left out, axes have round ticks, letters do not touch."""

import matplotlib as mpl
import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg

from pipeline.reporting.figure import (
    Figure,
    Line,
    Panel,
)
from pipeline.reporting.plotted import BUCKETS, Look, paper_look, plotted

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
