"""The study's bookkeeping with a method whose error is known in closed form."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import pytest

from pipeline.numerics.arrays import FloatArray
from pipeline.scoring.cross_validation import amount_study, noise_study
from pipeline.signals.log import Log


@dataclass(frozen=True)
class Run:
    q: FloatArray


@dataclass(frozen=True)
class Offset:
    """Predicts the truth, which these tests know to be sin t, plus a constant error."""

    error: float
    fine_voltages: bool = False

    def simulate(self, t: FloatArray, v: FloatArray, q0: float, qdot0: float) -> Run:
        return Run(np.sin(t) + self.error)


def sine(samples: int, start: float = 0.0) -> Log:
    t = start + 0.01 * np.arange(samples)
    return Log(t, np.sin(t), np.cos(t), -np.sin(t), np.zeros((samples, 1)))


def test_the_error_is_that_of_the_method_at_each_amount() -> None:
    seen: list[int] = []

    def identify(data: Sequence[Log]) -> Offset:
        samples = sum(len(x.t) for x in data)
        seen.append(samples)
        return Offset(2.0 / samples)

    training = [sine(700), sine(300, 20.0)]
    points = amount_study(training, [sine(1000)], identify, [100, 1000, 5000], repeats=3, rng=np.random.default_rng(0))
    span = np.ptp(np.sin(0.01 * np.arange(1000)))
    assert [p.level for p in points] == [100, 1000, 1000]
    assert [len(p.errors) for p in points] == [3, 1, 1]
    assert np.median(points[1].errors) == pytest.approx(2.0 / 1000 / span)
    assert np.median(points[0].errors) == pytest.approx(2.0 / 100 / span, rel=0.05)
    assert all(98 <= n <= 100 for n in seen[:3])  # a single row left over at a gap is dropped


def test_segments_differ_between_repeats_and_repeat_with_the_seed() -> None:
    def starts(seed: int) -> list[float]:
        found: list[float] = []

        def identify(data: Sequence[Log]) -> Offset:
            found.append(float(data[0].t[0]))
            return Offset(0.0)

        amount_study([sine(1000)], [sine(100)], identify, [50], repeats=8, rng=np.random.default_rng(seed))
        return found

    assert len(set(starts(1))) > 1
    assert starts(1) == starts(1)


def test_noise_is_added_before_differentiation_and_only_to_training_data() -> None:
    def identify(data: Sequence[Log]) -> Offset:
        return Offset(float(np.std(data[0].q - np.sin(data[0].t))))

    def keep(q: FloatArray, interval: float) -> tuple[FloatArray, FloatArray, FloatArray]:
        return q, q, q

    points = noise_study(
        [sine(5000)], [sine(1000)], identify, keep, [0.0, 0.1], repeats=3, rng=np.random.default_rng(0)
    )
    span = np.ptp(np.sin(0.01 * np.arange(1000)))
    assert points[0].errors == (0.0,)
    assert np.median(points[1].errors) == pytest.approx(0.1 / span, rel=0.05)
