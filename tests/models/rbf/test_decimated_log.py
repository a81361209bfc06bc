"""A log that was low-pass filtered to its samples is followed as it was before, and sides may differ in strength."""

from dataclasses import replace

import numpy as np
import pytest

from pipeline.models.rbf.prior import joint_prior
from pipeline.models.rbf.problem import JointProblem
from pipeline.models.rbf.start import data_scales
from pipeline.numerics.arrays import FloatArray
from pipeline.numerics.metrics import rms
from pipeline.signals.log import Log
from pipeline.signals.resampling import filtered_samples
from tests.models.rbf.test_evidence_search import double_well

RATIO = 20
INTERVAL = 0.04
"""Sample interval [s]: a thirteenth of a period in the wells."""


def driven(t: FloatArray) -> FloatArray:
    """Voltages (N, 2): pulses on either side in turn."""
    v = np.zeros((len(t), 2))
    for number, at in enumerate(np.arange(0.4, t[-1] - 1.0, 1.3)):
        v[(t >= at) & (t < at + 0.35), number % 2] = 2900.0
    return v


@pytest.mark.parametrize("gain", [3.0, 1.0])
def test_the_truth_leaves_little_of_what_the_filter_changed(gain):
    truth = double_well("viscous")
    count = 400
    t = INTERVAL / RATIO * np.arange(RATIO * count + 1)
    run = truth.simulate(t, driven(t), -0.012, 0.0)
    filtered = filtered_samples(np.column_stack((run.q, run.qdot, run.qddot)), RATIO)[:count]
    rows = slice(None, RATIO * count, RATIO)
    fine = driven(t)[:-1].reshape(count, RATIO, 2)
    log = Log(INTERVAL * np.arange(count), *filtered.T, fine[:, 0], fine=fine)
    p = replace(truth.parameters, structure=replace(truth.parameters.structure, hold="record"))
    left = JointProblem(p, [log], step=0.1).residual(truth.theta, gain)
    assert rms(left) < 0.25 * rms(log.q - run.q[rows]) / p.scales.half


def vibration(noise: float) -> Log:
    """A vibration of 30 rad/s that decays within a second of ten; its accelerations are noisy."""
    t = 0.01 * np.arange(1001.0)
    x, qdot, qddot = (
        np.real(rate * np.exp((30.0j - 1.0) * t)) for rate in (-1j, -1j * (30j - 1), -1j * (30j - 1) ** 2)
    )
    return Log(t, x, qdot, qddot + noise * np.random.default_rng(1).standard_normal(t.size), np.ones((t.size, 1)))


@pytest.mark.parametrize("noise", [0.0, 100.0])
def test_steps_follow_the_vibrations_of_a_joint_however_long_it_rests_and_no_noise(noise):
    scales = data_scales([vibration(noise)], centred=True)
    assert replace(double_well("viscous").parameters, scales=scales).pace == pytest.approx(30.0, rel=0.03)
    assert scales.frequency < 0.75 * 30.0


def test_steps_of_another_device_follow_its_frequency_scale():
    scales = data_scales([vibration(0.0)], centred=True)
    assert replace(double_well("viscous").parameters, scales=scales, signs=(1,)).pace == scales.frequency


def test_one_side_may_be_stronger_than_the_other():
    p = double_well("viscous").parameters
    start = np.zeros(p.count)
    free, alike = (joint_prior(p, start, symmetry) for symmetry in (None, 0.03))
    stronger, bent = start.copy(), start.copy()
    stronger[p.slices["input0"]] += 0.5
    bent[p.slices["input0"]] += np.linspace(-0.5, 0.5, p.structure.basis_functions)

    def cost(prior, theta):
        return np.sum(prior.residual(theta) ** 2) - np.sum(prior.residual(start) ** 2)

    assert cost(alike, stronger) == pytest.approx(cost(free, stronger))
    assert cost(alike, bent) > cost(free, bent) + 100.0
