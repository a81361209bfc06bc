"""Calibration recovers planted parameters and tells what it cannot know."""

import numpy as np
import pytest

from pipeline.device.parameters import NOMINAL, JointParameters
from pipeline.errors import InputError
from pipeline.models.analytical.calibration import calibrate
from pipeline.models.analytical.full_order import rest_state, simulate
from pipeline.models.analytical.reduced_order import pulse_sequence
from pipeline.models.analytical.statics import equilibria
from pipeline.models.analytical.windows import cut_windows, error_derivatives, simulate_windows
from pipeline.signals.log import Log


def log_of(joint: JointParameters, noise: float = 0.0, seed: int = 0, count: int = 6, dt: float = 0.01) -> Log:
    """A simulated log of pulses of both sides and of both together."""
    t, v = pulse_sequence(count=count, dt=dt)
    v[750:] = np.maximum(v[750:], 0.6 * v[750:, ::-1])
    run = simulate(joint, t, v, rest_state(joint, equilibria(joint, v[0])[0].q, 0.0, v[0]), tolerance=1e-6)
    measured = run.q + noise * np.random.default_rng(seed).standard_normal(t.size)
    return Log(t, measured, run.qdot, run.qddot, v)


def test_true_parameters_leave_no_error() -> None:
    truth = NOMINAL.with_values({"right.Y": 1.17e6, "F_c": 2e-3})
    motion = log_of(truth)
    windows = cut_windows([motion], 1.0)
    errors = simulate_windows(truth, windows).errors
    assert errors.size == windows.samples == windows.labels.size
    # The first window starts exactly; the others from a shape that q and its rate tell to first order.
    assert np.abs(errors[windows.labels == 0]).max() < 1e-6
    assert np.sqrt(np.mean(errors**2)) < 0.03 * np.sqrt(np.mean(simulate_windows(NOMINAL, windows).errors ** 2))


def test_derivatives_are_those_of_the_simulated_windows() -> None:
    names = ("left.Y", "eta", "right.eta_MW", "right.eps_r", "F_c")
    joint = NOMINAL.with_values({"F_c": 2e-3})
    windows = cut_windows([log_of(NOMINAL.with_values({"right.Y": 1.17e6, "F_c": 2e-3}), count=2, dt=5e-3)], 2.5)
    sizes = np.array([joint.value(name) or 0.1 for name in names])

    def moved(share: float) -> list[JointParameters]:
        steps = zip(names, share * sizes, strict=True)
        return [joint.with_values({name: joint.value(name) + step}) for name, step in steps]

    def simulated(share: float) -> np.ndarray:
        return np.stack([simulate_windows(point, windows, 1e-7).errors for point in moved(share)], axis=1)

    found = error_derivatives(simulate_windows(joint, windows, 1e-6), moved(1e-5), 1e-5 * sizes)
    wanted = (simulated(3e-4) - simulated(-3e-4)) / (6e-4 * sizes)
    assert (np.linalg.norm(found - wanted, axis=0) < 0.02 * np.linalg.norm(wanted, axis=0)).all()


def test_planted_parameters_come_back() -> None:
    planted = {"E": 1.72e9, "left.Y": 1.22e6, "right.Y": 1.16e6, "eta": 4.5e6, "right.eps_r": 3.0}
    said: list[float] = []
    fit = calibrate(
        [log_of(NOMINAL.with_values(planted), noise=1e-5)],
        NOMINAL,
        names=tuple(planted),
        jobs=2,
        report=lambda text, share: said.append(share),
    )
    assert fit.values == pytest.approx(list(planted.values()), rel=0.01)
    assert (np.abs(fit.values - list(planted.values())) < 6.0 * fit.standard_errors + 0.003 * fit.values).all()
    assert fit.rmse < 3e-4 and fit.converged and not fit.at_bound
    assert np.diag(fit.correlation) == pytest.approx(1.0) and np.abs(fit.correlation).max() < 1.0 + 1e-9
    assert said == sorted(said)


@pytest.mark.parametrize(
    ("name", "reason"),
    [
        ("Z", "unknown parameter 'Z'"),
        ("left.E", "unknown parameter 'left.E'"),
        ("l", "'l' cannot be calibrated; possible"),
    ],
)
def test_a_parameter_that_is_not_calibrated_is_refused(name: str, reason: str) -> None:
    with pytest.raises(InputError, match=reason):
        calibrate([], NOMINAL, names=("E", name))


def test_what_a_log_does_not_tell_stays_where_it_was() -> None:
    t = np.arange(0.0, 2.0, 0.01)
    still = equilibria(NOMINAL, np.zeros(2))[0].q
    rest = Log(t, np.full(t.size, still), np.zeros(t.size), np.zeros(t.size), np.zeros((t.size, 2)))
    fit = calibrate([rest], NOMINAL, names=("eta", "E"))
    assert fit.values[0] == pytest.approx(NOMINAL.eta, rel=1e-3)
    # Its uncertainty is the prior's, a factor of two; that of the modulus is far below its prior's.
    assert fit.standard_errors[0] / NOMINAL.eta == pytest.approx(np.log(2.0), rel=0.05)
    assert fit.standard_errors[1] / NOMINAL.E < 0.3 * np.log(1.1)
