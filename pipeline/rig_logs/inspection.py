"""Contents of a raw log: channels, units, rates, gaps, rails, hum, and suggested roles of the channels."""

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from ..errors import DataRefusedError, InputError
from ..numerics.arrays import FloatArray
from ..signals.columns import CHUNK, Signal, codes_in, masked, sparse
from ..signals.findings import MOST_REPEATED
from ..signals.outliers import NONE, Dropouts, dropouts
from ..signals.remarks import Clock, channel_remarks, code_remarks, dropout_texts
from ..signals.rounded_clock import uniform_clock
from ..signals.signal_quality import SignalQuality, examine_signal
from ..signals.timebase import TimeQuality, examine
from ..system.names import shell_word
from ..units.quantity import counted, stamped
from ..units.units import SECONDS
from .attributes import note_on_rate, stated_rate
from .channel_roles import Suggestion, is_called, suggest, suggested_unit
from .guarded import RecordedChannel, Recording, read_recording
from .source import CsvOptions

_UNEVEN = 0.5
_MOSTLY = 0.95
"""Share of a step by which those of a clock may differ, and how many of them do not by more."""

_SERIAL_DATES = ((35_000.0, 60_000.0), (725_000.0, 750_000.0))
"""Days since 1900 and since the year 0, of the years 1995 to 2053."""

_WRITTEN_DATES = 1.95e13, 2.1e13

_FAR_SHORTER = 10
"""Times as many samples has the longest channel as a parameter, which is no record."""

NO_CHANNEL = "the log holds no vector of numbers"
"""Message where nothing can be drafted or examined."""


@dataclass(frozen=True)
class InspectedChannel:
    """One channel.

    Attributes
    ----------
    name, unit, dtype : str
        As the log states it.
    time_base : int or None
        Position of its time base in `Inspection.time_bases`; None where none could be found.
    quality : SignalQuality
        In the numbers of the log, times in s.
    remarks : tuple of str
        Remarks, in words with numbers.
    codes : tuple of float
        Numbers that seem to stand for no value; they are left out of `quality`.
    every : int
        Rows from one sample to the next, where blanks stand between.
    description : str
        Text of the log beside it.
    """

    name: str
    unit: str
    dtype: str
    time_base: int | None
    quality: SignalQuality
    remarks: tuple[str, ...]
    codes: tuple[float, ...] = ()
    every: int = 1
    description: str = ""


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
        True if the format carries its own time base.
    time_bases : tuple of TimeQuality
        The different time bases, in s.
    channels : tuple of InspectedChannel
        Every numeric channel.
    suggestions : tuple of Suggestion
        Possible roles of the channels; nothing decides on them.
    apart : tuple of str
        Channels for which no role is suggested, as they are not of the same record as the others.
    rates : mapping of str to float
        Sample rates [Hz] that numbers in the log state, by their names; nothing decides on them.
    notes : tuple of str
        Findings and assumptions of the reader.
    heading : str
        Text of the log above or beside all channels.
    """

    path: Path
    format: str
    size: int
    own_time: bool
    time_bases: tuple[TimeQuality, ...]
    channels: tuple[InspectedChannel, ...]
    suggestions: tuple[Suggestion, ...]
    apart: tuple[str, ...]
    rates: Mapping[str, float]
    notes: tuple[str, ...]
    heading: str = ""


def inspect_log(path: Path, *, csv: CsvOptions | None = None) -> Inspection:
    """Read a whole log and describe it.

    Raises
    ------
    InputError
        As `read_recording`, or it is a settings file.

    Notes
    -----
    Cost: the reading, and some ten passes over each channel (about 0.1 s per million samples).
    """
    if path.suffix.lower() == ".toml":
        raise InputError(
            f"{path}: is a settings file; `debist check {shell_word(path)}` looks at the logs that it names"
        )
    recording, codes = _without_codes(read_recording(path, csv=csv))
    own_time = any(channel.time is not None for channel in recording.channels)
    notes = [*recording.notes, *recording.warnings]
    rates = {} if own_time else dict(recording.rates) | _constant_rates(recording.channels, notes)
    roles, apart = _roles(recording, rates, own_time=own_time)
    column, clock = (None, "s") if own_time else _time_column(recording.channels, roles, notes)
    bases, examined = _examined(recording.channels, column, clock, notes)
    driving = {role.role: role.candidates for role in roles}
    channels = []
    for channel, position, quality, own_clock in examined:
        alike = [seen.span for other, _, seen, _ in examined if other.unit == channel.unit and other is not channel]
        driven = channel.name in (*driving["v1"], *driving["v2"])
        own = codes.get(channel.name, {})
        remarks = tuple(
            remark.text
            for remark in (
                *code_remarks(own),
                *channel_remarks(quality, own_clock, driven=driven, alike=max(alike, default=np.nan)),
            )
        )
        time = column if channel.time is None else channel.time
        if position is not None and time is not None and channel.name in driving["q"]:
            lost, quality = _without_dropouts(Signal(time, channel.samples), quality, bases[position].step)
            remarks += tuple(text for text, _ in dropout_texts(lost, unit=channel.unit))
        remarks = () if own_time and channel.time is None else remarks
        channels.append(
            InspectedChannel(
                name=channel.name,
                unit=channel.unit,
                dtype=channel.dtype,
                time_base=position,
                quality=quality,
                remarks=remarks,
                codes=tuple(own),
                every=sparse(Signal(channel.samples, channel.samples))[1],
                description=recording.descriptions.get(channel.name, ""),
            )
        )
    return Inspection(
        path=path,
        format=recording.format,
        size=path.stat().st_size,
        own_time=own_time,
        time_bases=tuple(bases),
        channels=tuple(channels),
        suggestions=roles,
        apart=apart,
        rates=rates,
        notes=tuple(notes),
        heading=recording.heading,
    )


def _examined(
    recorded: Sequence[RecordedChannel], column: FloatArray | None, clock: Clock, notes: list[str]
) -> tuple[list[TimeQuality], list[tuple[RecordedChannel, int | None, SignalQuality, Clock]]]:
    """The time bases, own ones or the log's `column`; each channel with the place of its base, quality and clock."""
    stamps: list[FloatArray] = []
    bases: list[TimeQuality] = []
    examined: list[tuple[RecordedChannel, int | None, SignalQuality, Clock]] = []
    for channel in recorded:
        time = column if channel.time is None else channel.time
        position = _time_base(time, stamps, bases, notes) if time is not None else None
        if time is not None and position is not None and time.size == channel.samples.size:
            examined.append((channel, position, examine_signal(time, channel.samples, bases[position].step), clock))
        else:  # a time base itself, or a channel without one: located by sample number
            numbers = np.arange(channel.samples.size, dtype=np.float64)
            examined.append((channel, None, examine_signal(numbers, channel.samples, 1.0), "samples"))
    return bases, examined


def _without_dropouts(signal: Signal, quality: SignalQuality, step: float) -> tuple[Dropouts, SignalQuality]:
    """Samples of a channel that no motion reaches, and how fast it moves without them."""
    lost = NONE if quality.levels else dropouts(signal, (), quality, step)
    if not lost.spans.size:
        return lost, quality
    samples = signal.samples.copy()
    for first, end in lost.spans:
        samples[first:end] = np.nan
    return lost, replace(quality, band=examine_signal(signal.time, samples, step).band)


def _without_codes(recording: Recording) -> tuple[Recording, dict[str, dict[float, int]]]:
    """A recording with NaN in place of codes for no value, and the count of each code by channel."""
    codes = {channel.name: codes_in(channel.samples) for channel in recording.channels}
    bases = {id(channel.time): channel.time for channel in recording.channels if channel.time is not None}
    times = {key: masked(base, codes_in(base, of_time=True)) for key, base in bases.items()}
    channels = [
        replace(
            channel,
            samples=masked(channel.samples, codes[channel.name]),
            time=None if channel.time is None else times[id(channel.time)],
        )
        for channel in recording.channels
    ]
    return replace(recording, channels=tuple(channels)), {name: counts for name, counts in codes.items() if counts}


def _constant_rates(channels: Sequence[RecordedChannel], notes: list[str]) -> dict[str, float]:
    """Sample rates [Hz] that columns of one number state (`fs`, `Ts`), which may stand in the first row only."""
    rates = {}
    for channel in channels:
        if stated_rate(channel.name, 1.0) is None:
            continue
        numbers = channel.samples[np.isfinite(channel.samples)]
        number = float(numbers[0]) if numbers.size and np.all(numbers == numbers[0]) else 0.0
        if (rate := stated_rate(channel.name, number)) is not None:
            rates[channel.name] = rate
            notes.append(note_on_rate(channel.name, number, rate))
    return rates


def _roles(
    recording: Recording, rates: Collection[str], *, own_time: bool
) -> tuple[tuple[Suggestion, ...], tuple[str, ...]]:
    """Suggestions for the roles, and the channels that are set apart before."""
    usual = [channel for channel in recording.channels if channel.time is not None or not own_time]
    counts = {} if own_time else {channel.name: channel.samples.size for channel in recording.channels}
    unnamed = [channel for channel in usual if rates and not is_called("time", channel.name)]
    longest = max(counts.values(), default=0)
    left_out = {name for name, count in counts.items() if _FAR_SHORTER * count < longest}
    numbered = (each.name for each in unnamed if each.samples.size > 1 and np.all(np.diff(each.samples[:CHUNK]) == 1.0))
    left_out = left_out.union(rates, numbered)
    offered = [channel for channel in usual if channel.name not in left_out]
    rising = () if own_time else [channel.name for channel in offered if _rises_evenly(channel.samples)]
    roles = suggest(
        [(channel.name, channel.unit) for channel in offered],
        own_time=own_time,
        rising=rising,
        counts=counts,
        described=recording.descriptions,
    )
    time = next((role.only for role in roles if role.role == "time" and role.only is not None), None)
    others = () if time is None else (channel.name for channel in offered if counts[channel.name] != counts[time])
    return roles, (*sorted(left_out & counts.keys()), *others)


def _rises_evenly(samples: FloatArray) -> bool:
    """True if nearly all steps of a column are upwards and about as large, as those of a clock."""
    steps = np.diff(samples[np.isfinite(samples)][:CHUNK])
    usual = float(np.median(steps)) if steps.size > 1 else 0.0
    return usual > 0.0 and bool(np.mean(np.abs(steps - usual) <= _UNEVEN * usual) >= _MOSTLY)


def _time_column(
    channels: Sequence[RecordedChannel], roles: Sequence[Suggestion], notes: list[str]
) -> tuple[FloatArray | None, Clock]:
    """The column that is taken for time in the description, in s, and the unit of places in the log then."""
    name = next((role.only for role in roles if role.role == "time"), None)
    if name is None:
        if channels:
            notes.append("no single column is called time; rates and places are in samples")
        return None, "samples"
    channel = next(c for c in channels if c.name == name)
    unit = suggested_unit(channel.name, channel.unit)
    stated = f"in {unit}" if unit in SECONDS else "in s, of which the log says nothing"
    if unit not in SECONDS and any(first <= np.nanmin(channel.samples) <= last for first, last in _SERIAL_DATES):
        unit = "day"
        stated = "in days, as serial dates of a spreadsheet or MATLAB are"
    elif unit not in SECONDS and _WRITTEN_DATES[0] <= np.nanmin(channel.samples) <= _WRITTEN_DATES[1]:
        stated += ", though its digits look like a date (20260131235959.5): export seconds"
    notes.append(f"described as if {name!r} were time {stated}; the settings decide")
    return channel.samples * SECONDS.get(unit, 1.0), "s" if unit in SECONDS else ""


def _time_base(time: FloatArray, stamps: list[FloatArray], bases: list[TimeQuality], notes: list[str]) -> int | None:
    """Position of the time base among those seen so far; a new one is examined."""
    for position, seen in enumerate(stamps):
        if seen is time:
            return position
    clock = uniform_clock(time)
    if clock is not None:
        notes.append(f"time stamps are {clock.described}")
    try:
        quality = examine(time if clock is None else clock.time)
    except DataRefusedError as error:
        notes.append(str(error))
        return None
    if quality.backward:
        notes.append(
            f"time steps back at {counted(quality.backward, 'place')}, first after {stamped(quality.backward_at[0])} "
            "s: ingest refuses it; see [ingest] time_reversal"
        )
    if quality.repeated > MOST_REPEATED * quality.n:
        notes.append(
            f"{100.0 * quality.repeated / quality.n:.0f} % of the time stamps repeat: too coarse a clock; set "
            "sample_rate in place of time"
        )
    stamps.append(time)
    bases.append(quality)
    return len(bases) - 1
