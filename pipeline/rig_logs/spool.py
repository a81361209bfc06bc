"""Columns that the guarded child has written into a temporary file, mapped as arrays or read slice by slice."""

import mmap
import os
from collections import OrderedDict
from collections.abc import Callable

import numpy as np

from pipeline.numerics.arrays import FloatArray

Places = list[tuple[int, int]]
"""Offset [bytes] and number of samples of each part of a column, in order."""

_CHUNK = 1 << 16
_HELD = 4


def mapped_columns(fd: int) -> Callable[[Places], FloatArray]:
    """Columns as read-only arrays; a column of one part is a view on the mapped file.

    The callable raises ValueError for places that are not in the file.
    """
    size = os.fstat(fd).st_size
    mapped = mmap.mmap(fd, size, access=mmap.ACCESS_READ) if size else b""

    def column(places: Places) -> FloatArray:
        _check(places, size)
        parts = [np.frombuffer(mapped, dtype="<f8", count=count, offset=offset) for offset, count in places]
        whole = parts[0] if len(parts) == 1 else np.concatenate([np.empty(0), *parts])
        whole.flags.writeable = False
        return whole

    return column


def spooled_columns(fd: int) -> Callable[[Places], "SpooledColumn"]:
    """Columns that stay in the file, which must be kept open; ValueError as for `mapped_columns`."""
    size = os.fstat(fd).st_size

    def column(places: Places) -> SpooledColumn:
        _check(places, size)
        return SpooledColumn(fd, places)

    return column


def _check(places: Places, size: int) -> None:
    if any(offset < 0 or count < 0 or offset + 8 * count > size for offset, count in places):
        raise ValueError


class SpooledColumn:
    """A column on disk, of which a few chunks are held ready, since most slices are near each other.

    Parameters
    ----------
    fd : int
        Descriptor of the open file.
    places : list of (int, int)
        Where its parts lie.
    """

    def __init__(self, fd: int, places: Places) -> None:
        self._fd = fd
        self._offsets = np.array([offset for offset, _ in places], dtype=np.int64)
        self._starts = np.concatenate(([0], np.cumsum([count for _, count in places]))).astype(np.int64)
        self._held: OrderedDict[int, FloatArray] = OrderedDict()

    @property
    def size(self) -> int:
        """Number of samples."""
        return int(self._starts[-1])

    def __getitem__(self, rows: slice, /) -> FloatArray:
        """The samples of a range of rows."""
        start, stop, _ = rows.indices(self.size)
        if stop - start >= _CHUNK:
            return self._read(start, stop)
        parts = []
        while start < stop:
            number, first = divmod(start, _CHUNK)
            last = min(stop - number * _CHUNK, _CHUNK)
            parts.append(self._chunk(number)[first:last])
            start += last - first
        return parts[0] if len(parts) == 1 else np.concatenate([np.empty(0), *parts])

    def _chunk(self, number: int) -> FloatArray:
        held = self._held.get(number)
        if held is None:
            held = self._held[number] = self._read(number * _CHUNK, min((number + 1) * _CHUNK, self.size))
            if len(self._held) > _HELD:
                self._held.popitem(last=False)
        else:
            self._held.move_to_end(number)
        return held

    def _read(self, start: int, stop: int) -> FloatArray:
        values = np.empty(stop - start, dtype="<f8")
        part = int(np.searchsorted(self._starts, start, side="right")) - 1
        filled = 0
        while start < stop:
            end = min(stop, int(self._starts[part + 1]))
            if end > start:
                content = values[filled : filled + end - start].data.cast("B")
                _read_fully(self._fd, content, int(self._offsets[part]) + 8 * (start - int(self._starts[part])))
                filled, start = filled + end - start, end
            part += 1
        values.flags.writeable = False
        return values


def _read_fully(fd: int, content: memoryview, offset: int) -> None:
    while content:
        count = os.preadv(fd, [content], offset)
        if not count:
            raise OSError("the temporary file of a log's samples is shorter than it was")
        content, offset = content[count:], offset + count
