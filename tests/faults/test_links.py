"""A run folder from somebody else, with symbolic and hard links in it: no file outside is touched."""

import os
import shutil
from pathlib import Path

import pytest
from typer.testing import CliRunner

from cli import app
from pipeline.errors import InputError
from pipeline.workflow.run import run_stage
from tests.prototypes import Silent

MINE = "a file of the user\n"
NAMES = (
    ".lock",
    ".lock-holder.json",
    ".manifest.next.json",
    "manifest.json",
    "stages/differentiate.json",
    "stages",
    "train",
    "train/train",
    "train/train/kinematics.parquet",
    "train/train/.kinematics.parquet.debist-staged",
    f"train/train/.kinematics.parquet.debist-staged.{os.getpid()}.debist-tmp".replace("/.k", "/..k"),
    f".manifest.next.json.{os.getpid()}.debist-tmp".replace(".m", "..m", 1),
    "exports",
    "studies",
)


@pytest.fixture
def victim(tmp_path) -> Path:
    """A folder of the user's with files that a run could overwrite."""
    folder = tmp_path / "victim"
    folder.mkdir()
    for name in ("file", "signals.parquet", "kinematics.parquet", "differentiate.json", "small.json", "alpha.svg"):
        (folder / name).write_text(MINE)
    return folder


def _planted(bench, name: str, target: Path, link) -> None:
    bench.start("changed")
    place = bench.run / name
    if place.is_dir():
        shutil.rmtree(place)
    else:
        place.unlink(missing_ok=True)
    link(target, place)


def _state(folder: Path) -> dict[str, str]:
    return {path.name: path.read_text() for path in folder.iterdir()}


@pytest.mark.parametrize("name", NAMES, ids=range(len(NAMES)))  # a name with the process id is no stable id
def test_no_symbolic_link_leads_a_write_out(bench, victim, name):
    """Named as the lock, its note, the manifest to be, an artifact, a temporary file, a folder."""
    is_folder = "." not in name
    _planted(bench, name, victim if is_folder else victim / "file", lambda to, at: at.symlink_to(to))
    before = _state(victim)
    for command in (["differentiate"], ["export", "--to", "json", "--model", "rbf-paper"], ["study", "alpha"]):
        result = CliRunner().invoke(
            app,
            [command[0], *command[1:2], str(bench.run)]
            if command[0] == "study"
            else [command[0], str(bench.run), *command[1:]],
        )
        assert result.exit_code in (0, 2, 4), result.output
        assert _state(victim) == before, (name, command)


@pytest.mark.parametrize(
    "name", [".lock", ".lock-holder.json", "stages/differentiate.json", "train/train/kinematics.parquet"]
)
def test_no_hard_link_leads_a_write_out(bench, victim, name):
    _planted(bench, name, victim / "file", lambda to, at: at.hardlink_to(to))
    before = _state(victim)
    try:
        run_stage(bench.run, "differentiate", Silent())
    except InputError as refused:
        assert "is missing" in str(refused)
    assert _state(victim) == before
