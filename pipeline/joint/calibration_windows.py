"""Windows of measured motion that a calibration simulates one by one, each from its measured beginning.

Near switching the well in which a long free run ends jumps with the parameters, and least squares on it has no
gradient to follow. Restarting from the measurement (multiple shooting with the initial states known; H. G. Bock,
1983) keeps the error smooth.
"""

import itertools
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from pipeline.errors import InputError
from pipeline.numerics.arrays import FloatArray, IntArray
from pipeline.signals.trajectory import Trajectory


@dataclass(frozen=True)
class Windows:
    """Measured motions, the first and last sample of each window (W, 3): motion, begin, end, and what lies between."""

    motions: tuple[Trajectory, ...]
    spans: IntArray
    parts: tuple[Trajectory, ...]

    def thinned(self, by: int) -> "Windows":
        """Every `by`-th window."""
        return Windows(self.motions, self.spans[::by], self.parts[::by])

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
    parts = tuple(_part(motions[index], begin, end) for index, begin, end in spans)
    return Windows(tuple(motions), np.array(spans, dtype=np.int64).reshape(-1, 3), parts)


def _part(motion: Trajectory, begin: int, end: int) -> Trajectory:
    """Samples `begin` to `end`, both included."""
    part = slice(begin, end + 1)
    return Trajectory(motion.t[part], motion.q[part], motion.qdot[part], motion.qddot[part], motion.v[part].copy())


def _unrest(motion: Trajectory) -> FloatArray:
    """Speed [m/s], with the acceleration weighed in as what it becomes within the shape's 10 ms relaxation."""
    return np.hypot(motion.qdot, 0.01 * motion.qddot)
