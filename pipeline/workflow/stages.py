"""The stages of a run, one row each; what depends on what follows from the inputs and outputs of their tasks."""

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

from ..device.parameter_sets import parameter_set
from ..device.parameters import JointParameters
from ..settings.prototype import Prototype
from ..store import layout
from ..store.run_folder import RunFolder
from ..system.names import Typeface
from . import prior_knowledge as side_files
from . import stage_check as check
from . import stage_compare as compare
from . import stage_differentiate as differentiate
from . import stage_identify as identify
from . import stage_ingest as ingest
from . import stage_instruments as instruments
from . import stage_report as report
from . import stage_scores as scores
from . import stage_validate as validate
from .engine import After, Task
from .run_models import identified_models, made_control


@dataclass(frozen=True)
class Planned:
    """What the tasks of a run follow from.

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
    """

    run: RunFolder
    prototype: Prototype
    prototype_file: Path
    models: tuple[str, ...] = ()
    typeface: Typeface | None = None

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
    return [*ingest.tasks(prototype, prototype_file), *side_files.tasks(prototype, prototype_file)]


def _compare(planned: Planned) -> Iterator[Task]:
    for name in planned.prototype.baselines:
        yield compare.task(planned.prototype, planned.parameters, name)
        yield validate.task(planned.prototype, planned.parameters, "compare", name, layout.baseline(name))


def _report(planned: Planned) -> list[Task]:
    run = planned.run
    figures = planned.typeface or report.made_figures(run)
    return report.tasks(
        planned.prototype, planned.parameters, planned.scored, report.made_studies(run), figures, made_control(run)
    )


STAGES = (
    Stage("ingest", lambda p: reading_tasks(p.prototype, p.prototype_file)),
    Stage("check", lambda p: check.tasks(p.prototype)),
    Stage("differentiate", lambda p: differentiate.tasks(p.prototype), with_it=("check",)),
    Stage("identify", lambda p: identify.tasks(p.prototype, p.parameters), known_after=layout.CHECK),
    Stage("compare", _compare, with_it=("scores",)),
    Stage(
        "instruments",
        lambda p: [instruments.task(p.prototype, identified_models(p.run, p.prototype))],
        known_after=layout.MODELS,
    ),
    Stage(
        "validate",
        lambda p: validate.tasks(p.prototype, p.parameters, identified_models(p.run, p.prototype)),
        known_after=layout.MODELS,
        with_it=("instruments", "scores"),
    ),
    Stage("scores", lambda p: [scores.task(p.prototype, p.parameters, p.scored)], known_after=layout.MODELS),
    Stage("report", _report, known_after=layout.MODELS, with_it=("instruments",)),
)
STAGE_NAMES = tuple(stage.name for stage in STAGES)


def plan(planned: Planned) -> Iterator[Task | After]:
    """Every task of a run, with a mark before those that the identified models decide."""
    for stage in STAGES:
        if stage.known_after:
            yield After(stage.known_after)
        yield from stage.tasks(planned)


def of_stages(plan: Iterable[Task | After], names: Iterable[str]) -> Iterator[Task | After]:
    """The tasks of these stages, with all marks."""
    wanted = set(names)
    return (entry for entry in plan if isinstance(entry, After) or entry.stage in wanted)
