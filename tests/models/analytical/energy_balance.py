"""Energy of a motion: what the voltages and the force put in is stored or dissipated."""

from dataclasses import dataclass

import casadi as ca
import numpy as np

from pipeline.device.parameters import JointParameters
from pipeline.equations.beam import Expression
from pipeline.equations.full_joint import (
    FullSymbols,
    capacitances,
    elastic_energy,
    kinetic_energy,
    membrane_volume,
    symbols,
    tip,
    viscous_dissipation,
)
from pipeline.models.analytical.full_order import FullOrderMotion
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


def maxwell_energy(s: FullSymbols) -> Expression:
    """½ V_DE Y_MW e_i² of both Maxwell springs [J]."""
    return 0.5 * sum(
        membrane_volume(s, side) * s.parameter(f"{side}.Y_MW") * s.z[i] ** 2 for i, side in enumerate(("left", "right"))
    )


def _flows(s: FullSymbols) -> Expression:
    """T, U, Maxwell, friction energy [J]; rate of work of voltages and force [W]; dissipated power [W].

    Along a motion d/dt (sum of the first four) = work rate − dissipated power. The voltages are imposed, so the
    work that the field does on the structure is ½ Ċ_i v_i².
    """
    q_dot = ca.jtimes(tip(s)[0], s.qm, s.qm_dot)
    work = 0.5 * ca.dot(ca.jtimes(capacitances(s), s.qm, s.qm_dot), s.v_squared) + s.force * q_dot
    dissipated = 2.0 * viscous_dissipation(s) + s.parameter("F_c") * ca.fabs(q_dot) * s.z[2] ** 2
    for i, side in enumerate(("left", "right")):
        rate = s.parameter(f"{side}.Y_MW") ** 2 / s.parameter(f"{side}.eta_MW")
        dissipated = dissipated + membrane_volume(s, side) * rate * s.z[i] ** 2
    friction = 0.5 * s.parameter("F_c") * s.parameter("s_c") * s.z[2] ** 2
    return ca.vertcat(kinetic_energy(s), elastic_energy(s), maxwell_energy(s), friction, work, dissipated)


def energy_balance(
    parameters: JointParameters, motion: FullOrderMotion, v: FloatArray, force: FloatArray | None = None
) -> EnergyBalance:
    """Energies along a simulated motion; powers are integrated by the trapezoidal rule, so the samples must be
    dense (0.2 ms).

    Parameters
    ----------
    parameters : JointParameters
        The joint.
    motion : FullOrderMotion
        From `pipeline.models.analytical.full_order.simulate`.
    v, force : FloatArray, shapes (N, 2) and (N,)
        The voltages [V] and force [N] of the simulation.
    """
    from scipy.integrate import cumulative_trapezoid

    load = np.zeros(motion.t.size) if force is None else force
    s, p = symbols(), parameters.vector()
    flow = ca.Function("flow", [s.qm, s.qm_dot, s.z, s.v_squared, s.force, s.p], [_flows(s)])
    given = [motion.qm.T, motion.qm_dot.T, motion.z.T, v.T**2, load[None], np.tile(p[:, None], motion.t.size)]
    flows = np.array(flow(*given)).T
    work, dissipated = (cumulative_trapezoid(flows[:, k], motion.t, initial=0) for k in (4, 5))
    return EnergyBalance(flows[:, 0], flows[:, 1], flows[:, 2], flows[:, 3], work, dissipated)
