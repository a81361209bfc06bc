"""Whether logs of a device that is no joint are told to be of one, or of two."""

import numpy as np

from pipeline.checks.check import check_logs
from pipeline.checks.declared import Declared
from pipeline.checks.weak_form import LogSignals

FILM = Declared(squared=True, displacement="m", inputs=("V",), mass=None, sample_interval=0.004)
STEP = 0.001


def _film(name: str, drive: np.ndarray, *, mass: float = 1.0, damping: float = 3.0, lag: float = 0.0) -> LogSignals:
    """A spring of 14 Hz under a squared input behind a lag [s], with creep where there is one, and 2 µm of noise."""
    w, x, p, charge, creep = 2.0 * np.pi * 14.0, 0.0, 0.0, 0.0, 0.0
    q = np.empty(drive.size)
    for n, u in enumerate(drive):
        charge += STEP / (lag + STEP) * (u - charge)
        creep += STEP / 0.5 * (0.3 * x - creep) * (lag > 0.0)
        p += STEP * (w**2 * (charge**2 - x - x**3 - (0.3 * x - creep) * (lag > 0.0)) - damping * w * p) / mass
        x += STEP * p
        q[n] = x
    q = 8e-3 * q + 2e-6 * np.random.default_rng(0).standard_normal(q.size)
    return LogSignals(name, STEP * np.arange(q.size), q, 6e3 * drive[:, None], STEP)


def _sine(hertz: float) -> np.ndarray:
    return 0.5 - 0.5 * np.cos(2.0 * np.pi * hertz * STEP * np.arange(20_000))


def _levels(seed: int) -> np.ndarray:
    return np.repeat(np.random.default_rng(seed).uniform(0.0, 1.0, 200), 100)


def _state(first: LogSignals, other: LogSignals) -> str:
    (row,) = (row for row in check_logs([first, other], FILM) if row.what == "same device")
    return row.state


def test_logs_of_one_tone_of_a_film_with_lag_and_creep_are_of_one_device() -> None:
    logs = [_film(f"train/{hertz:g}", _sine(hertz), lag=0.012) for hertz in (3.0, 7.0, 11.0)]
    assert {_state(logs[0], other) for other in logs[1:]} <= {"ok", "not seen"}
    assert _state(logs[0], _film("train/levels", _levels(1), lag=0.012)) in ("ok", "not seen")


def test_seven_times_the_mass_is_another_device_where_the_law_is_that_of_the_check() -> None:
    first = _film("train/a", _levels(1), damping=0.4)
    assert _state(first, _film("train/b", _levels(2), damping=0.4)) == "ok"
    assert _state(first, _film("train/c", _levels(2), damping=0.4, mass=7.0)) == "note"


SLIDER = Declared(squared=False, displacement="m", inputs=("V",), mass=None, sample_interval=0.01)


def _slider(name: str, drive: np.ndarray, *, gain: float = 1.0) -> LogSignals:
    """A spring of 2 Hz with hysteresis, which makes small motions stiffer than large ones; its input read by a gain."""
    w, x, p, h = 2.0 * np.pi * 2.0, 0.0, 0.0, 0.0
    q = np.empty(drive.size)
    for n, u in enumerate(drive):
        h += STEP * (p - 2.0 * abs(p) * h)
        p += STEP * (w**2 * (u - x - 0.3 * h) - 3.0 * w * p)
        x += STEP * p
        q[n] = x
    q = 1e-3 * q + 1e-6 * np.random.default_rng(0).standard_normal(q.size)
    return LogSignals(name, STEP * np.arange(q.size), q, gain * drive[:, None], STEP)


def test_a_gain_that_hysteresis_makes_is_none_of_the_probe() -> None:
    """Slow levels show less stiffness than a fast multisine; a probe of another range is off by a factor."""
    rng, t = np.random.default_rng(5), STEP * np.arange(20_000)
    tones = np.sin(2.0 * np.pi * np.outer(t, np.linspace(0.1, 3.0, 40)) + rng.uniform(0.0, 2.0 * np.pi, 40)).sum(axis=1)
    slow = np.repeat(np.random.default_rng(2).uniform(-0.7, 0.7, 40), 500)
    first = _slider("train/a", tones / np.abs(tones).max())
    gains = {}
    for gain in (1.0, 3.0):
        rows = check_logs([first, _slider("train/b", slow, gain=gain)], SLIDER)
        gains[gain] = [(row.state, row.gate, row.values["gain"]) for row in rows if row.what.startswith("gain")]
    assert gains[1.0] == []
    ((state, gate, factor),) = gains[3.0]
    assert (state, gate) == ("note", None) and 1.0 / 4.5 < factor < 1.0 / 2.0
