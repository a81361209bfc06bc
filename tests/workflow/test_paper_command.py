"""`debist paper`: the recipe as printed, on the example logs, and every figure and table under its number."""

from pathlib import Path

import numpy as np
import pytest

from pipeline.commands.console import Progress
from pipeline.device.parameters import NOMINAL
from pipeline.reporting.paper_figures import COLOURED
from pipeline.reporting.plotted import paper_figure
from pipeline.settings.prototype import Compare, Prototype, parse_prototype
from pipeline.store.run_folder import RunFolder
from pipeline.workflow.engine import bring_up_to_date, tasks_of
from pipeline.workflow.run import STAGE_NAMES, Planned, of_stages, plan
from pipeline.workflow.studies.paper import FIGURES, joint_figures, paper_settings, run_paper

PRINTED = {"q": 2.1, "phi": 2.0, "qdot": 4.1, "qddot": 5.0}


def prototype(**changes: object) -> Prototype:
    settings = {
        "name": "P",
        "logs": {"train": ["train.mf4"]},
        "channels": {
            "q": {"channel": "ILD2300.Distance", "unit": "mm"},
            "v1": {"channel": "HV_left.Umeas", "unit": "V"},
            "v2": {"channel": "HV_right.Umeas", "unit": "V"},
        },
        "plant": {"mass": {"value": 0.0405, "unit": "kg"}},
    }
    return parse_prototype(settings | changes, "P.toml")


def test_the_recipe_is_the_printed_one() -> None:
    """§ 5.1 and § 4.2: 10 ms, α = 0.01, ε = 1e-6, order 1 on the samples; M = 10, σ_n = 0.5."""
    recipe = paper_settings(prototype(ingest={"sample_interval": 0.005}))
    assert recipe.ingest.sample_interval == 0.01
    assert (recipe.differentiate.alpha, recipe.differentiate.epsilon, recipe.differentiate.order) == (0.01, 1e-6, 1)
    assert recipe.ingest.record_interval == 0.01
    assert (recipe.identify.basis_functions, recipe.identify.smoothing) == (10, 0.5)
    assert recipe.plant.parameters == "nominal"


def test_the_recipe_meets_the_printed_errors_on_a_training_log(shared_folder: Path, tmp_path: Path) -> None:
    """Table 2 prints 2.1, 2.0, 4.1 and 5.0 % for q, φ, q̇ and q̈; the simulated prototype P2 comes as close as 0.4 %."""
    log = str(shared_folder / "rig-logs" / "P2" / "train.mf4")
    recipe = paper_settings(prototype(logs={"train": [log]})).model_copy(update={"compare": Compare(models=())})
    run = RunFolder.create(tmp_path / "run", recipe.model_dump(mode="json"), tmp_path / "P.toml")
    stages = [name for name in STAGE_NAMES if name != "report"]
    tasks = list(tasks_of(of_stages(plan(Planned(run, recipe, tmp_path / "P.toml")), stages)))
    bring_up_to_date(run, tasks, Progress(quiet=True))
    scores = run.read_table("scores.parquet")
    errors = {
        str(signal): 100.0 * float(value)
        for signal, value, model in zip(scores["signal"], scores["nrmse"], scores["model"], strict=True)
        if model == "rbf-paper"
    }
    assert {name: pytest.approx(value, abs=0.4) for name, value in PRINTED.items()} == errors


def test_the_figures_of_the_joint_are_drawn_and_the_same_twice() -> None:
    figures = joint_figures(NOMINAL)
    assert set(figures) == {name for name in FIGURES if name[:6] in ("fig-01", *(f"fig-0{n}" for n in range(3, 8)))}
    written = [paper_figure(figures["fig-05"], COLOURED, "svg", "pdf") for _ in range(2)]
    assert written[0] == written[1]
    assert written[0][0].startswith(b"<?xml")
    assert written[0][1].startswith(b"%PDF")


@pytest.mark.long
def test_the_whole_paper_of_an_example_prototype(shared_folder: Path, tmp_path: Path) -> None:
    logs = shared_folder / "rig-logs" / "P2"
    text = f"""name = "P2"
[logs]
train = ["{logs / "train.mf4"}"]
validation = ["{logs / "validation.mf4"}"]
[channels]
q = {{ channel = "ILD2300.Distance", unit = "mm" }}
v1 = {{ channel = "HV_left.Umeas", unit = "V" }}
v2 = {{ channel = "HV_right.Umeas", unit = "V" }}
[plant]
mass = {{ value = 0.0405, unit = "kg" }}
"""
    (tmp_path / "P2.toml").write_text(text, encoding="utf-8")
    made = run_paper(tmp_path / "P2.toml", tmp_path / "paper", Progress(quiet=True))
    for name in FIGURES:
        assert (made.root / "paper" / f"{name}.svg").stat().st_size > 5_000
        assert (made.root / "paper" / f"{name}.pdf").read_bytes().startswith(b"%PDF")
    page = (made.root / "paper.html").read_text(encoding="utf-8")
    assert all(title in page for title in FIGURES.values())
    row = next(row for row in made.table if row["role"] == "train" and row["model"] == "rbf-paper by § 5.1")
    assert row["printed_q"] == 0.021
    assert np.isclose(row["q"], 0.021, atol=0.001)
    again = run_paper(tmp_path / "P2.toml", tmp_path / "paper", Progress(quiet=True))
    assert all(task.up_to_date for task in again.done)
