"""Every format gives back what was written: samples, units, time bases."""

from decimal import Decimal

import numpy as np
import pytest

from pipeline.errors import InputError
from pipeline.rig_logs import read_recording
from pipeline.rig_logs.draft import toml_draft
from pipeline.rig_logs.source import CsvOptions
from pipeline.workflow.inspection import inspect
from tests.rig_logs.small_logs import (
    TIME,
    Q,
    V,
    matlab_object,
    old_matlab_object,
    open_here,
    read_here,
    save_plain_mat,
    write_matlab73,
)

START = {"mf4": 12.345}
FLOAT32 = {"mat", "mf4"}


@pytest.mark.parametrize("kind", ["mat", "mat73", "csv", "parquet", "h5", "mf4"])
def test_every_format_through_the_child(logs, kind):
    recording = read_recording(logs[kind], channels=["q", "v"])
    assert [channel.name for channel in recording.channels] == ["q", "v"]
    q = recording.channel("q")
    assert q.samples.dtype == np.float64 and not q.samples.flags.writeable
    np.testing.assert_allclose(q.samples, Q, rtol=2e-7 if kind in FLOAT32 else 1e-8, atol=1e-9)
    np.testing.assert_array_equal(recording.channel("v").samples, V)
    if kind in ("mat", "mat73", "mf4"):
        np.testing.assert_allclose(q.time, TIME + START.get(kind, 0.0), rtol=1e-15)
        assert q.time is recording.channel("v").time
    else:
        assert q.time is None
        np.testing.assert_allclose(read_recording(logs[kind], channels=["time"]).channels[0].samples, TIME, atol=1e-12)
    assert q.unit == ("" if kind == "mat73" else "mm")
    assert {"time", "q", "v"} <= set(recording.listed)


def test_format_is_found_by_content_not_by_suffix(logs, tmp_path):
    disguised = tmp_path / "log.csv"
    disguised.write_bytes(logs["mat"].read_bytes())
    assert read_recording(disguised, channels=["q"]).format == "MAT v5, ControlDesk"


def test_mdf_channels_keep_their_own_rasters(logs):
    recording = read_recording(logs["mf4"], channels=["temperature", "q"])
    slow, fast = recording.channels
    assert slow.samples.size == 40 and fast.samples.size == 400
    np.testing.assert_allclose(slow.time, 12.345 + 0.01 * np.arange(40))
    assert (slow.unit, slow.dtype) == ("°C", "int16")


@pytest.mark.parametrize("compressed", [False, True])
def test_plain_mat_variables_against_scipy(tmp_path, compressed):
    path = tmp_path / "plain.mat"
    save_plain_mat(path, compressed=compressed)
    found = read_here(path)
    assert set(found) == {"t", "q", "counts", "table(:,1)", "table(:,2)", "table(:,3)", "nested.deep.v"}
    np.testing.assert_array_equal(found["t"], TIME)
    np.testing.assert_array_equal(found["q"], Q.astype(np.float32))
    np.testing.assert_array_equal(found["counts"], np.arange(400))
    np.testing.assert_array_equal(found["table(:,3)"], V)
    np.testing.assert_array_equal(found["nested.deep.v"], V)


def test_several_rasters_by_xindex(tmp_path):
    path = tmp_path / "rasters.mat"
    slow = np.arange(40) * 0.01
    axes = [
        {"Name": "", "Data": TIME, "Unit": "s", "Raster": "fast"},
        {"Name": "", "Data": slow, "Unit": "s", "Raster": "slow"},
    ]
    channels = [
        {"Name": '"q"', "Data": Q, "Unit": "mm", "Path": "A/1", "XIndex": 1.0},
        {"Name": "v", "Data": slow, "Unit": "V", "Path": "A/2", "XIndex": 2.0},
    ]
    for shift in (0.0, -1.0):  # counted from 1, and from 0
        shifted = [{**channel, "XIndex": channel["XIndex"] + shift} for channel in channels]
        write_matlab73(path, axes, shifted)
        times = {entry.name: entry.time for entry in open_here(path).entries()}
        assert times == {"time (fast)": None, "time (slow)": None, "q": "time (fast)", "v": "time (slow)"}
        np.testing.assert_array_equal(read_here(path)["time (slow)"], slow)


def test_controldesk_with_one_channel_has_no_references(tmp_path):
    path = tmp_path / "one.mat"
    axis = {"Name": "t", "Data": TIME, "Unit": "s", "Raster": ""}
    write_matlab73(path, [axis], [{**axis, "Name": "q", "Data": Q, "Unit": "", "XIndex": 1.0}])
    np.testing.assert_array_equal(read_here(path)["q"], Q)
    assert open_here(path).entries()[1].time == "t"


def test_channels_of_another_length_than_the_axis_have_no_time(tmp_path):
    path = tmp_path / "odd.mat"
    axis = {"Name": "t", "Data": TIME, "Unit": "s", "Raster": ""}
    write_matlab73(path, [axis], [{**axis, "Name": "q", "Data": Q[:-1], "Unit": "", "XIndex": 1.0}])
    source = open_here(path)
    assert source.entries()[1].time is None
    assert "399 samples" in source.notes[0]


def test_parquet_and_hdf5_hold_more_than_vectors(tmp_path):
    import h5py
    import pyarrow as pa
    import pyarrow.parquet as pq

    stamps = pa.array((TIME * 1e9).astype(np.int64) + 10**18, pa.timestamp("ns"))
    nulls = pa.array([None, 1.0] * 200)
    pq.write_table(pa.table({"when": stamps, "q": nulls, "text": ["a"] * 400}), tmp_path / "a", row_group_size=150)
    found = read_here(tmp_path / "a")
    assert set(found) == {"when", "q"}
    np.testing.assert_allclose(found["when"], TIME, atol=2e-9)
    assert np.isnan(found["q"][::2]).all() and (found["q"][1::2] == 1.0).all()
    with h5py.File(tmp_path / "b", "w") as file:
        file["run/table"] = np.column_stack([TIME, Q])
        file["rows"] = np.rec.fromarrays([TIME, Q], names="t,q")
        file["again"] = file["run/table"]
        file["soft"] = h5py.SoftLink("/run/table")
    found = read_here(tmp_path / "b")
    assert set(found) == {"again[:,0]", "again[:,1]", "rows.t", "rows.q"}
    np.testing.assert_array_equal(found["rows.q"], Q)
    np.testing.assert_array_equal(found["again[:,1]"], Q)


def test_durations_in_parquet_are_seconds_and_what_is_no_number_is_told(tmp_path):
    import pyarrow as pa
    import pyarrow.parquet as pq

    passed = pa.array((TIME * 1e6).round().astype(np.int64), pa.duration("us"))
    path = tmp_path / "log.parquet"
    pq.write_table(pa.table({"passed": passed, "q": Q, "mode": ["run"] * TIME.size}), path)
    np.testing.assert_allclose(read_here(path)["passed"], TIME, atol=1e-6)
    recording = read_recording(path)
    assert [(channel.name, channel.unit) for channel in recording.channels] == [("passed", "s"), ("q", "")]
    assert recording.notes == ("no numbers, and left out: 'mode' (string)",)


@pytest.mark.parametrize(("digits", "scale"), [(20, 0), (38, 9), (76, 9)])
def test_decimals_in_parquet_are_exact_from_their_first_one_on(tmp_path, digits, scale):
    """Stamps in ns since 1970; a float64 holds them to 256 ns."""
    import pyarrow as pa
    import pyarrow.parquet as pq

    counts = [1_764_300_000_123_456_789 + 333_333 * i for i in range(400)]
    stamps = pa.array([None if i == 3 else Decimal(count).scaleb(-scale) for i, count in enumerate(counts)])
    table = {"t": stamps.cast((pa.decimal256 if digits > 38 else pa.decimal128)(digits, scale)), "q": Q}
    pq.write_table(pa.table(table | {"v": pa.array([Decimal("1.25")] * 400)}), tmp_path / "log.parquet")
    read = read_here(tmp_path / "log.parquet")
    expected = np.where(np.arange(400) == 3, np.nan, 333_333.0 * np.arange(400) / 10.0**scale)
    np.testing.assert_allclose(read["t"], expected, rtol=1e-15)
    assert set(read["v"]) == {1.25}


def test_shared_logs(shared_folder):
    """The example rigs: formats, rates, units and first samples as their description says."""
    rigs = shared_folder / "rig-logs"
    p1 = read_recording(rigs / "P1/train.mat", channels=["Laser_q", "HV1_meas"])
    assert [channel.unit for channel in p1.channels] == ["mm", "kV"]
    assert p1.channels[0].samples.size == 1_125_000
    np.testing.assert_allclose(np.diff(p1.channels[0].time[:1000]), 1 / 30_000.0, rtol=1e-9)
    p3 = read_recording(rigs / "P3/train.csv", csv=CsvOptions())
    assert [(channel.name, channel.unit) for channel in p3.channels] == [
        ("Zeit", "s"),
        ("Weg q", "µm"),
        ("U DE1", "V"),
        ("U DE2", "V"),
    ]
    assert int(np.isnan(p3.channel("Weg q").samples).sum()) == 3
    assert p3.channel("Weg q").samples[0] == -9923.0
    genuine = read_recording(shared_folder / "measured/controldesk/aquisicao_01_mpc_modelo_NARX.mat")
    assert genuine.listed == ("time", "In1", "In2", "In7")
    assert genuine.channel("In2").time.size == 60_001
    assert genuine.channel("In2").time[1] == pytest.approx(0.9999267e-3, rel=1e-4)


@pytest.mark.long
def test_shared_mdf(shared_folder):
    p2 = read_recording(shared_folder / "rig-logs/P2/train.mf4")
    assert p2.channel("ILD2300.Distance").time[0] == pytest.approx(12.345, abs=1e-4)
    assert [channel.unit for channel in p2.channels] == ["s", "mm", "V", "V"]


def simulink_log(dtype=(("values", object), ("dimensions", object), ("label", object))):
    """What a scope with three signals saves as "Structure With Time"."""
    signals = np.zeros(3, dtype=list(dtype))
    signals[0] = (Q[:, None], 1, "laser")
    signals[1] = (np.column_stack([V, 2.0 * V]), 2, "amplifiers")
    signals[2] = (V[None, None, :], 1, "")
    return {"time": TIME[:, None], "signals": signals, "blockName": "rig/Scope"}


def test_simulinks_structure_with_time(tmp_path):
    from scipy.io import savemat

    savemat(tmp_path / "scope.mat", {"ScopeData": simulink_log()})
    source = open_here(tmp_path / "scope.mat")
    assert source.format == "MAT v5, Simulink" and not source.notes
    assert [(entry.name, entry.time) for entry in source.entries()] == [
        ("ScopeData.time", None),
        ("laser", "ScopeData.time"),
        ("amplifiers(:,1)", "ScopeData.time"),
        ("amplifiers(:,2)", "ScopeData.time"),
        ("ScopeData.signals(3).values", "ScopeData.time"),
    ]
    found = read_here(tmp_path / "scope.mat")
    np.testing.assert_array_equal(found["laser"], Q)
    np.testing.assert_array_equal(found["amplifiers(:,2)"], 2.0 * V)
    np.testing.assert_array_equal(found["ScopeData.signals(3).values"], V)
    by_place = read_recording(tmp_path / "scope.mat", channels=["ScopeData.signals(1).values"]).channels[0]
    np.testing.assert_array_equal(by_place.samples, Q)
    np.testing.assert_array_equal(by_place.time, TIME)


def test_elements_of_a_struct_array_are_channels(tmp_path):
    from scipy.io import savemat

    runs = np.zeros(2, dtype=[("q", object), ("note", object)])
    runs[0], runs[1] = (Q, "first"), (V, "second")
    savemat(tmp_path / "array.mat", {"runs": runs})
    found = read_here(tmp_path / "array.mat")
    assert set(found) == {"runs(1).q", "runs(2).q"}
    np.testing.assert_array_equal(found["runs(2).q"], V)


def test_a_table_whose_data_are_not_there_leaves_the_other_channels(tmp_path):
    """A table in version 5 (an opaque variable, its data in a nameless one) and in version 7.3."""
    import h5py
    from scipy.io import savemat

    plain = tmp_path / "plain.mat"
    savemat(plain, {"q": Q})
    raw = plain.read_bytes()
    (tmp_path / "table.mat").write_bytes(raw[:128] + matlab_object("log", "table") + raw[128:])
    with h5py.File(tmp_path / "table73.mat", "w", userblock_size=512) as file:
        file["q"] = Q
        item = file.create_dataset("log", data=np.zeros((1, 6), dtype=np.uint32))
        item.attrs["MATLAB_class"], item.attrs["MATLAB_object_decode"] = np.bytes_("table"), np.int32(3)
    with (tmp_path / "table73.mat").open("r+b") as file:
        file.write(b"MATLAB 7.3 MAT-file, Platform: GLNXA64".ljust(116) + b"\0" * 8 + b"\0\x02IM")
    for name in ("table.mat", "table73.mat"):
        source = open_here(tmp_path / name)
        assert [entry.name for entry in source.entries()] == ["q"]
        assert "'log' (a MATLAB table" in source.notes[0] and "save its columns as arrays" in source.notes[0]


def test_an_object_of_an_old_class_is_named_and_none_of_its_fields_is_a_channel(tmp_path):
    from scipy.io import loadmat, savemat

    savemat(tmp_path / "plain.mat", {"q": Q})
    raw, data = (tmp_path / "plain.mat").read_bytes(), old_matlab_object("data", "iddata", "last", [2021.0, 4.0])
    (path := tmp_path / "object.mat").write_bytes(raw + data)
    assert loadmat(path)["data"]["last"][0, 0][0, 0] == 2021.0  # SciPy takes it for an object too
    source = open_here(path)
    assert [entry.name for entry in source.entries()] == ["q"]
    assert "'data' (a MATLAB iddata" in source.notes[0] and "save its vectors (data.u, data.y)" in source.notes[0]


def test_arrays_that_are_no_channels_are_told_by_their_shape(tmp_path):
    import h5py

    runs, wide = np.random.default_rng(0).normal(size=(3, 400, 2)), np.zeros((1100, 1500))
    with h5py.File(path := tmp_path / "runs.h5", "w") as file:
        file["train/u"], file["wide"], file["one"], file["none"] = runs, wide, np.ones((1, 1, 1)), np.zeros((0, 3, 2))
        file["remark"] = "text"
    with pytest.raises(InputError, match=r"runs.h5: the log holds no vector of numbers: train/u is 3 × 400 × 2"):
        toml_draft([inspect(path)[0]])


def test_rows_of_a_matrix_that_is_wider_than_high_are_channels(tmp_path):
    import h5py
    from scipy.io import savemat

    table = np.vstack([np.arange(Q.size) * 0.01, Q, 2.0 * Q])
    with h5py.File(tmp_path / "rows.h5", "w") as file:
        file.create_dataset("run/data", data=table, chunks=(3, 64))
    savemat(tmp_path / "rows.mat", {"data": table})
    for name, channel in (("rows.h5", "run/data[1,:]"), ("rows.mat", "data(2,:)")):
        recording = read_recording(tmp_path / name)
        np.testing.assert_array_equal(recording.channel(channel).samples, Q)
        assert len(recording.channels) == 3


def test_logs_that_differ_in_the_name_of_the_variable_have_a_way_out(tmp_path):
    from scipy.io import savemat

    run = {"y": Q, "u": V}
    one, two, both = (tmp_path / f"{name}.mat" for name in ("one", "two", "both"))
    savemat(one, {"run1": run})
    savemat(two, {"run2": run | {"t": TIME}})
    savemat(both, {"run1": run, "run2": run | {"t": TIME}})
    for path in (one, two):
        (channel,) = read_recording(path, channels=["*.u"]).channels
        assert channel.name == "*.u"
        np.testing.assert_array_equal(channel.samples, V)
    np.testing.assert_array_equal(read_recording(both, channels=["*.t"]).channels[0].samples, TIME)
    with pytest.raises(InputError, match=r"both.mat: no channel '\*.u'; it has 'run1.y', 'run1.u'"):
        read_recording(both, channels=["*.u"])


def test_simulinks_structure_with_time_in_version_7_3(tmp_path):
    import h5py

    from tests.rig_logs.small_logs import write_numbers, write_text

    path = tmp_path / "scope73.mat"
    with h5py.File(path, "w", userblock_size=512) as file:
        references, log = file.create_group("#refs#"), file.create_group("ScopeData")
        write_numbers(log, "time", TIME)
        signals = log.create_group("signals")
        for field, values in (("values", (Q, V)), ("label", ("laser", "amplifier"))):
            write = write_text if field == "label" else write_numbers
            items = [write(references, f"{field}{i}", value) for i, value in enumerate(values)]
            data = signals.create_dataset(field, (2, 1), dtype=h5py.ref_dtype)
            for i, item in enumerate(items):
                data[i, 0] = item.ref
    with path.open("r+b") as file:
        file.write(b"MATLAB 7.3 MAT-file, Platform: GLNXA64".ljust(116) + b"\0" * 8 + b"\0\x02IM")
    recording = read_recording(path, channels=["laser", "amplifier"])
    assert recording.format == "MAT v7.3, Simulink"
    for channel, values in zip(recording.channels, (Q, V), strict=True):
        np.testing.assert_array_equal(channel.samples, values)
        np.testing.assert_array_equal(channel.time, TIME)
