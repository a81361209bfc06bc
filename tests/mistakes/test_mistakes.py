"""Every mistake of the first week is told, in every format, and honest logs are told nothing of."""

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from pipeline.rig_logs.inspection import inspect_log
from tests.mistakes.table import MISTAKES, Log, Mistake, bursts, log, lose_rows, rows, sentence, told
from tests.prototypes import motion
from tests.rig_logs.small_logs import workbook


def test_each_is_named_once():
    assert len(MISTAKES) == len({mistake.done for mistake in MISTAKES})


@pytest.mark.parametrize("mistake", MISTAKES, ids=lambda mistake: mistake.done)
def test_it_is_told_as_the_page_says(mistake: Mistake) -> None:
    said = sentence(mistake)
    assert said, mistake.tell()
    assert mistake.said in said


def test_nothing_is_said_of_honest_logs():
    assert told([log(1), log(3)]) == []
    halves = [rows(log(1), slice(0, 10_000)), rows(log(1), slice(10_000, None))]
    assert not [text for text in told(halves) if "shared" in text or "gain" in text]


@pytest.mark.parametrize("noise", [0.0, 4.0])
def test_a_sequence_that_is_run_twice_is_no_copy(noise):
    """The device answers alike; each log has its own noise, or the inputs are commands without any."""
    runs = []
    for seed in (50, 51):
        draw, once = np.random.default_rng(seed), motion(20.0, 1000.0, 1, noise=3e-6)
        q = once[1] + draw.normal(0.0, 3e-6, once[0].size)
        runs.append(Log(once[0], q, once[2] + draw.normal(0.0, noise, once[2].shape)))
    assert not [text for text in told(runs) if "shared" in text]


def _at_zero(one: Log) -> Log:
    """The probe of v1 loses its contact for one sample at some hundred places."""
    v = one.v.copy()
    v[50::190, 0] = 0.0
    return Log(one.t, one.q, v)


@pytest.mark.parametrize(
    ("second", "part"),
    [
        (_at_zero, "single-sample spikes, the first at"),
        (lambda one: Log(1e6 * one.t, one.q, one.v), "correct the unit of time"),
        (lambda one: Log(101550.0 + one.t + 40.0 * (one.t >= 10.0), one.q, one.v), "as stamps written hhmmss do"),
    ],
)
def test_their_siblings_are_told(second: Callable[[Log], Log], part: str) -> None:
    assert any(part in text for text in told([log(1), second(log(1))]))


def _write(path: Path, one: Log) -> None:
    """The log in mm and kV, in the format that the ending names."""
    columns = {"time": one.t, "q": 1e3 * one.q, "v1": 1e-3 * one.v[:, 0], "v2": 1e-3 * one.v[:, 1]}
    if path.suffix == ".csv":
        np.savetxt(path, np.column_stack(list(columns.values())), "%.9g", ",", header=",".join(columns), comments="")
    elif path.suffix == ".mat":
        from scipy.io import savemat

        savemat(path, columns)
    elif path.suffix == ".h5":
        import h5py

        with h5py.File(path, "w") as file:
            for name, column in columns.items():
                file[name] = column
    elif path.suffix == ".npz":
        np.savez(path, **columns)
    elif path.suffix == ".parquet":
        import pandas as pd

        pd.DataFrame(columns).to_parquet(path)
    elif path.suffix == ".xlsx":
        workbook(path, [list(columns), *np.stack(list(columns.values()), axis=1).tolist()])
    elif path.suffix == ".tdms":
        import nptdms

        with nptdms.TdmsWriter(path) as writer:
            writer.write_segment([nptdms.ChannelObject("rig", *column) for column in columns.items()])
    elif path.suffix == ".lvm":
        head = "LabVIEW Measurement\t\nSeparator\tTab\nX_Columns\tNo\n***End_of_Header***\t\n"
        table = np.stack(list(columns.values()), axis=1)
        np.savetxt(path, table, "%.9g", "\t", header=head + "\t".join(columns), comments="")
    else:
        from asammdf import MDF, Signal

        signals = [Signal(column, one.t, name=name) for name, column in list(columns.items())[1:]]
        with MDF(version="4.10") as file:
            file.append(signals)
            file.save(path, overwrite=True)


@pytest.mark.parametrize("ending", ["csv", "mat", "h5", "npz", "parquet", "mf4", "xlsx", "tdms", "lvm"])
def test_the_silent_faults_of_a_log_are_told_in_every_format(ending, tmp_path):
    """By `inspect` and by ingest, with what stands in the file."""
    from pipeline.settings.prototype import parse_prototype
    from pipeline.workflow.si_log import read_si
    from pipeline.workflow.steps.ingest import examined

    damaged = bursts(0.0)(lose_rows(log(1)))
    damaged = Log(damaged.t, damaged.q, np.minimum(damaged.v, 2500.0))
    path = tmp_path / f"log.{ending}"
    _write(path, damaged)
    channels = {"q": {"channel": "q", "unit": "mm"}, "v1": {"channel": "v1", "unit": "kV"}}
    channels["v2"] = {"channel": "v2", "unit": "kV"}
    if ending != "mf4":
        channels["time"] = {"channel": "time", "unit": "s"}
    else:
        channels = {name: {**channel, "scale": 1.0} for name, channel in channels.items()}
    document = {"name": "P", "logs": {"train": [path.name]}, "channels": channels}
    prototype = parse_prototype(document, "P.toml")
    warnings = "\n".join(examined(read_si(path, prototype), prototype, "log")[1]["warnings"])
    for part in ("samples at 0 mm, which no motion reaches", "rows are missing though time goes on", "saturated probe"):
        assert part in warnings
    (remarks,) = [channel.remarks for channel in inspect_log(path).channels if channel.name == "q"]
    assert any("which no motion reaches" in remark for remark in remarks)
    assert any("rows are missing" in remark for remark in remarks)
