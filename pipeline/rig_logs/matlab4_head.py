"""The head of a matrix in a MAT file of version 4, by which such a file is known."""

import struct
from typing import NamedTuple

SIZE = 20
"""Bytes before the name."""
_LONGEST_NAME = 64
_KINDS, _MATRICES = 6, 3


class Head(NamedTuple):
    """Byte order, kind of number and of matrix, its size, whether it is complex, and bytes of its name."""

    order: str
    number: int
    matrix: int
    rows: int
    columns: int
    complex: int
    name: int


def head_at(buffer: "bytes | memoryview", position: int) -> Head | None:
    """The head of a matrix, or None where there is none."""
    if position + SIZE > len(buffer):
        return None
    for order, machine in (("<", 0), (">", 1)):
        kind, rows, columns, imaginary, name = struct.unpack_from(order + "5i", buffer, position)
        known = kind >= 0 and kind // 100 == 10 * machine and kind // 10 % 10 < _KINDS and kind % 10 < _MATRICES
        if known and min(rows, columns) >= 0 and imaginary in (0, 1) and 1 < name <= _LONGEST_NAME:
            return Head(order, kind // 10 % 10, kind % 10, rows, columns, imaginary, name)
    return None


def begins_matlab4(start: bytes) -> bool:
    """Whether a file whose first bytes are these is one: a head, and the name of a variable."""
    head = head_at(start, 0)
    name = b"" if head is None else start[SIZE : SIZE + head.name]
    return name.endswith(b"\0") and name[:-1].decode("latin-1").isidentifier()
