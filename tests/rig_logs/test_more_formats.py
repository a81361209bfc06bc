"""Compressed logs, NumPy's arrays, TDMS and workbooks; and what is said where a library is not installed."""

import bz2
import gzip
import lzma
import warnings
import zipfile

import numpy as np
import pandas as pd
import pytest

from pipeline.errors import InputError
from pipeline.rig_logs import read_recording
from pipeline.rig_logs.source import CsvOptions, Limits, UnreadableLogError
from tests.rig_logs.small_logs import TIME, Q, V, load, open_here, workbook


def _csv():
    return "t [s],q [mm],v [V]\n" + "".join(f"{t:.3f},{q:.9f},{v}\n" for t, q, v in zip(TIME, Q, V, strict=True))


def _write(path, kind):
    if kind == "gz":
        path.write_bytes(gzip.compress(_csv().encode()))
    elif kind == "bz2":
        path.write_bytes(bz2.compress(_csv().encode()))
    elif kind == "xz":
        path.write_bytes(lzma.compress(_csv().encode()))
    elif kind == "zip":
        with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
            archive.writestr("folder/log.csv", _csv())
            archive.writestr("folder/.DS_Store", b"\0")
    elif kind == "npz":
        with path.open("wb") as file:
            np.savez_compressed(file, t=TIME, q=Q, v=V[:, None], fs=1000.0, objects=np.array([{}]))
    elif kind == "npy":
        np.save(path, np.rec.fromarrays([TIME, Q, V], names="t,q,v"))
    elif kind == "tdms":
        import nptdms

        properties = {"wf_increment": 0.001, "wf_start_offset": 0.0, "unit_string": "mm"}
        with nptdms.TdmsWriter(path) as writer:
            writer.write_segment(
                [nptdms.ChannelObject("rig", name, data, properties) for name, data in (("q", Q), ("v", V))]
            )
    else:
        workbook(path, [["Rig 7", "", ""], ["t [s]", "q [mm]", "v"], *np.stack([TIME, Q, V], axis=1).tolist()])


KINDS = ["gz", "bz2", "xz", "zip", "npz", "npy", "tdms", "xlsx"]


@pytest.mark.parametrize("kind", KINDS)
def test_the_samples_are_those_that_were_written(tmp_path, kind):
    path = tmp_path / f"log.{kind}"
    _write(path, kind)
    recording = read_recording(path)
    channels = {channel.name.removeprefix("array."): channel for channel in recording.channels}
    np.testing.assert_allclose(channels["q"].samples, Q, atol=1e-8)
    np.testing.assert_allclose(channels["v"].samples, V, atol=1e-8)
    times = channels["q"].time if kind == "tdms" else channels["t"].samples
    np.testing.assert_allclose(times, TIME, atol=1e-12)
    assert channels["q"].unit == ("" if kind.startswith("np") else "mm")
    if kind == "npz":
        assert recording.rates == {"fs": 1000.0} and "'objects' (Python objects)" in " ".join(recording.notes)


@pytest.mark.parametrize("kind", KINDS)
def test_a_truncated_file_is_refused_with_one_line(tmp_path, kind):
    path = tmp_path / f"log.{kind}"
    _write(path, kind)
    path.write_bytes(path.read_bytes()[: path.stat().st_size // 3])
    with pytest.raises(InputError, match=f"log.{kind}: "):
        read_recording(path)


def test_a_small_file_that_unpacks_to_much_is_refused(tmp_path):
    (tmp_path / "log.csv.gz").write_bytes(gzip.compress(b"0,0\n" * 500_000))
    with pytest.raises(UnreadableLogError, match="far more than it holds"):
        open_here(tmp_path / "log.csv.gz", limits=Limits(small_bytes=1 << 20))


def test_an_archive_of_several_files_is_no_log(tmp_path):
    with zipfile.ZipFile(tmp_path / "logs.zip", "w") as archive:
        archive.writestr("a.csv", _csv())
        archive.writestr("b.csv", _csv())
    with pytest.raises(UnreadableLogError, match="an archive of 2 files"):
        open_here(tmp_path / "logs.zip")


def _tables(path, version):
    """A table and two timetables of 30 kHz, as mat-io writes them: rows by a duration, and by dates."""
    columns = {"q": Q, "HV 1": V, "armed": V > 0.0, "note": ["a"] * len(Q), "pair": Q}
    step = pd.to_timedelta(np.round(np.arange(len(Q)) * 1e9 / 30_000.0), unit="ns")
    by_date = pd.DataFrame({"q": Q}, index=pd.Timestamp("2026-03-29 01:59:59.9") + step)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # mat-io sets an option of pandas that is deprecated
        import matio

        frames = {"T": pd.DataFrame(columns), "TT": pd.DataFrame({"q": Q, "v": V}, index=step), "D": by_date, "x": Q}
        frames["TT"].index.name = frames["D"].index.name = "Time"
        matio.save_to_mat(str(path), frames, version=version)


@pytest.mark.parametrize("version", ["v7", "v7.3"])
def test_tables_of_matlab_are_read_with_the_times_of_their_rows(tmp_path, version):
    _tables(tmp_path / "log.mat", version)
    recording = read_recording(tmp_path / "log.mat")
    channels = {channel.name: channel for channel in recording.channels}
    np.testing.assert_array_equal(channels["T.q"].samples, Q)
    np.testing.assert_array_equal(channels["T.HV 1"].samples, V)
    np.testing.assert_array_equal(channels["T.armed"].samples, V > 0.0)
    for name, rounding in (("TT", 1e-9), ("D", 5e-7)):  # mat-io writes dates as doubles, in ms since 1970
        np.testing.assert_array_equal(channels[f"{name}.q"].samples, Q)
        np.testing.assert_allclose(channels[f"{name}.q"].time, np.arange(len(Q)) / 30_000.0, atol=rounding)
    assert channels["T.q"].time is None and channels["TT.Time"].unit == "s" and "x" in channels
    assert "T.note" not in channels and "'T.note' (text)" in " ".join(recording.notes)


def test_a_matrix_and_large_counts_of_numpy(tmp_path):
    ticks = 1_700_000_000_123_456_789 + np.arange(400) * 1_000_001
    np.savez(tmp_path / "log.npz", m=np.stack([Q, V], axis=1), ticks=ticks, z=Q * 1j)
    source = open_here(tmp_path / "log.npz")
    np.testing.assert_array_equal(load(source, "m[:,1]"), V)
    np.testing.assert_array_equal(load(source, "ticks"), np.arange(400) * 1_000_001)
    assert "complex" in source.texts["z"]


@pytest.mark.parametrize("name", ["log.xlsx", "log.xls", "log", "log.csv"])
def test_a_workbook_is_known_by_its_content_and_its_hidden_sheets_are_not_read(tmp_path, name):
    rows = [["t [s]", "q [mm]"], *np.stack([TIME, Q], axis=1).tolist()]
    workbook(tmp_path / name, rows, hidden=[*rows, *rows[1:]])
    source = open_here(tmp_path / name)
    np.testing.assert_array_equal(load(source, "q"), Q)
    assert "2 sheets" in source.notes[0] and "'Log'" in source.notes[0]


def test_numbers_that_a_workbook_holds_as_text_need_their_decimal_mark(tmp_path):
    texts = [[t, f"{q:.4f}".replace(".", ",")] for t, q in zip(TIME.tolist(), Q, strict=True)]
    workbook(tmp_path / "log.xlsx", [["t [s]", "q [mm]"], *texts])
    read = open_here(tmp_path / "log.xlsx", CsvOptions(decimal=","))
    np.testing.assert_allclose(load(read, "q"), Q, atol=1e-4)
    np.testing.assert_array_equal(load(read, "t"), TIME)


@pytest.mark.parametrize(
    ("properties", "time"),
    [
        ({"wf_increment": 1.0, "wf_xunit_string": "ms"}, TIME),
        ({"wf_increment": 0.001, "wf_start_offset": 0.5}, TIME + 0.5),
        ({"wf_increment": 0.001, "wf_start_time": np.datetime64("2024-05-12T10:00:00.25")}, TIME + 0.25),
        ({"wf_increment": 0.001, "wf_xunit_string": "Hz", "wf_xname": "Frequency"}, None),
    ],
)
def test_the_time_of_waveforms_of_tdms(tmp_path, properties, time):
    import nptdms

    first = {"wf_increment": 0.001, "wf_start_time": np.datetime64("2024-05-12T10:00:00")}
    with nptdms.TdmsWriter(tmp_path / "log.tdms") as writer:
        named = (("v", V, first), ("q", Q, properties))
        writer.write_segment([nptdms.ChannelObject("rig", name, data, of) for name, data, of in named])
    recording = read_recording(tmp_path / "log.tdms")
    q = recording.channel("q").time
    assert (q is None and "over Frequency in Hz" in recording.notes[0]) if time is None else np.allclose(q, time)


def test_what_tdms_states_beside_the_numbers_is_noted_or_the_channel_left_out(tmp_path):
    import nptdms

    raw = {"NI_Scale[0]_Scale_Type": "Foo", "NI_Number_Of_Scales": 1}
    with nptdms.TdmsWriter(tmp_path / "log.tdms") as writer:
        named = (("q", Q, {"gain": 0.5}), ("v", V, {"fs": "1 kHz"}), ("raw", np.arange(Q.size), raw))
        writer.write_segment([nptdms.ChannelObject("rig", name, data, of) for name, data, of in named])
    recording = read_recording(tmp_path / "log.tdms")
    assert recording.rates == {"v.fs": 1000.0} and recording.listed == ("q", "v")
    assert "'raw' (raw numbers with a scale that is not read, Foo" in recording.notes[0]
    assert any("gain = 0.5, not applied here to 'q'" in note for note in recording.notes)


@pytest.mark.parametrize(
    ("start", "word"),
    [
        (b"CDF\x01", "classic netCDF"),
        (b"ARROW1", "Parquet"),
        (b"\x89MCAP", "ROS"),
        (b"\x80\x04", "pickle"),
        (b"7z\xbc\xaf", "unpack it"),
        (b"RIFF", "WAVE"),
    ],
)
def test_a_format_that_is_not_read_is_named(tmp_path, start, word):
    (tmp_path / "log").write_bytes(start + bytes(range(256)))
    with pytest.raises(UnreadableLogError, match=word):
        open_here(tmp_path / "log")
