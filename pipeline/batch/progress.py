"""How far a batch is: what its journals and its runs show while its processes, here or elsewhere, go on."""

from collections import Counter
from collections.abc import Iterable
from dataclasses import dataclass
from datetime import UTC, datetime, timedelta
from pathlib import Path
from typing import Literal

from pipeline.batch.journal import Event, Journal, journals, latest
from pipeline.errors import DebistError, InputError
from pipeline.runs import layout
from pipeline.runs.lock import HOLDER, is_held
from pipeline.runs.manifest import MANIFEST, load_manifest

State = Literal["done", "running", "failed", "stopped", "waiting"]
STATES: dict[State, str] = {
    "done": "has its scores",
    "running": "a process holds its run",
    "failed": "its process ended with a reason",
    "stopped": "begun, and no process holds it; the same command goes on",
    "waiting": "not begun",
}
_STARTING = 60.0
"""Time [s] that a process may take from its start until it holds its run."""


@dataclass(frozen=True)
class Member:
    """One prototype of a batch: its state, why it failed, and when that was."""

    name: str
    state: State
    reason: str = ""
    since: datetime | None = None


@dataclass(frozen=True)
class FleetProgress:
    """How far a batch is.

    Attributes
    ----------
    members : tuple of Member
        In the order of the names.
    expected_end : datetime or None
        When the shards that have begun will be done, by the wall time of the prototypes so far; None where nothing
        runs or none is done.
    shards, begun : int
        How many shards there are, and how many have begun; 0 for a folder without journals.
    """

    members: tuple[Member, ...]
    expected_end: datetime | None = None
    shards: int = 0
    begun: int = 0

    @property
    def counts(self) -> dict[str, int]:
        """Prototypes by state."""
        counted = Counter(member.state for member in self.members)
        return {state: counted[state] for state in STATES}


def is_fleet(folder: Path) -> bool:
    """Whether a folder is no run but holds runs or the journals of a batch."""
    return (
        folder.is_dir()
        and not (folder / MANIFEST).exists()
        and (any(folder.glob("batch-*.jsonl")) or any(folder.glob(f"*/{MANIFEST}")))
    )


def fleet_progress(output: Path) -> FleetProgress:
    """How far the batch in a folder is, or what the runs in it are without one; it reads and hashes no artifact.

    Raises
    ------
    DebistError
        The folder or a journal cannot be read.
    """
    recorded, time = journals(output), datetime.now(UTC)
    events = latest(recorded)
    runs = {path.parent.name for path in output.glob(f"*/{MANIFEST}")}
    names = sorted(runs | set(events) | {name for journal in recorded for name in journal.plan.planned})
    if not names:
        raise InputError(f"{output}: holds neither runs nor the journal of a batch; name the DIR of `debist batch`")
    members = tuple(_member(output, name, events.get(name), time) for name in names)
    running = {member.name for member in members if member.state == "running"}
    ends = [end for journal in recorded if (end := _expected_end(journal, running, time))]
    of_newest = _newest(recorded)
    shards = of_newest[0].shard.of if of_newest else 0
    return FleetProgress(members, max(ends, default=None), shards, len(of_newest))


def _newest(recorded: Iterable[Journal]) -> list[Journal]:
    """The journals of the batch that was begun last: another one may have had another count of shards."""
    by_count: dict[int, list[Journal]] = {}
    for journal in recorded:
        by_count.setdefault(journal.shard.of, []).append(journal)
    return max(by_count.values(), key=_last_time, default=[])


def _last_time(recorded: Iterable[Journal]) -> float:
    return max((event.time.timestamp() for journal in recorded for event in journal.last.values()), default=0.0)


def _member(output: Path, name: str, event: Event | None, time: datetime) -> Member:
    run = output / name
    if (run / HOLDER).is_file() and is_held(run):  # the lock itself is tried only where a note says who may hold it
        return Member(name, "running", since=event.time if event else None)
    if event is None or event.state == "not started":
        return _without_event(run, name)
    if event.state == "failed":
        return Member(name, "failed", event.reason, event.time)
    if event.state != "started":
        return Member(name, "done", since=event.time)
    starting = time - event.time < timedelta(seconds=_STARTING)
    return Member(name, "running" if starting else "stopped", since=event.time)


def _without_event(run: Path, name: str) -> Member:
    """A run that no batch made, or none yet."""
    if not (run / MANIFEST).is_file():
        return Member(name, "waiting")
    try:
        return Member(name, "done" if layout.SCORES in load_manifest(run).artifacts else "stopped")
    except DebistError as error:
        return Member(name, "failed", str(error))


def _expected_end(journal: Journal, running: set[str], time: datetime) -> datetime | None:
    """When a shard will be done, if it goes on as before; runs that were up to date are left out of the estimate."""
    seconds = [event.seconds for event in journal.last.values() if event.state in ("done", "failed")]
    own = running & set(journal.plan.planned)
    if not seconds or not own:
        return None
    mean = sum(seconds) / len(seconds)
    begun = (time - journal.last[name].time for name in own if name in journal.last)
    spent = sum(min(mean, span.total_seconds()) for span in begun)
    ended = sum(event.state != "started" for event in journal.last.values())
    left = mean * (len(journal.plan.planned) - ended) - spent
    return time + timedelta(seconds=max(0.0, left) / min(journal.plan.jobs, len(own)))


def shard_notes(progress: FleetProgress) -> str:
    """That some shards have not begun; empty where all have, or where there is one only."""
    if progress.begun == progress.shards:
        return ""
    return f"{progress.begun} of {progress.shards} shards have begun; the others add prototypes and time"
