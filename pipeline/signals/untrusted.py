"""Samples that are no measurements: at the ends of the sensor's range, while it has lost its target, or single ones
far off. They are masked.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from pipeline.numerics.arrays import BoolArray, FloatArray, Samples
from pipeline.signals.columns import Signal, chunks
from pipeline.signals.lost_target import UNBOUNDED, lost_bounds
from pipeline.signals.signal_quality import SignalQuality, rail_share, spikes_in, three_in_a_row, usual_span

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
    bounds : (float, float)
        Values beyond which the sensor has lost its target.
    noise : float or None
        Noise against which single samples are called spikes; None to keep them.
    quality : SignalQuality
        Of the samples, its rails those between the bounds.
    """

    samples: Samples
    rails: tuple[float, ...]
    bounds: tuple[float, float]
    noise: float | None
    quality: SignalQuality

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
        left_out: BoolArray = (self._at_rail(part) | self._lost(part) | self._spikes(part))[own]
        trusted: FloatArray = np.where(left_out, np.nan, part[own])
        return trusted

    def left_out(self) -> tuple[int, int, int]:
        """Samples left out at the rails, without a target, and as spikes.

        Cost: one pass, none where there is nothing to leave out.
        """
        rails = lost = spikes = 0
        for rows in chunks(0 if self._nothing else self.size):
            before, after = min(_NEAR, rows.start), min(_NEAR, self.size - rows.stop)
            part = self.samples[rows.start - before : rows.stop + after]
            own = slice(before, before + rows.stop - rows.start)
            missed = self._lost(part)[own]
            at_rail = self._at_rail(part)[own] & ~missed
            rails += int(np.count_nonzero(at_rail))
            lost += int(np.count_nonzero(missed))
            spikes += int(np.count_nonzero(self._spikes(part)[own] & ~at_rail & ~missed))
        return rails, lost, spikes

    @property
    def _nothing(self) -> bool:
        return not self.rails and self.noise is None and self.bounds == UNBOUNDED

    def _lost(self, part: FloatArray) -> BoolArray:
        found: BoolArray = (part < self.bounds[0]) | (part > self.bounds[1])
        return found

    def _at_rail(self, part: FloatArray) -> BoolArray:
        found = np.zeros(part.size, dtype=np.bool_)
        for rail in self.rails:
            found |= three_in_a_row(np.pad(part == rail, 2))
        return found

    def _spikes(self, part: FloatArray) -> BoolArray:
        found = np.zeros(part.size, dtype=np.bool_)
        if self.noise is not None and part.size > 2:
            found[1:-1] = spikes_in(part, self.noise)
        return found


def trusted(
    q: Signal, inputs: Sequence[Signal], quality: SignalQuality, step: float, *, rails: bool, lost: bool, spikes: bool
) -> Trusted:
    """The signal without what is no measurement.

    Parameters
    ----------
    q : (Samples, Samples)
        Time stamps [s] and samples as measured.
    inputs : sequence of (Samples, Samples)
        The same of what drives the device; their steps tell a place of the device from a sensor's lost target.
    quality : SignalQuality
        Of these samples: says where the rails are and how large the noise is.
    step : float
        Nominal sampling step [s].
    rails, lost, spikes : bool
        What to leave out.
    """
    samples = q[1]
    bounds = lost_bounds(q, inputs, quality, step) if lost and not quality.constant else UNBOUNDED
    if bounds != UNBOUNDED:
        usual = usual_span(samples, *bounds)
        low, high = (rail_share(samples, usual, end) for end in (0, 1))
        quality = replace(quality, usual=usual, low_rail=low, high_rail=high)
    found = zip(quality.usual, (quality.low_rail, quality.high_rail), strict=True)
    ends = tuple(end for end, share in found if share > 0.0) if rails and not quality.constant else ()
    return Trusted(samples, ends, bounds, quality.roughness if spikes and quality.spikes else None, quality)
