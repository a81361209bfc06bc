"""Missing parts of a signal: samples that stand for no value, and times at which only q is known."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from ..errors import DataRefusedError
from ..numerics.arrays import BoolArray, FloatArray
from .columns import ROUNDING, Signal, chunks, column


@dataclass(frozen=True)
class Missing:
    """What is missing.

    Attributes
    ----------
    n, not_finite : int
        Samples, and how many of them are NaN or infinite.
    first : float
        Stamp [s] of the first of these; NaN if there is none.
    before, after : float
        Time [s] for which the displacement is known before the signal's first finite sample, and after its last.
    lasts : float
        Time [s] for which the displacement is known.
    """

    n: int
    not_finite: int
    first: float
    before: float
    after: float
    lasts: float

    @property
    def share(self) -> float:
        """Share of the samples, or of the time of the displacement, whichever is larger."""
        alone = (self.before + self.after) / self.lasts if self.lasts > 0.0 else 0.0
        return max(self.not_finite / self.n, alone)


def missing(q: Signal, beside: Mapping[str, Signal]) -> dict[str, Missing]:
    """What is missing of each signal beside the displacement `q` while that is known.

    Raises
    ------
    DataRefusedError
        No sample of one of them is finite.

    Notes
    -----
    Cost: one pass over stamps and samples of each, in chunks.
    """
    begin, end, _, _ = _extent("q", q)
    absent = {}
    for name, signal in beside.items():
        first, last, count, bad = _extent(name, signal)
        lost = max(0.0, first - begin), max(0.0, end - last)
        absent[name] = Missing(signal[1].size, count, bad, *lost, end - begin)
    return absent


def _extent(name: str, signal: Signal) -> tuple[float, float, int, float]:
    """First and last stamp of a finite sample, the number of samples that are not finite, and their first stamp."""
    time, samples = signal
    low = np.inf
    high = -np.inf
    count = 0
    bad = np.nan
    for rows in chunks(samples.size):
        stamps = time[rows]
        finite = np.isfinite(samples[rows])
        timed = stamps[finite & np.isfinite(stamps)]
        if timed.size:
            low, high = min(low, float(timed.min())), max(high, float(timed.max()))
        if not finite.all():
            count += int(np.count_nonzero(~finite))
            bad = bad if np.isfinite(bad) else float(stamps[np.argmin(finite)])
    if not low <= high:
        raise DataRefusedError(f"{name}: no sample is finite where the time is known")
    return low, high, count, bad


_NINES = [10.0**digits - 1.0 for digits in range(3, 7)]
_WHOLE = [2.0**bits for bits in (15, 16, 31, 32)]
_CODES = np.array([*_NINES[1:], *(-code for code in (*_NINES, *_WHOLE)), *(end - 1.0 for end in _WHOLE)])
"""Codes that recorders write: nines, positive ones from 9999 on, and the ends of whole numbers of 16 and 32 bits."""
_HUGE = 0.999e20
"""No measurement is that large: 9.9E37 of instruments, 9.97E36 of netCDF, 1.8E308."""


def masked(samples: FloatArray, codes: Iterable[float]) -> FloatArray:
    """A column with NaN in place of codes; the column itself without any."""
    if not codes:
        return samples
    parts = (np.where(_is_any(samples[rows], codes), np.nan, samples[rows]) for rows in chunks(samples.size))
    return column(samples.size, parts, np.float64)


def codes_in(
    samples: FloatArray, declared: Sequence[float] | None = None, *, of_time: bool = False
) -> dict[float, int]:
    """The codes for no value in a column, and how many samples each has.

    Parameters
    ----------
    samples : FloatArray, shape (N,)
        In the numbers of the log.
    declared : sequence of float, optional
        Numbers that stand for no value; without them numbers of 1e20 and more, taken as one, and usual codes that lie
        further from the rest than that is wide.
    of_time : bool
        Whether the column is a clock, which may pass by any smaller number.

    Notes
    -----
    Cost: one pass, in chunks.
    """
    wanted = _CODES if declared is None else np.array(declared, dtype=np.float64)
    counts = dict.fromkeys(wanted.tolist(), 0)
    low = np.inf
    high = -np.inf
    largest = 0.0
    huge = 0
    for rows in chunks(samples.size):
        part = samples[rows]
        part = part[np.isfinite(part)]
        beyond = np.abs(part) >= _HUGE
        if declared is None and beyond.any():
            huge += int(np.count_nonzero(beyond))
            largest = max(largest, part[beyond].max(), key=abs)
            part = part[~beyond]
        least = part.min(initial=np.inf)
        most = part.max(initial=-np.inf)
        for code in (c for c in counts if least <= c + ROUNDING * abs(c) and c - ROUNDING * abs(c) <= most):
            at_code = _is_any(part, (code,))
            if at_code.any():
                counts[code] += int(np.count_nonzero(at_code))
                part = part[~at_code]
        low, high = min(low, part.min(initial=np.inf)), max(high, part.max(initial=-np.inf))
    span = high - low
    far = {code: n for code, n in counts.items() if n and (declared is not None or not of_time)}
    if declared is None:
        far = {code: n for code, n in far.items() if span > 0.0 and max(low - code, code - high) > span}
    return far | ({float(largest): huge} if huge else {})


def _is_any(part: FloatArray, codes: Iterable[float]) -> BoolArray:
    is_code = np.zeros(part.size, dtype=np.bool_)
    for code in codes:
        is_code |= np.abs(part) >= _HUGE if abs(code) >= _HUGE else np.abs(part - code) <= ROUNDING * abs(code)
    return is_code


def code_remarks(counts: dict[float, int]) -> list[str]:
    """What to say of the codes in a column."""
    return [
        f"{n} sample{'s' * (n > 1)} of {code:.6g} stand{'s' * (n == 1)} for no value: masked (`missing` in [channels])"
        for code, n in counts.items()
    ]
