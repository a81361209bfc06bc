"""The clamped beam that carries the frame: pose of its tip, inertia, elasticity and loss, in two theories.

``RITZ``: ``w = l Σ a_j ξ^j``, j = 2…4, ξ = x/l, and axial displacement ``u0 = l a_5`` (eqs. 2, 8, 9, 13, with the
½ on the bending energy that makes the beam buckle and ``(∂w/∂x)²`` in eq. 2). Coordinates a_2, a_3, a_4, a_5.

``CHAIN``: n rigid links at angles θ_i to the vertical, rotational springs between them, masses lumped at the
ends; ``½ Σ k_i Δ_i²(1 + c Δ_i²/2)`` with ``Δ_i = θ_i − θ_{i−1} − κ0 l/n``. As n grows this is the geometrically
exact inextensible elastica. The frame sits rigidly on the last link.

The functions fill arrays that the caller owns, so that a time step allocates nothing. Cost: O(n²) of inertia.
"""

import numpy as np

from pipeline.compiled import compiled
from pipeline.numerics.arrays import FloatArray
from pipeline.rig.parameters import RITZ, JointParameters

# Six Gauss points on [0, 1]: exact for the bending energy, a polynomial of degree ten.
_NODES = 0.5 * (np.polynomial.legendre.leggauss(6)[0] + 1.0)
_WEIGHTS = 0.5 * np.polynomial.legendre.leggauss(6)[1]


@compiled
def tip(x: FloatArray, p: JointParameters, pose: FloatArray, jacobian: FloatArray) -> None:
    """Fill `pose` = (q, u_y, φ) of the tip and its `jacobian`, shape (3, n), at the coordinates `x`."""
    n, l = x.size, p.length
    if p.beam == RITZ:
        slope, shortening = 0.0, 0.0
        pose[0] = 0.0
        for j in range(3):
            inner = 0.0
            for k in range(3):
                inner += (j + 2) * (k + 2) / (j + k + 3) * x[k]
            pose[0] += l * x[j]
            slope += (j + 2) * x[j]
            shortening += 0.5 * inner * x[j]
            jacobian[0, j], jacobian[1, j], jacobian[2, j] = l, -l * inner, j + 2
        pose[1] = l * (x[3] - shortening)
        pose[2] = np.arctan(slope)
        for j in range(3):
            jacobian[2, j] /= 1.0 + slope * slope
        jacobian[0, 3], jacobian[1, 3], jacobian[2, 3] = 0.0, l, 0.0
        return
    link = l / n
    pose[0], pose[1], pose[2] = 0.0, 0.0, x[n - 1]
    for i in range(n):
        s, c = np.sin(x[i]), np.cos(x[i])
        pose[0] += link * s
        pose[1] += link * (c - 1.0)
        jacobian[0, i], jacobian[1, i], jacobian[2, i] = link * c, -link * s, 0.0
    jacobian[2, n - 1] = 1.0


@compiled
def inertia(x: FloatArray, v: FloatArray, p: JointParameters, matrix: FloatArray, bias: FloatArray) -> None:
    """Fill the mass `matrix`, shape (n, n), and the velocity-dependent inertia forces `bias`, shape (n,).

    The equations of motion read ``M(x) v̇ + bias(x, v) = force(x, v)``.
    """
    n, l = x.size, p.length
    if p.beam == RITZ:
        squared = 0.0
        row = np.zeros(4)
        row[3] = l
        for j in range(3):
            for k in range(3):
                b = (j + 2) * (k + 2) / (j + k + 3)
                row[j] -= l * b * x[k]
                squared += b * v[j] * v[k]
                matrix[j, k] = p.line_inertia * l * b + p.line_density * l**3 / (j + k + 5) + p.mass * l * l
            matrix[j, 3] = matrix[3, j] = 0.0
        matrix[3, 3] = 0.0
        for j in range(4):
            bias[j] = -p.mass * row[j] * l * squared
            for k in range(4):
                matrix[j, k] += p.mass * row[j] * row[k]
        return
    link = l / n
    for i in range(n):
        bias[i] = 0.0
        for j in range(n):
            lever = _lever(i, j, n, link, p)
            matrix[i, j] = lever * np.cos(x[i] - x[j])
            bias[i] += lever * np.sin(x[i] - x[j]) * v[j] ** 2
    matrix[n - 1, n - 1] += p.frame_inertia


@compiled
def _lever(i: int, j: int, n: int, link: float, p: JointParameters) -> float:
    """Σ of mass × lever of link i × lever of link j over the lumped masses: half links at each node, and the frame."""
    outer = max(i, j)
    beam = p.line_density * link * (n - outer - 0.5) * link * link
    arm_i = link + (p.frame_offset if i == n - 1 else 0.0)
    arm_j = link + (p.frame_offset if j == n - 1 else 0.0)
    return float(beam + p.mass * arm_i * arm_j)


@compiled
def elastic(x: FloatArray, v: FloatArray, p: JointParameters, force: FloatArray) -> float:
    """Fill `force`, shape (n,), with elasticity and loss of the beam; return its potential energy [J].

    The chain's includes the weight of the frame's offset, which the tip's vertical displacement does not carry.
    """
    n, l = x.size, p.length
    for j in range(n):
        force[j] = 0.0
    if p.beam == RITZ:
        energy = 0.5 * p.axial * l * x[3] ** 2
        force[3] = -p.axial * l * x[3]
        for g in range(_NODES.size):
            xi = _NODES[g]
            slope, bend, rate = 0.0, -p.curvature, 0.0
            for j in range(3):
                slope += (j + 2) * xi ** (j + 1) * x[j]
                bend += (j + 2) * (j + 1) * xi**j * x[j] / l
                rate += (j + 2) * (j + 1) * xi**j * v[j] / l
            stretch = 1.0 + slope * slope
            energy += 0.5 * p.bending * l * _WEIGHTS[g] * bend * bend * stretch
            for j in range(3):
                d1, d2 = (j + 2) * xi ** (j + 1), (j + 2) * (j + 1) * xi**j / l
                moment = p.bending * (bend * stretch * d2 + bend * bend * slope * d1) + p.bending_loss * rate * d2
                force[j] -= l * _WEIGHTS[g] * moment
        return float(energy)
    energy = 0.0
    natural = p.curvature * l / n
    for i in range(n):
        angle, rate = x[i] - natural, v[i]
        if i > 0:
            angle -= x[i - 1]
            rate -= v[i - 1]
        k = p.hinge_stiffness[i]
        energy += 0.5 * k * angle**2 * (1.0 + 0.5 * p.hinge_cubic * angle**2)
        moment = k * angle * (1.0 + p.hinge_cubic * angle**2) + p.hinge_loss[i] * rate
        force[i] -= moment
        if i > 0:
            force[i - 1] += moment
    weight = p.mass * p.gravity * p.frame_offset
    force[n - 1] += weight * np.sin(x[n - 1])
    return float(energy + weight * (np.cos(x[n - 1]) - 1.0))
