"""Logs of other devices: in volts of their data acquisition, without a time channel, of an electronic circuit."""

import re

import numpy as np
import pytest
from typer.testing import CliRunner

from cli import app
from pipeline.store.run_folder import RunFolder

RUNNER = CliRunner()
RATE = 200.0


def ingested(folder, channels, more="", *, time=False):
    t = np.arange(800) / RATE
    columns = [0.5 + 0.2 * np.sin(2 * np.pi * t), np.sign(np.sin(3.0 * t))]
    table = np.column_stack([t, *columns] if time else columns)
    np.savetxt(folder / "log.csv", table, fmt="%.9f", delimiter=",", header="t,q,v" if time else "q,v", comments="")
    text = f'name = "d"\n[logs]\ntrain = ["log.csv"]\n[channels]\n{channels}\n{more}\n'
    (folder / "d.toml").write_text(text, encoding="utf-8")
    result = RUNNER.invoke(app, ["ingest", str(folder / "d.toml"), "-o", str(folder / "run"), "--json"])
    return result, folder / "run"


def test_volts_of_the_data_acquisition_become_millimetres_by_scale_and_offset(tmp_path):
    channels = (
        'q = { channel = "q", unit = "mm", scale = 20.0, offset = -10.0 }\nv1 = { channel = "v", unit = "V" }'
        '\ntime = { channel = "t", unit = "s" }'
    )
    result, run = ingested(tmp_path, channels, time=True)
    assert result.exit_code == 0, result.output
    q = RunFolder.open(run).read_table("train/log/signals.parquet")["q"]
    assert (np.nanmin(q), np.nanmax(q)) == pytest.approx((-4e-3, 4e-3), abs=2e-5)


def test_a_log_without_time_is_read_at_its_sample_rate_and_refused_without_one(tmp_path):
    channels = 'q = { channel = "q", unit = "mm" }\nv1 = { channel = "v", unit = "V" }'
    result, _ = ingested(tmp_path, channels)
    assert result.exit_code == 2
    assert "sample_rate" in result.output
    result, run = ingested(tmp_path, channels, f"[ingest]\nsample_rate = {RATE}")
    assert result.exit_code == 0, result.output
    t = RunFolder.open(run).read_table("train/log/signals.parquet")["t"]
    assert t[-1] == pytest.approx(799 / RATE, abs=0.011)


def test_a_log_of_two_megahertz_is_read_in_stretched_time(tmp_path):
    """The way out that the refusal of such an interval names."""
    t = np.arange(800) / 2e6
    rows = np.column_stack([t, np.sin(2e5 * t), np.sign(np.sin(3e4 * t))])
    np.savetxt(tmp_path / "log.csv", rows, fmt="%.9g", delimiter=",", header="t,q,v", comments="")
    channels = (
        'q = { channel = "q", unit = "V" }\nv1 = { channel = "v", unit = "V" }\ntime = { channel = "t", unit = "s"'
    )
    for time, interval, told in ((" }", 5e-7, "stretch time"), (", scale = 1e4 }", 5e-3, "")):
        text = f"[channels]\n{channels}{time}\n[ingest]\nsample_interval = {interval}\n"
        (tmp_path / "d.toml").write_text(f'name = "d"\n[logs]\ntrain = ["log.csv"]\n{text}', encoding="utf-8")
        result = RUNNER.invoke(app, ["ingest", str(tmp_path / "d.toml"), "-o", str(tmp_path / "run")])
        assert (result.exit_code == 2) == bool(told) and told in result.output
    table = RunFolder.open(tmp_path / "run").read_table("train/log/signals.parquet")
    assert np.diff(table["t"]) == pytest.approx(5e-3) and table["t"].size >= 799


def shaken(folder, velocity_unit="mm/s", acceleration='unit = "m/s^2", scale = 9.81', inputs="linear"):
    """A log of a shaken circuit board: displacement of a coarse encoder, velocity of a vibrometer, base in g."""
    t = np.arange(2000) / 400.0
    q, velocity = 4.0 * np.sin(8.0 * t), 32.0 * np.cos(8.0 * t)
    table = np.column_stack([t, np.round(q / 0.5) * 0.5, velocity, np.sin(3.0 * t)])
    np.savetxt(folder / "log.csv", table, fmt="%.9f", delimiter=",", header="t,enc,vib,base", comments="")
    (folder / "d.toml").write_text(
        f"""name = "d"
[logs]
train = ["log.csv"]
[channels]
time = {{ channel = "t", unit = "s" }}
q = {{ channel = "enc", unit = "mm" }}
qdot = {{ channel = "vib", unit = "{velocity_unit}" }}
v1 = {{ channel = "base", {acceleration} }}
[plant]
inputs = "{inputs}"
""",
        encoding="utf-8",
    )
    return RUNNER.invoke(app, ["ingest", str(folder / "d.toml"), "-o", str(folder / "run")])


def test_a_measured_velocity_is_resampled_and_differentiated_once(tmp_path):
    result = shaken(tmp_path)
    assert result.exit_code == 0, result.output
    assert RUNNER.invoke(app, ["differentiate", str(tmp_path / "run")]).exit_code == 0
    run = RunFolder.open(tmp_path / "run")
    table, middle = run.read_table("train/log/kinematics.parquet"), slice(20, -20)
    t = table["t"][middle]
    assert table["velocity"][middle] == pytest.approx(0.032 * np.cos(8.0 * t), abs=2e-5)
    assert table["qdot"][middle] == pytest.approx(0.032 * np.cos(8.0 * t), abs=1e-5)
    assert table["qddot"][middle] == pytest.approx(-0.256 * np.sin(8.0 * t), abs=2e-3)
    assert table["v1"][middle] == pytest.approx(9.81 * np.sin(3.0 * t), abs=1e-3)
    assert run.record("train/log/kinematics.parquet").notes["of"] == "velocity"


@pytest.mark.parametrize(
    ("changes", "said"),
    [
        ({"velocity_unit": "deg/s"}, "channels.qdot.unit"),
        ({"velocity_unit": "mm"}, "channels.qdot.unit"),
        ({"inputs": "squared"}, "an acceleration acts by itself"),
    ],
)
def test_what_no_velocity_and_no_acceleration_can_be_is_refused(tmp_path, changes, said):
    result = shaken(tmp_path, **changes)
    assert result.exit_code == 2
    assert said in result.output.replace("\n", " ")


@pytest.mark.parametrize(("unit", "factor"), [("mm/s", None), ("cm/s", 0.1), ("m/s", 0.001)])
def test_a_velocity_that_contradicts_the_displacement_is_warned_of(tmp_path, unit, factor):
    assert shaken(tmp_path, velocity_unit=unit).exit_code == 0
    result = RUNNER.invoke(app, ["differentiate", str(tmp_path / "run")])
    assert result.exit_code == 0, result.output
    said = " ".join(result.output.split())
    found = re.search(r"q moves (\S+) times as far as qdot; check unit, scale and sign", said)
    assert (found is None) == (factor is None)
    assert found is None or float(found[1]) == pytest.approx(factor, rel=0.05)
