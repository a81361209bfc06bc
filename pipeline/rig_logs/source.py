"""What every format reader offers to the guarded child: a listing from the headers, and one channel at a time."""

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
        Declared number of samples.
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

    def entries(self) -> list[Entry]:
        """Every numeric channel, from the headers only."""

    def load(self, name: str) -> NDArray[Any]:
        """The samples of one entry, real numbers of any type, shape (count,)."""


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
