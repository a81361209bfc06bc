"""Batch: many prototypes, each in a process of its own, so that one failing or killed leaves the others alone."""

import csv
import difflib
import io
import math
import time
import tomllib
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from pipeline.batch.journal import JOURNAL, BatchObserver, Shard, failures, journal_of
from pipeline.batch.worker import Outcome, Program, Worker
from pipeline.errors import DebistError, InputError
from pipeline.isolation import next_ready, preload
from pipeline.loading.report_data import load_datasheet, load_scores
from pipeline.names import slug
from pipeline.plain_files import read_toml
from pipeline.reporting.fleet_report import fleet_report
from pipeline.reporting.fleet_table import Summary, failed, summary
from pipeline.reporting.tables import disarmed
from pipeline.runs import layout, schemas, tables
from pipeline.runs.atomic import make_folder, write_text
from pipeline.runs.manifest import MANIFEST
from pipeline.runs.outputs import note_written
from pipeline.runs.run_folder import RunFolder
from pipeline.runs.schemas import FLEET
from pipeline.settings import load_prototype

_FLEET_KEY = "prototypes"


def prototype_files(places: Sequence[Path]) -> list[Path]:
    """The settings files that are meant: files themselves, all ``*.toml`` of folders, the list of a fleet file.

    A fleet file is a TOML file with the single key ``prototypes``, a list of paths relative to it.

    Raises
    ------
    InputError
        A place that does not exist, a folder without settings files, or a fleet file with mistakes.
    """
    files: list[Path] = []
    for place in places:
        if place.is_dir():
            inside = sorted(place.glob("*.toml")) + sorted(place.glob("*/*.toml"))
            if not inside:
                raise InputError(f"{place}: holds no settings file (*.toml)")
            files += inside
        else:
            files += _fleet_members(place) or [place]
    return list(dict.fromkeys(path.resolve() for path in files))


def _fleet_members(place: Path) -> list[Path]:
    """What a fleet file lists; nothing for a settings file."""
    try:
        document = read_toml(place)
    except FileNotFoundError:
        raise InputError(f"{place}: no such file or folder") from None
    except (OSError, UnicodeDecodeError, tomllib.TOMLDecodeError):
        return []  # its own run will say what is wrong with it, and the others go on
    if _FLEET_KEY not in document:
        mistyped = difflib.get_close_matches(_FLEET_KEY, document)
        if mistyped and "name" not in document:
            raise InputError(f"{place}: unknown key {mistyped[0]!r}; did you mean {_FLEET_KEY!r}?")
        return []
    members = document[_FLEET_KEY]
    is_list = isinstance(members, list) and members and all(isinstance(member, str) for member in members)
    if set(document) != {_FLEET_KEY} or not is_list:
        raise InputError(
            f"{place}: a fleet file holds the key {_FLEET_KEY!r} alone, a list of paths such as ['P1.toml']"
        )
    paths = [place.parent / member for member in members]
    for path in paths:
        if path.is_dir():
            raise InputError(f"{place}: {path} is a folder; list settings files, or give the folder to the command")
    return paths


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
    named: Sequence[tuple[str, Path]],
    output: Path,
    observer: BatchObserver,
    program: Program,
    execution: Execution,
    shard: Shard | None = None,
) -> list[Outcome]:
    """Run every prototype; what is up to date costs a check only.

    Parameters
    ----------
    named : sequence of (str, Path)
        Names and settings files, as `named_prototypes` gives them.
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

    Notes
    -----
    Cost: that of the runs, and once 2 s of processor time for the imports where processes are forked (Linux),
    elsewhere as much for each; for a prototype that is up to date some milliseconds and the hashing of its files.
    """
    make_folder(output)
    preload(["pipeline.batch.preloaded", program.__module__])
    own = [(name, path) for name, path in named if shard is None or shard.holds(name)]
    options = () if execution.report else ("--no-report",)

    def begin(name: str, prototype: Path) -> "Worker | None":
        """Its process; None where none is needed."""
        if _is_up_to_date(prototype, output / name, execution.report):
            return None
        return Worker(program, name, prototype, output, options, time_limit=execution.time_limit)

    with journal_of(output, shard or Shard(), [name for name, _ in own], execution.jobs, observer) as journal:
        outcomes = _run_all(own, journal, begin, execution)
    if shard is None:
        write_fleet(output, outcomes)
    return sorted(outcomes, key=lambda outcome: outcome.name)


def _run_all(
    named: Sequence[tuple[str, Path]],
    observer: BatchObserver,
    begin: Callable[[str, Path], Worker | None],
    execution: Execution,
) -> list[Outcome]:
    """The outcome of each, in the order in which they ended."""
    waiting, outcomes, running = list(named), list[Outcome](), list[Worker]()
    first_failed = ""
    try:
        while waiting or running:
            while waiting and len(running) < execution.jobs:
                name, prototype = waiting.pop(0)
                observer.started(name)
                began = time.perf_counter()
                if (worker := begin(name, prototype)) is not None:
                    running.append(worker)
                else:
                    outcomes.append(Outcome(name, prototype, 0, "", time.perf_counter() - began))
                    observer.finished(outcomes[-1])
            if running:
                ready = next_ready(running)
                with ready:
                    outcomes.append(ready.outcome())
                running.remove(ready)
                observer.finished(outcomes[-1])
            if execution.fail_fast and outcomes and outcomes[-1].failed:
                first_failed = first_failed or outcomes[-1].name
                outcomes += [_not_started(name, path, first_failed) for name, path in waiting]
                waiting.clear()
    finally:
        for worker in running:
            worker.__exit__()
    return outcomes


def _is_up_to_date(prototype: Path, run: Path, report: bool) -> bool:
    """Whether a prototype needs no process, which saves its start."""
    if not (run / MANIFEST).is_file():
        return False
    from pipeline.stages.run import is_up_to_date  # a second of imports, which a new fleet does not need here

    return is_up_to_date(prototype, run, with_report=report)


def _not_started(name: str, prototype: Path, first_failed: str) -> Outcome:
    return Outcome(name, prototype, None, f"not started: {first_failed} failed, and --fail-fast was given")


def collect_batch(named: Sequence[tuple[str, Path]], output: Path) -> list[Outcome]:
    """Write the fleet tables from the runs that are there, running nothing."""
    outcomes = existing_outcomes(named, output)
    make_folder(output)
    write_fleet(output, outcomes)
    return sorted(outcomes, key=lambda outcome: outcome.name)


def named_prototypes(prototypes: Sequence[Path]) -> list[tuple[str, Path]]:
    """The prototypes with the names that decide their run folders.

    Raises
    ------
    InputError
        Two prototypes of one name, capitals aside, or one that is named as a file of the fleet.
    """
    named: dict[str, Path] = {}
    for path in prototypes:
        try:
            name = load_prototype(path).folder
        except DebistError:
            name = slug(path.stem)  # its own run fails with the reason
        if name.casefold() in (*FLEET_FILES, "settings") or JOURNAL.fullmatch(name.casefold()):
            raise InputError(f"{path}: {name!r} is the name of a file of the fleet; name the prototype otherwise")
        for other in named:
            if name.casefold() == other.casefold():
                alike = "" if name == other else f" ({other!r}, which some disks take for the same)"
                raise InputError(
                    f"{path}: a second prototype is named {name!r}{alike} after {named[other]}; names decide the run "
                    "folders, change one"
                )
        named[name] = path
    return list(named.items())


FLEET_TABLE = "fleet.parquet"
FLEET_CSV = "fleet.csv"
FLEET_REPORT = "fleet.html"
FLEET_FILES = (FLEET_TABLE, FLEET_CSV, FLEET_REPORT)


def write_fleet(output: Path, outcomes: Iterable[Outcome]) -> None:
    """Tables and page of a fleet, in the order of the names; nothing in them depends on times or processes."""
    ordered = sorted(outcomes, key=lambda outcome: outcome.name)
    write_fleet_tables(output, ordered)
    write_fleet_report(output, [(outcome.name, outcome.reason) for outcome in ordered])
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
    columns = {column.key: [row[column.key] for row in rows] for column in FLEET.columns}
    tables.write_table(output / FLEET_TABLE, FLEET, columns)
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(columns)
    writer.writerows([disarmed(value) for value in row] for row in zip(*columns.values(), strict=True))
    write_text(output / FLEET_CSV, text.getvalue())


def existing_outcomes(named: Sequence[tuple[str, Path]], output: Path) -> list[Outcome]:
    """What the runs in a folder hold already, without running anything.

    A prototype has failed if the journals there end with its failure, or if it has no scores.
    """
    failed_last, outcomes = failures(output) if output.is_dir() else {}, []
    for name, prototype in named:
        try:
            event = failed_last.get(name)
            if event is None:
                load_scores(output / name)
            outcomes.append(Outcome(name, prototype, event.exit_code if event else 0, event.reason if event else ""))
        except DebistError as error:
            outcomes.append(Outcome(name, prototype, error.exit_code, str(error)))
    return outcomes


def write_fleet_report(output: Path, outcomes: Iterable[tuple[str, str]]) -> Path:
    """Write ``fleet.html`` into the folder of a batch.

    Parameters
    ----------
    output : Path
        Folder that holds one run folder per prototype.
    outcomes : iterable of (name, reason)
        Prototypes in order; the reason is empty for one that did not fail.
    """
    members = (_member(output, name, reason) for name, reason in outcomes)  # a datasheet has 20 kB: one at a time
    page = fleet_report(members, output.resolve().name)
    target = output / FLEET_REPORT
    write_text(target, page)
    return target


def _member(output: Path, name: str, reason: str) -> Summary:
    if reason:
        return failed(name, reason)
    try:
        held = RunFolder.open(output / name).manifest.artifacts
        document = load_datasheet(output / name) if layout.DATASHEET in held else _scores_alone(output / name)
        paged = layout.REPORT in held
    except DebistError as error:
        return failed(name, str(error))
    return summary(name, document, f"{name}/{layout.REPORT}" if paged else None)


def _scores_alone(run: Path) -> dict[str, Any]:
    """Entries of the page for a run without a datasheet: errors, without facts or a verdict."""
    scores = load_scores(run)
    judged = next((row["model"] for row in scores if row["headline"]), scores[0]["model"])
    return {"scores": scores, "judged_model": judged, "facts": [], "verdict": {"data": "", "model": ""}}
