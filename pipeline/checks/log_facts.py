"""What one log shows of its device without any model: pushes, delays, rests, ring-down, spans.

And whether two logs show one device: the accelerations of one, predicted by what the other taught, say so.
"""

from dataclasses import dataclass

import numpy as np

from pipeline.checks.push_and_delay import InputFacts, input_facts
from pipeline.checks.weak_form import FORCE_ORDER, LogSignals, WeakTerms, scales_of, solve, weak_terms
from pipeline.device_facts.events import RestFacts, rest_facts
from pipeline.numerics.arrays import BoolArray, FloatArray
from pipeline.scoring.wells import NoWells, Wells, find_wells

_CLEAR_RING = 0.15  # unexplained share up to which a ring-down's frequency counts


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


def log_facts(log: LogSignals, sample_interval: float, *, squared: bool) -> LogFacts:
    """Look at one log.

    Cost: 0.2 s for 40,000 samples, most of it the ring-downs.
    """
    terms = weak_terms(log, sample_interval, scales_of(log, squared=squared), squared=squared)
    inputs = (None,) * log.v.shape[1] if terms is None else input_facts(terms, sample_interval)
    every = max(1, round(sample_interval / log.interval))
    t, q, v = log.t[::every], log.q[::every], np.ascontiguousarray(log.v[::every])
    wells = find_wells([(q, v, every * log.interval)])
    rests = rest_facts([(t, q, v)], wells)
    rings = [ring for ring in (*rests.rings_left, *rests.rings_right) if ring.unexplained <= _CLEAR_RING]
    return LogFacts(
        signals=log,
        inputs=inputs,
        peaks=np.max(np.abs(log.v), axis=0),
        span=float(np.nanmax(log.q) - np.nanmin(log.q)),
        wells=wells,
        rests=rests,
        ring=float(np.median([ring.frequency for ring in rings])) if rings else None,
        damping=float(np.median([ring.damping for ring in rings])) if rings else None,
        natural=None if terms is None else _natural_frequency(terms),
    )


def _natural_frequency(terms: WeakTerms) -> float | None:
    """From ``ω² = −∂f/∂q`` where the force vanishes and is stable; it needs no time window, so it can be anything."""
    force = np.polynomial.Polynomial(solve(terms.design(), terms.inertia)[: FORCE_ORDER + 1])
    roots = force.roots()
    rests = roots.real[np.abs(roots.imag) < 1e-9 * (1.0 + np.abs(roots.real))]
    low, high = np.quantile(terms.q, (0.01, 0.99))
    squares = -force.deriv()(rests[(rests > low) & (rests < high)])
    stable = squares[squares > 0.0]
    return float(np.exp(np.mean(np.log(stable))) ** 0.5 / (2.0 * np.pi)) if stable.size else None


_LEAST_SHARED = 60


def misfit_ratio(first: WeakTerms, second: WeakTerms) -> float | None:
    """How much worse one log's weak form explains the other than that explains itself.

    Each log's weights predict the accelerations of the other, at those displacements that both visit; the median
    residual over that of the log's own weights is taken, and of the two directions the smaller one. Both logs must
    share their `Scales`. One device gives 0.8 to 1.2, whatever the voltages; another of the same drawing 2 and more.

    Returns
    -------
    float or None
        None where the logs share too few displacements, or one of them is explained without any residual.
    """
    ratios = [
        ratio for a, b in ((first, second), (second, first)) if (ratio := _misfit(a, b, _shared(a, b))) is not None
    ]
    return min(ratios, default=None)


def _shared(taught: WeakTerms, judged: WeakTerms) -> BoolArray:
    """Bumps of `judged` at displacements that `taught` has seen, outliers left out."""
    low, high = np.quantile(taught.q, (0.01, 0.99))
    inside: BoolArray = (judged.q >= low) & (judged.q <= high)
    return inside


def _misfit(taught: WeakTerms, judged: WeakTerms, rows: BoolArray) -> float | None:
    if np.count_nonzero(rows) < _LEAST_SHARED:
        return None
    design, inertia = judged.design(), judged.inertia
    foreign = inertia - design @ solve(taught.design(), taught.inertia)
    own = inertia - design @ solve(design, inertia)
    size = float(np.median(np.abs(own[rows])))
    return float(np.median(np.abs(foreign[rows]))) / size if size > 0.0 else None
