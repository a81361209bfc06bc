"""The neural baseline runs freely as its equations say, takes its state from the measured past, and learns a device."""

import importlib.util

import numpy as np
import pytest
from scipy.signal import dlsim

from pipeline.errors import CorruptArtifactError, InputError
from pipeline.models.neural import HIDDEN, NEURAL, PAST, WINDOW, NeuralModel, identify_neural
from pipeline.numerics.metrics import nrmse
from pipeline.signals.trajectory import Trajectory
from tests.file_columns import unknown_entries

DT = 0.01
A, B, C = 1.88, -0.9, 0.02  # q_{k+1} = A q_k + B q_{k−1} + C u_k: a damped oscillator of 2.4 Hz


def network(linear):
    """A network without hidden layer."""
    outputs, inputs = np.shape(linear)
    return {
        "linear": np.array(linear, dtype=float), "bias": np.zeros(outputs), "inner": np.zeros((1, inputs)),
        "inner_bias": np.zeros(1), "outer": np.zeros((outputs, 1)),
    }  # fmt: skip


#: Its states are q_k and q_{k−1}; the encoder sees two samples, from which both follow.
OSCILLATOR = NeuralModel.model_validate(
    {
        "step": network([[A, B, C], [1.0, 0.0, 0.0]]), "output": network([[1.0, 0.0]]),
        "encoder": network([[0.0, C, B, A], [0.0, 0.0, 0.0, 1.0]]), "middle": 0.0, "spread": 1.0,
        "input_middle": np.zeros(1), "input_spread": np.ones(1), "interval_s": DT, "inputs": "linear",
        "bounds": np.array([-50.0, 50.0]),
    }
)  # fmt: skip


def drive(samples, seed=1):
    """Steps of random height, none in the first half second."""
    levels = np.random.default_rng(seed).uniform(-1.0, 1.0, samples // 25 + 1)
    return np.repeat(np.r_[0.0, 0.0, levels], 25)[:samples, None]


def truth(u):
    """The oscillator from rest."""
    return dlsim(
        (np.array([[A, B], [1.0, 0.0]]), np.array([[C], [0.0]]), np.array([[1.0, 0.0]]), np.zeros((1, 1)), DT), u
    )[1][:, 0]


def motion(samples, seed=1, shift=0.0):
    u = drive(samples, seed)
    q = truth(u) + shift
    qdot = np.gradient(q, DT)
    return Trajectory(DT * np.arange(samples), q, qdot, np.gradient(qdot, DT), u)


def test_a_free_run_is_that_of_the_state_space():
    x = motion(600)
    run = OSCILLATOR.simulate(x.t, x.v, 0.0, 0.0)
    assert run.status == "ok"
    np.testing.assert_allclose(run.q, x.q, atol=1e-12)


def test_a_prediction_takes_its_state_from_the_measured_past():
    x = motion(600)
    seen, starts = x.q.copy(), np.array([129, 300])
    seen[150:160] = np.nan
    for start, q in zip(starts, OSCILLATOR.predict(x.t, x.v, seen, x.qdot, starts, np.array([3, 120])), strict=True):
        np.testing.assert_allclose(q, x.q[start : start + len(q)], atol=1e-12)
    assert len(q) == 121


def test_the_acceleration_is_the_second_difference_of_what_follows():
    x = motion(600)
    exact = (x.q[2:] - 2.0 * x.q[1:-1] + x.q[:-2]) / DT**2
    predicted = OSCILLATOR.accelerate(x.t, x.v, x.q, x.qdot)
    assert predicted.shape == x.q.shape
    np.testing.assert_allclose(predicted[3:-1], exact[2:], atol=1e-7)


def test_a_run_that_leaves_its_bounds_has_diverged_there():
    narrow = OSCILLATOR.model_copy(update={"bounds": np.array([-0.1, 0.1])})
    x = motion(600)
    beyond = int(np.flatnonzero(np.abs(x.q) > 0.1)[0])
    run = narrow.simulate(x.t, x.v, 0.0, 0.0)
    assert (run.status, run.diverged_at_s) == ("diverged", pytest.approx(x.t[beyond]))
    assert np.isnan(run.q[beyond:]).all() and np.isfinite(run.q[:beyond]).all()


def test_its_file_holds_all_of_it_with_units():
    x = motion(300)
    again = NEURAL.read(OSCILLATOR.to_tree())
    np.testing.assert_array_equal(again.simulate(x.t, x.v, 0.0, 0.0).q, OSCILLATOR.simulate(x.t, x.v, 0.0, 0.0).q)
    assert not unknown_entries(OSCILLATOR)


def test_a_damaged_file_and_another_interval_are_named():
    tree = OSCILLATOR.to_tree()
    with pytest.raises(CorruptArtifactError, match="do not fit 2 inputs"):
        NEURAL.read(tree | {"input_middle": np.zeros(2), "input_spread": np.ones(2)})
    with pytest.raises(CorruptArtifactError, match="encoder"):
        NEURAL.read({name: part for name, part in tree.items() if name != "encoder"})
    with pytest.raises(InputError, match=r"steps at 0\.01 s"):
        OSCILLATOR.simulate(0.005 * np.arange(50), np.zeros((50, 1)), 0.0, 0.0)


def test_without_deepsi_the_extra_is_named(monkeypatch):
    monkeypatch.setattr(importlib.util, "find_spec", lambda name: None)
    with pytest.raises(InputError, match=r'pip install "debist\[neural\]"'):
        identify_neural([motion(600)], inputs="linear")


def test_short_stretches_are_refused(monkeypatch):
    monkeypatch.setattr(importlib.util, "find_spec", lambda name: name)
    with pytest.raises(InputError, match=f"has {WINDOW} samples, a neural model needs {round((PAST + WINDOW) / 0.8)}"):
        identify_neural([motion(WINDOW)], inputs="linear")


@pytest.mark.long
@pytest.mark.filterwarnings("default")
def test_training_finds_an_oscillator_beside_an_offset():
    """In a fifth of its usual steps; with hidden layers a linear device is no more than an example."""
    pytest.importorskip("deepSI")
    shares = []
    model = identify_neural(
        [motion(3000, 1, 5.0), motion(1500, 2, 5.0)], inputs="linear", steps=500,
        on_progress=lambda text, share: shares.append(share),
    )  # fmt: skip
    assert shares == [0.5, 1.0] and model.step.inner.shape == (HIDDEN, 7)
    new = motion(2000, 9, 5.0)
    run = model.simulate(new.t, new.v, 5.0, 0.0)
    assert run.status == "ok" and nrmse(new.q, run.q) < 0.03
