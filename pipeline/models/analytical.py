"""The analytical model (§ 3) behind the interface of all models: `analytical` and `analytical-calibrated`."""

from dataclasses import dataclass, field
from typing import Any

from pipeline.models.base import FreeRun
from pipeline.numerics.arrays import FloatArray
from pipeline.physics.full_order import rest_state, simulate
from pipeline.physics.parameters import QUANTITIES, VECTOR_NAMES, JointParameters


@dataclass(frozen=True)
class AnalyticalModel:
    """The full-order joint with one set of parameters.

    Attributes
    ----------
    parameters : JointParameters
        The set: the designer's for `analytical`, the fitted one for `analytical-calibrated`.
    name : str
        The name under which predictions and scores are filed.
    diagnostics : dict
        How the parameters came about, e.g. uncertainties of a calibration; part of `describe`.
    tolerance : float
        Local error tolerance of the integrator (`pipeline.physics.full_order.simulate`).
    """

    parameters: JointParameters
    name: str = "analytical"
    diagnostics: dict[str, Any] = field(default_factory=dict)
    tolerance: float = 1e-5

    def simulate(self, t: FloatArray, v: FloatArray, q0: float, qdot0: float) -> FreeRun:
        """Free run from the static shape at ``q0`` that moves with ``qdot0``; v is (N, 2), left and right [V].

        Cost: 0.3 s of processor time for 37.5 s, at 10 ms samples.
        """
        start = rest_state(self.parameters, q0, qdot0, v[0])
        motion = simulate(self.parameters, t, v, start, tolerance=self.tolerance)
        if motion.diverged_at is None:
            return FreeRun(t, motion.q, motion.q_dot, motion.q_ddot, "ok")
        return FreeRun(t, motion.q, motion.q_dot, motion.q_ddot, "diverged", motion.diverged_at)

    def accelerate(self, t: FloatArray, v: FloatArray, q: FloatArray, qdot: FloatArray) -> FloatArray:
        """Acceleration [m/s²] along a measured motion, by the reduced model (eq. 26), shape (N,).

        A measurement of q tells nothing of the beam's other shapes, so they follow the static path here.
        """
        from pipeline.physics.reduced_order import accelerate
        from pipeline.physics.reduction import reduce_joint

        return accelerate(reduce_joint(self.parameters), t, v, q, qdot)

    def describe(self) -> dict[str, Any]:
        """Parameters with their units in the keys, and how they came about."""
        values = {f"{name} [{QUANTITIES[name].unit}]": self.parameters.value(name) for name in VECTOR_NAMES}
        return {"model": self.name, "states": 10, "tolerance": self.tolerance, "parameters": values} | self.diagnostics
