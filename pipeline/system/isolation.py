"""Work in a process of its own, by the standard library's `multiprocessing`: if it dies or hangs, this process goes on.

On Linux processes are forked from a server that has imported what they need, elsewhere each is a new interpreter. A
process imports neither the program's main module nor modules of the current folder, and ends when its parent is gone.
"""

import atexit
import json
import math
import multiprocessing
import os
import signal
import sys
import sysconfig
import tempfile
import threading
import time
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import ExitStack, contextmanager, suppress
from multiprocessing.connection import Connection, wait
from pathlib import Path
from types import ModuleType
from typing import Any, Self, TypeVar

from .machine import ONE_THREAD, load_linear_algebra, resource

Running = TypeVar("Running", bound="Isolated")
Send = Callable[[Any], None]
"""Hands what JSON can hold to the parent."""

_HOME = str(Path(__file__).resolve().parents[2])
_STANDARD = ("stdlib", "platstdlib", "purelib", "platlib")
_SURROUNDINGS = {
    "PYTHONSAFEPATH": "1",
    "HDF5_PLUGIN_PRELOAD": "::",  # no filter plugins from anywhere
    "JE_ARROW_MALLOC_CONF": "background_thread:false",  # no thread may run in a process that is forked
    **dict.fromkeys((*ONE_THREAD, "NUMBA_NUM_THREADS"), "1"),  # processes share the cores
}
_LONGEST_FOLDER = 70
"""Characters of the temporary folder beyond which the socket of the server would have too long a name."""
_LONGEST_MESSAGE = 1 << 28
_LONGEST_WORDS = 1 << 16
_DESCRIPTORS = 12
"""Descriptors that are free before a process is started."""
_GRACE = 5.0
"""Time [s] for a process to end by itself before it is killed."""
_starting = threading.RLock()
_preloaded = list[str]()


def preload(modules: Sequence[str]) -> None:
    """Have the server import these modules too; without effect elsewhere, and once the server runs."""
    context = process_context()
    _preloaded.extend(name for name in modules if name not in _preloaded)
    if context.get_start_method() == "forkserver":
        context.set_forkserver_preload(_preloaded)


def limit(memory: int, processor_seconds: int, file_bytes: int) -> None:
    """Limit this process for good, where the system has such limits (not Windows; no memory limit on macOS).

    Parameters
    ----------
    memory : int
        Most address space [bytes]; beyond it Python raises MemoryError, and libraries fail.
    processor_seconds : int
        Most processor time; SIGXCPU ends the process after it.
    file_bytes : int
        Most bytes of a file that it writes.
    """
    if resource is None:
        return
    for name, bound, spare in (
        ("RLIMIT_AS", memory, 0),
        ("RLIMIT_CPU", processor_seconds, 1),  # SIGXCPU says why, SIGKILL a second later could be anybody's
        ("RLIMIT_FSIZE", file_bytes, 0),
        ("RLIMIT_CORE", 0, 0),
    ):
        kind = getattr(resource, name)
        hard = resource.getrlimit(kind)[1]
        last = bound + spare if hard == resource.RLIM_INFINITY else min(bound + spare, hard)
        with suppress(ValueError, OSError):  # macOS refuses some
            resource.setrlimit(kind, (min(bound, last), last))


def largest_memory() -> int:
    """Largest resident memory [bytes] of this process so far; 0 where the system does not count it."""
    if resource is None:
        return 0
    return int(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss) * (1 if sys.platform == "darwin" else 1024)


class Isolated:
    """A call in a process of its own; as a context manager it ends the process when it is left.

    Iterating yields the messages of the process until it ends, or is killed at its time limit.

    Parameters
    ----------
    work : callable
        A function of a module, called as ``work(send, *arguments)``.
    arguments : object
        Objects that can be pickled.
    time_limit : float
        Wall time [s] after which the process is killed.

    Attributes
    ----------
    channel : Connection
        Ready to be read when there is a message, or the process has ended.
    end : float
        Time at which it is killed, on the monotonic clock [s].
    late : bool
        True if the process was killed at its time limit.
    """

    def __init__(self, work: Callable[..., None], *arguments: Any, time_limit: float = math.inf) -> None:
        self._folder = tempfile.TemporaryDirectory(prefix="debist-", ignore_cleanup_errors=True)
        self._words = Path(self._folder.name) / "words"
        self.late = False
        context = process_context()
        self.channel, theirs = context.Pipe(duplex=False)
        with theirs, apart():
            self._process = context.Process(
                target=_work, args=(theirs, _current_folder(), str(self._words), work, arguments)
            )
            self._process.start()
        self.end = time.monotonic() + time_limit

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        """Terminate the process if it still runs, and kill it if it does not end."""
        self.end = min(self.end, time.monotonic() + _GRACE)
        if not wait([self._process.sentinel], 0.0):
            self._process.terminate()
        self.exit_code()
        self.channel.close()
        self._folder.cleanup()

    def __iter__(self) -> Iterator[Any]:
        """Messages of the process; as nothing is unpickled, it cannot run anything here."""
        with suppress(EOFError, OSError, ValueError):
            while self.channel.poll(self.seconds_left):
                yield json.loads(self.channel.recv_bytes(_LONGEST_MESSAGE))

    @property
    def seconds_left(self) -> float | None:
        """Wall time [s] until it is killed; None for ever."""
        return None if self.end == math.inf else max(0.0, self.end - time.monotonic())

    def exit_code(self) -> int:
        """The exit code, once it has ended or was killed at its time limit; negative where a signal ended it."""
        if not wait([self._process.sentinel], self.seconds_left):
            self.late = True
            self._process.kill()
        wait([self._process.sentinel])
        with _starting:  # `multiprocessing` asks after all processes when one is started
            self._process.join()
        return self._process.exitcode or 0

    def words(self) -> str:
        """The end of its standard error."""
        with suppress(OSError), self._words.open("rb") as file:
            file.seek(max(0, file.seek(0, os.SEEK_END) - _LONGEST_WORDS))
            return file.read().decode("utf-8", "replace")
        return ""


def next_ready(running: Iterable[Running]) -> Running:
    """The first of some processes that has sent something, has ended, or has to be killed."""
    by_channel: dict[Any, Running] = {process.channel: process for process in running}
    first = min(by_channel.values(), key=lambda process: process.end)
    ready = wait(list(by_channel), first.seconds_left)
    return by_channel[ready[0]] if ready else first


def death(exit_code: int) -> str:
    """Cause of the end of a process that has sent no answer."""
    if exit_code >= 0:
        return f"exit code {exit_code if exit_code < 1 << 16 else hex(exit_code)}"  # Windows counts in hex
    name = signal.Signals(-exit_code).name if -exit_code in set(signal.Signals) else f"signal {-exit_code}"
    return f"{name} (by another program, or by the system where memory runs out)" if name == "SIGKILL" else name


def process_context() -> Any:
    """Fork server or new interpreters; a process of the server has no server of its own, and is forked itself."""
    with ExitStack() as spare:  # where descriptors run out it fails here; the server would print a traceback of its own
        for _ in range(_DESCRIPTORS):
            spare.callback(os.close, os.open(os.devnull, os.O_RDONLY))
    forks = "forkserver" in multiprocessing.get_all_start_methods() and bool(sys.platform == "linux")
    if not forks or len(os.fsencode(tempfile.gettempdir())) > _LONGEST_FOLDER:
        return multiprocessing.get_context("spawn")
    from multiprocessing.forkserver import get_inherited_fds

    return multiprocessing.get_context("forkserver" if get_inherited_fds() is None else "fork")


@contextmanager
def apart() -> Iterator[None]:
    """Context for processes that share neither main module, current folder nor number of threads with this one.

    `multiprocessing` has each import the main module, which need not have the guard that this takes.
    """
    with _starting:
        main = sys.modules["__main__"]
        path = sys.path
        before = {name: os.environ.get(name) for name in _SURROUNDINGS}
        sys.modules["__main__"], sys.path = ModuleType("__main__"), import_path()
        os.environ.update(_SURROUNDINGS)
        try:
            yield
        finally:
            sys.modules["__main__"], sys.path = main, path
            for name, value in before.items():
                if value is None:
                    del os.environ[name]
                else:
                    os.environ[name] = value


def import_path() -> list[str]:
    """Search path of this process for modules; the current folder is left out unless debist or Python lies there."""
    here = _current_folder()
    own = {_HOME, *(sysconfig.get_path(name) for name in _STANDARD)}
    entries = [os.path.join(here or "", entry) for entry in sys.path if entry or here]  # noqa: PTH118
    entries = [entry for entry in entries if entry in own or not here or Path(entry) != Path(here)]
    return entries if _HOME in entries else [*entries, _HOME]


def _current_folder() -> str | None:
    """The current folder, to which names of files may be relative; None where it was deleted."""
    with suppress(OSError):
        return str(Path.cwd())
    return None


def _work(channel: Connection, here: str | None, words: str, work: Callable[..., None], arguments: Any) -> None:
    """Do the work in the process, with standard error in a file and standard output nowhere."""
    begin()
    if not Path(words).parent.is_dir():  # the command was stopped while this process began
        return
    if here is not None:
        os.chdir(here)
    for number, name, place in ((1, "stdout", os.devnull), (2, "stderr", words)):
        stream = Path(place).open("w", encoding="utf-8", errors="backslashreplace", buffering=1)  # noqa: SIM115
        os.dup2(stream.fileno(), number)
        setattr(sys, name, stream)
    work(lambda message: channel.send_bytes(json.dumps(message).encode()), *arguments)
    end()


_at_end = list[Callable[[], None]]()


def at_end(call: Callable[[], None]) -> None:
    """Have this called when the process ends as usual, by `multiprocessing` too, which does nothing of `atexit`."""
    atexit.register(call)
    _at_end.append(call)


def end() -> None:
    """Do what is to be done at the end of a process of `multiprocessing`."""
    for call in _at_end:
        call()


def begin() -> None:
    """End this process with its parent, which alone decides what Ctrl-C means."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    threading.Thread(target=_end_with_parent, daemon=True).start()
    load_linear_algebra()


def _end_with_parent() -> None:
    if (parent := multiprocessing.parent_process()) is not None:
        wait([parent.sentinel])
        os._exit(1)
