"""Terms of models of which a run has as many as it needs: exact slopes, the same numbers from every writer."""

import numpy as np
import pytest

from pipeline.codegen.graph import apply, trace
from pipeline.codegen.numba_writer import formula
from pipeline.generated import terms
from pipeline.numerics.compiled import compiled

SLOPED = {
    "POWERS": ("x",),
    "TURNING_ARM": ("x",),
    "CLIPPED": ("x",),
    "BELL": ("inside",),
    "ACCELERATION": ("p", "curves", "push", "arm", "arc", "drag"),
    "BENT": ("drive", "bend"),
    "PAST_ZONE": ("drive", "zone"),
    "STOP_FORCE": ("x", "p", "stops"),
    "ELEMENT": ("coupling", "p", "rate", "load"),
    "DAHL_MOVE": ("state", "travel", "length"),
}


def drawn(graph, count=1000, seed=0):
    """Inputs between 0.2 and 1, away from the kinks of clips and signs."""
    rng = np.random.default_rng(seed)
    given = {name: rng.uniform(0.2, 1.0, (count, size)) for name, size in graph.inputs.items()}
    if "low" in given:
        given["low"] -= 2.0
        given["high"] += 2.0
    return given


@pytest.mark.parametrize("name", SLOPED)
def test_slopes_are_the_derivatives(name):
    graph = getattr(terms, name)
    given = drawn(graph)
    found = graph.evaluate(**given)
    columns = [(along, i) for along in SLOPED[name] for i in range(graph.inputs[along])]
    slopes = found["slopes"].reshape(1000, -1, len(columns))
    for place, (along, i) in enumerate(columns):
        above, below = ({key: value.copy() for key, value in given.items()} for _ in range(2))
        above[along][:, i] += 1e-6
        below[along][:, i] -= 1e-6
        difference = (graph.evaluate(**above)["value"] - graph.evaluate(**below)["value"]) / 2e-6
        scale = np.abs(difference).max()
        assert slopes[:, :, place] == pytest.approx(difference, abs=1e-7 * max(1.0, scale))


@pytest.mark.parametrize("name", [*SLOPED, "GAUSSIAN", "DAHL_RATE", "LAGGED_RATES", "POLYNOMIAL_VARIABLES"])
def test_a_formula_and_a_trace_give_what_the_graph_gives(name):
    graph = getattr(terms, name)
    given = drawn(graph, 20)
    truth = np.concatenate(list(graph.evaluate(**given).values()), axis=1)
    numbers, run = np.concatenate(list(given.values()), axis=1), formula(graph)
    function = compiled(lambda numbers: run(numbers))
    for row, expected in zip(numbers, truth, strict=True):
        assert function(tuple(row)) == pytest.approx(expected, rel=1e-12, abs=1e-14)
    again = trace(lambda x: {"found": apply(graph, *x)}, x=numbers.shape[1])
    assert again.evaluate(x=numbers)["found"] == pytest.approx(truth, rel=1e-12, abs=1e-14)
