"""How white a residual is, how many independent samples it is worth, and whether one is smaller than another."""

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


def surely_smaller(errors: FloatArray, reference: FloatArray, block: int, *, by_sign: bool = False) -> bool:
    """Whether `errors` are smaller than `reference` beyond chance.

    The mean square lies lower by more than two standard errors; or, `by_sign`, it lies lower and so does that of more
    blocks than chance gives at two standard deviations: one block in which both went wrong makes the standard error
    large and says little of the rest.

    The difference is taken sample by sample and its standard error over blocks, because neighbours err together.

    Parameters
    ----------
    errors, reference : FloatArray, shape (N,)
        Errors of two models over the same samples.
    block : int
        Samples that hang together; N below two blocks is never sure.
    by_sign : bool
        Whether the sign test may decide too.
    """
    count = len(errors) // block
    if count < 2:
        return False
    gain = (reference**2 - errors**2)[: count * block].reshape(count, block).mean(axis=1)
    if gain.mean() > 2.0 * gain.std(ddof=1) / np.sqrt(count):
        return True
    return bool(by_sign and gain.mean() > 0.0 and np.count_nonzero(gain > 0.0) > 0.5 * count + np.sqrt(count))
