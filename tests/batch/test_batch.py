"""A batch: one failing alone, the fleet table, a rerun that does nothing, names that stay apart."""

import csv
import json
import os
import resource
import signal
import subprocess
import sys
import threading
import time
from pathlib import Path

import pyarrow.parquet as pq
import pytest
from typer.testing import CliRunner

from cli import app
from pipeline.batch.batch import named_prototypes, prototype_files, run_batch
from pipeline.batch.fleet import write_fleet_tables
from pipeline.batch.worker import ONE_THREAD, Outcome, run_worker
from pipeline.child_processes import died_of
from pipeline.errors import InputError
from pipeline.process_copies import CAN_COPY
from tests.prototypes import content, motion, settings, write_csv, write_program

RUNNER = CliRunner()


def _prototype(folder: Path, name: str, gain: float = 1.0) -> Path:
    """Ten seconds of a double well under random pulses, times a factor."""
    write_csv(folder / f"{name}.csv", *motion(10.0, 200.0, 1, gain=gain, noise=3e-6))
    path = folder / f"{name}.toml"
    path.write_text(settings(name=name, train=f"{name}.csv"))
    return path


def test_one_fails_alone(tmp_path: Path) -> None:
    fleet, output = tmp_path / "fleet", tmp_path / "runs"
    fleet.mkdir()
    for name, gain in (("a", 1.0), ("b", 0.97)):
        _prototype(fleet, name, gain)
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


def _kill_child_that_works_on(name: str) -> None:
    """Wait for the process that bears the prototype's name, let it begin, and kill it."""
    for _ in range(6000):
        for folder in Path("/proc").glob("[0-9]*"):
            try:
                title, ancestor = (folder / "comm").read_text().strip(), _parent(_parent(int(folder.name)))
            except (OSError, ValueError):
                continue
            if title == name and ancestor == os.getpid():
                time.sleep(0.2)
                os.kill(int(folder.name), signal.SIGKILL)
                return
        time.sleep(0.01)


def _parent(pid: int) -> int:
    return int(Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()[1])


@pytest.mark.skipif(not Path("/proc/self/stat").exists(), reason="finds the process under /proc")
def test_neither_a_killed_worker_nor_the_number_of_processes_changes_a_result(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    named = named_prototypes([_prototype(tmp_path, name, gain) for name, gain in (("b", 0.97), ("a", 1.0))])
    told = Told()
    one = run_batch(named, tmp_path / "one", 1, told, program="cli:app", report=False)
    assert told.begun == [outcome.name for outcome in told.ended] == ["b", "a"]
    assert [outcome.name for outcome in one] == ["a", "b"]
    ours = 1024 * resource.getrusage(resource.RUSAGE_SELF).ru_maxrss  # a child is charged with it from the fork on
    assert all(
        outcome.processor_seconds > 0.1 and 1e7 < outcome.memory_bytes < max(1e9, 1.01 * ours) for outcome in one
    )

    killer = threading.Thread(target=_kill_child_that_works_on, args=("b",))
    killer.start()
    killed = run_batch(named, tmp_path / "two", 2, Told(), program="cli:app", report=False)
    killer.join()
    assert [(outcome.name, outcome.exit_code, outcome.reason) for outcome in killed] == [
        ("a", 0, ""),
        ("b", -9, died_of(9)),
    ]
    before = (tmp_path / "two/a/manifest.json").stat().st_mtime_ns  # a rerun does only what is missing
    assert not any(
        outcome.failed for outcome in run_batch(named, tmp_path / "two", 2, Told(), program="cli:app", report=False)
    )
    assert (tmp_path / "two/a/manifest.json").stat().st_mtime_ns == before
    page = (tmp_path / "two/fleet.html").read_text()  # without reports it has the errors alone
    assert "2 of 2 prototypes were run to the end" in page and "NRMSE of q in %" in page
    for name in ("a", "b"):
        assert content(tmp_path / "one" / name) == content(tmp_path / "two" / name)
    assert (tmp_path / "one/fleet.csv").read_bytes() == (tmp_path / "two/fleet.csv").read_bytes()
    assert pq.read_table(tmp_path / "one/fleet.parquet").equals(pq.read_table(tmp_path / "two/fleet.parquet"))

    monkeypatch.setattr("pipeline.batch.batch.Workers.run", None)  # what is up to date needs no process
    assert not any(
        outcome.failed for outcome in run_batch(named, tmp_path / "two", 2, Told(), program="cli:app", report=False)
    )

    (tmp_path / "one/fleet.csv").unlink()
    arguments = ["batch", str(tmp_path), "-o", str(tmp_path / "one"), "--collect"]
    assert RUNNER.invoke(app, arguments).exit_code == 0
    assert (tmp_path / "one/fleet.csv").read_bytes() == (tmp_path / "two/fleet.csv").read_bytes()


def test_a_worker_ends_with_its_batch(tmp_path: Path) -> None:
    sleeping = "import os, pathlib, time; pathlib.Path('pid').write_text(str(os.getpid())); time.sleep(60)"
    name = write_program(tmp_path / "modules", sleeping)
    program = (
        f"import sys; sys.path.insert(0, {str(tmp_path / 'modules')!r}); from pathlib import Path; "
        f"from pipeline.batch import worker; worker.run_worker({name!r}, 'x', Path('x'), Path())"
    )
    batch = subprocess.Popen([sys.executable, "-c", program], cwd=tmp_path)
    for _ in range(1000):
        if (tmp_path / "pid").exists() and (pid := (tmp_path / "pid").read_text()):
            break
        time.sleep(0.01)
    batch.kill()
    batch.wait()
    for _ in range(1000):
        try:
            os.kill(int(pid), 0)
            if Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()[0] == "Z":
                return  # dead, and not yet collected by whoever inherits it
        except (ProcessLookupError, FileNotFoundError):
            return
        time.sleep(0.01)
    os.kill(int(pid), signal.SIGKILL)
    pytest.fail("the worker went on without its batch")


@pytest.mark.parametrize("limit", ["-1s", "0 s", "1us", "1e30s", "1e9 d"])
def test_a_time_limit_that_no_run_could_have_is_refused(tmp_path: Path, limit: str) -> None:
    (tmp_path / "a.toml").write_text("name = 1")
    result = RUNNER.invoke(app, ["batch", str(tmp_path), "-o", str(tmp_path / "runs"), "--time-limit", limit])
    assert result.exit_code == 2 and "--time-limit" in result.stderr and "1 s to 1e7 s" in result.stderr
    assert not (tmp_path / "runs").exists()


@pytest.mark.skipif(not CAN_COPY, reason="processes cannot be copied here")
def test_an_interrupted_batch_does_not_wait_for_what_it_runs(tmp_path: Path) -> None:
    program = (
        "import os, signal, threading\n"
        "from pathlib import Path\n"
        "from pipeline.batch.batch import run_batch\n"
        "from pipeline.process_copies import Copies\n"
        "signal.signal(signal.SIGINT, signal.default_int_handler)\n"  # a job of a shell may be born deaf to it
        "run = Copies.run\n"
        "def sleeping(self, work, *arguments, **options):\n"
        "    threading.Timer(1.0, os.kill, (os.getpid(), signal.SIGINT)).start()\n"
        "    return run(self, 'time:sleep', 60.0, **options)\n"
        "Copies.run = sleeping\n"
        "class Told:\n"
        "    def started(self, name): pass\n"
        "    def finished(self, outcome): print('finished', outcome)\n"
        "run_batch([('a', Path('a.toml'))], Path('runs'), 1, Told(), program='cli:app')\n"
    )
    began = time.monotonic()
    ended = subprocess.run([sys.executable, "-c", program], cwd=tmp_path, capture_output=True, text=True, check=False)
    assert "KeyboardInterrupt" in ended.stderr, ended.stderr
    assert time.monotonic() - began < 30.0
    assert ended.stdout == ""


def test_an_interrupted_batch_says_how_to_go_on(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    for name in ("a", "b"):
        (tmp_path / f"{name}.toml").write_text("name = 1")
    outcomes = iter([Outcome("a", tmp_path / "a.toml", 0, "")])

    def interrupted(*_: object) -> Outcome:
        try:
            return next(outcomes)
        except StopIteration:
            raise KeyboardInterrupt from None

    monkeypatch.setattr("pipeline.batch.batch._run_one", interrupted)
    result = RUNNER.invoke(app, ["batch", str(tmp_path), "-o", str(tmp_path / "runs")])
    assert result.exit_code == 130
    assert "interrupted; 1 of 2 prototypes are done; the same command goes on" in result.stderr


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


def test_numerical_libraries_of_a_worker_have_one_thread(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    for variable in ONE_THREAD:
        monkeypatch.setenv(variable, "7")
    spy = "import os, sys; sys.exit(':'.join(v for k, v in os.environ.items() if k.endswith('_NUM_THREADS')))"
    monkeypatch.syspath_prepend(tmp_path)
    assert run_worker(write_program(tmp_path, spy), "x", tmp_path / "x.toml", tmp_path).reason == "1:1:1:1"


def test_a_fleet_file_names_its_members(tmp_path: Path) -> None:
    (tmp_path / "sub").mkdir()
    one = _prototype(tmp_path / "sub", "one")
    fleet = tmp_path / "fleet.toml"
    fleet.write_text('prototypes = ["sub/one.toml"]')
    assert prototype_files([fleet, one]) == [one.resolve()]
    fleet.write_text('prototypes = ["sub/one.toml"]\njobs = 2')
    with pytest.raises(InputError, match="'prototypes' alone"):
        prototype_files([fleet])


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ('prototypes = "one.toml"', "a list of paths"),
        ("prototypes = []", "a list of paths"),
        ("prototypes = [1]", "a list of paths"),
        ('prototype = ["one.toml"]', "did you mean 'prototypes'"),
        ('prototypes = ["sub"]', "sub is a folder; list settings files"),
    ],
)
def test_a_mistake_in_a_fleet_file_is_said_before_anything_runs(tmp_path: Path, text: str, said: str) -> None:
    (tmp_path / "sub").mkdir()
    (tmp_path / "fleet.toml").write_text(text)
    with pytest.raises(InputError, match=f"fleet.toml: .*{said}"):
        prototype_files([tmp_path / "fleet.toml"])


def test_what_is_not_there_is_said(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="no settings file"):
        prototype_files([tmp_path])
    with pytest.raises(InputError, match="no such file"):
        prototype_files([tmp_path / "x.toml"])


def test_two_of_one_name_would_share_a_folder(tmp_path: Path) -> None:
    (tmp_path / "sub").mkdir()
    pair = [_prototype(tmp_path, "a"), _prototype(tmp_path / "sub", "a")]
    with pytest.raises(InputError, match="named 'a'"):
        named_prototypes(pair)


def test_no_cell_of_the_csv_is_a_formula(tmp_path: Path) -> None:
    write_fleet_tables(tmp_path, [Outcome("x", tmp_path, 2, "=cmd()|' /C calc'!A0", 0.1)])
    with (tmp_path / "fleet.csv").open(newline="") as stream:
        assert next(csv.DictReader(stream))["reason"].startswith("'=cmd")
