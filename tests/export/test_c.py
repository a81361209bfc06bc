"""C99: compiles without a warning, runs like the model to the last digits, allocates nothing."""

import subprocess

import numpy as np
import pytest
from scipy.interpolate import CubicSpline

from tests.export.joints import (
    COMPILER,
    STRICT,
    CompiledModel,
    data_driven,
    half_steps,
    hybrid,
    overdamped,
    paper,
    sindy,
    subject,
    turning_arm,
)

pytestmark = pytest.mark.skipif(COMPILER is None, reason="no C compiler here")

MODELS = {
    "hybrid": (hybrid(), 2, 3000.0, 1e-9),  # the program has the corrections from tables
    "hybrid without corrections": (hybrid(0, -0.5), 2, 3000.0, 1e-13),
    "data-driven": (data_driven(), 2, 3000.0, 1e-12),
    "data-driven, driven to its wall": (data_driven("linear", 1), 1, 400_000.0, 1e-9),
    "data-driven, one linear input": (data_driven("linear", 1), 1, 300.0, 1e-12),
    "data-driven, lagged input": (data_driven(lag=0.05), 2, 3000.0, 1e-12),
    "data-driven, lag from rest without input": (data_driven(lag=0.05, rest_at_zero=True), 2, 3000.0, 1e-12),
    "data-driven, lagged effect": (data_driven(lag=0.05, effect_lags=True), 2, 3000.0, 1e-12),
    "data-driven, effect lags from rest": (
        data_driven(lag=0.05, rest_at_zero=True, effect_lags=True),
        2,
        3000.0,
        1e-12,
    ),
    "data-driven, lag far below the step": (data_driven(lag=1e-4), 2, 3000.0, 1e-12),
    "data-driven, turning arm": (turning_arm(), 1, 60.0, 1e-12),
    "data-driven, overdamped": (overdamped(), 2, 3000.0, 1e-12),
    "paper": (paper(), 2, 3000.0, 1e-12),
    "sindy": (sindy(), 2, 3000.0, 1e-12),
}
"""Model, inputs, peak of the pulses, tolerance of q as a share of its range."""


@pytest.mark.parametrize("name", MODELS)
def test_compiled_c_runs_like_the_model(name, tmp_path):
    model, inputs, peak, tolerance = MODELS[name]
    what = subject(model, inputs=inputs, peak=peak)
    run = model.simulate(what.t, what.v, *what.start)
    assert run.status == "ok"
    found = CompiledModel(what, tmp_path).free_run(half_steps(what))
    for column, truth in zip(found.T, (run.q, run.qdot, run.qddot), strict=True):
        assert np.ptp(truth) > 0.0
        assert np.abs(column - truth).max() < 3.0 * tolerance * np.ptp(truth)
    assert np.abs(found[:, 0] - run.q).max() < tolerance * np.ptp(run.q)


@pytest.mark.parametrize("name", ["hybrid", "data-driven", "paper"])
def test_single_precision_stays_within_a_thousandth(name, tmp_path):
    model, inputs, peak, _ = MODELS[name]
    what = subject(model, inputs=inputs, peak=peak)
    run = model.simulate(what.t, what.v, *what.start)
    found = CompiledModel(what, tmp_path, single=True).free_run(half_steps(what))
    assert 0.0 < np.abs(found[:, 0] - run.q).max() < 1e-3 * np.ptp(run.q)


def test_steps_of_the_target_follow_the_model(tmp_path):
    what = subject(hybrid(delay=0.0))
    compiled = CompiledModel(what, tmp_path, flags=(f"-D{what.identifier.upper()}_STEP_S=0.001",))
    fine = np.arange(10 * (len(what.t) - 1) + 1) * 1e-3
    v, y = compiled.array(CubicSpline(what.t, what.v)(fine)), compiled.array(np.zeros(3))
    q = np.empty(len(v))
    compiled.call("start", *what.start, v[0])
    for n in range(len(v)):
        if n:
            compiled.call("step", v[n])
        compiled.call("read", y)
        q[n] = y[0]
    run = what.model.simulate(what.t, what.v, *what.start)
    assert np.sqrt(np.mean((q[::10] - run.q) ** 2)) < 1e-3 * np.ptp(run.q)


def test_nothing_is_allocated_and_nothing_is_global(tmp_path):
    what = subject(hybrid())
    CompiledModel(what, tmp_path)
    source = tmp_path / f"{what.identifier}.c"
    subprocess.run([COMPILER, *STRICT, "-c", source, "-o", tmp_path / "model.o"], check=True)
    listed = subprocess.run(["nm", tmp_path / "model.o"], capture_output=True, text=True, check=True).stdout
    symbols = [tuple(line.split()[-2:]) for line in listed.splitlines()]
    assert not [name for kind, name in symbols if kind in "BbDdC"]  # no writable data
    assert {name for kind, name in symbols if kind == "U"} <= {"sqrt", "exp", "expm1", "_GLOBAL_OFFSET_TABLE_"}
    assert {name for kind, name in symbols if kind == "T"} == {
        f"{what.identifier}_{name}" for name in ("start", "step", "advance", "read", "check")
    }
