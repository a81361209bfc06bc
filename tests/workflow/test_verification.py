"""`verify` looks at everything and names what does not belong; a run sets aside what is damaged."""

import json
import random
from pathlib import Path

import pytest
from typer.testing import CliRunner

from cli import app
from pipeline.store.atomic import run_lock
from pipeline.workflow.verify import Verified, verify_everything
from tests.faults.conftest import Bench, spoil
from tests.faults.small_run import drawn_once
from tests.prototypes import content, logs_read_once


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
def test_a_stage_manifest_that_is_not_as_written_is_a_problem(bench, run, how):
    """Workflow engines trust it: a stage would count as done that is not."""
    SPOILT[how](run / "stages" / "identify.json")
    assert [problem["artifact"] for problem in verify_everything(run).problems] == ["stages/identify.json"]
    result = debist("verify", run)
    assert result.exit_code == 4 and "stages/identify.json (stage identify)" in result.stderr
    bench.make()
    assert verify_everything(run).intact


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


def test_a_run_sets_aside_what_is_damaged_and_makes_it_anew(bench, run):
    for name in ("model.h5", "train/train/record.parquet"):
        spoil(run / name, random.Random(1))
    (run / "stages" / "identify.json").write_text("x")
    bench.make()
    found = verify_everything(run)
    assert (found.problems, found.unknown) == ([], [])
    assert content(run) == bench.expected
    assert len(list(run.rglob("*.corrupt-*"))) == 2
