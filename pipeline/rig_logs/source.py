"""What every format reader offers to the guarded child: a listing from the headers, and samples part by part."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Protocol

from numpy.typing import NDArray


@dataclass(frozen=True)
class CsvOptions:
    """How to read a CSV log, where it is not to be found out from the file; None means: find out."""

    encoding: str | None = None
    delimiter: str | None = None
    decimal: str | None = None
    header_row: int | None = None


@dataclass(frozen=True)
class Entry:
    """One numeric channel as the headers declare it.

    Attributes
    ----------
    name : str
        Unique name in the log.
    unit : str
        Unit as the log writes it, or "".
    dtype : str
        Type of the numbers in the log.
    count : int
        Declared number of samples; an estimate for texts, which declare none.
    time : str or None
        Name of the entry that is its time base; None for time bases themselves and for columns of tables.
    aliases : tuple of str
        Other ways to ask for it, such as a header cell with its unit.
    """

    name: str
    unit: str
    dtype: str
    count: int
    time: str | None = None
    aliases: tuple[str, ...] = field(default=())


class Source(Protocol):
    """An open raw log."""

    format: str
    notes: list[str]
    texts: dict[str, str]
    """Names of columns that are no numbers, with a cell that shows it."""

    def entries(self) -> list[Entry]:
        """Every numeric channel, from the headers only."""

    def parts(self, names: Sequence[str]) -> Iterator[tuple[str, NDArray[Any]]]:
        """The samples of some entries, real numbers of any type, in parts that follow each other in each entry.

        No part is much longer than `PART` rows, as far as the format allows, so that a log of any length can be read.
        """


PART = 1 << 17
"""Rows at a time."""


def ranges(count: int, step: int = PART) -> Iterator[tuple[int, int]]:
    """First and end row of consecutive parts."""
    return ((first, min(first + step, count)) for first in range(0, count, step))


def by_ranges(count: int, read: Callable[[int, int], NDArray[Any]]) -> Iterator[NDArray[Any]]:
    """The parts of a column of which `read` gives any range of rows."""
    return (read(first, last) for first, last in ranges(count))


class UnreadableLogError(Exception):
    """The file is damaged, truncated, or not what it claims to be; the text says in what way."""


def unique_names(names: list[str]) -> list[str]:
    """Names made unique by " (2)", " (3)", … in the order of the log."""
    seen: dict[str, int] = {}
    unique = []
    for name in names:
        seen[name] = seen.get(name, 0) + 1
        unique.append(name if seen[name] == 1 else f"{name} ({seen[name]})")
    return unique


def read_start(path: Path, size: int) -> bytes:
    """The first `size` bytes of a file."""
    with path.open("rb") as file:
        return file.read(size)
