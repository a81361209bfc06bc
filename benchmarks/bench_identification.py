"""Processor time of the identification: `python benchmarks/bench_identification.py`.

Prints the paper's model on 3750 and 1.125e6 samples (10 ms and 30 kHz of 37.5 s), warm, and the least squares
alone next to `numpy.linalg.lstsq` and `pinv` on the same rows.
The motion is that of a smooth random walk between ±12 mm under random pulses; only its size matters here.
"""

import os
import time
from collections.abc import Callable
from functools import partial

os.environ.setdefault("OMP_NUM_THREADS", "1")
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

import numpy as np

from pipeline.fitting.regression import pseudo_inverse_fit, triangular_factor
from pipeline.models.paper.model import identify_rbf_paper
from pipeline.numerics.arrays import FloatArray
from pipeline.signals.log import Log

SPAN = 37.5  # s


def motion(samples: int) -> Log:
    t = np.linspace(0.0, SPAN, samples)
    rng = np.random.default_rng(1)
    frequencies, phases = rng.uniform(0.2, 4.0, 12), rng.uniform(0.0, 6.3, 12)
    q = 4e-3 * np.sin(2 * np.pi * np.outer(t, frequencies) + phases).sum(axis=1)
    qdot = np.gradient(q, t)
    v = 3000.0 * (np.sin(2 * np.pi * np.outer(t, [0.4, 0.31])) > 0.3)
    qddot: FloatArray = np.gradient(qdot, t)
    return Log(t, q, qdot, qddot, v.astype(np.float64))


def best_of(work: Callable[[], object], repeats: int) -> float:
    spent = []
    for _ in range(repeats):
        start = time.process_time()
        work()
        spent.append(time.process_time() - start)
    return 1e3 * min(spent)


def speed() -> None:
    identify_rbf_paper([motion(500)])  # compile
    print(
        f"{'samples':>9}  {'rbf-paper':>10}  {'QR in blocks':>12}  {'lstsq':>8}  {'pinv':>8}   [ms of processor time]"
    )
    for samples, repeats in ((3750, 5), (1_125_000, 1)):
        log = motion(samples)
        matrix = np.random.default_rng(2).standard_normal((samples, 41))

        def in_blocks(rows: np.ndarray = matrix) -> object:
            parts = (rows[i : i + 8192].copy() for i in range(0, len(rows), 8192))
            return pseudo_inverse_fit(*triangular_factor(parts))

        def with_lstsq(rows: np.ndarray = matrix) -> object:
            return np.linalg.lstsq(rows[:, :40], rows[:, 40], rcond=None)

        def with_pinv(rows: np.ndarray = matrix) -> object:
            return np.linalg.pinv(rows[:, :40]) @ rows[:, 40]

        whole = best_of(partial(identify_rbf_paper, [log]), repeats)
        parts = [best_of(work, repeats) for work in (in_blocks, with_lstsq, with_pinv)]
        print(f"{samples:9d}  {whole:10.1f}  {parts[0]:12.1f}  {parts[1]:8.1f}  {parts[2]:8.1f}")


if __name__ == "__main__":
    speed()
