"""A batch: one failing alone, the fleet table, a rerun that does nothing, names that stay apart."""

import csv
import json
import os
import signal
import sys
import time
from pathlib import Path

import pyarrow.parquet as pq
import pytest
from typer.testing import CliRunner

from cli import app, debist
from pipeline.errors import InputError
from pipeline.system.machine import ONE_THREAD
from pipeline.workflow.batch import Execution, Outcome, Worker, run_batch, write_fleet_tables
from pipeline.workflow.members import Member, members, prototype_files
from pipeline.workflow.progress import failure_file
from tests.prototypes import content, motion_prototype

RUNNER = CliRunner()


def test_one_fails_alone(tmp_path: Path) -> None:
    fleet, output = tmp_path / "fleet", tmp_path / "runs"
    fleet.mkdir()
    for name, gain in (("a", 1.0), ("b", 0.97)):
        motion_prototype(fleet, name, gain)
    (fleet / "b.csv").write_text("t,q\n")
    result = RUNNER.invoke(app, ["batch", str(fleet), "-o", str(output), "--jobs", "2", "--no-report", "--json"])
    assert result.exit_code == 6
    by_name = {entry["name"]: entry for entry in json.loads(result.stdout)["prototypes"]}
    assert (by_name["a"]["exit_code"], by_name["b"]["exit_code"]) == (0, 2)
    assert "b.csv" in by_name["b"]["reason"]
    rows = pq.read_table(output / "fleet.parquet").to_pylist()
    assert {row["prototype"] for row in rows if row["nrmse"] is not None} == {"a"}
    assert [row["reason"] for row in rows if row["prototype"] == "b"] == [by_name["b"]["reason"]]
    assert "1 of 2 prototypes were run to the end, 1 failed" in (output / "fleet.html").read_text()


class Told:
    """An observer that remembers."""

    def __init__(self) -> None:
        self.begun: list[str] = []
        self.ended: list[Outcome] = []

    def started(self, name: str) -> None:
        self.begun.append(name)

    def finished(self, outcome: Outcome) -> None:
        self.ended.append(outcome)


def killed_or_debist(arguments: list[str]) -> None:
    """`debist`, but the prototype b kills its process, as the system does where memory runs out."""
    if arguments[1].endswith("b.toml"):
        os.kill(os.getpid(), signal.SIGKILL)
    debist(arguments)


def test_neither_a_killed_worker_nor_the_number_of_processes_changes_a_result(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    named = members([motion_prototype(tmp_path, name, gain) for name, gain in (("b", 0.97), ("a", 1.0))])
    told = Told()
    one = run_batch(named, tmp_path / "one", told, debist, Execution(1, report=False))
    assert told.begun == [outcome.name for outcome in told.ended] == ["b", "a"]
    assert [outcome.name for outcome in one] == ["a", "b"]
    assert all(outcome.processor_seconds > 0.1 and 1e7 < outcome.memory_bytes < 1e9 for outcome in one)

    killed = run_batch(named, tmp_path / "two", Told(), killed_or_debist, Execution(2, report=False))
    assert [(outcome.name, outcome.exit_code) for outcome in killed] == [("a", 0), ("b", -9)]
    assert "SIGKILL" in killed[1].reason
    before = (tmp_path / "two/a/manifest.json").stat().st_mtime_ns  # a rerun does only what is missing
    assert not any(
        outcome.failed for outcome in run_batch(named, tmp_path / "two", Told(), debist, Execution(2, report=False))
    )
    assert (tmp_path / "two/a/manifest.json").stat().st_mtime_ns == before
    page = (tmp_path / "two/fleet.html").read_text()  # without reports it has the errors alone
    assert "2 of 2 prototypes were run to the end" in page and "NRMSE of q in %" in page
    for name in ("a", "b"):
        assert content(tmp_path / "one" / name) == content(tmp_path / "two" / name)
    assert (tmp_path / "one/fleet.csv").read_bytes() == (tmp_path / "two/fleet.csv").read_bytes()
    assert pq.read_table(tmp_path / "one/fleet.parquet").equals(pq.read_table(tmp_path / "two/fleet.parquet"))

    monkeypatch.setattr("pipeline.workflow.batch.Worker", None)  # what is up to date needs no process
    assert not any(
        outcome.failed for outcome in run_batch(named, tmp_path / "two", Told(), debist, Execution(2, report=False))
    )

    (tmp_path / "one/fleet.csv").unlink()
    arguments = ["batch", str(tmp_path), "-o", str(tmp_path / "one"), "--collect"]
    assert RUNNER.invoke(app, arguments).exit_code == 0
    assert (tmp_path / "one/fleet.csv").read_bytes() == (tmp_path / "two/fleet.csv").read_bytes()


@pytest.mark.parametrize("limit", ["-1s", "0 s", "1us", "1e30s", "1e9 d"])
def test_a_time_limit_that_no_run_could_have_is_refused(tmp_path: Path, limit: str) -> None:
    (tmp_path / "a.toml").write_text("name = 1")
    result = RUNNER.invoke(app, ["batch", str(tmp_path), "-o", str(tmp_path / "runs"), "--time-limit", limit])
    assert result.exit_code == 2 and "--time-limit" in result.stderr and "1 s to 1e7 s" in result.stderr
    assert not (tmp_path / "runs").exists()


def test_an_interrupted_batch_does_not_wait_for_what_it_runs(tmp_path: Path) -> None:
    class Interrupting(Told):
        def started(self, name: str) -> None:
            super().started(name)
            if len(self.begun) == 2:
                raise KeyboardInterrupt

    told, began = Interrupting(), time.monotonic()
    with pytest.raises(KeyboardInterrupt):
        run_batch([Member(n, tmp_path / n) for n in "ab"], tmp_path / "runs", told, _sleeping, Execution(2))
    assert time.monotonic() - began < 60.0
    assert (told.begun, told.ended) == (["a", "b"], [])


def _sleeping(arguments: list[str]) -> None:
    time.sleep(120)


def test_what_was_not_started_is_listed(tmp_path: Path) -> None:
    for name in ("a", "b"):
        (tmp_path / f"{name}.toml").write_text("name = 1")
    result = RUNNER.invoke(app, ["batch", str(tmp_path), "-o", str(tmp_path / "runs"), "--fail-fast", "--json"])
    assert result.exit_code == 6
    told = {entry["name"]: entry for entry in json.loads(result.stdout)["prototypes"]}
    assert [told[name]["exit_code"] for name in "ab"] == [2, None]
    assert told["b"]["reason"] == "not started: a failed, and --fail-fast was given"
    rows = pq.read_table(tmp_path / "runs/fleet.parquet").to_pylist()
    assert [(row["prototype"], row["exit_code"]) for row in rows] == [("a", 2), ("b", None)]
    table = RUNNER.invoke(app, ["batch", str(tmp_path), "-o", str(tmp_path / "runs"), "--fail-fast"])
    assert table.stdout.count("not started") == 2


def _threads(arguments: list[str]) -> None:
    sys.exit(":".join(os.environ[name] for name in ONE_THREAD))


def test_numerical_libraries_of_a_worker_have_one_thread(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    for variable in ONE_THREAD:
        monkeypatch.setenv(variable, "7")
    with Worker(_threads, "x", tmp_path / "x.toml", tmp_path) as worker:
        worker.outcome()
    assert failure_file(tmp_path, "x").read_text().splitlines()[-1] == "1:1:1"


def _soiling(arguments: list[str]) -> None:
    before = os.environ.get("SOILED"), "soiled" in sys.modules
    os.environ["SOILED"], sys.modules["soiled"] = "1", sys
    os.chdir("/")
    print("noise on standard output")
    sys.exit(f"debist: {before} {Path.cwd() == Path('/')}")


def test_no_prototype_meets_what_another_left(tmp_path: Path) -> None:
    for name in "ab":
        with Worker(_soiling, name, tmp_path / "x.toml", tmp_path) as worker:
            worker.outcome()
        assert failure_file(tmp_path, name).read_text().splitlines()[-1] == "debist: (None, False) True"


def _unknown(arguments: list[str]) -> None:
    raise ZeroDivisionError("of nobody's making")


def test_an_unknown_exception_keeps_its_traceback_until_the_prototype_does_well(tmp_path: Path) -> None:
    named = members([motion_prototype(tmp_path, "a")])
    (failed,) = run_batch(named, tmp_path / "runs", Told(), _unknown, Execution(report=False))
    kept = failure_file(tmp_path / "runs", "a")
    assert failed.exit_code == 1 and "ZeroDivisionError" in failed.reason and str(kept) in failed.reason
    assert "Traceback" in kept.read_text() and "in _unknown" in kept.read_text()
    (done,) = run_batch(named, tmp_path / "runs", Told(), debist, Execution(report=False))
    assert done.exit_code == 0 and not kept.exists()


def _takes_memory(arguments: list[str]) -> None:
    resource = pytest.importorskip("resource")
    resource.setrlimit(resource.RLIMIT_AS, (1 << 32, 1 << 32))
    bytes(1 << 33)


def test_memory_that_runs_out_ends_the_prototype_that_takes_it(tmp_path: Path) -> None:
    with Worker(_takes_memory, "a", tmp_path / "x.toml", tmp_path) as worker:
        outcome = worker.outcome()
    assert outcome.exit_code == 1 and outcome.reason.startswith("a bug of debist: MemoryError")


def test_what_is_not_there_is_said(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="no settings file"):
        prototype_files([tmp_path], tmp_path)
    with pytest.raises(InputError, match="no such file"):
        prototype_files([tmp_path / "x.toml"], tmp_path)


def test_two_of_one_name_would_share_a_folder(tmp_path: Path) -> None:
    (tmp_path / "sub").mkdir()
    pair = [motion_prototype(tmp_path, "a"), motion_prototype(tmp_path / "sub", "a")]
    with pytest.raises(InputError, match="named 'a'"):
        members(pair)


def test_no_cell_of_the_csv_is_a_formula(tmp_path: Path) -> None:
    write_fleet_tables(tmp_path, [Outcome("x", tmp_path, 2, "=cmd()|' /C calc'!A0", 0.1)])
    with (tmp_path / "fleet.csv").open(newline="") as stream:
        assert next(csv.DictReader(stream))["reason"].startswith("'=cmd")
