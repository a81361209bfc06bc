"""Value of one more log of an identified joint: the variance of free runs after it, to first order.

The posterior of θ has the covariance S Sᵀ. The fit's residual has the RMS s and the autocorrelation time τ. A log whose
free run has the derivatives J by θ carries the information H = JᵀJ / (s² τ). A free run with the derivatives G then has
the variance diag(G S (1 + Sᵀ H S)⁻¹ Sᵀ Gᵀ), which needs no measurement (I-optimal design; Fedorov 1972).
"""

from dataclasses import dataclass

import numpy as np

from ...numerics.arrays import FloatArray
from ...signals.log import Log
from .model import HybridModel
from .problem import LOST_ERROR_SHARE, CondensedProblem

EVERY = 2
"""Samples of which one counts for those beside it: motions hardly change within 20 ms."""


def slopes(model: HybridModel, t: FloatArray, v: FloatArray, start: float) -> FloatArray | None:
    """Derivatives [mm] of the free run by θ, shape (N, P), from rest at `start` [m]; None where the run diverges.

    Its first second is left out where the joint does not begin at rest.

    Cost: as a Jacobian of the fit, 1 to 2 ms a second.

    Parameters
    ----------
    model : HybridModel
        Identified.
    t : FloatArray, shape (N,)
        Uniform times [s].
    v : FloatArray, shape (N, 2)
        Voltages [V].
    start : float
        Displacement at rest at the first sample [m].
    """
    run = model.simulate(t, v, start, 0.0)
    if run.status != "ok":
        return None
    record = Log(t=t, q=run.q, qdot=run.qdot, qddot=run.qddot, v=v, valid=np.ones(len(t), dtype=bool))
    return CondensedProblem(model.joint, [model.joint.reading(record)]).jacobian(model.theta, 0.0)[1]


@dataclass(frozen=True)
class Uncertainty:
    """Uncertainty of a joint's free run in an excitation sequence, after its logs.

    Attributes
    ----------
    model : HybridModel
        Identified.
    interval : float
        Sample interval [s] of the logs that it was identified from.
    programme : FloatArray, shape (T, R)
        Derivatives [mm] of the free run by the coordinates of the posterior: θ is the fit plus `spread` times these.
    stroke : float
        Range of that run [mm]: a run that ends in the other well errs by no more.
    """

    model: HybridModel
    interval: float
    programme: FloatArray
    stroke: float

    @property
    def noise(self) -> float:
        """s² τ of a second of a log [mm² s]."""
        diagnostics = self.model.diagnostics
        tau = float(diagnostics["integrated_correlation_time"])
        return (1e3 * float(diagnostics["training_rms_m"])) ** 2 * tau * self.interval

    def shown(self, by_theta: FloatArray, dt: float) -> FloatArray:
        """Information of a log of which the derivatives are `by_theta` (N, P) [mm] every `dt` [s], shape (R, R).

        Rows count that the model foresees to a tenth of its stroke: where a run may be lost, a fit is held to the log.
        """
        rows = by_theta[::EVERY] @ self.model.spread
        rows = rows[np.sum(rows**2, axis=1) < (LOST_ERROR_SHARE * self.stroke) ** 2]
        return np.asarray(rows.T @ rows * (EVERY * dt / self.noise))

    def error(self, shown: FloatArray | float = 0.0) -> float:
        """Standard deviation [m] of the free run, RMS over the programme, after logs with more information.

        A variance v counts as v / (1 + v / r²) for the stroke r.
        """
        root = np.linalg.inv(np.linalg.cholesky(np.eye(self.programme.shape[1]) + shown))
        variance = np.sum((self.programme @ root.T) ** 2, axis=1)
        return 1e-3 * float(np.sqrt(np.mean(variance / (1.0 + variance / self.stroke**2))))


def uncertainty(model: HybridModel, t: FloatArray, v: FloatArray, start: float, interval: float) -> Uncertainty | None:
    """Uncertainty of the free run under `v` from rest at `start`; None where it diverges.

    Parameters
    ----------
    model : HybridModel
        Identified.
    t : FloatArray, shape (N,)
        Uniform times of the programme [s].
    v : FloatArray, shape (N, 2)
        Its voltages [V].
    start : float
        Displacement at rest at the first sample [m].
    interval : float
        Sample interval [s] of the logs that the model was identified from.
    """
    by_theta = slopes(model, t, v, start)
    if by_theta is None:
        return None
    q = 1e3 * model.simulate(t, v, start, 0.0).q
    return Uncertainty(model, interval, by_theta[::EVERY] @ model.spread, float(np.ptp(q)))
