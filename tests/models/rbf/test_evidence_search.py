"""A bistable joint gets the elements that its log shows, and curves that are right where it has none."""

import numpy as np
import pytest
from scipy.stats import multivariate_normal

from pipeline.fitting.descent import Prior
from pipeline.fitting.homotopy import LEAST_STEPS, HomotopyFit
from pipeline.fitting.posterior import log_evidence
from pipeline.models.rbf.candidates import FRICTION, first_candidate
from pipeline.models.rbf.identify import _trial, identify_rbf
from pipeline.models.rbf.model import RbfModel
from pipeline.models.rbf.parameter_layout import ParameterLayout
from pipeline.models.rbf.problem import Effort
from pipeline.models.rbf.structure import JointScales, JointStructure
from pipeline.models.rbf.structure_search import Setting
from pipeline.signals.log import Log
from pipeline.system.worker_pool import silent
from tests.models.rbf.test_rbf import log

DAMPING = 4.0


def double_well(law, *, slip=0.0, stiffness=0.0, rate=3.0):
    """Wells at ±12 mm, damping of 4 1/s everywhere; friction and a relaxing spring [1/s²] in half ranges, if any."""
    structure = JointStructure(6, arc=False, **FRICTION[law])
    p = ParameterLayout(structure, JointScales(0.0, 0.022, 3000.0, 50.0), "squared", (1, -1))
    theta, at = np.zeros(p.count), p.slices
    theta[at["force"]][:4] = 0.0, 70.0, 0.0, np.log(230.0)
    flat = np.exp(-p.bend * (np.linspace(-1.0, 1.0, 41)[:, None] - p.centres) ** 2)
    even = np.linalg.lstsq(flat, np.ones(41), rcond=None)[0]
    theta[at["damping"]] = np.log(DAMPING * even)
    theta[at["input0"]] = theta[at["input1"]] = np.log(30.0 * even)
    theta[at["slip_force"]], theta[at["slip_length"]] = np.log(slip) if slip else (), np.log(0.01) if slip else ()
    if stiffness:
        theta[at["coupling0"]], theta[at["rate"]] = np.sqrt(stiffness) * even, np.log(rate)
    return RbfModel(p, theta, *np.zeros((2, p.count, 1)))


@pytest.mark.parametrize(
    ("law", "elements"),
    [
        ("viscous", {}),
        ("coulomb", {"slip": 1.0}),
        ("lag", {"stiffness": 8.0}),
        ("lag+slip", {"slip": 1.0, "stiffness": 8.0}),
    ],
    ids=["plain", "friction", "relaxation", "both"],
)
def test_the_elements_that_a_log_shows_are_found_and_no_others(law, elements):
    truth = double_well(law, **elements)
    found = identify_rbf([log(truth, 3, n=900)])
    structure = found.parameters.structure
    assert {name: getattr(structure, name) for name in FRICTION[law]} == FRICTION[law], found.diagnostics["chosen"]
    forces = found.diagnostics["elements"]
    # A Dahl state is nearly ±1 in motion.
    assert forces["dry friction"] == pytest.approx(elements.get("slip", 0.0) * truth.parameters.scales.half, rel=0.3)
    assert (forces["relaxation"] > 0.0) == ("stiffness" in elements)
    assert (forces["hidden shapes"], forces["drag"], forces["end stops"]) == (0.0, 0.0, 0.0)
    q = np.linspace(-0.016, 0.016, 9)
    curves, planted = found.curves(q), truth.curves(q)
    assert curves["d"] == pytest.approx(planted["d"], rel=0.2)
    assert curves["F"] == pytest.approx(planted["F"], abs=0.02 * np.abs(planted["F"]).max())


def test_no_candidate_outlasts_the_search():
    """A prior of other devices can take a hundred times as long as the fit of the device itself."""
    first = first_candidate({}, pair=True, angle=False, fine=False)
    records = [log(double_well("viscous"), 3, n=900)]
    trials = [_trial(records, Setting("squared", None, Effort(limit), silent), first, None) for limit in (1e-3, 20.0)]
    least, whole = (trial.fit.levels[-1].iterations for trial in trials)
    assert least == LEAST_STEPS < whole


def test_the_evidence_is_the_marginal_likelihood_of_a_linear_model_of_known_noise():
    """Differences between two models over the same data, which share the constant of the noise."""
    rng = np.random.default_rng(4)
    count, noise, found, exact = 4000, 0.3, [], []
    columns = rng.standard_normal((count, 5))
    data = columns @ rng.standard_normal(5) + noise * rng.standard_normal(count)
    for used, spread in ((5, 1.0), (4, 1.0)):
        rows, prior = columns[:, :used], Prior(np.eye(used) / spread, np.zeros(used))
        theta = np.linalg.solve(rows.T @ rows / noise**2 + prior.matrix.T @ prior.matrix, rows.T @ data / noise**2)
        residual = data - rows @ theta
        fit = HomotopyFit(theta, residual, rows.T @ rows, noise, (), True)
        found.append(log_evidence(fit, prior, 1.0))
        s2 = np.mean(residual**2)
        head = slice(0, 300)  # the exact density of all samples at once would take minutes: by the matrix identity
        gram = np.eye(used) / spread**2 + rows.T @ rows / s2
        quadratic = data @ data / s2 - (rows.T @ data / s2) @ np.linalg.solve(gram, rows.T @ data / s2)
        determinant = count * np.log(s2) + np.linalg.slogdet(gram)[1] + used * np.log(spread**2)
        exact.append(-0.5 * (quadratic + determinant))
        few = rows[head] @ rows[head].T * spread**2 + s2 * np.eye(300)
        direct = multivariate_normal(cov=few).logpdf(data[head])
        small = np.eye(used) / spread**2 + rows[head].T @ rows[head] / s2
        moved = rows[head].T @ data[head] / s2
        identity = data[head] @ data[head] / s2 - moved @ np.linalg.solve(small, moved)
        identity += 300 * np.log(2 * np.pi * s2) + np.linalg.slogdet(small)[1] + used * np.log(spread**2)
        assert direct == pytest.approx(-0.5 * identity)
    assert found[0] - found[1] == pytest.approx(exact[0] - exact[1], rel=1e-3)


def driven_well(acting, **how):
    """A double well of one linear input, and a motion of 12 s over its barrier under random levels."""
    structure = JointStructure(
        8, arc=False, force="polynomial", constant_damping=True, constant_gain=True,
        **dict.fromkeys(acting, True), **FRICTION["viscous"],
    )  # fmt: skip
    p = ParameterLayout(structure, JointScales(0.0, 0.02, 1.0, 50.0), "linear", (0,), **how)
    theta, at = np.zeros(p.count), p.slices
    theta[at["force"]][:4] = 0.0, 70.0, 0.0, np.log(230.0)
    theta[at["damping"]], theta[at["input0"]] = np.log(DAMPING), 60.0
    for name, value in acting.items():
        theta[at[name]] = np.log(value)
    rng, t = np.random.default_rng(3), 0.01 * np.arange(1200)
    v = np.repeat(rng.uniform(-1.0, 1.0, (60, 1)), 20, axis=0)
    run = RbfModel(p, theta, *np.zeros((2, p.count, 1))).simulate(t, v, -0.011, 0.0)
    assert np.count_nonzero(np.diff(np.sign(run.q))) > 5

    def noisy(noise):
        q = run.q + noise * rng.standard_normal(len(t))
        return Log(t, q, run.qdot, run.qddot, v, np.ones(len(t), dtype=bool))

    return noisy


@pytest.mark.parametrize("acting", [{}, {"input_lag": 0.05}, {"drag": 0.4}], ids=["plain", "lag of the input", "drag"])
def test_a_double_well_with_one_linear_input_gets_what_acts_and_no_more(acting):
    """Random levels move it over the barrier: held-out free runs would show friction or delays that are not there.

    What stood for the drag before it was offered goes again.
    """
    model = identify_rbf([driven_well(acting)(5e-6)], inputs="linear")
    found = model.parameters.structure
    offered = ("input_lag", "input_delay", "bent_input", "dead_zone", "drag", "stops")
    assert {name for name in offered if getattr(found, name)} == set(acting), model.diagnostics["chosen"]
    assert (found.rates, found.slips) == ((), 0), model.diagnostics["chosen"]
    q = np.linspace(-0.015, 0.015, 7)
    assert model.curves(q)["d"] == pytest.approx(np.full(7, DAMPING), rel=0.05)


def test_integration_steps_follow_from_the_noise():
    """A log of little noise is followed to its noise, in more steps than the pace of the device needs."""
    refined = []
    for noise in (1e-4, 1e-7):
        model = identify_rbf([driven_well({}, refinement=16)(noise)], inputs="linear")
        refined.append(model.parameters.refinement)
        assert model.diagnostics["training_rms_m"] == pytest.approx(noise, rel=0.1)
    assert refined[0] == 1 < refined[1]
