"""Writes `pipeline.generated` from `pipeline.equations`: ``python -m pipeline.codegen.write``. Needs CasADi.

A test compares the committed files with what this writes.
"""

import sys
import textwrap
from pathlib import Path
from typing import Any

import casadi as ca

from pipeline.codegen.from_casadi import Kernels, graphs
from pipeline.codegen.graph import Graph
from pipeline.equations import condensed_joint

FOLDER = Path(__file__).parent.parent / "generated"
_HEADER = '''"""{summary}

Written by ``python -m pipeline.codegen.write`` from `pipeline.equations.{source}`; not edited.
"""

# fmt: off

from pipeline.codegen.graph import Graph
'''


def _module(summary: str, source: str, constants: dict[str, Any], found: dict[str, Graph]) -> str:
    parts = [_HEADER.format(summary=summary, source=source)]
    for name, value in constants.items():
        parts.append(f"\n{name} = " + "\n    ".join(textwrap.wrap(repr(value), 110, break_long_words=False)) + "\n")
    for name, graph in found.items():
        body = "\n".join(textwrap.wrap(graph.text, 116, break_long_words=False, break_on_hyphens=False))
        parts.append(
            f'\n{name} = Graph(\n    {graph.inputs!r},\n    {graph.outputs!r},\n    """\n{body}\n    """,\n)\n'
        )
    return "".join(parts)


def _condensed() -> dict[str, str]:
    j, s = condensed_joint, condensed_joint.symbols()
    still = {"x": s.x, "u": s.u, "k": s.k, "c": s.c}
    moving = still | {"z": s.z}
    shape = j.shape(s)
    kernels = {
        "RATES": (moving | {"start": s.start}, {"rates": j.rates(s, j.friction_of(s, j.moved_stops(s)))}),
        "SHAPE": (still, {"forces": shape, "by_shape": ca.jacobian(shape, s.x[[2, 4]])}),
        "INERTIA": ({"x": s.x, "k": s.k}, {"mass": ca.vertcat(*j.frame_inertia(s)[:3])}),
    }
    linear = j.linearised(s)
    by_k, slopes = linear.pop("by_k"), linear.pop("c_q")
    exact = {"JACOBIAN": (moving | {"c_q": slopes}, linear), "BY_CONSTANTS": (moving, {"by_k": by_k})}
    names = ("CONSTANTS", "CORRECTIONS", "STATES", "STOPS", "CREEPS", "BRANCHES")
    return {
        "condensed_joint.py": _module(
            "The condensed joint: rates, forces at rest and inertia.",
            "condensed_joint",
            {name: getattr(j, name) for name in names},
            _prepared(kernels),
        ),
        "condensed_joint_jacobian.py": _module(
            "Exact derivatives of the condensed joint's rates.", "condensed_joint", {}, _prepared(exact)
        ),
    }


def _prepared(kernels: Kernels) -> dict[str, Graph]:
    prepare, found = graphs(kernels, "k")
    return {"PREPARE": prepare} | found


def texts() -> dict[str, str]:
    """File name and text of every generated module."""
    return _condensed()


if __name__ == "__main__":
    sys.setrecursionlimit(100_000)  # a chain of operations is walked by recursion
    for file_name, text in texts().items():
        (FOLDER / file_name).write_text(text, encoding="utf-8")
