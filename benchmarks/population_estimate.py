"""Estimation of the population prior from simulated joints, by empirical Bayes.

A log of 40 s says little of most directions of θ, and joints are alike in many of them. So fits of one structure to
several logs each of simulated joints are taken for draws from a normal distribution, whose mean and covariance are
estimated by expectation-maximisation from the information in each joint's logs (`estimate_population`). A joint and its
mirror image are equally probable, so the distribution is symmetric.
"""

from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

import numpy as np

from pipeline.fitting.descent import Prior
from pipeline.models.rbf.parameter_layout import ParameterLayout
from pipeline.models.rbf.prior import blocks_of
from pipeline.numerics.arrays import FloatArray

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


def write_population(path: Path, p: ParameterLayout, mean: FloatArray, covariance: FloatArray) -> None:
    """Write the population of joints of a structure as `pipeline.models.rbf.prior` reads it."""
    blocks = blocks_of(p)
    root = np.linalg.cholesky(np.linalg.inv(covariance)).T
    path.parent.mkdir(parents=True, exist_ok=True)
    np.savez_compressed(
        path, blocks=np.array(list(blocks)), lengths=np.array(list(blocks.values())),
        smoothing=np.array(p.structure.smoothing), mean=mean, root=root.astype(np.float32),
    )  # fmt: skip
