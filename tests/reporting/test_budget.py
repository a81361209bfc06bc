"""The report of a run as users have it: seven models, two logs at 1 ms; every figure as SVG and PDF on request."""

from typing import Any
from unittest.mock import Mock

import numpy as np
import pytest
from typer.testing import CliRunner

from cli import app
from pipeline.device.device import Device, device
from pipeline.device.parameters import NOMINAL
from pipeline.models.analytical.model import AnalyticalModel
from pipeline.models.base import FreeRun
from pipeline.models.hybrid.model import HybridModel
from pipeline.models.narx import NarxModel
from pipeline.numerics.arrays import FloatArray
from pipeline.runs import layout, schemas
from pipeline.runs.manifest import Recipe
from pipeline.runs.run_folder import RunFolder
from pipeline.runs.schedule import bring_up_to_date
from pipeline.settings import Prototype, parse_prototype
from pipeline.stages import check
from tests.export.joints import hybrid, paper, pulses, sindy

BYTES_OF_PAGE = 6e6
LOG_SECONDS, FINE = 37.5, 10

SETTINGS: dict[str, Any] = {
    "name": "P1",
    "logs": {"train": ["a.csv"], "validation": ["b.csv"]},
    "channels": {
        "q": {"channel": "q", "unit": "mm"},
        "v1": {"channel": "v1", "unit": "kV"},
        "v2": {"channel": "v2", "unit": "kV"},
    },
    "plant": {"mass": {"value": 0.0405, "unit": "kg"}, "parameters": "nominal"},
}


def _models() -> dict[str, Any]:
    joint = hybrid()
    narx = NarxModel(
        structure=np.array([1, 1, 1, 2]), exponents=np.eye(4, dtype=np.int64), coefficients=np.full(4, 1e-5),
        scales=np.ones(4), interval_s=0.01, inputs="squared", bounds=np.array([-0.1, 0.1]),
    )  # fmt: skip
    return {
        "hybrid": HybridModel(joint.joint, joint.theta, *2 * (0.01 * np.eye(len(joint.theta)),)),
        "rbf-paper": paper(),
        "sindy": sindy(),
        "sindy-default": sindy(),
        "narx": narx,
        "analytical": AnalyticalModel(parameters=NOMINAL),
        "analytical-calibrated": AnalyticalModel(parameters=NOMINAL, name="analytical-calibrated"),
    }


class _Writer:
    """Artifacts of a run as the stages before leave them."""

    def __init__(self, folder: RunFolder, plant: Device) -> None:
        self.folder, self.plant, self.written = folder, plant, {}

    def table(self, name: str, schema: Any, columns: Any, notes: Any) -> None:
        self.written[name] = self.folder.write_table(name, schemas.schema_of(schema, self.plant), columns, notes)


def _log(writer: _Writer, role: str, name: str, truth: FreeRun, v: FloatArray, models: Any) -> list[dict[str, Any]]:
    rng, t = np.random.default_rng(len(name)), truth.t
    fine = np.linspace(t[0], t[-1], FINE * (len(t) - 1) + 1)
    noise = 3e-6 * rng.standard_normal(len(fine))
    record = {"t": fine, "q": np.interp(fine, t, truth.q) + noise, "segment": np.zeros(len(fine), dtype=np.int32)}
    record |= {f"v{k + 1}": np.interp(fine, t, v[:, k]) for k in range(2)}
    kinematics = {key: record[key][::FINE] for key in ("q", "v1", "v2", "segment")}
    kinematics |= {"t": t, "qdot": truth.qdot, "qddot": truth.qddot}
    writer.table(layout.record(role, name), schemas.RECORD, record, {"raw_rows": 1_125_000, "raw_step": 1 / 3e4})
    writer.table(layout.kinematics(role, name), schemas.KINEMATICS, kinematics, {})
    rows = []
    for number, model in enumerate(models):
        wave = 1.0 + 0.01 * (number + 1) * np.sin((number + 2) * t)
        free = {"t": t, "q": truth.q * wave, "qdot": truth.qdot * wave, "qddot": truth.qddot * wave}
        free["phi"] = 800.0 * free["q"]
        notes = {"status": "ok", "diverged_at_s": None}
        writer.table(layout.predictions(role, name, model), schemas.PREDICTIONS, free, notes)
        score = {column.key: None for column in schemas.SCORES.columns}
        score |= {"log": name, "role": role, "model": model, "signal": "q", "nrmse": 0.01 * (number + 1)}
        rows.append(score | {"unit": "m", "n": len(t), "status": "ok", "switch_accuracy": 1.0})
    return rows


@pytest.fixture(scope="module")
def run(tmp_path_factory: pytest.TempPathFactory) -> RunFolder:
    root = tmp_path_factory.mktemp("budget")
    prototype: Prototype = parse_prototype(SETTINGS, "test")
    folder = RunFolder.create(root / "run", prototype.model_dump(mode="json"), root / "P1.toml")
    writer, models, rows = _Writer(folder, device(prototype)), _models(), []
    for role, name, _ in layout.logs(prototype):
        t, v = pulses(LOG_SECONDS)
        v *= 1.0 if role == "train" else 0.95  # the same log twice would be refused
        rows += _log(writer, role, name, hybrid().simulate(t, v, -0.0105, 0.0), v, models)
    written, identified = writer.written, ("hybrid", "rbf-paper")
    trees = {name: models[name].to_tree() for name in identified}
    notes: dict[str, Any] = {name: models[name].describe() for name in identified}
    notes["identified"] = list(identified)
    written[layout.MODELS] = folder.write_tree(layout.MODELS, trees, notes)
    for name in models:
        if name not in identified:
            artifact = layout.baseline(name)
            written[artifact] = folder.write_tree(artifact, {name: models[name].to_tree()}, models[name].describe())
    scores = {column.key: [row[column.key] for row in rows] for column in schemas.SCORES.columns}
    written[layout.SCORES] = folder.write_table(layout.SCORES, schemas.SCORES, scores, {})
    nothing = {column.key: [] for column in schemas.INSTRUMENTS.columns}
    written[layout.INSTRUMENTS] = folder.write_table(layout.INSTRUMENTS, schemas.INSTRUMENTS, nothing, {})
    # Free runs belong to the kinematics that they were made from.
    made_from = {name: made.content_hash for name, made in written.items() if name.endswith("kinematics.parquet")}
    folder.commit(Recipe("test", "1", {}, {"a.csv": "f" * 64, **made_from}), written)
    bring_up_to_date(folder, check.tasks(prototype), Mock())
    return folder


@pytest.mark.long
def test_the_report_of_seven_models_stays_in_the_budget(run: RunFolder) -> None:
    """Its processor time is a row of `benchmarks/bench_speed.py`."""
    result = CliRunner().invoke(app, ["report", str(run.root), "-q"])
    assert result.exit_code == 0, result.output
    page = run.path(layout.REPORT).read_text(encoding="utf-8")
    assert [name for name in _models() if f">{name}<" not in page] == []
    assert len(page.encode()) < BYTES_OF_PAGE


@pytest.mark.long
def test_figures_of_seven_models_stay_in_the_budget(run: RunFolder) -> None:
    result = CliRunner().invoke(app, ["report", str(run.root), "-q", "--figures", "serif"])
    assert result.exit_code == 0, result.output
    figures = list((run.root / "figures").iterdir())
    assert {
        f"{name}.{kind}"
        for name in ("curves", "energy", "phase-portrait", "validation-b-models")
        for kind in ("svg", "pdf")
    } <= {path.name for path in figures}
    assert sum(path.stat().st_size for path in figures) < BYTES_OF_PAGE
