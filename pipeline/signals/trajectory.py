"""A gap-free stretch of a measured motion with its derivatives and voltages."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from pipeline.errors import InputError
from pipeline.numerics.arrays import FloatArray
from pipeline.signals.timebase import is_uniform


@dataclass(frozen=True)
class Trajectory:
    """One gap-free stretch of one log, sampled uniformly; the unit that identification works on.

    Attributes
    ----------
    t : FloatArray, shape (N,)
        Time [s], uniform.
    q, qdot, qddot : FloatArray, shape (N,)
        Displacement, velocity, acceleration [m, m/s, m/s²], or [rad …] for an angle.
    v : FloatArray, shape (N, K) or (N, r, K)
        Voltages [V], K = 1 or 2 (column 0 is the left one), at the samples or at r times of each sample interval.

    Raises
    ------
    InputError
        Shapes that differ, fewer than two samples, samples that are not finite, a time base that is not uniform.
    """

    t: FloatArray
    q: FloatArray
    qdot: FloatArray
    qddot: FloatArray
    v: FloatArray

    def __post_init__(self) -> None:
        n = len(self.t)
        if n < 2:
            raise InputError(f"a stretch of {n} samples is too short to identify from; at least 2 are needed")
        if self.v.ndim not in (2, 3) or len(self.v) != n:
            raise InputError(f"the voltages have the shape {self.v.shape}, ({n}, inputs) was expected")
        for name in ("t", "q", "qdot", "qddot", "v"):
            values = getattr(self, name)
            if len(values) != n:
                raise InputError(f"{name} has {len(values)} samples, the time base {n}")
            if not np.all(np.isfinite(values)):
                raise InputError(f"{name} holds samples that are not finite; split the log at its gaps first")
        if not is_uniform(self.t, 1e-6):
            raise InputError("the time base is not uniform; resample the log first")

    @property
    def interval(self) -> float:
        """Sample interval [s]."""
        return float((self.t[-1] - self.t[0]) / (len(self.t) - 1))


def operating_range(trajectories: Sequence[Trajectory]) -> tuple[float, float]:
    """Smallest and largest displacement of all stretches: q_min, q_max of eq. 39.

    Raises
    ------
    InputError
        No stretch at all, or a displacement that never changes.
    """
    if not trajectories:
        raise InputError("there is no training data; name at least one training log with valid samples")
    low = min(float(x.q.min()) for x in trajectories)
    high = max(float(x.q.max()) for x in trajectories)
    if not high > low:
        raise InputError(f"q is constant ({low:g}) in all training logs; nothing can be identified from it")
    return low, high
