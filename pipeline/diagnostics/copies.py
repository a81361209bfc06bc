"""Test for two logs of one recording: equal windows of raw samples of q, at any offset.

A copy that was resampled, rounded, filtered, or to which noise was added has other samples and is not found.
"""

from collections.abc import Iterator, Sequence
from itertools import combinations

import numpy as np

from ..numerics.arrays import FloatArray
from ..signals.columns import chunks
from ..signals.findings import Finding, Number
from .log_facts import LogSignals

_WINDOW = 64
"""Raw samples that are equal in both logs. Half of them differ from the one before, so chance makes no two equal."""
_KEPT = 128
"""Windows of a log that are kept: those of the least hashes, so that two logs keep the same ones of what they share."""
_FEWEST = 3
"""Equal windows, with one offset in time, from which on a recording is shared: about 3 % of the longer log."""
_FACTOR = np.uint64(0x9E3779B97F4A7C15)
"""Odd, so that it has an inverse modulo 2⁶⁴."""


def sketch(time: FloatArray, q: FloatArray) -> list[tuple[int, float]]:
    """Hashes of windows of raw samples that move, the least `_KEPT` of them, and where each begins [s].

    Parameters
    ----------
    time, q : FloatArray, shape (N,)
        Stamps [s] and raw samples.

    Notes
    -----
    A window's hash is Σ x_j p^j modulo 2⁶⁴ over the bits x of its samples, by differences of one running sum. The sign
    of q adds 2⁶³ times an even number of odd factors, which is nothing: a mirrored copy has the same hashes. Cost: one
    pass over the samples in chunks.
    """
    least: dict[int, float] = {}
    for hashes, stamps in _windows(time, q):
        if hashes.size > 2 * _KEPT:
            low = hashes <= np.partition(hashes, 2 * _KEPT - 1)[2 * _KEPT - 1]
            hashes, stamps = hashes[low], stamps[low]
        for value, stamp in zip(hashes.tolist(), stamps.tolist(), strict=True):
            least.setdefault(value, stamp)
        least = dict(sorted(least.items())[:_KEPT])
    return list(least.items())


def shared_recordings(logs: Sequence[LogSignals]) -> list[tuple[int, int, Finding]]:
    """Every pair of logs that hold one recording, by their places, with a finding on the shared spans."""
    pairs = ((i, k, overlap(logs[i], logs[k])) for i, k in combinations(range(len(logs)), 2))
    return [(i, k, finding) for i, k, finding in pairs if finding is not None]


def overlap(first: LogSignals, second: LogSignals) -> Finding | None:
    """The spans [s] that two logs have in common, in the clock of each; None where too few windows are equal."""
    stamp_of = dict(second.sketch)
    stamps = np.array([(here, stamp_of[value]) for value, here in first.sketch if value in stamp_of])
    if len(stamps) < _FEWEST:
        return None
    (other_start, start), (other_stop, stop) = stamps.min(axis=0).tolist(), stamps.max(axis=0).tolist()
    spans = {"start": start, "stop": stop, "other_start": other_start, "other_stop": other_stop}
    numbers = {name: Number(time, "s") for name, time in spans.items()}
    return Finding("shared_recording", "fair", second.name, first.name, numbers)


def _windows(time: FloatArray, q: FloatArray) -> Iterator[tuple[FloatArray, FloatArray]]:
    """Hashes of the windows that move and are finite, and their first stamps, chunk by chunk."""
    for rows in chunks(q.size, overlap=_WINDOW - 1):
        part = np.ascontiguousarray(q[rows], dtype=np.float64)
        if part.size <= _WINDOW:
            return
        with np.errstate(over="ignore"):
            powers = np.cumprod(np.full(part.size, _FACTOR))
            sums = np.concatenate((np.zeros(1, np.uint64), np.cumsum(part.view(np.uint64) * powers)))
            inverses = np.cumprod(np.full(part.size - _WINDOW + 1, np.uint64(pow(int(_FACTOR), -1, 1 << 64))))
            hashes = (sums[_WINDOW:] - sums[:-_WINDOW]) * inverses
        with np.errstate(invalid="ignore"):
            moves = np.diff(part, prepend=part[0]) != 0.0
        counts = [np.concatenate(([0], np.cumsum(each))) for each in (moves, np.isfinite(part))]
        moving, measured = (each[_WINDOW:] - each[:-_WINDOW] for each in counts)
        usable = (2 * moving > _WINDOW) & (measured == _WINDOW)
        # High bits alone, as the low ones depend on the low bits of the samples, which are often zero; exact in JSON.
        yield hashes[usable] >> np.uint64(16), time[rows][: usable.size][usable]
