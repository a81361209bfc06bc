"""`verify` looks at everything and names what does not belong; `repair` sets aside and rebuilds."""

import json
import shutil
from pathlib import Path

import pytest
from typer.testing import CliRunner

from cli import app
from pipeline.errors import InputError
from pipeline.runs.lock import run_lock
from pipeline.runs.run_folder import RunFolder
from pipeline.tools.verify import Verified, repair_run, subset, verify_all, verify_everything
from tests.faults.conftest import Bench, spoil
from tests.faults.small_run import drawn_once
from tests.prototypes import Silent, content, logs_read_once


@pytest.fixture(scope="module")
def bench(tmp_path_factory):
    """The small run of the fault tests."""
    with drawn_once(), logs_read_once():
        yield Bench(tmp_path_factory.mktemp("verification"))


@pytest.fixture
def run(bench) -> Path:
    bench.start("intact")
    return bench.run


def debist(*arguments: object):
    return CliRunner().invoke(app, [str(argument) for argument in arguments])


def test_an_intact_run_is_intact_to_the_last_file(run):
    found = verify_everything(run)
    assert (found.problems, found.unknown) == ([], [])
    assert found.checked == len(content(run))


SPOILT = {
    "emptied": lambda path: path.write_text(""),
    "without content": lambda path: path.write_text(json.dumps({"stage": path.stem, "content": {}}, indent=1) + "\n"),
    "deleted": Path.unlink,
    "nested": lambda path: path.write_text("[" * 100_000),
}


@pytest.mark.parametrize("how", SPOILT)
def test_a_stage_manifest_that_is_not_as_written_is_a_problem(run, how):
    """Workflow engines trust it: a stage would count as done that is not."""
    SPOILT[how](run / "stages" / "identify.json")
    assert [problem["artifact"] for problem in verify_everything(run).problems] == ["stages/identify.json"]
    result = debist("verify", run)
    assert result.exit_code == 4 and "stages/identify.json (stage identify)" in result.stderr
    repair_run(run, Silent())
    assert verify_everything(run).intact


def test_an_invented_stage_manifest_is_named(run):
    (run / "stages" / "simulate.json").write_text('{"stage": "simulate", "content": {}}')
    result = debist("verify", run)
    assert result.exit_code == 4 and "does not belong to the run: stages/simulate.json" in result.stderr


def test_figures_of_studies_and_exports_are_checked(run):
    assert debist("study", "alpha", run).exit_code == 0
    assert debist("export", run, "--to", "json", "--model", "rbf-paper").exit_code == 0
    assert verify_everything(run).intact
    (document,) = (run / "exports").glob("[!.]*.json")
    for path in (document, run / "studies" / "alpha.svg", run / "studies" / "alpha.parquet"):
        path.write_bytes(path.read_bytes() + b" ")
    assert {problem["artifact"] for problem in verify_everything(run).problems} == {
        "studies/alpha.parquet",
        "studies/alpha.svg",
        f"exports/{document.name}",
    }
    document.unlink()
    result = debist("verify", run)
    assert result.exit_code == 4 and f"exports/{document.name} (stage export) is missing" in result.stderr


PLANTED = (
    "notes.txt", "train/extra.parquet", "model.h5.corrupt-20200101T000000000000", ".debist-written.json",
    "exports/foreign.c", "figures/new.svg",
)  # fmt: skip
LEFT = (
    ".model.h5.debist-staged", "train/.x.1.debist-tmp", "exports/.a.debist-tmp/model.c", ".lock-holder.json",
)  # fmt: skip


def test_what_does_not_belong_to_the_run_is_named(run, tmp_path):
    (run / "link").symlink_to(tmp_path)
    for name in (*PLANTED, *LEFT):
        (run / name).parent.mkdir(parents=True, exist_ok=True)
        (run / name).write_text("x")
    found = verify_everything(run)
    assert found == Verified(found.checked, [], sorted((*PLANTED, "link")), sorted(LEFT))
    result = debist("verify", run)
    assert result.exit_code == 4 and "7 files do not belong to the run" in result.stderr
    for name in (*PLANTED, "link"):
        assert f"does not belong to the run: {name}" in result.stderr
        (run / name).unlink()
    result = debist("verify", run)
    assert result.exit_code == 4 and "a run was interrupted; `debist run` completes it" in result.stderr
    with run_lock(run):
        assert debist("verify", run).exit_code == 0, "they are of the process that writes"


def test_a_run_removes_what_an_interrupted_one_left(bench, run):
    for name in LEFT:
        (run / name).parent.mkdir(parents=True, exist_ok=True)
        (run / name).write_text("x")
    bench.make()
    assert verify_everything(run).intact


def test_all_runs_of_a_folder_are_verified_and_the_fleet_tables(run, tmp_path):
    from pipeline.batch.batch import collect_batch

    for name in ("a", "b"):
        shutil.copytree(run, tmp_path / name)
    collect_batch([(name, tmp_path / f"{name}.toml") for name in ("a", "b")], tmp_path)
    assert [(found.root.name, found.intact) for found in verify_all(tmp_path)] == [
        ("a", True),
        ("b", True),
        (tmp_path.name, True),
    ]
    (tmp_path / "a" / "manifest.json").write_text("{}")
    (tmp_path / "b" / "scores.parquet").write_text("x")
    (tmp_path / "fleet.csv").write_text("x")
    assert [found.intact for found in verify_all(tmp_path)] == [False, False, False]
    result = debist("verify", "--all", tmp_path)
    assert result.exit_code == 4 and "3 of 3 are not intact" in result.stderr
    document = json.loads(debist("verify", "--all", tmp_path, "--json").stdout)
    assert len(document["runs"]) == 3


def test_the_parts_of_a_subset_read_every_file_once(run):
    whole = verify_everything(run)
    (run / "scores.parquet").write_text("x")
    parts = [verify_everything(run, subset(f"{number}/3")) for number in (1, 2, 3)]
    assert sum(part.checked for part in parts) == whole.checked
    assert [part.checked + part.left_out for part in parts] == [whole.checked] * 3
    assert [problem["artifact"] for part in parts for problem in part.problems] == ["scores.parquet"]


def test_a_share_is_drawn_anew_and_what_is_none_is_refused(run):
    assert verify_everything(run, subset("100%")).left_out == 0
    half = subset("50 %")
    assert 300 < sum(half(str(number)) for number in range(1000)) < 700
    said = debist("verify", run, "--subset", "1/2")
    assert said.exit_code == 0 and " of " in said.stdout
    for wrong in ("0%", "101%", "3/2", "x"):
        assert debist("verify", run, "--subset", wrong).exit_code == 2
    assert "without --subset" in debist("verify", run, "--subset", "1/2", "--against", run).stderr


def test_repair_sets_aside_and_rebuilds(bench, run):
    import random

    for name in ("model.h5", "train/train/record.parquet"):
        spoil(run / name, random.Random(1))
    (run / "stages" / "identify.json").write_text("x")
    done, found = repair_run(run, Silent())
    assert (found.problems, found.unknown) == ([], [])
    assert [status.stage for status in done if not status.up_to_date] == ["ingest", "identify"]
    assert content(run) == bench.expected
    assert len(list(run.rglob("*.corrupt-*"))) == 2
    assert all(status.up_to_date for status in repair_run(run, Silent())[0])


def test_repair_of_a_run_without_a_manifest_needs_the_settings(bench, run):
    (run / "manifest.json").write_text("{}")
    with pytest.raises(InputError, match=r"give its settings file: `debist repair"):
        repair_run(run, Silent())
    _, found = repair_run(run, Silent(), bench.prototype)
    # That figures for a paper were wanted stood in the manifest alone; `debist report --figures` makes them again.
    wanted = {name: digest for name, digest in bench.expected.items() if not name.startswith("figures/")}
    assert found.problems == [] and content(run) == wanted
    (aside,) = run.parent.glob(f"{run.name}.corrupt-*")
    assert (aside / "manifest.json").read_text() == "{}" and (aside / "model.h5").is_file()
    shutil.rmtree(aside)


def test_no_stage_manifest_outlives_its_content(run):
    """Before other content becomes valid, the stage manifest that says otherwise is withdrawn."""
    folder = RunFolder.open(run)
    recipe = folder.record("scores.parquet").recipe
    written = {"scores.parquet": folder.write_bytes("scores.parquet", b"other", {})}
    folder.commit(recipe, written)
    assert not (run / "stages" / f"{recipe.stage}.json").exists()
    assert verify_everything(run).problems == []


def test_what_a_task_notes_reads_the_same_after_the_run_was_opened_anew(tmp_path):
    """Or a page that is drawn after an interruption has its rows in another order."""
    run = RunFolder.create(tmp_path / "run", {}, tmp_path / "P.toml")
    from pipeline.runs.manifest import Recipe

    notes = {"b": 1, "a": {"z": 1, "y": [{"q": 1, "p": 2}]}}
    run.commit(Recipe("s", "1", {}, {}), {"one.json": run.write_text("one.json", "x", notes)})
    assert json.dumps(run.record("one.json").notes) == json.dumps(notes)
    assert json.dumps(RunFolder.open(run.root).record("one.json").notes) == json.dumps(notes)
