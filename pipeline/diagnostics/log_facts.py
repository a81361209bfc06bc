"""Facts from one log without any model: inputs, late responses, rests."""

from dataclasses import dataclass

import numpy as np

from ..device.device import Device
from ..numerics.arrays import FloatArray, IntArray, samples_of
from ..scoring.wells import NoWells, Wells, end_of_rest, find_wells, places_of_rest
from ..signals.signal_quality import takes_both_signs
from .weak_form import BLOCKS, GAIN_TERMS, LogSignals, WeakTerms, residual, solve, under_inputs, unexplained, weak_terms

SURE = 4.0
"""Standard errors by which a number must differ from zero before its sign is judged."""

FIELD = 1.02
"""Share of the field limit from which on a log is above it: noise and probes make 1.01 of a command of 1."""

DRIFT = 0.02
"""Share of the range of q by which its rests move over a log, from which on that is shown, and by which one creeps."""


_ANSWER = 10
"""Rows within which a device that begins to move has done so; it is at rest for twice as many before."""
_STILL = 0.02
"""Share of its range within which q or an input stands still; q moves by three times as much."""


def undriven_starts(t: FloatArray, q: FloatArray, v: FloatArray) -> tuple[float, ...]:
    """Times [s] at which q leaves a rest though every input has been steady since before that rest.

    Parameters
    ----------
    t, q : FloatArray, shape (N,)
        Times [s], a sample interval of the identification apart, and displacement; NaN where masked.
    v : FloatArray, shape (N, K)
        Inputs.

    Notes
    -----
    Cost: some passes over N rows.
    """
    rest = 2 * _ANSWER
    rows = rest + _ANSWER
    if q.size <= rows:
        return ()
    reach = float(np.nanmax(q) - np.nanmin(q))
    whole = np.lib.stride_tricks.sliding_window_view(q, rows)
    still = np.ptp(whole[:, :rest], axis=1) < _STILL * reach
    moved = np.abs(whole[:, -1] - whole[:, rest - 1]) > 3.0 * _STILL * reach
    steady = np.ones(whole.shape[0], dtype=np.bool_)
    for column in v.T:
        steady &= np.ptp(np.lib.stride_tricks.sliding_window_view(column, rows), axis=1) < _STILL * np.ptp(column)
    begins = np.flatnonzero(still & moved & steady)
    return tuple(t[begins[np.diff(begins, prepend=-rows) > _ANSWER] + rest].tolist())


def rest_drift(
    t: FloatArray, q: FloatArray, v: FloatArray, interval: float, wells: Wells | NoWells, plant: Device
) -> float | None:
    """The common slope of the rests in both wells over time, by least squares; None where it is not sure or small.

    A rest in which q still swings counts the less.

    Parameters
    ----------
    t, q : FloatArray, shape (N,)
        Times [s] and displacement [m or rad]; NaN where masked.
    v : FloatArray, shape (N, K)
        Inputs.
    interval : float
        Step of the times [s].
    wells : Wells or NoWells
        Places at which the device rests.
    plant : Device
        Its inputs, and whether it is the joint.

    Returns
    -------
    float or None
        [m/s or rad/s].
    """
    places_at_rest = places_of_rest(q, v, interval, plant=plant)
    ends = [rows for rest in places_at_rest if np.isfinite(q[rows := end_of_rest(rest, interval)]).all()]
    reach = float(np.nanmax(q) - np.nanmin(q))
    times = np.array([np.mean(t[rows]) for rows in ends])
    places = np.array([np.median(q[rows]) for rows in ends])
    right = places > wells.barrier if isinstance(wells, Wells) else np.zeros(places.size, dtype=np.bool_)
    sides = [side for side in (~right, right) if side.any()]
    design = np.column_stack([*sides, times]) if sides else np.empty((0, 1))
    if len(design) <= 2 * design.shape[1] or reach == 0.0:
        return None
    sizes = np.array([np.hypot(np.ptp(q[rows]), DRIFT * reach) for rows in ends])
    design = design / sizes[:, None]
    weights = np.linalg.lstsq(design, places / sizes, rcond=None)[0]
    left = places / sizes - design @ weights
    scatter = float(left @ left) / (len(design) - design.shape[1])
    error = float(np.sqrt(scatter * np.linalg.pinv(design.T @ design)[-1, -1]))
    rate = float(weights[-1])
    return rate if abs(rate) > SURE * error and abs(rate) * float(np.ptp(t)) > DRIFT * reach else None


REACH = 20
"""Delays up to so many sample intervals are looked for."""
_ON = 0.25
"""Share of an input's largest drive from which on it counts as switched on."""


@dataclass(frozen=True)
class InputForce:
    """Mean acceleration while an input is on, at its largest value [m/s² or rad/s²], and its standard error."""

    value: float
    error: float

    @property
    def sure(self) -> bool:
        """True if the sign is sure."""
        return abs(self.value) > SURE * self.error


@dataclass(frozen=True)
class LogFacts:
    """The facts.

    Attributes
    ----------
    signals : LogSignals
    sample_interval : float
        Of the identification [s].
    input_forces : tuple of InputForce or None
        One of each input; None where it hardly ever changes, or the log is too short.
    late : float
        Delay [s] of the response of q to the logged inputs; zero unless every part of the log shows it.
    peaks : FloatArray, shape (K,)
        Largest magnitude of each input.
    span : float
        Range of q [m or rad].
    wells : Wells or NoWells
    unexplained : float or None
        Residual of the accelerations in the weak form, over their RMS.
    under_other_action : float or None
        The same if the inputs acted by the other action: in proportion, not by their squares, or the reverse.
    as_signed_monitor : float or None
        The same if the one input were the signed monitor of two membranes; None unless it takes both signs.
    starts : tuple of float
        Times [s] at which q leaves a rest though no input changes.
    drift : float or None
        A remarkable drift of the rests [m/s or rad/s].
    """

    signals: LogSignals
    sample_interval: float
    input_forces: tuple[InputForce | None, ...]
    late: float
    peaks: FloatArray
    span: float
    wells: Wells | NoWells
    unexplained: float | None
    under_other_action: float | None
    as_signed_monitor: float | None
    starts: tuple[float, ...]
    drift: float | None


def log_facts(log: LogSignals, sample_interval: float, plant: Device) -> LogFacts:
    """The facts of one log.

    Parameters
    ----------
    log : LogSignals
        The log.
    sample_interval : float
        Sample interval [s] of the identification.
    plant : Device
        Its inputs, and whether it is the joint.

    Notes
    -----
    Cost: 0.05 s for 40,000 samples, most of it the weak form.
    """
    terms = weak_terms(log, plant.acting(log.v), sample_interval)
    every = samples_of(sample_interval, log.interval)
    t, q, v = log.every(every)
    wells = find_wells([(q, v, every * log.interval)], plant=plant)
    both_signs = any(map(takes_both_signs, log.v.min(axis=0).tolist(), log.v.max(axis=0).tolist()))
    other_action = signed_monitor = None
    if terms is not None:
        other_action = unexplained(under_inputs(terms, log, plant.under_other_action.acting(log.v), sample_interval))
    if terms is not None and both_signs and log.v.shape[1] == 1:
        sides = np.hstack([np.maximum(log.v, 0.0), np.maximum(-log.v, 0.0)])
        signed_monitor = unexplained(under_inputs(terms, log, np.square(sides), sample_interval))
    return LogFacts(
        signals=log,
        sample_interval=sample_interval,
        input_forces=(None,) * log.v.shape[1] if terms is None else input_forces(terms),
        late=0.0 if terms is None else late_answer(terms, sample_interval),
        peaks=np.max(np.abs(log.v), axis=0),
        span=float(np.nanmax(log.q) - np.nanmin(log.q)),
        wells=wells,
        unexplained=None if terms is None else unexplained(terms),
        under_other_action=other_action,
        as_signed_monitor=signed_monitor,
        starts=undriven_starts(t, q, v),
        drift=rest_drift(t, q, v, every * log.interval, wells, plant=plant),
    )


def input_forces(terms: WeakTerms) -> tuple[InputForce | None, ...]:
    """Force of every input; None where it hardly ever changes: a constant determines none.

    The jackknife does not show errors of the weak form itself. These grow with the correlation r of the inputs, so the
    standard errors are divided by √(1 − r²).
    """
    acting = terms.inputs[terms.rows, :, 0]
    moved = np.ptp(acting, axis=0) > _ON
    design = terms.design()
    everything = np.arange(terms.rows.size)
    whole = _mean_accelerations(terms, design, everything)
    left_out = np.array(
        [
            _mean_accelerations(terms, design, np.delete(everything, block))
            for block in np.array_split(everything, BLOCKS)
        ]
    )
    errors = np.sqrt((BLOCKS - 1) / BLOCKS * np.sum((left_out - left_out.mean(axis=0)) ** 2, axis=0))
    with np.errstate(invalid="ignore", divide="ignore"):  # of inputs that never change
        correlations = np.nan_to_num(np.atleast_2d(np.corrcoef(acting.T)) - np.eye(whole.size))
    apart = np.sqrt(np.maximum(1.0 - np.max(np.abs(correlations), axis=0) ** 2, np.finfo(float).eps))
    return tuple(
        InputForce(float(acceleration), float(error)) if changes else None
        for acceleration, error, changes in zip(whole, errors / apart, moved, strict=True)
    )


def late_answer(terms: WeakTerms, sample_interval: float) -> float:
    """Delay of the inputs [s] that explains the accelerations best, zero unless it explains every block better.

    Eight blocks of a log that has none agree by chance once in 256. Cost: 41 least squares, 8 ms for 4,000 bumps.
    """
    step = samples_of(sample_interval, terms.interval)
    reach = max(1, round(REACH * sample_interval / terms.interval / step))
    lags = step * np.arange(-reach, reach + 1)
    starts = [block[0] for block in np.array_split(np.arange(terms.rows.size), BLOCKS)]
    errors = np.array([np.add.reduceat(residual(terms, lag) ** 2, starts) for lag in lags.tolist()])
    best = int(np.argmin(errors.sum(axis=1)))
    return float(lags[best] * terms.interval) if np.all(errors[best] < errors[reach]) else 0.0


def _mean_accelerations(terms: WeakTerms, design: FloatArray, rows: IntArray) -> FloatArray:
    """Mean acceleration of every input while it is on, by some of the rows, shape (K,)."""
    count = terms.inputs.shape[1]
    weights = solve(design[rows], terms.inertia[rows])[-count * GAIN_TERMS :].reshape(count, GAIN_TERMS)
    result = np.zeros(count)
    for i in range(count):
        on = np.abs(terms.inputs[terms.rows, i, 0]) > _ON
        if on.any():
            result[i] = float(np.mean(terms.q[on, None] ** np.arange(GAIN_TERMS) @ weights[i]))
    return result * terms.size
