"""Elements of the virtual joint: the clamped beam that carries the frame, the two membranes, and friction.

The beam has two theories.

``RITZ``: ``w = l Σ a_j ξ^j``, j = 2…4, ξ = x/l, and axial displacement ``u0 = l a_5`` (eqs. 2, 8, 9, 13, with the
½ on the bending energy that makes the beam buckle and ``(∂w/∂x)²`` in eq. 2). Coordinates a_2, a_3, a_4, a_5.

``CHAIN``: n rigid links at angles θ_i to the vertical, rotational springs between them, masses lumped at the
ends; ``½ Σ k_i Δ_i²(1 + c Δ_i²/2)`` with ``Δ_i = θ_i − θ_{i−1} − κ0 l/n``. As n grows this is the geometrically
exact inextensible elastica. The frame sits rigidly on the last link.

The two pre-stretched DE membranes run between the fixed base and the frame. Corner of the frame on side s = −1 (left),
+1 (right), from the corrected eqs. 4 and 5: tip + (s·a cos φ − (b − a0) sin φ, −(b − a0) cos φ − s·a sin φ); anchor at
(s·e_z, e_x − l) seen from the upright tip. Rubber laws, uniaxial and incompressible, force conjugate to λ1 divided by
volume, with initial modulus Y: ``NEO_HOOKEAN`` Y/3 (λ − λ⁻²) · ``GENT`` the same × J/(J − I1 + 3), shape = (J, –) ·
``MOONEY_RIVLIN`` the first × (1 − r + r/λ), shape = (r, –) · ``OGDEN`` Σ μ_k (λ^{α_k − 1} − λ^{−α_k/2 − 1}) over
exponents shape = (α_1, α_2), each carrying half of Y.

The functions fill arrays that the caller owns, so that a time step allocates nothing. Cost: O(n²) of inertia.
"""

import math

import numpy as np

from ..numerics.arrays import FloatArray
from ..numerics.compiled import inner, shared
from .parameters import (
    BOUC_WEN,
    DAHL,
    GENT,
    LUGRE,
    MAXWELL_SLIP,
    MOONEY_RIVLIN,
    NEO_HOOKEAN,
    RITZ,
    THICKNESS,
    RigParameters,
)

# Six Gauss points on [0, 1]: exact for the bending energy, a polynomial of degree ten.
_AT, _SHARES = np.polynomial.legendre.leggauss(6)
_NODES, _WEIGHTS = 0.5 * (_AT + 1.0), 0.5 * _SHARES


@shared
def tip(x: FloatArray, p: RigParameters, pose: FloatArray, jacobian: FloatArray) -> None:
    """Fill `pose` = (q, u_y, φ) of the tip and its `jacobian`, shape (3, n), at the coordinates `x`.

    Parameters
    ----------
    x : FloatArray, shape (n,)
        Coordinates.
    p : RigParameters
        The joint.
    pose : FloatArray, shape (3,)
        Takes q [m], u_y [m] and φ [rad].
    jacobian : FloatArray, shape (3, n)
        Takes their derivatives.
    """
    n = x.size
    l = p.length
    if p.beam == RITZ:
        slope = 0.0
        shortening = 0.0
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
        jacobian[0, 3] = jacobian[2, 3] = 0.0
        jacobian[1, 3] = l
        return
    link = l / n
    pose[0] = pose[1] = 0.0
    pose[2] = x[n - 1]
    for i in range(n):
        s = np.sin(x[i])
        c = np.cos(x[i])
        pose[0] += link * s
        pose[1] += link * (c - 1.0)
        jacobian[0, i], jacobian[1, i], jacobian[2, i] = link * c, -link * s, 0.0
    jacobian[2, n - 1] = 1.0


@shared
def inertia(x: FloatArray, v: FloatArray, p: RigParameters, matrix: FloatArray, bias: FloatArray) -> None:
    """Fill the mass `matrix`, shape (n, n), and the velocity-dependent inertia forces `bias`, shape (n,).

    The equations of motion read ``M(x) v̇ + bias(x, v) = force(x, v)``.

    Parameters
    ----------
    x, v : FloatArray, shape (n,)
        Coordinates and their rates.
    p : RigParameters
        The joint.
    matrix : FloatArray, shape (n, n)
        Takes the mass matrix.
    bias : FloatArray, shape (n,)
        Takes the inertia forces.
    """
    n = x.size
    l = p.length
    if p.beam == RITZ:
        squared = 0.0
        row = bias  # ∂u_y/∂x, until the forces take its place
        row[3] = l
        for j in range(3):
            row[j] = 0.0
            for k in range(3):
                b = (j + 2) * (k + 2) / (j + k + 3)
                row[j] -= l * b * x[k]
                squared += b * v[j] * v[k]
                matrix[j, k] = p.line_inertia * l * b + p.line_density * l**3 / (j + k + 5) + p.mass * l * l
            matrix[j, 3] = matrix[3, j] = 0.0
        matrix[3, 3] = 0.0
        for j in range(n):
            for k in range(n):
                matrix[j, k] += p.mass * row[j] * row[k]
        for j in range(n):
            bias[j] = -p.mass * row[j] * l * squared
        return
    link = l / n
    for i in range(n):
        bias[i] = 0.0
        for j in range(n):
            # Σ of mass × lever of link i × lever of link j over the lumped masses: half links at each node, and the
            # frame
            beam = p.line_density * link * (n - max(i, j) - 0.5) * link * link
            arm_i = link + (p.frame_offset if i == n - 1 else 0.0)
            arm_j = link + (p.frame_offset if j == n - 1 else 0.0)
            lever = beam + p.mass * arm_i * arm_j
            matrix[i, j] = lever * np.cos(x[i] - x[j])
            bias[i] += lever * np.sin(x[i] - x[j]) * v[j] ** 2
    matrix[n - 1, n - 1] += p.frame_inertia


@shared
def elastic(x: FloatArray, v: FloatArray, p: RigParameters, force: FloatArray) -> float:
    """Fill `force`, shape (n,), with elasticity and loss of the beam; return its potential energy [J].

    The chain's includes the weight of the frame's offset, which the tip's vertical displacement does not carry.

    Parameters
    ----------
    x, v : FloatArray, shape (n,)
        Coordinates and their rates.
    p : RigParameters
        The joint.
    force : FloatArray, shape (n,)
        Takes the forces.
    """
    n = x.size
    l = p.length
    for j in range(n):
        force[j] = 0.0
    if p.beam == RITZ:
        energy = 0.5 * p.axial * l * x[3] ** 2
        force[3] = -p.axial * l * x[3]
        for g in range(_NODES.size):
            xi = _NODES[g]
            slope = 0.0
            bend = -p.curvature
            rate = 0.0
            for j in range(3):
                slope += (j + 2) * xi ** (j + 1) * x[j]
                bend += (j + 2) * (j + 1) * xi**j * x[j] / l
                rate += (j + 2) * (j + 1) * xi**j * v[j] / l
            stretch = 1.0 + slope * slope
            energy += 0.5 * p.bending * l * _WEIGHTS[g] * bend * bend * stretch
            for j in range(3):
                d1 = (j + 2) * xi ** (j + 1)
                d2 = (j + 2) * (j + 1) * xi**j / l
                moment = p.bending * (bend * stretch * d2 + bend * bend * slope * d1) + p.bending_loss * rate * d2
                force[j] -= l * _WEIGHTS[g] * moment
        return float(energy)
    energy = 0.0
    for i in range(n):
        angle = x[i] - p.curvature * l / n
        rate = v[i]
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


@shared
def hinge_angle(x: FloatArray, i: int) -> float:
    """Angle [rad] by which link i of a chain is turned against the one before."""
    return float(x[i] - x[i - 1] if i > 0 else x[i])


@shared
def yielding(
    x: FloatArray, start: FloatArray, layers: FloatArray, p: RigParameters, force: FloatArray, after: FloatArray
) -> None:
    """Add the moments of the layers of a chain's hinges that yield to `force`, shape (n,).

    Perfectly plastic layers in parallel with the elastic hinge (Prandtl–Ishlinskii): each holds an elastic angle that
    follows the hinge since `start`, shape (n,), and stops at its yield. `layers`, shape (layers, n), holds these
    angles [rad] before, `after` those at `x`.

    Parameters
    ----------
    x : FloatArray, shape (n,)
        Coordinates.
    start : FloatArray, shape (n,)
        Coordinates at the beginning of the step.
    layers : FloatArray, shape (layers, n)
        Elastic angles [rad] at the beginning.
    p : RigParameters
        The joint.
    force : FloatArray, shape (n,)
        The moments are added to it.
    after : FloatArray, shape (layers, n)
        Takes the elastic angles [rad] at `x`.
    """
    n = x.size
    if p.beam == RITZ:
        return
    for i in range(n):
        moved = hinge_angle(x, i) - start[i]
        moment = 0.0
        for k in range(p.plastic_share.size):
            most = p.plastic_yield[k] * p.length / n
            after[k, i] = min(max(layers[k, i] + moved, -most), most)
            moment += p.plastic_share[k] * p.hinge_stiffness[i] * after[k, i]
        force[i] -= moment
        if i > 0:
            force[i - 1] += moment


@shared
def stretch(side: int, pose: FloatArray, p: RigParameters, gradient: FloatArray) -> float:
    """λ1 of membrane `side` (0 left, 1 right) at `pose` = (q, u_y, φ); fills ∂λ1/∂pose, shape (3,).

    Parameters
    ----------
    side : int
        0 for the left membrane, 1 for the right one.
    pose : FloatArray, shape (3,)
        q [m], u_y [m] and φ [rad] of the tip.
    p : RigParameters
        The joint.
    gradient : FloatArray, shape (3,)
        Takes ∂λ1/∂pose.
    """
    s = 2.0 * side - 1.0
    sin = math.sin(pose[2])
    cos = math.cos(pose[2])
    arm = s * p.arm[side]
    drop = p.drop[side]
    dx = pose[0] + arm * cos - drop * sin - s * p.anchor_x[side]
    dy = p.length + pose[1] - drop * cos - arm * sin - p.anchor_y[side]
    length = math.sqrt(dx * dx + dy * dy)
    scale = 1.0 / (length * p.free_length[side])
    gradient[0] = dx * scale
    gradient[1] = dy * scale
    gradient[2] = (dx * (-arm * sin - drop * cos) + dy * (drop * sin - arm * cos)) * scale
    return float(length / p.free_length[side])


@shared
def rubber_stress(stretch_1: float, side: int, p: RigParameters) -> float:
    """∂U/∂λ1 per volume of the rubber alone [Pa] at `stretch_1` = λ1."""
    modulus: float = p.modulus[side]
    shape: float = p.rubber_shape[0]
    neo = modulus / 3.0 * (stretch_1 - 1.0 / stretch_1**2)
    if p.rubber == NEO_HOOKEAN:
        return neo
    if p.rubber == GENT:
        room = shape - stretch_1**2 - 2.0 / stretch_1 + 3.0
        return neo * shape / room if room > 0.0 else math.nan  # beyond its last stretch the rubber has no stress
    if p.rubber == MOONEY_RIVLIN:
        return neo * (1.0 - shape + shape / stretch_1)
    stress = 0.0
    for alpha in p.rubber_shape:  # μ_k · 3α_k/2 is the share of Y
        power = math.pow(stretch_1, alpha - 1.0) - math.pow(stretch_1, -0.5 * alpha - 1.0)
        stress += 0.5 * modulus / (1.5 * alpha) * power
    return stress


def rubber_energy(stretch_1: float, side: int, p: RigParameters) -> float:
    """Strain energy per volume [J/m³] of the rubber alone at `stretch_1` = λ1, zero at λ1 = 1."""
    modulus: float = p.modulus[side]
    shape: float = p.rubber_shape[0]
    invariant = stretch_1**2 + 2.0 / stretch_1 - 3.0
    if p.rubber == NEO_HOOKEAN:
        return modulus / 6.0 * invariant
    if p.rubber == GENT:
        return -modulus / 6.0 * shape * math.log(1.0 - invariant / shape)
    if p.rubber == MOONEY_RIVLIN:
        second = 2.0 * stretch_1 + 1.0 / stretch_1**2 - 3.0
        return modulus / 6.0 * ((1.0 - shape) * invariant + shape * second)
    energy = 0.0
    for alpha in p.rubber_shape:
        terms = math.pow(stretch_1, alpha) + 2.0 * math.pow(stretch_1, -0.5 * alpha) - 3.0
        energy += 0.5 * modulus / (1.5 * alpha**2) * terms
    return energy


@inner
def viscous_strain(stretch_1: float, strain: int) -> tuple[float, float]:
    """The strain that the viscous branches see, and its derivative by λ1: λ3 = λ1^(−1/2), or ln λ1."""
    if strain == THICKNESS:
        thickness = 1.0 / math.sqrt(stretch_1)
        return thickness, -0.5 * thickness / stretch_1
    return math.log(stretch_1), 1.0 / stretch_1


@shared
def slide(z: FloatArray, shift: float, speed: float, dt: float, p: RigParameters, after: FloatArray) -> float:
    """Friction force [N] against the motion after sliding by `shift` [m] at `speed` [m/s] within `dt` [s].

    `z`, shape (elements,), is the state before and `after` the state after [N]. Each law is solved implicitly in it
    over an implicit half step, hence stable for any displacement Δ:

    ``MAXWELL_SLIP``  each element: ``z ← clip(z + k Δ, ±W)``, force Σ z (Al-Bender et al. 2005,
                      doi:10.1109/TAC.2005.858676)
    ``DAHL``          ``dz = k(1 − z sgn(dx)/W) dx``, plus Coulomb ``c0 tanh(ẋ/c1)``
    ``LUGRE``         bristle deflection with the Stribeck curve ``W(1 + c0 exp(−(ẋ/c1)²))``, plus micro-damping c2 ż
                      and viscous c3 ẋ (Canudas de Wit et al. 1995, doi:10.1109/9.376053)
    ``BOUC_WEN``      ``dz = k(dx − ((1 − c0)|dx| z + c0 dx |z|)/W)``, exponent one, 0 ≤ c0 ≤ ½

    where k, W are `slip_stiffness`, `slip_force` and c0… are `friction_shape`.

    Parameters
    ----------
    z : FloatArray, shape (elements,)
        Friction states before [N].
    shift : float
        Travel [m].
    speed : float
        Velocity [m/s].
    dt : float
        Time [s].
    p : RigParameters
        The joint.
    after : FloatArray, shape (elements,)
        Takes the friction states after [N].
    """
    force = 0.0
    for i in range(z.size):
        k = p.slip_stiffness[i]
        w = p.slip_force[i]
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
