"""Report: the page, the datasheet and, if wanted, every figure for a paper, from what the run holds."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING

from ..device.parameters import JointParameters, parameter_values
from ..diagnostics.datasheet import Datasheet, make_datasheet
from ..diagnostics.run_data import RunData
from ..settings.prototype import Prototype
from ..store import layout, schemas
from ..store.columns import StudyName
from ..store.run_folder import RunFolder, Written
from ..system.names import Typeface
from .engine import Task
from .report_data import read_run

if TYPE_CHECKING:
    from ..reporting.figure import Figure
    from ..reporting.plotted import Format

ALGORITHM = "40"

FORMATS: "tuple[Format, ...]" = ("svg", "pdf")


@dataclass(frozen=True)
class Prepared:
    """A run as it was read, judged and drawn."""

    data: RunData
    sheet: Datasheet
    figures: "Mapping[str, Figure]"


def tasks(
    prototype: Prototype,
    parameters: JointParameters | None,
    models: Sequence[str],
    studies: Sequence[StudyName] = (),
    figures: Typeface | None = None,
    control: Sequence[str] = (),
    jobs: int = 1,
) -> list[Task]:
    """The page with the datasheet, then the figures for a paper if they are wanted.

    Parameters
    ----------
    prototype : Prototype
        Settings of the run.
    parameters : JointParameters or None
        Parameter set of a DE joint, for φ; None for another device.
    models : sequence of str
        Models with free runs of the present kinematics, the main model first.
    studies : sequence of str
        Hyperparameter studies that the run holds (`made_studies`).
    figures : {"sans", "serif"}, optional
        Typeface of the figures for a paper; None makes none.
    control : sequence of str
        Results of `debist control` for the present model (`pipeline.workflow.run_contents.made_control`).
    jobs : int
        Processes in which the page's figures are drawn.
    """
    from ..reporting.log_figures import LOG_FIGURES

    prepared = partial(prepare, prototype=prototype, models=models, studies=studies, control=control)
    inputs = _inputs(prototype, models, studies, control)
    common = {"parameters": parameter_values(parameters), "models": list(models)}
    settings = prototype.model_dump(mode="json")
    page = Task(
        stage="report",
        title="page",
        algorithm=ALGORITHM,
        settings={**common, "prototype": settings},
        inputs=inputs,
        outputs=(layout.REPORT, layout.DATASHEET),
        work=partial(_page, prepared=prepared, jobs=jobs),
    )
    if figures is None:
        return [page]
    return [
        page,
        Task(
            stage="report",
            title="figures",
            algorithm=ALGORITHM,
            settings={**common, "plant": settings["plant"], "identify": settings["identify"], "typeface": figures},
            inputs=inputs,
            outputs=tuple(
                layout.figure(f"{role}-{log}-{kind}", ending)
                for role, log, _ in layout.logs(prototype)
                for kind in LOG_FIGURES
                for ending in FORMATS
            ),
            work=partial(_drawings, prepared=prepared, typeface=figures),
        ),
    ]


def _inputs(
    prototype: Prototype, models: Sequence[str], studies: Sequence[StudyName], control: Sequence[str]
) -> tuple[str, ...]:
    """The artifacts that the page shows something of."""
    logs = [(role, log) for role, log, _ in layout.logs(prototype)]
    return (
        layout.CHECK,
        layout.MODELS,
        layout.SCORES,
        layout.INSTRUMENTS,
        *((layout.CURVES,) if prototype.compare.curves is not None else ()),
        *((layout.KNOWN_CURVES,) if prototype.plant.curves is not None else ()),
        *(layout.baseline(model) for model in models if model in prototype.baselines),
        *(layout.study(name) for name in studies),
        *(layout.control(title) for title in control),
        *(layout.record(role, log) for role, log in logs),
        *(layout.kinematics(role, log) for role, log in logs),
        *(layout.predictions(role, log, model) for role, log in logs for model in models),
    )


def made_studies(run: RunFolder) -> tuple[StudyName, ...]:
    """The hyperparameter studies that a run holds."""
    return tuple(name for name in schemas.STUDIES if layout.study(name) in run.manifest.artifacts)


def made_figures(run: RunFolder) -> Typeface | None:
    """Typeface of the figures for a paper that a run holds, which a rerun keeps up to date; None if it holds none."""
    drawn = (
        record.recipe.settings.get("typeface")
        for name, record in run.manifest.artifacts.items()
        if record.recipe.stage == "report" and name not in (layout.REPORT, layout.DATASHEET)
    )
    return next(("serif" if typeface == "serif" else "sans" for typeface in drawn), None)


def prepare(
    run: RunFolder,
    prototype: Prototype,
    models: Sequence[str],
    studies: Sequence[StudyName] = (),
    control: Sequence[str] = (),
) -> Prepared:
    """Read a run and evaluate everything that its page and its figures show.

    Parameters
    ----------
    run : RunFolder
        The run.
    prototype : Prototype
        Its settings.
    models : sequence of str
        Models that are shown, the main model first.
    studies : sequence of str
        Studies that are shown.
    control : sequence of str
        Titles of the control documents that are shown.
    """
    from ..reporting.run_report import figures_of

    data = read_run(run, prototype, models, studies, control)
    sheet = make_datasheet(data)
    return Prepared(data, sheet, figures_of(data, sheet))


def _page(run: RunFolder, *, prepared: Callable[[RunFolder], Prepared], jobs: int) -> Mapping[str, Written]:
    from ..reporting.run_report import run_report

    contents = prepared(run)
    page = run_report(contents.data, contents.sheet, contents.figures, jobs)
    notes = {"verdict": contents.sheet.grades}
    return {
        layout.REPORT: run.write_text(layout.REPORT, page, notes),
        layout.DATASHEET: run.write_json(layout.DATASHEET, contents.sheet.to_json(contents.data), notes),
    }


def _drawings(
    run: RunFolder, *, prepared: Callable[[RunFolder], Prepared], typeface: Typeface
) -> Mapping[str, Written]:
    from ..reporting.plotted import paper_figure

    contents = prepared(run)
    written = {}
    for name, figure in contents.figures.items():
        drawn = paper_figure(figure, contents.data.model_names, *FORMATS, typeface=typeface)
        for ending, content in zip(FORMATS, drawn, strict=True):
            artifact = layout.figure(name, ending)
            written[artifact] = run.write_bytes(artifact, content, {"title": figure.title})
    return written
