"""A raw log by the settings: displacement and inputs in SI units, each with its time base."""

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from pipeline.errors import InputError
from pipeline.loading.device import Device
from pipeline.numerics.arrays import FloatArray
from pipeline.settings import Channel, Prototype
from pipeline.signals.columns import Signal, chunks, column, equal, held, scaled
from pipeline.signals.timebase import nominal_step
from pipeline.units import DISPLACEMENT, INPUT, TIME, VELOCITY, SiUnit, to_si

if TYPE_CHECKING:
    from pipeline.rig_logs import Recording

_RATES_AGREE = 0.01  # share by which a stated sample rate may differ from that of the log


@dataclass(frozen=True)
class SiLog:
    """A log in SI units; signals with one time base hold the same object.

    Attributes
    ----------
    q : Signal
        Displacement [m or rad].
    inputs : tuple of Signal
        Voltages [V], or what the inputs measure.
    velocity : Signal or None
        Measured velocity [m/s or rad/s].
    """

    q: Signal
    inputs: tuple[Signal, ...]
    velocity: Signal | None = None

    @property
    def beside(self) -> dict[str, Signal]:
        """All but q, by their names in a record."""
        named = {f"v{i}": signal for i, signal in enumerate(self.inputs, start=1)}
        return named if self.velocity is None else {**named, "velocity": self.velocity}


def read_si(path: Path, prototype: Prototype, plant: Device, progress: Callable[[float], None] | None = None) -> SiLog:
    """Read a log; long columns lie in temporary files, which are mapped and vanish with the last view of them.

    Parameters
    ----------
    path : Path
        The log.
    prototype : Prototype
        Says which channel is which.
    plant : Device
        Says in which units.
    progress : callable, optional
        Told the share of the samples that are read.

    Raises
    ------
    InputError
        The log cannot be read, lacks a channel or a time base, or contradicts a unit of the settings.
    """
    from pipeline.rig_logs import CsvOptions, read_recording

    channels = prototype.channels
    used = (channels.time, channels.q, *channels.inputs, channels.qdot)
    wanted = [channel.channel for channel in used if channel is not None]
    csv = CsvOptions(**prototype.ingest.csv.model_dump())
    return _si_log(read_recording(path, channels=wanted, csv=csv, progress=progress), prototype, plant)


def _si_log(recording: "Recording", prototype: Prototype, plant: Device) -> SiLog:
    channels = prototype.channels
    signals = [(channels.q, plant.displacement), *zip(channels.inputs, plant.inputs, strict=True)]
    if channels.qdot is not None and plant.velocity is not None:
        signals.append((channels.qdot, plant.velocity))
    columns = [_si(recording, channel, unit) for channel, unit in signals]
    if channels.time is not None and plant.time is not None:
        bases = [_si(recording, channels.time, plant.time)] * len(columns)
    else:
        bases = _own_bases(recording, [channel for channel, _ in signals], prototype.ingest.sample_rate)
    _check_rate(recording.path, bases[0], prototype.ingest.sample_rate)
    for (channel, _), base, samples in zip(signals, bases, columns, strict=True):
        if base.size != samples.size:
            raise InputError(
                f"{recording.path}: channel {channel.channel!r} has {samples.size} samples, but its time has "
                f"{base.size}; they are not of one recording, or the log was cut"
            )
    q, *others = (
        _held(recording.path, channel, bases[0], (base, samples)) if channel.on_change else (base, samples)
        for (channel, _), base, samples in zip(signals, bases, columns, strict=True)
    )
    inputs = len(plant.inputs)
    return SiLog(q, tuple(others[:inputs]), *others[inputs:])


def _held(path: Path, channel: Channel, time: FloatArray, seen: Signal) -> Signal:
    """An input that was recorded when it changed, at the stamps of q."""
    at = seen[0][np.isfinite(seen[0]) & np.isfinite(seen[1])]
    if np.any(np.diff(at) < 0.0):
        raise InputError(
            f"{path}: the time of channel {channel.channel!r} steps back, so what held when is not known; "
            "repair the log"
        )
    return time, held(time, *seen)


def _check_rate(path: Path, time: FloatArray, rate: float | None) -> None:
    """Refuse a sample rate [Hz] of the settings that the log's own time contradicts."""
    if rate is None or time.size < 2:
        return
    own = 1.0 / nominal_step(time)
    if not abs(own / rate - 1.0) <= _RATES_AGREE:
        raise InputError(
            f"{path}: its time says {own:.6g} samples per second, but [ingest] sample_rate is {rate:g} Hz; that "
            "setting is for logs without time: remove it, or correct the unit of time"
        )


def _si(recording: "Recording", channel: Channel, unit: SiUnit) -> FloatArray:
    found = recording.channel(channel.channel)
    factor, offset = unit.factor * channel.scale, unit.factor * channel.offset
    if channel.scale == 1.0:  # else the log's own unit is that of its data acquisition
        _check_unit(recording.path, found.name, found.unit, channel.unit, unit)
    return scaled(found.samples, factor, offset)


def _own_bases(recording: "Recording", channels: list[Channel], rate: float | None) -> list[FloatArray]:
    """The channels' own time bases, or that of a sample rate [Hz]; equal ones become one object."""
    bases: list[FloatArray] = []
    counted: dict[str, int] = {}
    for channel in channels:
        found = recording.channel(channel.channel)
        base: FloatArray | None = found.time
        if base is None and rate is not None:
            counted[channel.channel] = found.samples.size
            base = next((known for known in bases if known.size == found.samples.size), None)
            base = _counted(found.samples.size, rate) if base is None else base
        if base is None:
            raise InputError(
                f"{recording.path}: the format carries no time base; name the time channel as [channels] time, "
                f"or give [ingest] sample_rate (the log has {', '.join(recording.listed)})"
            )
        bases.append(next((known for known in bases if equal(known, base)), base))
    if len(set(counted.values())) > 1:
        sizes = ", ".join(f"{name!r} {size} samples" for name, size in counted.items())
        raise InputError(
            f"{recording.path}: its channels have no time, and one [ingest] sample_rate cannot be that of {sizes}; "
            "name channels of one recording in [channels], or save the log with time"
        )
    return bases


def _counted(size: int, rate: float) -> FloatArray:
    """Stamps [s] of so many samples at a rate [Hz]."""
    return column(size, (np.arange(rows.start, rows.stop) / rate for rows in chunks(size)), np.float64)


def _check_unit(path: Path, channel: str, stated: str, unit: str, resolved: SiUnit) -> None:
    """Refuse a log whose own unit contradicts the settings; a unit the log words in its own way is let pass."""
    bare = stated.strip("[]() ")
    if not bare:
        return
    try:
        own = to_si(bare, (*DISPLACEMENT, *INPUT, *TIME, *VELOCITY.values()), "")
    except InputError:
        return
    if own.symbol != resolved.symbol or not np.isclose(own.factor, resolved.factor, rtol=1e-9):
        raise InputError(
            f"{path}: channel {channel!r} is in {stated} by the log, but in {unit} by the settings; "
            "correct the unit in [channels]"
        )
