"""The layout that page and paper share: nothing leaves the sheet, hidden lines are left out, ticks are round."""

from dataclasses import replace

import numpy as np
import pytest

from pipeline.device_facts.datasheet import make_datasheet
from pipeline.reporting.axis_ticks import linear_ticks, log_ticks, tick_label
from pipeline.reporting.drawing import PAGE, PAPER, PAPER_COLUMN, Sheet, lay_out, paper_sheet
from pipeline.reporting.figure import Band, Cells, Figure, Line, Panel, Points
from pipeline.reporting.figure_font import text_width
from pipeline.reporting.legend import entries
from pipeline.reporting.run_report import figures_of
from pipeline.reporting.shapes import Box, Drawing, Stroke, Text
from pipeline.reporting.svg import svg_file
from tests.reporting.synthetic import run_data

FIGURES = figures_of(run_data(), make_datasheet(run_data()))
MODELS = ("rbf", "sindy", "narx")
X = np.linspace(0.0, 10.0, 400)


def _figure(*lines: Line, **more: object) -> Figure:
    return Figure("f", "", "", "t", "s", (Panel("q", "m", lines),), **more)  # type: ignore[arg-type]


def _ends(text: Text, size: float) -> tuple[float, float, float, float]:
    width = text_width(text.text) * size
    back = {"start": 0.0, "mid": width / 2, "end": width}[text.anchor]
    if text.turned:
        return text.x - size, text.x, text.y - width + back, text.y + back
    return text.x - back, text.x - back + width, text.y - 0.75 * size, text.y


@pytest.mark.parametrize("name", FIGURES)
def test_nothing_leaves_the_sheet(name: str) -> None:
    figure = FIGURES[name]
    for sheet in (PAGE, paper_sheet(figure)):
        drawing = lay_out(figure, run_data().model_names, sheet)
        for shape in drawing.shapes:
            if isinstance(shape, Text):
                left, right, top, bottom = _ends(shape, drawing.text)
                assert left >= 0.0, shape
                assert right <= drawing.width, shape
                assert top >= 0.0, shape
                assert bottom <= drawing.height, shape
            if isinstance(shape, Stroke):
                for path in shape.paths:
                    assert path.min() >= 0.0
                    assert path[:, 0].max() <= drawing.width
                    assert path[:, 1].max() <= drawing.height


@pytest.mark.parametrize("name", FIGURES)
def test_labels_along_an_axis_do_not_touch(name: str) -> None:
    figure = FIGURES[name]
    drawing = lay_out(figure, run_data().model_names, paper_sheet(figure))
    ticks = [shape for shape in drawing.shapes if isinstance(shape, Text) and shape.kind == "tick"]
    boxes = [_ends(tick, drawing.text) for tick in ticks]
    for i, (left, right, top, bottom) in enumerate(boxes):
        for other in boxes[:i]:
            assert right < other[0] or other[1] < left or bottom < other[2] or other[3] < top, (ticks[i], other)


def _frames(drawing: Drawing) -> list[Box]:
    return [shape for shape in drawing.shapes if isinstance(shape, Box) and shape.style.kind == "frame"]


def test_a_hidden_line_is_not_drawn_and_sets_no_axis() -> None:
    near, far = Line("rbf", "rbf", X, np.sin(X)), Line("sindy", "sindy", X, 1e9 * X)
    hidden = lay_out(_figure(near, far, hidden=("sindy",)), MODELS, PAPER)
    alone = lay_out(_figure(near), MODELS, PAPER)
    assert [type(shape) for shape in hidden.shapes] == [type(shape) for shape in alone.shapes]
    assert "10⁹" not in svg_file(_figure(near, far, hidden=("sindy",)), MODELS)


def test_the_legend_names_measurement_models_in_order_and_points_last() -> None:
    lines = (Line("narx", "narx", X, X), Line("measured", "measured", X, X, wide=True), Line("rbf", "rbf", X, X))
    cells = Cells(("left", "right"), X[:3], X[:3], np.zeros((3, 3), dtype=np.int8))
    points = (Points("rest", "rbf", X[:1], X[:1]),)
    panel = Panel("q", "m", lines, (Band("rbf, band", "rbf", X, X, X),), points, cells)
    figure = Figure("f", "", "", "t", "s", (panel, panel))
    assert [entry.label for entry in entries(figure, MODELS)] == [
        "left",
        "measured",
        "rbf, band",
        "rbf",
        "narx",
        "rest",
    ]


def test_a_narrow_legend_breaks_into_rows_and_the_panels_keep_their_height() -> None:
    names = tuple(f"a model with a long name {i}" for i in range(5))
    lines = tuple(Line(name, name, X, X) for name in names)
    one, many = lay_out(_figure(*lines[:2]), names, PAPER), lay_out(_figure(*lines), names, PAPER_COLUMN)
    assert many.height - PAPER_COLUMN.panel_height > one.height - PAPER.panel_height
    assert _frames(many)[0].height == PAPER_COLUMN.panel_height


def test_missing_samples_interrupt_a_line_and_a_band() -> None:
    y = np.where((X > 3.0) & (X < 4.0), np.nan, X)
    panel = Panel("q", "m", (Line("a", "v1", X, y),), (Band("a", "v1", X, y - 1.0, y + 1.0),))
    drawing = lay_out(Figure("f", "", "", "t", "s", (panel,)), (), Sheet(500.0, 200.0, 10.0))
    line = next(s for s in drawing.shapes if isinstance(s, Stroke) and s.style.kind == "line")
    assert len(line.paths) == 2
    assert (
        sum(getattr(shape, "style", None) is not None and shape.style.kind == "band" for shape in drawing.shapes) == 2
    )  # type: ignore[union-attr]


def test_equal_columns_stand_beside_one_another() -> None:
    panels = tuple(Panel(f"p{i}", "m", (Line("a", "v1", X, X),)) for i in range(4))
    figure = Figure("f", "", "", "q", "m", panels, columns=2)
    frames = _frames(lay_out(figure, (), paper_sheet(figure)))
    assert frames[0].y == frames[1].y < frames[2].y == frames[3].y
    assert len({round(frame.width, 6) for frame in frames}) == 1
    stacked = _frames(lay_out(replace(figure, columns=1), (), PAGE))
    assert len({frame.x for frame in stacked}) == 1


@pytest.mark.parametrize(
    ("low", "high", "labels"),
    [
        (0.5, 2000.0, ["1", "10", "100", "1000"]),
        (0.3, 4.0, ["0.5", "1", "2"]),
        (1.1, 1.9, ["1.2", "1.4", "1.6", "1.8"]),
        (1e-12, 1e-1, ["10⁻¹²", "10⁻¹⁰", "10⁻⁸", "10⁻⁶", "0.0001", "0.01"]),
    ],
)
def test_logarithmic_axes_have_round_labels(low: float, high: float, labels: list[str]) -> None:
    assert [tick_label(float(v)) for v in log_ticks(low, high)] == labels


def test_linear_ticks_lie_inside() -> None:
    for low, high in ((-0.013, 0.021), (3.0, 3.001), (-1e7, 1e8)):
        values, decimals = linear_ticks(low, high, 5)
        assert 2 <= len(values) <= 11
        assert low - 1e-9 <= values[0]
        assert values[-1] <= high + 1e-9 * abs(high)
        assert len({f"{v:.{decimals}f}" for v in values}) == len(values)
