"""MATLAB: the function and the lookup tables, run under GNU Octave where it is installed."""

import subprocess

import numpy as np
import pytest
from scipy.io import loadmat

from pipeline.export.sources import write_matlab
from tests.export.joints import OCTAVE, data_driven, held_slider, hybrid, paper, sindy, subject

needs_octave = pytest.mark.skipif(OCTAVE is None, reason="no GNU Octave here")

MODELS = {
    "hybrid": (hybrid(), 1e-9),
    "data-driven": (data_driven(), 1e-9),
    "data-driven, lagged input": (data_driven(lag=0.05), 1e-9),
    "data-driven, lagged effect": (data_driven(lag=0.05, effect_lags=True), 1e-9),
    "held input, delayed": (held_slider(0.013), 1e-9),
    "paper": (paper(), 1e-9),
    "sindy": (sindy(), 1e-9),
}
"""Model, tolerance of q as a share of its range."""


def octave(script, folder):
    result = subprocess.run(
        [OCTAVE, "--norc", "--quiet", "--eval", script], cwd=folder, capture_output=True, text=True, timeout=120
    )
    assert result.returncode == 0, result.stderr  # Octave may complain on its way out although all went well
    return result.stdout


@needs_octave
@pytest.mark.parametrize("name", MODELS)
def test_the_function_runs_like_the_model(name, tmp_path):
    model, tolerance = MODELS[name]
    what = subject(model, 0.8, inputs=1 if name.startswith("held") else 2)
    write_matlab(what, tmp_path)
    octave(
        f"load {what.identifier}_data.mat; c = check; "
        f"[q, qdot, qddot] = {what.identifier}(c.t, c.v, c.q0, c.qdot0); save -v6 found.mat q qdot qddot",
        tmp_path,
    )
    found, run = loadmat(tmp_path / "found.mat", squeeze_me=True), model.simulate(what.t, what.v, *what.start)
    for signal in ("q", "qdot", "qddot"):
        truth = getattr(run, signal)
        known = np.isfinite(truth)  # one of the models diverges
        np.testing.assert_array_equal(np.isfinite(found[signal]), known)
        assert np.abs(found[signal] - truth)[known].max() < 3.0 * tolerance * np.ptp(truth[known]), signal


@needs_octave
def test_lookup_tables_give_the_curves(tmp_path):
    what = subject(hybrid(), 0.3)
    write_matlab(what, tmp_path)
    at = np.linspace(-0.0199, 0.0199, 57)
    values = " ".join(repr(float(x)) for x in at)
    octave(
        f"load {what.identifier}_data.mat; F = interp1(q_bp, F_table, [{values}]); "
        f"d = interp1(q_bp, d_table, [{values}]); save -v6 found.mat F d",
        tmp_path,
    )
    found, curves = loadmat(tmp_path / "found.mat", squeeze_me=True), what.model.curves(at)
    for name in ("F", "d"):
        assert np.abs(found[name] - curves[name]).max() < 2e-3 * np.ptp(curves[name]), name


def test_the_mat_file_carries_units_range_and_the_models_own_run(tmp_path):
    what = subject(paper(), 0.5)
    script, data = write_matlab(what, tmp_path).written
    assert script.read_text().startswith(f"function [q, qdot, qddot] = {what.identifier}(t, v, q0, qdot0)")
    held = loadmat(data, squeeze_me=True, simplify_cells=True)
    assert held["units"]["dC1_dq_table"] == "F/m"
    np.testing.assert_array_equal(held["validity"]["q"], what.validity.q)
    np.testing.assert_array_equal(held["check"]["q"], what.model.simulate(what.t, what.v, *what.start).q)
    assert write_matlab(what, tmp_path / "again").written[1].read_bytes() == data.read_bytes()
