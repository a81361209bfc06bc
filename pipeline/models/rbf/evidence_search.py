"""Structure and prior of a bistable joint by their marginal likelihood, while an observer holds it near its logs.

Held-out free runs of a bistable joint are decided by a few passages between its wells. Coupled to the measurement as
much as the first level of a fit is, no passage decides: the errors are small, nearly linear in the parameters, and
nearly white. There the marginal likelihood p(log | structure) = ∫ p(log | θ) p(θ) dθ has a Gaussian integrand (Laplace;
MacKay 1992, doi:10.1162/neco.1992.4.3.415). It charges every element for the room that its prior leaves it, so that an
element which the log does not show is left out.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ...fitting.homotopy import GAINS, LEVEL_TOLERANCE, Callbacks, HomotopyFit, Schedule, fit_homotopy
from ...fitting.posterior import log_evidence
from ...numerics.metrics import rms
from ...signals.log import Log
from .candidates import Candidate, Offer
from .problem import JointProblem
from .structure_search import Begun, Setting, excerpts

ODDS = 20.0
"""Odds that the logs must give a candidate against the one before it: an element is shown at the level of 5 %."""

LAST_ITERATIONS = 300
"""Steps at the last level of a fit; most converge within 60."""


@dataclass(frozen=True)
class Trial:
    """A candidate fitted to logs that hold it.

    Attributes
    ----------
    option : Candidate
    begun : Begun
        Parameterisation, fitted θ, and prior.
    fit : HomotopyFit
    evidence : float
        Logarithm of the marginal likelihood; −∞ if no simulation follows the logs.
    """

    option: Candidate
    begun: Begun
    fit: HomotopyFit
    evidence: float

    @property
    def rms(self) -> float:
        """Of its errors, in the unit of q."""
        return self.begun[0].scales.half * rms(self.fit.residual) if self.fit.levels else float("inf")


def search_by_evidence(
    records: Sequence[Log], setting: Setting, first: Candidate, offers: Sequence[Offer]
) -> tuple[Trial, dict[str, Trial]]:
    """The best candidate, and all that were tried by their labels.

    One offer after the other is made to the best candidate so far. A candidate replaces it where the logs give odds of
    more than `ODDS` for it.

    Parameters
    ----------
    records : sequence of Log
        Training logs.
    setting : Setting
        Settings that all candidates share; nothing more is offered once its effort is spent.
    first : Candidate
        The simplest one.
    offers : sequence of Offer
        Elements and priors.
    """
    logs = excerpts(records)
    best = _trial(logs, setting, first, None)
    tried = {first.label: best}
    for offer in offers:
        for option in offer(best.option):
            if option.label in tried:
                continue
            if setting.effort.exhausted():
                break
            tried[option.label] = _trial(logs, setting, option, best)
        best = max(
            [best, *(trial for trial in tried.values() if trial.evidence > best.evidence + np.log(ODDS))],
            key=lambda trial: trial.evidence,
        )
    return best, tried


def _trial(records: Sequence[Log], setting: Setting, option: Candidate, near: Trial | None) -> Trial:
    """A candidate fitted at the first observer gain, from the fit of another prior where that has its structure."""
    p, start, prior = setting.begin(records, option)
    if near is not None and near.begun[0] == p:
        start = near.begun[1]
    schedule = Schedule(
        GAINS[:1], last_iterations=LAST_ITERATIONS, tolerance=LEVEL_TOLERANCE, noise_inflation=option.noise_inflation
    )
    fit = fit_homotopy(
        JointProblem(p, records, effort=setting.effort),
        start,
        prior,
        schedule,
        callbacks=Callbacks(on_progress=setting.progress(option.label, p.scales.half)),
    )
    evidence = log_evidence(fit, prior, Candidate.noise_inflation**2) if fit.levels else -np.inf
    return Trial(option, (p, fit.theta, prior), fit, evidence)
