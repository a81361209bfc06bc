"""Writes `pipeline.generated` from `pipeline.equations`: ``python -m pipeline.equations.write``. Needs CasADi.

Expressions become graphs with every common subexpression once, and what depends on constants alone apart. A test
compares the committed files with what this writes.
"""

import sys
import textwrap
from functools import cache
from typing import Any

import casadi as ca

from .. import generated
from ..codegen.graph import Builder, Graph, Operation, reachable, text_of
from . import (
    beam,
    condensed_joint,
    condensed_parts,
    elements,
    full_joint,
)

_FULL = """Kernels of the full-order joint.

Inputs: `qm`, `qm_dot`, `qm_ddot` shape (4,) Ritz coordinates [1/m, 1/m², 1/m³, m] and their rates; `z` shape (3,)
Maxwell strains and friction state; `v_squared` shape (2,) [V²]; `force` shape (1,) [N]; `p` shape (41,) parameters
in the order of `pipeline.device.parameters.VECTOR_NAMES`. The arguments after them are outputs."""

_HEADER = '''"""{summary}

Written by ``python -m pipeline.equations.write`` from `pipeline.equations`; not edited.
"""

# fmt: off
# ruff: noqa

'''


def texts() -> dict[str, str]:
    """File name and text of every generated module."""
    return {
        "analytical_joint.py": _full(),
        "condensed_joint.py": _condensed(),
        "condensed_joint_jacobian.py": _condensed_jacobian(),
        "terms.py": _terms(),
    }


def _module(summary: str, named: dict[str, Graph], constants: dict[str, Any] | None = None, imports: str = "") -> str:
    """The text of a module with constants and graphs."""
    parts = [
        _HEADER.format(summary=summary),
        "from ..codegen.graph import Graph\n",
        imports,
        *(
            f"\n{name} = " + "\n    ".join(textwrap.wrap(repr(value), 110, break_long_words=False)) + "\n"
            for name, value in (constants or {}).items()
        ),
    ]
    for name, each in named.items():
        body = "\n".join(textwrap.wrap(each.text, 116, break_long_words=False, break_on_hyphens=False))
        parts.append(f'\n{name} = Graph(\n    {each.inputs!r},\n    {each.outputs!r},\n    """\n{body}\n    """,\n)\n')
    return "".join(parts)


def _condensed() -> str:
    j = condensed_joint
    s = condensed_parts.symbols()
    still = {"x": s.x, "u": s.u, "k": s.k, "c": s.c}
    moving = still | {"z": s.z, "start": s.start}
    forces = j.rest_forces(s)
    mass, _ = condensed_parts.frame_inertia(s)
    upper = ca.vertcat(*(mass[i, k] for k in range(3) for i in range(k + 1)))
    kernels = {
        "RATES": (moving, {"rates": j.rates(s, j.stop_forces(s, j.moved_stops(s)))}),
        "REST_FORCES": (still, {"forces": forces, "by_shape": ca.jacobian(forces, s.x[condensed_parts.SHAPE[1:]])}),
        "INERTIA": ({"x": s.x, "k": s.k}, {"mass": upper}),
        "STOP_MOVE": ({"x": s.x, "z": s.z, "start": s.start, "k": s.k}, {"moved": ca.vertcat(*j.moved_stops(s))}),
    }
    names = [
        "CONSTANTS",
        "TIP_CONSTANTS",
        "CORRECTIONS",
        "STATES",
        "ELEMENT_STATES",
        "SHAPE",
        "SHAPE_RATES",
        "FIRST_STRAIN",
        "QUARTICS",
        "SEXTICS",
        "SHORTENINGS",
        "FIRST_ELEMENT",
        "SOFTENING",
        "DRY_LEVELS",
        "AT_REST",
        "STOPS",
        "STOP_ELEMENTS",
        "STOP_SHARES",
        "STOP_DIRECTIONS",
        "SLIPS",
        "LAYERS",
        "CREEPS",
        "BRANCHES",
    ]
    integrals = {name: beam.products(order) for order, name in enumerate(("SHAPES", "SLOPES", "BENDS"))}
    return _module(
        "The condensed joint: rates, forces at rest, inertia, stop operators after a step.",
        graphs(kernels, "k") | {"UPRIGHT": graph({"k": s.k}, {"load": j.upright_load(s)})},
        {name: getattr(condensed_parts, name) for name in names} | integrals,
    )


def _condensed_jacobian() -> str:
    s = condensed_parts.symbols()
    moving = {"x": s.x, "u": s.u, "k": s.k, "c": s.c, "z": s.z}
    slopes, linear, by_k = condensed_joint.linearised(s)
    exact = {"JACOBIAN": (moving | {"c_q": slopes}, linear), "BY_CONSTANTS": (moving, {"by_k": by_k})}
    return _module("Exact derivatives of the condensed joint's rates.", graphs(exact, "k"))


def _full() -> str:
    kernels = full_joint.kernels(full_joint.symbols())
    named = {name.upper(): graph(inputs, outputs) for name, (_, inputs, outputs) in kernels.items()}
    functions = [_function(name, docstring, named[name.upper()]) for name, (docstring, _, _) in kernels.items()]
    imports = (
        "from ..codegen.numba_writer import kernel\nfrom ..numerics.compiled import compiled\n"
        "from ..numerics.arrays import FloatArray\n"
    )
    return _module(_FULL, named, imports=imports) + "".join(functions)


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


def _terms() -> str:
    kernels = elements.kernels() | full_joint.reduced_kernels()
    summary = "Terms of the models of which each run has as many as it needs: see the functions of the same names."
    return _module(summary, {name: graph(inputs, outputs) for name, (inputs, outputs) in kernels.items()})


_NAMES = {
    ca.OP_ADD: "add", ca.OP_SUB: "sub", ca.OP_MUL: "mul", ca.OP_DIV: "div", ca.OP_NEG: "neg", ca.OP_SQRT: "sqrt",
    ca.OP_FABS: "abs", ca.OP_SIGN: "sign", ca.OP_FMIN: "min", ca.OP_FMAX: "max", ca.OP_EXP: "exp", ca.OP_ATAN: "atan",
    ca.OP_SIN: "sin", ca.OP_COS: "cos", ca.OP_TANH: "tanh", ca.OP_LT: "lt", ca.OP_LE: "le", ca.OP_AND: "and",
    ca.OP_OR: "or", ca.OP_NOT: "not", ca.OP_IF_ELSE_ZERO: "where",
}  # fmt: skip


def graphs(kernels: dict[str, elements.Term], hoisted: str) -> dict[str, Graph]:
    """Graphs of kernels that share the operations on the `hoisted` constants alone.

    Parameters
    ----------
    kernels : dict
        Inputs and outputs of each kernel by name; every kernel that has the constants names them alike.
    hoisted : str
        Name of the input that is constant through a run.

    Returns
    -------
    dict
        First ``PREPARE``, from the constants to the prepared constants ``p``; then the kernels, with ``p`` in the place
        of the constants. Zeros of their structure are not stored.
    """
    builder = Builder()
    stores = {name: _trace(builder, inputs, outputs) for name, (inputs, outputs) in kernels.items()}
    constant = _constant_operations(builder, hoisted)
    prepared: dict[int, int] = {}
    operations = {name: _kernel(builder, stores[name], constant, prepared) for name in kernels}
    out = [Operation("store", (source,), ("p", place)) for source, place in prepared.items()]
    size = next(inputs[hoisted].numel() for inputs, _ in kernels.values() if hoisted in inputs)
    named = {"PREPARE": Graph({hoisted: size}, {"p": len(out)}, text_of(reachable(builder.operations, out)))}
    for name, (inputs, outputs) in kernels.items():
        sizes = {key: value.numel() for key, value in inputs.items() if key != hoisted} | {"p": len(out)}
        named[name] = Graph(sizes, {k: value.numel() for k, value in outputs.items()}, text_of(operations[name]))
    return named


def graph(inputs: dict[str, elements.Expression], outputs: dict[str, elements.Expression]) -> Graph:
    """The graph of one kernel as it is; every entry of its outputs is stored."""
    builder = Builder()
    stores = _trace(builder, inputs, {name: ca.densify(value) for name, value in outputs.items()}, dense=True)
    sizes = [{key: value.numel() for key, value in each.items()} for each in (inputs, outputs)]
    return Graph(sizes[0], sizes[1], text_of(reachable(builder.operations, stores)))


def _trace(
    builder: Builder,
    inputs: dict[str, elements.Expression],
    outputs: dict[str, elements.Expression],
    dense: bool = False,
) -> list[Operation]:
    """Add the expressions to the builder; return the stores of their entries."""
    sparse = [value if dense else ca.sparsify(value) for value in outputs.values()]
    function = ca.Function("f", list(inputs.values()), ca.cse(sparse), list(inputs), list(outputs))
    register: dict[int, int] = {}
    stores = []
    for i in range(function.n_instructions()):
        kind = function.instruction_id(i)
        target = function.instruction_output(i)
        if kind == ca.OP_OUTPUT:
            which, entry = target
            rows, columns = sparse[which].sparsity().get_triplet()
            # Arrays are filled row by row.
            place = rows[entry] * sparse[which].shape[1] + columns[entry]
            source = register[function.instruction_input(i)[0]]
            stores.append(Operation("store", (source,), (list(outputs)[which], place)))
            continue
        if kind == ca.OP_INPUT:
            which, entry = function.instruction_input(i)
            value = builder.input(list(inputs)[which], entry)
        elif kind == ca.OP_CONST:
            value = builder.constant(float(function.instruction_constant(i)))
        else:
            value = _operation(builder, kind, [register[r] for r in function.instruction_input(i)])
        register[target[0]] = value
    return stores


def _operation(builder: Builder, kind: int, operands: list[int]) -> int:
    match kind:
        case ca.OP_SQ:
            return builder.add("mul", operands[0], operands[0])
        case ca.OP_TWICE:
            return builder.add("mul", builder.constant(2.0), operands[0])
        case ca.OP_INV:
            return builder.add("div", builder.constant(1.0), operands[0])
        case ca.OP_DIV:
            # As a product: the reciprocal is often wanted again, and where it is a constant it is prepared.
            return builder.add("mul", operands[0], builder.add("div", builder.constant(1.0), operands[1]))
        case ca.OP_ADD:
            return _sum(builder, *operands)
    return builder.add(_NAMES[kind], *operands)


def _sum(builder: Builder, a: int, b: int) -> int:
    """Sum of a and b, or a difference where one of them is a negative."""
    for first, other in ((a, b), (b, a)):
        if builder.operations[other].name == "neg":
            return builder.add("sub", first, builder.operations[other].operands[0])
    return builder.add("add", a, b)


def _constant_operations(builder: Builder, hoisted: str) -> list[bool]:
    """Flag of each operation: true if it depends on numbers and the constants alone."""
    constant: list[bool] = []
    for operation in builder.operations:
        given = operation.name != "input" or operation.place[0] == hoisted
        constant.append(given and all(constant[i] for i in operation.operands))
    return constant


def _kernel(
    builder: Builder, stores: list[Operation], constant: list[bool], prepared: dict[int, int]
) -> list[Operation]:
    """The kernel's own operations; `prepared` collects the operations on constants that it reads."""
    source = builder.operations
    own = Builder()

    @cache
    def visit(i: int) -> int:
        """Place among `own` of operation i, with all that it needs."""
        operation = source[i]
        if operation.name == "constant":
            return own.constant(operation.value)
        of_numbers = operation.operands and all(source[j].name == "constant" for j in operation.operands)
        if constant[i] and not of_numbers:
            return own.input("p", prepared.setdefault(i, len(prepared)))
        return own.add(operation.name, *(visit(j) for j in operation.operands), place=operation.place)

    return reachable(own.operations, [store._replace(operands=(visit(store.operands[0]),)) for store in stores])


if __name__ == "__main__":
    sys.setrecursionlimit(100_000)  # a chain of operations is walked by recursion
    for file_name, text in texts().items():
        with open(f"{generated.__path__[0]}/{file_name}", "w", encoding="utf-8", newline="\n") as target:  # noqa: PTH123 - no paths here
            target.write(text)
