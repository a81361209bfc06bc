"""Parts of a recording as logs: by times, named by them; an overlap of training and validation is refused."""

from pathlib import Path

import numpy as np
import pytest
from typer.testing import CliRunner

from cli import app
from pipeline.settings.prototype import load_prototype
from pipeline.store import layout
from pipeline.store.run_folder import RunFolder
from tests.prototypes import motion, settings, write_csv

RUNNER = CliRunner()
TRAIN, TWO, LAST = (
    '{ file = "long.csv", stop = "9 s" }',
    '{ file = "long.csv", start = "9 s", stop = "18000 ms" }',
    '{ file = "long.csv", start = "0.3 min" }',
)


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("parts")
    write_csv(folder / "long.csv", *motion(27.0, 200.0, 1, noise=3e-6))
    return folder


def _settings(folder: Path, train: str, validation: str, name: str = "parts") -> Path:
    text = settings(name=name, train="A", validation="B").replace('["A"]', f"[{train}]")
    (folder / f"{name}.toml").write_text(text.replace('["B"]', f"[{validation}]"), encoding="utf-8")
    return folder / f"{name}.toml"


def _read(run: Path, name: str) -> dict[str, np.ndarray]:
    return dict(RunFolder.open(run).read_table(name))


def test_parts_of_one_recording_train_and_validate(folder: Path) -> None:
    prototype, run = _settings(folder, f"{TRAIN}, {TWO}", LAST), folder / "run"
    result = RUNNER.invoke(app, ["run", str(prototype), "-o", str(run), "--no-report", "-q"])
    assert result.exit_code == 0, result.output
    names = ["long-to-9-s", "long-from-9-s-to-18000-ms", "long-from-0.3-min"]
    assert [name for _, name, _ in layout.logs(load_prototype(prototype))] == names
    spans = [(0.0, 8.99), (9.0, 17.99), (18.0, 26.99)]
    whole = np.loadtxt(folder / "long.csv", delimiter=",", skiprows=1)[::2]
    for (role, name, _), span in zip(layout.logs(load_prototype(prototype)), spans, strict=True):
        part = _read(run, layout.signals(role, name))
        assert (part["t"][0], part["t"][-1]) == pytest.approx(span, abs=1e-9)
        inside = (whole[:, 0] > span[0] - 1e-6) & (whole[:, 0] < span[1] + 1e-6)
        assert np.nanmedian(np.abs(part["q"] - 1e-3 * whole[inside, 1])) < 1e-5
    assert RUNNER.invoke(app, ["status", str(run)]).exit_code == 0
    assert "long from 0.3 min" in RUNNER.invoke(app, ["validate", str(run), "--details"]).stdout
    recipe = RunFolder.open(run).record(layout.signals("train", names[0])).recipe
    assert list(recipe.inputs) == ["long.csv"] and recipe.settings["part"] == {"stop_s": 9.0}
    _settings(folder, f"{TRAIN}, {TWO}", LAST.replace("0.3 min", "0.35 min"))
    assert "part" in RUNNER.invoke(app, ["status", str(run)]).output


@pytest.mark.parametrize(
    ("train", "validation", "text"),
    [
        (TRAIN, '"long.csv"', "'long.csv' has samples of the training log 'long to 9 s.csv'; validate on a part"),
        (TRAIN, '{ file = "long.csv", start = "8.5 s" }', "'long from 8.5 s.csv' has samples of the training log"),
        (TRAIN, TRAIN, "'long to 9 s.csv' is a training log too"),
        (f"{TRAIN}, {TRAIN}", LAST, "two logs are named 'long-to-9-s'"),
        ('{ file = "gone.csv", stop = "9 s" }', LAST, "gone.csv: no such log"),
        ('{ file = "long.csv", start = "60 s" }', "", "no sample from 60 to inf s: its time runs from 0 to 26.995 s"),
        ('{ file = "long.csv", start = "9 s", stop = "9 s" }', "", "logs.train.0: stop = '9 s' is not after start"),
        ('{ file = "long.csv", start = "9" }', "", "logs.train.0: start: '9' has no unit; write for example '9 s'"),
        ('{ file = "long.csv", begin = "9 s" }', "", "unknown key 'logs.train.0.begin'; did you mean 'gain'?"),
        ('{ start = "9 s" }', "", "'logs.train.0.file' is missing"),
    ],
)
def test_what_cannot_be_meant_is_refused(folder: Path, train: str, validation: str, text: str) -> None:
    prototype = _settings(folder, train, validation, name="refused")
    result = RUNNER.invoke(app, ["ingest", str(prototype), "-o", str(folder / "refused")])
    assert result.exit_code == 2 and text in result.stderr, result.stderr
