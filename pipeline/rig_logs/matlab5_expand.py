"""Compressed variables of MAT files of version 5: expanded block by block, large ones into a temporary file."""

import mmap
import struct
import tempfile
import zlib
from collections.abc import Iterator
from contextlib import suppress

from pipeline.rig_logs.source import UnreadableLogError

TRUNCATED = "the file is truncated or damaged"
_BLOCK = 1 << 20
_IN_MEMORY = 1 << 24
_TAG = 8


class Buffer:
    """Bytes of a file or of an expanded variable.

    Attributes
    ----------
    view : memoryview
    """

    def __init__(self, content: bytes | mmap.mmap) -> None:
        self.view = memoryview(content)
        self._mapped = content if isinstance(content, mmap.mmap) else None

    def let_go(self) -> None:
        """Give back the memory of the pages that were read; they come back from the file when they are needed."""
        if self._mapped is not None:
            with suppress(OSError):  # it is an advice
                self._mapped.madvise(mmap.MADV_DONTNEED)


def expand(packed: memoryview, order: str, limit: int) -> Buffer:
    """Expand one compressed variable to exactly the size that its own tag declares.

    Parameters
    ----------
    packed : memoryview
        The zlib stream.
    order : str
        Byte order, "<" or ">".
    limit : int
        Most bytes that it may declare.

    Raises
    ------
    UnreadableLogError
        Damaged, truncated, or beyond the limit.

    Notes
    -----
    Memory: a block, or the variable where it has up to 16 MB; the temporary file takes as much as the variable.
    """
    blocks = _blocks(packed)
    start = next(blocks, b"")
    if len(start) < _TAG:
        raise UnreadableLogError(TRUNCATED)
    size = _TAG + struct.unpack_from(order + "II", start)[1]
    if size > limit:
        raise UnreadableLogError(
            f"a compressed variable of {len(packed) / 1e6:.3g} MB declares {size / 1e6:.0f} MB, "
            f"beyond the limit of {limit / 1e6:.0f} MB; refused unread"
        )
    if size <= _IN_MEMORY:
        return Buffer(b"".join(_exactly(size, start, blocks)))
    try:
        with tempfile.TemporaryFile(prefix="debist-") as file:
            file.writelines(_exactly(size, start, blocks))
            file.flush()
            return Buffer(mmap.mmap(file.fileno(), size, access=mmap.ACCESS_READ))
    except OSError as error:
        raise UnreadableLogError(
            f"the temporary folder does not take the {size / 1e6:.0f} MB of a compressed variable ({error.strerror}); "
            "set TMPDIR"
        ) from error


def _exactly(size: int, start: bytes, blocks: Iterator[bytes]) -> Iterator[bytes]:
    """All blocks, which must have that size together; a stream that holds more is not expanded to its end."""
    left = size - len(start)
    yield start
    for block in blocks:
        left -= len(block)
        if left < 0:
            break
        yield block
    if left:
        raise UnreadableLogError(TRUNCATED)


def _blocks(packed: memoryview) -> Iterator[bytes]:
    """What the stream holds, up to its end, where its checksum is checked."""
    inflater = zlib.decompressobj()
    try:
        for first in range(0, len(packed), _BLOCK):
            waiting: bytes | memoryview = packed[first : first + _BLOCK]
            while waiting and not inflater.eof:
                block = inflater.decompress(waiting, _BLOCK)
                waiting = inflater.unconsumed_tail
                if block:
                    yield block
        while not inflater.eof and (block := inflater.decompress(b"", _BLOCK)):
            yield block
    except zlib.error as error:
        raise UnreadableLogError(f"a compressed variable is damaged ({error})") from error
    if not inflater.eof:
        raise UnreadableLogError(TRUNCATED)
