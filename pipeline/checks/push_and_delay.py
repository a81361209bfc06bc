"""Which way each input pushes, and how much later than the input the motion answers."""

from dataclasses import dataclass

import numpy as np

from pipeline.checks.weak_form import GAIN_TERMS, WeakTerms, solve
from pipeline.numerics.arrays import FloatArray, IntArray

BLOCKS = 8
"""Parts of a log of which one at a time is left out; the spread of the results is their uncertainty (jackknife)."""
REACH = 20
"""Delays up to so many sample intervals are looked for."""
_ON = 0.25  # of an input's largest drive: there it counts as switched on
_LEAST_ON = 20  # bumps with the input on, for a statement about it


@dataclass(frozen=True)
class Estimate:
    """A number with its standard error."""

    value: float
    error: float


@dataclass(frozen=True)
class InputFacts:
    """What one input does.

    Attributes
    ----------
    push : Estimate
        Mean acceleration while it is on, at its largest value [m/s² or rad/s²].
    delay : Estimate
        By how much the motion answers later than the input says [s]; negative: earlier.
    at_the_end : bool
        Whether the best delay is the largest that was tried.
    """

    push: Estimate
    delay: Estimate
    at_the_end: bool


def input_facts(terms: WeakTerms, sample_interval: float) -> tuple[InputFacts | None, ...]:
    """Push and delay of every input; None where it is hardly ever on.

    The delay minimises the residual of the weak form: first one delay of all inputs, then each with the others held;
    a parabola through the three best gives it between the samples. Both uncertainties are jackknifed over 8 blocks.

    Cost: three scans of 41 delays, 0.1 s for 4,000 bumps.
    """
    count = terms.push.shape[1]
    driven = [int(np.sum(np.abs(terms.push[terms.rows, i, 0]) > _ON)) >= _LEAST_ON for i in range(count)]
    if not any(driven):
        return tuple(None for _ in driven)
    step = max(1, round(sample_interval / terms.interval))
    reach = max(2, round(REACH * sample_interval / terms.interval / step))
    offsets = step * np.arange(-reach, reach + 1)
    best = np.zeros(count, dtype=np.int64)
    if sum(driven) > 1:
        best[:] = offsets[int(np.argmin(_scan(terms, best, range(count), offsets).sum(axis=1)))]
    delays: list[tuple[Estimate, bool]] = []
    for i in range(count):
        errors = _scan(terms, best, (i,), offsets)
        best[i] = offsets[int(np.argmin(errors.sum(axis=1)))]
        delays.append(_minimum(errors, offsets.astype(np.float64) * terms.interval))
    pushes = _pushes(terms)
    return tuple(InputFacts(pushes[i], *delays[i]) if driven[i] else None for i in range(count))


def _scan(terms: WeakTerms, base: IntArray, moved: "range | tuple[int, ...]", offsets: IntArray) -> FloatArray:
    """Squared residual of each block for each delay of the inputs `moved`, shape (delays, blocks)."""
    blocks = np.array_split(np.arange(terms.rows.size), BLOCKS)
    errors = np.empty((offsets.size, BLOCKS))
    for row, offset in enumerate(offsets.tolist()):
        lags = base.copy()
        lags[list(moved)] = offset
        design = terms.design(lags)
        residual = (terms.inertia - design @ solve(design, terms.inertia)) ** 2
        errors[row] = [residual[block].sum() for block in blocks]
    return errors


def _minimum(errors: FloatArray, delays: FloatArray) -> tuple[Estimate, bool]:
    """Delay of the least residual with its jackknife error, and whether it lies at an end."""
    total = errors.sum(axis=1)
    whole = _vertex(total, delays)
    left_out = np.array([_vertex(total - errors[:, block], delays) for block in range(errors.shape[1])])
    error = float(np.sqrt((BLOCKS - 1) / BLOCKS * np.sum((left_out - left_out.mean()) ** 2)))
    least = int(np.argmin(total))
    return Estimate(whole, error), least in (0, delays.size - 1)


def _vertex(values: FloatArray, places: FloatArray) -> float:
    """Place of the least value, by a parabola through it and its neighbours."""
    k = int(np.clip(np.argmin(values), 1, values.size - 2))
    before, at, after = values[k - 1 : k + 2].tolist()
    bend = before - 2.0 * at + after
    move = 0.5 * (before - after) / bend if bend > 0.0 else 0.0
    return float(places[k] + float(np.clip(move, -1.0, 1.0)) * (places[1] - places[0]))


def _pushes(terms: WeakTerms) -> list[Estimate]:
    """Mean acceleration of each input while it is on, at its largest drive."""
    design = terms.design()
    blocks = np.array_split(np.arange(terms.rows.size), BLOCKS)
    everything = np.arange(terms.rows.size)
    found = [_push_of(terms, design, np.setdiff1d(everything, block)) for block in (np.empty(0, np.int64), *blocks)]
    whole, parts = found[0], np.array(found[1:])
    errors = np.sqrt((BLOCKS - 1) / BLOCKS * np.sum((parts - parts.mean(axis=0)) ** 2, axis=0))
    return [Estimate(float(w), float(e)) for w, e in zip(whole, errors, strict=True)]


def _push_of(terms: WeakTerms, design: FloatArray, rows: IntArray) -> FloatArray:
    count = terms.push.shape[1]
    weights = solve(design[rows], terms.inertia[rows])[-count * GAIN_TERMS :].reshape(count, GAIN_TERMS)
    result = np.zeros(count)
    for i in range(count):
        on = np.abs(terms.push[terms.rows, i, 0]) > _ON
        powers = terms.q[on, None] ** np.arange(GAIN_TERMS)
        result[i] = float(np.mean(powers @ weights[i])) if on.any() else 0.0
    return result * terms.scales.size
