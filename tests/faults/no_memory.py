"""Commands in processes whose requests for memory, small ones too, are counted and some of them refused.

A library of some lines of C (`no_memory.c`) stands between the process and the allocator of the C library. It is
preloaded into one process, which imports all that a run needs and is copied (forked) for each command.
"""

import ctypes
import json
import os
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from functools import partial
from pathlib import Path

from pipeline.child_processes import isolated

EVERYTHING = 1 << 62
_SOURCE = Path(__file__).with_name("no_memory.c")
_HOME = str(Path(__file__).resolve().parents[2])


@dataclass(frozen=True)
class Ended:
    """How a command ended (negative: the signal), what it said, requests made and refused, most bytes it had more."""

    code: int
    said: str
    asked: int
    refused: int
    peak: int


class Process:
    """The process that is copied."""

    def __init__(self, child: "subprocess.Popen[str]") -> None:
        self._child = child

    def run(self, arguments: Sequence[str], first: int = 0, last: int = 0, most: int = EVERYTHING) -> Ended:
        """Run `debist` with these arguments.

        Parameters
        ----------
        arguments : sequence of str
            Of the command.
        first, last : int
            Which requests for memory are refused, counted from 1.
        most : int
            How many bytes it may have beyond what its process had before; what goes beyond is refused.
        """
        assert self._child.stdin and self._child.stdout
        print(json.dumps([list(arguments), first, last, most]), file=self._child.stdin, flush=True)
        return Ended(**json.loads(self._child.stdout.readline()))


def compiler() -> str | None:
    """The C compiler, where there is one and the C library is the one that the source is written for."""
    return shutil.which("cc") if sys.platform == "linux" and os.confstr("CS_GNU_LIBC_VERSION") else None


@contextmanager
def process(folder: Path, warm_by: Sequence[Sequence[str]], small: bool) -> Iterator[Process]:
    """A process that is copied for commands.

    Parameters
    ----------
    folder : Path
        Where the library may lie.
    warm_by : sequence of sequence of str
        Commands that it runs first, so that copies find everything imported and compiled.
    small : bool
        Whether every object of Python is a request of its own.
    """
    library = folder / "no_memory.so"
    subprocess.run([compiler() or "cc", "-O2", "-shared", "-fPIC", "-o", str(library), str(_SOURCE)], check=True)
    program = f"sys.path.append({_HOME!r}); from tests.faults.no_memory import serve; serve()"
    environment = os.environ | {"LD_PRELOAD": str(library), "NO_MEMORY": str(library)}
    environment |= {"PYTHONMALLOC": "malloc"} if small else {}
    command = [part if part != "-I" else "-P" for part in isolated(program)]  # -I would ignore PYTHONMALLOC
    with subprocess.Popen(
        [*command, json.dumps([list(one) for one in warm_by])],
        stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True, env=environment,
    ) as child:  # fmt: skip
        yield Process(child)
        child.stdin and child.stdin.close()


def serve() -> None:
    """Be the process that is copied."""
    from pipeline.batch.warm import preload, run_debist
    from pipeline.child_processes import exit_code
    from pipeline.machine import settle_machine

    library = ctypes.CDLL(os.environ.pop("NO_MEMORY"))
    del os.environ["LD_PRELOAD"]  # readers of logs have limits of their own
    library.share.restype = ctypes.POINTER(ctypes.c_long)
    counts = library.share()
    settle_machine()
    told = os.fdopen(os.dup(1), "w")
    os.dup2(os.open(os.devnull, os.O_WRONLY), 1)
    if warm_by := json.loads(sys.argv[1]):
        preload("cli:app")
    for arguments in warm_by:
        exit_code(partial(run_debist, "cli:app", "", arguments))
    for line in sys.stdin:
        arguments, *limits = json.loads(line)
        for i in range(4):
            counts[i] = 0
        with tempfile.TemporaryFile() as said:
            pid = os.fork()
            if pid == 0:
                os.dup2(said.fileno(), 2)
                sys.argv = ["debist", *arguments]
                import cli

                limited = partial(library.arm, *map(ctypes.c_long, limits))
                os.register_at_fork(after_in_child=limited)
                cli.app()  # which does its work in a child
            code = os.waitstatus_to_exitcode(os.waitpid(pid, 0)[1])
            said.seek(0)
            text = said.read().decode("utf-8", "replace")
        answer = {"code": code, "said": text, "asked": counts[0], "refused": counts[1], "peak": counts[3]}
        print(json.dumps(answer), file=told, flush=True)
