"""Inputs that were recorded when they changed: each sample holds until the next one."""

import numpy as np
import pandas as pd
import pytest
from asammdf import MDF, Signal
from typer.testing import CliRunner

from cli import app
from pipeline.signals.columns import CHUNK, held
from pipeline.store.run_folder import RunFolder

RUNNER = CliRunner()
T = 0.001 * np.arange(8000)
V = np.where(T % 1.0 < 0.4, 1000.0 * np.floor(T % 3.0), 0.0)
Q = 5.0 * np.sin(2.0 * np.pi * T)
CHANGES = np.flatnonzero(np.diff(V, prepend=-1.0))


def write(folder, form):
    if form == "csv":
        cells = np.where(np.isin(np.arange(T.size), CHANGES), V, np.nan)
        pd.DataFrame({"t": T, "q": Q, "v": cells}).to_csv(folder / "log.csv", index=False)
    else:
        log = MDF()
        log.append([Signal(Q, T, name="q", unit="mm")])
        log.append([Signal(V[CHANGES], T[CHANGES], name="v", unit="V")])
        log.save(folder / "log.mf4", overwrite=True)


def settings(form, on_change, of="v1"):
    keys = {key: f'channel = "{key[0]}", unit = "{"mm" if key == "q" else "V"}"' for key in ("q", "v1")}
    keys[of] += ", on_change = true" if on_change else ""
    time = 'time = { channel = "t", unit = "s" }\n' if form == "csv" else ""
    lines = [f"{key} = {{ {text} }}" for key, text in keys.items()]
    return f'name = "d"\n[logs]\ntrain = ["log.{form}"]\n[channels]\n{time}' + "\n".join(lines)


def ingested(folder, form, on_change=True, of="v1"):
    write(folder, form)
    (folder / "d.toml").write_text(settings(form, on_change, of), encoding="utf-8")
    return RUNNER.invoke(app, ["ingest", str(folder / "d.toml"), "-o", str(folder / "run")])


@pytest.mark.parametrize("form", ["csv", "mf4"])
def test_the_record_holds_what_the_input_was(tmp_path, form):
    assert ingested(tmp_path, form).exit_code == 0
    record = RunFolder.open(tmp_path / "run").read_table("train/log/record.parquet")
    there = np.interp(record["t"], T, V)
    far = np.min(np.abs(record["t"][:, None] - T[CHANGES]), axis=1) > 0.003  # from an edge
    np.testing.assert_allclose(record["v1"][far], there[far], atol=1e-6)
    assert np.all(record["segment"] == 0)


@pytest.mark.parametrize("form", ["csv", "mf4"])
def test_without_the_setting_the_log_is_refused_with_it_named(tmp_path, form):
    result = ingested(tmp_path, form, on_change=False)
    assert result.exit_code == 3
    assert "on_change = true" in " ".join(result.output.split())


def test_held_samples_are_the_last_finite_ones():
    rng = np.random.default_rng(0)
    time = np.cumsum(rng.uniform(0.5, 1.5, CHUNK + 999))
    stamps = np.sort(rng.choice(time[50:], 300, replace=False))
    samples = np.where(rng.random(300) < 0.1, np.nan, rng.standard_normal(300))
    expected = pd.Series(samples, stamps).dropna().reindex(time, method="ffill").to_numpy()
    found = held(time, stamps, samples)
    np.testing.assert_array_equal(found, expected)
    assert np.isnan(found[:50]).all()
