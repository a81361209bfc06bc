"""A channel may have its own time, a part of a signed monitor, blanks between samples, and codes for no value."""

import numpy as np
import pandas as pd
import pytest
from typer.testing import CliRunner

from cli import app
from pipeline.rig_logs.attributes import stated_rate
from pipeline.rig_logs.channel_roles import clocks_beside
from pipeline.store.run_folder import RunFolder

RUNNER = CliRunner()
T = 0.001 * np.arange(8000)
V = np.where(T % 1.0 < 0.4, 2800.0, 0.0) - np.where((T % 1.0 > 0.5) & (T % 1.0 < 0.8), 1400.0, 0.0)
Q = 5.0 * np.sin(2.0 * np.pi * T)
TIME = 'time = { channel = "t", unit = "s" }\n'


def ingested(folder, columns, channels, more=""):
    pd.DataFrame(columns).to_csv(folder / "log.csv", index=False)
    text = f'name = "d"\n[logs]\ntrain = ["log.csv"]\n[channels]\n{channels}\n[plant]\ninputs = "linear"\n{more}'
    (folder / "d.toml").write_text(text, encoding="utf-8")
    result = RUNNER.invoke(app, ["ingest", str(folder / "d.toml"), "-o", str(folder / "run")])
    if result.exit_code:
        return " ".join(result.output.split()), None
    run = RunFolder.open(folder / "run")
    return run.record("train/log/record.parquet").notes["warnings"], run.read_table("train/log/record.parquet")


def test_a_signed_monitor_of_both_membranes(tmp_path):
    halves = "\n".join(
        f'{key} = {{ channel = "v", unit = "V", part = "{part}" }}'
        for key, part in (("v1", "positive"), ("v2", "negative"))
    )
    _, record = ingested(tmp_path, {"t": T, "q": Q, "v": V}, TIME + 'q = { channel = "q", unit = "mm" }\n' + halves)
    inside = np.abs(np.gradient(V)) == 0.0
    rows = np.rint(record["t"] / 0.001).astype(int)
    np.testing.assert_allclose(record["v1"][inside[rows]], np.maximum(V, 0.0)[rows][inside[rows]], atol=1e-6)
    np.testing.assert_allclose(record["v2"][inside[rows]], np.maximum(-V, 0.0)[rows][inside[rows]], atol=1e-6)


def test_a_slow_input_with_blanks_between_is_interpolated(tmp_path):
    slow = np.where(np.arange(T.size) % 10 == 0, 1000.0 * np.sin(T), np.nan)
    channels = TIME + 'q = { channel = "q", unit = "mm" }\nv1 = { channel = "v", unit = "V" }'
    warnings, record = ingested(tmp_path, {"t": T, "q": Q, "v": slow}, channels)
    assert any("v1 has a sample every 10 rows" in warning for warning in warnings)
    np.testing.assert_allclose(record["v1"], 1000.0 * np.sin(record["t"]), atol=0.1)


@pytest.mark.parametrize(
    ("code", "declared"), [(-9999.0, ""), (1.7976931348623157e308, ""), (-1.0, ", missing = [-1]")]
)
def test_codes_in_an_input_are_masked_and_told(tmp_path, code, declared):
    spoilt = np.abs(V)
    spoilt[3000:3004] = code
    channels = TIME + f'q = {{ channel = "q", unit = "mm" }}\nv1 = {{ channel = "v", unit = "V"{declared} }}'
    warnings, record = ingested(tmp_path, {"t": T, "q": Q, "v": spoilt}, channels)
    assert any(f"v1: 4 samples of {code:.6g} stand for no value" in warning for warning in warnings)
    assert record["v1"].min() > -50.0 and record["v1"].max() < 3000.0


@pytest.mark.parametrize("period", [0.65536, 4.0, 7.9])
def test_a_counter_that_begins_anew_is_unwrapped(tmp_path, period):
    channels = TIME + 'q = { channel = "q", unit = "mm" }\nv1 = { channel = "v", unit = "V" }'
    columns = {"t": (T + 0.3) % period, "q": Q, "v": np.abs(V)}
    assert ' of 8000 rows, or "unwrap" for a counter' in ingested(tmp_path, columns, channels)[0]
    warnings, record = ingested(tmp_path, columns, channels, '[ingest]\ntime_reversal = "unwrap"\n')
    assert any("a counter that begins anew" in warning for warning in warnings)
    assert np.ptp(record["t"]) == pytest.approx(np.ptp(T), abs=0.002)
    np.testing.assert_allclose(record["q"], np.interp(record["t"] - record["t"][0], T, Q) * 1e-3, atol=1e-4)


def test_one_stamp_far_ahead_is_refused_before_a_record_of_that_length_is_made(tmp_path):
    channels = TIME + 'q = { channel = "q", unit = "mm" }\nv1 = { channel = "v", unit = "V" }'
    far = np.where(np.arange(T.size) < 4000, T, T + 1e12)
    told, _ = ingested(tmp_path, {"t": far, "q": Q, "v": np.abs(V)}, channels)
    assert "holds 8 s of samples within 1e+12 s" in told


def test_two_clocks_before_all_channels_are_named_and_neither_is_chosen(tmp_path):
    """Nothing shows which of them is that of the input; a clock of the same times is none to name."""
    channels = 'time = { channel = "time_a", unit = "s" }\nq = { channel = "q", unit = "mm" }\n'
    late = {"time_a": T, "time_b": T + 0.012, "q": Q, "v": V}
    warnings, record = ingested(tmp_path, late, channels + 'v1 = { channel = "v", unit = "V" }')
    assert sum("'time_b', up to 12.0 ms from 'time_a': which of them is that of" in text for text in warnings) == 2
    np.testing.assert_allclose(record["q"], 1e-3 * np.interp(record["t"], T, Q), atol=1e-5)
    of_all = 'v1 = { channel = "v", unit = "V" }'
    own = 'v1 = { channel = "v", unit = "V", time = { channel = "time_b", unit = "s" } }'
    for columns, input_ in ((late, own), (late | {"time_b": T}, own), (late | {"time_b": T + 1.7e9}, of_all)):
        warnings, _ = ingested(tmp_path, columns, channels + input_)
        assert not [text for text in warnings if "which of them" in text or "is not used" in text]


def test_a_second_channel_of_one_name_is_told(tmp_path):
    """As where a second recording has a group or columns of its own beside the first."""
    rows = "".join(f"{t:.4f},{q:.4f},{v:.1f},{t:.4f},{q:.4f},{v:.1f}\n" for t, q, v in zip(T, Q, V, strict=True))
    (tmp_path / "log.csv").write_text("t,q,v,t,q,v\n" + rows)
    (tmp_path / "d.toml").write_text(
        f'name = "d"\n[logs]\ntrain = ["log.csv"]\n[channels]\n{TIME}q = {{ channel = "q", unit = "mm" }}\n'
        'v1 = { channel = "v", unit = "V" }\n[plant]\ninputs = "linear"\n'
    )
    result = RUNNER.invoke(app, ["ingest", str(tmp_path / "d.toml"), "-o", str(tmp_path / "run")])
    said = " ".join(result.output.split())
    assert "q: the log has 'q (2)' too, which is not read" in said and "'v (2)' too" in said and "'t (2)' t" not in said


def test_clocks_may_stand_behind_their_channels():
    assert clocks_beside(["X", "q", "X (2)", "v1"], "X") == {"q": "X", "v1": "X (2)"}
    assert clocks_beside(["q", "time", "v1", "time (2)"], "time") == {"q": "time", "v1": "time (2)"}
    assert clocks_beside(["time", "q", "time (2)", "v1"], "time") == {"q": "time", "v1": "time (2)"}
    assert clocks_beside(["clock", "q", "clock_v", "v1"], "time") == {"q": "clock", "v1": "clock_v"}
    assert clocks_beside(["time", "q", "v1", "time_v"], "time") == {"q": "time_v", "v1": "time_v"}
    assert clocks_beside(["a", "q", "b", "v1"], "a", ["b"]) == {"q": "a", "v1": "b"}


@pytest.mark.parametrize(
    ("name", "number", "rate"),
    [("f_sample", 500.0, 500.0), ("SampFreq", 500.0, 500.0), ("sr", 500.0, 500.0), ("log.daq_rate", 500.0, 500.0),
     ("Samples/s", 500.0, 500.0), ("deltaT", 2e-3, 500.0), ("T_sample_ms", 2.0, 500.0), ("birate", 2.0, None),
     ("fs", 500.0, 500.0), ("Fs_Hz", 500.0, 500.0), ("sample rate [kHz]", 0.5, 500.0), ("dt_ms", 2.0, 500.0),
     ("t_s", 2e-3, 500.0), ("sampling_interval_us", 2000.0, 500.0), ("gain_ms", 2.0, None), ("frequency", 2.0, None),
     ("Taux d'échantillonnage", 500.0, 500.0), ("Frecuencia de muestreo [kHz]", 0.5, 500.0),
     ("Periodo di campionamento", 2e-3, 500.0), ("Pas d’échantillonnage ms", 2.0, 500.0)],
)  # fmt: skip
def test_single_numbers_that_state_a_sample_rate(name, number, rate):
    assert stated_rate(name, number) == (None if rate is None else pytest.approx(rate))


def test_what_a_reader_left_out_is_a_warning_of_ingest(tmp_path):
    rows = [f"{t:.3f},{q:.4f},{v:.1f}" for t, q, v in zip(T, Q, V, strict=True)]
    rows[2500:2500] = ["operator paused the rig", "# again"]
    (tmp_path / "log.csv").write_text("\n".join(["t,q,v", *rows]) + "\n")
    (tmp_path / "d.toml").write_text(
        'name = "d"\n[logs]\ntrain = ["log.csv"]\n[channels]\ntime = { channel = "t", unit = "s" }\n'
        'q = { channel = "q", unit = "mm" }\nv1 = { channel = "v", unit = "V" }\n[plant]\ninputs = "linear"\n'
    )
    result = RUNNER.invoke(app, ["ingest", str(tmp_path / "d.toml"), "-o", str(tmp_path / "run")])
    assert "2 lines left out: line 2502: 'operator paused the rig'" in " ".join(result.output.split()), result.output


@pytest.mark.parametrize("names", [("X_Value", "X_Value"), ("t_q", "t_v"), ("Time", "v time"), ("a [s]", "b [s]")])
def test_each_channel_is_on_the_clock_beside_it(tmp_path, names):
    """As LabVIEW, ControlDesk and INCA write them; the settings name the time of one channel."""
    table = np.c_[T, Q, T + 0.012, V]
    header = f"{names[0]},q,{names[1]},v"
    np.savetxt(tmp_path / "log.csv", table, delimiter=",", header=header, comments="", fmt="%.6f")
    text = (
        f'name = "d"\n[logs]\ntrain = ["log.csv"]\n[channels]\ntime = {{ channel = "{names[0]}", unit = "s" }}\n'
        'q = { channel = "q", unit = "mm" }\nv1 = { channel = "v", unit = "V" }\n[plant]\ninputs = "linear"\n'
    )
    (tmp_path / "d.toml").write_text(text)
    result = RUNNER.invoke(app, ["ingest", str(tmp_path / "d.toml"), "-o", str(tmp_path / "run")])
    assert result.exit_code == 0
    record = RunFolder.open(tmp_path / "run").read_table("train/log/record.parquet")
    rises = record["t"][np.argmax(record["v1"] > 1400.0)] - T[np.argmax(V > 1400.0)]
    assert rises == pytest.approx(0.012, abs=2e-3) and "a clock of its own" in result.output


@pytest.mark.parametrize(
    ("name", "begins"),
    [("log.parquet", "2026-11-20T10:00"), ("log.npz", "2026-11-20T10:00"), ("iso.csv", "2026-11-20T10:00")]
    + [("clock.csv", begins) for begins in ("2026-11-20T10:00", "2026-11-20T23:59:59.995", "2026-11-20T23:59:59.985")],
)
@pytest.mark.parametrize("late", [0.012, -0.012])
def test_clocks_of_dates_or_times_of_day_keep_what_lies_between_them(tmp_path, name, begins, late):
    """Each would begin at zero by itself; time stamps of a log count from one origin, also across midnight."""
    stamps = np.datetime64(begins, "us") + np.rint(1e6 * T).astype("m8[us]")
    columns = {"t": stamps, "q": Q, "t_v": stamps + np.timedelta64(round(1e6 * late), "us"), "v": V}
    if name.endswith("npz"):
        np.savez(tmp_path / name, **columns)
    elif name.endswith("parquet"):
        pd.DataFrame(columns).to_parquet(tmp_path / name)
    else:
        texts = {key: [str(each)[11 * (name == "clock.csv") :] for each in columns[key]] for key in ("t", "t_v")}
        pd.DataFrame(columns | texts).to_csv(tmp_path / name, index=False)
    (tmp_path / "d.toml").write_text(
        f'name = "d"\n[logs]\ntrain = ["{name}"]\n[channels]\n{TIME}q = {{ channel = "q", unit = "mm" }}\n'
        'v1 = { channel = "v", unit = "V" }\n[plant]\ninputs = "linear"\n'
    )
    result = RUNNER.invoke(app, ["ingest", str(tmp_path / "d.toml"), "-o", str(tmp_path / "run")])
    said = " ".join(result.output.split())
    assert result.exit_code == 0, said
    record = RunFolder.open(tmp_path / "run").read_table(f"train/{name.partition('.')[0]}/record.parquet")
    np.testing.assert_allclose(record["q"], 1e-3 * np.interp(record["t"], T, Q), atol=1e-5)
    rises = record["t"][np.argmax(np.diff(record["v1"]) > 1000.0)] - T[np.argmax(np.diff(V) > 1000.0)]
    assert rises == pytest.approx(late, abs=2e-3)
    assert "up to 12.0 ms from 't': it is used for v1" in said and "rounded" not in said


def test_a_rate_that_the_log_states_against_that_of_the_settings(tmp_path):
    channels = 'q = { channel = "q", unit = "mm" }\nv1 = { channel = "v", unit = "V" }'
    (tmp_path / "log.csv").write_text(
        "# sample rate: 1000 Hz\nq,v\n" + "".join(f"{q:.4f},{v:.1f}\n" for q, v in zip(Q, V, strict=True))
    )
    text = f'name = "d"\n[logs]\ntrain = ["log.csv"]\n[channels]\n{channels}\n[plant]\ninputs = "linear"\n[ingest]\n'
    for rate, accept, code in ((1000.0, "", 0), (100.0, "", 3), (100.0, '[quality]\naccept = ["rate"]\n', 0)):
        (tmp_path / "d.toml").write_text(f"{text}sample_rate = {rate}\n{accept}")
        result = RUNNER.invoke(app, ["ingest", str(tmp_path / "d.toml"), "-o", str(tmp_path / f"run{rate}{code}")])
        assert result.exit_code == code, result.output
        assert (
            "sample rate states 1000 Hz, but [ingest] sample_rate is 100 Hz" in " ".join(result.output.split())
        ) is (rate == 100.0)


@pytest.mark.parametrize(
    ("above", "rate", "told"),
    [
        ("# 1000 Hz", 500.0, "the line '1000 Hz' is 1000 Hz, and a motion has less than half of"),
        ("Frequency: 1000 Hz", 2000.0, "Frequency is 1000 Hz"),
        ("frequency = 1 kHz", 1200.0, "frequency is 1000 Hz"),
        ("period_us: 1000", 833.3, "period_us is 1000 Hz"),
        ("# 1000 Hz", 1000.0, ""),
        ("excitation frequency: 2.5 Hz", 1000.0, ""),
        ("frequency: 400 Hz", 1000.0, ""),
        ("# 1000 Hz low pass", 500.0, ""),
    ],
)
def test_a_frequency_that_no_motion_can_have_questions_the_rate_and_refuses_nothing(tmp_path, above, rate, told):
    rows = "".join(f"{q:.4f},{v:.1f}\n" for q, v in zip(Q, V, strict=True))
    (tmp_path / "log.csv").write_text(f"{above}\nq,v\n{rows}")
    (tmp_path / "d.toml").write_text(
        'name = "d"\n[logs]\ntrain = ["log.csv"]\n[channels]\nq = { channel = "q", unit = "mm" }\n'
        f'v1 = {{ channel = "v", unit = "V" }}\n[plant]\ninputs = "linear"\n[ingest]\nsample_rate = {rate}\n'
    )
    result = RUNNER.invoke(app, ["ingest", str(tmp_path / "d.toml"), "-o", str(tmp_path / "run")])
    said = " ".join(result.output.split())
    assert result.exit_code == 0, said
    assert ("is that rate right?" in said) is bool(told) and told in said


@pytest.mark.parametrize(
    ("rate", "told"), [(1000.0, ""), (500.0, "at 25 Hz and no hum at 50 Hz"), (2000.0, "at 100 Hz")]
)
def test_mains_hum_on_the_probes_against_the_rate_of_the_settings(tmp_path, rate, told):
    t = 0.001 * np.arange(20_000)
    rng = np.random.default_rng(0)
    noise = rng.normal(size=(2, t.size))
    edges = np.cumsum(rng.uniform(0.2, 0.9, 60))  # periodic pulses have lines of their own
    v = np.where(np.searchsorted(edges, t) % 2, 2800.0, 0.0) + 5.0 * np.sin(2.0 * np.pi * 50.03 * t) + noise[0]
    columns = {"q": 5.0 * np.sin(2.0 * np.pi * t) + 0.01 * noise[1], "v": v}
    channels = 'q = { channel = "q", unit = "mm" }\nv1 = { channel = "v", unit = "V" }'
    warnings, _ = ingested(tmp_path, columns, channels, f"[ingest]\nsample_rate = {rate}\n")
    said = [text for text in warnings if "mains hum" in text]
    assert len(said) == bool(told) and told in "".join(said)


def test_rasters_side_by_side_are_filled_up_with_blanks(tmp_path):
    slow = np.full((2, T.size), np.nan)
    slow[:, : T.size // 5] = (T + 0.012)[::5], V[::5]
    channels = TIME.replace('"t"', '"time"') + 'q = { channel = "q", unit = "mm" }\nv1 = { channel = "v", unit = "V" }'
    columns = {"time": T, "q": Q, "time (2)": slow[0], "v": slow[1]}
    warnings, record = ingested(tmp_path, columns, channels)
    assert record["t"][np.argmax(record["v1"] > 1400.0)] - T[np.argmax(V > 1400.0)] == pytest.approx(0.012, abs=5e-3)
    assert [text for text in warnings if "a clock of its own" in text]


@pytest.mark.parametrize("beside", [{"fs": np.full(T.size, 1000.0)}, {"t": T}, {"time": np.round(1e3 * T)}])
def test_columns_that_contradict_the_rate_of_the_settings(tmp_path, beside):
    """A rate in each row, or a clock that the settings do not name."""
    channels = 'q = { channel = "q", unit = "mm" }\nv1 = { channel = "v", unit = "V" }'
    (tmp_path / "a").mkdir()
    refused, _ = ingested(tmp_path / "a", {"q": Q, "v": V} | beside, channels, "[ingest]\nsample_rate = 2500\n")
    assert "[ingest] sample_rate is 2500 Hz" in refused
    (tmp_path / "b").mkdir()
    assert ingested(tmp_path / "b", {"q": Q, "v": V} | beside, channels, "[ingest]\nsample_rate = 1000\n")[0] == []
