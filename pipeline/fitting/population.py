"""A population of devices, each known from its logs: mean and covariance by empirical Bayes, and odd members.

A log determines some directions of θ well and others hardly. So each member enters as a Gaussian in information form,
and members are draws from a normal distribution whose mean and covariance expectation-maximisation estimates (Dempster,
Laird and Rubin 1977, doi:10.1111/j.2517-6161.1977.tb01600.x; Laird and Ware 1982, doi:10.2307/2529876).

Few members determine no covariance. The spread of each entry counts as that of `Shrinkage.spreads` more members with
the prior's spread, and correlations as those of `Shrinkage.correlations` more members with the prior's correlations. In
directions that no log shows the prior stays. Distances from the mean are cut at `Shrinkage.cut` spreads (winsorised),
so a few odd members neither move the mean far nor widen the spread much.
"""

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from ..numerics.arrays import FloatArray

ROUNDS = 50
MORE_ROUNDS = 15
"""Steps of expectation-maximisation from the prior, and from the estimate with one member more."""

FALSE_ALARMS = 1.0 / 40.0
"""Bound of the share of usual members that are called odd."""


class Information(NamedTuple):
    """Information of one member's logs on θ to second order: precision Λ (P, P), and Λ times the best θ (P,)."""

    precision: FloatArray
    vector: FloatArray


@dataclass(frozen=True)
class NormalPopulation:
    """A normal distribution of θ.

    Attributes
    ----------
    mean : FloatArray, shape (P,)
    covariance : FloatArray, shape (P, P)
        Of one more member about `mean`, with the scatter of an estimated mean.
    """

    mean: FloatArray
    covariance: FloatArray


@dataclass(frozen=True)
class Shrinkage:
    """Weight of the prior in members, and the spreads at which distances are cut.

    The logs of twelve simulated joints were exp(37) times as probable (mean of the exponent) under the other joints as
    under the prior. With 1 and 20 members it is exp(31), with 0.1 and 60 exp(40), but five members would then be too
    sure.
    """

    spreads: float = 0.3
    correlations: float = 60.0
    cut: float = 2.0


@dataclass(frozen=True)
class Oddity:
    """Largest deviation of one member from the others, if one entry of θ alone is odd.

    Attributes
    ----------
    entry : int
        Of θ.
    size, error : float
        Deviation of that entry from its expectation under the others, and the standard error.
    odd : bool
        True if that is farther than chance explains, with the bound `FALSE_ALARMS` for a usual member.
    """

    entry: int
    size: float
    error: float
    odd: bool


def estimate_population(
    members: Sequence[Information],
    prior: NormalPopulation,
    shrinkage: Shrinkage = Shrinkage(),
    *,
    start: NormalPopulation | None = None,
    rounds: int = ROUNDS,
) -> NormalPopulation:
    """The population behind some members.

    Parameters
    ----------
    members : sequence of Information
        Of N members.
    prior : NormalPopulation
        What is believed without them; its covariance counts as `Shrinkage` has it, its mean as one member's.
    shrinkage : Shrinkage
        Weight of the prior.
    start : NormalPopulation, optional
        Start of the estimation: the prior if left out.
    rounds : int
        Steps. Cost: 4 N P³ flops each.
    """
    believed = np.linalg.inv(prior.covariance)
    count = len(members)
    precisions = np.array([member.precision for member in members])
    vectors = np.array([member.vector for member in members])
    mean = (start or prior).mean
    covariance = (start or prior).covariance
    lost = _variance_within(shrinkage.cut)
    for _ in range(rounds):
        inverse = np.linalg.inv(covariance)
        spread = np.sqrt(np.diag(covariance))
        own = np.linalg.inv(precisions + inverse)
        best = np.einsum("nij,nj->ni", own, vectors + inverse @ mean)
        middle = mean + np.clip(best - mean, -shrinkage.cut * spread, shrinkage.cut * spread).mean(axis=0)
        mean = np.linalg.solve(count * inverse + believed, count * (inverse @ middle) + believed @ prior.mean)
        apart = np.clip(best - mean, -shrinkage.cut * spread, shrinkage.cut * spread)
        seen = (own.sum(axis=0) + apart.T @ apart / lost) / count
        covariance = _shrunk(seen, prior.covariance, count, shrinkage)
    inverse = np.linalg.inv(covariance)
    shown = count * inverse - inverse @ np.linalg.inv(precisions + inverse).sum(axis=0) @ inverse
    moved = np.linalg.inv(shown + believed)  # the mean's scatter, none where no member shows anything
    return NormalPopulation(mean, _symmetric(covariance + moved @ shown @ moved))


def _shrunk(seen: FloatArray, believed: FloatArray, count: int, by: Shrinkage) -> FloatArray:
    """The covariance of `count` members with the members for which the prior counts."""
    variances = (by.spreads * np.diag(believed) + count * np.diag(seen)) / (by.spreads + count)
    scale = np.sqrt(variances / np.diag(believed))
    mixed = (by.correlations * scale[:, None] * believed * scale + count * seen) / (by.correlations + count)
    to = np.sqrt(variances / np.diag(mixed))
    return _symmetric(to[:, None] * mixed * to)


def _symmetric(matrix: FloatArray) -> FloatArray:
    return np.asarray(0.5 * (matrix + matrix.T))


def _variance_within(cut: float) -> float:
    """Variance of a standard normal number that is cut at ± `cut`."""
    if not np.isfinite(cut):
        return 1.0
    inside = math.erf(cut / math.sqrt(2.0))
    density = np.exp(-0.5 * cut**2) / np.sqrt(2.0 * np.pi)
    return float(inside - 2.0 * cut * density + cut**2 * (1.0 - inside))


def without_each(
    members: Sequence[Information], prior: NormalPopulation, whole: NormalPopulation
) -> Iterator[NormalPopulation]:
    """Population of all the others for each member; `whole` is that of all. Cost: `MORE_ROUNDS` steps for each.

    Parameters
    ----------
    members : sequence of Information
        Of N members.
    prior : NormalPopulation
        Prior without them.
    whole : NormalPopulation
        The population of all: where the estimation starts.
    """
    for i in range(len(members)):
        yield estimate_population([*members[:i], *members[i + 1 :]], prior, start=whole, rounds=MORE_ROUNDS)


def log_evidence(member: Information, population: NormalPopulation) -> float:
    """Logarithm of the probability of a member's logs, but for a constant of the logs."""
    inverse = np.linalg.inv(population.covariance)
    right = member.vector + inverse @ population.mean
    whole = member.precision + inverse
    quadratic = right @ np.linalg.solve(whole, right) - population.mean @ inverse @ population.mean
    return 0.5 * float(quadratic + np.linalg.slogdet(inverse)[1] - np.linalg.slogdet(whole)[1])


def oddity(member: Information, others: NormalPopulation, count: int, entries: Sequence[int]) -> Oddity:
    """Oddest of these `entries` of θ in one member beside `count` others.

    It is judged by the score of one entry of θ, moved alone, over its standard deviation. Student's t with count − 1
    degrees of freedom bounds that ratio for all these entries together (Bonferroni). Λ and h are the information of the
    member, N(μ, P⁻¹) is the population. The score is u = P (Λ + P)⁻¹ (h − Λ μ), its covariance
    G = P − P (Λ + P)⁻¹ P.

    Parameters
    ----------
    member : Information
        Information of its logs.
    others : NormalPopulation
        The population of the others.
    count : int
        Number of the others.
    entries : sequence of int
        Places in θ that may be odd.
    """
    from scipy.special import stdtrit

    inverse = np.linalg.inv(others.covariance)
    turned = np.linalg.solve(member.precision + inverse, inverse).T  # P (Λ + P)⁻¹
    score = turned @ (member.vector - member.precision @ others.mean)
    shown = np.maximum(np.diag(inverse - turned @ inverse), np.finfo(float).tiny)
    farthest = max(entries, key=lambda entry: abs(score[entry]) / np.sqrt(shown[entry]))
    bound = float(stdtrit(max(count - 1, 1), 1.0 - 0.5 * FALSE_ALARMS / len(entries)))
    size = score[farthest] / shown[farthest]
    error = 1.0 / np.sqrt(shown[farthest])
    return Oddity(farthest, float(size), float(error), bool(abs(size) > bound * error))
