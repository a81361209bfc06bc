"""Shards of a batch: a stable split, their joined tables, one batch at a time, and states while they work."""

import json
import os
from pathlib import Path

import pyarrow.parquet as pq
import pytest
from typer.testing import CliRunner

from cli import app
from pipeline.errors import InputError
from pipeline.store.atomic import run_lock
from pipeline.store.manifest import MANIFEST
from pipeline.workflow.batch import collect_batch
from pipeline.workflow.members import Member, Shard
from pipeline.workflow.progress import failure, fleet_progress, keep_failure

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
    done = RUNNER.invoke(app, ["batch", str(folder), "-o", str(folder / "runs"), *more, "--json"])
    return done.exit_code, [entry["name"] for entry in json.loads(done.stdout).get("prototypes", [])]


def test_shards_leave_the_tables_to_collect_which_gives_the_reason_of_each_failure(tmp_path: Path) -> None:
    for name in ("P1", "P2", "P3"):
        (tmp_path / f"{name}.toml").write_text("name = 1")
    code, first = _batch(tmp_path, "--shard", "1/2")
    _, second = _batch(tmp_path, "--shard", "2/2")
    assert code == 6 and sorted(first + second) == ["P1", "P2", "P3"] and first and second
    assert not (tmp_path / "runs/fleet.parquet").exists()
    assert _batch(tmp_path, "--collect") == (6, ["P1", "P2", "P3"])
    rows = pq.read_table(tmp_path / "runs/fleet.parquet").to_pylist()
    assert len(rows) == 3 and all("mistake" in row["reason"] for row in rows)
    shown = RUNNER.invoke(app, ["status", str(tmp_path / "runs")])
    assert shown.exit_code == 0 and "3 prototypes: 3 failed" in shown.stdout
    refused = RUNNER.invoke(app, ["batch", str(tmp_path), "-o", str(tmp_path), "--shard", "1/2", "--collect"])
    assert refused.exit_code == 2 and "without --shard" in refused.stderr


def test_a_batch_or_shard_that_is_started_twice_is_refused_and_leaves_everything_as_it_is(tmp_path: Path) -> None:
    (tmp_path / "P1.toml").write_text("name = 1")
    assert _batch(tmp_path)[0] == 6
    before = {path: path.read_bytes() for path in (tmp_path / "runs").rglob("*") if path.is_file()}
    with run_lock(tmp_path / "runs", Shard(1, 1).lock), run_lock(tmp_path / "runs", Shard(1, 2).lock):
        assert _batch(tmp_path)[0] == 5
        assert _batch(tmp_path, "--shard", "1/2")[0] == 5
        assert _batch(tmp_path, "--shard", "2/2")[0] in (0, 6)
        assert _batch(tmp_path, "--collect")[0] == 6
    assert all(path.read_bytes() == content for path, content in before.items() if "failed" in path.parts)


def test_each_state_is_shown(tmp_path: Path) -> None:
    keep_failure(tmp_path, "failing", 3, "no wells", "debist: no wells\n")
    for name in ("held", "stopped"):
        (tmp_path / name).mkdir()
    (tmp_path / "stopped/.lock").touch()
    with run_lock(tmp_path / "held"):
        shown = json.loads(RUNNER.invoke(app, ["status", str(tmp_path), "--json"]).stdout)
    states = {member["name"]: (member["state"], member["reason"]) for member in shown["prototypes"]}
    assert states == {"failing": ("failed", "no wells"), "held": ("running", ""), "stopped": ("stopped", "")}
    assert shown["counts"] == {"done": 0, "running": 1, "failed": 1, "stopped": 1}
    assert "no wells" in RUNNER.invoke(app, ["status", str(tmp_path)]).stdout
    assert [member.state for member in fleet_progress(tmp_path)] == ["failed", "stopped", "stopped"]


def test_a_failure_that_was_mended_since_is_none(tmp_path: Path) -> None:
    keep_failure(tmp_path, "a", 2, "x", "")
    assert failure(tmp_path, "a") is not None
    (tmp_path / "a").mkdir()
    (tmp_path / "a" / MANIFEST).write_text("{}")
    os.utime(tmp_path / "failed/a.txt", (1.0, 1.0))
    assert failure(tmp_path, "a") is None
    assert collect_batch([Member("a", tmp_path / "a.toml")], tmp_path)[0].reason != "x"
