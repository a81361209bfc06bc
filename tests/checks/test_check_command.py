"""`debist check` and the first step of `debist run`: a mistake stops with exit code 3, by name, before any fit."""

import json
from pathlib import Path

import numpy as np
import pytest
from typer.testing import CliRunner

from cli import app
from pipeline.rig.double_well import DoubleWell
from pipeline.rig.excitation import command, random_excitation

RUNNER = CliRunner()
TOML = """
name = "P"
[logs]
train = ["train.csv"]
validation = ["validation.csv"]
[channels]
time = { channel = "time", unit = "s" }
q = { channel = "q", unit = "mm" }
v1 = { channel = "v1", unit = "kV" }
v2 = { channel = "v2", unit = "kV" }
[plant]
mass = { value = 41, unit = "g" }
[identify]
models = ["rbf-paper"]
[compare]
models = []
"""


def _write_log(path: Path, seed: int, device: DoubleWell | None = None) -> None:
    t = np.arange(10_000) / 500.0
    v = command(random_excitation(np.random.default_rng(seed), duration=20.0, excitation="training"), t)
    rng = np.random.default_rng(seed + 1)
    q = 1e3 * (device or DoubleWell()).simulate(v, 1 / 500.0) + rng.normal(0.0, 3e-3, t.size)
    np.savetxt(path, np.column_stack([t, q, 1e-3 * v]), fmt="%.6f", delimiter=",", header="time,q,v1,v2", comments="")


@pytest.fixture(scope="module")
def logs(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("logs")
    _write_log(folder / "train.csv", 1)
    _write_log(folder / "validation.csv", 3)
    _write_log(folder / "other.csv", 3, DoubleWell(left_well=9.5e-3))
    (folder / "P.toml").write_text(TOML)
    return folder


def _settings(logs: Path, name: str, *changes: tuple[str, str]) -> Path:
    text = TOML
    for old, new in changes:
        assert old in text
        text = text.replace(old, new)
    path = logs / name
    path.write_text(text)
    return path


MISTAKES = {
    "v1 and v2 swapped": (
        [('channel = "v1"', 'channel = "_"'), ('channel = "v2"', 'channel = "v1"'), ('"_"', '"v2"')],
        "sides",
    ),
    "mass in kg": ([("value = 41,", "value = 41000,")], "scale"),
    "time in ms": ([('{ channel = "time", unit = "s" }', '{ channel = "time", unit = "min" }')], "rate"),
    "another joint": ([("validation.csv", "other.csv")], "device"),
}


@pytest.mark.parametrize(("changes", "gate"), MISTAKES.values(), ids=MISTAKES)
def test_a_mistake_stops_before_the_fit_and_names_what_would_accept_it(logs, tmp_path, changes, gate) -> None:
    settings = _settings(logs, f"{gate}.toml", *changes)
    for arguments in (["check", str(settings)], ["run", str(settings), "-o", str(tmp_path / "run")]):
        result = RUNNER.invoke(app, [*arguments, "-q"])
        assert result.exit_code == 3, result.output
        (line,) = [line for line in result.stderr.splitlines() if line.startswith("debist: ")]
        assert f'[quality] accept = ["{gate}"]' in line
    assert not list((tmp_path / "run").rglob("kinematics.parquet"))


def test_an_honest_prototype_passes_and_the_numbers_are_json(logs: Path) -> None:
    result = RUNNER.invoke(app, ["check", str(logs / "P.toml"), "-q", "--json"])
    assert result.exit_code == 0, result.output
    rows = json.loads(result.stdout)["rows"]
    assert {row["log"] for row in rows} == {"training log", "validation log"}
    assert not [row for row in rows if row["state"] == "wrong"]
    assert {"push of v1", "delay of q after v2", "same device", "natural frequency"} <= {row["what"] for row in rows}


def test_what_is_accepted_by_name_runs_and_is_shown_in_the_report(logs: Path, tmp_path: Path) -> None:
    """A device that is wired the other way round says so in its settings."""
    changes, _ = MISTAKES["v1 and v2 swapped"]
    settings = _settings(logs, "accepted.toml", *changes, ("[identify]", '[quality]\naccept = ["sides"]\n[identify]'))
    run = tmp_path / "run"
    result = RUNNER.invoke(app, ["run", str(settings), "-o", str(run), "-q"])
    assert result.exit_code == 0, result.output
    assert "(accepted: sides)" in result.stderr
    page = (run / "report.html").read_text()
    assert "Logs against settings" in page and "(accepted: sides)" in page
    again = RUNNER.invoke(app, ["check", str(run)])
    assert again.exit_code == 0 and "(!)" in again.stdout


def test_the_table_fits_eighty_columns(logs: Path) -> None:
    result = RUNNER.invoke(app, ["check", str(logs / "P.toml"), "-q"])
    assert result.exit_code == 0
    assert max(len(line.rstrip()) for line in result.stdout.splitlines()) <= 92
