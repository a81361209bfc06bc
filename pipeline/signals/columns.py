"""Columns seen in part, scaled, or with rows left out, without a copy of the whole: every view is read by slices.

Rows are walked through in chunks of fixed size, so that nothing depends on how a log was read.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from pipeline.numerics.arrays import BoolArray, FloatArray, IntArray, Samples

CHUNK = 1 << 17
"""Rows at a time."""
_FIRST_STEP = 1 << 9

Signal = tuple[Samples, Samples]
"""Time stamps [s] and samples, in the order of the log."""


def chunks(size: int, overlap: int = 0) -> Iterator[slice]:
    """Ranges of at most `CHUNK` rows that cover `size` rows, each longer by `overlap` rows where there are any."""
    for first in range(0, size, CHUNK):
        yield slice(first, min(first + CHUNK + overlap, size))


@dataclass(frozen=True)
class Part:
    """Rows `first` … `last` − 1 of a column."""

    samples: Samples
    first: int
    last: int

    @property
    def size(self) -> int:
        """Number of samples."""
        return self.last - self.first

    def __getitem__(self, rows: slice, /) -> FloatArray:
        """The samples of a range of rows."""
        start, stop, _ = rows.indices(self.size)
        return self.samples[self.first + start : self.first + max(start, stop)]


@dataclass(frozen=True)
class Scaled:
    """A column times a factor, plus an offset, for units."""

    samples: Samples
    factor: float
    offset: float = 0.0

    @property
    def size(self) -> int:
        """Number of samples."""
        return self.samples.size

    def __getitem__(self, rows: slice, /) -> FloatArray:
        """The samples of a range of rows."""
        scaled: FloatArray = self.samples[rows] * self.factor + self.offset
        return scaled


class Held:
    """A column that was recorded when it changed, at other stamps: its last finite sample, NaN before the first.

    Parameters
    ----------
    time : Samples
        Stamps [s] at which it is wanted.
    stamps, samples : Samples
        Rising stamps [s] and samples of the record; they are held in memory.

    Notes
    -----
    Cost: O(log M) a row for M samples of the record.
    """

    def __init__(self, time: Samples, stamps: Samples, samples: Samples) -> None:
        self._time = time
        at, values = stamps[0 : stamps.size], samples[0 : samples.size]
        known = np.isfinite(at) & np.isfinite(values)
        self._at, self._values = at[known], np.concatenate(([np.nan], values[known]))

    @property
    def size(self) -> int:
        """Number of samples."""
        return self._time.size

    @property
    def rising(self) -> bool:
        """Whether the record's stamps never step back."""
        return bool(np.all(np.diff(self._at) >= 0.0))

    def __getitem__(self, rows: slice, /) -> FloatArray:
        """The samples of a range of rows."""
        return np.asarray(self._values[np.searchsorted(self._at, self._time[rows], side="right")])


class Rows:
    """Which rows of a log are taken: one bit a row.

    Parameters
    ----------
    parts : sequence of BoolArray
        The flags of consecutive chunks, each of `CHUNK` rows but the last.
    """

    def __init__(self, parts: Sequence[BoolArray]) -> None:
        self._packed = [np.packbits(part) for part in parts]
        self._sizes = [part.size for part in parts]
        counts = [int(np.count_nonzero(part)) for part in parts]
        self._starts = np.concatenate(([0], np.cumsum(counts))).astype(np.int64)
        self.size = sum(self._sizes)

    @property
    def count(self) -> int:
        """Number of rows taken."""
        return int(self._starts[-1])

    @property
    def all(self) -> bool:
        """Whether every row is taken."""
        return self.count == self.size

    def flags(self, chunk: int) -> BoolArray:
        """The flags of one chunk."""
        return np.unpackbits(self._packed[chunk], count=self._sizes[chunk]).view(np.bool_)

    def same(self, other: "Rows") -> bool:
        """Whether the same rows are taken."""
        return self.count == other.count and all(map(np.array_equal, self._packed, other._packed))

    def spans(self, start: int, stop: int) -> Iterator[tuple[int, slice]]:
        """The chunks that hold the rows taken number `start` … `stop` − 1, and which of theirs those are."""
        chunk = int(np.searchsorted(self._starts, start, side="right")) - 1
        while start < stop:
            first, end = int(self._starts[chunk]), int(self._starts[chunk + 1])
            if end > start:
                yield chunk, slice(start - first, min(stop, end) - first)
                start = end
            chunk += 1


class Selected:
    """The rows of a column that are taken, one after the other."""

    def __init__(self, samples: Samples, rows: Rows) -> None:
        self._samples = samples
        self._rows = rows
        self._chunk = -1  # the chunk that is held ready, since slices mostly follow each other
        self._ready: FloatArray = np.empty(0)

    @property
    def size(self) -> int:
        """Number of samples."""
        return self._rows.count

    def __getitem__(self, rows: slice, /) -> FloatArray:
        """The samples of a range of rows."""
        start, stop, _ = rows.indices(self.size)
        parts = [self._taken(chunk)[span] for chunk, span in self._rows.spans(start, stop)]
        return parts[0] if len(parts) == 1 else np.concatenate([np.empty(0), *parts])

    def _taken(self, chunk: int) -> FloatArray:
        if chunk != self._chunk:
            part = self._samples[chunk * CHUNK : (chunk + 1) * CHUNK]
            self._chunk, self._ready = chunk, part[self._rows.flags(chunk)]
        return self._ready


def select(samples: Samples, rows: Rows) -> Samples:
    """The rows taken of a column; the column itself where those are all."""
    return samples if rows.all else Selected(samples, rows)


def take(samples: Samples, indices: IntArray) -> FloatArray:
    """The samples at ascending indices, shape of `indices`."""
    taken = np.empty(indices.size)
    edges = np.searchsorted(indices, np.arange(0, samples.size + CHUNK, CHUNK))
    for chunk in np.flatnonzero(np.diff(edges)):
        own = slice(edges[chunk], edges[chunk + 1])
        part = samples[int(chunk) * CHUNK : int(chunk + 1) * CHUNK]
        taken[own] = part[indices[own] - chunk * CHUNK]
    return taken


def row_at(time: Samples, value: float, near: int = 0) -> int:
    """The first row whose stamp is not before `value`, looked for outwards from row `near`; the size if there is none.

    Parameters
    ----------
    time : Samples
        Ascending stamps.
    value : float
        What to look for.
    near : int
        Where to begin; a good guess saves reading.
    """
    first, step = min(near, time.size), _FIRST_STEP
    while first > 0 and time[first - 1 : first][0] >= value:
        last, first, step = first, max(0, first - step), min(2 * step, CHUNK)
        if first == 0 or time[first : first + 1][0] < value:
            return first + int(np.searchsorted(time[first:last], value))
    while first < time.size:
        part = time[first : first + step]
        if part[-1] >= value:
            return first + int(np.searchsorted(part, value))
        first, step = first + part.size, min(2 * step, CHUNK)
    return first


def equal(one: Samples, other: Samples) -> bool:
    """Whether two columns hold the same numbers."""
    return one is other or (
        one.size == other.size and all(np.array_equal(one[rows], other[rows]) for rows in chunks(one.size))
    )
