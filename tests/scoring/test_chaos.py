"""Chaos: the exponent against the variational equations, the distances against known ones."""

import numpy as np
import pytest

from pipeline.scoring.chaos import LEAST, lyapunov_exponent, parted_at, statistics, statistics_of_halves

INTERVAL, SUBSTEPS = 0.2, 8


def acceleration(x, p, u):
    return -0.3 * p + x - x**3 + u


def drive(seconds, amplitude):
    t = INTERVAL * np.arange(int(seconds / INTERVAL))
    return t, amplitude * np.cos(1.2 * t)[:, None]


def runge_kutta(slope, state, t, v):
    """States at the samples; the input is the cosine between them too."""
    amplitude, h, states = v[0, 0] / np.cos(1.2 * t[0]), INTERVAL / SUBSTEPS, []
    for start in t:
        states.append(state)
        for k in range(SUBSTEPS):
            now = start + k * h
            u = [amplitude * np.cos(1.2 * (now + share * h)) for share in (0.0, 0.5, 1.0)]
            a = slope(state, u[0])
            b = slope(state + h / 2 * a, u[1])
            c = slope(state + h / 2 * b, u[1])
            state = state + h / 6 * (a + 2 * b + 2 * c + slope(state + h * c, u[2]))
    return np.array(states)


def double_well(t, v, q0, qdot0):
    def slope(y, u):
        return np.array([y[1], acceleration(y[0], y[1], u)])

    return runge_kutta(slope, np.array([q0, qdot0]), t, v)


def simulate(t, v, q0, qdot0):
    return double_well(t, v, q0, qdot0)[:, 0]


def variational_exponent(t, v):
    """Growth of a tangent vector along the motion, by its own differential equation."""

    def slope(y, u):
        return np.array([y[1], acceleration(y[0], y[1], u), y[3], (1 - 3 * y[0] ** 2) * y[2] - 0.3 * y[3]])

    tangent = runge_kutta(slope, np.array([1.0, 0.0, 1.0, 0.0]), t, v)[:, 2:]
    return np.log(np.linalg.norm(tangent[-1])) / (t[-1] - t[0])


def test_the_exponent_of_a_driven_double_well_is_that_of_the_variational_equations():
    t, v = drive(400.0, 0.5)
    motion = double_well(t, v, 1.0, 0.0)
    found = lyapunov_exponent(simulate, t, v, motion[:, 0], motion[:, 1], 3.0)
    assert found == pytest.approx(variational_exponent(t, v), rel=0.2)
    assert found > 0.08


def test_a_calm_motion_has_no_exponent():
    t, v = drive(100.0, 0.15)
    motion = double_well(t, v, 1.0, 0.0)
    assert lyapunov_exponent(simulate, t, v, motion[:, 0], motion[:, 1], 3.0) is None
    assert parted_at(motion[:, 0], np.full(len(t), np.nan), 3.0) is None


def test_distances_of_known_motions():
    t = 0.01 * np.arange(8000)
    wide, narrow = np.linspace(-1.0, 1.0, 4000), np.linspace(-0.5, 0.5, 4000)
    assert statistics(wide, narrow, 0.01).histogram == pytest.approx(0.25 / 2.0, rel=1e-3)  # mean of |u/2| over 2
    slow, fast = np.sin(6.3 * t), np.sin(25.3 * t)
    assert statistics(slow, np.roll(slow, 37), 0.01).spectrum < 1e-2
    assert statistics(slow, fast, 0.01).spectrum == pytest.approx(np.sqrt(2.0), rel=0.05)
    assert statistics(slow, fast, 0.01).histogram < 1e-3
    assert statistics_of_halves(slow, 0.01).histogram < 1e-3


def test_masked_and_short_records():
    t = 0.01 * np.arange(2000)
    q = np.where((t > 5.0) & (t < 6.0), np.nan, np.sin(7.0 * t))
    assert statistics(q, np.sin(7.0 * t), 0.01).histogram < 0.02
    assert statistics(q[: LEAST - 1], q[: LEAST - 1], 0.01) is None
    assert statistics(np.zeros(500), np.zeros(500), 0.01) is None
    assert statistics(np.full(500, np.nan), np.zeros(500), 0.01) is None
