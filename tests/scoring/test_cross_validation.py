"""Cross-validation and inner validation: nothing is scored on what it was fitted to, and the choice is Breiman's."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import pytest

from pipeline.numerics.arrays import FloatArray, IntArray
from pipeline.scoring.cross_validation import (
    block_folds,
    fold_score,
    held_out_blocks,
    kept_segments,
    log_folds,
    not_above_lowest,
    signal_ranges,
    simplest_within_one_standard_error,
)
from pipeline.scoring.wells import NoWells, Wells
from pipeline.signals.log import Log

WELLS = Wells(-1.0, 1.0, 0.0)


@dataclass(frozen=True)
class Run:
    q: FloatArray
    qdot: FloatArray
    qddot: FloatArray


@dataclass(frozen=True)
class Memory:
    """Knows q at the times it has seen and says 0 elsewhere: it errs by nothing only on its own training data."""

    seen: dict[float, float]
    fine_voltages: bool = False

    def simulate(self, t: FloatArray, v: FloatArray, q0: float, qdot0: float) -> Run:
        q = np.array([self.seen.get(float(x), 0.0) for x in t])
        return Run(q, q, q)


def remember(data: Sequence[Log]) -> Memory:
    return Memory({float(t): float(q) for x in data for t, q in zip(x.t, x.q, strict=True)})


def square(samples: int, start: float = 0.0) -> Log:
    t = start + 0.01 * np.arange(samples)
    q = np.where(np.arange(samples) % 2 == 0, 1.0, -1.0)
    return Log(t, q, q, q, np.zeros((samples, 1)))


def stretches(x: Log, segment: IntArray) -> list[Log]:
    rows = [np.flatnonzero(segment == k) for k in range(segment.max() + 1)]
    return [Log(x.t[r], x.q[r], x.qdot[r], x.qddot[r], x.v[r]) for r in rows]


@pytest.mark.parametrize("deal", [block_folds, log_folds])
def test_no_model_is_scored_on_what_it_has_seen(deal) -> None:  # type: ignore[no-untyped-def]
    logs = [square(400), square(200, 10.0), square(300, 20.0)]
    whole = [np.zeros(len(x.t), dtype=np.int64) for x in logs]
    folds = deal(whole, 3)
    for fold in range(3):
        train, test = (
            [
                part
                for x, seg, number in zip(logs, whole, folds, strict=True)
                for part in stretches(x, kept_segments(seg, keep(number)))
            ]
            for keep in (lambda n, f=fold: n != f, lambda n, f=fold: n == f)
        )
        model, ranges = remember(train), signal_ranges(logs)
        assert fold_score(model, test, ranges, WELLS).nrmse == {s: pytest.approx(0.5) for s in ("q", "qdot", "qddot")}
        assert fold_score(model, train, ranges, WELLS).nrmse["q"] == 0.0
        assert sum(len(x.t) for x in train + test) == 900


def test_a_divergence_counts_as_a_missed_fold_in_the_wrong_well() -> None:
    x = square(100)

    class Lost:
        fine_voltages = False

        def simulate(self, t: FloatArray, v: FloatArray, q0: float, qdot0: float) -> Run:
            q = np.where(t < 0.5, x.q, np.nan)
            return Run(q, q, q)

    score = fold_score(Lost(), [x], signal_ranges([x]), WELLS)
    assert score.nrmse["q"] == 1.0 and score.diverged == 1 and score.samples == 100
    assert score.well_agreement == 0.5
    assert fold_score(Lost(), [x], signal_ranges([x]), NoWells("one cluster")).well_agreement is None


def test_models_are_told_apart_by_their_differences_fold_by_fold() -> None:
    hard = np.array([0.1, 0.2, 0.3, 0.4, 0.5])  # folds differ far more than the models
    errors = {"best": hard, "worse": hard + np.array([0.02, 0.021, 0.019, 0.02, 0.02]), "like": hard[::-1] + 0.01}
    assert not_above_lowest(errors) == {"best", "like"}
    assert not_above_lowest({}) == set()


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
