"""Ingest of a long log of each format: processor time and largest memory, beside a library that only reads it.

    python benchmarks/bench_long_log.py [--formats parquet mdf mat hdf5 csv] [--rows 54000000] [--folder FOLDER]

54 million rows are half an hour at 30 kHz. The peers read the same four columns into memory and do nothing with them:
pyarrow (Parquet, CSV), asammdf (MDF), SciPy (MAT v5), h5py (HDF5, as MAT v7.3); `debist ingest` checks, resamples and
stores them. Needs some 6 GB of disk. The memory is the resident one, each page counted once and without those of mapped
files, which the system can drop (smaps_rollup), sampled every 50 ms and summed over the processes of the command; Linux
only.
"""

import argparse
import os
import shutil
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pyarrow as pa
import pyarrow.csv
import pyarrow.parquet as pq

TOML = """name = "long"
[logs]
train = ["{log}"]
[channels]
time = {{ channel = "t", unit = "s" }}
q = {{ channel = "q", unit = "m" }}
v1 = {{ channel = "v1", unit = "V" }}
v2 = {{ channel = "v2", unit = "V" }}
"""


NAMES = ("t", "q", "v1", "v2")
PEERS = {
    "parquet": "import pyarrow.parquet as pq; pq.read_table('long.parquet', columns=['t', 'q', 'v1', 'v2'])",
    "mdf": "from asammdf import MDF; m = MDF('long.mf4'); kept = [m.get(n) for n in ('q', 'v1', 'v2')]",
    "mat": "import scipy.io; scipy.io.loadmat('long.mat', variable_names=['t', 'q', 'v1', 'v2'])",
    "hdf5": "import h5py; kept = [column[()] for column in h5py.File('long-73.mat').values()]",
    "csv": "import pyarrow.csv as c; c.read_csv('long.csv')",
}
LOGS = {"parquet": "long.parquet", "mdf": "long.mf4", "mat": "long.mat", "hdf5": "long-73.mat", "csv": "long.csv"}


def pieces(rows: int, rate: float, size: int = 1_000_000) -> Iterator[list[np.ndarray]]:
    """A swing with 3 µm of noise under stepping voltages: t, q, v1, v2."""
    rng = np.random.default_rng(0)
    for first in range(0, rows, size):
        t = np.arange(first, min(first + size, rows)) / rate
        q = 9e-3 * np.sin(7.0 * t) + rng.normal(0.0, 3e-6, t.size)
        v = 3000.0 * (t % 2.0 < 1.0)
        yield [t, q, v, 3000.0 - v]


def write_log(path: Path, kind: str, rows: int, rate: float) -> None:
    """The log in one format."""
    schema = pa.schema([(name, pa.float64()) for name in NAMES])
    if kind == "parquet":
        with pq.ParquetWriter(path, schema, compression="zstd", write_page_checksum=True) as writer:
            for columns in pieces(rows, rate):
                writer.write_table(pa.Table.from_arrays(columns, schema=schema))
    elif kind == "csv":
        with pa.csv.CSVWriter(path, schema) as writer:
            for columns in pieces(rows, rate):
                writer.write_table(pa.Table.from_arrays([c.round(9) for c in columns], schema=schema))
    elif kind == "mat":
        import scipy.io

        whole = [np.concatenate(parts) for parts in zip(*pieces(rows, rate), strict=True)]
        scipy.io.savemat(path, dict(zip(NAMES, whole, strict=True)))
    elif kind == "hdf5":
        _write_hdf5(path, rows, rate)
    else:
        from asammdf import MDF, Signal

        with MDF(version="4.10") as log:
            for i, (t, *columns) in enumerate(pieces(rows, rate)):
                if i == 0:
                    log.append([Signal(c, t, name=name) for name, c in zip(NAMES[1:], columns, strict=True)])
                else:
                    log.extend(0, [(t, None), *((c, None) for c in columns)])
            log.save(path, overwrite=True)


def _write_hdf5(path: Path, rows: int, rate: float) -> None:
    """Variables of a MAT v7.3 file as MATLAB keeps them without compression."""
    import h5py

    with h5py.File(path, "w", userblock_size=512) as file:
        columns = [file.create_dataset(name, (1, rows), "f8", chunks=(1, 1 << 17)) for name in NAMES]
        for column in columns:
            column.attrs["MATLAB_class"] = np.bytes_("double")
        for i, parts in enumerate(pieces(rows, rate)):
            for column, part in zip(columns, parts, strict=True):
                column[0, i * 1_000_000 : i * 1_000_000 + len(part)] = part
    with path.open("r+b") as raw:
        header = b"MATLAB 7.3 MAT-file, Platform: GLNXA64, HDF5 schema 1.00 .".ljust(116) + bytes(8)
        raw.write((header + b"\x00\x02IM").ljust(512, b"\0"))


def _resident(root: int) -> int:
    """Resident bytes of a process and all that came from it, each page once, those of files left out."""
    total, waiting = 0, [root]
    while waiting:
        pid = waiting.pop()
        waiting += _children(pid)
        try:
            lines = Path(f"/proc/{pid}/smaps_rollup").read_text().splitlines()
        except OSError:
            continue
        total += sum(1024 * int(line.split()[1]) for line in lines if line.startswith(("Pss_Anon:", "Pss_Shmem:")))
    return total


def _children(pid: int) -> list[int]:
    try:
        return [int(child) for child in Path(f"/proc/{pid}/task/{pid}/children").read_text().split()]
    except OSError:
        return []


def measured(command: list[str], folder: Path) -> tuple[float, int]:
    """Processor time [s] and largest memory [bytes] of a command and its children."""
    environment = os.environ | {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1", "ARROW_NUM_THREADS": "1"}
    child = subprocess.Popen(command, cwd=folder, env=environment, stdout=subprocess.DEVNULL)
    largest = 0
    while True:
        largest = max(largest, _resident(child.pid))
        pid, status, usage = os.wait4(child.pid, os.WNOHANG)
        if pid:
            break
        time.sleep(0.05)
    if status:
        raise SystemExit(f"{command[-1]} failed")
    return usage.ru_utime + usage.ru_stime, largest


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--formats", nargs="+", choices=list(LOGS), default=list(LOGS))
    parser.add_argument("--rows", type=int, default=54_000_000)
    parser.add_argument("--rate", type=float, default=30_000.0, help="samples per second")
    parser.add_argument("--folder", type=Path, help="where log and run go for the time of the benchmark")
    options = parser.parse_args()
    print("format   rows      log [MB]  ingest [s]  memory [MB]  a library that only reads [s]  its memory [MB]  ratio")
    for kind in options.formats:
        folder = Path(tempfile.mkdtemp(dir=options.folder))
        try:
            log = folder / LOGS[kind]
            channels = TOML.replace('time = {{ channel = "t", unit = "s" }}\n', "") if kind == "mdf" else TOML
            (folder / "long.toml").write_text(channels.format(log=log.name))
            write_log(log, kind, options.rows, options.rate)
            program = "from cli import app; app()"
            ours = measured([sys.executable, "-c", program, "ingest", "long.toml", "-o", "run", "-q"], folder)
            peer = measured([sys.executable, "-c", PEERS[kind]], folder)
            print(
                f"{kind:8} {options.rows:9} {log.stat().st_size / 1e6:8.0f} {ours[0]:11.1f} {ours[1] / 2**20:12.0f}"
                f" {peer[0]:30.1f} {peer[1] / 2**20:16.0f} {ours[0] / peer[0]:6.1f}",
                flush=True,
            )
        finally:
            shutil.rmtree(folder)


if __name__ == "__main__":
    main()
