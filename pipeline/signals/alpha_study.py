"""The study of the regularisation parameter (fig. 11c): what over- and under-smoothing do to a record."""

from dataclasses import dataclass

import numpy as np

from pipeline.numerics.arrays import FloatArray
from pipeline.numerics.tvregdiff import Order
from pipeline.signals.differentiate import differentiate
from pipeline.signals.smoothing_parameter import SmoothingParameter, smoothing_parameter


@dataclass(frozen=True)
class AlphaStudy:
    """One differentiation of a record for each of K regularisation parameters.

    Attributes
    ----------
    alphas : FloatArray, shape (K,)
        Regularisation parameters [signal·s^order].
    misfit : FloatArray, shape (K,)
        RMS of record less regularised signal [signal]: at the noise's standard deviation or below, the parameter
        smooths noise only; above it, the signal too.
    roughness : FloatArray, shape (K,)
        Mean modulus of the change of the acceleration from sample to sample [signal/s²]: large where noise is
        left.
    qdot, qddot : FloatArray, shape (K, N)
        Velocity and acceleration [signal/s, signal/s²].
    automatic : SmoothingParameter
        What would be chosen for the record without reweighting, with its estimate of the noise.
    """

    alphas: FloatArray
    misfit: FloatArray
    roughness: FloatArray
    qdot: FloatArray
    qddot: FloatArray
    automatic: SmoothingParameter


def alpha_study(
    samples: FloatArray, dt: float, alphas: FloatArray, *, order: Order = 1, epsilon: float | None = None
) -> AlphaStudy:
    """Differentiate a record with each of several regularisation parameters.

    Parameters
    ----------
    samples : FloatArray, shape (N,)
        Gap-free, uniformly sampled record [signal], not constant, N > order + 2.
    dt : float
        Sampling interval [s].
    alphas : FloatArray, shape (K,)
        Regularisation parameters [signal·s^order]; the paper compares 0.0001 to 1 for millimetres.
    order : {1, 2, 3, 4}, default 1
        Derivative whose variation is penalised; 1 is the paper's.
    epsilon : float, optional
        Rounding of the modulus [(signal/s^order)²], the automatic one by default.

    Returns
    -------
    AlphaStudy

    Raises
    ------
    InputError
        As `differentiate`.
    """
    automatic = smoothing_parameter(samples, dt, order)
    rounding = automatic.epsilon if epsilon is None else epsilon
    runs = [differentiate(samples, dt, order=order, alpha=float(alpha), epsilon=rounding) for alpha in alphas]
    return AlphaStudy(
        alphas=np.asarray(alphas, dtype=np.float64),
        misfit=np.array([np.sqrt(np.mean((run.q_smooth - samples) ** 2)) for run in runs]),
        roughness=np.array([np.mean(np.abs(np.diff(run.qddot))) for run in runs]),
        qdot=np.array([run.qdot for run in runs]),
        qddot=np.array([run.qddot for run in runs]),
        automatic=automatic,
    )
