"""Simulink's layout "Structure With Time" in a MAT file, as scopes and "To Workspace" blocks save it.

One struct (of any name) with ``time`` and a struct array ``signals`` (values, dimensions, label, …). ``values`` has a
row for each time; signals of several elements have columns, and what is 1×1×N is a vector.
"""

from .mat_values import MatArray, MatChannel, MatStruct, MatValue, bare, is_struct, text_of
from .source import Entry, unique_names


def is_simulink_log(value: MatValue) -> bool:
    """Whether a variable is a structure with time and signals."""
    return is_struct(value) and value.count == 1 and {"time", "signals"} <= set(value.fields)


def simulink_channels(variable: str, log: MatStruct, notes: list[str]) -> list[MatChannel]:
    """Time, called ``variable.time``, and the signals by their labels; what is left out is added to `notes`."""
    channels = []
    time = log.get(0, "time")
    signals = log.get(0, "signals")
    clock = f"{variable}.time"
    rows = 0
    if isinstance(time, MatArray) and time.size > 1:
        rows = time.size
        channels.append(MatChannel(Entry(clock, "s", time.dtype, rows), time.read, time.step))
    else:
        notes.append(f"{variable} is a Simulink structure without time; set [ingest] sample_rate")
    if not is_struct(signals):
        return channels
    places = [f"{variable}.signals({i + 1}).values" for i in range(signals.count)]
    labels = [bare(text_of(signals.get(i, "label"))) or place for i, place in enumerate(places)]
    for i, (name, place) in enumerate(zip(unique_names(labels), places, strict=True)):
        values = signals.get(i, "values")
        if isinstance(values, MatArray):
            channels += _signal(name, place, values, clock if values.dims[0] == rows or values.size == rows else None)
        if not isinstance(values, MatArray) or not (values.is_vector or len(values.dims) == 2):
            notes.append(f"{place} ({name!r}) is left out: it holds no real vector or matrix")
    return channels


def _signal(name: str, place: str, values: MatArray, clock: str | None) -> list[MatChannel]:
    """The channels of one signal: itself, or its columns."""
    if values.is_vector:
        aliases = () if name == place else (place,)
        return [MatChannel(Entry(name, "", values.dtype, values.size, clock, aliases), values.read, values.step)]
    if len(values.dims) != 2:
        return []
    rows, columns = values.dims
    entries = [Entry(f"{name}(:,{j + 1})", "", values.dtype, rows, clock) for j in range(columns)]
    return [MatChannel(entry, values.column(j)) for j, entry in enumerate(entries)]
