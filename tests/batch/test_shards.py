"""Shards of a batch: a stable split, their journals, their joined tables, and how far they are while they work."""

import json
from datetime import UTC, datetime, timedelta
from pathlib import Path

import pyarrow.parquet as pq
import pytest
from typer.testing import CliRunner

from cli import app
from pipeline.batch.batch import collect_batch
from pipeline.batch.journal import Event, Plan, Shard, failures, journals
from pipeline.batch.progress import fleet_progress, is_fleet
from pipeline.batch.worker import Outcome
from pipeline.commands.outcome import BatchProgress
from pipeline.errors import CorruptArtifactError, InputError
from pipeline.runs.lock import run_lock
from pipeline.runs.manifest import MANIFEST

RUNNER = CliRunner()
NAMES = [f"P{number}" for number in range(60)]


def test_a_split_is_whole_without_overlap_and_stays_where_prototypes_are_added() -> None:
    shards = [Shard(number, 4) for number in range(1, 5)]
    assert all(sum(shard.holds(name) for shard in shards) == 1 for name in NAMES)
    assert all(sum(shard.holds(name) for name in NAMES) > 5 for shard in shards)
    assert [name for name in NAMES[:9] if Shard(2, 4).holds(name)] == ["P3", "P7"]


@pytest.mark.parametrize("text", ["0/3", "4/3", "3", "1/0", "-1/3", "1/3/5", "a/b"])
def test_what_is_no_shard_is_refused(text: str) -> None:
    with pytest.raises(InputError, match=r"number/count such as 3/100"):
        Shard.parse(text)


def _batch(folder: Path, *more: str) -> tuple[int, list[str]]:
    arguments = ["batch", str(folder), "-o", str(folder / "runs"), *more]
    done = RUNNER.invoke(app, [*arguments, "--json"])
    return done.exit_code, [entry["name"] for entry in json.loads(done.stdout)["prototypes"]]


def test_shards_leave_the_tables_to_collect_which_gives_the_reason_of_each_failure(tmp_path: Path) -> None:
    for name in ("P1", "P2", "P3"):
        (tmp_path / f"{name}.toml").write_text("name = 1")
    (code, first), (_, second) = _batch(tmp_path, "--shard", "1/2"), _batch(tmp_path, "--shard", "2/2")
    assert code == 6 and sorted(first + second) == ["P1", "P2", "P3"] and first and second
    assert not (tmp_path / "runs/fleet.parquet").exists()
    assert [journal.shard for journal in journals(tmp_path / "runs")] == [Shard(1, 2), Shard(2, 2)]
    assert _batch(tmp_path, "--collect") == (6, ["P1", "P2", "P3"])
    rows = pq.read_table(tmp_path / "runs/fleet.parquet").to_pylist()
    assert len(rows) == 3 and all("mistake" in row["reason"] for row in rows)
    whole = {row["prototype"]: row["reason"] for row in rows}
    assert {name: event.reason for name, event in failures(tmp_path / "runs").items()} == whole
    shown = RUNNER.invoke(app, ["status", str(tmp_path / "runs")])
    assert shown.exit_code == 0 and "3 prototypes: 3 failed" in shown.stdout
    refused = RUNNER.invoke(app, ["batch", str(tmp_path), "-o", str(tmp_path), "--shard", "1/2", "--collect"])
    assert refused.exit_code == 2 and "without --shard" in refused.stderr


def _write(path: Path, planned: list[str], events: list[Event], jobs: int = 1) -> None:
    lines = [Plan(planned=tuple(planned), jobs=jobs), *events]
    path.write_text("".join(f"{line.model_dump_json()}\n" for line in lines), encoding="utf-8")


def test_a_batch_that_goes_on_shows_states_and_its_end(tmp_path: Path) -> None:
    now = datetime.now(UTC)
    ago = lambda seconds: now - timedelta(seconds=seconds)  # noqa: E731
    _write(
        tmp_path / "batch-1-of-2.jsonl",
        ["a", "b", "c", "d", "e"],
        [
            Event(time=ago(900), name="a", state="started"),
            Event(time=ago(800), name="a", state="done", exit_code=0, seconds=100.0),
            Event(time=ago(800), name="b", state="started"),
            Event(time=ago(500), name="b", state="failed", exit_code=3, reason="no wells", seconds=300.0),
            Event(time=ago(500), name="c", state="started"),
            Event(time=ago(50), name="d", state="started"),
        ],
    )
    assert is_fleet(tmp_path)
    progress = fleet_progress(tmp_path)
    assert [(member.name, member.state) for member in progress.members] == [
        ("a", "done"), ("b", "failed"), ("c", "stopped"), ("d", "running"), ("e", "waiting"),
    ]  # fmt: skip
    # three of five are left at 200 s each, of which the one that runs has had 50 s
    assert progress.expected_end is not None
    assert (progress.expected_end - now).total_seconds() == pytest.approx(550.0, abs=5.0)
    shown = json.loads(RUNNER.invoke(app, ["status", str(tmp_path), "--json"]).stdout)
    assert shown["counts"] == {"done": 1, "running": 1, "failed": 1, "stopped": 1, "waiting": 1}
    assert (shown["shards"], shown["shards_begun"], shown["prototypes"][1]["reason"]) == (2, 1, "no wells")
    text = RUNNER.invoke(app, ["status", str(tmp_path)]).stdout
    assert "no wells" in text and "1 of 2 shards have begun" in text and "expected end" in text


def test_a_run_that_a_process_holds_is_running(tmp_path: Path) -> None:
    _write(tmp_path / "batch-1-of-1.jsonl", ["a"], [])
    assert [member.state for member in fleet_progress(tmp_path).members] == ["waiting"]
    with run_lock(tmp_path / "a"):
        assert [member.state for member in fleet_progress(tmp_path).members] == ["running"]


def test_a_failure_that_was_mended_since_is_none(tmp_path: Path) -> None:
    before = datetime.now(UTC) - timedelta(seconds=60)
    _write(tmp_path / "batch-1-of-1.jsonl", ["a"], [Event(time=before, name="a", state="failed", reason="x")])
    assert set(failures(tmp_path)) == {"a"}
    (tmp_path / "a").mkdir()
    (tmp_path / "a" / MANIFEST).write_text("{}")
    assert not failures(tmp_path)
    assert collect_batch([("a", tmp_path / "a.toml")], tmp_path)[0].reason != "x"


def test_a_line_that_is_being_written_is_left_out_and_another_file_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "batch-1-of-1.jsonl"
    _write(path, ["a"], [Event(time=datetime.now(UTC), name="a", state="started")])
    path.write_bytes(path.read_bytes() + b'{"time": "20')
    assert journals(tmp_path)[0].last["a"].state == "started"
    path.write_text("[]\n")
    with pytest.raises(CorruptArtifactError, match=r"batch-1-of-1\.jsonl: is no journal"):
        journals(tmp_path)


def test_each_line_of_a_log_has_time_name_and_state(capsys: pytest.CaptureFixture[str]) -> None:
    with BatchProgress(2) as progress:
        for name, code, reason in (("a", 0, ""), ("b", 3, "no wells")):
            progress.started(name)
            progress.finished(Outcome(name, Path("x.toml"), code, reason, 1.5, 1.0))
    first, second = capsys.readouterr().err.splitlines()
    stamp, rest = first.split(" ", 1)
    assert datetime.fromisoformat(stamp).tzinfo is not None and rest.startswith("[1/2] a: done (1.5 s)")
    assert "[2/2] b: failed: no wells (1.5 s)" in second
