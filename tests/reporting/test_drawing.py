"""Figures drawn with matplotlib: hidden lines are left out, axes have round ticks, letters do not touch."""

import itertools
from dataclasses import replace

import matplotlib as mpl
import numpy as np
import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.text import Text

from pipeline.reporting.canvas import page_chart
from pipeline.reporting.figure import (
    Band,
    Cells,
    Figure,
    Line,
    Panel,
    Points,
    linear_ticks,
    log_ticks,
    tick_label,
    tick_labels,
)
from pipeline.reporting.legend import entries
from pipeline.reporting.plotted import BUCKETS, CELL_COLOURS, Look, paper_look, plotted
from tests.reporting.synthetic import figures_of_one_log, run_data

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


@pytest.mark.parametrize("typeface", ["sans", pytest.param("serif", marks=pytest.mark.long)])
def test_every_axis_has_ticks_and_no_letters_touch_or_leave_the_sheet(typeface):
    for name, figure in figures_of_one_log().items():
        _check_axes_and_letters(name, _drawn(figure, run_data().model_names, paper_look(figure, typeface)))


def _check_axes_and_letters(name, canvas):
    renderer, sheet = canvas.canvas.get_renderer(), canvas.bbox
    for on in canvas.axes:
        for axis in (on.xaxis, on.yaxis):
            low, high = sorted(axis.get_view_interval())
            ticks = [tick for tick in axis.get_majorticklocs() if low <= tick <= high]
            assert len(ticks) >= 3, (name, ticks)
    texts = [text for text in canvas.findobj(Text) if text.get_visible() and text.get_text().strip()]
    boxes = [(text.get_text(), text.get_window_extent(renderer)) for text in texts]
    outside = _ticks_outside(canvas, renderer)
    shown = [(text, box) for text, box in boxes if box.width > 0 and box.bounds not in outside]
    for text, box in shown:
        assert box.x0 >= sheet.x0 - 1 and box.x1 <= sheet.x1 + 1, (name, text)
        assert box.y0 >= sheet.y0 - 1 and box.y1 <= sheet.y1 + 1, (name, text)
    for (one, a), (other, b) in itertools.combinations(shown, 2):
        assert not a.padded(-0.5).overlaps(b.padded(-0.5)), (name, one, other)


def _ticks_outside(canvas, renderer) -> set[tuple[float, ...]]:
    """Places of the labels of ticks outside the limits, which exist but are not drawn."""
    outside = set()
    for on in canvas.axes:
        for axis in (on.xaxis, on.yaxis):
            low, high = sorted(axis.get_view_interval())
            for tick in axis.get_major_ticks():
                if not (tick.label1.get_visible() and low <= tick.get_loc() <= high):
                    outside.add(tick.label1.get_window_extent(renderer).bounds)
    return outside


def test_a_hidden_line_is_not_drawn_and_sets_no_axis():
    near, far = Line("rbf", "rbf", X, np.sin(X)), Line("sindy", "sindy", X, 1e9 * X)
    (hidden,) = _drawn(_figure(near, far, hidden=("sindy",))).axes
    (alone,) = _drawn(_figure(near)).axes
    assert hidden.get_ylim() == alone.get_ylim()
    assert len(hidden.get_legend_handles_labels()[0]) == len(alone.get_legend_handles_labels()[0])


def test_the_legend_names_measurement_models_in_order_and_points_last():
    lines = (Line("narx", "narx", X, X), Line("measured", "measured", X, X, wide=True), Line("rbf", "rbf", X, X))
    cells = Cells(("left", "right"), X[:3], X[:3], np.zeros((3, 3), dtype=np.int8))
    points = (Points("rest", "rbf", X[:1], X[:1]),)
    panel = Panel("q", "m", lines, (Band("rbf, band", "rbf", X, X, X),), points, cells)
    figure = Figure("f", "", "", "t", "s", (panel, panel))
    expected = ["left", "measured", "rbf, band", "rbf", "narx", "rest"]
    assert [entry.label for entry in entries(figure, MODELS)] == expected
    (legend,) = _drawn(figure).legends
    assert [text.get_text() for text in legend.get_texts()] == expected


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


def test_panels_beside_one_another_are_lettered_and_equal():
    panels = tuple(Panel(f"p{i}", "m", (Line("a", "v1", X, X),)) for i in range(4))
    figure = Figure("f", "", "", "q", "m", panels, columns=2)
    axes = _drawn(figure, ()).axes
    assert [on.get_title(loc="left") for on in axes] == ["(a)", "(b)", "(c)", "(d)"]
    places = [on.get_position() for on in axes]
    assert places[0].y0 == pytest.approx(places[1].y0) and places[0].y0 > places[2].y1
    assert len({round(place.width, 3) for place in places}) == 1
    stacked = _drawn(replace(figure, columns=1), ()).axes
    assert len({round(on.get_position().x0, 6) for on in stacked}) == 1


def test_no_gap_is_left_between_three_classes():
    """Each class is painted over those before it; the first covers all of the grid."""
    x = np.linspace(0.0, 1.0, 21)
    index = ((x[None, :] + x[:, None] > 0.9) * 2).astype(np.int8)
    index[8, 10] = 1
    cells = Cells(("hardly", "open", "always"), x, x, index)
    (on,) = _drawn(Figure("f", "", "", "q", "m", (Panel("p", "m", cells=cells),)), ()).axes
    areas = [area for area in on.collections if mpl.colors.to_hex(area.get_facecolor()[0]) in CELL_COLOURS]
    first = np.concatenate([path.vertices for path in areas[0].get_paths()])
    factor = on.get_xlim()[1] / x[-1]
    assert len(areas) == 3
    np.testing.assert_allclose([first.min(axis=0), first.max(axis=0)], [[0.0, 0.0], [factor, factor]], atol=1e-9)
    assert (
        areas[0].get_paths()[0].contains_points(factor * np.stack(np.meshgrid(x, x), -1).reshape(-1, 2)[22:-22]).all()
    )


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


@pytest.mark.parametrize(
    ("low", "high", "labels"),
    [
        (0.5, 2000.0, ["1", "10", "100", "1000"]),
        (0.3, 4.0, ["0.5", "1", "2"]),
        (1.1, 1.9, ["1.2", "1.4", "1.6", "1.8"]),
        (1e-12, 1e-1, ["10⁻¹²", "10⁻¹⁰", "10⁻⁸", "10⁻⁶", "0.0001", "0.01"]),
    ],
)
def test_logarithmic_axes_have_round_labels(low, high, labels):
    assert [tick_label(float(v)) for v in log_ticks(low, high)] == labels


def test_linear_ticks_lie_inside():
    for low, high in ((-0.013, 0.021), (3.0, 3.001), (-1e7, 1e8)):
        values, decimals = linear_ticks(low, high, 5)
        assert 2 <= len(values) <= 11
        assert low - 1e-9 <= values[0]
        assert values[-1] <= high + 1e-9 * abs(high)
        assert len({f"{v:.{decimals}f}" for v in values}) == len(values)


@pytest.mark.parametrize(
    ("values", "labels"),
    [
        ([0.1, 1.0, 10.0, 100.0], ["0.1", "1", "10", "100"]),
        ([100.0, 1e3, 1e4, 1e5], ["10²", "10³", "10⁴", "10⁵"]),
        ([1e-6, 1e-3, 1.0], ["10⁻⁶", "10⁻³", "10⁰"]),
        ([0.02, 0.05, 0.1], ["0.02", "0.05", "0.1"]),
    ],
)
def test_an_axis_has_one_style_of_powers_of_ten(values: list[float], labels: list[str]) -> None:
    assert tick_labels(np.array(values)) == labels


def test_panels_of_a_half_figure_share_their_axis_and_counts_have_whole_ticks() -> None:
    t = np.linspace(0.0, 3.0, 7)
    panels = (
        Panel("q", "m", (Line("q", "measured", t, t),), low=True),
        Panel("v", "V", (Line("v", "v1", 2.0 * t, t),)),
    )
    figure = Figure("f", "", "", "fold", "1", panels, half=True, whole=True)
    axes = _drawn(figure).axes
    assert len(page_chart(figure, [])) == 1
    assert axes[0].get_xlim() == axes[1].get_xlim() == (0.0, 6.0)
    ticks = axes[1].get_xticks()
    assert np.all(ticks == np.round(ticks))
    low, usual = (on.get_position().height for on in axes)
    assert low < 0.7 * usual
