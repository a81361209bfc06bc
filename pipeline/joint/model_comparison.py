"""The full-order and the reduced model side by side (figure 7)."""

import time
from dataclasses import dataclass

import numpy as np

from pipeline.joint.equilibria import equilibria
from pipeline.joint.full_order import Trajectory, rest_state, simulate
from pipeline.joint.parameters import JointParameters
from pipeline.joint.reduced_order import ReducedMotion, simulate_reduced
from pipeline.joint.reduction import reduce_joint
from pipeline.numerics.arrays import FloatArray
from pipeline.numerics.metrics import nrmse


def pulse_sequence(
    voltage: float = 3000.0, *, pulse: float = 0.5, pause: float = 1.0, count: int = 4, dt: float = 1e-3
) -> tuple[FloatArray, FloatArray]:
    """Times [s] and voltages (N, 2) [V]: left, right, left … pulses of `pulse` [s] with pauses, as in figure 7."""
    period = pulse + pause
    t: FloatArray = dt * np.arange(round(count * period / dt) + 1, dtype=np.float64)
    v = np.zeros((t.size, 2))
    number = np.minimum((t / period).astype(int), count - 1)
    on = (t - number * period >= 0.5 * pause) & (t - number * period < 0.5 * pause + pulse)
    v[on, number[on] % 2] = voltage
    return t, v


@dataclass(frozen=True)
class Motions:
    """The same motion by the full and the reduced model, with the processor time [s] of each."""

    v: FloatArray
    full: Trajectory
    reduced: ReducedMotion
    full_seconds: float
    reduced_seconds: float

    @property
    def nrmse(self) -> dict[str, float | None]:
        """NRMSE (eq. 41) of the reduced against the full model; None where one of them diverged."""
        pairs = {
            "q": (self.full.q, self.reduced.q),
            "qdot": (self.full.q_dot, self.reduced.q_dot),
            "qddot": (self.full.q_ddot, self.reduced.q_ddot),
        }
        whole = self.full.diverged_at is None and self.reduced.diverged_at is None
        return {name: nrmse(full, reduced) if whole else None for name, (full, reduced) in pairs.items()}


def simulate_both(
    parameters: JointParameters, t: FloatArray, v: FloatArray, *, q0: float | None = None, tolerance: float = 1e-5
) -> Motions:
    """Free run of the full-order and the reduced model from rest at q0 [m], or in the left well."""
    start = q0 if q0 is not None else next(e.q for e in equilibria(parameters, v[0]) if e.stable)
    state, reduced = rest_state(parameters, start, 0.0, v[0]), reduce_joint(parameters)
    # The first calls load compiled code; the times are those of the simulations.
    simulate(parameters, t[:2], v[:2], state)
    simulate_reduced(reduced, t[:2], v[:2], start, 0.0)
    clock = [time.process_time()]
    full = simulate(parameters, t, v, state, tolerance=tolerance)
    clock.append(time.process_time())
    short = simulate_reduced(reduced, t, v, start, 0.0)
    clock.append(time.process_time())
    return Motions(v, full, short, clock[1] - clock[0], clock[2] - clock[1])
