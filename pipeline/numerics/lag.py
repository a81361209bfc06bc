"""First-order lags, solved exactly between samples."""

import numpy as np

from pipeline.compiled import compiled
from pipeline.numerics.arrays import FloatArray


@compiled
def first_order_lag(
    x: FloatArray, interval: float, time_constant: float, start: float | None = None, held: bool = False
) -> tuple[FloatArray, FloatArray]:
    """Solve ż = (x − z)/T (eq. 37) and its sensitivity ∂z/∂ln T, from rest: z(0) = x(0).

    `x` is linear between samples, so with a = e^(−h/T), r = T(1 − a)/h the exact step is
    z⁺ = a z + (r − a) x + (1 − r) x⁺; no time step error, and T may be far below the interval.

    Parameters
    ----------
    x : FloatArray, shape (N,)
        The input at the samples.
    interval : float
        Sample interval h [s].
    time_constant : float
        T [s], positive.
    start : float, optional
        z(0), where it is not x(0).
    held : bool
        Whether x keeps its value from sample to sample instead; then z⁺ = a z + (1 − a) x.

    Returns
    -------
    z, dz_dlogT : FloatArray, shape (N,)
        Cost: 10 flops per sample, a recurrence, about 5 ns per sample.
    """
    z = np.empty(len(x))
    sensitivity = np.empty(len(x))
    ratio = interval / time_constant
    a = np.exp(-ratio)
    r = -np.expm1(-ratio) / ratio
    da = a * ratio  # d/d ln T of a
    dr = r - a  # d/d ln T of r
    z[0], sensitivity[0] = x[0] if start is None else start, 0.0
    for n in range(1, len(x)):
        if held:
            z[n] = a * z[n - 1] + (1.0 - a) * x[n - 1]
            sensitivity[n] = a * sensitivity[n - 1] + da * (z[n - 1] - x[n - 1])
            continue
        z[n] = a * z[n - 1] + (r - a) * x[n - 1] + (1.0 - r) * x[n]
        sensitivity[n] = a * sensitivity[n - 1] + da * z[n - 1] + (dr - da) * x[n - 1] - dr * x[n]
    return z, sensitivity
