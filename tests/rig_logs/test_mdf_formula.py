"""Formulas that an MDF log brings along: their channels are named and not read, and nothing is run."""

import numpy as np
import pytest

from pipeline.errors import InputError
from pipeline.rig_logs import read_recording

RAW = np.arange(1, 6, dtype=np.int16)
X = RAW.astype(float)
HOSTILE = "__import__('os').system('echo in > {path}')"
SYMPY = """
def symbols(name):
    return name

def lambdify(symbol, text, **_):  # as sympy's, which compiles the text
    return eval("lambda X: " + text)
"""


def log_with(path, formula: str, version: str = "4.10"):
    from asammdf import MDF, Signal

    with MDF(version=version) as mdf:
        time = np.arange(RAW.size) / 10.0
        mdf.append([Signal(RAW, time, name="q", unit="mm", conversion={"formula": formula} if formula else None)])
        mdf.append([Signal(X / 3.0, time, name="v", unit="V")])
        mdf.save(path, overwrite=True)
    return path


def test_no_formula_is_run_where_sympy_would(tmp_path, monkeypatch):
    """A stand-in for sympy that runs what it is given, as sympy does."""
    (tmp_path / "sympy.py").write_text(SYMPY)
    monkeypatch.syspath_prepend(tmp_path)
    path = tmp_path / "planted"
    with pytest.raises(InputError, match=r"'q' holds .* a conversion formula, .* export the channel") as caught:
        read_recording(log_with(tmp_path / "log.mf4", HOSTILE.format(path=path)), channels=["q"])
    assert not path.exists() and "\n" not in str(caught.value)


def test_other_channels_of_such_a_log_are_read(tmp_path):
    recording = read_recording(log_with(tmp_path / "log.mf4", "2*X1+1"))
    np.testing.assert_array_equal(recording.channel("v").samples, X / 3.0)
    assert "q" not in recording.listed
    (note,) = recording.notes
    assert "'q' (the result of a conversion formula" in note


def test_version_3_counts_its_types_otherwise(tmp_path):
    recording = read_recording(log_with(tmp_path / "log.mdf", "", "3.30"))
    np.testing.assert_array_equal(recording.channel("q").samples, X)
    assert {channel.name: channel.dtype for channel in recording.channels} == {
        "time": "float64",
        "q": "int16",
        "time (2)": "float64",
        "v": "float64",
    }
