"""Batch: many prototypes, each in a process of its own, so that one failing or killed leaves the others alone."""

import csv
import io
import os
import subprocess
import sys
import time
import tomllib
from collections.abc import Callable, Iterable, Sequence
from concurrent.futures import FIRST_COMPLETED, Future, ThreadPoolExecutor, wait
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from pipeline.artifacts import schemas, tables
from pipeline.artifacts.atomic import write_text
from pipeline.artifacts.schemas import FLEET
from pipeline.errors import DebistError, InputError
from pipeline.settings import load_prototype
from pipeline.stages.fleet_report import write_fleet_report
from pipeline.stages.scores import load_scores

FLEET_TABLE = "fleet.parquet"
FLEET_CSV = "fleet.csv"


@dataclass(frozen=True)
class Outcome:
    """How one prototype went.

    Attributes
    ----------
    name : str
        Name of the prototype; its run lies under that name.
    prototype : Path
        Its settings file.
    exit_code : int
        Of its process; negative if a signal ended it.
    reason : str
        Why it failed, one line; empty if it did not.
    seconds : float
        Wall time.
    """

    name: str
    prototype: Path
    exit_code: int
    reason: str
    seconds: float


def collect(places: Sequence[Path]) -> list[Path]:
    """The settings files that are meant: files themselves, all ``*.toml`` of folders, the list of a fleet file.

    A fleet file is a TOML file with the single key ``prototypes``, a list of paths relative to it.

    Raises
    ------
    InputError
        A place that does not exist, a folder without settings files, or a fleet file that is none.
    """
    found: list[Path] = []
    for place in places:
        if place.is_dir():
            inside = sorted(place.glob("*.toml")) + sorted(place.glob("*/*.toml"))
            if not inside:
                raise InputError(f"{place}: holds no settings file (*.toml)")
            found += inside
        else:
            found += _fleet_members(place) or [place]
    return list(dict.fromkeys(path.resolve() for path in found))


def _fleet_members(place: Path) -> list[Path]:
    try:
        document = tomllib.loads(place.read_text(encoding="utf-8"))
    except FileNotFoundError:
        raise InputError(f"{place}: no such file or folder") from None
    except (OSError, UnicodeDecodeError, tomllib.TOMLDecodeError):
        return []  # its own run will say what is wrong with it, and the others go on
    members = document.get("prototypes")
    if members is None:
        return []
    if set(document) != {"prototypes"} or not all(isinstance(member, str) for member in members):
        raise InputError(f"{place}: a fleet file holds the key 'prototypes' alone, a list of paths")
    return [place.parent / member for member in members]


def run_batch(
    prototypes: Sequence[Path],
    output: Path,
    jobs: int,
    finished: Callable[[Outcome, int, int], None],
    *,
    fail_fast: bool,
) -> list[Outcome]:
    """Run every prototype; what is up to date costs a check only.

    Parameters
    ----------
    prototypes : sequence of Path
        Settings files.
    output : Path
        Gets one run folder per prototype, and the fleet tables.
    jobs : int
        Processes at a time.
    finished : callable
        Called with each outcome, the number done, and the number of all.
    fail_fast : bool
        Start no more after the first failure.

    Raises
    ------
    InputError
        Two prototypes of one name.

    Notes
    -----
    Cost: that of the runs, plus about 0.3 s of processor time each for the start of a process.
    """
    names = _names(prototypes)
    output.mkdir(parents=True, exist_ok=True)
    outcomes: list[Outcome] = []
    waiting, running = list(zip(names, prototypes, strict=True)), set[Future[Outcome]]()
    with ThreadPoolExecutor(max_workers=jobs) as pool:
        while waiting or running:
            while waiting and len(running) < jobs:
                running.add(pool.submit(_run_one, *waiting.pop(0), output))
            done, running = wait(running, return_when=FIRST_COMPLETED)
            for future in done:
                outcomes.append(future.result())
                finished(outcomes[-1], len(outcomes), len(prototypes))
                if fail_fast and outcomes[-1].exit_code:
                    waiting.clear()
    outcomes.sort(key=lambda outcome: outcome.name)
    write_fleet(output, outcomes)
    write_fleet_report(output, [(outcome.name, outcome.reason) for outcome in outcomes])
    return outcomes


def _names(prototypes: Sequence[Path]) -> list[str]:
    names: list[str] = []
    for path in prototypes:
        try:
            name = load_prototype(path).name
        except DebistError:
            name = path.stem  # its own run fails with the reason
        if name in names:
            raise InputError(f"{path}: a second prototype is named {name!r}; names decide the run folders, change one")
        names.append(name)
    return names


def _run_one(name: str, prototype: Path, output: Path) -> Outcome:
    began = time.perf_counter()
    # One thread each in the numerical libraries: the processes share the cores, not the libraries.
    environment = os.environ | {f"{library}_NUM_THREADS": "1" for library in ("OMP", "OPENBLAS", "MKL", "NUMBA")}
    command = [sys.executable, "-c", "from cli import app; app()", "run", str(prototype), "-o", str(output / name)]
    done = subprocess.run([*command, "--json", "--quiet"], capture_output=True, text=True, env=environment, check=False)
    return Outcome(name, prototype, done.returncode, _reason(done), time.perf_counter() - began)


def _reason(done: "subprocess.CompletedProcess[str]") -> str:
    if done.returncode == 0:
        return ""
    if done.returncode < 0:
        return f"ended by signal {-done.returncode}"
    lines = [line for line in done.stderr.splitlines() if line.strip()]
    said = [line.removeprefix("debist: ") for line in lines if line.startswith("debist: ")]
    return (said or lines or [f"exit code {done.returncode}"])[-1]


def write_fleet(output: Path, outcomes: Iterable[Outcome]) -> None:
    """The scores of all prototypes in one table, Parquet and CSV; a failed one has a row that says why."""
    rows: list[dict[str, Any]] = []
    for outcome in outcomes:
        head = {"prototype": outcome.name, "exit_code": outcome.exit_code, "reason": outcome.reason}
        scores = load_scores(output / outcome.name) if outcome.exit_code == 0 else [{}]
        rows += [{column.name: None for column in schemas.SCORES.columns} | score | head for score in scores]
    columns = {column.name: [row[column.name] for row in rows] for column in FLEET.columns}
    tables.write_table(output / FLEET_TABLE, FLEET, columns)
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(columns)
    writer.writerows([_cell(value) for value in row] for row in zip(*columns.values(), strict=True))
    write_text(output / FLEET_CSV, text.getvalue())


def _cell(value: Any) -> Any:
    """A CSV cell that no spreadsheet takes for a formula."""
    if isinstance(value, str) and value[:1] in ("=", "+", "-", "@", "\t", "\r"):
        return f"'{value}"
    return "" if value is None else value
