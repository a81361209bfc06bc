"""Error by horizon of predictors whose error is known."""

from collections.abc import Callable

import numpy as np
import pytest

from pipeline.device.device import JOINT
from pipeline.numerics.arrays import FloatArray
from pipeline.scoring.scores import HorizonError, MeasuredPath, Predict, horizon_errors

T = 0.01 * np.arange(1000)
Q = np.sin(2.0 * T)
QDOT = 2.0 * np.cos(2.0 * T)
V = np.zeros((1000, 1))


def horizon_error(
    predict: Predict, t: FloatArray, v: FloatArray, q: FloatArray, qdot: FloatArray, horizon: float
) -> HorizonError:
    return horizon_errors(predict, MeasuredPath(t, v, q, qdot), [horizon], plant=JOINT)[0]


def each(one: Callable[[FloatArray, float, float], FloatArray]) -> Predict:
    """A predictor by one rule, which gets the times since a start and the state there."""

    def predict(t, v, seen, speed, starts, ahead):
        for start, count in zip(starts, ahead, strict=True):
            yield one(t[start : start + count + 1] - t[start], seen[start], speed[start])

    return predict


persistence = each(lambda s, q, qdot: np.full(s.size, q))
exact = each(lambda s, q, qdot: q * np.cos(2.0 * s) + qdot / 2.0 * np.sin(2.0 * s))


def test_a_restart_that_diverges_counts_as_an_error_of_the_whole_range() -> None:
    lost = each(lambda s, q, qdot: np.full(s.size, 0.0 if q > 0 else np.nan))

    def fragile(*signals):
        return (path + gone for path, gone in zip(exact(*signals), lost(*signals), strict=True))

    result = horizon_error(fragile, T, V, Q, QDOT, 0.1)
    assert 0 < result.diverged < result.starts
    assert result.nrmse == pytest.approx(np.sqrt(result.diverged / result.starts), rel=1e-9)
    blind = horizon_error(each(lambda s, q, qdot: np.full(s.size, np.nan)), T, V, Q, QDOT, 0.1)
    assert blind.nrmse is None and blind.diverged == blind.starts


def test_masked_rows_are_neither_start_nor_target() -> None:
    q = Q.copy()
    q[::2] = np.nan
    result = horizon_error(exact, T, V, q, QDOT, 0.02)
    assert result.nrmse is None or result.nrmse < 1e-12
    assert horizon_error(exact, T, V, np.full(1000, np.nan), QDOT, 0.02).starts == 0


def test_all_of_the_measurement_before_a_restart_is_shown_but_for_what_is_before_unknown_inputs() -> None:
    calls: list[tuple[FloatArray, FloatArray, list[int]]] = []

    def shown(t, v, seen, speed, starts, ahead):
        calls.append((t, seen, starts.tolist()))
        return persistence(t, v, seen, speed, starts, ahead)

    q, v = np.where((np.arange(1000) == 505) | (np.arange(1000) < 3), np.nan, Q), V.copy()
    v[700:720] = np.nan
    horizon_error(shown, T, v, q, QDOT, 0.1)
    (t, seen, starts), (later, _, _) = calls
    assert (t[0], t[-1], later[0], later[-1]) == (T[3], T[699], T[720], T[999])
    np.testing.assert_array_equal(seen, q[3:700])
    assert starts == list(range(7, 687, 10))


def test_horizons_share_restarts_and_are_those_of_each_alone() -> None:
    asked: list[int] = []

    def counted(t, v, seen, speed, starts, ahead):
        asked.extend(ahead.tolist())
        return persistence(t, v, seen, speed, starts, ahead)

    q = np.where(np.arange(1000) % 97 == 5, np.nan, Q)
    path = MeasuredPath(T, V, q, QDOT)
    together = horizon_errors(counted, path, [0.01, 0.1, 1.0], plant=JOINT, most_starts=9)
    made = len(asked)
    asked.clear()
    alone = [horizon_errors(counted, path, [h], plant=JOINT, most_starts=9)[0] for h in (0.01, 0.1, 1.0)]
    assert together == alone
    assert made < len(asked) == sum(error.starts for error in alone)
