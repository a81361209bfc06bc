"""One prototype of a batch in a process of its own, with its cost in processor time and memory."""

import itertools
import math
import sys
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path

from ..errors import RunLockedError
from ..system.isolation import Isolated, Send, death, largest_memory
from .progress import failure_file, keep_failure

Program = Callable[[list[str]], object]


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
        Processor time of the process, without its readers of logs; 0 for one that was killed.
    memory_bytes : int
        Its largest resident memory; 0 for one that was killed, and where the system does not count it (Windows).
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


class Worker(Isolated):
    """A prototype on its way in a process of its own.

    Parameters
    ----------
    program : callable
        The command ``debist`` with a list of arguments, a function of a module.
    name, prototype, output
        The run of the settings file `prototype` goes into the folder `name` of `output`.
    options : sequence of str
        More options of ``debist run``.
    time_limit : float
        Wall time [s] after which it is killed.
    """

    def __init__(
        self, program: Program, name: str, prototype: Path, output: Path, options: Sequence[str] = (), *,
        time_limit: float = math.inf,
    ) -> None:  # fmt: skip
        self.name = name
        self._prototype = prototype
        self._output = output
        self._time_limit = time_limit
        self._began = time.perf_counter()
        command = ["run", str(prototype), "-o", str(output / name), "--json", "-q", "--jobs", "1", *options]
        super().__init__(_run, program, command, time_limit=time_limit)

    def outcome(self) -> Outcome:
        """Wait for the end."""
        messages = list(self)
        answer = messages[-1] if messages else {}
        code = answer["exit_code"] if answer else self.exit_code()
        printed = self.words()
        reason = reason_of(code, printed)
        if self.late:
            reason = (
                f"stopped after the time limit of {self._time_limit:g} s; raise --time-limit, the same command goes on"
            )
        if code not in (0, RunLockedError.exit_code):  # a locked run is another process's
            keep_failure(self._output, self.name, code, reason, printed)
            if code == 1:
                reason = f"{reason}; its traceback is in {failure_file(self._output, self.name)}"
        return Outcome(
            self.name,
            self._prototype,
            code,
            reason,
            time.perf_counter() - self._began,
            answer.get("processor_seconds", 0.0),
            answer.get("memory_bytes", 0),
        )


def _run(send: Send, program: Program, command: list[str]) -> None:
    """In the process: run the command, and send its exit code and its cost."""
    code = 0
    try:
        program(command)
    except SystemExit as end:
        code = end.code if isinstance(end.code, int) else int(end.code is not None)
        if isinstance(end.code, str):
            sys.stderr.write(end.code + "\n")
    sys.stderr.flush()
    send({"exit_code": code, "processor_seconds": time.process_time(), "memory_bytes": largest_memory()})


def reason_of(exit_code: int, stderr: str) -> str:
    """Why a process with this exit code and this standard error failed; empty if it did not."""
    if exit_code == 0:
        return ""
    if exit_code < 0:
        return f"ended by {death(exit_code)}; what is written is whole, and the same command goes on"
    lines = [line for line in stderr.splitlines() if line.strip()]
    if exit_code == 1:
        return _last_of_traceback(lines)
    errors = [number for number, line in enumerate(lines) if line.startswith("debist: ")]
    if not errors:
        return (lines or [death(exit_code)])[-1]
    more = list(itertools.takewhile(lambda line: line.startswith("  "), lines[errors[-1] + 1 :]))
    return (
        lines[errors[-1]].removeprefix("debist: ") + (": " if more else "") + "; ".join(line.strip() for line in more)
    )


def _last_of_traceback(lines: Sequence[str]) -> str:
    """The exception that a traceback ends with."""
    own = [line for line in lines if not line.startswith(("debist: ", "warning: "))]
    return f"a bug of debist: {own[-1].strip()}" if own else death(1)
