"""One prototype of a batch in a process of its own, with its cost in processor time and memory.

It is a copy of one that is warm where the system can do that, else a new interpreter.
"""

import itertools
import os
import signal
import subprocess
import sys
import tempfile
import threading
import time
from collections.abc import Iterator, Sequence
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from pathlib import Path
from typing import BinaryIO

from pipeline import machine
from pipeline.child_processes import died_of, isolated
from pipeline.process_copies import BADNESS, CAN_COPY, Copies, End

# The processes share the cores, so the numerical libraries within them must not.
ONE_THREAD = dict.fromkeys((*machine.ONE_THREAD, "NUMBA_NUM_THREADS"), "1")
_LONGEST_STDERR = 1 << 16
SACRIFICED = "500"
"""A worker's badness, so that the kernel (Linux) takes it, with its readers, rather than the batch."""


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


class Workers:
    """Runs prototypes, each in a process of its own; as a context manager it ends its own process when it is left.

    Parameters
    ----------
    program : str
        The command ``debist``, named ``module:object``: its `make_commands` makes it ready, its `work` runs it.
    warm : bool
        Import beforehand what runs need: 2 s of processor time once, which the third prototype has repaid.
    """

    def __init__(self, program: str, warm: bool = True) -> None:
        self._program, self._warm = program, warm
        self._copies: Copies | None = None
        self._starting, self._over = threading.Lock(), False

    def __enter__(self) -> "Workers":
        return self

    def __exit__(self, *_: object) -> None:
        self.end()

    def end(self) -> None:
        """End the process and what it runs; those who wait for that get an `InterruptedError`."""
        with self._starting:
            self._over = True
            if self._copies is not None:
                self._copies.close()

    def run(
        self, name: str, prototype: Path, output: Path, options: Sequence[str] = (), time_limit: float | None = None
    ) -> Outcome:
        """Run a prototype as ``debist run`` with these options and wait for its end; see `run_worker`."""
        if CAN_COPY:
            copies, began = self._running(), time.perf_counter()
            run = str(Path(output).absolute() / name)
            arguments = ["run", str(prototype), "-o", run, "--json", "--quiet", *options]
            with tempfile.TemporaryFile(prefix="debist-") as said, Path(os.devnull).open("r+b") as nowhere:
                end = copies.run(
                    "pipeline.batch.warm:run_debist", self._program, name, arguments, badness=SACRIFICED,
                    time_limit=time_limit, files=[nowhere.fileno(), nowhere.fileno(), said.fileno()],
                )  # fmt: skip
                if self._over:
                    raise InterruptedError(f"{name}: stopped with its batch")
                if end is not None:
                    return make_outcome(name, prototype, began, end, said, time_limit)
        # The process that is copied is gone, and with it what it had made, or it has threads of its own.
        return run_worker(self._program, name, prototype, output, options, time_limit=time_limit)

    def _running(self) -> Copies:
        """The process that is copied; it is started with the first prototype, and anew if it died."""
        with self._starting:
            if self._over:
                raise InterruptedError("the batch is over")
            if self._copies is not None and self._copies.ended:
                self._copies.close()
                self._copies = None
            self._copies = self._copies or self._started()
            return self._copies

    def _started(self) -> Copies:
        environment = os.environ | ONE_THREAD
        if self._warm:
            return Copies(environment, "pipeline.batch.warm:warm_up", arguments=[self._program])
        return Copies(environment, "pipeline.machine:settle_machine")


def run_worker(
    program: str, name: str, prototype: Path, output: Path, options: Sequence[str] = (), *,
    time_limit: float | None = None,
) -> Outcome:  # fmt: skip
    """Run a prototype as ``debist run``, which is `program`, with these options in a child process and wait for it.

    The child ends with this process, however that ends: a worker without its batch would hold its run's lock. After
    `time_limit` [s] of wall time it is killed.
    """
    began = time.perf_counter()
    text = (
        f"from pipeline.child_processes import end_with; end_with({os.getpid()}); "
        f"from pipeline.process_copies import named; named({program!r}).work()"
    )
    command = [*isolated(text), "run", str(prototype), "-o", str(output / name)]
    with tempfile.TemporaryFile(prefix="debist-") as said:
        child = subprocess.Popen(
            [*command, "--json", "--quiet", *options],
            stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL,
            stderr=said,
            env=os.environ | ONE_THREAD,
        )
        with suppress(OSError):
            Path(f"/proc/{child.pid}/{BADNESS.name}").write_text(SACRIFICED)
        with _time_limit(child, time_limit) as stopped:
            _, status, usage = os.wait4(child.pid, 0)
            child.returncode = os.waitstatus_to_exitcode(status)
        used = usage.ru_utime + usage.ru_stime
        end = End(child.returncode, used, usage.ru_maxrss, stopped.is_set())
        return make_outcome(name, prototype, began, end, said, time_limit)


def make_outcome(
    name: str, prototype: Path, began: float, end: End, said: BinaryIO, time_limit: float | None
) -> Outcome:
    """The outcome of a process that was begun at `began` and wrote its standard error into `said`."""
    said.seek(max(0, said.seek(0, os.SEEK_END) - _LONGEST_STDERR))
    reason = _reason(end.status, said.read().decode("utf-8", "replace"))
    if end.stopped and end.status == -signal.SIGKILL:
        reason = f"stopped after the time limit of {time_limit:g} s; raise --time-limit, the same command goes on"
    seconds, memory = time.perf_counter() - began, end.memory * (1 if sys.platform == "darwin" else 1024)
    return Outcome(name, prototype, end.status, reason, seconds, end.processor_seconds, memory)


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
