"""What is in a raw log: channels, units, rates, gaps, rails, hum; and which channel might be what.

Suggestions are for a person; nothing decides on them.
"""

import re
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

import numpy as np

from pipeline.errors import DataRefusedError, InputError
from pipeline.numerics.arrays import FloatArray
from pipeline.rig_logs.guarded import read_recording
from pipeline.rig_logs.recording import Channel
from pipeline.rig_logs.source import CsvOptions
from pipeline.signals.signal_quality import SignalQuality, examine_signal
from pipeline.signals.timebase import TimeQuality, examine

Role = Literal["time", "q", "v1", "v2"]

TIME_UNITS = {"s": 1.0, "sec": 1.0, "ms": 1e-3, "us": 1e-6, "µs": 1e-6, "μs": 1e-6, "ns": 1e-9, "min": 60.0}
"""Seconds per unit of a time column."""
_DISPLACEMENT_UNITS = ("m", "mm", "cm", "um", "µm", "μm", "nm", "deg", "°", "rad", "mrad")
_INPUT_UNITS = ("v", "kv", "mv", "a", "ma", "%", "pct", "n")
_PINT_NAMES = {"pct": "percent", "%": "percent", "°": "deg", "μm": "um", "sec": "s", "μs": "us"}
_WORDS: dict[str, re.Pattern[str]] = {
    "time": re.compile(r"^(t|time|zeit|tempo|temps|timestamp)([ _.\[(].*)?$", re.IGNORECASE),
    "q": re.compile(
        r"(laser|weg|dist|displ|posi|angle|angul|winkel|saida|ild|^q$|[ _.]q$|^q[ _.])",
        re.IGNORECASE,
    ),
    "v": re.compile(r"(^hv|volt|spannung|tens|^u[ _\d]|control|[ _.]u$|umeas|^v\d|^u$)", re.IGNORECASE),
}
_LEFT = re.compile(r"(left|links|[^\d]1([^\d]|$))", re.IGNORECASE)
_RIGHT = re.compile(r"(right|rechts|[^\d]2([^\d]|$))", re.IGNORECASE)
_NAME_SUFFIX = re.compile(r"[_ ](?P<unit>[A-Za-zµμ%°]+)$")


@dataclass(frozen=True)
class Suggestion:
    """Channels that might play a role.

    Attributes
    ----------
    role : {"time", "q", "v1", "v2"}
        The role in the settings.
    candidates : tuple of str
        Names of the channels that might be meant; exactly one if there is no doubt.
    """

    role: Role
    candidates: tuple[str, ...]

    @property
    def only(self) -> str | None:
        """The one candidate, None where there are none or several."""
        return self.candidates[0] if len(self.candidates) == 1 else None


def suggested_unit(name: str, unit: str) -> str:
    """The log's unit, or what a suffix of the name says (``angulo_deg``), in pint's notation; "" if neither does."""
    bare = unit.strip("[]() ")
    if not bare:
        match = _NAME_SUFFIX.search(name)
        known = (*TIME_UNITS, *_DISPLACEMENT_UNITS, *_INPUT_UNITS)
        bare = match["unit"] if match and match["unit"].lower() in known else ""
    return _PINT_NAMES.get(bare.lower(), bare)


def suggest(channels: Sequence[tuple[str, str]], *, own_time: bool) -> tuple[Suggestion, ...]:
    """Suggestions for the roles.

    Parameters
    ----------
    channels : sequence of (name, unit)
        The channels of the log, time bases left out where the format has them.
    own_time : bool
        Whether the format carries its own time base, so that none has to be named.
    """
    units = {name: suggested_unit(name, unit) for name, unit in channels}
    names = list(units)
    called = [name for name in names if any(map(_WORDS["time"].search, (name, re.split(r"[./]", name)[-1])))]
    times = tuple(name for name in called if units[name] in ("", *TIME_UNITS))
    times = times or tuple(name for name in names if units[name] in TIME_UNITS)
    rest = [name for name in names if name not in times]
    found = [] if own_time else [Suggestion("time", times)]
    found.append(Suggestion("q", _best(rest, units, _DISPLACEMENT_UNITS, "q")))
    inputs = _best(rest, units, _INPUT_UNITS, "v")
    left = tuple(name for name in inputs if _LEFT.search(name) and not _RIGHT.search(name))
    right = tuple(name for name in inputs if _RIGHT.search(name) and not _LEFT.search(name))
    if len(left) == 1 and len(right) == 1:
        return (*found, Suggestion("v1", left), Suggestion("v2", right))
    return (*found, Suggestion("v1", inputs), Suggestion("v2", () if len(inputs) == 1 else inputs))


def _best(names: list[str], units: dict[str, str], wanted: tuple[str, ...], word: str) -> tuple[str, ...]:
    """Channels with a fitting unit and a fitting name; else with either."""
    pint_names = {_PINT_NAMES.get(unit, unit).lower() for unit in wanted}
    by_unit = [name for name in names if units[name].lower() in pint_names]
    by_name = [name for name in names if _WORDS[word].search(name)]
    both = [name for name in by_unit if name in by_name]
    return tuple(both or by_unit or by_name)


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
        raise InputError(f"{path}: is a settings file; `debist check {path}` looks at the logs that it names")
    recording = read_recording(path, csv=csv)
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
        ("upper", quality.high_rail, quality.usual[1]),
        ("lower", quality.low_rail, quality.usual[0]),
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
