"""Identification of the data-driven joint: convex start and observer homotopy.

Inner validation chooses the structure of a device (`structure_search`). Held-out free runs of a bistable device are
decided by a few passages between its wells, so its structure and prior are chosen by their marginal likelihood while an
observer holds it near its logs. Coupled to the measurement as much as the first level of a fit is, no passage decides:
the errors are small, nearly linear in the parameters, and nearly white. There the marginal likelihood
p(log | structure) = ∫ p(log | θ) p(θ) dθ has a Gaussian integrand (Laplace; MacKay 1992,
doi:10.1162/neco.1992.4.3.415). It charges every element for the room that its prior leaves it, so that an element which
the log does not show is left out.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from ...errors import DataRefusedError
from ...fitting.descent import FLOOR
from ...fitting.homotopy import (
    COUPLED,
    GAINS,
    LEVEL_TOLERANCE,
    Callbacks,
    HomotopyFit,
    Schedule,
    fit_homotopy,
)
from ...fitting.information import coverage
from ...fitting.posterior import log_evidence, posterior_factor, robust_spread, whiteness
from ...fitting.regression import InputAction
from ...numerics.arrays import FloatArray
from ...numerics.metrics import NORMAL_90, rms
from ...settings.models import RBF_TIME_LIMIT
from ...signals.log import Log, operating_range
from ...system.worker_pool import OnProgress, silent
from ..free_runs import scale_on
from ..model_type import KnownCurves, ModelType, Training
from .candidates import Candidate, Offer, decided_fields, first_candidate, joint_offers, offers
from .model import RbfModel
from .parameter_layout import MOST_REFINED
from .prior import population
from .problem import Effort, JointProblem
from .start import bistable_signs, looks_overdamped
from .structure_search import SEARCH_SHARE, Begun, Setting, cut, excerpts, search

NEGLIGIBLE_INPUT = 0.01
"""Share of the largest input below which one does nothing."""

JACOBIANS = 20
LAST_JACOBIANS = 8
"""Jacobians of a descent, and of its last level on whole logs, that a time limit must at least hold; logs are cut where
it does not: of an hour at 10 ms a single one takes longer than a limit."""

SAMPLES_OF_LIMIT = 7_500
"""Samples of all training logs beyond which the time limit of a structure search grows in proportion."""

TUBE_MARGIN = 1.5
TUBE_LEAST = NORMAL_90
"""Factor on the 90 % quantile of errors on the training logs, for tubes of other logs; and their least half width over
the spread of the draws. That holds nine tenths of a normal distribution: a short log is followed to the noise. Chosen
on fifteen simulated joints of three physics and eleven other devices, three of them measured."""

ITERATIONS = 15
"""Steps per observer level before the last one; most fits converge within ten."""

LAST_ITERATIONS = 300
"""Steps at the last level of a fit; most converge within 60."""

RESOLVED = 0.3
"""Standard errors by which the integration steps of a fit may move an estimate: a tenth of its mean square error."""

ODDS = 20.0
"""Odds that the logs must give a candidate against the one before it: an element is shown at the level of 5 %."""


def identify_rbf(
    records: Sequence[Log],
    *,
    mass: float = 1.0,
    inputs: InputAction = "squared",
    angle: bool = False,
    decided: Mapping[str, Any] | None = None,
    candidates: Sequence[Candidate] | None = None,
    measured: KnownCurves | None = None,
    time_limit: float = RBF_TIME_LIMIT,
    on_progress: OnProgress = silent,
) -> RbfModel:
    """Identify the data-driven joint from whole training logs.

    Parameters
    ----------
    records : sequence of Log
        Training logs, gaps and outliers masked.
    mass : float
        Moving mass [kg]; 1 if unknown.
    inputs : {"squared", "linear"}
        Action of the inputs: the force goes with v² or v.
    angle : bool
        True if q is an angle [rad].
    decided : mapping, optional
        Fields of the structure that are decided (`pipeline.models.rbf.candidates.decided_fields`).
    candidates : sequence of Candidate, optional
        Structures among which the inner validation chooses instead; a single one is taken as it is.
    measured : KnownCurves, optional
        Measured curves, which are kept; only the rest is learned.
    time_limit : float
        Processor time [s] by the cost model of `pipeline.models.rbf.problem`, which counts evaluations: the same
        data and limit give the same model on every machine. The structure search takes at most 0.6 of it. Where a
        structure is searched on more than `SAMPLES_OF_LIMIT` samples, it is as many times as long.
    on_progress : callable
        Receives what is going on, with the present error, and which share of the limit is spent.

    Raises
    ------
    InputError
        No data, a constant displacement, inputs that are always zero, known curves outside the data.
    DataRefusedError
        No candidate follows the training logs.
    """
    wanted = dict(decided or {})
    if measured:
        measured.check(*operating_range(records))
        measured = measured.per_unit_mass(mass)
    signs = bistable_signs(records, inputs)
    pair = signs in ((1, -1), (-1, 1))  # the two membranes of a joint pull in opposite directions
    longer = 1.0 if pair else max(1.0, sum(len(record.t) for record in records) / SAMPLES_OF_LIMIT)
    effort = Effort(time_limit * longer)
    # Passages near a separatrix would outweigh all else in the free run of a bistable device.
    setting = Setting(inputs, measured, effort, on_progress, coupled=COUPLED if signs else GAINS[-1])
    fine = all(r.fine is not None for r in records)
    first = candidates[0] if candidates else first_candidate(wanted, pair=pair, angle=angle, fine=fine)
    if candidates:
        once, again = [lambda _: candidates[1:]], list[Offer]()
    elif pair:
        once, again = joint_offers(
            wanted,
            angle=angle,
            mirrored=bool(np.prod(operating_range(records)) < 0.0),  # q = 0, the mirror plane, is in the range
            knows=lambda structure: not measured and population().knows(structure),
        )
    else:
        once, again = offers(
            wanted,
            fine=fine,
            slow=looks_overdamped(records, inputs),
            driven=any(bool(np.any(np.abs(r.v[0]) > NEGLIGIBLE_INPUT * np.abs(r.v).max())) for r in records),
            squared=inputs == "squared",
        )
    if signs and not candidates:
        shown, tried = _by_evidence(excerpts(records), setting, first, once, again)
        chosen, begun, levels = shown.candidate, shown.begun, GAINS[len(shown.fit.levels) :]
    else:
        chosen, judged, tried = search(records, setting, first, once, again)
        begun, levels = setting.begin(records, chosen, judged), GAINS
    complete = not effort.exhausted(SEARCH_SHARE)
    fitted = _fit_to_all(records, setting, chosen, begun, levels)
    fit = fitted.fit
    if not fit.levels:
        raise DataRefusedError("no simulation follows the training logs even when held near them; check q and units")
    p, _, prior = fitted.begun
    model = RbfModel(
        parameters=p,
        theta=fit.theta,
        spread=posterior_factor(fit, prior),
        band_spread=robust_spread(*fitted.problem.jacobian(fit.theta, fit.levels[-1].gain), fit.noise, prior),
        mass_kg=mass,
    )
    diagnostics = _diagnostics(records, fitted, tried) | {
        "effort_s": effort.spent,
        "search_complete": complete,
        "elements": model.acting(records),
    }
    model = replace(model, diagnostics=diagnostics)
    return replace(model, tube=scale_on(records, model, fitted.rms, TUBE_MARGIN, TUBE_LEAST))


@dataclass(frozen=True)
class _Fitted:
    """A candidate fitted to logs.

    Attributes
    ----------
    candidate : Candidate
    begun : Begun
        Parameterisation, θ, and prior.
    fit : HomotopyFit
    errors : FloatArray, shape (N,)
        Dimensionless.
    problem : JointProblem
    evidence : float
        Logarithm of the marginal likelihood, where structures are compared by it; −∞ if no simulation follows the logs.
    """

    candidate: Candidate
    begun: Begun
    fit: HomotopyFit
    errors: FloatArray
    problem: JointProblem
    evidence: float = -np.inf

    @property
    def rms(self) -> float:
        """Of its errors, in the unit of q; infinite if nothing was fitted."""
        return self.begun[0].scales.half * rms(self.errors) if self.errors.size else np.inf


def _by_evidence(
    records: Sequence[Log], setting: Setting, first: Candidate, once: Sequence[Offer], again: Sequence[Offer]
) -> tuple[_Fitted, dict[str, float]]:
    """A bistable device of the elements and the prior that its logs show.

    The offers are made to the best candidate so far. A smaller candidate replaces it where the logs make it more
    probable, any other where they give odds of more than `ODDS` for it. Beside it: the residual of each that was tried.
    """
    best = _trial(records, setting, first, None)
    tried = {first.label: best}

    def after(best: _Fitted, turn: Sequence[Offer]) -> _Fitted:
        """The best candidate when the offers of a turn have been made."""
        for offer in turn:
            for option in offer(best.candidate):
                if option.label not in tried and not setting.effort.exhausted(SEARCH_SHARE):
                    tried[option.label] = _trial(records, setting, option, best)
            shown = (
                trial
                for trial in tried.values()
                if trial.evidence - best.evidence > np.log(ODDS) * (trial.begun[0].count >= best.begun[0].count)
            )
            best = max([best, *shown], key=lambda trial: trial.evidence)
        return best

    best, before = after(best, once), None
    while best is not before:
        best, before = after(best, again), best
    return best, {label: trial.rms for label, trial in tried.items()}


def _trial(records: Sequence[Log], setting: Setting, option: Candidate, near: _Fitted | None) -> _Fitted:
    """A candidate fitted at the first observer gain, from the fit of another prior where that has its structure."""
    p, start, prior = setting.begin(records, option)
    if near is not None and near.begun[0] == p:
        start = near.begun[1]
    problem = JointProblem(p, records, effort=setting.effort)
    fit = fit_homotopy(
        problem,
        start,
        prior,
        Schedule(
            GAINS[:1],
            last_iterations=LAST_ITERATIONS,
            tolerance=LEVEL_TOLERANCE,
            noise_inflation=option.noise_inflation,
        ),
        callbacks=Callbacks(
            enough=lambda: setting.effort.exhausted(SEARCH_SHARE),
            on_progress=setting.progress(option.label, p.scales.half),
        ),
    )
    evidence = log_evidence(fit, prior, Candidate.noise_inflation**2) if fit.levels else -np.inf
    return _Fitted(option, (p, fit.theta, prior), fit, fit.residual, problem, evidence)


def _fit_to_all(
    records: Sequence[Log],
    setting: Setting,
    option: Candidate,
    begun: Begun,
    levels: Sequence[float],
) -> _Fitted:
    """A candidate on all data: long logs by their excerpts first, then as much of them as the effort allows."""
    p, start, prior = begun
    gains = [gain for gain in levels if gain >= setting.coupled]

    def descend(problem: JointProblem, theta: FloatArray, gains: Sequence[float], share: float) -> HomotopyFit:
        """θ after a homotopy over the observer gains [frequency scale], within a share of the effort."""
        return fit_homotopy(
            problem,
            theta,
            prior,
            Schedule(
                gains=gains,
                iterations=ITERATIONS,
                last_iterations=LAST_ITERATIONS,
                noise_inflation=option.noise_inflation,
            ),
            callbacks=Callbacks(
                enough=lambda: setting.effort.exhausted(share),
                on_progress=setting.progress(option.label, p.scales.half),
                is_chaotic=problem.is_chaotic,
            ),
        )

    def within(logs: Sequence[Log], theta: FloatArray, jacobians: int) -> JointProblem:
        """The logs, or so much of them that a time limit holds so many Jacobians."""
        problem = JointProblem(p, logs, effort=setting.effort)
        affordable = setting.effort.limit / (jacobians * problem.jacobian_effort(theta))
        return problem if affordable >= 1.0 else JointProblem(p, cut(logs, affordable), effort=setting.effort)

    problem = within(excerpts(records), start, JACOBIANS)
    whole = all(len(log.measured) == len(record.t) for log, record in zip(problem.logs, records, strict=True))
    fit = descend(problem, start, gains, 1.0 if whole else 0.8)
    if not whole and fit.reached_last:
        complete = within(records, fit.theta, LAST_JACOBIANS)
        last = descend(complete, fit.theta, gains[-1:], 1.0)
        fit, problem = (last, complete) if last.levels else (fit, problem)
    while fit.levels and problem.parameters.refinement < MOST_REFINED:
        finer = problem.refined()
        needed = LAST_JACOBIANS * finer.jacobian_effort(fit.theta)
        if _step_error(fit, finer) <= RESOLVED or setting.effort.spent + needed > setting.effort.limit:
            break
        last = descend(finer, fit.theta, [fit.levels[-1].gain], 1.0)
        if not last.levels:
            break
        passed = (*fit.levels, *last.levels)
        fit, problem = replace(last, levels=passed, reached_last=fit.reached_last, chaotic=fit.chaotic), finer
    return _Fitted(
        candidate=option,
        begun=(problem.parameters, start, prior),
        fit=fit,
        errors=fit.residual[problem.of_displacement] if fit.levels else fit.residual,
        problem=problem,
    )


def _step_error(fit: HomotopyFit, finer: JointProblem) -> float:
    """How far twice as many steps move the residual, which bounds how far they move any estimate [standard errors]."""
    ahead = finer.residual(fit.theta, fit.levels[-1].gain)
    if ahead is None:
        return 0.0
    independent = len(ahead) / whiteness(fit.residual).integrated_correlation_time
    return rms(ahead - fit.residual) / max(rms(fit.residual), FLOOR) * float(np.sqrt(independent))


def _diagnostics(records: Sequence[Log], fitted: _Fitted, tried: dict[str, float]) -> dict[str, object]:
    p = fitted.begun[0]
    fit = fitted.fit
    white = whiteness(fitted.errors)
    visited = coverage(
        p.scales.middle + p.scales.half * p.centres, [r.q[r.valid] for r in records], [r.v[r.valid] for r in records]
    )
    return {
        "chosen": fitted.candidate.label,
        "candidates": np.array(list(tried) or [fitted.candidate.label]),
        "candidate_rms_m": np.array(list(tried.values()) or [0.0]),
        "levels": {name: np.array([getattr(x, name) for x in fit.levels]) for name in vars(fit.levels[0])},
        "converged": fit.converged,
        "reached_free_run": fit.levels[-1].gain == GAINS[-1],
        "chaotic": fit.chaotic,
        "training_rms_m": fitted.rms,
        "residual_correlation_samples": white.integrated_correlation_time,
        "residual_lag_one": white.lag_one,
        "visits_per_centre": visited.visits,
        "driven_visits_per_centre": visited.driven,
    }


def _fit(training: Training) -> RbfModel:
    return identify_rbf(
        training.records,
        mass=training.device.mass,
        inputs=training.device.action,
        angle=training.device.displacement.symbol == "rad",
        decided=decided_fields(training.identify.structure, training.inputs_before),
        measured=training.known_curves,
        time_limit=training.identify.time_limit,
        on_progress=training.on_progress,
    )


RBF = ModelType(_fit, RbfModel, "export.data_driven:realise_rbf")
