"""Readers see one state of a run while another process writes; what is hashed of a raw log is what is read."""

import os
import shutil
import time
from pathlib import Path

import numpy as np
import pytest

from pipeline.errors import InputError, SupersededError
from pipeline.store.atomic import run_lock
from pipeline.store.columns import Column
from pipeline.store.manifest import Recipe
from pipeline.store.run_folder import RunFolder, in_snapshot
from pipeline.store.schemas import Schema
from pipeline.workflow.engine import Task, bring_up_to_date
from pipeline.workflow.verify import verify_everything
from tests.prototypes import Silent

SCHEMA = Schema("one", (Column("x", "x", "1", "number of the commit", dtype="int64"),))
READS = 300


def _commit(run: RunFolder, number: int) -> None:
    """Two artifacts that belong together."""
    written = {
        "a/one.parquet": run.write_table("a/one.parquet", SCHEMA, {"x": np.full(100, number)}, {}),
        "two.json": run.write_text("two.json", str(number), {}),
    }
    run.commit(Recipe("test", "1", {"number": number}, {}), written)


def _write_on(root: Path) -> None:
    with run_lock(root):
        run, number = RunFolder.open(root), 0
        while True:
            number += 1
            _commit(run, number)
            run.state({"test": {name: record.content_hash for name, record in run.manifest.artifacts.items()}})


def _both(run: RunFolder) -> tuple[int, int]:
    first = int(run.read_table("a/one.parquet")["x"][0])
    time.sleep(0.001)
    return first, int(run.read_bytes("two.json"))


def test_readers_get_one_state_while_another_process_replaces_all(tmp_path):
    """Neither damage nor a mixture is told, and reading does not stand still."""
    root = tmp_path / "run"
    _commit(RunFolder.create(root, {}, tmp_path / "P.toml"), 0)
    writer = os.fork()
    if writer == 0:
        try:
            _write_on(root)
        finally:
            os._exit(1)
    try:
        seen = set()
        for _ in range(READS):
            one, two = in_snapshot(root, _both)
            assert one == two
            seen.add(one)
            found = verify_everything(root)
            assert (found.problems, found.unknown, found.leftover, found.checked) == ([], [], [], 2)
        assert len(seen) > 5, "the writer stood still"
    finally:
        os.kill(writer, 9)
        os.waitpid(writer, 0)


def test_what_is_really_damaged_is_still_told(tmp_path):
    root = tmp_path / "run"
    _commit(RunFolder.create(root, {}, tmp_path / "P.toml"), 0)
    (root / "two.json").write_text("x")
    assert [problem["artifact"] for problem in verify_everything(root).problems] == ["two.json"]
    reader = RunFolder.open(root)
    _commit(RunFolder.open(root), 1)
    with pytest.raises(SupersededError, match="was replaced by another run while it was read"):
        reader.read_bytes("two.json")


def _swap(path: Path) -> None:
    path.with_suffix(".new").write_text("other")
    path.with_suffix(".new").replace(path)


def _change(path: Path) -> None:
    times = path.stat()
    path.write_text("other")
    os.utime(path, ns=(times.st_atime_ns, times.st_mtime_ns))


def _swap_and_back(path: Path) -> None:
    shutil.copy2(path, path.with_suffix(".old"))
    _swap(path)
    path.with_suffix(".old").replace(path)


@pytest.mark.parametrize("meddle", [_swap, _change, _swap_and_back, Path.unlink])
def test_a_log_that_changes_between_its_hash_and_its_reading_is_refused(tmp_path, meddle):
    log = tmp_path / "log.csv"
    log.write_text("first")

    def work(run):
        meddle(log)
        return {"one.json": run.write_text("one.json", "x", {})}

    run = RunFolder.create(tmp_path / "run", {}, tmp_path / "P.toml")
    task = Task("ingest", "log", "1", {}, (), ("one.json",), work, sources={"log.csv": log})
    with pytest.raises(InputError, match=r"log\.csv: was changed while it was read"):
        bring_up_to_date(run, [task], Silent())
    assert not RunFolder.open(run.root).manifest.artifacts
    assert not [path for path in run.root.iterdir() if path.name != "manifest.json"]
