"""One small log of every format."""

from pathlib import Path

import h5py
import pyarrow as pa
import pyarrow.parquet as pq
import pytest

from pipeline.rig.log import write_mat5
from tests.rig_logs.small_logs import TIME, UNITS, Q, V, write_matlab73, write_mdf


@pytest.fixture(scope="session")
def logs(tmp_path_factory) -> dict[str, Path]:
    """One small intact log of each format with the channels time, q, v."""
    folder = tmp_path_factory.mktemp("logs")
    paths = {kind: folder / f"log.{kind}" for kind in ("mat", "mat73", "csv", "parquet", "h5", "mf4")}
    write_mat5(paths["mat"], TIME, {"q": (Q, "mm"), "v": (V, "V")})
    axis = {"Name": "", "Type": 4.0, "Data": TIME, "Unit": "", "Raster": "HostService"}
    channel = {**axis, "Path": "Model Root/Scope", "XIndex": 1.0}
    write_matlab73(paths["mat73"], [axis], [{**channel, "Name": "q", "Data": Q}, {**channel, "Name": "v", "Data": V}])
    rows = "".join(f"{t:.3f};{q:.9f};{v:.1f}\n" for t, q, v in zip(TIME, Q, V, strict=True)).replace(".", ",")
    paths["csv"].write_text("# Prüfstand\ntime;q;v\n[s];[mm];[V]\n" + rows, encoding="latin-1")
    fields = [pa.field(name, pa.float64(), metadata={"unit": unit}) for name, unit in UNITS]
    pq.write_table(pa.Table.from_arrays([TIME, Q, V], schema=pa.schema(fields)), paths["parquet"])
    with h5py.File(paths["h5"], "w") as file:
        for (name, unit), values in zip(UNITS, (TIME, Q, V), strict=True):
            file.create_dataset(name, data=values).attrs["unit"] = unit
    write_mdf(paths["mf4"])
    return paths
