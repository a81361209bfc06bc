"""What is noteworthy in a channel, in words with numbers, for a person."""

from dataclasses import dataclass
from typing import Literal

import numpy as np

from ..units.quantity import stamped
from .signal_quality import SignalQuality

_FROZEN_SECONDS = 0.05
_FROZEN_SAMPLES = 20
_SHOWS = 1e-4
"""Share of the range of a signal that a hum is worth a remark from."""
_MUCH = 10.0
"""Times the range of an idle channel by which another one of its unit moves, if the idle one is not driven."""

Clock = Literal["s", "samples", ""]
"""Units of places in a log: seconds, numbers of samples, or a time of which the log states no unit."""


@dataclass(frozen=True)
class Context:
    """What is known of a channel beside its samples.

    Attributes
    ----------
    clock : {"s", "samples", ""}
        Unit of its places.
    driven : bool
        Whether it may be an input: one that is held, or stays at a limit, was commanded so.
    alike : float
        Largest range of another channel of its unit; NaN where there is none.
    """

    clock: Clock = "s"
    driven: bool = False
    alike: float = np.nan


def remarks_on(quality: SignalQuality, context: Context = Context()) -> tuple[str, ...]:
    """What a person should look at."""
    clock = context.clock
    remarks = []
    if quality.not_finite:
        remarks.append(f"{counted(quality.not_finite, 'sample')} not finite{_first(quality.not_finite_at, clock)}")
    if quality.constant:
        return (*remarks, "constant")
    if quality.levels:
        values = [f"{value:.6g}" for value in quality.levels]
        return (*remarks, f"takes {len(values)} values only: {', '.join(values[:-1])} and {values[-1]}")
    if quality.idle:
        undriven = not context.driven or context.alike > _MUCH * quality.span
        remarks.append("nothing but noise: no excitation" if undriven else "white noise, or nothing but noise")
    if not (context.driven and (quality.stepped or quality.ramped)):
        remarks += _stays(quality, clock)
    if quality.spikes:
        remarks.append(f"{counted(quality.spikes, 'single-sample spike')}{_first(quality.spikes_at, clock)}")
    remarks += [
        f"{line.frequency:g} Hz hum {line.above_floor_db:.0f} dB over the spectrum beside it, "
        f"amplitude {line.amplitude:.3g}"
        for line in quality.hum
        if line.stands_out and line.amplitude > _SHOWS * quality.span and clock == "s"
    ]
    return tuple(remarks)


def _stays(quality: SignalQuality, clock: Clock) -> list[str]:
    """Where a signal does not move that might."""
    remarks = []
    for rail, share, value in (
        ("upper", quality.high_rail, quality.usual[1]),
        ("lower", quality.low_rail, quality.usual[0]),
    ):
        if share > 0.0:
            remarks.append(f"{100 * share:.2g} % of the samples stay at the {rail} extreme {value:.6g}: saturated?")
    long = quality.longest_frozen > _FROZEN_SECONDS and quality.frozen_samples >= _FROZEN_SAMPLES
    if clock == "s" and long and not (quality.stepped or quality.rests):
        remarks.append(f"unchanged for {quality.longest_frozen:.3g} s from {stamped(quality.frozen_at)} s on")
    return remarks


def counted(number: int, thing: str) -> str:
    """A number of things."""
    return f"{number} {thing}{'' if number == 1 else 's'}"


def _first(places: tuple[float, ...], clock: Clock) -> str:
    """Where the first one is; nothing where the time itself is not known there."""
    if not places or not np.isfinite(places[0]):
        return ""
    if clock == "s":
        return f", the first at {stamped(places[0])} s"
    place = f"{places[0]:.6g}"
    return f", the first at {f'sample {place}' if clock == 'samples' else place}"
