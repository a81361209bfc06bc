"""The expressions of a Python kernel, read with the types of its arguments."""

import ast
import inspect
import textwrap
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from pipeline.export.kernels.program import Array, Element, Expression, Function, Invoke, Name, Number, Operation, Type

if TYPE_CHECKING:
    from pipeline.export.kernels.translate import Translator

_BINARY = {ast.Add: "+", ast.Sub: "-", ast.Mult: "*", ast.Div: "/"}
_COMPARE = {ast.Lt: "<", ast.LtE: "<=", ast.Gt: ">", ast.GtE: ">=", ast.Eq: "==", ast.NotEq: "!="}
_ELEMENTARY = ("sqrt", "exp", "expm1", "tanh", "sin", "cos", "abs", "isfinite")
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


class Reader:
    """One kernel: what its names mean, and its expressions.

    Parameters
    ----------
    translator : Translator
        Knows the other kernels and the constants.
    python : callable
        The kernel.
    """

    def __init__(self, translator: "Translator", python: Any) -> None:
        self.translator = translator
        self.python = python
        node = ast.parse(textwrap.dedent(inspect.getsource(python))).body[0]
        if not isinstance(node, ast.FunctionDef):
            raise UntranslatableError(f"{python} is no function")
        self.node = node
        self.known: dict[str, Expression | Record] = {}

    def expression(self, node: ast.expr) -> Expression:
        """Translate an expression."""
        match node:
            case ast.Constant(bool(value)):
                return Number(int(value))
            case ast.Constant(int(value) | float(value)):
                return Number(value)
            case ast.Name(name):
                return self._name(name, node)
            case ast.Attribute(owner, field) if (record := self.record(owner)) is not None:
                return self.translator.constant(field, _plain(getattr(record.value, field)))
            case ast.Subscript(ast.Attribute(owner, "shape"), ast.Constant(int(axis))):
                return Number(self._shape(owner)[axis])
            case ast.Subscript(array, index):
                return self._element(array, index)
            case ast.BinOp(left, operator, right):
                return self.binary(operator, self.expression(left), self.expression(right), right)
            case ast.UnaryOp(ast.USub(), operand):
                negated = self.expression(operand)
                if isinstance(negated, Number):
                    return Number(-negated.value)
                return Operation("neg", (negated,), negated.type)
            case ast.UnaryOp(ast.Not(), operand):
                return Operation("not", (self.expression(operand),), "bool")
            case ast.Compare():
                return self._comparison(node)
            case ast.BoolOp(operator, values):
                word = "and" if isinstance(operator, ast.And) else "or"
                return Operation(word, tuple(self.expression(each) for each in values), "bool")
            case ast.IfExp(test, then, otherwise):
                condition, one, other = (self.expression(each) for each in (test, then, otherwise))
                if isinstance(condition, Number):
                    return one if condition.value else other
                return Operation("choose", (condition, one, other), _wider(one, other))
            case ast.Call():
                return self._call(node)
        raise self.refuse(node)

    def record(self, node: ast.expr) -> Record | None:
        """A named tuple of constants, or one inside another."""
        if isinstance(node, ast.Name):
            known = self.known.get(node.id)
            return known if isinstance(known, Record) else None
        if isinstance(node, ast.Attribute) and (owner := self.record(node.value)) is not None:
            value = getattr(owner.value, node.attr)
            return Record(value) if isinstance(value, tuple) else None
        return None

    def _name(self, name: str, node: ast.expr) -> Expression:
        if name in self.known:
            known = self.known[name]
            if isinstance(known, Record):
                raise self.refuse(node)
            return known
        value = self.python.__globals__.get(name)
        if value is None or callable(value):
            raise self.refuse(node)
        return self.translator.constant(name, _plain(value))

    def _element(self, array: ast.expr, index: ast.expr) -> Expression:
        base = self.expression(array)
        parts = index.elts if isinstance(index, ast.Tuple) else [index]
        if not (isinstance(base, Name) and isinstance(base.type, Array) and len(parts) == len(base.type.shape)):
            raise self.refuse(array)
        return Element(base, tuple(self.expression(part) for part in parts))

    def binary(
        self, operator: ast.operator, left: Expression, right: Expression, power: ast.expr | None = None
    ) -> Expression:
        """Two numbers joined; integers that are known now are added up at once."""
        if isinstance(operator, ast.Pow) and isinstance(right, Number) and right.value == 2:
            return Operation("square", (left,), left.type)
        symbol = _BINARY.get(type(operator))
        if symbol is None:
            raise self.refuse(power or self.node)
        whole = all(each.type == "int" for each in (left, right))
        if whole and isinstance(left, Number) and isinstance(right, Number) and symbol in _FOLD:
            return Number(_FOLD[symbol](left.value, right.value))
        return Operation(symbol, (left, right), "int" if whole and symbol != "/" else "real")

    def _comparison(self, node: ast.Compare) -> Expression:
        values = [self.expression(each) for each in (node.left, *node.comparators)]
        parts: list[Expression] = []
        for operator, left, right in zip(node.ops, values, values[1:], strict=False):
            symbol = _COMPARE.get(type(operator))
            if symbol is None:
                raise self.refuse(node)
            if isinstance(left, Number) and isinstance(right, Number):
                parts.append(Number(int(_FOLD[symbol](left.value, right.value))))
            else:
                parts.append(Operation(symbol, (left, right), "bool"))
        return parts[0] if len(parts) == 1 else Operation("and", tuple(parts), "bool")

    def _call(self, node: ast.Call) -> Expression:
        match node:
            case ast.Call(ast.Name("bool" | "float"), [value]):
                return self.expression(value)
            case ast.Call(ast.Name("len"), [array]):
                return Number(self._shape(array)[0])
            case ast.Call(ast.Name("min" | "max" as which), values):
                found = [self.expression(each) for each in values]
                folded = found[0]
                for each in found[1:]:
                    folded = Operation(which, (folded, each), _wider(folded, each))
                return folded
            case ast.Call(ast.Attribute(ast.Name("np"), "sum"), [ast.Subscript(array, ast.Slice() as part)]):
                return self._sum(array, part)
            case ast.Call(ast.Attribute(ast.Name("np" | "math"), name), [value]) | ast.Call(
                ast.Name("abs" as name), [value]
            ) if name in _ELEMENTARY:
                return Operation(name, (self.expression(value),), "bool" if name == "isfinite" else "real")
        function, arguments = self.callee(node)
        if function.changed or len(function.results) != 1 or isinstance(function.results[0], Array):
            raise self.refuse(node)
        return Invoke(function, arguments, function.results[0])

    def _sum(self, array: ast.expr, part: ast.Slice) -> Expression:
        base = self.expression(array)
        if not (isinstance(base, Name) and isinstance(base.type, Array)):
            raise self.refuse(array)
        places = range(self.whole(part.lower, 0), self.whole(part.upper, base.type.size))
        total: Expression = Element(base, (Number(places[0]),))
        for place in places[1:]:
            total = Operation("+", (total, Element(base, (Number(place),))), "real")
        return total

    # extents

    def _shape(self, node: ast.expr) -> tuple[int, ...]:
        found = self.expression(node)
        if not isinstance(found.type, Array):
            raise self.refuse(node)
        return found.type.shape

    def extents(self, node: ast.expr) -> tuple[int, ...]:
        """Extents of a new array."""
        parts = node.elts if isinstance(node, ast.Tuple) else [node]
        return tuple(self.whole(part, 0) for part in parts)

    def whole(self, node: ast.expr | None, absent: int) -> int:
        """An integer that is known now, such as the end of a slice."""
        if node is None:
            return absent
        found = self.expression(node)
        if isinstance(found, Number) and isinstance(found.value, int):
            return found.value
        raise self.refuse(node)

    def refuse(self, node: ast.AST) -> UntranslatableError:
        """The error for what lies beyond the subset."""
        where = f"{self.python.__module__}.{self.python.__name__}"
        return UntranslatableError(f"{where}: {ast.unparse(node)!r} is beyond what the export translates")

    def callee(self, call: ast.Call) -> tuple[Function, tuple[Expression, ...]]:
        """The kernel of a call, translated for its arguments, and those that are no constants."""
        kernel = self.python.__globals__.get(call.func.id) if isinstance(call.func, ast.Name) else None
        if kernel is None:
            raise self.refuse(call)
        types: list[Argument] = []
        passed: list[Expression] = []
        for argument in call.args:
            record = self.record(argument)
            if record is not None:
                types.append(record)
                continue
            found = self._zeros(argument) or self.expression(argument)
            types.append(found.type)
            passed.append(found)
        return self.translator.function(kernel, tuple(types)), tuple(passed)

    def _zeros(self, argument: ast.expr) -> Name | None:
        """`np.zeros(…)` as an argument: a constant."""
        match argument:
            case ast.Call(ast.Attribute(ast.Name("np"), "zeros"), [extent]):
                shape = self.extents(extent)
                name = "NONE" if 0 in shape else f"ZEROS_{'_'.join(map(str, shape))}"
                constant = self.translator.constant(name, np.zeros(shape))
                return constant if isinstance(constant, Name) else None
        return None


def _wider(left: Expression, right: Expression) -> Type:
    return "int" if left.type == right.type == "int" else "real"


def _plain(value: Any) -> Any:
    """A Python number for a numpy scalar, a float or integer array for an array."""
    if isinstance(value, np.generic) or (isinstance(value, np.ndarray) and value.ndim == 0):
        return value.item()
    if isinstance(value, tuple):
        return np.array(value, dtype=np.float64)
    return int(value) if isinstance(value, bool) else value
