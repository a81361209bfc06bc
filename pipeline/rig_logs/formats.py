"""Which reader a file needs, by its first bytes; the suffix is only a hint in messages.

A new format is a module with ``open_log(path, csv, limits) -> Source`` and one line in `FORMATS`.
"""

import importlib
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from pipeline.rig_logs.source import CsvOptions, Limits, Source, UnreadableLogError, read_start

_VERSION_1 = (b"\x00\x01", b"\x01\x00")  # in the byte order of the file
_HDF5 = b"\x89HDF\r\n\x1a\n"
_KNOWN_BUT_NOT_READ = {
    b"TDSm": "a TDMS file; export it as MDF4, MAT or CSV",
    b"PK\x03\x04": "a zip archive (a workbook?); export it as CSV or unpack it",
    b"\x1f\x8b": "gzip-compressed; unpack it first",
    b"version https://git-lfs": "a pointer of Git LFS; fetch the log itself by `git lfs pull`",
    **dict.fromkeys((b"<!DOCTYPE html", b"<!doctype html", b"<html"), "a web page; download the log itself"),
}


@dataclass(frozen=True)
class Format:
    """One format.

    Attributes
    ----------
    name : str
        As people say it.
    module : str
        In `pipeline.rig_logs`; imported in the guarded child when such a file is opened.
    begins : callable
        Whether a file whose first 1024 bytes are these is one.
    """

    name: str
    module: str
    begins: Callable[[bytes], bool]


FORMATS = (
    Format("MDF", "mdf", lambda start: start.startswith((b"MDF ", b"UnFinMF "))),
    Format("Parquet", "parquet", lambda start: start.startswith(b"PAR1")),
    Format("MAT v7.3", "matlab73", lambda start: _is_hdf5(start) and start.startswith(b"MATLAB 7.3")),
    Format("HDF5", "hdf5", lambda start: _is_hdf5(start)),
    Format("MAT v5", "matlab5", lambda start: start[126:128] in (b"IM", b"MI") and start[124:126] in _VERSION_1),
)
"""Tried in this order; what none of them takes is read as CSV."""


def _is_hdf5(start: bytes) -> bool:
    return _HDF5 in (start[:8], start[512:520])  # a MAT file has its own 512 bytes before


def open_source(path: Path, csv: CsvOptions, limits: Limits) -> Source:
    """Open a raw log with the reader of its format.

    Raises
    ------
    UnreadableLogError
        Empty, damaged, or of no known format.
    """
    start = read_start(path, 1024)
    if not start:
        raise UnreadableLogError("the file is empty")
    for magic, what in _KNOWN_BUT_NOT_READ.items():
        if start.startswith(magic):
            raise UnreadableLogError(f"this is {what}")
    module = next((known.module for known in FORMATS if known.begins(start)), "csv")
    if module == "csv" and start.startswith(b"MATLAB"):
        raise UnreadableLogError("it begins like a MAT file, and the rest is damaged or missing")
    source: Source = importlib.import_module(f"pipeline.rig_logs.{module}").open_log(path, csv, limits)
    return source
