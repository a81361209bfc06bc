"""Calls side by side in processes of the standard library, or one after the other in this process."""

import traceback
import warnings
from collections.abc import Callable, Iterator, Sequence
from contextlib import AbstractContextManager, closing, contextmanager, nullcontext, suppress
from functools import partial
from multiprocessing.connection import Connection, wait
from typing import Any, NamedTuple, TypeVar

from ..errors import WARNING, DebistError
from .isolation import apart, begin, end, process_context

OnProgress = Callable[[str, float], None]
"""Called with the present step and the share, 0 to 1, that is done."""
_GONE = (
    "a process ended before its work was done, as where memory runs out; what is written is whole, and the same "
    "command with --jobs 1 goes on"
)


def silent(what: str, share: float) -> None:
    """Report nothing."""


Item = TypeVar("Item")
Made = TypeVar("Made")
Call = Callable[[OnProgress], Any]
"""Task: it takes a callable (current step, share done) for its progress, and returns its result."""


class _Here:
    """Calls in this process: each has ended when it has begun."""

    jobs = 1

    def __init__(self) -> None:
        self._ended: list[tuple[int, Callable[[], Any]]] = []

    def begin(self, key: int, call: Call, on_progress: OnProgress) -> None:
        """Make the call."""
        result = call(on_progress)
        self._ended.append((key, lambda: result))

    def finished(self) -> list[tuple[int, Callable[[], Any]]]:
        """The call that was made."""
        ended = self._ended
        self._ended = []
        return ended


class _Processes:
    """Calls in processes that stay, each at one end of a pipe; calls and results must be picklable.

    Fewer than `jobs` calls may be under way when one is begun.

    Parameters
    ----------
    jobs : int
        Processes at a time.
    """

    def __init__(self, jobs: int) -> None:
        self.jobs = jobs
        self._context = process_context()
        self._processes: dict[Connection, Any] = {}
        self._idle: list[Connection] = []
        self._calls: dict[Connection, tuple[int, OnProgress]] = {}

    def begin(self, key: int, call: Call, on_progress: OnProgress) -> None:
        """Hand the call to a process that has nothing to do, or to a new one."""
        channel = self._idle.pop() if self._idle else self._start()
        self._calls[channel] = (key, on_progress)
        with suppress(OSError):  # its process has ended, which `finished` finds
            channel.send(call)

    def _start(self) -> Connection:
        channel, theirs = self._context.Pipe()
        with theirs, apart():
            process = self._context.Process(target=_serve, args=(theirs,))
            process.start()
        self._processes[channel] = process
        return channel  # type: ignore[no-any-return]

    def finished(self) -> list[tuple[int, Callable[[], Any]]]:
        """Wait for a call, passing on the progress of all; the keys of ended calls, and what gives their results."""
        ended = list[tuple[int, Callable[[], Any]]]()
        while not ended:
            for channel in wait(list(self._calls)):
                ended += self._received(channel)  # type: ignore[arg-type]
        return ended

    def _received(self, channel: Connection) -> list[tuple[int, Callable[[], Any]]]:
        """The call at a channel if it has ended; else its progress is passed on."""
        key, on_progress = self._calls[channel]
        try:
            message = channel.recv()
        except (EOFError, OSError):
            message = _Ended(None, DebistError(_GONE), [])
            channel.close()
        if not isinstance(message, _Ended):
            on_progress(*message)
            return []
        del self._calls[channel]
        if not channel.closed:
            self._idle.append(channel)
        return [(key, message.result)]

    def close(self) -> None:
        """Let processes without a call end, which then keep what they have compiled, and end all if one has a call."""
        if self._calls:
            for process in self._processes.values():
                process.terminate()
        for channel in self._processes.keys() - self._calls.keys():
            with suppress(OSError):
                channel.send(None)
        for process in self._processes.values():
            process.join()


Pool = _Here | _Processes


class _Ended(NamedTuple):
    """Outcome of a call: its value, or the error that it raised, and the warnings for the user."""

    value: Any
    error: Exception | None
    texts: list[str]

    def result(self) -> Any:
        """The result of the call, after its warnings."""
        if self.error is not None:
            raise self.error
        for text in self.texts:
            warnings.warn(text, stacklevel=2)
        return self.value


def _serve(channel: Connection) -> None:
    """Make the calls that come in a process, until the pool closes."""
    begin()
    while (call := channel.recv()) is not None:
        channel.send(_made(call, lambda what, share: channel.send((what, share))))
    end()


def _made(call: Call, on_progress: OnProgress) -> _Ended:
    with warnings.catch_warnings(record=True) as given:
        warnings.simplefilter("always")
        try:
            value = call(on_progress)
        except Exception as error:
            if not isinstance(error, DebistError):
                error.add_note(traceback.format_exc())  # pickled without the places that it passed
            return _Ended(None, error, [])
    return _Ended(value, None, [str(warning.message) for warning in given if str(warning.message).startswith(WARNING)])


def pool(jobs: int) -> AbstractContextManager[Pool]:
    """Calls in so many processes, in this one for a single job; whoever leaves it early ends those with a call.

    Parameters
    ----------
    jobs : int
        Processes at a time.
    """
    return nullcontext(_Here()) if jobs == 1 else closing(_Processes(jobs))


@contextmanager
def meanwhile(call: Call, on_progress: OnProgress, jobs: int) -> Iterator[Callable[[], Any]]:
    """The result of a call that another process makes meanwhile; with a single job it is made when it is asked for.

    Parameters
    ----------
    call : callable
        The call; picklable with more than one job.
    on_progress : callable
        Receives its progress, while its result is waited for.
    jobs : int
        Processes at a time.
    """
    if jobs == 1:
        yield lambda: call(on_progress)
        return
    with closing(_Processes(1)) as other:
        other.begin(0, call, on_progress)
        yield lambda: other.finished()[0][1]()


def in_processes(work: Callable[[Item], Made], items: Sequence[Item], jobs: int) -> Iterator[Made]:
    """The results of `work` for the items, in order, in `jobs` processes; in this one for a single job."""
    made = dict[int, Made]()
    with pool(jobs) as processes:
        begun = 0
        for number in range(len(items)):
            while number not in made:
                while begun < min(len(items), number + jobs):
                    processes.begin(begun, partial(_without_progress, work, items[begun]), silent)
                    begun += 1
                made |= {key: result() for key, result in processes.finished()}
            yield made.pop(number)


def _without_progress(work: Callable[[Item], Made], item: Item, on_progress: OnProgress) -> Made:
    return work(item)
