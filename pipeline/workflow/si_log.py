"""A raw log by the settings: displacement and inputs in SI units, each with its time base."""

import math
import re
from collections.abc import Callable, Iterable, Mapping
from dataclasses import replace
from pathlib import Path

import numpy as np

from ..device.device import Device, device
from ..device.parameters import JointParameters
from ..diagnostics.sentences import judge
from ..errors import InputError
from ..numerics.arrays import BoolArray, FloatArray, runs_of
from ..rig_logs import CsvOptions, RecordedChannel, Recording, read_recording
from ..rig_logs.attributes import rates_beside, stated_rate
from ..rig_logs.channel_roles import clocks_beside, is_called, suggested_unit
from ..settings.logs import Channel, LogColumn
from ..settings.prototype import Prototype
from ..signals.columns import (
    Signal,
    chunks,
    codes_in,
    column,
    equal,
    finite,
    held,
    masked,
    one_sign,
    scaled,
    select,
    sparse,
)
from ..signals.findings import Number, Remark, refusal
from ..signals.log import RawLog
from ..signals.remarks import code_remarks
from ..signals.rounded_clock import uniform_clock
from ..signals.signal_quality import span
from ..signals.timebase import nominal_step, unwrapped
from ..units.quantity import quantity
from ..units.units import DISPLACEMENT, INPUT, SECONDS, TIME, VELOCITY, SiUnit, to_si

_RATES_AGREE = 0.01  # share by which a stated sample rate may differ from that of the log
_UNIT_IN_NAME = re.compile(r"[\[(](?P<unit>[^\[\]()]+)[\])]$")


def with_displacement(log: RawLog, plant: Device, parameters: JointParameters | None) -> RawLog:
    """The log with the displacement of the joint [m] in place of its angle [rad]; one of a length as it is.

    Parameters
    ----------
    log : RawLog
        Its q, and a measured velocity, are those of the angle φ.
    plant : Device
        Says what was logged.
    parameters : JointParameters or None
        Geometry of the joint; `device` grants that a set is named where an angle is converted.

    Raises
    ------
    InputError
        Most of the angles lie beyond those of the joint, so that their unit, zero or sign is another.
    """
    if plant.angle is None or parameters is None:
        return log
    from ..models.analytical.statics import displacement_of_rotation, rotation_nodes

    time, phi = log.q
    low, high = rotation_nodes(parameters)[[0, -1], 1]
    middle = float(np.nanmedian(phi))
    if not low <= middle <= high:
        raise InputError(
            f"q: the angle is about {np.degrees(middle):.3g}°, but the joint turns from {np.degrees(low):.3g}° to "
            f"{np.degrees(high):.3g}°; correct unit, offset or scale of q in [channels], or leave plant.parameters out "
            "for another device"
        )
    velocity = log.velocity
    if velocity is not None:
        measured = np.isfinite(time) & np.isfinite(phi)
        at = np.interp(velocity.time, time[measured], phi[measured])
        velocity = Signal(velocity.time, velocity.samples * displacement_of_rotation(at, parameters)[1])

    # Part by part, so that a long log does not lie in memory.
    displacement = (displacement_of_rotation(phi[rows], parameters)[0] for rows in chunks(phi.size))
    return replace(log, q=Signal(time, column(phi.size, displacement, np.float64)), velocity=velocity)


def read_si(
    path: Path,
    prototype: Prototype,
    parameters: JointParameters | None = None,
    progress: Callable[[float], None] | None = None,
) -> RawLog:
    """Read a log; long columns lie in temporary files, which are mapped and vanish with the last view of them.

    Parameters
    ----------
    path : Path
        The log.
    prototype : Prototype
        States which channel is which, and in which units.
    parameters : JointParameters, optional
        Geometry of a joint whose angle is logged.
    progress : callable, optional
        Receives the share of the samples that are read.

    Raises
    ------
    InputError
        The log cannot be read, lacks a channel or a time base, or contradicts a unit of the settings.
    """
    channels = prototype.channels
    signals = [each for each in (channels.q, *channels.inputs, channels.qdot) if each is not None]
    named = [each.channel for each in (channels.time, *(signal.time for signal in signals)) if each is not None]
    wanted = [*named, *(signal.channel for signal in signals)]
    csv = CsvOptions(**prototype.ingest.csv.model_dump())
    read = read_recording(path, channels=wanted, csv=csv, progress=progress)
    beside = _clocks_beside(read, prototype)
    unread = sorted({*beside.values(), *_clocks_unnamed(read, prototype)}.difference(wanted))
    if unread:
        clocks = read_recording(path, channels=[*named, *unread], csv=csv).channels  # stamps count from one origin
        others = (each for each in read.channels if each.name not in {clock.name for clock in clocks})
        read = replace(read, channels=(*clocks, *others))
    plant = device(prototype)
    return with_displacement(on_uniform_clocks(_si_log(read, prototype, plant, beside)), plant, parameters)


def on_uniform_clocks(log: RawLog) -> RawLog:
    """The log with the uniform clock in place of stamps that are those of one, rounded; which is noted."""
    signals = {"q": log.q, **log.beside}
    stamps = {id(time): time for time, _ in signals.values()}  # signals may share theirs
    clocks = {key: uniform_clock(time) for key, time in stamps.items()}
    notes = list(log.notes)
    for key, clock in clocks.items():
        if clock is not None:
            names = ", ".join(name for name, (time, _) in signals.items() if id(time) == key)
            of = "" if len(clocks) == 1 else f" of {names}"
            notes.append(Remark(f"the time stamps{of} are {clock.described}", dealt_with=True))
    uniform = {key: clock.time for key, clock in clocks.items() if clock is not None}
    made = (Signal(uniform.get(id(time), time), samples) for time, samples in signals.values())
    return _raw_log(made, len(log.inputs), notes)


def _raw_log(signals: Iterable[Signal], inputs: int, notes: Iterable[Remark]) -> RawLog:
    """A log of q, so many inputs, and perhaps a velocity."""
    q, *others = signals
    return RawLog(q, tuple(others[:inputs]), others[inputs] if others[inputs:] else None, tuple(notes))


def part_of_log(log: RawLog, span: tuple[float, float], path: Path) -> RawLog:
    """The samples of a log from the first to before the second time [s].

    Raises
    ------
    InputError
        The log at `path` has none of q there.
    """
    if span == (-math.inf, math.inf):
        return log
    signals = [log.q, *log.beside.values()]
    rows = {id(time): _within(time, span) for time, _ in signals}
    bases = {id(time): time[rows[id(time)]] for time, _ in signals}
    if not bases[id(log.q.time)].size:
        raise InputError(
            f"{path}: has no sample from {span[0]:.6g} to {span[1]:.6g} s: its time runs from "
            f"{np.nanmin(log.q.time):.6g} to {np.nanmax(log.q.time):.6g} s; correct start and stop in [logs]"
        )
    cut = (Signal(bases[id(time)], samples[rows[id(time)]]) for time, samples in signals)
    return _raw_log(cut, len(log.inputs), log.notes)


def _within(time: FloatArray, span: tuple[float, float]) -> "slice | BoolArray":
    """The rows of a time base within a span [s]; as a slice where they follow each other, so that nothing is copied."""
    inside: BoolArray = (time >= span[0]) & (time < span[1])
    rows = runs_of(inside)
    return rows[0] if len(rows) == 1 else inside


def _clocks_beside(recording: Recording, prototype: Prototype) -> dict[str, str]:
    """The column of time that stands beside each channel, where the log has several and the settings name one.

    It may be one for all that the settings do not name.
    """
    channels = prototype.channels
    used = [each for each in (channels.q, *channels.inputs, channels.qdot) if each is not None]
    if channels.time is None or all(each.time for each in used):
        return {}
    own = clocks_beside(recording.listed, channels.time.channel, recording.in_time)
    beside = {each.channel: own[each.channel] for each in used if not each.time and each.channel in own}
    named = {each.time.channel for each in used if each.time}
    return {} if named and {*beside.values()} <= named else beside


def _clocks_unnamed(recording: Recording, prototype: Prototype) -> list[str]:
    """Columns that are called time or a sample rate, where the settings give a rate in place of a time."""
    if prototype.ingest.sample_rate is None or prototype.channels.time is not None:
        return []
    return [name for name in recording.listed if is_called("time", name) or stated_rate(name, 1.0) is not None]


def _si_log(recording: Recording, prototype: Prototype, plant: Device, clocks: Mapping[str, str]) -> RawLog:
    channels = prototype.channels
    signals = {"q": (channels.q, plant.logged)}
    signals |= {f"v{k}": pair for k, pair in enumerate(zip(channels.inputs, plant.inputs, strict=True), start=1)}
    if channels.qdot is not None and plant.velocity is not None:
        signals["qdot"] = (channels.qdot, plant.velocity)
    notes = [Remark(text) for text in recording.warnings]
    columns = [_si(recording, channel, unit, name, notes) for name, (channel, unit) in signals.items()]
    bases = _bases(recording, {name: channel for name, (channel, _) in signals.items()}, prototype, clocks, notes)
    notes += _contradicted_rates(recording, channels.q.channel, bases[0], prototype)
    if prototype.ingest.time_reversal == "unwrap":
        made = {id(base): unwrapped(base) for base in bases}
        if any(not equal(base, made[id(base)]) for base in bases):
            notes.append(
                Remark("time steps back, as of a counter that begins anew: it goes on by its usual step there")
            )
        bases = [made[id(base)] for base in bases]
    if channels.q.average:
        bases[0] = scaled(bases[0], 1.0, -0.5 * channels.q.average)
        averaged = f"{1e3 * channels.q.average:.4g} ms averaged by its sensor"
        notes.append(Remark(f"q: {averaged}: half of it is taken off its time"))
    _check_rate(recording.path, bases[0], prototype.ingest.sample_rate)
    for (channel, _), base, samples in zip(signals.values(), bases, columns, strict=True):
        if base.size != samples.size:
            raise InputError(
                f"{recording.path}: channel {channel.channel!r} has {samples.size} samples, but its time has "
                f"{base.size}; they are not of one recording, or the log was cut"
            )
    held_or_read = (
        _held(recording.path, channel, bases[0], Signal(base, samples))
        if channel.on_change
        else _without_blanks(Signal(base, samples), name, notes, alone=base is not bases[0])
        for (name, (channel, _)), base, samples in zip(signals.items(), bases, columns, strict=True)
    )
    return _raw_log(held_or_read, len(plant.inputs), notes)


def _without_blanks(signal: Signal, name: str, notes: list[Remark], *, alone: bool) -> Signal:
    """A slow channel of a fast table by its own samples; where its time is `alone`, without rows of blanks."""
    filled = finite(signal.time) | finite(signal.samples) if alone else np.empty(0, np.bool_)
    if not filled.all():
        signal = Signal(select(signal.time, filled), select(signal.samples, filled))
    own, every = sparse(signal)
    if every > 1:
        notes.append(
            Remark(f"{name} has a sample every {every} rows and blanks between: interpolated", dealt_with=True)
        )
    return own


def _held(path: Path, channel: Channel, time: FloatArray, seen: Signal) -> Signal:
    """An input that was recorded when it changed, at the stamps of q."""
    at = seen.time[np.isfinite(seen.time) & np.isfinite(seen.samples)]
    if np.any(np.diff(at) < 0.0):
        raise InputError(
            f"{path}: the time of channel {channel.channel!r} steps back, so what held when is not known; "
            "repair the log"
        )
    return Signal(time, held(time, *seen))


def _check_rate(path: Path, time: FloatArray, rate: float | None) -> None:
    """Refuse a sample rate [Hz] of the settings that the log's own time contradicts."""
    if rate is None or time.size < 2:
        return
    own = 1.0 / nominal_step(time)
    if not abs(own / rate - 1.0) <= _RATES_AGREE:
        raise InputError(
            f"{path}: by its time it has {own:.6g} samples per second, but [ingest] sample_rate is {rate:g} Hz; that "
            "setting is for logs without time: remove it, or correct the unit of time"
        )


def _si(recording: Recording, log_column: LogColumn, unit: SiUnit, name: str, notes: list[Remark]) -> FloatArray:
    """A column in SI units, NaN in place of codes for no value, which are noted under its name in a record."""
    read = recording.channel(log_column.channel)
    if log_column.scale == 1.0:  # else the log's own unit is that of its data acquisition
        _check_unit(recording.path, read.name, read.unit, log_column.unit, unit)
        notes += [Remark(text).of(name) for text in recording.unapplied(log_column.channel) if not log_column.offset]
    notes += [
        Remark(f"{name}: the log has {each!r} too, which is not read")
        for each in recording.listed
        if each == f"{log_column.channel} (2)" and name != "time"
    ]
    codes = codes_in(read.samples, log_column.missing, of_time=unit.symbol == "s")
    notes += [remark.of(name) for remark in code_remarks(codes)]
    samples = scaled(masked(read.samples, codes), unit.factor * log_column.scale, unit.factor * log_column.offset)
    part = log_column.part if isinstance(log_column, Channel) else "all"
    return samples if part == "all" else one_sign(samples, 1.0 if part == "positive" else -1.0)


def _bases(
    recording: Recording,
    channels: Mapping[str, Channel],
    prototype: Prototype,
    clocks: Mapping[str, str],
    notes: list[Remark],
) -> list[FloatArray]:
    """The time base of each channel [s]: its own, that of all, or what the log has; equal ones are one object.

    Parameters
    ----------
    recording : Recording
        The log.
    channels : mapping of str to Channel
        The signals' channels, by their names in a record.
    prototype : Prototype
        Names the time of all.
    clocks : mapping of str to str
        The column of time that stands beside a channel, where the log has several.
    notes : list of Remark
        Gets what is remarkable.
    """
    bases = list[FloatArray]()
    without = [each for each in channels.values() if not (each.time or prototype.channels.time)]
    own = _own_bases(recording, without, prototype.ingest.sample_rate)
    read: dict[LogColumn, FloatArray] = {}
    several = len({*clocks.values(), *(each.time.channel for each in channels.values() if each.time)}) > 1

    def seconds(clock: LogColumn) -> FloatArray:
        """The stamps of a column, read once."""
        if clock not in read:
            unit = to_si(clock.unit, TIME, f"{prototype.name}: time {clock.channel!r}")
            read[clock] = _si(recording, clock, unit, "time", notes)
        return read[clock]

    for name, channel in channels.items():
        clock = channel.time or prototype.channels.time
        if clock is None:
            bases.append(own.pop(0))
            continue
        base = seconds(clock)
        beside = clock.channel if channel.time else clocks.get(channel.channel, clock.channel)
        if beside != clock.channel:
            stated = suggested_unit(beside, recording.channel(beside).unit)
            column_beside = {"channel": beside, "unit": stated if stated in SECONDS else clock.unit}
            own_base = seconds(clock.model_copy(update=column_beside))
            base = _of_two(name, base, own_base, (clock.channel, beside), notes, own=several)
        bases.append(next((other for other in bases if other is not base and equal(other, base)), base))
    return bases


def _of_two(
    name: str, of_all: FloatArray, beside: FloatArray, columns: tuple[str, str], notes: list[Remark], *, own: bool
) -> FloatArray:
    """The time base [s] of a signal: the column beside it where that is its `own` and runs over the time of all."""
    rises = all(np.all(np.diff(beside[rows][np.isfinite(beside[rows])]) >= 0.0) for rows in chunks(beside.size))
    if beside.size != of_all.size or equal(beside, of_all) or not rises or np.nanmax(beside) == np.nanmin(beside):
        return of_all
    (begin, end), (own_begin, own_end) = span(of_all), span(beside)
    shared = min(end, own_end) - max(begin, own_begin)
    what = f"{name} stands beside a clock of its own, {columns[1]!r}"
    way_out = f"give that of {name} in [channels] as time = {{ channel, unit }}"
    if 2.0 * shared > max(end - begin, own_end - own_begin):
        filled = np.isnan(beside).any() or np.isnan(of_all).any()  # with blanks: rows are not of one time
        apart = "" if filled else f", up to {quantity(float(np.abs(beside - of_all).max()), 's')} from {columns[0]!r}"
        then = f"it is used for {name}" if own else f"which of them is that of {name} is not known; {way_out}"
        notes.append(Remark(f"{what}{apart}: {then}", dealt_with=own))
        return beside if own else of_all
    apart = f", which differs from {columns[0]!r}, and is not used: it runs from {own_begin:.6g} to {own_end:.6g} s"
    notes += [Remark(f"{what}{apart}; {way_out}")] if own else []
    return of_all


def _own_bases(recording: Recording, channels: list[Channel], rate: float | None) -> list[FloatArray]:
    """The time bases of a log, or that of a sample rate [Hz]; equal ones become one object."""
    bases: list[FloatArray] = []
    counted: dict[str, int] = {}
    for channel in channels:
        read = recording.channel(channel.channel)
        base: FloatArray | None = read.time
        if base is None and rate is not None:
            counted[channel.channel] = read.samples.size
            base = next((other for other in bases if other.size == read.samples.size), None)
            stamps = (np.arange(rows.start, rows.stop) / rate for rows in chunks(read.samples.size))
            base = column(read.samples.size, stamps, np.float64) if base is None else base
        if base is None:
            raise InputError(
                f"{recording.path}: the format carries no time base; name the time channel as [channels] time, "
                f"or give [ingest] sample_rate (the log has {', '.join(recording.listed)})"
            )
        bases.append(next((other for other in bases if equal(other, base)), base))
    if len(set(counted.values())) > 1:
        sizes = ", ".join(f"{name!r} {size} samples" for name, size in counted.items())
        raise InputError(
            f"{recording.path}: its channels have no time, and one [ingest] sample_rate cannot be that of {sizes}; "
            "name channels of one recording in [channels], or save the log with time"
        )
    return bases


def _contradicted_rates(recording: Recording, channel: str, time: FloatArray, prototype: Prototype) -> list[Remark]:
    """Remarks on stated sample rates beside a channel that its time [s] contradicts.

    Raises
    ------
    DataRefusedError
        The time is made of the rate of the settings, which these do not accept unchecked.
    """
    rates = dict(rates_beside(channel, recording.rates))
    for name in _clocks_unnamed(recording, prototype):
        rates |= _rate_of_column(recording.channel(name), prototype.ingest.sample_rate or 0.0)
    if not rates:
        return _rates_in_doubt(recording, prototype)
    own = 1.0 / nominal_step(time)
    if any(abs(rate / own - 1.0) <= _RATES_AGREE for rate in rates.values()):
        return []
    stated = " and ".join(f"{name} states {rate:.6g} Hz" for name, rate in rates.items())
    if prototype.ingest.sample_rate is None:
        return [
            Remark(
                f"in the log {stated}, but by its time it has {own:.6g} samples per second: is the unit of time right?"
            )
        ]
    numbers = {name: Number(rate, "Hz") for name, rate in rates.items()}
    numbers["settings"] = Number(prototype.ingest.sample_rate, "Hz")
    accepted = judge(f"{recording.path}", [refusal("rate", "other_rate", numbers)], prototype.quality)
    return [Remark(text, dealt_with=True) for text in accepted]


def _rates_in_doubt(recording: Recording, prototype: Prototype) -> list[Remark]:
    """A remark on frequencies that no motion in the samples can have, and that are not the rate of the settings.

    A lower one may be that of an excitation, and any may be that of another instrument: none refuses the log.
    """
    rate = prototype.ingest.sample_rate
    if rate is None or prototype.channels.time is not None:
        return []
    ratios = {name: frequency / rate for name, frequency in recording.frequencies.items()}
    if any(abs(ratio - 1.0) <= _RATES_AGREE for ratio in ratios.values()):
        return []
    beyond = [f"{name} is {ratio * rate:.6g} Hz" for name, ratio in ratios.items() if ratio >= 0.5 * (1 - _RATES_AGREE)]
    doubt = (
        f"in the log {' and '.join(beyond)}, and a motion has less than half of [ingest] sample_rate = {rate:g} Hz: is "
        "that rate right?"
    )
    return [Remark(doubt)] if beyond else []


def _rate_of_column(column: RecordedChannel, wanted: float) -> dict[str, float]:
    """The rate [Hz] of a column that is one number, or rises as a clock; nothing for others.

    A clock without a unit is taken in that unit which gives the `wanted` rate, if one does; else in s.
    """
    numbers = column.samples[np.isfinite(column.samples)]
    if numbers.size < 2 or np.any(np.diff(numbers) < 0.0):
        return {}
    if numbers[-1] == numbers[0]:
        rate = stated_rate(column.name, float(numbers[0]))
        return {} if rate is None else {column.name: rate}
    unit = suggested_unit(column.name, column.unit)
    factors = [SECONDS[unit]] if unit in SECONDS else list(SECONDS.values())
    steps = (float(numbers[-1] - numbers[0]) / (numbers.size - 1), nominal_step(numbers))  # with gaps, or coarse stamps
    rates = [1.0 / (step * factor) for factor in factors for step in steps]
    return {column.name: next((rate for rate in rates if abs(rate / wanted - 1.0) <= _RATES_AGREE), 1.0 / steps[0])}


def _check_unit(path: Path, channel: str, stated: str, unit: str, resolved: SiUnit) -> None:
    """Refuse a log whose own unit contradicts the settings; a unit the log words in its own way is let pass."""
    in_name = _UNIT_IN_NAME.search(channel)
    bare = stated.strip("[]() ") or (in_name["unit"] if in_name else "")
    if not bare:
        return
    try:
        own = to_si(bare, (*DISPLACEMENT, *INPUT, *TIME, *VELOCITY.values()), "")
    except InputError:
        return
    other_kind = own.symbol != resolved.symbol
    monitor = ', or of a 1:1000 monitor give unit = "V", scale = 1000' if (bare, unit) == ("V", "kV") else ""
    if (other_kind and stated) or not (other_kind or np.isclose(own.factor, resolved.factor, rtol=1e-9)):
        raise InputError(
            f"{path}: channel {channel!r} is in {bare} by {'the log' if stated else 'its name'}, but in {unit} by the "
            f"settings; correct the unit in [channels]{monitor}"
        )
