"""The channels of a MAT file: ControlDesk's and Simulink's recordings, and plain vectors, matrices and structs."""

from collections.abc import Iterator, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

from numpy.typing import NDArray

from ..units.units import SECONDS, time_unit
from .attributes import is_unit, note_on_rate, possible_rate, rates_among, scales_among, starts_among, stated_rate
from .channel_roles import is_called
from .mat_recorders import (
    TABLES,
    MatArray,
    MatChannel,
    MatObject,
    MatStruct,
    MatValue,
    is_recorder,
    is_simulink_log,
    recorder_channels,
    scalar_of,
    simulink_channels,
    table_channels,
    text_of,
)
from .source import (
    MOST_COLUMNS,
    Entry,
    Source,
    UnreadableLogError,
    left_out,
    not_listed,
    ranges,
)

_MOST_ELEMENTS = 1000

_WAYS_OUT = {
    "iddata": "save its vectors (NAME.u, NAME.y) and its sample time (NAME.Ts)",
    "timeseries": "save its vectors (NAME.Time, NAME.Data)",
    "complex array": "save its real part, real(NAME)",
    "sparse array": "save full(NAME)",
    "cell": "save what it holds as variables of their own, as NAME1 = NAME{1}",
}
"""Advice for variables that are not read, by their class."""


class MatSource(Source):
    """The numeric channels among the variables of a MAT file."""

    def __init__(self, version: str, variables: dict[str, MatValue], path: Path) -> None:
        super().__init__()
        self._channels: dict[str, MatChannel] = {}
        self._not_listed: dict[str, tuple[int, ...]] = {}
        recordings = [name for name, value in variables.items() if is_recorder(value) or is_simulink_log(value)]
        makers = {"ControlDesk" if is_recorder(variables[name]) else "Simulink" for name in recordings}
        self.format = ", ".join([f"MAT {version}", *sorted(makers)])
        if len(recordings) > 1:
            self.notes.append(f"{len(recordings)} recordings in one file; channels are named recording/channel")
        for name, value in variables.items():
            prefix = f"{name}/" if len(recordings) > 1 else ""
            if is_recorder(value):
                self._add(recorder_channels(value, self.notes), prefix)
            elif is_simulink_log(value):
                self._add(simulink_channels(name, value, self.notes), prefix)
            elif isinstance(value, MatObject) and value.kind in TABLES:
                self._add_table(path, name, value.kind)
            else:
                self._add(self._plain(name, value))
        self.notes += [*left_out(self.texts), *not_listed(self._not_listed)]

    def entries(self) -> list[Entry]:
        """Every numeric channel."""
        return [channel.entry for channel in self._channels.values()]

    def parts(self, names: Sequence[str]) -> Iterator[tuple[str, NDArray[Any]]]:
        """The samples of some channels."""
        for name in names:
            channel = self._channels[name]
            for first, last in ranges(channel.entry.count, channel.step):
                yield name, self.counted(name, channel.read(first, last))

    def _add(self, channels: Sequence[MatChannel], prefix: str = "") -> None:
        for channel in channels:
            time = channel.entry.time
            entry = replace(
                channel.entry, name=prefix + channel.entry.name, time=None if time is None else prefix + time
            )
            self._channels[entry.name] = replace(channel, entry=entry)

    def _add_table(self, path: Path, name: str, kind: str) -> None:
        try:
            channels, texts = table_channels(path, name, kind)
        except UnreadableLogError as error:
            self.texts[name] = f"{error}"
            return
        self._add(channels)
        self.texts |= dict.fromkeys(texts, "text")

    def _plain(self, name: str, value: MatValue, second: float = 1.0) -> list[MatChannel]:
        """Vectors by their name, signals of matrices, fields of structs as name.field or name(k).field."""
        if isinstance(value, MatObject):
            advice = _WAYS_OUT.get(value.kind, "save its vectors as variables of their own").replace("NAME", name)
            self.texts[name] = f"a MATLAB {value.kind}: {advice}"
        elif isinstance(value, str) and value:
            self.texts[name] = f"the text {value[:40]!r}"
            self.note_rates(rates_among({name: value}, ""))
            self.heading = "; ".join(filter(None, (self.heading, value)))
        elif isinstance(value, MatArray):
            self._note_scalar(name, value, second)
            if value.is_vector:
                return [MatChannel(Entry(name, "", value.dtype, value.size), value.read, value.step)]
            if len(value.dims) == 2 and 1 < min(value.dims) <= MOST_COLUMNS:
                return _signals_of(name, value)
            if value.size > 1:
                self._not_listed[name] = value.dims
        elif isinstance(value, MatStruct) and value.count <= _MOST_ELEMENTS:
            places = [name] if value.count == 1 else [f"{name}({i + 1})" for i in range(value.count)]
            return [channel for i, place in enumerate(places) for channel in self._fields(place, value, i)]
        return []

    def _fields(self, place: str, value: MatStruct, index: int) -> list[MatChannel]:
        """The channels of one element of a struct, in the units that it states: for all of them, or by their names."""
        members = {field: value.get(index, field) for field in value.fields}
        units = next((members[field] for field in members if is_unit(field)), None)
        second = SECONDS.get(time_unit(text_of(members.get("TimeUnit"))), 1.0)
        several = sum(isinstance(each, MatArray) for each in members.values()) > 1
        channels = []
        for field, member in members.items():
            if is_unit(field):
                continue
            info = members.get(f"{field}Info")  # as of a timeseries that was saved as a struct
            of_all = members.get("TimeUnit") if several and is_called("time", field) else units
            by_name = units.get(0, field) if isinstance(units, MatStruct) else of_all
            unit = text_of(info.get(0, "Units") if isinstance(info, MatStruct) else by_name)
            for channel in self._plain(f"{place}.{field}", member, second):
                own = replace(channel.entry, unit=channel.entry.unit or unit.strip())
                channels.append(replace(channel, entry=own))
        return channels

    def _note_scalar(self, name: str, value: MatArray, second: float) -> None:
        """Note a number that may be the sample rate, the interval in units of so many seconds, or a scale."""
        number = scalar_of(value)
        if number is None:
            return
        if (rate := stated_rate(name, number)) is not None:
            self.rates[name] = rate = (
                rate if (stated_rate(name, 2.0) or 0.0) > (stated_rate(name, 1.0) or 0.0) else rate / second
            )
            self.notes.append(note_on_rate(name, number, rate))
        elif (frequency := possible_rate(name, number)) is not None:
            self.frequencies[name] = frequency
        self.stated_starts |= starts_among({name: number}, "")
        self.notes += scales_among({name: number})


def _signals_of(name: str, matrix: MatArray) -> list[MatChannel]:
    """Columns of a matrix as name(:,j); rows as name(j,:) where it is wider than high, as targets write samples."""
    rows, columns = matrix.dims
    if columns <= rows:
        entries = [Entry(f"{name}(:,{j + 1})", "", matrix.dtype, rows) for j in range(columns)]
        return [MatChannel(entry, matrix.column(j)) for j, entry in enumerate(entries)]
    entries = [Entry(f"{name}({j + 1},:)", "", matrix.dtype, columns) for j in range(rows)]
    return [MatChannel(entry, matrix.row(j)) for j, entry in enumerate(entries)]
