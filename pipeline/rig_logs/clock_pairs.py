"""One clock from two columns: whole seconds, and the nano-, micro- or milliseconds since them.

ROS writes ``stamp.sec`` and ``stamp.nanosec``; recorders write a time of day and ``ms`` behind it.
"""

import re
from collections.abc import Iterator, Sequence
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pipeline.rig_logs.source import Entry, Source, UnreadableChannelError, unique_names
from pipeline.units import time_unit

_PARTS = {"n": 1e9, "nano": 1e9, "u": 1e6, "µ": 1e6, "micro": 1e6, "m": 1e3, "milli": 1e3}
_BEHIND = {"ms": 1e3, "us": 1e6, "ns": 1e9}
_NAME = re.compile(r"(?i)(?P<stem>.*?)(?P<part>nano|micro|milli|[nuµm])?(secs?|seconds?)")


class ClockPairs:
    """A log in which each such pair is one more channel, in s since its first whole second."""

    def __init__(self, source: Source, pairs: dict[str, tuple[Entry, Entry, float]]) -> None:
        self._source, self._pairs = source, pairs
        self.format, self.texts, self.notes = source.format, source.texts, source.notes
        self.rates = getattr(source, "rates", {})
        self.one_pass = getattr(source, "one_pass", False)
        for name, (whole, part, _) in pairs.items():
            self.notes.append(f"{name!r} is made of {whole.name!r} and {part.name!r}, from the first whole second on")

    def entries(self) -> list[Entry]:
        """Those of the log, and the clocks."""
        clocks = [Entry(name, "s", "float64", whole.count) for name, (whole, _, _) in self._pairs.items()]
        return [*self._source.entries(), *clocks]

    def parts(self, names: Sequence[str]) -> Iterator[tuple[str, NDArray[Any]]]:
        """Samples as the log gives them, and each clock once both of its columns are read."""
        clocks = [name for name in names if name in self._pairs]
        of_clocks = [entry.name for name in clocks for entry in self._pairs[name][:2]]
        held: dict[str, list[NDArray[Any]]] = {name: [] for name in of_clocks}
        own = [name for name in names if name not in self._pairs]
        for name, samples in self._source.parts(list(dict.fromkeys([*own, *of_clocks]))):
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
        if whole.name in getattr(source, "whole_seconds", ()) and time_unit(entry.name) in _BEHIND:
            made.append((f"time of {whole.name} and {entry.name}", (whole, entry, _BEHIND[time_unit(entry.name)])))
    if not made:
        return source
    names = unique_names([entry.name for entry in entries] + [name for name, _ in made])[len(entries) :]
    return ClockPairs(source, dict(zip(names, (pair for _, pair in made), strict=True)))
