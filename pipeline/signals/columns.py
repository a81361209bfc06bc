"""Columns of any length: long ones lie in temporary files that are mapped as arrays, and are made block by block."""

import tempfile
from collections.abc import Iterable, Iterator
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from ..numerics.arrays import BoolArray, FloatArray

CHUNK = 1 << 17
"""Rows at a time."""
ROUNDING = 1e-6
"""Share that is left to rounding: of a number of 32 bits, of a place on a grid or a lattice, of a first moment."""
BLOCKS = 64
BLOCK = 2 * CHUNK // BLOCKS
"""Blocks spread over a long column, and rows of each, from which a median is taken."""

Entry = TypeVar("Entry", bound=np.generic)
Signal = tuple[FloatArray, FloatArray]
"""Time stamps [s] and samples, in the order of the log."""


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
    """What was recorded when it changed, at other stamps: its last finite sample, NaN before the first, shape (N,).

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
    """Which samples are neither NaN nor infinite, shape (N,)."""
    return column(samples.size, (np.isfinite(samples[rows]) for rows in chunks(samples.size)), np.bool_)


def select(samples: FloatArray, taken: BoolArray) -> FloatArray:
    """The samples at the rows taken; the column itself where those are all."""
    count = int(np.count_nonzero(taken))
    if count == samples.size:
        return samples
    return column(count, (samples[rows][taken[rows]] for rows in chunks(samples.size)), np.float64)


def sparse(signal: Signal) -> tuple[Signal, int]:
    """A column without its blanks where it has a sample every few rows, and how many rows those are; 1 for others."""
    taken = finite(signal[1])
    if taken.all():
        return signal, 1
    spacing = np.diff(np.flatnonzero(taken))
    usual = int(np.median(spacing)) if spacing.size else 1
    if usual < 2 or np.mean(spacing == usual) < 0.5:
        return signal, 1
    return (select(signal[0], taken), select(signal[1], taken)), usual


def equal(first: FloatArray, second: FloatArray) -> bool:
    """Whether two columns hold the same numbers."""
    return first is second or (
        first.size == second.size and all(np.array_equal(first[rows], second[rows]) for rows in chunks(first.size))
    )
