"""The numbers that an independent solution of the corrected equations gives (Table 1, b = 23 mm)."""

import numpy as np
import pytest

from pipeline.device.parameters import NOMINAL, TABLE1, JointParameters
from pipeline.generated.analytical_joint import motion, motion_slopes
from pipeline.models.analytical.bifurcation import (
    bistable_from,
    equilibrium_diagram,
    over_screw,
    switchable_to,
    switching_voltage,
)
from pipeline.models.analytical.statics import equilibria, tip_values
from pipeline.numerics.stiff import R_Q, R_S, R_V, R_Z, SLOPES, Z_Q, Z_V, Z_Z

OFF, LEFT, BOTH = np.array([0.0, 0.0]), np.array([3000.0, 0.0]), np.array([3000.0, 3000.0])
# Parameter set, |q±| [mm], φ [deg] and u_y [mm] there, q at left 3 kV [mm], |q| at both 3 kV [mm], barrier [µJ].
WELLS = [(TABLE1, 13.77, 11.27, -2.894, 15.15, 8.52, 977), (NOMINAL, 11.19, 8.87, -1.698, 13.47, 0.0, 315)]
# Slow eigenvalues, the stiffest real one and the fast pair [1/s].
SPECTRA = [
    (TABLE1, [-0.744 + 20.717j, -3.473, -3.682], -5.20e4, -1366 + 7955j),
    (NOMINAL, [-1.243 + 17.737j, -3.428, -3.692], -5.23e4, -1149 + 6170j),
]
# Pitchforks at v = 0 and both 3 kV [mm], z_b that left 3 kV switches and does not switch [mm], lowest 50 V step [V].
BIFURCATIONS = [(TABLE1, 2.693, 5.683, 8.5, 9.0, 2400.0), (NOMINAL, 4.435, 7.479, 9.5, None, 1650.0)]


@pytest.mark.parametrize(("parameters", "q", "phi", "u_y", "q_left", "q_both", "barrier"), WELLS)
def test_wells(
    parameters: JointParameters, q: float, phi: float, u_y: float, q_left: float, q_both: float, barrier: float
) -> None:
    low, middle, high = equilibria(parameters, OFF)
    assert (low.stable, middle.stable, high.stable) == (True, False, True)
    assert [1e3 * low.q, 1e3 * high.q] == pytest.approx([-q, q], abs=0.0051)
    assert np.degrees(high.phi) == pytest.approx(phi, abs=0.0051)
    assert 1e3 * high.u_y == pytest.approx(u_y, abs=0.00051)
    assert 1e6 * (middle.energy - high.energy) == pytest.approx(barrier, abs=0.51)
    assert tip_values(middle.qm, parameters.vector())[3:] == pytest.approx([1.426, 1.426], abs=0.00051)
    (switched,) = equilibria(parameters, LEFT)
    assert 1e3 * switched.q == pytest.approx(q_left, abs=0.0051)
    assert 1e3 * max(e.q for e in equilibria(parameters, BOTH) if e.stable) == pytest.approx(q_both, abs=0.0051)


def _state_matrix(parameters: JointParameters, x: np.ndarray) -> np.ndarray:
    """∂ẋ/∂x at an equilibrium without voltage, without the friction state, (10, 10)."""
    mass, slopes, rates, acting = np.empty((4, 4)), np.empty(SLOPES), np.empty(11), (np.zeros(2), np.zeros(1))
    motion(x, *acting, parameters.vector(), mass, rates)
    motion_slopes(x, *acting, parameters.vector(), np.zeros(4), slopes)
    r_q, r_v, r_z = slopes[R_Q:R_V].reshape(4, 4), slopes[R_V:R_Z].reshape(4, 4), slopes[R_Z:Z_Q].reshape(4, 3)
    z_q, z_v, z_z = slopes[Z_Q:Z_V].reshape(3, 4), slopes[Z_V:Z_Z].reshape(3, 4), np.diag(slopes[Z_Z:R_S])
    shape = np.eye(11)[4:8]
    return np.vstack([shape, -np.linalg.solve(mass, np.hstack([r_q, r_v, r_z])), np.hstack([z_q, z_v, z_z])])[:10, :10]


@pytest.mark.parametrize(("parameters", "slow", "stiffest", "fast"), SPECTRA)
def test_eigenvalues_in_the_right_well(
    parameters: JointParameters, slow: list[complex], stiffest: float, fast: complex
) -> None:
    well = equilibria(parameters, OFF)[-1]
    spectrum = np.linalg.eigvals(_state_matrix(parameters, np.concatenate([well.qm, np.zeros(7)])))
    for expected in slow:
        assert np.min(np.abs(spectrum - expected)) < 0.00075
    assert np.min(np.abs(spectrum - stiffest)) < 51.0
    assert np.min(np.abs(spectrum - fast)) < 0.75


@pytest.mark.parametrize(
    ("parameters", "off", "both", "switches", "locks", "lowest"),
    [pytest.param(*BIFURCATIONS[0], marks=pytest.mark.long), *BIFURCATIONS[1:]],
)
def test_bifurcations(
    parameters: JointParameters, off: float, both: float, switches: float, locks: float | None, lowest: float
) -> None:
    for v, pitchfork in ((OFF, off), (BOTH, both)):
        branches = equilibrium_diagram(over_screw(parameters, v), (0.0, 0.01))
        points = [point for branch in branches for point in branch.special]
        assert {point.kind for point in points} == {"branch point"}
        assert [1e3 * point.parameter for point in points] == pytest.approx([pitchfork] * len(points), abs=0.00051)
    assert 1e3 * (bistable_from(parameters) or 0.0) == pytest.approx(off, abs=0.00051)
    limit = switchable_to(parameters)
    assert limit is not None and 1e3 * limit > switches and (locks is None or 1e3 * limit < locks)
    found = switching_voltage(parameters)
    assert found.left == pytest.approx(found.right, rel=1e-9)
    assert found.both_ways is not None and 50.0 * np.ceil(found.both_ways / 50.0) == lowest
