"""What the instruments add to the truth, one error at a time."""

import numpy as np
import pytest

from pipeline.numerics.linear_filters import first_order_lag
from pipeline.rig.bench import Bench, Laser, record
from pipeline.rig.joint import simulate
from pipeline.rig.parameters import nominal

T = np.arange(30_000) / 30_000.0
IDEAL = Laser(noise=0.0, resolution=1e-12, linearity=0.0, hum=0.0)


def test_laser_errors_have_their_sizes() -> None:
    q = 0.02 * np.sin(2 * np.pi * T)
    rng = np.random.default_rng(1)
    np.testing.assert_allclose(IDEAL.read(T, q, rng), q, atol=1e-11)
    steps = Laser(noise=0.0, linearity=0.0, hum=0.0).read(T, q, rng) / 0.3e-6
    np.testing.assert_allclose(steps, np.round(steps), atol=1e-6)
    linearity = Laser(noise=0.0, resolution=1e-12, hum=0.0).read(T, q, rng) - q
    assert np.abs(linearity).max() == pytest.approx(4e-6, rel=0.05)
    same_place = np.interp(q[:7000], np.sort(q), linearity[np.argsort(q)])
    np.testing.assert_allclose(linearity[:7000], same_place, atol=1e-8)  # repeatable: a function of q alone
    noise = Laser(linearity=0.0, hum=0.0).read(T, q, rng) - q
    assert np.std(noise) == pytest.approx(1.5e-6, rel=0.03)
    assert np.abs(IDEAL.read(T, 2 * q, rng)).max() == pytest.approx(25e-3)


def test_membranes_charge_behind_their_electrodes_and_probes_see_the_converters() -> None:
    p, t = nominal(), np.arange(8000) / 4000.0
    u = np.zeros((t.size, 2))
    u[400:2000, 0] = 2900.0
    quick, slow = Bench(rate=4000.0), Bench(rate=4000.0, charging=20e-3)
    logs = [record(p, bench, t, u, np.random.default_rng(3)) for bench in (quick, slow)]
    np.testing.assert_array_equal(logs[0].v1, logs[1].v1)
    behind, _ = first_order_lag(logs[0].true_v1, t[1], 20e-3)
    lagged = np.column_stack([behind, np.zeros_like(behind)])
    np.testing.assert_allclose(logs[1].true_q, simulate(p, lagged, t[1], stride=2).q, atol=2e-6)
    assert np.abs(logs[1].true_q - logs[0].true_q).max() > 1e-3
