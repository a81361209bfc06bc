import numpy as np
import pytest
from scipy.integrate import solve_ivp

from pipeline.codegen.graph import trace
from pipeline.generated.terms import CONFINED_FORCE, STOP_FORCE
from pipeline.models.rbf.dynamics import basis_rows, free_rates, no_sensitivities
from pipeline.models.rbf.model import RbfModel
from pipeline.models.rbf.observed_run import Coupling, Drive, observed_run
from pipeline.models.rbf.parameter_layout import ParameterLayout
from pipeline.models.rbf.problem import JointProblem
from pipeline.models.rbf.structure import JointScales, JointStructure
from pipeline.numerics.arrays import bridged
from pipeline.signals.log import Log

SCALES = JointScales(middle=0.0, half=0.02, volts=3000.0, stiffness=50.0)


def parameters(**changes):
    structure = JointStructure(basis_functions=6, rates=(6.0, 0.2), shape_elements=1, slips=1, **changes)
    return ParameterLayout(structure, SCALES, "squared", (1, -1))


def double_well(p, rng, *, friction=1.0):
    """A parameter vector of a joint with wells near ±0.6, everything else drawn at random."""
    theta, at = 0.3 * rng.standard_normal(p.count), p.slices
    theta[at["force"]] = 0.0
    theta[at["force"]][1], theta[at["force"]][3] = 60.0, np.log(160.0)
    theta[at["damping"]] += np.log(0.5)
    for k in range(2):
        theta[at[f"input{k}"]] += np.log(20.0)
    theta[at["coupling0"]] = 4.0 + rng.standard_normal(6)
    theta[at["coupling1"]] = rng.standard_normal(6)
    theta[at["rate"]] = np.log([6.0, 2.0])
    theta[at["relaxation0"]] += np.log(20.0)
    theta[at["slip_force"]], theta[at["slip_length"]] = np.log(friction), np.log(0.02)
    theta[at["inertia"]], theta[at["inertia_centre"]] = np.log(0.2), 0.1
    theta[at["input_offset"]] = 0.002
    if p.structure.input_lag:
        theta[at["input_lag"]] = np.log(0.01)
    theta[at["input_bend"]] = 0.8
    return theta


def pulses(n, interval, rng):
    v, t = np.zeros((n, 2)), interval * np.arange(n)
    for start in np.arange(0.2, t[-1], 0.9):
        v[(t >= start) & (t < start + 0.5), rng.integers(2)] = rng.uniform(1000, 3000)
    return v


def record(p, theta, n=700, interval=0.01, seed=1):
    rng = np.random.default_rng(seed)
    v = pulses(n, interval, rng)
    u, du = p.inputs(v, interval, 1, theta)
    still = np.zeros(n)
    drive, free = Drive(u, du, u[0], p.held), Coupling(still, still, 0.0)
    states, _, valid = observed_run(p.coefficients(theta), drive, free, (0.6, 0.0), interval, 1, no_sensitivities())
    assert valid == n
    q, qdot, qddot = (SCALES.half * states[:, i] for i in range(3))
    return Log(interval * np.arange(n), q, qdot, qddot, v, np.ones(n, dtype=bool))


@pytest.mark.parametrize("changes", [{}, {"turning_arm": True, "drag": True}, {"stops": True}], ids=str)
def test_the_traced_law_is_the_one_that_runs_integrate(changes):
    """On the states of a run; friction, which moves by whole steps, is left out."""
    structure = JointStructure(basis_functions=6, rates=(6.0, 0.2), shape_elements=2, slips=0, **changes)
    p, n = ParameterLayout(structure, SCALES, "squared", (1, -1)), 1000
    theta = 0.3 * np.random.default_rng(4).standard_normal(p.count)
    v, still = pulses(n, 0.01, np.random.default_rng(5)), np.zeros(n)
    u, du = p.inputs(v, 0.01, 2, theta)
    c, drive, free = p.coefficients(theta), Drive(u, du, u[0], p.held), Coupling(still, still, 0.0)
    states, _, valid = observed_run(c, drive, free, (0.6, 0.0), 0.01, 2, no_sensitivities())
    assert valid == n
    law = trace(lambda x, u: {"dx": free_rates(c, x, (), u)}, x=4, u=2)
    rates = law.evaluate(x=states[:, [0, 1, 3, 4]], u=u[::4])["dx"]
    np.testing.assert_allclose(rates[:, 1], states[:, 2], rtol=0.0, atol=1e-12 * np.abs(states[:, 2]).max())


@pytest.mark.parametrize("gain", [pytest.param(0.0, marks=pytest.mark.long), 2.0])
@pytest.mark.parametrize(
    "changes",
    [
        {},
        {"hold": "zero", "input_lag": True, "rest_at_zero": True},
        {"force": "polynomial", "constant_damping": True, "constant_gain": True, "hold": "cubic"},
        {"turning_arm": True, "drag": True, "stops": True},
        {"input_lag": True, "effect_lags": True, "bent_input": True, "dead_zone": True},
        {"input_lag": True, "effect_lags": True, "hold": "zero", "rest_at_zero": True},
    ],
)
def test_sensitivities_are_the_exact_derivatives_of_the_scheme(gain, changes):
    p = parameters(**changes)
    theta = double_well(p, np.random.default_rng(2))
    log = record(p, theta, n=150)
    problem, elsewhere = JointProblem(p, [log]), theta + 0.03 * np.random.default_rng(3).standard_normal(p.count)
    _, jacobian = problem.jacobian(elsewhere, gain)
    step = 1e-6
    for i in range(p.count):
        shift = np.zeros(p.count)
        shift[i] = step
        above, below = (problem.residual(elsewhere + s * shift, gain) for s in (1, -1))
        difference = (above - below) / (2 * step)
        assert jacobian[:, i] == pytest.approx(difference, abs=2e-6 + 2e-4 * np.abs(difference).max()), i


def test_agrees_with_an_adaptive_integrator_of_the_equations_as_written():
    p = parameters()
    theta = double_well(p, np.random.default_rng(4))
    c, at = p.coefficients(theta), p.slices
    log = record(p, theta, n=250)

    def slope(t, y):
        x, speed, w, s = y[0], y[1], y[2:4], y[4]
        inside = np.clip(x, c.low, c.high)
        basis = np.concatenate((x ** np.arange(4), np.exp(-c.bend * (inside - c.centres) ** 2)))
        force, damping, g1, g2, h1, h2, relaxation, *pulls = c.curves @ basis
        pulls = np.array(pulls)
        bent = -2.0 * c.bend * (inside - c.centres) * basis[4:] * (c.low < x < c.high)
        u = (np.array([np.interp(t, log.t, log.v[:, k]) for k in range(2)]) / 3000.0 - theta[at["input_offset"]]) ** 2
        arm = x - c.inertia[1]
        load = w - [pulls @ u, 0.0]
        total = force - damping * speed - c.inertia[0] * arm * speed**2 - h1 * load[0] - h2 * load[1]
        total += g1 * u[0] + g2 * u[1] + w[0] * (c.curves[7:, 4:] @ bent) @ u - c.slip_force[0] * s
        relax = np.array([h1, h2]) * speed - (c.rates + np.array([relaxation, 0.0])) * load
        return [speed, total / (1 + c.inertia[0] * arm**2), *relax, (speed - abs(speed) * s) / c.slip_length[0]]

    rest = [c.curves[7:] @ basis_rows(np.array([0.6]), c)[0] @ theta[at["input_offset"]] ** 2, 0.0]
    truth = solve_ivp(slope, (0, log.t[-1]), [0.6, 0, *rest, 0], t_eval=log.t, rtol=1e-8, atol=1e-10, max_step=0.005)
    assert log.q / SCALES.half == pytest.approx(truth.y[0], abs=4e-3)


@pytest.mark.parametrize("seed", range(6))
def test_any_parameter_vector_is_passive_and_confined(seed):
    """Without inputs no random joint may gain energy, however far outside the data it starts."""
    p = parameters(drag=True, stops=True)
    rng = np.random.default_rng(seed)
    theta = double_well(p, rng) + 0.4 * rng.standard_normal(p.count)
    theta[p.slices["input_offset"]] = 0.0
    theta[p.slices["stops"]] += -0.9, 0.8, np.log(300.0), np.log(3.0)
    c, n = p.coefficients(theta), 800
    still, none = np.zeros(n), np.zeros((2 * (n - 1) * 2 + 1, 2))
    drive, free = Drive(none, np.zeros((2, *none.shape)), none[0], False), Coupling(still, still, 0.0)
    states, _, valid = observed_run(c, drive, free, (2.0, 0.0), 0.005, 2, no_sensitivities())
    assert valid == n
    grid = np.linspace(-2.1, 2.1, 8001)
    at_rest = {"x": grid[:, None], "p": np.zeros((grid.size, 1)), "stops": np.tile(c.stops, (grid.size, 1))}
    force, ends = (basis_rows(grid, c) @ c.curves[0])[:, None], np.tile(c.at_ends, (grid.size, 1))
    reach = {"low": np.array([c.low]), "high": np.array([c.high])}
    confined = CONFINED_FORCE.evaluate(x=at_rest["x"], force=force, at_ends=ends, **reach)
    values = (confined["value"] + STOP_FORCE.evaluate(**at_rest)["value"])[:, 0]
    well = -np.concatenate(([0.0], np.cumsum(0.5 * (values[1:] + values[:-1]) * np.diff(grid))))
    x, speed, w, s = states[:, 0], states[:, 1], states[:, 3:5], states[:, 5]
    inertia = 1 + c.inertia[0] * (x - c.inertia[1]) ** 2
    energy = 0.5 * inertia * speed**2 + np.interp(x, grid, well) + 0.5 * (w**2).sum(axis=1)
    energy += 0.5 * c.slip_force[0] * c.slip_length[0] * s**2
    assert np.diff(energy).max() < 2e-3 * np.ptp(energy)
    assert energy[-1] < energy[0]


def test_a_gap_is_bridged_and_left_out_of_the_residual():
    p = parameters()
    theta = double_well(p, np.random.default_rng(6))
    log = record(p, theta, n=200)
    valid = log.valid.copy()
    valid[80:95] = False
    broken = Log(log.t, np.where(valid, log.q, np.nan), log.qdot, log.qddot, log.v, valid)
    residual = JointProblem(p, [broken]).residual(theta, 1.0)
    assert len(residual) == 185
    assert np.isfinite(residual).all()
    line = bridged(broken.q, valid)
    assert np.diff(line[80:95]) == pytest.approx(np.diff(line[80:95]).mean())


@pytest.mark.parametrize("changes", [{}, {"bent_input": True}, {"dead_zone": True}], ids=str)
def test_the_gains_of_the_curves_are_the_push_of_the_largest_input(changes):
    structure = JointStructure(basis_functions=6, rates=(), shape_elements=0, slips=0, arc=False, **changes)
    p = ParameterLayout(structure, SCALES, "squared", (1, -1))
    theta = 0.3 * np.random.default_rng(7).standard_normal(p.count)
    theta[p.slices["input_offset"]] = -0.03, 0.02
    none = np.zeros((p.count, 1))
    model = RbfModel(p, theta, none, none, mass_kg=0.04)
    t, places = 0.01 * np.arange(2), np.linspace(-0.015, 0.015, 5)
    curves = model.curves(places)
    for k in (0, 1):
        volts = np.zeros((2, 2))
        volts[:, k] = SCALES.volts
        pushed = [
            model.simulate(t, volts, q, 0.0).qddot[0] - model.simulate(t, 0.0 * volts, q, 0.0).qddot[0] for q in places
        ]
        expected = 0.5 * curves[f"dC{k + 1}_dq"] * SCALES.volts**2 / model.mass_kg
        assert pushed == pytest.approx(expected, rel=1e-9)
