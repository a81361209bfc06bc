"""Processor time of a 37.5 s free run: `python benchmarks/bench_free_run.py`.

Ours, warm, next to `solve_ivp` (RK45 and LSODA at 1e-6) with the same right side written in NumPy; the largest
difference of q between ours and the tighter of them is printed too.
"""

import os
import time

os.environ.setdefault("OMP_NUM_THREADS", "1")

import numpy as np
from scipy.integrate import solve_ivp

from pipeline.identification.rbf import basis_centres
from pipeline.models.rbf_paper import RbfPaperModel

MASS, SAMPLES, INTERVAL = 0.04, 3750, 0.01


def joint() -> RbfPaperModel:
    centres = basis_centres(-0.02, 0.02, 10)
    stiffness, damping = 8.0 * (centres / 0.012) ** 2 - 8.0, 0.1 + 5.0 * np.abs(centres)
    gains = 4e-9 * (1.0 + 10.0 * centres), -4e-9 * (1.0 - 12.0 * centres)
    return RbfPaperModel(centres, 1.0, np.array([stiffness, damping, *gains]), 0.03, MASS)


def pulses(t: np.ndarray) -> np.ndarray:
    rng, v = np.random.default_rng(5), np.zeros((len(t), 2))
    for start in np.arange(0.5, t[-1], 1.3):
        v[(t >= start) & (t < start + 0.7), rng.integers(2)] = rng.uniform(1500, 3000)
    return v


def main() -> None:
    model, t = joint(), INTERVAL * np.arange(SAMPLES)
    v, start = pulses(t), [0.012, 0.0, 0.0]

    def slope(s: float, y: np.ndarray) -> list[float]:
        bells = np.exp(-((y[0] - model.centres) ** 2) / (2 * model.width**2))
        c, d, g1, g2 = model.weights @ bells
        left, right = np.interp(s, t, v[:, 0]), np.interp(s, t, v[:, 1])
        return [y[1], (-c * y[0] - d * y[2] + g1 * left**2 + g2 * right**2) / MASS, (y[1] - y[2]) / model.lag]

    model.simulate(t, v, 0.012, 0.0)  # compile
    spent = []
    for _ in range(7):
        begin = time.process_time()
        run = model.simulate(t, v, 0.012, 0.0)
        spent.append(time.process_time() - begin)
    ours = min(spent)
    print(f"ours (RK4, 5 ms)     {1e3 * ours:8.1f} ms   {run.status}")
    for method in ("RK45", "LSODA"):
        begin = time.process_time()
        truth = solve_ivp(slope, (0.0, t[-1]), start, method=method, t_eval=t, rtol=1e-6, atol=1e-9, max_step=0.01)
        spent_there = time.process_time() - begin
        away = np.abs(truth.y[0] - run.q).max()
        print(f"solve_ivp {method:<10} {1e3 * spent_there:8.1f} ms   {spent_there / ours:6.0f} x   |dq| {away:.1e} m")


if __name__ == "__main__":
    main()
