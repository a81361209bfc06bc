"""Held-out errors and inner validation: each segment counts by its length, and the choice is Breiman's."""

from dataclasses import dataclass

import numpy as np
import pytest

from pipeline.numerics.arrays import FloatArray
from pipeline.scoring.cross_validation import (
    held_out_blocks,
    held_out_error,
    simplest_within_one_standard_error,
)
from pipeline.signals.log import Log


@dataclass(frozen=True)
class Run:
    q: FloatArray


def square(samples: int, start: float = 0.0) -> Log:
    t = start + 0.01 * np.arange(samples)
    q = np.where(np.arange(samples) % 2 == 0, 1.0, -1.0)
    return Log(t, q, q, q, np.zeros((samples, 1)))


def test_segments_count_by_their_length_and_a_divergence_as_a_miss_of_the_whole_range() -> None:
    whole = square(300, 1.0)
    ended = square(100)

    class Lost:
        fine_voltages = False

        def simulate(self, t: FloatArray, v: FloatArray, q0: float, qdot0: float) -> Run:
            return Run(whole.q if t[0] == whole.t[0] else np.where(t < 0.5, ended.q, np.nan))

    assert held_out_error(Lost(), [whole]) == 0.0
    assert held_out_error(Lost(), [whole, ended]) == pytest.approx(0.5)  # √(100 / 400)


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
