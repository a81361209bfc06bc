"""Samples for the page's viewer: quantised, differenced, deflated, in base 64; what is too long by its extremes.

A series of n samples is cut to 16 bits of its own range (a 30 mm stroke in steps of 0.5 µm), stored as differences in
two byte planes. A quiet 1 ms record takes about half a byte a sample.
"""

import base64
import zlib
from typing import Any

import numpy as np

from pipeline.numerics.arrays import FloatArray

LEVELS = 65534  # codes 0 … 65534; 65535 says that there is no sample
MISSING = 65535
LEVEL = 6  # of deflate; 9 takes ten times as long and saves 0.5 %
LONGEST = 60_000  # samples a series may have before it is stored by the extremes of its buckets


def packed(y: FloatArray, longest: int = LONGEST) -> dict[str, Any]:
    """A series as JSON values.

    Parameters
    ----------
    y : FloatArray, shape (n,)
        Samples; NaN where there is none.
    longest : int
        Number of samples beyond which the least and the largest of every bucket are kept instead.

    Returns
    -------
    dict
        ``n`` samples (or buckets), ``count`` samples to a bucket, ``low`` and ``step`` of the quantisation, ``data``
        and, for buckets, ``high_data``.
    """
    if y.size <= longest:
        return _quantised([y]) | {"count": 1}
    count = -(-y.size // (longest // 2))
    edges = np.arange(0, y.size, count)
    finite = np.isfinite(y)
    low = np.minimum.reduceat(np.where(finite, y, np.inf), edges)
    high = np.maximum.reduceat(np.where(finite, y, -np.inf), edges)
    low[~np.isfinite(low)], high[~np.isfinite(high)] = np.nan, np.nan
    return _quantised([low, high]) | {"count": count}


def unpacked(series: dict[str, Any], key: str = "data") -> FloatArray:
    """The samples back, as the viewer does it; within half a step of the original."""
    planes = np.frombuffer(zlib.decompress(base64.b64decode(series[key])), dtype=np.uint8)
    n = series["n"]
    codes = np.cumsum(planes[:n].astype(np.int64) + 256 * planes[n:].astype(np.int64)) % 65536
    return np.where(codes == MISSING, np.nan, series["low"] + series["step"] * codes)


def _quantised(parts: list[FloatArray]) -> dict[str, Any]:
    finite = np.concatenate([part[np.isfinite(part)] for part in parts])
    low, high = (float(finite.min()), float(finite.max())) if finite.size else (0.0, 0.0)
    step = (high - low) / LEVELS or 1.0
    result: dict[str, Any] = {"n": int(parts[0].size), "low": low, "step": step}
    for key, part in zip(("data", "high_data"), parts, strict=False):
        known = np.isfinite(part)
        codes = np.full(part.size, MISSING, dtype=np.int64)
        codes[known] = np.rint((part[known] - low) / step)
        change = np.diff(codes, prepend=0) % 65536
        planes = np.concatenate((change & 255, change >> 8)).astype(np.uint8)
        result[key] = base64.b64encode(_deflated(planes.tobytes())).decode("ascii")
    return result


def _deflated(data: bytes) -> bytes:
    """Deflated for repetitions or for noise, whichever is shorter."""
    return min((_deflate(data, kind) for kind in (zlib.Z_DEFAULT_STRATEGY, zlib.Z_FILTERED)), key=len)


def _deflate(data: bytes, strategy: int) -> bytes:
    packer = zlib.compressobj(LEVEL, zlib.DEFLATED, zlib.MAX_WBITS, zlib.DEF_MEM_LEVEL, strategy)
    return packer.compress(data) + packer.flush()
