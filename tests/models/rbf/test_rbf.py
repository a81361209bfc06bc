import numpy as np
import pytest

from pipeline.errors import CorruptArtifactError, InputError
from pipeline.models.free_runs import tubes
from pipeline.models.model_type import KnownCurves, model_from_tree
from pipeline.models.rbf.candidates import FRICTION, Candidate, decided_fields
from pipeline.models.rbf.identify import identify_rbf
from pipeline.models.rbf.model import RbfModel
from pipeline.models.rbf.parameter_layout import ParameterLayout
from pipeline.models.rbf.start import bistable_signs, looks_overdamped
from pipeline.models.rbf.structure import JointScales, JointStructure
from pipeline.settings.prototype import Structure
from pipeline.signals.differentiate import differentiate
from pipeline.signals.log import Log

STRUCTURE = JointStructure(basis_functions=8, rates=(6.0, 0.2), shape_elements=1)
INTERVAL = 0.01


def planted():
    """A double well with wells at ±12 mm, hidden elements, friction, an asymmetry: none of it known to the fit."""
    p = ParameterLayout(STRUCTURE, JointScales(0.0, 0.022, 3000.0, 50.0), "squared", (1, -1))
    theta, at = np.zeros(p.count), p.slices
    theta[at["force"]][:4] = 2.0, 70.0, 5.0, np.log(230.0)
    theta[at["damping"]] = np.log(0.4)
    theta[at["input0"]], theta[at["input1"]] = np.log(15.0), np.log(14.0)
    theta[at["coupling0"]] = 3.0
    theta[at["coupling1"]] = np.linspace(1.0, 3.0, 8)
    theta[at["rate"]] = np.log([60.0, 3.0])
    theta[at["slip_force"]], theta[at["slip_length"]] = np.log(0.4), np.log(0.01)
    theta[at["inertia"]] = np.log(0.15)
    return RbfModel(p, theta, *np.zeros((2, p.count, 1)), 0.04)


def pulses(n, rng):
    t, v = INTERVAL * np.arange(n), np.zeros((n, 2))
    at = 0.4
    while at < t[-1]:
        width = rng.uniform(0.3, 1.2)
        v[(t >= at) & (t < at + width), rng.integers(2)] = rng.uniform(1500, 3000)
        at += width + rng.uniform(0.3, 1.2)
    return v


def log(model, seed, n=1000, noise=5e-6):
    rng = np.random.default_rng(seed)
    t, v = INTERVAL * np.arange(n), pulses(n, rng)
    run = model.simulate(t, v, -0.012, 0.0)
    assert run.status == "ok"
    return Log(t, run.q + noise * rng.standard_normal(n), run.qdot, run.qddot, v, np.ones(n, dtype=bool))


@pytest.fixture(scope="module")
def identified():
    return identify_rbf([log(planted(), 11)], mass=0.04, candidates=[Candidate("free", STRUCTURE, 1.0)])


def test_a_free_run_over_an_unseen_log_follows_the_truth(identified):
    fresh = log(planted(), 12)
    run = identified.simulate(fresh.t, fresh.v, fresh.q[0], 0.0)
    assert run.status == "ok"
    assert np.sqrt(np.mean((run.q - fresh.q) ** 2)) < 0.04 * np.ptp(fresh.q)


def test_planted_curves_lie_in_the_bands_and_bands_widen_where_an_input_never_acted(identified):
    q = np.linspace(-0.015, 0.015, 31)
    truth, found, draws = planted().curves(q), identified.curves(q), identified.curve_ensemble(q, 100)
    for name in ("F", "dC1_dq", "dC2_dq"):
        spread, size = draws[name].std(axis=0), np.abs(truth[name]).max()
        assert np.mean(np.abs(found[name] - truth[name]) < 3.0 * spread + 0.015 * size) > 0.9, name
    assert draws["dC2_dq"][:, -1].std() > 5.0 * draws["dC2_dq"][:, 0].std()


def test_draws_of_an_outcome_are_those_of_the_curves(identified):
    q = np.linspace(-0.015, 0.015, 31)
    by_curves, drawn = (
        identified.curve_ensemble(q, 100)["F"],
        identified.outcome_ensemble(lambda near: near.curves(q)["F"], 100),
    )
    assert np.abs(drawn - by_curves).max() < 0.2 * by_curves.std(axis=0).max()


def test_two_logs_and_a_masked_span_identify_as_well(identified):
    first, second = log(planted(), 11, n=600), log(planted(), 13, n=500)
    valid = first.valid.copy()
    valid[400:430] = False
    masked = Log(first.t, np.where(valid, first.q, np.nan), first.qdot, first.qddot, first.v, valid)
    model = identify_rbf([masked, second], mass=0.04, candidates=[Candidate("free", STRUCTURE, 1.0)])
    fresh = log(planted(), 12)
    run = model.simulate(fresh.t, fresh.v, fresh.q[0], 0.0)
    assert np.sqrt(np.mean((run.q - fresh.q) ** 2)) < 0.06 * np.ptp(fresh.q)


def test_the_same_data_give_the_same_model():
    data, candidates = [log(planted(), 11, n=250)], [Candidate("free", STRUCTURE, 1.0)]
    once, again = (identify_rbf(data, mass=0.04, candidates=candidates) for _ in range(2))
    assert (again.theta == once.theta).all()
    assert (again.draws(4) == once.draws(4)).all()


def test_tree_round_trip(identified):
    again = model_from_tree("rbf", identified.to_tree())
    fresh = log(planted(), 12, n=300)
    before, after = (m.simulate(fresh.t, fresh.v, fresh.q[0], 0.0).q for m in (identified, again))
    assert (before == after).all()
    broken = identified.to_tree()
    del broken["theta"]
    with pytest.raises(CorruptArtifactError, match="theta"):
        model_from_tree("rbf", broken)


def test_tubes_hold_nine_tenths_of_another_log_of_the_same_device_and_stand_in_the_file(identified):
    fresh = log(planted(), 12)
    free = identified.simulate(fresh.t, fresh.v, fresh.q[0], 0.0).q
    draws, _ = identified.simulate_draws(fresh.t, fresh.v, fresh.q[0], 0.0)
    around = tubes(free, draws, identified.tube)
    assert around.coverage(fresh.q) > 0.86
    assert np.median(around.high - around.low) < 0.1 * np.ptp(fresh.q)
    assert model_from_tree("rbf", identified.to_tree()).tube == identified.tube


def test_constant_and_undriven_logs_are_refused():
    n = 100
    t, wave = INTERVAL * np.arange(n), np.sin(np.arange(n))
    flat = Log(t, 0 * t, 0 * t, 0 * t, np.ones((n, 2)), np.ones(n, dtype=bool))
    with pytest.raises(InputError, match="constant"):
        identify_rbf([flat])
    undriven = Log(t, wave, wave, wave, np.zeros((n, 2)), np.ones(n, dtype=bool))
    with pytest.raises(InputError, match="never driven"):
        identify_rbf([undriven])


def arm(seed, *, n=700, interval=0.03):
    """An arm that a propeller lifts: sin q, a lagged squared drive, dry friction."""
    structure = JointStructure(6, arc=False, turning_arm=True, input_lag=True, **FRICTION["maxwell-slip"])
    p = ParameterLayout(structure, JointScales(0.8, 0.7, 60.0, 20.0), "squared", (1,))
    theta, at = np.zeros(p.count), p.slices
    theta[at["force"]][:4] = 0.0, -12.0, 0.0, np.log(0.1)
    theta[at["damping"]], theta[at["input0"]] = np.log(0.8), np.log(12.0)
    theta[at["slip_force"]], theta[at["slip_length"]] = np.log(0.05), np.log(0.02)
    theta[at["input_lag"]] = np.log(0.15)
    rng, t = np.random.default_rng(seed), interval * np.arange(n)
    v = np.repeat(rng.uniform(20.0, 42.0, n // 70), 70)[:, None]
    run = RbfModel(p, theta, *np.zeros((2, p.count, 1))).simulate(t, v, 0.6, 0.0)
    assert run.status == "ok"
    return Log(t, run.q + 1e-4 * rng.standard_normal(n), run.qdot, run.qddot, v, np.ones(n, dtype=bool))


def test_measured_curves_are_kept_and_friction_is_learned_from_a_short_log():
    """F(q) and dC/dq from a test stand at least halve the error of a free run on an unseen log."""
    truth, q = planted(), np.linspace(-0.02, 0.02, 41)
    rng, curves = np.random.default_rng(3), planted().curves(q)
    force = curves["F"] + 2e-3 * np.abs(curves["F"]).max() * rng.standard_normal(len(q))
    known = KnownCurves(q, force, (curves["dC1_dq"] / 2.0, curves["dC2_dq"] / 2.0))
    short, fresh = log(truth, 11, n=600), log(truth, 12)
    choice = [Candidate("lag", JointStructure(12, **FRICTION["lag+slip"]))]
    kept = identify_rbf([short], mass=0.04, candidates=choice, measured=known)
    free = identify_rbf([short], mass=0.04, candidates=choice)
    for name in ("F", "dC1_dq", "dC2_dq"):
        assert np.abs(kept.curves(q)[name] - curves[name]).max() < 0.02 * np.abs(curves[name]).max(), name
    errors = []
    for model in (kept, free):
        run = model.simulate(fresh.t, fresh.v, fresh.q[0], 0.0)
        errors.append(np.sqrt(np.nanmean((run.q - fresh.q) ** 2)) / np.ptp(fresh.q))
    assert errors[0] < 0.01
    assert errors[0] < 0.5 * errors[1]


def slider(seed, *, n=1200, bend=0.0, drag=0.0, stop=None, zone=0.0):
    """A spring and a mass under a held force; if asked for, its drive saturates, it moves in a fluid, its motion ends
    at stops [10 mm], or small forces do nothing.
    """
    structure = JointStructure(
        5, rates=(), shape_elements=0, slips=0, arc=False, force="polynomial", constant_damping=True,
        constant_gain=True, hold="zero", bent_input=bend != 0.0, drag=drag > 0.0, stops=stop is not None,
        dead_zone=zone > 0.0,
    )  # fmt: skip
    p = ParameterLayout(structure, JointScales(0.0, 0.01, 1.0, 20.0), "linear", (0,))
    theta, at = np.zeros(p.count), p.slices
    theta[at["force"]][:4] = 0.0, -60.0, 0.0, np.log(20.0)
    theta[at["damping"]], theta[at["input0"]] = np.log(2.0), 40.0
    theta[at["input_bend"]], theta[at["drag"]] = bend, np.log(drag or 1.0)
    theta[at["input_zone"]] = np.log(zone or 1.0)
    theta[at["stops"]] = (*(stop or ()), np.log(3000.0), np.log(20.0))[: 4 * (stop is not None)]
    rng, interval = np.random.default_rng(seed), 0.05
    t, v = interval * np.arange(n), rng.uniform(-1.0, 1.0, n)
    run = RbfModel(p, theta, *np.zeros((2, p.count, 1))).simulate(t, v[:, None], 0.0, 0.0)
    assert run.status == "ok"
    noisy = run.q + 2e-6 * rng.standard_normal(n)
    return Log(t, noisy, run.qdot, run.qddot, v[:, None], np.ones(n, dtype=bool))


def test_the_hold_of_the_input_is_found_and_makes_the_free_run_exact():
    """And a delay or a lag that ends at next to nothing stays out: its input moves this slider at once."""
    model = identify_rbf([slider(9, n=600)], inputs="linear", decided=FRICTION["viscous"])
    assert model.parameters.structure.hold == "zero"
    assert model.parameters.structure.constant_gain
    assert not model.parameters.structure.input_delay and not model.parameters.structure.input_lag
    fresh = slider(2, n=600)
    run = model.simulate(fresh.t, fresh.v, fresh.q[0], 0.0)
    assert np.sqrt(np.mean((run.q - fresh.q) ** 2)) < 2e-3 * np.ptp(fresh.q)
    assert model.diagnostics["converged"]


def element(model, name):
    """A parameter of the data-driven joint in the units of the slider: 10 mm and the largest drive."""
    c, s, at = model.parameters.coefficients(model.theta), model.parameters.scales, model.parameters.slices
    return {
        "drag": lambda: [c.drag * 0.01 / s.half],
        "zone": lambda: np.exp(model.theta[at["input_zone"]]) * s.volts,
        "stop": lambda: (s.middle + s.half * c.stops[:2]) / 0.01,
        "bend": lambda: model.theta[at["input_bend"]],
    }[name]()


@pytest.mark.long
@pytest.mark.parametrize(
    ("name", "planted_value", "seed", "n", "within", "error"),
    [
        ("drag", 2.0, 11, 600, 0.1, 2e-3),
        ("zone", 0.2, 15, 600, 0.01, 5e-3),
        ("stop", (-0.3, 0.4), 13, 800, 0.01, 2e-2),  # they set in more softly than planted
        ("bend", 1.2, 7, 600, 0.05, 2e-3),
    ],
)
def test_a_planted_element_is_seen(name, planted_value, seed, n, within, error):
    """Drag of a fluid, a dead zone, end stops, a drive that saturates: found, and followed on a new log."""
    model = identify_rbf([slider(seed, n=n, **{name: planted_value})], inputs="linear")
    assert list(element(model, name)) == pytest.approx(list(np.atleast_1d(planted_value)), abs=within)
    fresh = slider(seed + 1, n=n, **{name: planted_value})
    run = model.simulate(fresh.t, fresh.v, fresh.q[0], 0.0)
    assert np.sqrt(np.mean((run.q - fresh.q) ** 2)) < error * np.ptp(fresh.q)


def test_a_short_time_limit_ends_early_the_same_everywhere_and_says_that_nothing_converged():
    told = []
    data = [slider(5, n=600, stop=(-0.3, 0.4))]
    cut, again = (
        identify_rbf(data, inputs="linear", time_limit=0.05, on_progress=lambda what, share: told.append((what, share)))
        for _ in range(2)
    )
    assert (cut.theta == again.theta).all()
    assert not cut.diagnostics["converged"]
    assert "free run, error" in told[-1][0]
    assert told[-1][1] == 1.0
    assert cut.diagnostics["effort_s"] < 0.5


def oscillator(seed, amplitude, *, n=1500, interval=0.01):
    """A double well on a shaker, integrated here and not by the model; q in steps of 1 µm.

    x" = -0.3 x' + x - x**3 - u in units of 10 mm and 50 ms: chaotic for u = 0.5 cos 1.2 t, calm for 0.15.
    """
    rng, size, unit, substeps = np.random.default_rng(seed), 0.01, 0.05, 10
    t, phase, h = interval * np.arange(n), rng.uniform(0.0, 2 * np.pi), interval / unit / substeps

    def rates(y, s):
        return np.array([y[1], -0.3 * y[1] + y[0] - y[0] ** 3 - amplitude * np.cos(1.2 * s + phase)])

    states, y = np.empty((n, 2)), np.array([1.0, 0.0])
    for k in range(n):
        states[k] = y
        for j in range(substeps):
            s = t[k] / unit + j * h
            a = rates(y, s)
            b = rates(y + h / 2 * a, s + h / 2)
            c = rates(y + h / 2 * b, s + h / 2)
            y = y + h / 6 * (a + 2 * b + 2 * c + rates(y + h * c, s + h))
    base = size / unit**2 * amplitude * np.cos(1.2 * t / unit + phase)
    q = np.round((size * states[:, 0] + 1e-5 * rng.standard_normal(n)) / 1e-6) * 1e-6
    seen = differentiate(q, interval)
    return Log(t, q, seen.qdot, seen.qddot, base[:, None], np.ones(n, dtype=bool))


WELL = Candidate("well", JointStructure(
    8, rates=(), shape_elements=0, slips=0, arc=False, force="polynomial", constant_damping=True, constant_gain=True,
    hold="cubic",
))  # fmt: skip


def test_a_chaotic_log_teaches_what_a_calm_one_does_and_is_said_to_be_chaotic():
    """The free run of a driven double well in chaos has no useful error; tied to the log the fit is as good as any."""
    model = identify_rbf([oscillator(1, 0.5)], inputs="linear", candidates=[WELL])
    assert model.diagnostics["chaotic"]
    assert model.diagnostics["converged"]
    assert not model.diagnostics["reached_free_run"]
    calm = oscillator(3, 0.15, n=800)
    run = model.simulate(calm.t, calm.v, calm.q[0], 0.0)
    assert np.sqrt(np.mean((run.q - calm.q) ** 2)) < 0.01 * np.ptp(calm.q)
    quiet = identify_rbf([oscillator(4, 0.15)], inputs="linear", candidates=[WELL])
    assert not quiet.diagnostics["chaotic"]
    assert quiet.diagnostics["reached_free_run"]


def test_restarts_along_a_log_go_on_from_the_free_run_of_the_truth():
    """Hidden states come through a gap in the measurement, and each restart is what it is alone."""
    truth = planted()
    moving = log(truth, 12, noise=0.0)
    seen, starts, ahead = moving.q.copy(), np.array([150, 300]), np.array([20, 15])
    seen[220:240] = np.nan
    runs = [*truth.predict(moving.t, moving.v, seen, moving.qdot, starts, ahead)]
    for start, run in zip(starts, runs, strict=True):
        np.testing.assert_allclose(run, moving.q[start : start + len(run)], atol=1e-4)
    (alone,) = truth.predict(moving.t, moving.v, seen, moving.qdot, starts[1:], ahead[1:])
    np.testing.assert_allclose(runs[1], alone, atol=1e-12)


def seen(seed, *, bend=0.0, shift=0.0, weaker=1.0, n=1000):
    """A log of the planted joint, its sides alike, as a laser sees it that bends its readings by a share of half their
    range and whose zero is shifted [m]; or with a second membrane that pulls less.
    """
    joint = planted()
    theta, at = joint.theta.copy(), joint.parameters.slices
    theta[at["force"]][[0, 2]], theta[at["coupling1"]] = 0.0, 2.0
    theta[at["input1"]] = np.log(15.0 * weaker)
    true = log(RbfModel(joint.parameters, theta, joint.spread, joint.band_spread, 0.04), seed, n=n, noise=0.0)
    bend /= joint.parameters.scales.half
    slope, noise = 1.0 + 2.0 * bend * true.q, 5e-6 * np.random.default_rng(seed).standard_normal(n)
    q, qddot = true.q + bend * true.q**2 + shift + noise, true.qddot * slope + 2.0 * bend * true.qdot**2
    return Log(true.t, q, true.qdot * slope, qddot, true.v, true.valid)


def test_a_bistable_joint_is_fitted_while_it_is_tied_to_its_log():
    """A free run is decided by single passages near the separatrix, so none is fitted; it follows a new log well."""
    model = identify_rbf([seen(21, n=600)])
    assert model.diagnostics["levels"]["gain"][-1] == 0.3
    assert not model.diagnostics["reached_free_run"]
    assert model.diagnostics["converged"]
    fresh = seen(22)
    run = model.simulate(fresh.t, fresh.v, fresh.q[0], 0.0)
    assert np.sqrt(np.mean((run.q - fresh.q) ** 2)) < 0.03 * np.ptp(fresh.q)


def seesaw(seed, *, n=900, interval=0.04, signs=(1, -1)):
    """A beam on a pivot between two propellers with a common lag; both squares act, so many ways up or against."""
    structure = JointStructure(
        8, rates=(), shape_elements=0, slips=0, arc=False, turning_arm=True, force="polynomial", constant_damping=True,
        constant_gain=True, input_lag=True,
    )  # fmt: skip
    p = ParameterLayout(structure, JointScales(0.1, 1.2, 1.0, 4.0), "squared", signs)
    theta, at = np.zeros(p.count), p.slices
    theta[at["force"]][:4] = 0.3, -5.0, 0.0, np.log(0.1)
    theta[at["damping"]] = np.log(0.5)
    theta[at["input0"]], theta[at["input1"]] = np.log(2.5), np.log(2.0)
    theta[at["input_lag"]] = np.log(0.2)
    rng, t = np.random.default_rng(seed), interval * np.arange(n)
    v = np.column_stack([np.repeat(rng.uniform(0.0, 1.0, n // m + 1), m)[:n] for m in (25, 35)])
    run = RbfModel(p, theta, *np.zeros((2, p.count, 1))).simulate(t, v, 0.1, 0.0)
    assert run.status == "ok"
    return Log(t, run.q + 1e-4 * rng.standard_normal(n), run.qdot, run.qddot, v, np.ones(n, dtype=bool))


def test_heat_that_follows_the_square_of_an_input_is_told_from_an_input_that_lags():
    """The input crosses zero often; only what it does is slow."""
    structure = JointStructure(
        8, rates=(), shape_elements=0, slips=0, arc=False, force="polynomial", constant_damping=True,
        constant_gain=True, input_lag=True, effect_lags=True,
    )  # fmt: skip
    p = ParameterLayout(structure, JointScales(0.3, 0.5, 1.0, 10.0), "squared", (1,))
    theta, at = np.zeros(p.count), p.slices
    theta[at["force"]][:4] = -1.0, -8.0, 0.0, np.log(0.1)
    theta[at["damping"]], theta[at["input0"]], theta[at["input_lag"]] = np.log(0.8), np.log(9.0), np.log(0.4)
    rng, t = np.random.default_rng(5), 0.04 * np.arange(700)
    v = np.repeat(rng.uniform(-1.0, 1.0, (100, 1)), 7, axis=0)
    run = RbfModel(p, theta, *np.zeros((2, p.count, 1))).simulate(t, v, -0.2, 0.0)
    assert run.status == "ok"
    q = run.q + 1e-4 * rng.standard_normal(700)
    log = Log(t, q, run.qdot, run.qddot, v, np.ones(700, dtype=bool))
    model = identify_rbf(
        [log],
        decided=decided_fields(
            Structure(friction="viscous", force="polynomial", damping="constant", gain="constant", effect="plain")
        ),
    )
    assert "lagged effect" in model.diagnostics["chosen"]
    assert np.exp(model.theta[model.parameters.slices["input_lag"]]) == pytest.approx(0.4, rel=0.05)


def test_only_two_wells_are_taken_for_a_bistable_device():
    assert bistable_signs([seen(21)], "squared") == (1, -1)
    assert bistable_signs([oscillator(1, 0.5)], "linear") == (0,)
    assert bistable_signs([seesaw(1)], "squared") == ()
    assert bistable_signs([seesaw(1, signs=(1, 1))], "squared") == ()
    assert bistable_signs([arm(1)], "squared") == ()


def test_two_inputs_at_one_well_are_searched_for_and_fitted_in_free_run():
    """The structure of a bistable joint has no lag of the drive and is never fitted in free run."""
    model = identify_rbf(
        [seesaw(1, n=400)], angle=True, decided=decided_fields(Structure(friction="viscous", effect="plain"))
    )
    assert "lagged input" in model.diagnostics["chosen"]
    assert model.diagnostics["reached_free_run"]
    assert np.exp(model.theta[model.parameters.slices["input_lag"]]) == pytest.approx(0.2, rel=0.01)
    assert model.parameters.signs == (1, -1)
    fresh = seesaw(2)
    run = model.simulate(fresh.t, fresh.v, fresh.q[0], 0.0)
    assert np.sqrt(np.mean((run.q - fresh.q) ** 2)) < 1e-3 * np.ptp(fresh.q)


def level(seed, *, n=1500, interval=0.01, noise=1e-5, speed=2.0):
    """What has no inertia: q follows its input at a rate, as a level or an air muscle does; solved exactly."""
    rng, t = np.random.default_rng(seed), interval * np.arange(n)
    v = np.repeat(rng.uniform(-1.0, 1.0, n // 60 + 1), 60)[:n]
    q, decay = np.zeros(n), np.exp(-speed * interval)
    for i in range(1, n):
        q[i] = decay * q[i - 1] + 0.01 * (1.0 - decay) * v[i - 1]
    q += noise * rng.standard_normal(n)
    kinematics = differentiate(q, interval)
    return Log(t, q, kinematics.qdot, kinematics.qddot, v[:, None], np.ones(n, dtype=bool))


def test_what_has_no_inertia_looks_overdamped_and_what_swings_does_not():
    assert looks_overdamped([level(1)], "linear")
    assert not looks_overdamped([slider(1)], "linear")
    assert not looks_overdamped([seen(21)], "squared")


@pytest.mark.long
def test_a_device_without_inertia_is_followed():
    choice = decided_fields(
        Structure(friction="viscous", drive="direct", effect="plain", gain="constant", drag="none", stops="none")
    )
    model = identify_rbf([level(1)], inputs="linear", decided=choice)
    assert any("overdamped" in one for one in model.diagnostics["candidates"])
    fresh = level(2)
    run = model.simulate(fresh.t, fresh.v, fresh.q[0], 0.0)
    assert np.sqrt(np.mean((run.q - fresh.q) ** 2)) < 5e-3 * np.ptp(fresh.q)
