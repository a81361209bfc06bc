"""Clocks that a log states otherwise than by one column of time, as channels of it.

Two columns make one clock: whole seconds, and the nano-, micro- or milliseconds since them. ROS writes ``stamp.sec``
and ``stamp.nanosec``; recorders write a time of day and ``ms`` behind it. And each channel has its own clock where the
log states a start and a step for each.
"""

import re
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..units.units import time_unit
from .source import Entry, Source, UnreadableChannelError, View, unique_names

_PARTS = {"n": 1e9, "nano": 1e9, "u": 1e6, "µ": 1e6, "micro": 1e6, "m": 1e3, "milli": 1e3}
_GROUP_OF = re.compile(r"[./][^./]*$")
_BEHIND = {"ms": 1e3, "us": 1e6, "ns": 1e9}
_NAME = re.compile(r"(?i)(?P<stem>.*?)(?P<part>nano|micro|milli|[nuµm])?(secs?|seconds?)")


class ClockPairs(View):
    """A log in which each such pair is one more channel, in s since its first whole second."""

    def __init__(self, source: Source, pairs: dict[str, tuple[Entry, Entry, float]]) -> None:
        super().__init__(source)
        self._pairs = pairs
        for name, (whole, part, _) in pairs.items():
            self.notes.append(f"{name!r} is made of {whole.name!r} and {part.name!r}, from the first whole second on")

    def entries(self) -> list[Entry]:
        """Those of the log, and the clocks."""
        clocks = [Entry(name, "s", "float64", whole.count) for name, (whole, _, _) in self._pairs.items()]
        return [*self._log.entries(), *clocks]

    def parts(self, names: Sequence[str]) -> Iterator[tuple[str, NDArray[Any]]]:
        """Samples as the log gives them, and each clock once both of its columns are read."""
        clocks = [name for name in names if name in self._pairs]
        of_clocks = [entry.name for name in clocks for entry in self._pairs[name][:2]]
        held: dict[str, list[NDArray[Any]]] = {name: [] for name in of_clocks}
        own = [name for name in names if name not in self._pairs]
        for name, samples in self._log.parts(list(dict.fromkeys([*own, *of_clocks]))):
            if name in held:
                held[name].append(np.array(samples, dtype=np.float64))
            if name in names:
                yield name, samples
        for name in clocks:
            whole, part, per_second = self._pairs[name]
            yield name, self._clock(np.concatenate(held[whole.name]), np.concatenate(held[part.name]), part, per_second)

    def _clock(
        self, seconds: NDArray[Any], fraction: NDArray[Any], part: Entry, per_second: float
    ) -> NDArray[np.float64]:
        if np.any((fraction < 0.0) | (fraction >= per_second)):
            raise UnreadableChannelError(f"{part.name!r} is not always less than a second, so it is no part of a clock")
        finite = seconds[np.isfinite(seconds)]
        if np.any(np.trunc(finite) != finite):
            raise UnreadableChannelError(f"{part.name!r} stands beside a time that is not in whole seconds")
        clock: NDArray[np.float64] = seconds - (finite[0] if finite.size else 0.0) + fraction / per_second
        return clock


def with_clocks(source: Source) -> Source:
    """The log itself, or with a clock for each pair of columns that are named as one is."""
    entries = source.entries()
    named = [(entry, match) for entry in entries if (match := _NAME.fullmatch(entry.name))]
    wholes = {match["stem"].casefold(): entry for entry, match in named if not match["part"]}
    made = []
    for entry, match in named:
        whole = wholes.get(match["stem"].casefold()) if match["part"] else None
        if whole is not None and whole.count == entry.count and whole.time == entry.time:
            made.append((f"{match['stem']}time", (whole, entry, _PARTS[match["part"].casefold()])))
    for whole, entry in pairwise(entries):
        if whole.name in source.whole_seconds and time_unit(entry.name) in _BEHIND:
            made.append((f"time of {whole.name} and {entry.name}", (whole, entry, _BEHIND[time_unit(entry.name)])))
    if not made:
        return source
    names = unique_names([entry.name for entry in entries] + [name for name, _ in made])[len(entries) :]
    return ClockPairs(source, dict(zip(names, (pair for _, pair in made), strict=True)))


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
