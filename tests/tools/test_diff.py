"""`debist diff`: what differs between two runs, as records, text and page."""

import json
import shutil
import sys
from dataclasses import replace
from pathlib import Path

import pytest
from typer.testing import CliRunner

from cli import app
from pipeline.errors import CorruptArtifactError
from pipeline.runs import layout, schemas
from pipeline.runs.comparison import Change
from pipeline.runs.manifest import Recipe, to_json
from pipeline.runs.run_folder import RunFolder
from pipeline.tools.diff import diff_runs, write_diff_page

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "export"))
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
    found = diff_runs(planted_run, planted_run)
    assert found.equal
    assert (found.settings, found.versions, found.sources, found.only) == ((), (), (), ((), ()))
    result = CliRunner().invoke(app, ["diff", str(planted_run), str(planted_run)])
    assert result.exit_code == 0
    assert "equal: settings, versions, raw logs (SHA-256), NRMSE of free runs, artifacts" in result.stdout


def test_equal_hashes_of_a_damaged_artifact_are_not_called_equal(planted_run, tmp_path):  # noqa: F811
    other = tmp_path / "copy"
    shutil.copytree(planted_run, other)
    content = bytearray((other / layout.MODELS).read_bytes())
    content[len(content) // 2] ^= 1
    (other / layout.MODELS).write_bytes(content)
    with pytest.raises(CorruptArtifactError, match=layout.MODELS):
        diff_runs(other, planted_run)


def test_free_runs_of_other_logs_are_not_called_equal(planted_run, twin):  # noqa: F811
    run = RunFolder.open(twin)
    rows = {name: [to_json(value) for value in column] for name, column in run.read_table(layout.SCORES).items()}
    rows["log"] = [f"other-{log}" for log in rows["log"]]
    run.commit(Recipe("test", "2", {}, {}), {layout.SCORES: run.write_table(layout.SCORES, schemas.SCORES, rows, {})})
    shown = CliRunner().invoke(app, ["diff", str(planted_run), str(twin)]).stdout
    assert "no free runs to compare" in shown
    assert "NRMSE" not in next(line for line in shown.splitlines() if line.startswith("equal:"))


def test_a_setting_and_a_score_that_differ_are_shown_and_nothing_else(planted_run, twin):  # noqa: F811
    found = diff_runs(planted_run, twin)
    assert not found.equal
    assert [(c.key, c.one, c.other) for c in found.settings] == [("identify.basis_functions", 10, 12)]
    apart = [(p.model, p.signal) for p in found.scores if p.ratio is not None and p.ratio != 1.0]
    assert set(apart) == {("rbf-paper", "q")}
    assert all(p.ratio == pytest.approx(2.0) for p in found.scores if (p.model, p.signal) == ("rbf-paper", "q"))
    assert [c.artifact for c in found.artifacts if c.state != "equal"] == [layout.SCORES]
    document = json.loads(CliRunner().invoke(app, ["diff", str(planted_run), str(twin), "--json"]).stdout)
    assert document["settings"] == [{"key": "identify.basis_functions", "one": 10, "other": 12}]
    assert document["equal"] is False


def test_the_page_loads_nothing_and_overlays_both_runs(planted_run, twin, tmp_path):  # noqa: F811
    target = write_diff_page(diff_runs(planted_run, twin), planted_run, twin, tmp_path / "diff.html")
    page = target.read_text(encoding="utf-8")
    assert "default-src" in page and "src=" not in page and "style=" not in page
    assert page.count('class="viewer"') == 2
    assert "run, hybrid: fit 100.0 %" in page and "twin, hybrid: fit 100.0 %" in page
    assert "restoring force F" in page


def test_free_runs_on_unlike_logs_are_not_laid_over_one_another(planted_run, twin, tmp_path):  # noqa: F811
    found = replace(diff_runs(planted_run, twin), sources=(Change("validation/b", "1f", "2e"),))
    page = write_diff_page(found, planted_run, twin, tmp_path / "diff.html").read_text(encoding="utf-8")
    assert page.count('class="viewer"') == 1
    assert "Free runs on validation/b are not drawn: the raw logs differ." in page


def test_a_folder_without_a_run_is_one_line(planted_run, tmp_path):  # noqa: F811
    result = CliRunner().invoke(app, ["diff", str(planted_run), str(tmp_path)])
    assert result.exit_code == 2
    assert "no run here" in result.stderr


def test_a_page_is_html_and_nothing_else(planted_run, twin, tmp_path):  # noqa: F811
    result = CliRunner().invoke(app, ["diff", str(planted_run), str(twin), "-o", str(tmp_path / "diff.pdf")])
    assert (result.exit_code, list(tmp_path.glob("*.pdf"))) == (2, [])
    assert "name it *.html" in result.stderr
