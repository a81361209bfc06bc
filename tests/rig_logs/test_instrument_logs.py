"""Files of instruments and programs: names, units and samples are those that were written, or the refusal says more."""

import json
import tarfile
import tomllib
from contextlib import suppress

import h5py
import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq
import pytest
from scipy.io import savemat

from pipeline.rig_logs import read_recording
from pipeline.rig_logs.draft import toml_draft
from pipeline.rig_logs.inspection import inspect_log
from pipeline.rig_logs.source import UnreadableLogError
from tests.rig_logs.small_logs import load, open_here

N = 700
TIME = 0.002 * np.arange(N)
Q = np.round(9.0 * np.sin(7.0 * TIME), 4)
V = np.round(np.where(TIME < 0.5, 0.0, 3000.0) + 0.5 * np.cos(TIME), 2)


def _rows(form, *columns):
    return "".join(form.format(*row) + "\n" for row in zip(*columns, strict=True))


ROWS = _rows("{:.3f},{:.4f},{:.2f}", TIME, Q, V)
YOKOGAWA = (
    '"Model","DL850E"\n"TraceName","CH1  ","CH2  "\n"BlockSize",700,700\n"VUnit","mm","V"\n"SampleRate",500.0,500.0\n'
    '"HResolution",2E-03,2E-03\n"Date","2026/11/27","2026/11/27"\n"HUnit","s","s"\n\n'
)
CATMAN = "HBM catman\nZeit\tWeg\tU_links\ns\tmm\tV\nDT=2.000 ms\tMX840A\tMX840A\n27.11.2026 10:11:12\t\t\n"
COMSOL = "% Model: joint.mph\n% Time (s)          Displacement, x (mm)   Voltage left (V)\n"
TWINCAT = "Name\tLaser\tName\tHV\nSampleTime[ms]\t2\tSampleTime[ms]\t2\nUnit\tmm\tUnit\tV\n\n"
LAYOUTS = {
    "yokogawa": (YOKOGAWA + _rows(",{:+.4E},{:+.6E}", Q, V), {"CH1": ("mm", Q), "CH2": ("V", V)}),
    "catman": (
        CATMAN + ROWS.replace(",", "\t").replace(".", ","),
        {"Zeit": ("s", TIME), "Weg": ("mm", Q), "U_links": ("V", V)},
    ),
    "comsol": (
        COMSOL + _rows("{:<20.3f}{:<23.4f}{:.2f}", TIME, Q, V),
        {"Time": ("s", TIME), "Displacement, x": ("mm", Q), "Voltage left": ("V", V)},
    ),
    "twincat": (
        TWINCAT + _rows("{:.0f}\t{:.4f}\t{:.0f}\t{:.2f}", 1e3 * TIME, Q, 1e3 * TIME, V),
        {"Laser": ("mm", Q), "HV": ("V", V)},
    ),
    "date and time between blanks": (
        "date time q v\n" + _rows("2026-11-27 10:11:{:06.3f} {:.4f} {:.2f}", 12 + TIME, Q, V),
        {"time": ("s", TIME), "q": ("", Q), "v": ("", V)},
    ),
    "units in words": (
        "Time,Displacement,Voltage\nmilliseconds,millimeters,kilovolts\n" + ROWS,
        {"Time": ("milliseconds", TIME), "Displacement": ("millimeters", Q), "Voltage": ("kilovolts", V)},
    ),
    "writetimetable of MATLAB": (
        "Time,q,v\n" + _rows("{:g} sec,{:.4f},{:.2f}", TIME, Q, V),
        {"Time": ("s", TIME), "q": ("", Q), "v": ("", V)},
    ),
}  # fmt: skip


NOT_READ = {
    "serial plotter": _rows("t:{:.3f}\tq:{:.4f}\tv1:{:.2f}", TIME, Q, V),
    "serial monitor with time stamps": _rows("10:11:{:06.3f} -> {:.4f},{:.2f}", 12 + TIME, Q, V),
    "minutes behind numbers": "t,q,v\n" + _rows("{:g} min,{:.4f},{:.2f}", TIME, Q, V),
    "units in every cell": "t,q,v\n" + _rows("{:g} s,{:.4f} mm,{:.2f} V", TIME, Q, V),
    "SI prefixes": "t,q,v\n" + _rows("{:.3f},{:.4f},{}", TIME, Q, ["2.8k" if v > 9 else "734.1m" for v in V]),
    "write.table of R": '"t" "q" "v"\n' + _rows('"{}" {:.3f} {:.4f} {:.2f}', range(1, N + 1), TIME, Q, V),
    "ruled table": "  t  |  q  |  v  \n-----+-----+-----\n" + ROWS.replace(",", " | ") + "(700 rows)\n",
    "two decimal marks": "t;q;v\n" + _rows("{:.3f};{};{:.2f}", TIME, [f"{q:.4f}".replace(".", ",") for q in Q], V),
    "checksums": _rows("$LOG,{:.3f},{:.4f},{:.2f}*5A", TIME, Q, V),
    "printed tuples": "t,q,v\n" + _rows("({:.3f}, {:.4f}, {:.2f})", TIME, Q, V),
    "comments behind": "t,q,v\n" + _rows("{:.3f},{:.4f},{:.2f} # by hand", TIME, Q, V),
    "accounts": "t,q,v\n" + _rows("{:.3f},{},{:.2f}", TIME, [f"({-q:.4f})" if q < 0 else f"{q:.4f}" for q in Q], V),
    "powers by D": "t,q,v\n" + _rows("{:.3f},{},{:.2f}", TIME, [f"{q:.4e}".replace("e", "D") for q in Q], V),
    "morning": "t,q,v\n" + _rows("2024/5/12 上午1:02:{:06.3f},{:.4f},{:.2f}", TIME, Q, V),
    "hours and minutes": "t,q,v\n" + _rows("23h59m{:06.3f}s,{:.4f},{:.2f}", TIME, Q, V),
    "points in times": "t,q,v\n" + _rows("13.02.{:06.3f},{:.4f},{:.2f}", TIME, Q, V),
}
"""Layouts that are refused, as a whole or in the columns that are written so."""


@pytest.mark.parametrize("name", NOT_READ)
def test_what_is_not_read_is_never_misread(tmp_path, name):
    (tmp_path / "log.csv").write_text(NOT_READ[name])
    read = {}
    with suppress(UnreadableLogError):
        source = open_here(tmp_path / "log.csv")
        read = {entry.name: load(source, entry.name) for entry in source.entries()}
        assert not set("tqv") <= read.keys()
    for channel, samples in read.items():
        columns = {"t": [TIME], "q": [Q], "v": [V]}.get(channel, [TIME, Q, V, np.arange(1, N + 1)])
        assert any(samples.size == N and np.allclose(samples, column, rtol=1e-3) for column in columns)


@pytest.mark.parametrize("name", LAYOUTS)
def test_names_units_and_samples(tmp_path, name):
    text, expected = LAYOUTS[name]
    path = tmp_path / "log.csv"
    path.write_text(text)
    source = open_here(path)
    units = {entry.name: entry.unit for entry in source.entries()}
    for channel, (unit, samples) in expected.items():
        assert units[channel] == unit
        np.testing.assert_allclose(load(source, channel), samples, atol=1e-9)


@pytest.mark.parametrize(
    ("encoding", "names"),
    [
        ("latin-1", "Zeit [s],Weg größer [mm],U° [V]"),
    ],
)
def test_names_in_the_encodings_of_other_scripts(tmp_path, encoding, names):
    path = tmp_path / "log.csv"
    path.write_bytes((names + "\n" + ROWS).encode(encoding))
    source = open_here(path)
    bare = [cell.replace("[", "(").split("(")[0].strip() for cell in names.split(",")]
    assert [entry.name for entry in source.entries()] == bare
    np.testing.assert_allclose(load(source, bare[1]), Q, atol=1e-9)


LVM = (
    "LabVIEW Measurement\t\nX_Columns\t{}\n***End_of_Header***\t\n\t\nChannels\t2\t\t\nX_Dimension\tTime\tTime\t\n"
    "X0\t0\t0.012\t\nDelta_X\t0.002\t0.002\t\n***End_of_Header***\t\t\t\nX_Value\tq\tv\tComment\n"
)


def _labview(path, columns):
    path.write_text(LVM.format(columns) + _rows("{}\t{:.4f}\t{:.2f}\t", TIME if columns == "One" else [""] * N, Q, V))


def _attributes(path, _):
    with h5py.File(path, "w") as file:
        for name, samples, start in (("q", Q, 0.0), ("v", V, 0.012)):
            file[name] = samples
            file[name].attrs.update(t0=start, dt=0.002)


def _struct(path, _):
    savemat(path, {name: {"t0": start, "dt": 0.002, "Y": y} for name, y, start in (("q", Q, 0.0), ("v", V, 0.012))})


@pytest.mark.parametrize(
    ("write", "how", "q", "v"),
    [
        (_labview, "One", "q", "v"), (_labview, "No", "q", "v"), (_attributes, "", "q", "v"),
        (_struct, "", "q.Y", "v.Y"),
    ],
)  # fmt: skip
def test_channels_begin_when_their_log_states(tmp_path, write, how, q, v):
    write(tmp_path / "log", how)
    recording = read_recording(tmp_path / "log", channels=[q, v])
    np.testing.assert_allclose(recording.channel(q).time, TIME)
    np.testing.assert_allclose(recording.channel(v).time, TIME + 0.012)
    np.testing.assert_allclose(recording.channel(v).samples, V)
    draft = toml_draft([inspect_log(tmp_path / "log")])
    assert "carries its own time base" in draft
    assert 'channel = "X_Value"' not in draft


@pytest.mark.parametrize("step", [1, 2])
@pytest.mark.parametrize("write", ["mat", "h5", "npz"])
def test_channels_of_several_clocks_are_drafted_with_their_own(tmp_path, write, step):
    """By their groups, in whatever order; else by the time before them. They may be as long as each other."""
    path, late, v = tmp_path / f"log.{write}", TIME[::step] + 0.012, V[::step]
    if write == "mat":
        savemat(path, {"laser": {"time": TIME, "q": Q}, "hv": {"time": late, "v1": v}})
        q, q_time, v1, v_time = "laser.q", "laser.time", "hv.v1", "hv.time"
    elif write == "h5":
        with h5py.File(path, "w") as file:
            file["laser/t"], file["laser/q"], file["hv/t"], file["hv/v1"] = TIME, Q, late, v
        q, q_time, v1, v_time = "laser/q", "laser/t", "hv/v1", "hv/t"
    else:
        np.savez(path, t1=TIME, q=Q, t2=late, v1=v)
        q, q_time, v1, v_time = "q", "t1", "v1", "t2"
    draft = tomllib.loads(toml_draft([inspect_log(path)]))["channels"]
    assert "time" not in draft
    assert (draft["q"]["channel"], draft["q"]["time"]["channel"]) == (q, q_time)
    assert (draft["v1"]["channel"], draft["v1"]["time"]["channel"]) == (v1, v_time)


def test_units_in_the_metadata_of_a_parquet_table(tmp_path):
    units = {"t": "ms", "q": "mm", "v": "kV"}
    table = pa.table({"t": TIME, "q": Q, "v": V})
    for metadata in ({"units": json.dumps(units)}, {"PANDAS_ATTRS": json.dumps({"units": units})}):
        pq.write_table(table.replace_schema_metadata(metadata), tmp_path / "log.parquet")
        assert {entry.name: entry.unit for entry in open_here(tmp_path / "log.parquet").entries()} == units


def test_columns_within_a_field_of_a_table_are_channels(tmp_path):
    """As pandas writes a DataFrame."""
    table = np.zeros(N, [("index", "f8"), ("values_block_0", "f8", (2,)), ("note", "S3", (2,))])
    table["index"], table["values_block_0"] = TIME, np.c_[Q, V]
    with h5py.File(tmp_path / "log.h5", "w") as file:
        file["log/table"] = table
    source = open_here(tmp_path / "log.h5")
    np.testing.assert_array_equal(load(source, "log/table.values_block_0[:,1]"), V)
    np.testing.assert_array_equal(load(source, "log/table.index"), TIME)
    assert list(source.texts) == ["log/table.note"]


@pytest.mark.parametrize(
    ("content", "message"),
    [
        ("# Created by Octave 8.4.0\n# name: data\n# type: matrix\n# rows: 700\n# columns: 3\n" + ROWS, "save -v7"),
        ("    -1\n    58\nq\nNONE\n" + ROWS.replace(",", " "), "universal file"),
        (json.dumps([[t, q] for t, q in zip(TIME, Q, strict=True)]), "JSON"),
    ],
)
def test_texts_that_are_no_tables_are_refused_by_name(tmp_path, content, message):
    (tmp_path / "log.txt").write_text(content)
    with pytest.raises(UnreadableLogError, match=message):
        open_here(tmp_path / "log.txt")


@pytest.mark.parametrize("mode", ["w", "w:gz"])
def test_a_tar_archive_is_to_be_unpacked(tmp_path, mode):
    (tmp_path / "log.csv").write_text("t,q,v\n" + ROWS)
    with tarfile.open(tmp_path / "log.tar", mode) as archive:
        archive.add(tmp_path / "log.csv", "log.csv")
    with pytest.raises(UnreadableLogError, match="archive; unpack it"):
        open_here(tmp_path / "log.tar")
