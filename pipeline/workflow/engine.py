"""Bring artifacts up to date: content decides what is done again, and every redo has its reason."""

import time
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
from difflib import get_close_matches
from pathlib import Path
from typing import Any, Protocol

from ..errors import InputError
from ..store.hashing import file_sha256
from ..store.manifest import Recipe
from ..store.run_folder import RunFolder, Written

_TICK = 2_000_000_000
"""Nanoseconds; the coarsest clock by which a file system notes changes."""

FIRST_TIME = "first time"
"""The reason to make what was never made."""


@dataclass(frozen=True)
class Task:
    """One step of a stage: what it reads, what it writes, and what decides the result.

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
        Where the settings name them.
    outputs : tuple of str
        Names of the artifacts it always writes; it may write more where the data ask for it.
    work : callable
        Writes the outputs into the run that it is given, and returns them by name.
    reports : bool
        Whether `work` also takes a callable (current step, share done) that reports its progress.
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
        """These tasks are to come, named by their stages, up-to-date ones too."""

    def started(self, task: Task, reasons: list[str]) -> None:
        """The task is being done, for these reasons."""

    def progressed(self, task: Task, what: str, share: float) -> None:
        """How far a task that reports has come."""

    def finished(self, task: Task, seconds: float) -> None:
        """The task is done."""

    def skipped(self, task: Task) -> None:
        """The task's outputs are up to date."""

    def warned(self, what: str, warning: str) -> None:
        """Something about a task's data, by its title, or about an artifact deserves a look."""


class Unheard:
    """An observer that reports nothing."""

    def planned(self, stages: Sequence[str]) -> None:
        """Say nothing."""

    def started(self, task: Task, reasons: list[str]) -> None:
        """Say nothing."""

    def progressed(self, task: Task, what: str, share: float) -> None:
        """Say nothing."""

    def finished(self, task: Task, seconds: float) -> None:
        """Say nothing."""

    def skipped(self, task: Task) -> None:
        """Say nothing."""

    def warned(self, what: str, warning: str) -> None:
        """Print nothing: the notes of the artifacts hold the warnings."""


@dataclass(frozen=True)
class TaskStatus:
    """Whether a task's outputs are up to date, and if not, why."""

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
    """What a run would redo and why, without doing it; what hangs on a stale input is stale too."""
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
    """What decides the outputs of a task, with the content of its inputs of today."""
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
    """That a raw log or table of a task is not there."""
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
            identity = (stat.st_dev, stat.st_ino, stat.st_size, stat.st_mtime_ns, stat.st_ctime_ns)
            states[path] = Seen(identity, time.time_ns() - max(stat.st_ctime_ns, stat.st_mtime_ns) < _TICK)
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
        now = after.get(path)
        same = was is not None and now is not None and was.identity == now.identity
        if same and was is not None and was.recent:
            same = file_sha256(path) == recipe.inputs[name]
        if not same:
            raise InputError(f"{path}: was changed while it was read; wait until it is complete and run again")


def outputs_of(run: RunFolder, task: Task) -> list[str]:
    """The declared outputs, and what was written beside them because of the data."""
    first = run.manifest.artifacts.get(task.outputs[0])
    beside = [name for name, record in run.manifest.artifacts.items() if first and record.recipe == first.recipe]
    return list(dict.fromkeys((*task.outputs, *beside)))


def reasons_of(run: RunFolder, task: Task, recipe: Recipe) -> list[str]:
    """Why a task is to be done; empty where its outputs are up to date."""
    for name in outputs_of(run, task):
        if name not in run.manifest.artifacts:
            return [FIRST_TIME]
        problem = run.problem(name)
        if problem:
            return [f"{name} {problem}"]
    return recipe.differences(run.manifest.artifacts[task.outputs[0]].recipe)
