"""Scores: every free run against its log, one row per log, model and signal."""

from collections.abc import Mapping, Sequence
from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from pipeline.artifacts import schemas
from pipeline.artifacts.manifest import plain
from pipeline.artifacts.run_folder import RunFolder, Written
from pipeline.artifacts.tables import Table
from pipeline.settings import Prototype, Role
from pipeline.stages import layout
from pipeline.stages.device import Device, device
from pipeline.stages.engine import TIMES, Task
from pipeline.stages.joint_parameters import recorded
from pipeline.stages.pitch import PitchMap, pitch_map
from pipeline.stages.predict import HORIZONS
from pipeline.stages.trajectories import voltages

if TYPE_CHECKING:
    from pipeline.numerics.scoring.scores import Score
    from pipeline.numerics.scoring.wells import NoWells, Wells
    from pipeline.physics.parameters import JointParameters
    from pipeline.reporting.tables import Format

ALGORITHM = "3"

_BOOTSTRAP_SEED = 0

SIGNALS = ("q", "phi", "qdot", "qddot")


def task(prototype: Prototype, parameters: "JointParameters | None", models: Sequence[str]) -> Task:
    """Score these models on every log."""
    logs = [(role, log) for role, log, _ in layout.logs(prototype)]
    return Task(
        stage="scores",
        title="NRMSE table",
        algorithm=ALGORITHM,
        settings={"models": list(models), "parameters": recorded(parameters)},
        inputs=tuple(
            name
            for role, log in logs
            for name in (layout.kinematics(role, log), *(layout.predictions(role, log, model) for model in models))
        ),
        outputs=(layout.SCORES,),
        work=lambda run: _score(run, prototype, pitch_map(parameters), models),
    )


def scored_models(run: RunFolder, prototype: Prototype) -> tuple[str, ...]:
    """The identified models, and those rivals whose free runs belong to the kinematics of today."""
    rivals = [
        model
        for model in prototype.rivals
        if all(_fresh(run, role, log, model) for role, log, _ in layout.logs(prototype))
    ]
    return (*prototype.identify.models, *rivals)


def _fresh(run: RunFolder, role: Role, log: str, model: str) -> bool:
    made = run.manifest.artifacts.get(layout.predictions(role, log, model))
    source = layout.kinematics(role, log)
    return made is not None and made.recipe.inputs.get(source) == run.record(source).content_hash


def _score(
    run: RunFolder, prototype: Prototype, pitch: PitchMap | None, models: Sequence[str]
) -> Mapping[str, Written]:
    from pipeline.numerics.scoring.wells import find_wells

    logs = [(role, log, run.read_table(layout.kinematics(role, log))) for role, log, _ in layout.logs(prototype)]
    wells = find_wells([(table["q"], voltages(table), _interval(table)) for _, _, table in logs])
    rows = []
    for role, log, measured in logs:
        for model in models:
            name = layout.predictions(role, log, model)
            calculated, outcome = run.read_table(name), run.record(name).notes
            scored = _score_one(device(prototype), pitch, measured, calculated, outcome, wells)
            rows += [{"log": log, "role": role, "model": model} | row for row in scored]
    columns = {column.name: [row[column.name] for row in rows] for column in schemas.SCORES.columns}
    return {layout.SCORES: run.write_table(layout.SCORES, schemas.SCORES, columns, {"wells": asdict(wells)})}


def _score_one(
    plant: Device,
    pitch: PitchMap | None,
    measured: Table,
    calculated: Table,
    outcome: Mapping[str, Any],
    wells: "Wells | NoWells",
) -> list[dict[str, Any]]:
    from pipeline.numerics.scoring.scores import score_run
    from pipeline.numerics.scoring.step_response import response_errors
    from pipeline.numerics.scoring.wells import Wells

    unit = plant.displacement.symbol
    units = {"q": unit, "phi": "rad", "qdot": f"{unit}/s", "qddot": f"{unit}/s²"}
    pairs = {name: (measured[name], calculated[name]) for name in ("q", "qdot", "qddot")}
    if pitch is not None:
        pairs["phi"] = (pitch(measured["q"]), calculated["phi"])
    v, interval = voltages(measured), _interval(measured)
    scores = score_run(
        {name: pairs[name] for name in SIGNALS if name in pairs},
        v,
        interval,
        status=outcome["status"],
        diverged_at_s=outcome["diverged_at_s"],
        wells=wells,
        rng=np.random.default_rng(_BOOTSTRAP_SEED),
    )
    switches = response_errors(measured["q"], calculated["q"], v, interval, wells) if isinstance(wells, Wells) else None
    more = {f"nrmse_{name}": error["nrmse"] for name, error in outcome["horizons"].items()}
    more |= {"rise_error_s": switches.rise_s, "settling_error_s": switches.settling_s} if switches else {}
    return [_row(score, units[score.signal], more if score.signal == "q" else {}) for score in scores]


def _row(score: "Score", unit: str, more: Mapping[str, float | None]) -> dict[str, Any]:
    empty = dict.fromkeys((*(f"nrmse_{name}" for name in HORIZONS), "rise_error_s", "settling_error_s"))
    band = score.nrmse_interval
    limits = {"nrmse_low": band.low if band else None, "nrmse_high": band.high if band else None}
    return {**vars(score), **limits, **empty, **more, "unit": unit}


def _interval(table: Table) -> float:
    return float((table["t"][-1] - table["t"][0]) / (len(table["t"]) - 1))


def load_scores(root: Path) -> list[dict[str, Any]]:
    """The score rows of a run as records, null where a value is undefined."""
    table = RunFolder.open(root).read_table(layout.SCORES)
    names = list(table)
    return [dict(zip(names, map(plain, row), strict=True)) for row in zip(*table.values(), strict=True)]


def score_text(root: Path, form: "Format") -> str:
    """The NRMSE table of a run with fitting and simulation times, as text of the given form."""
    from pipeline.reporting.tables import nrmse_table, render

    run = RunFolder.open(root)
    scores = load_scores(root)
    return render(nrmse_table(scores, _times(run, scores)), form)


def _times(run: RunFolder, scores: Sequence[Mapping[str, Any]]) -> dict[str, dict[str, float | None]]:
    """Processor time [s] of each model's fit and of its longest free run, as noted when they were made."""
    times: dict[str, dict[str, float | None]] = {}
    for score in scores:
        model = score["model"]
        fitted = run.manifest.artifacts.get(layout.rival(model))
        notes = fitted.notes if fitted else run.record(layout.MODELS).notes.get(model, {})
        made = run.record(layout.predictions(score["role"], score["log"], model)).notes.get(TIMES, {}).get("simulate_s")
        longest = max(filter(None, (made, times.get(model, {}).get("simulate_s"))), default=None)
        times[model] = {"fit_s": notes.get(TIMES, {}).get("fit_s"), "simulate_s": longest}
    return times


def percent(fraction: float | None) -> str:
    """A fraction in percent, or a dash where it is undefined."""
    return "–" if fraction is None else f"{100.0 * fraction:.2f}"
