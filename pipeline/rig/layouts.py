"""The file formats that the virtual rig can write, by name."""

from pathlib import Path

import numpy as np

from pipeline.numerics.arrays import FloatArray
from pipeline.rig.controldesk import write_mat5, write_mat73
from pipeline.rig.log import Layout

Channels = dict[str, tuple[FloatArray, str]]

_CLOCK = 12.345  # s, since the recorder was started


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
    import pyarrow as pa
    from pyarrow import parquet

    fields, columns = [pa.field("time", pa.float64(), metadata={"unit": "s"})], [pa.array(t)]
    for name, (samples, unit) in channels.items():
        fields.append(pa.field(name, pa.float32(), metadata={"unit": unit}))
        columns.append(pa.array(samples.astype(np.float32)))
    parquet.write_table(pa.table(columns, schema=pa.schema(fields)), path, write_page_checksum=True)


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
    rows = _csv_rows(t, channels, ";").replace(b".", b",")
    path.write_bytes(("\n".join(lines) + "\n").encode("latin-1") + rows)


def _csv_rows(t: FloatArray, channels: Channels, delimiter: str) -> bytes:
    """Rows with times to 0.1 µs and samples to four decimals; a NaN reads ``nan``."""
    import pyarrow as pa
    from pyarrow import csv

    names = [str(i) for i in range(len(channels) + 1)]
    columns = [np.round(t, 7), *(np.round(samples, 4) for samples, _ in channels.values())]
    sink = pa.BufferOutputStream()
    options = csv.WriteOptions(include_header=False, delimiter=delimiter, quoting_style="none")
    csv.write_csv(pa.table(columns, names=names), sink, options)
    return bytes(sink.getvalue().to_pybytes())


_RIG = (("Laser_q", "mm"), ("HV1_meas", "kV"), ("HV2_meas", "kV"))
LAYOUTS = {
    "mat": Layout(".mat", None, *_RIG, write_mat5),
    "mat73": Layout(".mat", None, *_RIG, write_mat73),
    "mf4": Layout(
        ".mf4", None, ("ILD2300.Distance", "mm"), ("HV_left.Umeas", "V"), ("HV_right.Umeas", "V"), _write_mdf
    ),
    "csv": Layout(".csv", ("time", "s"), *_RIG, _write_csv),
    "csv-de": Layout(".csv", ("Zeit", "s"), ("Weg q", "µm"), ("U DE1", "V"), ("U DE2", "V"), _write_csv_german),
    "parquet": Layout(".parquet", ("time", "s"), *_RIG, _write_parquet),
}
