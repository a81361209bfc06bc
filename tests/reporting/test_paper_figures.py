"""Paper figures: the same bytes for the same figure, and names that are no mathtext."""

import re
import xml.etree.ElementTree as ET
from dataclasses import replace
from importlib.resources import as_file, files
from pathlib import Path

import numpy as np
import pytest
from fontTools.ttLib import TTFont

from pipeline.reporting.canvas import paper_figure
from pipeline.reporting.figure import Figure, Line, Panel
from pipeline.reporting.plotted import FONT, SANS
from tests.reporting.figure_font import write_subset
from tests.reporting.synthetic import HOSTILE, run_data, run_figures

T = np.linspace(0.0, 10.0, 5000)
NAMED = Figure(
    "named",
    HOSTILE,
    "",
    HOSTILE,
    "s",
    (Panel(HOSTILE, "m", (Line(HOSTILE, "rbf", T, np.sin(T)), Line("other", "sindy", T, np.cos(T)))),),
)


def test_a_hostile_name_is_drawn_as_it_is() -> None:
    (drawn,) = paper_figure(NAMED, ("rbf", "sindy"), "svg")
    text = drawn.decode()
    assert "$\\frac{1}{$ &lt;script&gt;" in text
    assert "<script" not in text


@pytest.mark.parametrize(
    "name",
    [
        "\x00\x1b[31m red \x9f",
        "]]> &amp; <a>",
        *(pytest.param(name, marks=pytest.mark.long) for name in ("مرحبا \u202e\u200f", "x" * 5000, "\ud7ff\ufffe")),
    ],
)
def test_a_strange_name_leaves_a_well_formed_file(name: str) -> None:
    figure = replace(NAMED, title=name, panels=(replace(NAMED.panels[0], name=name),))
    svg, pdf = paper_figure(figure, ("rbf", "sindy"), "svg", "pdf")
    root = ET.fromstring(svg.decode())  # noqa: S314 - our own text
    assert root.tag == "{http://www.w3.org/2000/svg}svg"
    assert pdf.startswith(b"%PDF")


@pytest.mark.parametrize("kind", ["svg", "pdf", "png"])
def test_equal_figures_give_equal_bytes(kind: str) -> None:
    first, second = (paper_figure(NAMED, ("rbf", "sindy"), kind)[0] for _ in range(2))  # type: ignore[arg-type]
    assert first == second
    assert first.startswith({"svg": b"<?xml", "pdf": b"%PDF", "png": b"\x89PNG"}[kind])


def test_figures_of_a_run_are_drawn_with_embedded_outlines() -> None:
    figures = run_figures()
    for name in ("validation-other-models", "curves", "phase-portrait", "excitation"):
        (drawn,) = paper_figure(figures[name], run_data().model_names, "pdf")
        assert b"/Type3" not in drawn  # journals refuse bitmap-like Type 3 fonts
        assert len(drawn) < 400_000


def test_powers_of_ten_are_labelled_without_mathtext() -> None:
    x = np.logspace(-6, 0, 50)
    figure = Figure("p", "", "", "alpha", "1", (Panel("error", "1", (Line("a", "v1", x, x),), log=True),), x_log=True)
    (drawn,) = paper_figure(figure, (), "svg")
    assert not re.search(r"mathdefault|\\times|\$", drawn.decode())


def test_the_figure_font_is_todays_subset(tmp_path: Path) -> None:
    write_subset(tmp_path / FONT)
    with (
        as_file(files("pipeline.reporting") / "assets" / FONT) as kept,
        TTFont(tmp_path / FONT) as made,
        TTFont(kept) as asset,
    ):
        assert asset.getBestCmap() == made.getBestCmap()
        assert not {"GSUB", "GPOS"} & set(asset.keys())
        assert asset["name"].getDebugName(1) == SANS[0]


def test_a_letter_that_the_figure_font_lacks_comes_from_the_whole_font() -> None:
    panel = Panel("Ж", "m", (Line("Ж", "rbf", T, np.sin(T)), Line("other", "sindy", T, np.cos(T))))
    (drawn,) = paper_figure(Figure("f", "", "", "t", "s", (panel,)), ("rbf", "sindy"), "pdf")
    assert b"DejaVuSansFigures" in drawn
    assert b"+DejaVuSans " in drawn or b"+DejaVuSans\n" in drawn
