"""Models judged by free runs over data that they were not fitted to: logs held out, and blocks within a fit."""

import itertools
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Protocol, TypeVar

import numpy as np

from ..errors import DebistError
from ..numerics.arrays import FloatArray
from ..numerics.metrics import rmse
from ..signals.log import Log, operating_range
from .intervals import LEVEL, Interval

FOLDS = 4
NEGLIGIBLE = 1e-5  # of the range of q; smaller errors are no reason to prefer a choice, a laser resolves about as much

Choice = TypeVar("Choice")


class SimulatedMotion(Protocol):
    """A free run, NaN after a divergence."""

    @property
    def q(self) -> FloatArray:
        """Displacement [m]."""


class Simulator(Protocol):
    """A fitted model."""

    @property
    def fine_voltages(self) -> bool:
        """True if the model takes the inputs between the samples."""

    def simulate(self, t: FloatArray, v: FloatArray, q0: float, qdot0: float) -> SimulatedMotion:
        """Free run, see `pipeline.models.base.DynamicModel.simulate`."""


def mean_over_folds(values: FloatArray) -> tuple[float, Interval | None]:
    """Mean over folds and its interval by the corrected resampled t-test.

    Folds share most of their training data, so their errors are no independent draws. The variance of the mean is taken
    as (1/k + 1/(k − 1)) s² instead of s²/k (Nadeau & Bengio 2003, doi:10.1023/A:1024068626366).

    Parameters
    ----------
    values : FloatArray, shape (k,)
        One per fold.

    Returns
    -------
    mean : float
    interval : Interval or None
        None with fewer than three folds.
    """
    from scipy.special import stdtrit

    k = values.size
    mean = float(values.mean())
    if k < 3:
        return mean, None
    half = float(stdtrit(k - 1, (1.0 + LEVEL) / 2.0) * np.sqrt(1.0 / k + 1.0 / (k - 1)) * values.std(ddof=1))
    return mean, Interval(mean - half, mean + half)


@dataclass(frozen=True)
class HeldOutBlock:
    """Rows `start:stop` of the trajectory number `source`, in fold `fold`."""

    source: int
    start: int
    stop: int
    fold: int


def held_out_blocks(trajectories: Sequence[Log]) -> list[HeldOutBlock]:
    """Blocks of about a quarter of all samples, dealt to `FOLDS` folds in turn; no block crosses a gap.

    A trajectory shorter than that is one block. With a single trajectory every fold holds one block.
    """
    total = sum(len(x.t) for x in trajectories)
    spans = []
    for source, x in enumerate(trajectories):
        edges = np.linspace(0, len(x.t), max(1, round(FOLDS * len(x.t) / total)) + 1).astype(int)
        spans += [(source, int(a), int(b)) for a, b in itertools.pairwise(edges)]
    return [HeldOutBlock(*span, fold=i % FOLDS) for i, span in enumerate(spans)]


def free_run_error(measured: FloatArray, calculated: FloatArray, span: float) -> float:
    """RMS error of a signal over `span`, at most 1: a run that diverged or missed everything counts as 1."""
    error = rmse(measured, calculated)
    return 1.0 if error is None else min(1.0, error / span)


def simplest_within_one_standard_error(errors: Mapping[Choice, FloatArray], terms: Mapping[Choice, int]) -> Choice:
    """The choice with the fewest terms among those whose mean error is within one standard error of the lowest.

    Breiman et al., Classification and Regression Trees (1984), section 3.4.3. Equal numbers of terms are decided by the
    mean error.

    Parameters
    ----------
    errors : mapping of choice to FloatArray, shape (folds,)
        Error in each fold.
    terms : mapping of choice to int
        Complexity.
    """
    means = {choice: float(values.mean()) for choice, values in errors.items()}
    best = min(means, key=means.__getitem__)
    spread = errors[best]
    limit = means[best] + (float(spread.std(ddof=1)) / np.sqrt(spread.size) if spread.size > 1 else 0.0)
    return min((c for c in errors if means[c] <= max(limit, NEGLIGIBLE)), key=lambda c: (terms[c], means[c]))


Identify = Callable[[Sequence[Log]], Simulator]
Differentiate = Callable[[FloatArray, float], tuple[FloatArray, FloatArray, FloatArray]]
"""``(samples, interval) -> (q, qdot, qddot)``: the smoothed signal and its derivatives."""


@dataclass(frozen=True)
class StudyPoint:
    """The held-out error of one method at one amount of data or noise.

    Attributes
    ----------
    level : float
        Training samples, or standard deviation [m] of the noise added to q.
    errors : tuple of float
        Free-run NRMSE of q on the held-out segments, one per repeat that was fitted; 1 stands for a run that diverged
        or missed everything.
    refused : int
        Repeats whose data the method refused.
    """

    level: float
    errors: tuple[float, ...]
    refused: int


def amount_study(
    training: Sequence[Log],
    held_out: Sequence[Log],
    identify: Identify,
    amounts: Sequence[int],
    *,
    repeats: int,
    rng: np.random.Generator,
) -> tuple[StudyPoint, ...]:
    """Held-out error against the number of training samples.

    Each repeat takes a segment of consecutive samples at a random place, wrapping from one trajectory to the next. So
    small amounts are judged by typical segments, not by how the first log begins.

    Parameters
    ----------
    training, held_out : sequence of Log
        Logs for the fit, and logs that are predicted freely.
    identify : callable
        The method.
    amounts : sequence of int
        Training samples; an amount of all samples or more is done once, with all.
    repeats : int
        Segments per amount.
    rng : numpy.random.Generator
        Places of the segments.
    """
    total = sum(len(x.t) for x in training)
    points = []
    for amount in np.minimum(amounts, total).tolist():
        starts = [0] if amount == total else rng.integers(total, size=repeats).tolist()
        draws = [_segment(training, start, amount) for start in starts]
        points.append(_point(float(amount), draws, held_out, identify))
    return tuple(points)


def noise_study(
    training: Sequence[Log],
    held_out: Sequence[Log],
    identify: Identify,
    differentiate: Differentiate,
    levels: Sequence[float],
    *,
    repeats: int,
    rng: np.random.Generator,
) -> tuple[StudyPoint, ...]:
    """Held-out error against white noise added to the training displacement before it is differentiated anew.

    Parameters
    ----------
    training, held_out : sequence of Log
        Logs that are corrupted and fitted, and logs that are left as they are and predicted freely.
    identify : callable
        The method.
    differentiate : callable
        Smooths and differentiates the noisy samples.
    levels : sequence of float
        Standard deviations [m]; at zero one repeat is enough.
    repeats : int
        Noise draws per level.
    rng : numpy.random.Generator
        The noise.
    """
    return tuple(
        _point(
            level,
            [
                [_corrupted(x, level, differentiate, rng) for x in training]
                for _ in range(repeats if level > 0.0 else 1)
            ],
            held_out,
            identify,
        )
        for level in levels
    )


def _point(level: float, draws: Sequence[Sequence[Log]], held_out: Sequence[Log], identify: Identify) -> StudyPoint:
    errors = []
    refused = 0
    for draw in draws:
        try:
            model = identify(draw)
        except DebistError:
            refused += 1
        else:
            errors.append(held_out_error(model, held_out))
    return StudyPoint(level, tuple(errors), refused)


def held_out_error(model: Simulator, held_out: Sequence[Log]) -> float:
    """Free-run NRMSE of q over all segments, each from its own measured first state; weighted by their length.

    Hidden states of a model begin as after a long rest there. A run that diverged or missed everything counts as 1.
    """
    low, high = operating_range(held_out)
    runs = [
        model.simulate(x.t, x.drive_of(fine=model.fine_voltages), float(x.q[0]), float(x.qdot[0])) for x in held_out
    ]
    squares = sum(free_run_error(x.q, run.q, high - low) ** 2 * len(x.t) for x, run in zip(held_out, runs, strict=True))
    return float(np.sqrt(squares / sum(len(x.t) for x in held_out)))


def _segment(training: Sequence[Log], start: int, amount: int) -> list[Log]:
    """`amount` consecutive samples from row `start` of the joined training data, wrapping at its end."""
    offsets = np.cumsum([0, *(len(x.t) for x in training)])
    total = int(offsets[-1])
    taken = []
    for low, high in ((start, min(start + amount, total)), (0, start + amount - total)):
        for x, offset in zip(training, offsets, strict=False):
            a = max(low - int(offset), 0)
            b = min(high - int(offset), len(x.t))
            if b - a >= 2:
                taken.append(Log(t=x.t[a:b], q=x.q[a:b], qdot=x.qdot[a:b], qddot=x.qddot[a:b], v=x.v[a:b]))
    return taken


def _corrupted(x: Log, level: float, differentiate: Differentiate, rng: np.random.Generator) -> Log:
    q, qdot, qddot = differentiate(x.q + level * rng.normal(size=len(x.t)), x.interval)
    return Log(t=x.t, q=q, qdot=qdot, qddot=qddot, v=x.v)
