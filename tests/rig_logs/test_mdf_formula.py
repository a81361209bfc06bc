"""Formulas that an MDF log brings along: arithmetic is worked out, anything else is refused and never run."""

import numpy as np
import pytest

from pipeline.errors import InputError
from pipeline.rig_logs import read_recording
from pipeline.rig_logs.mdf import convert

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


@pytest.mark.parametrize(
    ("formula", "expected"),
    [
        ("2*X1+1", 2.0 * X + 1.0),
        ("X1*(1/2)", X / 2.0),
        ("sqrt(X1) + exp(-X1)", np.sqrt(X) + np.exp(-X)),
        ("(X1>2)*3 - pow(X1, 2)", (X > 2.0) * 3.0 - X**2),
        ("9**9**9**9*X1", np.full(5, np.inf)),
        ("7.5e-1", np.full(5, 0.75)),
    ],
)
def test_arithmetic_is_worked_out(tmp_path, formula, expected):
    recording = read_recording(log_with(tmp_path / "log.mf4", formula))
    np.testing.assert_allclose(recording.channel("q").samples, expected, rtol=1e-15)


@pytest.mark.parametrize(
    "formula", ["X1^2", "X1 &", "X1.real", "f(X1)", "X1 if X1 else 0", "(lambda: X1)()", "1," * 600]
)
def test_anything_else_is_refused(formula):
    with pytest.raises(ValueError, match=r"."):
        convert(formula, RAW)


def test_no_formula_is_run_where_sympy_would(tmp_path, monkeypatch):
    """A stand-in for sympy that runs what it is given, as sympy does."""
    (tmp_path / "sympy.py").write_text(SYMPY)
    monkeypatch.syspath_prepend(tmp_path)
    path = tmp_path / "planted"
    with pytest.raises(InputError, match=r"'q': the log's conversion formula .* export the channel") as caught:
        read_recording(log_with(tmp_path / "log.mf4", HOSTILE.format(path=path)))
    assert not path.exists() and "\n" not in str(caught.value)


def test_other_channels_of_such_a_log_are_read(tmp_path):
    path = log_with(tmp_path / "log.mf4", "f(X1)")
    np.testing.assert_array_equal(read_recording(path, channels=["v"]).channel("v").samples, X / 3.0)


def test_version_3_counts_its_types_otherwise(tmp_path):
    recording = read_recording(log_with(tmp_path / "log.mdf", "", "3.30"))
    np.testing.assert_array_equal(recording.channel("q").samples, X)
    assert {channel.name: channel.dtype for channel in recording.channels} == {
        "time": "float64",
        "q": "int16",
        "time (2)": "float64",
        "v": "float64",
    }
