"""Commands that write into the user's folders replace their own files only, and a raw log by no word."""

from pathlib import Path

import pytest
from typer.testing import CliRunner

from cli import app
from pipeline.errors import InputError
from pipeline.store.outputs import WRITTEN, beside, new_outputs

MINE = "measured for a week\n"
SETTINGS = 'name = "P"\n[logs]\ntrain = ["rig/train.mat"]\nvalidation = ["rig/validation.mat"]\n'


def _write(folder: Path, text: str, *, force: bool = False, command: str = "test") -> None:
    with new_outputs(folder, command, force=force, names=("train.mat",)) as staged:
        (staged / "truth").mkdir()
        (staged / "truth" / "truth.json").write_text(text)
        (staged / "train.mat").write_text(text)


def test_its_own_files_are_replaced_and_nobody_elses(tmp_path):
    _write(tmp_path, "one")
    _write(tmp_path, "two")
    assert ((tmp_path / "train.mat").read_text(), (tmp_path / "truth/truth.json").read_text()) == ("two", "two")
    with pytest.raises(InputError, match="was not written by `debist other`"):
        _write(tmp_path, "three", command="other")
    (tmp_path / "train.mat").write_text(MINE)
    with pytest.raises(InputError, match=r"train\.mat: is there already .* or was changed since"):
        _write(tmp_path, "three")
    assert (tmp_path / "train.mat").read_text() == MINE
    _write(tmp_path, "three", force=True)
    assert (tmp_path / "train.mat").read_text() == "three"
    assert sorted(path.name for path in tmp_path.iterdir()) == [WRITTEN, "train.mat", "truth"]


@pytest.mark.parametrize("moved", [0, 1])
def test_after_an_interruption_while_files_move_the_same_command_starts_again(tmp_path, monkeypatch, moved):
    _write(tmp_path, "one")
    moves = []

    def interrupted(path, target):
        if len(moves) == moved:
            raise KeyboardInterrupt
        moves.append(target)
        path.replace(target)

    with monkeypatch.context() as patch, pytest.raises(KeyboardInterrupt):
        patch.setattr("pipeline.store.outputs.replace", interrupted)
        _write(tmp_path, "two")
    texts = {(tmp_path / name).read_text() for name in ("train.mat", "truth/truth.json")}
    assert len(moves) == moved and ("one" in texts) and (("two" in texts) == bool(moved))
    moves.clear()
    with monkeypatch.context() as patch, pytest.raises(KeyboardInterrupt):  # and once more
        patch.setattr("pipeline.store.outputs.replace", interrupted)
        _write(tmp_path, "two and a half")
    _write(tmp_path, "three")
    assert {(tmp_path / name).read_text() for name in ("train.mat", "truth/truth.json")} == {"three"}
    with pytest.raises(InputError, match="was changed since"):
        (tmp_path / "train.mat").write_text("one")
        _write(tmp_path, "four")


def test_a_raw_log_of_settings_is_never_replaced(tmp_path, monkeypatch):
    """Whether the settings lie beside it, above it, or in the current folder; links do not hide it."""
    rig, elsewhere = tmp_path / "rig", tmp_path / "else" / "where"
    for folder in (rig, elsewhere):
        folder.mkdir(parents=True)
    (rig / "train.mat").write_text(MINE)
    (tmp_path / "P.toml").write_text(SETTINGS)
    with pytest.raises(InputError, match=r"is a raw log of .*P\.toml and is never overwritten"):
        _write(rig, "x", force=True)
    (elsewhere / "train.mat").hardlink_to(rig / "train.mat")
    monkeypatch.chdir(tmp_path)
    with pytest.raises(InputError, match="never overwritten"):
        _write(elsewhere, "x", force=True)
    assert (rig / "train.mat").read_text() == MINE


def test_a_failure_leaves_what_was_there(tmp_path):
    _write(tmp_path, "one")
    with pytest.raises(ValueError, match="stop"), new_outputs(tmp_path, "test") as staged:
        (staged / "train.mat").write_text("half")
        raise ValueError("stop")
    assert (tmp_path / "train.mat").read_text() == "one"
    assert not [path for path in tmp_path.iterdir() if path.name.endswith(".debist-tmp")]


@pytest.mark.parametrize(
    ("command", "name"),
    [
        (["rig", "simulate", "-o", "{}", "--duration", "2", "--rate", "2000"], "train.mat"),
        (["rig", "simulate", "-o", "{}", "--format", "csv", "--rate", "2000"], "validation.csv"),
        (["rig", "simulate", "-o", "{}", "--seed", "3"], "same-3.toml"),
        (["rig", "fleet", "1", "-o", "{}/..", "--format", "mat"], "train.mat"),
        (["rig", "excite", "-o", "{}/train.csv", "--duration", "8 s"], "train.csv"),
        (["rig", "excite", "-o", "{}/train.csv", "--duration", "8 s"], "train.json"),
        (["rig", "closed-loop", "nominal", "--play", "none.csv", "-o", "{}/train"], "train.mat"),
        (["rig", "closed-loop", "nominal", "--play", "none.csv", "-o", "{}/train"], "train.toml"),
        (["demo", "-o", "{}/../X"], "train.mat"),
    ],
)
def test_no_command_of_the_rig_replaces_a_log(tmp_path, command, name):
    folder = tmp_path / {"rig fleet": "same-00", "demo -o": "X-rig"}.get(" ".join(command[:2]), "rig")
    folder.mkdir()
    (folder / name).write_text(MINE)
    result = CliRunner().invoke(app, [part.format(folder) for part in command])
    assert result.exit_code == 2, result.output
    assert f"{name}: is there already" in result.stderr and "name another place" in result.stderr
    assert [path.read_text() for path in folder.iterdir()] == [MINE]


@pytest.mark.parametrize(("given", "made"), [("runs/P1", "runs/P1-rig"), (".", "../here-rig"), ("..", "../../up-rig")])
def test_a_folder_beside_the_current_one_has_its_name(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, given: str, made: str
) -> None:
    (tmp_path / "up" / "here").mkdir(parents=True)
    monkeypatch.chdir(tmp_path / "up" / "here")
    assert beside(Path(given), "-rig").resolve() == Path(made).resolve()
