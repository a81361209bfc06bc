"""The full-order joint against the published check values, its own energies, and known laws."""

import math

import numpy as np
import pytest

from pipeline.rig import parameters as law
from pipeline.rig.elements import elastic, inertia, rubber_energy, rubber_stress, slide, tip, yielding
from pipeline.rig.joint import moved, potential, rest, simulate, wells
from pipeline.rig.parameters import RigParameters, coordinates, nominal

FRICTIONS = {
    law.MAXWELL_SLIP: np.array([0.0, 1.0, 0.0, 0.0]),
    law.LUGRE: np.array([0.3, 5e-3, 0.02, 0.005]),
    law.BOUC_WEN: np.array([0.4, 1.0, 0.0, 0.0]),
    law.DAHL: np.array([2e-4, 5e-3, 0.0, 0.0]),
}


def conservative(beam: int) -> RigParameters:
    """The drawing without any loss."""
    p = nominal()
    return p._replace(
        beam=beam,
        frame_offset=4e-3 if beam == law.CHAIN else 0.0,
        frame_inertia=1e-5,
        bending_loss=0.0,
        hinge_loss=np.zeros_like(p.hinge_loss),
        kelvin_voigt=0.0,
        branch_modulus=np.zeros_like(p.branch_modulus),
    )


def test_nominal_joint_meets_the_check_values_of_its_statics() -> None:
    p = nominal()
    left, right = wells(p)
    assert left == pytest.approx(-11.19e-3, abs=5e-6)
    assert right == pytest.approx(11.19e-3, abs=5e-6)
    pose, x = np.empty(3), rest(p, side=1)
    tip(x, p, pose, np.empty((3, 4)))
    assert math.degrees(pose[2]) == pytest.approx(8.87, abs=0.01)
    assert pose[1] == pytest.approx(-1.698e-3, abs=1e-6)
    softer = p._replace(bending=p.bending * 1.62 / 1.76, axial=p.axial * 1.62 / 1.76)
    assert wells(softer)[1] == pytest.approx(13.77e-3, abs=5e-6)
    barrier = potential(p, np.array([0.0, 0.0, 0.0, x[3]]), np.zeros(2)) - potential(p, x, np.zeros(2))
    assert barrier == pytest.approx(315e-6, abs=5e-6)


@pytest.mark.parametrize("beam", [law.RITZ, law.CHAIN])
@pytest.mark.parametrize("rubber", [law.NEO_HOOKEAN, law.GENT, law.MOONEY_RIVLIN, law.OGDEN])
def test_joint_rests_where_its_potential_is_least(beam: int, rubber: int) -> None:
    """Where the joint comes to rest, the potential is stationary and curved upwards in every coordinate."""
    shape = {law.GENT: [9.0, 0.0], law.MOONEY_RIVLIN: [0.3, 0.0], law.OGDEN: [1.5, 3.0]}.get(rubber, [0.0, 0.0])
    p = nominal()._replace(beam=beam, rubber=rubber, rubber_shape=np.array(shape), frame_offset=2e-3 * beam)
    x = rest(p, side=1)
    step = 1e-4 * np.eye(coordinates(p))
    energies = [[potential(p, x + s * row, np.zeros(2)) for s in (-1, 0, 1)] for row in step]
    for low, middle, high in energies:
        curvature = (low - 2 * middle + high) / 1e-8
        assert curvature > 0
        assert abs(high - low) / 2e-4 < 1e-5 * curvature


@pytest.mark.parametrize("rubber", [law.NEO_HOOKEAN, law.GENT, law.MOONEY_RIVLIN, law.OGDEN])
def test_rubber_laws_share_their_initial_modulus_and_derive_from_their_energy(rubber: int) -> None:
    shape = {law.GENT: [9.0, 0.0], law.MOONEY_RIVLIN: [0.3, 0.0], law.OGDEN: [1.5, 3.0]}.get(rubber, [0.0, 0.0])
    p = nominal()._replace(rubber=rubber, rubber_shape=np.array(shape))
    assert rubber_stress(1.0 + 1e-6, 0, p) / 1e-6 == pytest.approx(p.modulus[0], rel=1e-4)
    for stretch in (0.9, 1.2, 1.6):
        slope = (rubber_energy(stretch + 1e-5, 0, p) - rubber_energy(stretch - 1e-5, 0, p)) / 2e-5
        assert slope == pytest.approx(rubber_stress(stretch, 0, p), rel=1e-6)


@pytest.mark.parametrize("beam", [law.RITZ, law.CHAIN])
def test_energy_is_kept_without_losses(beam: int) -> None:
    """Released where a slightly different joint rests, it swings for 2 s and has the energy that it began with."""
    p = conservative(beam)
    p = p._replace(axial=p.axial / 50)  # slow enough that the steps resolve the axial mode
    lossy = nominal()._replace(beam=beam, frame_offset=p.frame_offset, axial=p.axial)
    x0, n = rest(lossy._replace(arm=p.arm * np.array([1.0, 1.03])), side=-1), coordinates(p)
    released = potential(p, x0, np.zeros(2)) - potential(p, rest(lossy, side=-1), np.zeros(2))
    assert released > 1e-6
    for steps in (237, 2001, 20_001):
        end = moved(p, x0, np.zeros((steps, 2)), 1e-4)[2]
        x, v = end.x, end.v
        matrix = np.empty((n, n))
        inertia(x, v, p, matrix, np.empty(n))
        kinetic = 0.5 * v @ matrix @ v
        change = potential(p, x, np.zeros(2)) - potential(p, x0, np.zeros(2)) + kinetic
        assert abs(change) < 2e-3 * released


@pytest.mark.parametrize("beam", [law.RITZ, law.CHAIN])
def test_inertia_forces_do_no_work_of_their_own(beam: int) -> None:
    """v·bias = ½ v·Ṁ v, the property that makes kinetic energy change by the other forces only."""
    p, rng = conservative(beam), np.random.default_rng(5)
    n = coordinates(p)
    x, v = 0.2 * rng.standard_normal(n), rng.standard_normal(n)
    matrix, bias = np.empty((n, n)), np.empty(n)
    inertia(x, v, p, matrix, bias)
    work = v @ bias
    energies = []
    for step in (-1e-5, 1e-5):
        inertia(x + step * v, v, p, matrix, np.empty(n))
        energies.append(0.5 * v @ matrix @ v)
    assert work == pytest.approx((energies[1] - energies[0]) / 2e-5, rel=1e-6)


def test_chain_tends_to_the_elastica() -> None:
    """A horizontal dead load bends many links as the cantilever's linear theory says for small loads."""
    p = nominal(links=40)._replace(beam=law.CHAIN)
    load, n = 1e-3, 40
    stiffness = np.empty((n, n))
    for j in range(n):
        x = np.zeros(n)
        x[j] = 1e-6
        force = np.empty(n)
        elastic(x, np.zeros(n), p, force)
        stiffness[:, j] = -force / 1e-6
    pose, jacobian = np.empty(3), np.empty((3, n))
    tip(np.zeros(n), p, pose, jacobian)
    deflection = jacobian[0] @ np.linalg.solve(stiffness, load * jacobian[0])
    assert deflection == pytest.approx(load * p.length**3 / (3 * p.bending), rel=2e-3)


@pytest.mark.parametrize("kind", FRICTIONS)
def test_friction_dissipates_over_any_closed_cycle_and_saturates(kind: int) -> None:
    p = nominal()._replace(
        friction=kind, slip_stiffness=np.array([4.0, 1.0]), slip_force=np.array([1e-3, 5e-4]),
        friction_shape=FRICTIONS[kind],
    )  # fmt: skip
    path = 3e-3 * np.sin(np.linspace(0, 4 * np.pi, 4001))
    dt, z, work, forces = 1e-3, np.zeros(2), 0.0, []
    for shift in np.diff(path):
        after = np.empty(2)
        force = slide(z, shift, shift / dt, dt, p, after)
        work += force * shift
        forces.append(force)
        z = after
    assert work > 0.5 * 2 * 4 * 3e-3 * 1e-3  # two cycles of four quarter strokes against most of the force
    assert 1.0e-3 < max(forces) < 1.5e-3 * 1.5
    assert min(forces) == pytest.approx(-max(forces), rel=0.05)


@pytest.mark.parametrize("beam", [law.RITZ, law.CHAIN])
def test_time_step_is_converged(beam: int) -> None:
    p = nominal()._replace(beam=beam)
    t = np.arange(15_000) * 1e-4
    v = np.zeros((t.size, 2))
    v[:, 0] = 3000 * np.clip((t - 0.1) / 0.01, 0, 1)
    x0 = rest(p, side=-1)
    coarse, fine = (simulate(p, v, 1e-4, stride=stride, x0=x0).q for stride in (5, 1))
    assert coarse.max() > 0.02, "it snaps over and overshoots"
    assert np.abs(coarse - fine).max() < 5e-6


def test_layers_of_a_hinge_are_elastic_then_yield_and_dissipate_over_a_cycle() -> None:
    """One layer of stiffness s k that yields at z: the loop has the area 4 s k z (A − z) (Masing)."""
    p = nominal(links=3)._replace(
        beam=law.CHAIN, plastic_share=np.array([0.1]), plastic_yield=np.array([2.0]), hinge_stiffness=np.full(3, 0.5)
    )
    most, amplitude, stiffness = 2.0 * p.length / 3, 0.2, 0.1 * 0.5
    layers, angle, work, after = np.zeros((1, 3)), 0.0, 0.0, np.zeros((1, 3))
    path = amplitude * np.sin(np.linspace(0.0, 4.0 * np.pi, 20_001))
    for i, turned in enumerate(path[1:]):
        force = np.zeros(3)
        # Every link turns with the first, so only the clamp bends.
        yielding(np.full(3, turned), np.array([angle, 0.0, 0.0]), layers, p, force, after)
        assert force[0] == pytest.approx(-stiffness * after[0, 0])
        work -= force[0] * (turned - angle) if i >= 10_000 else 0.0
        layers, angle = after.copy(), turned
    assert np.abs(layers).max() <= most + 1e-15
    assert work == pytest.approx(4.0 * stiffness * most * (amplitude - most), rel=1e-3)


def test_a_joint_whose_beam_yields_does_not_come_back_to_where_it_was() -> None:
    """Pulled by 2 kV and released, it rests elsewhere; without layers it returns."""
    p = nominal(links=4)._replace(beam=law.CHAIN, branch_modulus=np.zeros((2, 1)))
    pulled = np.zeros((8000, 2))
    pulled[500:2500, 1] = 2000.0
    gaps = []
    for share in (0.0, 0.05):
        q = simulate(
            p._replace(plastic_share=np.array([share]), plastic_yield=np.array([0.2])), pulled, 1e-3, stride=1
        ).q
        gaps.append(abs(q[-1] - q[0]))
    assert gaps[0] < 2e-6
    assert gaps[1] > 20 * gaps[0]
