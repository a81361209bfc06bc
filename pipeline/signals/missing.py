"""What a log lacks of a signal beside the displacement: samples that are none, and times at which only q is known."""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from pipeline.errors import DataRefusedError
from pipeline.signals.columns import Signal, chunks


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
    found = {}
    for name, signal in beside.items():
        first, last, count, bad = _extent(name, signal)
        lost = max(0.0, first - begin), max(0.0, end - last)
        found[name] = Missing(signal[1].size, count, bad, *lost, end - begin)
    return found


def _extent(name: str, signal: Signal) -> tuple[float, float, int, float]:
    """First and last stamp of a finite sample, the number of samples that are not finite, and their first stamp."""
    time, samples = signal
    low, high, count, bad = np.inf, -np.inf, 0, np.nan
    for rows in chunks(samples.size):
        stamps, finite = time[rows], np.isfinite(samples[rows])
        known = stamps[finite & np.isfinite(stamps)]
        if known.size:
            low, high = min(low, float(known.min())), max(high, float(known.max()))
        if not finite.all():
            count += int(np.count_nonzero(~finite))
            bad = bad if np.isfinite(bad) else float(stamps[np.argmin(finite)])
    if not low <= high:
        raise DataRefusedError(f"{name}: no sample is finite where the time is known")
    return low, high, count, bad
