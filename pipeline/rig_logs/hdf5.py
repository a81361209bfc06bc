"""HDF5 logs: vectors by their path, columns of matrices as path[:,j]; units from the usual attributes.

Nothing outside the file is ever opened, and no claim is believed. Refused: external links, external storage, virtual
datasets, and datasets that claim more than what they store could expand to. Soft links are not followed: they could
lead through an external one. Without these checks a file of 1 kB can claim 16 GB, or lead a reader to any file.
"""

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import h5py
import numpy as np
from numpy.typing import NDArray

from ..units.units import SECONDS, time_unit
from .attributes import description_among, plain, rates_among, scales_among, starts_among, texts_among, unit_among
from .channel_roles import is_called
from .source import MOST_COLUMNS, PART, Entry, Source, UnreadableLogError, left_out, not_listed, ranges

PACKING = ("scale_factor", "add_offset", "_Unsigned", "valid_min", "valid_max", "valid_range")
"""Attributes of netCDF by which stored numbers are not the values."""
_MISSING = ("_FillValue", "missing_value")
_FILLED = ("int16", "uint16", "int32", "uint32", "float32", "float64")
"""Types of which netCDF takes the value that stands where nothing was written for none."""
_FILTERS = {
    307: "bzip2",
    32001: "blosc",
    32004: "lz4",
    32008: "bitshuffle",
    32013: "zfp",
    32015: "zstd",
    32026: "blosc2",
}
NUMBERS = "fiubmM"
"""Kinds of types that are read; time stamps and durations as seconds."""
_KINDS = {"c": "complex: save its real part", "O": "text or lists", "S": "text", "U": "text", "V": "no numbers"}
_NO_VARIABLE = b"This is a netCDF dimension but not a netCDF variable"
_LARGEST_RATIO = 2000.0  # of declared to stored bytes; deflate reaches about 1000
_SMALL_BYTES = 1 << 20  # which are read whatever they declare


def unit_of(attributes: Mapping[str, Any], column: int, columns: int) -> tuple[str, str]:
    """The unit of a column, and the origin of a time such as ``seconds since 2024-01-31``; "" where there is none."""
    text = unit_among(attributes, column, columns)
    _, since, origin = text.partition(" since ")
    return (time_unit(text), origin) if since and time_unit(text) else (text, "")


def why_unread(dataset: Any) -> str:
    """Reason why no numbers are read from a dataset; "" where they are."""
    filters = dataset.id.get_create_plist()
    codes = [filters.get_filter(i)[0] for i in range(filters.get_nfilters())]
    if foreign := [code for code in codes if not h5py.h5z.filter_avail(code)]:
        return (
            f"compressed by a filter that is not read here, {_FILTERS.get(foreign[0], 'unknown')} ({foreign[0]}): "
            "write it with gzip or none"
        )
    if dataset.dtype.names or dataset.dtype.kind in NUMBERS:
        return ""
    return _KINDS.get(dataset.dtype.kind, f"{dataset.dtype}")


def missing_values(dataset: Any, *, filled: bool = False) -> NDArray[Any] | None:
    """Numbers that stand for no value in a dataset; None where there are none.

    In a file of netCDF a value that was never written is the fill value of the dataset (`filled`).

    Raises
    ------
    UnreadableLogError
        Its numbers are packed: they would have to be converted.
    """
    if packed := [name for name in PACKING if name in dataset.attrs]:
        raise UnreadableLogError(
            f"packed ({', '.join(f'{name} = {plain(dataset.attrs[name])}' for name in packed)}): save its "
            "unpacked values"
        )
    values = [np.ravel(dataset.attrs[name]) for name in _MISSING if name in dataset.attrs]
    if filled and dataset.dtype.name in _FILLED and "_FillValue" not in dataset.attrs:
        values.append(np.ravel(dataset.fillvalue))
    if any(each.dtype.kind not in "iuf" for each in values):
        raise UnreadableLogError("its fill value is no number")
    return np.concatenate(values).astype(dataset.dtype.base) if values else None


def written_chunks(dataset: Any, axis: int) -> NDArray[np.bool_] | None:
    """Mask of the written chunks along an axis; None where all are written, or there are no chunks."""
    if dataset.chunks is None:
        return None
    counts = [-(-size // chunk) for size, chunk in zip(dataset.shape, dataset.chunks, strict=True)]
    if dataset.id.get_num_chunks() == math.prod(counts):
        return None
    written = np.zeros(counts[axis], dtype=np.bool_)

    def mark(chunk: Any) -> None:
        """A chunk was written."""
        written[chunk.chunk_offset[axis] // dataset.chunks[axis]] = True

    dataset.id.chunk_iter(mark)
    return written


def scales_of_axis(dataset: Any, axis: int) -> list[str]:
    """Names of the dimension scales of an axis that hold numbers; a bare dimension of netCDF does not."""
    try:
        scales = list(dataset.dims[axis].values())
    except (RuntimeError, ValueError, KeyError, TypeError, OSError):  # references to what is not there
        return []
    return [
        scale.name.lstrip("/")
        for scale in scales
        if scale.name and not bytes(scale.attrs.get("NAME", b"")).startswith(_NO_VARIABLE)
    ]


def open_hdf5(path: Path) -> Any:
    """Open an HDF5 file for reading.

    Raises
    ------
    UnreadableLogError
        Truncated, damaged, or left open by its writer.
    """
    try:
        return h5py.File(path, "r")
    except OSError as error:
        reason = str(error).split("(", 1)[-1].rstrip(")") or str(error)
        if "unable to lock" in reason or "already open" in reason:
            raise UnreadableLogError(
                "its recorder still writes it, or died while it did: end the recording, or after a crash run "
                "`h5clear -s` on a copy"
            ) from error
        raise UnreadableLogError(f"HDF5 cannot open it: {reason}") from error


def child_of(group: Any, name: str) -> Any:
    """Member `name` of a group, if it is a hard link to a group or to a harmless dataset.

    Raises
    ------
    UnreadableLogError
        It leads elsewhere.
    """
    link = group.get(name, getlink=True)
    if not isinstance(link, h5py.HardLink):
        path = f"{group.name.rstrip('/')}/{name}"
        if link is None:
            raise UnreadableLogError(f"{path} is named but not there: damaged")
        raise UnreadableLogError(f"{path} is a link that leads elsewhere ({type(link).__name__}); refused")
    return checked(group[name])


def checked(item: Any) -> Any:
    """The object itself, if its samples are in this file and as many as it claims.

    Raises
    ------
    UnreadableLogError
        External storage, a virtual dataset, or more declared than stored.
    """
    if not isinstance(item, h5py.Dataset):
        return item
    if item.external:
        raise UnreadableLogError(f"{item.name} keeps its samples in other files (external storage); refused")
    if item.is_virtual:
        raise UnreadableLogError(f"{item.name} is put together from other files (virtual dataset); refused")
    declared = item.size * item.dtype.itemsize if item.size else 0
    stored = item.id.get_storage_size()
    if declared > _SMALL_BYTES and declared > _LARGEST_RATIO * stored:
        raise UnreadableLogError(
            f"{item.name} claims {declared / 1e6:.0f} MB and stores {stored / 1e6:.3g} MB; refused unread"
        )
    return item


def walk(group: Any, prefix: str = "", seen: set[Any] | None = None) -> Iterator[tuple[str, Any]]:
    """Every dataset below a group with its path from there, each once (but those `seen`), in the file's order."""
    seen = set() if seen is None else seen
    for name in group:
        if isinstance(group.get(name, getlink=True), h5py.SoftLink):
            continue  # what it names is listed in its own place, if it is in this file
        item = child_of(group, name)
        address = h5py.h5o.get_info(item.id).addr
        if address in seen:
            continue
        seen.add(address)
        if isinstance(item, h5py.Group):
            yield from walk(item, f"{prefix}{name}/", seen)
        elif isinstance(item, h5py.Dataset):
            yield f"{prefix}{name}", item


def flat(dataset: Any, start: int, stop: int, shape: tuple[int, ...]) -> NDArray[Any]:
    """Elements `start` … `stop` − 1 of a vector or matrix in the file's order, read without the others.

    Parameters
    ----------
    dataset : h5py.Dataset
        The dataset.
    start, stop : int
        First element, and the one behind the last.
    shape : tuple of int
        Its shape.
    """
    if math.prod(shape) == max(shape):
        index: list[int | slice] = [0] * len(shape)
        index[int(np.argmax(shape))] = slice(start, stop)
        return np.asarray(dataset[tuple(index)])
    width = shape[-1]
    rows = range(start // width, -(-stop // width))
    return np.concatenate([dataset[row, max(start - row * width, 0) : min(stop - row * width, width)] for row in rows])


def rows_at_a_time(dataset: Any, axis: int) -> int:
    """About `PART` rows along an axis, a multiple of the stored chunks, so that none is unpacked twice."""
    chunk = dataset.chunks[axis] if dataset.chunks else 1
    return int(-(-PART // chunk) * chunk)


_Column = int | tuple[str] | tuple[str, int] | None
"""Part of a dataset: column or row of a matrix; name of a field of a table, and its column if there are several."""


class Hdf5Source(Source):
    """A plain HDF5 file; a dimension scale in s is the time base of a channel, else the settings name one."""

    format = "HDF5"

    def __init__(self, path: Path, *_: object) -> None:
        super().__init__()
        self._places: dict[str, tuple[Any, _Column, NDArray[Any] | None]] = {}
        self._entries: list[Entry] = []
        self._file = open_hdf5(path)
        self._filled = "_NCProperties" in self._file.attrs
        self.notes += scales_among(self._file.attrs)
        self.heading = texts_among(self._file.attrs)
        others = {}
        for name, dataset in walk(self._file):
            for holder in (self._file, dataset.parent, dataset):
                self.note_rates(rates_among(holder.attrs, holder.name.strip("/")))
                self.stated_starts |= starts_among(holder.attrs, holder.name.strip("/"))
            if dataset.parent != self._file and len(dataset.parent) == 1:
                self.notes += scales_among(dataset.parent.attrs, name)
            if not self._list(name, dataset):
                others[name] = dataset.shape
        units = {entry.name: entry for entry in self._entries}
        self._entries = [replace(entry, time=self._clock(entry, units)) for entry in self._entries]
        self.notes += [*left_out(self.texts), *not_listed(others)]

    def entries(self) -> list[Entry]:
        """Every vector of real numbers."""
        return self._entries

    def parts(self, names: Sequence[str]) -> Iterator[tuple[str, NDArray[Any]]]:
        """The samples of some channels, in slices along the stored chunks."""
        for name in names:
            dataset, column, missing = self._places[name]
            axis = int(np.argmax(dataset.shape))
            written = written_chunks(dataset, axis)
            if written is not None:
                self.warnings.append(
                    f"{name!r}: {np.sum(~written)} of {written.size} chunks were never written, no values"
                )
            for first, last in ranges(dataset.shape[axis], rows_at_a_time(dataset, axis)):
                if column is None:
                    part = flat(dataset, first, last, dataset.shape)
                elif isinstance(column, tuple):
                    part = flat(dataset.fields(column[0]), first, last, dataset.shape)[(..., *column[1:])]
                else:
                    part = dataset[first:last, column] if axis == 0 else dataset[column, first:last]
                samples = self.counted(name, part)
                if missing is not None:
                    samples = np.where(np.isin(part, missing), np.nan, samples)
                if written is not None:
                    samples = np.where(written[np.arange(first, last) // dataset.chunks[axis]], samples, np.nan)
                yield name, samples

    def _list(self, name: str, dataset: Any) -> bool:
        """List its channels, or the sample rate that it states; False for numbers that are neither."""
        shape: tuple[int, ...] = dataset.shape or ()
        if dataset.size and dataset.size > 1 and (why := why_unread(dataset)):
            self.texts[name] = why
        elif dataset.dtype.names and dataset.size == max(shape, default=0):  # a table of named columns
            for field in dataset.dtype.names:
                kind = dataset.dtype[field]
                if kind.kind in NUMBERS and not kind.shape:
                    self._add(f"{name}.{field}", kind, dataset.size, dataset, (field,))
                elif kind.base.kind in NUMBERS and len(kind.shape) == 1 and kind.shape[0] <= MOST_COLUMNS:
                    for j in range(kind.shape[0]):
                        self._add(f"{name}.{field}[:,{j}]", kind.base, dataset.size, dataset, (field, j))
                else:
                    self.texts[f"{name}.{field}"] = f"{kind}"
        elif dataset.dtype.kind in NUMBERS and dataset.size and dataset.size == max(shape, default=0) > 1:
            self._add(name, dataset.dtype, dataset.size, dataset, None)
        elif dataset.dtype.kind in NUMBERS and len(shape) == 2 and 1 < min(shape) <= MOST_COLUMNS:
            for j in range(min(shape)):
                place = f"[:,{j}]" if shape[1] <= shape[0] else f"[{j},:]"
                self._add(name + place, dataset.dtype, max(shape), dataset, j)
        elif dataset.dtype.kind in "fiu" and dataset.size == 1:
            number = {name: float(np.ravel(dataset[()])[0])}
            self.note_rates(rates_among(number, ""))
            self.notes += scales_among(number)
        else:
            return dataset.dtype.kind not in "fiu" or not dataset.size
        return True

    def _clock(self, entry: Entry, entries: Mapping[str, Entry]) -> str | None:
        """The dimension scale over which a channel runs, if that is its time in s; another unit of time is noted."""
        dataset = self._places[entry.name][0]
        for name in scales_of_axis(dataset, int(np.argmax(dataset.shape))):
            scale = entries.get(name)
            if scale is None or scale is entry or scale.count != entry.count:
                continue
            factor = SECONDS.get(time_unit(scale.unit)) if scale.unit else 1.0 if is_called("time", name) else None
            if factor == 1.0:
                return name
            if factor is not None:
                self.notes.append(f"{entry.name!r} runs over {name!r} in {scale.unit}: name that as its time")
        return None

    def _add(self, name: str, dtype: np.dtype[Any], count: int, dataset: Any, column: _Column) -> None:
        """List a channel, unless its attributes cannot be applied; what they say is noted."""
        try:
            missing = missing_values(dataset, filled=self._filled) if dataset.dtype.names is None else None
        except UnreadableLogError as error:
            self.texts[name] = f"{error}"
            return
        columns: Sequence[Any] = dataset.dtype.names or range(min(dataset.shape))
        place = columns.index(column[0]) if isinstance(column, tuple) else column or 0
        unit, since = unit_of(dataset.attrs, place, len(columns))
        own = name if isinstance(column, tuple) else dataset.name.lstrip("/")
        notes = [f"time of {own!r} counts from {since}"] if since else []
        notes += scales_among(dataset.attrs, own)
        self.notes += [note for note in notes if note not in self.notes]
        self._places[name] = (dataset, column, missing)
        if text := "" if isinstance(column, tuple) else description_among(dataset.attrs):
            self.descriptions[name] = text
        self._entries.append(Entry(name, "s" if dtype.kind in "mM" else unit, dtype.name, int(count)))


open_log = Hdf5Source
