"""Facts from one log without any model: inputs, late responses, rests.

What inputs do is read from the acceleration of a log as a sum of smooth terms, in weak form: no derivative of the
samples is taken. Both sides of ``q̈ = f(q) + d(q) q̇ + Σ g_i(q) e_i`` are averaged under a bump ``φ(s) = (1 − s²)⁴`` of
half width W; e_i is the squared voltage, or the input itself. Partial integration moves the derivatives from q to the
bump, so noise is averaged over hundreds of samples. f is a polynomial of order 5, d has a constant and a square, each
g_i is a parabola.
"""

from dataclasses import dataclass, replace

import numpy as np

from ..device.device import Device
from ..numerics.arrays import FloatArray, IntArray, sample_interval, samples_of
from ..scoring.wells import NoWells, Wells, end_of_rest, find_wells, places_of_rest
from ..signals.signal_quality import takes_both_signs

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

FORCE_ORDER = 5
GAIN_TERMS = 3
HALF_WIDTH = 5
"""Half width of the bump, in sample intervals of the identification: the motion is smooth over that."""
BLOCKS = 8
"""Parts of a log of which one at a time is left out: the spread of the results is their uncertainty (jackknife)."""
_MOST_SAMPLES = 600_000

REACH = 20
"""Delays up to so many sample intervals are looked for."""
_ON = 0.25
"""Share of an input's largest drive from which on it counts as switched on."""


@dataclass(frozen=True)
class LogSignals:
    """One log on a fine uniform grid.

    Attributes
    ----------
    name : str
        Title, for instance ``training log``.
    t : FloatArray, shape (N,)
        Time [s], uniform.
    q : FloatArray, shape (N,)
        Displacement [m or rad], NaN where masked.
    v : FloatArray, shape (N, K)
        Inputs, finite.
    raw_step : float
        Step of the raw log [s].
    noise, resolution : float or None
        Noise of the raw q (standard deviation) and step of its converter, where there is one [m or rad].
    held : int
        Raw samples for which q keeps each value.
    sketch : tuple of (int, float)
        Hashes of some windows of the raw q, and where they begin [s] (`pipeline.diagnostics.copies`).
    """

    name: str
    t: FloatArray
    q: FloatArray
    v: FloatArray
    raw_step: float
    noise: float | None = None
    resolution: float | None = None
    held: int = 1
    sketch: tuple[tuple[int, float], ...] = ()

    @property
    def interval(self) -> float:
        """Step of the grid [s]."""
        return sample_interval(self.t)


@dataclass(frozen=True)
class WeakTerms:
    """A log's averages under the bumps, of q and inputs scaled to size one.

    Attributes
    ----------
    size : float
        Standard deviation of q, by which it is scaled.
    z : FloatArray, shape (N,)
        Scaled displacement about its mean; zero where it is not measured.
    rows : IntArray, shape (R,)
        Sample at the middle of each bump that meets no masked sample.
    inertia : FloatArray, shape (R,)
        Averages of the scaled acceleration [1/s²].
    motion : FloatArray, shape (R, FORCE_ORDER + 3)
        Averages of the terms of f and d.
    inputs : FloatArray, shape (N, K, GAIN_TERMS)
        Averages of ``e_i``, ``e_i q``, ``e_i q²`` around every sample.
    interval : float
        Step of the samples [s].
    bump : FloatArray, shape (2 W + 1,)
        Weights of the samples under a bump.
    """

    size: float
    z: FloatArray
    rows: IntArray
    inertia: FloatArray
    motion: FloatArray
    inputs: FloatArray
    interval: float
    bump: FloatArray

    def design(self, lag: int = 0) -> FloatArray:
        """All terms, shape (R, P); the inputs are taken `lag` samples earlier."""
        late = np.take(self.inputs.reshape(len(self.inputs), -1), self.rows - lag, axis=0, mode="clip")
        return np.concatenate([self.motion, late], axis=1)


def weak_terms(log: LogSignals, acting: FloatArray, sample_interval: float) -> WeakTerms | None:
    """Average every term of a log, its first 600,000 samples if it is longer; None where too few bumps fit in.

    Parameters
    ----------
    log : LogSignals
        The log.
    acting : FloatArray, shape (N, K)
        The acting inputs. A block of them must determine all weights.
    sample_interval : float
        Sample interval [s] of the identification.

    Notes
    -----
    Cost: 15 convolutions with the bump for two inputs, 0.02 s for 40,000 samples.
    """
    half = max(HALF_WIDTH, round(HALF_WIDTH * sample_interval / log.interval))
    q = log.q[:_MOST_SAMPLES]
    measured = np.isfinite(q)
    # Middles of bumps, a sample interval apart, that meet only measured samples.
    missing = np.concatenate(([0], np.cumsum(~measured)))
    middles = np.arange(half, len(q) - half, half // HALF_WIDTH)
    rows = middles[missing[middles + half + 1] == missing[middles - half]]
    if rows.size < BLOCKS * (FORCE_ORDER + 3 + GAIN_TERMS * log.v.shape[1]):
        return None
    size = float(np.std(q[measured])) or 1.0
    z = np.where(measured, (q - float(np.mean(q[measured]))) / size, 0.0)
    bump, slope, curvature = _bump(half, log.interval)
    # z² ż is the rate of z³/3.
    motion = [*(_average(z**k, bump) for k in range(FORCE_ORDER + 1)), _average(z, slope), _average(z**3 / 3.0, slope)]
    return WeakTerms(
        size=size,
        z=z,
        rows=rows,
        inertia=_average(z, curvature)[rows],
        motion=np.column_stack([term[rows] for term in motion]),
        inputs=_input_terms(acting, z, bump),
        interval=log.interval,
        bump=bump,
    )


def under_inputs(terms: WeakTerms, acting: FloatArray) -> WeakTerms:
    """The terms of a log of the same motion with other acting inputs, shape (N, K)."""
    return replace(terms, inputs=_input_terms(acting, terms.z, terms.bump))


def solve(design: FloatArray, inertia: FloatArray) -> FloatArray:
    """Least squares with columns of equal size; directions that the data do not show are left at zero."""
    normal = design.T @ design
    size = np.sqrt(np.diag(normal))
    size = np.where(size > 0.0, size, 1.0)
    values, directions = np.linalg.eigh(normal / np.outer(size, size))
    shown = values > len(design) * np.finfo(float).eps * values[-1]
    answers = directions[:, shown].T @ (design.T @ inertia / size) / values[shown]
    return np.asarray(directions[:, shown] @ answers / size)


def residual(terms: WeakTerms, lag: int = 0) -> FloatArray:
    """Residual of the accelerations under the log's own weights, shape (R,); inputs act `lag` samples late.

    Cost: 0.2 ms for 4,000 bumps.
    """
    design = terms.design(lag)
    return terms.inertia - design @ solve(design, terms.inertia)


def unexplained(terms: WeakTerms) -> float:
    """RMS residual of the accelerations under the log's own weights, over their RMS."""
    return float(np.linalg.norm(residual(terms))) / max(float(np.linalg.norm(terms.inertia)), np.finfo(float).tiny)


def _input_terms(acting: FloatArray, z: FloatArray, bump: FloatArray) -> FloatArray:
    """`WeakTerms.inputs` of the acting inputs, each over its largest drive."""
    e = acting[: len(z)]
    drive = np.max(np.abs(e), axis=0)
    e = e / np.where(drive > 0.0, drive, 1.0)
    averages = [np.column_stack([_average(column * z**k, bump) for k in range(GAIN_TERMS)]) for column in e.T]
    return np.stack(averages, axis=1)


def _bump(half: int, h: float) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Weights, shape (2 half + 1,) each, that average a signal, its first and its second derivative under the bump."""
    s = np.arange(-half, half + 1) / half
    shape = 1.0 - s**2
    width = half * h
    total = float((shape**4).sum())
    curvature = (-8.0 * shape**3 + 48.0 * s**2 * shape**2) / width**2
    return shape**4 / total, -8.0 * s * shape**3 / width / total, curvature / total


def _average(x: FloatArray, weights: FloatArray) -> FloatArray:
    return np.asarray(np.convolve(x, weights, "same"))


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
    spans = np.ptp(np.lib.stride_tricks.sliding_window_view(v, rows, axis=0), axis=2)
    begins = np.flatnonzero(still & moved & np.all(spans <= _STILL * np.ptp(v, axis=0), axis=1))
    return tuple(t[begins[np.diff(begins, prepend=-rows) > _ANSWER] + rest].tolist())


def rest_drift(
    t: FloatArray, q: FloatArray, v: FloatArray, interval: float, wells: Wells | NoWells, plant: Device
) -> float | None:
    """The common slope of the rests in both wells over time, by least squares; None where it is not sure or small.

    A rest in which q still swings counts the less. What the small inputs of a rest shift it by is estimated too.

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
    ends = [end_of_rest(rest, interval) for rest in places_of_rest(q, v, interval, plant=plant)]
    ends = [rows for rows in ends if np.isfinite(q[rows]).all()]
    reach = float(np.nanmax(q) - np.nanmin(q))
    means = np.array([[*np.mean(plant.acting(v[rows]), axis=0), np.mean(t[rows])] for rows in ends])
    places = np.array([np.median(q[rows]) for rows in ends])
    right = places > wells.barrier if isinstance(wells, Wells) else np.zeros(places.size, dtype=np.bool_)
    sides = [side for side in (~right, right) if side.any()]
    design = np.column_stack([*sides, means]) if sides else np.empty((0, 1))
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
    t, q, v = (np.ascontiguousarray(signal[::every]) for signal in (log.t, log.q, log.v))
    wells = find_wells([(q, v, every * log.interval)], plant=plant)
    both_signs = any(map(takes_both_signs, log.v.min(axis=0).tolist(), log.v.max(axis=0).tolist()))
    signed_monitor = None
    if terms is not None and both_signs and log.v.shape[1] == 1:
        sides = np.square(np.hstack([np.maximum(log.v, 0.0), np.maximum(-log.v, 0.0)]))
        signed_monitor = unexplained(under_inputs(terms, sides))
    return LogFacts(
        signals=log,
        sample_interval=sample_interval,
        input_forces=(None,) * log.v.shape[1] if terms is None else input_forces(terms),
        late=0.0 if terms is None else late_answer(terms, sample_interval),
        peaks=np.max(np.abs(log.v), axis=0),
        span=float(np.nanmax(log.q) - np.nanmin(log.q)),
        wells=wells,
        unexplained=None if terms is None else unexplained(terms),
        under_other_action=(
            None if terms is None else unexplained(under_inputs(terms, plant.under_other_action.acting(log.v)))
        ),
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
            result[i] = float(np.mean(terms.z[terms.rows][on, None] ** np.arange(GAIN_TERMS) @ weights[i]))
    return result * terms.size
