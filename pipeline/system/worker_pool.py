"""Calls side by side in processes of the standard library, or one after the other in this process."""

import multiprocessing
import warnings
from collections.abc import Callable, Iterator
from concurrent.futures import FIRST_COMPLETED, Future, ProcessPoolExecutor, wait
from concurrent.futures.process import BrokenProcessPool
from contextlib import contextmanager
from typing import Any, Protocol

from ..errors import WARNING, DebistError
from .isolation import apart, begin, process_context
from .progress import OnProgress

Call = Callable[[OnProgress], Any]
"""What is done: it takes a callable (current step, share done) for its progress, and returns its result."""

_POLL = 0.1
"""Time [s] between two looks at the progress of the processes: a tenth of a second reads as at once."""


class Pool(Protocol):
    """Calls that were begun, and their results."""

    @property
    def jobs(self) -> int:
        """The number of calls at a time."""

    def begin(self, key: int, call: Call, on_progress: OnProgress) -> None:
        """Begin a call; there are fewer than `jobs` under way."""

    def finished(self) -> list[tuple[int, Callable[[], Any]]]:
        """Wait for at least one call; the keys of those that have ended, and callables that give result or error."""


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
    """Calls in processes of their own, which must be picklable, as must their results.

    Parameters
    ----------
    executor : ProcessPoolExecutor
        Runs the calls.
    progress : SimpleQueue
        Brings the progress of the processes here.
    jobs : int
        Processes at a time.
    """

    def __init__(self, executor: ProcessPoolExecutor, progress: Any, jobs: int) -> None:
        self.jobs = jobs
        self._executor = executor
        self._progress = progress
        self._calls: dict[Future[Any], int] = {}
        self._listeners: dict[int, OnProgress] = {}

    def begin(self, key: int, call: Call, on_progress: OnProgress) -> None:
        """Hand the call to a process."""
        self._listeners[key] = on_progress
        with apart():
            self._calls[self._executor.submit(_perform, key, call)] = key

    def finished(self) -> list[tuple[int, Callable[[], Any]]]:
        """Wait for a call, and meanwhile pass on the progress of all."""
        ended: set[Future[Any]] = set()
        while not ended:
            ended = wait(self._calls, _POLL, FIRST_COMPLETED).done
            while not self._progress.empty():
                key, what, share = self._progress.get()
                self._listeners[key](what, share)
        return [(self._calls.pop(future), _result_of(future)) for future in ended]


def _result_of(future: "Future[Any]") -> Callable[[], Any]:
    def result() -> Any:
        """The result of the call, after the warnings that it gave."""
        try:
            value, texts = future.result()
        except BrokenProcessPool:
            raise DebistError(
                "a process ended before its work was done, as where memory runs out; what is written is whole, and the "
                "same command with --jobs 1 goes on"
            ) from None
        for text in texts:
            warnings.warn(text, stacklevel=2)
        return value

    return result


_reports: Any = None
"""In a process of the pool: the queue for its progress."""


def _enter(queue: Any) -> None:
    """Prepare a process of the pool."""
    global _reports
    begin()
    _reports = queue


def _perform(key: int, call: Call) -> tuple[Any, list[str]]:
    """In a process: make the call; its result, and the warnings for the user."""
    with warnings.catch_warnings(record=True) as given:
        warnings.simplefilter("always")
        value = call(lambda what, share: _reports.put((key, what, share)))
    return value, [str(warning.message) for warning in given if str(warning.message).startswith(WARNING)]


@contextmanager
def pool(jobs: int) -> Iterator[Pool]:
    """Calls in so many processes, in this one for a single job; whoever leaves it early ends the processes.

    Parameters
    ----------
    jobs : int
        Processes at a time.
    """
    if jobs == 1:
        yield _Here()
        return
    context = process_context()
    progress = context.SimpleQueue()
    with ProcessPoolExecutor(jobs, mp_context=context, initializer=_enter, initargs=(progress,)) as executor:
        try:
            yield _Processes(executor, progress, jobs)
        except BaseException:
            executor.shutdown(wait=False, cancel_futures=True)
            for process in multiprocessing.active_children():
                process.terminate()
            raise
