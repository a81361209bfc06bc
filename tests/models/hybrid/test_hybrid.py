"""The hybrid joint: planted parameters come back, runs are bounded, trees go round."""

from dataclasses import replace

import numpy as np
import pytest

from pipeline.device.device import JOINT
from pipeline.device.parameters import NOMINAL
from pipeline.diagnostics.calibrated import calibrated
from pipeline.errors import CorruptArtifactError, DataRefusedError
from pipeline.models.base import predictor
from pipeline.models.choose import choose
from pipeline.models.hybrid import parameters as condensed_parameters
from pipeline.models.hybrid.identify import BASIS_FUNCTIONS, identify_hybrid
from pipeline.models.hybrid.model import HybridModel
from pipeline.models.hybrid.problem import CondensedJoint, CondensedProblem
from pipeline.models.hybrid.start import prior_root
from pipeline.models.model_type import Training, model_from_tree
from pipeline.numerics.arrays import FloatArray
from pipeline.settings.prototype import Identify
from pipeline.signals.log import Log
from tests.export.joints import hybrid

PLANTED = {
    "left.log C0": 0.67,
    "right.log C0": -0.4,
    "log E": -0.2,
    "log eta": 0.53,
    "log stop force 0": 0.8,
    "delay": 0.5,
}
"""In prior widths."""


def joint(planted: dict[str, float], centres: int = 0) -> HybridModel:
    condensed = CondensedJoint(
        NOMINAL, np.array([-0.02, 0.01, 0.008]), centres, 3000.0, condensed_parameters.static_slope_ratio(NOMINAL)
    )
    theta = condensed.start()
    for name, value in planted.items():
        theta[condensed_parameters.NAMES.index(name)] = value
    return HybridModel.of(condensed, theta, *2 * (np.zeros((len(theta), len(theta))),))


def pulses(seed: int, seconds: float) -> tuple[FloatArray, FloatArray]:
    """Smooth-edged pulses on alternating sides."""
    random, t = np.random.default_rng(seed), np.arange(round(100 * seconds) + 1) * 0.01
    v, start, side = np.zeros((len(t), 2)), 0.5, 0
    while start < seconds - 1.0:
        length = random.uniform(0.5, 1.4)
        edges = np.tanh((t - start) / 0.01) - np.tanh((t - start - length) / 0.01)
        v[:, side] += 0.5 * random.uniform(2400.0, 3000.0) * edges
        start, side = start + length + random.uniform(0.3, 1.0), 1 - side
    return t, v


def log(model: HybridModel, seed: int, seconds: float = 9.0) -> Log:
    t, v = pulses(seed, seconds)
    run = model.simulate(t, v, -0.0105, 0.0)
    noise = 2e-6 * np.random.default_rng(seed + 100).standard_normal(len(t))
    return Log(t, run.q + noise, run.qdot, run.qddot, v, np.ones(len(t), dtype=bool))


def gapped(record: Log) -> Log:
    """The log with 0.4 s of its displacement lost in the middle and nonsense in its place."""
    valid, q = record.valid.copy(), record.q.copy()
    middle = slice(len(q) // 2, len(q) // 2 + 40)
    valid[middle], q[middle] = False, 1.0
    return replace(record, q=q, valid=valid)


@pytest.fixture(scope="module")
def identified() -> tuple[HybridModel, HybridModel]:
    truth = joint(PLANTED)
    return truth, identify_hybrid([log(truth, 1), gapped(log(truth, 7, 4.0))], NOMINAL)


def test_planted_joint_is_followed_on_a_log_it_has_not_seen(
    identified: tuple[HybridModel, HybridModel],
) -> None:
    truth, model = identified
    unseen = log(truth, 2)
    run = model.simulate(unseen.t, unseen.v, float(unseen.q[0]), 0.0)
    assert run.status == "ok"
    assert np.ptp(unseen.q) > 0.03
    assert np.sqrt(np.mean((run.q - unseen.q) ** 2)) < 0.01 * np.ptp(unseen.q)


@pytest.mark.parametrize(
    ("name", "widths", "part", "seconds"),
    [("log charging time", 2.0, "charging", 1e-3 * np.exp(3.0)), ("delay", 2.5, "delay", 15e-3)],
)
def test_electrodes_that_charge_slowly_and_recorders_that_began_apart_are_seen(
    name: str, widths: float, part: str, seconds: float
) -> None:
    truth = joint({name: widths})
    assert getattr(truth.joint.instruments(truth.theta), part) == pytest.approx(seconds)
    model = identify_hybrid([log(truth, 1)], NOMINAL)
    found = getattr(model.joint.instruments(model.theta), part) * model.joint.similarity.time
    assert found == pytest.approx(seconds, abs=1e-3, rel=0.1 if part == "charging" else 0.0)
    unseen = log(truth, 2)
    run = model.simulate(unseen.t, unseen.v, float(unseen.q[0]), 0.0)
    assert np.sqrt(np.mean((run.q - unseen.q) ** 2)) < 0.01 * np.ptp(unseen.q)


def test_bands_of_curves_leave_force_and_damping_open_where_no_correction_acts(
    identified: tuple[HybridModel, HybridModel],
) -> None:
    truth, model = identified
    assert model.joint.centres == 0 and model.of_curves.joint.centres == BASIS_FUNCTIONS
    q = np.linspace(-0.012, 0.012, 25)
    expected, found, known = model.curves(q), model.of_curves.curves(q), truth.curves(q)
    closed = replace(model, curve_spread=model.band_spread).curve_ensemble(q, 400)
    opened = model_from_tree("hybrid", model.to_tree()).curve_ensemble(q, 400)
    for name, values in expected.items():
        np.testing.assert_allclose(found[name], values, rtol=1e-9, atol=1e-9 * np.abs(values).max())
    for name in ("F", "dC1_dq", "dC2_dq"):
        low, high = np.percentile(opened[name], [0.5, 99.5], axis=0)
        assert np.mean((low < known[name]) & (known[name] < high)) > 0.9, name
    assert np.all(opened["F"].std(axis=0) > 0.95 * closed["F"].std(axis=0))
    assert opened["F"].std(axis=0).mean() > 1.02 * closed["F"].std(axis=0).mean()


def test_planted_parameters_come_back(identified: tuple[HybridModel, HybridModel]) -> None:
    truth, model = identified
    believed = replace(truth, spread=np.linalg.inv(prior_root(0)))
    # Of the device, at its size: what the log leaves open against what the drawing does, both by their central 90 %
    left_open = [{one.name.split(",")[0]: one for one in calibrated(known)} for known in (model, believed)]
    for name in PLANTED:
        j = condensed_parameters.NAMES.index(name)
        assert abs(model.theta[j] - truth.theta[j]) < 0.35, name
        by_log, by_drawing = (found[name.replace("log ", "")] for found in left_open)
        if "log" in name:
            assert np.log(by_log.high / by_log.low) < 0.5 * np.log(by_drawing.high / by_drawing.low), name
        else:
            assert by_log.high - by_log.low < 0.5 * (by_drawing.high - by_drawing.low), name


def test_what_the_laser_did_not_see_does_not_count() -> None:
    """A truth that is held to its own log has no error, whatever stands in a gap of it."""
    truth = joint(PLANTED)
    whole = log(truth, 1)
    for pole in (60.0, 30.0, 8.0):
        errors = [CondensedProblem(truth.joint, [one]).residual(truth.theta, pole) for one in (whole, gapped(whole))]
        seen, gap = (float(np.abs(error).max()) for error in errors if error is not None)
        assert gap < 1.1 * seen < 0.03, pole  # mm


def test_a_run_is_held_where_it_takes_another_well_and_nowhere_else() -> None:
    truth, wrong = joint(PLANTED), joint(PLANTED | {"right.log C0": -2.0})
    problem = CondensedProblem(truth.joint, [log(truth, 1)])
    lost = problem.residual(wrong.theta, 0.0)
    problem.hold_lost(wrong.theta, 0.0)
    held = problem.residual(wrong.theta, 0.0)
    assert lost is not None
    assert held is not None
    assert np.abs(lost).max() > 10.0  # mm
    assert np.abs(held).max() < 5.0
    assert 0.0 < problem.held_share < 0.5
    problem.hold_lost(truth.theta, 0.0)
    assert problem.held_share == 0.0


@pytest.mark.parametrize("pole", [8.0, 0.0])
def test_a_log_that_begins_in_motion_is_compared_from_where_its_hidden_states_are_known(pole: float) -> None:
    truth = joint(PLANTED)
    whole = log(truth, 1)
    begin = int(np.argmax(np.abs(whole.qdot)))  # on its way from one well to the other
    problem = CondensedProblem(truth.joint, [whole.part(begin, len(whole.t))])
    error = problem.residual(truth.theta, pole)
    assert error is not None
    assert np.abs(error).max() < 0.02 * 1e3 * np.ptp(whole.q)  # mm
    assert problem.held_share == 0.0
    assert len(error) == len(whole.t) - begin - 100


def test_the_tree_goes_round(identified: tuple[HybridModel, HybridModel]) -> None:
    _, model = identified
    again = model_from_tree("hybrid", model.to_tree())
    t, v = pulses(4, 4.0)
    np.testing.assert_array_equal(again.simulate(t, v, -0.01, 0.0).q, model.simulate(t, v, -0.01, 0.0).q)
    assert again.describe() == model.describe()
    tree = model.to_tree()
    del tree["theta"]
    with pytest.raises(CorruptArtifactError, match="theta"):
        model_from_tree("hybrid", tree)
    with pytest.raises(CorruptArtifactError, match="another version of debist"):
        model_from_tree("hybrid", model.to_tree() | {"constants": "l | bending"})
    narrower = model.to_tree()["prior_std"] * np.where(np.array(condensed_parameters.NAMES) == "delay", 1.0 / 3.0, 1.0)
    with pytest.raises(CorruptArtifactError, match="another version of debist"):
        model_from_tree("hybrid", model.to_tree() | {"prior_std": narrower})  # θ would mean another delay


@pytest.mark.parametrize("volts", [5e3, 1e6])
def test_no_voltage_drives_it_out_of_bounds(volts: float) -> None:
    model = joint(PLANTED)
    t, v = pulses(5, 5.0)
    run = model.simulate(t, v / 3e3 * volts, 0.01, 3.0)
    assert run.status == "ok"
    assert np.abs(run.q).max() <= model.joint.q_stop + 1e-9
    assert model.joint.q_stop <= 1.5 * -model.joint.basis[0]


def test_a_joint_softens_from_the_beginning_of_a_recording_whatever_its_clock_counts_from() -> None:
    model = joint({"softening": 3.0})
    t, v = pulses(5, 5.0)
    fresh, epoch, later = (model.simulate(t + begun, v, -0.0105, 0.0).q for begun in (0.0, 1e6, 600.0))
    assert epoch == pytest.approx(fresh, abs=1e-7)  # the clock's own rounding
    assert np.abs(later - fresh).max() > 1e-4
    moved = log(model, 1, 5.0)
    errors = [CondensedProblem(model.joint, [replace(moved, t=moved.t + t)]) for t in (0.0, 1e6)]
    one, other = (problem.residual(model.theta, 0.0) for problem in errors)
    assert one is not None and other == pytest.approx(one, abs=1e-4)  # mm


WRONG = {"left.log C0": 5.0, "log E": 5.0}
"""So far off that the joint no longer follows a log of the drawing."""


def given(*records: Log) -> Training:
    return Training((), records, JOINT, NOMINAL, None, Identify())


def test_a_hybrid_joint_that_follows_its_logs_is_taken() -> None:
    def never(_: object) -> HybridModel:
        raise AssertionError

    truth = joint({})
    choice = choose(given(log(truth, 1)), lambda _: truth, never)
    assert choice.model is truth
    assert choice.other is None
    assert choice.to_json()["chosen"] == "hybrid"


def test_what_predicts_the_unseen_rest_better_is_taken() -> None:
    truth, wrong = joint({}), joint(WRONG)
    training, seen = given(log(truth, 1)), list[int]()

    def alone(part: Training) -> HybridModel:
        seen.append(len(part.records[0].t))
        return truth

    choice = choose(training, lambda _: wrong, alone)
    assert choice.model is truth
    assert choice.other is wrong
    assert choice.held_out["rbf"] < 0.001 < 0.01 < choice.held_out["hybrid"]
    assert choice.to_json()["ablation"]["rbf_alone"] == choice.held_out["rbf"]
    length = len(training.records[0].t)
    assert seen == [round(0.75 * length), length]


def test_a_network_that_is_not_surely_nearer_does_not_replace_the_equations() -> None:
    truth, soft, stiff = joint({}), joint({"log E": -0.05}), joint({"log E": 0.05})
    training = given(log(truth, 1, 24.0))
    choices = [choose(training, lambda _: a, lambda _: b) for a, b in ((soft, stiff), (stiff, soft))]  # noqa: B023
    assert [choice.model for choice in choices] == [soft, stiff]
    for choice in choices:
        assert choice.interval is not None and choice.interval.low < choice.held_out["hybrid"] < choice.interval.high
        assert choice.excess is not None and choice.excess.low < 0.0 < choice.excess.high


def test_data_alone_where_no_hybrid_joint_can_be_tied_to_the_logs() -> None:
    def refused(_: object) -> HybridModel:
        raise DataRefusedError("no simulation follows")

    truth = joint({})
    assert choose(given(log(truth, 1)), refused, lambda _: truth).model is truth


def test_hidden_states_come_from_the_measurement_before_a_restart() -> None:
    """In the midst of its own motion a joint goes on as it did, where one that had rested before goes another way."""
    truth, (t, v), ahead = joint(PLANTED), pulses(3, 9.0), np.array([15])
    moving = truth.simulate(t, v, -0.0105, 0.0)
    seen, starts = moving.q.copy(), np.arange(110, 880, 40)
    seen[335:346] = np.nan
    shown = predictor(truth)(t, v, seen, moving.qdot, starts, np.repeat(ahead, len(starts)))
    errors = []
    for start, run in zip(starts, shown, strict=True):
        rows = slice(start, start + 16)
        (rested,) = predictor(truth)(t[rows], v[rows], seen[rows], moving.qdot[rows], np.zeros(1, np.int64), ahead)
        errors.append([float(np.max(np.abs(path - moving.q[rows]))) for path in (run, rested)])
    after, rested = np.median(errors, axis=0)
    assert after < 0.02 * rested
    assert np.max(errors, axis=0)[0] < 1e-3 * np.ptp(moving.q)


@pytest.mark.parametrize("step", [0.03, 0.05, 0.1, 0.25])
def test_coarse_samples_are_simulated_as_fine_ones(step: float) -> None:
    """The integrator's step does not grow with the sample interval."""
    model, v = hybrid(), np.array([2000.0, 0.0])
    fine = 0.01 * np.arange(201)
    coarse = fine[:: round(step / 0.01)]
    q = [model.simulate(t, np.tile(v, (len(t), 1)), -0.0105, 0.0).q for t in (fine, coarse)]
    np.testing.assert_allclose(q[1], q[0][:: round(step / 0.01)], atol=2e-3 * np.ptp(q[0]))
