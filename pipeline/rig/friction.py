"""Hysteretic friction along one sliding coordinate, in four laws, over one implicit half step.

All laws are written for the displacement Δ since the start of the step, with the state z at the start:

``MAXWELL_SLIP``  each element: ``z ← clip(z + k Δ, ±W)``, force Σ z (Al-Bender et al. 2005,
                  doi:10.1109/TAC.2005.858676)
``DAHL``          ``dz = k(1 − z sgn(dx)/W) dx``, plus Coulomb ``c0 tanh(ẋ/c1)``
``LUGRE``         bristle deflection with the Stribeck curve ``W(1 + c0 exp(−(ẋ/c1)²))``, plus micro-damping c2 ż and
                  viscous c3 ẋ (Canudas de Wit et al. 1995, doi:10.1109/9.376053)
``BOUC_WEN``      ``dz = k(dx − ((1 − c0)|dx| z + c0 dx |z|)/W)``, exponent one, 0 ≤ c0 ≤ ½

where k, W are `slip_stiffness`, `slip_force` and c0… are `friction_shape`. z is a force [N] in all of them. Each is
solved implicitly in z, hence stable for any Δ.
"""

import numpy as np

from pipeline.compiled import compiled
from pipeline.numerics.arrays import FloatArray
from pipeline.rig.parameters import BOUC_WEN, DAHL, LUGRE, MAXWELL_SLIP, JointParameters


@compiled
def slide(z: FloatArray, shift: float, speed: float, dt: float, p: JointParameters, after: FloatArray) -> float:
    """Friction force [N] against the motion after sliding by `shift` [m] at `speed` [m/s] within `dt` [s].

    `z`, shape (elements,), is the state before and `after` the state after [N].
    """
    force = 0.0
    for i in range(z.size):
        k, w = p.slip_stiffness[i], p.slip_force[i]
        if p.friction == MAXWELL_SLIP:
            after[i] = min(max(z[i] + k * shift, -w), w)
        elif p.friction == BOUC_WEN:
            gamma = p.friction_shape[0]
            loss = (1.0 - gamma) * abs(shift) + gamma * shift * np.sign(z[i])
            after[i] = (z[i] + k * shift) / (1.0 + k * loss / w)
        else:
            level = w
            if p.friction == LUGRE:
                level = w * (1.0 + p.friction_shape[0] * np.exp(-((speed / p.friction_shape[1]) ** 2)))
            after[i] = (z[i] + k * shift) / (1.0 + k * abs(shift) / level)
        force += after[i]
        if p.friction == LUGRE:
            force += p.friction_shape[2] * (after[i] - z[i]) / dt
    if p.friction == LUGRE:
        force += p.friction_shape[3] * speed
    if p.friction == DAHL:
        force += p.friction_shape[0] * np.tanh(speed / p.friction_shape[1])
    return force
