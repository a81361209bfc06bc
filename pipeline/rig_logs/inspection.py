"""What is in a raw log: channels, units, rates, gaps, rails, hum; and a first settings file for it."""

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from pipeline.errors import DataRefusedError
from pipeline.numerics.arrays import FloatArray
from pipeline.rig_logs.guarded import read_recording
from pipeline.rig_logs.limits import Limits
from pipeline.rig_logs.recording import Channel
from pipeline.rig_logs.source import CsvOptions
from pipeline.rig_logs.suggestions import TIME_UNITS, Suggestion, suggest, suggested_unit
from pipeline.signals.signal_quality import SignalQuality, examine_signal
from pipeline.signals.timebase import TimeQuality, examine

_HUM_DB = 10.0
_RAIL_SHARE = 1e-3
_FROZEN_SECONDS = 0.05


@dataclass(frozen=True)
class InspectedChannel:
    """One channel.

    Attributes
    ----------
    name, unit, dtype : str
        As the log says.
    time_base : int or None
        Position of its time base in `Inspection.time_bases`; None where none could be found.
    quality : SignalQuality
        In the numbers of the log, times in s.
    remarks : tuple of str
        What is noteworthy, in words with numbers.
    """

    name: str
    unit: str
    dtype: str
    time_base: int | None
    quality: SignalQuality
    remarks: tuple[str, ...]


@dataclass(frozen=True)
class Inspection:
    """A raw log, described.

    Attributes
    ----------
    path : Path
        The log.
    format : str
        Its format in words.
    size : int
        Bytes of the file.
    own_time : bool
        Whether the format carries its own time base.
    time_bases : tuple of TimeQuality
        The different time bases, in s.
    channels : tuple of InspectedChannel
        Every numeric channel.
    suggestions : tuple of Suggestion
        Which channel might be what; nothing decides on them.
    notes : tuple of str
        What the reader found out or had to assume.
    """

    path: Path
    format: str
    size: int
    own_time: bool
    time_bases: tuple[TimeQuality, ...]
    channels: tuple[InspectedChannel, ...]
    suggestions: tuple[Suggestion, ...]
    notes: tuple[str, ...]


def inspect_log(path: Path, *, csv: CsvOptions | None = None, limits: Limits | None = None) -> Inspection:
    """Read a whole log and describe it.

    Raises
    ------
    InputError
        As `read_recording`.

    Notes
    -----
    Cost: the reading, and some ten passes over each channel (about 0.1 s per million samples).
    """
    recording = read_recording(path, csv=csv, limits=limits)
    own_time = any(channel.time is not None for channel in recording.channels)
    roles = suggest(
        [(c.name, c.unit) for c in recording.channels if c.time is not None or not own_time], own_time=own_time
    )
    notes = list(recording.notes)
    column = None if own_time else _time_column(recording.channels, roles, notes)
    stamps: list[FloatArray] = []
    bases: list[TimeQuality] = []
    channels = []
    for channel in recording.channels:
        time = column if channel.time is None and not own_time else channel.time
        position = _time_base(time, stamps, bases, notes) if time is not None else None
        if time is not None and position is not None and time.size == channel.samples.size:
            quality = examine_signal(time, channel.samples, bases[position].step)
            remarks = remarks_on(quality)
        else:  # a time base itself, or a channel without one: located by sample number
            position = None
            quality = examine_signal(np.arange(channel.samples.size, dtype=np.float64), channel.samples, 1.0)
            remarks = ()
        channels.append(InspectedChannel(channel.name, channel.unit, channel.dtype, position, quality, remarks))
    size = path.stat().st_size
    return Inspection(path, recording.format, size, own_time, tuple(bases), tuple(channels), roles, tuple(notes))


def _time_column(
    channels: Sequence[Channel[FloatArray]], roles: Sequence[Suggestion], notes: list[str]
) -> FloatArray | None:
    """The column that is taken for time in the description, in s."""
    name = next((role.only for role in roles if role.role == "time"), None)
    if name is None:
        notes.append("no single column is called time; rates and places are in samples")
        return None
    channel = next(c for c in channels if c.name == name)
    unit = suggested_unit(channel.name, channel.unit)
    notes.append(f"described as if {name!r} were time in {unit or 's'}; the settings decide")
    return channel.samples * TIME_UNITS.get(unit, 1.0)


def _time_base(time: FloatArray, stamps: list[FloatArray], bases: list[TimeQuality], notes: list[str]) -> int | None:
    """Position of the time base among those seen so far; a new one is examined."""
    for position, known in enumerate(stamps):
        if known is time:
            return position
    try:
        quality = examine(time)
    except DataRefusedError as error:
        notes.append(str(error))
        return None
    stamps.append(time)
    bases.append(quality)
    return len(bases) - 1


def remarks_on(quality: SignalQuality) -> tuple[str, ...]:
    """What a person should look at."""
    remarks = []
    if quality.not_finite:
        remarks.append(f"{counted(quality.not_finite, 'sample')} not finite{_first(quality.not_finite_at)}")
    if quality.constant:
        return (*remarks, "constant")
    if quality.idle:
        remarks.append("nothing but noise: no excitation")
    for rail, share, value in (
        ("upper", quality.high_rail, quality.largest),
        ("lower", quality.low_rail, quality.smallest),
    ):
        if share > _RAIL_SHARE:
            remarks.append(f"{100 * share:.2g} % of the samples stay at the {rail} extreme {value:.6g}: saturated?")
    if quality.longest_frozen > _FROZEN_SECONDS:
        remarks.append(f"unchanged for {quality.longest_frozen:.3g} s from {quality.frozen_at:.6g} s on")
    if quality.spikes:
        remarks.append(f"{counted(quality.spikes, 'single-sample spike')}{_first(quality.spikes_at)}")
    remarks += [
        f"{line.frequency:g} Hz hum {line.above_floor_db:.0f} dB over the spectrum beside it, "
        f"amplitude {line.amplitude:.3g}"
        for line in quality.hum
        if line.above_floor_db > _HUM_DB
    ]
    return tuple(remarks)


def counted(number: int, thing: str) -> str:
    """A number of things."""
    return f"{number} {thing}{'' if number == 1 else 's'}"


def _first(places: tuple[float, ...]) -> str:
    """Where the first one is; nothing where the time itself is not known there."""
    return f", the first at {places[0]:.6g} s" if places and np.isfinite(places[0]) else ""
