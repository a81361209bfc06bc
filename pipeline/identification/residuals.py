"""How white a residual is, how many independent samples it is worth, and whether one is smaller than another."""

from dataclasses import dataclass

import numpy as np
from scipy.special import stdtrit

from pipeline.numerics.arrays import FloatArray

SIGNIFICANCE = 0.16
"""Share of equal models that are told apart: one standard error, one-sided."""


@dataclass(frozen=True)
class Whiteness:
    """Autocorrelation of a residual.

    Attributes
    ----------
    integrated_correlation_time : float
        Integrated autocorrelation time τ [samples]: N samples carry the information of N/τ independent ones.
    lag_one : float
        Correlation of neighbours; 0 for white noise.
    """

    integrated_correlation_time: float
    lag_one: float


def whiteness(residual: FloatArray) -> Whiteness:
    """Autocorrelation time by Geyer's initial positive sequence (1992, doi:10.1214/ss/1177011137).

    Parameters
    ----------
    residual : FloatArray, shape (N,)
        Residual in the order of time; N ≥ 2. Cost: two FFTs of length 2 N.
    """
    centred = residual - residual.mean()
    n = len(centred)
    correlation = np.fft.irfft(np.abs(np.fft.rfft(centred, 2 * n)) ** 2)[:n]
    correlation = correlation / max(float(correlation[0]), np.finfo(float).tiny)
    pairs = correlation[: n - n % 2].reshape(-1, 2).sum(axis=1)
    stop = int(np.argmax(pairs <= 0.0)) if np.any(pairs <= 0.0) else len(pairs)
    return Whiteness(max(1.0, 2.0 * float(pairs[:stop].sum()) - 1.0), float(correlation[1]))


def surely_smaller(errors: FloatArray, reference: FloatArray) -> bool:
    """Whether the mean square of `errors` is smaller than that of `reference` by more than a standard error.

    The test of Diebold and Mariano (1995, doi:10.1080/07350015.1995.10524599): the mean difference of the squares over
    its standard error, in which N samples count as N/τ for their autocorrelation time τ, as neighbours err together,
    against Student's t with N/τ − 1 degrees of freedom, as that may be few (Harvey, Leybourne and Newbold 1997,
    doi:10.1016/S0169-2070(96)00719-4).

    Parameters
    ----------
    errors, reference : FloatArray, shape (N,)
        Errors of two models over the same samples, in the order of time. Cost: two FFTs of length 2 N.
    """
    gain = reference**2 - errors**2
    count = len(gain) / whiteness(gain).integrated_correlation_time
    if count < 2.0:
        return False
    return bool(gain.mean() > stdtrit(count - 1.0, 1.0 - SIGNIFICANCE) * gain.std() / np.sqrt(count))
