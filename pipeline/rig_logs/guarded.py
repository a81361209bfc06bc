"""Reading a raw log in a child process with limits, so that a hostile or damaged file cannot hurt the parent."""

import json
import mmap
import os
import signal
import stat
import subprocess
import sys
import tempfile
from collections.abc import Sequence
from dataclasses import asdict
from pathlib import Path
from typing import Any

import numpy as np

from pipeline.errors import InputError
from pipeline.numerics.arrays import FloatArray
from pipeline.rig_logs.limits import Limits
from pipeline.rig_logs.recording import Channel, Recording
from pipeline.rig_logs.source import CsvOptions

# The child sees the parent's import path and nothing else of its environment; -S saves the time of `site`.
_START = (
    "import json, sys; request = json.loads(sys.stdin.readline()); sys.path[:] = request.pop('sys_path'); "
    "from pipeline.rig_logs.child import main; main(request)"
)
_PATIENCE = 10


def read_recording(
    path: Path,
    *,
    channels: Sequence[str] | None = None,
    csv: CsvOptions | None = None,
    limits: Limits | None = None,
) -> Recording:
    """Read a raw log, in a child process with limits.

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

    Raises
    ------
    InputError
        No such file, unreadable, damaged, without one of the channels, or beyond the limits.

    Notes
    -----
    Cost: the child's start (about 0.15 s of processor time, most of it numpy's import), the parse, and one
    write and one mapped read of 8 bytes a sample; the arrays are backed by an unlinked temporary file, so the
    system can page them out.
    """
    limits = limits or Limits()
    _check_is_file(path)
    with tempfile.TemporaryFile(prefix="debist-") as data:
        request = {
            "sys_path": [entry or str(Path.cwd()) for entry in sys.path],
            "path": str(path),
            "channels": None if channels is None else list(dict.fromkeys(channels)),
            "csv": asdict(csv or CsvOptions()),
            "limits": asdict(limits),
            "data_fd": data.fileno(),
        }
        answer = _ask_child(path, request, limits)
        return _recording(path, answer, data.fileno())


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


def _ask_child(path: Path, request: dict[str, Any], limits: Limits) -> dict[str, Any]:
    size = path.stat().st_size
    try:
        done = _run_child(request, _PATIENCE * limits.seconds(size))
    except subprocess.TimeoutExpired:
        raise InputError(f"{path}: reading it does not end; damaged, or on a stalled file system") from None
    try:
        answer = json.loads(done.stdout) if done.returncode == 0 else None
    except ValueError:
        answer = None
    if not isinstance(answer, dict):
        raise InputError(f"{path}: its reader {_cause_of_death(done.returncode, done.stderr, limits, size)}")
    if "error" in answer:
        raise InputError(str(answer["error"]))
    return answer


def _run_child(request: dict[str, Any], timeout: float) -> "subprocess.CompletedProcess[bytes]":
    """Start the child, hand it the request, collect its answer; the file's name travels as data, never as an option."""
    environment = {
        name: value for name, value in os.environ.items() if name in ("PATH", "HOME", "TMPDIR", "LD_LIBRARY_PATH")
    }
    # One thread each; HDF5 must not load filter plugins from anywhere.
    environment |= {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1", "HDF5_PLUGIN_PRELOAD": "::"}
    return subprocess.run(
        [sys.executable, "-I", "-S", "-c", _START],
        input=(json.dumps(request) + "\n").encode(),
        capture_output=True,
        env=environment,
        pass_fds=(request["data_fd"],),
        timeout=timeout,
        check=False,
    )


def _cause_of_death(code: int, stderr: bytes, limits: Limits, size: int) -> str:
    if code == -signal.SIGXCPU or code == -signal.SIGKILL:
        return f"was ended (limits: {limits.seconds(size)} s, {limits.memory(size) >> 20} MB); damaged or too large"
    if code < 0:
        return f"died of {signal.Signals(-code).name}; the file is damaged"
    last = stderr.decode("utf-8", "replace").strip().splitlines()[-1:] or ["no reason given"]
    return f"failed ({last[0][:200]}); the file is damaged or not what it claims to be"


def _recording(path: Path, answer: dict[str, Any], fd: int) -> Recording:
    size = os.fstat(fd).st_size
    mapped = mmap.mmap(fd, size, access=mmap.ACCESS_READ) if size else b""
    arrays: dict[tuple[int, int], FloatArray] = {}

    def array(place: list[int]) -> FloatArray:
        offset, count = int(place[0]), int(place[1])
        if offset < 0 or count < 0 or offset + 8 * count > size:
            raise InputError(f"{path}: its reader gave samples that are not there; the file is damaged")
        if (offset, count) not in arrays:
            arrays[offset, count] = np.frombuffer(mapped, dtype="<f8", count=count, offset=offset)
        return arrays[offset, count]

    channels = tuple(
        Channel(
            name=str(entry["name"]),
            unit=str(entry["unit"]),
            time=None if entry["time"] is None else array(entry["time"]),
            samples=array(entry["samples"]),
            dtype=str(entry["dtype"]),
        )
        for entry in answer["channels"]
    )
    return Recording(path, str(answer["format"]), channels, tuple(answer["listed"]), tuple(answer["notes"]))
