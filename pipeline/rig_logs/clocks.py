"""A time for each channel, where the log states when each begins and how it is sampled."""

import re
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .source import Entry, Source, View

_GROUP_OF = re.compile(r"[./][^./]*$")


class StartTimes(View):
    """A log in which each channel has its time: start + k · step, in s."""

    def __init__(self, source: Source, starts: dict[str, tuple[float, float]]) -> None:
        super().__init__(source)
        clocks: dict[tuple[float, float], str] = {}
        self._time = {name: clocks.setdefault(clock, f"time of {name}") for name, clock in starts.items()}
        self._clocks = {time: clock for clock, time in clocks.items()}
        begins = ", ".join(f"{start:g}" for start, _ in clocks)
        self.notes.append(f"channels begin at {begins} s, as the log states: each has its own time")

    def entries(self) -> list[Entry]:
        """The times, and the channels."""
        entries = [replace(each, time=self._time.get(each.name, each.time)) for each in self._log.entries()]
        counts = {each.time: each.count for each in entries}
        return [*(Entry(time, "s", "float64", counts[time]) for time in self._clocks), *entries]

    def parts(self, names: Sequence[str]) -> Iterator[tuple[str, NDArray[Any]]]:
        """Samples as the log gives them, and the times beside."""
        beside = {time: next(name for name in self._time if self._time[name] == time) for time in self._clocks}
        wanted = [beside.get(name, name) for name in names]
        rows = Counter[str]()
        for name, samples in self._log.parts(list(dict.fromkeys(wanted))):
            first, rows[name] = rows[name], rows[name] + samples.size
            if name in names:
                yield name, samples
            if beside.get(time := self._time.get(name, "")) == name and time in names:
                start, step = self._clocks[time]
                yield time, start + step * np.arange(first, rows[name])


def with_starts(source: Source) -> Source:
    """The log itself, or with a time for each channel where it states a rate and a start for each, and these differ."""
    starts = source.starts or _stated_beside(source)
    return StartTimes(source, starts) if len(set(starts.values())) > 1 else source


def _stated_beside(source: Source) -> dict[str, tuple[float, float]]:
    """Start and step [s] that numbers beside a channel or its group state: ``q.t0`` and ``q.dt`` those of ``q.Y``."""
    numbers = source.stated_starts
    starts = {_GROUP_OF.sub("", name): start for name, start in numbers.items()}
    rates = {_GROUP_OF.sub("", name): rate for name, rate in source.rates.items() if starts}
    clocks = {}
    for entry in source.entries() if starts else ():
        places = (entry.name, _GROUP_OF.sub("", entry.name))
        place = next((place for place in places if place in starts and place in rates), None)
        if place is not None and entry.time is None and entry.name not in numbers:
            clocks[entry.name] = (starts[place], 1.0 / rates[place])
    return clocks
