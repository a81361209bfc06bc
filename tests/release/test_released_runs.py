"""Run folders of every release: this program opens them, or names `debist run`, which brings them up to date."""

import json
import zipfile
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
import pyarrow.parquet as pq
import pytest
from typer.testing import CliRunner

import debist
from cli import app
from pipeline import __version__

ARCHIVES = sorted(Path(__file__).parent.glob("*.zip"))
Scores = Mapping[tuple[str, str, str], Mapping[str, Any]]


@pytest.fixture(params=ARCHIVES, ids=lambda path: path.stem)
def released(request: pytest.FixtureRequest, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The folder of a release, unpacked: logs, settings, run."""
    with zipfile.ZipFile(request.param) as packed:
        packed.extractall(tmp_path)
    monkeypatch.chdir(tmp_path)
    return tmp_path


def _scores(run: Path) -> Scores:
    """Rows of the table by log, model and signal, as any program reads them."""
    rows = pq.read_table(run / "scores.parquet").to_pylist()
    return {(row["log"], row["model"], row["signal"]): row for row in rows}


def _debist(*arguments: str) -> str:
    done = CliRunner().invoke(app, list(arguments))
    assert done.exit_code == 0, done.output
    return done.stdout


def test_each_release_left_a_run() -> None:
    assert __version__ in {path.stem for path in ARCHIVES}
    assert all(path.stat().st_size < 300_000 for path in ARCHIVES)


def test_a_released_run_is_read_or_names_what_mends_it(released: Path) -> None:
    recorded = _scores(released / "run")
    run = debist.open_run("run")
    try:
        scores = run.scores()
        assert set(zip(scores.log, scores.model, scores.signal, strict=True)) == set(recorded)
        for log in run.logs:
            q = run.log(log).q_m
            assert 0.01 < np.ptp(q) < 0.1  # metres
            for model in run.models:
                free = run.simulate(model, log)
                nrmse = np.sqrt(np.mean((free.q_m - free.q_measured_m) ** 2)) / np.ptp(q)
                assert nrmse == pytest.approx(recorded[log, model, "q"]["nrmse"], rel=1e-3)
    except debist.DebistError as error:
        assert "debist run" in str(error)


def test_debist_run_brings_a_released_run_up_to_date(released: Path) -> None:
    recorded = _scores(released / "run")
    _debist("run", "released.toml", "-o", "run", "--no-report", "-q")
    _debist("verify", "run")
    renewed = _scores(released / "run")
    assert set(recorded) <= set(renewed)
    for row, values in recorded.items():
        assert renewed[row]["status"] == values["status"]
        assert renewed[row]["nrmse"] < 1.1 * values["nrmse"], row
    assert json.loads(_debist("report", "run", "--json"))
    assert debist.open_run("run").simulate().attrs["status"] == "ok"
