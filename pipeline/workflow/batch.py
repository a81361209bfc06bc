"""Batch: many prototypes, each in a process of its own, and the tables and page of the fleet."""

import csv
import io
import itertools
import math
import sys
import time
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Protocol

from ..errors import DebistError, RunLockedError
from ..reporting.fleet_report import Summary, fleet_report, summary
from ..reporting.tables import disarmed
from ..store import layout, schemas, tables
from ..store.atomic import run_lock, write_text, writing
from ..store.manifest import MANIFEST
from ..store.outputs import note_written
from ..store.run_folder import RunFolder
from ..system.isolation import Isolated, Send, death, largest_memory, next_ready, preload
from ..system.machine import claim_room
from ..system.package import full_name
from .members import FLEET_CSV, FLEET_FACTS, FLEET_FILES, FLEET_REPORT, FLEET_TABLE, Member, Shard
from .progress import failure, failure_file, forget_failure, keep_failure
from .report_data import load_datasheet, load_scores

Program = Callable[[list[str]], object]

ROOM = 2**30
"""Address space [bytes] that the imports of a run's process need."""


@dataclass(frozen=True)
class Outcome:
    """Outcome of one prototype in a batch.

    Attributes
    ----------
    name : str
        Name of the prototype; its run lies under that name.
    prototype : Path
        Its settings file.
    exit_code : int or None
        Of its process; negative if a signal ended it, None if it was not started.
    reason : str
        Cause of its failure, or reason why it was not started, one line; empty if it did well.
    seconds : float
        Wall time.
    processor_seconds : float
        Processor time of the process, without its readers of logs; 0 for one that was killed.
    memory_bytes : int
        Its largest resident memory; 0 for one that was killed, and where the system does not count it (Windows).
    """

    name: str
    prototype: Path
    exit_code: int | None
    reason: str
    seconds: float = 0.0
    processor_seconds: float = 0.0
    memory_bytes: int = 0

    @property
    def failed(self) -> bool:
        """True if it was started and did not end well."""
        return self.exit_code not in (0, None)


class Worker(Isolated):
    """A prototype on its way in a process of its own.

    Parameters
    ----------
    program : callable
        The command ``debist`` with a list of arguments, a function of a module.
    name, prototype, output
        The run of the settings file `prototype` goes into the folder `name` of `output`.
    options : sequence of str
        More options of ``debist run``.
    time_limit : float
        Wall time [s] after which it is killed.
    """

    def __init__(
        self,
        program: Program,
        name: str,
        prototype: Path,
        output: Path,
        options: Sequence[str] = (),
        *,
        time_limit: float = math.inf,
    ) -> None:
        self.name = name
        self._prototype = prototype
        self._output = output
        self._time_limit = time_limit
        self._began = time.perf_counter()
        command = ["run", str(prototype), "-o", str(output / name), "--json", "-q", "--jobs", "1", *options]
        super().__init__(_run, program, command, time_limit=time_limit)

    def outcome(self) -> Outcome:
        """Wait for the end."""
        messages = list(self)
        answer = messages[-1] if messages else {}
        code = answer["exit_code"] if answer else self.exit_code()
        printed = self.words()
        late = f"stopped after the time limit of {self._time_limit:g} s; raise --time-limit, the same command goes on"
        reason = late if self.late else reason_of(code, printed)
        if code not in (0, RunLockedError.exit_code):  # a locked run is another process's
            keep_failure(self._output, self.name, code, reason, printed)
            if code == 1:
                reason = f"{reason}; its traceback is in {failure_file(self._output, self.name)}"
        return Outcome(
            name=self.name,
            prototype=self._prototype,
            exit_code=code,
            reason=reason,
            seconds=time.perf_counter() - self._began,
            processor_seconds=answer.get("processor_seconds", 0.0),
            memory_bytes=answer.get("memory_bytes", 0),
        )


def _run(send: Send, program: Program, command: list[str]) -> None:
    """Run the command in the process, and send its exit code and its cost."""
    code = 0
    try:
        program(command)
    except SystemExit as end:
        code = end.code if isinstance(end.code, int) else int(end.code is not None)
        if isinstance(end.code, str):
            sys.stderr.write(end.code + "\n")
    sys.stderr.flush()
    send({"exit_code": code, "processor_seconds": time.process_time(), "memory_bytes": largest_memory()})


def reason_of(exit_code: int, stderr: str) -> str:
    """Cause of the failure of a process with this exit code and standard error; empty if it did not fail."""
    if exit_code == 0:
        return ""
    if exit_code < 0:
        return f"ended by {death(exit_code)}; what is written is whole, and the same command goes on"
    lines = [line for line in stderr.splitlines() if line.strip()]
    if exit_code == 1:  # a traceback ends with the exception
        own = [line for line in lines if not line.startswith(("debist: ", "warning: "))]
        return f"a bug of debist: {own[-1].strip()}" if own else death(1)
    errors = [number for number, line in enumerate(lines) if line.startswith("debist: ")]
    if not errors:
        return (lines or [death(exit_code)])[-1]
    more = list(itertools.takewhile(lambda line: line.startswith("  "), lines[errors[-1] + 1 :]))
    return (
        lines[errors[-1]].removeprefix("debist: ") + (": " if more else "") + "; ".join(line.strip() for line in more)
    )


class BatchObserver(Protocol):
    """Notified how a batch goes; the command shows it."""

    def started(self, name: str) -> None:
        """A prototype's process is about to start."""

    def finished(self, outcome: Outcome) -> None:
        """A prototype is done, or failed."""


@dataclass(frozen=True)
class Execution:
    """Settings for the execution of a batch.

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
    Cost: that of the runs, and 2 s of processor time for the imports: once where processes are forked (Linux),
    elsewhere for each. A prototype that is up to date costs some milliseconds and the hashing of its files.
    """
    claim_room(ROOM)
    with writing(output):
        output.mkdir(parents=True, exist_ok=True)
    preload([full_name("workflow.preloaded"), program.__module__])

    def begin(member: Member) -> "Worker | None":
        """Process of the prototype; None where none is needed."""
        forget_failure(output, member.name)
        if _is_up_to_date(member.settings, output / member.name, execution.report):
            return None
        options = () if execution.report else ("--no-report",)
        return Worker(program, member.name, member.settings, output, options, time_limit=execution.time_limit)

    part = shard or Shard()
    with run_lock(output, part.lock):
        own = [member for member in members if part.holds(member.name)]
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
                reason = f"not started: {first_failed} failed, and --fail-fast was given"
                outcomes += [Outcome(member.name, member.settings, None, reason) for member in waiting]
                waiting.clear()
    finally:
        for worker in running:
            worker.__exit__()
    return outcomes


def _is_up_to_date(prototype: Path, run: Path, report: bool) -> bool:
    """True if a prototype needs no process, which saves its start."""
    if not (run / MANIFEST).is_file():
        return False
    from .run import is_up_to_date  # a second of imports, which a new fleet does not need here

    return is_up_to_date(prototype, run, with_report=report)


def collect_batch(members: Sequence[Member], output: Path) -> list[Outcome]:
    """Write the fleet tables from the runs that are there, running nothing."""
    outcomes = [_existing(member, output) for member in members]
    write_fleet(output, outcomes)
    return sorted(outcomes, key=lambda outcome: outcome.name)


def write_fleet(output: Path, outcomes: Iterable[Outcome]) -> None:
    """Tables and page of a fleet, in the order of the names; nothing in them depends on times or processes."""
    ordered = sorted(outcomes, key=lambda outcome: outcome.name)
    write_fleet_tables(output, ordered)
    summaries = [_member(output, outcome.name, outcome.reason) for outcome in ordered]
    facts = [(member.name, key, value, unit) for member in summaries for key, (value, unit) in member.facts.items()]
    columns = {column.key: [fact[k] for fact in facts] for k, column in enumerate(schemas.FLEET_FACTS.columns)}
    tables.write_pieces(output / FLEET_FACTS, schemas.FLEET_FACTS, [columns])
    write_text(output / FLEET_REPORT, fleet_report(summaries, output.resolve().name))
    note_written(output, FLEET_FILES, "batch")


def write_fleet_tables(output: Path, outcomes: Iterable[Outcome]) -> None:
    """The scores of all prototypes in one table, Parquet and CSV; one that failed has a row with the reason."""
    rows: list[dict[str, Any]] = []
    for outcome in outcomes:
        head = {"prototype": outcome.name, "exit_code": outcome.exit_code, "reason": outcome.reason}
        try:
            scores = load_scores(output / outcome.name) if outcome.exit_code == 0 else [{}]
        except DebistError as error:  # changed or damaged since it ended well
            scores, head = [{}], head | {"exit_code": error.exit_code, "reason": str(error)}
        rows += [{column.key: None for column in schemas.SCORES.columns} | score | head for score in scores]
    columns = {column.key: [row[column.key] for row in rows] for column in schemas.FLEET.columns}
    tables.write_pieces(output / FLEET_TABLE, schemas.FLEET, [columns])
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(columns)
    writer.writerows([disarmed(value) for value in row] for row in zip(*columns.values(), strict=True))
    write_text(output / FLEET_CSV, text.getvalue())


def _existing(member: Member, output: Path) -> Outcome:
    if (failed := failure(output, member.name)) is not None:
        return Outcome(member.name, member.settings, failed.exit_code, failed.reason)
    try:
        load_scores(output / member.name)
    except DebistError as error:
        return Outcome(member.name, member.settings, error.exit_code, str(error))
    return Outcome(member.name, member.settings, 0, "")


def _member(output: Path, name: str, reason: str) -> Summary:
    if reason:
        return Summary(name, reason)
    try:
        held = RunFolder.open(output / name).manifest.artifacts
        document = load_datasheet(output / name) if layout.DATASHEET in held else _scores_alone(output / name)
    except DebistError as error:
        return Summary(name, str(error))
    return summary(name, document, f"{name}/{layout.REPORT}" if layout.REPORT in held else None)


def _scores_alone(run: Path) -> dict[str, Any]:
    """Entries of the page for a run without a datasheet: errors, without facts or an assessment."""
    scores = load_scores(run)
    judged = next((row["model"] for row in scores if row["headline"]), scores[0]["model"])
    return {"scores": scores, "judged_model": judged, "facts": [], "verdict": {"data": "", "model": ""}}
