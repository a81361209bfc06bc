"""`debist diff`: what differs between runs, as records and text."""

import json
import shutil
from pathlib import Path

import pytest
from typer.testing import CliRunner

from cli import app
from pipeline.errors import CorruptArtifactError
from pipeline.store import layout, schemas
from pipeline.store.manifest import Recipe, to_json
from pipeline.store.run_folder import RunFolder
from pipeline.workflow.studies.diff import diff_runs, paired_logs
from tests.export.conftest import planted_run  # noqa: F401 - a fixture


@pytest.fixture
def twin(planted_run, tmp_path):  # noqa: F811
    """The same run with another setting, and one model's error doubled."""
    other = tmp_path / "twin"
    shutil.copytree(planted_run, other)
    run = RunFolder.open(other)
    rows = {name: [to_json(value) for value in column] for name, column in run.read_table(layout.SCORES).items()}
    for i, (model, signal) in enumerate(zip(rows["model"], rows["signal"], strict=True)):
        if (model, signal) == ("rbf-paper", "q"):
            rows["nrmse"][i] *= 2.0
    run.commit(Recipe("test", "1", {}, {}), {layout.SCORES: run.write_table(layout.SCORES, schemas.SCORES, rows, {})})
    settings = dict(run.manifest.prototype)
    settings["identify"] = {**settings["identify"], "basis_functions": 12}
    RunFolder.create(other, settings, Path(run.manifest.prototype_file))
    return other


def test_a_run_beside_itself_is_equal(planted_run):  # noqa: F811
    same = diff_runs([planted_run, planted_run])
    assert same.equal
    assert (same.settings, same.versions, same.sources, same.scores, same.facts) == ((), (), (), (), ())
    result = CliRunner().invoke(app, ["diff", str(planted_run), str(planted_run)])
    assert result.exit_code == 0
    assert "equal: settings, versions, raw logs (SHA-256), NRMSE of free runs, facts, artifacts" in result.stdout


def test_equal_hashes_of_a_damaged_artifact_are_not_called_equal(planted_run, tmp_path):  # noqa: F811
    other = tmp_path / "copy"
    shutil.copytree(planted_run, other)
    content = bytearray((other / layout.MODELS).read_bytes())
    content[len(content) // 2] ^= 1
    (other / layout.MODELS).write_bytes(content)
    with pytest.raises(CorruptArtifactError, match=layout.MODELS):
        diff_runs([other, planted_run])


def test_a_setting_and_a_score_that_differ_are_shown_and_nothing_else(planted_run, twin):  # noqa: F811
    different = diff_runs([planted_run, twin, planted_run])
    assert not different.equal
    assert [(c.key, c.values) for c in different.settings] == [("identify.basis_functions", (10, 12, 10))]
    assert {c.key.partition(" · ")[2] for c in different.scores} == {"rbf-paper · q"}
    for change in different.scores:
        assert change.values == (pytest.approx(change.values[1] / 2.0), change.values[1], change.values[0])
    unequal = [[c.artifact for c in compared if c.state != "equal"] for compared in different.artifacts]
    assert unequal == [[layout.SCORES], []]
    document = json.loads(CliRunner().invoke(app, ["diff", str(planted_run), str(twin), "--json"]).stdout)
    assert document["settings"] == [{"key": "identify.basis_functions", "values": [10, 12]}]
    assert document["equal"] is False
    shown = CliRunner().invoke(app, ["diff", str(planted_run), str(twin)]).stdout
    assert "basis_functions" in shown and "rbf-paper" in shown and "hybrid" not in shown


def test_logs_stand_beside_those_of_their_content_then_of_their_name_then_in_order():
    first = {("train", "a"): "1", ("train", "b"): "2", ("validation", "v"): "3"}
    second = {("train", "b"): "1", ("train", "new"): "9", ("validation", "w"): "4"}
    assert paired_logs(first, second) == {("train", "b"): "a", ("train", "new"): "b", ("validation", "w"): "v"}
    assert paired_logs(first, {("train", "a"): "7", ("train", "c"): "2"}) == {("train", "c"): "b", ("train", "a"): "a"}
    more = {("validation", "x"): "5", ("validation", "y"): "6"}
    assert paired_logs(first, more) == {("validation", "x"): "v"}, "one that is left over has none beside it"
