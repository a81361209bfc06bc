"""MAT files of version 5 to 7: a lazy, bounds-checked reader in pure Python.

The format: a header of 128 bytes, then data elements, each a tag (type, number of bytes) and its content padded
to 8 bytes; a variable is an element miMATRIX, alone or inside one zlib stream (miCOMPRESSED). MathWorks, MAT-File
Format, version 5 chapter. A parser in C (scipy.io) was seen to die on damaged files, so sizes are checked here
before a byte is used, a compressed variable is never expanded beyond the size that it declares, and samples stay
in the file until someone asks for them. This parser stays beside the guarded child because scipy.io holds a struct as
a whole: 344 MB for five channels of nine million samples, where this one holds a part.

Cost: one pass over the tags of each variable (a struct costs its number of fields); samples are views on the
mapped file or the expanded variable, copied once on conversion. Memory: a part of a channel, whatever their length.
"""

import mmap
import struct
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pipeline.rig_logs.mat_source import MatSource
from pipeline.rig_logs.mat_values import MatArray, MatObject, MatValue
from pipeline.rig_logs.matlab5_expand import TRUNCATED, Buffer, expand
from pipeline.rig_logs.source import CsvOptions, Limits, Source, UnreadableLogError

_HEADER = 128
_MATRIX, _COMPRESSED = 14, 15
_TEXT_CODECS = {1: "latin-1", 2: "latin-1", 4: "utf-16", 16: "utf-8", 17: "utf-16", 18: "utf-32"}
_STORED = {1: "i1", 2: "u1", 3: "i2", 4: "u2", 5: "i4", 6: "u4", 7: "f4", 9: "f8", 12: "i8", 13: "u8"}
_NUMERIC = {
    6: "float64",
    7: "float32",
    8: "int8",
    9: "uint8",
    10: "int16",
    11: "uint16",
    12: "int32",
    13: "uint32",
    14: "int64",
    15: "uint64",
}
_STRUCT, _OBJECT, _CHAR, _OPAQUE = 2, 3, 4, 17
_COMPLEX_FLAG = 0x0800
_NOT_READ = {1: "cell", 5: "sparse array", 16: "function handle"}
_DEEPEST = 16
_MOST_ELEMENTS = 1_000_000


@dataclass(frozen=True)
class _Element:
    """One data element: its type and where its content is."""

    kind: int
    start: int
    size: int
    next: int


@dataclass(frozen=True)
class _Struct:
    """A struct array whose fields have been walked over, not read."""

    fields: tuple[str, ...]
    elements: tuple[dict[str, MatValue], ...]

    @property
    def count(self) -> int:
        """Number of elements."""
        return len(self.elements)

    def get(self, index: int, name: str) -> MatValue:
        """Field `name` of element `index`, or None."""
        return self.elements[index].get(name) if index < len(self.elements) else None


def open_matlab5(path: Path, expansion_limit: int) -> MatSource:
    """List the channels of a MAT v5 file.

    Parameters
    ----------
    path : Path
        The file.
    expansion_limit : int
        Most bytes to which its compressed variables may expand, all together.

    Raises
    ------
    UnreadableLogError
        Truncated or damaged, or a compressed variable declares more than `expansion_limit`.
    """
    with path.open("rb") as file:
        mapped = Buffer(mmap.mmap(file.fileno(), 0, access=mmap.ACCESS_READ))
    whole = mapped.view
    if len(whole) < _HEADER:
        raise UnreadableLogError(TRUNCATED)
    order = "<" if bytes(whole[126:128]) == b"IM" else ">"
    variables: dict[str, MatValue] = {}
    position = _HEADER
    while position < len(whole):
        element = _element(whole, position, len(whole), order)
        buffer, inner = mapped, element
        if element.kind == _COMPRESSED:
            buffer = expand(whole[element.start : element.start + element.size], order, expansion_limit)
            expansion_limit -= len(buffer.view)
            inner = _element(buffer.view, 0, len(buffer.view), order)
        if inner.kind == _MATRIX:
            name, value = _Walker(buffer, order).matrix(inner, 0)
            if name and not name.startswith("__"):  # without a name: the workspace in which objects keep their data
                variables[name] = value
        position = element.next
    return MatSource("v5", variables, path)


def _element(buffer: memoryview, position: int, end: int, order: str) -> _Element:
    """The element at `position`; everything it claims is checked against `end`."""
    if position + 8 > end:
        raise UnreadableLogError(TRUNCATED)
    kind, size = struct.unpack_from(order + "II", buffer, position)
    if kind >> 16:  # small format: the content sits in the second half of the tag
        size, kind = kind >> 16, kind & 0xFFFF
        if size > 4:
            raise UnreadableLogError(TRUNCATED)
        return _Element(kind, position + 4, size, position + 8)
    start = position + 8
    if start + size > end:
        raise UnreadableLogError(TRUNCATED)
    # Compressed elements are not padded; the last padding may be missing.
    following = start + size if kind == _COMPRESSED else start + size + (-size) % 8
    return _Element(kind, start, size, following)


class _Walker:
    """Walks over the elements of one variable."""

    def __init__(self, buffer: Buffer, order: str) -> None:
        self._held, self._buffer = buffer, buffer.view
        self._order = order
        self._left = _MOST_ELEMENTS

    def matrix(self, element: _Element, depth: int) -> tuple[str, MatValue]:
        """Name and value of an element miMATRIX."""
        self._left -= 1
        if depth > _DEEPEST or self._left < 0:
            raise UnreadableLogError("structs are nested too deeply or have too many elements")
        end = element.start + element.size
        if element.size == 0:
            return "", None
        flags = _element(self._buffer, element.start, end, self._order)
        if flags.size < 8:
            raise UnreadableLogError(TRUNCATED)
        word = struct.unpack_from(self._order + "I", self._buffer, flags.start)[0]
        kind = word & 0xFF
        if kind == _OPAQUE:
            return self._opaque(flags.next, end)
        shape = _element(self._buffer, flags.next, end, self._order)
        dims = tuple(int(d) for d in self._numbers(shape))
        label = _element(self._buffer, shape.next, end, self._order)
        name = self._label(label)
        if not dims or min(dims) < 0:
            raise UnreadableLogError(TRUNCATED)
        if kind not in _NUMERIC and kind not in (_STRUCT, _OBJECT, _CHAR):
            return name, MatObject(_NOT_READ.get(kind, "value of an unknown kind"))
        if kind in _NUMERIC and word & _COMPLEX_FLAG:
            return name, MatObject("complex array")
        if kind in _NUMERIC:
            return name, self._array(dims, _NUMERIC[kind], label.next, end)
        if kind == _CHAR:
            return name, self._text(label.next, end)
        if kind == _OBJECT:
            return name, MatObject(self._label(_element(self._buffer, label.next, end, self._order)) or "object")
        return name, self._struct(dims, label.next, end, depth)

    def _opaque(self, position: int, end: int) -> tuple[str, MatValue]:
        """Name and class of an object: three texts, the second of which says what kind of object."""
        texts = []
        for _ in range(3):
            element = _element(self._buffer, position, end, self._order)
            texts.append(self._label(element))
            position = element.next
        return texts[0], MatObject(texts[2] or "object")

    def _label(self, element: _Element) -> str:
        """The name of a variable or a class."""
        content = bytes(self._buffer[element.start : element.start + element.size])
        return content.decode("utf-8", "replace").rstrip("\0")

    def _numbers(self, element: _Element) -> NDArray[np.generic]:
        stored = _STORED.get(element.kind)
        if stored is None:
            raise UnreadableLogError(TRUNCATED)
        dtype = np.dtype(self._order + stored)
        return np.frombuffer(self._buffer, dtype, element.size // dtype.itemsize, element.start)

    def _array(self, dims: tuple[int, ...], dtype: str, position: int, end: int) -> MatArray:
        data = _element(self._buffer, position, end, self._order)
        stored = _STORED.get(data.kind)

        def read(start: int, stop: int) -> NDArray[Any]:
            """These numbers, mapped from the file anew."""
            self._held.let_go()
            return self._numbers(data)[start:stop].astype(dtype, copy=False)

        value = MatArray(dims, dtype, read)
        if stored is None or value.size * np.dtype(stored).itemsize != data.size:
            raise UnreadableLogError(TRUNCATED)
        return value

    def _text(self, position: int, end: int) -> str:
        if position >= end:
            return ""
        data = _element(self._buffer, position, end, self._order)
        codec = _TEXT_CODECS.get(data.kind, "latin-1")
        if codec in ("utf-16", "utf-32"):
            codec += "-le" if self._order == "<" else "-be"
        return bytes(self._buffer[data.start : data.start + data.size]).decode(codec, "replace").rstrip("\0")

    def _struct(self, dims: tuple[int, ...], position: int, end: int, depth: int) -> MatValue:
        length = _element(self._buffer, position, end, self._order)
        if length.size < 4:
            raise UnreadableLogError(TRUNCATED)
        width = struct.unpack_from(self._order + "i", self._buffer, length.start)[0]
        names = _element(self._buffer, length.next, end, self._order)
        raw = bytes(self._buffer[names.start : names.start + names.size])
        if width <= 0 or names.size % width:
            raise UnreadableLogError(TRUNCATED)
        fields = tuple(raw[i : i + width].split(b"\0")[0].decode("utf-8", "replace") for i in range(0, len(raw), width))
        count = int(np.prod(dims, dtype=np.float64))
        if count * len(fields) * 8 > end - names.next:
            raise UnreadableLogError(TRUNCATED)
        position = names.next
        elements = []
        for _ in range(count):
            values: dict[str, MatValue] = {}
            for field in fields:
                inner = _element(self._buffer, position, end, self._order)
                values[field] = self.matrix(inner, depth + 1)[1] if inner.kind == _MATRIX else None
                position = inner.next
            elements.append(values)
        return _Struct(fields, tuple(elements))


def open_log(path: Path, csv: CsvOptions, limits: Limits) -> Source:
    """The log as `pipeline.rig_logs.child` opens it."""
    return open_matlab5(path, limits.largest(path.stat().st_size))
