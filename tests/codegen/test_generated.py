"""The generated graphs are those of the equations, and every writer gives the same numbers."""

import sys
from pathlib import Path

import numpy as np
import pytest

from pipeline import generated
from pipeline.generated.condensed_joint import BENDS, SHAPES, SLOPES


def test_generated_modules_are_written_from_the_equations() -> None:
    """`python -m pipeline.equations.write` has been run since the equations changed."""
    pytest.importorskip("casadi")
    from pipeline.equations.write import texts

    limit = sys.getrecursionlimit()
    sys.setrecursionlimit(100_000)
    try:
        written = texts()
    finally:
        sys.setrecursionlimit(limit)
    for name, text in written.items():
        assert (Path(generated.__file__).parent / name).read_text(encoding="utf-8") == text, name


def test_integrals_over_the_beam_are_those_of_the_consistent_mass_and_stiffness_of_a_beam_element() -> None:
    # Przemieniecki, Theory of Matrix Structural Analysis (1968), ch. 11: the end's displacement and rotation
    assert np.array(SHAPES)[:2, :2] == pytest.approx(np.array([[156.0, -22.0], [-22.0, 4.0]]) / 420.0, rel=1e-15)
    assert np.array(SLOPES)[:2, :2] == pytest.approx(np.array([[36.0, -3.0], [-3.0, 4.0]]) / 30.0, rel=1e-15)
    assert np.array(BENDS)[:2, :2] == pytest.approx(np.array([[12.0, -6.0], [-6.0, 4.0]]), rel=1e-15)
    s = np.linspace(0.0, 1.0, 100_001)
    bubble = s**2 * (1.0 - s) ** 2
    assert np.trapezoid(bubble * np.stack([3 * s**2 - 2 * s**3, s**3 - s**2, bubble]), s) == pytest.approx(SHAPES[2])
