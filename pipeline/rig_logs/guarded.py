"""Reading a raw log in a child process with limits, so that a hostile or damaged file cannot hurt the parent."""

import os
import stat
import tempfile
from collections.abc import Callable, Mapping, Sequence
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import IO, Any

import numpy as np

from ..errors import InputError
from ..numerics.arrays import FloatArray
from ..signals.columns import column
from ..system.isolation import Isolated, death, preload
from ..system.package import full_name
from . import child
from .attributes import NOT_APPLIED
from .source import CsvOptions, Limits, missing_channel

_READER = child.read_log
_PATIENCE = 10


@dataclass(frozen=True)
class RecordedChannel:
    """One channel of a raw log, in the numbers of the log.

    Attributes
    ----------
    name : str
        Name in the log.
    unit : str
        Unit as the log writes it, "" where it has none; information only, the settings decide.
    time : FloatArray, shape (N,), or None
        The channel's own time base [s]; None where the format has none (a column of a table).
    samples : FloatArray, shape (N,)
        Samples, converted to float64, read-only.
    dtype : str
        Type of the numbers in the log, such as ``float32``.
    """

    name: str
    unit: str
    time: FloatArray | None
    samples: FloatArray
    dtype: str


@dataclass(frozen=True)
class Recording:
    """A raw log, or the part of it that was asked for.

    Attributes
    ----------
    path : Path
        The file.
    format : str
        Its format in words, such as ``MAT v5, ControlDesk``.
    channels : tuple of RecordedChannel
        The channels that were asked for, under the names by which they were asked for.
    listed : tuple of str
        Names of all numeric channels of the log.
    in_time : tuple of str
        Names of those with a unit of time, or of time stamps.
    notes : tuple of str
        Remarks for the user, such as the detected dialect of a CSV file.
    warnings : tuple of str
        Samples that were left out or changed.
    rates : mapping of str to float
        Sample rates [Hz] that single numbers beside the channels state, by their names; information only.
    frequencies : mapping of str to float
        Frequencies [Hz] by their names, either of the samples or of a motion: the log does not state which.
    descriptions : mapping of str to str
        Text of the log beside a channel, by its name.
    heading : str
        Text of the log above or beside all of them.
    """

    path: Path
    format: str
    channels: tuple[RecordedChannel, ...]
    listed: tuple[str, ...]
    in_time: tuple[str, ...] = ()
    notes: tuple[str, ...] = ()
    warnings: tuple[str, ...] = ()
    rates: Mapping[str, float] = field(default_factory=dict)
    frequencies: Mapping[str, float] = field(default_factory=dict)
    descriptions: Mapping[str, str] = field(default_factory=dict)
    heading: str = ""

    def channel(self, name: str) -> RecordedChannel:
        """The channel of that name.

        Raises
        ------
        InputError
            It was not read, or the log has none of that name.
        """
        for channel in self.channels:
            if channel.name == name:
                return channel
        raise InputError(f"{self.path}: {missing_channel(name, self.listed)}")

    def unapplied(self, name: str) -> list[str]:
        """The notes on numbers beside a channel that look like its calibration."""
        group = name.rpartition(".")[0]
        return [
            note
            for note in self.notes
            if NOT_APPLIED in note and (repr(name) in note or (group and note.startswith(f"{group}.")))
        ]


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
    Cost: the start of the process (elsewhere than on Linux each time), most of it numpy's import; the parse; and one
    write of 8 bytes a sample. The arrays are views of a mapped temporary file, so the system can page them out.
    """
    limits = limits or Limits()
    _check_is_file(path)
    with tempfile.TemporaryDirectory(prefix="debist-", ignore_cleanup_errors=True) as folder:
        samples = Path(folder) / "samples"
        request = {
            "path": str(path),
            "channels": None if channels is None else list(dict.fromkeys(channels)),
            "csv": asdict(csv or CsvOptions()),
            "limits": asdict(limits),
            "samples": str(samples),
        }
        answer = read_in_child(request, limits, progress)
        if "error" in answer:
            raise InputError(str(answer["error"]))
        with samples.open("rb") as data:
            return _recording(path, answer, data)


def _check_is_file(path: Path) -> None:
    try:
        mode = path.stat().st_mode
    except (OSError, ValueError) as error:
        raise InputError(f"{path}: cannot be read ({getattr(error, 'strerror', None) or error})") from error
    if not stat.S_ISREG(mode):
        raise InputError(f"{path}: is {'a directory' if stat.S_ISDIR(mode) else 'no regular file'}, not a log")
    if not os.access(path, os.R_OK):
        raise InputError(f"{path}: cannot be read (no permission)")


def read_in_child(
    request: dict[str, Any], limits: Limits, progress: Callable[[float], None] | None = None
) -> dict[str, Any]:
    """Have a request answered by `pipeline.rig_logs.child.read_log` in a process of its own.

    Raises
    ------
    InputError
        The process died, or did not end in time.
    """
    size = Path(request["path"]).stat().st_size
    preload(("numpy", full_name("system.isolation"), full_name("rig_logs.child")))
    with Isolated(_READER, request, time_limit=_PATIENCE * limits.seconds(size)) as reader:
        for message in reader:
            if isinstance(message, dict) and isinstance(message.get("answer"), dict):
                return dict(message["answer"])
            if progress is not None and isinstance(message, dict):
                progress(float(message.get("share", 0.0)))
        raise InputError(f"{request['path']}: {_cause_of_death(reader, limits, size)}")


def _cause_of_death(reader: Isolated, limits: Limits, size: int) -> str:
    code = reader.exit_code()
    signal = death(code) if code < 0 else ""
    if reader.late:
        return "reading it does not end; damaged, or on a stalled file system"
    if signal == "SIGXCPU":
        return (
            f"its reader was ended after {limits.seconds(size)} s of processor time; the file is too large or damaged"
        )
    if signal.startswith("SIGKILL"):
        return (
            f"its reader was killed; for want of memory (it may take {limits.memory(size) >> 20} MB)? run again alone"
        )
    if signal:
        return f"its reader died of {signal}; the file is damaged"
    reason = reader.words().strip().rpartition("\n")[2][:200] or "no reason given"
    return f"its reader failed ({reason}); the file is damaged or not what it claims to be, or the reader has a mistake"


def _recording(path: Path, answer: dict[str, Any], data: IO[bytes]) -> Recording:
    """The recording that a child answered, its columns as read-only views of the mapped file of samples."""
    size = os.fstat(data.fileno()).st_size // 8
    mapped = np.asarray(np.memmap(data, "<f8", "r", shape=(size,))) if size else np.empty(0)
    columns: dict[str, FloatArray] = {}

    def found(places: list[list[int]]) -> FloatArray:
        """The column at the places that the child answered."""
        key = str(places)  # channels on one time base get the same object
        if key not in columns:
            try:
                columns[key] = _column(mapped, [(int(offset), int(count)) for offset, count in places])
            except (ValueError, TypeError, OverflowError):
                raise InputError(f"{path}: its reader gave samples that are not there; the file is damaged") from None
        return columns[key]

    return Recording(
        path=path,
        format=str(answer["format"]),
        channels=tuple(
            RecordedChannel(
                name=str(entry["name"]),
                unit=str(entry["unit"]),
                time=None if entry["time"] is None else found(entry["time"]),
                samples=found(entry["samples"]),
                dtype=str(entry["dtype"]),
            )
            for entry in answer["channels"]
        ),
        listed=tuple(answer["listed"]),
        in_time=tuple(answer["in_time"]),
        notes=tuple(answer["notes"]),
        warnings=tuple(answer["warnings"]),
        rates={str(name): float(rate) for name, rate in answer["rates"].items()},
        frequencies={str(name): float(number) for name, number in answer["frequencies"].items()},
        descriptions={str(name): str(text) for name, text in answer["descriptions"].items()},
        heading=str(answer["heading"]),
    )


def _column(mapped: FloatArray, places: Sequence[tuple[int, int]]) -> FloatArray:
    """The samples at these offsets [bytes], so many at each; those of several parts in a file of their own.

    Raises
    ------
    ValueError
        They are not in the file.
    """
    if any(offset < 0 or offset % 8 or count < 0 or offset // 8 + count > mapped.size for offset, count in places):
        raise ValueError
    parts = [mapped[offset // 8 : offset // 8 + count] for offset, count in places]
    whole = parts[0] if len(parts) == 1 else column(sum(part.size for part in parts), parts, np.float64)
    whole.flags.writeable = False
    return whole
