"""A saturated, spiky log through ingest and differentiate: masked, counted, told; nothing is fitted there."""

import json
from pathlib import Path

import numpy as np
from typer.testing import CliRunner

from cli import app
from pipeline.store.run_folder import RunFolder
from tests.prototypes import settings

RUNNER = CliRunner()


def _ingested(folder: Path, more: str = "") -> RunFolder:
    rng, t = np.random.default_rng(3), np.arange(6000) / 1000.0
    q = 10.0 * np.sin(2 * np.pi * 0.8 * t) + 0.002 * rng.standard_normal(t.size)
    q = np.clip(q, None, 9.98)
    q[[700, 2900]] += 3.0
    q[700], q[2900] = min(q[700], 9.97), min(q[2900], 9.97)
    table = np.column_stack([t, q, 3.0 * (np.sin(t) > 0)])
    np.savetxt(folder / "log.csv", table, fmt="%.6f", delimiter=",", header="time,q,v1", comments="")
    (folder / "p.toml").write_text(settings(more, inputs=["v1"]), encoding="utf-8")
    result = RUNNER.invoke(app, ["ingest", str(folder / "p.toml"), "-o", str(folder / "run"), "--json"])
    assert result.exit_code == 0, result.output
    assert RUNNER.invoke(app, ["differentiate", str(folder / "run")]).exit_code == 0
    json.loads(result.stdout)
    return RunFolder.open(folder / "run")


def test_a_saturated_span_is_masked_counted_and_told(tmp_path):
    run = _ingested(tmp_path)
    notes = run.record("train/log/signals.parquet").notes
    assert 100 < notes["masked_at_rails"] < 200
    assert notes["masked_spikes"] == 2
    assert any("at the ends of its range masked" in text for text in notes["warnings"])
    table = run.read_table("train/log/kinematics.parquet")
    crest = np.abs(table["t"] - 0.25 / 0.8) < 0.005
    assert (table["segment"][crest] == -1).all()
    assert np.isnan(table["qddot"][crest]).all()
    assert np.nanmax(table["q"]) < 9.98e-3
    known = table["segment"] >= 0
    assert np.abs(table["q"][known] - 0.01 * np.sin(2 * np.pi * 0.8 * table["t"][known])).max() < 2e-5


def test_rows_cut_off_at_the_ends_of_a_log_are_masked_rows(tmp_path):
    """A target that is lost until the end leaves a shorter record, of which little is masked."""
    t = np.arange(6000) / 1000.0
    q = np.where(t < 3.6, 5.0 * np.sin(2 * np.pi * 0.8 * t), 60.0)
    table = np.delete(np.column_stack([t, q, 3.0 * (np.sin(9 * t) > 0)]), slice(800, 1750), axis=0)
    np.savetxt(tmp_path / "log.csv", table, fmt="%.6f", delimiter=",", header="time,q,v1", comments="")
    (tmp_path / "p.toml").write_text(settings(inputs=["v1"]), encoding="utf-8")
    result = RUNNER.invoke(app, ["ingest", str(tmp_path / "p.toml"), "-o", str(tmp_path / "run")])
    assert result.exit_code == 3, result.output
    assert "% of the rows are masked (gaps, rails, spikes, lost target) (at most 50 %)" in " ".join(
        result.stderr.split()
    )
