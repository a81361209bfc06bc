"""The NARX baseline finds a planted difference equation, predicts freely and names what it cannot do."""

import numpy as np
import pytest

from pipeline.device.device import JOINT
from pipeline.models.model_type import model_from_tree
from pipeline.models.narx import NarxModel, identify_narx
from pipeline.numerics.arrays import FloatArray
from pipeline.numerics.metrics import nrmse
from pipeline.signals.log import Log
from tests.file_columns import unknown_entries

DT = 0.01


def equation(exponents: list[list[int]], coefficients: list[float]) -> NarxModel:
    """Of degree 3 in q and one increment, with one input and without lags of it."""
    return NarxModel(
        structure=np.array([3, 1, 1, 1]), exponents=np.array(exponents), coefficients=np.array(coefficients),
        scales=np.ones(3), interval_s=DT, inputs="squared", bounds=np.array([-0.1, 0.1]),
    )  # fmt: skip


#: A damped double well: δ_{n+1} = δ_n + (0.02 q − 200 q³ − 0.03 δ_n + 1e-11 v²), wells at ±10 mm.
TRUTH = equation([[1, 0, 0], [3, 0, 0], [0, 1, 0], [0, 0, 1]], [0.02, -200.0, -0.03, 1e-11])


def pulses(samples: int, seed: int) -> FloatArray:
    rng = np.random.default_rng(seed)
    v = np.zeros((samples, 1))
    for start in range(60, samples - 150, 150):
        v[start : start + rng.integers(20, 90), 0] = rng.uniform(1000.0, 3000.0)
    return v


def motion(seed: int, samples: int = 2000) -> Log:
    v = pulses(samples, seed)
    q, reached = TRUTH.run(v, np.array([-0.01]), 0.0)
    assert reached == samples
    qdot = np.gradient(q, DT)
    return Log(DT * np.arange(samples), q, qdot, np.gradient(qdot, DT), v)


@pytest.fixture(scope="module")
def model() -> NarxModel:
    return identify_narx([motion(1)], JOINT)


def test_a_planted_equation_predicts_a_new_record_freely(model: NarxModel) -> None:
    new = motion(9)
    run = model.simulate(new.t, new.v, float(new.q[0]), float(new.qdot[0]))
    assert run.status == "ok"
    error = nrmse(new.q, run.q)
    assert error is not None and error < 1e-3


def test_round_trip_through_the_tree_changes_no_prediction(model: NarxModel) -> None:
    again = model_from_tree("narx", model.to_tree())
    t, v = DT * np.arange(400), pulses(400, 3)
    np.testing.assert_array_equal(again.simulate(t, v, -0.01, 0.0).q, model.simulate(t, v, -0.01, 0.0).q)


def test_divergence_is_a_status_with_a_time() -> None:
    """Q grows by 10 % a step: from 1 mm past 0.1 m after ln 100 / ln 1.1 = 48.3 steps."""
    growing = equation([[1, 0, 0], [0, 1, 0]], [0.1, -1.0])
    run = growing.simulate(DT * np.arange(100), np.zeros((100, 1)), 1e-3, 0.0)
    assert (run.status, run.diverged_at_s) == ("diverged", pytest.approx(0.49))
    assert np.isnan(run.q[49:]).all() and np.isfinite(run.qddot[:49]).all()


def test_a_prediction_goes_on_from_the_measured_past() -> None:
    moving = motion(3)
    seen, starts = moving.q.copy(), np.array([129, 180])
    seen[150:160] = np.nan
    predictions = TRUTH.predict(moving.t, moving.v, seen, moving.qdot, starts, np.array([3, 120]))
    for start, predicted in zip(starts, predictions, strict=True):
        np.testing.assert_allclose(predicted, moving.q[start : start + len(predicted)], atol=1e-12)
    assert len(predicted) == 121


def test_its_file_tells_unit_and_meaning_of_every_entry(model: NarxModel) -> None:
    assert not unknown_entries(model)
