"""Energy of a motion: what the voltages and the force put in is stored or dissipated."""

from dataclasses import dataclass

import numpy as np

from pipeline.compiled import compiled
from pipeline.generated.analytical_joint import energy_flow
from pipeline.joint.full_order import Trajectory
from pipeline.joint.parameters import JointParameters
from pipeline.numerics.arrays import FloatArray


@dataclass(frozen=True)
class EnergyBalance:
    """Energies [J] along a motion, each (N,); `defect` is stored − initially stored + dissipated − work."""

    kinetic: FloatArray
    elastic: FloatArray
    maxwell: FloatArray
    friction: FloatArray
    work: FloatArray
    dissipated: FloatArray

    @property
    def defect(self) -> FloatArray:
        """What does not close, shape (N,)."""
        stored = self.kinetic + self.elastic + self.maxwell + self.friction
        return np.asarray(stored - stored[0] + self.dissipated - self.work)


@compiled
def _tabulate_flows(
    qm: FloatArray, qm_dot: FloatArray, z: FloatArray, v_squared: FloatArray, force: FloatArray, p: FloatArray,
    flows: FloatArray,
) -> None:  # fmt: skip
    """`energy_flow` at every sample, into `flows` (N, 6)."""
    for i in range(flows.shape[0]):
        energy_flow(qm[i], qm_dot[i], z[i], v_squared[i], force[i : i + 1], p, flows[i])


def energy_balance(
    parameters: JointParameters, motion: Trajectory, v: FloatArray, force: FloatArray | None = None
) -> EnergyBalance:
    """Energies along a simulated motion; powers are integrated by the trapezoidal rule, so the samples must be
    dense (0.2 ms).

    Parameters
    ----------
    parameters : JointParameters
        The joint.
    motion : Trajectory
        From `pipeline.joint.full_order.simulate`.
    v, force : FloatArray, shapes (N, 2) and (N,)
        The voltages [V] and force [N] of the simulation.
    """
    from scipy.integrate import cumulative_trapezoid

    load = np.zeros(motion.t.size) if force is None else force
    flows = np.empty((motion.t.size, 6))
    _tabulate_flows(
        np.ascontiguousarray(motion.qm), np.ascontiguousarray(motion.qm_dot), np.ascontiguousarray(motion.z),
        v**2, load, parameters.vector(), flows,
    )  # fmt: skip
    work, dissipated = (cumulative_trapezoid(flows[:, k], motion.t, initial=0) for k in (4, 5))
    return EnergyBalance(flows[:, 0], flows[:, 1], flows[:, 2], flows[:, 3], work, dissipated)
