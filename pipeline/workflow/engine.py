"""Bring artifacts up to date: content decides what is done again and why; side by side in processes."""

import time
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
from difflib import get_close_matches
from functools import partial
from operator import methodcaller
from pathlib import Path
from typing import Any, Protocol

from ..errors import InputError
from ..store.hashing import file_sha256
from ..store.manifest import Recipe, recover
from ..store.run_folder import RunFolder, Written
from ..system.worker_pool import OnProgress, Pool, pool

_TICK = 2_000_000_000
"""Nanoseconds; the coarsest clock by which a file system notes changes."""

FIRST_TIME = "first time"
"""The reason to make what was never made."""


@dataclass(frozen=True)
class Task:
    """One step of a stage: its inputs, its outputs, and the settings that decide the result.

    Attributes
    ----------
    stage, title : str
        Name of the stage; the title names the log or model.
    algorithm : str
        Version of the algorithm; raise it when equal inputs give another result.
    settings : mapping
        JSON values of the settings that matter to the result.
    inputs : tuple of str
        Names of artifacts of the run.
    sources : mapping of str to Path
        Raw files by the name under which they are recorded.
    named_in : str
        Keys of the settings that name them.
    outputs : tuple of str
        Names of the artifacts it always writes; it may write more where the data ask for it.
    work : callable
        Writes the outputs into the run that it is given, and returns them by name.
    reports : bool
        True if `work` also takes a callable (current step, share done) that reports its progress.
    """

    stage: str
    title: str
    algorithm: str
    settings: Mapping[str, Any]
    inputs: tuple[str, ...]
    outputs: tuple[str, ...]
    work: Callable[..., Mapping[str, Written]]
    sources: Mapping[str, Path] | None = None
    reports: bool = False
    named_in: str = "[logs]"


class Observer(Protocol):
    """Receiver of what happens; the command prints it."""

    def planned(self, stages: Sequence[str]) -> None:
        """Receive the tasks to come, named by their stages, up-to-date ones too."""

    def started(self, task: Task, reasons: list[str]) -> None:
        """The task is being done, for these reasons."""

    def progressed(self, task: Task, what: str, share: float) -> None:
        """Receive the share done of a task that reports its progress."""

    def finished(self, task: Task, seconds: float) -> None:
        """The task is done."""

    def skipped(self, task: Task) -> None:
        """The task's outputs are up to date."""

    def warned(self, what: str, warning: str) -> None:
        """Something about a task's data, by its title, or about an artifact deserves a look."""


class Unheard:
    """An observer that reports nothing; the notes of the artifacts hold the warnings."""

    def planned(self, stages: Sequence[str]) -> None:
        """Ignore the tasks to come."""

    def started(self, task: Task, reasons: list[str]) -> None:
        """Ignore the beginning of a task."""

    def progressed(self, task: Task, what: str, share: float) -> None:
        """Ignore the share done."""

    def finished(self, task: Task, seconds: float) -> None:
        """Ignore the end of a task."""

    def skipped(self, task: Task) -> None:
        """Ignore a task that is up to date."""

    def warned(self, what: str, warning: str) -> None:
        """Ignore a warning."""


@dataclass(frozen=True)
class TaskStatus:
    """State of a task's outputs: up to date, or the reasons why not."""

    stage: str
    title: str
    outputs: tuple[str, ...]
    reasons: list[str]

    @property
    def up_to_date(self) -> bool:
        """No reason to redo it."""
        return not self.reasons


@dataclass(frozen=True)
class After:
    """A mark in a plan: which tasks stand behind it depends on what this artifact holds."""

    artifact: str


Plan = Iterable[Task | After]
"""The tasks of a run, inputs before what is made from them."""


def tasks_of(plan: Plan) -> Iterator[Task]:
    """The tasks of a plan, without its marks."""
    return (entry for entry in plan if isinstance(entry, Task))


def status(run: RunFolder, plan: Plan) -> list[TaskStatus]:
    """State of each task of a run, with reasons; a task with a stale input is stale too."""
    stale: set[str] = set()
    statuses = []
    for task in tasks_of(plan):
        artifacts = run.manifest.artifacts
        waiting = [f"input {n} is {'stale' if n in artifacts else 'not made yet'}" for n in task.inputs if n in stale]
        missing = [name for name in task.inputs if name not in artifacts]
        reasons = waiting or (
            [f"input {missing[0]} is missing"] if missing else reasons_of(run, task, recipe_of(run, task))
        )
        if reasons:
            stale.update(task.outputs)
        statuses.append(TaskStatus(task.stage, task.title, task.outputs, reasons))
    return statuses


def recipe_of(run: RunFolder, task: Task) -> Recipe:
    """Recipe of a task's outputs, with the content hashes of its present inputs."""
    inputs = {name: run.record(name).content_hash for name in task.inputs}
    for name, path in (task.sources or {}).items():
        try:
            inputs[name] = file_sha256(path)
        except FileNotFoundError:
            raise InputError(missing_source(path, task)) from None
        except OSError as error:
            raise InputError(unreadable_source(path, error)) from error
    return Recipe(task.stage, task.algorithm, dict(task.settings), inputs)


def missing_source(path: Path, task: Task) -> str:
    """Message that a raw log or table of a task is missing."""
    beside = {other.name.casefold(): other.name for other in path.parent.iterdir()} if path.parent.is_dir() else {}
    close = get_close_matches(path.name.casefold(), beside, n=1)
    hint = f"did you mean {beside[close[0]]!r}? " if close else ""
    return f"{path}: no such log or table; {hint}correct its name in {task.named_in}"


def unreadable_source(path: Path, error: OSError) -> str:
    """The error for a raw log or table that the system does not let read."""
    return f"{path}: cannot be read: {error.strerror}; see to disk and permission"


@dataclass(frozen=True)
class Seen:
    """Size and times that show whether a file changed, and whether they are too recent to show it."""

    identity: tuple[int, ...]
    recent: bool


def seen(task: Task) -> dict[Path, Seen]:
    """The state of the raw files of a task."""
    states: dict[Path, Seen] = {}
    for path in (task.sources or {}).values():
        with suppress(OSError):  # `recipe_of` says what is wrong with it
            stat = path.stat()
            states[path] = Seen(
                identity=(stat.st_dev, stat.st_ino, stat.st_size, stat.st_mtime_ns, stat.st_ctime_ns),
                recent=time.time_ns() - max(stat.st_ctime_ns, stat.st_mtime_ns) < _TICK,
            )
    return states


def check_sources(task: Task, recipe: Recipe, before: Mapping[Path, Seen]) -> None:
    """Make sure that the bytes which were hashed are those which were read.

    Raises
    ------
    InputError
        A source was changed or replaced between the two.
    """
    after = seen(task)
    for name, path in (task.sources or {}).items():
        was = before.get(path)
        same = was is not None and path in after and was.identity == after[path].identity
        if not same or (was and was.recent and file_sha256(path) != recipe.inputs[name]):
            raise InputError(f"{path}: was changed while it was read; wait until it is complete and run again")


def outputs_of(run: RunFolder, task: Task) -> list[str]:
    """The declared outputs, and what was written beside them because of the data."""
    first = run.manifest.artifacts.get(task.outputs[0])
    beside = [name for name, record in run.manifest.artifacts.items() if first and record.recipe == first.recipe]
    return list(dict.fromkeys((*task.outputs, *beside)))


def reasons_of(run: RunFolder, task: Task, recipe: Recipe) -> list[str]:
    """Reasons why a task is to be done; empty where its outputs are up to date."""
    for name in outputs_of(run, task):
        if name not in run.manifest.artifacts:
            return [FIRST_TIME]
        if problem := run.problem(name):
            return [f"{name} {problem}"]
    return recipe.differences(run.manifest.artifacts[task.outputs[0]].recipe)


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
    recover(run.root)
    try:
        with pool(jobs) as processes:
            schedule = _Schedule(run, iter(plan), _InOrder(observer), processes)
            while schedule.goes_on():
                schedule.begin_what_is_ready()
                schedule.end_what_is_done()
            if schedule.failed is not None:
                raise schedule.failed[1]
    except BaseException:
        recover(run.root)
        raise
    return [schedule.statuses[number] for number in sorted(schedule.statuses)]


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

    def add(self, number: int, *events: Event | None) -> None:
        """Events of the task at a place of the plan; None behind the last of them."""
        self._waiting.setdefault(number, []).extend(events)
        while self._waiting.get(self._first):
            if (event := self._waiting[self._first].pop(0)) is None:
                del self._waiting[self._first]
                self._first += 1
            else:
                event(self._observer)

    def at_once(self, number: int, event: Event) -> None:
        """An event that is of no interest later, such as progress."""
        if number == self._first:
            event(self._observer)


@dataclass
class _Step:
    """A task under way: its raw files before they are read, the recipe of its outputs, its beginning [s]."""

    task: Task
    sources: dict[Path, Seen]
    recipe: Recipe
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
        self.failed: tuple[int, Exception] | None = None
        """Place and error of the first task of the plan that failed."""
        self.statuses: dict[int, TaskStatus] = {}
        """Tasks done and their reasons."""

    def goes_on(self) -> bool:
        """True if a task waits or runs, after the plan was read as far as it is known."""
        while self.failed is None and not (self._mark and self._mark.artifact in self._unfinished(self._read)):
            if (entry := next(self._plan, None)) is None:
                break
            if isinstance(entry, After):
                self._mark = entry
            else:
                self._waiting[self._read] = entry
                self._read += 1
        return bool(self._waiting) or any(self.failed is None or number < self.failed[0] for number in self._running)

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
        # its sources are looked at before they are hashed: what changes between the two is found
        step = _Step(task, seen(task), recipe_of(run, task), time.perf_counter())
        reasons = reasons_of(run, task, step.recipe)
        self.statuses[number] = TaskStatus(task.stage, task.title, task.outputs, reasons)
        if not reasons:
            self._events.add(number, lambda observer: observer.skipped(task), None)
            return
        self._events.add(number, lambda observer: observer.started(task, reasons))
        for name in outputs_of(run, task):
            if name in run.manifest.artifacts and run.problem(name) not in (None, "is missing"):
                run.set_aside(name)

        def on_progress(what: str, share: float) -> None:
            """Pass on how far the task is."""
            self._events.at_once(number, lambda observer: observer.progressed(task, what, share))

        self._running[number] = step
        place = run if self._processes.jobs == 1 else run.root
        self._processes.begin(number, partial(_perform, task, place), on_progress)

    def end_what_is_done(self) -> None:
        """Wait for running tasks, and commit what they have written."""
        for number, result in self._processes.finished() if self._running else ():
            step = self._running.pop(number)
            if self.failed is not None and self.failed[0] < number:
                continue
            try:
                written = result()
                check_sources(step.task, step.recipe, step.sources)
            except Exception as error:
                self.failed = (number, error)
                self._waiting = {earlier: task for earlier, task in self._waiting.items() if earlier < number}
            else:
                self._commit(number, step, written)

    def _commit(self, number: int, step: _Step, written: Mapping[str, Written]) -> None:
        self._run.commit(step.recipe, written)
        seconds = time.perf_counter() - step.began
        warnings = dict.fromkeys(text for made in written.values() for text in made.notes.get("warnings", ()))
        self._events.add(number, *(methodcaller("warned", step.task.title, text) for text in warnings))
        self._events.add(number, lambda observer: observer.finished(step.task, seconds), None)


def _perform(task: Task, place: RunFolder | Path, on_progress: OnProgress) -> Mapping[str, Written]:
    """Write the outputs of a task into a run: an open one, or in another process the one in this folder."""
    run = place if isinstance(place, RunFolder) else RunFolder.open(place)
    return task.work(run, on_progress) if task.reports else task.work(run)
