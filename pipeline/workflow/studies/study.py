"""Studies of the parameters that a person might turn: alpha (fig. 11c), the RBF basis (fig. 11b), the training data."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

from ...device.device import Device, device
from ...models.paper.model import identify_rbf_paper
from ...models.paper.online import drifted, follow
from ...numerics.arrays import FloatArray, sample_interval
from ...reporting.plotted import paper_figure
from ...scoring.cross_validation import amount_study, held_out_error, noise_study
from ...settings.logs import Role
from ...settings.prototype import Prototype
from ...signals.differentiate import alpha_study, differentiate
from ...signals.log import Log, operating_range
from ...store import layout, schemas
from ...store.atomic import refuse_link, run_lock, write_bytes
from ...store.columns import StudyName
from ...store.outputs import new_outputs
from ...store.run_folder import RunFolder, Written
from ...system.worker_pool import in_processes
from ...units.units import ALPHA_UNIT
from ..engine import Observer, Task, bring_up_to_date
from ..report_data import read_study
from ..run_contents import load_logs, sources
from ..steps.differentiate import differentiator

ALGORITHM = "2"

ALPHAS = tuple(10.0 ** np.arange(-12.0, 2.01, 1.0))  # for q in mm, deg or mV
BASIS_FUNCTIONS = (5, 8, 10, 12, 15, 20)
SMOOTHINGS = (0.3, 0.5, 0.8, 1.2)
SHARES = (0.05, 0.1, 0.2, 0.4, 0.7, 1.0)  # of the training samples
NOISES = (0.0, 1e-4, 3e-4, 1e-3, 3e-3)  # of the range of q
REPEATS = 4
FORGETTING = (1.0, 0.9995, 0.998)
DRIFTS = (0.0, 0.1)  # growth of the restoring force over the logs

Columns = Mapping[str, FloatArray]


@dataclass(frozen=True)
class StudyResult:
    """A study as it is printed.

    Attributes
    ----------
    columns : mapping of str to array
        Its table.
    units : mapping of str to str
        Of the columns.
    figure : Path
        Path of the figure.
    notes : mapping
        Notes of the study.
    """

    columns: Columns
    units: Mapping[str, str]
    figure: Path
    notes: Mapping[str, Any]


def run_study(root: Path, name: StudyName, observer: Observer, *, jobs: int = 1) -> StudyResult:
    """Do a study of a run, or take it from the run if it is up to date.

    Writes ``studies/NAME.parquet`` and its figure ``studies/NAME.svg``.

    Parameters
    ----------
    root : Path
        Run folder.
    name : {"alpha", "basis", "data", "online"}
        The study.
    observer : Observer
        Receives what happens.
    jobs : int
        Processes at a time.
    """
    with run_lock(root):
        run = RunFolder.open(root)
        bring_up_to_date(run, [study_task(run.prototype, name, jobs)], observer)
        study = read_study(run, name, device(run.prototype))
        figure = _draw(run.root, name, study.columns, study.units)
        return StudyResult(study.columns, study.units, figure, run.record(layout.study(name)).notes)


def study_task(prototype: Prototype, name: StudyName, jobs: int) -> Task:
    """The task that brings the table of a study up to date."""
    records = tuple(layout.record(role, log) for role, log, _ in layout.logs(prototype) if role == "train")
    return Task(
        stage="study",
        title=name,
        algorithm=ALGORITHM,
        settings={"study": name, **_settings(prototype, name)},
        inputs=records if name == "alpha" else sources(prototype),
        outputs=(layout.study(name),),
        work=partial(_work, prototype=prototype, name=name, jobs=jobs),
    )


def _settings(prototype: Prototype, name: StudyName) -> dict[str, Any]:
    """Settings that a study reads beside those that its inputs were made with."""
    if name == "alpha":
        return {"order": prototype.differentiate.order}
    plant = {"plant": prototype.plant.model_dump(mode="json", include={"mass", "inputs", "inputs_before"})}
    read = set() if name == "basis" else {"basis_functions", "smoothing"}
    settings = plant | {"identify": prototype.identify.model_dump(mode="json", include=read)}
    return settings | {"differentiate": prototype.differentiate.model_dump(mode="json")} if name == "data" else settings


def _work(run: RunFolder, prototype: Prototype, name: StudyName, jobs: int) -> Mapping[str, Written]:
    plant = device(prototype)
    studies: dict[StudyName, Callable[[RunFolder, Prototype, Device], tuple[Columns, dict[str, Any]]]] = {
        "alpha": _alpha,
        "basis": partial(_basis, jobs=jobs),
        "data": _data,
        "online": _online,
    }
    columns, notes = studies[name](run, prototype, plant)
    artifact = layout.study(name)
    return {artifact: run.write_table(artifact, schemas.schema_of(schemas.STUDIES[name], plant), columns, notes)}


def _alpha(run: RunFolder, prototype: Prototype, plant: Device) -> tuple[Columns, dict[str, Any]]:
    log = next(log for role, log, _ in layout.logs(prototype) if role == "train")
    table = run.read_table(layout.record("train", log))
    longest = max(np.unique(table["segment"][table["segment"] >= 0]), key=lambda n: np.sum(table["segment"] == n))
    rows = table["segment"] == longest
    order = prototype.differentiate.order
    alphas = ALPHA_UNIT[plant.displacement.symbol][1] * np.array(ALPHAS)
    study = alpha_study(table["q"][rows], sample_interval(table["t"][rows]), alphas, order=order)
    notes = {
        "log": f"train/{log}",
        "order": order,
        "automatic_alpha": study.automatic.alpha,
        "noise_std": study.automatic.noise_std,
    }
    return {"alpha": study.alphas, "misfit": study.misfit, "roughness": study.roughness}, notes


def _segments(run: RunFolder, prototype: Prototype, role: Role) -> list[Log]:
    """The gap-free segments of the logs in a role."""
    return [segment for log in load_logs(run, prototype, role) for segment in log.segments()]


def _held_out(run: RunFolder, prototype: Prototype) -> list[Log]:
    """The validation logs; without any, the training logs themselves."""
    return _segments(run, prototype, "validation") or _segments(run, prototype, "train")


def _basis(run: RunFolder, prototype: Prototype, plant: Device, jobs: int) -> tuple[Columns, dict[str, Any]]:
    grid = [(count, smoothing) for count in BASIS_FUNCTIONS for smoothing in SMOOTHINGS]
    work = partial(_one_basis, _segments(run, prototype, "train"), _held_out(run, prototype), _recipe(prototype, plant))
    mse, condition, nrmse = np.array(list(in_processes(work, grid, jobs))).T
    counts, smoothings = np.array(grid, dtype=np.float64).T
    errors = {"mse": mse, "condition": condition, "nrmse": nrmse}
    return {"basis_functions": counts, "smoothing": smoothings, **errors}, {"model": "rbf-paper"}


def _recipe(prototype: Prototype, plant: Device) -> dict[str, Any]:
    """Arguments of `identify_rbf_paper` by the settings."""
    return {
        "basis_functions": prototype.identify.basis_functions,
        "smoothing": prototype.identify.smoothing,
        "mass": plant.mass,
        "inputs": plant.action,
    }


def _one_basis(
    data: list[Log], held_out: list[Log], recipe: dict[str, Any], point: tuple[int, float]
) -> tuple[float, float, float]:
    """Training MSE of q̈, condition number and held-out NRMSE of q for one pair (M, σₙ)."""
    model = identify_rbf_paper(data, **recipe | {"basis_functions": point[0], "smoothing": point[1]})
    residual = np.concatenate([model.accelerate(x.t, x.v, x.q, x.qdot) - x.qddot for x in data])
    return float(np.mean(residual**2)), float(model.diagnostics["condition"]), held_out_error(model, held_out)


def _data(run: RunFolder, prototype: Prototype, plant: Device) -> tuple[Columns, dict[str, Any]]:
    data = _segments(run, prototype, "train")
    held_out = _held_out(run, prototype)
    identify = partial(identify_rbf_paper, **_recipe(prototype, plant))
    method = differentiator(prototype.differentiate, measured=False, unit=ALPHA_UNIT[plant.displacement.symbol][1])

    def smooth(samples: FloatArray, interval: float) -> tuple[FloatArray, FloatArray, FloatArray]:
        """Smoothed samples and their derivatives."""
        result = differentiate(samples, interval, **method)
        return result.q_smooth, result.qdot, result.qddot

    total = sum(len(x.t) for x in data)
    rng = np.random.default_rng(0)
    low, high = operating_range(data)
    amounts = sorted({max(50, round(share * total)) for share in SHARES})
    levels = [(high - low) * share for share in NOISES]
    points = [
        *((p.level, 0.0, p) for p in amount_study(data, held_out, identify, amounts, repeats=REPEATS, rng=rng)),
        *((total, p.level, p) for p in noise_study(data, held_out, identify, smooth, levels, repeats=REPEATS, rng=rng)),
    ]
    rows = np.array([(samples, noise, *_summary(point.errors)) for samples, noise, point in points])
    columns = dict(zip(("samples", "noise", "nrmse", "nrmse_low", "nrmse_high"), rows.T, strict=True))
    return columns, {"model": "rbf-paper", "repeats": REPEATS, "refused": sum(p.refused for _, _, p in points)}


def _online(run: RunFolder, prototype: Prototype, plant: Device) -> tuple[Columns, dict[str, Any]]:
    data = _segments(run, prototype, "train")
    model = identify_rbf_paper(data, **_recipe(prototype, plant))
    rows = np.concatenate([model.regressors(x) for x in data])
    target = plant.mass * np.concatenate([x.qddot for x in data])
    q = np.linspace(model.centres[0], model.centres[-1], 101)
    force = model.force_rows(q)
    weights = model.weights.ravel()
    interval = prototype.ingest.sample_interval
    truth = force @ weights
    tables = []
    for drift in DRIFTS:
        measured, growth = drifted(rows, target, weights, len(model.centres), drift)
        for forgetting in FORGETTING:
            looks = follow(rows, measured, force, growth[:, None] * truth, forgetting=forgetting)
            constant = np.ones(len(looks[0]))
            tables.append((forgetting * constant, drift * constant, interval * looks[0], *looks[1:]))
    names = ("forgetting", "drift", "t", "curve_error", "prediction_error")
    columns = {name: np.concatenate(parts) for name, *parts in zip(names, *tables, strict=True)}
    memories = ["all" if value >= 1.0 else f"{interval / (1.0 - value):.3g} s" for value in FORGETTING]
    return columns, {"model": "rbf-paper", "memories": memories, "lag_s": model.lag_s}


def _summary(errors: tuple[float, ...]) -> tuple[float, float, float]:
    """Median, least and largest error of the repeats; NaN where all were refused."""
    return (float(np.median(errors)), min(errors), max(errors)) if errors else (np.nan, np.nan, np.nan)


def _draw(root: Path, name: StudyName, columns: Columns, units: Mapping[str, str]) -> Path:
    """The figure of a study, beside its table."""
    from ...reporting.paper_figures import study_figure

    target = root / layout.STUDIES / f"{name}.svg"
    refuse_link(target.parent)
    with new_outputs(target.parent, "study", force=True) as staged:
        write_bytes(staged / target.name, paper_figure(study_figure(name, columns, units), (), "svg")[0])
    return target
