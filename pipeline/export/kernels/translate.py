"""Translate the kernels that debist runs: Python in the subset that numba compiles, to typed statements.

What is understood: numbers, arrays of known extents, tuples of results, `if`, `for … in range`, calls of kernels
and of elementary functions, named tuples of constants. Anything else is refused, so that no export says something
else than the model does. Functions are translated once for each set of argument types.
"""

import ast
import inspect
from collections.abc import Mapping
from typing import Any

import numpy as np

from pipeline.codegen.graph import Graph
from pipeline.export.kernels.kernel_reader import Argument, Reader, Record
from pipeline.export.kernels.program import (
    Array,
    Assign,
    Branch,
    Copy,
    Declare,
    Element,
    Expression,
    Fill,
    Function,
    Invocation,
    Leave,
    Loop,
    Name,
    Number,
    Program,
    Return,
    Skip,
    Statement,
    Type,
)
from pipeline.export.kernels.scopes import assigned, declarations, mentions


class Translator:
    """Collects a program from kernels.

    Attributes
    ----------
    program : Program
        Grows with each call of `function`.

    Parameters
    ----------
    generated : mapping
        Kernels that were generated, and their graphs: their text is written from these.
    """

    def __init__(self, generated: Mapping[Any, Graph] | None = None) -> None:
        self.program = Program()
        self._generated = {_python(kernel): graph for kernel, graph in (generated or {}).items()}
        self._known: dict[tuple[Any, ...], Function] = {}

    def function(self, kernel: Any, arguments: tuple[Argument, ...], name: str = "") -> Function:
        """The kernel for arguments of these types, with everything that it calls.

        Raises
        ------
        UntranslatableError
            The kernel leaves the subset.
        """
        python = _python(kernel)
        if python in self._generated:
            return self._of_graph(python.__name__, self._generated[python])
        key = (python, tuple(id(a.value) if isinstance(a, Record) else a for a in arguments))
        if key not in self._known:
            taken = {function.name for function in self.program.functions}
            made = Function(free_name((name or python.__name__).strip("_"), taken), _summary(python))
            self._known[key] = made
            _Kernel(self, python, made).translate(arguments)
            self.program.functions.append(made)
        return self._known[key]

    def _of_graph(self, name: str, graph: Graph) -> Function:
        """A function that is written from its graph, not translated."""
        sizes = {**graph.inputs, **graph.outputs}
        made = Function(name, "", [Name(each, Array((size,))) for each, size in sizes.items()])
        made.changed = [each for each in made.parameters if each.name in graph.outputs]
        self.program.graphs[name] = graph
        return made

    def constant(self, name: str, value: Any) -> Number | Name:
        """A constant of the program under its own name, or under a numbered one if that means another value."""
        store: dict[str, Any] = self.program.arrays if isinstance(value, np.ndarray) else self.program.numbers
        taken = {*self.program.arrays, *self.program.numbers}
        clear = name.strip("_").upper()
        while clear in taken and not (clear in store and np.array_equal(store[clear], value)):
            clear = free_name(name.strip("_").upper(), taken)
            if clear not in taken:
                break
        store[clear] = value
        if isinstance(value, np.ndarray):
            return Name(clear, Array(value.shape, bool(np.issubdtype(value.dtype, np.integer))))
        return Number(value, clear)


def _python(kernel: Any) -> Any:
    return getattr(kernel, "py_func", kernel)


def free_name(name: str, taken: set[str]) -> str:
    """The name, numbered if it is taken."""
    number, free = 2, name
    while free in taken:
        free, number = f"{name}_{number}", number + 1
    return free


def _summary(python: Any) -> str:
    return (inspect.getdoc(python) or "").split("\n", 1)[0]


class _Kernel(Reader):
    """One kernel on its way to typed statements."""

    def __init__(self, translator: Translator, python: Any, made: Function) -> None:
        super().__init__(translator, python)
        self._made = made
        self._count = assigned(self.node)
        self._begins = declarations(self.node)

    def translate(self, arguments: tuple[Argument, ...]) -> None:
        """Fill the function of the program from the kernel, for arguments of these types."""
        for parameter, type_ in zip(self.node.args.args, arguments, strict=True):
            if isinstance(type_, Record):
                self.known[parameter.arg] = type_
            else:
                name = Name(parameter.arg, type_)
                self.known[parameter.arg] = name
                self._made.parameters.append(name)
        self._made.body = list(self._block(self.node.body))

    def _block(self, body: list[ast.stmt]) -> tuple[Statement, ...]:
        made: list[Statement] = []
        for statement in body:
            made += self._statement(statement)
            if made and isinstance(made[-1], Return):
                break  # what a known extent cuts off
        return tuple(made)

    def _statement(self, node: ast.stmt) -> list[Statement]:
        match node:
            case ast.Expr(ast.Constant()) | ast.Pass():
                return []
            case ast.Expr(ast.Call() as call):
                return [self._invocation(call, ())]
            case ast.AnnAssign(target, _, value) if value is not None:
                return self._assign([target], value, node)
            case ast.Assign(targets, value):
                return self._assign(targets, value, node)
            case ast.AugAssign(target, operator, value):
                old = self.expression(_as_load(target))
                return [self._store(target, self.binary(operator, old, self.expression(value)), node)]
            case ast.For(ast.Name(variable), ast.Call(ast.Name("range"), bounds), body):
                opened = self._open(node)
                return [*opened, self._loop(variable, [self.expression(each) for each in bounds], body)]
            case ast.If(test, then, otherwise):
                return self._branch(self.expression(test), then, otherwise, node)
            case ast.Break():
                return [Leave()]
            case ast.Continue():
                return [Skip()]
            case ast.Return(value):
                return [self._return(value)]
        raise self.refuse(node)

    def _assign(self, targets: list[ast.expr], value: ast.expr, node: ast.stmt) -> list[Statement]:
        if len(targets) > 1:  # a = b = 0.0
            return [self._store(target, self.expression(value), node) for target in targets]
        target = targets[0]
        if isinstance(target, ast.Tuple):
            if isinstance(value, ast.Tuple):
                return self._parallel(target.elts, value.elts, node)
            if isinstance(value, ast.Call):
                return self._unpack(target.elts, value, node)
            raise self.refuse(node)
        if isinstance(target, ast.Subscript) and isinstance(target.slice, ast.Slice):
            return [self._fill(target, target.slice, value)]
        if isinstance(target, ast.Name):
            made = self._array(target.id, value)
            if made:
                return made
            known = self._static(target.id, value)
            if known is not None:
                return []
        if isinstance(value, ast.Call) and self._changes(value):
            return self._unpack([target], value, node)
        return [self._store(target, self.expression(value), node)]

    def _parallel(self, targets: list[ast.expr], values: list[ast.expr], node: ast.stmt) -> list[Statement]:
        for i, target in enumerate(targets):
            base = target.value if isinstance(target, ast.Subscript) else target
            if isinstance(base, ast.Name) and any(mentions(later, base.id) for later in values[i + 1 :]):
                return self._through_temporaries(targets, values, node)
        return [made for pair in zip(targets, values, strict=True) for made in self._assign([pair[0]], pair[1], node)]

    def _through_temporaries(self, targets: list[ast.expr], values: list[ast.expr], node: ast.stmt) -> list[Statement]:
        made: list[Statement] = []
        for i, value in enumerate(values):
            found = self.expression(value)
            held = Name(f"new_{i}_{node.lineno}", found.type)
            self.known[held.name] = held
            made.append(Assign(held, found, declares=True))
        held_names = [Name(f"new_{i}_{node.lineno}", "real") for i in range(len(values))]
        return made + [self._store(t, name, node) for t, name in zip(targets, held_names, strict=True)]

    def _unpack(self, targets: list[ast.expr], call: ast.Call, node: ast.stmt) -> list[Statement]:
        function, arguments = self.callee(call)
        if len(function.results) != len(targets):
            raise self.refuse(node)
        made: list[Statement] = []
        found: list[Name | Element] = []
        for i, (target, type_) in enumerate(zip(targets, function.results, strict=True)):
            if isinstance(target, ast.Name) and target.id == "_":
                unused = Name(f"unused_{i}_{node.lineno}", type_)
                made.append(Declare(unused))
                found.append(unused)
                continue
            if isinstance(target, ast.Name) and target.id not in self.known:
                self.known[target.id] = Name(target.id, type_)
                made.append(Declare(Name(target.id, type_)))
            place = self.expression(_as_load(target))
            if not isinstance(place, Name | Element):
                raise self.refuse(node)
            found.append(place)
        self._note_changes(function, arguments)
        return [*made, Invocation(function, arguments, tuple(found))]

    def _store(self, target: ast.expr, value: Expression, node: ast.stmt) -> Statement:
        declares = False
        if isinstance(target, ast.Name) and target.id not in self.known:
            self.known[target.id] = Name(target.id, value.type)
            declares = target.id in self._begins.get(id(node), ())
        place = self.expression(_as_load(target))
        if not isinstance(place, Name | Element):
            raise self.refuse(node)
        if isinstance(place, Element):
            self._note_change(place.array)
        return Assign(place, value, declares)

    def _array(self, name: str, value: ast.expr) -> list[Statement]:
        """`np.zeros(…)`, `np.empty(…)` and `x.copy()`: a new array."""
        match value:
            case ast.Call(ast.Attribute(ast.Name("np"), "zeros" | "empty"), [extent, *_]):
                type_: Type = Array(self.extents(extent))
                made: list[Statement] = []
            case ast.Call(ast.Attribute(ast.Name(source), "copy"), []):
                original = self.known[source]
                if not isinstance(original, Name):
                    raise self.refuse(value)
                type_ = original.type
                made = [Copy(Name(name, type_), original)]
            case _:
                return []
        self.known[name] = Name(name, type_)
        return [Declare(Name(name, type_)), *made]

    def _static(self, name: str, value: ast.expr) -> Number | None:
        """An integer that never changes, such as an extent, is used as such."""
        if self._count[name] != 1:
            return None
        found = self.expression(value)
        if isinstance(found, Number) and isinstance(found.value, int):
            self.known[name] = found
            return found
        return None

    def _fill(self, target: ast.Subscript, part: ast.Slice, value: ast.expr) -> Statement:
        array = self.expression(target.value)
        if not (isinstance(array, Name) and isinstance(array.type, Array)):
            raise self.refuse(target)
        self._note_change(array)
        filled = self.expression(value)
        start, stop = self.whole(part.lower, 0), self.whole(part.upper, array.type.size)
        if isinstance(filled, Name) and isinstance(filled.type, Array):
            if (start, stop) != (0, filled.type.size):
                raise self.refuse(target)
            return Copy(array, filled)
        return Fill(array, start, stop, filled)

    def _loop(self, variable: str, bounds: list[Expression], body: list[ast.stmt]) -> Statement:
        clear = "turn" if variable == "_" else variable
        name = Name(clear, "int")
        self.known[variable] = name
        start, stop = (Number(0), bounds[0]) if len(bounds) == 1 else bounds[:2]
        return Loop(name, start, stop, self._block(body))

    def _branch(
        self, test: Expression, then: list[ast.stmt], otherwise: list[ast.stmt], node: ast.stmt
    ) -> list[Statement]:
        if isinstance(test, Number):
            return list(self._block(then if test.value else otherwise))
        return [*self._open(node), Branch(test, self._block(then), self._block(otherwise))]

    def _open(self, node: ast.stmt) -> list[Statement]:
        """Declarations of what is assigned inside a statement and used after it."""
        names = [Name(name, "real") for name in self._begins.get(id(node), ())]
        self.known.update({name.name: name for name in names})
        return [Declare(name) for name in names]

    def _return(self, value: ast.expr | None) -> Statement:
        parts = [] if value is None else value.elts if isinstance(value, ast.Tuple) else [value]
        values = tuple(self.expression(part) for part in parts)
        self._made.results = [each.type for each in values]
        return Return(values)

    def _changes(self, call: ast.Call) -> bool:
        """Whether a kernel is called that cannot stand in an expression."""
        if not (isinstance(call.func, ast.Name) and callable(self.python.__globals__.get(call.func.id))):
            return False
        function, _ = self.callee(call)
        return bool(function.changed) or len(function.results) != 1 or isinstance(function.results[0], Array)

    def _invocation(self, call: ast.Call, targets: tuple[Name | Element, ...]) -> Statement:
        function, arguments = self.callee(call)
        self._note_changes(function, arguments)
        return Invocation(function, arguments, targets)

    def _note_changes(self, function: Function, arguments: tuple[Expression, ...]) -> None:
        for parameter, argument in zip(function.parameters, arguments, strict=True):
            if parameter in function.changed and isinstance(argument, Name):
                self._note_change(argument)

    def _note_change(self, array: Name) -> None:
        if array in self._made.parameters and array not in self._made.changed:
            self._made.changed.append(array)


def _as_load(target: ast.expr) -> ast.expr:
    return ast.parse(ast.unparse(target), mode="eval").body
