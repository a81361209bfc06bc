"""What inspection says of a log, and the settings file that it drafts."""

import json
import tomllib

import numpy as np
import pytest

from pipeline.rig.log import write_mat5
from pipeline.rig_logs.channel_roles import suggest, suggested_unit
from pipeline.rig_logs.draft import proposed_roles, quoted, toml_draft
from pipeline.rig_logs.inspection import inspect_log
from pipeline.units.units import FILL_IN


@pytest.fixture(scope="module")
def noisy_log(tmp_path_factory):
    path = tmp_path_factory.mktemp("inspection") / "run 3 (b).mat"
    t = np.arange(30_000) / 3000.0
    rng = np.random.default_rng(0)
    q = np.clip(10.0 * np.sin(2 * np.pi * t), -8.0, np.inf) + 0.05 * np.sin(2 * np.pi * 50.0 * t)
    q = np.where(q < -7.9, -8.0, q + rng.normal(0.0, 1e-3, t.size))
    write_mat5(
        path,
        t,
        {
            "Laser_q": (q, "mm"),
            "HV1_meas": (3.0 * (t % 2 < 1) + rng.normal(0.0, 0.01, t.size), "kV"),
            "HV2_meas": (rng.normal(0.0, 0.01, t.size), "kV"),
        },
    )
    return path


def test_inspection_finds_what_was_planted(noisy_log):
    inspection = inspect_log(noisy_log)
    (time,) = inspection.time_bases
    assert inspection.own_time and time.step == pytest.approx(1.0 / 3000.0)
    channels = {channel.name: channel for channel in inspection.channels}
    assert channels["Laser_q"].time_base == 0 and channels["time"].time_base is None
    remarks = " ".join(channels["Laser_q"].remarks)
    assert "lower extreme -8: saturated?" in remarks and "50 Hz hum" in remarks
    assert "no excitation" in " ".join(channels["HV2_meas"].remarks)
    assert channels["HV1_meas"].remarks == ()


def test_draft_is_a_settings_file(noisy_log):
    text = toml_draft([inspect_log(noisy_log)])
    draft = tomllib.loads(text)
    assert draft["name"] == "run 3 (b)"
    assert draft["logs"]["train"] == ["run 3 (b).mat"]
    assert draft["channels"] == {
        "q": {"channel": "Laser_q", "unit": "mm"},
        "v1": {"channel": "HV1_meas", "unit": "kV"},
        "v2": {"channel": "HV2_meas", "unit": "kV"},
    }
    assert text.count("# suggested") == 3


def test_csv_needs_a_time_column(logs):
    inspection = inspect_log(logs["csv"])
    assert not inspection.own_time
    assert tomllib.loads(toml_draft([inspection]))["channels"]["time"] == {"channel": "time", "unit": "s"}
    assert any("described as if 'time' were time in s" in note for note in inspection.notes)


@pytest.mark.parametrize(
    ("name", "unit", "expected"),
    [
        ("tempo_ms", "", "ms"), ("angulo_deg", "", "deg"), ("u_pct", "", "percent"), ("Weg q", "[µm]", "µm"),
        ("phi", "°", "deg"), ("HV1_meas", "", ""), ("U_KV", "", "kV"), ("drive_A", "", "A"), ("signal_M", "", ""),
        ("x_mm", "", "mm"), ("t/s", "", "s"), ("q / mm", "", "mm"), ("U/V", "", "V"), ("a/b", "", ""),
        ("angle in deg", "", "deg"), ("t [ms]", "", "ms"), ("q [mm]", "", "mm"), ("v1 (kV)", "", "kV"),
    ],
)  # fmt: skip
def test_unit_suggestions(name, unit, expected):
    assert suggested_unit(name, unit) == expected


def test_role_suggestions():
    roles = suggest([("Zeit", "s"), ("Weg q", "µm"), ("U DE1", "V"), ("U DE2", "V")], own_time=False)
    assert [(role.role, role.only) for role in roles] == [
        ("time", "Zeit"),
        ("q", "Weg q"),
        ("v1", "U DE1"),
        ("v2", "U DE2"),
    ]
    several = suggest([("a", "mm"), ("b", "mm"), ("c", "V"), ("d", "V"), ("e", "V")], own_time=True)
    assert [role.only for role in several] == [None, None, None]
    assert several[1].candidates == ("c", "d", "e")


@pytest.mark.parametrize(
    "name", ['quo"te', "back\\slash", "esc\x1b[2J", "rtl\u202e", "nul\0", "ünï", "new\nline", "del\x7f"]
)
def test_hostile_names_stay_inside_their_quotes(name):
    text = quoted(name)
    assert tomllib.loads(f"x = {text}")["x"] == name
    assert text.isprintable()


def test_undecodable_bytes_in_a_name_are_replaced():
    text = quoted("a\udc80b")
    assert tomllib.loads(f"x = {text}")["x"] == "a\ufffdb"


def test_what_a_log_excites_is_told_where_the_channels_are_clear(noisy_log, tmp_path):
    from typer.testing import CliRunner

    from cli import app

    shown = CliRunner().invoke(app, ["inspect", str(noisy_log)])
    assert shown.exit_code == 0, shown.output
    assert "HV2_meas" in shown.stdout and "Not excited" in shown.stdout and "chosen by name and unit" in shown.stdout
    document = json.loads(CliRunner().invoke(app, ["inspect", str(noisy_log), "--json"]).stdout)
    assert sum(document["excitation"]["excitation"]["visits"]["visits"]) == 1000
    settings = tmp_path / "P.toml"
    draft = toml_draft([inspect_log(noisy_log)]).replace("run 3 (b).mat", "log.mat")
    settings.write_text(draft + "\n[identify]\nbasis_functions = 6\n")
    named = CliRunner().invoke(app, ["inspect", str(noisy_log), "--settings", str(settings), "--json"])
    found = json.loads(named.stdout)["excitation"]
    assert len(found["excitation"]["centres_m"]) == 6 and not found["assumed"]


@pytest.mark.parametrize(
    ("given", "validation"),
    [
        (["train.mat", "validation.mat"], ["validation.mat"]),
        (["1.mf4", "2.mf4", "3.mf4"], ["3.mf4"]),
        (["Prüflauf 1.csv", "Prüflauf 2.csv"], ["Prüflauf 2.csv"]),
        (["train-1.mat", "train-2.mat"], []),
        (["log.mat"], []),
        (["prbs_test_60min_val.mat", "prbs_test_60min.mat"], ["prbs_test_60min_val.mat"]),
        (["profit.csv", "vali.csv", "latest.csv"], ["latest.csv"]),
    ],
)
def test_logs_are_proposed_for_training_and_validation(given, validation):
    train, proposed = proposed_roles(given)
    assert proposed == validation
    assert sorted(train + proposed) == sorted(given) and train


def _csv(path, header, *columns, fmt="%.6g", delimiter=","):
    np.savetxt(path, np.column_stack(columns), fmt=fmt, delimiter=delimiter, header=header, comments="")
    return path


def test_a_column_that_rises_evenly_may_be_the_time(tmp_path):
    """A log without a heading, as a microcontroller prints it."""
    t = np.arange(2000)
    np.savetxt(path := tmp_path / "serial.csv", np.column_stack([10 * t, np.sin(0.02 * t), t % 7]), "%.5g", ",")
    inspection = inspect_log(path)
    assert {role.role: role.only for role in inspection.suggestions}["time"] == "column 1"
    assert tomllib.loads(toml_draft([inspection]))["channels"]["time"] == {"channel": "column 1", "unit": FILL_IN}


def _draft(path):
    return tomllib.loads(toml_draft([inspect_log(path)]))


def test_draft_asks_for_the_rate_of_a_log_without_time(tmp_path):
    t = np.arange(4000) / 100.0
    columns = (30.0 * np.sin(t) ** 3, 3.0 * np.sign(np.sin(0.3 * t)))
    draft = _draft(_csv(tmp_path / "no_time.csv", "angle [deg],motor [V]", *columns))
    assert "time" not in draft["channels"] and draft["ingest"] == {"sample_rate": FILL_IN}
    text = toml_draft([inspect_log(_csv(tmp_path / "odd.csv", "angle [deg],motor [V],x7", *columns, np.cos(t)))])
    assert tomllib.loads(text)["channels"]["time"]["channel"] == FILL_IN
    assert f'# sample_rate = "{FILL_IN}"' in text


def test_draft_takes_the_step_of_a_slow_log_and_the_law_of_an_input_of_both_signs(tmp_path):
    t = np.arange(2000.0)
    q, u = np.sin(0.01 * t), np.sign(np.sin(0.003 * t))
    slow = _draft(_csv(tmp_path / "slow.csv", "t [s],level [cm],pump [V]", t, q, 5.0 + u))
    assert slow["ingest"] == {"sample_interval": 1} and slow["plant"]["inputs"] == "squared"
    assert "ingest" not in _draft(_csv(tmp_path / "fast.csv", "t [ms],level [cm],pump [V]", t, q, 5.0 + u))
    assert "ingest" not in _draft(_csv(tmp_path / "open.csv", "t,level [cm],pump [V]", t, q, 5.0 + u))
    both = _draft(_csv(tmp_path / "both.csv", "t [s],angle [deg],motor [V]", t, q, u))
    assert both["plant"]["inputs"] == "linear"
    hardly = _draft(_csv(tmp_path / "hardly.csv", "t [s],angle [deg],fan [%]", t, q, 25.0 + 55.0 * u))
    assert hardly["plant"]["inputs"] == "squared"  # the fan of a drone brakes for a moment


def _mat(path, **variables):
    from scipy.io import savemat

    savemat(path, variables)
    return path


def _h5(path, **datasets):
    import h5py

    with h5py.File(path, "w") as file:
        for name, values in datasets.items():
            file[name] = values
    return path


def _chosen(path):
    return {role: channel["channel"] for role, channel in _draft(path)["channels"].items()}


def test_parameters_beside_a_record_are_not_proposed(tmp_path):
    """A result of an identification in the file: its vectors are called angle and voltage too."""
    t = np.arange(2000.0)
    est = {"theta": np.ones((6, 3)), "volt": np.arange(8.0), "level": np.zeros(1900)}
    data = {"time": t, "ydat": np.sin(t)[:, None], "udat": np.column_stack([np.cos(t), t % 7]), "tstep": np.arange(150)}
    path = _mat(tmp_path / "result.mat", est=est, data=data)
    assert _chosen(path) == {
        "time": "data.time", "q": "data.ydat", "v1": "data.udat(:,1)", "v2": "data.udat(:,2)"
    }  # fmt: skip
    assert set(inspect_log(path).apart) >= {"est.volt", "est.level", "data.tstep"}


WAVE, INPUT = np.sin(0.1 * np.arange(900.0)), np.arange(900) % 7 / 7.0


@pytest.mark.parametrize("column", [["200"] * 900, ["200", *[""] * 899]], ids=["constant", "first row"])
def test_a_column_that_tells_the_rate_is_suggested_in_the_draft(tmp_path, column):
    rows = [f"{q:.5g},{u:.5g},{fs}" for q, u, fs in zip(WAVE, INPUT, column, strict=True)]
    (path := tmp_path / "log.csv").write_text("\n".join(["q,u,fs", *rows]) + "\n")
    text, draft = toml_draft([inspect_log(path)]), _draft(path)
    assert draft["ingest"] == {"sample_rate": 200} and _chosen(path) == {"q": "q", "v1": "u"}
    assert "suggested: what fs in the log says" in text and "v2 is left out: a device with one input?\n" in text


def test_the_rate_beside_the_channels_is_suggested(tmp_path):
    draft = _draft(_mat(tmp_path / "log.mat", y=WAVE, u=INPUT, Ts=4.0))
    assert draft["ingest"] == {"sample_rate": 0.25, "sample_interval": 4} and "time" not in draft["channels"]
    both = {"a/y": WAVE, "a/u": INPUT, "b/y": WAVE[:50], "b/u": INPUT[:50]}
    near = _h5(tmp_path / "near.h5", **both, **{"a/fs": np.array([750.0]), "b/fs": 8.0, "fs": 9.0})
    assert _draft(near)["ingest"] == {"sample_rate": 750}


def test_no_clock_is_taken_for_q_and_no_other_channel_for_a_clock(tmp_path):
    numbers = np.arange(900)
    (path := tmp_path / "log.csv").write_text(
        "# fs: 200\nNo,T,x,u,u\n"
        + "".join(f"{n},23.5,{q:.5g},{u:.5g},0\n" for n, q, u in zip(numbers, WAVE, INPUT, strict=True))
    )
    draft = toml_draft([inspect_log(path)])
    assert 'q = { channel = "x"' in draft and "sample_rate = 200" in draft and '# one of "u", "u (2)"' in draft
    both = _mat(tmp_path / "log.mat", T=np.full(900, 23.5), t=numbers / 200.0, x=WAVE, u=INPUT)
    assert _draft(both)["channels"]["time"]["channel"] == "t"
    grouped = _draft(_h5(tmp_path / "log.h5", **{"rig/t": numbers / 200.0, "rig/q": WAVE, "rig/v1": INPUT}))
    assert {key: each["channel"] for key, each in grouped["channels"].items()} == {
        "time": "rig/t", "q": "rig/q", "v1": "rig/v1",
    }  # fmt: skip
