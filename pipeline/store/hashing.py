"""Two hashes for every artifact: of its content, which decides, and of its bytes, which finds bit rot.

The content hash is logical: SHA-256 per column over canonical little-endian values (one NaN, one zero),
then over the sorted (name, dtype, unit, length, digest). It does not depend on codec, row groups or the
version of a library.
"""

import hashlib
import json
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from ..system.plain_files import open_plain

_BLOCK = 1 << 20


def file_sha256(path: Path) -> str:
    """SHA-256 of a regular file's bytes; OSError for any other."""
    with open_plain(path) as stream:
        return hashlib.file_digest(stream, "sha256").hexdigest()


def json_sha256(document: Any) -> str:
    """SHA-256 of a JSON document in canonical form (sorted keys, no blanks)."""
    text = json.dumps(document, sort_keys=True, separators=(",", ":"), ensure_ascii=False, allow_nan=False)
    return hashlib.sha256(text.encode()).hexdigest()


class ColumnDigest:
    """SHA-256 of one column's canonical values, taken part by part; how it is cut into parts makes no difference.

    Floats are hashed as little-endian float64 with one NaN and one zero, integers and booleans as int64,
    text as length-prefixed UTF-8.
    """

    def __init__(self, values: Any = ()) -> None:
        self._digest = hashlib.sha256()
        self.length = 0
        """Number of values."""
        self.update(values)

    def update(self, values: np.ndarray[Any, Any]) -> None:
        """Append values; memory is bounded by one block."""
        flat = np.asarray(values).reshape(-1)
        for start in range(0, len(flat), _BLOCK):
            self._digest.update(_canonical(flat[start : start + _BLOCK]))
        self.length += len(flat)

    def hexdigest(self) -> str:
        """The digest of all values so far."""
        return self._digest.hexdigest()


def _canonical(block: np.ndarray[Any, Any]) -> bytes:
    if block.dtype.kind == "f":
        canonical = block.astype("<f8") + 0.0  # -0.0 + 0.0 is 0.0
        canonical[np.isnan(canonical)] = np.nan
        return canonical.tobytes()
    if block.dtype.kind in "iub":
        return block.astype("<i8").tobytes()
    encoded = [str(text).encode() for text in block.tolist()]
    return b"".join(len(text).to_bytes(8, "little") + text for text in encoded)


def table_hash(columns: Iterable[tuple[str, str, str, np.ndarray[Any, Any]]]) -> str:
    """Content hash of a table from its columns (name, dtype, unit, values)."""
    return digests_hash(
        (name, dtype, unit, np.shape(values), ColumnDigest(values).hexdigest()) for name, dtype, unit, values in columns
    )


def digests_hash(columns: Iterable[tuple[str, str, str, Sequence[int], str]]) -> str:
    """Content hash of a table from its columns' digests (name, dtype, unit, shape, digest)."""
    return json_sha256(sorted([name, dtype, unit, list(shape), digest] for name, dtype, unit, shape, digest in columns))


def tree_hash(tree: Mapping[str, Any]) -> str:
    """Content hash of a tree of arrays, numbers and texts (an HDF5 file)."""
    return table_hash((path, np.asarray(value).dtype.kind, "", np.asarray(value)) for path, value in flatten(tree))


def flatten(tree: Mapping[str, Any], prefix: str = "", separator: str = "/") -> Iterable[tuple[str, Any]]:
    """The leaves of a nested mapping with their paths; a list of mappings is read as one by position."""
    for key, value in tree.items():
        if isinstance(value, Mapping):
            yield from flatten(value, f"{prefix}{key}{separator}", separator)
        elif isinstance(value, list | tuple) and any(isinstance(entry, Mapping) for entry in value):
            yield from flatten({str(k): entry for k, entry in enumerate(value)}, f"{prefix}{key}{separator}", separator)
        else:
            yield f"{prefix}{key}", value
