"""Which reader a file needs, by its first bytes; the suffix is only a hint in messages."""

from pathlib import Path

from pipeline.rig_logs.limits import Limits
from pipeline.rig_logs.source import CsvOptions, Source, UnreadableLogError, read_start

_HDF5 = b"\x89HDF\r\n\x1a\n"
_KNOWN_BUT_NOT_READ = {
    b"TDSm": "a TDMS file; export it as MDF4, MAT or CSV",
    b"PK\x03\x04": "a zip archive (a workbook?); export it as CSV or unpack it",
    b"\x1f\x8b": "gzip-compressed; unpack it first",
    b"version https://git-lfs": "a pointer of Git LFS; fetch the log itself by `git lfs pull`",
    **dict.fromkeys((b"<!DOCTYPE html", b"<!doctype html", b"<html"), "a web page; download the log itself"),
}


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
    expansion_limit = limits.largest(path.stat().st_size)
    if start.startswith((b"MDF ", b"UnFinMF ")):
        from pipeline.rig_logs.mdf import MdfSource

        return MdfSource(path)
    if start.startswith(b"PAR1"):
        from pipeline.rig_logs.parquet import ParquetSource

        return ParquetSource(path)
    if _HDF5 in (start[:8], start[512:520]):
        if start.startswith(b"MATLAB 7.3"):
            from pipeline.rig_logs.matlab73 import open_matlab73

            return open_matlab73(path)
        from pipeline.rig_logs.hdf5 import Hdf5Source

        return Hdf5Source(path)
    if start[126:128] in (b"IM", b"MI") and start[124:126] in (b"\x00\x01", b"\x01\x00"):
        from pipeline.rig_logs.matlab5 import open_matlab5

        return open_matlab5(path, expansion_limit)
    if start.startswith(b"MATLAB"):
        raise UnreadableLogError("it begins like a MAT file, and the rest is damaged or missing")
    from pipeline.rig_logs.csv import CsvSource

    return CsvSource(path, csv)
