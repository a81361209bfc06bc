"""Clocks that a file states: scales of HDF5, pairs of seconds and parts of them; and columns of structs."""

import h5py
import numpy as np
import pandas as pd
import pyarrow as pa
import pyarrow.parquet as pq
import pytest

from pipeline.rig_logs import read_recording
from pipeline.rig_logs.source import UnreadableChannelError
from tests.rig_logs.small_logs import TIME, Q, V, load, open_here

SLOW = 100.0 + np.arange(80) / 200.0


def _scales(path, unit="s", name="time"):
    """Two rates in one file, each with the scale of its dimension."""
    with h5py.File(path, "w") as file:
        for group, time, channel, samples in (("fast", TIME, "q", Q), ("slow", SLOW, "v1", V[::5])):
            file[f"{group}/{name}"], file[f"{group}/{channel}"] = time, samples
            if unit:
                file[f"{group}/{name}"].attrs["units"] = unit
            file[f"{group}/{name}"].make_scale(name)
            file[f"{group}/{channel}"].dims[0].attach_scale(file[f"{group}/{name}"])


@pytest.mark.parametrize(("unit", "name"), [("s", "x"), ("seconds since 2026-03-01", "x"), ("", "time")])
def test_each_channel_of_hdf5_has_the_time_of_its_own_scale(tmp_path, unit, name):
    _scales(tmp_path / "log.h5", unit, name)
    channels = {channel.name: channel for channel in read_recording(tmp_path / "log.h5").channels}
    np.testing.assert_array_equal(channels["fast/q"].time, TIME)
    np.testing.assert_array_equal(channels["slow/v1"].time, SLOW)
    assert channels[f"fast/{name}"].time is None


@pytest.mark.parametrize(("unit", "note"), [("ms", "runs over 'fast/x' in ms"), ("Hz", ""), ("", "")])
def test_a_scale_that_is_no_time_in_seconds_is_no_clock(tmp_path, unit, note):
    _scales(tmp_path / "log.h5", unit, "x")
    recording = read_recording(tmp_path / "log.h5")
    assert {channel.time for channel in recording.channels} == {None}
    assert note in " ".join(recording.notes)


def test_a_dimension_of_netcdf_without_values_is_no_clock(tmp_path):
    with h5py.File(tmp_path / "log.nc", "w") as file:
        file["q"] = Q
        file["time"] = np.zeros(len(Q), dtype=">f4")
        file["time"].make_scale("This is a netCDF dimension but not a netCDF variable.       400")
        file["q"].dims[0].attach_scale(file["time"])
    assert {entry.time for entry in open_here(tmp_path / "log.nc").entries()} == {None}


STAMPS = 1_700_000_000_400_000_000 + np.round(TIME * 1e9).astype(np.int64)


@pytest.mark.parametrize(
    ("whole", "part", "per_second", "clock"),
    [
        ("header.stamp.sec", "header.stamp.nanosec", 10**9, "header.stamp.time"),
        pytest.param("stamp_secs", "stamp_nsecs", 10**9, "stamp_time", marks=pytest.mark.long),
        ("tv_sec", "tv_usec", 10**6, "tv_time"),
        ("Seconds", "Milliseconds", 10**3, "time"),
    ],
)
@pytest.mark.parametrize("ending", ["csv", "parquet", "h5"])
def test_seconds_and_parts_of_them_are_one_clock(tmp_path, whole, part, per_second, clock, ending):
    ticks = STAMPS // (10**9 // per_second)
    columns = {whole: ticks // per_second, part: ticks % per_second, "q": Q}
    path = tmp_path / f"log.{ending}"
    if ending == "csv":
        pd.DataFrame(columns).to_csv(path, index=False)
    elif ending == "parquet":
        pd.DataFrame(columns).to_parquet(path)
    else:
        with h5py.File(path, "w") as file:
            for name, column in columns.items():
                file[name] = column
    channels = {channel.name: channel for channel in read_recording(path).channels}
    np.testing.assert_allclose(channels[clock].samples, TIME + 0.4, atol=1e-9)
    assert channels[clock].unit == "s" and {whole, part} <= set(channels)
    asked = read_recording(path, channels=[clock, "q"])
    np.testing.assert_allclose(asked.channel(clock).samples, TIME + 0.4, atol=1e-9)
    np.testing.assert_allclose(asked.channel("q").samples, Q, atol=1e-8)


def test_a_column_that_exceeds_a_second_is_no_part_of_a_clock(tmp_path):
    pd.DataFrame({"sec": np.arange(400), "nsec": 1e9 * TIME * 10.0, "q": Q}).to_parquet(tmp_path / "log.parquet")
    with pytest.raises(UnreadableChannelError, match="no part of a clock"):
        load(open_here(tmp_path / "log.parquet"), "time")
    assert "time" not in [channel.name for channel in read_recording(tmp_path / "log.parquet").channels]


def test_columns_of_structs_in_parquet_are_channels(tmp_path):
    missing = np.arange(len(Q)) == 7
    inner = pa.StructArray.from_arrays([pa.array(V), pa.array(["a"] * len(Q))], ["left", "note"])
    table = {"t": TIME, "m": pa.StructArray.from_arrays([pa.array(Q), inner], ["q", "hv"], mask=pa.array(missing))}
    pq.write_table(pa.table(table), tmp_path / "log.parquet")
    recording = read_recording(tmp_path / "log.parquet")
    channels = {channel.name: channel.samples for channel in recording.channels}
    np.testing.assert_array_equal(channels["m.q"], np.where(missing, np.nan, Q))
    np.testing.assert_array_equal(channels["m.hv.left"], np.where(missing, np.nan, V))
    assert set(channels) == {"t", "m.q", "m.hv.left"} and "'m.hv.note' (string)" in " ".join(recording.notes)
