"""Files that anybody may have left: read only where they are regular, and no further than a bound.

A FIFO would be waited for without end, a device would never end; both are refused before a byte is read.
"""

import errno
import os
import stat
import tomllib
from io import BufferedReader
from pathlib import Path
from typing import Any

_LARGEST = 1 << 20
"""Bytes of settings, notes and other small files."""


def open_plain(path: Path) -> BufferedReader:
    """Open a regular file for reading.

    Raises
    ------
    OSError
        As `open` does; also where it is no regular file.
    """
    try:
        kind = path.stat().st_mode
    except ValueError:
        raise OSError(errno.EINVAL, "has a NUL in its name", str(path)) from None
    if stat.S_ISDIR(kind):
        raise IsADirectoryError(errno.EISDIR, os.strerror(errno.EISDIR), str(path))
    if not stat.S_ISREG(kind):
        raise OSError(errno.EINVAL, "is no regular file", str(path))
    return path.open("rb")


def read_plain(path: Path, most: int = _LARGEST) -> bytes:
    """The bytes of a regular file of at most `most` bytes.

    Raises
    ------
    OSError
        As `open_plain`; also where it is larger.
    """
    with open_plain(path) as stream:
        content = stream.read(most + 1)
    if len(content) > most:
        raise OSError(errno.EFBIG, f"is larger than {most / 1e6:.3g} MB", str(path))
    return content


def read_toml(path: Path) -> dict[str, Any]:
    """Contents of a TOML file.

    Raises
    ------
    OSError
        As `read_plain`.
    UnicodeDecodeError, tomllib.TOMLDecodeError
        It is not UTF-8, or no TOML; also where it is nested too deeply or a number has thousands of digits.
    """
    text = read_plain(path).decode("utf-8-sig")  # some editors mark UTF-8 by a first character
    try:
        return tomllib.loads(text)
    except RecursionError:
        raise tomllib.TOMLDecodeError("brackets are nested too deeply") from None
    except ValueError as error:
        if isinstance(error, tomllib.TOMLDecodeError):
            raise
        raise tomllib.TOMLDecodeError(str(error).partition(";")[0]) from None
