"""MAT files of version 4, as many real-time targets write them: a lazy, bounds-checked reader in pure Python.

The format: matrices one after the other, each five numbers of four bytes (type, rows, columns, whether complex, length
of the name), the name and the samples, column by column. The type's digits are M O P T: byte order, 0, kind of number,
kind of matrix (full, text, sparse). MathWorks, MAT-File Format, appendix on level 4.

Cost: one pass over the heads; samples stay in the mapped file until someone asks for them.
"""

import mmap
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pipeline.rig_logs.mat_source import MatSource
from pipeline.rig_logs.mat_values import MatArray, MatValue
from pipeline.rig_logs.matlab4_head import SIZE, Head, head_at
from pipeline.rig_logs.matlab5_expand import TRUNCATED
from pipeline.rig_logs.source import CsvOptions, Limits, Source, UnreadableLogError

_STORED = ("f8", "f4", "i4", "i2", "u2", "u1")
_DTYPES = ("float64", "float32", "int32", "int16", "uint16", "uint8")


def open_matlab4(path: Path) -> MatSource:
    """List the channels of a MAT v4 file.

    Raises
    ------
    UnreadableLogError
        Truncated or damaged.
    """
    with path.open("rb") as file:
        whole = memoryview(mmap.mmap(file.fileno(), 0, access=mmap.ACCESS_READ))
    variables: dict[str, MatValue] = {}
    position = 0
    while position < len(whole):
        head = head_at(whole, position)
        if head is None:
            raise UnreadableLogError(TRUNCATED)
        first = position + SIZE + head.name
        size = np.dtype(_STORED[head.number]).itemsize * head.rows * head.columns
        position = first + size * (1 + head.complex)
        if position > len(whole):
            raise UnreadableLogError(TRUNCATED)
        name = bytes(whole[first - head.name : first]).split(b"\0")[0].decode("latin-1")
        if head.matrix == 0 and not head.complex:
            variables[name] = _array(whole[first : first + size], head)
    return MatSource("v4", variables)


def _array(samples: memoryview, head: Head) -> MatArray:
    stored = np.dtype(head.order + _STORED[head.number])

    def read(first: int, last: int) -> NDArray[Any]:
        """Samples in column-major order."""
        return np.frombuffer(samples[first * stored.itemsize : last * stored.itemsize], dtype=stored)

    return MatArray((head.rows, head.columns), _DTYPES[head.number], read)


def open_log(path: Path, csv: CsvOptions, limits: Limits) -> Source:
    """The log as `pipeline.rig_logs.child` opens it."""
    return open_matlab4(path)
