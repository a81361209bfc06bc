"""In which encoding a text file is written."""

import codecs
import re

from .csv_cells import rows_of
from .source import UnreadableLogError

_BOMS = (
    (codecs.BOM_UTF8, "utf-8-sig"),
    (codecs.BOM_UTF16_LE, "utf-16"),
    (codecs.BOM_UTF16_BE, "utf-16"),
)
_NO_TEXT = "this is no text and no format that is known here; export the log as CSV, MAT, MDF4, HDF5 or Parquet"
_BEYOND_ASCII = re.compile(rb"[\x80-\xff]+")
_IN_NO_WESTERN_TEXT = re.compile(rb"[\x81-\x83\x8d\x8f\x90\x9d]")
_OTHER_SCRIPTS = re.compile(r"gb|big5|euc|shift_jis|cp932|cp949|johab|hz|iso2022|koi8|cp125[13]|cp866|iso8859-[57]$")
"""Python's names of encodings of Chinese, Japanese, Korean, Cyrillic and Greek."""


def text_encoding(start: bytes) -> str:
    """The encoding by the first bytes of a file.

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
        return _other_script(start) or ("cp1252" if re.search(rb"[\x80-\x9f]", start) else "latin-1")


def _other_script(start: bytes) -> str | None:
    """The encoding of a text of another script, whose letters beyond ASCII stand side by side; None for Latin ones."""
    runs = [len(run) for run in _BEYOND_ASCII.findall(start)]
    if 2 * runs.count(1) > sum(runs) and not _IN_NO_WESTERN_TEXT.search(start):
        return None
    import chardet

    text = b"\n".join(line for line in start.splitlines() if not line.isascii())
    name = codecs.lookup(chardet.detect(text)["encoding"] or "ascii").name
    try:
        codecs.getincrementaldecoder(name)().decode(start)
    except UnicodeDecodeError:
        return None
    return name if _OTHER_SCRIPTS.match(name) else None
