"""Compile the kernels once per installation, by calls on next to no data; `debist warmup` does it at set-up.

A kernel that these calls leave out is compiled when a run first calls it, which costs time and nothing else.
"""

import gc
import time
from collections.abc import Callable
from typing import Any

import numpy as np

from ..device.parameters import NOMINAL
from ..system.worker_pool import in_processes

COST = 30.0
"""Processor time [s] that a first run spends on compilation, roughly."""
_DT = 0.01
"""A sample interval [s], as of most logs."""


def warm_up(jobs: int, on_progress: Callable[[float], None] | None = None) -> float:
    """Compile what any command needs in `jobs` processes; returns the wall time [s].

    `on_progress` gets the share of the kernels that are compiled.
    """
    began = time.perf_counter()
    for done, _ in enumerate(in_processes(_compile, range(len(GROUPS)), jobs), start=1):
        if on_progress is not None:
            on_progress(done / len(GROUPS))
    return time.perf_counter() - began


def _compile(group: int) -> None:
    from ..numerics.compiled import keep_kernels

    gc.disable()  # a compilation makes millions of objects that stay; looking through them takes a fifth of its time
    for call in GROUPS[group]:
        call()
        keep_kernels()  # now: a set-up that is interrupted keeps what it has


def _hybrid() -> None:
    from ..models.hybrid.log_reading import DrivingVoltages, Instruments
    from ..models.hybrid.parameters import constants, nominal_deviations, static_slope_ratio
    from ..models.hybrid.runs import Driving, Followed, JointCoefficients, Stepping, run_joints
    from ..models.hybrid.sensitivity import sensitivities
    from ..models.hybrid.statics import static_curves, substeps
    from ..models.hybrid.variational import Driven

    k = constants(NOMINAL, nominal_deviations(), static_slope_ratio(NOMINAL))
    basis = np.array([-0.01, 0.01, 0.01])
    weights = np.zeros((9, 3))
    substeps(k, basis, weights, _DT)
    undisturbed = Instruments(offset=0.0, delay=0.0, charging=1e-3, probe=np.zeros(2))
    for shape in ((2, 2), (3, 10, 2)):
        u = DrivingVoltages(np.zeros(shape), _DT).squared(1, undisturbed, 1.0)[None]
    stepping = Stepping(_DT, 1, 0.05, 1.0)
    for joints in (1, 2):
        run_joints(
            JointCoefficients(np.tile(k, (joints, 1)), np.tile(weights, (joints, 1, 1)), basis),
            Driving(u, np.zeros(joints, dtype=np.int64), np.zeros(joints), np.zeros(3)),
            Followed(np.zeros(u.shape[1]), np.zeros((u.shape[1] - 1) // 2 + 1)),
            stepping,
        )
    driven = Driven(u[0], np.zeros((4, u.shape[1], 2)), np.zeros(0), np.zeros(0), np.zeros(3))
    sensitivities(JointCoefficients(k, weights, basis), np.abs(k), np.ones(len(weights)), 0.0, driven, stepping)
    static_curves(np.zeros(2), k, basis, weights)


def _without_parameter_set() -> None:
    from ..models.narx import NarxModel
    from ..models.paper.model import RbfPaperModel
    from ..models.polynomial_dynamics import PolynomialDynamics, free_run

    v = np.zeros((3, 2))
    paper = RbfPaperModel(centres=np.array([0.0, 1.0]), smoothing=1.0, weights=np.zeros((4, 2)), lag_s=1.0)
    paper.simulate(_DT * np.arange(3.0), v, 0.0, 0.0)
    still = PolynomialDynamics(
        exponents=np.zeros((1, 7), dtype=np.int64),
        coefficients=np.zeros((2, 1)),
        scales=np.ones(7),
        lags=(),
        squared=True,
        low=-1.0,
        high=1.0,
    )
    free_run(still, v, _DT, 0.0, 0.0)
    NarxModel(
        structure=np.array([1, 1, 1, 2]),
        exponents=np.zeros((1, 4), dtype=np.int64),
        coefficients=np.zeros(1),
        scales=np.ones(4),
        interval_s=_DT,
        inputs="squared",
        bounds=np.array([-1.0, 1.0]),
    ).run(v, np.zeros(1), 0.0)


def _network() -> None:
    from ..models.rbf.dynamics import Coefficients, basis_rows, no_sensitivities, slid
    from ..models.rbf.observed_run import Coupling, Drive, observed_run
    from ..models.rbf.structure import drive_at_nodes

    single = np.ones(1)
    two = np.zeros(2)
    curves = np.zeros((5, 5))
    joint = Coefficients(
        curves=curves,
        rates=single,
        slip_force=single,
        slip_length=single,
        inertia=two,
        centres=single,
        bend=1.0,
        low=-1.0,
        high=1.0,
        arm=two,
        drag=0.0,
        stops=np.zeros(0),
        ends=curves[:2],
        at_ends=two,
    )
    drive = Drive(np.zeros((3, 2)), np.zeros((0, 3, 2)), np.zeros(2), False)
    observed_run(joint, drive, Coupling(two, two, 0.0), (0.0, 0.0), _DT, 1, no_sensitivities())
    drive_at_nodes(np.zeros((2, 1, 1)), _DT, 1, "record")
    basis_rows(two, joint)
    slid(two, 1.0)


def _analytical() -> None:
    from ..models.analytical.full_order import rest_state, simulate
    from ..models.analytical.reduced_order import friction_state, maxwell_strains, reduce_joint
    from ..models.analytical.sensitivity import state_sensitivities
    from ..models.analytical.statics import tip_values
    from ..numerics.stiff import RITZ, STATES

    t = np.array([0.0, 1e-4])
    v = np.zeros((2, 2))
    simulate(NOMINAL, t, v, rest_state(NOMINAL, 0.001, 0.001, v[0]))
    reduce_joint(NOMINAL)
    tip_values(np.zeros(RITZ), NOMINAL.vector())
    friction_state(np.zeros(2), 1.0)
    maxwell_strains(np.ones((2, 2)), 1.0, np.ones(2))
    still: Any = np.zeros((2, STATES))
    state_sensitivities(t, v, still, still, np.tile(NOMINAL.vector(), (2, 1)), np.ones(1), np.zeros((STATES, 1)))


def _measured() -> None:
    """Compile the kernels for measured motions: differentiation, and the lag and basis of the paper."""
    from ..fitting.regression import basis_values
    from ..numerics.linear_filters import first_order_lag
    from ..signals.differentiate import differentiate

    samples = np.sin(0.1 * np.arange(40.0)) + _DT * (np.arange(40) % 3)
    differentiate(samples, 0.001)
    first_order_lag(samples, _DT, 1.0)
    basis_values(samples, np.zeros(2), 1.0)


def _rig() -> None:
    from ..rig.bench import Bench, record
    from ..rig.joint import potential, rest, tip_displacement
    from ..rig.loop import Scenario, played, run_loop
    from ..rig.parameters import nominal

    p = nominal()
    bench = Bench(rate=2000.0)
    t = bench.clock(0.002)
    x = rest(p, side=1)
    record(p, bench, t, np.zeros((t.size, 2)), np.random.default_rng(1))
    potential(p, x, np.zeros(2))
    tip_displacement(p, x)
    run_loop(p, Bench(), Scenario(np.zeros(1), np.zeros(1), 0.002), played(t, np.zeros((t.size, 2))))


def _control() -> None:
    from ..control.controller import begin_control, closed_on_model, control
    from ..control.design import Settings, condensed_joint_law, design
    from ..control.law import CONTROLLER_STATE
    from ..control.plant import plant_of
    from ..models.hybrid.model import HybridModel
    from ..models.hybrid.parameters import static_slope_ratio
    from ..models.hybrid.problem import CondensedJoint

    joint = CondensedJoint(NOMINAL, np.array([-0.02, 0.01, 0.008]), 0, 3000.0, static_slope_ratio(NOMINAL))
    theta = joint.start()
    state = np.zeros(CONTROLLER_STATE)
    plant = plant_of(HybridModel.of(joint, theta, np.eye(theta.size), np.eye(theta.size)))
    law = design(plant, Settings(3000.0, (0.003, 0.003)))
    begin_control(0.0, law, state)
    control(state, 0.0, 0.0, law, np.zeros(2))
    closed_on_model(law, condensed_joint_law(plant, (0.003, 0.003)), -0.01, np.zeros(2))


GROUPS = ((_hybrid, _control, _rig), (_analytical, _network, _without_parameter_set, _measured))
"""Groups of kernels, one process each, of about the same time; kernels that share others stand together."""
