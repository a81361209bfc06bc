"""Translate the kernels that debist runs: Python in the subset that numba compiles, to typed statements.

What is understood: numbers, arrays of known extents, tuples of results, `if`, `for … in range`, calls of kernels
and of elementary functions, named tuples of constants. Anything else is refused, so that no export says something
else than the model does. Functions are translated once for each set of argument types.
"""

import ast
import inspect
import textwrap
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from pipeline.export.program import (
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
    Invoke,
    Leave,
    Loop,
    Name,
    Number,
    Operation,
    Program,
    Return,
    Statement,
    Type,
)
from pipeline.export.scopes import assigned, declarations, mentions

_BINARY = {ast.Add: "+", ast.Sub: "-", ast.Mult: "*", ast.Div: "/"}
_COMPARE = {ast.Lt: "<", ast.LtE: "<=", ast.Gt: ">", ast.GtE: ">=", ast.Eq: "==", ast.NotEq: "!="}
_ELEMENTARY = ("sqrt", "exp", "tanh", "sin", "cos", "abs", "isfinite")
_FOLD: dict[str, Callable[[Any, Any], Any]] = {
    "+": lambda a, b: a + b,
    "-": lambda a, b: a - b,
    "*": lambda a, b: a * b,
    "<": lambda a, b: a < b,
    "<=": lambda a, b: a <= b,
    ">": lambda a, b: a > b,
    ">=": lambda a, b: a >= b,
    "==": lambda a, b: a == b,
    "!=": lambda a, b: a != b,
}


class UntranslatableError(Exception):
    """A kernel uses Python beyond the subset: a bug of debist, not of its user."""


@dataclass(frozen=True)
class Record:
    """Argument type of a named tuple of constants; the parameter vanishes, its fields become constants."""

    value: Any


Argument = Type | Record


class Translator:
    """Collects a program from kernels.

    Attributes
    ----------
    program : Program
        Grows with each call of `function`.
    """

    def __init__(self) -> None:
        self.program = Program()
        self._known: dict[tuple[Any, ...], Function] = {}

    def function(self, kernel: Any, arguments: tuple[Argument, ...], name: str = "") -> Function:
        """The kernel for arguments of these types, with everything that it calls.

        Raises
        ------
        UntranslatableError
            The kernel leaves the subset.
        """
        python = getattr(kernel, "py_func", kernel)
        key = (python, tuple(id(a.value) if isinstance(a, Record) else a for a in arguments))
        if key not in self._known:
            taken = {function.name for function in self.program.functions}
            made = Function(free_name((name or python.__name__).strip("_"), taken), _summary(python))
            self._known[key] = made
            _Kernel(self, python, made).translate(arguments)
            self.program.functions.append(made)
        return self._known[key]

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


def free_name(name: str, taken: set[str]) -> str:
    """The name, numbered if it is taken."""
    number, free = 2, name
    while free in taken:
        free, number = f"{name}_{number}", number + 1
    return free


def _summary(python: Any) -> str:
    return (inspect.getdoc(python) or "").split("\n", 1)[0]


class _Kernel:
    """One kernel on its way."""

    def __init__(self, translator: Translator, python: Any, made: Function) -> None:
        self._all = translator
        self._python = python
        self._made = made
        node = ast.parse(textwrap.dedent(inspect.getsource(python))).body[0]
        if not isinstance(node, ast.FunctionDef):
            raise UntranslatableError(f"{python} is no function")
        self._node = node
        self._known: dict[str, Expression | Record] = {}
        self._count = assigned(node)
        self._begins = declarations(node)

    def translate(self, arguments: tuple[Argument, ...]) -> None:
        for parameter, type_ in zip(self._node.args.args, arguments, strict=True):
            if isinstance(type_, Record):
                self._known[parameter.arg] = type_
            else:
                name = Name(parameter.arg, type_)
                self._known[parameter.arg] = name
                self._made.parameters.append(name)
        self._made.body = list(self._block(self._node.body))

    # statements

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
                old = self._expression(_as_load(target))
                return [self._store(target, self._binary(operator, old, self._expression(value)), node)]
            case ast.For(ast.Name(variable), ast.Call(ast.Name("range"), bounds), body):
                opened = self._open(node)
                return [*opened, self._loop(variable, [self._expression(each) for each in bounds], body)]
            case ast.If(test, then, otherwise):
                return self._branch(self._expression(test), then, otherwise, node)
            case ast.Break():
                return [Leave()]
            case ast.Return(value):
                return [self._return(value)]
        raise self._refuse(node)

    def _assign(self, targets: list[ast.expr], value: ast.expr, node: ast.stmt) -> list[Statement]:
        if len(targets) > 1:  # a = b = 0.0
            return [self._store(target, self._expression(value), node) for target in targets]
        target = targets[0]
        if isinstance(target, ast.Tuple):
            if isinstance(value, ast.Tuple):
                return self._parallel(target.elts, value.elts, node)
            if isinstance(value, ast.Call):
                return self._unpack(target.elts, value, node)
            raise self._refuse(node)
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
        return [self._store(target, self._expression(value), node)]

    def _parallel(self, targets: list[ast.expr], values: list[ast.expr], node: ast.stmt) -> list[Statement]:
        for i, target in enumerate(targets):
            base = target.value if isinstance(target, ast.Subscript) else target
            if isinstance(base, ast.Name) and any(mentions(later, base.id) for later in values[i + 1 :]):
                return self._through_temporaries(targets, values, node)
        return [made for pair in zip(targets, values, strict=True) for made in self._assign([pair[0]], pair[1], node)]

    def _through_temporaries(self, targets: list[ast.expr], values: list[ast.expr], node: ast.stmt) -> list[Statement]:
        made: list[Statement] = []
        for i, value in enumerate(values):
            found = self._expression(value)
            held = Name(f"new_{i}_{node.lineno}", found.type)
            self._known[held.name] = held
            made.append(Assign(held, found, declares=True))
        held_names = [Name(f"new_{i}_{node.lineno}", "real") for i in range(len(values))]
        return made + [self._store(t, name, node) for t, name in zip(targets, held_names, strict=True)]

    def _unpack(self, targets: list[ast.expr], call: ast.Call, node: ast.stmt) -> list[Statement]:
        function, arguments = self._callee(call)
        if len(function.results) != len(targets):
            raise self._refuse(node)
        made: list[Statement] = []
        found: list[Name | Element] = []
        for target, type_ in zip(targets, function.results, strict=True):
            if isinstance(target, ast.Name) and target.id not in self._known:
                self._known[target.id] = Name(target.id, type_)
                made.append(Declare(Name(target.id, type_)))
            place = self._expression(_as_load(target))
            if not isinstance(place, Name | Element):
                raise self._refuse(node)
            found.append(place)
        self._note_changes(function, arguments)
        return [*made, Invocation(function, arguments, tuple(found))]

    def _store(self, target: ast.expr, value: Expression, node: ast.stmt) -> Statement:
        declares = False
        if isinstance(target, ast.Name) and target.id not in self._known:
            self._known[target.id] = Name(target.id, value.type)
            declares = target.id in self._begins.get(id(node), ())
        place = self._expression(_as_load(target))
        if not isinstance(place, Name | Element):
            raise self._refuse(node)
        if isinstance(place, Element):
            self._note_change(place.array)
        return Assign(place, value, declares)

    def _array(self, name: str, value: ast.expr) -> list[Statement]:
        """`np.zeros(…)`, `np.empty(…)` and `x.copy()`: a new array."""
        match value:
            case ast.Call(ast.Attribute(ast.Name("np"), "zeros" | "empty"), [extent, *_]):
                type_: Type = Array(self._extents(extent))
                made: list[Statement] = []
            case ast.Call(ast.Attribute(ast.Name(source), "copy"), []):
                original = self._known[source]
                if not isinstance(original, Name):
                    raise self._refuse(value)
                type_ = original.type
                made = [Copy(Name(name, type_), original)]
            case _:
                return []
        self._known[name] = Name(name, type_)
        return [Declare(Name(name, type_)), *made]

    def _static(self, name: str, value: ast.expr) -> Number | None:
        """An integer that never changes, such as an extent, is used as such."""
        if self._count[name] != 1:
            return None
        found = self._expression(value)
        if isinstance(found, Number) and isinstance(found.value, int):
            self._known[name] = found
            return found
        return None

    def _fill(self, target: ast.Subscript, part: ast.Slice, value: ast.expr) -> Statement:
        array = self._expression(target.value)
        if not (isinstance(array, Name) and isinstance(array.type, Array)):
            raise self._refuse(target)
        self._note_change(array)
        filled = self._expression(value)
        start, stop = self._whole(part.lower, 0), self._whole(part.upper, array.type.size)
        if isinstance(filled, Name) and isinstance(filled.type, Array):
            if (start, stop) != (0, filled.type.size):
                raise self._refuse(target)
            return Copy(array, filled)
        return Fill(array, start, stop, filled)

    def _loop(self, variable: str, bounds: list[Expression], body: list[ast.stmt]) -> Statement:
        clear = "turn" if variable == "_" else variable
        name = Name(clear, "int")
        self._known[variable] = name
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
        self._known.update({name.name: name for name in names})
        return [Declare(name) for name in names]

    def _return(self, value: ast.expr | None) -> Statement:
        parts = [] if value is None else value.elts if isinstance(value, ast.Tuple) else [value]
        values = tuple(self._expression(part) for part in parts)
        self._made.results = [each.type for each in values]
        return Return(values)

    # calls

    def _callee(self, call: ast.Call) -> tuple[Function, tuple[Expression, ...]]:
        kernel = self._python.__globals__.get(call.func.id) if isinstance(call.func, ast.Name) else None
        if kernel is None:
            raise self._refuse(call)
        types: list[Argument] = []
        passed: list[Expression] = []
        for argument in call.args:
            record = self._record(argument)
            if record is not None:
                types.append(record)
                continue
            found = self._zeros(argument) or self._expression(argument)
            types.append(found.type)
            passed.append(found)
        return self._all.function(kernel, tuple(types)), tuple(passed)

    def _zeros(self, argument: ast.expr) -> Name | None:
        """`np.zeros(…)` as an argument: a constant."""
        match argument:
            case ast.Call(ast.Attribute(ast.Name("np"), "zeros"), [extent]):
                shape = self._extents(extent)
                name = "NONE" if 0 in shape else f"ZEROS_{'_'.join(map(str, shape))}"
                constant = self._all.constant(name, np.zeros(shape))
                return constant if isinstance(constant, Name) else None
        return None

    def _changes(self, call: ast.Call) -> bool:
        """Whether a kernel is called that cannot stand in an expression."""
        if not (isinstance(call.func, ast.Name) and callable(self._python.__globals__.get(call.func.id))):
            return False
        function, _ = self._callee(call)
        return bool(function.changed) or len(function.results) != 1 or isinstance(function.results[0], Array)

    def _invocation(self, call: ast.Call, targets: tuple[Name | Element, ...]) -> Statement:
        function, arguments = self._callee(call)
        self._note_changes(function, arguments)
        return Invocation(function, arguments, targets)

    def _note_changes(self, function: Function, arguments: tuple[Expression, ...]) -> None:
        for parameter, argument in zip(function.parameters, arguments, strict=True):
            if parameter in function.changed and isinstance(argument, Name):
                self._note_change(argument)

    def _note_change(self, array: Name) -> None:
        if array in self._made.parameters and array not in self._made.changed:
            self._made.changed.append(array)

    # expressions

    def _expression(self, node: ast.expr) -> Expression:
        match node:
            case ast.Constant(bool(value)):
                return Number(int(value))
            case ast.Constant(int(value) | float(value)):
                return Number(value)
            case ast.Name(name):
                return self._name(name, node)
            case ast.Attribute(owner, field) if (record := self._record(owner)) is not None:
                return self._all.constant(field, _plain(getattr(record.value, field)))
            case ast.Subscript(ast.Attribute(owner, "shape"), ast.Constant(int(axis))):
                return Number(self._shape(owner)[axis])
            case ast.Subscript(array, index):
                return self._element(array, index)
            case ast.BinOp(left, operator, right):
                return self._binary(operator, self._expression(left), self._expression(right), right)
            case ast.UnaryOp(ast.USub(), operand):
                negated = self._expression(operand)
                if isinstance(negated, Number):
                    return Number(-negated.value)
                return Operation("neg", (negated,), negated.type)
            case ast.UnaryOp(ast.Not(), operand):
                return Operation("not", (self._expression(operand),), "bool")
            case ast.Compare():
                return self._comparison(node)
            case ast.BoolOp(operator, values):
                word = "and" if isinstance(operator, ast.And) else "or"
                return Operation(word, tuple(self._expression(each) for each in values), "bool")
            case ast.IfExp(test, then, otherwise):
                condition, one, other = (self._expression(each) for each in (test, then, otherwise))
                if isinstance(condition, Number):
                    return one if condition.value else other
                return Operation("choose", (condition, one, other), _wider(one, other))
            case ast.Call():
                return self._call(node)
        raise self._refuse(node)

    def _record(self, node: ast.expr) -> Record | None:
        """A named tuple of constants, or one inside another."""
        if isinstance(node, ast.Name):
            known = self._known.get(node.id)
            return known if isinstance(known, Record) else None
        if isinstance(node, ast.Attribute) and (owner := self._record(node.value)) is not None:
            value = getattr(owner.value, node.attr)
            return Record(value) if isinstance(value, tuple) else None
        return None

    def _name(self, name: str, node: ast.expr) -> Expression:
        if name in self._known:
            known = self._known[name]
            if isinstance(known, Record):
                raise self._refuse(node)
            return known
        value = self._python.__globals__.get(name)
        if value is None or callable(value):
            raise self._refuse(node)
        return self._all.constant(name, _plain(value))

    def _element(self, array: ast.expr, index: ast.expr) -> Expression:
        base = self._expression(array)
        parts = index.elts if isinstance(index, ast.Tuple) else [index]
        if not (isinstance(base, Name) and isinstance(base.type, Array) and len(parts) == len(base.type.shape)):
            raise self._refuse(array)
        return Element(base, tuple(self._expression(part) for part in parts))

    def _binary(
        self, operator: ast.operator, left: Expression, right: Expression, power: ast.expr | None = None
    ) -> Expression:
        if isinstance(operator, ast.Pow) and isinstance(right, Number) and right.value == 2:
            return Operation("square", (left,), left.type)
        symbol = _BINARY.get(type(operator))
        if symbol is None:
            raise self._refuse(power or self._node)
        whole = all(each.type == "int" for each in (left, right))
        if whole and isinstance(left, Number) and isinstance(right, Number) and symbol in _FOLD:
            return Number(_FOLD[symbol](left.value, right.value))
        return Operation(symbol, (left, right), "int" if whole and symbol != "/" else "real")

    def _comparison(self, node: ast.Compare) -> Expression:
        values = [self._expression(each) for each in (node.left, *node.comparators)]
        parts: list[Expression] = []
        for operator, left, right in zip(node.ops, values, values[1:], strict=False):
            symbol = _COMPARE.get(type(operator))
            if symbol is None:
                raise self._refuse(node)
            if isinstance(left, Number) and isinstance(right, Number):
                parts.append(Number(int(_FOLD[symbol](left.value, right.value))))
            else:
                parts.append(Operation(symbol, (left, right), "bool"))
        return parts[0] if len(parts) == 1 else Operation("and", tuple(parts), "bool")

    def _call(self, node: ast.Call) -> Expression:
        match node:
            case ast.Call(ast.Name("bool" | "float"), [value]):
                return self._expression(value)
            case ast.Call(ast.Name("len"), [array]):
                return Number(self._shape(array)[0])
            case ast.Call(ast.Name("min" | "max" as which), values):
                found = [self._expression(each) for each in values]
                folded = found[0]
                for each in found[1:]:
                    folded = Operation(which, (folded, each), _wider(folded, each))
                return folded
            case ast.Call(ast.Attribute(ast.Name("np"), "sum"), [ast.Subscript(array, ast.Slice() as part)]):
                return self._sum(array, part)
            case ast.Call(ast.Attribute(ast.Name("np" | "math"), name), [value]) | ast.Call(
                ast.Name("abs" as name), [value]
            ) if name in _ELEMENTARY:
                return Operation(name, (self._expression(value),), "bool" if name == "isfinite" else "real")
        function, arguments = self._callee(node)
        if function.changed or len(function.results) != 1 or isinstance(function.results[0], Array):
            raise self._refuse(node)
        return Invoke(function, arguments, function.results[0])

    def _sum(self, array: ast.expr, part: ast.Slice) -> Expression:
        base = self._expression(array)
        if not (isinstance(base, Name) and isinstance(base.type, Array)):
            raise self._refuse(array)
        places = range(self._whole(part.lower, 0), self._whole(part.upper, base.type.size))
        total: Expression = Element(base, (Number(places[0]),))
        for place in places[1:]:
            total = Operation("+", (total, Element(base, (Number(place),))), "real")
        return total

    # extents

    def _shape(self, node: ast.expr) -> tuple[int, ...]:
        found = self._expression(node)
        if not isinstance(found.type, Array):
            raise self._refuse(node)
        return found.type.shape

    def _extents(self, node: ast.expr) -> tuple[int, ...]:
        parts = node.elts if isinstance(node, ast.Tuple) else [node]
        return tuple(self._whole(part, 0) for part in parts)

    def _whole(self, node: ast.expr | None, absent: int) -> int:
        if node is None:
            return absent
        found = self._expression(node)
        if isinstance(found, Number) and isinstance(found.value, int):
            return found.value
        raise self._refuse(node)

    def _refuse(self, node: ast.AST) -> UntranslatableError:
        where = f"{self._python.__module__}.{self._python.__name__}"
        return UntranslatableError(f"{where}: {ast.unparse(node)!r} is beyond what the export translates")


def _as_load(target: ast.expr) -> ast.expr:
    return ast.parse(ast.unparse(target), mode="eval").body


def _wider(left: Expression, right: Expression) -> Type:
    return "int" if left.type == right.type == "int" else "real"


def _plain(value: Any) -> Any:
    """A Python number for a numpy scalar, a float or integer array for an array."""
    if isinstance(value, np.generic) or (isinstance(value, np.ndarray) and value.ndim == 0):
        return value.item()
    return int(value) if isinstance(value, bool) else value
