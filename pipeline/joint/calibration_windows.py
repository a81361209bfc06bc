"""Windows of measured motion that a calibration simulates one by one, each from its measured beginning.

Near switching the well in which a long free run ends jumps with the parameters, and least squares on it has no
gradient to follow. Restarting from the measurement (multiple shooting with the initial states known; H. G. Bock,
1983) keeps the error smooth. The states that are not measured follow from what is: the shape from the static path
at the measured q, the Maxwell strains and the friction state from the whole measured motion before the window.
"""

import itertools
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from pipeline.errors import InputError
from pipeline.joint.full_order import rest_state, simulate
from pipeline.joint.parameters import JointParameters
from pipeline.joint.reduced_order import friction_state, maxwell_strains
from pipeline.joint.static_path import unactuated_path
from pipeline.numerics.arrays import FloatArray, IntArray
from pipeline.signals.trajectory import Trajectory

UNREACHABLE = 0.03
"""Error [m] of a sample that the model does not reach: no static path, or a run that diverged."""


@dataclass(frozen=True)
class Windows:
    """Measured motions and the first and last sample of each window (W, 3): motion, begin, end."""

    motions: tuple[Trajectory, ...]
    spans: IntArray

    @property
    def samples(self) -> int:
        """Number of compared samples."""
        return int((self.spans[:, 2] - self.spans[:, 1]).sum())

    @property
    def labels(self) -> IntArray:
        """Number of the window of every compared sample, shape (samples,)."""
        return np.repeat(np.arange(len(self.spans)), self.spans[:, 2] - self.spans[:, 1])


def cut_windows(motions: Sequence[Trajectory], duration: float) -> Windows:
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
        if motion.v.shape[1] != 2:
            raise InputError("calibration of the joint needs both voltages; name channels v1 and v2")
        pieces = max(1, round((motion.t[-1] - motion.t[0]) / duration))
        edges = np.linspace(0, motion.t.size - 1, pieces + 1).astype(int)
        margin = (motion.t.size - 1) // (3 * pieces)
        for k in range(1, pieces):
            near = slice(edges[k] - margin, edges[k] + margin + 1)
            edges[k] = near.start + int(np.argmin(_unrest(motion)[near]))
        spans.extend((index, int(a), int(b)) for a, b in itertools.pairwise(edges) if b > a)
    return Windows(tuple(motions), np.array(spans, dtype=np.int64).reshape(-1, 3))


def _unrest(motion: Trajectory) -> FloatArray:
    """Speed [m/s], with the acceleration weighed in as what it becomes within the shape's 10 ms relaxation."""
    return np.hypot(motion.qdot, 0.01 * motion.qddot)


def initial_states(parameters: JointParameters, motion: Trajectory, begins: IntArray) -> FloatArray:
    """Full-order states (W, 11) at the samples `begins` of a measured motion."""
    path = unactuated_path(parameters)
    stretch = np.stack([np.interp(motion.q, path.q, path.stretch[:, side]) for side in range(2)], axis=1)
    rates = np.array([side.Y_MW / side.eta_MW for side in (parameters.left, parameters.right)])
    strains = maxwell_strains(stretch**-0.5, motion.interval, rates)
    friction = friction_state(motion.q, parameters.s_c)
    internal = np.column_stack([strains, friction])
    return np.stack([rest_state(parameters, motion.q[k], motion.qdot[k], motion.v[k], internal[k]) for k in begins])


def window_errors(parameters: JointParameters, windows: Windows, tolerance: float = 1e-4) -> FloatArray:
    """Simulated minus measured q [m] of all windows, shape (samples,); the first sample of each is left out.

    Cost: 0.1 s of processor time for 37.5 s at 10 ms, however it is cut.
    """
    errors: list[FloatArray] = []
    for index, motion in enumerate(windows.motions):
        spans = windows.spans[windows.spans[:, 0] == index]
        try:
            states = initial_states(parameters, motion, spans[:, 1])
        except InputError:
            errors.append(np.full(int((spans[:, 2] - spans[:, 1]).sum()), UNREACHABLE))
            continue
        for state, (_, begin, end) in zip(states, spans, strict=True):
            part = slice(begin, end + 1)
            run = simulate(parameters, motion.t[part], motion.v[part], state, tolerance=tolerance)
            error = run.q[1:] - motion.q[part][1:]
            errors.append(np.where(np.isfinite(error), error, UNREACHABLE))
    return np.concatenate(errors)
