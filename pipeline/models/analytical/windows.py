"""Windows of measured motion that a calibration simulates by the full-order model, and their errors' derivatives.

Near switching the well in which a long free run ends jumps with the parameters, and least squares on it has no
gradient to follow. Restarting from the measurement (multiple shooting with the initial states known; H. G. Bock,
1983) keeps the error smooth.

Not all states are measured at the begin of a window. The shape follows from the static path at the measured q, the
Maxwell strains and the friction state from the whole measured motion before the window. Voltages are linear between
`VoltageKnots`: samples of the log, and finer times where a voltage switches.
"""

import itertools
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from ...device.parameters import JointParameters
from ...errors import InputError
from ...numerics.arrays import BoolArray, FloatArray, IntArray
from ...signals.log import Log
from .full_order import REACH, Inputs, integrate, no_solution, rest_states, state_scale
from .reduced_order import friction_state, maxwell_strains
from .sensitivity import state_sensitivities
from .statics import unactuated_path

BENT = 0.01
"""Deviation from a straight line within a sample interval, relative to the largest voltage, from which it is refined:
above the noise of a measured voltage, and below what a switching leaves to an amplifier's lag."""


class VoltageKnots(NamedTuple):
    """Times t (M,) [s], voltages v (M, K) [V], linear in between, and the `rows` (N,) of them that are samples."""

    t: FloatArray
    v: FloatArray
    rows: IntArray


def voltage_knots(t: FloatArray, v: FloatArray) -> VoltageKnots:
    """Times and voltages for an integrator that takes straight lines between its times.

    Parameters
    ----------
    t : FloatArray, shape (N,)
        Sample times [s].
    v : FloatArray, shape (N, K) or (N, r, K)
        Voltages [V] at the samples, or at r evenly spaced times of each sample interval, the first of which is the
        sample itself.

    Notes
    -----
    If voltages sampled every 10 ms are lines from sample to sample, a pulse begins up to 10 ms wrong. A passage near
    the saddle is then late by several times that. Cost: 50 ns for each voltage, and what the integrator takes for the
    knots: a third more of them on half an hour of pulses, all of them where noise exceeds `BENT`.
    """
    v = v[:, None] if v.ndim == 2 else v
    parts = v.shape[1]
    samples = v[:, 0]
    lines = samples[:-1, None] + np.diff(samples, axis=0)[:, None] * (np.arange(parts)[:, None] / parts)
    count = np.where(np.abs(v[:-1] - lines).max(axis=(1, 2)) > BENT * np.abs(v).max(), parts, 1)
    rows = np.concatenate([[0], np.cumsum(count)])
    within = np.arange(rows[-1]) - np.repeat(rows[:-1], count)
    interval = np.repeat(np.arange(t.size - 1), count)
    times = t[interval] + within / parts * np.diff(t)[interval]
    return VoltageKnots(np.append(times, t[-1]), np.vstack([v[interval, within], samples[-1:]]), rows)


class Window(NamedTuple):
    """Measured displacement q (n,) [m] at the samples of a window, first velocity [m/s], and the voltages."""

    q: FloatArray
    qdot0: float
    drive: VoltageKnots


@dataclass(frozen=True)
class Windows:
    """Measured motions, the first and last sample of each window (W, 3): motion, begin, end, and what lies between."""

    motions: tuple[Log, ...]
    spans: IntArray
    parts: tuple[Window, ...]

    def resolved(self, lost_windows: BoolArray, finer: "Windows") -> "Windows":
        """Windows, the `lost_windows` (W,) of them cut where `finer` windows are cut."""
        spans = [(int(index), int(begin), int(end)) for index, begin, end in self.spans[~lost_windows]]
        for index, begin, end in self.spans[lost_windows]:
            cuts = np.unique(np.clip(finer.spans[finer.spans[:, 0] == index, 1:], begin, end))
            spans.extend((int(index), int(a), int(b)) for a, b in itertools.pairwise(cuts))
        return _windows(self.motions, spans)

    @property
    def samples(self) -> int:
        """Number of compared samples."""
        return int((self.spans[:, 2] - self.spans[:, 1]).sum())

    @property
    def labels(self) -> IntArray:
        """Number of the window of every compared sample, shape (samples,)."""
        return np.repeat(np.arange(len(self.spans)), self.spans[:, 2] - self.spans[:, 1])


def cut_windows(motions: Sequence[Log], duration: float) -> Windows:
    """Cut motions into windows of about `duration` [s]; a motion shorter than that is one window.

    A cut is put where the joint is slowest within a third of a window, because the unmeasured shape is known best
    there.

    Raises
    ------
    InputError
        A motion with one voltage only: the joint has two.
    """
    spans: list[tuple[int, int, int]] = []
    for index, motion in enumerate(motions):
        if motion.v.shape[-1] != 2:
            raise InputError("calibration of the joint needs both voltages; name channels v1 and v2")
        pieces = max(1, round((motion.t[-1] - motion.t[0]) / duration))
        edges = np.linspace(0, motion.t.size - 1, pieces + 1).astype(int)
        margin = (motion.t.size - 1) // (3 * pieces)
        # Speed [m/s], with the acceleration weighed in as what it becomes within the shape's 10 ms relaxation
        unrest = np.hypot(motion.qdot, 0.01 * motion.qddot)
        for k in range(1, pieces):
            near = slice(edges[k] - margin, edges[k] + margin + 1)
            edges[k] = near.start + int(np.argmin(unrest[near]))
        spans.extend((index, int(a), int(b)) for a, b in itertools.pairwise(edges) if b > a)
    return _windows(motions, spans)


def _windows(motions: Sequence[Log], spans: Sequence[tuple[int, int, int]]) -> Windows:
    drives = [voltage_knots(motion.t, motion.drive) for motion in motions]
    parts = tuple(_window(motions[index], drives[index], begin, end) for index, begin, end in spans)
    return Windows(tuple(motions), np.array(spans, dtype=np.int64).reshape(-1, 3), parts)


def _window(motion: Log, drive: VoltageKnots, begin: int, end: int) -> Window:
    """Samples `begin` to `end`, both included."""
    rows = drive.rows[begin : end + 1]
    knots = slice(rows[0], rows[-1] + 1)
    return Window(
        q=motion.q[begin : end + 1],
        qdot0=float(motion.qdot[begin]),
        drive=VoltageKnots(drive.t[knots], drive.v[knots], rows - rows[0]),
    )


UNREACHABLE = 0.03
"""Error [m] of a sample that the model does not reach: no static path, or a run that diverged."""

NODE = 1e-3
"""Distance [m] of the nodes of the static path from which windows start."""


@dataclass(frozen=True)
class WindowRun:
    """Solution of one window: states and their rates (M, 11) at its knots, of which the first `valid` hold."""

    states: FloatArray
    rates: FloatArray
    valid: int


@dataclass(frozen=True)
class WindowRuns:
    """Simulated windows.

    Attributes
    ----------
    parameters : JointParameters
        The joint that was simulated.
    windows : Windows
        Windows of the logs that it was compared with.
    runs : tuple of WindowRun
        The solution of each window; none where the joint has no static path to start from.
    errors : FloatArray, shape (samples,)
        Simulated minus measured q [m]; the first sample of each window is left out.
    """

    parameters: JointParameters
    windows: Windows
    runs: tuple[WindowRun, ...]
    errors: FloatArray


def simulate_windows(
    parameters: JointParameters, windows: Windows, tolerance: float = 1e-4, pool: ThreadPoolExecutor | None = None
) -> WindowRuns:
    """Simulate every window from its measured begin.

    Parameters
    ----------
    parameters : JointParameters
        The joint.
    windows : Windows
        From `cut_windows`.
    tolerance : float
        Local error of a step of the integrator, relative to the typical size of each state. At 1e-4 the errors are
        within 0.1 µm (RMS), at 1e-3 within 1.4 µm, at 1e-2 within 18 µm.
    pool : ThreadPoolExecutor, optional
        Threads for the windows; the integrator frees the GIL.

    Notes
    -----
    Cost: 0.09 s of processor time for 37.5 s at 10 ms, however it is cut; 0.06 s at 1e-3, 0.04 s at 1e-2.
    """
    try:
        starts = start_states(parameters, windows)
    except InputError:
        return WindowRuns(parameters, windows, (), np.full(windows.samples, UNREACHABLE))
    p = parameters.vector()
    scale = tolerance * state_scale(parameters)
    levers = parameters.levers[:3]

    def run(start: FloatArray, part: Window) -> WindowRun:
        """The motion over one window."""
        t, v, _ = part.drive
        solution = no_solution(t.size)
        valid = integrate(Inputs(t, v, np.zeros(t.size)), start, p, scale, REACH, solution)
        return WindowRun(solution.states, solution.rates, valid)

    def errors(run: WindowRun, part: Window) -> FloatArray:
        """Error of q [m] after the first sample; `UNREACHABLE` after a divergence."""
        later = part.drive.rows[1:]
        return np.where(later < run.valid, run.states[later, :3] @ levers - part.q[1:], UNREACHABLE)

    runs = tuple((pool.map if pool else map)(run, starts, windows.parts))
    return WindowRuns(parameters, windows, runs, np.concatenate([*map(errors, runs, windows.parts)]))


def error_derivatives(
    motions: WindowRuns, moved: Sequence[JointParameters], steps: FloatArray, pool: ThreadPoolExecutor | None = None
) -> FloatArray:
    """Derivatives of the errors, shape (samples, P), with respect to P unknowns.

    Parameters
    ----------
    motions : WindowRuns
        The simulation at which they are taken.
    moved : sequence of JointParameters
        The parameters with one unknown moved by its step.
    steps : FloatArray, shape (P,)
        Steps of the unknowns.
    pool : ThreadPoolExecutor, optional
        Threads for the windows.

    Notes
    -----
    Exact up to 5 % at 10 ms (`pipeline.models.analytical.sensitivity`); zero where the model reaches nothing. Cost:
    0.1 s of processor time for 37.5 s at 10 ms and P = 14, where one-sided differences would take 14 simulations.
    """
    if not motions.runs:
        return np.zeros((motions.windows.samples, steps.size))
    points = np.array([joint.vector() for joint in (motions.parameters, *moved)])
    base = np.array([run.states[0] for run in motions.runs])
    starts = [_start_derivatives(joint, motions.windows, base, h) for joint, h in zip(moved, steps, strict=True)]
    levers = motions.parameters.levers[:3]

    def derivatives(run: WindowRun, part: Window, start: FloatArray) -> FloatArray:
        """Derivatives of one window, zero behind a divergence."""
        t, v, rows = part.drive
        by_parameter = np.zeros((rows.size, steps.size))
        simulated = slice(0, run.valid)
        if run.valid > 1:
            states = state_sensitivities(
                t[simulated], v[simulated], run.states[simulated], run.rates[simulated], points, steps, start
            )
            reached = rows[rows < run.valid]
            by_parameter[: reached.size] = np.tensordot(states[reached, :3], levers, (1, 0))
        return by_parameter[1:]

    every = (motions.runs, motions.windows.parts, np.stack(starts, axis=-1))
    return np.concatenate([*(pool.map if pool else map)(derivatives, *every)])


def start_states(parameters: JointParameters, windows: Windows) -> FloatArray:
    """Full-order states (W, 11) at the begin of every window.

    Raises
    ------
    InputError
        The joint has no static path over the measured displacements.
    """
    reach = NODE * np.ceil(1.02 * max(np.abs(motion.q).max() for motion in windows.motions) / NODE)
    path = unactuated_path(parameters, float(reach), 1 + 2 * round(reach / NODE))
    rates = np.array([side.relaxation for side in (parameters.left, parameters.right)])

    def internal(motion: Log) -> FloatArray:
        """Maxwell strains and friction state along a motion, shape (N, 3)."""
        stretch = np.stack([np.interp(motion.q, path.q, path.stretch[:, side]) for side in range(2)], axis=1)
        strains = maxwell_strains(stretch**-0.5, motion.interval, rates)
        return np.column_stack([strains, friction_state(motion.q, parameters.s_c)])

    along = [internal(motion) for motion in windows.motions]
    z = np.array([along[index][begin] for index, begin, _ in windows.spans])
    measured = np.array([(part.q[0], part.qdot0) for part in windows.parts])
    return rest_states(parameters, measured, np.array([part.drive.v[0] for part in windows.parts]), z, path)


def _start_derivatives(moved: JointParameters, windows: Windows, base: FloatArray, step: float) -> FloatArray:
    """Derivative (W, 11) of the start states with respect to one unknown; zero at the edge of what can be held."""
    try:
        return (start_states(moved, windows) - base) / step
    except InputError:
        return np.zeros_like(base)
