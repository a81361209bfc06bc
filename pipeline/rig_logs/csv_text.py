"""A CSV file as the UTF-8 text that Arrow reads, in a file of Arrow's own."""

import codecs
import io
from collections.abc import Iterable
from contextlib import suppress
from itertools import islice
from pathlib import Path
from typing import Any

from pipeline.rig_logs.source import PART, temporary_path


def as_utf8(path: Path, length: int, encoding: str, owner: object) -> Any:
    """The first `length` bytes as UTF-8 in a file of Arrow's own; where that is less than all, in a mapped buffer.

    Arrow's threads read ahead. Were they to hold memory of Python's, as they would of a Python file or of a codec,
    one of them could abort the interpreter while it is taken down. A file is read block by block, whereas pages of
    a mapped one stay in memory.

    Parameters
    ----------
    path : Path
        The log.
    length : int
        Bytes that are whole rows.
    encoding : str
        Its text encoding.
    owner : object
        What reads it; see `written`.
    """
    import pyarrow as pa

    if not _is_ascii_and_more(encoding):
        with text_of(path, length, encoding, newline="") as lines:
            return written(lines, owner)
    if length == path.stat().st_size:  # what is beyond ASCII stands in no number
        return pa.OSFile(str(path))
    with pa.memory_map(str(path)) as mapped:
        return pa.BufferReader(mapped.read_buffer(length))


def written(lines: Iterable[str], owner: object) -> Any:
    """Lines in a file of Arrow's own, which vanishes with it, on Windows with the `owner`."""
    import pyarrow as pa

    path, rest = temporary_path(owner), iter(lines)
    with path.open("wb") as file:
        while some := list(islice(rest, PART)):
            file.write("".join(some).encode())
    opened = pa.OSFile(str(path))
    with suppress(PermissionError):  # as on Windows, where an open file stays
        path.unlink()
    return opened


def text_of(path: Path, length: int, encoding: str, newline: str | None = None) -> io.TextIOWrapper:
    """The first `length` bytes as text, to be read in order."""
    return io.TextIOWrapper(io.BufferedReader(_Head(path, length)), encoding, newline=newline)


class _Head(io.RawIOBase):
    """The first bytes of a file, to be read in order."""

    def __init__(self, path: Path, size: int) -> None:
        self._file = path.open("rb")
        self._left = size

    def readable(self) -> bool:
        """It is."""
        return True

    def readinto(self, buffer: Any, /) -> int:
        """Read what fits."""
        count = self._file.readinto(memoryview(buffer)[: self._left])
        self._left -= count
        return count

    def close(self) -> None:
        """Close the file."""
        self._file.close()
        super().close()


def _is_ascii_and_more(encoding: str) -> bool:
    """Whether every ASCII character is its own single byte, which means nothing else anywhere."""
    name = codecs.lookup(encoding).name
    if name in ("utf-8", "utf-8-sig", "ascii"):
        return True
    every = bytes(range(256))
    decoded = every.decode(encoding, "replace")
    return len(decoded) == len(every) and decoded[:128].encode() == every[:128]
