"""Samples that are no measurements: at the ends of the sensor's range, or single ones far off. They are masked."""

from dataclasses import dataclass

import numpy as np

from pipeline.numerics.arrays import BoolArray, FloatArray, Samples
from pipeline.signals.columns import chunks
from pipeline.signals.signal_quality import SignalQuality, spikes_in

_NEAR = 2


@dataclass(frozen=True)
class Trusted:
    """A signal with NaN where it is not to be trusted, read by slices.

    Attributes
    ----------
    samples : Samples
        As measured.
    rails : tuple of float
        Values at which three samples in a row are a sensor at the end of its range.
    noise : float or None
        Noise against which single samples are called spikes; None to keep them.
    """

    samples: Samples
    rails: tuple[float, ...]
    noise: float | None

    @property
    def size(self) -> int:
        """Number of samples."""
        return self.samples.size

    def __getitem__(self, rows: slice, /) -> FloatArray:
        """The samples of a range of rows."""
        if self._nothing:
            return self.samples[rows]
        start, stop, _ = rows.indices(self.size)
        before, after = min(_NEAR, start), min(_NEAR, self.size - stop)
        part = self.samples[start - before : stop + after]
        own = slice(before, before + stop - start)
        left_out: BoolArray = (self._at_rail(part) | self._spikes(part))[own]
        trusted: FloatArray = np.where(left_out, np.nan, part[own])
        return trusted

    def left_out(self) -> tuple[int, int]:
        """Samples left out at the rails, and as spikes. Cost: one pass, none where there is nothing to leave out."""
        rails = spikes = 0
        for rows in chunks(0 if self._nothing else self.size):
            before, after = min(_NEAR, rows.start), min(_NEAR, self.size - rows.stop)
            part = self.samples[rows.start - before : rows.stop + after]
            own = slice(before, before + rows.stop - rows.start)
            at_rail = self._at_rail(part)[own]
            rails += int(np.count_nonzero(at_rail))
            spikes += int(np.count_nonzero(self._spikes(part)[own] & ~at_rail))
        return rails, spikes

    @property
    def _nothing(self) -> bool:
        return not self.rails and self.noise is None

    def _at_rail(self, part: FloatArray) -> BoolArray:
        found = np.zeros(part.size, dtype=np.bool_)
        for rail in self.rails:
            padded = np.concatenate((np.zeros(2, np.bool_), part == rail, np.zeros(2, np.bool_)))
            triple = padded[:-2] & padded[1:-1] & padded[2:]
            found |= triple[:-2] | triple[1:-1] | triple[2:]
        return found

    def _spikes(self, part: FloatArray) -> BoolArray:
        found = np.zeros(part.size, dtype=np.bool_)
        if self.noise is not None and part.size > 2:
            found[1:-1] = spikes_in(part, self.noise)
        return found


def trusted(samples: Samples, quality: SignalQuality, *, rails: bool, spikes: bool) -> Trusted:
    """The signal without what is no measurement.

    Parameters
    ----------
    samples : Samples
        As measured.
    quality : SignalQuality
        Of these samples: says where the rails are and how large the noise is.
    rails, spikes : bool
        What to leave out.
    """
    found = ((quality.smallest, quality.low_rail), (quality.largest, quality.high_rail))
    ends = tuple(end for end, share in found if share > 0.0) if rails and not quality.constant else ()
    return Trusted(samples, ends, quality.noise if spikes and quality.spikes else None)
