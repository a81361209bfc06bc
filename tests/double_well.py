"""The smallest truth that behaves like the joint: one degree of freedom, two wells, known curves, one lag state.

It is of the hybrid model's own form (§4, eqs. 28–33), so that what an identification recovers can be compared
with what was planted; it is not a model of the device. For that see :mod:`pipeline.rig.joint`.
"""

from dataclasses import dataclass

import numpy as np

from pipeline.numerics.arrays import FloatArray
from pipeline.numerics.compiled import compiled


@dataclass(frozen=True)
class DoubleWell:
    """``m q̈ = −c(q) q − d(q) z + g1(q) v1² + g2(q) v2²`` with ``ż = (q̇ − z)/T_z``.

    The curves are ``c = k (q/q_r − 1)(1 + q/q_l)/(1 + (q/q_s)²)``, ``d = d0 + d2 q²`` and
    ``g_i = ±g exp(−(q ∓ s)²/(2w²))``, each side with its own strength.

    Attributes
    ----------
    mass : float
        [kg].
    stiffness : float
        k [N/m]; each well has about twice this stiffness.
    right_well, left_well, softening : float
        Distances q_r, q_l of the wells and the softening length q_s [m].
    damping, damping_growth : float
        d0 [N s/m] and d2 [N s/m³].
    left_force, right_force : float
        g of the left and right membrane [N/V²].
    force_offset, force_width : float
        s and w of the coupling curves [m].
    lag : float
        T_z [s].
    """

    mass: float = 0.041
    stiffness: float = 7.4
    right_well: float = 11.6e-3
    left_well: float = 11.0e-3
    softening: float = 40e-3
    damping: float = 0.12
    damping_growth: float = 150.0
    left_force: float = 8.6e-9
    right_force: float = 8.1e-9
    force_offset: float = 6e-3
    force_width: float = 30e-3
    lag: float = 0.03

    def curves(self, q: FloatArray) -> dict[str, FloatArray]:
        """The planted curves at `q` [m]: c [N/m], d [N s/m], g1 and g2 [N/V²], each shaped like `q`."""
        c = self.stiffness * (q / self.right_well - 1) * (1 + q / self.left_well) / (1 + (q / self.softening) ** 2)
        g1 = self.left_force * np.exp(-((q + self.force_offset) ** 2) / (2 * self.force_width**2))
        g2 = -self.right_force * np.exp(-((q - self.force_offset) ** 2) / (2 * self.force_width**2))
        return {"c": c, "d": self.damping + self.damping_growth * q**2, "g1": g1, "g2": g2}

    def simulate(self, v: FloatArray, dt: float, *, stride: int = 10) -> FloatArray:
        """Displacement [m] from rest in the left well under voltages `v` [V], shape (N, 2), every `dt` seconds.

        Classical Runge–Kutta on every `stride`-th sample with the voltages of the samples themselves (`stride`
        even, so that the middle of a step is a sample), cubic Hermite in between.

        Cost: N/stride steps of about 0.5 µs, and O(N) for the interpolation.
        """
        grid = np.linspace(-60e-3, 60e-3, 2401)  # 50 µm: the tables' linear interpolation errs by < 1e-5 of c
        c, d, g1, g2 = self.curves(grid).values()
        # −c q, −d, g1, g2 per unit mass
        table = np.stack([-c * grid, -d, g1, g2], axis=1) / self.mass
        return _integrate(table, grid[0], grid[1] - grid[0], self.lag, -self.left_well, v**2, dt, stride)


@compiled
def _acceleration(table: FloatArray, low: float, step: float, q: float, z: float, e1: float, e2: float) -> float:
    place = (q - low) / step
    i = min(max(int(place), 0), table.shape[0] - 2)
    f = place - i
    value = 0.0
    for column, factor in enumerate((1.0, z, e1, e2)):
        value += ((1 - f) * table[i, column] + f * table[i + 1, column]) * factor
    return value


@compiled
def _integrate(
    table: FloatArray, low: float, cell: float, lag: float, q0: float, e: FloatArray, dt: float, stride: int
) -> FloatArray:
    n = e.shape[0]
    out = np.empty(n)
    h, half = stride * dt, stride // 2
    q, p, z = q0, 0.0, 0.0
    for start in range(0, n, stride):
        k = np.zeros((5, 3))
        for stage in range(4):
            c = (0.0, 0.5, 0.5, 1.0)[stage]
            j = min(start + int(2 * c) * half, n - 1)
            qs, ps, zs = q + c * h * k[stage, 0], p + c * h * k[stage, 1], z + c * h * k[stage, 2]
            k[stage + 1, 0] = ps
            k[stage + 1, 1] = _acceleration(table, low, cell, qs, zs, e[j, 0], e[j, 1])
            k[stage + 1, 2] = (ps - zs) / lag
        dq, dp, dz = (k[1] + 2 * k[2] + 2 * k[3] + k[4]) * (h / 6)
        for j in range(start, min(start + stride, n)):
            s = (j - start) / stride
            rise = s * s * (3 - 2 * s)
            out[j] = q + rise * dq + s * (1 - s) * h * ((1 - s) * p - s * (p + dp))
        q, p, z = q + dq, p + dp, z + dz
    return out
