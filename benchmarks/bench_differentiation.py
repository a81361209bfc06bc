"""Differentiators side by side: `python benchmarks/bench_differentiation.py speed | accuracy`.

`speed` prints processor time and peak memory of TVRegDiff from 10³ to 10⁷ samples next to PyNumDiff, `derivative`
and pysindy's smoothed finite difference, each with the ratio to ours, and ours in units of one banded solve.
`accuracy` prints the errors of both derivatives on the signals of `tests/signals/differentiation_signals.py`:
ours with automatic parameters; ours and every peer with the parameter of a grid that is best against the truth (best
for the first and best for the second derivative, separately).  Peers that are not installed are left out.
"""

import argparse
import contextlib
import os
import resource
import subprocess
import sys
import time
import warnings
from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path
from typing import Literal

for threads in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS"):
    os.environ.setdefault(threads, "1")

import numpy as np  # noqa: E402 - after the number of threads

ROOT = Path(__file__).resolve().parents[1]
sys.path[:0] = [str(ROOT), str(ROOT / "tests" / "signals")]  # the signals are shared with the tests

import differentiation_signals as signals  # noqa: E402 - after the path to it

from pipeline.numerics.tvregdiff import Order, tvregdiff  # noqa: E402

Derivatives = tuple[np.ndarray, np.ndarray]
Differentiator = Callable[[np.ndarray, float], Derivatives]

ORDERS: tuple[Order, ...] = (1, 2, 3, 4)
DEGREES: tuple[Literal[3, 5], ...] = (3, 5)
STARTS: tuple[Literal["exact", "fitted"], ...] = ("exact", "fitted")
CASES = [
    (signals.corner(), (0.05,)),
    (signals.sine(), (0.001, 0.05)),
    (signals.chirp(), (0.001, 0.01)),
    (signals.steps(), (0.0001, 0.001)),
    (signals.ring_down(), (0.0003, 0.003, 0.01)),
]


def rms(error: np.ndarray) -> float:
    return float(np.sqrt(np.mean(error**2)))


# ---------------------------------------------------------------- peers


def twice(differentiate: Callable[[np.ndarray, float], np.ndarray]) -> Differentiator:
    """A differentiator that only knows one derivative, applied again for the second."""

    def both(y: np.ndarray, dt: float) -> Derivatives:
        first = differentiate(y, dt)
        return first, differentiate(first, dt)

    return both


def savitzky_golay(window: int, degree: int) -> Differentiator:
    from scipy.signal import savgol_filter

    def both(y: np.ndarray, dt: float) -> Derivatives:
        first, second = (np.asarray(savgol_filter(y, window, degree, deriv=d, delta=dt)) for d in (1, 2))
        return first, second

    return both


def rts(order: int, ratio: float) -> Differentiator:
    import pynumdiff

    def both(y: np.ndarray, dt: float) -> Derivatives:
        first = pynumdiff.rtsdiff(y, dt, order, ratio, True)[1]
        return first, np.gradient(first, dt, edge_order=2)

    return both


def butterworth(order: int, cutoff: float) -> Differentiator:
    import pynumdiff

    return twice(lambda y, dt: pynumdiff.butterdiff(y, dt, filter_order=order, cutoff_freq=cutoff)[1])


def spline(degree: Literal[3, 5], smoothing: float) -> Differentiator:
    from scipy.interpolate import UnivariateSpline

    def both(y: np.ndarray, dt: float) -> Derivatives:
        t = dt * np.arange(y.size)
        fitted = UnivariateSpline(t, y, k=degree, s=y.size * smoothing**2)
        return fitted.derivative(1)(t), fitted.derivative(2)(t)

    return both


def convex_tv(order: int, gamma: float) -> Differentiator:
    import pynumdiff

    def both(y: np.ndarray, dt: float) -> Derivatives:
        first = pynumdiff.tvrdiff(y, dt, order, gamma)[1]
        return first, np.gradient(first, dt, edge_order=2)

    return both


def iterative_tv(gamma: float, iterations: int = 10) -> Differentiator:
    from pynumdiff.total_variation_regularization import iterative_velocity

    return twice(lambda y, dt: iterative_velocity(y, dt, num_iterations=iterations, gamma=gamma, scale="small")[1])


def trend_filtered(alpha: float, order: int = 0, max_iter: int = 1000) -> Differentiator:
    from derivative import dxdt

    return twice(
        lambda y, dt: dxdt(
            y, dt * np.arange(y.size), kind="trend_filtered", order=order, alpha=alpha, max_iter=max_iter
        )
    )


def kalman(alpha: float) -> Differentiator:
    from derivative import dxdt

    return twice(lambda y, dt: dxdt(y, dt * np.arange(y.size), kind="kalman", alpha=alpha))


def smoothed_difference(window: int) -> Differentiator:
    from pysindy.differentiation import SmoothedFiniteDifference

    smoother = {"window_length": window, "polyorder": 3}
    return twice(lambda y, dt: SmoothedFiniteDifference(smoother_kws=smoother)(y[:, None], dt)[:, 0])


def grid(name: str, n: int, noise_std: float) -> Iterator[tuple[object, Differentiator]]:
    """Parameters and differentiators of one peer."""
    odd = [w for w in (7, 9, 13, 17, 25, 35, 49, 69, 99, 139, 199, 279, 399) if w < n // 2]
    if name == "SciPy Savitzky-Golay":
        yield from (((w, d), savitzky_golay(w, d)) for d in (2, 3, 5, 7) for w in odd if w > d + 1)
    elif name == "PyNumDiff RTS":
        yield from (((m, r), rts(m, float(r))) for m in (1, 2, 3) for r in np.arange(1.0, 22.0, 1.5))
    elif name == "PyNumDiff Butterworth":
        yield from (((m, c), butterworth(m, c)) for m in (2, 4) for c in np.geomspace(0.005, 0.5, 11))
    elif name == "SciPy smoothing spline":
        yield from (((k, f), spline(k, f * noise_std)) for k in DEGREES for f in (0.9, 0.97, 1.0, 1.03, 1.1))
    elif name == "PyNumDiff tvrdiff":
        yield from (((m, g), convex_tv(m, g)) for m in (1, 2, 3) for g in np.geomspace(1e-6, 1e2, 9))
    elif name == "PyNumDiff iterative TV" and n <= 100:
        yield from ((g, iterative_tv(g)) for g in np.geomspace(1e-4, 10.0, 16))
    elif name == "derivative TrendFiltered" and n <= 100:
        yield from ((a, trend_filtered(a, max_iter=10**5)) for a in np.geomspace(1e-5, 1e-1, 9))
    elif name == "pysindy smoothed difference":
        yield from ((w, smoothed_difference(w)) for w in odd)


PEERS = (
    "SciPy Savitzky-Golay",
    "PyNumDiff RTS",
    "PyNumDiff Butterworth",
    "SciPy smoothing spline",
    "PyNumDiff tvrdiff",
    "PyNumDiff iterative TV",
    "derivative TrendFiltered",
    "pysindy smoothed difference",
)


# ---------------------------------------------------------------- accuracy


def errors(case: signals.Signal, derivatives: Derivatives) -> tuple[float, float]:
    first, second = derivatives
    return rms(first - case.first), np.inf if case.second is None else rms(second - case.second)


def own(case: signals.Signal, y: np.ndarray) -> Iterator[tuple[str, tuple[float, float]]]:
    from pipeline.signals.differentiate import differentiate

    for order in ORDERS:
        k = differentiate(y, case.dt, order=order)
        yield f"ours, order {order}, automatic", errors(case, (k.qdot, k.qddot))


def own_best(case: signals.Signal, y: np.ndarray) -> Iterator[tuple[str, tuple[float, float]]]:
    """Errors over a grid of our parameters, of which the best against the truth is taken, as for the peers.

    Order, memory length of the smoother, rounding of the modulus from nearly none to quadratic, natural or relaxed
    ends, and up to two reweightings.
    """
    from pipeline.signals.noise import noise_std

    n, sigma = y.size, noise_std(y)
    for order in ORDERS:
        for memory in np.geomspace(2.0, 64.0, 16):
            typical = sigma / memory ** (order + 0.5)
            for rounding in (*np.geomspace(1e-2, 1e2, 7), 1e9):
                delta = rounding * typical
                lam = memory ** (2 * order + 2) * max(delta, typical)
                label = f"order {order}, memory {memory:.3g}, rounding {rounding:.2g}"
                quadratic = rounding > 1e3
                starts = {"": None} | ({", relaxed ends": relaxed_ends(n, order, memory)} if quadratic else {})
                for ends, weights in starts.items():
                    reweightings = 0 if quadratic else 2
                    for k, found in enumerate(reweighted_fits(case, y, order, lam, delta, weights, reweightings)):
                        yield label + ends + (f", reweighted {k}x" if k else ""), found


def relaxed_ends(n: int, order: int, memory: float) -> np.ndarray:
    """Weights that fall as the square of the distance to the nearer end (Oehlert 1992).

    Without them the minimiser meets both ends with its derivatives above m + 1 zero, whatever the signal does
    there; with them the error at the ends is of the order of the error inside.

    Parameters
    ----------
    n : int
        Number of samples.
    order : int
        Order m of the difference whose variation is penalised.
    memory : float
        Memory length of the smoother [samples], ``(lam/delta)^(1/(2m + 2))``.

    Returns
    -------
    np.ndarray, shape (n,)
        In (0, 1].

    References
    ----------
    G. W. Oehlert, Relaxed boundary smoothing splines, Ann. Statist. 20 (1992) 146-160, doi:10.1214/aos/1176348516.
    """
    zone = min(6.0 * memory, n / 3.0)
    index = np.arange(n, dtype=np.float64)
    distance = np.maximum(np.minimum(index - order, n - index), 1.0)
    return np.asarray(np.minimum(1.0, (distance / max(zone, 1.0)) ** 2))


def reweighted_fits(
    case: signals.Signal,
    y: np.ndarray,
    order: Order,
    lam: float,
    delta: float,
    weights: np.ndarray | None,
    reweightings: int,
) -> Iterator[tuple[float, float]]:
    """Errors of a solution and of those after each reweighting, parameters in steps."""
    from pipeline.numerics.linear_filters import finite_difference, finite_difference_at_jumps
    from pipeline.signals.differentiate import jump_weights

    for k in range(reweightings + 1):
        fit = tvregdiff(
            y,
            case.dt,
            alpha=lam * case.dt**order,
            epsilon=(delta / case.dt**order) ** 2,
            order=order,
            start="fitted",
            weights=weights,
            tolerance=1e-4,
        )
        difference = finite_difference_at_jumps if k else finite_difference
        first = fit.derivative if order == 1 else difference(fit.integral, case.dt, 1)
        yield errors(case, (first, difference(fit.integral, case.dt, 2)))
        if k < reweightings:
            t = np.concatenate((np.zeros(order + 1), np.diff(fit.integral, order + 1)))
            weights = jump_weights(t, delta, order)


def accuracy(only: str | None) -> None:
    print(f"{'signal':10s} {'noise':>7s} {'method':32s} {'RMS first':>11s} {'RMS second':>11s}  best parameters")
    for case, levels in CASES:
        for noise in levels:
            y = case.noisy(noise, np.random.default_rng(1))
            rows: list[tuple[str, tuple[float, float], str]] = []
            if only != "peers":
                rows += [(name, found, "") for name, found in own(case, y)]
                rows.append(_least("ours, best parameters", [(found, label) for label, found in own_best(case, y)]))
            if only != "own":
                for name in PEERS:
                    rows += _best(name, case, y, noise)
            for name, (first, second), parameter in rows:
                print(f"{case.name:10s} {noise:7.4f} {name:32s} {first:11.5g} {second:11.5g}  {parameter}", flush=True)


def _best(name: str, case: signals.Signal, y: np.ndarray, noise: float) -> list[tuple[str, tuple[float, float], str]]:
    tried = []
    try:
        for parameter, differentiator in grid(name, y.size, noise):
            with warnings.catch_warnings(), contextlib.suppress(ValueError, np.linalg.LinAlgError):
                warnings.simplefilter("ignore")
                tried.append((errors(case, differentiator(y, case.dt)), parameter))
    except (ImportError, AttributeError):
        return []
    if not tried:
        return []
    return [_least(name, tried)]


def _least(name: str, tried: list[tuple[tuple[float, float], object]]) -> tuple[str, tuple[float, float], str]:
    first, second = (min(tried, key=lambda row: row[0][which]) for which in (0, 1))
    return name, (first[0][0], second[0][1]), f"{first[1]} · {second[1]}"


# ---------------------------------------------------------------- speed


def timed(call: Callable[[], object], least: float = 0.2) -> float:
    """Median processor time of repeated calls [s]; the first, which may compile or import, does not count."""
    call()
    durations: list[float] = []
    while not durations or (sum(durations) < least and len(durations) < 25):
        start = time.process_time()
        call()
        durations.append(time.process_time() - start)
    return float(np.median(durations))


def banded_solve(n: int) -> Callable[[], object]:
    from scipy.linalg import solveh_banded

    band = np.empty((3, n))
    band[0], band[1], band[2] = 1.0, -4.0, 7.0
    right = np.ones(n)
    return lambda: solveh_banded(band, right, check_finite=False)


def long_record(n: int) -> tuple[np.ndarray, float]:
    """37.5 s of ring-downs in mm with 3 µm of noise, sampled n times."""
    case = signals.ring_down(n, 37.5 / n, (2.8, 4.0, 6.0, 9.0) * 4)
    return case.noisy(0.003, np.random.default_rng(2)), case.dt


def speed(largest: int) -> None:
    sizes = [
        n for n in (1000, 3750, 10_000, 30_000, 100_000, 300_000, 1_125_000, 3_000_000, 10_000_000) if n <= largest
    ]
    print("TVRegDiff, alpha = 0.01 mm s, epsilon = 1e-6 (mm/s)², to a relative duality gap of 1e-10")
    print(f"{'N':>9s} {'time [s]':>9s} {'ns/sample':>9s} {'steps':>5s} {'step/banded solve':>17s} {'peak [MB]':>9s}")
    for n in sizes:
        y, dt = long_record(n)
        result = tvregdiff(y, dt, alpha=0.01)
        seconds = timed(partial(tvregdiff, y, dt, alpha=0.01))
        ratio = seconds / result.iterations / timed(banded_solve(n))
        print(
            f"{n:9d} {seconds:9.4f} {1e9 * seconds / n:9.0f} {result.iterations:5d} {ratio:17.2f} {peak_memory(n):9.0f}"
        )
    starts(min(largest, 1_125_000))  # after the table: a child's peak memory starts from its parent's
    for n in (1000, 3750):
        beside_peers(n)


def starts(n: int) -> None:
    """Processor time of every start and rounding on one record."""
    y, dt = long_record(n)
    print(f"\nN = {n}, alpha = 0.01 mm s, to a relative duality gap of 1e-10")
    print(f"{'start':28s} {'epsilon':>8s} {'time [s]':>9s} {'steps':>5s}")
    for start in STARTS:
        for epsilon in (1e-12, 1e-6, 1e-2):
            solve = partial(tvregdiff, y, dt, alpha=0.01, start=start, epsilon=epsilon)
            steps = solve().iterations
            seconds = timed(solve, least=1.0)
            print(f"{start:28s} {epsilon:8.0e} {seconds:9.3f} {steps:5d}", flush=True)


def beside_peers(n: int) -> None:
    from pipeline.signals.differentiate import differentiate

    print(f"\nN = {n}: processor time of a first derivative, and its ratio to ours")
    y, dt = long_record(n)
    reference = timed(lambda: tvregdiff(y, dt, alpha=0.01))
    print(f"  {'ours: tvregdiff':34s} {reference:9.4f} s")
    automatic = timed(lambda: differentiate(y, dt))
    print(
        f"  {'ours: differentiate':34s} {automatic:9.4f} s {automatic / reference:9.1f}  (both, alpha from the record)"
    )
    peers: list[tuple[str, Callable[[], Differentiator]]] = [
        ("pysindy smoothed difference", lambda: smoothed_difference(11)),
        ("PyNumDiff RTS", lambda: rts(2, 10.0)),
        ("PyNumDiff tvrdiff (cvxpy)", lambda: convex_tv(1, 0.01)),
        ("PyNumDiff iterative TV, 10 sweeps", lambda: iterative_tv(0.01)),
        ("derivative Kalman", lambda: kalman(1.0)),
        ("derivative TrendFiltered", lambda: trend_filtered(0.01)),
    ]
    for name, build in peers:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            try:
                seconds = timed_once(build(), y, dt)
            except (ImportError, AttributeError) as missing:
                print(f"  {name:34s} not measured: {missing}")
                continue
        print(f"  {name:34s} {seconds:9.4f} s {seconds / reference:9.1f}", flush=True)


def timed_once(differentiator: Differentiator, y: np.ndarray, dt: float) -> float:
    """Processor time per derivative of a peer: half of a call that finds two [s]."""
    differentiator(y[:60], dt)
    start = time.process_time()
    differentiator(y, dt)
    return 0.5 * (time.process_time() - start)


def peak_memory(n: int) -> float:
    """Peak resident memory of a fresh process that differentiates n samples [MB]."""
    command = [sys.executable, str(Path(__file__).resolve()), "peak", "--largest", str(n)]
    return float(subprocess.run(command, check=True, capture_output=True, text=True).stdout)


def peak(n: int) -> None:
    rng = np.random.default_rng(2)
    y = rng.standard_normal(n)
    np.cumsum(y, out=y)
    tvregdiff(y, 37.5 / n, alpha=0.01, max_iterations=8)
    print(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1e3)


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("what", choices=("speed", "accuracy", "peak"))
    parser.add_argument("--largest", type=int, default=10_000_000, help="largest record of `speed`")
    parser.add_argument("--only", choices=("own", "peers"), help="`accuracy` of one side")
    arguments = parser.parse_args()
    if arguments.what == "speed":
        speed(arguments.largest)
    elif arguments.what == "accuracy":
        accuracy(arguments.only)
    else:
        peak(arguments.largest)
