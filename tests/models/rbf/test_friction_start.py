"""Friction from which a fit starts: the accelerations tell its lengths and forces, dry and over a long way."""

from dataclasses import replace

import numpy as np
import pytest

from pipeline.models.rbf.candidates import FRICTION
from pipeline.models.rbf.dynamics import slid
from pipeline.models.rbf.start import SLIP_LENGTHS, starting_joint
from pipeline.models.rbf.structure import JointStructure
from pipeline.signals.log import Log

PLAIN = JointStructure(
    5, rates=(), shape_elements=0, slips=0, arc=False, force="polynomial", constant_damping=True, constant_gain=True
)


def log(forces: dict[float, float]) -> Log:
    """A mass on a spring of 100 1/s² along a given path, with friction of these forces [1/s²] by length."""
    t = 0.01 * np.arange(2000)
    parts = [(0.5, 1.3, 0.0), (0.3, 3.1, 1.0), (0.2, 6.7, 2.0)]
    q = sum(a * np.sin(w * t + p) for a, w, p in parts)
    qdot = sum(a * w * np.cos(w * t + p) for a, w, p in parts)
    qddot = -sum(a * w**2 * np.sin(w * t + p) for a, w, p in parts)
    half = 0.5 * np.ptp(q)
    friction = half * sum(force * slid(q / half, length) for length, force in forces.items())
    v = (qddot + 100.0 * q + 4.0 * qdot + friction) / 50.0
    return Log(t, q, qdot, qddot, v[:, None], np.ones(t.size, dtype=bool))


@pytest.mark.parametrize("planted", [{0.01: 8.0, 1.0: 20.0}, {0.03: 6.0, 0.3: 15.0, 1.0: 9.0}])
def test_several_states_start_at_the_lengths_and_forces_of_the_log(planted):
    p, start = starting_joint([log(planted)], replace(PLAIN, **FRICTION["maxwell-slip"]), "linear", centred=False)
    started = zip(np.exp(start[p.slices["slip_length"]]), np.exp(start[p.slices["slip_force"]]), strict=True)
    near = {min(SLIP_LENGTHS, key=lambda length: abs(length - reached)): force for reached, force in started}
    assert len(near) == 3
    for length, force in planted.items():
        assert near[length] == pytest.approx(force, rel=0.1)


@pytest.mark.parametrize(("planted", "length"), [({0.01: 8.0}, 0.01), ({1.0: 20.0}, 1.0), ({}, 0.01)])
def test_a_single_state_is_dry_unless_the_log_shows_a_long_way(planted, length):
    p, start = starting_joint([log(planted)], replace(PLAIN, **FRICTION["coulomb"]), "linear", centred=False)
    assert np.exp(start[p.slices["slip_length"]]) == pytest.approx([length])
