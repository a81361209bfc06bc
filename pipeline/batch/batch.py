"""Batch: many prototypes, each in a process of its own, so that one failing or killed leaves the others alone."""

import difflib
import math
import time
import tomllib
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path

from pipeline.batch.fleet import FLEET_FILES, existing_outcomes, write_fleet
from pipeline.batch.journal import JOURNAL, BatchObserver, Shard, journal_of
from pipeline.batch.worker import Outcome, Program, Worker
from pipeline.errors import DebistError, InputError
from pipeline.isolation import next_ready, preload
from pipeline.names import slug
from pipeline.plain_files import read_toml
from pipeline.runs.atomic import make_folder
from pipeline.runs.manifest import MANIFEST
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
    preload([program.__module__, "pipeline.batch.preloaded"])
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
