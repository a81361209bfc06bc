"""Equilibria, static path and continuation: properties that need no stored numbers."""

import numpy as np
import pytest

from pipeline.errors import InputError
from pipeline.joint.bifurcation import bistable_from, branch_through, over_force, over_voltage, switching_voltage
from pipeline.joint.characteristic_curves import characteristics
from pipeline.joint.equilibria import equilibria
from pipeline.joint.full_order import rest_state
from pipeline.joint.parameters import NOMINAL, TABLE1
from pipeline.joint.static_path import static_path, static_pitch_angle, unactuated_path
from pipeline.numerics.arrays import FloatArray
from pipeline.solvers.continuation import trace_branch

MIRRORED = {"left": "right", "right": "left"}


def test_mirroring_the_joint_mirrors_its_equilibria() -> None:
    unequal = {"left.b": 23.3e-3, "right.Y": 1.15e6}
    swapped = {f"{MIRRORED[name[: name.index('.')]]}{name[name.index('.') :]}": x for name, x in unequal.items()}
    one = equilibria(NOMINAL.with_values(unequal), np.array([1000.0, 300.0]), 0.004)
    two = equilibria(NOMINAL.with_values(swapped), np.array([300.0, 1000.0]), -0.004)
    assert len(one) == 3
    assert [e.q for e in one] == pytest.approx([-e.q for e in reversed(two)], abs=1e-9)
    assert [e.stable for e in one] == [e.stable for e in reversed(two)]


def test_holding_force_is_the_slope_of_the_energy() -> None:
    path = static_path(NOMINAL, np.linspace(-0.02, 0.02, 321), np.array([1500.0, 0.0]))
    # Central differences of fourth order; the path is smooth.
    h = path.q[1] - path.q[0]
    slope = (path.energy[:-4] - 8 * path.energy[1:-3] + 8 * path.energy[3:-1] - path.energy[4:]) / (12 * h)
    assert slope == pytest.approx(path.force[2:-2], abs=1e-5)
    stiffness = (path.force[:-4] - 8 * path.force[1:-3] + 8 * path.force[3:-1] - path.force[4:]) / (12 * h)
    assert stiffness == pytest.approx(path.stiffness[2:-2], abs=1e-2)
    farads = path.capacitance
    slopes = (farads[:-4] - 8 * farads[1:-3] + 8 * farads[3:-1] - farads[4:]) / (12 * h)
    assert slopes == pytest.approx(path.capacitance_slope[2:-2], rel=1e-4)


def test_zeros_of_the_holding_force_are_the_equilibria() -> None:
    path = unactuated_path(TABLE1)
    crossings = np.flatnonzero(np.diff(np.sign(path.force)) != 0)
    zeros = sorted({round(1e3 * float(path.q[i]), 0) for i in crossings})
    assert zeros == pytest.approx(sorted({round(1e3 * e.q, 0) for e in equilibria(TABLE1, np.zeros(2))}), abs=1.0)
    assert np.array_equal(path.stable, path.stiffness > 0.0)


def test_voltage_pulls_towards_the_other_side() -> None:
    path = unactuated_path(NOMINAL)
    assert (path.capacitance_slope[:, 0] > 0.0).all() and (path.capacitance_slope[:, 1] < 0.0).all()


def test_pitch_angle_map_interpolates_the_path_and_continues_it() -> None:
    q = np.array([[-0.0123, 0.0], [0.0071, 0.0401]])
    phi = static_pitch_angle(q, NOMINAL)
    fine = static_path(NOMINAL, np.linspace(-0.0123, 0.0071, 98), np.zeros(2))
    assert phi[0, 0] == pytest.approx(fine.phi[0], abs=1e-7) and phi[1, 0] == pytest.approx(fine.phi[-1], abs=1e-7)
    assert phi[0, 1] == pytest.approx(0.0, abs=1e-12) and phi[1, 1] > static_pitch_angle(np.array(0.03), NOMINAL)


def test_a_joint_without_static_path_says_so() -> None:
    for snapping in ({"E": 0.9e9}, {"b": 20e-3}):
        with pytest.raises(InputError, match="snaps although its tip is held"):
            unactuated_path(NOMINAL.with_values(snapping))


def test_a_snapping_joint_still_has_curves_equilibria_and_motions() -> None:
    snapping = NOMINAL.with_values({"b": 20e-3})
    result = characteristics(snapping)
    path = result.paths["off"]
    assert result.switching.left is not None and not path.held.all()
    # The branch runs through both wells and the saddle between them.
    for equilibrium in equilibria(snapping, np.zeros(2)):
        assert np.min(np.hypot((path.q - equilibrium.q) / 1e-3, path.force / 1e-2)) < 1.0
    well = equilibria(snapping, np.zeros(2))[0].q
    assert rest_state(snapping, well - 1e-3, 0.0, np.zeros(2))[:3] @ snapping.l ** np.arange(2, 5) == pytest.approx(
        well - 1e-3
    )


def test_asymmetry_turns_the_pitchfork_into_a_fold() -> None:
    symmetric, unequal = NOMINAL, NOMINAL.with_values({"right.Y": 1.21e6})
    assert (bistable_from(unequal) or 0.0) > (bistable_from(symmetric) or 1.0)
    voltages = switching_voltage(unequal)
    assert voltages.left is not None and voltages.right is not None and voltages.left < voltages.right


def test_no_second_well_no_switching_voltage() -> None:
    assert switching_voltage(NOMINAL.with_values({"b": 28e-3})).both_ways is None


def test_force_branch_passes_both_folds_of_the_double_well() -> None:
    well = equilibria(NOMINAL, np.zeros(2))[0]
    branch = branch_through(over_force(NOMINAL, np.zeros(2)), well.qm, 0.0, (-0.1, 0.1))
    folds = sorted(point.parameter for point in branch.special)
    path = unactuated_path(NOMINAL)
    inner = np.abs(path.q) < 0.008
    assert [point.kind for point in branch.special] == ["fold", "fold"]
    assert folds == pytest.approx([path.force[inner].min(), path.force[inner].max()], abs=2e-5)


def test_switching_happens_at_the_fold() -> None:
    fold = switching_voltage(NOMINAL).left or 0.0
    below, above = (equilibria(NOMINAL, np.array([fold + d, 0.0])) for d in (-1.0, 1.0))
    assert sum(e.stable for e in below) == 2 and sum(e.stable for e in above) == 1
    branch = branch_through(over_voltage(NOMINAL, 0), equilibria(NOMINAL, np.zeros(2))[0].qm, 0.0, (0.0, 3000.0))
    assert branch.stable.any() and not branch.stable.all()


def test_continuation_of_the_normal_forms() -> None:
    def fold(y: FloatArray, lam: float) -> tuple[FloatArray, FloatArray, FloatArray]:
        return y**2 + lam, np.array([[2 * y[0]]]), np.ones(1)

    def pitchfork(y: FloatArray, lam: float) -> tuple[FloatArray, FloatArray, FloatArray]:
        return y**3 - lam * y, np.array([[3 * y[0] ** 2 - lam]]), -y

    parabola = trace_branch(fold, np.array([1.0]), -1.0, bounds=(-1.5, 1.0))
    assert [point.kind for point in parabola.special] == ["fold"]
    assert parabola.special[0].parameter == pytest.approx(0.0, abs=1e-12)
    assert np.abs(parabola.y[:, 0] ** 2 + parabola.parameter).max() < 1e-10
    straight = trace_branch(pitchfork, np.array([0.0]), -0.5, bounds=(-1.0, 1.0))
    assert [point.kind for point in straight.special] == ["branch point"]
    assert straight.special[0].parameter == pytest.approx(0.0, abs=1e-8)
    assert straight.stable[0] and not straight.stable[-1]
