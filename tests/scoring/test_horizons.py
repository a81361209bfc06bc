"""Error by horizon of predictors whose error is known."""

import numpy as np
import pytest

from pipeline.numerics.arrays import FloatArray
from pipeline.scoring.horizons import HorizonError, MeasuredPath, Predict, horizon_errors

T = 0.01 * np.arange(1000)
Q = np.sin(2.0 * T)
QDOT = 2.0 * np.cos(2.0 * T)
V = np.zeros((1000, 1))


def horizon_error(
    predict: Predict, t: FloatArray, v: FloatArray, q: FloatArray, qdot: FloatArray, horizon: float
) -> HorizonError:
    return horizon_errors(predict, MeasuredPath(t, v, q, qdot), [horizon], joint=True)[0]


def persistence(t: FloatArray, v: FloatArray, q: FloatArray, qdot: FloatArray) -> FloatArray:
    return np.full(t.size - q.size + 1, q[-1])


def exact(t: FloatArray, v: FloatArray, q: FloatArray, qdot: FloatArray) -> FloatArray:
    s = t[q.size - 1 :] - t[q.size - 1]
    return q[-1] * np.cos(2.0 * s) + qdot[-1] / 2.0 * np.sin(2.0 * s)


def test_an_exact_model_errs_at_no_horizon() -> None:
    for horizon in (0.01, 0.1, 1.0):
        assert horizon_error(exact, T, V, Q, QDOT, horizon).nrmse == pytest.approx(0.0, abs=1e-12)


def test_persistence_errs_by_the_change_over_the_horizon() -> None:
    """RMS of sin(2(t+h)) − sin 2t is sqrt(2)·sin h; the range of q is 2."""
    result = horizon_error(persistence, T, V, Q, QDOT, 0.1)
    assert result.nrmse == pytest.approx(np.sqrt(2) * np.sin(0.1) / 2, rel=0.05)
    assert result.horizon_s == pytest.approx(0.1)
    assert result.starts == 99
    assert result.interval is not None and result.interval.low < result.nrmse < result.interval.high


def test_a_restart_that_diverges_counts_as_an_error_of_the_whole_range() -> None:
    def fragile(t: FloatArray, v: FloatArray, q: FloatArray, qdot: FloatArray) -> FloatArray:
        return exact(t, v, q, qdot) if q[-1] > 0 else np.full(t.size, np.nan)

    result = horizon_error(fragile, T, V, Q, QDOT, 0.1)
    assert 0 < result.diverged < result.starts
    assert result.nrmse == pytest.approx(np.sqrt(result.diverged / result.starts), rel=1e-9)
    blind = horizon_error(lambda t, v, a, b: np.full(t.size, np.nan), T, V, Q, QDOT, 0.1)
    assert blind.nrmse is None and blind.diverged == blind.starts


def test_few_restarts_have_no_interval() -> None:
    """Ten seconds hold two blocks of three restarts 1 s apart at most."""
    assert horizon_error(persistence, T[:500], V[:500], Q[:500], QDOT[:500], 1.0).interval is None


def test_masked_rows_are_neither_start_nor_target() -> None:
    q = Q.copy()
    q[::2] = np.nan
    result = horizon_error(exact, T, V, q, QDOT, 0.02)
    assert result.nrmse is None or result.nrmse < 1e-12
    assert horizon_error(exact, T, V, np.full(1000, np.nan), QDOT, 0.02).starts == 0


def test_a_record_shorter_than_the_horizon_has_no_start() -> None:
    assert horizon_error(exact, T, V, Q, QDOT, 100.0).starts == 0


def test_up_to_a_second_before_a_restart_is_shown_and_nothing_from_before_a_gap() -> None:
    lengths: dict[int, int] = {}

    def shown(t: FloatArray, v: FloatArray, q: FloatArray, qdot: FloatArray) -> FloatArray:
        lengths[round(t[q.size - 1] / 0.01)] = q.size
        return np.full(t.size - q.size + 1, q[-1])

    horizon_error(shown, T, V, np.where(np.arange(1000) == 505, np.nan, Q), QDOT, 0.1)
    assert [lengths[start] for start in (0, 50, 400, 500, 510, 600, 700)] == [1, 51, 101, 101, 5, 95, 101]


def test_no_prediction_passes_where_the_inputs_are_not_known() -> None:
    v = V.copy()
    v[500:520] = np.nan
    result = horizon_error(exact, T, v, Q, QDOT, 0.1)
    assert result.starts == horizon_error(exact, T, V, Q, QDOT, 0.1).starts - 3  # from rows 490, 500 and 510
    assert result.diverged == 0


def test_of_a_slow_device_a_hundred_samples_before_a_restart_are_shown() -> None:
    lengths: list[int] = []

    def shown(t: FloatArray, v: FloatArray, q: FloatArray, qdot: FloatArray) -> FloatArray:
        lengths.append(q.size)
        return np.full(t.size - q.size + 1, q[-1])

    horizon_error(shown, 1000.0 * T, V, Q, QDOT / 1000.0, 10.0)
    assert max(lengths) == 101


def test_horizons_that_share_restarts_are_those_of_each_alone_from_fewer_predictions() -> None:
    asked: list[int] = []

    def counted(t: FloatArray, v: FloatArray, q: FloatArray, qdot: FloatArray) -> FloatArray:
        asked.append(t.size - q.size)
        return persistence(t, v, q, qdot)

    q = np.where(np.arange(1000) % 97 == 5, np.nan, Q)
    path = MeasuredPath(T, V, q, QDOT)
    together = horizon_errors(counted, path, [0.01, 0.1, 1.0], joint=True, most_starts=9)
    made = len(asked)
    asked.clear()
    alone = [horizon_errors(counted, path, [h], joint=True, most_starts=9)[0] for h in (0.01, 0.1, 1.0)]
    assert together == alone
    assert made < len(asked) == sum(error.starts for error in alone)
