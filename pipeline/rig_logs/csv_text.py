"""The bytes of a CSV file: their encoding, and those that are whole rows, as the UTF-8 text that Arrow reads."""

import codecs
import io
import mmap
import re
from collections.abc import Iterable
from contextlib import suppress
from itertools import islice
from pathlib import Path
from typing import Any

import pyarrow as pa

from .csv_cells import rows_of
from .source import PART, UnreadableLogError, temporary_path

_TAIL_BYTES = 1 << 16
_BOMS = (
    (codecs.BOM_UTF8, "utf-8-sig"),
    (codecs.BOM_UTF16_LE, "utf-16"),
    (codecs.BOM_UTF16_BE, "utf-16"),
)
_NO_TEXT = "this is no text and no format that is known here; export the log as CSV, MAT, MDF4, HDF5 or Parquet"


def text_encoding(start: bytes) -> str:
    """The encoding by the first bytes of a file: UTF-8 or UTF-16, else a Western one, in which numbers are the same.

    Raises
    ------
    UnreadableLogError
        They are no text.
    """
    for bom, encoding in _BOMS:
        if start.startswith(bom):
            return encoding
    for parity, encoding in ((1, "utf-16-le"), (0, "utf-16-be")):  # of numbers, every other byte is zero
        if b"\0" not in start[1 - parity :: 2] and 2 * start[parity::2].count(0) > len(start[parity::2]):
            return encoding
    start = start.strip(b"\0")
    control = sum(byte < 32 and byte not in b"\t\n\r\f" for byte in start)
    before, zero, _ = start.partition(b"\0")
    if zero:
        line = len(rows_of(before.decode("latin-1") + "."))
        damaged = f"a zero byte in line {line}, which is no text: repair or delete that line"
        raise UnreadableLogError(_NO_TEXT if control > len(start) // 1000 else damaged)
    try:
        codecs.getincrementaldecoder("utf-8")().decode(start)
        return "utf-8"
    except UnicodeDecodeError:
        if control > len(start) // 1000:
            raise UnreadableLogError(_NO_TEXT) from None
        return "cp1252" if re.search(rb"[\x80-\x9f]", start) else "latin-1"


def as_utf8(path: Path, length: int, encoding: str, owner: object) -> Any:
    """The first `length` bytes as UTF-8.

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
        Reader of it; see `written`.
    """
    if not _is_ascii_and_more(encoding):
        with text_of(path, length, encoding, newline="") as lines:
            return written(lines, owner)
    return _whole_rows_of(path, length)  # what is beyond ASCII stands in no number


def written(lines: Iterable[str], owner: object) -> Any:
    """Lines in a file of Arrow's own, which vanishes with it, on Windows with the `owner`."""
    path = temporary_path(owner)
    rest = iter(lines)
    with path.open("wb") as file:
        while some := list(islice(rest, PART)):
            file.write("".join(some).encode())
    opened = pa.OSFile(str(path))
    with suppress(PermissionError):  # as on Windows, where an open file stays
        path.unlink()
    return opened


def text_of(path: Path, length: int, encoding: str, newline: str | None = None) -> io.TextIOWrapper:
    """The first `length` bytes as text, to be read in order.

    Parameters
    ----------
    path : Path
        The file.
    length : int
        Bytes that are read.
    encoding : str
        Encoding of the text.
    newline : str, optional
        As of `io.TextIOWrapper`.
    """
    return io.TextIOWrapper(_whole_rows_of(path, length), encoding, newline=newline)


def _whole_rows_of(path: Path, length: int) -> Any:
    """The first `length` bytes in a file of Arrow's own; where that is less than all, in a mapped buffer."""
    if length == path.stat().st_size:
        return pa.OSFile(str(path))
    with pa.memory_map(str(path)) as mapped:
        return pa.BufferReader(mapped.read_buffer(length))


def _is_ascii_and_more(encoding: str) -> bool:
    """True if every ASCII character is its own single byte, which means nothing else anywhere."""
    name = codecs.lookup(encoding).name
    if name in ("utf-8", "utf-8-sig", "ascii"):
        return True
    every = bytes(range(256))
    decoded = every.decode(encoding, "replace")
    return len(decoded) == len(every) and decoded[:128].encode() == every[:128]


def last_rows(content: bytes | mmap.mmap, end: int, encoding: str) -> tuple[list[str], int]:
    """The rows in the last 64 kB of a file, and how many bytes at its end belong to a row without line end.

    Parameters
    ----------
    content : bytes-like
        The whole file.
    end : int
        Its bytes that are text.
    encoding : str
        Its text encoding.

    Raises
    ------
    UnicodeDecodeError
        The file ends within a character of two bytes or more.
    """
    codec = encoding
    if encoding == "utf-16":
        codec = "utf-16-be" if content[:2] == codecs.BOM_UTF16_BE else "utf-16-le"
    width = len("0".encode(codec)) if codec != "utf-8-sig" else 1
    start = max(0, end - _TAIL_BYTES)
    start -= start % width
    if width == 1:  # line ends are single bytes in all of these, whatever stands between them
        codec = "latin-1"
    text = content[start:end].decode(codec)
    return rows_of(text), len(text[max(text.rfind("\n"), text.rfind("\r")) + 1 :].encode(codec))


def bytes_written(content: bytes | mmap.mmap) -> int:
    """Bytes of a file before the zeros at its end, which stay where a logger that took space lost its power."""
    end = len(content)
    while end and content[end - 1] == 0:
        begin = max(0, end - _TAIL_BYTES)
        end = begin + len(content[begin:end].rstrip(b"\0"))
    return end
