"""Times of channels that begin one after another, by the start and the step that their log states for each."""

from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pipeline.rig_logs.source import Entry, Source


class StartTimes:
    """A log in which each channel has its time: start + k · step, in s."""

    def __init__(self, source: Source, starts: dict[str, tuple[float, float]]) -> None:
        self._source = source
        self.format, self.texts, self.notes = source.format, source.texts, source.notes
        self.one_pass = getattr(source, "one_pass", False)
        clocks: dict[tuple[float, float], str] = {}
        self._time = {name: clocks.setdefault(clock, f"time of {name}") for name, clock in starts.items()}
        self._clocks = {time: clock for clock, time in clocks.items()}
        self.notes.append(f"channels begin at {', '.join(f'{start:g}' for start, _ in clocks)} s: each has its own time")

    def entries(self) -> list[Entry]:
        """The times, and the channels; a column of time, which is that of the first channel only, is left out."""
        entries = [replace(each, time=self._time[each.name]) for each in self._source.entries() if each.name in self._time]
        return [*(Entry(time, "s", "float64", entries[0].count) for time in self._clocks), *entries]

    def parts(self, names: Sequence[str]) -> Iterator[tuple[str, NDArray[Any]]]:
        """Samples as the log gives them, and the times beside."""
        beside = {time: next(name for name in self._time if self._time[name] == time) for time in self._clocks}
        wanted = [beside.get(name, name) for name in names]
        rows = Counter[str]()
        for name, samples in self._source.parts(list(dict.fromkeys(wanted))):
            first, rows[name] = rows[name], rows[name] + samples.size
            if name in names:
                yield name, samples
            if beside.get(time := self._time[name]) == name and time in names:
                start, step = self._clocks[time]
                yield time, start + step * np.arange(first, rows[name])


def with_starts(source: Source) -> Source:
    """The log itself, or with a time for each channel where it states several starts."""
    starts = getattr(source, "starts", {})
    return StartTimes(source, starts) if starts else source
