"""The generated graphs are those of the equations, and every writer gives the same numbers."""

import sys
from pathlib import Path

import pytest

from pipeline import generated


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
