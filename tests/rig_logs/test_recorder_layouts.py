"""Tables as instruments write them, each with the values that went in: LabVIEW, oscilloscopes, local dates."""

from datetime import datetime, timedelta
from pathlib import Path

import numpy as np
import pytest

from pipeline.rig_logs import read_recording

T = np.arange(400) / 100.0
Q, V = np.round(np.sin(5.0 * T), 5), np.where(T % 1.0 < 0.5, 3.0, 0.0)

LABVIEW = """\
LabVIEW Measurement\t
Writer_Version\t2
Separator\tTab
Decimal_Separator\t.
X_Columns\tOne
Date\t2024/03/05
Time\t14:21:33.1234567
***End_of_Header***\t
\t
Channels\t2\t\t
Samples\t400\t400\t
Date\t2024/03/05\t2024/03/05\t
Time\t14:21:33.12\t14:21:33.12\t
Y_Unit_Label\tmm\tkV\t
X_Dimension\tTime\tTime\t
X0\t0.0\t0.0\t
Delta_X\t0.01\t0.01\t
***End_of_Header***\t\t\t
X_Value\tLaser\tHV1\tComment
"""
TEKTRONIX = """\
Model,MDO3024
Firmware Version,1.26

Waveform Type,ANALOG,ANALOG
Point Format,Y,Y
Horizontal Units,s,s
Horizontal Scale,0.4,0.4
Sample Interval,0.01,0.01
Record Length,400,400
Vertical Units,V,V
Label,,
TIME,CH1,CH2
"""


def _table(head: str, cells: str, decimal: str = ".") -> str:
    rows = (cells.format(t=t, q=q, v=v, i=i) for i, (t, q, v) in enumerate(zip(T, Q, V, strict=True)))
    return head + "".join(row.replace(".", decimal) + "\n" for row in rows)


FILES = {
    "log.lvm": (_table(LABVIEW, "{t:.6f}\t{q:.6f}\t{v:.6f}\t"), ["X_Value", "Laser", "HV1"]),
    "tektronix.csv": (_table(TEKTRONIX, "{t:.6e},{q:.5f},{v:.4f}"), ["TIME", "CH1", "CH2"]),
    "quoted.csv": (_table("t,q,v\n", '"{t:.3f}","{q:.5f}","{v:.4f}"', ","), ["t", "q", "v"]),
    "trailing.csv": (_table("t;q;v\n", "{t:.3f};{q:.5f};{v:.4f};;"), ["t", "q", "v"]),
}


@pytest.mark.parametrize("name", FILES)
def test_the_numbers_of_an_instrument_are_read(tmp_path: Path, name: str) -> None:
    text, names = FILES[name]
    (tmp_path / name).write_text(text, encoding="utf-8")
    read = read_recording(tmp_path / name)
    assert [channel.name for channel in read.channels] == names
    for channel, expected in zip(read.channels, (T, Q, V), strict=True):
        np.testing.assert_allclose(channel.samples, expected, atol=1e-9)
    if name == "log.lvm":
        assert [channel.unit for channel in read.channels] == ["", "mm", "kV"]
    if name == "tektronix.csv":
        assert [channel.unit for channel in read.channels] == ["s", "V", "V"]


def test_a_labview_file_without_time_states_its_rate(tmp_path: Path) -> None:
    head = LABVIEW.replace("X_Columns\tOne", "X_Columns\tNo").replace("Decimal_Separator\t.", "Decimal_Separator\t,")
    for number in ("33.1234567", "33.12", "0.0", "0.01"):
        head = head.replace(number, number.replace(".", ","))
    (tmp_path / "log.lvm").write_text(_table(head, "\t{q:.6f}\t{v:.6f}", ","), encoding="utf-8")
    read = read_recording(tmp_path / "log.lvm")
    assert [channel.name for channel in read.channels] == ["Laser", "HV1"]
    np.testing.assert_allclose(read.channels[0].samples, Q, atol=1e-9)
    assert read.rates == {"Delta_X": 100.0}


def test_oscilloscopes_that_count_samples_state_the_rate(tmp_path: Path) -> None:
    head = "X,CH1,CH2,Start,Increment,\nSequence,Volt,Volt,0.000000e+00,1.000000e-02,\n"
    (tmp_path / "rigol.csv").write_text(_table(head, "{i},{q:.5f},{v:.4f},,"), encoding="utf-8")
    read = read_recording(tmp_path / "rigol.csv")
    np.testing.assert_allclose(read.channels[1].samples, Q, atol=1e-9)
    assert read.rates == {"Increment": 100.0}


@pytest.mark.parametrize(
    "form",
    ["{d:%d.%m.%Y %H:%M:%S}", "{d:%m/%d/%Y %I:%M:%S}", "{d:%d}-Mar-{d:%Y %H:%M:%S}", "Mar {d:%d %Y %H:%M:%S}",
     "{d:%d}. März {d:%Y %H:%M:%S}", "{d:%d}-déc-{d:%Y %H:%M:%S}", "{d:%M:%S}"],
)  # fmt: skip
def test_local_dates_with_times_count_from_the_first_one(tmp_path: Path, form: str) -> None:
    begin, after = datetime(2024, 3, 5, 14, 59, 58), " PM" if "%I" in form else ""
    rows = [
        f"{form.format(d=begin + timedelta(seconds=float(t)))}.{round(1e3 * (t % 1.0)):03d}{after};{q};{v}\n"
        for t, q, v in zip(T, Q, V, strict=True)
    ]
    (tmp_path / "dated.csv").write_text("time;q;v\n" + "".join(rows), encoding="utf-8")
    read = read_recording(tmp_path / "dated.csv")
    assert read.channel("time").unit == "s"
    np.testing.assert_allclose(read.channel("time").samples, T, atol=1e-9)
