"""Radial basis functions: values and slopes.

Written by ``python -m pipeline.equations.write`` from `pipeline.equations`; not edited.
"""

# fmt: off
# ruff: noqa

from pipeline.codegen.graph import Graph
from pipeline.codegen.numba_writer import formula
from pipeline.compiled import shared

NAMES = ('gaussian',)

REACHES = (8.6,)

GAUSSIAN = Graph(
    {'square': 1},
    {'found': 2},
    """
constant -0.5; input square 0; mul 0 1; exp 2; mul 0 3; store found 0 3; store found 1 4
    """,
)

GRAPHS = {'gaussian': GAUSSIAN}

_gaussian = formula(GAUSSIAN)


@shared
def basis_function(kind: int, square: float) -> tuple[float, float]:
    """Value of the function `NAMES[kind]`, and its slope along `square`, ((q − ξ)/σ)²."""
    return _gaussian((square,))  # type: ignore[no-any-return]
