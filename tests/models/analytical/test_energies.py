"""The generated kernels against the formulas of the paper, written again by hand, and against differences."""

import numpy as np
import pytest

from pipeline.device.parameters import NOMINAL, VACUUM_PERMITTIVITY, VECTOR_NAMES, JointParameters
from pipeline.equations.full_joint import BEAM_DAMPING_FACTOR
from pipeline.generated import analytical_joint as kernels
from pipeline.models.analytical.statics import length_scales
from pipeline.numerics.arrays import FloatArray
from pipeline.numerics.stiff import R_Q, R_S, R_V, R_Z, SLOPES, Z_Q, Z_V, Z_Z

UNEQUAL = NOMINAL.with_values(
    {"left.b": 23.4e-3, "right.Y": 1.1e6, "right.eps_r": 3.0, "left.e_z": 15e-3, "kappa0": 0.3, "F_c": 3e-3}
)
SCALE = length_scales(NOMINAL.l)


def shapes(count: int) -> FloatArray:
    """Ritz coordinates (count, 4) of bent beams."""
    random = np.random.default_rng(3).uniform(-1.0, 1.0, (count, 4))
    return random * np.array([0.05, 0.05, 0.03, 3e-5]) * SCALE


def energy_by_hand(joint: JointParameters, qm: FloatArray, v: FloatArray) -> float:
    """Eqs. 1 to 6 and 9 to 11 as corrected, with the integrals by the trapezoidal rule."""
    x = np.linspace(0.0, joint.l, 20001)
    slope = qm[0] * 2 * x + qm[1] * 3 * x**2 + qm[2] * 4 * x**3
    bend = qm[0] * 2 + qm[1] * 6 * x + qm[2] * 12 * x**2
    q = qm[0] * joint.l**2 + qm[1] * joint.l**3 + qm[2] * joint.l**4
    phi, u_y = np.arctan(slope[-1]), qm[3] - 0.5 * np.trapezoid(slope**2, x)
    energy = 0.5 * joint.E * joint.I * np.trapezoid((bend - joint.kappa0) ** 2 * (1 + slope**2), x)
    energy += 0.5 * joint.E * joint.A / joint.l * qm[3] ** 2 + joint.m * joint.g * u_y
    s, c = np.sin(phi), np.cos(phi)
    left, right = joint.left, joint.right
    one = np.hypot(
        -left.e_z - q - left.a0 * s + left.a * c + left.b * s,
        left.e_x - joint.l - u_y - left.a0 * c + left.b * c - left.a * s,
    )
    two = np.hypot(
        right.e_z - q - right.a0 * s - right.a * c + right.b * s,
        right.e_x - joint.l - u_y - right.a0 * c + right.b * c + right.a * s,
    )
    for side, length, voltage in ((left, one, v[0]), (right, two, v[1])):
        stretch = length / side.l0
        volume, c0 = side.n * side.A0 * side.d0, side.n * VACUUM_PERMITTIVITY * side.eps_r * side.A0 / side.d0
        energy += volume * side.Y / 6 * (stretch**2 + 2 / stretch - 3) - 0.5 * c0 * stretch * voltage**2
    return float(energy)


@pytest.mark.parametrize("joint", [NOMINAL, UNEQUAL])
def test_energy_is_that_of_the_corrected_paper(joint: JointParameters) -> None:
    v = np.array([2000.0, 1000.0])
    for qm in shapes(5):
        energy = kernels.statics(qm, v**2, joint.vector(), np.empty(4), np.empty((4, 4)))
        assert energy == pytest.approx(energy_by_hand(joint, qm, v), rel=1e-7)


def test_gradient_and_hessian_match_differences() -> None:
    p, v_squared, step = UNEQUAL.vector(), np.array([4e6, 1e6]), 1e-6
    gradient, hessian, up, down, unused = np.empty(4), np.empty((4, 4)), np.empty(4), np.empty(4), np.empty((4, 4))
    for qm in shapes(4):
        kernels.statics(qm, v_squared, p, gradient, hessian)
        for i, unit in enumerate(np.diag(SCALE) * step):
            high = kernels.statics(qm + unit, v_squared, p, up, unused)
            low = kernels.statics(qm - unit, v_squared, p, down, unused)
            assert (high - low) / (2 * step) == pytest.approx(gradient[i] * SCALE[i], rel=1e-5, abs=1e-6)
            expected = hessian[i] * SCALE[i] * SCALE
            assert (up - down) * SCALE / (2 * step) == pytest.approx(expected, rel=1e-5, abs=1e-3)


def test_parameter_sensitivity_matches_differences() -> None:
    p, qm, v_squared = UNEQUAL.vector(), shapes(1)[0], np.array([4e6, 1e6])
    sensitivity, up, down, unused = np.empty((4, p.size)), np.empty(4), np.empty(4), np.empty((4, 4))
    kernels.static_sensitivity(qm, v_squared, p, sensitivity)
    for column, name in enumerate(VECTOR_NAMES):
        step = 1e-6 * max(abs(p[column]), 1e-3)
        for target, sign in ((up, 1), (down, -1)):
            moved = p.copy()
            moved[column] += sign * step
            kernels.statics(qm, v_squared, moved, target, unused)
        difference = (up - down) / (2 * step) * SCALE
        size = np.max(np.abs(sensitivity[:, column] * SCALE)) + 1e-9
        assert difference == pytest.approx(sensitivity[:, column] * SCALE, abs=3e-4 * size), name


def test_linearisation_matches_differences_of_the_dynamics() -> None:
    rng = np.random.default_rng(5)
    p, qm, rate = UNEQUAL.vector(), shapes(1)[0], rng.standard_normal(4) * 0.1 * SCALE
    z, v_squared, force = np.array([0.01, -0.02, 0.3]), np.array([4e6, 1e6]), np.array([0.02])
    mass, tau, z_dot = np.empty((4, 4)), np.empty(4), np.empty(3)
    kernels.dynamics(qm, rate, z, v_squared, force, p, mass, tau, z_dot)
    acceleration = np.linalg.solve(mass, tau)
    x, slopes = np.concatenate([qm, rate, z]), np.empty(SLOPES)
    kernels.motion_slopes(x, v_squared, force, p, acceleration, slopes)
    r_q, r_v, z_q, z_v = (slopes[i : i + 4 * n].reshape(n, 4) for i, n in ((R_Q, 4), (R_V, 4), (Z_Q, 3), (Z_V, 3)))
    r_z, z_z = slopes[R_Z:Z_Q].reshape(4, 3), slopes[Z_Z:R_S]

    def residual(x: FloatArray) -> FloatArray:
        kernels.dynamics(x[:4], x[4:8], x[8:], v_squared, force, p, mass, tau, z_dot)
        return np.concatenate([(mass @ acceleration - tau) * SCALE, z_dot])

    exact = np.vstack([SCALE[:, None] * np.hstack([r_q, r_v, r_z]), np.hstack([z_q, z_v, np.diag(z_z)])])
    for column, unit in enumerate(np.concatenate([SCALE, SCALE, np.ones(3)])):
        step = np.eye(11)[column] * 1e-6 * unit
        difference = (residual(x + step) - residual(x - step)) / 2e-6
        size = np.max(np.abs(exact[:, column] * unit)) + 1e-9
        assert difference == pytest.approx(exact[:, column] * unit, abs=1e-5 * size), column


def test_mass_and_damping_are_positive_definite_and_damping_is_the_beams() -> None:
    still = NOMINAL.with_values({"eta_v": 0.0})
    mass, tau, z_dot = np.empty((4, 4)), np.empty(4), np.empty(3)
    damping, coupling, thickness = np.empty((4, 4)), np.empty((4, 3)), np.empty((2, 4))
    x = np.linspace(0.0, NOMINAL.l, 4001)
    curvatures = np.stack([2 + 0 * x, 6 * x, 12 * x**2])
    products = np.trapezoid(curvatures[:, None] * curvatures[None], x, axis=2)
    for qm in shapes(3):
        kernels.dynamics(qm, qm, np.zeros(3), np.zeros(2), np.zeros(1), NOMINAL.vector(), mass, tau, z_dot)
        kernels.dissipation(qm, still.vector(), damping, coupling, thickness)
        assert np.linalg.eigvalsh(mass * np.outer(SCALE, SCALE)).min() > 0.0
        expected = BEAM_DAMPING_FACTOR * NOMINAL.eta * NOMINAL.I * products
        assert damping[:3, :3] == pytest.approx(expected, rel=1e-6)
        kernels.dissipation(qm, NOMINAL.vector(), damping, coupling, thickness)
        assert np.linalg.eigvalsh(damping * np.outer(SCALE, SCALE)).min() > -1e-12
