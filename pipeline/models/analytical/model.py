"""The analytical model (§ 3) behind the interface of all models: `analytical` and `analytical-calibrated`."""

from collections.abc import Sequence
from typing import Annotated, Any, ClassVar, Literal

from pydantic import Field

from ...device.parameters import QUANTITIES, VECTOR_NAMES, JointParameters
from ...errors import InputError
from ...numerics.arrays import FloatArray
from ...numerics.stiff import STATES
from ...signals.log import Log
from ..base import FreeRun, checked
from ..model_file import JointSet, ModelFile
from ..model_type import ModelType, Training
from .full_order import rest_state, simulate
from .reduced_order import CURVES, reduce_joint
from .windows import voltage_knots


class AnalyticalModel(ModelFile):
    """The full-order joint with one set of parameters, and its file."""

    fine_voltages: ClassVar[bool] = True
    input_count: ClassVar[int] = 2
    name: Literal["analytical", "analytical-calibrated"] = "analytical"
    """Name of the model."""
    tolerance: Annotated[float, Field(ge=1e-8, le=0.1)] = 1e-4
    """Local error of the integrator, relative to the usual size of each state."""
    parameters: JointSet
    """The designer's set for `analytical`, the fitted one for `analytical-calibrated`."""

    @checked
    def simulate(self, t: FloatArray, v: FloatArray, q0: float, qdot0: float) -> FreeRun:
        """Free run from the static shape at ``q0`` that moves with ``qdot0``; v is left and right [V].

        Cost: 0.1 s of processor time for 37.5 s, at 10 ms samples.

        Parameters
        ----------
        t : FloatArray, shape (N,)
            Times [s].
        v : FloatArray, shape (N, 2) or (N, r, 2)
            Voltages [V] at the samples, or at r times of each interval.
        q0 : float
            Displacement [m] at the first sample.
        qdot0 : float
            Velocity [m/s] there.
        """
        knots = voltage_knots(t, v)
        start = rest_state(self.parameters, q0, qdot0, knots.v[0])
        motion = simulate(self.parameters, knots.t, knots.v, start, tolerance=self.tolerance)
        q, qdot, qddot = (signal[knots.rows] for signal in (motion.q, motion.qdot, motion.qddot))
        return FreeRun(t, q, qdot, qddot, motion.status, motion.diverged_at_s)

    def curves(self, q: FloatArray) -> dict[str, FloatArray]:
        """Characteristic curves at q [m], shape (n,) (fig. 14): F [N], d [N·s/m], dC1_dq, dC2_dq [F/m].

        Those of the reduced model (eq. 26), along the static path; Maxwell branches and friction are left out.

        Raises
        ------
        InputError
            The beam snaps while its tip is held, so that no curve over q exists.
        """
        values, slopes = reduce_joint(self.parameters).evaluate(q)
        return {
            "F": values[:, CURVES.index("f")],
            "d": values[:, CURVES.index("d")],
            "dC1_dq": slopes[:, CURVES.index("C_1")],
            "dC2_dq": slopes[:, CURVES.index("C_2")],
        }

    def describe(self) -> dict[str, Any]:
        """Parameters with their units in the keys, and how they came about."""
        return {
            "model": self.name,
            "states": STATES,
            "tolerance": self.tolerance,
            "parameters": {f"{name} [{QUANTITIES[name].unit}]": self.parameters.value(name) for name in VECTOR_NAMES},
        } | self.diagnostics


def calibrate_analytical(data: Sequence[Log], start: JointParameters) -> AnalyticalModel:
    """`analytical-calibrated`: the designer's set fitted to the training segments (§ 3.3).

    Fits the paper's seven parameters, the asymmetries that its analytical model lacks, and friction.

    Notes
    -----
    Cost: that of `pipeline.models.analytical.calibration.calibrate`.
    """
    from .calibration import ASYMMETRIC_NAMES, FRICTION_NAMES, calibrate

    fit = calibrate(data, start, names=ASYMMETRIC_NAMES + FRICTION_NAMES)
    return AnalyticalModel(
        parameters=fit.parameters,
        name="analytical-calibrated",
        diagnostics={
            "fitted": [f"{name} [{QUANTITIES[name].unit}]" for name in fit.names],
            "values": fit.values,
            "standard_errors": fit.standard_errors,
            "correlation": fit.correlation,
            "at_bound": list(fit.at_bound),
            "rmse_windows_m": fit.rmse,
            "converged": fit.converged,
            "evaluations": fit.evaluations,
        },
    )


def _parameters(training: Training) -> JointParameters:
    if training.parameters is None:
        raise InputError("the analytical model needs a parameter set; name one as plant.parameters")
    return training.parameters


ANALYTICAL = ModelType(lambda training: AnalyticalModel(parameters=_parameters(training)), AnalyticalModel)
ANALYTICAL_CALIBRATED = ModelType(
    lambda training: calibrate_analytical(training.fitted_segments, _parameters(training)), AnalyticalModel
)
