"""How white a residual is, and how many independent samples it is worth."""

from dataclasses import dataclass

import numpy as np

from pipeline.numerics.arrays import FloatArray


@dataclass(frozen=True)
class Whiteness:
    """Autocorrelation of a residual.

    Attributes
    ----------
    correlation_time : float
        Integrated autocorrelation time τ [samples]: N samples carry the information of N/τ independent ones.
    lag_one : float
        Correlation of neighbours; 0 for white noise.
    """

    correlation_time: float
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
