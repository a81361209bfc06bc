"""Columns of any length, made block by block, long ones in mapped temporary files; codes and times without a value."""

import tempfile
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import NamedTuple, TypeVar

import numpy as np
from numpy.typing import NDArray

from ..errors import DataRefusedError
from ..numerics.arrays import BoolArray, FloatArray

CHUNK = 1 << 17
"""Rows at a time."""
ROUNDING = 1e-6
"""Share that is left to rounding: of a number of 32 bits, of a place on a grid or a lattice, of a first moment."""
BLOCKS = 64
BLOCK = 2 * CHUNK // BLOCKS
"""Blocks spread over a long column, and rows of each, from which a median is taken."""

Entry = TypeVar("Entry", bound=np.generic)
_NINES = [10.0**digits - 1.0 for digits in range(3, 7)]
_WHOLE = [2.0**bits for bits in (15, 16, 31, 32)]
_CODES = [*_NINES[1:], *(-code for code in (*_NINES, *_WHOLE)), *(end - 1.0 for end in _WHOLE)]
"""Codes that recorders write: nines, positive ones from 9999 on, and the ends of whole numbers of 16 and 32 bits."""
_HUGE = 0.999e20
"""No measurement is that large: 9.9E37 of instruments, 9.97E36 of netCDF, 1.8E308."""


class Signal(NamedTuple):
    """Time stamps [s] and samples, in the order of the log, shape (N,) each."""

    time: FloatArray
    samples: FloatArray


def chunks(size: int, overlap: int = 0) -> Iterator[slice]:
    """Ranges of at most `CHUNK` rows that cover `size` rows, each longer by `overlap` rows where there are any."""
    for first in range(0, size, CHUNK):
        yield slice(first, min(first + CHUNK + overlap, size))


def column(size: int, parts: Iterable[NDArray[Entry]], dtype: type[Entry]) -> NDArray[Entry]:
    """The array of `size` entries that follow each other in `parts`.

    A long one is a `numpy.memmap` on a temporary file, read-only, which the system deletes with
    the last view of it.

    Raises
    ------
    OSError
        The temporary folder is full.
    """
    if size <= CHUNK:
        return np.concatenate([np.empty(0, dtype), *parts])
    with tempfile.TemporaryFile(prefix="debist-") as file:
        for part in parts:
            file.write(np.ascontiguousarray(part).data)  # a mapped page that finds no room would end the process
        return np.asarray(np.memmap(file, dtype, "r", shape=(size,)))


class Stream:
    """Columns that are made in ascending order, any number of rows at a time.

    Parameters
    ----------
    pieces : iterator of FloatArray, shape (k, n)
        The columns, piece after piece.
    """

    def __init__(self, pieces: Iterator[FloatArray]) -> None:
        self._pieces = pieces
        self._ready: list[FloatArray] = []

    def read(self, count: int) -> FloatArray:
        """The next `count` rows, shape (k, count)."""
        parts = self._ready
        held = sum(part.shape[1] for part in parts)
        while held < count:
            parts.append(next(self._pieces))
            held += parts[-1].shape[1]
        values = np.concatenate(parts, axis=1)
        self._ready = [values[:, count:].copy()]
        return values[:, :count]


def differences(samples: FloatArray, order: int = 1, spacing: int = 1) -> FloatArray:
    """Differences of some order between samples so far apart, of the whole or of blocks spread over a long column."""
    parts = [samples]
    if samples.size > BLOCKS * BLOCK:
        starts = np.linspace(0, samples.size - BLOCK, BLOCKS).astype(np.int64).tolist()
        parts = [samples[i : i + BLOCK] for i in starts]
    for _ in range(order):
        parts = [part[spacing:] - part[:-spacing] for part in parts]
    return np.concatenate(parts)


def scaled(samples: FloatArray, factor: float, offset: float) -> FloatArray:
    """Samples times a factor, plus an offset, for units."""
    parts = (samples[rows] * factor + offset for rows in chunks(samples.size))
    return samples if (factor, offset) == (1.0, 0.0) else column(samples.size, parts, np.float64)


def one_sign(samples: FloatArray, sign: float) -> FloatArray:
    """The positive part of a column, or with `sign` −1 the negative one without its sign; 0 elsewhere."""
    return column(samples.size, (np.maximum(sign * samples[rows], 0.0) for rows in chunks(samples.size)), np.float64)


def held(time: FloatArray, stamps: FloatArray, samples: FloatArray) -> FloatArray:
    """Samples of a record made on change, held to other stamps; NaN before the first finite one, shape (N,).

    Parameters
    ----------
    time : FloatArray, shape (N,)
        Stamps [s] at which it is wanted.
    stamps, samples : FloatArray, shape (M,)
        Rising stamps [s] and samples of the record.

    Notes
    -----
    Cost: O(N log M); memory for the finite samples.
    """
    usable = finite(stamps) & finite(samples)
    at = stamps[usable]
    values = np.concatenate(([np.nan], samples[usable]))
    parts = (values[np.searchsorted(at, time[rows], side="right")] for rows in chunks(time.size))
    return column(time.size, parts, np.float64)


def finite(samples: FloatArray) -> BoolArray:
    """Mask of the samples that are neither NaN nor infinite, shape (N,)."""
    return column(samples.size, (np.isfinite(samples[rows]) for rows in chunks(samples.size)), np.bool_)


def select(samples: FloatArray, taken: BoolArray) -> FloatArray:
    """The samples at the rows taken; the column itself where those are all."""
    count = int(np.count_nonzero(taken))
    parts = (samples[rows][taken[rows]] for rows in chunks(samples.size))
    return samples if count == samples.size else column(count, parts, np.float64)


def sparse(signal: Signal) -> tuple[Signal, int]:
    """A column without its blanks where it has a sample every few rows, and how many rows those are; 1 for others."""
    time, samples = signal
    taken = finite(samples)
    if taken.all():
        return signal, 1
    spacing = np.diff(np.flatnonzero(taken))
    usual = int(np.median(spacing)) if spacing.size else 1
    if usual < 2 or np.mean(spacing == usual) < 0.5:
        return signal, 1
    return Signal(select(time, taken), select(samples, taken)), usual


def equal(first: FloatArray, second: FloatArray) -> bool:
    """True if two columns hold the same numbers."""
    return first is second or (
        first.size == second.size and all(np.array_equal(first[rows], second[rows]) for rows in chunks(first.size))
    )


@dataclass(frozen=True)
class Missing:
    """Missing samples of a signal.

    Attributes
    ----------
    n, not_finite : int
        Samples, and how many of them are NaN or infinite.
    first : float
        Stamp [s] of the first of these; NaN if there is none.
    before, after : float
        Time [s] for which the displacement is known before the signal's first finite sample, and after its last.
    lasts : float
        Time [s] for which the displacement is known.
    """

    n: int
    not_finite: int
    first: float
    before: float
    after: float
    lasts: float

    @property
    def share(self) -> float:
        """Share of the samples, or of the time of the displacement, whichever is larger."""
        alone = (self.before + self.after) / self.lasts if self.lasts > 0.0 else 0.0
        return max(self.not_finite / self.n, alone)


def missing(q: Signal, beside: Mapping[str, Signal]) -> dict[str, Missing]:
    """Missing samples of each signal beside the displacement `q` while that is known.

    Raises
    ------
    DataRefusedError
        No sample of one of them is finite.

    Notes
    -----
    Cost: one pass over stamps and samples of each, in chunks.
    """
    begin, end, _, _ = _extent("q", q)
    absent = {}
    for name, (time, samples) in beside.items():
        first, last, count, bad = _extent(name, Signal(time, samples))
        absent[name] = Missing(
            n=samples.size,
            not_finite=count,
            first=bad,
            before=max(0.0, first - begin),
            after=max(0.0, end - last),
            lasts=end - begin,
        )
    return absent


def _extent(name: str, signal: Signal) -> tuple[float, float, int, float]:
    """First and last stamp of a finite sample, the number of samples that are not finite, and their first stamp."""
    time, samples = signal
    usable = finite(samples)
    timed = select(time, usable)
    timed = select(timed, finite(timed))
    if not timed.size:
        raise DataRefusedError(f"{name}: no sample is finite where the time is known")
    gone = select(time, ~usable)
    located = gone[np.isfinite(gone)]
    return float(timed.min()), float(timed.max()), gone.size, float(located[0]) if located.size else np.nan


def masked(samples: FloatArray, codes: Iterable[float]) -> FloatArray:
    """A column with NaN in place of codes; the column itself without any."""
    parts = (np.where(_is_any(samples[rows], codes), np.nan, samples[rows]) for rows in chunks(samples.size))
    return column(samples.size, parts, np.float64) if codes else samples


def codes_in(
    samples: FloatArray, declared: Sequence[float] | None = None, *, of_time: bool = False
) -> dict[float, int]:
    """The codes for no value in a column, and how many samples each has.

    Parameters
    ----------
    samples : FloatArray, shape (N,)
        In the numbers of the log.
    declared : sequence of float, optional
        Numbers that stand for no value; without them numbers of 1e20 and more, taken as one, and usual codes that lie
        further from the rest than that is wide.
    of_time : bool
        True if the column is a clock, which may pass by any smaller number.

    Notes
    -----
    Cost: one pass, in chunks.
    """
    counts = dict.fromkeys(_CODES if declared is None else map(float, declared), 0)
    low = np.inf
    high = -np.inf
    largest = 0.0
    huge = 0
    for rows in chunks(samples.size):
        part = samples[rows]
        part = part[np.isfinite(part)]
        beyond = np.abs(part) >= _HUGE
        if declared is None and beyond.any():
            huge += int(np.count_nonzero(beyond))
            largest = max(largest, part[beyond].max(), key=abs)
            part = part[~beyond]
        least = part.min(initial=np.inf)
        most = part.max(initial=-np.inf)
        for code in (c for c in counts if least <= c + ROUNDING * abs(c) and c - ROUNDING * abs(c) <= most):
            at_code = _is_any(part, (code,))
            if at_code.any():
                counts[code] += int(np.count_nonzero(at_code))
                part = part[~at_code]
        low = min(low, part.min(initial=np.inf))
        high = max(high, part.max(initial=-np.inf))
    span = high - low
    far = {
        code: n
        for code, n in counts.items()
        if n and (declared is not None or (not of_time and span > 0.0 and max(low - code, code - high) > span))
    }
    return far | ({float(largest): huge} if huge else {})


def _is_any(part: FloatArray, codes: Iterable[float]) -> BoolArray:
    is_code = np.zeros(part.size, dtype=np.bool_)
    for code in codes:
        is_code |= np.abs(part) >= _HUGE if abs(code) >= _HUGE else np.abs(part - code) <= ROUNDING * abs(code)
    return is_code
