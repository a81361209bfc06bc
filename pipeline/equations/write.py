"""Writes `pipeline.generated` from `pipeline.equations`: ``python -m pipeline.equations.write``. Needs CasADi.

A test compares the committed files with what this writes.
"""

import sys
import textwrap
from typing import Any

import casadi as ca

from pipeline import generated
from pipeline.codegen.graph import Graph
from pipeline.equations import condensed_joint, data_driven_joint, full_joint, lagged_models, reduced_joint
from pipeline.equations.basis_functions import basis_functions
from pipeline.equations.graphs import graph, graphs

_FULL = """Kernels of the full-order joint.

Inputs: `qm`, `qm_dot`, `qm_ddot` shape (4,) Ritz coordinates [1/m, 1/m², 1/m³, m] and their rates; `z` shape (3,)
Maxwell strains and friction state; `v_squared` shape (2,) [V²]; `force` shape (1,) [N]; `p` shape (41,) parameters
in the order of `parameters.VECTOR_NAMES`. The arguments after them are outputs, written in full."""

_HEADER = '''"""{summary}

Written by ``python -m pipeline.equations.write`` from `pipeline.equations`; not edited.
"""

# fmt: off
# ruff: noqa

'''
_GRAPH = "from pipeline.codegen.graph import Graph\n"


def texts() -> dict[str, str]:
    """File name and text of every generated module."""
    return {
        "analytical_joint.py": _full(),
        "basis_functions.py": _basis_functions(),
        "condensed_joint.py": _condensed(),
        "condensed_joint_jacobian.py": _condensed_jacobian(),
        "terms.py": _terms(),
    }


def _module(summary: str, found: dict[str, Graph], constants: dict[str, Any] | None = None, imports: str = "") -> str:
    """The text of a module with constants and graphs."""
    parts = [_HEADER.format(summary=summary), _GRAPH, imports]
    for name, value in (constants or {}).items():
        parts.append(f"\n{name} = " + "\n    ".join(textwrap.wrap(repr(value), 110, break_long_words=False)) + "\n")
    for name, one in found.items():
        body = "\n".join(textwrap.wrap(one.text, 116, break_long_words=False, break_on_hyphens=False))
        parts.append(f'\n{name} = Graph(\n    {one.inputs!r},\n    {one.outputs!r},\n    """\n{body}\n    """,\n)\n')
    return "".join(parts)


def _condensed() -> str:
    j, s = condensed_joint, condensed_joint.symbols()
    still = {"x": s.x, "u": s.u, "k": s.k, "c": s.c}
    moving = still | {"z": s.z, "start": s.start}
    shape = j.shape(s)
    kernels = {
        "RATES": (moving, {"rates": j.rates(s, j.friction_of(s, j.moved_stops(s)))}),
        "SHAPE": (still, {"forces": shape, "by_shape": ca.jacobian(shape, s.x[[2, 4]])}),
        "INERTIA": ({"x": s.x, "k": s.k}, {"mass": ca.vertcat(*j.frame_inertia(s)[:3])}),
        "STOP_MOVE": ({"x": s.x, "z": s.z, "start": s.start, "k": s.k}, {"moved": ca.vertcat(*j.moved_stops(s))}),
    }
    names = ["CONSTANTS", "TIP_CONSTANTS", "TIP_DIMENSIONS", "CORRECTIONS", "STATES", "ELEMENT_STATES", "FIRST_ELEMENT"]
    names += ["DRY_LEVELS", "AT_REST", "STOPS", "CREEPS", "BRANCHES"]
    constants = {name: getattr(j, name) for name in names}
    return _module(
        "The condensed joint: rates, forces at rest, inertia, stop operators after a step.",
        graphs(kernels, "k"),
        constants,
    )


def _condensed_jacobian() -> str:
    s = condensed_joint.symbols()
    moving = {"x": s.x, "u": s.u, "k": s.k, "c": s.c, "z": s.z}
    linear = condensed_joint.linearised(s)
    by_k, slopes = linear.pop("by_k"), linear.pop("c_q")
    exact = {"JACOBIAN": (moving | {"c_q": slopes}, linear), "BY_CONSTANTS": (moving, {"by_k": by_k})}
    return _module("Exact derivatives of the condensed joint's rates.", graphs(exact, "k"))


def _full() -> str:
    kernels = full_joint.kernels(full_joint.symbols())
    found = {name.upper(): graph(inputs, outputs) for name, (_, inputs, outputs) in kernels.items()}
    functions = [_function(name, docstring, found[name.upper()]) for name, (docstring, _, _) in kernels.items()]
    imports = "from pipeline.codegen.numba_writer import kernel\nfrom pipeline.compiled import compiled\n"
    imports += "from pipeline.numerics.arrays import FloatArray\n"
    return _module(_FULL, found, imports=imports) + "".join(functions)


def _function(name: str, docstring: str, source: Graph) -> str:
    """A compiled function of arrays; a last output of one entry is returned."""
    value = next((output for output in source.outputs if output == "energy"), None)
    arguments = [argument for argument in [*source.inputs, *source.outputs] if argument != value]
    signature = ", ".join(f"{argument}: FloatArray" for argument in arguments)
    call = f"_{name}(({', '.join(arguments)}))"
    return (
        f"\n\n_{name} = kernel({name.upper()}, value={value!r})\n"
        "\n\n@compiled(inline='always')\n"
        f"def {name}({signature}) -> {'float' if value else 'None'}:\n"
        f'    """{docstring}"""\n' + (f"    found: float = {call}\n    return found\n" if value else f"    {call}\n")
    )


def _basis_functions() -> str:
    known, square = basis_functions(), ca.SX.sym("square")
    values = {name: one.law(square) for name, one in known.items()}
    outputs = {name: {"found": ca.vertcat(value, ca.gradient(value, square))} for name, value in values.items()}
    found = {name.upper(): graph({"square": square}, output) for name, output in outputs.items()}
    imports = "from pipeline.codegen.numba_writer import formula\nfrom pipeline.compiled import compiled\n"
    # An infinite reach is written as a number whose square is one.
    constants = {"NAMES": tuple(known), "REACHES": tuple(min(one.reach, 1e150) for one in known.values())}
    text = _module("Radial basis functions: values and slopes.", found, constants, imports)
    text += "\nGRAPHS = {" + ", ".join(f"{name!r}: {name.upper()}" for name in known) + "}\n"
    text += "".join(f"\n_{name} = formula({name.upper()})\n" for name in known)
    text += "\n\n@compiled\ndef basis_function(kind: int, square: float) -> tuple[float, float]:\n"
    text += '    """Value of the function `NAMES[kind]`, and its slope along `square`, ((q − ξ)/σ)²."""\n'
    for kind, name in enumerate(known):
        case = "    " if kind == len(known) - 1 else f"    if kind == {kind}:\n        "
        text += f"{case}return _{name}((square,))  # type: ignore[no-any-return]\n"
    return text


def _terms() -> str:
    kernels = data_driven_joint.kernels() | lagged_models.kernels() | reduced_joint.kernels()
    summary = "Terms of the models of which each run has as many as it needs: see the laws of the same names."
    return _module(summary, {name: graph(inputs, outputs) for name, (inputs, outputs) in kernels.items()})


if __name__ == "__main__":
    sys.setrecursionlimit(100_000)  # a chain of operations is walked by recursion
    for file_name, text in texts().items():
        with open(f"{generated.__path__[0]}/{file_name}", "w", encoding="utf-8") as target:  # noqa: PTH123 - no paths here
            target.write(text)
