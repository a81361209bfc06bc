"""Clocks that a file states: scales of HDF5, pairs of seconds and parts of them; and columns of structs."""

import h5py
import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq
import pytest

from pipeline.rig_logs import read_recording
from tests.rig_logs.small_logs import TIME, Q, V, open_here

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


@pytest.mark.parametrize("apart", [12_000_000, 0, -(1 << 60)])
def test_counters_of_one_log_keep_what_lies_between_them_as_far_as_float64_holds_it(tmp_path, apart):
    with h5py.File(tmp_path / "log.h5", "w") as file:
        file["t"], file["t_v"], file["id"] = STAMPS, STAMPS + apart, np.full(STAMPS.size, 7)
    read = {channel.name: channel.samples for channel in read_recording(tmp_path / "log.h5").channels}
    own = apart if abs(apart) < 1 << 53 else 0
    np.testing.assert_array_equal(read["t"], STAMPS - STAMPS[0])
    np.testing.assert_array_equal(read["t_v"], STAMPS - STAMPS[0] + own)
    assert read["id"][0] == 7
