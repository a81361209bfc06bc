"""Instruments by the score test: planted errors come back, honest logs are silent, corrections undo errors."""

from collections.abc import Sequence
from dataclasses import dataclass, field, replace

import numpy as np
import pytest

from pipeline.device.parameters import NOMINAL
from pipeline.diagnostics.instruments import SIGNIFICANCE, InstrumentTest, Reading
from pipeline.diagnostics.series import instrument_facts
from pipeline.models.hybrid.model import HybridModel
from pipeline.models.hybrid.parameters import DEVIATIONS as PARAMETERS, NAMES as DEVIATIONS, static_slope_ratio
from pipeline.models.hybrid.problem import CondensedJoint, CondensedProblem
from pipeline.numerics.arrays import FloatArray
from pipeline.rig.excitation import command, random_excitation
from pipeline.signals.findings import Number
from pipeline.signals.log import Corrections, Log, corrected, exchanged, mirrored

PRIOR_STD = {entry.name: entry.prior_std for entry in PARAMETERS}
DURATION, INTERVAL, FINE, NOISE = 8.0, 0.01, 10, 2e-6


def _log(model: HybridModel, seed: int) -> Log:
    """Pulses of both voltages, and q of the model with the noise of a laser."""
    rng = np.random.default_rng(seed)
    t = INTERVAL * np.arange(round(DURATION / INTERVAL))
    fine = INTERVAL / FINE * np.arange(FINE * len(t))
    v = command(random_excitation(rng, duration=DURATION, excitation="pulses"), fine).reshape(len(t), FINE, 2)
    run = model.simulate(t, v, 0.0112, 0.0)
    return Log(t, run.q + NOISE * rng.standard_normal(len(t)), run.qdot, run.qddot, v[:, 0], fine=v)


JOINT = CondensedJoint(NOMINAL, np.array([-0.025, 0.01, 0.008]), 0, 3000.0, static_slope_ratio(NOMINAL))


def _joint(**deviations: float) -> HybridModel:
    """A joint whose left membrane is stronger than the right one, and that deviates from that as given."""
    theta = JOINT.start()
    for name, value in {"left.log C0": 0.5, **deviations}.items():
        theta[DEVIATIONS.index(name)] = value
    return HybridModel.of(JOINT, theta, np.zeros((len(theta), 0)), np.zeros((len(theta), 0)))


@pytest.fixture(scope="module")
def logs() -> list[Log]:
    return [_log(_joint(), seed) for seed in (1, 2, 3)]


@pytest.fixture(scope="module")
def model(logs: list[Log]) -> HybridModel:
    """The joint, and what a fit to the first log would leave open of it."""
    joint = _joint()
    _, by_theta = CondensedProblem(JOINT, [logs[0]]).jacobian(joint.theta, 2.0)
    _, singular, turned = np.linalg.svd(by_theta / (1e3 * NOISE), full_matrices=False)
    return replace(joint, spread=turned.T / np.sqrt(1.0 + singular**2))


@pytest.fixture(scope="module")
def instruments(model: HybridModel, logs: list[Log]) -> InstrumentTest:
    return InstrumentTest(model, [[logs[0]]])


def _beyond(reading: Reading, instruments: InstrumentTest) -> dict[str, float]:
    rows = zip(instruments.quantities.items(), reading.estimate, reading.standard_error, strict=True)
    return {name: x for (name, limit), x, error in rows if abs(x) > max(SIGNIFICANCE * error, limit)}


PLANTED = {
    "nothing": (Corrections((1.0, 1.0)), {}),
    "gains": (Corrections((1.03, 0.98)), {"gain_v1": 0.03, "gain_v2": -0.02}),
    "laser": (Corrections((1.0, 1.0), 1e-4, 1.02), {"zero_q": 1e-4, "gain_q": 0.02}),
    "recorder": (Corrections((1.0, 1.0), delay=2.5e-3, clock=1.01), {"delay": 2.5e-3, "clock": 0.01}),
    "far": (Corrections((1.1, 1.0), delay=0.03), {"gain_v1": 0.1, "delay": 0.03}),
}


@pytest.mark.parametrize("name", PLANTED)
def test_planted_errors_come_back(name: str, instruments: InstrumentTest, logs: list[Log]) -> None:
    errors, wanted = PLANTED[name]
    reading = instruments.of([corrected(logs[1], errors)])
    found = _beyond(reading, instruments)
    assert found.keys() == wanted.keys()
    assert found == pytest.approx(wanted, rel=0.1)
    assert reading.status == "measured"


def test_corrections_undo_the_errors(instruments: InstrumentTest, logs: list[Log]) -> None:
    wrong = corrected(logs[1], Corrections((1.05, 1.0), 3e-4, 0.99, 4e-3, 1.005))
    by = instruments.of([wrong]).corrections
    assert _beyond(instruments.of([corrected(wrong, by)]), instruments) == {}


def test_exchanged_inputs_and_a_mirrored_q_are_named(instruments: InstrumentTest, logs: list[Log]) -> None:
    assert instruments.of([exchanged(logs[1])]).exchange == "inputs"
    assert instruments.of([mirrored(logs[1])]).exchange == "sign"
    assert instruments.of([logs[1]]).exchange == "none"


def test_of_two_training_logs_each_is_the_reference_of_the_other(model: HybridModel, logs: list[Log]) -> None:
    wrong = corrected(logs[1], Corrections((0.97, 1.0)))
    instruments = InstrumentTest(model, [[logs[0]], [wrong]])
    first, second = (instruments.of_training[number].estimate[0] for number in (0, 1))
    assert second == pytest.approx(-0.03, rel=0.1)
    assert first == pytest.approx(0.03, rel=0.1)


def test_what_training_logs_differ_by_is_no_sure_reading_of_another(model: HybridModel, logs: list[Log]) -> None:
    """Readings x₁ − x₂ = 0.03 have the variance 0.03²/2, and a third one less their mean 1.5 times that."""
    wrong = corrected(logs[1], Corrections((0.97, 1.0)))
    alike, unlike = (InstrumentTest(model, [[logs[0]], [second]]).of([logs[2]]) for second in (logs[1], wrong))
    assert unlike.standard_error[0] == pytest.approx(0.03 * np.sqrt(0.75), rel=0.1)
    assert alike.standard_error[0] < 1e-3
    assert unlike.standard_error[1] < 2e-3


def test_small_errors_of_a_model_on_one_training_log_hide_no_instrument(model: HybridModel, logs: list[Log]) -> None:
    """They are sure, as nothing errs in the other log, but below what an instrument causes at its limit."""
    bent = replace(logs[1], q=logs[1].q + 30e-6 * np.sin(10.0 * np.pi * logs[1].t))
    instruments = InstrumentTest(model, [[logs[0]], [corrected(bent, Corrections((0.97, 1.0)))]])
    first, second = (instruments.of_training[number] for number in (0, 1))
    assert first.unlike < -1.0
    assert second.unlike > 1.0
    assert first.estimate[0] == pytest.approx(0.03, rel=0.1)
    assert second.estimate[0] == pytest.approx(-0.03, rel=0.1)


def test_a_log_of_another_device_is_recognised(instruments: InstrumentTest) -> None:
    other = _joint(**{"log E": 0.5, "left.log Y": -0.5})
    assert instruments.of([_log(other, 2)]).status == "another device"


def test_a_model_that_no_run_follows_measures_nothing(model: HybridModel, logs: list[Log]) -> None:
    far = replace(model, theta=np.full(len(model.theta), 7.0))
    reading = InstrumentTest(far, [[logs[0]]]).of([logs[1]])
    assert reading.status == "not measured"
    assert np.isnan(reading.estimate).all()


def test_derivatives_by_corrections_hardly_depend_on_their_step(instruments: InstrumentTest, logs: list[Log]) -> None:
    whole = instruments._linearised([logs[1]], np.zeros(6))
    assert whole is not None
    for k in range(6):
        ahead, behind = (instruments._residual([logs[1]], side * 0.1 * np.eye(6)[k]) for side in (1.0, -1.0))
        assert ahead is not None
        assert behind is not None
        by = (ahead - behind) / 0.2
        assert np.linalg.norm(whole.by_corrections[:, k] - by) < 0.1 * np.linalg.norm(by)


def test_a_run_with_sensitivities_leaves_the_residual_of_a_run_without(
    instruments: InstrumentTest, logs: list[Log]
) -> None:
    """One-sided differences subtract one from the other."""
    problem, gain, _ = instruments._problem([logs[1]], np.zeros(6))
    theta = instruments._model.theta
    assert problem.residual(theta, gain) == pytest.approx(problem.jacobian(theta, gain)[0], rel=0.0, abs=1e-12)


def test_corrections_one_after_the_other_are_those_of_both(logs: list[Log]) -> None:
    first = Corrections((1.02, 0.9), 1e-4, 1.01, 0.0, 0.99)
    second = Corrections((0.99, 1.1), -2e-4, 0.98, 2e-3, 1.02)
    one, both = corrected(corrected(logs[0], first), second), corrected(logs[0], first.then(second))
    np.testing.assert_allclose(one.q, both.q, rtol=1e-12, atol=1e-12)
    np.testing.assert_allclose(one.t, both.t, rtol=1e-12)
    np.testing.assert_allclose(one.drive, both.drive, atol=1e-6)
    assert first.then(second).act


def _facts(instruments: InstrumentTest, log: Log) -> dict[str, tuple[str, Number]]:
    """What a series shows of the instruments of a later run, beyond four standard errors: titles and numbers."""
    return {
        key: (title, number)
        for key, title, number in instrument_facts(instruments, [log], "m")
        if abs(number.value) > SIGNIFICANCE * number.error
    }


def test_a_series_holds_drifts_of_instruments_apart_from_those_of_the_device(
    instruments: InstrumentTest, logs: list[Log]
) -> None:
    drifted = _facts(instruments, corrected(logs[1], Corrections((1.0, 1.0), 1e-4)))
    assert drifted.keys() == {"reading_zero_q"}
    _, zero = drifted["reading_zero_q"]
    assert zero.value == pytest.approx(1e-4, rel=0.1)
    assert zero.unit == "m"
    stiffer = _log(_joint(**{"log E": 0.5}), 2)
    assert not list(instrument_facts(instruments, [stiffer], "m")), "no instrument explains a stiffer beam"


def test_more_capacitance_reads_as_voltages_that_are_low(instruments: InstrumentTest) -> None:
    """The force goes with C v²: logs of q and v hold 2 % of the voltage for 4 % of the capacitance."""
    more = {name: 0.04 / PRIOR_STD[name] for name in ("left.log C0", "right.log C0")}
    aged = _log(_joint(**{**more, "left.log C0": 0.5 + more["left.log C0"]}), 2)
    read = _facts(instruments, aged)
    assert read.keys() == {"reading_gain_v1", "reading_gain_v2"}
    assert [number.value for _, number in read.values()] == pytest.approx([-0.02, -0.02], rel=0.2)
    assert all("or of the device" in title for title, _ in read.values())


GRAVITY, DAMPING, TORQUE = 40.0, 1.5, 60.0


def _pendulum(theta: FloatArray, log: Log, gain: float, start: tuple[float, float]) -> FloatArray:
    """Angle [rad] of q̈ = k v − g sin q − d q̇ under an observer, by the midpoint rule between the samples."""
    strength, weight, damping = theta
    x, p = start
    angles = []
    h = 0.5 * log.interval
    for n in range(len(log.t)):
        angles.append(x)
        ends = log.q[n], log.q[min(n + 1, len(log.t) - 1)]
        drive = log.fine[n, :, 0]
        for place in (0, 1):
            middle = ends[0] + (0.25 + 0.5 * place) * (ends[1] - ends[0])
            v = drive[(5 * place + 2)]

            def rates(x: float, p: float, v: float = v, seen: float = middle) -> tuple[float, float]:
                error = seen - x
                return p + 2.0 * gain * error, (strength * v - weight * np.sin(x) - damping * p + gain**2 * error)

            dx, dp = rates(x, p)
            dx, dp = rates(x + 0.5 * h * dx, p + 0.5 * h * dp)
            x, p = x + h * dx, p + h * dp
    return np.array(angles)


@dataclass(frozen=True)
class _PendulumProblem:
    log: Log

    def residual(self, theta: FloatArray, gain: float) -> FloatArray:
        return _pendulum(theta, self.log, gain, (self.log.q[0], self.log.qdot[0])) - self.log.q

    def jacobian(self, theta: FloatArray, gain: float) -> tuple[FloatArray, FloatArray]:
        steps = 1e-4 * np.diag(theta)
        columns = [(self.residual(theta + s, gain) - self.residual(theta - s, gain)) / (2.0 * s.sum()) for s in steps]
        return self.residual(theta, gain), np.column_stack(columns)


@dataclass(frozen=True)
class _PendulumModel:
    """A driven pendulum with 1 % of uncertainty in each parameter."""

    theta: FloatArray = field(default_factory=lambda: np.array([TORQUE, GRAVITY, DAMPING]))
    coupling: float = 20.0

    @property
    def spread(self) -> FloatArray:
        return 0.01 * np.diag(self.theta)

    def observed(self, parts: Sequence[Log]) -> _PendulumProblem:
        return _PendulumProblem(parts[0])


def _angle_log(seed: int, size: float = 0.15, noise: float = 2e-4) -> Log:
    """An angle [rad] under sines of one linear input, with noise [rad]."""
    rng = np.random.default_rng(seed)
    t = INTERVAL * np.arange(800)
    times = INTERVAL / FINE * np.arange(FINE * len(t))
    phases = rng.uniform(0.0, 2.0 * np.pi, 8)
    sines = np.sin(2.0 * np.pi * np.outer(times, np.linspace(0.2, 2.5, 8)) + phases).sum(axis=1)
    fine = size * sines.reshape(len(t), FINE, 1)
    still = Log(t, 0.0 * t, 0.0 * t, 0.0 * t, fine[:, 0], fine=fine)
    q = _pendulum(_PendulumModel().theta, still, 0.0, (0.0, 0.0)) + noise * rng.standard_normal(len(t))
    return replace(still, q=q)


def test_instruments_of_an_angle_under_one_linear_input() -> None:
    """A pendulum: gravity sets the scale of the angle, and no other model or unit is in the way."""
    instruments = InstrumentTest(_PendulumModel(), [[_angle_log(1)]])
    assert list(instruments.quantities) == ["gain_v1", "zero_q", "gain_q", "delay", "clock"]
    assert _beyond(instruments.of([_angle_log(2)]), instruments) == {}
    wrong = corrected(_angle_log(2), Corrections((1.03,), 0.02, 1.02, 2.5e-3))
    found = _beyond(instruments.of([wrong]), instruments)
    assert found == pytest.approx({"gain_v1": 0.03, "zero_q": 0.02, "gain_q": 0.02, "delay": 2.5e-3}, rel=0.15)


def test_a_linear_device_with_model_errors_does_not_hide_a_delay() -> None:
    """Small swings are linear: gains of zero would leave no residual, were its noise not that of the raw reading."""
    instruments = InstrumentTest(
        _PendulumModel(np.array([TORQUE, GRAVITY, 1.05 * DAMPING])), [[_angle_log(1, 0.003, 0.0)]]
    )
    late = instruments.of([corrected(_angle_log(2, 0.003, 0.0), Corrections((1.0,), delay=5e-3))])
    place = list(instruments.quantities).index("delay")
    assert late.status == "measured" and _beyond(late, instruments).keys() == {"delay"}
    assert abs(late.estimate[place] - 5e-3) < SIGNIFICANCE * late.standard_error[place]
