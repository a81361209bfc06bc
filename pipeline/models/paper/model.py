"""The paper's recipe to the letter (§4.2): 4M weights by least squares, one friction lag, Gaussians.

    m q̈ = −c(q) q − d(q) z + Σ_k g_k(q) u_k,  ż = (q̇ − z)/T_z,  u_k = v_k²                     (eqs. 37-40)

with c, d, g_k = Σ_i θ_i exp(−(q−ξ_i)²/(2σ_n²Δξ²)). Eq. 37 prints ½ g v², but g = ½ ∂C/∂q holds the ½ already
(eqs. 33, 40), so it stands once here.
"""

# mypy: disable-error-code="no-untyped-def,no-untyped-call"

from collections.abc import Iterator, Sequence
from typing import Annotated, Any, ClassVar, Literal, NamedTuple, Self

import numpy as np
from pydantic import Field, model_validator

from ...codegen.numba_writer import formula
from ...fitting.information import coverage
from ...fitting.posterior import posterior_draws, whiteness
from ...fitting.regression import (
    InputAction,
    basis_centres,
    basis_values,
    basis_width,
    curve_signals,
    input_signal,
    pseudo_inverse_fit,
    regressor,
    triangular_factor,
)
from ...generated.terms import GAUSSIAN, LAGGED_RATES
from ...numerics.arrays import FloatArray, IntArray, bridged, sample_interval
from ...numerics.fixed_step import (
    Methods,
    begin,
    between_samples,
    bounded_run,
    escape_bounds,
    finish,
    inlined,
    integrator,
    run_status,
    steps_per_sample,
)
from ...numerics.linear_filters import first_order_lag
from ...settings.models import CENTRES, SMOOTHING
from ...signals.log import Log, operating_range
from ..base import FreeRun, checked, gain_curves
from ..model_file import MOST_INPUTS, Lag, ModelFile, Positive, Rising, Sizes, Table, Unit
from ..model_type import ModelType, Training
from .lag_search import LagSegment, search_lag

_gaussian = formula(GAUSSIAN)
_lagged_rates = formula(LAGGED_RATES)

REACH = 8.6
"""|q − ξ|/σ from which a bell is left out of a sum: exp(−37) is below rounding."""
ROWS = 8192  # rows of the regressor that are held at once
_LARGEST = 1e300
"""Magnitude of a weight: where hardly any data determine one, the pseudo-inverse has no bound."""
SEED = 20251  # of the draws of weights: the same model gives the same bands


class LaggedJoint(NamedTuple):
    """A joint of eqs. 37 to 40 in a run, over its mass.

    Voltages v (N, K) [V] are linear between samples; weights (M, 2 + K) have columns c, d, g_1 … g_K. `parts` are half
    steps in a sample interval, `farthest` is the square of the reach of a bell (None: no term is left out), `inverse`
    is 1/σ, `u` and `values` have room for inputs and curves.
    """

    v: FloatArray
    squared: bool
    parts: int
    farthest: float | None
    centres: FloatArray
    weights: FloatArray
    inverse: float
    lag: float
    u: FloatArray
    values: FloatArray


def _rates(system, x, node, dx, acceleration):
    """State equation under the inputs of the half step."""
    n, following, share = between_samples(node, system.parts, len(system.v))
    for k in range(system.v.shape[1]):
        u = system.v[n, k] + share * (system.v[following, k] - system.v[n, k])
        system.u[k] = u * u if system.squared else u
    _move(system, x, system.u, dx)
    acceleration[0] = dx[1]


@inlined
def _move(system, x, u, dx):
    """Curves at q as sums over the basis without negligible terms; then the state equation."""
    for s in range(len(system.values)):
        system.values[s] = 0.0
    for i in range(len(system.centres)):
        distance = (x[0] - system.centres[i]) * system.inverse
        square = distance * distance
        if system.farthest is None or square < system.farthest:
            value = _gaussian((square,))[0]
            for s in range(len(system.values)):
                system.values[s] += system.weights[i, s] * value
    forcing = 0.0
    for k in range(len(u)):
        forcing += system.values[2 + k] * u[k]
    dx[0] = x[1]
    dx[1], dx[2] = _lagged_rates((x[0], x[1], x[2], system.values[0], system.values[1], forcing, system.lag))


_integrate = integrator(LaggedJoint, lambda kind: Methods(begin, _rates, finish))


def lagged_rates(model: "RbfPaperModel", x: Sequence[Any], u: Sequence[Any]) -> list[Any]:
    """Rates of q, q̇ and z under the inputs u (K,): the state equation of a run for traced values."""
    nothing = np.empty(0)
    dx = np.empty(3, dtype=object)
    _move(model.joint(nothing, 1, None, nothing, np.empty(2 + len(u), dtype=object)), x, u, dx)
    return list(dx)


class RbfPaperModel(ModelFile):
    """The identified model of §4.2, and its file. K inputs, M basis functions."""

    sizes: ClassVar[Sizes] = {"R": (3, 2 + MOST_INPUTS), "M": (2, 200), "S": (0, 1000)}
    name: ClassVar[str] = "rbf-paper"
    fine_voltages: ClassVar[bool] = False
    centres: Annotated[Rising, Unit("{q}")]
    """Centres ξ of the basis functions."""
    smoothing: Annotated[float, Field(ge=1e-3, le=1e3)]
    """Smoothing factor σ_n: the width over the distance of the centres."""
    width: Annotated[Positive, Unit("{q}")] = Field(
        default_factory=lambda data: basis_width(data["centres"], data["smoothing"])
    )
    """Width σ of the basis functions."""
    weights: Annotated[FloatArray, Table("R M", -_LARGEST, _LARGEST), Unit("{c}, {d}, {g}")]
    """Weights by row: stiffness c, damping d, gain g of each input."""
    lag_s: Annotated[Lag, Unit("s")]
    """Time constant T_z of the friction state."""
    mass_kg: Annotated[Positive, Unit("{m}")] = 1.0
    """Moving mass or inertia; 1 if it is unknown, and curves are then per unit mass."""
    inputs: InputAction = "squared"
    """Action of the inputs: squared or linear."""
    basis: Literal["gaussian"] = "gaussian"
    """Basis function."""
    spread: Annotated[FloatArray, Table("W S", -_LARGEST, _LARGEST), Unit("{c}, {d}, {g}")] = np.empty((0, 0))
    """Factor S of the covariance S Sᵀ of the weights, row by row of weights; empty if it is not known."""

    @model_validator(mode="after")
    def _named(self) -> Self:
        if len(self.spread) not in (0, self.weights.size):
            raise ValueError(f"spread has {len(self.spread)} rows for {self.weights.size} weights")
        return self

    def joint(self, v: FloatArray, parts: int, reach: float | None, u: FloatArray, values: FloatArray) -> LaggedJoint:
        """The system of a run.

        Parameters
        ----------
        v : FloatArray, shape (N, K)
            Voltages [V].
        parts : int
            Half steps in a sample interval.
        reach : float, optional
            Distance in σ from which a bell is left out; none is if left out.
        u, values : FloatArray, shapes (K,) and (2 + K,)
            Room for inputs and curves.
        """
        return LaggedJoint(
            v=v,
            squared=self.inputs == "squared",
            parts=parts,
            farthest=None if reach is None else reach**2,
            centres=self.centres,
            weights=np.ascontiguousarray(self.weights.T) / self.mass_kg,
            inverse=1.0 / self.width,
            lag=float(self.lag_s),
            u=u,
            values=values,
        )

    @property
    def input_count(self) -> int:
        """Number of voltages that it takes."""
        return len(self.weights) - 2

    @checked
    def simulate(self, t: FloatArray, v: FloatArray, q0: float, qdot0: float) -> FreeRun:
        """Free run under measured voltages; see `pipeline.models.base.DynamicModel.simulate`.

        The friction state starts at z(0) = q̇(0). The run counts as diverged when q leaves the operating range of
        the training data by more than twice its length.
        """
        states, valid = self._run(t, v, (q0, qdot0, qdot0))
        return FreeRun(t, states[:, 0].copy(), states[:, 1].copy(), states[:, 2].copy(), *run_status(t, valid))

    def predict(
        self, t: FloatArray, v: FloatArray, seen: FloatArray, speed: FloatArray, starts: IntArray, ahead: IntArray
    ) -> Iterator[FloatArray]:
        """Predictions with friction filtered from the measured velocity; see `pipeline.models.base.Predicts`."""
        z, _ = first_order_lag(bridged(speed, np.isfinite(speed)), sample_interval(t), self.lag_s)
        for start, count in zip(starts.tolist(), ahead.tolist(), strict=True):
            rows = slice(start, start + count + 1)
            yield self._run(t[rows], v[rows], (float(seen[start]), float(speed[start]), float(z[start])))[0][:, 0]

    def _run(self, t: FloatArray, v: FloatArray, start: tuple[float, float, float]) -> tuple[FloatArray, int]:
        """Integrate from q, q̇ and z: q, q̇, q̈ at the samples (N, 3), NaN after divergence, and valid samples.

        Cost: 4 evaluations of M exponentials and (2 + K)·M products a step, about 60 ns each for M = 10.
        """
        interval = sample_interval(t)
        steps = steps_per_sample(interval, self.lag_s)
        inputs = self.input_count
        system = self.joint(np.ascontiguousarray(v), 2 * steps, REACH, np.zeros(inputs), np.zeros(2 + inputs))
        bounds = escape_bounds(*self.centres[[0, -1]].tolist())
        return bounded_run(_integrate, system, np.array(start), len(v), steps, interval, bounds)

    @checked
    def accelerate(self, t: FloatArray, v: FloatArray, q: FloatArray, qdot: FloatArray) -> FloatArray:
        """Acceleration [m/s²] along a measured path, the friction state filtered from the measured velocity.

        Parameters
        ----------
        t : FloatArray, shape (N,)
            Times [s].
        v : FloatArray, shape (N, K)
            Inputs.
        q : FloatArray, shape (N,)
            Displacement.
        qdot : FloatArray, shape (N,)
            Velocity.
        """
        curves = basis_values(q, self.centres, self.width) @ self.weights.T
        signals = self._signals(q, qdot, v, sample_interval(t))
        return np.asarray(np.einsum("ij,ij->i", curves, signals) / self.mass_kg)

    def _signals(self, q: FloatArray, qdot: FloatArray, v: FloatArray, interval: float) -> FloatArray:
        """Signals of eq. 40 along a measured motion, the friction state filtered from its velocity."""
        z, _ = first_order_lag(np.ascontiguousarray(qdot), interval, self.lag_s)
        return curve_signals(q, z, input_signal(v, self.inputs))

    def curves(self, q: FloatArray) -> dict[str, FloatArray]:
        """Characteristic curves at q [m], shape (n,) (fig. 14).

        Returns
        -------
        dict
            ``F`` = c(q) q, restoring force [N]; ``d`` damping [N s/m]; ``dC1_dq``, ``dC2_dq`` [F/m] = 2 g_k (eq. 33)
            for squared inputs, ``g1``, ``g2`` [N/V] for linear ones. Per unit mass where `mass_kg` is 1.
        """
        return self._characteristics(self.weights, q)

    def curve_ensemble(self, q: FloatArray, count: int = 64) -> dict[str, FloatArray]:
        """The curves of `count` draws of the weights, each of shape (count, n); the same at every call."""
        draws = posterior_draws(self.weights.ravel(), self.spread, count, SEED)
        drawn = [self._characteristics(weights, q) for weights in draws.reshape(count, *self.weights.shape)]
        return {name: np.array([each[name] for each in drawn]) for name in drawn[0]}

    def _characteristics(self, weights: FloatArray, q: FloatArray) -> dict[str, FloatArray]:
        values = basis_values(q, self.centres, self.width) @ weights.T
        forces = {"F": values[:, 0] * q, "d": values[:, 1]}
        return forces | gain_curves(values.T[2:], squared=self.inputs == "squared")

    def regressors(self, motion: Log) -> FloatArray:
        """Rows of eq. 40 along a measured motion, shape (N, (2 + K)·M), the lag being known."""
        signals = self._signals(motion.q, motion.qdot, motion.v, motion.interval)
        return regressor(basis_values(motion.q, self.centres, self.width), signals)

    def force_rows(self, q: FloatArray) -> FloatArray:
        """Rows that give the restoring force c(q) q [N] at q [m] from all weights, shape (n, (2 + K)·M)."""
        signals = np.zeros((len(q), len(self.weights)))
        signals[:, 0] = q
        return regressor(basis_values(q, self.centres, self.width), signals)

    def describe(self) -> dict[str, Any]:
        """Structure, hyperparameters and diagnostics."""
        return {
            "structure": "m q'' = -c(q) q - d(q) z + sum g_k(q) u_k, z' = (q' - z)/T_z",
            "basis_functions": len(self.centres),
            "basis": self.basis,
            "smoothing": self.smoothing,
            "centre_min_m": float(self.centres[0]),
            "centre_max_m": float(self.centres[-1]),
            "lag_s": self.lag_s,
            "mass_kg": self.mass_kg,
            "inputs": self.inputs,
            **self.diagnostics,
        }


def identify_rbf_paper(
    trajectories: Sequence[Log],
    *,
    basis_functions: int = CENTRES,
    smoothing: float = SMOOTHING,
    mass: float = 1.0,
    inputs: InputAction = "squared",
) -> RbfPaperModel:
    """Identify the model of §4.2 from gap-free segments of training logs.

    Parameters
    ----------
    trajectories : sequence of Log
        The friction state starts anew, z = q̇, in each of them.
    basis_functions : int
        M.
    smoothing : float
        σ_n.
    mass : float
        m_q [kg]; 1 if unknown, the weights are then per unit mass.
    inputs : {"squared", "linear"}
        Action of the inputs: u = v² or u = v.

    Raises
    ------
    InputError
        No data, a constant displacement, fewer than two basis functions.
    """
    centres = basis_centres(*operating_range(trajectories), basis_functions)
    width = basis_width(centres, smoothing)
    segments = [_segment(x, basis_values(x.q, centres, width), mass, inputs) for x in trajectories]
    lag, converged, history = search_lag(segments)
    fit = pseudo_inverse_fit(*triangular_factor(_rows(segments)))
    tau = _correlation_time(segments, fit.weights)
    visited = coverage(centres, [x.q for x in trajectories], [x.v for x in trajectories])
    return RbfPaperModel(
        centres=centres,
        smoothing=smoothing,
        weights=fit.weights.reshape(-1, basis_functions),
        lag_s=lag,
        mass_kg=mass,
        inputs=inputs,
        spread=fit.residual_rms * np.sqrt(tau) * fit.spread,
        diagnostics={
            "rank": fit.rank,
            "parameters": len(fit.weights),
            "condition": fit.condition,
            "residual_rms": fit.residual_rms,
            "samples": fit.samples,
            "lag_iterations": len(history) - 1,
            "lag_converged": converged,
            "lag_search": dict(zip(("lag_s", "cost", "rank", "condition"), history.T.copy(), strict=True)),
            "residual_correlation_samples": tau,
            "visits_per_centre": visited.visits,
            "driven_visits_per_centre": visited.driven,
        },
    )


def _segment(x: Log, basis: FloatArray, mass: float, inputs: InputAction) -> LagSegment:
    signals = curve_signals(x.q, np.zeros_like(x.q), input_signal(x.v, inputs))
    return LagSegment(basis, signals, mass * x.qddot, np.ascontiguousarray(x.qdot), x.interval)


def _rows(segments: Sequence[LagSegment]) -> Iterator[FloatArray]:
    """Blocks of rows of [ψᵀ y] (eq. 40)."""
    for x in segments:
        for start in range(0, len(x.target), ROWS):
            part = slice(start, start + ROWS)
            yield np.column_stack((regressor(x.basis[part], x.signals[part]), x.target[part]))


def _correlation_time(segments: Sequence[LagSegment], weights: FloatArray) -> float:
    """Autocorrelation time [samples] of the residual in the longest segment: coloured residuals widen the bands."""
    x = max(segments, key=lambda segment: len(segment.target))
    curves = x.basis @ weights.reshape(-1, x.basis.shape[1]).T
    return whiteness(x.target - np.einsum("ij,ij->i", curves, x.signals)).integrated_correlation_time


def _fit(training: Training) -> RbfPaperModel:
    return identify_rbf_paper(
        training.segments,
        basis_functions=training.identify.basis_functions,
        smoothing=training.identify.smoothing,
        mass=training.device.mass,
        inputs=training.device.action,
    )


RBF_PAPER = ModelType(_fit, RbfPaperModel, "export.data_driven:realise_paper")
