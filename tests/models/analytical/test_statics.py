"""Equilibria, static path and continuation: properties that need no stored numbers."""

import numpy as np
import pytest

from pipeline.device.parameters import NOMINAL, TABLE1
from pipeline.models.analytical.bifurcation import (
    bistable_from,
    branch_through,
    characteristics,
    equilibrium_diagram,
    over_force,
    over_screw,
    over_voltage,
    switching_voltage,
    with_screw_height,
)
from pipeline.models.analytical.full_order import rest_state
from pipeline.models.analytical.statics import equilibria, static_path, unactuated_path
from pipeline.numerics.continuation import Branch

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


def _distance(branches: list[Branch], z_b: float, q: float, phi: float) -> float:
    """From an equilibrium to the nearest drawn one: chords in (z_b over 10 mm, q over 10 mm, φ)."""
    target, nearest = np.array([1e2 * z_b, 1e2 * q, phi]), np.inf
    for branch in branches:
        x = np.column_stack([1e2 * branch.parameter, branch.y * [1e2, 1.0]])
        along = np.diff(x, axis=0)
        share = ((target - x[:-1]) * along).sum(axis=1) / np.maximum((along**2).sum(axis=1), 1e-300)
        feet = x[:-1] + np.clip(share, 0.0, 1.0)[:, None] * along
        nearest = min(nearest, float(np.min(np.linalg.norm(feet - target, axis=1))))
    return nearest


@pytest.mark.parametrize("count", [5, pytest.param(200, marks=pytest.mark.long)])
def test_every_equilibrium_that_dense_starts_find_lies_on_a_drawn_branch(count: int) -> None:
    rng, names = np.random.default_rng(3), ("E", "l", "left.Y", "right.Y", "left.l0", "right.l0", "left.e_z")
    for _ in range(count):
        drawn = (NOMINAL, TABLE1)[rng.integers(2)]
        joint = drawn.with_values({name: drawn.value(name) * (1.0 + 0.03 * rng.normal()) for name in names})
        state = np.array([(0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (1.0, 1.0)][rng.integers(4)])
        v = 3000.0 * rng.uniform(0.3, 1.0) * state
        diagram = equilibrium_diagram(over_screw(joint, v), (0.0, 0.01))
        for z_b in rng.uniform(0.0, 0.01, 3):
            for found in equilibria(with_screw_height(joint, z_b), v):
                assert _distance(diagram, z_b, found.q, found.phi) < 2e-3
