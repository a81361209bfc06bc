"""The Python API and its gallery on a run whose logs the model itself has written."""

import runpy
import subprocess
import sys
from pathlib import Path

import matplotlib.pyplot
import numpy as np
import pytest

from debist import open_run

GALLERY = sorted((Path(__file__).resolve().parents[2] / "docs" / "gallery").glob("*.py"))


def test_three_lines_from_a_run_to_a_free_run(planted_run):
    run = open_run(planted_run)
    free = run.simulate(log="b")
    assert (run.name, run.logs, run.models) == ("demo-1", ["a", "b"], ["hybrid", "rbf-paper"])
    np.testing.assert_array_equal(free.q_m, free.q_measured_m)  # the log is the model's own run
    assert run.simulate("hybrid").equals(free)  # the last log, if none is named
    scores = run.scores().query("log == 'b' and signal == 'q'").set_index("model").nrmse
    assert scores["hybrid"] == 0.0
    assert list(run.log("a").columns) == [
        "t_s", "q_m", "v1_V", "v2_V", "segment", "qdot_m_per_s", "qddot_m_per_s2",
    ]  # fmt: skip


def test_opening_loads_nothing_heavy():
    code = "import sys; import debist; print(*sys.modules)"
    loaded = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout.split()
    assert {"numpy", "scipy", "pandas", "numba", "pyarrow", "h5py", "matplotlib"}.isdisjoint(loaded)


@pytest.mark.parametrize("script", GALLERY, ids=lambda path: path.stem)
def test_the_gallery_runs(script, planted_run, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("sys.argv", [str(script), str(planted_run)])
    matplotlib.use("agg")
    runpy.run_path(str(script))
    matplotlib.pyplot.close("all")
    assert [path for path in tmp_path.rglob("*.svg") if path.stat().st_size > 1000]
