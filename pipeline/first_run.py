"""A first run compiles the kernels of later stages in a second process, while the first one reads and differentiates.

Both look into the same cache, and `pipeline.compiled` lets only one of them compile a kernel. What is compiled is what
the calls below need; a kernel that they leave out is compiled when it is called.
"""

import fcntl
import os
import subprocess
import tempfile
from contextlib import suppress
from typing import Any

import numpy as np

from pipeline.child_processes import isolated
from pipeline.compiled import cache_folder, is_cached, is_prepared
from pipeline.machine import KERNELS

_PROGRAM = (
    "from pipeline.machine import settle_machine; settle_machine(); "
    "from pipeline.first_run import compile_kernels; compile_kernels()"
)
_started: list["subprocess.Popen[bytes]"] = []


def compile_ahead() -> None:
    """Start the second process, which ends with this one, unless the kernels are there or only one processor is."""
    from pipeline.joint.condensed_curves import curves_at
    from pipeline.joint.sensitivity import integrate_sensitivities

    if (
        _started
        or _processors() < 2
        or all(is_cached(each) or is_prepared(each) for each in (curves_at, integrate_sensitivities))
    ):
        return
    nowhere, program = subprocess.DEVNULL, f"from pipeline.child_processes import end_with; end_with({os.getpid()}); "
    child = subprocess.Popen(isolated(program + _PROGRAM), stdin=nowhere, stdout=nowhere, stderr=nowhere)
    _started.append(child)


def _processors() -> int:
    """Processors that this process may use; where the system does not say (macOS), all that there are."""
    allowed = getattr(os, "sched_getaffinity", None)
    return len(allowed(0)) if allowed else os.cpu_count() or 1


def compile_kernels() -> None:
    """Call, on next to no data, what models need, in the order of a run; one process at a time."""
    from pipeline.joint.condensed_curves import curves_at

    lock = os.open(cache_folder(curves_at) / "first_run.lock", os.O_RDWR | os.O_CREAT | os.O_CLOEXEC, 0o666)
    with suppress(BlockingIOError):
        fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        _hybrid()
        _without_parameter_set()
        _analytical()
        _measured()


def compile_all() -> None:
    """Call, on next to no data, what any command needs: models, the virtual rig, controllers."""
    compile_kernels()
    _rig()
    _control()


def write_prepared() -> None:
    """Write the kernels that come with the package anew, in a process that finds no compiled ones."""
    program = (
        "from pipeline.prepared_kernels import PREPARED, write; "
        "from pipeline.first_run import compile_all; write(PREPARED, compile_all)"
    )
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run(isolated(program), check=True, env=os.environ | {KERNELS: folder})


def _hybrid() -> None:
    from pipeline.joint.condensed_curves import static_curves
    from pipeline.joint.condensed_parameters import constants, instruments, nominal_deviations, static_slope_ratio
    from pipeline.joint.condensed_runs import run_joints
    from pipeline.joint.condensed_sensitivity import Driven, sensitivities
    from pipeline.joint.condensed_statics import substeps
    from pipeline.joint.driving_voltages import DrivingVoltages
    from pipeline.joint.parameters import NOMINAL

    k = constants(NOMINAL, nominal_deviations(), static_slope_ratio(NOMINAL))
    basis, weights, dt = np.array([-0.01, 0.01, 0.01]), np.zeros((9, 3)), 0.01
    substeps(k, basis, weights, dt)
    u = np.zeros((2, 5, 2))
    seen = instruments(np.zeros(len(nominal_deviations())))
    for shape in ((2, 2), (3, 10, 2)):
        u = DrivingVoltages(np.zeros(shape), dt).squared(1, seen, 1.0)[None]
    for joints in (1, 2):
        run_joints(
            np.tile(k, (joints, 1)), np.tile(weights, (joints, 1, 1)), basis, u, np.zeros(joints, dtype=np.int64),
            np.zeros(joints), np.zeros(2), np.zeros(u.shape[1]),
            np.zeros((u.shape[1] - 1) // 2 + 1), dt, 1, 0.05, 1.0,
        )  # fmt: skip
    driven = Driven(u[0], np.zeros((4, u.shape[1], 2)), np.zeros(0), np.zeros(0), np.zeros(2))
    sensitivities(k, basis, weights, np.abs(k), np.ones(len(weights)), 0.0, driven, dt, 1, 0.05, 1.0)
    static_curves(np.zeros(2), k, basis, weights)


def _without_parameter_set() -> None:
    from pipeline.baselines.narx import NarxEquation, NarxStructure, narx_run
    from pipeline.baselines.polynomial_dynamics import PolynomialDynamics, free_run
    from pipeline.solvers.lagged_free_run import lagged_rbf_run

    v = np.zeros((3, 2))
    lagged_rbf_run(v, True, 0.01, 1, (0.0, 0.0), np.zeros(2), np.zeros((2, 4)), 1.0, 1.0, (-1.0, 1.0))
    still = PolynomialDynamics(np.zeros((1, 8), dtype=np.int64), np.zeros((2, 1)), np.ones(8), 0.0, True, -1.0, 1.0)
    free_run(still, v, 0.01, 0.0, 0.0)
    structure = NarxStructure(inputs=2, increments=1, input_lags=1, degree=1)
    equation = NarxEquation(structure, np.zeros((1, 4), dtype=np.int64), np.zeros(1), np.ones(4), 0.01, True, -1.0, 1.0)
    narx_run(equation, v, 0.0, 0.0)


def _analytical() -> None:
    from pipeline.joint.equilibria import tip_values
    from pipeline.joint.full_order import rest_state, simulate
    from pipeline.joint.parameters import NOMINAL
    from pipeline.joint.reduced_order import friction_state, maxwell_strains
    from pipeline.joint.reduction import reduce_joint
    from pipeline.joint.sensitivity import state_sensitivities
    from pipeline.solvers.stiff import STATES

    t, v = np.array([0.0, 1e-4]), np.zeros((2, 2))
    simulate(NOMINAL, t, v, rest_state(NOMINAL, 0.001, 0.001, v[0]))
    tip_values(reduce_joint(NOMINAL).path.qm[0], NOMINAL.vector())
    friction_state(np.zeros(2), 1.0)
    maxwell_strains(np.ones((2, 2)), 1.0, np.ones(2))
    still: Any = np.zeros((2, STATES))
    points = np.tile(NOMINAL.vector(), (2, 1))
    state_sensitivities(t, v, still, still, points, np.ones(1), np.zeros((STATES, 1)))


def _measured() -> None:
    """What looks at measured motions: differentiation, and the paper's search for its lag."""
    from pipeline.identification.lag_search import pair_products
    from pipeline.identification.rbf import basis_values
    from pipeline.numerics.lag import first_order_lag
    from pipeline.signals.differentiate import differentiate

    samples = np.sin(0.1 * np.arange(40.0)) + 0.01 * (np.arange(40) % 3)
    differentiate(samples, 0.001)
    first_order_lag(samples, 0.01, 1.0)
    pair_products(basis_values(samples, np.zeros(2), 1.0), 0, 1, np.zeros((1, 3)))


def _rig() -> None:
    from pipeline.rig.bench import Bench, record
    from pipeline.rig.controllers import played
    from pipeline.rig.joint import potential, rest, tip_displacement
    from pipeline.rig.loop import Scenario, run_loop
    from pipeline.rig.parameters import nominal

    p, bench = nominal(), Bench(rate=2000.0)
    t, x = bench.clock(0.002), rest(p, side=1)
    record(p, bench, t, np.zeros((t.size, 2)), np.random.default_rng(1))
    potential(p, x, np.zeros(2))
    tip_displacement(p, x)
    run_loop(p, Bench(), Scenario(np.zeros(1), np.zeros(1), 0.002), played(t, np.zeros((t.size, 2))))


def _control() -> None:
    from pipeline.control.controller import begin_control, closed_on_model, control
    from pipeline.control.design import Settings, condensed_joint_law, design
    from pipeline.control.law import CONTROLLER_STATE
    from pipeline.control.plant import plant_of
    from pipeline.joint.condensed_parameters import static_slope_ratio
    from pipeline.joint.condensed_problem import CondensedJoint
    from pipeline.joint.parameters import NOMINAL
    from pipeline.models.hybrid import HybridModel

    joint = CondensedJoint(NOMINAL, np.array([-0.02, 0.01, 0.008]), 0, 3000.0, static_slope_ratio(NOMINAL))
    theta, state = joint.start(), np.zeros(CONTROLLER_STATE)
    plant = plant_of(HybridModel(joint, theta, np.eye(theta.size), np.eye(theta.size)))
    law = design(plant, Settings(3000.0, (0.003, 0.003)))
    begin_control(0.0, law, state)
    control(state, 0.0, 0.0, law, np.zeros(2))
    closed_on_model(law, condensed_joint_law(plant, (0.003, 0.003)), -0.01, np.zeros(2))


if __name__ == "__main__":
    write_prepared()
