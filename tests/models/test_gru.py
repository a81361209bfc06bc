"""The GRU rival: equations by hand without PyTorch; with it, training lowers the error and matches its free run."""

import sys

import numpy as np
import pytest

from pipeline.baselines.gru import GruWeights, gru_run, gru_steps
from pipeline.errors import CorruptArtifactError, InputError
from pipeline.models.gru import GruModel, identify_gru
from pipeline.signals.trajectory import Trajectory

DT = 0.01


def weights(units: int = 3, inputs: int = 2, seed: int = 0) -> GruWeights:
    rng = np.random.default_rng(seed)
    shapes = [(3 * units, inputs), (3 * units,), (3 * units, units), (3 * units,), (units, 3), (2, units + 1)]
    return GruWeights(*(rng.normal(size=shape) for shape in shapes))


def model() -> GruModel:
    return GruModel(weights(), DT, np.array([0.02, 0.2]), np.array([9e6, 9e6]), True)


def lagging(samples: int = 700) -> Trajectory:
    """A first-order lag behind a random staircase: easy for any recurrent network."""
    rng = np.random.default_rng(5)
    v = np.repeat(rng.uniform(0.0, 3000.0, samples // 50 + 1), 50)[:samples, None]
    q = np.zeros(samples)
    for n in range(1, samples):
        q[n] = 0.9 * q[n - 1] + 0.1 * 0.01 * (v[n, 0] / 3000.0) ** 2
    qdot = np.gradient(q, DT)
    return Trajectory(DT * np.arange(samples), q, qdot, np.gradient(qdot, DT), v)


def test_the_update_is_that_of_the_equations() -> None:
    w, u = weights(), np.array([[0.3, -0.2], [0.5, 0.1]])
    h = np.tanh(w.encoder[:, :2] @ [0.4, -0.6] + w.encoder[:, 2])
    a, b = np.split(w.input_weights @ u[1] + w.input_bias, 3), np.split(w.hidden_weights @ h + w.hidden_bias, 3)
    reset, update = (1 / (1 + np.exp(-(a[k] + b[k]))) for k in (0, 1))
    after = (1 - update) * np.tanh(a[2] + reset * b[2]) + update * h
    expected = [w.readout[:, :-1] @ x + w.readout[:, -1] for x in (h, after)]
    np.testing.assert_allclose(gru_run(w, u, np.array([0.4, -0.6])), expected, rtol=1e-12)
    np.testing.assert_allclose(
        gru_steps(w, u, np.array([[0.4, -0.6], [0, 0]])), [expected[1] - expected[0]], rtol=1e-12
    )


def test_a_run_is_bounded_for_any_input() -> None:
    run = model().simulate(DT * np.arange(200), np.full((200, 2), 1e6), 0.0, 0.0)
    assert run.status == "ok" and np.all(np.isfinite(run.qddot))


def test_round_trip_through_the_tree_changes_no_prediction() -> None:
    t, v = DT * np.arange(100), np.random.default_rng(1).uniform(0, 3000, (100, 2))
    again = GruModel.from_tree(model().to_tree())
    np.testing.assert_array_equal(again.simulate(t, v, 0.01, 0.0).q, model().simulate(t, v, 0.01, 0.0).q)


def test_a_damaged_tree_and_another_interval_are_named() -> None:
    with pytest.raises(CorruptArtifactError, match="do not fit"):
        GruModel.from_tree(model().to_tree() | {"encoder": np.ones((3, 2))})
    with pytest.raises(InputError, match="resample"):
        model().simulate(0.02 * np.arange(9), np.zeros((9, 2)), 0.0, 0.0)


def test_without_torch_one_line_says_how_to_install_it(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "torch", None)
    with pytest.raises(InputError, match=r"pip install 'debist\[gru\]'"):
        identify_gru([lagging()])


def test_training_learns_a_lag_and_stops_at_its_time_limit() -> None:
    pytest.importorskip("torch", reason="the GRU's training needs the extra `gru`")
    data = lagging()
    trained = identify_gru([data], units=8, iterations=200)
    run = trained.simulate(data.t, data.v, float(data.q[0]), float(data.qdot[0]))
    assert np.sqrt(np.mean((run.q - data.q) ** 2)) < 0.25 * np.std(data.q)
    stopped = identify_gru([data], units=8, iterations=200, time_limit=0.0)
    assert stopped.diagnostics["training_status"] == "time limit"
    assert stopped.diagnostics["iterations"] < 200
