"""From CasADi expressions to graphs: common subexpressions once, what depends on constants alone apart."""

from typing import Any

import casadi as ca

from pipeline.codegen.graph import Builder, Graph, Operation, reachable, text_of

Expression = Any
Kernels = dict[str, tuple[dict[str, Expression], dict[str, Expression]]]
"""Inputs and outputs of kernels, by their names."""

_NAMES = {
    ca.OP_ADD: "add", ca.OP_SUB: "sub", ca.OP_MUL: "mul", ca.OP_DIV: "div", ca.OP_NEG: "neg", ca.OP_SQRT: "sqrt",
    ca.OP_FABS: "abs", ca.OP_SIGN: "sign", ca.OP_FMIN: "min", ca.OP_FMAX: "max", ca.OP_EXP: "exp", ca.OP_ATAN: "atan",
    ca.OP_SIN: "sin", ca.OP_COS: "cos", ca.OP_TANH: "tanh", ca.OP_LT: "lt", ca.OP_LE: "le", ca.OP_AND: "and",
    ca.OP_OR: "or", ca.OP_NOT: "not", ca.OP_IF_ELSE_ZERO: "where",
}  # fmt: skip


def graphs(kernels: Kernels, hoisted: str) -> dict[str, Graph]:
    """Graphs of kernels that share what depends on the constants `hoisted` alone.

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
    found = {"PREPARE": Graph({hoisted: size}, {"p": len(out)}, text_of(reachable(builder.operations, out)))}
    for name, (inputs, outputs) in kernels.items():
        sizes = {key: value.numel() for key, value in inputs.items() if key != hoisted} | {"p": len(out)}
        found[name] = Graph(sizes, {k: value.numel() for k, value in outputs.items()}, text_of(operations[name]))
    return found


def graph(inputs: dict[str, Expression], outputs: dict[str, Expression]) -> Graph:
    """The graph of one kernel as it is; every entry of its outputs is stored."""
    builder = Builder()
    stores = _trace(builder, inputs, {name: ca.densify(value) for name, value in outputs.items()}, dense=True)
    sizes = [{key: value.numel() for key, value in each.items()} for each in (inputs, outputs)]
    return Graph(sizes[0], sizes[1], text_of(reachable(builder.operations, stores)))


def _trace(
    builder: Builder, inputs: dict[str, Expression], outputs: dict[str, Expression], dense: bool = False
) -> list[Operation]:
    """Add the expressions; what is stored where."""
    sparse = [value if dense else ca.sparsify(value) for value in outputs.values()]
    function = ca.Function("f", list(inputs.values()), ca.cse(sparse), list(inputs), list(outputs))
    register: dict[int, int] = {}
    stores = []
    names = list(inputs)
    for i in range(function.n_instructions()):
        kind, target = function.instruction_id(i), function.instruction_output(i)
        if kind == ca.OP_OUTPUT:
            which, entry = target
            key = list(outputs)[which]
            rows, columns = sparse[which].sparsity().row(), sparse[which].sparsity().get_triplet()[1]
            # Arrays are filled row by row.
            place = rows[entry] * sparse[which].shape[1] + columns[entry]
            stores.append(Operation("store", (register[function.instruction_input(i)[0]],), (key, place)))
            continue
        if kind == ca.OP_INPUT:
            which, entry = function.instruction_input(i)
            value = builder.add("input", place=(names[which], entry))
        elif kind == ca.OP_CONST:
            value = builder.constant(float(function.instruction_constant(i)))
        else:
            value = _operation(builder, kind, [register[r] for r in function.instruction_input(i)])
        register[target[0]] = value
    return stores


def _operation(builder: Builder, kind: int, operands: list[int]) -> int:
    if kind == ca.OP_SQ:
        return builder.add("mul", operands[0], operands[0])
    if kind == ca.OP_TWICE:
        return builder.add("mul", builder.constant(2.0), operands[0])
    if kind == ca.OP_INV:
        return builder.add("div", builder.constant(1.0), operands[0])
    if kind == ca.OP_DIV:
        # As a product: the reciprocal is often wanted again, and where it is a constant it is prepared.
        return builder.add("mul", operands[0], builder.add("div", builder.constant(1.0), operands[1]))
    if kind == ca.OP_ADD:
        return _sum(builder, *operands)
    return builder.add(_NAMES[kind], *operands)


def _sum(builder: Builder, a: int, b: int) -> int:
    """A + b, or a difference where one of them is a negative."""
    for one, other in ((a, b), (b, a)):
        if builder.operations[other].name == "neg":
            return builder.add("sub", one, builder.operations[other].operands[0])
    return builder.add("add", a, b)


def _constant_operations(builder: Builder, hoisted: str) -> list[bool]:
    """Whether each operation depends on numbers and the constants alone."""
    found: list[bool] = []
    for operation in builder.operations:
        if operation.name == "input":
            found.append(operation.place[0] == hoisted)
        else:
            found.append(all(found[i] for i in operation.operands))
    return found


def _kernel(
    builder: Builder, stores: list[Operation], constant: list[bool], prepared: dict[int, int]
) -> list[Operation]:
    """The kernel's own operations; `prepared` collects what it takes from the constants."""
    source = builder.operations
    own = Builder()
    moved: dict[int, int] = {}

    def visit(i: int) -> int:
        if i in moved:
            return moved[i]
        operation = source[i]
        if constant[i]:
            if operation.name == "constant":
                moved[i] = own.constant(operation.value)
            elif operation.operands and all(source[j].name == "constant" for j in operation.operands):
                moved[i] = own.add(operation.name, *(visit(j) for j in operation.operands))
            else:
                place = prepared.setdefault(i, len(prepared))
                moved[i] = own.add("input", place=("p", place))
        else:
            moved[i] = own.add(operation.name, *(visit(j) for j in operation.operands), place=operation.place)
        return moved[i]

    found = [Operation("store", (visit(store.operands[0]),), store.place) for store in stores]
    return reachable(own.operations, found)
