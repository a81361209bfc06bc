"""The end of a CSV file: whether its last row is there in full."""

import codecs
import mmap
import re
from collections.abc import Sequence

_TAIL_BYTES = 1 << 16
_FEWEST = 10
_ROW_END = re.compile(r"\r\n|\r|\n")
_DIGITS = re.compile(r"[+-]?\d*(?:[.,](?P<fraction>\d+))?(?:[eE][+-]?(?P<exponent>\d+))?$")


def rows_of(text: str) -> list[str]:
    """Its rows; those of `str.splitlines` end at characters, too, which may stand within a cell."""
    rows = _ROW_END.split(text)
    return rows if rows[-1] else rows[:-1]


def last_rows(content: bytes | mmap.mmap, encoding: str) -> tuple[list[str], int]:
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


def is_whole(cell: str, before: Sequence[str]) -> bool:
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
