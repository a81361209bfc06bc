"""One prototype of a batch in a process of its own, with its cost in processor time and memory."""

import itertools
import os
import signal
import subprocess
import sys
import tempfile
import threading
import time
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Any, BinaryIO

from pipeline.child_processes import died_of, isolated

# The processes share the cores, so the numerical libraries within them must not.
ONE_THREAD = {f"{library}_NUM_THREADS": "1" for library in ("OMP", "OPENBLAS", "MKL", "NUMBA")}
_LONGEST_STDERR = 1 << 16
SACRIFICED = "500"
"""What is added to a worker's badness when memory runs out, thousandths of all memory; proc_pid_oom_score_adj(5)."""
_PROGRAM = "from pipeline.batch.worker import end_with_parent; end_with_parent(); from cli import app; app.work()"


@dataclass(frozen=True)
class Outcome:
    """How one prototype went.

    Attributes
    ----------
    name : str
        Name of the prototype; its run lies under that name.
    prototype : Path
        Its settings file.
    exit_code : int or None
        Of its process; negative if a signal ended it, None if it was not started.
    reason : str
        Why it failed or was not started, one line; empty if it did well.
    seconds : float
        Wall time.
    processor_seconds : float
        Processor time of the process, and of readers of logs where they are no copies that the batch shares.
    memory_bytes : int
        Largest resident memory of any of them; Linux counts from the fork, so never less than that of the parent.
    """

    name: str
    prototype: Path
    exit_code: int | None
    reason: str
    seconds: float = 0.0
    processor_seconds: float = 0.0
    memory_bytes: int = 0

    @property
    def failed(self) -> bool:
        """Whether it was started and did not end well."""
        return self.exit_code not in (0, None)


def run_worker(
    name: str, prototype: Path, output: Path, options: Sequence[str] = (), *, time_limit: float | None = None
) -> Outcome:
    """Run a prototype as ``debist run`` with these options in a child process and wait for it.

    The child's standard input is a pipe that nobody writes to: it closes when this process ends, however it ends. After
    `time_limit` [s] of wall time it is killed.
    """
    began = time.perf_counter()
    command = [*isolated(_PROGRAM), "run", str(prototype), "-o", str(output / name)]
    with tempfile.TemporaryFile(prefix="debist-") as said:
        child = subprocess.Popen(
            [*command, "--json", "--quiet", *options],
            stdin=subprocess.PIPE,
            stdout=subprocess.DEVNULL,
            stderr=said,
            env=os.environ | ONE_THREAD,
        )
        with _time_limit(child, time_limit) as stopped:
            _, status, usage = os.wait4(child.pid, 0)
            child.returncode = os.waitstatus_to_exitcode(status)
        child.stdin.close()  # type: ignore[union-attr]
        ended = {
            "status": child.returncode,
            "processor_seconds": usage.ru_utime + usage.ru_stime,
            "memory": usage.ru_maxrss,
            "stopped": stopped.is_set(),
        }
        return make_outcome(name, prototype, began, ended, said, time_limit)


def make_outcome(
    name: str, prototype: Path, began: float, ended: Mapping[str, Any], said: BinaryIO, time_limit: float | None
) -> Outcome:
    """The outcome of a process that was begun at `began` and wrote its standard error into `said`.

    `ended` has its ``status`` (negative: a signal), ``processor_seconds``, ``memory`` (as the system counts it), and
    whether it was ``stopped`` for its time limit [s].
    """
    said.seek(max(0, said.seek(0, os.SEEK_END) - _LONGEST_STDERR))
    reason = _reason(ended["status"], said.read().decode("utf-8", "replace"))
    if ended["stopped"] and ended["status"] == -signal.SIGKILL:
        reason = f"stopped after the time limit of {time_limit:g} s; raise --time-limit, the same command goes on"
    seconds, memory = time.perf_counter() - began, ended["memory"] * (1 if sys.platform == "darwin" else 1024)
    return Outcome(name, prototype, ended["status"], reason, seconds, ended["processor_seconds"], memory)


@contextmanager
def _time_limit(child: "subprocess.Popen[bytes]", seconds: float | None) -> Iterator[threading.Event]:
    """Within, the child is killed after some seconds; the event says whether it was."""
    stopped = threading.Event()

    def stop() -> None:
        """End the process for good."""
        stopped.set()
        child.kill()

    timer = threading.Timer(seconds or 0.0, stop)
    timer.daemon = True
    if seconds is not None:
        timer.start()
    try:
        yield stopped
    finally:
        timer.cancel()


def end_with_parent() -> None:
    """Kill this process once its standard input closes: a worker whose batch was killed would hold its run's lock.

    And where memory runs out, have the kernel (Linux) take a worker, with its readers, rather than the batch.
    """
    with suppress(OSError):
        Path("/proc/self/oom_score_adj").write_text(SACRIFICED)

    def wait() -> None:
        """Until standard input is closed, which the parent's end does."""
        while os.read(0, 1):
            pass
        os.kill(os.getpid(), signal.SIGTERM)

    threading.Thread(target=wait, daemon=True).start()


def _reason(exit_code: int, stderr: str) -> str:
    if exit_code == 0:
        return ""
    if exit_code < 0:
        return died_of(-exit_code)
    lines = [line for line in stderr.splitlines() if line.strip()]
    said = [number for number, line in enumerate(lines) if line.startswith("debist: ")]
    if not said:
        return (lines or [f"exit code {exit_code}"])[-1]
    more = list(itertools.takewhile(lambda line: line.startswith("  "), lines[said[-1] + 1 :]))
    return lines[said[-1]].removeprefix("debist: ") + (": " if more else "") + "; ".join(line.strip() for line in more)
