"""The two pre-stretched DE membranes between the fixed base and the frame: lengths, rubber, electrostatics.

Corner of the frame on side s = −1 (left), +1 (right), from the corrected eqs. 4 and 5: tip + (s·a cos φ − (b − a0)
sin φ, −(b − a0) cos φ − s·a sin φ); anchor at (s·e_z, e_x − l) seen from the upright tip.

Rubber laws, uniaxial and incompressible, force conjugate to λ1 divided by volume, with initial modulus Y:
``NEO_HOOKEAN`` Y/3 (λ − λ⁻²) · ``GENT`` the same × J/(J − I1 + 3), shape = (J, –) · ``MOONEY_RIVLIN`` the first ×
(1 − r + r/λ), shape = (r, –) · ``OGDEN`` Σ μ_k (λ^{α_k − 1} − λ^{−α_k/2 − 1}) over exponents shape = (α_1, α_2),
each carrying half of Y.
"""

import math

from pipeline.compiled import compiled
from pipeline.numerics.arrays import FloatArray
from pipeline.rig.parameters import GENT, MOONEY_RIVLIN, NEO_HOOKEAN, THICKNESS, JointParameters


@compiled
def stretch(side: int, pose: FloatArray, p: JointParameters, gradient: FloatArray) -> float:
    """λ1 of membrane `side` (0 left, 1 right) at `pose` = (q, u_y, φ); fills ∂λ1/∂pose, shape (3,)."""
    s = 2.0 * side - 1.0
    sin, cos = math.sin(pose[2]), math.cos(pose[2])
    arm, drop = s * p.arm[side], p.drop[side]
    dx = pose[0] + arm * cos - drop * sin - s * p.anchor_x[side]
    dy = p.length + pose[1] - drop * cos - arm * sin - p.anchor_y[side]
    length = math.sqrt(dx * dx + dy * dy)
    scale = 1.0 / (length * p.free_length[side])
    gradient[0] = dx * scale
    gradient[1] = dy * scale
    gradient[2] = (dx * (-arm * sin - drop * cos) + dy * (drop * sin - arm * cos)) * scale
    return float(length / p.free_length[side])


@compiled
def rubber_stress(stretch_1: float, side: int, p: JointParameters) -> float:
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


@compiled
def rubber_energy(stretch_1: float, side: int, p: JointParameters) -> float:
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


@compiled
def viscous_strain(stretch_1: float, p: JointParameters) -> tuple[float, float]:
    """The strain that the viscous branches see, and its derivative by λ1: λ3 = λ1^(−1/2), or ln λ1."""
    if p.strain == THICKNESS:
        thickness = 1.0 / math.sqrt(stretch_1)
        return thickness, -0.5 * thickness / stretch_1
    return math.log(stretch_1), 1.0 / stretch_1
