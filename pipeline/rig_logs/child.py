"""The guarded child: opens one raw log under resource limits and writes its samples as plain bytes.

Its messages are shares of the samples that are read, and at last the answer; samples go part by part, as little-endian
float64, into a temporary file. Nothing that was read is executed, pickled or trusted: the parent checks every offset
against the file's length.

Which reader a file needs its first bytes say; the suffix is only a hint in messages. A new format is a module with
``open_log(path, csv, limits) -> Source`` and one line in `FORMATS`.
"""

import errno
import os
import re
import struct
from collections import Counter, defaultdict
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from io import FileIO
from pathlib import Path
from traceback import format_exc
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..errors import disk_failure
from ..system.isolation import Send, limit
from ..system.package import object_at
from ..units.units import time_unit
from .source import (
    MEGABYTE,
    CsvOptions,
    Entry,
    Limits,
    Source,
    StartTimes,
    UnreadableChannelError,
    UnreadableLogError,
    for_any_variable,
    left_out,
    missing_channel,
    read_start,
    stated_beside,
)

_LONGEST_ERROR = _LONGEST_TEXT = 2000
_ENVIRONMENT = {"HDF5_PLUGIN_PRELOAD", "HOME", "LD_LIBRARY_PATH", "PATH", "SYSTEMROOT", "TEMP", "TMP", "TMPDIR"} | {
    "OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS",
}  # fmt: skip
"""All that a reader knows of the environment."""


_OF_LIBRARIES = (OSError, ValueError, KeyError, IndexError, TypeError, OverflowError, RuntimeError, ImportError)

_OF_A_CHANNEL = (UnreadableChannelError, KeyError, TypeError, NotImplementedError)
"""Raised where a library does not know a kind of channel; all else may be damage, for which a log is refused."""
_VERSION_1 = (b"\x00\x01", b"\x01\x00")  # in the byte order of the file
_HDF5 = b"\x89HDF\r\n\x1a\n"
_COMTRADE = re.compile(rb"[^\n]*\n *\d+, *\d+A, *\d+D")
START = 1024  # bytes that tell the format


def read_log(send: Send, request: dict[str, Any]) -> None:
    """Answer a request; runs in a process of its own (see `pipeline.system.isolation`)."""
    limits = Limits(**request["limits"])
    path = Path(request["path"])
    for name in set(os.environ) - _ENVIRONMENT:
        del os.environ[name]
    size = path.stat().st_size
    limit(limits.memory(size), limits.seconds(size), limits.data_bytes + (1 << 22))
    try:
        send({"answer": _read(path, request, limits, send)})
        return
    except UnreadableLogError as error:
        reason = f"{path}: {error}"
    except (NameError, SyntaxError, ModuleNotFoundError):  # which no file causes
        reason = f"{path}: its reader has a mistake, whatever the log holds; correct the reader: {format_exc(limit=-1)}"
    except (MemoryError, *_OF_LIBRARIES) as error:
        system = disk_failure(error)
        reason = f"{path}: damaged or not what it claims to be ({type(error).__name__}: {error})"
        if isinstance(error, MemoryError) or getattr(error, "errno", 0) == errno.ENOMEM:
            reason = (
                f"{path}: reading it needs more than {limits.memory(size) // MEGABYTE} MB of memory, or than "
                "`ulimit -v` leaves"
            )
        elif system is not None:
            reason = f"{path}: cannot be read: {system}"
    send({"answer": {"error": " ".join(reason.split())[:_LONGEST_ERROR]}})  # of libraries it may be a paragraph


def _read(path: Path, request: dict[str, Any], limits: Limits, send: Send) -> dict[str, Any]:
    source = open_source(path, CsvOptions(**request["csv"]), limits)
    entries = source.entries()
    wanted = _wanted(entries, source.texts, request["channels"], source.warnings)
    times = {entry.time for _, entry in wanted}
    needed = {entry.name: entry for entry in entries if entry.name in times} | {
        entry.name: entry for _, entry in wanted
    }
    declared = sum(entry.count for entry in needed.values()) * 8
    alone = request["channels"] is None and not source.one_pass
    failed: dict[str, Exception] = {}
    with Path(request["samples"]).open("wb", buffering=0) as file:
        spool = _Spool(path, file, declared, limits)
        for names in [[name] for name in needed] if alone else [list(needed)]:
            try:
                for name, samples in source.parts(names):
                    spool.write(name, samples)
                    send({"share": min(1.0, file.tell() / max(declared, 1))})
            except _OF_A_CHANNEL as error:
                failed[names[0]] = error
                if not alone or len(failed) == len(needed):
                    raise
    wanted = [(name, entry) for name, entry in wanted if not {entry.name, entry.time} & failed.keys()]
    return {
        "format": source.format,
        "notes": [
            *source.notes,
            *source.counted.notes(needed.keys() - failed.keys()),
            *left_out({name: f"{error}" for name, error in failed.items()}),
        ],
        "warnings": source.warnings,
        "rates": source.rates,
        "frequencies": source.frequencies,
        "descriptions": {name: text[:_LONGEST_TEXT] for name, text in source.descriptions.items()},
        "heading": source.heading[:_LONGEST_TEXT],
        "listed": [entry.name for entry in entries if entry.name not in failed],
        "in_time": [entry.name for entry in entries if entry.name not in failed and time_unit(entry.unit)],
        "channels": [
            {
                "name": name,
                "unit": entry.unit,
                "dtype": entry.dtype,
                "samples": spool.places[entry.name],
                "time": None if entry.time is None else spool.places[entry.time],
            }
            for name, entry in wanted
        ],
    }


def _wanted(
    entries: list[Entry], texts: Mapping[str, str], names: list[str] | None, warnings: list[str]
) -> list[tuple[str, Entry]]:
    """The entries asked for, each under the name by which it was asked for."""
    if names is None:
        return [(entry.name, entry) for entry in entries]
    wild = [for_any_variable(entry.name) for entry in entries]
    times = Counter(wild)
    by_alias = (
        {alias: entry for alias, entry in zip(wild, entries, strict=True) if times[alias] == 1}
        | {alias: entry for entry in entries for alias in entry.aliases}
        | {entry.name: entry for entry in entries}
    )
    for name in names:
        if name in texts:
            way_out = "" if ":" in texts[name] or ";" in texts[name] else "; export it as numbers"
            raise UnreadableLogError(f"channel {name!r} holds no plain numbers, but {texts[name]}{way_out}")
        if name not in by_alias:
            raise UnreadableLogError("; ".join([missing_channel(name, [entry.name for entry in entries]), *warnings]))
    return [(name, by_alias[name]) for name in names]


class _Spool:
    """The file for the samples, and where in it the parts of each entry lie: offset and count, in order.

    Parameters
    ----------
    path : Path
        The log.
    file : FileIO
        Gets the samples.
    declared : int
        Bytes of samples that its headers declare.
    limits : Limits
        Of which the size of the samples counts here.
    """

    def __init__(self, path: Path, file: FileIO, declared: int, limits: Limits) -> None:
        self.places: defaultdict[str, list[list[int]]] = defaultdict(list)
        size = path.stat().st_size
        self._largest = limits.largest(size)
        self._file = file
        self._beyond = f"of samples in a file of {size / 1e6:.3g} MB, beyond the limit of {self._largest / 1e6:.0f} MB"
        if declared > self._largest:
            raise UnreadableLogError(f"declares {declared / 1e6:.0f} MB {self._beyond}; refused unread")

    def write(self, name: str, samples: NDArray[Any]) -> None:
        """Append a part of an entry."""
        if not len(samples):
            return
        content = np.ascontiguousarray(samples, dtype="<f8").data.cast("B")
        position = self._file.tell()
        if position + len(content) > self._largest:
            raise UnreadableLogError(f"holds more {self._beyond}")
        places = self.places[name]
        if places and places[-1][0] + 8 * places[-1][1] == position:
            places[-1][1] += len(samples)
        else:
            places.append([position, len(samples)])
        while content:
            try:
                content = content[self._file.write(content) :]
            except OSError as error:
                raise UnreadableLogError(
                    "the temporary folder is full; its samples take 8 bytes each there, set TMPDIR"
                ) from error


@dataclass(frozen=True)
class Format:
    """One format.

    Attributes
    ----------
    module : str
        In `pipeline.rig_logs`; imported in the guarded child when such a file is opened.
    begins : callable
        Test of the first 1024 bytes of a file for the format.
    """

    module: str
    begins: Callable[[bytes], bool]


FORMATS = (
    Format("mdf", lambda start: start.startswith((b"MDF ", b"UnFinMF "))),
    Format("parquet", lambda start: start.startswith(b"PAR1")),
    Format("matlab73", lambda start: _is_hdf5(start) and start.startswith(b"MATLAB ")),
    Format("hdf5", lambda start: _is_hdf5(start)),
    Format("tdms", lambda start: start.startswith(b"TDSm")),
    Format("numpy_arrays", lambda start: start.startswith(b"\x93NUMPY")),
    Format("workbook", lambda start: start.startswith(b"\xd0\xcf\x11\xe0")),
    Format("archives", lambda start: start.startswith((b"PK\x03\x04", b"\x1f\x8b", b"BZh", b"\xfd7zXZ"))),
    Format("matlab5", lambda start: start[126:128] in (b"IM", b"MI") and start[124:126] in _VERSION_1),
)
"""Tried in this order; what none of them takes is read as CSV."""


def _is_hdf5(start: bytes) -> bool:
    return _HDF5 in (start[:8], start[512:520])  # a MAT file has its own 512 bytes before


def _is_matlab4(start: bytes) -> bool:
    """True if a file begins with the head of a matrix (type, rows, columns, complex, length of the name) and a name."""
    for order, types in (("<5i", range(53)), (">5i", range(1000, 1053))):
        kind, _, _, imaginary, length = struct.unpack(order, start[:20].ljust(20, b"\xff"))
        name = start[20:][:length] if 1 < length <= 64 else b""
        if (
            kind in types
            and imaginary in (0, 1)
            and name.endswith(b"\0")
            and name[:-1].decode("latin-1").isidentifier()
        ):
            return True
    return False


_KNOWN_BUT_NOT_READ: tuple[tuple[Callable[[bytes], object] | tuple[bytes, ...], str], ...] = (
    ((b"{", b"[[", b"[{", b"[\n", b"[ "), "this is JSON; export the log as CSV"),
    ((b"# Created by Octave",), "this is Octave's text format; save it by `save -v7 NAME.mat`"),
    ((b"    -1\n    58",), "this is a universal file (UFF 58); export the log as CSV or MAT"),
    ((b"CDF\x01", b"CDF\x02", b"CDF\x05"), "this is classic netCDF; convert it by `nccopy -k nc4`"),
    ((b"ARROW1", b"FEA1"), "this is Arrow or Feather; write it as Parquet (pyarrow.parquet.write_table)"),
    ((b"\x89MCAP", b"#ROSBAG"), "this is a bag of ROS; export its topics as CSV or Parquet"),
    ((b"\x80\x03", b"\x80\x04", b"\x80\x05"), "this is a pickle of Python; save its arrays by numpy.savez"),
    ((b"7z\xbc\xaf", b"Rar!", b"\x28\xb5\x2f\xfd", b"\x1f\x9d"), "this is an archive; unpack it"),
    ((b"RIFF",), "this is a WAVE or AVI file; export its samples as CSV or MAT"),
    ((b"SQLite format 3",), "this is a database; export its table as CSV"),
    ((b"LOGG",), "this is a CAN trace (BLF); export its signals as MDF4"),
    ((b"<?xml", b"%PDF", b"\x89PNG", b"\xff\xd8\xff"), "this is no table of numbers; export the log as CSV"),
    ((b"version https://git-lfs",), "this is a pointer of Git LFS; fetch the log itself by `git lfs pull`"),
    ((b"<!DOCTYPE html", b"<!doctype html", b"<html"), "this is a web page; download the log itself"),
    (lambda start: start[257:262] == b"ustar", "this is an archive; unpack it"),
    (
        _COMTRADE.match,
        "this is the configuration of a COMTRADE record; export the record with its scale factors applied as CSV",
    ),
    ((b"MATLAB",), "it begins like a MAT file, and the rest is damaged or missing"),
    (_is_matlab4, "this is a MAT file of version 4; load it in MATLAB and save it by `save NAME.mat -v7`"),
)
"""Formats that are refused, by the bytes with which they begin, or by a test of the first ones."""


def open_source(path: Path, csv: CsvOptions, limits: Limits) -> Source:
    """Open a raw log with the reader of its format.

    Where it states a rate and a start for each channel, and these differ, each has its own time.

    Raises
    ------
    UnreadableLogError
        Empty, damaged, or of no known format.
    """
    start = read_start(path, START)
    if not start:
        raise UnreadableLogError("the file is empty")
    module = next((form.module for form in FORMATS if form.begins(start)), "csv")
    for begins, what in _KNOWN_BUT_NOT_READ if module == "csv" else ():
        if start.startswith(begins) if isinstance(begins, tuple) else begins(start):
            raise UnreadableLogError(what)
    source: Source = object_at(f"rig_logs.{module}:open_log")(path, csv, limits)
    starts = source.starts or stated_beside(source)
    return StartTimes(source, starts) if len(set(starts.values())) > 1 else source
