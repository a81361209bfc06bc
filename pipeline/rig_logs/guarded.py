"""Reading a raw log in a child process with limits, so that a hostile or damaged file cannot hurt the parent."""

import json
import os
import signal
import stat
import subprocess
import tempfile
import threading
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager, suppress
from dataclasses import asdict
from pathlib import Path
from typing import Any, TextIO

from pipeline.child_processes import import_path, isolated
from pipeline.errors import InputError
from pipeline.numerics.arrays import FloatArray
from pipeline.process_copies import CAN_COPY, Copies
from pipeline.rig_logs.child import START, module_for
from pipeline.rig_logs.recording import (
    Channel,
    Places,
    Recording,
    mapped_columns,
)
from pipeline.rig_logs.source import CsvOptions, Limits, read_start

_CHILD, _READER = "pipeline.rig_logs.child", "pipeline.rig_logs.child:answer_request"
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
        What is known of a CSV log; the rest is found out.
    limits : Limits, optional
        Memory, processor time and sizes that are allowed.
    progress : callable, optional
        Told the share of the samples that are read.

    Raises
    ------
    InputError
        No such file, unreadable, damaged, without one of the channels, or beyond the limits.

    Notes
    -----
    Cost: once the start of the process that is copied (0.15 s of processor time, most of it numpy's import); the
    parse, and one write of 8 bytes a sample; the arrays are views of a mapped temporary file, so the system can page
    them out. A large compressed variable of a MAT file of version 5 is expanded into another one.
    """
    with tempfile.TemporaryFile(prefix="debist-") as data:
        answer = _ask_child(path, channels, csv, limits, data.fileno(), progress)
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
    data_fd: int,
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
        "data_fd": data_fd,
    }
    for last in (False, True):  # what a reader dies of may be the machine; the file is blamed after a second reading
        try:
            with _listening(progress) as progress_fd:
                done = _run_child(request | {"progress_fd": progress_fd}, _PATIENCE * limits.seconds(size))
        except subprocess.TimeoutExpired:
            raise InputError(f"{path}: reading it does not end; damaged, or on a stalled file system") from None
        answer = _answer(done)
        if answer is not None or last or done.returncode == -signal.SIGXCPU:
            break
        os.ftruncate(data_fd, 0)
        os.lseek(data_fd, 0, os.SEEK_SET)
    if answer is None:
        raise InputError(f"{path}: its reader {_cause_of_death(done.returncode, done.stderr, limits, size)}")
    if "error" in answer:
        raise InputError(str(answer["error"]))
    return answer


def _answer(done: "subprocess.CompletedProcess[bytes]") -> dict[str, Any] | None:
    """What the child says, None if it died or says nothing that can be understood."""
    try:
        answer = json.loads(done.stdout) if done.returncode == 0 else None
    except ValueError:
        return None
    return answer if isinstance(answer, dict) else None


@contextmanager
def _listening(progress: Callable[[float], None] | None) -> Iterator[int | None]:
    """A descriptor for the child; each line that it writes there is a share, passed on from a thread."""
    if progress is None:
        yield None
        return
    source, sink = os.pipe()
    lines = os.fdopen(source, encoding="ascii", errors="replace")
    listener = threading.Thread(target=_pass_on, args=(lines, progress), daemon=True)
    listener.start()
    try:
        yield sink
    finally:
        os.close(sink)
        listener.join()


def _pass_on(lines: TextIO, progress: Callable[[float], None]) -> None:
    """Tell of each line; where memory ends nobody listens any more, and the log is read all the same."""
    with lines, suppress(MemoryError):
        for line in lines:
            with suppress(ValueError):
                progress(float(line))


_copies: dict[str, Any] = {}


def start_readers() -> Copies:
    """The process that readers are copied from; copies of this process use the same."""
    surroundings = import_path(), _environment()
    if _copies.get("surroundings") != surroundings or _copies["readers"].ended:
        if "readers" in _copies:
            _copies["readers"].close()
        _copies.update(readers=Copies(_environment(), _CHILD, "-S"), surroundings=surroundings)
    readers: Copies = _copies["readers"]
    return readers


def _environment() -> dict[str, str]:
    """All that a child knows of the environment."""
    environment = {
        name: value for name, value in os.environ.items() if name in ("PATH", "HOME", "TMPDIR", "LD_LIBRARY_PATH")
    }
    # One thread each; HDF5 must not load filter plugins from anywhere.
    return environment | {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1", "HDF5_PLUGIN_PRELOAD": "::"}


def _run_child(request: dict[str, Any], timeout: float) -> "subprocess.CompletedProcess[bytes]":
    """Start the child, hand it the request, collect its answer; the file's name travels as data, never as an option."""
    files = {name: request[name] for name in ("data_fd", "progress_fd") if request[name] is not None}
    if CAN_COPY:
        placed = request | {name: 3 + place for place, name in enumerate(files)}
        done = _read_in_copy(start_readers(), _READER, _module(request), _line(placed), list(files.values()), timeout)
        if done is not None:
            return done
    # The child sees the parent's import path and nothing else of its environment; -S saves the time of `site`.
    return subprocess.run(
        isolated("from pipeline.rig_logs.child import answer_request; answer_request()", "-S"),
        input=_line(request),
        capture_output=True,
        env=_environment(),
        pass_fds=list(files.values()),
        timeout=timeout,
        check=False,
    )


def _read_in_copy(
    readers: Copies, reader: str, module: str | None, content: bytes, files: Sequence[int], timeout: float
) -> "subprocess.CompletedProcess[bytes] | None":
    """Call a reader in a copy: `content` is its standard input, `files` are 3, 4, …; None where none was made.

    Raises
    ------
    subprocess.TimeoutExpired
        It did not end within `timeout` [s] and was killed.
    """
    with _in_memory(content) as given, _in_memory() as out, _in_memory() as err:
        of_copy = [given.fileno(), out.fileno(), err.fileno(), *files]
        end = readers.run(reader, files=of_copy, module=module, time_limit=timeout)
        if end is not None and end.stopped:
            raise subprocess.TimeoutExpired(reader, timeout)
        if end is not None:
            return subprocess.CompletedProcess([], end.status, _content(out), _content(err))
    return None


@contextmanager
def _in_memory(content: bytes = b"") -> Iterator[Any]:
    """A file in memory with this content, to be read from its start."""
    with os.fdopen(os.memfd_create("reader"), "w+b", buffering=0) as file:
        file.write(content)
        file.seek(0)
        yield file


def _content(file: Any) -> bytes:
    return os.pread(file.fileno(), os.fstat(file.fileno()).st_size, 0)


def _line(request: dict[str, Any]) -> bytes:
    return (json.dumps(request) + "\n").encode()


def _module(request: dict[str, Any]) -> str | None:
    """The module that reads a log that begins like this one."""
    try:
        return f"pipeline.rig_logs.{module_for(read_start(Path(request['path']), START))}"
    except OSError:
        return None


def _cause_of_death(code: int, stderr: bytes, limits: Limits, size: int) -> str:
    if code == -signal.SIGXCPU:
        return f"was ended after {limits.seconds(size)} s of processor time; the file is too large or damaged"
    if code == -signal.SIGKILL:
        return f"was killed twice; for want of memory (it may take {limits.memory(size) >> 20} MB)? run again alone"
    if code < 0:
        return f"died of {signal.Signals(-code).name}, and again at a second reading; the file is damaged"
    last = stderr.decode("utf-8", "replace").strip().splitlines()[-1:] or ["no reason given"]
    return f"failed ({last[0][:200]}); the file is damaged or not what it claims to be"


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
        Channel(
            name=str(entry["name"]),
            unit=str(entry["unit"]),
            time=None if entry["time"] is None else found(entry["time"]),
            samples=found(entry["samples"]),
            dtype=str(entry["dtype"]),
        )
        for entry in answer["channels"]
    )
    rates = {str(name): float(rate) for name, rate in answer["rates"].items()}
    return Recording(path, str(answer["format"]), channels, tuple(answer["listed"]), tuple(answer["notes"]), rates)
