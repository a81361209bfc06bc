"""What is in a raw log: channels, units, rates, gaps, rails, hum; and which channel might be what.

Suggestions are for a person; nothing decides on them.
"""

import re
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

import numpy as np

from pipeline.errors import DataRefusedError, InputError
from pipeline.numerics.arrays import FloatArray
from pipeline.rig_logs.experiments import far_shorter, note_on, second_experiments
from pipeline.rig_logs.guarded import read_recording
from pipeline.rig_logs.recording import Channel
from pipeline.rig_logs.source import CsvOptions, note_on_rate, stated_rate
from pipeline.signals.signal_quality import SignalQuality, examine_signal
from pipeline.signals.timebase import TimeQuality, examine

Role = Literal["time", "q", "v1", "v2"]

TIME_UNITS = {"s": 1.0, "sec": 1.0, "ms": 1e-3, "us": 1e-6, "µs": 1e-6, "μs": 1e-6, "ns": 1e-9, "min": 60.0}
"""Seconds per unit of a time column."""
_DISPLACEMENT_UNITS = ("m", "mm", "cm", "um", "µm", "μm", "nm", "deg", "°", "rad", "mrad")
_INPUT_UNITS = ("V", "kV", "mV", "A", "mA", "%", "pct", "N")
_PINT_NAMES = {
    "pct": "percent", "%": "percent", "°": "deg", "degree": "deg", "degrees": "deg", "μm": "um", "sec": "s", "μs": "us",
    "second": "s", "seconds": "s", "volt": "V", "volts": "V", "ampere": "A", "amperes": "A",
}  # fmt: skip
_SIGNAL = r"(^|[./]){}(_?(dat|data|id|ident|train|meas|val|valid|test)|(?-i:[A-Z])\w*|\d*)([(\[]:,\d+[)\]])?$"
"""The output y and the input u of identification, such as ``data.ydat(:,1)``, ``yEst``, ``run/u``."""
_WORDS: dict[str, re.Pattern[str]] = {
    "time": re.compile(r"^(t|time|zeit|tempo|temps|timestamp)([ _.\[(/].*)?$", re.IGNORECASE),
    "q": re.compile(
        r"(laser|weg|dist|displ|pos|angle|angul|winkel|saida|ild|theta|phi|tilt|pitch|level|pegel|height|gap|stroke|"
        r"encoder|^[xyq]$|[ _.]q$|^q[ _./]|" + _SIGNAL.format("y") + ")",
        re.IGNORECASE,
    ),
    "v": re.compile(
        r"(^hv|volt|spannung|tens|^u[ _/\d]|control|[ _.]u$|umeas|^v\d|^[uvi]$|pwm|duty|cmd|command|current|strom|"
        r"torque|throttle|motor|pump|valve|ventil|heater|" + _SIGNAL.format("u") + ")",
        re.IGNORECASE,
    ),
}
_WANTED = re.compile(r"(ref|soll|set.?point|target|desired)", re.IGNORECASE)
"""Names of what a controller wants: neither a displacement nor an input."""
_LEFT = re.compile(r"(left|links|[^\d]1([^\d]|$)|[ _.-]l$)", re.IGNORECASE)
_RIGHT = re.compile(r"(right|rechts|[^\d]2([^\d]|$)|[ _.-]r$)", re.IGNORECASE)
_MOST_INPUTS = 2
_NAME_SUFFIX = re.compile(r"(?:[_ ]|\s*/\s*)(?P<unit>[A-Za-zµμ%°]+)$")


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
        bare = _spelt(match["unit"]) if match else ""
    return _PINT_NAMES.get(bare.lower(), bare)


def _spelt(unit: str) -> str:
    """A unit that stands at the end of a name, in its right letters (KV is kV); "" where it is none."""
    known = (*TIME_UNITS, *_DISPLACEMENT_UNITS, *_INPUT_UNITS)
    if unit in known:
        return unit
    return next((one for one in known if one.lower() == unit.lower() and (len(one) > 1 or one.isupper())), "")


def suggest(
    channels: Sequence[tuple[str, str]],
    *,
    own_time: bool,
    rising: Sequence[str] = (),
    counts: Mapping[str, int] | None = None,
) -> tuple[Suggestion, ...]:
    """Suggestions for the roles.

    Parameters
    ----------
    channels : sequence of (name, unit)
        The channels of the log, time bases left out where the format has them.
    own_time : bool
        Whether the format carries its own time base, so that none has to be named.
    rising : sequence of str
        Channels that rise by equal steps; a single one may be the time, if no other is called so.
    counts : mapping of str to int, optional
        Samples of each channel where they are all of one raster: those of one record have equally many.
    """
    sizes = dict.fromkeys((name for name, _ in channels), 0) | dict(counts or {})
    units = {name: suggested_unit(name, unit) for name, unit in channels}
    names = list(units)
    called = [name for name in names if any(map(_WORDS["time"].search, (name, re.split(r"[./]", name)[-1])))]
    times = tuple(name for name in called if units[name] in ("", *TIME_UNITS))
    times = times or tuple(name for name in names if units[name] in TIME_UNITS)
    times = times or (tuple(name for name in rising if not units[name]) if len(rising) == 1 else ())
    times = tuple(name for name in times if sizes[name] == max(map(sizes.__getitem__, times)))
    rest = [name for name in names if name not in times and not _WANTED.search(name)]
    rest = [name for name in rest if not times or sizes[name] == sizes[times[0]]]
    found = [] if own_time else [Suggestion("time", times)]
    q = _best(rest, units, _DISPLACEMENT_UNITS, "q")
    rest = [name for name in rest if len(q) != 1 or sizes[name] == sizes[q[0]]]
    inputs = _best([name for name in rest if q != (name,)], units, _INPUT_UNITS, "v")
    left_over = tuple(name for name in rest if name not in (*q, *inputs) and not units[name])
    if not q and len(left_over) == 1:
        q = left_over
    elif not inputs and len(left_over) <= _MOST_INPUTS and len(q) == 1:
        inputs = left_over
    found.append(Suggestion("q", q))
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


_RAIL_SHARE = 1e-3
_FROZEN_SECONDS, _FROZEN_SAMPLES = 0.05, 20
_UNEVEN, _MOSTLY = 0.5, 0.95
"""Share of a step by which those of a clock may differ, and how many of them do not by more."""
_LONG_AGO = 1e5
"""Seconds of a clock from which on stamps are told to the millisecond: it counts from a day or an epoch long ago."""
_MUCH = 10.0
"""Times the range of an idle channel by which another one of its unit moves, if the idle one is not driven."""

NO_CHANNEL = "the log holds no vector of numbers"
"""Said where nothing can be drafted or examined."""

Clock = Literal["s", "samples", ""]
"""In what places in a log are told: seconds, numbers of samples, or a time of which the log states no unit."""


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
    apart : tuple of str
        Channels for which no role is suggested, as they are not of the same record as the others.
    rates : mapping of str to float
        Sample rates [Hz] that numbers in the log state, by their names; nothing decides on them.
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
    apart: tuple[str, ...]
    rates: Mapping[str, float]
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
    notes = list(recording.notes)
    rates = {} if own_time else dict(recording.rates) | _constant_rates(recording.channels, notes)
    roles, apart = _roles(recording.channels, rates, notes, own_time=own_time)
    column, clock = (None, "s") if own_time else _time_column(recording.channels, roles, notes)
    stamps: list[FloatArray] = []
    bases: list[TimeQuality] = []
    examined: list[tuple[Channel[FloatArray], int | None, SignalQuality, Clock]] = []
    for channel in recording.channels:
        time = column if channel.time is None and not own_time else channel.time
        position = _time_base(time, stamps, bases, notes) if time is not None else None
        if time is not None and position is not None and time.size == channel.samples.size:
            examined.append((channel, position, examine_signal(time, channel.samples, bases[position].step), clock))
        else:  # a time base itself, or a channel without one: located by sample number
            numbers = np.arange(channel.samples.size, dtype=np.float64)
            examined.append((channel, None, examine_signal(numbers, channel.samples, 1.0), "samples"))
    bare = {channel.name for channel in recording.channels if own_time and channel.time is None}
    inputs = {name for role in roles if role.role in ("v1", "v2") for name in role.candidates}
    channels = []
    for channel, position, quality, own_clock in examined:
        alike = [seen.span for other, _, seen, _ in examined if other.unit == channel.unit and other is not channel]
        context = Context(own_clock, channel.name in inputs, max(alike, default=np.nan))
        remarks = () if channel.name in bare else remarks_on(quality, context)
        channels.append(InspectedChannel(channel.name, channel.unit, channel.dtype, position, quality, remarks))
    size = path.stat().st_size
    return Inspection(
        path, recording.format, size, own_time, tuple(bases), tuple(channels), roles, apart, rates, tuple(notes)
    )


def _constant_rates(channels: Sequence[Channel[FloatArray]], notes: list[str]) -> dict[str, float]:
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
    channels: Sequence[Channel[FloatArray]], rates: Collection[str], notes: list[str], *, own_time: bool
) -> tuple[tuple[Suggestion, ...], tuple[str, ...]]:
    """Suggestions for the roles, and the channels that are set apart before; why is added to the notes."""
    usual = [channel for channel in channels if channel.time is not None or not own_time]
    counts = {} if own_time else {channel.name: channel.samples.size for channel in channels}
    left_out = far_shorter(counts).union(rates)
    further = second_experiments([channel.name for channel in usual if channel.name not in left_out], _is_record)
    notes += note_on(further)
    kept = [channel for channel in usual if channel.name not in left_out and channel.name not in further]
    rising = () if own_time else [channel.name for channel in kept if _rises_evenly(channel.samples)]
    named = [(channel.name, channel.unit) for channel in kept]
    roles = suggest(named, own_time=own_time, rising=rising, counts=counts)
    time = next((role.only for role in roles if role.role == "time" and role.only is not None), None)
    others = () if time is None else (channel.name for channel in kept if counts[channel.name] != counts[time])
    return roles, (*sorted(left_out & counts.keys()), *further, *others)


def _is_record(names: Sequence[str]) -> bool:
    """Whether an output and an input are among channels of these names."""
    return all(any(map(_WORDS[word].search, names)) for word in ("q", "v"))


def _rises_evenly(samples: FloatArray) -> bool:
    """Whether nearly all steps of a column are upwards and about as large, as those of a clock."""
    steps = np.diff(samples[: 1 << 17])
    usual = float(np.median(steps)) if steps.size > 1 else 0.0
    return usual > 0.0 and bool(np.mean(np.abs(steps - usual) <= _UNEVEN * usual) >= _MOSTLY)


def _time_column(
    channels: Sequence[Channel[FloatArray]], roles: Sequence[Suggestion], notes: list[str]
) -> tuple[FloatArray | None, Clock]:
    """The column that is taken for time in the description, in s, and in what places are told then."""
    name = next((role.only for role in roles if role.role == "time"), None)
    if name is None:
        if channels:
            notes.append("no single column is called time; rates and places are in samples")
        return None, "samples"
    channel = next(c for c in channels if c.name == name)
    unit = suggested_unit(channel.name, channel.unit)
    stated = f"in {unit}" if unit in TIME_UNITS else "in s, of which the log says nothing"
    notes.append(f"described as if {name!r} were time {stated}; the settings decide")
    return channel.samples * TIME_UNITS.get(unit, 1.0), "s" if unit in TIME_UNITS else ""


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


@dataclass(frozen=True)
class Context:
    """What is known of a channel beside its samples.

    Attributes
    ----------
    clock : {"s", "samples", ""}
        In what its places are told.
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
    clock, remarks = context.clock, []
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
    if not (context.driven and quality.stepped):
        remarks += _stays(quality, clock)
    if quality.spikes:
        remarks.append(f"{counted(quality.spikes, 'single-sample spike')}{_first(quality.spikes_at, clock)}")
    remarks += [
        f"{line.frequency:g} Hz hum {line.above_floor_db:.0f} dB over the spectrum beside it, "
        f"amplitude {line.amplitude:.3g}"
        for line in quality.hum
        if line.stands_out and clock == "s"
    ]
    return tuple(remarks)


def _stays(quality: SignalQuality, clock: Clock) -> list[str]:
    """Where a signal does not move that might."""
    remarks = []
    for rail, share, value in (
        ("upper", quality.high_rail, quality.usual[1]),
        ("lower", quality.low_rail, quality.usual[0]),
    ):
        if share > _RAIL_SHARE:
            remarks.append(f"{100 * share:.2g} % of the samples stay at the {rail} extreme {value:.6g}: saturated?")
    long = quality.longest_frozen > _FROZEN_SECONDS and quality.frozen_samples >= _FROZEN_SAMPLES
    if clock == "s" and long and not quality.stepped:
        remarks.append(f"unchanged for {quality.longest_frozen:.3g} s from {moment(quality.frozen_at)} s on")
    return remarks


def counted(number: int, thing: str) -> str:
    """A number of things."""
    return f"{number} {thing}{'' if number == 1 else 's'}"


def moment(stamp: float) -> str:
    """A time stamp [s] without its unit, told to the millisecond where the clock has run for long."""
    return f"{stamp:.3f}" if abs(stamp) >= _LONG_AGO else f"{stamp:.6g}"


def _first(places: tuple[float, ...], clock: Clock) -> str:
    """Where the first one is; nothing where the time itself is not known there."""
    if not places or not np.isfinite(places[0]):
        return ""
    if clock == "s":
        return f", the first at {moment(places[0])} s"
    place = f"{places[0]:.6g}"
    return f", the first at {f'sample {place}' if clock == 'samples' else place}"
