"""A raw log before it becomes a file, with faults on request; names and units of each format, and the formats by name.

MAT files are as ControlDesk exports them: one struct with ``X`` (time axes) and ``Y`` (channels), v5.
"""

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Literal

import numpy as np
import pyarrow as pa
from numpy.typing import NDArray
from pyarrow import csv, parquet

from ..numerics.arrays import FloatArray
from ..units.units import PLAIN
from .bench import Laser, Readings

_RASTER = "HostService"
_CLOCK = 12.345  # s, since the recorder was started
_RIG = (("Laser_q", "mm"), ("HV1_meas", "kV"), ("HV2_meas", "kV"))
_COUNT = 3  # faults of each kind in a log
_GAP, _DROPOUT = (5e-3, 60e-3), (2e-3, 30e-3)  # s, shortest and longest
_SATURATED_SHARE = 0.97  # of the largest |q|: where the range ends on request


def write_mat5(path: Path, t: FloatArray, channels: dict[str, tuple[FloatArray, str]]) -> None:
    """Write `channels` (name → samples, unit) over the times `t` [s] as MAT v5, samples in single precision."""
    from scipy.io import savemat

    y = [
        {
            "Name": name,
            "Type": 1,
            "Data": samples.astype(np.float32)[None, :],
            "Unit": unit,
            "Raster": _RASTER,
            "Path": f"Model Root/Rig/{name}",
            "XIndex": 1,
        }
        for name, (samples, unit) in channels.items()
    ]
    record = {
        "Info": {"RevisionMajor": 2},
        "X": _struct_array([{"Name": "", "Type": 5, "Data": t[None, :], "Unit": "s", "Raster": _RASTER}]),
        "Y": _struct_array(y),
        "Description": {"General": {"User": "virtual rig"}},
    }
    savemat(path, {"rec": record}, format="5", do_compression=False)


def _struct_array(records: list[dict[str, Any]]) -> NDArray[np.void]:
    """A 1×n MATLAB struct array from `records` with equal keys."""
    fields = [(field, object) for field in records[0]]
    return np.array([[tuple(record.values()) for record in records]], dtype=fields)


Channels = dict[str, tuple[FloatArray, str]]


@dataclass(frozen=True)
class Layout:
    """Channel names and file format of one make of rig.

    Attributes
    ----------
    suffix : str
        Ending of the file's name.
    time : tuple of (str, str) or None
        Name and unit of the time channel; None where the format carries its own time base.
    q, v1, v2 : tuple of (str, str)
        Name and unit.
    write : callable
        Writes (path, t, channels: name → samples and unit).
    """

    suffix: str
    time: tuple[str, str] | None
    q: tuple[str, str]
    v1: tuple[str, str]
    v2: tuple[str, str]
    write: Callable[[Path, FloatArray, dict[str, tuple[FloatArray, str]]], None]

    def save(self, log: Readings, path: Path, more: Mapping[tuple[str, str], FloatArray] | None = None) -> None:
        """Write `log` in this layout, and `more` channels [SI] by name and unit; samples are in the units named."""
        samples = {self.q: log.q, self.v1: log.v1, self.v2: log.v2, **(more or {})}
        self.write(
            path,
            log.t,
            {name: (values * (1.0 / PLAIN[unit][0]), unit) for (name, unit), values in samples.items()},
        )

    def toml(self) -> str:
        """The ``[channels]`` table of a prototype with logs of this layout."""
        entries = {"time": self.time, "q": self.q, "v1": self.v1, "v2": self.v2}
        return "[channels]\n" + "".join(
            f'{key} = {{ channel = "{entry[0]}", unit = "{entry[1]}" }}\n' for key, entry in entries.items() if entry
        )


def _write_mdf(path: Path, t: FloatArray, channels: Channels) -> None:
    """MDF 4.10 with one channel group, doubles, on a clock that does not start at zero."""
    from asammdf import MDF, Signal

    signals = [
        Signal(samples, timestamps=t + _CLOCK, name=name, unit=unit) for name, (samples, unit) in channels.items()
    ]
    with MDF(version="4.10") as file:
        file.append(signals, comment="virtual rig")
        file.save(path, overwrite=True)


def _write_parquet(path: Path, t: FloatArray, channels: Channels) -> None:
    """A table with page checksums; units in the fields' metadata, samples in single precision."""
    time = pa.field("time", pa.float64(), metadata={"unit": "s"})
    others = [pa.field(name, pa.float32(), metadata={"unit": unit}) for name, (_, unit) in channels.items()]
    columns = [t, *(samples.astype(np.float32) for samples, _ in channels.values())]
    parquet.write_table(pa.table(columns, schema=pa.schema([time, *others])), path, write_page_checksum=True)


def _write_csv(path: Path, t: FloatArray, channels: Channels) -> None:
    """Commas, decimal points, units in the header, UTF-8."""
    header = ",".join(["time [s]", *(f"{name} [{unit}]" for name, (_, unit) in channels.items())]) + "\n"
    path.write_bytes(header.encode() + _csv_rows(t, channels, ","))


def _write_csv_german(path: Path, t: FloatArray, channels: Channels) -> None:
    """Semicolons, decimal commas, Latin-1, two lines of preamble and a row of units."""
    lines = [
        "# Prüfstand DE-Gelenk (virtuell)",
        f"# Abtastrate {1 / np.median(np.diff(t)):.0f} Hz",
        ";".join(["Zeit", *channels]),
        ";".join(["[s]", *(f"[{unit}]" for _, unit in channels.values())]),
    ]
    path.write_bytes(("\n".join(lines) + "\n").encode("latin-1") + _csv_rows(t, channels, ";").replace(b".", b","))


def _csv_rows(t: FloatArray, channels: Channels, delimiter: str) -> bytes:
    """Rows with times to 0.1 µs and samples to four decimals; a NaN reads ``nan``."""
    columns = [np.round(t, 7), *(np.round(samples, 4) for samples, _ in channels.values())]
    table = pa.table(columns, names=[str(i) for i in range(len(columns))])
    sink = pa.BufferOutputStream()
    csv.write_csv(table, sink, csv.WriteOptions(include_header=False, delimiter=delimiter, quoting_style="none"))
    return bytes(sink.getvalue().to_pybytes())


LAYOUTS = {
    "mat": Layout(".mat", None, *_RIG, write_mat5),
    "mf4": Layout(
        suffix=".mf4",
        time=None,
        q=("ILD2300.Distance", "mm"),
        v1=("HV_left.Umeas", "V"),
        v2=("HV_right.Umeas", "V"),
        write=_write_mdf,
    ),
    "csv": Layout(".csv", ("time", "s"), *_RIG, _write_csv),
    "csv-de": Layout(
        suffix=".csv",
        time=("Zeit", "s"),
        q=("Weg q", "µm"),
        v1=("U DE1", "V"),
        v2=("U DE2", "V"),
        write=_write_csv_german,
    ),
    "parquet": Layout(".parquet", ("time", "s"), *_RIG, _write_parquet),
}


FaultKind = Literal["saturation", "dropouts", "nan", "gaps", "repeats"]
"""Kinds of faults, in the order in which they are put in."""


@dataclass(frozen=True)
class Fault:
    """One fault that was put in: its kind, and where it begins and ends [s]."""

    kind: str
    start: float
    end: float


def inject_faults(log: Readings, kinds: tuple[str, ...], rng: np.random.Generator) -> tuple[Readings, list[Fault]]:
    """Put faults of the `kinds` into `log`; say which and where.

    ``gaps``        samples are missing, time runs on (3 of 5 to 60 ms)
    ``dropouts``    the laser loses its target and reads the end of its range (3 of 2 to 30 ms)
    ``saturation``  the laser's range ends at 97 % of the largest displacement, not at 25 mm
    ``nan``         single readings are not numbers (3)
    ``repeats``     single samples are written twice with the same stamp (3)
    """
    faults: list[Fault] = []
    q = log.q.copy()
    rail = Laser().rail
    if "saturation" in kinds:
        rail = _SATURATED_SHARE * float(np.abs(q).max())
        beyond = np.flatnonzero(np.abs(q) > rail)
        faults.append(Fault("saturation", float(log.t[beyond[0]]), float(log.t[beyond[-1]])))
        q = np.clip(q, -rail, rail)
    for kind, lengths, reading in (("dropouts", _DROPOUT, rail), ("nan", (0.0, 0.0), np.nan)):
        for first, last in _places(log, lengths, rng) if kind in kinds else []:
            q[first:last] = reading
            faults.append(Fault(kind, float(log.t[first]), float(log.t[last - 1])))
    damaged = Readings(log.t, q, log.v1, log.v2)
    for first, last in _places(log, _GAP, rng) if "gaps" in kinds else []:
        faults.append(Fault("gaps", float(log.t[first - 1]), float(log.t[last])))
        damaged = damaged.at((damaged.t < log.t[first]) | (damaged.t >= log.t[last]))
    for _ in range(_COUNT if "repeats" in kinds else 0):
        at = int(rng.integers(1, damaged.t.size))
        faults.append(Fault("repeats", float(damaged.t[at]), float(damaged.t[at])))
        damaged = damaged.at(np.insert(np.arange(damaged.t.size), at, at))  # as a logger that writes a row again
    return damaged, sorted(faults, key=lambda fault: fault.start)


def _places(log: Readings, lengths: tuple[float, float], rng: np.random.Generator) -> Iterator[tuple[int, int]]:
    """Ranges of samples [first, last), one in each third of the log, at least one sample long."""
    third = log.t.size // _COUNT
    for i in range(_COUNT):
        count = max(1, round(float(rng.uniform(*lengths)) / float(log.t[1] - log.t[0])))
        first = i * third + int(rng.integers(1, max(2, third - count - 1)))
        yield first, first + count
