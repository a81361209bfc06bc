"""The tasks of a run in order, or side by side in processes; events and results are the same."""

import math
import time
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from functools import partial
from pathlib import Path

from ..store.manifest import Recipe
from ..store.run_folder import RunFolder, Written
from ..system.progress import OnProgress
from ..system.worker_pool import Pool, pool
from .engine import (
    After,
    Observer,
    Plan,
    Seen,
    Task,
    TaskStatus,
    check_sources,
    outputs_of,
    reasons_of,
    recipe_of,
    seen,
)


def bring_up_to_date(run: RunFolder, plan: Plan, observer: Observer, *, jobs: int = 1) -> list[TaskStatus]:
    """Do those tasks whose outputs are missing, damaged or stale; what was done and why, in the order of the plan.

    A task begins when no unfinished task before it writes one of its inputs. Damaged files are set aside under a name
    of their own before the rebuild. A task that fails leaves its old outputs as they were, and the tasks behind it are
    not done.

    Parameters
    ----------
    run : RunFolder
        The run, whose lock the caller holds.
    plan : iterable of Task or After
        Inputs before what is made from them. It is read beyond an `After` when its artifact is finished.
    observer : Observer
        Receives the events in the order of the plan, whatever the order in which tasks end.
    jobs : int
        Processes at a time. With more than one, `work` of each task must be a function of a module, or a partial of
        one, that can be pickled.
    """
    run.recover()
    try:
        with pool(jobs) as processes:
            schedule = _Schedule(run, iter(plan), _InOrder(observer), processes)
            while schedule.goes_on():
                schedule.begin_what_is_ready()
                schedule.end_what_is_done()
            schedule.raise_failure()
    except BaseException:
        run.recover()
        raise
    return schedule.statuses


Event = Callable[[Observer], None]


class _InOrder:
    """Events of tasks that run side by side, passed on as if one task had been done after the other.

    Parameters
    ----------
    observer : Observer
        Receives them.
    """

    def __init__(self, observer: Observer) -> None:
        self._observer = observer
        self._first = 0
        self._waiting: dict[int, list[Event | None]] = {}

    def add(self, number: int, *events: Event) -> None:
        """Events of the task at a place of the plan."""
        self._waiting.setdefault(number, []).extend(events)
        self._pass_on()

    def end(self, number: int) -> None:
        """No more events of a task."""
        self._waiting.setdefault(number, []).append(None)
        self._pass_on()

    def at_once(self, number: int, event: Event) -> None:
        """An event that is of no interest later, such as progress."""
        if number == self._first:
            event(self._observer)

    def _pass_on(self) -> None:
        while self._waiting.get(self._first):
            event = self._waiting[self._first].pop(0)
            if event is None:
                del self._waiting[self._first]
                self._first += 1
            else:
                event(self._observer)


@dataclass
class _Step:
    """A task under way: what its outputs are made from, its raw files before they are read, its beginning [s]."""

    task: Task
    recipe: Recipe
    sources: dict[Path, Seen]
    began: float


class _Schedule:
    """The tasks of a plan, by their places in it: those that wait, those that run, and what was done."""

    def __init__(self, run: RunFolder, plan: Iterator[Task | After], events: _InOrder, processes: Pool) -> None:
        self._run = run
        self._plan = plan
        self._events = events
        self._processes = processes
        self._read = 0
        self._mark: After | None = None
        self._waiting: dict[int, Task] = {}
        self._running: dict[int, _Step] = {}
        self._failed: tuple[int, Exception] | None = None
        self._statuses: dict[int, TaskStatus] = {}

    @property
    def statuses(self) -> list[TaskStatus]:
        """What was done and why, in the order of the plan."""
        return [self._statuses[number] for number in sorted(self._statuses)]

    def goes_on(self) -> bool:
        """Whether a task waits or runs, after the plan was read as far as it is known."""
        while self._failed is None and not self._must_wait():
            entry = next(self._plan, None)
            if entry is None:
                break
            if isinstance(entry, After):
                self._mark = entry
            else:
                self._waiting[self._read] = entry
                self._read += 1
        behind = math.inf if self._failed is None else self._failed[0]
        return bool(self._waiting) or any(number < behind for number in self._running)

    def _must_wait(self) -> bool:
        """Whether the plan is not known beyond this place, or this process alone does what was read."""
        if self._processes.jobs == 1 and self._waiting:
            return True
        return self._mark is not None and self._mark.artifact in self._unfinished(self._read)

    def _unfinished(self, before: int) -> set[str]:
        """The artifacts that tasks before a place of the plan have still to write."""
        tasks = self._waiting | {number: step.task for number, step in self._running.items()}
        return {name for number, task in tasks.items() if number < before for name in task.outputs}

    def begin_what_is_ready(self) -> None:
        """Begin the waiting tasks whose inputs are finished, as far as there are processes."""
        for number, task in list(self._waiting.items()):
            if len(self._running) == self._processes.jobs:
                return
            if not self._unfinished(number).intersection((*task.inputs, *task.outputs)):
                del self._waiting[number]
                self._begin(number, task)

    def _begin(self, number: int, task: Task) -> None:
        """Begin a task; one that is up to date has ended at once."""
        run = self._run
        sources = seen(task)  # before they are hashed: what changes between the two is found
        step = _Step(task, recipe_of(run, task), sources, time.perf_counter())
        reasons = reasons_of(run, task, step.recipe)
        self._statuses[number] = TaskStatus(task.stage, task.title, task.outputs, reasons)
        if not reasons:
            self._events.add(number, lambda observer: observer.skipped(task))
            self._events.end(number)
            return
        self._events.add(number, lambda observer: observer.started(task, reasons))
        for name in outputs_of(run, task):
            if name in run.manifest.artifacts and run.problem(name) not in (None, "is missing"):
                run.set_aside(name)

        def on_progress(what: str, share: float) -> None:
            """Pass on how far the task is."""
            self._events.at_once(number, lambda observer: observer.progressed(task, what, share))

        self._running[number] = step
        alone = self._processes.jobs == 1
        self._processes.begin(number, partial(_perform, task, run if alone else run.root), on_progress)

    def end_what_is_done(self) -> None:
        """Wait for running tasks, and commit what they have written."""
        for number, result in self._processes.finished() if self._running else ():
            step = self._running.pop(number)
            if self._failed is not None and self._failed[0] < number:
                continue
            try:
                written = result()
                check_sources(step.task, step.recipe, step.sources)
            except Exception as error:
                self._failed = (number, error)
                self._waiting = {earlier: task for earlier, task in self._waiting.items() if earlier < number}
            else:
                self._commit(number, step, written)

    def _commit(self, number: int, step: _Step, written: Mapping[str, Written]) -> None:
        task = step.task
        self._run.commit(step.recipe, written)
        seconds = time.perf_counter() - step.began
        warnings = dict.fromkeys(text for made in written.values() for text in made.notes.get("warnings", ()))
        self._events.add(number, *(partial(_warn, title=task.title, text=text) for text in warnings))
        self._events.add(number, lambda observer: observer.finished(task, seconds))
        self._events.end(number)

    def raise_failure(self) -> None:
        """Raise the error of the first task of the plan that failed, if one did."""
        if self._failed is not None:
            raise self._failed[1]


def _warn(observer: Observer, *, title: str, text: str) -> None:
    observer.warned(title, text)


def _perform(task: Task, place: RunFolder | Path, on_progress: OnProgress) -> Mapping[str, Written]:
    """Write the outputs of a task into a run: an open one, or in another process the one in this folder."""
    run = place if isinstance(place, RunFolder) else RunFolder.open(place)
    return task.work(run, on_progress) if task.reports else task.work(run)
