"""Times of day in a column of CSV, as seconds from the first one on; and when LabVIEW began each channel."""

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .csv_cells import NUMBER, clock_of

_HOUR = 3600.0
_DAY = 86_400.0


class Clock:
    """A column of times of day, or of minutes and seconds, read part by part.

    Parameters
    ----------
    first : str
        The first cell that is not empty.
    """

    def __init__(self, first: str) -> None:
        self._origin = np.nan
        self._last = 0.0
        self._form, match = clock_of(first) or ("", None)
        self._turn = _DAY if match and match["h"] else _HOUR
        begins = min((match.start(part) for part, text in match.groupdict().items() if text), default=0) if match else 0
        self.note = f"counts from {first}" + ("; its date is not used" if begins > 1 else "")

    def seconds(self, cells: Any) -> NDArray[Any]:
        """The seconds of a part of the column since its first cell, NaN where a cell is empty.

        Raises
        ------
        ValueError
            A cell is no time.
        """
        import pyarrow as pa
        import pyarrow.compute as pc

        from ..store.arrow_columns import doubles

        matched = pc.extract_regex(cells, self._form)
        if matched.null_count > cells.null_count:
            raise ValueError("a time cannot be read")
        parts = {each.name for each in matched.type}

        def part(name: str) -> Any:
            """The numbers of one part, 0 where it is not written."""
            if name not in parts:
                return 0.0
            text = pc.replace_substring_regex(pc.struct_field(matched, name), "[,: ]", ".")
            text = pc.replace_substring_regex(text, r"^(\d\d)(\d)", r"\1.\2")  # as in 20261127101500123
            return doubles(pc.if_else(pc.equal(text, ""), "0", text).cast(pa.float64()))

        hours = part("h")
        if "half" in parts:
            half = pc.struct_field(matched, "half")
            of_twelve, after_noon = (
                doubles(pc.match_substring_regex(half, form).cast(pa.float64())) for form in (".", "[Pp]")
            )
            hours = np.where(of_twelve > 0.0, hours % 12.0 + 12.0 * after_noon, hours)
        return self._onwards(3600.0 * hours + 60.0 * (part("m") + part("mm")) + part("s") + part("ss"))

    def _onwards(self, times: NDArray[Any]) -> NDArray[Any]:
        """Times within a day (or an hour) from the first one on: back by more than half of it is the next one."""
        filled = np.flatnonzero(np.isfinite(times))
        if not filled.size:
            return times
        self._origin = float(times[filled[0]]) if np.isnan(self._origin) else self._origin
        seconds = times - self._origin
        steps = np.diff(seconds[filled], prepend=self._last % self._turn)
        turns = np.floor(self._last / self._turn) + np.cumsum(steps < -self._turn / 2.0)
        seconds[filled] += self._turn * turns
        self._last = float(seconds[filled[-1]])
        return seconds


def labview_starts(above: Sequence[Sequence[str]], width: int) -> tuple[tuple[float, float], ...]:
    """X0 and Delta_X [s] of each column, in the rows above the data; () where all have one clock, or columns of time.

    Parameters
    ----------
    above : sequence of rows
        Their cells, the key first.
    width : int
        Number of columns.
    """
    keys = {row[0]: [cell.replace(",", ".") for cell in row[1:]] for row in above if row}
    if keys.get("X_Columns", ["Multi"])[0] == "Multi" or "Time" not in keys.get("X_Dimension", []):
        return ()
    pairs = [*zip(keys.get("X0", []), keys.get("Delta_X", []), strict=False)]
    clocks = [(float(start), float(step)) for start, step in pairs if NUMBER.match(start) and NUMBER.match(step)]
    alike = len(set(clocks)) < 2 or min(step for _, step in clocks) <= 0.0
    return () if alike else (clocks[0], *clocks, *clocks[-1:] * width)[:width]
