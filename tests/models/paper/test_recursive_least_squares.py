import numpy as np
import pytest

from pipeline.errors import InputError
from pipeline.models.paper.online import RecursiveLeastSquares


def stream(rng, n=400, p=6):
    scales = np.logspace(-3, 3, p)
    matrix = rng.standard_normal((n, p)) * scales
    return matrix, scales


def test_without_forgetting_the_stream_ends_at_the_batch_solution():
    rng = np.random.default_rng(1)
    matrix, scales = stream(rng)
    right = matrix @ (rng.standard_normal(6) / scales) + 0.1 * rng.standard_normal(400)
    online = RecursiveLeastSquares(scales, ridge=1e-9)
    for row, y in zip(matrix, right, strict=True):
        online.update(row, y)
    batch = np.linalg.lstsq(matrix / scales, right, rcond=None)[0]
    assert online.weights * scales == pytest.approx(batch, rel=1e-9)
    assert online.samples == 400


def test_forgetting_weighs_the_past_exponentially():
    rng = np.random.default_rng(2)
    matrix, scales = stream(rng, n=150)
    right = rng.standard_normal(150)
    online = RecursiveLeastSquares(scales, forgetting=0.97, ridge=1e-9)
    for row, y in zip(matrix, right, strict=True):
        online.update(row, y)
    weight = np.sqrt(0.97 ** np.arange(149, -1, -1))
    batch = np.linalg.lstsq(weight[:, None] * matrix / scales, weight * right, rcond=None)[0]
    assert online.weights * scales == pytest.approx(batch, rel=1e-8)


def test_a_change_of_the_plant_is_followed():
    rng = np.random.default_rng(3)
    matrix, scales = stream(rng, n=1200)
    before, after = (rng.standard_normal(6) / scales for _ in range(2))
    online = RecursiveLeastSquares(scales, forgetting=0.98)
    for n, row in enumerate(matrix):
        online.update(row, row @ (before if n < 600 else after))
    assert online.weights == pytest.approx(after, rel=1e-4)


def test_a_column_that_falls_silent_for_a_million_forgetting_times_does_no_harm():
    online = RecursiveLeastSquares(np.ones(2), forgetting=0.5)
    rng = np.random.default_rng(4)
    for _ in range(5000):
        x = rng.standard_normal()
        online.update(np.array([x, 0.0]), 3.0 * x)
    with np.errstate(all="ignore"):
        assert online.weights[0] == pytest.approx(3.0)


@pytest.mark.parametrize("bad", [{"forgetting": 0.0}, {"forgetting": 1.1}, {"ridge": 0.0}])
def test_impossible_settings_are_refused(bad):
    with pytest.raises(InputError):
        RecursiveLeastSquares(np.ones(2), **bad)
