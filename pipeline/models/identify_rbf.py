"""Identification of the data-driven joint: convex start, observer homotopy, choice by inner validation."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
import scipy.linalg

from pipeline.errors import DataRefusedError
from pipeline.identification.coverage import coverage
from pipeline.identification.homotopy import GAINS, HomotopyFit, Prior, fit_homotopy
from pipeline.identification.joint_parameters import JointParameters
from pipeline.identification.joint_problem import COARSE_STEP, JointProblem
from pipeline.identification.joint_start import data_scales, joint_prior, starting_joint
from pipeline.identification.known_curves import KnownCurves, pin_curves
from pipeline.identification.regressor import InputLaw
from pipeline.identification.residuals import surely_smaller, whiteness
from pipeline.models.rbf import RbfModel
from pipeline.models.rbf_candidates import Candidate, Question, RbfChoice, first_candidate, questions
from pipeline.numerics.arrays import FloatArray
from pipeline.signals.record import Record

INNER = 0.65
"""Share of each training log that the candidates are fitted on; they are judged by a free run over the rest."""

QUICK_GAINS = (3.0, 0.3, 0.03, 0.0)
"""Observer gains of the fits that only serve to compare candidates."""

BLOCK = 2.0
"""Time [s] over which errors hang together."""

NARROW = 2.5
"""How much too narrow the Gauss-Newton posterior is: on simulated joints of the model's own class, its 95 % bands of
the curves must be widened 2.1 to 2.7 times to hold 95 % of the truth. It is widened by this."""

LOST = 1.0
"""Dimensionless error at which a diverged sample counts: half the operating range."""


def identify_rbf(
    records: Sequence[Record],
    *,
    mass: float = 1.0,
    inputs: InputLaw = "squared",
    angle: bool = False,
    choice: RbfChoice | None = None,
    candidates: Sequence[Candidate] | None = None,
    known: KnownCurves | None = None,
) -> RbfModel:
    """Identify the data-driven joint from whole training logs.

    Parameters
    ----------
    records : sequence of Record
        Training logs, gaps and outliers masked.
    mass : float
        Moving mass [kg]; 1 if unknown.
    inputs : {"squared", "linear"}
        Whether the force goes with v² or v.
    angle : bool
        Whether q is an angle [rad].
    choice : RbfChoice, optional
        What is decided of the structure; the rest is found by inner validation.
    candidates : sequence of Candidate, optional
        Structures among which the inner validation chooses instead; a single one is taken without.
    known : KnownCurves, optional
        Measured curves, which are kept; only the rest is learned.

    Raises
    ------
    InputError
        No data, a constant displacement, inputs that are always zero, known curves outside the data.
    DataRefusedError
        No candidate follows the training logs.
    """
    wanted, count = choice or RbfChoice(), records[0].v.shape[1]
    if known:
        known.check(min(float(r.q[r.valid].min()) for r in records), max(float(r.q[r.valid].max()) for r in records))
        known = known.per_unit_mass(mass)
    setting = _Setting(inputs, known)
    if candidates is None:
        chosen, tried = _search(
            _coarse(records), setting, first_candidate(count, wanted, angle=angle), questions(count, wanted)
        )
    else:
        chosen, tried = _search(_coarse(records), setting, candidates[0], [lambda _: candidates[1:]])
    parameters, start, prior = setting.begin(records, chosen)
    fit = fit_homotopy(JointProblem(parameters, records), start, prior, caution=chosen.caution)
    if not fit.levels:
        raise DataRefusedError("no simulation follows the training logs even when tied to them; check q and units")
    return RbfModel(
        parameters,
        fit.theta,
        NARROW * posterior_factor(fit, prior),
        mass,
        _diagnostics(records, parameters, fit, chosen, tried),
    )


@dataclass(frozen=True)
class _Setting:
    """What holds for every candidate: the law of the inputs, and known curves per unit mass."""

    inputs: InputLaw
    known: KnownCurves | None

    def begin(self, records: Sequence[Record], one: Candidate) -> tuple[JointParameters, FloatArray, Prior]:
        """Parameterisation, start and prior of a candidate."""
        gains = {i for i, gain in enumerate(self.known.gains) if gain is not None} if self.known else set()
        structure = replace(one.structure, shape_elements=0) if gains else one.structure
        centred = one.symmetry is not None
        reach = self.known.reach if self.known else (np.inf, -np.inf)
        p, start = starting_joint(records, structure, self.inputs, centred=centred, known_gains=gains, reach=reach)
        prior = joint_prior(p, start, one.symmetry)
        return (p, *pin_curves(p, start, prior, self.known)) if self.known else (p, start, prior)


def _search(
    records: Sequence[Record], setting: _Setting, first: Candidate, asked: Sequence[Question]
) -> tuple[Candidate, dict[str, float]]:
    """One question after the other, each with the answers so far.

    An answer replaces the one before only if its squared error is smaller by more than two standard errors of the
    difference, taken over blocks of `BLOCK` s: outcomes near the separatrix are a lottery that must not decide.

    Returns
    -------
    Candidate
    dict of str to float
        RMS held-out error of each that was tried, in the unit of q; empty if nothing was asked.
    """
    best, known, tried = first, None, {}
    for question in asked:
        offered = [(one, inner_errors(records, setting, one)) for one in question(best)]
        if offered and known is None:
            known = inner_errors(records, setting, first)
            tried[first.label] = _rms(known)
        rows = max(1, round(BLOCK / records[0].interval))
        for one, errors in sorted(offered, key=lambda pair: _rms(pair[1])):
            tried[one.label] = _rms(errors)
            if known is not None and surely_smaller(errors, known, rows):
                best, known = one, errors
    return best, tried


def _rms(values: FloatArray) -> float:
    return float(np.sqrt(np.mean(values**2)))


def _diagnostics(
    records: Sequence[Record], p: JointParameters, fit: HomotopyFit, chosen: Candidate, tried: dict[str, float]
) -> dict[str, object]:
    white, scales = whiteness(fit.residual), p.scales
    visited = coverage(
        scales.middle + scales.half * p.centres, [r.q[r.valid] for r in records], [r.v[r.valid] for r in records]
    )
    return {
        "chosen": chosen.label,
        "candidates": np.array(list(tried) or [chosen.label]),
        "candidate_rms_m": np.array(list(tried.values()) or [0.0]),
        "levels": {name: np.array([getattr(x, name) for x in fit.levels]) for name in vars(fit.levels[0])},
        "training_rms_m": scales.half * float(np.sqrt(np.mean(fit.residual**2))),
        "residual_correlation_samples": white.correlation_time,
        "residual_lag_one": white.lag_one,
        "visits_per_centre": visited.visits,
        "driven_visits_per_centre": visited.driven,
    }


def _coarse(records: Sequence[Record]) -> list[Record]:
    """The records at the coarsest interval that the quick fits can integrate over in one step."""
    frequency = data_scales(records, centred=False).frequency
    return [r.thinned(int(COARSE_STEP / (frequency * r.interval))) for r in records]


def inner_errors(records: Sequence[Record], setting: _Setting, one: Candidate) -> FloatArray:
    """Free-run errors of a candidate over data of the training logs that its fit has not seen, in the unit of q.

    Fitted on the first part of every log and judged on the rest. Then, with several logs, fitted on all but one and
    judged on that one, so that a structure must carry over to another excitation; with one log, fitted on its last
    part and judged on what was before. Samples of a run that is lost count `LOST`.
    """
    early = [r.part(0, int(INNER * len(r.t))) for r in records]
    errors = _held_out(early, records, INNER, setting, one)
    if len(records) == 1:
        split = int((1.0 - INNER) * len(records[0].t))
        split += int(np.argmax(records[0].valid[split:]))
        errors += _held_out([records[0].part(split, len(records[0].t))], [records[0].part(0, split)], 0.0, setting, one)
    for i, record in enumerate(records if len(records) > 1 else ()):
        errors += _held_out([*records[:i], *records[i + 1 :]], [record], 0.0, setting, one)
    return np.concatenate(errors)


def _held_out(
    fitted: Sequence[Record], judged: Sequence[Record], after: float, setting: _Setting, one: Candidate
) -> list[FloatArray]:
    """Errors of a quick fit on some records in the free run over what lies after the share `after` of others."""
    p, start, prior = setting.begin(fitted, one)
    fit = fit_homotopy(
        JointProblem(p, fitted, step=COARSE_STEP), start, prior,
        gains=QUICK_GAINS, caution=one.caution, iterations=4, last_iterations=8,
    )  # fmt: skip
    errors = JointProblem(p, judged, after, step=COARSE_STEP).held_out(fit.theta, GAINS[1])
    return [p.scales.half * np.minimum(np.abs(error), LOST) for error in errors]


def posterior_factor(fit: HomotopyFit, prior: Prior) -> FloatArray:
    """Factor S of the Gauss-Newton posterior covariance S Sᵀ = (JᵀJ/(s² τ) + AᵀA)⁻¹, shape (P, P).

    Residuals of a free run are coloured, so N of them carry less than N samples' information: τ is their integrated
    autocorrelation time in samples.
    """
    tau = whiteness(fit.residual).correlation_time
    noise = max(float(np.mean(fit.residual**2)), 1e-12)
    a = prior.matrix
    precision = fit.hessian / (noise * tau) + a.T @ a
    scale = 1.0 / np.sqrt(np.diag(precision))
    values, vectors = scipy.linalg.eigh(scale[:, None] * precision * scale)
    values = np.maximum(values, len(values) * np.finfo(float).eps * values[-1])
    spread: FloatArray = scale[:, None] * vectors / np.sqrt(values)
    return spread
