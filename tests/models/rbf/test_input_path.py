import numpy as np
import pytest
from scipy.integrate import simpson, solve_ivp

from pipeline.models.rbf.model import RbfModel
from pipeline.models.rbf.parameter_layout import ParameterLayout
from pipeline.models.rbf.problem import JointProblem
from pipeline.models.rbf.structure import JointScales, JointStructure, drive_at_nodes
from pipeline.signals.log import Log

INTERVAL = 0.1


@pytest.mark.parametrize("squared", [False, True])
@pytest.mark.parametrize("steps", [1, 3])
def test_steps_lose_nothing_of_the_finer_record_wherever_a_pulse_begins(steps, squared):
    """By Simpson's rule, as Runge-Kutta integrates, the inputs or their squares have the area that the record has."""
    fine, power = 0.7 * np.arange(200) / 5.0, 2 if squared else 1
    for edge in range(50, 60):
        v = np.where((np.arange(200) >= edge) & (np.arange(200) < 100), 3.0, 0.0)
        drive = drive_at_nodes(v.reshape(40, 5, 1), 0.7, steps, "record", squared=squared)[:, 0]
        acting = np.abs(drive) * drive if squared else drive
        area = simpson(acting, dx=0.7 / (2 * steps))
        assert area == pytest.approx(np.trapezoid(v**power, fine))
    ramp = drive_at_nodes(fine.reshape(40, 5, 1), 0.7, steps, "record")[:, 0]
    assert ramp[2:-2] == pytest.approx(0.7 / (2 * steps) * np.arange(len(ramp))[2:-2])


@pytest.mark.parametrize("squared", [False, True])
def test_a_pulse_moves_a_mass_as_far_as_the_record_does_wherever_it_begins(squared):
    """Velocity and displacement of a free mass by Runge-Kutta are the record's first and second integral."""
    for edge in range(50, 60):
        v = np.where((np.arange(200) >= edge) & (np.arange(200) < 100), 3.0, 0.0)
        nodes = drive_at_nodes(v.reshape(20, 10, 1), 1.0, 1, "record", squared=squared)[:, 0]
        acting = np.sign(nodes) * np.abs(nodes) ** (1 + squared)
        first, middle, last = acting[:-2:2], acting[1::2], acting[2::2]
        speeds = np.cumsum(first + 4.0 * middle + last) / 6.0
        moved = np.sum(speeds[:-1]) + np.sum(first / 6.0 + middle / 3.0)
        force = v[:191] ** (1 + squared)
        exact = np.append(0.0, np.cumsum(0.05 * (force[1:] + force[:-1])))[:-1]
        assert moved == pytest.approx(np.sum(0.1 * exact + 0.01 * (force[:-1] / 3.0 + force[1:] / 6.0)))


def mass(**changes):
    """A free mass with constant damping and gain, one held input."""
    structure = JointStructure(
        4, rates=(), shape_elements=0, slips=0, arc=False, force="offset", constant_damping=True, constant_gain=True,
        **changes,
    )  # fmt: skip
    p = ParameterLayout(structure, JointScales(0.0, 1.0, 1.0, 10.0), "linear", (0,))
    theta = np.zeros(p.count)
    theta[p.slices["damping"]], theta[p.slices["input0"]] = np.log(0.7), 3.0
    if p.structure.input_lag:
        theta[p.slices["input_lag"]] = np.log(0.3)
    return RbfModel(p, theta, *np.zeros((2, p.count, 1)))


@pytest.mark.parametrize("rest_at_zero", [False, True])
def test_a_held_input_behind_a_lag_moves_a_mass_as_an_integrator_says(rest_at_zero):
    rng, t = np.random.default_rng(1), INTERVAL * np.arange(30)
    v = rng.uniform(-0.5, 1.0, (30, 1))
    model = mass(hold="zero", input_lag=True, rest_at_zero=rest_at_zero)
    run = model.simulate(t, v, 0.0, 0.0)
    state = np.array([0.0, 0.0, 0.0 if rest_at_zero else v[0, 0]])
    for n in range(29):
        step = solve_ivp(
            lambda _, y, n=n: [y[1], 3.0 * y[2] - 0.7 * y[1], (v[n, 0] - y[2]) / 0.3],
            (0.0, INTERVAL), state, rtol=1e-9, atol=1e-12,
        )  # fmt: skip
        state = step.y[:, -1]
        assert run.q[n + 1] == pytest.approx(state[0], abs=2e-5)


def test_an_effect_behind_a_lag_moves_a_mass_as_an_integrator_says():
    """Heat by the square of an input of both signs, which drops where the input crosses zero only behind the lag."""
    rng, t = np.random.default_rng(2), INTERVAL * np.arange(30)
    v = rng.uniform(-1.0, 1.0, (30, 1))
    held = mass(hold="zero", input_lag=True, effect_lags=True, rest_at_zero=True)
    p = ParameterLayout(held.parameters.structure, held.parameters.scales, "squared", (1,))
    theta = np.zeros(p.count)
    theta[p.slices["damping"]], theta[p.slices["input0"]], theta[p.slices["input_lag"]] = np.log([0.7, 3.0, 0.3])
    run = RbfModel(p, theta, *np.zeros((2, p.count, 1))).simulate(t, v, 0.0, 0.0)
    state = np.zeros(3)
    for n in range(29):
        step = solve_ivp(
            lambda _, y, n=n: [y[1], 3.0 * y[2] - 0.7 * y[1], (v[n, 0] ** 2 - y[2]) / 0.3],
            (0.0, INTERVAL), state, rtol=1e-9, atol=1e-12,
        )  # fmt: skip
        state = step.y[:, -1]
        assert run.q[n + 1] == pytest.approx(state[0], abs=2e-5)


@pytest.mark.parametrize("every", [2, 3])
def test_a_thinned_drive_neither_leads_nor_lags(every):
    """A ramp stays itself under a centred average; a delay shifts it whether it is thinned or not."""
    t = 0.01 * np.arange(400)
    log = Log(t, np.sin(t), np.cos(t), -np.sin(t), t[:, None], np.ones(len(t), dtype=bool))
    for model, delay in ((mass(), 0.0), (mass(input_delay=True), 0.05)):
        (seen,) = JointProblem(model.parameters, [log], thinning=every).logs
        assert seen.every == every
        nodes = seen.at_nodes(model.parameters, 1, delay)[20:-20, 0]
        assert nodes == pytest.approx((np.arange(len(nodes)) + 20) * seen.interval / 2 - delay)


def test_the_measured_velocity_is_part_of_the_residual_and_vanishes_for_the_truth():
    model = mass(hold="linear")
    t = 0.02 * np.arange(300)
    v = np.sin(3.0 * t)[:, None]
    run, rng = model.simulate(t, v, 0.0, 0.0), np.random.default_rng(1)
    valid = np.ones(len(t), dtype=bool)
    valid[100:110] = False
    coarse = run.q + 0.02 * rng.standard_normal(len(t))
    log = Log(t, coarse, run.qdot, run.qddot, v, valid, velocity=np.where(valid, run.qdot, np.nan))
    problem = JointProblem(model.parameters, [log])
    error, rows = problem.residual(model.theta, 0.0), problem.of_displacement
    assert (np.count_nonzero(rows), np.count_nonzero(~rows)) == (290, 299 - 11)
    assert np.abs(error[~rows]).max() < 1e-4 < 0.01 < error[rows].std()
    nudged = model.theta + 1e-6 * np.eye(len(model.theta))[-1]
    same, jacobian = problem.jacobian(model.theta, 0.0)
    assert same == pytest.approx(error)
    assert jacobian[:, -1] == pytest.approx((problem.residual(nudged, 0.0) - error) / 1e-6, abs=1e-5)
