"""What the writers write means what the graph means: C compiled by gcc, MATLAB statement by statement."""

import ctypes
import math
import re
import shutil
import subprocess
from pathlib import Path

import numpy as np
import pytest

from pipeline.codegen.graph import Graph, choose, clip, function, trace
from pipeline.codegen.text_writer import c_function, matlab_function
from pipeline.generated.condensed_joint import RATES, REST_FORCES
from pipeline.numerics.arrays import FloatArray

COMPILER = shutil.which("gcc")


def everything(x: list, h: list) -> dict:
    """Every operation, an array that is read and written, an output of what was read, a number."""
    sine = function("sin", x[0]) + function("cos", x[1]) * function("tanh", h[0])
    grown = function("exp", -x[0] * x[0]) / (2.0 - function("expm1", h[0]))
    condition = function("and", function("lt", x[0], x[1]), function("not", function("le", h[0], 0.2)))
    kept = choose(function("or", condition, function("finite", h[0])), clip(x[1], -0.5, 0.5), -sine)
    return {"x": [x[1], x[0] - sine, x[2]], "y": [kept, grown, function("sqrt", function("abs", x[0])), 3.25]}


GRAPHS = {"everything": trace(everything, x=3, h=1), "rates": RATES, "shape": REST_FORCES}


def inputs(graph: Graph, seed: int) -> dict[str, FloatArray]:
    random = np.random.default_rng(seed)
    return {name: random.uniform(0.1, 1.0, size) for name, size in graph.inputs.items()}


def check(graph: Graph, given: dict[str, FloatArray], found: dict[str, FloatArray]) -> None:
    for name, expected in graph.evaluate(**given).items():
        np.testing.assert_allclose(found[name], expected, rtol=1e-12, atol=1e-12 * np.abs(expected).max())


@pytest.mark.skipif(COMPILER is None, reason="no C compiler here")
@pytest.mark.parametrize("name", GRAPHS)
def test_c_means_what_the_graph_means(name: str, tmp_path: Path) -> None:
    graph = GRAPHS[name]
    helpers = "".join(
        f"static inline real {word}(real a, real b) {{ return b {sign} a ? b : a; }}\n"
        for word, sign in (("least", "<"), ("largest", ">"))
    )
    text = c_function("run", graph, frozenset("h")).replace("static void run", "void run")
    (tmp_path / "k.c").write_text(
        f"#include <math.h>\ntypedef double real;\n#define R(x) x\n#define M(name) name\n{helpers}{text}"
    )
    subprocess.run([COMPILER, "-std=c99", "-shared", "-fPIC", "k.c", "-o", "k.so", "-lm"], cwd=tmp_path, check=True)
    run = ctypes.CDLL(str(tmp_path / "k.so")).run
    for seed in range(20):
        given = inputs(graph, seed)
        arrays = {key: value.copy() for key, value in given.items()}
        arrays |= {key: np.zeros(size) for key, size in graph.outputs.items() if key not in arrays}
        run(*(ctypes.c_double(a[0]) if key == "h" else a.ctypes.data_as(ctypes.c_void_p) for key, a in arrays.items()))
        check(graph, given, arrays)


class Indexed(dict):
    """A MATLAB array: read by a call, written as an entry, counted from 1."""

    def __call__(self, place: int) -> float:
        return self[place]


@pytest.mark.parametrize("name", GRAPHS)
def test_matlab_means_what_the_graph_means(name: str) -> None:
    graph = GRAPHS[name]
    text = matlab_function("run", graph, frozenset("h"))
    for old, new in (("&&", " and "), ("||", " or "), ("~", " not ")):
        text = text.replace(old, new)
    for seed in range(20):
        given = inputs(graph, seed)
        known = {word: getattr(math, word) for word in ("sqrt", "exp", "expm1", "tanh", "sin", "cos", "isfinite")}
        known |= {"abs": abs, "min": min, "max": max, "choose": lambda condition, a, b: a if condition else b}
        sizes = {key: given.get(key, np.zeros(graph.outputs.get(key, 0))) for key in [*graph.inputs, *graph.outputs]}
        known |= {key: Indexed(enumerate(map(float, values), start=1)) for key, values in sizes.items()}
        known["h"] = float(given["h"][0]) if "h" in given else 0.0
        for line in text.strip().splitlines()[1:-1]:
            exec(re.sub(r"^(\s*)(\w+)\((\d+)\) =", r"\2[\3] =", line).strip().rstrip(";"), known)  # noqa: S102
        check(graph, given, {key: np.array(list(known[key].values())) for key in graph.outputs})
