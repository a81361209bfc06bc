"""The stage on a run folder: page, datasheet and figures as artifacts, nothing done twice, older runs read."""

import json
import shutil
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from pipeline.device.device import device
from pipeline.errors import CorruptArtifactError, InputError
from pipeline.reporting.datasheet_rows import datasheet_tables
from pipeline.reporting.log_figures import LOG_FIGURES
from pipeline.settings.prototype import Prototype, parse_prototype
from pipeline.store import layout, schemas
from pipeline.store.manifest import Recipe
from pipeline.store.run_folder import RunFolder
from pipeline.workflow import stage_check as check, stage_report as report
from pipeline.workflow.engine import bring_up_to_date
from pipeline.workflow.report_data import load_datasheet
from tests.faults.small_run import drawn_once
from tests.prototypes import Silent
from tests.reporting.synthetic import HOSTILE, double_well, log_data

SETTINGS: dict[str, Any] = {
    "name": "P1",
    "logs": {"train": ["a.csv"], "validation": ["b.csv"]},
    "channels": {
        "q": {"channel": HOSTILE, "unit": "mm"},
        "v1": {"channel": "v1", "unit": "kV"},
        "v2": {"channel": "v2", "unit": "kV"},
    },
    "plant": {"mass": {"value": 0.04, "unit": "kg"}},
    "identify": {"models": ["rbf-paper"]},
    "compare": {"models": []},
}


def _prototype() -> Prototype:
    return parse_prototype(json.loads(json.dumps(SETTINGS)), "test")


@pytest.fixture(scope="module")
def unreported(tmp_path_factory: pytest.TempPathFactory) -> RunFolder:
    """A run as the stages before leave it, from the synthetic double well."""
    prototype = _prototype()
    plant, home = device(prototype), tmp_path_factory.mktemp("stage")
    folder = RunFolder.create(home / "run", prototype.model_dump(mode="json"), home / "P1.toml")
    written, rows = {}, []
    for (role, name, _), seed in zip(layout.logs(prototype), (0, 1), strict=True):
        log = log_data(role, name, seed)
        free = dict(log.predictions["rbf"])
        for artifact, schema, columns, notes in (
            (layout.record(role, name), schemas.RECORD, log.record, log.record_notes),
            (layout.kinematics(role, name), schemas.KINEMATICS, log.record | vars(log.motion), log.kinematics_notes),
            (layout.predictions(role, name, "rbf-paper"), schemas.PREDICTIONS, free, log.outcomes["rbf"]),
        ):
            written[artifact] = folder.write_table(artifact, schemas.schema_of(schema, plant), columns, notes)
        score = {column.key: None for column in schemas.SCORES.columns}
        score |= {"log": name, "role": role, "model": "rbf-paper", "signal": "q", "nrmse": 0.01, "rmse": 1e-4}
        rows.append(score | {"unit": "m", "n": 3000, "status": "ok", "switch_accuracy": 1.0})
    tree = {"rbf-paper": double_well().to_tree()}
    written[layout.MODELS] = folder.write_tree(layout.MODELS, tree, {"rbf-paper": {"rank": 40}})
    scores = {column.key: [row[column.key] for row in rows] for column in schemas.SCORES.columns}
    written[layout.SCORES] = folder.write_table(layout.SCORES, schemas.SCORES, scores, {})
    nothing = {column.key: [] for column in schemas.INSTRUMENTS.columns}
    written[layout.INSTRUMENTS] = folder.write_table(layout.INSTRUMENTS, schemas.INSTRUMENTS, nothing, {})
    folder.commit(Recipe("test", "1", {}, {"a.csv": "f" * 64}), written)
    bring_up_to_date(folder, check.tasks(prototype), Silent())
    return folder


@pytest.fixture(scope="module")
def reported(unreported: RunFolder, tmp_path_factory: pytest.TempPathFactory) -> RunFolder:
    """The same with its report."""
    run = _copy(unreported, tmp_path_factory.mktemp("reported"))
    assert [status.up_to_date for status in _report(run)] == [False]
    return run


@pytest.fixture
def run(unreported: RunFolder, tmp_path: Path) -> RunFolder:
    """A copy of the run without a report, to be changed."""
    return _copy(unreported, tmp_path)


def _copy(run: RunFolder, home: Path) -> RunFolder:
    return RunFolder.open(shutil.copytree(run.root, home / "run"))


def _report(run: RunFolder, *, figures: bool = False) -> list[Any]:
    typeface: Any = "sans" if figures else report.made_figures(run)
    return bring_up_to_date(run, report.tasks(_prototype(), None, ("rbf-paper",), figures=typeface), Silent())


def test_the_stage_writes_page_datasheet_and_figures_once(run: RunFolder, reported: RunFolder) -> None:
    with drawn_once():
        _check_figures_are_made_once(run)
    page = run.path(layout.REPORT).read_text(encoding="utf-8")
    assert page == reported.path(layout.REPORT).read_text(encoding="utf-8")


def _check_figures_are_made_once(run: RunFolder) -> None:
    assert [status.up_to_date for status in _report(run, figures=True)] == [False, False]
    names = {name for name in run.manifest.artifacts if name.startswith("figures/")}
    assert {"figures/curves.pdf", "figures/curves.svg", f"figures/train-a-{LOG_FIGURES[0]}.svg"} <= names
    assert all(run.problem(name) is None for name in run.manifest.artifacts)
    page = run.path(layout.REPORT).read_text(encoding="utf-8")
    assert str(run.root) not in page
    assert [status.up_to_date for status in _report(run, figures=True)] == [True, True]
    # Whoever has made figures once finds them made anew with the page.
    run.path("figures/curves.pdf").unlink()
    assert [status.up_to_date for status in _report(run)] == [True, False]


def test_the_same_run_gives_the_same_bytes(reported: RunFolder, tmp_path: Path) -> None:
    run = _copy(reported, tmp_path)
    outputs = [name for name, record in run.manifest.artifacts.items() if record.recipe.stage == "report"]
    first = {name: run.path(name).read_bytes() for name in outputs}
    for name in outputs:
        run.path(name).unlink()
    _report(run)
    assert {name: run.path(name).read_bytes() for name in outputs} == first


def test_a_model_of_another_version_is_named_and_the_page_goes_on(run: RunFolder) -> None:
    tree = {"rbf-paper": {"centres": np.zeros(3)}}
    run.commit(Recipe("test", "1", {}, {}), {layout.MODELS: run.write_tree(layout.MODELS, tree, {})})
    _report(run)
    assert "not loaded" in run.path(layout.REPORT).read_text(encoding="utf-8")
    assert load_datasheet(run.root)["facts_from"] is None


def test_show_prints_the_datasheet_and_finds_damage(unreported: RunFolder, reported: RunFolder, tmp_path: Path) -> None:
    with pytest.raises(InputError, match=r"datasheet\.json"):
        load_datasheet(unreported.root)
    run = _copy(reported, tmp_path)
    (title, _, facts), (_, _, seen), *_ = datasheet_tables(load_datasheet(run.root))
    assert title.startswith("P1: facts from rbf-paper;")
    (rest,) = (row for row in facts if row[0] == "rest position")
    assert rest[1].startswith("−12.000") and rest[2].startswith("12.000") and rest[2].endswith("mm")
    assert {len(row) for row in facts} == {3}
    assert "rest position" in [row[0] for row in seen]
    run.path(layout.DATASHEET).write_text("{}", encoding="utf-8")
    with pytest.raises(CorruptArtifactError):
        load_datasheet(run.root)
