"""Figures of docs/explanation/differentiation.md: `python benchmarks/differentiation_figures.py`."""

import os
import sys
from pathlib import Path
from typing import Any

os.environ.setdefault("OMP_NUM_THREADS", "1")

import matplotlib
import numpy as np

matplotlib.use("svg")
ROOT = Path(__file__).resolve().parents[1]
sys.path[:0] = [str(ROOT), str(ROOT / "tests" / "signals")]  # the signals are shared with the tests

import differentiation_signals as signals  # noqa: E402 - after the path to it
import matplotlib.pyplot as plt  # noqa: E402
from matplotlib.figure import Figure  # noqa: E402
from scipy.integrate import solve_ivp  # noqa: E402

from pipeline.numerics.tvregdiff import Order  # noqa: E402
from pipeline.signals.differentiate import alpha_study, differentiate  # noqa: E402
from pipeline.signals.resampling import decimated  # noqa: E402

FIGURES = ROOT / "docs" / "figures"
NOISE = 0.003
ORDERS: tuple[Order, ...] = (1, 2, 3, 4)
STYLE: Any = {"svg.hashsalt": "debist", "font.size": 8, "axes.spines.top": False, "axes.spines.right": False}


def rms(error: np.ndarray) -> float:
    return float(np.sqrt(np.mean(error**2)))


def save(figure: Figure, name: str) -> None:
    figure.savefig(FIGURES / f"differentiation-{name}.svg", metadata={"Date": None})
    plt.close(figure)


def alpha() -> None:
    """Over- and under-smoothing, as fig. 11c: one switch, 10 ms samples, order 1."""
    record = signals.ring_down(400, 0.01, (2.8, 4.0))
    samples = record.noisy(NOISE, np.random.default_rng(1))
    t = record.dt * np.arange(samples.size)
    study = alpha_study(samples, record.dt, np.array([1e-5, 1e-2, 1.0]), epsilon=1e-6)
    figure, axes = plt.subplots(2, 3, figsize=(7.5, 3.6), sharex=True, sharey="row", layout="constrained")
    shown = slice(30, 130)
    rows = (
        (1.0, record.first, study.qdot, "velocity [mm/s]"),
        (1e-3, record.second, study.qddot, "acceleration [m/s²]"),
    )
    for row, (scale, truth, found, label) in zip(axes, rows, strict=True):
        for axis, derivative in zip(row, found, strict=True):
            axis.plot(t[shown], scale * truth[shown], color="0.7", lw=2.5, label="truth")
            axis.plot(t[shown], scale * derivative[shown], color="tab:red", lw=1.0, label="TVRegDiff, order 1")
        row[0].set_ylabel(label)
    for axis, a in zip(axes[0], study.alphas, strict=True):
        axis.set_title(f"α = $10^{{{round(np.log10(a))}}}$ mm s", fontsize=9)
    for axis in axes[1]:
        axis.set_xlabel("time [s]")
    axes[0, 0].legend(frameon=False)
    save(figure, "alpha")


def orders() -> None:
    """The acceleration after a switch for the four orders, parameters from the record."""
    record = signals.ring_down(10_000, 1e-3)
    samples = record.noisy(NOISE, np.random.default_rng(1))
    t = record.dt * np.arange(samples.size)
    figure, axes = plt.subplots(1, 4, figsize=(7.5, 2.0), sharey=True, layout="constrained")
    shown = slice(430, 700)
    for axis, order in zip(axes, ORDERS, strict=True):
        k = differentiate(samples, record.dt, order=order)
        axis.plot(t[shown], 1e-3 * record.second[shown], color="0.7", lw=2.5, label="truth")
        axis.plot(t[shown], 1e-3 * k.qddot[shown], color="tab:blue", lw=1.0, label="from the record")
        axis.set_title(f"order {order}", fontsize=9)
        axis.set_xlabel("time [s]")
    axes[0].set_ylabel("acceleration [m/s²]")
    axes[3].legend(frameon=False, fontsize=7)
    save(figure, "orders")


def rates() -> None:
    """RMS errors at 10 ms instants against the interval at which the 30 kHz record is differentiated."""
    fine = signals.ring_down(300_000, 1.0 / 30_000.0)
    t = fine.dt * np.arange(fine.value.size)
    samples = fine.noisy(NOISE, np.random.default_rng(5))
    intervals = np.array([fine.dt, 0.2e-3, 0.5e-3, 1e-3, 2e-3, 5e-3, 10e-3])
    errors = np.empty((4, 2, intervals.size))
    for j, interval in enumerate(intervals):
        steps = round(interval / fine.dt)
        grid = interval * np.arange(fine.value.size // steps)
        record = samples if steps == 1 else np.concatenate(list(decimated(t, [samples], grid, interval)), axis=1)[0]
        read = slice(None, None, round(0.01 / interval))
        for order in ORDERS:
            k = differentiate(record, interval, order=order)
            errors[order - 1, 0, j] = rms(k.qdot[read] - fine.first[::300])
            errors[order - 1, 1, j] = rms(k.qddot[read] - fine.second[::300])
    figure, axes = plt.subplots(1, 2, figsize=(6.0, 2.4), layout="constrained")
    for axis, which, unit in ((axes[0], 0, "velocity error [mm/s]"), (axes[1], 1, "acceleration error [mm/s²]")):
        for order in ORDERS:
            axis.loglog(1e3 * intervals, errors[order - 1, which], "o-", ms=3, lw=1, label=f"order {order}")
        axis.set_xlabel("differentiated at an interval of [ms]")
        axis.set_ylabel(unit)
    axes[0].legend(frameon=False)
    save(figure, "rates")
    print("interval [ms], then RMS velocity and acceleration errors of orders 1 to 4")
    for j, interval in enumerate(intervals):
        print(f"{1e3 * interval:7.3f}  " + "  ".join(f"{e[0, j]:.3g} {e[1, j]:.4g}" for e in errors))


def joint(time_constant: float, rate: float = 30_000.0) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Time, displacement, velocity, acceleration of a Duffing oscillator with wells at ±11 mm, switched every second.

    The force follows its command with a lag of first order, so the acceleration does not jump.
    """
    stiffness, well, damping = 0.5 * (2.0 * np.pi * 5.0) ** 2, 11.0, 6.0

    def acceleration(q: np.ndarray, v: np.ndarray, force: np.ndarray) -> np.ndarray:
        return np.asarray(stiffness * (q - q**3 / well**2) - damping * v + force)

    def rates_of_change(t: float, state: np.ndarray) -> list[float]:
        q, v, force = state
        command = 12_000.0 * (1 if t % 2.0 < 1.0 else -1) * (t % 1.0 < 0.05)
        return [v, acceleration(q, v, force), (command - force) / time_constant]

    t = np.arange(0.0, 8.0, 1.0 / rate)
    path = solve_ivp(rates_of_change, (0.0, 8.0), [-well, 0.0, 0.0], t_eval=t, rtol=1e-9, atol=1e-9,
                     max_step=0.5 * time_constant)  # fmt: skip
    q, v, force = path.y
    return t, q, v, acceleration(q, v, force)


def drives() -> None:
    """RMS errors at 10 ms instants of a record whose force takes a millisecond or five to follow."""
    print("time constant [ms], noise [mm], then RMS errors of orders 2, 3, 4")
    for time_constant in (1e-3, 5e-3):
        t, q, v, a = joint(time_constant)
        grid = 1e-3 * np.arange(float(t.size // 30))
        for noise in (0.0003, 0.003, 0.01):
            noisy = q + noise * np.random.default_rng(3).standard_normal(q.size)
            record = np.concatenate(list(decimated(t, [noisy], grid, 1e-3)), axis=1)[0]
            columns = []
            for order in ORDERS[1:]:
                k = differentiate(record, 1e-3, order=order)
                columns.append(f"{rms(k.qdot[::10] - v[::300]):.3g}/{rms(k.qddot[::10] - a[::300]):.4g}")
            print(f"{1e3 * time_constant:g}  {noise:g}  " + "  ".join(columns))


if __name__ == "__main__":
    with plt.rc_context(STYLE):
        alpha()
        orders()
        rates()
    drives()
