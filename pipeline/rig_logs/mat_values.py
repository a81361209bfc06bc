"""What a MAT file holds, whichever version it is of: arrays whose samples stay in the file, structs, texts, objects."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Protocol, TypeGuard

from numpy.typing import NDArray

from .source import PART, Entry

Reader = Callable[[int, int], NDArray[Any]]
"""First and end sample → samples."""


@dataclass(frozen=True)
class MatArray:
    """A real numeric array whose samples are still in the file.

    `read(start, stop)` gives a range of them in column-major order; `step` is how many at a time cost least.
    """

    dims: tuple[int, ...]
    dtype: str
    read: Reader
    step: int = PART

    @property
    def size(self) -> int:
        """Number of elements."""
        size = 1
        for dim in self.dims:
            size *= dim
        return size

    @property
    def is_vector(self) -> bool:
        """Whether it is long in one direction only."""
        return self.size == max(self.dims, default=0) and self.size > 1

    def column(self, j: int) -> Reader:
        """Samples of column j (from 0) of a matrix."""
        rows = self.dims[0]
        return lambda first, last: self.read(j * rows + first, j * rows + last)

    def row(self, j: int) -> Reader:
        """Samples of row j (from 0) of a matrix: every part of it is read for each row."""
        rows = self.dims[0]
        return lambda first, last: self.read(first * rows, last * rows)[j::rows]


@dataclass(frozen=True)
class MatObject:
    """An object of a MATLAB class (table, timeseries, iddata, …), or another value that is not read, such as a cell."""

    kind: str


class MatStruct(Protocol):
    """A struct array."""

    @property
    def fields(self) -> tuple[str, ...]:
        """Names of the fields."""

    @property
    def count(self) -> int:
        """Number of elements."""

    def get(self, index: int, name: str) -> "MatValue":
        """Field `name` of element `index`; None where there is no such field."""


MatValue = MatArray | MatStruct | MatObject | str | None
"""None stands for what is empty or damaged."""


@dataclass(frozen=True)
class MatChannel:
    """A channel as a layout finds it, and how its samples are read."""

    entry: Entry
    read: Reader
    step: int = PART


def is_struct(value: MatValue) -> TypeGuard[MatStruct]:
    """Whether a value is a struct array."""
    return value is not None and not isinstance(value, str | MatArray | MatObject)


def text_of(value: MatValue) -> str:
    """A text, or "" for anything else."""
    return value if isinstance(value, str) else ""


def scalar_of(value: MatValue) -> float | None:
    """The one number of a 1×1 array, or None."""
    return float(value.read(0, 1)[0]) if isinstance(value, MatArray) and value.size == 1 else None


def bare(name: str) -> str:
    """A name without the quotes around it or around the parts of a model path."""
    return "/".join(part.strip('"') for part in name.strip().split("/")) if '"' in name else name.strip()
