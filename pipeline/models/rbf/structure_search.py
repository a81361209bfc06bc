"""Structure of a data-driven joint: candidates are fitted on a part of the training logs and judged on the rest."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from ...fitting.descent import Prior
from ...fitting.homotopy import COUPLED, GAINS, LEVEL_TOLERANCE, Callbacks, HomotopyFit, Schedule, fit_homotopy
from ...fitting.posterior import surely_smaller
from ...fitting.regression import InputAction
from ...numerics.arrays import FloatArray
from ...numerics.metrics import rms
from ...signals.log import Log
from ...system.worker_pool import OnProgress, silent
from ..model_type import KnownCurves
from .candidates import Candidate, Offer
from .parameter_layout import ParameterLayout
from .prior import joint_prior, pin_curves, population
from .problem import COARSE_STEP, Effort, JointProblem
from .start import TIMES, data_scales, starting_joint

FITTED_SHARE = 0.65
"""Share of each training log that the candidates are fitted on; they are judged by a free run over the rest."""

QUICK_GAINS = (*GAINS[::2], GAINS[-1])
"""Observer gains of the fits that only serve to compare candidates."""

NEAR_GAINS = (COUPLED, GAINS[-1])
"""Gains where the fit of a similar structure gives the start."""

QUICK_ITERATIONS = 10
"""Steps of these fits per level, and half of those in free run."""

MANY = 40
"""Parameters beyond which they take half as many: each costs more, and the start knows less of each."""

DIVERGED_ERROR_HALF_RANGES = 1.0
"""Dimensionless error at which a diverged sample counts: half the operating range."""

EXCERPT = 8_000
"""Integration steps of a fit that only compares: longer logs are cut to the excerpt in which q ranges furthest."""

SHORTEST = 500
"""Samples of a log that no cut leaves less of."""

LEAST_SAMPLES = 1_500
"""Samples of all logs together below which none is left out where candidates are only compared."""

GROUPS = 3
"""Groups of the training logs of which each is held out once, at most: every fold takes a fit of each candidate."""

FAR = 1.3
"""Times the error in free run beyond which a smaller structure must not err surely more coupled to the measurement
either: passages between two wells make free runs err so much that hardly anything is sure."""

TOO_SIMPLE = 1.5
"""Times the error over what was fitted beyond which a smaller structure does not replace a larger one whatever held-out
data say: of a slow device they may hold too little to be sure of anything."""

ROUNDS = 4
"""Times that offers are made which depend on other fields, at most: fields could change in turns."""

SEARCH_SHARE = 0.6
"""Share of the effort after which nothing more is offered: the rest is for the fit of the chosen structure."""

IDLE = 0.01
"""Share of a sample interval below which a lag or a delay has no effect that the samples show."""


Begun = tuple[ParameterLayout, FloatArray, Prior]
"""Parameterisation, start and prior."""

Fit = tuple[ParameterLayout, FloatArray]
"""Parameterisation and θ."""


@dataclass(frozen=True)
class Setting:
    """Settings that all candidates share.

    Attributes
    ----------
    inputs : InputAction
    measured : KnownCurves or None
        Measured curves per unit mass.
    effort : Effort
    on_progress : callable
    thinning : int
        One of so many samples is compared.
    coupled : float
        Smallest observer gain of a fit: 0, the free run, but for a chaotic and for a bistable device.
    """

    inputs: InputAction
    measured: KnownCurves | None
    effort: Effort = field(default_factory=Effort)
    on_progress: OnProgress = silent
    thinning: int = 1
    coupled: float = 0.0

    def begin(self, records: Sequence[Log], option: Candidate, like: Fit | None = None) -> Begun:
        """Parameterisation, start and prior of a candidate; lag and delay start as in another fit of it."""
        structure = option.structure
        if self.measured:
            structure = replace(
                structure,
                force="curve",
                constant_gain=False,
                bent_input=False,
                dead_zone=False,
                stops=structure.stops and self.measured.force is None,
            )
        p, start = starting_joint(
            records,
            structure,
            self.inputs,
            centred=option.population or option.symmetry is not None,  # q = 0 is the mirror plane
            known_signs=self.measured.signs if self.measured else None,
            reach=self.measured.reach if self.measured else (np.inf, -np.inf),
            timing={name: like[1][like[0].slices[name]] for name in TIMES} if like else None,
        )
        prior = population().prior(p) if option.population else joint_prior(p, start, option.symmetry)
        return (p, *pin_curves(p, start, prior, self.measured)) if self.measured else (p, start, prior)

    def progress(self, what: str, half: float) -> Callable[[float, float], None]:
        """Report of a fit: level and present error in millimetres or milliradians."""

        def report(gain: float, rms: float) -> None:
            """Report a level: observer gain, error in half ranges."""
            level = f"observer {gain:g}" if gain else "free run"
            self.on_progress(
                f"{what}: {level}, error {1e3 * half * rms:.3g}e-3", min(1.0, self.effort.spent / self.effort.limit)
            )

        return report


def search(
    records: Sequence[Log],
    setting: Setting,
    first: Candidate,
    once: Sequence[Offer],
    again: Sequence[Offer] = (),
) -> tuple[Candidate, Fit | None, dict[str, float]]:
    """One offer after the other, each to the best candidate so far: `once`, then `again` until none is taken.

    The rule is that of one standard error (Breiman et al. 1984): the simplest of those about as good as the best. One
    surely errs less than another if the difference exceeds a standard error (`surely_smaller`).

    * A candidate with more parameters replaces the one before if its free run errs less, and if it surely errs less in
      free run or coupled to the measurement.
    * A candidate with fewer parameters replaces it unless it surely errs more in one of three ways: in free run;
      coupled, where its free run errs `FAR` times as much; or by `TOO_SIMPLE` times over what it was fitted to.

    A free run carries an error on. Of a mass without spring, or near a separatrix, it is worth few independent samples,
    where coupled ones forget.

    Parameters
    ----------
    records : sequence of Log
        Training logs.
    setting : Setting
        Settings that all candidates share.
    first : Candidate
        The simplest one.
    once, again : sequence of Offer
        Offers, those of `again` up to `ROUNDS` times.

    Returns
    -------
    Candidate
        The chosen one.
    Fit or None
        The fit by which it was judged; None if nothing was offered.
    dict of str to float
        RMS held-out error of each candidate that was tried, in the unit of q, the geometric mean of the folds; empty if
        nothing was offered.
    """
    setting = replace(setting, thinning=max(1, sum(len(r.t) for r in records) // LEAST_SAMPLES))
    records = excerpts(records)
    scales = data_scales(records, centred=False)
    tried: dict[str, _Judged] = {}

    def judged(option: Candidate) -> _Judged:
        """The errors of an option, computed once."""
        if option.label not in tried:
            tried[option.label] = _judge(records, setting, option, tried.get(best.label))
        return tried[option.label]

    def better(option: Candidate, than: Candidate) -> bool:
        """True if an option replaces the best so far; a lag or a delay without effect is no reason."""
        if any(not getattr(than.structure, time) for time in judged(option).idle):
            return False
        smaller = size(option) < size(than)
        rivals = {than.label: than} | {before.label: before for before in taken if smaller}
        return all(_preferred(judged(option), judged(rival), smaller=smaller) for rival in rivals.values())

    def size(option: Candidate) -> int:
        """The number of its parameters."""
        return ParameterLayout(option.structure, scales, setting.inputs, (0,) * records[0].v.shape[1]).count

    best = first
    last_taken = len(once)
    taken = [first]
    for number, offer in enumerate([*once, *ROUNDS * tuple(again)]):
        if number - last_taken >= len(again) > 0:
            break
        others = offer(best)
        affordable = [(judged(each).rms, each) for each in others if not setting.effort.exhausted(SEARCH_SHARE)]
        for _, option in sorted(affordable, key=lambda pair: pair[0]):
            if better(option, best):
                best = option
                last_taken = max(number + 1, len(once))
                taken.append(option)
    return best, tried[best.label].fits[0] if tried else None, {label: each.rms for label, each in tried.items()}


@dataclass(frozen=True)
class _Judged:
    """Errors and fits of a candidate.

    The held-out errors (2, N) of each fold, in the unit of q, are coupled to the measurement at `COUPLED`, and free.
    Then its errors over the data of its first fit, and the fits fold by fold. Last the times of its drive that have no
    effect in any: a lower error with them is the luck of another way to the same minimum.
    """

    errors: tuple[FloatArray, ...]
    fitted: FloatArray
    fits: tuple[Fit, ...]
    idle: tuple[str, ...]

    @property
    def rms(self) -> float:
        """Of the free runs, in the unit of q: the geometric mean of the folds."""
        return float(np.exp(np.mean([np.log(rms(errors[-1]) + np.finfo(float).tiny) for errors in self.errors])))


def _preferred(new: _Judged, old: _Judged, *, smaller: bool) -> bool:
    """True if one candidate is preferred to another: if smaller, not surely worse; if larger, surely better."""
    coupled, free = (_in_equal_units(new, old, kind) for kind in (0, -1))
    if smaller:
        far = rms(free[0]) > FAR * rms(free[1]) and surely_smaller(*coupled[::-1])
        follows_less = rms(new.fitted) > TOO_SIMPLE * rms(old.fitted) and surely_smaller(old.fitted, new.fitted)
        return not (far or follows_less or surely_smaller(*free[::-1]))
    return rms(free[0]) < rms(free[1]) and (surely_smaller(*free) or surely_smaller(*coupled))


def _in_equal_units(new: _Judged, old: _Judged, kind: int) -> tuple[FloatArray, FloatArray]:
    """Held-out errors of two candidates over the folds, each fold in the geometric mean of what both err there.

    A fold whose excitation reaches beyond what was fitted has errors many times as large, and would decide alone.
    """
    pairs = [(a[kind], b[kind]) for a, b in zip(new.errors, old.errors, strict=True)]
    units = [np.sqrt(rms(a) * rms(b)) + np.finfo(float).tiny for a, b in pairs]
    first, second = ([pair[i] / unit for pair, unit in zip(pairs, units, strict=True)] for i in (0, 1))
    return np.concatenate(first), np.concatenate(second)


def excerpts(records: Sequence[Log]) -> list[Log]:
    """The logs, cut where together they take more than `EXCERPT` coarse steps."""
    step = COARSE_STEP / data_scales(records, centred=False).frequency
    total = sum(len(r.t) * max(1, np.ceil(r.interval / step)) for r in records)
    thinning = max(1, sum(len(r.t) for r in records) // LEAST_SAMPLES)
    return cut(records, EXCERPT * max(1.0, min(thinning, min(step / r.interval for r in records))) / total)


def cut(records: Sequence[Log], share: float) -> list[Log]:
    """The logs, each cut to its most moving excerpt of a share below 1, but to `SHORTEST` at least."""
    lengths = [max(int(share * len(r.t)), SHORTEST) for r in records]
    return [r if length >= len(r.t) else _excerpt(r, length) for r, length in zip(records, lengths, strict=True)]


def _excerpt(record: Log, length: int) -> Log:
    """The segment of so many samples in which q ranges furthest; it begins with a valid sample."""
    q = np.where(record.valid, record.q, np.nan)
    starts = range(0, len(q) - length + 1, max(1, length // 4))
    spans = [np.nanmax(q[s : s + length]) - np.nanmin(q[s : s + length]) for s in starts]
    start = starts[int(np.nanargmax(spans))]
    start += int(np.argmax(record.valid[start:]))
    return record.part(start, start + length)


def _folds(records: Sequence[Log]) -> list[tuple[list[Log], list[Log], float]]:
    """Parts of the logs that are fitted and judged, and the share after which judging begins.

    Fitted on the first part of every log and judged on the rest. Then, with several logs, fitted on all but some and
    judged on these, so that a structure must carry over to another excitation: on one each, or on a third of many. With
    one log, fitted on its last part and judged on what was before.
    """
    folds = [([r.part(0, int(FITTED_SHARE * len(r.t))) for r in records], list(records), FITTED_SHARE)]
    if len(records) == 1:
        only = records[0]
        split = int((1.0 - FITTED_SHARE) * len(only.t))
        split += int(np.argmax(only.valid[split:]))
        folds.append(([only.part(split, len(only.t))], [only.part(0, split)], 0.0))
        return folds
    groups = [list(records[i::GROUPS]) for i in range(min(GROUPS, len(records)))]
    return folds + [([r for other in groups if other is not group for r in other], group, 0.0) for group in groups]


def _judge(records: Sequence[Log], setting: Setting, option: Candidate, near: _Judged | None) -> _Judged:
    """Errors of a candidate over data of the training logs that its fit has not seen.

    Samples of a run that is lost count `DIVERGED_ERROR_HALF_RANGES`. The fits start from those of a candidate `near`
    by, where that is given: what both have in common needs no second search.
    """
    timed = option.structure.input_lag or option.structure.input_delay
    errors = list[FloatArray]()
    fits = list[Fit]()
    followed = np.empty(0)
    for i, (fitted, judged, after) in enumerate(_folds(records)):
        # One log may say little of lag and delay, and even of a gain's sign: they start as the fit of all has them.
        p, start, prior = setting.begin(fitted, option, fits[0] if timed and fits else None)
        fit = _quick_fit(p, fitted, start, prior, setting, option, near.fits[i] if near else None)
        problem = JointProblem(p, judged, after, step=COARSE_STEP, thinning=setting.thinning, effort=setting.effort)
        both = [
            np.concatenate(problem.held_out(fit.theta, GAINS[1], coupled)) for coupled in (COUPLED, setting.coupled)
        ]
        errors.append(p.scales.half * np.minimum(np.abs(both), DIVERGED_ERROR_HALF_RANGES))
        fits.append((p, fit.theta))
        followed = followed if i else p.scales.half * _followed(problem, fit.theta, setting.coupled)
    return _Judged(tuple(errors), followed, tuple(fits), _idle(fits, records[0].interval))


def _followed(problem: JointProblem, theta: FloatArray, gain: float) -> FloatArray:
    """Errors over what was fitted, dimensionless; `DIVERGED_ERROR_HALF_RANGES` where the run diverged."""
    residual = problem.residual(theta, gain)
    if residual is None:
        return np.full(sum(int(np.count_nonzero(log.in_residual)) for log in problem.logs), DIVERGED_ERROR_HALF_RANGES)
    return np.minimum(np.abs(residual), DIVERGED_ERROR_HALF_RANGES)


def _idle(fits: Sequence[Fit], interval: float) -> tuple[str, ...]:
    """The times of the drive that are next to nothing in all fits, at samples every `interval` [s]."""
    times = {name: np.exp([theta[p.slices[name]] for p, theta in fits]) for name in TIMES}
    return tuple(name for name, time in times.items() if time.size and bool(np.all(time < IDLE * interval)))


def _quick_fit(
    p: ParameterLayout,
    records: Sequence[Log],
    start: FloatArray,
    prior: Prior,
    setting: Setting,
    option: Candidate,
    near: Fit | None,
) -> HomotopyFit:
    """A fit that is good enough to compare: from one near by in few levels, or else from the start in all."""
    problem = JointProblem(p, records, step=COARSE_STEP, thinning=setting.thinning, effort=setting.effort)

    steps = QUICK_ITERATIONS if p.count <= MANY else QUICK_ITERATIONS // 2

    def fitted(theta: FloatArray, gains: Sequence[float]) -> HomotopyFit:
        """A quick homotopy from θ over the observer gains [frequency scale] that are strong enough."""
        return fit_homotopy(
            problem,
            theta,
            prior,
            Schedule(
                gains=[gain for gain in gains if gain >= setting.coupled],
                iterations=steps,
                last_iterations=2 * steps,
                tolerance=LEVEL_TOLERANCE,
                noise_inflation=option.noise_inflation,
            ),
            callbacks=Callbacks(
                on_progress=setting.progress(option.label, p.scales.half), is_chaotic=problem.is_chaotic
            ),
        )

    if near is not None and p.count > MANY and _alike(p, near[0]):
        fit = fitted(_adopted(p, start, *near), NEAR_GAINS)
        if fit.levels and fit.levels[-1].gain <= setting.coupled:
            return fit
    return fitted(start, QUICK_GAINS)


def _alike(p: ParameterLayout, near: ParameterLayout) -> bool:
    """True if the fit of another structure is a good start: its inputs act alike, its scales and signs are equal."""
    same = (getattr(p.structure, n) == getattr(near.structure, n) for n in ("effect_lags", "rest_at_zero", *TIMES))
    return all(same) and near.scales == p.scales and near.signs == p.signs


def _adopted(p: ParameterLayout, start: FloatArray, near: ParameterLayout, theta: FloatArray) -> FloatArray:
    """The start with every block that the structure near by has in the same size."""
    adopted = start.copy()
    same = all(getattr(p.structure, name) == getattr(near.structure, name) for name in ("basis_functions", "smoothing"))
    for name, where in p.slices.items():
        other = near.slices.get(name)
        if other is not None and other.stop - other.start == where.stop - where.start and (same or name in _PLAIN):
            adopted[where] = theta[other]
    return adopted


_PLAIN = ("rate", "slip_force", "slip_length", "inertia", "inertia_centre", "drag", "stops", "input_offset",
          "input_lag", "input_delay", "input_bend", "input_zone")  # fmt: skip
"""Blocks that mean the same whatever the Gaussians are."""
