"""Batch: many prototypes, each in a process of its own, so that one failing or killed leaves the others alone."""

import math
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Protocol

from ..store.atomic import make_folder
from ..store.lock import run_lock
from ..store.manifest import MANIFEST
from ..system.isolation import next_ready, preload
from ..system.package import full_name
from .fleet import write_fleet
from .members import Member, Shard
from .progress import forget_failure
from .worker import Outcome, Program, Worker


class BatchObserver(Protocol):
    """Notified how a batch goes; the command shows it."""

    def started(self, name: str) -> None:
        """A prototype's process is about to start."""

    def finished(self, outcome: Outcome) -> None:
        """A prototype is done, or failed."""


@dataclass(frozen=True)
class Execution:
    """How the runs of a batch are executed.

    Attributes
    ----------
    jobs : int
        Processes at a time; results do not depend on it.
    report : bool
        Make each prototype's report; the tables and the page of the fleet are written anyway.
    fail_fast : bool
        Start no more after the first failure; those left out have an exit code of None.
    time_limit : float
        Wall time [s] after which a prototype's process is killed; it has failed then, and the others go on.
    """

    jobs: int = 1
    report: bool = True
    fail_fast: bool = False
    time_limit: float = math.inf


def run_batch(
    members: Sequence[Member],
    output: Path,
    observer: BatchObserver,
    program: Program,
    execution: Execution,
    shard: Shard | None = None,
) -> list[Outcome]:
    """Run every prototype; what is up to date costs a check only.

    Parameters
    ----------
    members : sequence of Member
        The prototypes.
    output : Path
        Gets one run folder per prototype, and the fleet tables.
    observer : BatchObserver
        Notified of each start and end.
    program : callable
        The command ``debist`` with a list of arguments, a function of a module; each process runs it.
    execution : Execution
        Number of processes, time limit, and what a failure stops.
    shard : Shard, optional
        Run the prototypes of this shard only, and leave the tables of the fleet to `collect_batch`.

    Returns
    -------
    list of Outcome
        In the order of the names.

    Raises
    ------
    RunLockedError
        Another batch, or the same shard, works on the folder.

    Notes
    -----
    Cost: that of the runs, and once 2 s of processor time for the imports where processes are forked (Linux),
    elsewhere as much for each; for a prototype that is up to date some milliseconds and the hashing of its files.
    """
    make_folder(output)
    preload([full_name("workflow.preloaded"), program.__module__])
    own = [member for member in members if shard is None or shard.holds(member.name)]
    options = () if execution.report else ("--no-report",)

    def begin(member: Member) -> "Worker | None":
        """Its process; None where none is needed."""
        forget_failure(output, member.name)
        if _is_up_to_date(member.settings, output / member.name, execution.report):
            return None
        return Worker(program, member.name, member.settings, output, options, time_limit=execution.time_limit)

    with run_lock(output, (shard or Shard()).lock):
        outcomes = _run_all(own, observer, begin, execution)
        if shard is None:
            write_fleet(output, outcomes)
    return sorted(outcomes, key=lambda outcome: outcome.name)


def _run_all(
    members: Sequence[Member],
    observer: BatchObserver,
    begin: Callable[[Member], Worker | None],
    execution: Execution,
) -> list[Outcome]:
    """The outcome of each, in the order in which they ended."""
    waiting = list(members)
    outcomes: list[Outcome] = []
    running: list[Worker] = []
    first_failed = ""
    try:
        while waiting or running:
            while waiting and len(running) < execution.jobs:
                member = waiting.pop(0)
                observer.started(member.name)
                began = time.perf_counter()
                if (worker := begin(member)) is not None:
                    running.append(worker)
                else:
                    outcomes.append(Outcome(member.name, member.settings, 0, "", time.perf_counter() - began))
                    observer.finished(outcomes[-1])
            if running:
                ready = next_ready(running)
                with ready:
                    outcomes.append(ready.outcome())
                running.remove(ready)
                observer.finished(outcomes[-1])
            if execution.fail_fast and outcomes and outcomes[-1].failed:
                first_failed = first_failed or outcomes[-1].name
                outcomes += [_not_started(member, first_failed) for member in waiting]
                waiting.clear()
    finally:
        for worker in running:
            worker.__exit__()
    return outcomes


def _is_up_to_date(prototype: Path, run: Path, report: bool) -> bool:
    """Whether a prototype needs no process, which saves its start."""
    if not (run / MANIFEST).is_file():
        return False
    from .run import is_up_to_date  # a second of imports, which a new fleet does not need here

    return is_up_to_date(prototype, run, with_report=report)


def _not_started(member: Member, first_failed: str) -> Outcome:
    return Outcome(member.name, member.settings, None, f"not started: {first_failed} failed, and --fail-fast was given")
