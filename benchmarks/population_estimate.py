"""Estimation of the population prior from simulated joints, by empirical Bayes.

A log of 40 s says little of most directions of θ, and joints are alike in many of them. So fits of one structure to
several logs each of simulated joints are taken for draws from a normal distribution (`pipeline.fitting.population`). A
joint and its mirror image are equally probable, so the distribution is symmetric.
"""

from collections.abc import Sequence
from pathlib import Path

import numpy as np

from pipeline.fitting.descent import Prior
from pipeline.fitting.population import Information, NormalPopulation, Shrinkage, estimate_population
from pipeline.models.rbf.parameter_layout import ParameterLayout
from pipeline.models.rbf.prior import blocks_of
from pipeline.numerics.arrays import FloatArray


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


def estimate_symmetric_population(
    joints: Sequence[Information], image: FloatArray, mean: FloatArray, covariance: FloatArray
) -> tuple[FloatArray, FloatArray]:
    """Mean (P,) and covariance (P, P) of the population of joints and of their mirror images.

    Parameters
    ----------
    joints : sequence of Information
        Of N joints.
    image : FloatArray, shape (P, P)
        `pipeline.models.rbf.prior.mirror_image`.
    mean, covariance : FloatArray
        What is believed without them; the covariance counts as that of half a joint.
    """
    both = [*joints, *(Information(image @ one.precision @ image.T, image @ one.vector) for one in joints)]
    believed = NormalPopulation(0.5 * (mean + image @ mean), 0.5 * (covariance + image @ covariance @ image.T))
    found = estimate_population(both, believed, Shrinkage(1.0, 1.0, np.inf))
    return found.mean, found.covariance


def write_population(path: Path, p: ParameterLayout, mean: FloatArray, covariance: FloatArray) -> None:
    """Write the population of joints of a structure as `pipeline.models.rbf.prior` reads it."""
    blocks = blocks_of(p)
    root = np.linalg.cholesky(np.linalg.inv(covariance)).T
    path.parent.mkdir(parents=True, exist_ok=True)
    np.savez_compressed(
        path, blocks=np.array(list(blocks)), lengths=np.array(list(blocks.values())),
        smoothing=np.array(p.structure.smoothing), mean=mean, root=root.astype(np.float32),
    )  # fmt: skip
