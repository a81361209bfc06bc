"""`verify` looks at everything and names the unknown; `repair` sets aside and rebuilds; a signature tells who."""

import json
import shutil
from pathlib import Path

import pytest
from typer.testing import CliRunner

from cli import app
from pipeline.errors import CorruptArtifactError, InputError
from pipeline.runs.outputs import note_written
from pipeline.runs.run_folder import RunFolder
from pipeline.runs.verification import SIGNATURE
from pipeline.tools.verify import repair_run, verify_all, verify_everything
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
    found, _ = verify_everything(run)
    assert (found.problems, found.unknown) == ([], [])
    assert found.checked == len(content(run))


def test_a_stage_manifest_that_says_otherwise_is_a_problem(run):
    """Workflow engines trust it: a stage would count as done that is not."""
    path = run / "stages" / "identify.json"
    said = json.loads(path.read_text())
    said["content"]["model.h5"] = "0" * 64
    path.write_text(json.dumps(said))
    (run / "stages" / "ingest.json").write_text("[" * 100_000)
    assert [problem["artifact"] for problem in verify_everything(run)[0].problems] == [
        "stages/identify.json",
        "stages/ingest.json",
    ]
    result = debist("verify", run)
    assert result.exit_code == 4 and "stages/identify.json (stage identify) does not say what" in result.stderr


def test_figures_of_studies_and_exports_are_checked(run):
    assert debist("study", "alpha", run).exit_code == 0
    assert debist("export", run, "--to", "json", "--model", "rbf-paper").exit_code == 0
    assert verify_everything(run)[0].unknown == [] and verify_everything(run)[0].problems == []
    (document,) = (run / "exports").glob("[!.]*.json")
    for path in (document, run / "studies" / "alpha.svg", run / "studies" / "alpha.parquet"):
        path.write_bytes(path.read_bytes() + b" ")
    assert {problem["artifact"] for problem in verify_everything(run)[0].problems} == {
        "studies/alpha.parquet",
        "studies/alpha.svg",
        f"exports/{document.name}",
    }


def test_what_debist_did_not_write_is_named(run, tmp_path):
    (run / "notes.txt").write_text("mine")
    (run / "train" / "extra.parquet").write_text("x")
    (run / "link").symlink_to(tmp_path)
    found, _ = verify_everything(run)
    assert (found.problems, found.unknown) == ([], ["link", "notes.txt", "train/extra.parquet"])
    result = debist("verify", run)
    assert result.exit_code == 0 and "not written by debist: notes.txt" in result.stderr


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


def test_a_signature_tells_whether_anything_was_replaced(run, tmp_path):
    key, other = tmp_path / "lab.key", tmp_path / "other.key"
    assert debist("sign", run, "--key", key, "--new-key").exit_code == 0
    assert key.stat().st_mode & 0o777 == 0o600
    result = debist("verify", run, "--key", key)
    assert result.exit_code == 0 and "all intact; signed 20" in result.stdout
    assert verify_everything(run)[0].unknown == []
    other.write_text("0123456789abcdef0123")
    other.chmod(0o600)
    with pytest.raises(CorruptArtifactError, match="was signed with another key"):
        verify_everything(run, other)

    # whoever may rewrite the run can give it a date or hashes that fit, but no signature
    signature = (run / SIGNATURE).read_text()
    (run / SIGNATURE).write_text(signature.replace('"signed": "20', '"signed": "19'))
    with pytest.raises(CorruptArtifactError, match="was changed after it was signed"):
        verify_everything(run, key)
    (run / SIGNATURE).write_text(signature)
    (run / "exports").mkdir(exist_ok=True)
    (run / "exports" / "controller.c").write_text("/* of somebody else */")
    note_written(run / "exports", ["controller.c"], "export")
    assert verify_everything(run)[0].problems == []
    with pytest.raises(CorruptArtifactError, match="was changed after it was signed"):
        verify_everything(run, key)
    shutil.rmtree(run / "exports")

    folder = RunFolder.open(run)
    record = folder.record("scores.parquet")
    folder.commit(record.recipe, {"scores.parquet": folder.write_bytes("scores.parquet", b"better", {})})
    assert verify_everything(run)[0].problems == []
    with pytest.raises(CorruptArtifactError, match="was changed after it was signed"):
        verify_everything(run, key)
    for spoilt in ("{}", "[" * 100_000, '{"hmac_sha256": "é\\ud800", "key": 1, "signed": 2}'):
        (run / SIGNATURE).write_text(spoilt)
        with pytest.raises(CorruptArtifactError, match=r"damaged|signed with another key"):
            verify_everything(run, key)
    (run / SIGNATURE).unlink()
    with pytest.raises(CorruptArtifactError, match="is not signed"):
        verify_everything(run, key)


def test_a_damaged_run_is_not_signed_and_a_bad_key_is_none(run, tmp_path):
    key = tmp_path / "lab.key"
    key.write_text("short")
    key.chmod(0o600)
    assert "is no key" in debist("sign", run, "--key", key).stderr
    key.write_text("long enough to be one")
    key.chmod(0o644)
    assert "everybody can read this key" in debist("sign", run, "--key", key).stderr
    key.chmod(0o600)
    assert "is there already" in debist("sign", run, "--key", key, "--new-key").stderr
    (run / "model.h5").write_text("x")
    result = debist("sign", run, "--key", key)
    assert result.exit_code == 4 and "model.h5" in result.stderr and not (run / SIGNATURE).exists()


def test_no_stage_manifest_outlives_its_content(run):
    """Before other content becomes valid, the stage manifest that says otherwise is withdrawn."""
    folder = RunFolder.open(run)
    recipe = folder.record("scores.parquet").recipe
    written = {"scores.parquet": folder.write_bytes("scores.parquet", b"other", {})}
    folder.commit(recipe, written)
    assert not (run / "stages" / f"{recipe.stage}.json").exists()
    assert verify_everything(run)[0].problems == []


def test_what_a_task_notes_reads_the_same_after_the_run_was_opened_anew(tmp_path):
    """Or a page that is drawn after an interruption has its rows in another order."""
    run = RunFolder.create(tmp_path / "run", {}, tmp_path / "P.toml")
    from pipeline.runs.manifest import Recipe

    notes = {"b": 1, "a": {"z": 1, "y": [{"q": 1, "p": 2}]}}
    run.commit(Recipe("s", "1", {}, {}), {"one.json": run.write_text("one.json", "x", notes)})
    assert json.dumps(run.record("one.json").notes) == json.dumps(notes)
    assert json.dumps(RunFolder.open(run.root).record("one.json").notes) == json.dumps(notes)
