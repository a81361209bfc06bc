"""Paper figures: the same bytes for the same figure, and names that are no mathtext."""

import xml.etree.ElementTree as ET
from dataclasses import replace
from importlib.resources import as_file, files
from pathlib import Path

import numpy as np
import pytest
from fontTools.ttLib import TTFont

from pipeline.reporting.figure import Figure, Line, Panel
from pipeline.reporting.plotted import FONT, SANS, paper_figure
from tests.reporting.figure_font import write_subset
from tests.reporting.synthetic import HOSTILE

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
