"""A kernel as typed statements: what lies between the Python that debist runs and the text of another language.

Indices count from zero and every extent is a number that is known when the text is written.
"""

from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Literal

import numpy as np
import numpy.typing as npt

from pipeline.codegen.graph import Graph

Scalar = Literal["int", "real", "bool"]


@dataclass(frozen=True)
class Array:
    """Type of an array: its extents, and whether it holds integers."""

    shape: tuple[int, ...]
    integer: bool = False

    @property
    def size(self) -> int:
        """Number of entries."""
        return int(np.prod(self.shape))


Type = Scalar | Array


@dataclass(frozen=True)
class Number:
    """A number; `name` is that of the constant it came from, if it has one."""

    value: float | int
    name: str = ""

    @property
    def type(self) -> Type:
        """Integer or real."""
        return "int" if isinstance(self.value, int) else "real"


@dataclass(frozen=True)
class Name:
    """A variable, parameter or constant array."""

    name: str
    type: Type


@dataclass(frozen=True)
class Element:
    """An entry of an array."""

    array: Name
    index: tuple["Expression", ...]

    @property
    def type(self) -> Type:
        """Integer or real."""
        assert isinstance(self.array.type, Array)  # noqa: S101 - made only of arrays
        return "int" if self.array.type.integer else "real"


@dataclass(frozen=True)
class Operation:
    """An operator or function of the language's own library."""

    operator: str
    arguments: tuple["Expression", ...]
    type: Type


@dataclass(frozen=True)
class Invoke:
    """The value of a kernel that changes none of its arguments."""

    function: "Function"
    arguments: tuple["Expression", ...]
    type: Type = "real"


Expression = Number | Name | Element | Operation | Invoke


@dataclass(frozen=True)
class Assign:
    """A value for a variable or an entry; the variable is new where `declares`."""

    target: Name | Element
    value: Expression
    declares: bool = False


@dataclass(frozen=True)
class Declare:
    """A new variable; an array is filled with zeros."""

    name: Name


@dataclass(frozen=True)
class Fill:
    """One value for the entries from `start` to before `stop`."""

    array: Name
    start: int
    stop: int
    value: Expression


@dataclass(frozen=True)
class Copy:
    """All entries of one array from another."""

    target: Name
    source: Name


@dataclass(frozen=True)
class Invocation:
    """A kernel that changes arrays among its arguments or has several results."""

    function: "Function"
    arguments: tuple[Expression, ...]
    targets: tuple[Name | Element, ...]


@dataclass(frozen=True)
class Loop:
    """`variable` from `start` to before `stop`."""

    variable: Name
    start: Expression
    stop: Expression
    body: tuple["Statement", ...]


@dataclass(frozen=True)
class Branch:
    """If, else."""

    condition: Expression
    then: tuple["Statement", ...]
    otherwise: tuple["Statement", ...]


@dataclass(frozen=True)
class Leave:
    """Out of the innermost loop."""


@dataclass(frozen=True)
class Skip:
    """To the next turn of the innermost loop."""


@dataclass(frozen=True)
class Return:
    """Back to the caller with these results."""

    values: tuple[Expression, ...]


Statement = Assign | Declare | Fill | Copy | Invocation | Loop | Branch | Leave | Skip | Return


@dataclass
class Function:
    """One kernel for arguments of given types.

    Attributes
    ----------
    name, summary : str
        Its name, and the first line of its docstring.
    parameters : list of Name
        Without those that were bound to constants.
    results : list of Type
        None, one or several.
    changed : list of Name
        Array parameters that it writes to.
    body : list of Statement
    """

    name: str
    summary: str
    parameters: list[Name] = field(default_factory=list)
    results: list[Type] = field(default_factory=list)
    changed: list[Name] = field(default_factory=list)
    body: list[Statement] = field(default_factory=list)


@dataclass
class Program:
    """Functions in the order in which they need each other, and the constants that they share."""

    functions: list[Function] = field(default_factory=list)
    arrays: dict[str, npt.NDArray[np.generic]] = field(default_factory=dict)
    numbers: dict[str, float | int] = field(default_factory=dict)
    graphs: dict[str, Graph] = field(default_factory=dict)

    def called(self, name: str) -> Function:
        """The function of that name."""
        return next(function for function in self.functions if function.name == name)


def expressions(statements: "tuple[Statement, ...] | list[Statement]") -> Iterator[Expression]:
    """Every expression of the statements, parts after wholes."""
    for statement in statements:
        match statement:
            case Assign(target, value):
                yield from _walk(target)
                yield from _walk(value)
            case Fill(array, _, _, value):
                yield from _walk(array)
                yield from _walk(value)
            case Copy(target, source):
                yield from (target, source)
            case Invocation(_, arguments, targets):
                for each in (*arguments, *targets):
                    yield from _walk(each)
            case Loop(_, start, stop, body):
                yield from _walk(start)
                yield from _walk(stop)
                yield from expressions(body)
            case Branch(condition, then, otherwise):
                yield from _walk(condition)
                yield from expressions(then)
                yield from expressions(otherwise)
            case Return(values):
                for each in values:
                    yield from _walk(each)


def _walk(expression: Expression) -> Iterator[Expression]:
    yield expression
    match expression:
        case Element(array, index):
            yield array
            for each in index:
                yield from _walk(each)
        case Operation(_, arguments) | Invoke(_, arguments):
            for each in arguments:
                yield from _walk(each)
