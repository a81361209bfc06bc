"""The first settings file lies where it is told, with paths from there; descriptions and monitors are read."""

import tomllib

import h5py
import numpy as np
import pytest
from scipy.io import savemat
from typer.testing import CliRunner

from cli import app
from pipeline.rig_logs.attributes import monitor_ratio
from pipeline.rig_logs.draft import toml_draft
from pipeline.rig_logs.inspection import inspect_log

RUNNER = CliRunner()
T = 0.002 * np.arange(1500)
COLUMNS = {"q": np.sin(T), "a": 3.0 * (np.sin(3 * T) > 0.0), "b": 3.0 * (np.sin(3 * T) < 0.0)}


@pytest.fixture
def log(tmp_path):
    (tmp_path / "raw").mkdir()
    with h5py.File(tmp_path / "raw" / "log.h5", "w") as file:
        file.attrs["amplifier"] = "Trek 10/10B, monitor 1:1000"
        file["t"] = T
        told = {"q": ("mm", "Laser"), "a": ("V", "HV links"), "b": ("V", "HV rechts")}
        for number, (name, (unit, text)) in enumerate(told.items()):
            file[f"AI{number}"] = COLUMNS[name]
            file[f"AI{number}"].attrs.update(unit=unit, description=text)
    return tmp_path / "raw" / "log.h5"


def test_channels_by_their_descriptions_and_the_scale_by_the_head(log):
    text = toml_draft([inspect_log(log)])
    channels = tomllib.loads(text)["channels"]
    assert channels["q"] == {"channel": "AI0", "unit": "mm"}
    assert channels["v1"] == {"channel": "AI1", "unit": "V", "scale": 1000.0}
    assert channels["v2"] == {"channel": "AI2", "unit": "V", "scale": 1000.0}
    assert '"AI1" [V] (HV links)' in text


def test_paths_hold_from_where_the_file_lies(log, tmp_path, monkeypatch):
    (tmp_path / "settings").mkdir()
    monkeypatch.chdir(tmp_path)
    arguments = ["init", "raw/log.h5", "-o", "settings/P.toml"]
    assert RUNNER.invoke(app, arguments).exit_code == 0
    written = tomllib.loads((tmp_path / "settings" / "P.toml").read_text())
    assert written["logs"]["train"] == ["../raw/log.h5"]
    again = RUNNER.invoke(app, arguments)
    assert again.exit_code == 2 and "exists" in " ".join(again.output.split())
    assert tomllib.loads(RUNNER.invoke(app, ["init", "raw/log.h5"]).stdout)["logs"]["train"] == ["raw/log.h5"]


@pytest.mark.parametrize(
    ("text", "ratio"),
    [
        ("HV 1:1000", 1000.0), ("Teiler 2000 : 1", 2000.0), ("1 V = 1 kV", 1000.0), ("1V/kV", 1000.0),
        ("2 kV/V", 2000.0), ("begun at 11:10:00", 1.0), ("at 1:100:00", 1.0), ("up to 3 kV, 1:10", 1.0),
    ],
)  # fmt: skip
def test_the_ratio_of_a_monitor(text, ratio):
    assert monitor_ratio("no word of it", text) == ratio


def test_small_voltages_may_be_those_of_a_monitor(tmp_path):
    table = np.c_[T, *COLUMNS.values()]
    np.savetxt(tmp_path / "log.csv", table, delimiter=",", header="t [s],q [mm],U1 [V],U2 [V]", comments="", fmt="%.4f")
    assert toml_draft([inspect_log(tmp_path / "log.csv")]).count("1:1000 monitor?") == 2
    settings = tmp_path / "P.toml"
    settings.write_text(
        'name = "P"\n[logs]\ntrain = ["log.csv"]\n[channels]\ntime = { channel = "t", unit = "s" }\n'
        'q = { channel = "q", unit = "mm" }\nv1 = { channel = "U1", unit = "kV" }\n'
    )
    refused = RUNNER.invoke(app, ["ingest", str(settings), "-o", str(tmp_path / "run")])
    assert refused.exit_code == 2 and 'give unit = "V", scale = 1000' in " ".join(refused.output.split())


def test_a_text_of_a_mat_file_tells_of_the_monitor_where_no_unit_is_stated(tmp_path):
    savemat(tmp_path / "log.mat", {"t": T, "laser": COLUMNS["q"], "hv1": COLUMNS["a"], "note": "Trek, monitor 1:1000"})
    assert "the log names 1:1000: V of a monitor take scale = 1000" in toml_draft([inspect_log(tmp_path / "log.mat")])
