"""TDMS logs of LabVIEW through npTDMS: channels in their scaled units, with the time of their waveform."""

import re
import weakref
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any, BinaryIO

import numpy as np
from nptdms import TdmsFile
from nptdms.reader import TdmsReader
from nptdms.timestamp import TdmsTimestamp
from numpy.typing import NDArray

from ..units.units import SECONDS, time_unit
from .attributes import description_among, rates_among, scales_among, texts_among, unit_among
from .channel_roles import is_called
from .source import (
    Entry,
    Source,
    UnreadableLogError,
    left_out,
    ranges,
    unique_names,
)

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


class _Segments(TdmsReader):  # type: ignore[misc]
    """npTDMS's reader of the heads of segments; it keeps what each states of a channel, where npTDMS keeps the last."""

    def __init__(self, file: BinaryIO) -> None:
        super().__init__(file)
        self.stated: dict[str, list[tuple[int, dict[str, Any]]]] = {}
        self._rows: dict[str, int] = {}
        self.read_metadata()

    def _update_object_properties(self, segment_object_properties: Any) -> None:
        """Keep the properties of each channel with the number of its samples in the segments before."""
        super()._update_object_properties(segment_object_properties)
        for path in segment_object_properties or ():
            self.stated.setdefault(path, []).append(
                (self._rows.get(path, 0), dict(self.object_metadata[path].properties))
            )
        self._rows = {path: each.num_values for path, each in self.object_metadata.items()}

    @property
    def end(self) -> int:
        """The byte behind the last segment whose head is whole."""
        return int(self._segments[-1].next_segment_pos) if self._segments else 0


_Waveform = tuple[float, tuple[tuple[int, float], ...], int]
"""Step [s]; the first row of each recording, and when that begins [s]; number of samples."""


class TdmsSource(Source):
    """A TDMS file; a channel with `wf_increment` has a time base, others need a time channel."""

    format = "TDMS"

    def __init__(self, path: Path, *_: object) -> None:
        super().__init__()
        opened = path.open("rb")  # by its name npTDMS would take its index from another file
        weakref.finalize(self, opened.close)
        try:
            segments = _Segments(opened)
            opened.seek(0)
            self._file = TdmsFile.open(opened)
            channels = [channel for group in self._file.groups() for channel in group.channels()]
        except Exception as error:  # npTDMS lets errors of many kinds through on damaged files
            raise UnreadableLogError(f"npTDMS cannot open it: {type(error).__name__}: {error}") from error
        if self._file.file_status.incomplete_final_segment or segments.end < path.stat().st_size:
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
        self._stated = {each.path: segments.stated.get(each.path, []) for each in channels}
        self._first = min(
            filter(None, (_start(properties) for stated in self._stated.values() for _, properties in stated)),
            default=None,
        )
        self._times: dict[_Waveform, str] = {}
        self._entries = [self._entry(name, each) for name, each in self._channels.items() if not _kind(each)]

    def _entry(self, name: str, channel: Any) -> Entry:
        """A channel, with the time of its waveform where it has one."""
        properties = channel.properties
        kind = "s" if channel.dtype.kind == "M" else unit_among(properties)
        step = float(properties.get("wf_increment", 0.0))
        axis = str(properties.get("wf_xunit_string") or "s")
        factor = SECONDS.get(time_unit(axis), 0.0)
        if step > 0.0 and not factor:
            self.notes.append(
                f"{name!r} runs over {properties.get('wf_xname', 'an axis')} in {axis}, and not over time"
            )
        clock = self._time_channel(channel) if step == 1.0 else ""
        if clock and clock != name:
            self.notes.append(
                f"wf_increment = 1 of {name!r} is LabVIEW's default beside {clock!r}: name that as the time"
            )
        if not step * factor > 0.0 or clock:
            return Entry(name, kind, channel.dtype.name, len(channel))
        key = step * factor, self._recordings(name, channel, step, factor), len(channel)
        return Entry(name, kind, channel.dtype.name, len(channel), self._times.setdefault(key, f"time of {name}"))

    def _time_channel(self, channel: Any) -> str:
        """The channel of times among those of as many samples, "" where there is none."""
        return next(
            (
                name
                for name, each in self._channels.items()
                if len(each) == len(channel)
                and not _kind(each)
                and (each.dtype.kind == "M" or is_called("time", each.name) or unit_among(each.properties) in SECONDS)
            ),
            "",
        )

    def _recordings(self, name: str, channel: Any, step: float, factor: float) -> tuple[tuple[int, float], ...]:
        """The first row of each recording in a channel, and when it begins [s]; more than one where it was appended to.

        Raises
        ------
        UnreadableLogError
            The step changes between them.
        """
        begun: list[tuple[int, float]] = []
        last = np.nan
        for row, properties in self._stated[channel.path]:
            if properties.get("wf_increment", step) != step:
                raise UnreadableLogError(
                    f"wf_increment of {name!r} changes from {properties['wf_increment']:g} to {step:g}: "
                    "save each recording as a file of its own"
                )
            start = _start(properties)
            begins = float(properties.get("wf_start_offset", 0.0)) * factor
            begins += 0.0 if start is None else float((start - self._first) / np.timedelta64(1, "s"))
            if begun and begun[-1][0] == row:
                begun.pop()  # its head was written anew before its samples
            expected = begun[-1][1] + step * factor * (row - begun[-1][0]) if begun else np.nan
            if begins != last and row < len(channel) and not abs(begins - expected) < step * factor / 2.0:
                begun.append((row, begins))
            last = begins
        if len(begun) > 1:
            starts = ", ".join(f"{begins:g}" for _, begins in begun[1:])
            self.warnings.append(
                f"{name!r} begins anew at {starts} s, by the wf_start_time of later segments; others go on"
            )
        return tuple(begun)

    def entries(self) -> list[Entry]:
        """Every channel of numbers or time stamps, and the times of waveforms."""
        return [*(Entry(name, "s", "float64", count) for (_, _, count), name in self._times.items()), *self._entries]

    def parts(self, names: Sequence[str]) -> Iterator[tuple[str, NDArray[Any]]]:
        """The samples of some channels; time stamps count from the first."""
        waveforms = {name: key for key, name in self._times.items()}
        for name in names:
            if name in waveforms:
                step, begun, count = waveforms[name]
                rows, begins = np.array(begun).T
                for first, last in ranges(count):
                    row = np.arange(first, last)
                    recording = np.searchsorted(rows, row, side="right") - 1
                    yield name, begins[recording] + step * (row - rows[recording])
                continue
            for first, last in ranges(len(self._channels[name])):
                yield name, self.counted(name, np.asarray(self._channels[name][first:last]))


def _start(properties: Mapping[str, Any]) -> Any:
    """Start of a waveform, None where it is not stated."""
    start = properties.get("wf_start_time")
    return start.as_datetime64() if isinstance(start, TdmsTimestamp) and properties.get("wf_increment") else None


def _kind(channel: Any) -> str:
    """Type of a channel's content that is no number, or no value; "" for numbers and time stamps."""
    if channel.dtype is None or channel.dtype.kind not in "fiubM":
        return "text or complex"
    scales = {text for key, text in channel.properties.items() if _SCALE_TYPE.fullmatch(key)} - _SCALES
    return f"raw numbers with a scale that is not read, {', '.join(map(str, scales))}: export it as numbers" * bool(
        scales
    )


open_log = TdmsSource
