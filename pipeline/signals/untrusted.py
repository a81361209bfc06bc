"""Samples that are no measurements: at the ends of the sensor's range, while it has lost its target, or single ones
far off. They are masked.
"""

from dataclasses import dataclass, replace

import numpy as np

from pipeline.numerics.arrays import BoolArray, FloatArray, Samples
from pipeline.signals.columns import chunks
from pipeline.signals.signal_quality import SignalQuality, rail_share, spikes_in, three_in_a_row, usual_span

_NEAR = 2
_LOST_FOR = 0.05
"""Time [s] that a sensor stays at the level which says that it lost its target, on average at least."""
_FAR = 0.5
"""Gap between that level and the rest, as a share of the range of the rest."""
_NOISES = 12.0
"""Width of that level in standard deviations of the noise."""
_JUMP = 2
"""Samples that the jumps to it and back may show between the two."""


_UNBOUNDED = (-np.inf, np.inf)


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
        return not self.rails and self.noise is None and self.bounds == _UNBOUNDED

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


def trusted(samples: Samples, quality: SignalQuality, step: float, *, rails: bool, lost: bool, spikes: bool) -> Trusted:
    """The signal without what is no measurement.

    Parameters
    ----------
    samples : Samples
        As measured.
    quality : SignalQuality
        Of these samples: says where the rails are and how large the noise is.
    step : float
        Nominal sampling step [s].
    rails, lost, spikes : bool
        What to leave out.
    """
    bounds = lost_bounds(samples, quality, step) if lost and not quality.constant else _UNBOUNDED
    if bounds != _UNBOUNDED:
        usual = usual_span(samples, *bounds)
        low, high = (rail_share(samples, usual, end) for end in (0, 1))
        quality = replace(quality, usual=usual, low_rail=low, high_rail=high)
    found = zip(quality.usual, (quality.low_rail, quality.high_rail), strict=True)
    ends = tuple(end for end, share in found if share > 0.0) if rails and not quality.constant else ()
    return Trusted(samples, ends, bounds, quality.roughness if spikes and quality.spikes else None, quality)


def lost_bounds(samples: Samples, quality: SignalQuality, step: float) -> tuple[float, float]:
    """Values beyond which q is a level that the sensor shows without a target; infinite where there is none.

    Such a level is constant but for little noise, lies far outside the rest, and is entered by a jump and kept for
    50 ms or more. A device that moves passes through the values between; here hardly a sample has one.

    Parameters
    ----------
    samples : Samples
        As measured.
    quality : SignalQuality
        Of these samples.
    step : float
        Nominal sampling step [s].
    """
    smallest, largest = quality.usual
    width = max(_NOISES * quality.noise, 1e-3 * (largest - smallest))
    high = _bound(samples, largest - width, smallest, step, 1.0)
    low = _bound(samples, -smallest - width, -largest, step, -1.0)
    return (-np.inf if low is None else -low, np.inf if high is None else high)


def _bound(samples: Samples, level: float, smallest: float, step: float, sign: float) -> float | None:
    """The middle of the gap below the level at the top, if the sensor has lost its target there.

    samples are taken times `sign` · level: its lower end · smallest: of all · step: of time [s].
    """
    at_level, runs, before = 0, 0, False
    for rows in chunks(samples.size):
        there = sign * samples[rows] >= level
        runs += int(np.count_nonzero(np.diff(there.astype(np.int8), prepend=np.int8(before)) == 1))
        at_level += int(np.count_nonzero(there))
        before = bool(there[-1])
    if not 3 * runs <= at_level < 0.5 * samples.size or at_level * step < _LOST_FOR * runs:
        return None
    top, jumps = np.empty(0), _JUMP * runs
    for rows in chunks(samples.size):
        part = sign * samples[rows]
        top = np.sort(np.concatenate((top, part[part < level])))[-jumps - 1 :]
    if top.size <= jumps or level - top[0] < _FAR * (top[0] - smallest):
        return None
    return float(0.5 * (level + top[0]))
