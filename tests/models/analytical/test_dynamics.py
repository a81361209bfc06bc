"""Full-order and reduced motion: against SciPy, the energy balance, and each other."""

import numpy as np
import pytest
from energy_balance import energy_balance
from scipy.integrate import solve_ivp

from pipeline.device.parameters import NOMINAL
from pipeline.generated import analytical_joint as kernels
from pipeline.models.analytical.full_order import (
    rest_state,
    simulate,
)
from pipeline.models.analytical.reduced_order import (
    maxwell_strains,
    pulse_sequence,
    reduce_joint,
    simulate_reduced,
)
from pipeline.models.analytical.statics import equilibria, unactuated_path
from pipeline.numerics.arrays import FloatArray

UNEQUAL = NOMINAL.with_values({"left.b": 23.2e-3, "right.Y": 1.15e6, "right.eps_r": 2.9, "kappa0": 0.02})
START = float(equilibria(UNEQUAL, np.zeros(2))[0].q)


def test_full_order_motion_agrees_with_lsoda() -> None:
    t, v = pulse_sequence(count=1, pulse=0.1, pause=0.06, dt=0.01)
    force = 0.02 * np.sin(20.0 * t)
    start, p = rest_state(UNEQUAL, START, 0.0, v[0]), UNEQUAL.vector()
    mass, tau, z_dot = np.empty((4, 4)), np.empty(4), np.empty(3)

    def derivative(time: float, x: FloatArray) -> FloatArray:
        now = np.array([np.interp(time, t, v[:, side]) for side in range(2)])
        load = np.array([np.interp(time, t, force)])
        x = np.ascontiguousarray(x)  # the solver also passes columns of a matrix
        kernels.dynamics(x[:4], x[4:8], x[8:], now**2, load, p, mass, tau, z_dot)
        return np.concatenate([x[4:8], np.linalg.solve(mass, tau), z_dot])

    truth = solve_ivp(derivative, (0.0, t[-1]), start, "LSODA", t, rtol=1e-7, atol=1e-9, max_step=1e-2)
    motion = simulate(UNEQUAL, t, v, start, force=force, tolerance=1e-7)
    q = truth.y[:3].T @ UNEQUAL.l ** np.arange(2, 5)
    assert np.ptp(q) > 0.01
    assert motion.q == pytest.approx(q, abs=1e-7)
    assert motion.z[:, :2] == pytest.approx(truth.y[8:10].T, abs=1e-6)
    # A step away from the kinks of the input, the acceleration is the slope of the velocity.
    assert motion.qddot[0] == pytest.approx(0.0, abs=1e-6)


def test_energy_balance_closes() -> None:
    joint = UNEQUAL.with_values({"F_c": 2e-3, "s_c": 5e-4})
    t = np.arange(0.0, 3.0, 2e-4)
    v = 3000.0 * np.clip(np.stack([np.sin(5.0 * t), -np.sin(5.0 * t)], axis=1), 0.0, None) ** 2
    force = 0.03 * np.sin(15.0 * t)
    motion = simulate(joint, t, v, rest_state(joint, START, 0.0, v[0]), force=force, tolerance=1e-7)
    balance = energy_balance(joint, motion, v, force)
    assert balance.dissipated[-1] > 1e-3 and np.all(np.diff(balance.dissipated) >= 0.0)
    assert np.abs(balance.defect).max() < 2e-4 * balance.dissipated[-1]


def test_divergence_is_reported_not_raised() -> None:
    t = np.linspace(0.0, 1.0, 101)
    push = np.where(t > 0.3, 5.0, 0.0)
    motion = simulate(NOMINAL, t, np.zeros((t.size, 2)), rest_state(NOMINAL, 0.011, 0.0, np.zeros(2)), force=push)
    assert motion.diverged_at_s is not None and 0.3 < motion.diverged_at_s < 0.5
    assert np.isnan(motion.q[t > motion.diverged_at_s]).all() and np.isfinite(motion.q[t < motion.diverged_at_s]).all()


def test_friction_stops_the_ring_down() -> None:
    t = np.linspace(0.0, 4.0, 401)
    v = np.zeros((t.size, 2))
    rough = NOMINAL.with_values({"F_c": 5e-3})
    ends = [np.ptp(simulate(joint, t, v, rest_state(joint, 0.014, 0.0, v[0])).q[-60:]) for joint in (NOMINAL, rough)]
    assert ends[1] < 0.2 * ends[0]


def test_reduced_model_equals_the_full_one_when_quasi_static() -> None:
    t = np.linspace(0.0, 20.0, 2001)
    force = 0.02 * np.sin(0.1 * np.pi * t)
    v = np.zeros((t.size, 2))
    full = simulate(UNEQUAL, t, v, rest_state(UNEQUAL, START, 0.0, v[0]), force=force)
    reduced = simulate_reduced(reduce_joint(UNEQUAL), t, v, START, 0.0, force=force)
    assert reduced.q == pytest.approx(full.q, abs=2e-5)


def test_maxwell_strain_of_a_ramp_is_the_exact_exponential() -> None:
    t = np.linspace(0.0, 1.0, 101)
    rate = np.array([3.0, 7.0])
    strains = maxwell_strains(np.stack([0.1 * t, -0.2 * t], axis=1), 0.01, rate)
    assert strains[:, 0] == pytest.approx(0.1 / 3.0 * (1 - np.exp(-3.0 * t)), abs=1e-12)
    assert strains[:, 1] == pytest.approx(-0.2 / 7.0 * (1 - np.exp(-7.0 * t)), abs=1e-12)


def test_reduced_mass_contains_the_tip_mass() -> None:
    reduced = reduce_joint(NOMINAL)
    mass = reduced.evaluate(reduced.q)[0][:, 0]
    assert (mass > NOMINAL.m).all() and (mass < 1.3 * NOMINAL.m).all()
    path = unactuated_path(NOMINAL)
    value, slope = reduced.evaluate(path.q)
    assert value[:, 2] == pytest.approx(path.force, abs=1e-9)
    assert slope[:, 2] == pytest.approx(path.stiffness, rel=1e-4, abs=1e-3)
