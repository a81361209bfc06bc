"""Run: the stages, one row each, in order on one locked run folder."""

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Literal

from ..device.parameters import JointParameters, parameter_set
from ..errors import DebistError
from ..settings.prototype import Prototype, load_prototype
from ..store import layout
from ..store.atomic import run_lock
from ..store.manifest import MANIFEST, load_manifest, recover
from ..store.run_folder import RunFolder, in_snapshot
from ..system.names import Typeface
from . import (
    prior_knowledge,
    stage_check,
    stage_identify,
    stage_ingest,
    stage_instruments,
    stage_report,
    stage_validate,
)
from .engine import After, Observer, Plan, Task, TaskStatus, bring_up_to_date, status, tasks_of
from .place import Place, before_any_work, edited, place_of, run_folder
from .run_contents import identified_models, made_control


@dataclass(frozen=True)
class Planned:
    """Inputs of the plan of a run.

    Attributes
    ----------
    run : RunFolder
        Its artifacts decide which models there are.
    prototype, prototype_file : Prototype, Path
        Its settings, and the file that relative paths in them begin at.
    models : tuple of str, optional
        The models to score and show, the main model first; empty for all that the settings name.
    typeface : str, optional
        Typeface of figures for a paper, where they are wanted although the run holds none.
    jobs : int
        Processes at a time.
    """

    run: RunFolder
    prototype: Prototype
    prototype_file: Path
    models: tuple[str, ...] = ()
    typeface: Typeface | None = None
    jobs: int = 1

    @cached_property
    def parameters(self) -> JointParameters | None:
        """The parameter set that the settings name."""
        return parameter_set(self.prototype, self.prototype_file)

    @property
    def scored(self) -> tuple[str, ...]:
        """The models to score and show."""
        return self.models or (*identified_models(self.run, self.prototype), *self.prototype.baselines)


@dataclass(frozen=True)
class Stage:
    """A row: name, tasks, and the artifact that decides which tasks those are, or whether there are any.

    Attributes
    ----------
    with_it : tuple of str
        Stages that are brought up to date beside it where it is done alone.
    """

    name: str
    tasks: Callable[[Planned], Iterable[Task]]
    known_after: str = ""
    with_it: tuple[str, ...] = ()


def reading_tasks(prototype: Prototype, prototype_file: Path) -> list[Task]:
    """The tasks that read raw files."""
    return [*stage_ingest.tasks(prototype, prototype_file), *prior_knowledge.tasks(prototype, prototype_file)]


def _compare(planned: Planned) -> Iterator[Task]:
    for name in planned.prototype.baselines:
        yield stage_identify.baseline_task(planned.prototype, planned.parameters, name)
        yield stage_validate.task(planned.prototype, planned.parameters, "compare", name, layout.baseline(name))


def _report(planned: Planned) -> list[Task]:
    return stage_report.tasks(
        planned.prototype,
        planned.parameters,
        models=planned.scored,
        studies=stage_report.made_studies(planned.run),
        figures=planned.typeface or stage_report.made_figures(planned.run),
        control=made_control(planned.run),
        jobs=planned.jobs,
    )


STAGES = (
    Stage("ingest", lambda p: reading_tasks(p.prototype, p.prototype_file)),
    Stage("check", lambda p: stage_check.tasks(p.prototype)),
    Stage("differentiate", lambda p: stage_ingest.differentiate_tasks(p.prototype), with_it=("check",)),
    Stage("identify", lambda p: stage_identify.tasks(p.prototype, p.parameters, p.jobs), known_after=layout.CHECK),
    Stage("compare", _compare, with_it=("scores",)),
    Stage(
        "instruments",
        lambda p: [stage_instruments.task(p.prototype, identified_models(p.run, p.prototype))],
        known_after=layout.MODELS,
    ),
    Stage(
        "validate",
        lambda p: [
            stage_validate.task(p.prototype, p.parameters, "validate", name, layout.MODELS)
            for name in identified_models(p.run, p.prototype)
        ],
        known_after=layout.MODELS,
        with_it=("instruments", "scores"),
    ),
    Stage(
        "scores", lambda p: [stage_validate.scores_task(p.prototype, p.parameters, p.scored)], known_after=layout.MODELS
    ),
    Stage("report", _report, known_after=layout.MODELS, with_it=("instruments",)),
)
STAGE_NAMES = tuple(stage.name for stage in STAGES)


def plan(planned: Planned) -> Iterator[Task | After]:
    """Every task of a run, with a mark before those that the identified models decide."""
    for stage in STAGES:
        if stage.known_after:
            yield After(stage.known_after)
        yield from stage.tasks(planned)


def of_stages(plan: Iterable[Task | After], names: Sequence[str]) -> Iterator[Task | After]:
    """The tasks of these stages, with all marks."""
    return (entry for entry in plan if isinstance(entry, After) or entry.stage in names)


StageName = Literal["ingest", "differentiate", "identify", "validate", "compare", "report"]
"""Stages that can be done alone."""


def run_prototype(
    given: Path | Place,
    output: Path | None,
    observer: Observer,
    *,
    only: StageName | None = None,
    with_report: bool = True,
    replace: bool = False,
    jobs: int = 1,
) -> list[TaskStatus]:
    """Bring the run of a prototype's settings file up to date, or only one of its stages, or all but the report.

    Parameters
    ----------
    given : Path or Place
        The settings, or a run folder that was made from some; or both, as `place_of` found them.
    output : Path or None
        The run folder; None: ``runs/NAME``, or the run folder that was given.
    observer : Observer
        Receives what happens.
    only : str, optional
        A stage: this one only.
    with_report : bool
        Make the report, too.
    replace : bool
        Let the run folder belong to this prototype from now on, if it was another one's.
    jobs : int
        Processes for tasks that do not wait for each other; results and messages are the same for any number.

    Raises
    ------
    DebistError
        Bad settings or data, another prototype's run folder, a damaged manifest, or a run that is locked.
    """
    place = given if isinstance(given, Place) else place_of(given, output)
    prototype = place.prototype
    before_any_work(place, reading_tasks(prototype, place.prototype_file), replace=replace)
    stages = [only] if only else [name for name in STAGE_NAMES if with_report or name != "report"]
    with run_lock(place.root):
        run = RunFolder.create(place.root, prototype.model_dump(mode="json"), place.prototype_file)
        _strike_lost(run, observer)
        planned = Planned(run, prototype, place.prototype_file, jobs=jobs)
        observer.planned([task.stage for task in tasks_of(of_stages(plan(planned), stages))])
        return _bring_up_to_date(run, of_stages(plan(planned), stages), stages, observer, jobs)


def run_stage(
    root: Path, stage: StageName, observer: Observer, *, figures: Typeface | None = None, jobs: int = 1
) -> list[TaskStatus]:
    """Bring one stage of an existing run up to date, by the settings that the run holds.

    Parameters
    ----------
    root : Path
        Run folder.
    stage : str
        Name of the stage.
    observer : Observer
        Receives what happens.
    figures : {"sans", "serif"}, optional
        Typeface of the figures for a paper, which the report then makes; without one it renews those of the run.
    jobs : int
        Processes at a time.

    Raises
    ------
    CorruptArtifactError
        An input of the stage is damaged.
    """
    root = run_folder(root)
    load_manifest(root)  # a folder without a run is refused before a lock is laid into it
    with run_lock(root):
        run = RunFolder.open(root)
        _strike_lost(run, observer)
        models = () if stage == "compare" else stage_validate.scored_models(run, run.prototype)
        planned = Planned(run, run.prototype, Path(run.manifest.prototype_file), models, figures, jobs)
        beside = next(row.with_it for row in STAGES if row.name == stage)
        selected = list(tasks_of(of_stages(plan(planned), (stage, *beside))))
        if edits := edited(run):
            more = f", and {len(edits) - 1} more" if len(edits) > 1 else ""
            observer.warned(
                selected[0].title,
                f"{run.manifest.prototype_file} was edited since ({edits[0]}{more}); this goes by the settings that "
                "the run was made from; `debist run` takes the edit over",
            )
        _refuse_damaged_inputs(run, selected)
        return _bring_up_to_date(run, selected, (stage,), observer, jobs)


def _strike_lost(run: RunFolder, observer: Observer) -> None:
    """Strike off damaged or lost artifacts of other commands: no stage makes them anew."""
    recover(run.root)
    for name in [name for name in run.manifest.artifacts if layout.remade(name)]:
        if problem := run.strike(name):
            observer.warned(name, f"{problem}; {layout.remade(name)}")


def _refuse_damaged_inputs(run: RunFolder, tasks: Iterable[Task]) -> None:
    """Nothing is made from an artifact, or called up to date with it, that has not the bytes it was written with."""
    inputs = {name for task in tasks for name in task.inputs} - {name for task in tasks for name in task.outputs}
    for name in sorted(inputs & run.manifest.artifacts.keys()):
        run.checked(name)


def _bring_up_to_date(
    run: RunFolder, tasks: Plan, stages: Sequence[str], observer: Observer, jobs: int
) -> list[TaskStatus]:
    """Do what is to be done, and then state the content of these stages and of all that have tasks."""
    done = bring_up_to_date(run, tasks, observer, jobs=jobs)
    contents = {stage: dict[str, str]() for stage in (*stages, *(task.stage for task in done))}
    for task in done:
        contents[task.stage] |= {name: run.record(name).content_hash for name in task.outputs}
    run.state(contents)
    return done


def missing_settings(root: Path) -> str:
    """Message that the settings file of a run is not where it was; empty if it is."""
    named = load_manifest(run_folder(root)).prototype_file
    if not named or Path(named).is_file():
        return ""
    return f"its settings file {named} is not there any more: compared with what the run keeps of it"


def run_status(root: Path) -> list[TaskStatus]:
    """State of a run's tasks by the present settings file, or by the stored settings where that file is gone."""

    def judged(run: RunFolder) -> list[TaskStatus]:
        """State of the tasks, by the settings file if there is one."""
        prototype_file = Path(run.manifest.prototype_file)
        prototype = load_prototype(prototype_file) if prototype_file.is_file() else run.prototype
        return status(run, plan(Planned(run, prototype, prototype_file)))

    return in_snapshot(run_folder(root), judged)


def dry_run(place: Place, *, replace: bool = False) -> list[TaskStatus]:
    """List what `run_prototype` would do and why, without doing it.

    Raises
    ------
    DebistError
        As `run_prototype` before any work.
    """
    prototype = place.prototype
    before_any_work(place, reading_tasks(prototype, place.prototype_file), replace=replace)
    if (place.root / MANIFEST).is_file():
        return in_snapshot(place.root, lambda run: status(run, plan(Planned(run, prototype, place.prototype_file))))
    with TemporaryDirectory(prefix="debist-plan-") as empty:
        run = RunFolder.create(Path(empty) / "run", prototype.model_dump(mode="json"), place.prototype_file)
        return status(run, plan(Planned(run, prototype, place.prototype_file)))


def is_up_to_date(prototype_file: Path, root: Path, *, with_report: bool = True) -> bool:
    """True if `run_prototype` would find nothing to do; false where only doing it would show that."""
    try:
        prototype = load_prototype(prototype_file)
        run = RunFolder.open(root)
        made_for = (run.manifest.prototype, run.manifest.prototype_file)
        if made_for != (prototype.model_dump(mode="json"), str(prototype_file.resolve())):
            return False
        results = status(run, plan(Planned(run, prototype, prototype_file)))
        return all(result.up_to_date for result in results if with_report or result.stage != "report")
    except DebistError:
        return False


def fleet_status(roots: Sequence[Path]) -> list[tuple[Path, list[TaskStatus], str]]:
    """State of the tasks of each of many runs; the reason instead where a run cannot be read."""
    statuses: list[tuple[Path, list[TaskStatus], str]] = []
    for root in roots:
        try:
            statuses.append((root, run_status(root), ""))
        except DebistError as error:
            statuses.append((root, [], str(error)))
    return statuses
