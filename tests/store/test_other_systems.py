"""What Windows and other disks do differently, by stand-ins: files that are open elsewhere, long paths, names."""

import errno
from pathlib import Path

import pytest

from pipeline.errors import CorruptArtifactError, InputError
from pipeline.store import atomic, layout
from pipeline.store.atomic import write_text
from pipeline.store.manifest import MANIFEST, Recipe, load_manifest
from pipeline.store.run_folder import RunFolder
from pipeline.system.names import check_name


@pytest.fixture
def patient(monkeypatch) -> list[float]:
    """The pauses, none of which is waited for."""
    pauses: list[float] = []
    monkeypatch.setattr(atomic.time, "sleep", pauses.append)
    return pauses


def _refusing(monkeypatch, times: float) -> None:
    """Moves are refused so often, as while another program has the target open."""
    move, left = Path.replace, [times]

    def refused(source, target):
        left[0] -= 1
        if left[0] >= 0:
            raise PermissionError(errno.EACCES, "The process cannot access the file", str(source))
        return move(source, target)

    monkeypatch.setattr(Path, "replace", refused)


def test_a_file_that_is_open_elsewhere_for_a_moment_is_replaced(tmp_path, monkeypatch, patient):
    (tmp_path / "a.json").write_text("old")
    _refusing(monkeypatch, 3)
    write_text(tmp_path / "a.json", "new")
    assert (tmp_path / "a.json").read_text() == "new" and len(patient) == 3


def test_a_file_that_stays_open_elsewhere_is_named_and_left_whole(tmp_path, monkeypatch, patient):
    (tmp_path / "a.json").write_text("old")
    _refusing(monkeypatch, float("inf"))
    with pytest.raises(InputError, match=r"a\.json: cannot be written: .*; close the program that has it open, or"):
        write_text(tmp_path / "a.json", "new")
    assert [path.name for path in tmp_path.iterdir()] == ["a.json"]
    assert (tmp_path / "a.json").read_text() == "old" and sum(patient) < 1.0


def test_a_commit_that_meets_an_open_file_is_completed_by_the_next_run(tmp_path, monkeypatch, patient):
    run = RunFolder.create(tmp_path / "run", {}, tmp_path / "P.toml")
    run.commit(Recipe("s", "1", {}, {}), {"one.json": run.write_text("one.json", "old", {})})
    written = {"one.json": run.write_text("one.json", "new", {})}
    move = Path.replace

    def refused(source, target):
        if target == run.root / "one.json":
            raise PermissionError(errno.EACCES, "The process cannot access the file", str(source))
        return move(source, target)

    with monkeypatch.context() as patch, pytest.raises(InputError, match=r"one\.json: cannot be written"):
        patch.setattr(Path, "replace", refused)
        run.commit(Recipe("s", "2", {}, {}), written)
    assert RunFolder.open(run.root).read_bytes("one.json") == b"new"
    again = RunFolder.create(tmp_path / "run", {}, tmp_path / "P.toml")
    assert (run.root / "one.json").read_text() == "new" and again.problem("one.json") is None


@pytest.mark.parametrize("name", ["C:/x.json", "C:x.json", "//host/share/x", "a\\b.json", "..\\x", "a/../../x", "/x"])
def test_no_name_of_an_artifact_leaves_the_run_on_any_system(tmp_path, name):
    assert not layout.inside(name)
    run = RunFolder.create(tmp_path / "run", {}, tmp_path / "P.toml")
    with pytest.raises(InputError, match="leaves the run folder"):
        run.path(name)
    run.commit(Recipe("s", "1", {}, {}), {"one.json": run.write_text("one.json", "x", {})})
    run.manifest.artifacts[name] = run.manifest.artifacts["one.json"]
    run.manifest.save(run.root)
    with pytest.raises(CorruptArtifactError, match=MANIFEST):
        load_manifest(run.root)


@pytest.mark.parametrize("name", ["P.", "P...", "CON", "nul.txt", "com1 .a", "LPT9.x.y", "P "])
def test_names_that_windows_reserves_or_changes_are_refused(name):
    with pytest.raises(ValueError, match="rename it"):
        check_name(name)
