"""A run folder with planted models, as the stages leave it."""

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from pipeline.device.device import device
from pipeline.device.parameters import parameter_set
from pipeline.settings.prototype import parse_prototype
from pipeline.store import layout, schemas
from pipeline.store.manifest import Recipe
from pipeline.store.run_folder import RunFolder
from pipeline.workflow import stage_validate as validate
from pipeline.workflow.engine import bring_up_to_date
from tests.export.joints import hybrid, paper, pulses
from tests.prototypes import Silent

SETTINGS: dict[str, Any] = {
    "name": "demo-1",
    "logs": {"train": ["a.csv"], "validation": ["b.csv"]},
    "channels": {
        "q": {"channel": "q", "unit": "mm"},
        "v1": {"channel": "v1", "unit": "kV"},
        "v2": {"channel": "v2", "unit": "kV"},
    },
    "plant": {"mass": {"value": 0.04, "unit": "kg"}, "parameters": "nominal"},
    "compare": {"models": []},
}


@pytest.fixture(scope="session")
def planted_run(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A run whose logs the model `hybrid` itself has written, with its scores."""
    folder = tmp_path_factory.mktemp("export")
    prototype = parse_prototype(json.loads(json.dumps(SETTINGS)), "test")
    run = RunFolder.create(folder / "run", prototype.model_dump(mode="json"), folder / "P.toml")
    plant, truth, written = device(prototype), hybrid(), {}
    for number, (role, name, _) in enumerate(layout.logs(prototype)):
        t, v = pulses(8.0 + number)
        free = truth.simulate(t, v, -0.0105, 0.0)
        assert free.status == "ok"
        signals = {"t": t, "q": free.q, "v1": v[:, 0], "v2": v[:, 1], "segment": np.zeros(len(t), dtype=np.int32)}
        motion = {**signals, "qdot": free.qdot, "qddot": free.qddot}
        for artifact, schema, columns in (
            (layout.record(role, name), schemas.RECORD, signals),
            (layout.kinematics(role, name), schemas.KINEMATICS, motion),
        ):
            written[artifact] = run.write_table(artifact, schemas.schema_of(schema, plant), columns, {})
    tree = {"headline": "hybrid", "hybrid": truth.to_tree(), "rbf-paper": paper().to_tree()}
    written[layout.MODELS] = run.write_tree(
        layout.MODELS, tree, {"identified": ["hybrid", "rbf-paper"], "hybrid": {}, "rbf-paper": {}}
    )
    run.commit(Recipe("test", "1", {}, {}), written)
    parameters = parameter_set(prototype, folder)
    models = ("hybrid", "rbf-paper")
    runs = (validate.task(prototype, parameters, "validate", model, layout.MODELS) for model in models)
    made = [*runs, validate.scores_task(prototype, parameters, models)]
    bring_up_to_date(run, made, Silent())
    return run.root
