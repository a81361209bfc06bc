"""Paper: the recipe of the paper on a prototype's logs, and every figure and table under its number.

The recipe is a run of its own, in a folder of its own, so that its artifacts are checked and reused like any others.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np

from ...device.device import device
from ...device.parameters import JointParameters, parameter_set
from ...diagnostics.run_data import RunData
from ...errors import InputError
from ...fitting.regression import basis_values
from ...models.analytical.bifurcation import characteristics
from ...models.analytical.reduced_order import beam_modes, pulse_sequence, simulate_both
from ...models.base import HasCurves
from ...models.paper.model import RbfPaperModel
from ...numerics.arrays import FloatArray
from ...reporting import paper_figures as draw
from ...reporting.figure import Figure, of_models, window
from ...reporting.log_figures import log_figures
from ...reporting.paper_page import paper_page, table_1, table_2
from ...reporting.plotted import Format, paper_figure
from ...scoring.wells import wells_of
from ...settings.logs import ROLES
from ...settings.models import CENTRES, SMOOTHING
from ...settings.prototype import Compare, Differentiate, Identify, Prototype, load_prototype
from ...signals.differentiate import AlphaStudy, alpha_study
from ...signals.log import Log
from ...store import layout
from ...store.atomic import run_lock
from ...store.outputs import beside
from ...store.run_folder import RunFolder, Written
from ...units.units import ALPHA_UNIT
from .. import stage_validate as validate
from ..engine import Observer, Task, TaskStatus, bring_up_to_date, tasks_of
from ..report_data import read_run, read_study
from ..run import STAGE_NAMES, Planned, of_stages, plan
from .study import study_task

ALGORITHM = "4"
RECIPE = Differentiate(order=1, alpha=0.01, epsilon=1e-6)
"""§ 5.1: TVRegDiff with α = 0.01 and ε = 1e-6 for q in mm, applied twice, on samples at 10 ms."""
SAMPLE_INTERVAL = 0.01
BY_RECIPE = "{} by § 5.1"
"""Name of a model in Table 2: `debist run` differentiates otherwise, so its errors differ."""
ALPHAS = (1e-4, 1e-3, 1e-2, 1e-1, 1.0)
"""Regularisation parameters of figure 11c [mm·s]."""
PAIR = ("analytical-calibrated", "rbf-paper")
"""The two models of figures 12, 13 and 15; the paper's analytical model is its calibrated one (§ 3.3)."""
FIGURES = {
    "fig-01b": "Fig. 1b: potential energy and force",
    "fig-03": "Fig. 3: equilibria over z_b",
    "fig-04": "Fig. 4: force over displacement",
    "fig-05": "Fig. 5: capacitance and its derivative",
    "fig-06": "Fig. 6: modes of the beam, and the static path",
    "fig-07": "Fig. 7: full-order against reduced model",
    "fig-08": "Fig. 8b: basis functions",
    "lag-search": "§ 4.2: rank and condition number along the search for T_z",
    "fig-11a": "Fig. 11a: excitation and measured motion",
    "fig-11b": "Fig. 11b: number and width of the basis functions",
    "fig-11c": "Fig. 11c: regularisation parameter",
    "fig-12": "Fig. 12: models against the training log",
    "fig-13": "Fig. 13: the same between 24 and 30 s",
    "fig-14": "Fig. 14: characteristic curves",
    "fig-15": "Fig. 15: models against a log they have not seen",
}
DRAWN = ("rbf-paper", "analytical-calibrated", "analytical")
"""The models of these figures, in the order of their colours."""
ENDINGS: tuple[Format, ...] = ("svg", "pdf")


@dataclass(frozen=True)
class PaperRun:
    """The recipe's run, which holds the figures, and Table 2 with the printed values beside the computed ones."""

    root: Path
    done: list[TaskStatus]
    table: list[dict[str, Any]]


def paper_settings(prototype: Prototype) -> Prototype:
    """The prototype with the recipe of § 5.1 and § 4.2: its logs, channels and plant, everything else as printed.

    Raises
    ------
    InputError
        The device has no two squared inputs, or q is no length, so that the paper's joint is no model of it.
    """
    if not prototype.may_be_a_joint:
        raise InputError(
            f"{prototype.name}: the paper's joint has two squared inputs; if this is one, name v1 and v2 "
            "in [channels], else take `debist run` and `debist report`"
        )
    if device(prototype).displacement.symbol != "m":
        raise InputError(f"{prototype.name}: q of the paper's joint is a length; take `debist run` for another device")
    return prototype.model_copy(
        update={
            "plant": prototype.plant.model_copy(
                update={"parameters": prototype.plant.parameters or "nominal", "curves": None}
            ),
            "ingest": prototype.ingest.model_copy(
                update={"sample_interval": SAMPLE_INTERVAL, "record_interval": SAMPLE_INTERVAL}
            ),
            "differentiate": RECIPE,
            "identify": Identify(models=("rbf-paper",), basis_functions=CENTRES, smoothing=SMOOTHING),
            "compare": Compare(models=("analytical", "analytical-calibrated", "sindy")),
        }
    )


def run_paper(source: Path, output: Path | None, observer: Observer) -> PaperRun:
    """Bring the recipe's run and its figures up to date.

    Parameters
    ----------
    source : Path
        A run folder or a prototype's settings file.
    output : Path, optional
        Folder of the recipe's run; ``RUN-paper`` or ``runs/NAME-paper`` if left out.
    observer : Observer
        Receives every task.
    """
    prototype, prototype_file, usual = _opened(source)
    recipe = paper_settings(prototype)
    root = output or usual
    with run_lock(root):
        run = RunFolder.create(root, recipe.model_dump(mode="json"), prototype_file)
        tasks = tasks_of(
            of_stages(plan(Planned(run, recipe, prototype_file)), [name for name in STAGE_NAMES if name != "report"])
        )
        done = bring_up_to_date(
            run, [*tasks, study_task(recipe, "basis", jobs=1), _task(recipe, prototype_file)], observer
        )
    return PaperRun(root, done, run.record(layout.PAPER).notes["table_2"])


def _opened(source: Path) -> tuple[Prototype, Path, Path]:
    """Settings, their file, and the usual folder of the recipe's run."""
    if source.is_dir():
        run = RunFolder.open(source)
        return run.prototype, Path(run.manifest.prototype_file), beside(source, "-paper")
    prototype = load_prototype(source)
    return prototype, source, Path("runs") / f"{prototype.folder}-paper"


def _task(prototype: Prototype, prototype_file: Path) -> Task:
    parameters = parameter_set(prototype, prototype_file)
    assert parameters is not None  # noqa: S101 - `paper_settings` names a set
    models = (*prototype.identify.models, *prototype.baselines)
    logs = [(role, log) for role, log, _ in layout.logs(prototype)]
    return Task(
        stage="paper",
        title="figures and page",
        algorithm=ALGORITHM,
        settings={"prototype": prototype.model_dump(mode="json")},
        inputs=(
            layout.MODELS,
            layout.SCORES,
            layout.study("basis"),
            *(layout.baseline(model) for model in prototype.baselines),
            *(layout.kinematics(role, log) for role, log in logs),
            *(layout.predictions(role, log, model) for role, log in logs for model in models),
        ),
        outputs=(
            layout.PAPER,
            *(
                layout.paper_figure(name, ending)
                for name in FIGURES
                if name != "fig-15" or prototype.logs.validation
                for ending in ENDINGS
            ),
        ),
        work=lambda run: _work(run, prototype, parameters),
    )


def _work(run: RunFolder, prototype: Prototype, parameters: JointParameters) -> Mapping[str, Written]:
    data = read_run(run, prototype, validate.scored_models(run, prototype))
    figures: dict[str, tuple[Figure, Sequence[str]]] = {
        **{name: (figure, draw.COLOURED) for name, figure in joint_figures(parameters).items()},
        **{name: (figure, DRAWN) for name, figure in _recipe_figures(run, prototype, data).items()},
    }
    written: dict[str, Written] = {}
    pictures: dict[str, bytes] = {}
    for name, (figure, roles) in figures.items():
        files = paper_figure(figure, roles, *ENDINGS)
        pictures[FIGURES[name]] = files[0]
        for ending, content in zip(ENDINGS, files, strict=True):
            artifact = layout.paper_figure(name, ending)
            written[artifact] = run.write_bytes(artifact, content, {"title": FIGURES[name]})
    rows = [row | {"model": BY_RECIPE.format(row["model"])} for row in table_2(data.scores)]
    page = paper_page(prototype.name, pictures, table_1(parameters), rows, data, str(prototype.plant.parameters))
    return written | {layout.PAPER: run.write_text(layout.PAPER, page, {"table_2": rows})}


def joint_figures(parameters: JointParameters) -> dict[str, Figure]:
    """Figures 1b and 3 to 7: the analytical model of the parameter set."""
    motions = simulate_both(parameters, *pulse_sequence())
    return {
        **draw.paper_joint_figures(characteristics(parameters)),
        "fig-06": draw.modes_figure(parameters, beam_modes(motions.full.qm, parameters.l), motions.full.t),
        "fig-07": draw.motion_figure(motions),
    }


def _recipe_figures(run: RunFolder, prototype: Prototype, data: RunData) -> dict[str, Figure]:
    """Figures 8 and 11 to 15, and the search for T_z: the recipe on the logs."""
    training = data.role("train")[0]
    network = data.models["rbf-paper"]
    assert isinstance(network, RbfPaperModel)  # noqa: S101 - the recipe identifies it
    wells = wells_of([log.motion for log in data.logs], plant=data.device)
    compared = {
        role: of_models(log_figures(data, logs[0], wells)["models"], data.model_names, PAIR)
        for role in ROLES
        if (logs := data.role(role))
    }
    study = read_study(run, "basis", data.device)
    begin = float(training.motion.t[0])
    q = np.linspace(network.centres[0], network.centres[-1], 241)
    drawn = {name: data.models[name] for name in DRAWN if name in data.models}
    curves = {name: model.curves(q) for name, model in drawn.items() if isinstance(model, HasCurves)}
    figures = {
        "fig-08": draw.basis_figure(q, basis_values(q, network.centres, network.width), network.weights[0]),
        "lag-search": draw.lag_figure(network.diagnostics["lag_search"]),
        "fig-11a": draw.signals_figure(training),
        "fig-11b": draw.basis_study_figure(study.columns, study.units, (CENTRES, SMOOTHING)),
        "fig-11c": draw.alpha_figure(*_alpha_study(training.motion), float(RECIPE.alpha)),
        "fig-12": compared["train"],
        "fig-13": window(compared["train"], *(begin + at for at in draw.ZOOM)),
        "fig-14": draw.curves_figure(curves, q),
    }
    return figures | ({"fig-15": compared["validation"]} if "validation" in compared else {})


def _alpha_study(motion: Log) -> tuple[FloatArray, AlphaStudy]:
    """Figure 11c: the log's longest segment differentiated with each α [mm·s], around its fastest moment t [s]."""
    longest = max(motion.segments(), key=lambda segment: len(segment.t))
    t = longest.t
    unit = ALPHA_UNIT["m"][1]
    epsilon = float(RECIPE.epsilon or 0.0) * unit**2
    study = alpha_study(longest.q, SAMPLE_INTERVAL, unit * np.array(ALPHAS), order=1, epsilon=epsilon)
    fastest = t[np.argmax(np.abs(longest.qdot))]
    near = (t >= fastest - 0.5) & (t <= fastest + 1.0)
    return t[near], replace(study, alphas=np.array(ALPHAS), qdot=study.qdot[:, near])
