"""Names and units above a table of numbers: the rows that hold them, and units within names."""

import re
from collections import Counter
from collections.abc import Callable, Sequence

from ..units.units import PLAIN
from .attributes import OF_SAMPLING, number_with_unit, possible_rate, scales_among, stated_rate
from .csv_text import COMMENT, NUMBER, is_stamp, split_row
from .source import UnreadableLogError, unique_names

_UNIT_IN_NAME = re.compile(r"^(?P<name>.*\S)\s*[\[(（［](?P<unit>[^\[\]()（）［］]*)[\])）］]$")
_UNIT_BEHIND = re.compile(r"^(?P<name>.*\S)(?:\s+in\s+|\s+/\s*|,\s+|\s*(?=[<{]))[<{]?(?P<unit>[^\s<>{}]+)[>}]?$")
_BEHIND_STROKE = re.compile(r"^(?P<name>[^/]+)/(?P<unit>[^/]+)$")
_BEFORE_BRACKET = re.compile(r"\s+(?=[\[(])")
_BRACKETED = re.compile(r"[\[(][^\[\]()]*[\])]$")
_TIME = re.compile(r"(t|time|zeit|timestamp|x|x_value)\b", re.IGNORECASE)
_QUANTITY = re.compile(rf"{NUMBER.pattern.removesuffix('$')} ?[A-Za-zµμ%]{{0,3}}$")
_ROW_KEY = re.compile(r"(?i)(units?|names?|channels?|labels?|einheit(en)?)\s*[:=]\s*(?=\S)")
"""Mark before a row of units or names, as in ``#UNITS:s,V,V`` of Hantek."""
_RATE_IN_WORDS = re.compile(
    rf"(?i)(\w*(sampl|scan|rate\b|abtast|recorded|{OF_SAMPLING})[^\d]*|(?=[\d.,]+ ?s))"
    r"(?P<number>\d+([.,]\d+)?) ?(?P<unit>k?Hz|(s|sa|samples)(/| per )s(ec(ond)?)?|sps)\b"
)
"""A sample rate as in ``sampled at 500 Hz``."""
_ALONE = re.compile(r"(?i)\d+([.,]\d+)? ?k?Hz")
"""A frequency with nothing else in its line, as in ``# 500 Hz``."""
_KEY_END = re.compile(r"[:=;,\t]")
_APART = re.compile(r"\s{2,}|\t")
"""Gap between names of several words above columns between blanks."""
_SEPARATORS = re.compile(r"[,;|\t]|\s+")
_KNOWN = (
    "s sec second seconds ms us µs μs ns min h m mm cm um µm μm nm deg degree degrees ° rad mrad v volt volts kv mv a "
    "ampere ma n kn nm n·m mn·m % pct hz khz g kg pa kpa bar mbar k °c rpm 1 - sequence m/s mm/s deg/s rad/s m/s² "
    "m/s^2 milliseconds microseconds meter meters metre metres millimeters millimetres micrometers kilovolts millivolts"
)
_UNITS = frozenset(_KNOWN.split())
"""Spellings by which a row of units is known."""

Row = Sequence[str]
_DISPLAY = re.compile(r"(?i)(vertical|horizontal|probe|trigger|time|x)\b")
"""Label before a scale or an offset of an oscilloscope's display."""
_HORIZONTAL = "Horizontal Units"  # key of the unit of time in files of oscilloscopes
_UNITS_KEY = re.compile(r"(?i)(y_unit_label|(vertical |[vy]_?)units?)")
_NAMES_KEY = re.compile(r"(?i)((trace|channel|signal) ?)?names?")
_OF_CHANNELS = re.compile(
    r"(?i)name|((var(iable)?|signal|tag|channel|sensor|parameter|point|kanal|messstelle)[_ ]?(name|id)?)|topic"
)
_OF_VALUES = re.compile(r"(?i)((var|variable|tag|signal|point)[_ ]?)?(value|wert|messwert|reading)s?")


def bare_line(line: str) -> str:
    """A line without the mark of a comment before it, as gnuplot, numpy and MATLAB set before headings."""
    match = COMMENT.match(line)
    return line[match.end() :] if match else line


def cells_above(line: str, cells: Row, width: int) -> Row:
    """Cells of a line above rows of `width` cells, which often is separated otherwise than those."""
    if len(cells) == width:
        return [_ROW_KEY.sub("", cells[0]), *(cell.lstrip("#% ") or cell for cell in cells[1:])]
    bare = bare_line(line).strip()
    apart = [_APART.split(bare), [cell for cell in _SEPARATORS.split(_BEFORE_BRACKET.sub("", bare)) if cell]]
    return next((others for others in apart if len(others) == width), cells)


def heading_rows(
    above: Sequence[Row], comments: Sequence[bool], numeric: Sequence[bool]
) -> tuple[int | None, int | None]:
    """Indices of the rows above the data that hold the names and the units; None where there is none.

    Empty rows may stand between them and the data, and cells without content at the ends of either. The names are in
    the row that labels the most columns. Among several such rows those with a time come first, and the first of these
    is taken. The last one is taken among comments, and where two cells above units may be a key and its value. A row of
    one cell more than the data, as for comments, names the first of them; above units of two more.

    Parameters
    ----------
    above : sequence of rows
        All rows before the first row of data.
    comments : sequence of bool
        True for each row that is marked as a comment; the last of several comments is the heading.
    numeric : sequence of bool
        True for each column that holds numbers.
    """
    block: list[int] = []
    used = len(numeric) - [*numeric][::-1].index(True)
    for i in range(len(above) - 1, -1, -1):
        row = above[i][: max((j + 1 for j, cell in enumerate(above[i]) if cell), default=0)]
        if not block and row and row[0].startswith(";"):  # a comment below the names
            continue
        if not row and (not block or len(above[i]) < used):
            if block and not _holds_units(above[block[0]]):
                break
            continue
        beyond = 1 if not block else 2 if len(block) == 1 and _holds_units(above[block[0]]) else 0
        longer = len(numeric) < len(row) <= len(numeric) + beyond and all(row[:used])
        if not (used <= len(row) <= len(numeric) or len(above[i]) == len(numeric) or longer):
            break
        block.insert(0, i)
    if block and _TIME.match(above[block[-1]][0]) and not _holds_units(above[block[-1]]):
        lowest = block[-1]
        if _labels(above[lowest], numeric) == sum(numeric) and any(_holds_units(above[i]) for i in block[:-1]):
            units_above = all(cell.strip("[]() ").lower() in _UNITS for cell in above[lowest - 1] or ("",))
            return lowest, lowest - 1 if units_above else None  # or keys with values, as of oscilloscopes
    units = next((i for i in reversed(block[1:]) if _holds_units(above[i])), None)
    labels = {i: _labels(above[i], numeric) for i in block if units is None or i < units}
    names = [i for i in labels if labels[i] and labels[i] == max(labels.values())]
    if not names and units is not None:  # of numbers, as an oscilloscope numbers its channels
        numbered = all(cell.isdecimal() for cell in above[units - 1] if NUMBER.match(cell))
        return (units - 1, units) if numbered else (units, None)
    if not names:
        return None, None
    with_time = [i for i in names if any(map(_TIME.match, above[i]))]
    return (with_time or names)[-1 if comments[block[-1]] or (units is not None and used == 2) else 0], units


def _labels(row: Row, numeric: Sequence[bool]) -> int:
    """Number of numeric columns that a row labels, 0 where more of its cells are numbers."""
    cells = [cell for cell, wanted in zip(row, numeric, strict=False) if wanted and cell]
    numbers = sum(bool(_QUANTITY.match(cell.replace(",", "."))) or is_stamp(cell) for cell in cells)
    return len(cells) - numbers if 2 * numbers <= len(cells) else 0


def _holds_units(row: Row) -> bool:
    cells = [cell for cell in row if cell and cell.lower() not in ("unit", "no.") and not NUMBER.match(cell)]
    are_units = [bool(_BRACKETED.match(cell)) or cell.strip("[]() '").lower() in _UNITS for cell in cells]
    return 2 * sum(are_units) > len(cells) > 0


def stated_rates(lines: Sequence[str], delimiter: str) -> list[tuple[str, float, float]]:
    """Names and numbers, behind or below them, that state a sample rate in lines above the data, and it [Hz]."""
    rates = _numbers_called(stated_rate, lines, delimiter)
    for match in () if rates else filter(None, map(_RATE_IN_WORDS.search, lines)):
        rate = number_with_unit(f"{match['number']} {match['unit']}", "")
        rates[match[0]] = (match[0], rate, rate)
    return list(rates.values())


def stated_frequencies(lines: Sequence[str], delimiter: str) -> dict[str, float]:
    """Names and frequencies [Hz] in lines above the data that may be the sample rate: of `frequency`, or alone."""
    found = {name: rate for name, _, rate in _numbers_called(possible_rate, lines, delimiter).values()}
    alone = filter(None, (_ALONE.fullmatch(bare_line(line).strip(f" {delimiter}")) for line in lines))
    return found | {f"the line {match[0]!r}": number_with_unit(match[0], "") for match in alone}


def _numbers_called(
    rate_of: Callable[[str, float], float | None], lines: Sequence[str], delimiter: str
) -> dict[str, tuple[str, float, float]]:
    """Names, numbers and rates [Hz] of the keys whose rate a function knows."""
    rates: dict[str, tuple[str, float, float]] = {}
    rows = [split_row(bare_line(line), delimiter) for line in lines]
    over = {cell for row in rows if row and row[0] == "X_Dimension" for cell in row[1:] if cell}
    for i, row in enumerate(rows):
        if row and row[0] == "Delta_X" and over and "Time" not in over:  # LabVIEW's step of a frequency or a place
            continue
        for j, cell in enumerate(row):
            key, _, own = _KEY_END.sub(":", cell).partition(":")
            name, unit = _BRACKETED.sub("", key).strip(" #%"), "".join(_BRACKETED.findall(key)).strip("[]()")
            if rate_of(name, 1.0) is None or name in rates:
                continue
            whole = _KEY_END.split(bare_line(lines[i]), maxsplit=1)[-1] if j == 0 else own  # a comma may be decimal
            below = rows[i + 1][j : j + 1] if i + 1 < len(rows) else []
            numbers = [number_with_unit(text, unit) for text in (whole, own, *row[j + 1 :], *below)]
            numbers = numbers[:1] if numbers[0] else numbers
            stated = dict.fromkeys((number, rate) for number in numbers if (rate := rate_of(name, number)))
            for own_name, each in zip(unique_names([name] * len(stated)), stated, strict=True):
                rates[own_name] = (own_name, *each)
    return rates


def stated_scales(lines: Sequence[str], delimiter: str) -> list[str]:
    """Notes on numbers, behind names in lines above the data, that look like a calibration."""
    numbers = {}
    for row in (split_row(bare_line(line), delimiter) for line in lines):
        key, _, own = _KEY_END.sub(":", row[0] if row else "").partition(":")
        stated = [float(cell) for cell in (own.strip(), *row[1:]) if NUMBER.match(cell)]
        if stated and not _DISPLAY.match(key.strip(" #%")):
            numbers["_".join(key.strip(" #%").split())] = next((x for x in stated if x not in (0.0, 1.0)), stated[0])
    return scales_among(numbers)


def names_and_units(headings: Row, units_row: Row, width: int) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """Name and unit of each column; a unit in brackets behind a name is its unit where no row of units says it."""
    if not headings:
        return tuple(f"column {j + 1}" for j in range(width)), ("",) * width
    names = []
    units = []
    behind = [match["unit"] for match in map(_BEHIND_STROKE.match, headings) if match]
    by_strokes = len(behind) > 1 and all(unit in PLAIN or unit.lower() in _UNITS - {"v", "a", "k"} for unit in behind)
    matches = [_UNIT_IN_NAME.match(heading) or _unit_behind(heading, by_strokes) for heading in headings[:width]]
    bare = Counter(match["name"] if match else heading for match, heading in zip(matches, headings, strict=False))
    written = Counter(headings[:width])
    for j, (heading, match) in enumerate(zip(headings, matches, strict=False)):
        if match and bare[match["name"]] > written[heading] and match["unit"].lower() not in _UNITS - {"1"}:
            match = None  # as V(q) and V(v1), Y[0] and Y[1]: what distinguishes channels is no unit
        unit = units_row[j].strip("[]() '") if j < len(units_row) else ""
        names.append(match["name"] if match and not unit else heading or f"column {j + 1}")
        units.append(unit or (match["unit"].strip() if match else ""))
    return tuple(names), tuple(units)


def _unit_behind(heading: str, by_strokes: bool) -> re.Match[str] | None:
    """A name with its unit as in ``Weg in mm``, ``Weg / mm``, ``Weg, mm`` or ``Weg <mm>``; None for others.

    By strokes also as in ``Weg/mm``, where several headings are so, and no paths of channels.
    """
    match = _UNIT_BEHIND.match(heading) or (_BEHIND_STROKE.match(heading) if by_strokes else None)
    return match if match and match["unit"].lower() in _UNITS - {"1"} else None


def rows_by_key(above: list[Row]) -> tuple[int | None, int | None]:
    """The rows of names and of units that begin with an instrument's key, None where there are none.

    A Yokogawa recorder writes ``TraceName`` and ``VUnit`` before them, LabVIEW ``Y_Unit_Label``, a Tektronix
    oscilloscope ``Vertical Units``. In place of the key stands the unit of the time then, if any.
    """
    keys = {cells[0]: i for i, cells in reversed([*enumerate(above)]) if cells}
    names, units = (next((keys[key] for key in keys if of.fullmatch(key)), None) for of in (_NAMES_KEY, _UNITS_KEY))
    if units is not None:
        time = above[keys[_HORIZONTAL]] if _HORIZONTAL in keys else ()
        above[units] = [time[1] if len(time) > 1 else "", *above[units][1:]]
    return names, units


def check_long_table(header: Row, numeric: Sequence[bool], rows: Sequence[Row]) -> None:
    """Refuse a table of a row for each value, in which a column of texts names the channel.

    Raises
    ------
    UnreadableLogError
        It names several, so the column of values is no channel.
    """
    values = next((name for name in header if _OF_VALUES.fullmatch(name)), None)
    for j, name in enumerate(header):
        if values is not None and not numeric[j] and _OF_CHANNELS.fullmatch(name):
            channels = sorted({row[j] for row in rows if len(row) == len(header) and row[j]})
            if len(channels) > 1:
                raise UnreadableLogError(
                    f"column {name!r} names the channel of each row ({', '.join(channels[:3])}), so {values!r} holds "
                    "several: write one column for each (pandas.DataFrame.pivot, MATLAB's unstack)"
                )
