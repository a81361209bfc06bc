"""Graphs from plain Python functions of numbers, for what is known only when a model is exported: its structure."""

from collections.abc import Callable
from typing import Any, Union

from pipeline.codegen.graph import NUMPY, Builder, Graph, Operation, reachable, text_of

Number = Union["Value", float]
_OF_NUMBERS = {"add", "sub", "mul", "neg", "le", "lt"}
"""Operations that are done at once where all operands are known, alike in every language."""


class Value:
    """A number in a graph that is being traced."""

    def __init__(self, builder: Builder, place: int) -> None:
        self.builder, self.place = builder, place

    def __add__(self, other: Number) -> "Value":
        return _done("add", self, other)

    def __sub__(self, other: Number) -> "Value":
        return _done("sub", self, other)

    def __rsub__(self, other: Number) -> "Value":
        return _done("sub", other, self)

    def __mul__(self, other: Number) -> "Value":
        return _done("mul", self, other)

    def __truediv__(self, other: Number) -> "Value":
        return _done("div", self, other)

    def __rtruediv__(self, other: Number) -> "Value":
        return _done("div", other, self)

    def __neg__(self) -> "Value":
        return _done("neg", self)

    __radd__, __rmul__ = __add__, __mul__


def function(name: str, *operands: Number) -> "Value":
    """An operation by name: exp, expm1, tanh, sin, cos, sqrt, abs, floor, min, max, lt, le, and, or, not, finite."""
    return _done(name, *operands)


def choose(condition: Number, one: Number, other: Number) -> "Value":
    """`one` where the condition holds."""
    return _done("choose", condition, one, other)


def fetch(table: str, entry: int, index: Value) -> Value:
    """The entry of an input `index` places, a whole number, behind `entry`."""
    return Value(index.builder, index.builder.add("fetch", index.place, place=(table, entry)))


def clip(x: Number, low: Number, high: Number) -> "Value":
    """X within [low, high]."""
    return _done("min", high, _done("max", low, x))


def square(x: "Value") -> "Value":
    """X²."""
    return x * x


def _done(name: str, *operands: Number) -> "Value":
    builder = next(operand.builder for operand in operands if isinstance(operand, Value))
    places = [x.place if isinstance(x, Value) else builder.constant(float(x)) for x in operands]
    known = [builder.operations[i].value if builder.operations[i].name == "constant" else None for i in places]
    if name in _OF_NUMBERS and None not in known:
        return Value(builder, builder.constant(float(NUMPY[name](*known))))
    if name == "mul" and 0.0 in known:
        return Value(builder, builder.constant(0.0))
    for i, neutral in enumerate((0.0, 0.0) if name == "add" else (None, 0.0) if name == "sub" else (1.0, 1.0)):
        if name in ("add", "sub", "mul") and neutral is not None and known[i] == neutral:
            return Value(builder, places[1 - i])
    return Value(builder, builder.add(name, *places))


def trace(traced: Callable[..., dict[str, list[Any]]], **sizes: int) -> Graph:
    """The graph of a function.

    Parameters
    ----------
    traced : callable
        Takes a list of values under the name of each input, and gives those of each output.
    sizes : int
        Length of each input.
    """
    builder = Builder()
    inputs = {
        name: [Value(builder, builder.add("input", place=(name, i))) for i in range(size)]
        for name, size in sizes.items()
    }
    outputs = traced(**inputs)
    stores = [
        Operation("store", (x.place if isinstance(x, Value) else builder.constant(float(x)),), (name, i))
        for name, values in outputs.items()
        for i, x in enumerate(values)
    ]
    lengths = {name: len(values) for name, values in outputs.items()}
    return Graph(dict(sizes), lengths, text_of(reachable(builder.operations, stores)))


def inline(graph: Graph, **arrays: list[Any]) -> dict[str, list[Any]]:
    """The outputs of a generated graph for traced values or numbers."""
    values = [x for array in arrays.values() for x in array if isinstance(x, Value)]
    builder = values[0].builder
    given = {
        name: [x if isinstance(x, Value) else Value(builder, builder.constant(float(x))) for x in array]
        for name, array in arrays.items()
    }
    found: dict[str, list[Any]] = graph.inline(
        lambda name, operands: _done(name, *operands), lambda x: Value(builder, builder.constant(x)), **given
    )
    return found


def apply(graph: Graph, *numbers: Any) -> list[Any]:
    """The outputs' entries of a generated graph for the entries of its inputs, in order."""
    given = iter(numbers)
    arrays = {name: [next(given) for _ in range(size)] for name, size in graph.inputs.items()}
    return [value for values in inline(graph, **arrays).values() for value in values]
