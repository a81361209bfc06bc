"""The stretches of a log on a uniform grid as one stream of values, straight lines between the stretches."""

from collections.abc import Iterator

import numpy as np

from pipeline.numerics.arrays import FloatArray, IntArray
from pipeline.signals.columns import Part, row_at
from pipeline.signals.resampling import Grid, decimated, interpolated
from pipeline.signals.stretches import Stretches

_PIECE = 1 << 15
_EDGE = 1e-6
"""Share of an interval by which a grid point may lie outside a stretch and still belong to it: rounding."""


class Stream:
    """The values of a group of columns at all points of a grid, in ascending order, any number at a time.

    Parameters
    ----------
    group : Stretches
        Columns with k members.
    grid : Grid
        Inside the group's time span.
    decimate : bool
        Low-pass and decimate, or interpolate.
    """

    def __init__(self, group: Stretches, grid: Grid, *, decimate: bool) -> None:
        self._pieces = _resampled(group, grid, decimate)
        self._ready: FloatArray = np.empty((len(group.columns), 0))

    def read(self, count: int) -> FloatArray:
        """The values at the next `count` points, shape (k, count)."""
        parts, held = [self._ready], self._ready.shape[1]
        while held < count:
            parts.append(next(self._pieces))
            held += parts[-1].shape[1]
        values = np.concatenate(parts, axis=1)
        self._ready = values[:, count:].copy()
        return values[:, :count]


def _resampled(group: Stretches, grid: Grid, decimate: bool) -> Iterator[FloatArray]:
    """Values at all grid points, shape (k, m), piece after piece."""
    position = 0
    for (low, high), (first, last, end) in zip(*_shares_of_grid(group, grid), strict=True):
        if position < first:
            yield from _bridged(group, grid, position, first, low)
        wanted = end - first
        for piece in _stretch(group, low, high, Part(grid, first, last), grid.interval, decimate):
            yield piece[:, :wanted]
            wanted -= min(wanted, piece.shape[1])
        position = end
    if position < grid.size:
        yield from _bridged(group, grid, position, grid.size, group.time.size)


def _shares_of_grid(group: Stretches, grid: Grid) -> tuple[list[IntArray], list[IntArray]]:
    """Rows of each stretch that holds grid points; its first and end point, and the end of those it gives values to."""
    first = grid.count(group.edges[:, 0] - _EDGE * grid.interval)
    last = grid.count(group.edges[:, 1] + _EDGE * grid.interval, up_to=True)
    holds = np.flatnonzero(first < last)
    first, last = first[holds], last[holds]
    # Where two stretches nearly touch, a point at the edge of both is the later one's.
    end = np.minimum(last, np.append(first[1:], grid.size))
    return list(group.bounds[holds]), list(np.stack((first, last, end), axis=1))


def _stretch(
    group: Stretches, low: int, high: int, points: Part, interval: float, decimate: bool
) -> Iterator[FloatArray]:
    """Values of one gap-free stretch at its grid points."""
    time = Part(group.time, int(low), int(high))
    columns = [Part(column, int(low), int(high)) for column in group.columns]
    if decimate:
        yield from decimated(time, columns, points, interval)
        return
    each = [
        interpolated(time, column, points, smooth=smooth) for column, smooth in zip(columns, group.smooth, strict=True)
    ]
    for pieces in zip(*each, strict=True):
        yield np.stack(pieces)


def _bridged(group: Stretches, grid: Grid, first: int, last: int, near: int) -> Iterator[FloatArray]:
    """Straight lines from sample to sample at the points between two stretches; `near` is the row behind them."""
    for start in range(first, last, _PIECE):
        points = grid[start : min(start + _PIECE, last)]
        low = max(row_at(group.time, points[0], int(near)) - 1, 0)
        high = min(row_at(group.time, points[-1], int(near)) + 1, group.time.size)
        stamps = group.time[low:high]
        yield np.stack([np.interp(points, stamps, column[low:high]) for column in group.columns])
