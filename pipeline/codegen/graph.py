"""An expression graph as a list of operations: what every writer reads, without CasADi.

The text of a graph has its operations in order, apart by semicolons: ``mul 3 17`` is the product of the values of
operations 3 and 17, counted from 0; ``input x 2`` an entry of an input, ``constant 0.5`` a number, ``store f 0 41``
writes the value of operation 41 to an entry of an output.
"""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np

from pipeline.numerics.arrays import FloatArray


class Operation(NamedTuple):
    """One operation: `name`, and operands that are numbers of earlier operations.

    `input` has as `place` (array, entry), `constant` its value in `value`, `store` its output's (array, entry).
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

    @cached_property
    def operations(self) -> list[Operation]:
        """The parsed text."""
        return [_parsed(line) for line in self.text.strip().replace("\n", " ").split("; ")]

    def evaluate(self, **arrays: FloatArray) -> dict[str, FloatArray]:
        """The outputs, shape (…, n), for inputs of shape (…, n) by numpy: a few microseconds an operation."""
        values: list[FloatArray | float] = []
        shape = np.broadcast_shapes(*(np.shape(a)[:-1] for a in arrays.values()))
        found = {name: np.zeros((*shape, size)) for name, size in self.outputs.items()}
        for operation in self.operations:
            if operation.name == "input":
                array, entry = operation.place
                values.append(arrays[array][..., entry])
            elif operation.name == "constant":
                values.append(operation.value)
            elif operation.name == "store":
                array, entry = operation.place
                found[array][..., entry] = values[operation.operands[0]]
                values.append(0.0)
            else:
                values.append(_NUMPY[operation.name](*(values[i] for i in operation.operands)))
        return found


def _parsed(line: str) -> Operation:
    name, *rest = line.split()
    if name == "input":
        return Operation(name, (), (rest[0], int(rest[1])))
    if name == "constant":
        return Operation(name, (), value=float(rest[0]))
    if name == "store":
        return Operation(name, (int(rest[2]),), (rest[0], int(rest[1])))
    return Operation(name, tuple(int(operand) for operand in rest))


def text_of(operations: list[Operation]) -> str:
    """The text that `Graph` parses."""
    return "; ".join(_line(operation) for operation in operations)


def _line(operation: Operation) -> str:
    operands = " ".join(str(i) for i in operation.operands)
    match operation.name:
        case "input":
            return f"input {operation.place[0]} {operation.place[1]}"
        case "constant":
            return f"constant {operation.value!r}"
        case "store":
            return f"store {operation.place[0]} {operation.place[1]} {operands}"
    return f"{operation.name} {operands}"


_NUMPY: dict[str, Callable[..., FloatArray]] = {
    "add": np.add, "sub": np.subtract, "mul": np.multiply, "div": np.divide, "neg": np.negative, "sqrt": np.sqrt,
    "abs": np.abs, "sign": np.sign, "min": np.minimum, "max": np.maximum, "exp": np.exp, "atan": np.arctan,
    "sin": np.sin, "cos": np.cos, "tanh": np.tanh,
    "lt": lambda a, b: np.where(a < b, 1.0, 0.0),
    "le": lambda a, b: np.where(a <= b, 1.0, 0.0),
    "and": lambda a, b: a * b,
    "or": np.maximum,
    "not": lambda a: 1.0 - a,
    "where": lambda condition, value: np.where(condition != 0.0, value, 0.0),
}  # fmt: skip
