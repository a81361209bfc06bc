"""The end of a CSV file: whether its last row is there in full."""

import codecs
import mmap
import re
from collections.abc import Callable, Sequence
from pathlib import Path

from pipeline.rig_logs.csv_cells import is_remark
from pipeline.rig_logs.source import UnreadableLogError

_TAIL_BYTES = 1 << 16
_FEWEST = 10
_ROW_END = re.compile(r"\r\n|\r|\n")
_DIGITS = re.compile(r"[+-]?\d*(?:[.,](?P<fraction>\d+))?(?:[eE][+-]?(?P<exponent>\d+))?$")


def rows_of(text: str) -> list[str]:
    """Its rows; those of `str.splitlines` end at characters, too, which may stand within a cell."""
    rows = _ROW_END.split(text)
    return rows if rows[-1] else rows[:-1]


def _last_rows(content: bytes | mmap.mmap, encoding: str) -> tuple[list[str], int]:
    """The rows in the last 64 kB of a file, and how many bytes at its end belong to a row without line end.

    Parameters
    ----------
    content : bytes-like
        The whole file.
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
    start = max(0, len(content) - _TAIL_BYTES)
    start -= start % width
    tail = content[start:]
    if width == 1:  # line ends are single bytes in all of these, whatever stands between them
        codec = "latin-1"
    text = tail.decode(codec)
    end = max(text.rfind("\n"), text.rfind("\r")) + 1
    return rows_of(text), len(text[end:].encode(codec))


def _is_whole(cell: str, before: Sequence[str]) -> bool:
    """Whether a number cannot have been cut off: it has as many decimals (and digits of the exponent) as all before.

    Parameters
    ----------
    cell : str
        The last cell of the file.
    before : sequence of str
        The cells above it; ten of them at least, all of one form, are needed to tell.
    """
    forms = [form for text in before if text and (form := _form(text)) is not None]  # what is no number is a heading
    return len(forms) >= _FEWEST and set(forms) == {_form(cell)} and forms[0] != (0, 0)


def _form(cell: str) -> tuple[int, int] | None:
    match = _DIGITS.match(cell)
    return match and (len(match["fraction"] or ""), len(match["exponent"] or ""))


def whole_rows(
    path: Path, encoding: str, split: Callable[[str], list[str]], headings: Sequence[str]
) -> tuple[int, str]:
    """Bytes of a file without a last row that has no line end, unless that is seen to be whole; and a note on that row.

    Parameters
    ----------
    path : Path
        The log.
    encoding : str
        Its text encoding.
    split : callable
        Gives the cells of a row.
    headings : sequence of str
        The cells above the columns.

    Raises
    ------
    UnreadableLogError
        That row lacks cells, or a character is cut in two: the file is truncated.
    """
    with path.open("rb") as file:
        content = mmap.mmap(file.fileno(), 0, access=mmap.ACCESS_READ)
    try:
        rows, length = _last_rows(content, encoding)
    except UnicodeDecodeError as error:
        raise UnreadableLogError(f"truncated within a character: {error.reason}") from None
    if not length:
        return len(content), ""
    *before, last = [split(row) for row in rows]
    if is_remark(rows[-1], last, headings):
        return len(content), ""
    width = len(headings)
    if len(last) < width:
        raise UnreadableLogError(
            f"truncated: it ends within a row ({len(last)} of {width} cells); "
            "delete that row if the log shall be used up to there"
        )
    if _is_whole(last[width - 1], [row[width - 1] for row in before if len(row) >= width]):
        return len(content), "the last row has no line end; it is kept, its last number has as many digits as others"
    return len(content) - length, "the last row has no line end and may be cut off within a number: left out"
