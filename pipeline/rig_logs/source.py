"""Interface of the format readers to the guarded child, and limits for the reading of one raw log."""

import difflib
import itertools
import re
import shutil
import tempfile
import weakref
from abc import ABC, abstractmethod
from collections import Counter
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .attributes import note_on_rate, stated_rate

MEGABYTE = 1 << 20
PART = 1 << 17
"""Rows at a time."""
MOST_COLUMNS = 1000
"""Columns of a matrix that are channels, or rows of one that is wider than high."""
_MOST_NAMED = 3
EXACT = 1 << 53
"""Up to which float64 holds every whole number."""
_MOST_LISTED = 30
_NUMBERED = re.compile(r"column \d+")
"""Names of columns without a header."""
_PLACE_OF = re.compile(r"[./][^./]*$")  # the last part of a path or of a dotted name


@dataclass(frozen=True)
class Limits:
    """Bounds on the child process that parses a raw log.

    Attributes
    ----------
    memory_bytes : int
        Most address space of the child (RLIMIT_AS), libraries included.
    processor_seconds : int
        Most processor time of the child (RLIMIT_CPU); a hung child is ended after ten times what its file may take.
    data_bytes : int
        Most bytes of samples, in float64, that are taken from one log.
    expansion : float
        Most bytes of samples per byte of file, unless they are fewer than `small_bytes`: a constant signal
        compresses a thousandfold, and so does a bomb.
    small_bytes : int
        Samples of fewer bytes than this are taken however well they were compressed.
    """

    memory_bytes: int = 12_288 * MEGABYTE
    processor_seconds: int = 300
    data_bytes: int = 8_192 * MEGABYTE
    expansion: float = 200.0
    small_bytes: int = 256 * MEGABYTE

    def largest(self, file_bytes: int) -> int:
        """Most bytes of samples that a file of that size may declare."""
        return min(self.data_bytes, max(self.small_bytes, int(self.expansion * file_bytes)))

    def memory(self, file_bytes: int) -> int:
        """Address space for a file of that size: the libraries' 3 GB, and four times the samples it may declare."""
        return min(self.memory_bytes, 3072 * MEGABYTE + 4 * self.largest(file_bytes))

    def seconds(self, file_bytes: int) -> int:
        """Processor time for a file of that size: 20 s, and one per MB, ten times what the slowest format takes."""
        return min(self.processor_seconds, 20 + file_bytes // MEGABYTE)


@dataclass(frozen=True)
class CsvOptions:
    """Stated format of a CSV log; None: detected from the file."""

    encoding: str | None = None
    delimiter: str | None = None
    decimal: str | None = None
    header_row: int | None = None


@dataclass(frozen=True)
class Entry:
    """One numeric channel as the headers declare it.

    Attributes
    ----------
    name : str
        Unique name in the log.
    unit : str
        Unit as the log writes it, or "".
    dtype : str
        Type of the numbers in the log.
    count : int
        Declared number of samples; an estimate for texts, which declare none.
    time : str or None
        Name of the entry that is its time base; None for time bases themselves and for columns of tables.
    aliases : tuple of str
        Other ways to ask for it, such as a header cell with its unit.
    """

    name: str
    unit: str
    dtype: str
    count: int
    time: str | None = None
    aliases: tuple[str, ...] = field(default=())


class Source(ABC):
    """An open raw log.

    Attributes
    ----------
    format : str
        Name for readers.
    one_pass : bool
        True if all channels are read in one pass, so that one of them cannot fail alone.
    notes : list of str
        Findings and assumptions of its reader.
    warnings : list of str
        Samples that it left out or changed, which every use of them reports.
    texts : dict of str to str
        Names of columns that are no numbers, with a cell that shows it and what to do.
    rates : dict of str to float
        The sample rates [Hz] that single numbers state, by their names.
    frequencies : dict of str to float
        Frequencies [Hz] by their names, either of the samples or of a motion: the log does not state which.
    counted : Counted
        Origins of its clocks.
    starts : dict of str to (float, float)
        Start and step [s] of each channel, where the log states them.
    stated_starts : dict of str to float
        Numbers that state when a channel or those of a group begin [s], by their names.
    descriptions : dict of str to str
        Text of the log beside a channel, by its name.
    heading : str
        Text of the log above or beside all of them.
    """

    format = ""
    one_pass = False

    def __init__(self) -> None:
        self.notes: list[str] = []
        self.warnings: list[str] = []
        self.texts: dict[str, str] = {}
        self.rates: dict[str, float] = {}
        self.frequencies: dict[str, float] = {}
        self.counted = Counted()
        self.starts: dict[str, tuple[float, float]] = {}
        self.stated_starts: dict[str, float] = {}
        self.descriptions: dict[str, str] = {}
        self.heading = ""

    def note_rates(self, stated: Mapping[str, tuple[float, float]]) -> None:
        """Keep numbers that state a sample rate, or may, and that [Hz], by their names; the former are noted once."""
        for name, (number, rate) in stated.items():
            if stated_rate(name, number) is None:
                self.frequencies[name] = rate
                continue
            self.notes += [] if name in self.rates else [note_on_rate(name, number, rate)]
            self.rates[name] = rate

    @abstractmethod
    def entries(self) -> list[Entry]:
        """Every numeric channel, from the headers only."""

    @abstractmethod
    def parts(self, names: Sequence[str]) -> Iterator[tuple[str, NDArray[Any]]]:
        """The samples of some entries, real numbers of any type, in parts that follow each other in each entry.

        No part is much longer than `PART` rows, as far as the format allows, so that a log of any length can be read.
        """


class View(Source):
    """Another log, as it is or with more channels."""

    def __init__(self, log: Source) -> None:
        super().__init__()
        vars(self).update({name: getattr(log, name) for name in (*vars(self), "format", "one_pass")})
        self._log = log

    def entries(self) -> list[Entry]:
        """The entries of the log."""
        return self._log.entries()

    def parts(self, names: Sequence[str]) -> Iterator[tuple[str, NDArray[Any]]]:
        """The samples of the log."""
        return self._log.parts(names)


class Counted(dict[str, Any]):
    """Origins of channels of time stamps, or of whole numbers that are too large for float64, such as ns since 1970.

    Clocks of one log share an origin, the first sample of the first one that is read: what lies between them stays.
    """

    def origin(self, name: str, first: Any) -> Any:
        """Origin of a channel whose first sample this is: that of a clock before it, else the sample itself.

        Of counts a clock is one so near that float64 holds what is between them.
        """
        clocks = (each for each in self.values() if type(each) is type(first) and each != 0)
        near = (each for each in clocks if isinstance(first, np.datetime64) or abs(first - each) < EXACT)
        return self.setdefault(name, next(near, first))

    def __call__(self, name: str, samples: NDArray[Any]) -> NDArray[Any]:
        """A part of a channel, from its first sample on where that is a time stamp or too large to be held exactly.

        Time stamps and durations become seconds.
        """
        if samples.dtype.kind == "M":
            stamps = samples[~np.isnat(samples)]
            samples = samples - (self.origin(name, stamps[0]) if stamps.size else self.get(name, samples[:1]))
        if samples.dtype.kind == "m":
            return samples / np.timedelta64(1, "s")
        if samples.dtype.kind not in "iu" or samples.dtype.itemsize < 8 or not samples.size:
            return samples
        ends = np.iinfo(samples.dtype)  # which stand for no value, mostly, as in place of NaN
        counts = samples[(samples != ends.min) & (samples != ends.max)]
        if counts.size:
            self.origin(name, int(counts[0]) if abs(int(counts[0])) > EXACT else 0)
        if not (origin := self.get(name, 0)):
            return samples
        near = (samples.astype(np.uint64) - np.uint64(origin % (1 << 64))).view(np.int64)
        far = samples.astype(np.float64) - float(origin)
        return np.where(np.abs(far) < EXACT, near, far)

    def notes(self, names: Collection[str]) -> list[str]:
        """Origin of the times of these channels."""
        first = {f"{origin}": name for name, origin in reversed(self.items())}
        return [
            f"{name!r} counts from {origin}, the first sample of {first[f'{origin}']!r}"
            for name, origin in self.items()
            if name in names and origin != 0
        ]


def left_out(texts: Mapping[str, str]) -> list[str]:
    """A note on channels that are no numbers, with the text on each; none where there are none."""
    named = [f"{name!r} ({text})" for name, text in list(texts.items())[: 2 * _MOST_NAMED]]
    more = [f"{len(texts) - len(named)} more like them"] if len(texts) > len(named) else []
    return [f"no numbers, and left out: {', '.join([*named, *more])}"] if texts else []


def not_listed(shapes: Mapping[str, tuple[int, ...]]) -> list[str]:
    """A note on arrays that are neither vectors nor matrices of channels; none where there are none."""
    sizes = [f"{name} is {' × '.join(map(str, shape))}" for name, shape in shapes.items()]
    more = [f"{len(sizes) - _MOST_NAMED} more like them"] if len(sizes) > _MOST_NAMED else []
    note = (
        f"{', '.join([*sizes[:_MOST_NAMED], *more])}; only vectors and matrices of at most {MOST_COLUMNS} columns, or "
        "rows, are read: save each channel as a vector"
    )
    return [note] if sizes else []


def ranges(count: int, step: int = PART) -> Iterator[tuple[int, int]]:
    """First and end row of consecutive parts."""
    return ((first, min(first + step, count)) for first in range(0, count, step))


class UnreadableLogError(Exception):
    """The log is damaged, not what it claims to be, or cannot be read as asked for; the text states in what way."""


class UnreadableChannelError(UnreadableLogError):
    """One channel is of a kind that is not read; the others are."""


def temporary_path(owner: object) -> Path:
    """Path for a file that is deleted with its `owner`.

    Unlike Python's own temporary file it is not open, so that Windows too lets a library open it by its name.
    """
    folder = tempfile.mkdtemp(prefix="debist-")
    weakref.finalize(owner, shutil.rmtree, folder, ignore_errors=True)
    return Path(folder) / "log"


def unique_names(names: list[str]) -> list[str]:
    """Names made unique by " (2)", " (3)", … in the order of the log; an empty one is ``column k``."""
    names = [name or f"column {k}" for k, name in enumerate(names, start=1)]
    taken = set(names)
    numbers = dict[str, Iterator[int]]()
    unique = list[str]()
    for name in names:
        given = name
        if name in numbers:
            given = next(numbered for i in numbers[name] if (numbered := f"{name} ({i})") not in taken)
            taken.add(given)
        numbers.setdefault(name, itertools.count(2))
        unique.append(given)
    return unique


def missing_channel(name: str, listed: Sequence[str]) -> str:
    """One line that states what is there instead of the channel `name`."""
    if not listed:
        return f"no channel {name!r}; the log holds no numeric channel at all"
    folded = {entry.casefold(): entry for entry in listed}
    close = [folded[match] for match in difflib.get_close_matches(name.casefold(), list(folded), n=3, cutoff=0.5)]
    hint = f"did you mean {' or '.join(map(repr, close))}? " if close else ""
    shown = ", ".join(map(repr, listed[:_MOST_LISTED])) + (", …" if len(listed) > _MOST_LISTED else "")
    way_out = as_other_logs(name, listed)
    return f"no channel {name!r}; {hint}it has {shown}" + (f"; {way_out}" if way_out else "")


def for_any_variable(name: str) -> str:
    """``*.y`` for the channel ``run1.y``, by which it may be asked for in whatever variable it is; "" without a dot."""
    variable, dot, rest = name.partition(".")
    return f"*.{rest}" if variable and dot and rest else ""


def as_other_logs(name: str, listed: Sequence[str]) -> str:
    """Advice where a channel of other logs has another name here, or none; "" where neither is seen."""
    alias = for_any_variable(name)
    if alias and [for_any_variable(other) for other in listed].count(alias) == 1:
        return f"save all logs under the same variable name, or write {alias!r} in [channels]"
    if listed and all(map(_NUMBERED.fullmatch, listed)) and not _NUMBERED.fullmatch(name):
        return "it has no header: give it that of the other logs, or make a settings file for each"
    return ""


def read_start(path: Path, size: int) -> bytes:
    """The first `size` bytes of a file."""
    with path.open("rb") as file:
        return file.read(size)


class StartTimes(View):
    """A log in which each channel has its time: start + k · step, in s."""

    def __init__(self, source: Source, starts: dict[str, tuple[float, float]]) -> None:
        super().__init__(source)
        clocks: dict[tuple[float, float], str] = {}
        self._time = {name: clocks.setdefault(clock, f"time of {name}") for name, clock in starts.items()}
        self._clocks = {time: clock for clock, time in clocks.items()}
        self.notes.append(
            f"channels begin at {', '.join(f'{start:g}' for start, _ in clocks)} s, as the log states: each has its "
            "own time"
        )

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


def stated_beside(source: Source) -> dict[str, tuple[float, float]]:
    """Start and step [s] that numbers beside a channel or its group state: ``q.t0`` and ``q.dt`` those of ``q.Y``."""
    starts = {_PLACE_OF.sub("", name): start for name, start in source.stated_starts.items()}
    rates = {_PLACE_OF.sub("", name): rate for name, rate in source.rates.items() if starts}
    clocks = {}
    for entry in source.entries() if starts else ():
        places = (entry.name, _PLACE_OF.sub("", entry.name))
        place = next((place for place in places if place in starts and place in rates), None)
        if place is not None and entry.time is None and entry.name not in source.stated_starts:
            clocks[entry.name] = (starts[place], 1.0 / rates[place])
    return clocks
