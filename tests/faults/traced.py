"""A piece of work in a forked process whose system calls strace counts, makes fail, or answers with SIGKILL.

Faults at this level reach what C libraries do as well (HDF5, Arrow, zlib), at every single call.
"""

import mmap
import os
import re
import shutil
import subprocess
import tempfile
import traceback
from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from pipeline.errors import DebistError

CHANGING = ("write", "pwrite64", "ftruncate", "fsync", "rename", "mkdir", "unlink", "unlinkat", "openat")
BUG = 1
_LONGEST = 1 << 16


@dataclass(frozen=True)
class Call:
    """The `number`-th call of its name, counted from 1, with its arguments."""

    name: str
    number: int
    arguments: str


@dataclass(frozen=True)
class Ended:
    """How the work ended: exit code (negative: the signal), and what it said."""

    code: int
    text: str


def available() -> bool:
    """Whether strace is here and may attach to a process."""
    if shutil.which("strace") is None:
        return False
    return traced(lambda: None, "trace=none").code == 0


def traced(work: Callable[[], object], *expressions: str, log: Path | None = None) -> Ended:
    """Do the work in a fork of this process under strace with these ``-e`` expressions."""
    said, (gate, opener) = mmap.mmap(-1, _LONGEST), os.pipe()  # shared memory: no call that could be made to fail
    pid = os.fork()
    if pid == 0:
        _be_worker(work, gate, said)
    options = [part for expression in expressions for part in ("-e", expression)]
    options += ["-o", str(log) if log else os.devnull]
    try:
        tracer = subprocess.Popen(
            ["strace", "-y", "-p", str(pid), "-s", "300", *options], stderr=subprocess.PIPE, text=True
        )
        assert tracer.stderr is not None
        if "attached" not in tracer.stderr.readline():
            os.kill(pid, 9)
            os.waitpid(pid, 0)
            return Ended(-9, "strace cannot attach")
        os.write(opener, b"go")
        code = os.waitstatus_to_exitcode(os.waitpid(pid, 0)[1])
        tracer.communicate()
        return Ended(code, said[:].rstrip(b"\0").decode("utf-8", "replace"))
    finally:
        os.close(gate)
        os.close(opener)


def _be_worker(work: Callable[[], object], gate: int, said: mmap.mmap) -> None:
    code = BUG
    try:
        os.read(gate, 2)
        work()
        code = 0
    except DebistError as error:
        code = error.exit_code
        _say(said, str(error))
    except BaseException:
        _say(said, traceback.format_exc())
    finally:
        os._exit(code)


def _say(said: mmap.mmap, text: str) -> None:
    content = text.encode()[-_LONGEST:]
    said[: len(content)] = content


def changing_calls(work: Callable[[], object], folder: Path) -> list[Call]:
    """Every call of the work that changes something in `folder`, in order."""
    with tempfile.TemporaryDirectory() as scratch:
        log = Path(scratch) / "calls"
        ended = traced(work, f"trace={','.join(CHANGING)}", log=log)
        assert ended.code == 0, ended.text
        numbers: Counter[str] = Counter()
        found = []
        for line in log.read_text(errors="replace").splitlines():
            match = re.match(r"(?P<name>\w+)\((?P<arguments>.*)", line)
            if match is None or match["name"] not in CHANGING:
                continue
            name, arguments = match["name"], match["arguments"]
            numbers[name] += 1
            changes = name != "openat" or "O_CREAT" in arguments
            if changes and str(folder) in arguments:
                found.append(Call(name, numbers[name], arguments))
    return found
