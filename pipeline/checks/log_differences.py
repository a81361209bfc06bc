"""By what a log differs from another of its device: factors of the inputs, and the zero of q."""

from dataclasses import dataclass

import numpy as np

from pipeline.checks.weak_form import FORCE_ORDER, GAIN_TERMS, WeakTerms, solve
from pipeline.numerics.arrays import FloatArray, IntArray

_BLOCKS = 8
_SYSTEMATIC, _SYSTEMATIC_ZERO = 0.01, 0.008
"""Relative error of a gain, and error of the zero in standard deviations of q, that no scatter shows: the weak form is
no whole model. Of honest pairs of logs of 16 devices the common gain of both inputs is off by up to 3 %, mostly by less
than 1.5 %; of 13 joints the zero is off by up to 0.015 standard deviations, mostly by less than 0.008."""
_TOGETHER = 3.0
"""Standard errors by which the gains of two inputs may differ and be one."""


@dataclass(frozen=True)
class LogDifferences:
    """What the inputs of a log are to be multiplied by, and how far its q is off, with standard errors.

    Attributes
    ----------
    factors, errors : FloatArray, shape (K,)
        Of each input; of all together, K = 1, where they agree.
    together : bool
        Whether they do.
    zero, zero_error : float
        By how much q is higher than in the first log, in the unit of q.
    """

    factors: FloatArray
    errors: FloatArray
    together: bool
    zero: float
    zero_error: float


def log_differences(first: WeakTerms, other: WeakTerms, *, squared: bool) -> LogDifferences | None:
    """The gains and the shift of q with which the weights of each log explain the other best; means of both directions.

    Both logs must share their `Scales`. The errors are jackknifed over eight blocks of each log.

    Returns
    -------
    LogDifferences or None
        None where an input acts the other way round.

    Notes
    -----
    Cost: 34 least squares, 20 ms for 4,000 bumps.
    """
    directions = [_answers(first, other), _answers(other, first)]
    if any(np.any(answers[:-1] <= 0.0) for answers, _ in directions):
        return None
    (there, its_error), (back, own_error) = directions
    size = first.scales.size
    zero, zero_error = 0.5 * size * (back[-1] - there[-1]), 0.5 * size * np.hypot(its_error[-1], own_error[-1])
    shift = (float(zero), float(np.hypot(zero_error, _SYSTEMATIC_ZERO * size)))
    there, back, its_error, own_error = (each[:-1] for each in (there, back, its_error, own_error))
    power = 0.5 if squared else 1.0
    factors = (there / back) ** (0.5 * power)
    errors = factors * power * np.hypot(0.5 * np.hypot(its_error / there, own_error / back), _SYSTEMATIC)
    if np.ptp(factors) > _TOGETHER * float(np.linalg.norm(errors)):
        return LogDifferences(factors, errors, factors.size == 1, *shift)
    weights = errors**-2 / np.sum(errors**-2)
    together = np.array([weights @ factors]), np.array([np.linalg.norm(weights * errors)])
    return LogDifferences(*together, True, *shift)


def _answers(taught: WeakTerms, judged: WeakTerms) -> tuple[FloatArray, FloatArray]:
    """What each input's action in `judged` is to be multiplied by under the weights of `taught`, then the shift to be
    added to its scaled q; and the errors.
    """
    learned, shown = np.arange(taught.rows.size), np.arange(judged.rows.size)
    whole = _answer(taught, learned, judged, shown)
    variance = np.zeros_like(whole)
    for every, of in ((learned, "taught"), (shown, "judged")):
        left_out = [np.delete(every, block) for block in np.array_split(every, _BLOCKS)]
        pairs = [(rows, shown) if of == "taught" else (learned, rows) for rows in left_out]
        parts = np.array([_answer(taught, a, judged, b) for a, b in pairs])
        variance += (_BLOCKS - 1) / _BLOCKS * np.sum((parts - parts.mean(axis=0)) ** 2, axis=0)
    return whole, np.sqrt(variance)


def _answer(taught: WeakTerms, learned: IntArray, judged: WeakTerms, shown: IntArray) -> FloatArray:
    weights = solve(taught.design()[learned], taught.inertia[learned])
    low, high = np.quantile(taught.q, (0.01, 0.99))
    shown = shown[(judged.q[shown] >= low) & (judged.q[shown] <= high)]
    motion, push = judged.motion[shown], judged.push[judged.rows[shown]]
    ours = weights[: motion.shape[1]]
    gains = weights[motion.shape[1] :].reshape(push.shape[1], GAIN_TERMS)
    powers = np.arange(1, FORCE_ORDER + 1)
    slope = motion[:, :FORCE_ORDER] @ (powers * ours[1 : FORCE_ORDER + 1])
    slope += np.einsum("nik,ik->n", push[:, :, :-1], gains[:, 1:] * np.arange(1, GAIN_TERMS))
    columns = np.column_stack([np.einsum("nik,ik->ni", push, gains), slope])
    answer: FloatArray = np.linalg.lstsq(columns, judged.inertia[shown] - motion @ ours, rcond=None)[0]
    return answer
