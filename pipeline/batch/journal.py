"""Journal of a batch: what it was given to run and how each prototype went, one line of JSON for each event.

Every shard of a batch writes a journal of its own beside the runs, so that others can look on while it works.
"""

import re
from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path
from typing import Literal, NamedTuple, Protocol

from pydantic import AwareDatetime, BaseModel, ConfigDict, ValidationError

from pipeline.batch.worker import Outcome
from pipeline.errors import CorruptArtifactError, InputError
from pipeline.names import part_holds, part_of
from pipeline.runs.atomic import not_written, reading, refuse_link
from pipeline.runs.manifest import MANIFEST

JOURNAL = re.compile(r"batch-([1-9]\d*)-of-([1-9]\d*)\.jsonl")
"""Names of journals; the numbers are shard and count of shards."""

State = Literal["started", "done", "up to date", "failed", "not started"]


class Shard(NamedTuple):
    """One of `of` parts of a fleet, counted from 1."""

    number: int = 1
    of: int = 1

    @classmethod
    def parse(cls, text: str) -> "Shard":
        """The shard that a text such as ``3/100`` names.

        Raises
        ------
        InputError
            It names none.
        """
        if (part := part_of(text)) is None:
            raise InputError(f"--shard {text}: write number/count such as 3/100; the numbers count from 1")
        return cls(*part)

    def holds(self, name: str) -> bool:
        """Whether the shard holds the prototype `name`, which depends on no other name."""
        return part_holds(self.number, self.of, name)

    @property
    def journal(self) -> str:
        """Name of its journal."""
        return f"batch-{self.number}-of-{self.of}.jsonl"


class BatchObserver(Protocol):
    """Told how a batch goes; the command shows it."""

    def started(self, name: str) -> None:
        """A prototype's process is about to start."""

    def finished(self, outcome: Outcome) -> None:
        """A prototype is done, or failed."""


class _Line(BaseModel):
    model_config = ConfigDict(frozen=True, extra="ignore", allow_inf_nan=False)


class Plan(_Line):
    """First line of a journal: names of the prototypes, and processes at a time."""

    planned: tuple[str, ...]
    jobs: int


class Event(_Line):
    """Any later line: what happened to a prototype.

    Attributes
    ----------
    time : datetime
        When, UTC.
    name : str
        The prototype.
    state : str
        What it came to.
    exit_code : int or None
        Of its process.
    reason : str
        Why it failed or was not started.
    seconds : float
        Wall time that it took.
    """

    time: AwareDatetime
    name: str
    state: State
    exit_code: int | None = None
    reason: str = ""
    seconds: float = 0.0


@dataclass(frozen=True)
class Journal:
    """What a journal holds: the plan, and the last event of each prototype that has begun."""

    shard: Shard
    plan: Plan
    last: dict[str, Event]


def state_of(outcome: Outcome) -> State:
    """What a prototype came to; up to date is one for which no process had to start."""
    if outcome.exit_code is None:
        return "not started"
    if outcome.failed:
        return "failed"
    return "done" if outcome.processor_seconds else "up to date"


class _Writing:
    """An observer that writes each event down before it passes it on."""

    def __init__(self, path: Path, names: Sequence[str], jobs: int, then: BatchObserver) -> None:
        self._then = then
        try:
            refuse_link(path)
            self.stream = path.open("w", encoding="utf-8", newline="\n")
        except OSError as error:
            raise not_written(path, error) from error
        self._path, self._begun = path, set[str]()
        self._write(Plan(planned=tuple(names), jobs=jobs))

    def started(self, name: str) -> None:
        self._begun.add(name)
        self._write(Event(time=datetime.now(UTC), name=name, state="started"))
        self._then.started(name)

    def finished(self, outcome: Outcome) -> None:
        self._begun.discard(outcome.name)
        self._write(
            Event(
                time=datetime.now(UTC), name=outcome.name, state=state_of(outcome), exit_code=outcome.exit_code,
                reason=outcome.reason, seconds=outcome.seconds,
            )
        )  # fmt: skip
        self._then.finished(outcome)

    def close(self) -> None:
        """Close the journal; what was begun and has not ended was stopped with the batch."""
        with self.stream:
            for name in sorted(self._begun):
                self._write(Event(time=datetime.now(UTC), name=name, state="not started"))

    def _write(self, line: _Line) -> None:
        try:
            self.stream.write(line.model_dump_json() + "\n")
            self.stream.flush()
        except OSError as error:
            raise not_written(self._path, error) from error


@contextmanager
def journal_of(output: Path, shard: Shard, names: Sequence[str], jobs: int, then: BatchObserver) -> Iterator[_Writing]:
    """An observer that keeps the journal of a shard in the folder `output`, which is there; `then` gets the same calls.

    Raises
    ------
    InputError
        The disk does not take it.
    """
    observer = _Writing(output / shard.journal, names, jobs, then)
    try:
        yield observer
    finally:
        observer.close()


def journals(output: Path) -> list[Journal]:
    """The journals in the folder of a batch, in the order of the shards.

    Raises
    ------
    InputError
        The folder or a journal cannot be read.
    CorruptArtifactError
        A journal holds something else.
    """
    with reading(output):
        named = [(Shard(*map(int, match.groups())), path) for path in output.iterdir() if (match := _named(path))]
        return [_read(path, shard) for shard, path in sorted(named)]


def _named(path: Path) -> re.Match[str] | None:
    return JOURNAL.fullmatch(path.name)


def _read(path: Path, shard: Shard) -> Journal:
    lines = path.read_bytes().split(b"\n")[:-1]  # behind the last line feed stands what is being written
    try:
        plan = Plan.model_validate_json(lines[0] if lines else b"{}")
        events = [Event.model_validate_json(line) for line in lines[1:]]
    except ValidationError as error:
        raise CorruptArtifactError(
            f"{path}: is no journal of a batch ({error.errors()[0]['msg']}); delete it, `debist batch` writes a new one"
        ) from None
    return Journal(shard, plan, {event.name: event for event in events})


def latest(records: Iterable[Journal]) -> dict[str, Event]:
    """The last event of each prototype that has begun, whichever journal holds it."""
    events = sorted((event for journal in records for event in journal.last.values()), key=lambda event: event.time)
    return {event.name: event for event in events}


def failures(output: Path) -> dict[str, Event]:
    """The prototypes that failed last, and whose runs nothing was written into since."""
    return {
        name: event
        for name, event in latest(journals(output)).items()
        if event.state == "failed" and _changed(output / name) <= event.time.timestamp()
    }


def _changed(run: Path) -> float:
    """When the manifest of a run was written [s since the epoch]; 0 where there is none."""
    manifest = run / MANIFEST
    return manifest.stat().st_mtime if manifest.is_file() else 0.0
