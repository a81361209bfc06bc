"""The population prior of a bistable joint, from simulated ones: a Gaussian by empirical Bayes.

A log of 40 s says little of most directions of θ, and joints are alike in many of them. So fits of one structure to
several logs each of simulated joints are taken for draws from a normal distribution, whose mean and covariance are
estimated by expectation-maximisation from the information in each joint's logs (`estimate_population`). θ counts in
units of its joint's own scales; a joint and its mirror image are equally probable, so the distribution is symmetric.

What it is worth stands in docs/explanation/identification.md.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from pipeline.identification.descent import Prior
from pipeline.identification.joint_structure import JointStructure, Scales
from pipeline.identification.parameter_layout import ParameterLayout, kind_of
from pipeline.numerics.arrays import FloatArray, IntArray

ROUNDS = 50
"""Steps of expectation-maximisation."""

PSEUDO = 0.5
"""How many joints the distribution counts for with which the estimation starts; it stays in directions of which no log
tells."""


class Information(NamedTuple):
    """What the logs of one joint tell of dimensionless θ to second order, a Gaussian in information form: the precision
    H (P, P), and the vector H θ̂ − g (P,) with the slope g of their misfit at the estimate θ̂.
    """

    precision: FloatArray
    vector: FloatArray


def information_of(
    p: ParameterLayout, theta: FloatArray, hessian: FloatArray, noise: float, prior: Prior
) -> Information:
    """What the logs tell to which θ was fitted.

    Parameters
    ----------
    p : ParameterLayout
        What θ means.
    theta : FloatArray, shape (P,)
        The estimate, where the slope of the misfit is that of the prior turned round.
    hessian : FloatArray, shape (P, P)
        JᵀJ of the residual.
    noise : float
        Its assumed standard deviation.
    prior : Prior
        With which θ was fitted.
    """
    offset, scale = p.dimensionless
    precision = scale[:, None] * hessian * scale / noise**2
    slope = -scale * (prior.matrix.T @ prior.residual(theta))
    return Information(precision, precision @ ((theta - offset) / scale) - slope)


def estimate_population(
    joints: Sequence[Information], image: FloatArray, mean: FloatArray, covariance: FloatArray
) -> tuple[FloatArray, FloatArray]:
    """Mean (P,) and covariance (P, P) of the population of joints of which these logs tell.

    Expectation-maximisation of a random-effects model (Dempster, Laird and Rubin 1977,
    doi:10.1111/j.2517-6161.1977.tb01600.x; Laird and Ware 1982, doi:10.2307/2529876): what each joint is, given the
    present distribution, then the distribution, given what they are; each joint and its mirror image. Cost: 4 N P³
    flops a round.

    Parameters
    ----------
    joints : sequence of Information
        Of N joints.
    image : FloatArray, shape (P, P)
        `mirror.mirror_image`.
    mean, covariance : FloatArray
        Where the estimation starts; the covariance counts as that of `PSEUDO` joints.
    """
    both = [*joints, *(Information(image @ one.precision @ image.T, image @ one.vector) for one in joints)]
    mean = 0.5 * (mean + image @ mean)
    first = PSEUDO * (covariance + image @ covariance @ image.T)
    covariance = first / (2.0 * PSEUDO)
    for _ in range(ROUNDS):
        precision, spread, means = np.linalg.inv(covariance), first, []
        for one in both:
            own = np.linalg.inv(one.precision + precision)
            means.append(own @ (one.vector + precision @ mean))
            spread = spread + own
        mean = np.mean(means, axis=0)
        apart = np.array(means) - mean
        covariance = (spread + apart.T @ apart) / (len(both) + 2.0 * PSEUDO)
        covariance = 0.5 * (covariance + covariance.T)
    return mean, covariance


@dataclass(frozen=True)
class Population:
    """A normal distribution of dimensionless θ.

    Attributes
    ----------
    blocks : dict of str to int
        Names and lengths of the blocks of θ, in order.
    smoothing : float
        σ_n of its curves.
    mean : FloatArray, shape (P,)
    root : FloatArray, shape (P, P)
        A of the precision AᵀA.
    """

    blocks: dict[str, int]
    smoothing: float
    mean: FloatArray
    root: FloatArray

    def knows(self, structure: JointStructure) -> bool:
        """Whether it is one of this structure, whose two inputs pull opposite ways by their squares."""
        p = ParameterLayout(structure, Scales(0.0, 1.0, 1.0, 1.0), "squared", (1, -1))
        return blocks_of(p) == self.blocks and structure.smoothing == self.smoothing and not structure.overdamped

    def prior(self, p: ParameterLayout) -> Prior:
        """The prior of a joint of a structure that it knows, whose mirror plane is q = 0."""
        offset, scale = p.dimensionless
        matrix = self.root / scale
        right = self.root @ self.mean + matrix @ offset
        order = np.arange(p.count) if p.signs == (1, -1) else _exchanged(p)
        return Prior(matrix[:, order], right)


def blocks_of(p: ParameterLayout) -> dict[str, int]:
    """Names and lengths of the blocks of θ, in order."""
    return {name: where.stop - where.start for name, where in p.slices.items()}


def _exchanged(p: ParameterLayout) -> IntArray:
    """Where each parameter stands in θ of a joint whose inputs have the numbers of each other, shape (P,)."""
    order, at = np.arange(p.count), p.slices
    for name in at:
        if kind_of(name) in ("pull", "input"):
            order[at[name]] = np.arange(p.count)[at[f"{name[:-1]}{1 - int(name[-1])}"]]
    order[at["input_offset"]] = order[at["input_offset"]][::-1]
    return order
