"""A batch: one failing alone, the fleet table, a rerun that does nothing, names that stay apart."""

import csv
import json
from pathlib import Path

import numpy as np
import pyarrow.parquet as pq
import pytest
from typer.testing import CliRunner

from cli import app
from pipeline.errors import InputError
from pipeline.rig.double_well import DoubleWell
from pipeline.stages.batch import Outcome, collect, run_batch, write_fleet

RUNNER = CliRunner()
TOML = """
name = "{name}"
[logs]
train = ["{name}.csv"]
[channels]
time = {{ channel = "t", unit = "s" }}
q = {{ channel = "q", unit = "mm" }}
v1 = {{ channel = "v1", unit = "V" }}
v2 = {{ channel = "v2", unit = "V" }}
[identify]
models = ["rbf-paper"]
[compare]
models = []
"""


def _prototype(folder: Path, name: str, seed: int) -> Path:
    """Eight seconds of a double well under random pulses, as a CSV log at 1 kHz."""
    rng, dt = np.random.default_rng(seed), 1e-3
    t = np.arange(8000) * dt
    v = np.repeat(rng.choice([0.0, 1500.0, 3000.0], size=(20, 2)), 400, axis=0)
    q = DoubleWell().simulate(v, dt, stride=2) + rng.normal(0.0, 2e-6, t.size)
    rows = np.column_stack([t, q * 1e3, v])
    np.savetxt(folder / f"{name}.csv", rows, fmt="%.6f", delimiter=",", header="t,q,v1,v2", comments="")
    path = folder / f"{name}.toml"
    path.write_text(TOML.format(name=name))
    return path


def test_one_fails_alone_and_a_rerun_does_only_what_is_missing(tmp_path: Path) -> None:
    fleet, output = tmp_path / "fleet", tmp_path / "runs"
    fleet.mkdir()
    for name, seed in (("a", 1), ("b", 2)):
        _prototype(fleet, name, seed)
    (fleet / "b.csv").write_text("t,q\n")
    result = RUNNER.invoke(app, ["batch", str(fleet), "-o", str(output), "--jobs", "2", "--json"])
    assert result.exit_code == 6
    by_name = {entry["name"]: entry for entry in json.loads(result.stdout)["prototypes"]}
    assert (by_name["a"]["exit_code"], by_name["b"]["exit_code"]) == (0, 2)
    assert "b.csv" in by_name["b"]["reason"]
    rows = pq.read_table(output / "fleet.parquet").to_pylist()
    assert {row["prototype"] for row in rows if row["nrmse"] is not None} == {"a"}
    assert [row["reason"] for row in rows if row["prototype"] == "b"] == [by_name["b"]["reason"]]

    before = (output / "a" / "manifest.json").stat().st_mtime_ns
    _prototype(fleet, "b", 2)
    assert RUNNER.invoke(app, ["batch", str(fleet), "-o", str(output)]).exit_code == 0
    assert (output / "a" / "manifest.json").stat().st_mtime_ns == before
    assert {row["prototype"] for row in pq.read_table(output / "fleet.parquet").to_pylist()} == {"a", "b"}


def test_a_fleet_file_names_its_members(tmp_path: Path) -> None:
    (tmp_path / "sub").mkdir()
    one = _prototype(tmp_path / "sub", "one", 1)
    fleet = tmp_path / "fleet.toml"
    fleet.write_text('prototypes = ["sub/one.toml"]')
    assert collect([fleet, one]) == [one.resolve()]
    fleet.write_text('prototypes = ["sub/one.toml"]\njobs = 2')
    with pytest.raises(InputError, match="'prototypes' alone"):
        collect([fleet])


def test_what_is_not_there_is_said(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="no settings file"):
        collect([tmp_path])
    with pytest.raises(InputError, match="no such file"):
        collect([tmp_path / "x.toml"])


def test_two_of_one_name_would_share_a_folder(tmp_path: Path) -> None:
    (tmp_path / "sub").mkdir()
    pair = [_prototype(tmp_path, "a", 1), _prototype(tmp_path / "sub", "a", 2)]
    with pytest.raises(InputError, match="named 'a'"):
        run_batch(pair, tmp_path / "runs", 1, lambda *_: None, fail_fast=False)


def test_no_cell_of_the_csv_is_a_formula(tmp_path: Path) -> None:
    write_fleet(tmp_path, [Outcome("x", tmp_path, 2, "=cmd()|' /C calc'!A0", 0.1)])
    with (tmp_path / "fleet.csv").open(newline="") as stream:
        assert next(csv.DictReader(stream))["reason"].startswith("'=cmd")
