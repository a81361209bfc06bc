"""The analytical model: processor times and errors. `OMP_NUM_THREADS=1 python benchmarks/bench_physics.py`.

Full-order and reduced simulation of 37.5 s of switching pulses at 10 ms and 1 ms, SciPy's LSODA and BDF on the same
equations (compiled right-hand side, so that the integrators are compared and not the languages), equilibria,
characteristic curves. Medians of five runs; compiled code is loaded beforehand.
"""

import os
import sys
import time
from pathlib import Path
from typing import Literal

os.environ.setdefault("OMP_NUM_THREADS", "1")
sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

import numpy as np
from measure import seconds
from scipy.integrate import solve_ivp

from pipeline.device.parameters import NOMINAL
from pipeline.generated import analytical_joint as kernels
from pipeline.models.analytical.bifurcation import characteristics
from pipeline.models.analytical.full_order import rest_state, simulate
from pipeline.models.analytical.reduced_order import pulse_sequence, reduce_joint, simulate_reduced
from pipeline.models.analytical.statics import equilibria

METHODS: tuple[Literal["LSODA", "BDF"], ...] = ("LSODA", "BDF")


def line(name: str, value: float, note: str = "") -> None:
    print(f"{name:<58} {1e3 * value:10.2f} ms  {note}")


def scipy_run(method: Literal["LSODA", "BDF"], t: np.ndarray, v: np.ndarray, x0: np.ndarray) -> np.ndarray:
    """Displacement [m] by SciPy, no step longer than the sample interval, so that it misses no pulse."""
    p, force = NOMINAL.vector(), np.zeros(1)
    mass, rates = np.empty((4, 4)), np.empty(11)

    def derivative(time: float, x: np.ndarray) -> np.ndarray:
        voltage = np.array([np.interp(time, t, v[:, side]) for side in range(2)])
        kernels.motion(np.ascontiguousarray(x), voltage**2, force, p, mass, rates)
        return np.concatenate([rates[:4], np.linalg.solve(mass, rates[4:8]), rates[8:]])

    path = solve_ivp(derivative, (t[0], t[-1]), x0, method, t, rtol=1e-5, atol=1e-7, max_step=t[1] - t[0]).y
    return np.asarray(path[:3].T @ NOMINAL.l ** np.arange(2, 5))


def main() -> None:
    start = equilibria(NOMINAL, np.zeros(2))[0].q
    reduced = reduce_joint(NOMINAL)
    for dt in (1e-2, 1e-3):
        t, v = pulse_sequence(count=25, dt=dt)
        x0 = rest_state(NOMINAL, start, 0.0, v[0])
        truth = simulate(NOMINAL, t, v, x0, tolerance=1e-8)
        for tolerance in (1e-4, 1e-5, 1e-6):
            run = simulate(NOMINAL, t, v, x0, tolerance=tolerance)
            spent = seconds(lambda: simulate(NOMINAL, t, v, x0, tolerance=tolerance))  # noqa: B023
            error = np.abs(run.q - truth.q).max()
            note = f"{run.accepted} steps, largest error of q {1e9 * error:.1f} nm"
            line(f"full order, {t[-1]:.1f} s at {1e3 * dt:.0f} ms, tolerance {tolerance:g}", spent, note)
        spent = seconds(lambda: simulate_reduced(reduced, t, v, start, 0.0))  # noqa: B023
        line(f"reduced, {t[-1]:.1f} s at {1e3 * dt:.0f} ms", spent)
    t, v = pulse_sequence(count=1, dt=1e-2)
    x0 = rest_state(NOMINAL, start, 0.0, v[0])
    truth = simulate(NOMINAL, t, v, x0, tolerance=1e-8)
    line(f"full order, {t[-1]:.1f} s of a pulse at 10 ms", seconds(lambda: simulate(NOMINAL, t, v, x0, tolerance=1e-5)))
    for method in METHODS:
        begin = time.process_time()
        error = np.abs(scipy_run(method, t, v, x0) - truth.q).max()
        spent = time.process_time() - begin
        line(f"SciPy {method}, {t[-1]:.1f} s of a pulse at 10 ms", spent, f"error of q {1e9 * error:.1f} nm")
    line("all equilibria at one load", seconds(lambda: equilibria(NOMINAL, np.zeros(2))))
    line("curves: diagram, F(q), C(q), limits", seconds(lambda: characteristics(NOMINAL), 1))


if __name__ == "__main__":
    main()
