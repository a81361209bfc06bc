"""MATLAB values as both MAT formats give them: lazily, so that nothing is read that nobody asked for."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Protocol

from numpy.typing import NDArray

from pipeline.rig_logs.source import PART


@dataclass(frozen=True)
class MatArray:
    """A real numeric array whose samples are still in the file.

    `read(start, stop)` gives a range of them in column-major order; `step` says how many at a time cost least.
    """

    dims: tuple[int, ...]
    dtype: str
    read: Callable[[int, int], NDArray[Any]]
    step: int = PART

    @property
    def size(self) -> int:
        """Number of elements."""
        size = 1
        for dim in self.dims:
            size *= dim
        return size


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


MatValue = MatArray | MatStruct | str | None
"""None stands for what is no data here: cells, objects, function handles, complex or sparse arrays."""


def text_of(value: MatValue) -> str:
    """A text, or "" for anything else."""
    return value if isinstance(value, str) else ""


def scalar_of(value: MatValue) -> float | None:
    """The one number of a 1×1 array, or None."""
    return float(value.read(0, 1)[0]) if isinstance(value, MatArray) and value.size == 1 else None
