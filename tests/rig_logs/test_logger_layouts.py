"""What loggers add to a table: statistics, restarts, checksums, stamps, zeros. Samples are those that were written."""

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

from pipeline.rig_logs.source import UnreadableLogError
from tests.rig_logs.small_logs import load, open_here

N = 500
TIME = 0.002 * np.arange(N)
Q = np.round(9.0 * np.sin(7.0 * TIME), 4)
V = np.round(np.where(TIME < 0.5, 0.0, 3000.0) + 0.5 * np.cos(TIME), 2)
COLUMNS = {"t": ("s", TIME), "q": ("mm", Q), "v": ("V", V)}
LINES = [f"{t:.3f},{q:.4f},{v:.2f}\n" for t, q, v in zip(TIME, Q, V, strict=True)]
ROWS, HEAD = "".join(LINES), "t [s],q [mm],v [V]\n"
BOOT = (
    "ets Jul 29 2019 12:21:46\n\nrst:0x1 (POWERON_RESET),boot:0x13 (SPI_FAST_FLASH_BOOT)\n"
    "clk_drv:0x00,q_drv:0x00,d_drv:0x00\nmode:DIO, clock div:1\nentry 0x400806a8\n"
)
STATISTICS = "Min,-9.0,0.0\nMaximum:,9.0,3000.5\nMean,0.1,1500\n"


def _values(text, name="log.csv", folder=None):
    path = folder / name
    path.write_bytes(text if isinstance(text, bytes) else text.encode())
    source = open_here(path)
    units = {entry.name: entry.unit for entry in source.entries()}
    return {name: (unit, load(source, name)) for name, unit in units.items()}, source


@pytest.mark.parametrize(
    ("text", "left_out"),
    [
        (HEAD + ROWS + "\n" + STATISTICS, "Min,-9.0,0.0"), (HEAD + ROWS + "500 rows exported\n", "500 rows exported"),
        ("t,q,v\nMin,-9,0\nMax,9,3000\ns,mm,V\n" + ROWS, ""), (HEAD + "; recorded by hand\n" + ROWS, ""),
        (HEAD + "".join(LINES[:300]) + BOOT + HEAD + "".join(LINES[300:]), "ets Jul 29"),
        ("t,q,v\ns,mm,V\n" + "".join(LINES[:300]) + "t,q,v\ns,mm,V\n" + "".join(LINES[300:]), "s,mm,V"),
        ("t,q,v\n\ns,mm,V\n\n" + ROWS, ""), ("t/s,q/mm,v/V\n" + ROWS, ""), ("t,q,v\n's','mm','V'\n" + ROWS, ""),
        ("t [s] q [mm] v [V]\n" + ROWS.replace(",", " "), ""),
        ("\ufeff\ufeff" + HEAD + ROWS, ""), ("\0" * 512 + HEAD + ROWS, ""),
    ],
)  # fmt: skip
def test_lines_beside_the_samples_are_no_samples(tmp_path, text, left_out):
    read, source = _values(text, folder=tmp_path)
    for name, (unit, samples) in COLUMNS.items():
        assert read[name][0] == unit
        np.testing.assert_allclose(read[name][1], samples, atol=1e-9)
    source.parts(list(read))
    assert any(left_out in note for note in [*source.notes, *source.warnings])


@pytest.mark.parametrize("second", ["t,q,v\ns,mm,kV\n", "t [s],q [mm],v [kV]\n", "f,A,B\n", "t,v,q\n"])
def test_a_second_table_is_never_joined_to_the_first(tmp_path, second):
    (tmp_path / "log.csv").write_text("t,q,v\ns,mm,V\n" + ROWS + "\n" + second + ROWS)
    source = open_here(tmp_path / "log.csv")
    with pytest.raises(UnreadableLogError, match="begins another table"):
        load(source, "v")


@pytest.mark.parametrize("zeros", [1, 4096, 200_000])
def test_zeros_behind_the_text_are_left_out_with_a_note(tmp_path, zeros):
    read, source = _values(HEAD + ROWS + "\0" * zeros, folder=tmp_path)
    np.testing.assert_allclose(read["q"][1], Q, atol=1e-9)
    assert any(f"{zeros} zero bytes at the end are left out" in note for note in [*source.notes, *source.warnings])


@settings(max_examples=40, deadline=None)
@given(
    units=st.booleans(), end=st.sampled_from(["\n", "\r\n", "\r"]), bom=st.booleans(), comment=st.booleans(),
    delimiter=st.sampled_from([",", ";", "\t"]), comma=st.booleans(), quotes=st.booleans(),
    restart=st.none() | st.integers(10, N - 10), footer=st.sampled_from(["", STATISTICS, "\n\n", "# end\n"]),
    zeros=st.sampled_from([0, 7]),
)  # fmt: skip
def test_any_of_them_together(
    tmp_path_factory, units, end, bom, comment, delimiter, comma, quotes, restart, footer, zeros
):
    head = "t,q,v\ns,mm,V\n" if units else HEAD
    lines = [*LINES]
    if restart is not None:
        lines.insert(restart, head)
    text = ("# recorded by hand\n" if comment else "") + head + "".join(lines) + footer
    comma = comma and delimiter != ","
    text = text.replace(",", "\1").replace(".", ",") if comma else text.replace(",", "\1")
    if quotes:
        text = "\n".join(
            "\1".join(f'"{cell}"' for cell in line.split("\1")) if "\1" in line else line for line in text.split("\n")
        )
    content = (("\ufeff" if bom else "") + text.replace("\1", delimiter).replace("\n", end)).encode() + b"\0" * zeros
    read, _ = _values(content, folder=tmp_path_factory.mktemp("any"))
    for name, (unit, samples) in COLUMNS.items():
        assert read[name][0] == unit
        np.testing.assert_allclose(read[name][1], samples, atol=1e-9)


def test_the_configuration_of_a_comtrade_record_is_named(tmp_path):
    (tmp_path / "log.cfg").write_text("RIG,REC1,1999\n2,2A,0D\n1,q,,,mm,0.001,0,0,-32767,32767,1,1,P\n" + ROWS)
    with pytest.raises(UnreadableLogError, match="COMTRADE"):
        open_here(tmp_path / "log.cfg")
