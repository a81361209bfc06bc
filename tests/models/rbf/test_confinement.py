"""Extrapolation confines: a run of any parameters, state and input stays near the data, and rests there."""

import numpy as np
from hypothesis import example, given, settings, strategies as st

from pipeline.models.rbf.dynamics import POLYNOMIALS
from pipeline.models.rbf.model import RbfModel
from pipeline.models.rbf.observed_run import WALL
from pipeline.models.rbf.parameter_layout import OVERHANG, ParameterLayout
from pipeline.models.rbf.structure import JointScales, JointStructure

MIDDLE, HALF, LARGEST = 4e-3, 5e-3, 10.0
RESTS = 1.0 + 3.0 * OVERHANG + 0.15 + 1e-6
"""Half ranges within which a run without inputs ends: the reach of the curves, and what it takes to turn a force."""


def drawn(seed, force):
    """A model whose parameters are drawn at random, with a force that may lead away at both ends of the data."""
    structure = JointStructure(
        basis_functions=6, rates=(1.5,), shape_elements=0, slips=0, arc=False, force=force, constant_damping=True
    )
    p = ParameterLayout(structure, JointScales(MIDDLE, HALF, LARGEST, 50.0, 5.0), "squared", (1,))
    rng, (offset, scale) = np.random.default_rng(seed), p.dimensionless
    theta = offset + scale * rng.standard_normal(p.count)
    theta[p.slices["force"]] *= 3.0
    theta[p.slices["input_offset"]] = 0.0
    if force != "offset":
        theta[p.slices["force"].start + POLYNOMIALS - 1] = np.log(50.0) - rng.uniform(0.0, 20.0)
    return RbfModel(p, theta, np.zeros((p.count, 1)), np.zeros((p.count, 1)))


@settings(max_examples=20, deadline=None)
@given(
    seed=st.integers(0, 10**6), force=st.sampled_from(["curve", "polynomial", "offset"]), x=st.floats(-3.0, 3.0),
    speed=st.floats(-50.0, 50.0), drive=st.floats(0.0, 2.0),
)  # fmt: skip
@example(seed=117, force="offset", x=3.0, speed=0.0, drive=0.0)
def test_no_run_passes_the_wall_and_all_return_at_rest(seed, force, x, speed, drive):
    model, t = drawn(seed, force), 0.01 * np.arange(6000)
    v = np.where((t < 5.0) & (np.sin(7.0 * t) > 0.0), drive * LARGEST, 0.0)[:, None]
    run = model.simulate(t, v, MIDDLE + HALF * x, HALF * speed)
    assert run.status == "ok"
    away = np.abs(run.q - MIDDLE) / HALF
    assert away.max() <= WALL + 1e-9
    moves = np.abs(run.qdot[-500:]).max() > 1e-3 * HALF
    assert away[-1] <= RESTS or moves or away[-1] < away[-500]  # much damping lets it return slowly
