"""Child processes of the interpreter: no file of the current folder is a module to them, and none outlives its parent.

``python -c`` and ``python -m`` look for modules in the current folder first, where files of others may lie.
"""

import os
import signal
import sys
import sysconfig
import threading
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import TYPE_CHECKING, TypeVar

if TYPE_CHECKING:
    from concurrent.futures import ProcessPoolExecutor

Item = TypeVar("Item")
Made = TypeVar("Made")
_HOME = str(Path(__file__).resolve().parent.parent)
_LINUX, _PR_SET_PDEATHSIG = bool(sys.platform == "linux"), 1  # prctl(2)
_FOR_MEMORY = ("SIGKILL", "SIGABRT", "SIGSEGV", "SIGBUS")
"""By the kernel, which takes the largest process; by libraries in C++ and Rust; by libraries that do not look."""
_LESS = "; end other programs, or lower --jobs"
_STANDARD = ("stdlib", "platstdlib", "purelib", "platlib")


def isolated(program: str, *options: str) -> list[str]:
    """The command that runs a program text in an isolated interpreter with the modules that this process finds.

    Parameters
    ----------
    program : str
        Python source.
    options : str
        Further options of the interpreter, such as ``-S``.
    """
    return [sys.executable, "-I", *options, "-c", f"import sys; sys.path[:] = {import_path()!r}; {program}"]


def import_path() -> list[str]:
    """Where this process finds its modules, without the current folder, unless debist or the interpreter lies there."""
    here, kept = str(Path.cwd()), {_HOME, *(sysconfig.get_path(name) for name in _STANDARD)}
    found = [str(Path(entry).absolute()) for entry in sys.path]
    found = [entry for entry in found if entry in kept or entry != here]
    return found if _HOME in found else [*found, _HOME]


def exit_code(program: Callable[[], object]) -> int:
    """Run a program to its end, as the interpreter does; its exit code, when all is written that it has printed.

    Who then leaves by `os._exit` is spared what libraries do while the interpreter is taken down.
    """
    code = 0
    try:
        program()
    except SystemExit as end:
        code = end.code if isinstance(end.code, int) else int(end.code is not None)
        if isinstance(end.code, str):
            sys.stderr.write(end.code + "\n")
    flush()
    return code


def flush() -> None:
    """Write what is printed and held back, as far as it can be written; a stream that was closed is None."""
    for stream in (sys.stdout, sys.stderr):
        with suppress(OSError, ValueError, AttributeError):
            stream.flush()


def died_of(number: int) -> str:
    """What to say of a process that a signal has ended, and what to do."""
    known = number in set(signal.Signals)
    name = signal.Signals(number).name if known else f"signal {number}"
    why, do = (", most likely because memory ran out", _LESS) if name in _FOR_MEMORY else ("", "")
    return f"{name} ended the work{why}; what is written is whole, and the same command goes on{do}"


def end_with(parent: int) -> None:
    """Have this process killed once its parent, whose number is given, is gone."""
    if _LINUX:
        import ctypes

        ctypes.CDLL(None).prctl(_PR_SET_PDEATHSIG, signal.SIGKILL)
        if os.getppid() != parent:
            os.kill(os.getpid(), signal.SIGKILL)
        return

    def watch() -> None:
        """Kill this process once it has another parent."""
        while os.getppid() == parent:
            time.sleep(1.0)
        os.kill(os.getpid(), signal.SIGKILL)

    threading.Thread(target=watch, daemon=True).start()


@contextmanager
def process_pool(jobs: int) -> "Iterator[ProcessPoolExecutor]":
    """A pool of processes that end with this one, however it ends."""
    from concurrent.futures import ProcessPoolExecutor

    before = os.environ.get("PYTHONSAFEPATH")
    os.environ["PYTHONSAFEPATH"] = "1"  # where the system's way is to start new interpreters
    try:
        with ProcessPoolExecutor(max_workers=jobs, initializer=_end_with_parent) as pool:
            yield pool
    finally:
        if before is None:
            del os.environ["PYTHONSAFEPATH"]
        else:
            os.environ["PYTHONSAFEPATH"] = before


def in_processes(work: Callable[[Item], Made], items: Sequence[Item], jobs: int) -> Iterator[Made]:
    """What `work` makes of each item, in order, in so many processes; in this one for a single job."""
    if jobs == 1 or not items:
        yield from map(work, items)
        return
    with process_pool(jobs) as pool:
        yield from pool.map(work, items)


def _end_with_parent() -> None:
    """Kill this process of a pool once its parent is gone, which closes a pipe between them."""
    from multiprocessing import parent_process
    from multiprocessing.connection import wait

    def watch(sentinel: int) -> None:
        """Kill this process once the pipe from its parent is closed."""
        wait([sentinel])
        os.kill(os.getpid(), signal.SIGKILL)

    parent = parent_process()
    if parent is not None:
        threading.Thread(target=watch, args=(parent.sentinel,), daemon=True).start()
