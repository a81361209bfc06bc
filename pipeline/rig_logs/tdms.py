"""TDMS logs of LabVIEW through npTDMS: channels in their scaled units, with the time of their waveform."""

import re
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pipeline.rig_logs.attributes import description_among, rates_among, scales_among, texts_among, unit_among
from pipeline.rig_logs.source import (
    Counted,
    Entry,
    Source,
    UnreadableLogError,
    left_out,
    ranges,
    unique_names,
)
from pipeline.units import SECONDS, time_unit

_SCALE_TYPE = re.compile(r"NI_Scale\[\d+\]_Scale_Type")
_SCALES = {
    "Linear",
    "Polynomial",
    "RTD",
    "Strain",
    "Table",
    "Thermistor",
    "Thermocouple",
    "Add",
    "Subtract",
    "AdvancedAPI",
}
"""Types of scales that npTDMS applies; of others it gives raw numbers."""


class TdmsSource(Source):
    """A TDMS file; a channel with `wf_increment` has a time base, others need a time channel."""

    format = "TDMS"

    def __init__(self, path: Path, *_: object) -> None:
        from nptdms import TdmsFile

        super().__init__()
        try:
            self._file = TdmsFile.open(path)
            channels = [channel for group in self._file.groups() for channel in group.channels()]
        except Exception as error:  # npTDMS lets errors of many kinds through on damaged files
            raise UnreadableLogError(f"npTDMS cannot open it: {type(error).__name__}: {error}") from error
        if self._file.file_status.incomplete_final_segment:
            raise UnreadableLogError("truncated: its last segment is incomplete")
        names = [channel.name for channel in channels]
        named = [n if names.count(n) == 1 else f"{c.group_name}/{n}" for n, c in zip(names, channels, strict=True)]
        self._channels = dict(zip(unique_names(named), channels, strict=True))
        self.texts = {name: _kind(each) for name, each in self._channels.items() if _kind(each) and len(each)}
        self.notes = left_out(self.texts)
        for place, holder in {"": self._file, **{g.name: g for g in self._file.groups()}, **self._channels}.items():
            own = {key: value for key, value in holder.properties.items() if not key.startswith(("NI_", "wf_"))}
            self.note_rates(rates_among(own, place))
            self.notes += scales_among(own, place)
            self.descriptions |= {place: text} if (text := description_among(holder.properties)) else {}
        self.heading = texts_among(self._file.properties)
        self._first = min(filter(None, map(_start, channels)), default=None)
        self._times: dict[tuple[float, float, int], str] = {}
        self._entries = [self._entry(name, each) for name, each in self._channels.items() if not _kind(each)]

    def _entry(self, name: str, channel: Any) -> Entry:
        """A channel, with the time of its waveform where it has one."""
        properties = channel.properties
        kind = "s" if channel.dtype.kind == "M" else unit_among(properties)
        step, axis = float(properties.get("wf_increment", 0.0)), str(properties.get("wf_xunit_string") or "s")
        factor = SECONDS.get(time_unit(axis), 0.0)
        if step > 0.0 and not factor:
            self.notes.append(
                f"{name!r} runs over {properties.get('wf_xname', 'an axis')} in {axis}, and not over time"
            )
        if not step * factor > 0.0:
            return Entry(name, kind, channel.dtype.name, len(channel))
        begins = (_start(channel) - self._first) / np.timedelta64(1, "s") if _start(channel) is not None else 0.0
        key = step * factor, float(properties.get("wf_start_offset", 0.0)) * factor + begins, len(channel)
        time = self._times.setdefault(key, f"time of {name}")
        return Entry(name, kind, channel.dtype.name, len(channel), time)

    def entries(self) -> list[Entry]:
        """Every channel of numbers or time stamps, and the times of waveforms."""
        times = [Entry(name, "s", "float64", count) for (_, _, count), name in self._times.items()]
        return [*times, *self._entries]

    def parts(self, names: Sequence[str]) -> Iterator[tuple[str, NDArray[Any]]]:
        """The samples of some channels; time stamps count from the first."""
        waveforms = {name: key for key, name in self._times.items()}
        counted = Counted()
        for name in names:
            if name in waveforms:
                step, offset, count = waveforms[name]
                for first, last in ranges(count):
                    yield name, offset + step * np.arange(first, last)
                continue
            for first, last in ranges(len(self._channels[name])):
                yield name, counted(name, np.asarray(self._channels[name][first:last]))
        self.notes += counted.notes()


def _start(channel: Any) -> Any:
    """When the waveform of a channel begins, None where that is not stated."""
    start = channel.properties.get("wf_start_time")
    return start if isinstance(start, np.datetime64) and channel.properties.get("wf_increment") else None


def _kind(channel: Any) -> str:
    """What a channel holds that is no number, or no value; "" for numbers and time stamps."""
    if channel.dtype is None or channel.dtype.kind not in "fiubM":
        return "text or complex"
    scales = {text for key, text in channel.properties.items() if _SCALE_TYPE.fullmatch(key)} - _SCALES
    return f"raw numbers with a scale that is not read, {', '.join(map(str, scales))}: export it as numbers" * bool(
        scales
    )


open_log = TdmsSource
