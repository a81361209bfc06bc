"""Cross-validation and inner validation: nothing is scored on what it was fitted to, and the choice is Breiman's."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import pytest

from pipeline.errors import DataRefusedError
from pipeline.numerics.arrays import FloatArray
from pipeline.numerics.identification.trajectory import Trajectory
from pipeline.numerics.rivals.inner_validation import (
    free_run_error,
    held_out_blocks,
    simplest_within_one_standard_error,
)
from pipeline.numerics.scoring.cross_validation import cross_validate_blocks, cross_validate_logs


@dataclass(frozen=True)
class Run:
    q: FloatArray


@dataclass(frozen=True)
class Memory:
    """Knows q at the times it has seen and says 0 elsewhere: it scores 0 only on its own training data."""

    seen: dict[float, float]

    def simulate(self, t: FloatArray, v: FloatArray, q0: float, qdot0: float) -> Run:
        return Run(np.array([self.seen.get(float(x), 0.0) for x in t]))


def remember(data: Sequence[Trajectory]) -> Memory:
    return Memory({float(t): float(q) for x in data for t, q in zip(x.t, x.q, strict=True)})


def square(samples: int, start: float = 0.0) -> Trajectory:
    t = start + 0.01 * np.arange(samples)
    q = np.where(np.arange(samples) % 2 == 0, 1.0, -1.0)
    return Trajectory(t, q, q, q, np.zeros((samples, 1)))


def test_blocks_are_scored_by_models_that_have_not_seen_them() -> None:
    result = cross_validate_blocks([square(400), square(200, 10.0)], remember, 5)
    np.testing.assert_allclose(result.errors, 0.5)
    assert result.mean == pytest.approx(0.5) and result.standard_error == pytest.approx(0.0)


def test_each_log_is_left_out_once() -> None:
    result = cross_validate_logs([[square(50)], [square(60, 1.0), square(30, 2.0)], [square(40, 5.0)]], remember)
    np.testing.assert_allclose(result.errors, 0.5)


def test_a_refusal_is_no_error() -> None:
    def refuse(data: Sequence[Trajectory]) -> Memory:
        raise DataRefusedError("too little")

    result = cross_validate_blocks([square(100)], refuse, 4)
    assert np.isnan(result.errors).all() and result.mean is None and result.standard_error is None


@pytest.mark.parametrize("lengths", [[1000], [600, 400], [10, 10, 10, 970], [7, 5]])
def test_blocks_cover_every_row_once_and_cross_no_gap(lengths: list[int]) -> None:
    data = [square(n, 100.0 * k) for k, n in enumerate(lengths)]
    covered = [(b.source, row) for b in held_out_blocks(data) for row in range(b.start, b.stop)]
    assert sorted(covered) == [(k, row) for k, n in enumerate(lengths) for row in range(n)]


def test_the_simplest_within_one_standard_error_is_chosen() -> None:
    errors = {
        "rich": np.array([0.010, 0.014]),  # mean 0.012, standard error 0.002
        "lean": np.array([0.013, 0.0139]),
        "poor": np.array([0.015, 0.015]),
    }
    assert simplest_within_one_standard_error(errors, {"rich": 40, "lean": 12, "poor": 3}) == "lean"
    assert simplest_within_one_standard_error(errors, {"rich": 12, "lean": 12, "poor": 3}) == "rich"


def test_a_diverged_block_counts_as_one_and_no_more() -> None:
    measured = np.array([0.0, 1.0, 0.0])
    assert free_run_error(measured, np.array([0.0, np.nan, np.nan]), 1.0) == 1.0
    assert free_run_error(measured, measured + 100.0, 1.0) == 1.0
    assert free_run_error(measured, measured + 0.1, 1.0) == pytest.approx(0.1)
