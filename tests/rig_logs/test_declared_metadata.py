"""What formats define beside the samples is applied and named; what cannot be read leaves the other channels."""

import h5py
import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq
import pytest
from scipy.io import savemat

from pipeline.errors import InputError
from pipeline.rig_logs import read_recording
from tests.rig_logs.small_logs import TIME, Q, V, load, open_here, write_matlab73

RAW = np.round((Q - 5.0) / 0.001).astype("i2")


def _hdf5(path, attributes, raw=RAW):
    with h5py.File(path, "w") as file:
        file["v"] = V
        file.create_dataset("q", data=raw).attrs.update(attributes)
    source = open_here(path)
    return source, load(source, "q")


@pytest.mark.parametrize(
    ("attributes", "missing"),
    [({"_FillValue": RAW[7]}, [RAW[7]]), ({"missing_value": RAW[[3, 9]]}, RAW[[3, 9]]), ({"units": "mm"}, [])],
)
def test_numbers_that_stand_for_no_value_are_none(tmp_path, attributes, missing):
    _, q = _hdf5(tmp_path / "log.h5", attributes)
    np.testing.assert_array_equal(q, np.where(np.isin(RAW, missing), np.nan, RAW))


@pytest.mark.parametrize(
    "attributes", [{"scale_factor": 0.001, "add_offset": 5.0}, {"_Unsigned": "true"}, {"valid_range": [-9000, 2000]}]
)
def test_packed_numbers_are_not_taken_for_the_values(tmp_path, attributes):
    with h5py.File(tmp_path / "log.h5", "w") as file:
        file["v"] = V
        file.create_dataset("q", data=RAW).attrs.update(attributes)
    with pytest.raises(InputError, match=r"holds no plain numbers, but packed .*save its unpacked values"):
        read_recording(tmp_path / "log.h5", channels=["q"])
    assert read_recording(tmp_path / "log.h5").listed == ("v",)


def test_attributes_that_cannot_be_applied_leave_the_channel_out_and_others_are_named(tmp_path):
    with h5py.File(tmp_path / "log.h5", "w") as file:
        file["v"] = V
        file.create_dataset("q", data=RAW).attrs["scale_factor"] = "see manual"
        file.create_dataset("p", data=RAW).attrs["gain"] = 0.5
    source = open_here(tmp_path / "log.h5")
    assert [entry.name for entry in source.entries()] == ["p", "v"]
    assert "gain = 0.5, not applied" in source.notes[0]
    assert "'q' (packed (scale_factor = see manual): save its unpacked values)" in source.notes[1]


def test_the_unit_of_time_since_a_date(tmp_path):
    with h5py.File(tmp_path / "log.nc", "w") as file:
        file.create_dataset("time", data=1e3 * TIME).attrs["units"] = "milliseconds since 2024-01-31 12:00:00"
        file["q"] = Q
    source = open_here(tmp_path / "log.nc")
    assert {entry.name: entry.unit for entry in source.entries()}["time"] == "ms"
    assert source.notes == ["time of 'time' counts from 2024-01-31 12:00:00"]


def test_types_of_hdf5(tmp_path):
    with h5py.File(tmp_path / "log.h5", "w") as file:
        file["switch"], file["z"], file["words"] = V > 0, Q + 1j, ["on", "off"]
        file["ticks"] = 1_700_000_000_123_456_789 + np.arange(400) * 1_000_001
        damaged = file.create_dataset("q", (400,), "f8", chunks=(400,), compression=32001, allow_unknown_filter=True)
        damaged.id.write_direct_chunk((0,), b"x" * 99)
    source = open_here(tmp_path / "log.h5")
    np.testing.assert_array_equal(load(source, "switch"), V > 0)
    np.testing.assert_array_equal(load(source, "ticks"), np.arange(400) * 1_000_001)
    assert "complex" in source.texts["z"] and "blosc" in source.texts["q"] and "words" in source.notes[0]


@pytest.mark.parametrize(("unit", "factor"), [("ms", 1e3), ("s", 1.0), ("", 1.0), ("Sekunden", 1.0), ("µs", 1e6)])
@pytest.mark.parametrize("version", ["5", "7.3"])
def test_the_unit_of_a_time_axis_of_controldesk(tmp_path, unit, factor, version):
    axis = {"Name": "", "Type": 4.0, "Data": TIME * factor, "Unit": unit, "Raster": "HostService"}
    channel = {**axis, "Path": "Model", "XIndex": 1.0, "Name": "q", "Data": Q, "Unit": "mm"}
    if version == "7.3":
        write_matlab73(tmp_path / "log.mat", [axis], [channel])
    else:
        fields = {name: np.array([[channel[name]]], dtype=object) for name in channel}
        record = np.zeros((1, 1), dtype=[(name, object) for name in fields])
        record[0, 0] = tuple(channel.values())
        savemat(tmp_path / "log.mat", {"rec": {"X": axis, "Y": record, "Description": ""}})
    source = open_here(tmp_path / "log.mat")
    time = next(entry.time for entry in source.entries() if entry.name == "q")
    np.testing.assert_allclose(load(source, time), TIME)


@pytest.mark.parametrize(("kind", "word"), [(2, "angle"), (3, "distance"), (4, "index")])
def test_a_master_of_mdf_that_is_no_time(tmp_path, kind, word):
    from asammdf import MDF, Signal

    with MDF(version="4.10") as mdf:
        mdf.append([Signal(Q, TIME, name="q", master_metadata=("x", kind)), Signal(V, TIME, name="v")])
        mdf.save(tmp_path / "log.mf4", overwrite=True)
    source = open_here(tmp_path / "log.mf4")
    assert {entry.time for entry in source.entries()} == {None}
    assert f"an {word}".replace("an d", "a d") in source.notes[0]


@pytest.mark.parametrize("version", ["3.30", "4.10"])
def test_a_channel_of_states_in_mdf_leaves_the_others(tmp_path, version):
    from asammdf import MDF, Signal

    states = {"val_0": 0, "text_0": b"OFF", "val_1": 1, "text_1": b"ON", "default": b"?"}
    with MDF(version=version) as mdf:
        mdf.append([Signal(Q, TIME, name="q"), Signal((V > 0).astype("u1"), TIME, name="state", conversion=states)])
        mdf.save(tmp_path / "log.mdf", overwrite=True)
    source = open_here(next(tmp_path.glob("log.m*")))
    names = [entry.name for entry in source.entries()]
    assert "q" in names and "state" not in names
    assert "'state' (its numbers stand for texts" in source.notes[0]
    np.testing.assert_allclose(load(source, "q"), Q)


@pytest.mark.parametrize("keys", [{"val_0": 65535}, {"lower_0": 65530, "upper_0": 65535}])
@pytest.mark.parametrize("invalid", [slice(7, 9), slice(0, 400)])
def test_numbers_of_mdf_of_which_some_stand_for_a_text(tmp_path, keys, invalid):
    from asammdf import MDF, Signal

    raw = np.arange(400, dtype="u2")
    raw[invalid] = 65535
    conversion = {**keys, "text_0": b"invalid", "default_addr": {"a": 0.1, "b": 2.0}}
    with MDF(version="4.10") as mdf:
        mdf.append([Signal(raw, TIME, name="q", conversion=conversion)])
        mdf.save(tmp_path / "log.mf4", overwrite=True)
    expected = np.where(raw == 65535, np.nan, 0.1 * raw + 2.0)
    np.testing.assert_allclose(load(open_here(tmp_path / "log.mf4"), "q"), expected)


def test_types_of_parquet(tmp_path):
    ticks = 1_700_000_000_123_456_789 + np.arange(400) * 1_000_001
    stamps = pa.array([None, *ticks[1:].tolist()], pa.timestamp("ns"))
    columns = [ticks, Q, V, stamps, pa.array(ticks % 86_400_000_000_000, pa.time64("ns")), ["x"] * 400]
    names = ["t", "q", "q", "stamp", "clock", "word"]
    pq.write_table(pa.Table.from_arrays([pa.array(column) for column in columns], names=names), tmp_path / "a.parquet")
    source = open_here(tmp_path / "a.parquet")
    np.testing.assert_array_equal(load(source, "t"), np.arange(400) * 1_000_001)
    np.testing.assert_array_equal(load(source, "q (2)"), V)
    np.testing.assert_allclose(load(source, "stamp")[1:], np.arange(399) * 1.000001e-3)
    np.testing.assert_allclose(np.diff(load(source, "clock")), 1.000001e-3, rtol=1e-6)
    assert np.isnan(load(source, "stamp")[0]) and source.texts == {"word": "string"}


_TEXTS = (["ms"], np.bytes_("ms"), np.array([b"ms"]), np.array(["ms"], dtype=h5py.string_dtype()))


@pytest.mark.parametrize("name", ["units", "Unit", "UNIT", "unit_string", "Einheit"])
@pytest.mark.parametrize("text", _TEXTS)
def test_units_in_attributes_however_they_are_written(tmp_path, name, text):
    with h5py.File(tmp_path / "log.h5", "w") as file:
        file.create_dataset("t", data=1e3 * TIME).attrs[name] = text
        table = np.rec.fromarrays([1e3 * TIME, Q], names="t,q")[:, None]
        file.create_dataset("table", data=table).attrs[name] = ["ms", "mm"]
    source = open_here(tmp_path / "log.h5")
    assert {entry.name: entry.unit for entry in source.entries()} == {"t": "ms", "table.t": "ms", "table.q": "mm"}
    np.testing.assert_array_equal(load(source, "table.q"), Q)
    field = pa.field("t", pa.float64(), metadata={name: "ms"})
    pq.write_table(pa.Table.from_arrays([pa.array(TIME)], schema=pa.schema([field])), tmp_path / "log.parquet")
    assert open_here(tmp_path / "log.parquet").entries()[0].unit == "ms"


def test_units_in_structs_of_matlab(tmp_path):
    log = {"t": {"data": TIME, "unit": "ms"}, "q": {"time": TIME, "Value": Q, "Unit": "mm", "scale": 0.5}}
    both = {"t": TIME, "q": Q, "units": {"t": "ms", "q": "mm"}}
    series = {"Time": 1e3 * TIME, "Data": Q, "TimeInfo": {"Units": "milliseconds"}, "DataInfo": {"Units": "mm"}}
    savemat(
        tmp_path / "log.mat",
        log
        | {"series": series, "all": both, "SamplingRate": "0.4 kHz"}
        | {"id": {"y": Q, "Ts": 2.0, "TimeUnit": "milliseconds"}},
    )
    source = open_here(tmp_path / "log.mat")
    units = {entry.name: entry.unit for entry in source.entries()}
    assert units == {"t.data": "ms", "q.time": "", "q.Value": "mm", "all.t": "ms", "all.q": "mm", "id.y": ""} | {
        "series.Time": "milliseconds",
        "series.Data": "mm",
    }
    assert source.rates == {"id.Ts": 500.0, "SamplingRate": 400.0} and "q.scale = 0.5, not applied" in source.notes[0]


@pytest.mark.parametrize("holder", ["", "rig", "rig/q"])
def test_a_rate_in_attributes_is_told(tmp_path, holder):
    with h5py.File(tmp_path / "log.h5", "w") as file:
        file["rig/q"] = Q
        file[f"/{holder}"].attrs["sampling_rate"] = np.array([500.0]) if holder else "0.5 kHz"
    assert list(open_here(tmp_path / "log.h5").rates.values()) == [500.0]
    table = pa.table({"q": Q}).replace_schema_metadata({"dt": "2 ms", "q_gain": "2.5"})
    pq.write_table(table, tmp_path / "log.parquet")
    source = open_here(tmp_path / "log.parquet")
    assert source.rates == {"dt": 500.0} and "q_gain = 2.5, not applied" in " ".join(source.notes)
    pq.write_table(
        pa.table([Q], schema=pa.schema([pa.field("q", "f8", metadata={"fs": "500"})])), tmp_path / "q.parquet"
    )
    assert open_here(tmp_path / "q.parquet").rates == {"q.fs": 500.0}


def test_what_netcdf_never_wrote_is_missing(tmp_path):
    with h5py.File(tmp_path / "log.nc", "w") as file:
        file.attrs["_NCProperties"] = "version=2"
        file.create_dataset("q", (400,), "i2", fillvalue=-32767)[:300] = RAW[:300]
    q = load(open_here(tmp_path / "log.nc"), "q")
    np.testing.assert_array_equal(q, np.where(np.arange(400) < 300, RAW, np.nan))


STAMPS = np.datetime64("2024-05-12T10:00:00", "us") + (1e6 * TIME).astype("m8[us]")


@pytest.mark.parametrize("stamps", [STAMPS, STAMPS - STAMPS[0], STAMPS.astype("M8[ms]")])
def test_stamps_and_durations_of_numpy_are_seconds(tmp_path, stamps):
    stamps = stamps.copy()
    stamps[7] = "NaT"
    np.savez(tmp_path / "log.npz", t=stamps, q=Q)
    with h5py.File(tmp_path / "log.h5", "w") as file:
        file.create_dataset("t", data=stamps.astype(h5py.opaque_dtype(stamps.dtype)))
    for log in ("log.npz", "log.h5"):
        source = open_here(tmp_path / log)
        assert source.entries()[0].unit == "s"
        np.testing.assert_allclose(load(source, "t"), np.where(np.arange(400) == 7, np.nan, TIME), atol=1e-9)


def test_whole_numbers_beyond_those_with_a_sign(tmp_path):
    ticks = np.uint64(1 << 63) + np.arange(400, dtype="u8")
    np.savez(tmp_path / "log.npz", t=ticks)
    pq.write_table(pa.table({"t": ticks, "": Q}), tmp_path / "log.parquet")
    for log in ("log.npz", "log.parquet"):
        np.testing.assert_array_equal(load(open_here(tmp_path / log), "t"), np.arange(400))
    assert open_here(tmp_path / "log.parquet").entries()[1].name == "column 2"


@pytest.mark.parametrize("kind", ["i8", "u8"])
@pytest.mark.parametrize("begin", [0, 1_700_000_000_123_456_789])
@pytest.mark.parametrize("place", [0, 200, 399])
def test_the_ends_of_whole_numbers_stay_there(tmp_path, kind, begin, place):
    """They stand for missing values, mostly: no neighbour of the others, and none from which these count."""
    counts = (begin + np.arange(400)).astype(kind)
    counts[place] = np.iinfo(kind).min if kind == "i8" else np.iinfo(kind).max
    expected = np.arange(400.0)
    expected[place] = float(counts[place]) - begin
    expected -= (begin > 0) * expected[int(place == 0)]
    pq.write_table(pa.table({"t": counts, "q": Q}), tmp_path / "log.parquet")
    np.savez(tmp_path / "log.npz", t=counts)
    for log in ("log.npz", "log.parquet"):
        np.testing.assert_array_equal(load(open_here(tmp_path / log), "t"), expected)


def test_one_channel_that_cannot_be_read_leaves_the_others(tmp_path):
    from asammdf import MDF, Signal

    arrays = np.rec.fromarrays([np.zeros((400, 3))], dtype=[("arr", "f8", (3,))])
    with MDF(version="4.10") as mdf:
        mdf.append([Signal(Q, TIME, name="q"), Signal(arrays, TIME, name="arr")])
        mdf.save(tmp_path / "log.mf4", overwrite=True)
    recording = read_recording(tmp_path / "log.mf4")
    assert "arr" not in recording.listed and "'arr'" in recording.notes[-1]
    np.testing.assert_allclose(recording.channel("q").samples, Q)
    with pytest.raises(InputError, match="arr"):
        read_recording(tmp_path / "log.mf4", channels=["arr"])


@pytest.mark.parametrize("fill", [0.0, -9999.0])
def test_chunks_that_were_never_written_hold_no_values(tmp_path, fill):
    """A logger that took space for more rows than it wrote leaves its fill value behind."""
    numbers = np.arange(250.0)
    with h5py.File(tmp_path / "log.h5", "w") as file:
        vector = file.create_dataset("q", shape=(400,), chunks=(50,), dtype="f8", fillvalue=fill)
        vector[:250] = numbers
        matrix = file.create_dataset("m", shape=(400, 2), chunks=(50, 1), dtype="f8", fillvalue=fill)
        matrix[:250] = numbers[:, None]
    source = open_here(tmp_path / "log.h5")
    for name in ("q", "m[:,1]"):
        np.testing.assert_array_equal(load(source, name), np.r_[numbers, np.full(150, np.nan)])
    assert "'q': 3 of 8 chunks were never written, no values" in source.warnings
