"""What one log shows of its device without any model: pushes, delays, rests, ring-down, spans."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from pipeline.checks import limits
from pipeline.checks.input_lag import input_lag
from pipeline.checks.rest_drift import RestDrift, rest_drift
from pipeline.checks.undriven_starts import undriven_starts
from pipeline.checks.weak_form import (
    FORCE_ORDER,
    GAIN_TERMS,
    HALF_WIDTH,
    LogSignals,
    WeakTerms,
    scales_of,
    solve,
    under_inputs,
    unexplained,
    weak_terms,
)
from pipeline.device_facts.events import RestFacts, RingDown, rest_facts
from pipeline.numerics.arrays import FloatArray, IntArray, samples_of
from pipeline.numerics.metrics import rms
from pipeline.scoring.wells import SHORTEST_REST, NoWells, Wells, find_wells, snaps
from pipeline.scoring.wells import rests as quiet_rows
from pipeline.signals.signal_quality import takes_both_signs

BLOCKS = 8
"""Parts of a log of which one at a time is left out; the spread of the results is their uncertainty (jackknife)."""
REACH = 20
"""Delays up to so many sample intervals are looked for."""
_ON = 0.25  # of an input's largest drive: there it counts as switched on
_LEAST_ON = 20  # bumps with the input on, for a statement about it
_RING_INTERVAL = 0.01  # s, at which ring-downs are looked for where there are none at the sample interval
_MOST_TOGETHER = 0.9999  # correlation of two inputs, beyond which it hardly matters
_CLEAR_RING = 0.15  # unexplained share up to which a ring-down's frequency counts


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
    hardly_moves : bool
        Whether it surely pushes by less than the device usually accelerates.
    delay : Estimate
        By how much the motion answers later than the input says [s]; negative: earlier.
    at_the_end : bool
        Whether the best delay is the largest that was tried.
    """

    push: Estimate
    hardly_moves: bool
    delay: Estimate
    at_the_end: bool


def input_facts(terms: WeakTerms, sample_interval: float) -> tuple[InputFacts | None, ...]:
    """Push and delay of every input; None where it is hardly ever on, or never off: a constant says nothing of either.

    The delay minimises the residual of the weak form: first one delay of all inputs, then each with the others held;
    a parabola through the three best gives it between the samples. Both uncertainties are jackknifed over 8 blocks.

    Cost: three scans of 41 delays, 0.04 s for 4,000 bumps.
    """
    count = terms.push.shape[1]
    acting = np.abs(terms.push[terms.rows, :, 0])
    on, moved = (acting > _ON).sum(axis=0), np.ptp(acting, axis=0)
    driven = [bool(on[i] >= _LEAST_ON and moved[i] > _ON) for i in range(count)]
    if not any(driven):
        return tuple(None for _ in driven)
    step = samples_of(sample_interval, terms.interval)
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
    usual, pushes, late = limits.HARDLY * terms.scales.size * rms(terms.inertia), _pushes(terms), _pushes(terms, best)
    acts, unsure = _acts(late, driven), reach * step * terms.interval
    delays = [
        each if acts and _is_abrupt(terms, i, sample_interval) else (replace(each[0], error=unsure), each[1])
        for i, each in enumerate(delays)
    ]
    return tuple(
        InputFacts(push, abs(push.value) + limits.SIGN_CERTAINTY * push.error < usual, *delay) if on else None
        for push, delay, on in zip(pushes, delays, driven, strict=True)
    )


def _acts(pushes: Sequence[Estimate], driven: Sequence[bool]) -> bool:
    """Whether inputs that are driven surely push, two of them to both sides: else their delays are of chance."""
    acting = [push for push, on in zip(pushes, driven, strict=True) if on]
    sure = all(abs(push.value) > limits.SIGN_CERTAINTY * push.error for push in acting)
    return sure and (len(acting) < 2 or min(push.value for push in acting) < 0.0 < max(push.value for push in acting))


def _is_abrupt(terms: WeakTerms, i: int, sample_interval: float) -> bool:
    """Whether an input changes abruptly; a slow smooth one acts at any time alike, but for its weights."""
    step = samples_of(0.5 * HALF_WIDTH * sample_interval, terms.interval)
    drive = terms.push[terms.rows[0] : terms.rows[-1], i, 0]
    changes = drive[step:] - drive[:-step]
    return rms(changes[step:] - changes[:-step]) > limits.ABRUPT * rms(changes)


def _scan(terms: WeakTerms, base: IntArray, moved: "range | tuple[int, ...]", offsets: IntArray) -> FloatArray:
    """Squared residual of each block for each delay of the inputs `moved`, shape (delays, blocks)."""
    starts = [block[0] for block in np.array_split(np.arange(terms.rows.size), BLOCKS)]
    errors, design = np.empty((offsets.size, BLOCKS)), terms.design(base)
    for row, offset in enumerate(offsets.tolist()):
        for i in moved:
            design[:, terms.columns(i)] = terms.late(i, offset)
        residual = terms.inertia - design @ solve(design, terms.inertia)
        errors[row] = np.add.reduceat(residual**2, starts)
    return errors


def _minimum(errors: FloatArray, delays: FloatArray) -> tuple[Estimate, bool]:
    """Delay of the least residual with its jackknife error, and whether it lies at an end."""
    total = errors.sum(axis=1)
    whole = _vertex(total, delays)
    left_out = np.array([_vertex(total - errors[:, block], delays) for block in range(errors.shape[1])])
    least = int(np.argmin(total))
    return Estimate(whole, float(_jackknife_error(left_out))), least in (0, delays.size - 1)


def _vertex(values: FloatArray, places: FloatArray) -> float:
    """Place of the least value, by a parabola through it and its neighbours."""
    k = int(np.clip(np.argmin(values), 1, values.size - 2))
    before, at, after = values[k - 1 : k + 2].tolist()
    bend = before - 2.0 * at + after
    move = 0.5 * (before - after) / bend if bend > 0.0 else 0.0
    return float(places[k] + float(np.clip(move, -1.0, 1.0)) * (places[1] - places[0]))


def _pushes(terms: WeakTerms, lags: IntArray | None = None) -> list[Estimate]:
    """Mean acceleration of each input while it is on, at its largest drive; inputs act `lags` samples later.

    Parts of a log that are left out do not show what the weak form has wrong, and that grows as inputs go together.
    """
    design = terms.design(lags)
    blocks = np.array_split(np.arange(terms.rows.size), BLOCKS)
    everything = np.arange(terms.rows.size)
    pushes = [_push_of(terms, design, np.delete(everything, block)) for block in (np.empty(0, np.int64), *blocks)]
    whole, errors = pushes[0], _jackknife_error(np.array(pushes[1:]))
    with np.errstate(invalid="ignore", divide="ignore"):  # of inputs that never change
        together = np.abs(np.atleast_2d(np.corrcoef(terms.push[terms.rows, :, 0].T)) - np.eye(whole.size)).max(axis=0)
    errors /= np.sqrt(1.0 - np.minimum(np.nan_to_num(together), _MOST_TOGETHER) ** 2)
    return [Estimate(float(w), float(e)) for w, e in zip(whole, errors, strict=True)]


def _jackknife_error(left_out: FloatArray) -> FloatArray:
    """Standard error from estimates with one block left out each, shape (BLOCKS, …)."""
    error: FloatArray = np.sqrt((BLOCKS - 1) / BLOCKS * np.sum((left_out - left_out.mean(axis=0)) ** 2, axis=0))
    return error


def _push_of(terms: WeakTerms, design: FloatArray, rows: IntArray) -> FloatArray:
    count = terms.push.shape[1]
    weights = solve(design[rows], terms.inertia[rows])[-count * GAIN_TERMS :].reshape(count, GAIN_TERMS)
    result = np.zeros(count)
    for i in range(count):
        on = np.abs(terms.push[terms.rows, i, 0]) > _ON
        powers = terms.q[on, None] ** np.arange(GAIN_TERMS)
        result[i] = float(np.mean(powers @ weights[i])) if on.any() else 0.0
    return result * terms.scales.size


@dataclass(frozen=True)
class LogFacts:
    """The facts.

    Attributes
    ----------
    signals : LogSignals
    inputs : tuple of InputFacts or None
        One of each input; None where it is hardly ever on, or the log is too short.
    peaks : FloatArray, shape (K,)
        Largest magnitude of each input.
    span : float
        Range of q [m or rad].
    wells : Wells or NoWells
    rests : RestFacts
    ring : float or None
        Median frequency of the ring-downs after switch-offs [Hz].
    damping : float or None
        Their median damping ratio.
    natural : float or None
        Natural frequency of small motions about the rests [Hz], from the slope of the force; geometric mean.
    undriven : int
        How often q passes from well to well after all inputs were off: something that was not named moves it.
    unexplained, under_other_law : float or None
        Share of the accelerations that the weak form leaves, and that it leaves where inputs act by their other law (in
        proportion for by their squares); None where inputs of one height act alike by both.
    as_signed_monitor : float or None
        The same where the one input is the signed monitor of two membranes; None unless it takes both signs.
    both_signs : bool
        Whether an input takes both signs.
    lag : float or None
        Time constant [s] of a lag of the inputs that explains a late answer surely better than a delay.
    starts : tuple of float
        Times [s] at which q leaves a rest though no input changes.
    drift : RestDrift or None
        A drift of the rests that is sure and remarkable.
    terms : WeakTerms or None
        Its weak form under its own scales; None where the log is too short.
    """

    signals: LogSignals
    inputs: tuple[InputFacts | None, ...]
    peaks: FloatArray
    span: float
    wells: Wells | NoWells
    rests: RestFacts
    ring: float | None
    damping: float | None
    natural: float | None
    undriven: int
    unexplained: float | None = None
    under_other_law: float | None = None
    as_signed_monitor: float | None = None
    both_signs: bool = False
    lag: float | None = None
    starts: tuple[float, ...] = ()
    drift: RestDrift | None = None
    terms: WeakTerms | None = None


def log_facts(log: LogSignals, sample_interval: float, *, squared: bool, joint: bool) -> LogFacts:
    """Look at one log.

    Cost: 0.2 s for 40,000 samples, most of it the ring-downs.
    """
    terms = weak_terms(log, sample_interval, scales_of(log, squared=squared), squared=squared)
    inputs = (None,) * log.v.shape[1] if terms is None else input_facts(terms, sample_interval)
    every = samples_of(sample_interval, log.interval)
    t, q, v = log.every(every)
    wells = find_wells([(q, v, every * log.interval)], joint=joint)
    rests = rest_facts([(t, q, v)], wells, log.hum, joint=joint)
    rings = _rings(rests)
    if not rings and every > _ring_step(log):  # which a sample interval that is too long hides
        rings = _rings(rest_facts([log.every(_ring_step(log))], wells, log.hum, joint=joint))
    natural = None if terms is None else _natural_frequency(terms)
    both_signs = any(map(takes_both_signs, log.v.min(axis=0).tolist(), log.v.max(axis=0).tolist()))
    return LogFacts(
        signals=log,
        inputs=inputs,
        peaks=np.max(np.abs(log.v), axis=0),
        span=float(np.nanmax(log.q) - np.nanmin(log.q)),
        wells=wells,
        rests=rests,
        ring=float(np.median([ring.frequency for ring in rings])) if rings else None,
        damping=float(np.median([ring.damping for ring in rings])) if rings else None,
        natural=natural,
        undriven=_undriven(q, v, every * log.interval, wells, natural, joint=joint),
        unexplained=None if terms is None else unexplained(terms),
        under_other_law=unexplained(under_inputs(terms, log, sample_interval, squared=not squared))
        if terms is not None and _several_heights(log.v)
        else None,
        as_signed_monitor=unexplained(under_inputs(terms, _of_two(log), sample_interval, squared=True))
        if terms is not None and both_signs and log.v.shape[1] == 1
        else None,
        both_signs=both_signs,
        starts=undriven_starts(t, q, v),
        drift=rest_drift(t, q, v, every * log.interval, wells, joint=joint),
        lag=_lag(log, terms, inputs, sample_interval, squared=squared),
        terms=terms,
    )


def _lag(
    log: LogSignals,
    terms: WeakTerms | None,
    inputs: Sequence[InputFacts | None],
    sample_interval: float,
    *,
    squared: bool,
) -> float | None:
    """See `LogFacts`: looked for only where an input acts remarkably late."""
    late = any(fact is not None and fact.delay.value > limits.NOTED_DELAY * sample_interval for fact in inputs)
    return input_lag(log, terms, sample_interval, REACH, squared=squared) if late and terms is not None else None


def _ring_step(log: LogSignals) -> int:
    """Rows of a record in `_RING_INTERVAL`."""
    return samples_of(_RING_INTERVAL, log.interval)


def _rings(rests: RestFacts) -> list[RingDown]:
    """The ring-downs whose frequency counts."""
    return [ring for ring in (*rests.rings_left, *rests.rings_right) if ring.unexplained <= _CLEAR_RING]


def _of_two(log: LogSignals) -> LogSignals:
    """A log whose input of both signs is taken for the signed monitor of two membranes."""
    return replace(log, v=np.hstack([np.maximum(log.v, 0.0), np.maximum(-log.v, 0.0)]))


def _several_heights(v: FloatArray) -> bool:
    """Whether the square of an input is not in proportion to it."""
    away, squares = v - v.mean(axis=0), v**2 - np.mean(v**2, axis=0)
    both, own = np.mean(away * squares, axis=0) ** 2, np.mean(away**2, axis=0)
    left = np.mean(squares**2, axis=0) * own - both  # that a line through the input leaves, times its variance
    return bool(np.any((own > 0.0) & (left >= limits.SEVERAL_HEIGHTS**2 * (left + both))))


def _undriven(
    q: FloatArray, v: FloatArray, interval: float, wells: Wells | NoWells, natural: float | None, *, joint: bool
) -> int:
    """Passages between the wells that no input explains.

    A ring-down may go over the barrier after the inputs went off, again and again, but not once it has stayed in a well
    for `SHORTEST_REST` and two periods of the natural frequency [Hz].
    """
    crossed = snaps(q, wells)
    stayed = round(max(SHORTEST_REST, 2.0 / natural if natural else 0.0) / interval)
    count = 0
    for rows in quiet_rows(v, interval, joint=joint):
        within = crossed[(crossed > rows.start) & (crossed < rows.stop)]
        count += int(np.count_nonzero(np.diff(within, prepend=rows.start) > stayed))
    return count


def _natural_frequency(terms: WeakTerms) -> float | None:
    """From ``ω² = −∂f/∂q`` where the force vanishes and is stable; it needs no time window, so it can be anything."""
    force = np.polynomial.Polynomial(solve(terms.design(), terms.inertia)[: FORCE_ORDER + 1])
    roots = force.roots()
    rests = roots.real[np.abs(roots.imag) < 1e-9 * (1.0 + np.abs(roots.real))]
    low, high = np.quantile(terms.q, (0.01, 0.99))
    squares = -force.deriv()(rests[(rests > low) & (rests < high)])
    stable = squares[squares > 0.0]
    return float(np.exp(np.mean(np.log(stable))) ** 0.5 / (2.0 * np.pi)) if stable.size else None
