"""Run: the stages in order, on one locked run folder."""

from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path
from typing import Literal, get_args

from pipeline.errors import DebistError, InputError
from pipeline.loading import measured_curves
from pipeline.loading.device import parameter_set
from pipeline.loading.identified import identified_models
from pipeline.runs.atomic import sweep
from pipeline.runs.engine import Observer, Task, TaskStatus, bring_up_to_date, status
from pipeline.runs.lock import run_lock
from pipeline.runs.manifest import load_manifest
from pipeline.runs.run_folder import RunFolder, in_snapshot
from pipeline.runs.stage_manifest import write_stage_manifest
from pipeline.settings import Prototype, load_prototype, parse_prototype
from pipeline.stages import check, compare, differentiate, identify, ingest, report, scores, validate

StageName = Literal["ingest", "differentiate", "identify", "validate", "compare", "report"]
STAGES: tuple[str, ...] = (*get_args(StageName), "check", "scores")


def plan(run: RunFolder, prototype: Prototype, prototype_file: Path) -> Iterator[Task]:
    """Every task of a run, in order; those behind the identification are planned when it is done.

    Which models there are may be known only then: their names are files of what follows.

    Raises
    ------
    InputError
        The settings name a parameter set that is not there.
    """
    parameters = parameter_set(prototype, prototype_file)
    yield from ingest.tasks(prototype, prototype_file)
    yield from measured_curves.tasks(prototype, prototype_file)
    yield from check.tasks(prototype)
    yield from differentiate.tasks(prototype)
    yield from identify.tasks(prototype, parameters)
    identified = identified_models(run, prototype)
    models = (*identified, *prototype.rivals)
    yield from validate.tasks(prototype, parameters, identified)
    yield from compare.tasks(prototype, parameters)
    yield scores.task(prototype, parameters, models)
    yield from report.tasks(prototype, parameters, models, report.made_studies(run))


def default_output(prototype_file: Path) -> Path:
    """The run folder where none is named."""
    return Path("runs") / load_prototype(prototype_file).name


def run_prototype(
    prototype_file: Path,
    output: Path | None,
    observer: Observer,
    *,
    only: StageName | None = None,
    with_report: bool = True,
) -> list[TaskStatus]:
    """Bring the run of a prototype's settings file up to date, or only one of its stages, or all but the report.

    Raises
    ------
    DebistError
        Bad settings or data, a damaged manifest, or a run that is locked.
    """
    prototype = load_prototype(prototype_file)
    root = output or default_output(prototype_file)
    with run_lock(root):
        run = RunFolder.create(root, prototype.model_dump(mode="json"), prototype_file)
        sweep(root)
        tasks = _of_stage(plan(run, prototype, prototype_file), only)
        stages = (only,) if only else tuple(stage for stage in STAGES if with_report or stage != "report")
        return _bring_up_to_date(
            run, (task for task in tasks if with_report or task.stage != "report"), stages, observer
        )


def run_stage(root: Path, stage: StageName, observer: Observer) -> list[TaskStatus]:
    """Bring one stage of an existing run up to date, by the settings that the run holds."""
    load_manifest(root)  # a folder without a run is refused before a lock is laid into it
    with run_lock(root):
        run, planned = _open(root)
        tasks = list(planned)
        selected = list(_of_stage(tasks, stage))
        prototype = _settings(run)
        parameters = parameter_set(prototype, Path(run.manifest.prototype_file))
        if stage == "differentiate":  # nothing is differentiated before it is what the settings say
            selected = [*_of_stage(tasks, "check"), *selected]
        elif stage == "validate":
            selected.append(scores.task(prototype, parameters, scores.scored_models(run, prototype)))
        elif stage == "compare":
            selected += _of_stage(tasks, "scores")
        elif stage == "report":
            selected = report.tasks(
                prototype, parameters, scores.scored_models(run, prototype), report.made_studies(run)
            )
        return _bring_up_to_date(run, selected, (stage,), observer)


def _bring_up_to_date(
    run: RunFolder, tasks: Iterable[Task], stages: Sequence[str], observer: Observer
) -> list[TaskStatus]:
    """Do what is to be done, and then state the content of these stages and of all that have tasks."""
    done = bring_up_to_date(run, tasks, observer)
    for stage in dict.fromkeys((*stages, *(task.stage for task in done))):
        write_stage_manifest(run, stage, [name for task in done if task.stage == stage for name in task.outputs])
    return done


def run_status(root: Path) -> list[TaskStatus]:
    """What is stale in a run and why, by the settings that it holds."""
    return in_snapshot(root, lambda run: status(run, _plan(run)))


def is_up_to_date(prototype_file: Path, root: Path, *, with_report: bool = True) -> bool:
    """Whether `run_prototype` would find nothing to do; false where that cannot be told without doing it."""
    try:
        prototype, run = load_prototype(prototype_file), RunFolder.open(root)
        made_for = (run.manifest.prototype, run.manifest.prototype_file)
        if made_for != (prototype.model_dump(mode="json"), str(prototype_file.resolve())):
            return False
        tasks = plan(run, prototype, prototype_file)
        return all(result.up_to_date for result in status(run, tasks) if with_report or result.stage != "report")
    except DebistError:
        return False


def fleet_status(roots: Sequence[Path]) -> list[tuple[Path, list[TaskStatus], str]]:
    """What is stale in each of many runs; where a run cannot be read, why not instead."""
    found: list[tuple[Path, list[TaskStatus], str]] = []
    for root in roots:
        try:
            found.append((root, run_status(root), ""))
        except DebistError as error:
            found.append((root, [], str(error)))
    return found


def verify_run(root: Path) -> tuple[list[dict[str, str]], int]:
    """Check every artifact's bytes.

    Returns
    -------
    problems : list of dict
        ``artifact``, ``stage``, ``problem`` for each that is not as it was written.
    checked : int
        Number of artifacts.
    """
    return in_snapshot(root, _verified)


def _verified(run: RunFolder) -> tuple[list[dict[str, str]], int]:
    problems = []
    for name, record in sorted(run.manifest.artifacts.items()):
        try:
            problem = run.problem(name)
        except InputError as error:  # the disk refuses to read it; the others shall be checked nevertheless
            problem = str(error)
        if problem:
            problems.append({"artifact": name, "stage": record.recipe.stage, "problem": problem})
    return problems, len(run.manifest.artifacts)


def _open(root: Path) -> tuple[RunFolder, Iterator[Task]]:
    run = RunFolder.open(root)
    return run, _plan(run)


def _plan(run: RunFolder) -> Iterator[Task]:
    return plan(run, _settings(run), Path(run.manifest.prototype_file))


def _settings(run: RunFolder) -> Prototype:
    return parse_prototype(run.manifest.prototype, f"{run.root}/manifest.json")


def _of_stage(tasks: Iterable[Task], stage: str | None) -> Iterator[Task]:
    return (task for task in tasks if stage in (None, task.stage))
