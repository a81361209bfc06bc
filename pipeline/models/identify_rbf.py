"""Identification of the data-driven joint: convex start, observer homotopy, choice by inner validation."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
import scipy.linalg

from pipeline.errors import DataRefusedError
from pipeline.models.rbf import RbfModel
from pipeline.numerics.arrays import FloatArray
from pipeline.numerics.identification.coverage import coverage
from pipeline.numerics.identification.homotopy import GAINS, HomotopyFit, Prior, fit_homotopy
from pipeline.numerics.identification.joint_parameters import JointParameters, JointStructure
from pipeline.numerics.identification.joint_problem import JointProblem
from pipeline.numerics.identification.joint_start import joint_prior, starting_joint
from pipeline.numerics.identification.record import Record
from pipeline.numerics.identification.regressor import InputLaw
from pipeline.numerics.identification.residuals import whiteness

INNER = 0.65
"""Share of each training log that the candidates are fitted on; they are judged by a free run over the rest."""

LOST = 1.0
"""Dimensionless error at which a diverged sample counts: half the operating range."""


@dataclass(frozen=True)
class Candidate:
    """A structure with its prior: caution on the noise level, left/right symmetry (None for none)."""

    label: str
    structure: JointStructure
    caution: float = 3.0
    symmetry: float | None = None


def default_candidates(inputs: int, *, arc: bool = True) -> tuple[Candidate, ...]:
    """What is tried for a device with `inputs` inputs; `arc` for two inputs whose tip moves on an arc.

    Two inputs are taken for the two sides of a joint, whose mirror symmetry is worth a prior; the inner validation
    decides whether it is.
    """
    if inputs == 1:
        plain = JointStructure(basis_functions=8, rates=(), shape_elements=0, arc=False)
        lagged = replace(plain, input_lag=True)
        return Candidate("plain", plain), Candidate("lagged input", lagged)
    structure = JointStructure(arc=arc)
    return Candidate("free", structure), Candidate("mirror-symmetric prior", structure, symmetry=0.1)


def identify_rbf(
    records: Sequence[Record],
    *,
    mass: float = 1.0,
    inputs: InputLaw = "squared",
    candidates: Sequence[Candidate] | None = None,
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
    candidates : sequence of Candidate, optional
        Structures among which the inner validation chooses; a single one is taken without.

    Raises
    ------
    InputError
        No data, a constant displacement, inputs that are always zero.
    DataRefusedError
        No candidate follows the training logs.
    """
    offered = tuple(candidates) if candidates is not None else default_candidates(records[0].v.shape[1])
    scores = [_inner_score(records, inputs, c) for c in offered] if len(offered) > 1 else [0.0]
    chosen = offered[int(np.argmin(scores))]
    parameters, prior, fit = _fit(records, inputs, chosen, None)
    if not fit.levels:
        raise DataRefusedError("no simulation follows the training logs even when tied to them; check q and units")
    white, scales = whiteness(fit.residual), parameters.scales
    centres = scales.middle + scales.half * parameters.centres
    visited = coverage(centres, [r.q[r.valid] for r in records], [r.v[r.valid] for r in records])
    diagnostics = {
        "chosen": chosen.label,
        "candidates": np.array([c.label for c in offered]),
        "candidate_rms_m": np.array(scores),
        "levels": {name: np.array([getattr(x, name) for x in fit.levels]) for name in vars(fit.levels[0])},
        "training_rms_m": parameters.scales.half * float(np.sqrt(np.mean(fit.residual**2))),
        "residual_correlation_samples": white.correlation_time,
        "residual_lag_one": white.lag_one,
        "visits_per_centre": visited.visits,
        "driven_visits_per_centre": visited.driven,
    }
    return RbfModel(parameters, fit.theta, posterior_factor(fit, prior), mass, diagnostics)


def _fit(
    records: Sequence[Record], inputs: InputLaw, candidate: Candidate, share: float | None
) -> tuple[JointParameters, Prior, HomotopyFit]:
    fitted = records if share is None else [r.part(0, int(share * len(r.t))) for r in records]
    parameters, start = starting_joint(fitted, candidate.structure, inputs, centred=candidate.symmetry is not None)
    prior = joint_prior(parameters, start, candidate.symmetry)
    problem = JointProblem(parameters, fitted)
    quick = share is not None
    return (
        parameters,
        prior,
        fit_homotopy(
            problem,
            start,
            prior,
            caution=candidate.caution,
            iterations=4 if quick else 8,
            last_iterations=8 if quick else 25,
        ),
    )


def _inner_score(records: Sequence[Record], inputs: InputLaw, candidate: Candidate) -> float:
    """RMS free-run error over the held-out ends of the training logs, diverged samples counted as lost."""
    parameters, _, fit = _fit(records, inputs, candidate, INNER)
    if not fit.levels:
        return float("inf")
    errors = np.concatenate(JointProblem(parameters, records, INNER).held_out(fit.theta, GAINS[1]))
    return float(np.sqrt(np.mean(np.minimum(np.abs(errors), LOST) ** 2)) * parameters.scales.half)


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
