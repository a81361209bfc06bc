"""Compressed logs, NumPy's arrays, TDMS and workbooks; and what is said where a library is not installed."""

import bz2
import gzip
import lzma
import sys
import warnings
import zipfile

import h5py
import numpy as np
import pandas as pd
import pytest

from pipeline.errors import InputError
from pipeline.rig_logs import read_recording
from pipeline.rig_logs.inspection import inspect_log
from pipeline.rig_logs.mat_source import table_channels
from pipeline.rig_logs.source import CsvOptions, Limits, UnreadableLogError
from pipeline.signals.rounded_clock import uniform_clock
from tests.rig_logs.small_logs import TIME, Q, V, load, open_here, read_here, workbook


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
        matio = pytest.importorskip("matio", reason="mat-io has no wheel for Linux aarch64")

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


def test_without_mat_io_a_table_of_matlab_is_refused_with_the_way_out(tmp_path, monkeypatch):
    _tables(tmp_path / "log.mat", "v7")
    monkeypatch.setitem(sys.modules, "matio", None)
    with pytest.raises(UnreadableLogError, match=r"mat-io cannot read (?s:.*): save its columns as arrays"):
        table_channels(tmp_path / "log.mat", "T", "table")


@pytest.mark.parametrize("name", ["log.xlsx", "log.xls", "log", "log.csv"])
def test_a_workbook_is_known_by_its_content_and_its_hidden_sheets_are_not_read(tmp_path, name):
    rows = [["t [s]", "q [mm]"], *np.stack([TIME, Q], axis=1).tolist()]
    workbook(tmp_path / name, rows, hidden=[*rows, *rows[1:]])
    source = open_here(tmp_path / name)
    np.testing.assert_array_equal(load(source, "q"), Q)
    assert source.warnings == ["of the sheets 'Log' is read, 'Old' not"]


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
        (np.array([0, 50, 1, 0, 2], "<i4").tobytes() + b"q\0", "version 4; load it in MATLAB .* `save NAME.mat -v7`"),
        (np.array([1000, 1, 50, 0, 2], ">i4").tobytes() + b"q\0", "version 4; load it in MATLAB"),
    ],
)
def test_a_format_that_is_not_read_is_named(tmp_path, start, word):
    (tmp_path / "log").write_bytes(start + bytes(range(256)))
    with pytest.raises(UnreadableLogError, match=word):
        open_here(tmp_path / "log")


WAVEFORM = {"wf_increment": 0.001, "wf_start_time": np.datetime64("2024-05-12T10:00:00")}
LATER = {"wf_start_time": np.datetime64("2024-05-12T10:00:40")}
GOES_ON = {"wf_start_time": np.datetime64("2024-05-12T10:00:00.2")}


def _tdms(path, *segments, time=False):
    """Segments of 200 samples of q, each with properties of its own; where wanted, with a channel of times."""
    import nptdms

    with nptdms.TdmsWriter(path) as writer:
        for k, own in enumerate(segments):
            rows = slice(200 * k, 200 * (k + 1))
            channels = [nptdms.ChannelObject("rig", "q", Q[rows], own)]
            channels += [nptdms.ChannelObject("rig", "time", TIME[rows], {})] if time else []
            writer.write_segment(channels)


@pytest.mark.parametrize(
    ("second", "begins"), [(WAVEFORM, 0.2), (WAVEFORM | LATER, 40.0), (WAVEFORM | GOES_ON, 0.2), ({}, 0.2)]
)
def test_what_was_appended_to_tdms_begins_when_it_was_recorded(tmp_path, second, begins):
    _tdms(tmp_path / "log.tdms", WAVEFORM, second)
    recording = read_recording(tmp_path / "log.tdms")
    expected = np.concatenate([TIME[:200], begins + TIME[:200]])
    np.testing.assert_allclose(recording.channel("q").time, expected, atol=1e-9)
    assert ("'q' begins anew at 40 s" in " ".join(recording.warnings)) == (begins == 40.0)


def test_a_step_of_tdms_that_changes_is_refused(tmp_path):
    _tdms(tmp_path / "log.tdms", WAVEFORM, WAVEFORM | LATER | {"wf_increment": 0.002})
    with pytest.raises(UnreadableLogError, match=r"wf_increment of 'q' changes from 0\.001 to 0\.002"):
        open_here(tmp_path / "log.tdms")


def test_the_default_step_of_labview_is_no_clock_beside_a_channel_of_times(tmp_path):
    _tdms(tmp_path / "log.tdms", {"wf_increment": 1.0}, {}, time=True)
    source = open_here(tmp_path / "log.tdms")
    assert {entry.name: entry.time for entry in source.entries()} == {"q": None, "time": None}
    assert "wf_increment = 1 of 'q' is LabVIEW's default beside 'time'" in source.notes[0]


@pytest.mark.parametrize("left", [1, 20, 60])
def test_a_tdms_file_cut_within_the_head_of_a_segment_is_truncated(tmp_path, left):
    _tdms(tmp_path / "one.tdms", WAVEFORM)
    _tdms(path := tmp_path / "log.tdms", WAVEFORM, WAVEFORM | LATER)
    path.write_bytes(path.read_bytes()[: (tmp_path / "one.tdms").stat().st_size + left])
    with pytest.raises(UnreadableLogError, match="truncated"):
        open_here(path)


def test_an_index_beside_a_tdms_file_is_not_read(tmp_path):
    _tdms(tmp_path / "log.tdms", WAVEFORM)
    (tmp_path / "log.tdms_index").write_bytes(b"TDSh" + bytes(100))
    np.testing.assert_array_equal(read_here(tmp_path / "log.tdms")["q"], Q[:200])


HEADING = ["t", "q", ""]


def _sheets(path, times=TIME, form="0.0", cut=150, second=(HEADING,)):
    rows = [[t, q, ""] for t, q in np.stack([times, Q], axis=1).tolist()]
    sheets = {"Data": [HEADING, *rows[:cut]]} | ({"Data (2)": [*second, *rows[cut:]]} if cut < len(rows) else {})
    workbook(path, sheets, form=form)


@pytest.mark.parametrize("cut", [10, 150, 390])
@pytest.mark.parametrize("second", [(), (HEADING,)])
def test_a_table_that_may_go_on_in_another_sheet_is_refused(tmp_path, cut, second):
    _sheets(tmp_path / "log.xlsx", cut=cut, second=second)
    with pytest.raises(UnreadableLogError, match=r"the sheets .Data., .Data \(2\). hold tables of one heading"):
        open_here(tmp_path / "log.xlsx")


def test_sheets_that_are_not_read_are_named(tmp_path):
    _sheets(tmp_path / "log.xlsx", second=([HEADING[0], "q [µm]", *HEADING[2:]],))
    assert open_here(tmp_path / "log.xlsx").warnings == ["of the sheets 'Data (2)' is read, 'Data' not"]


@pytest.mark.parametrize(
    ("form", "begin"),
    [("dd.mm.yyyy hh:mm:ss.000", 46_000.999999), ("hh:mm:ss.000", 0.999999), ("[h]:mm:ss.000", 0.0), ("mm:ss.0", 0.9)],
)
def test_times_of_a_workbook_keep_all_their_digits_also_past_midnight(tmp_path, form, begin):
    times = np.arange(400) / 30_000.0
    for days in (begin + times / 86_400.0, (begin + times / 86_400.0) % 1.0):
        _sheets(tmp_path / "log.xlsx", days, form, cut=400)
        source = open_here(tmp_path / "log.xlsx")
        assert source.entries()[0].unit == "s"
        np.testing.assert_allclose(load(source, "t"), times, atol=1e-6)
        if begin > 1.0:
            break


@pytest.mark.parametrize(("form", "begin"), [("hh:mm:ss.000", 0.4), ("dd.mm.yyyy hh:mm:ss.000", 46_000.4)])
def test_the_digits_of_a_date_are_a_remark_and_its_clock_is_uniform(tmp_path, form, begin):
    """At 300 Hz they are nanoseconds of a time of day, and 0.6 µs of a date."""
    times = np.arange(400) / 300.0
    _sheets(tmp_path / "log.xlsx", begin + times / 86_400.0, form, cut=400)
    remarks = [note for note in inspect_log(tmp_path / "log.xlsx").notes if "rounded" in note]
    clock = uniform_clock(load(open_here(tmp_path / "log.xlsx"), "t"))
    assert clock is not None and np.ptp(clock.time - times) < 1e-7
    assert remarks == [f"time stamps are {clock.described}"]
    assert "rounded to 1.00 ms" in uniform_clock(np.round(times, 3)).described


def test_formulas_without_results_are_no_samples(tmp_path):
    rows = [["t", "q", "v"], *([t, q, "=2*A2"] for t, q in zip(TIME.tolist(), Q.tolist(), strict=True))]
    workbook(tmp_path / "log.xlsx", {"Data": rows})
    with pytest.raises(UnreadableLogError, match="formulas without stored results: open it in a spreadsheet program"):
        open_here(tmp_path / "log.xlsx")


@pytest.mark.parametrize("swmr", [False, True])
def test_an_hdf5_file_that_its_recorder_holds_is_refused(tmp_path, swmr):
    with h5py.File(tmp_path / "log.h5", "w", libver="latest") as file:
        file.create_dataset("q", data=Q, chunks=True)
        if swmr:
            file.swmr_mode = True
        file.flush()
        with pytest.raises(InputError, match="its recorder still writes it, or died while it did"):
            read_recording(tmp_path / "log.h5")
