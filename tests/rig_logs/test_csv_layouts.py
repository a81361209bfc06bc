"""CSV layouts of oscilloscopes, LabVIEW and spreadsheets: names, units and samples are those that were written."""

import numpy as np
import pytest

from pipeline.rig_logs.source import CsvOptions, UnreadableLogError
from tests.rig_logs.small_logs import load, open_here, read_here

N = 700
TIME = 0.002 * np.arange(N)
Q = np.round(9.0 * np.sin(7.0 * TIME), 4)
V = np.where(TIME < 0.5, 0.0, 3000.0)
LVM = "LabVIEW Measurement\t\nX_Columns\tOne\n***End_of_Header***\t\n\t\nChannels\t2\t\t\nDelta_X\t0.002\t0.002\t\n"
LVM += "***End_of_Header***\t\t\t\nX_Value\tq\tv\tComment\n"


def _rows(form, *columns):
    return "".join(form.format(*row) + "\n" for row in zip(*columns, strict=True))


def _plain(delimiter=",", end=""):
    return _rows(delimiter.join(["{:.3f}", "{:.4f}", "{:.1f}"]) + end, TIME, Q, V)


LAYOUTS = {
    "rigol, one channel": (
        "X,CH1,Start,Increment,\nSequence,Volt,-6e-06,2e-03\n" + _rows("{},{:.4f},", range(N), Q),
        {"CH1": Q},
    ),
    "rigol, two channels": (
        "X,CH1,CH2,Start,Increment,\nSequence,VOLT,VOLT,-3e-03,2e-03\n" + _rows("{},{:.4f},{},,", range(N), Q, V),
        {"CH1": Q, "CH2": V},
    ),
    "tektronix, new": (
        "Model,MDO3014\n\nSample Interval,2e-03,,\nVertical Units,V,V\n,,\nLabel,,\nTIME,CH1,CH2\n" + _plain(),
        {"TIME": TIME, "CH1": Q, "CH2": V},
    ),
    "siglent": (
        "Record Length,Analog:700,\nSource,CH1\nSecond,Volt\n" + _rows("{:.3f},{:.4f}", TIME, Q),
        {"Source": TIME, "CH1": Q},
    ),
    "labview, a comment in every row": (LVM + _plain("\t", "\tok"), {"X_Value": TIME, "q": Q, "v": V}),
    "spreadsheet, a title above the names": (
        "Messung 17;;\nt;q;v\ns;mm;V\n" + _plain(";").replace(".", ","),
        {"t": TIME, "q": Q, "v": V},
    ),
    "spreadsheet, an empty row and a date": (
        "Rig A,,\n2024-04-23 12:00:00,,\nrate,500,\n,,\nt,q,v\n,,\n" + _plain(),
        {"t": TIME, "q": Q, "v": V},
    ),
    "quoted decimal commas": (
        '"t","q","v"\n' + _rows('"{:.3f}","{:.4f}","{:.1f}"', TIME, Q, V).replace(".", ","),
        {"t": TIME, "q": Q, "v": V},
    ),
    "a delimiter at the end of rows of data only": ("t,q,v\n" + _plain(end=","), {"t": TIME, "q": Q, "v": V}),
    "a switch": ("t,q,v\n" + _rows("{:.3f},{:.4f},{}", TIME, Q, V > 0), {"t": TIME, "q": Q, "v": V > 0}),
    "nanoseconds since 1970": (
        "t,q\n" + _rows("{},{:.4f}", 1_700_000_000_123_456_789 + np.arange(N) * 2_000_001, Q),
        {"t": 1_700_000_000_123_456_789 + np.arange(N) * 2_000_001.0, "q": Q},
    ),
    "minutes and seconds, past the hour": (
        "t,q\n" + _rows("{:02.0f}:{:06.3f},{:.4f}", np.where(TIME < 1.0, 59, 0), (59 + TIME) % 60, Q),
        {"t": TIME, "q": Q},
    ),
}


def test_a_channel_that_begins_behind_what_is_seen_at_first_is_named(tmp_path):
    late = _rows("{:.3f},{:.4f},{}", TIME, Q, ["" if i < 500 else "7.5" for i in range(N)])
    (tmp_path / "log.csv").write_text("t,q,v\n" + late)
    source = open_here(tmp_path / "log.csv")
    assert [entry.name for entry in source.entries()] == ["t", "q"] and "empty cells only" in source.texts["v"]


@pytest.mark.parametrize("name", LAYOUTS)
def test_names_and_samples_are_those_that_were_written(tmp_path, name):
    text, expected = LAYOUTS[name]
    path = tmp_path / "log.csv"
    path.write_bytes(text.encode())
    source = open_here(path)
    found = {entry.name: load(source, entry.name) for entry in source.entries()}
    assert set(expected) <= set(found)
    assert {"Start", "Increment", "Comment"}.isdisjoint(found)
    for channel, samples in expected.items():
        np.testing.assert_allclose(found[channel], samples, atol=1e-9)


@pytest.mark.parametrize("delimiter", [";", "\t", " "])
@pytest.mark.parametrize("decimal", [".", ","])
@pytest.mark.parametrize("idle", [390, 600])
def test_a_decimal_mark_behind_whole_numbers_is_seen_or_to_be_set(tmp_path, delimiter, decimal, idle):
    """The first 400 rows are looked at; a mark behind them might stand between thousands."""
    q = np.where(np.arange(N) < idle, 0.0, Q)
    rows = [
        f"{2 * i}{delimiter}{'0' if i < idle else f'{q[i]:.4f}'.replace('.', decimal)}{delimiter}{V[i]:.0f}"
        for i in range(N)
    ]
    path = tmp_path / "log.csv"
    path.write_text("\n".join([delimiter.join("tqv"), *rows]) + "\n")
    if idle < 400:
        np.testing.assert_allclose(read_here(path)["q"], q, atol=1e-9)
        return
    with pytest.raises(UnreadableLogError, match=r"set \[ingest.csv\] decimal"):
        read_here(path)
    np.testing.assert_allclose(read_here(path, CsvOptions(decimal=decimal))["q"], q, atol=1e-9)


@pytest.mark.parametrize(
    ("above", "rate"),
    [
        ("Sampling Rate: 2 kHz\n\nq,v", 2000.0),
        ("X,q,v,Start,Increment\nSequence,mm,V,0,5e-4", 2000.0),
        ("sampling period (ms): 0.5\n\nq,v", 2000.0),
        ("Sampling frequency [kHz];2\nq,v", 2000.0),
        ("Abtastintervall: 0,5 ms\nq,v", 2000.0),
        ("# sample rate: 2 kHz\nn,q,v", 2000.0),
        ("# sampled at 2 kHz\nq,v", 2000.0),
        ("# Rate 2000 S/s\nq,v", 2000.0),
        ("# 2000 samples per second\nq,v", 2000.0),
        ("# recorded at 2 kHz\nq,v", 2000.0),
        ("Messrate 2000 Hz\nq,v", 2000.0),
        ("data rate: 2000 SPS\nq,v", 2000.0),
        ("f_sample: 2000\nq,v", 2000.0),
    ],
)
def test_a_rate_above_the_data_is_told(tmp_path, above, rate):
    columns = (range(N), Q, V) if above.splitlines()[-1].count(",") > 1 else (Q, V)
    (tmp_path / "log.csv").write_text(above + "\n" + _rows(",".join(["{}"] * len(columns)), *columns))
    assert list(open_here(tmp_path / "log.csv").rates.values()) == pytest.approx([rate])


def test_a_labview_file_without_time_states_its_rate(tmp_path):
    head = LVM.replace("X_Columns\tOne", "X_Columns\tNo").replace("0.002", "0,002")
    (tmp_path / "log.lvm").write_text(head + _rows("\t{:.4f}\t{:.1f}\t", Q, V).replace(".", ","))
    source = open_here(tmp_path / "log.lvm")
    np.testing.assert_allclose(load(source, "q"), Q, atol=1e-9)
    assert source.rates == {"Delta_X": 500.0}


def test_rates_that_differ_are_all_told(tmp_path):
    (tmp_path / "log.lvm").write_text(LVM.replace("0.002\t0.002", "0.002\t0.004") + _plain("\t"))
    assert open_here(tmp_path / "log.lvm").rates == pytest.approx({"Delta_X": 500.0, "Delta_X (2)": 250.0})


@pytest.mark.parametrize("how", ["further header", "whole file behind another", "no header of the file"])
def test_a_second_segment_of_labview_is_refused(tmp_path, how):
    rows = _plain("\t").splitlines(True)
    again = LVM.partition("\n\t\n")[2]
    head = again if how.startswith("no") else LVM
    text = head + "".join(rows[:300]) + (LVM if how.startswith("whole") else again) + "".join(rows[300:])
    (tmp_path / "log.lvm").write_text(text)
    place = head.count("\n") + 300 + 1
    with pytest.raises(UnreadableLogError, match=rf"line {place} is the header of another segment .*: cut the file"):
        load(open_here(tmp_path / "log.lvm"), "q")


@pytest.mark.parametrize(
    ("stamp", "refused"), [("1970-01-01T00:00:05", ""), ("0001-01-01 00:00:00", "not set: delete")]
)
def test_a_clock_that_was_set_after_the_first_row(tmp_path, stamp, refused):
    rows = "".join(f"2024-04-23T12:00:{t:09.6f},{q}\n" for t, q in zip(TIME, Q, strict=True))
    (tmp_path / "log.csv").write_text(f"time,q\n2024-04-23T12:00:00,0\n{stamp},0\n" + rows)
    source = open_here(tmp_path / "log.csv")
    if refused:
        with pytest.raises(UnreadableLogError, match=f"row 3: '{stamp}' in column 'time' .* {refused}"):
            load(source, "time")
    else:
        np.testing.assert_allclose(load(source, "time")[2:], TIME, atol=1e-9)
        assert load(source, "time")[1] < -1e9


@pytest.mark.parametrize(
    ("above", "names", "units"),
    [
        ("time,V(q),V(v1)", ("time", "V(q)", "V(v1)"), ("", "", "")),
        ("t (s),q (mm),q (V)", ("t", "q", "q (2)"), ("s", "mm", "V")),
        ("time,laser,hv\nt,q,v", ("time", "laser", "hv"), ("", "", "")),
        (", A, B\nFrequency, 1.0Hz, 1Hz\nIndex, A (mV), B (mV)", ("Index", "A", "B"), ("", "mV", "mV")),
        ("s,mm,V\nt,q,v", ("t", "q", "v"), ("s", "mm", "V")),
        ("Number,Time,CH1\nNO.,ms,V", ("Number", "Time", "CH1"), ("NO.", "ms", "V")),
        ("Time(s),CH1V,CH2V,t0 =-1s, tInc =2e-3,", ("Time", "CH1V", "CH2V"), ("s", "", "")),
    ],
)
def test_what_stands_above_the_data_is_taken_for_names_and_units_only_where_it_can_be(tmp_path, above, names, units):
    (tmp_path / "log.csv").write_text(f"{above}\n{_plain()}")
    entries = open_here(tmp_path / "log.csv").entries()
    assert (tuple(each.name for each in entries), tuple(each.unit for each in entries)) == (names, units)


@pytest.mark.parametrize("name", ["Comment", "Bemerkung", ""])
@pytest.mark.parametrize("note", ["start", "17 V", "3", "27.11.2026 10:15:00"])
@pytest.mark.parametrize("units", ["", ",s,mm,V\n"])
def test_notes_before_the_first_samples_are_no_keys_of_a_preamble(tmp_path, name, note, units):
    rows = [f"{note if i in (0, 2) else ''},{row}" for i, row in enumerate(_plain().splitlines())]
    (tmp_path / "log.csv").write_text("\n".join([f"rig A\n{name},t,q,v\n{units}{rows[0]}", *rows[1:]]) + "\n")
    source = open_here(tmp_path / "log.csv")
    np.testing.assert_array_equal(load(source, "q"), Q)
    np.testing.assert_array_equal(load(source, "t"), np.round(TIME, 3))


@pytest.mark.parametrize("row", [3, 400])
def test_the_line_of_a_zero_byte_is_named(tmp_path, row):
    rows = ["t,q,v", *_plain().splitlines()]
    rows[row - 1] = "\0" + rows[row - 1]
    (tmp_path / "log.csv").write_text("\r\n".join(rows))
    with pytest.raises(UnreadableLogError, match=f"a zero byte in line {row}, .*repair or delete"):
        open_here(tmp_path / "log.csv")


@pytest.mark.parametrize(
    "cell",
    [
        "12/05/2024 01:02:{:06.3f} p.m.",
        "Sun May 12 13:02:{:06.3f} 2024",
        "2024/05/12 13:02:{:06.3f} +0200",
        "13:02:{:06.3f} CEST",
        "133:13:02:{:06.3f}",
        "202405121302{:06.3f}",
        "05.03.2024 14:59:{:06.3f}",
        "Mar 05 2024 14:59:{:06.3f}",
        "5. März 2024 14:59:{:06.3f}",
        "59:{:06.3f}",
    ],
)
def test_a_time_of_day_is_read_whatever_stands_around_it(tmp_path, cell):
    rows = "".join(f"{cell.format(t)},{q}\n" for t, q in zip(TIME, Q, strict=True))
    (tmp_path / "log.csv").write_text("time,q\n" + rows)
    np.testing.assert_allclose(load(open_here(tmp_path / "log.csv"), "time"), TIME, atol=1e-9)


def test_a_heading_longer_than_what_is_read_at_first(tmp_path):
    names = ["t", "q", *(f'"Model_Root_subsystem_{k:05d}_a_signal_name"' for k in range(3200))]
    (tmp_path / "log.csv").write_text(",".join(names) + "\n" + _rows("{:.3f},{:.4f}" + ",0" * 3200, TIME[:50], Q[:50]))
    np.testing.assert_allclose(load(open_here(tmp_path / "log.csv"), "q"), Q[:50])


def _table(row, head=""):
    return head + "".join(row(t, q, v) for t, q, v in zip(TIME, Q, V, strict=True))


@pytest.mark.parametrize(("name", "value"), [("VarName", "VarValue"), ("signal", "value"), ("topic", "Value")])
def test_a_row_for_each_value_is_refused_with_the_way_out(tmp_path, name, value):
    long = _table(lambda t, q, v: f"pos;{t:.3f};{q:.4f}\nhv;{t:.3f};{v:.1f}\n", f"{name};time;{value}\n")
    (tmp_path / "log.csv").write_text(long)
    with pytest.raises(UnreadableLogError, match=rf"'{name}' names the channel of each row \(hv, pos\).*pivot"):
        read_here(tmp_path / "log.csv")
    (tmp_path / "log.csv").write_text(long.replace("hv;", "pos;"))  # of one channel alone it can be read
    assert value in read_here(tmp_path / "log.csv")
