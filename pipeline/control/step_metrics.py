"""How a joint follows a step of its target: settling, overshoot, error at rest."""

from dataclasses import dataclass

import numpy as np

from ..numerics.arrays import FloatArray
from ..numerics.metrics import rms, settling_index

BAND = 0.05
"""Half width of the band in which a joint has settled, as a share of the wells' distance."""


@dataclass(frozen=True)
class Step:
    """One step of the target, from it to the next.

    Attributes
    ----------
    t_s, target_m : float
        When it came and where to.
    settling_s : float or None
        Time [s] after which q stays within the band about the target; None if it is outside at the end.
    overshoot_m : float
        How far [m] q went beyond the target, at least 0.
    rms_m : float
        RMS [m] of q − target over the second half of the step.
    """

    t_s: float
    target_m: float
    settling_s: float | None
    overshoot_m: float
    rms_m: float


def step_metrics(t: FloatArray, q: FloatArray, target: FloatArray, distance: float) -> list[Step]:
    """Metrics of every step of a target that is constant in between.

    Parameters
    ----------
    t, q, target : FloatArray, shape (N,)
        Time [s], displacement and target [m]; all finite.
    distance : float
        Distance of the wells [m].
    """
    first = np.flatnonzero(np.diff(target, prepend=np.nan) != 0.0)
    return [
        one_step(t[begin:end], q[begin:end], float(target[begin]), distance)
        for begin, end in zip(first, [*first[1:], len(t)], strict=True)
    ]


def one_step(t: FloatArray, q: FloatArray, target: float, distance: float) -> Step:
    """Metrics of a segment with one target, from its first row on.

    Parameters
    ----------
    t : FloatArray, shape (n,)
        Times [s].
    q : FloatArray, shape (n,)
        Displacement [m].
    target : float
        Target [m].
    distance : float
        Distance of the wells [m].
    """
    error = q - target
    settled = int(settling_index(error, BAND * distance))
    direction = -np.sign(error[0]) if abs(error[0]) > BAND * distance else 1.0
    late = error[len(error) // 2 :]
    return Step(
        t_s=float(t[0]),
        target_m=target,
        settling_s=float(t[settled] - t[0]) if settled < len(t) else None,
        overshoot_m=max(0.0, float(np.max(direction * error))),
        rms_m=rms(late),
    )
