"""Intact logs of every format to be damaged, and which of their bytes the format protects by a checksum."""

import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from pathlib import Path

import h5py
import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq
from scipy.io import savemat

from pipeline.rig.log import write_mat5
from tests.fuzz.edits import LETTERS
from tests.rig_logs.small_logs import matlab_object, write_matlab73

N = 60
TIME = np.arange(N) / 1000.0
Q = 9.0 * np.sin(70.0 * TIME)
V = np.where(TIME < 0.03, 0.0, 3000.5)
CHANNELS = {"q": (Q, "mm"), "v": (V, "V")}
Ranges = list[tuple[int, int]]


@dataclass(frozen=True)
class Seed:
    """An intact log.

    Attributes
    ----------
    name : str
    data : bytes
    protected : list of (int, int)
        Byte ranges in which the format notices the changes that `values` make.
    values : sequence of int
        Any byte under a checksum; in rows of numbers a letter.
    """

    name: str
    data: bytes
    protected: Ranges = field(default_factory=list)
    values: Sequence[int] = range(256)


def seeds(kind: str, folder: Path) -> list[Seed]:
    """The seeds of one format."""
    made = []
    for write in _WRITERS[kind]:
        path = folder / f"{kind}-{write.__name__.strip('_')}"
        protected = write(path)
        values = LETTERS if kind == "csv" else range(256)
        made.append(Seed(path.name, path.read_bytes(), protected, values))
    return made


def _controldesk(path: Path) -> Ranges:
    write_mat5(path, TIME, CHANNELS)
    return []


def _compressed_mat(path: Path) -> Ranges:
    savemat(path, {"t": TIME, "table": np.column_stack([Q, V]), "s": {"q": Q, "note": "text"}}, do_compression=True)
    data, ranges, position = path.read_bytes(), [], 128
    while position < len(data):
        size = int.from_bytes(data[position + 4 : position + 8], "little")
        # From the second byte on: in the first, bits of the window's size change nothing when the data are shorter.
        ranges.append((position + 10, position + 8 + size))
        position += 8 + size
    return ranges


def _simulink(path: Path) -> Ranges:
    """A structure with time, and an object of a class beside it."""
    signals = np.zeros(2, dtype=[("values", object), ("dimensions", object), ("label", object)])
    signals[0], signals[1] = (Q[:, None], 1, "laser"), (np.column_stack([V, V]), 2, "amplifiers")
    savemat(path, {"scope": {"time": TIME[:, None], "signals": signals}})
    data = path.read_bytes()
    path.write_bytes(data[:128] + matlab_object("log", "table") + data[128:])
    return []


def _matlab73_by_hand(path: Path) -> Ranges:
    axis = {"Name": "", "Type": 4.0, "Data": TIME, "Unit": "s", "Raster": "HostService"}
    channel = {**axis, "Path": "Model Root/Scope", "XIndex": 1.0}
    write_matlab73(path, [axis], [{**channel, "Name": "q", "Data": Q}, {**channel, "Name": "v", "Data": V}])
    return []


def _mdf(path: Path, compression: int = 0) -> Ranges:
    from asammdf import MDF, Signal

    with MDF(version="4.10") as mdf:
        mdf.append([Signal(s, TIME + 12.345, name=name, unit=unit) for name, (s, unit) in CHANNELS.items()])
        mdf.append([Signal(np.arange(9, dtype=np.int16), np.arange(9) * 0.01, name="slow", unit="°C")])
        mdf.save(path.with_suffix(".mf4"), overwrite=True, compression=compression)
    path.with_suffix(".mf4").replace(path)
    data, ranges, position = path.read_bytes(), [], 0
    while (position := data.find(b"##DZ", position)) >= 0:
        packed = int.from_bytes(data[position + 40 : position + 48], "little")
        ranges.append((position + 50, position + 48 + packed))
        position += 4
    return ranges


def _mdf_deflated(path: Path) -> Ranges:
    return _mdf(path, 1)


def _mdf_transposed(path: Path) -> Ranges:
    return _mdf(path, 2)


def _german_csv(path: Path) -> Ranges:
    rows = "".join(f"{t:.3f};{q:.6f};{v:.1f}\n" for t, q, v in zip(TIME, Q, V, strict=True)).replace(".", ",")
    path.write_bytes(("# Prüfstand\ntime;q;v\n[s];[mm];[V]\n" + rows).encode("latin-1"))
    return _cells(path, rows, ";")


def _english_csv(path: Path) -> Ranges:
    rows = "".join(f"{t:.3f},{q!r},{v:.1f}\r\n" for t, q, v in zip(TIME.tolist(), Q.tolist(), V.tolist(), strict=True))
    path.write_text('time (s),"q [mm]",v\r\n' + rows, encoding="utf-8-sig", newline="")
    return _cells(path, rows, ",")


def _blank_csv(path: Path) -> Ranges:
    rows = "".join(f"{t:.3f}  {q:.6e} {v:.0f}\n" for t, q, v in zip(TIME, Q, V, strict=True))
    path.write_text("t q v\n" + rows)
    return _cells(path, rows, " ")


def _utf16_csv(path: Path) -> Ranges:
    rows = "".join(f"{t:.3f}\t{q:.6f}\t{v:.1f}\n" for t, q, v in zip(TIME, Q, V, strict=True))
    path.write_text("time\tq\tv\n" + rows, encoding="utf-16")
    return []


def _cells(path: Path, rows: str, delimiter: str) -> Ranges:
    """Where the numbers of the rows stand, in an encoding of one byte a character."""
    start = path.stat().st_size - len(rows)
    return [(start + match.start(), start + match.end()) for match in re.finditer(rf"[^{delimiter}\r\n]+", rows)]


def _parquet(path: Path, compression: str = "none") -> Ranges:
    fields = [pa.field(name, pa.float64(), metadata={"unit": unit}) for name, unit in (("t", "s"), ("q", "mm"))]
    table = pa.Table.from_arrays([TIME, Q], schema=pa.schema(fields)).append_column("n", pa.array(np.arange(N)))
    pq.write_table(table, path, compression=compression, use_dictionary=False, write_page_checksum=True)
    group = pq.ParquetFile(path).metadata.row_group(0)
    columns = [group.column(i) for i in range(3)]
    # One page a column: its header of thirty to sixty bytes, statistics included, then its body.
    return [(c.data_page_offset + 80, c.data_page_offset + c.total_compressed_size) for c in columns]


def _parquet_zstd(path: Path) -> Ranges:
    return _parquet(path, "zstd")


def _parquet_snappy(path: Path) -> Ranges:
    return _parquet(path, "snappy")


def _parquet_dictionary(path: Path) -> Ranges:
    pq.write_table(pa.table({"t": TIME, "q": Q, "v": V}), path, compression="gzip", write_page_checksum=True)
    return []


def _hdf5(path: Path) -> Ranges:
    with h5py.File(path, "w") as file:
        for name, (samples, unit) in {"time": (TIME, "s"), **CHANNELS}.items():
            file.create_dataset(name, data=samples).attrs["unit"] = unit
        file.create_group("deep").create_dataset("table", data=np.column_stack([Q, V]))
    return []


def _hdf5_checksums(path: Path) -> Ranges:
    with h5py.File(path, "w", libver="latest") as file:
        for name, (samples, unit) in {"time": (TIME, "s"), **CHANNELS}.items():
            item = file.create_dataset(name, data=samples, chunks=(N,), compression="gzip", fletcher32=True)
            item.attrs["unit"] = unit
        chunks = [file[name].id.get_chunk_info(0) for name in file]
        return [(chunk.byte_offset, chunk.byte_offset + chunk.size) for chunk in chunks]


_WRITERS: dict[str, tuple[Callable[[Path], Ranges], ...]] = {
    "mat5": (_controldesk, _compressed_mat, _simulink),
    "mat73": (_matlab73_by_hand,),
    "mdf4": (_mdf, _mdf_deflated, _mdf_transposed),
    "csv": (_german_csv, _english_csv, _blank_csv, _utf16_csv),
    "parquet": (_parquet, _parquet_zstd, _parquet_snappy, _parquet_dictionary),
    "hdf5": (_hdf5, _hdf5_checksums),
}
KINDS = tuple(_WRITERS)
