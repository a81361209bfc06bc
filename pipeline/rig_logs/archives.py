"""One log in a compressed file: gzip, bzip2, xz or zip; a zip may also be a workbook or NumPy's archive of arrays."""

import bz2
import gzip
import lzma
import re
import zipfile
import zlib
from collections.abc import Callable
from pathlib import Path
from typing import Any, BinaryIO

from .source import (
    PART,
    CsvOptions,
    Limits,
    Source,
    UnreadableLogError,
    View,
    read_start,
    temporary_path,
)

_HIDDEN = re.compile(r"/$|^__MACOSX|(^|/)\.")
"""Folders, and files that file managers leave behind."""
_OPENERS: dict[bytes, Callable[[Path], Any]] = {b"\x1f\x8b": gzip.open, b"BZ": bz2.open, b"\xfd7": lzma.open}


class UnpackedSource(View):
    """A log that lies unpacked in a temporary file as long as this exists."""

    def __init__(self, path: Path, packed: BinaryIO, csv: CsvOptions, limits: Limits) -> None:
        from .child import open_source

        unpacked = temporary_path(self)
        left = limits.largest(path.stat().st_size)
        try:
            with unpacked.open("wb") as file:
                while part := packed.read(PART):
                    left -= len(part)
                    if left < 0:
                        raise UnreadableLogError("it unpacks to far more than it holds; refused")
                    file.write(part)
        except (OSError, EOFError, zlib.error, lzma.LZMAError, zipfile.BadZipFile, RuntimeError) as error:
            if getattr(error, "errno", None):  # of the disk, as when it is full
                raise
            raise UnreadableLogError(f"truncated or damaged ({error})") from error
        super().__init__(open_source(unpacked, csv, limits))
        self.format = f"{self.format}, compressed"


def open_log(path: Path, csv: CsvOptions, limits: Limits) -> Source:
    """The log as `pipeline.rig_logs.child` opens it."""
    if opener := _OPENERS.get(read_start(path, 2)):
        with opener(path) as packed:
            return UnpackedSource(path, packed, csv, limits)
    try:
        archive = zipfile.ZipFile(path)
    except zipfile.BadZipFile as error:
        raise UnreadableLogError(f"truncated or damaged ({error})") from error
    with archive:
        names = [name for name in archive.namelist() if not _HIDDEN.search(name)]
        if sum(each.file_size for each in archive.infolist()) > limits.largest(path.stat().st_size):
            raise UnreadableLogError("it unpacks to far more than it holds; refused")
        if "[Content_Types].xml" in names or "mimetype" in names:
            from . import workbook

            return workbook.open_log(path, csv, limits)
        if names and all(name.endswith(".npy") for name in names):
            from . import numpy_arrays

            return numpy_arrays.open_log(path, csv, limits)
        if len(names) != 1:
            raise UnreadableLogError(f"an archive of {len(names)} files, not of one log; unpack it")
        if archive.getinfo(names[0]).flag_bits & 1:
            raise UnreadableLogError("an archive with a password; unpack it")
        with archive.open(names[0]) as member:
            return UnpackedSource(path, member, csv, limits)  # type: ignore[arg-type]
