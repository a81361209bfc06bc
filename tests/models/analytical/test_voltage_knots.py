"""Voltages between the samples: straight lines that follow them, few of them, and the snap that they time."""

import numpy as np
import pytest

from pipeline.device.parameters import NOMINAL
from pipeline.models.analytical.model import AnalyticalModel
from pipeline.models.analytical.statics import equilibria
from pipeline.models.analytical.windows import BENT, voltage_knots

PARTS = 10
FINE = 1e-3 * np.arange(2000)
T = FINE[::PARTS]


def pulse(begin: float, *, lag: float = 2e-3, noise: float = 0.0) -> np.ndarray:
    """Voltages (N, r, 2) [V] of a pulse on the right membrane, 1 s long, behind an amplifier."""
    since = FINE - begin
    v = 3000.0 * (np.exp(-np.clip(since - 1.0, 0.0, None) / lag) - np.exp(-np.clip(since, 0.0, None) / lag))
    both = np.column_stack([np.zeros_like(v), v]) + noise * np.random.default_rng(0).standard_normal((v.size, 2))
    return both.reshape(T.size, PARTS, 2)


@pytest.mark.parametrize("noise", [0.0, 3.0])
def test_the_lines_follow_the_voltages_and_are_few(noise):
    v = pulse(0.2034, noise=noise)
    knots = voltage_knots(T, v)
    lines = np.column_stack([np.interp(FINE, knots.t, knots.v[:, side]) for side in range(2)])
    assert np.abs(lines - v.reshape(-1, 2))[: -PARTS + 1].max() <= BENT * np.abs(v).max()
    assert np.array_equal(knots.t[knots.rows], T)
    assert np.all(np.diff(knots.t) > 0.0)
    assert knots.t.size < T.size + 8 * PARTS


def test_a_snap_begins_where_the_pulse_does():
    model, v = AnalyticalModel(parameters=NOMINAL), pulse(0.2034)
    start = max(at.q for at in equilibria(NOMINAL, np.zeros(2)))
    exact = model.simulate(FINE, v.reshape(-1, 2), start, 0.0).q[::PARTS]
    span = np.ptp(exact)
    told = np.abs(model.simulate(T, v, start, 0.0).q - exact).max()
    samples_alone = np.abs(model.simulate(T, v[:, 0], start, 0.0).q - exact).max()
    assert span > 0.01 and told < 2e-3 * span < samples_alone
