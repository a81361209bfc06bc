"""How a CSV file is written is found out, or said by the user, and never guessed over an error."""

import re

import numpy as np
import pytest
from hypothesis import HealthCheck, example, given, settings, strategies as st

from pipeline.errors import InputError
from pipeline.rig_logs import csv as csv_source, read_recording
from pipeline.rig_logs.csv import CsvSource
from pipeline.rig_logs.csv_dialect import find_dialect
from pipeline.rig_logs.source import CsvOptions, UnreadableLogError
from tests.rig_logs.small_logs import load, open_here, read_here


def _find(text, encoding="utf-8", **options):
    return find_dialect(text.encode(encoding), whole=True, options=CsvOptions(**options))


@pytest.mark.parametrize(
    ("encoding", "name"), [("cp850", "Hübe"), ("cp850", "Größe_ü"), ("cp1252", "„Höhe“"), ("latin-1", "Höhe")]
)
def test_names_in_western_encodings_are_read(tmp_path, encoding, name):
    rows = "".join(f"{i / 100},{i % 7},{i % 5}\n" for i in range(200))
    (tmp_path / "log.csv").write_bytes(f"t,{name},U\n{rows}".encode(encoding))
    assert name in read_here(tmp_path / "log.csv")


@pytest.mark.parametrize(
    ("encoding", "words"), [("utf-8", "not encoded as utf-8: "), (None, "not encoded as utf-8 throughout")]
)
def test_another_encoding_is_named_with_what_to_do(tmp_path, encoding, words):
    """At the beginning against the settings, and behind the sample."""
    rows = [f"{i / 100},{i % 7},{i % 5}\n" for i in range(40_000)]
    place = 0 if encoding else 30_000
    content = "".join([*rows[:place], "t,Höhe,U\n", *rows[place:]]).encode("latin-1")
    (tmp_path / "log.csv").write_bytes(content if encoding else b"t,q,U\n" + content)
    with pytest.raises(UnreadableLogError, match=rf"{words}.*set .*\[ingest\.csv\] encoding.* or save it as UTF-8"):
        read_here(tmp_path / "log.csv", CsvOptions(encoding=encoding))


@pytest.mark.parametrize("delimiter", [";", ",", "\t", "|", " "])
@pytest.mark.parametrize("decimal", [".", ","])
@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "latin-1", "utf-16"])
def test_all_combinations_are_found_and_read(tmp_path, delimiter, decimal, encoding):
    if decimal == "," and delimiter in ", ":
        pytest.skip("cannot be told apart")
    rows = [f"{i / 8:.3f}{delimiter}{-i * 1.5:.1f}{delimiter}{i}e-3".replace(".", decimal) for i in range(50)]
    heading = delimiter.join(["t_[s]", "Weg_[µm]", "n"])
    path = tmp_path / "log.csv"
    path.write_text("\n".join(["Prüfstand 3", heading, *rows]) + "\n", encoding=encoding)
    found = read_here(path)
    assert list(found) == ["t_", "Weg_", "n"]
    np.testing.assert_allclose(found["Weg_"], -1.5 * np.arange(50))
    np.testing.assert_allclose(found["n"], 1e-3 * np.arange(50))


NUMBERS = [-1250, 998, 12, 11043, 7, 2500, 431, -9923]
LARGE = [1250 + 7 * i for i in range(8)]
LEVELS = [1000 * (1 + i % 3) for i in range(8)]


@pytest.mark.parametrize("numbers", [NUMBERS, LARGE, LEVELS])
@pytest.mark.parametrize(("mark", "delimiter"), [(",", ";"), (",", "\t"), (",", ","), (".", ";"), (".", ",")])
def test_marks_between_thousands_are_not_taken_for_decimals(tmp_path, mark, delimiter, numbers):
    """Nothing shows what they are, until a cell in any column has other digits behind the mark."""
    if (mark, delimiter) == (".", ",") and numbers is not NUMBERS:  # that is how decimals are written there
        return
    cells = [f"{number:,}".replace(",", mark) for number in numbers]
    cells = [f'"{cell}"' for cell in cells] if mark == delimiter else cells
    rows = [("t", "q"), *((str(i), cell) for i, cell in enumerate(cells))]
    path = tmp_path / "log.csv"
    path.write_text("\n".join(map(delimiter.join, rows)) + "\n")
    first = f"'{f'{numbers[0]:,}'.replace(',', mark)}' in line 2, column 'q': does '{mark}' separate thousands"
    with pytest.raises(UnreadableLogError, match=re.escape(first)):
        read_here(path)
    decimals = [number / (1000 if abs(number) > 999 else 1) for number in numbers]
    np.testing.assert_allclose(read_here(path, CsvOptions(decimal=mark))["q"], decimals)
    path.write_text(
        path.read_text() + delimiter.join(("8", f'"0{mark}5"' if mark == delimiter else f"0{mark}5")) + "\n"
    )
    np.testing.assert_allclose(read_here(path)["q"], [*decimals, 0.5])


def test_a_time_with_a_point_shows_that_commas_stand_between_thousands(tmp_path):
    path = tmp_path / "log.csv"
    path.write_text("t;q;v\n" + "".join(f"{0.01 * i:.2f};{q:,};{i % 3}\n" for i, q in enumerate(LARGE)))
    assert read_here(path).keys() == {"t", "v"}
    with pytest.raises(InputError, match="'q' holds no plain numbers, but '1,250'; marks between thousands"):
        read_recording(path, channels=["q"])
    path.write_text("t;q;v\n" + "".join(f"{0.01 * i:.2f};{q:,};{i % 3}\n" for i, q in enumerate(range(900, 1100))))
    with pytest.raises(InputError, match="'1,000' in line 102; marks between thousands"):
        read_recording(path, channels=["q"])
    path.write_text("t,q,v\n" + "".join(f'{i},"{q:,}",{i % 3}\n' for i, q in enumerate(range(1040, 950, -1))))
    with pytest.raises(InputError, match="line 2: '1,040' has marks between thousands"):
        read_recording(path, channels=["q"])


def test_missing_values_are_numbers_that_are_not_there(tmp_path):
    path = tmp_path / "log.csv"
    path.write_text("t,q\n0,NaN\n1,\n2,nan\n3,inf\n4,-5\n5,#N/A\n6,7\n7,8\n")
    np.testing.assert_array_equal(read_here(path)["q"], [np.nan, np.nan, np.nan, np.inf, -5, np.nan, 7, 8])


@pytest.mark.parametrize("heading", ["t,q,v", "t [s],q [mm],v [kV]", "Prüfstand 3\nt,q,v\ns,mm,kV", "# t,q,v"])
@pytest.mark.parametrize("whole", [False, True])
def test_commas_that_separate_and_stand_before_decimals_are_refused(heading, whole):
    """Cut at each comma, decimals are columns of their own; a column of whole numbers has none."""
    rows = [f"{i if whole else i / 2000},{-8 + i / 640:.3f},{i % 7 / 64:.2f}".replace(".", ",") for i in range(400)]
    rows = [row.replace(",", ".").replace(".", ",") for row in rows if whole or row.count(",") == 5]
    with pytest.raises(UnreadableLogError, match=r"the comma separates cells and stands before decimals"):
        _find("\n".join([heading, *rows]) + "\n")


@pytest.mark.parametrize(
    "text",
    [
        "rig,2\n" + "".join(f"{i},{2 * i},{i % 9}\n" for i in range(50)),
        "t,q\n" + "".join(f"0{i % 9}.5,{i},{i % 9}\n" for i in range(50)),
        "t,q,n,m\n" + "".join(f"{i},{2 * i},007,{i % 9}\n" for i in range(50)),
    ],
)
def test_rows_of_whole_numbers_below_other_words_are_read(text):
    assert _find(text).delimiter == ","


def test_quoted_cells_protect_the_delimiter(tmp_path):
    path = tmp_path / "log.csv"
    path.write_text('"t","q [mm]","remark"\n"0","1.5","a, b"\n"1","2.5",""\n')
    np.testing.assert_array_equal(read_here(path)["q"], [1.5, 2.5])


@pytest.mark.parametrize(
    ("row", "complaint"), [("2,4x", "'4x'"), ("2", "has 1 cells, not 2"), ("2,3,4", "has 3 cells, not 2")]
)
@pytest.mark.parametrize("position", [0, 1, 30, 20_000])
def test_a_row_that_does_not_fit_is_an_error_wherever_it_stands(tmp_path, row, complaint, position):
    rows = [f"{i},{2 * i}" for i in range(20_100)]
    rows.insert(position + 1, row)
    path = tmp_path / "log.csv"
    path.write_text("t,q\n" + "\n".join(rows) + "\n")
    with pytest.raises(UnreadableLogError, match="does not fit the table") as error:
        read_here(path)
    assert f"row {position + 3}" in str(error.value)
    assert complaint in str(error.value)


def test_settings_win_over_what_is_found():
    text = "a;b\n1,5;2\n2,5;3\n"
    assert _find(text).decimal == ","
    assert _find(text, delimiter=";", decimal=",", header_row=0).header == ("a", "b")
    with pytest.raises(UnreadableLogError, match="no table of numbers"):
        _find(text, delimiter=";", decimal=".", header_row=0, encoding="ascii")
    with pytest.raises(UnreadableLogError, match="row 0 is no header"):
        _find("preamble\n" + text, header_row=0)


def test_a_cut_off_last_row(tmp_path):
    path = tmp_path / "log.csv"
    path.write_text("t,q\n0,10\n1,20\n2,30")
    np.testing.assert_array_equal(read_here(path)["q"], [10, 20])
    path.write_text("t,q\n0,10\n1,20\n2")
    with pytest.raises(UnreadableLogError, match=r"truncated: it ends within a row \(1 of 2 cells\)"):
        read_here(path)


def test_a_damaged_first_row_is_not_taken_for_units(tmp_path):
    path = tmp_path / "log.csv"
    path.write_text("t,q\n0,x5\n1,20\n2,30\n")
    with pytest.raises(UnreadableLogError, match=r"row 1 .* with the number '0' in it: repair or delete that row"):
        read_here(path)
    path.write_text("t,q\ns,1\n1,20\n2,30\n")  # a quantity without unit
    np.testing.assert_array_equal(read_here(path)["q"], [20, 30])


@pytest.mark.parametrize(
    ("encoding", "text"), [("utf-8", "Åben"), ("cp1252", "…x"), ("utf-8", "a\u2028b"), ("utf-8", "a\x0bb")]
)
def test_a_character_that_ends_a_line_elsewhere_stands_in_a_cell(tmp_path, encoding, text):
    rows = [f"{0.01 * i:.2f};{np.sin(i):.4f};{text}" for i in range(300)]
    (tmp_path / "log.csv").write_bytes("\n".join(["t [s];q [mm];remark", *rows]).encode(encoding))
    t = read_here(tmp_path / "log.csv")["t"]  # without its line end the last row may be cut off within its remark
    np.testing.assert_allclose(t, 0.01 * np.arange(299), atol=1e-12)


ROWS = [f"{i / 8:.3f},{-i * 1.5:.1f},{i}" for i in range(50)]


@pytest.mark.parametrize(
    ("above", "delimiter", "names", "units"),
    [
        ("# t q v", " ", ("t", "q", "v"), ("", "", "")),  # numpy.savetxt
        ("#t\tq\tv", "\t", ("t", "q", "v"), ("", "", "")),  # gnuplot
        ("# t q v", ",", ("t", "q", "v"), ("", "", "")),  # savetxt with another delimiter than its header
        ("% time [s] angle [deg] input [V]", " ", ("time", "angle", "input"), ("s", "deg", "V")),
        ("# written by me today\n# t q v\n# s mm V", " ", ("t", "q", "v"), ("s", "mm", "V")),
        ("Time,Channel A,Channel B\n(ms),(mV),(V)\n", ",", ("Time", "Channel A", "Channel B"), ("ms", "mV", "V")),
        ("Points,2\n\nFormat,Y,\nUnits,S,\n\nTIME,CH1,CH2", ",", ("TIME", "CH1", "CH2"), ("", "", "")),
        ("Clock,Position,Force\n,of cart,of motor\ns,mm,N", ",", ("Clock", "Position", "Force"), ("s", "mm", "N")),
        ("X_Value\tWeg\tKraft\tComment", "\t", ("X_Value", "Weg", "Kraft"), ("", "", "")),  # LabVIEW
        ("#Time,#CH1,#CH2\n#UNITS:s,V,mV", ",", ("Time", "CH1", "CH2"), ("s", "V", "mV")),  # Hantek
        ("t / s;Weg, mm;U <kV>", ";", ("t", "Weg", "U"), ("s", "mm", "kV")),
    ],
)
def test_headings_of_other_programs(above, delimiter, names, units):
    rows = [row.replace(",", delimiter) for row in ROWS]
    dialect = _find("\n".join([above, *rows]) + "\n")
    assert (dialect.header, dialect.units) == (names, units)


@pytest.mark.parametrize("mark", [".", ","])
def test_times_of_day_count_from_the_first_and_go_on_past_midnight(tmp_path, mark):
    path = tmp_path / "log.csv"
    rows = 40_000  # more than a block
    ticks = 86_400_000 - 25_000 + 5 * np.arange(rows)
    days, left = np.divmod(ticks, 86_400_000)
    parts = left // 3_600_000, left // 60_000 % 60, left // 1000 % 60, left % 1000
    cells = [f"{h:02d}:{m:02d}:{s:02d}{mark}{ms:03d}" for h, m, s, ms in zip(*parts, strict=True)]
    dates = np.where(days == 0, "31.12.2025", "01.01.2026")
    lines = [f"{date};{cell};{i % 7}{mark}5" for i, (date, cell) in enumerate(zip(dates, cells, strict=True))]
    path.write_text("Datum;Zeit;q\n" + "\n".join(lines) + "\n")
    source = CsvSource(path, CsvOptions())
    assert [(entry.name, entry.unit) for entry in source.entries()] == [("Zeit", "s"), ("q", "")]
    np.testing.assert_allclose(read_here(path)["Zeit"], 0.005 * np.arange(rows), atol=1e-9)


def test_a_damaged_time_of_day_is_named(tmp_path):
    path = tmp_path / "log.csv"
    path.write_text("t;q\n" + "".join(f"12:00:{i:02d};{i}\n" for i in range(60)) + "12:01:0x;60\n")
    with pytest.raises(UnreadableLogError, match="'12:01:0x'"):
        read_here(path)


def test_a_decimal_of_any_column_decides_for_all(tmp_path):
    """A pulse of 3.072 kV beside 0 could be of thousands, were it not for a time of 0.04 s."""
    path = tmp_path / "log.csv"
    path.write_text("t,v,q\n" + "".join(f"{0.04 * i:.2f},{'3.072' if i % 9 > 5 else '0'},{i % 7}\n" for i in range(60)))
    assert set(read_here(path)["v"]) == {0.0, 3.072}


@pytest.mark.parametrize("rows", [500, 30_000])
def test_marks_between_thousands_are_found_wherever_they_begin(tmp_path, rows):
    """The first rows are whole numbers below a thousand, and then 1,908 would be read as 1.908."""
    path = tmp_path / "log.csv"
    cells = [str(i % 900) if i < rows else f"{1900 + i % 50:,}" for i in range(rows + 100)]
    path.write_text("\n".join(["t;q", *(f"{i};{cell}" for i, cell in enumerate(cells))]) + "\n")
    with pytest.raises(UnreadableLogError, match=r"'1,9\d\d' in line \d+, column 'q': does ',' separate thousands"):
        read_here(path)
    assert read_here(path, CsvOptions(decimal=","))["q"][-1] == pytest.approx((1900 + (rows + 99) % 50) / 1000)


@pytest.mark.parametrize("row", [3, 8_000])
@pytest.mark.parametrize("word", ["OVER", "OL", "----", "--.--", "1.#INF00", "?", "No Signal", "#REF!", "\u221e"])
@pytest.mark.parametrize("delimiter", [";", " "])
def test_words_in_place_of_numbers_are_missing_values_and_named(tmp_path, word, row, delimiter):
    word = word.replace(" ", "_")
    rows = [f"{i}{delimiter}{2 * i}.5" for i in range(8_100)]
    rows[row] = rows[row + 5] = f"{row}{delimiter}{word}"
    path = tmp_path / "log.csv"
    path.write_text(f"t{delimiter}q\n" + "\n".join(rows) + "\n")
    source = open_here(path)
    q = load(source, "q")
    assert np.flatnonzero(~np.isfinite(q)).tolist() == [row, row + 5] and q[-1] == 16_198.5
    assert word.startswith("#") or f"{word!r} in 'q' (2 times, the first in line {row + 2})" in source.warnings[-1]


@pytest.mark.parametrize(
    "line", ["# pulse 7", "# pulse 7, early", "Event: the pulse", "t,q", "% a, b", "// x,,,", "End of data"]
)
@pytest.mark.parametrize(
    ("row", "end"),
    [(3, "\n"), (8_000, "\r\n"), (8_100, "")],
)
def test_lines_that_are_no_rows_of_numbers_are_left_out_and_named(tmp_path, line, row, end):
    rows = [f"{i},{2 * i}.5" for i in range(8_100)]
    rows.insert(row, line)
    path = tmp_path / "log.csv"
    path.write_bytes(((end or "\n").join(["t,q", *rows]) + end).encode())
    source = open_here(path)
    np.testing.assert_array_equal(load(source, "q"), 2.0 * np.arange(8_100) + 0.5)
    assert source.warnings[-1] == f"1 line left out: line {row + 2}: {line!r}"


@pytest.mark.parametrize("encoding", ["utf-16-le", "utf-16-be", "utf-16", "utf-8-sig"])
def test_text_of_two_bytes_may_lack_its_mark(tmp_path, encoding):
    path = tmp_path / "log.csv"
    path.write_text("t [s];Wärme [K]\n" + "".join(f"{i};{i},5\n" for i in range(9)), encoding=encoding)
    assert read_here(path)["Wärme"].tolist() == [i + 0.5 for i in range(9)]


_CELLS = st.sampled_from(["1", "-2.5", ".5", "5.", "-1E-3", "", "", "", "+3", "x", "1 000", "--5", "1.2.3"])


@settings(max_examples=150, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(
    delimiter=st.sampled_from([" ", "\t", ";", ","]),
    rows=st.lists(st.lists(_CELLS, min_size=2, max_size=5), min_size=1, max_size=3),
    space=st.sampled_from(["", " "]),
)
@example("\t", [["1", "", "2", "3"]], "")
@example("\t", [["", "1", "2", "3"]], "")
def test_rows_of_plain_numbers_are_read_as_all_rows_are(tmp_path, monkeypatch, delimiter, rows, space):
    """A comment has all rows looked at; those of plain numbers may pass without, and nothing else may."""
    plain = [f"{i / 8}{delimiter}{space}{i}.5{delimiter}{-i}" for i in range(30)]
    text = "\n".join([f"t{delimiter}q{delimiter}v", *plain, "# note", *map(delimiter.join, rows), *plain[:5]])
    (tmp_path / "log.csv").write_text(text + "\n")

    def outcome() -> object:
        try:
            source = open_here(tmp_path / "log.csv")
            return *(load(source, name).tolist() for name in ("t", "q", "v")), source.notes
        except UnreadableLogError as error:
            return str(error)

    quickly = outcome()
    with monkeypatch.context() as patched:
        patched.setattr(csv_source, "plain_row", lambda delimiter, width: re.compile("(?!)"))
        assert repr(quickly) == repr(outcome())
