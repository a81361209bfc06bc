"""The engine redoes what is missing, damaged or stale, says why, and nothing else."""

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import pytest

from pipeline.errors import CorruptArtifactError, InputError, RunLockedError
from pipeline.store.atomic import run_lock
from pipeline.store.manifest import MANIFEST
from pipeline.store.run_folder import RunFolder, Written
from pipeline.workflow.engine import Task, bring_up_to_date, status
from tests.prototypes import Silent


def _chain(log: Path, *, alpha: float = 1.0, order: int = 2) -> list[Task]:
    """Two tasks: the raw log's text doubled, then that text repeated."""

    def double(run: RunFolder) -> Mapping[str, Written]:
        return {"a/one.json": run.write_text("a/one.json", log.read_text() * 2, {"alpha": alpha})}

    def repeat(run: RunFolder) -> Mapping[str, Written]:
        return {"two.json": run.write_text("two.json", run.checked("a/one.json").read_text() * order, {})}

    return [
        Task("one", "log", "1", {"alpha": alpha}, (), ("a/one.json",), double, {"log.txt": log}),
        Task("two", "all", "1", {"order": order}, ("a/one.json",), ("two.json",), repeat),
    ]


@pytest.fixture
def log(tmp_path: Path) -> Path:
    path = tmp_path / "log.txt"
    path.write_text("x")
    return path


def _run(tmp_path: Path, tasks: list[Task]) -> dict[str, list[str]]:
    run = RunFolder.create(tmp_path / "run", {}, tmp_path / "P.toml")
    return {result.stage: result.reasons for result in bring_up_to_date(run, tasks, Silent())}


def test_a_second_run_does_nothing(tmp_path: Path, log: Path) -> None:
    assert all(_run(tmp_path, _chain(log)).values())
    before = {p: p.stat().st_mtime_ns for p in (tmp_path / "run").rglob("*") if p.is_file()}
    assert _run(tmp_path, _chain(log)) == {"one": [], "two": []}
    assert before == {p: p.stat().st_mtime_ns for p in (tmp_path / "run").rglob("*") if p.is_file()}


def test_a_changed_setting_redoes_what_depends_on_it(tmp_path: Path, log: Path) -> None:
    _run(tmp_path, _chain(log))
    assert _run(tmp_path, _chain(log, order=3)) == {"one": [], "two": ["setting order changed from 2 to 3"]}


def test_an_equal_result_stops_the_redoing(tmp_path: Path, log: Path) -> None:
    _run(tmp_path, _chain(log))
    redone = _run(tmp_path, _chain(log, alpha=2.0))  # alpha changes nothing in the text
    assert redone == {"one": ["setting alpha changed from 1.0 to 2.0"], "two": []}


def test_content_decides_not_the_time_stamp(tmp_path: Path, log: Path) -> None:
    import os

    _run(tmp_path, _chain(log))
    log.write_text("y")
    os.utime(log, (0, 0))
    assert _run(tmp_path, _chain(log)) == {
        "one": ["input log.txt changed"],
        "two": ["input a/one.json changed"],
    }


@pytest.mark.parametrize("name", ["a/one.json", "two.json"])
def test_every_flipped_byte_is_found_set_aside_and_rebuilt(tmp_path: Path, log: Path, name: str) -> None:
    _run(tmp_path, _chain(log))
    path = tmp_path / "run" / name
    good = path.read_bytes()
    for index in range(len(good)):
        path.write_bytes(good[:index] + bytes([good[index] ^ 1]) + good[index + 1 :])
        run = RunFolder.open(tmp_path / "run")
        with pytest.raises(CorruptArtifactError, match=path.name):
            run.checked(name)
        assert any(
            "bytes that were written" in reason
            for reasons in _run(tmp_path, _chain(log)).values()
            for reason in reasons
        )
        assert path.read_bytes() == good
    assert len(list(path.parent.glob(f"{path.name}.corrupt-*"))) == len(good)


def test_every_flipped_byte_of_the_manifest_is_found(tmp_path: Path, log: Path) -> None:
    _run(tmp_path, _chain(log))
    path = tmp_path / "run" / MANIFEST
    good = path.read_bytes()
    for index in range(0, len(good), 7):
        path.write_bytes(good[:index] + bytes([good[index] ^ 1]) + good[index + 1 :])
        with pytest.raises(CorruptArtifactError, match=MANIFEST):
            RunFolder.open(tmp_path / "run")


def test_status_says_what_a_run_would_do(tmp_path: Path, log: Path) -> None:
    _run(tmp_path, _chain(log)[:0])
    before = {result.stage: result.reasons for result in status(RunFolder.open(tmp_path / "run"), _chain(log))}
    assert before == {"one": ["first time"], "two": ["input a/one.json is not made yet"]}
    _run(tmp_path, _chain(log))
    run = RunFolder.open(tmp_path / "run")
    assert all(result.up_to_date for result in status(run, _chain(log)))
    log.write_text("z")
    found = {result.stage: result.reasons for result in status(run, _chain(log))}
    assert found == {"one": ["input log.txt changed"], "two": ["input a/one.json is stale"]}


@pytest.mark.parametrize("plant", ["a", "two.json"])
def test_nothing_is_written_through_a_link(tmp_path: Path, log: Path, plant: str) -> None:
    outside = tmp_path / "outside"
    outside.mkdir()
    run = RunFolder.create(tmp_path / "run", {}, tmp_path / "P.toml")
    (tmp_path / "run" / plant).symlink_to(outside / "x" if plant.endswith("json") else outside)
    with pytest.raises(InputError, match="symbolic link"):
        bring_up_to_date(run, _chain(log), Silent())
    assert list(outside.iterdir()) == []


def test_two_runs_on_one_folder(tmp_path: Path) -> None:
    import multiprocessing
    import os

    holding, leave = multiprocessing.Event(), multiprocessing.Event()
    holder = multiprocessing.get_context("fork").Process(target=_hold, args=(tmp_path, holding, leave))
    holder.start()
    assert holding.wait(10)
    with pytest.raises(RunLockedError, match=f"process {holder.pid} on .* since"), run_lock(tmp_path):
        pass
    os.kill(holder.pid or 0, 9)
    holder.join()
    with run_lock(tmp_path):  # a dead holder holds nothing
        pass


def _hold(root: Path, holding: Any, leave: Any) -> None:
    with run_lock(root):
        holding.set()
        leave.wait(30)
