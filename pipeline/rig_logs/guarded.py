"""Reading a raw log in a child process with limits, so that a hostile or damaged file cannot hurt the parent."""

import os
import stat
import tempfile
from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

from ..errors import InputError
from ..numerics.arrays import FloatArray
from ..system.isolation import Isolated, death, preload
from ..system.package import full_name
from . import child
from .recording import (
    Places,
    RecordedChannel,
    Recording,
    mapped_columns,
)
from .source import CsvOptions, Limits

_READER_IMPORTS = ("numpy", full_name("system.isolation"), full_name("rig_logs.child"))
_READER = child.read_log
_PATIENCE = 10


def read_recording(
    path: Path,
    *,
    channels: Sequence[str] | None = None,
    csv: CsvOptions | None = None,
    limits: Limits | None = None,
    progress: Callable[[float], None] | None = None,
) -> Recording:
    """Read a raw log into arrays, in a child process with limits.

    Parameters
    ----------
    path : Path
        The log; its format is found from its content.
    channels : sequence of str, optional
        Names of the channels to read; only these are materialised. All numeric ones by default.
    csv : CsvOptions, optional
        Stated format of a CSV log; the rest is detected.
    limits : Limits, optional
        Memory, processor time and sizes that are allowed.
    progress : callable, optional
        Receives the share of the samples that are read.

    Raises
    ------
    InputError
        No such file, unreadable, damaged, without one of the channels, or beyond the limits.

    Notes
    -----
    Cost: the start of the process (elsewhere than on Linux each time), most of it numpy's import; the parse, and one
    write of 8 bytes a sample; the arrays are views of a mapped temporary file, so the system can page them out.
    """
    with tempfile.TemporaryDirectory(prefix="debist-", ignore_cleanup_errors=True) as folder:
        samples = Path(folder) / "samples"
        answer = _ask_child(path, channels, csv, limits, samples, progress)
        with samples.open("rb") as data:
            return _recording(path, answer, mapped_columns(data))


def _check_is_file(path: Path) -> None:
    try:
        mode = path.stat().st_mode
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or str(error)
        raise InputError(f"{path}: cannot be read ({reason})") from error
    if not stat.S_ISREG(mode):
        raise InputError(f"{path}: is {'a directory' if stat.S_ISDIR(mode) else 'no regular file'}, not a log")
    if not os.access(path, os.R_OK):
        raise InputError(f"{path}: cannot be read (no permission)")


def _ask_child(
    path: Path,
    channels: Sequence[str] | None,
    csv: CsvOptions | None,
    limits: Limits | None,
    samples: Path,
    progress: Callable[[float], None] | None,
) -> dict[str, Any]:
    limits = limits or Limits()
    _check_is_file(path)
    size = path.stat().st_size
    request = {
        "path": str(path),
        "channels": None if channels is None else list(dict.fromkeys(channels)),
        "csv": asdict(csv or CsvOptions()),
        "limits": asdict(limits),
        "samples": str(samples),
    }
    done = read_in_child(request, _PATIENCE * limits.seconds(size), progress)
    if done.late:
        raise InputError(f"{path}: reading it does not end; damaged, or on a stalled file system")
    if done.answer is None:
        raise InputError(f"{path}: its reader {_cause_of_death(done, limits, size)}")
    if "error" in done.answer:
        raise InputError(str(done.answer["error"]))
    return done.answer


@dataclass(frozen=True)
class Done:
    """End of a reader: its answer, or the cause of its death, and the last line of its standard error."""

    answer: dict[str, Any] | None
    ended_by: str = ""
    late: bool = False
    last_line: str = ""


def read_in_child(request: dict[str, Any], time_limit: float, progress: Callable[[float], None] | None = None) -> Done:
    """Have a request answered by `pipeline.rig_logs.child.read_log` in a process of its own."""
    preload(_READER_IMPORTS)
    with Isolated(_READER, request, time_limit=time_limit) as reader:
        for message in reader:
            if isinstance(message, dict) and isinstance(message.get("answer"), dict):
                return Done(message["answer"])
            if progress is not None and isinstance(message, dict):
                progress(float(message.get("share", 0.0)))
        code = reader.exit_code()
        return Done(None, death(code) if code < 0 else "", reader.late, reader.words().strip().rpartition("\n")[2])


def _cause_of_death(done: Done, limits: Limits, size: int) -> str:
    if done.ended_by == "SIGXCPU":
        return f"was ended after {limits.seconds(size)} s of processor time; the file is too large or damaged"
    if done.ended_by.startswith("SIGKILL"):
        return f"was killed; for want of memory (it may take {limits.memory(size) >> 20} MB)? run again alone"
    if done.ended_by:
        return f"died of {done.ended_by}; the file is damaged"
    reason = done.last_line[:200] or "no reason given"
    return f"failed ({reason}); the file is damaged or not what it claims to be"


def _recording(path: Path, answer: dict[str, Any], column: Callable[[Places], FloatArray]) -> Recording:
    columns: dict[str, FloatArray] = {}

    def found(places: list[list[int]]) -> FloatArray:
        """The column of which the child says that it lies there."""
        key = str(places)  # channels on one time base get the same object
        if key not in columns:
            try:
                columns[key] = column([(int(offset), int(count)) for offset, count in places])
            except (ValueError, TypeError, OverflowError):
                raise InputError(f"{path}: its reader gave samples that are not there; the file is damaged") from None
        return columns[key]

    channels = tuple(
        RecordedChannel(
            name=str(entry["name"]),
            unit=str(entry["unit"]),
            time=None if entry["time"] is None else found(entry["time"]),
            samples=found(entry["samples"]),
            dtype=str(entry["dtype"]),
        )
        for entry in answer["channels"]
    )
    rates = {str(name): float(rate) for name, rate in answer["rates"].items()}
    frequencies = {str(name): float(number) for name, number in answer["frequencies"].items()}
    descriptions = {str(name): str(text) for name, text in answer["descriptions"].items()}
    return Recording(
        path=path,
        format=str(answer["format"]),
        channels=channels,
        listed=tuple(answer["listed"]),
        notes=tuple(answer["notes"]),
        warnings=tuple(answer["warnings"]),
        rates=rates,
        frequencies=frequencies,
        descriptions=descriptions,
        heading=str(answer["heading"]),
    )
