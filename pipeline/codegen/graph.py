"""An expression graph as a list of operations: the input of every writer, without CasADi.

The text of a graph has its operations in order, apart by semicolons: ``mul 3 17`` is the product of the values of
operations 3 and 17, counted from 0; ``input x 2`` an entry of an input, ``constant 0.5`` a number, ``store f 0 41``
writes the value of operation 41 to an entry of an output; ``fetch t 2 41`` is the entry of the input t that lies
behind its entry 2 by the value of operation 41, a whole number of places.

`trace` makes a graph from a plain Python function of numbers, for what is known only when a model is exported: its
structure.
"""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from typing import Any, NamedTuple, Union

import numpy as np

from ..numerics.arrays import FloatArray

_COMMUTE = {"add", "mul", "and", "or"}
_OF_NUMBERS = {"add", "sub", "mul", "neg", "le", "lt"}
"""Operations that are computed here if all operands are numbers; every language gives the same value."""


class Operation(NamedTuple):
    """One operation: `name`, and operands that are numbers of earlier operations.

    `input` and `fetch` have as `place` (array, entry), `constant` its value in `value`, `store` its output's.
    """

    name: str
    operands: tuple[int, ...]
    place: tuple[str, int] = ("", 0)
    value: float = 0.0


@dataclass(frozen=True)
class Graph:
    """Operations in order, and the lengths of inputs and outputs by name."""

    inputs: dict[str, int]
    outputs: dict[str, int]
    text: str

    @property
    def arguments(self) -> list[str]:
        """Names of the inputs, then of the outputs that are not inputs."""
        return list(dict.fromkeys([*self.inputs, *self.outputs]))

    @cached_property
    def operations(self) -> list[Operation]:
        """The parsed text."""
        return [_parsed(line) for line in self.text.strip().replace("\n", " ").split("; ")]

    def inline(
        self, functions: Callable[[str, list[Any]], Any], number: Callable[[float], Any], **arrays: Any
    ) -> dict[str, list[Any]]:
        """The outputs as lists, with inputs of any kind: `functions` does an operation, `number` makes a constant."""
        values: list[Any] = []
        outputs: dict[str, list[Any]] = {name: [number(0.0)] * size for name, size in self.outputs.items()}
        for operation in self.operations:
            array, entry = operation.place
            match operation.name:
                case "input":
                    values.append(arrays[array][entry])
                case "constant":
                    values.append(number(operation.value))
                case "fetch":
                    values.append(functions("fetch", [arrays[array], entry, values[operation.operands[0]]]))
                case "store":
                    outputs[array][entry] = values[operation.operands[0]]
                case name:
                    values.append(functions(name, [values[i] for i in operation.operands]))
        return outputs

    def evaluate(self, **arrays: FloatArray) -> dict[str, FloatArray]:
        """The outputs, shape (…, n), for inputs of shape (…, n) by numpy: a few microseconds an operation."""
        shape = np.broadcast_shapes(*(np.shape(a)[:-1] for a in arrays.values()))
        columns = {name: np.moveaxis(np.asarray(a), -1, 0) for name, a in arrays.items()}
        outputs = self.inline(lambda name, operands: NUMPY[name](*operands), float, **columns)
        return {
            name: np.stack([np.broadcast_to(value, shape) for value in values], axis=-1)
            for name, values in outputs.items()
        }


def _parsed(line: str) -> Operation:
    name, *rest = line.split()
    match name:
        case "constant":
            return Operation(name, (), value=float(rest[0]))
        case "input" | "store" | "fetch":
            return Operation(name, tuple(map(int, rest[2:])), (rest[0], int(rest[1])))
    return Operation(name, tuple(map(int, rest)))


def text_of(operations: list[Operation]) -> str:
    """The text that `Graph` parses."""
    return "; ".join(_line(operation) for operation in operations)


def _line(operation: Operation) -> str:
    place = operation.place if operation.place[0] else ()
    value = [operation.value] if operation.name == "constant" else []
    return " ".join([operation.name, *map(str, place), *map(repr, value), *map(str, operation.operands)])


class Builder:
    """Operations without repetition; an operation on numbers alone is computed here."""

    def __init__(self) -> None:
        self.operations: list[Operation] = []
        self._known: dict[Operation, int] = {}

    def add(self, name: str, *operands: int, place: tuple[str, int] = ("", 0), value: float = 0.0) -> int:
        """The number of an operation."""
        if name in _COMMUTE:
            operands = tuple(sorted(operands))
        operation = Operation(name, operands, place, value)
        if operation not in self._known:
            self._known[operation] = len(self.operations)
            self.operations.append(operation)
        return self._known[operation]

    def input(self, name: str, entry: int) -> int:
        """An entry of an input."""
        return self.add("input", place=(name, entry))

    def constant(self, value: float) -> int:
        """A number."""
        return self.add("constant", value=value)


def reachable(operations: list[Operation], stores: list[Operation]) -> list[Operation]:
    """Operations that the stores need, in order, renumbered; the stores at the end."""
    needed = {store.operands[0] for store in stores}
    for i in range(len(operations) - 1, -1, -1):
        if i in needed:
            needed.update(operations[i].operands)
    order = sorted(needed)
    place = {old: new for new, old in enumerate(order)}
    renumbered = [operations[i]._replace(operands=tuple(place[j] for j in operations[i].operands)) for i in order]
    return renumbered + [store._replace(operands=(place[store.operands[0]],)) for store in stores]


NUMPY: dict[str, Callable[..., Any]] = {
    "add": np.add, "sub": np.subtract, "mul": np.multiply, "div": np.divide, "neg": np.negative, "sqrt": np.sqrt,
    "abs": np.abs, "sign": np.sign, "min": np.minimum, "max": np.maximum, "exp": np.exp, "atan": np.arctan,
    "sin": np.sin, "cos": np.cos, "tanh": np.tanh,
    "lt": lambda a, b: np.where(a < b, 1.0, 0.0),
    "le": lambda a, b: np.where(a <= b, 1.0, 0.0),
    "and": lambda a, b: a * b,
    "or": np.maximum,
    "not": lambda a: 1.0 - a,
    "where": lambda condition, value: np.where(condition != 0.0, value, 0.0),
    "choose": lambda condition, chosen, other: np.where(np.asarray(condition) != 0.0, chosen, other),
    "finite": lambda a: np.where(np.isfinite(a), 1.0, 0.0),
    "expm1": np.expm1, "floor": np.floor,
    "fetch": lambda array, entry, index: array[entry + np.asarray(index, dtype=np.int64)],
}  # fmt: skip
"""Every operation by numpy."""


Number = Union["Value", float]


@dataclass(eq=False)
class Value:
    """A number in a graph that is being traced."""

    __array_ufunc__ = None  # so that a number of numpy leaves the operation to this class
    builder: Builder
    place: int

    def __add__(self, other: Number) -> "Value":
        return function("add", self, other)

    def __sub__(self, other: Number) -> "Value":
        return function("sub", self, other)

    def __rsub__(self, other: Number) -> "Value":
        return function("sub", other, self)

    def __mul__(self, other: Number) -> "Value":
        return function("mul", self, other)

    def __truediv__(self, other: Number) -> "Value":
        return function("div", self, other)

    def __rtruediv__(self, other: Number) -> "Value":
        return function("div", other, self)

    def __neg__(self) -> "Value":
        return function("neg", self)

    __radd__ = __add__
    __rmul__ = __mul__


def choose(condition: Number, first: Number, other: Number) -> "Value":
    """`first` where the condition holds."""
    return function("choose", condition, first, other)


def fetch(table: str, entry: int, index: Value) -> Value:
    """The entry of an input `index` places, a whole number, behind `entry`."""
    return Value(index.builder, index.builder.add("fetch", index.place, place=(table, entry)))


def clip(x: Number, low: Number, high: Number) -> "Value":
    """The value x within [low, high]."""
    return function("min", high, function("max", low, x))


def function(name: str, *operands: Number) -> "Value":
    """An operation by name: exp, expm1, tanh, sin, cos, sqrt, abs, floor, min, max, lt, le, and, or, not, finite."""
    builder = next(operand.builder for operand in operands if isinstance(operand, Value))
    places = [x.place if isinstance(x, Value) else builder.constant(float(x)) for x in operands]
    constants = [builder.operations[i].value if builder.operations[i].name == "constant" else None for i in places]
    if name in _OF_NUMBERS and None not in constants:
        return Value(builder, builder.constant(float(NUMPY[name](*constants))))
    if name == "mul" and 0.0 in constants:
        return Value(builder, builder.constant(0.0))
    for i, neutral in enumerate((0.0, 0.0) if name == "add" else (None, 0.0) if name == "sub" else (1.0, 1.0)):
        if name in ("add", "sub", "mul") and neutral is not None and constants[i] == neutral:
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
    inputs = {name: [Value(builder, builder.input(name, i)) for i in range(size)] for name, size in sizes.items()}
    outputs = traced(**inputs)
    stores = [
        Operation("store", (x.place if isinstance(x, Value) else builder.constant(float(x)),), (name, i))
        for name, values in outputs.items()
        for i, x in enumerate(values)
    ]
    text = text_of(reachable(builder.operations, stores))
    return Graph(sizes, {name: len(values) for name, values in outputs.items()}, text)


def inline(graph: Graph, **arrays: list[Any]) -> dict[str, list[Any]]:
    """The outputs of a generated graph for traced values or numbers."""
    builder = next((x.builder for array in arrays.values() for x in array if isinstance(x, Value)), None)
    if builder is None:
        return graph.inline(lambda name, operands: NUMPY[name](*operands), float, **arrays)
    given = {
        name: [x if isinstance(x, Value) else Value(builder, builder.constant(float(x))) for x in array]
        for name, array in arrays.items()
    }
    return graph.inline(
        lambda name, operands: function(name, *operands), lambda x: Value(builder, builder.constant(x)), **given
    )


def apply(graph: Graph, *numbers: Any) -> list[Any]:
    """The outputs' entries of a generated graph for the entries of its inputs, in order: traced values, or numbers."""
    given = iter(numbers)
    outputs = inline(graph, **{name: [next(given) for _ in range(size)] for name, size in graph.inputs.items()})
    return [value for values in outputs.values() for value in values]


Call = tuple[str, dict[str, str]]
"""Name of a graph, and the arrays used for some of its inputs and outputs; the others have their own names."""


@dataclass(frozen=True)
class GraphSequence:
    """Graphs that are called one after another on named arrays, as for a method with stages.

    A Runge-Kutta step calls the same rates four times: each graph is written once, and the calls say in which arrays it
    finds its inputs and leaves its outputs.

    Attributes
    ----------
    graphs : dict of Graph
        By name.
    calls : tuple of Call
        In order.
    given : tuple of str
        Arrays that come from outside; all others live during a run only.
    """

    graphs: dict[str, Graph]
    calls: tuple[Call, ...]
    given: tuple[str, ...]

    def places(self, call: Call) -> list[str]:
        """The arrays of a call, in the order of the graph's inputs and outputs."""
        name, other = call
        return [other.get(array, array) for array in self.graphs[name].arguments]

    @cached_property
    def local(self) -> dict[str, int]:
        """Length of every array that is not given."""
        return {
            place: size
            for name, other in self.calls
            for array, size in self.graphs[name].outputs.items()
            if (place := other.get(array, array)) not in self.given
        }

    def changed(self) -> list[str]:
        """Given arrays that are written."""
        outputs = {other.get(array, array) for name, other in self.calls for array in self.graphs[name].outputs}
        return [array for array in self.given if array in outputs]
