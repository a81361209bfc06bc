"""Tables and timetables of MATLAB through mat-io: columns as NAME.column, with the times of the rows."""

import warnings
from pathlib import Path
from typing import Any

import numpy as np

from .hdf5 import open_hdf5, walk
from .mat_values import MatChannel
from .source import Entry, UnreadableLogError

TABLES = ("table", "timetable")
_NUMBERS = "fiub"
_TIMES = "mM"


def table_channels(path: Path, name: str, kind: str) -> tuple[list[MatChannel], list[str]]:
    """The columns of the table `name` in a MAT file, and the names of those that hold no numbers.

    Raises
    ------
    UnreadableLogError
        mat-io does not read this table, or the file leads to others.
    """
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # it sets an option of pandas that is deprecated
        from matio import load_from_mat
    with path.open("rb") as file:
        if file.read(8) == b"MATLAB 7" or b"\x89HDF" in file.read(512):
            for _ in walk(open_hdf5(path)):  # refuses what lies in other files
                pass
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # of formats in which MATLAB shows times
            frame = load_from_mat(str(path), variable_names=[name], add_table_attrs=True)[name]
        columns = {str(column): frame[column] for column in frame.columns}
    except Exception as error:  # whatever is damaged or newer than mat-io
        raise UnreadableLogError(
            f"a MATLAB {kind} that mat-io cannot read ({type(error).__name__}: {error}): save its columns as arrays"
        ) from error
    units = [str(unit) for unit in next((frame.attrs[key] for key in frame.attrs if key.endswith("Units")), ())]
    time = f"{name}.{frame.index.name or 'Time'}" if kind == "timetable" else None
    channels = [] if time is None else [_channel(time, frame.index.to_numpy(), "s", None)]
    texts = []
    for i, (column, values) in enumerate(columns.items()):
        if values.dtype.kind not in _NUMBERS + _TIMES:
            texts.append(f"{name}.{column}")
            continue
        unit = "s" if values.dtype.kind in _TIMES else units[i] if i < len(units) else ""
        channels.append(_channel(f"{name}.{column}", values.to_numpy(), unit, time))
    return channels, texts


def _channel(name: str, values: Any, unit: str, time: str | None) -> MatChannel:
    samples = values / np.timedelta64(1, "s") if values.dtype.kind == "m" else values
    return MatChannel(
        Entry(name, unit, samples.dtype.name, samples.size, time), lambda first, last: samples[first:last]
    )
