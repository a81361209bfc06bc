"""A high-voltage converter that charges one DE membrane: lag, rate limit, power limit."""

from dataclasses import dataclass

import numpy as np

from pipeline.compiled import compiled
from pipeline.numerics.arrays import FloatArray

_POWER_FLOOR = 100.0  # V: below this the current limit, not the power limit, holds


@dataclass(frozen=True)
class Converter:
    """Parameters of one converter and its load.

    Attributes
    ----------
    lag : float
        Time constant of the voltage control [s].
    rate_limit : float
        Largest slope up or down, set by the output current [V/s].
    power_limit : float
        Largest power into the load while charging [W].
    capacitance : float
        Of membrane and cable [F].
    """

    lag: float = 2.5e-3
    rate_limit: float = 1.25e6
    power_limit: float = 8.0
    capacitance: float = 7.0e-9

    def drive(self, u: FloatArray, dt: float) -> FloatArray:
        """Output voltage [V] for a sampled command `u` [V], shape (N,), starting discharged.

        ``v̇ = clip((u − v)/lag, ±rate)`` with ``rate = min(rate_limit, power_limit/(C v))`` while charging. The
        linear part is integrated exactly for a command held over each sample.

        Cost: O(N), about 5 ns a sample.
        """
        return _drive(u, dt, self.lag, self.rate_limit, self.power_limit / self.capacitance)


@compiled
def _drive(u: FloatArray, dt: float, lag: float, rate: float, power: float) -> FloatArray:
    v = np.empty_like(u)
    decay = -np.expm1(-dt / lag)
    x = 0.0
    for i in range(u.size):
        v[i] = x
        step = (u[i] - x) * decay
        up = min(rate, power / max(x, _POWER_FLOOR)) * dt
        x += min(max(step, -rate * dt), up)
    return v
