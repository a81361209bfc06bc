"""How much training data, and how little noise, a method needs: its held-out error against both."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from ..errors import DebistError
from ..numerics.arrays import FloatArray
from ..signals.log import Log, operating_range
from .cross_validation import Simulator, fold_score
from .wells import NoWells

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

    @property
    def median(self) -> float | None:
        """Median over the repeats fitted; None if all were refused."""
        return float(np.median(self.errors)) if self.errors else None


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

    Each repeat takes a segment of consecutive samples at a random place, wrapping from one trajectory to the next, so
    that small amounts are judged by typical segments and not by how the first log begins.

    Parameters
    ----------
    training, held_out : sequence of Log
        What may be fitted, and what is predicted freely.
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
    for amount in amounts:
        starts = [0] if amount >= total else [int(s) for s in rng.integers(total, size=repeats)]
        stretches = [_stretch(training, start, min(amount, total)) for start in starts]
        points.append(_point(float(min(amount, total)), stretches, held_out, identify))
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
        What is corrupted and fitted, and what is predicted freely and left as it is.
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
    points = []
    for level in levels:
        draws = [
            [_corrupted(x, level, differentiate, rng) for x in training] for _ in range(repeats if level > 0.0 else 1)
        ]
        points.append(_point(level, draws, held_out, identify))
    return tuple(points)


def _point(level: float, draws: Sequence[Sequence[Log]], held_out: Sequence[Log], identify: Identify) -> StudyPoint:
    errors = []
    refused = 0
    for draw in draws:
        try:
            model = identify(draw)
        except DebistError:
            refused += 1
            continue
        errors.append(held_out_error(model, held_out))
    return StudyPoint(level, tuple(errors), refused)


def held_out_error(model: Simulator, held_out: Sequence[Log]) -> float:
    """Free-run NRMSE of q over all segments, each from its own first state, at most 1; weighted by their length."""
    low, high = operating_range(held_out)
    return fold_score(model, held_out, {"q": high - low}, NoWells("")).nrmse["q"]


def _stretch(training: Sequence[Log], start: int, amount: int) -> list[Log]:
    """`amount` consecutive samples from row `start` of the joined training data, wrapping at its end."""
    offsets = np.cumsum([0, *(len(x.t) for x in training)])
    total = int(offsets[-1])
    taken = []
    for low, high in ((start, min(start + amount, total)), (0, start + amount - total)):
        for x, offset in zip(training, offsets, strict=False):
            a = max(low - int(offset), 0)
            b = min(high - int(offset), len(x.t))
            if b - a >= 2:
                taken.append(Log(x.t[a:b], x.q[a:b], x.qdot[a:b], x.qddot[a:b], x.v[a:b]))
    return taken


def _corrupted(x: Log, level: float, differentiate: Differentiate, rng: np.random.Generator) -> Log:
    q, qdot, qddot = differentiate(x.q + level * rng.normal(size=len(x.t)), x.interval)
    return Log(x.t, q, qdot, qddot, x.v)
