"""The data-driven joint as a model: RBF curves, hidden relaxing elements, friction, identified from logs alone."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import field, replace
from typing import Annotated, Any, ClassVar, Self

import numpy as np
from pydantic import dataclasses as stored, model_validator

from ...codegen.graph import trace
from ...fitting.posterior import first_order_curves, outcome_draws, posterior_draws
from ...generated.terms import CONFINED_FORCE, STOP_FORCE
from ...numerics.arrays import FloatArray, IntArray, bridged, sample_interval
from ...numerics.fixed_step import run_status
from ...numerics.metrics import rms
from ...signals.log import Log
from ..base import NO_TUBES, FreeRun, TubeScale, checked, gain_curves
from ..model_file import STORED, Facts, Positive, Sizes, Table, Unit, tree_of
from .dynamics import DAMPING, FORCE, INPUT, Coefficients, basis_rows, free_rates, no_sensitivities
from .observed_run import Coupling, Drive, observed_run
from .parameter_layout import ParameterLayout
from .problem import JointProblem, steps_per_sample
from .structure import JointStructure

PATH_OBSERVER_GAIN = 3.0  # along a measured path, in units of the frequency scale
SEED = 20251  # of the posterior draws: the same model gives the same draws


@stored.dataclass(frozen=True, config=STORED)
class RbfModel:
    """An identified data-driven joint (equation of motion: `pipeline.models.rbf.dynamics`), and its file."""

    sizes: ClassVar[Sizes] = {"P": (1, 20_000), "R": (1, 20_000), "B": (1, 20_000)}
    parameters: ParameterLayout
    """Structure, scales and signs."""
    theta: Annotated[FloatArray, Table("P")]
    """Fitted parameters in units of the scales."""
    spread: Annotated[FloatArray, Table("P R")]
    """Factor S, a row for each entry of theta, of the covariance S Sᵀ of theta, from which outcomes are drawn."""
    band_spread: Annotated[FloatArray, Table("P B")]
    """Factor S, a row for each entry of theta, of the covariance S Sᵀ of theta, as the training data show it."""
    mass_kg: Annotated[Positive, Unit("{m}")] = 1.0
    """Moving mass or inertia; 1 if it is unknown, and curves are then per unit mass."""
    diagnostics: Facts = field(default_factory=dict)
    tube: TubeScale = NO_TUBES

    name = "rbf"
    coupling = PATH_OBSERVER_GAIN
    """Observer gain [frequency scale] at which each sample stands nearly alone."""

    @model_validator(mode="after")
    def _finite(self) -> Self:
        with np.errstate(all="ignore"):
            if self.theta.size != self.parameters.count or not all(
                np.isfinite(values).all() for values in self.parameters.coefficients(self.theta)
            ):
                raise ValueError("theta does not fit its structure")
        return self

    @property
    def fine_voltages(self) -> bool:
        """True if the inputs between the samples are those of the finer record."""
        return self.parameters.structure.hold == "record"

    @property
    def input_count(self) -> int:
        """Number of voltages that it takes."""
        return len(self.parameters.signs)

    @checked
    def simulate(self, t: FloatArray, v: FloatArray, q0: float, qdot0: float) -> FreeRun:
        """Free run; see `pipeline.models.base.DynamicModel.simulate`.

        Hidden states start at rest under the first inputs.
        """
        s = self.parameters.scales
        start = ((q0 - s.middle) / s.half, qdot0 / s.half)
        states, valid = _Driven(self.parameters, self.theta, v, sample_interval(t)).run(_free(len(t)), start)
        return FreeRun(
            t,
            s.middle + s.half * states[:, 0],
            s.half * states[:, 1],
            s.half * states[:, 2],
            *run_status(t, valid),
        )

    def predict(
        self, t: FloatArray, v: FloatArray, seen: FloatArray, speed: FloatArray, starts: IntArray, ahead: IntArray
    ) -> Iterator[FloatArray]:
        """Predictions after an observer has held the joint; see `pipeline.models.base.Predicts`.

        The observer's pole is one over the sample interval; where nothing was measured it rests.
        """
        s = self.parameters.scales
        interval = sample_interval(t)
        measured = np.isfinite(seen)
        x = (bridged(seen, measured) - s.middle) / s.half
        driven = _Driven(self.parameters, self.theta, v, interval)
        coupling = Coupling(x, measured.astype(np.float64), 1.0 / interval)
        held, _ = driven.run(coupling, (float(x[0]), float(speed[0]) / s.half))
        for start, count in zip(starts.tolist(), ahead.tolist(), strict=True):
            states, _ = driven.run(_free(count + 1), np.delete(held[start], 2), start)
            yield s.middle + s.half * states[:, 0]

    @checked
    def simulate_draws(
        self, t: FloatArray, v: FloatArray, q0: float, qdot0: float, *, count: int = 32
    ) -> tuple[FloatArray, FloatArray]:
        """Free runs of an ensemble drawn from the parameters' posterior: what the data leave open.

        Parameters
        ----------
        t : FloatArray, shape (N,)
            Times [s].
        v : FloatArray, shape (N, K) or (N, r, K)
            Inputs at the samples, or at r times of each interval.
        q0 : float
            Displacement at the first sample [m or rad].
        qdot0 : float
            Velocity there.
        count : int
            Number of draws.

        Returns
        -------
        q : FloatArray, shape (count, N)
            Displacement [m]; NaN after divergence.
        theta : FloatArray, shape (count, P)
            The draws.
        """
        s = self.parameters.scales
        draws = self.draws(count)
        start = ((q0 - s.middle) / s.half, qdot0 / s.half)
        driven = (_Driven(self.parameters, theta, v, sample_interval(t)) for theta in draws)
        runs = [each.run(_free(len(t)), start)[0][:, 0] for each in driven]
        return s.middle + s.half * np.array(runs), draws

    def _followed(
        self, t: FloatArray, v: FloatArray, x: FloatArray, seen: FloatArray, speed: float
    ) -> tuple[FloatArray, FloatArray]:
        """State (N, 2 + L + D) behind an observer that follows the path x, and inputs (N, K) at the samples."""
        driven = _Driven(self.parameters, self.theta, v, sample_interval(t))
        coupling = Coupling(x, seen, PATH_OBSERVER_GAIN * self.parameters.scales.frequency)
        states, _ = driven.run(coupling, (float(x[0]), speed))
        return np.delete(states, 2, axis=1), driven.drive.u[:: 2 * driven.steps]

    def acting(self, logs: Sequence[Log]) -> dict[str, float]:
        """RMS force [N] of each element along logs; per unit mass where `mass_kg` is 1, and 0 of one that is absent.

        It is the difference between the accelerations with the element and without. Cost: a trace of the equation for
        each element, and an evaluation of it for each sample.
        """
        s = self.parameters.scales
        parts = [
            self._followed(
                log.t,
                log.drive if self.fine_voltages else log.v,
                bridged((log.q - s.middle) / s.half, log.valid),
                log.valid.astype(np.float64),
                float(log.qdot[0]) / s.half,
            )
            for log in logs
        ]
        states, inputs = (np.concatenate(each) for each in zip(*parts, strict=True))
        known = np.isfinite(states).all(axis=1)
        at = states[known], inputs[known]
        c = self.parameters.coefficients(self.theta)
        whole = _accelerations(c, *at)
        return {
            name: 0.0 if without is None else self.mass_kg * s.half * rms(whole - _accelerations(without, *at))
            for name, without in _left_out(self.parameters, c).items()
        }

    def curves(self, q: FloatArray) -> dict[str, FloatArray]:
        """Characteristic curves at q [m], shape (n,) (fig. 14).

        Returns
        -------
        dict
            ``F`` restoring force [N] at rest without inputs; ``d`` damping [N s/m] including the hidden elements
            that relax faster than the joint moves; and at rest ``dC1_dq``, ``dC2_dq`` [F/m] = 2 g_k (eq. 33) for
            squared inputs, ``g1``, ``g2`` [N/V] for linear ones: those of the largest inputs of the logs. Per unit mass
            where `mass_kg` is 1.
        """
        return self._characteristics(self.theta, q)

    def curve_ensemble(self, q: FloatArray, count: int = 64) -> dict[str, FloatArray]:
        """Curves drawn from the covariance that the training data show, each (count, n), θ acting to first order."""
        return first_order_curves(
            lambda theta: self._characteristics(theta, q), self.theta, self.band_spread, count, SEED, ("d",)
        )

    def outcome_ensemble(self, outcome: Callable[["RbfModel"], FloatArray], count: int = 64) -> FloatArray:
        """Outcomes (count, n) of draws from the covariance that the training data show, θ acting to first order.

        They are of the same draws as `curve_ensemble`.
        """
        return outcome_draws(
            lambda theta: outcome(replace(self, theta=theta)), self.theta, self.band_spread, count, SEED
        )

    def draws(self, count: int) -> FloatArray:
        """Parameter vectors from the posterior, shape (count, P); always the same for the same model."""
        return posterior_draws(self.theta, self.spread, count, SEED)

    def observed(self, parts: Sequence[Log]) -> JointProblem:
        """The joint coupled to the parts of a log."""
        return JointProblem(self.parameters, parts)

    def describe(self) -> dict[str, Any]:
        """Structure, hyperparameters and diagnostics."""
        p = self.parameters
        c = p.coefficients(self.theta)
        return {
            "structure": _equation_of_motion(p.structure),
            "origin": "data alone",
            "basis_functions": p.structure.basis_functions,
            "smoothing": p.structure.smoothing,
            "relaxation_rates_1_per_s": c.rates.tolist(),
            "drag_1_per_m": c.drag / p.scales.half,
            "end_stops_m": (p.scales.middle + p.scales.half * c.stops[:2]).tolist(),
            "slip_length_m": (c.slip_length * p.scales.half).tolist(),
            "mass_kg": self.mass_kg,
            "inputs": p.law,
            "parameters": len(self.theta),
            **self.diagnostics,
        }

    def to_tree(self) -> dict[str, Any]:
        """The model as a dictionary of arrays, numbers and texts."""
        return tree_of(self)

    def _characteristics(self, theta: FloatArray, q: FloatArray) -> dict[str, FloatArray]:
        p = self.parameters
        s = p.scales
        c = p.coefficients(theta)
        relaxing = INPUT + len(p.signs)
        x = np.ascontiguousarray((q - s.middle) / s.half)
        curves: FloatArray = basis_rows(x, c) @ c.curves.T
        ends = {"at_ends": c.at_ends, "low": np.array([c.low]), "high": np.array([c.high])}
        curves[:, [FORCE]] = CONFINED_FORCE.evaluate(x=x[:, None], force=curves[:, [FORCE]], **ends)["value"]
        if len(c.stops):
            curves[:, FORCE] += STOP_FORCE.evaluate(x=x[:, None], p=np.zeros(1), stops=c.stops)["value"][:, 0]
        couplings = curves[:, relaxing : relaxing + len(c.rates)]
        rates = np.tile(c.rates, (len(q), 1))
        for i in range(p.structure.shape_elements):
            rates[:, i] += curves[:, p.rows[f"relaxation{i}"]]
        damping = curves[:, DAMPING] + np.where(rates > p.pace, couplings**2 / rates, 0.0).sum(axis=1)
        squared = p.law == "squared"
        pushes = self.mass_kg * s.half * p.full_effect(theta)[:, None] * curves[:, INPUT:relaxing].T
        forces = {"F": -self.mass_kg * s.half * curves[:, FORCE], "d": self.mass_kg * damping}
        return forces | gain_curves(pushes / (s.volts**2 if squared else s.volts), squared=squared)


class _Driven:
    """A joint under the inputs of a log."""

    def __init__(self, parameters: ParameterLayout, theta: FloatArray, v: FloatArray, interval: float) -> None:
        self._c = parameters.coefficients(theta)
        self._interval = interval
        self.steps = steps_per_sample(parameters, interval, theta)
        u, du = parameters.inputs(v, interval, self.steps, theta)
        self.drive = Drive(u, du, parameters.at_rest(u, theta), parameters.held)

    def run(self, coupling: Coupling, start: FloatArray | tuple[float, float], row: int = 0) -> tuple[FloatArray, int]:
        """States from a row of the log on, and valid samples; see `observed_run`."""
        first, last = (2 * self.steps * sample for sample in (row, row + len(coupling.measured) - 1))
        u, du, rested, held = self.drive
        drive = Drive(u[first : last + 1], du[:, first : last + 1], rested, held)
        states, _, valid = observed_run(self._c, drive, coupling, start, self._interval, self.steps, no_sensitivities())
        return states, valid


def _free(samples: int) -> Coupling:
    """No coupling."""
    return Coupling(np.zeros(samples), np.zeros(samples), 0.0)


def _equation_of_motion(s: JointStructure) -> str:
    """The terms that a structure has, with F as it is drawn: positive where it pulls towards smaller q."""
    pulled = s.shape_elements > 0
    elements = bool(s.rates)
    terms = [
        "mu(q) q'' = -F" if s.arc else "q'' = -F",
        "- (d + k |q'|) q'" if s.drag else "- d q'",
        *["- mu'(q) q'^2 / 2"] * s.arc,
        *["- h e + pulls' u w" if pulled else "- h w"] * elements,
        *["- Dahl friction"] * bool(s.slips),
        "+ gains u",
    ]
    return ", ".join(
        [
            " ".join(terms),
            *["F with end stops"] * s.stops,
            *["w' = h q' - r e, e = w - pulls u" if pulled else "w' = h q' - r w"] * elements,
        ]
    )


def _left_out(p: ParameterLayout, c: Coefficients) -> dict[str, Coefficients | None]:
    """The equation without each of the elements; None of one that it does not have."""
    s = p.structure
    first = INPUT + len(p.signs)
    shapes = first + s.shape_elements
    own = first + len(s.rates)
    return {
        "restoring force": _without_curves(c, FORCE)._replace(at_ends=np.zeros(2)),
        "damping": _without_curves(c, DAMPING),
        "inputs": _without_curves(c, slice(INPUT, first)),
        "hidden shapes": _without_curves(c, slice(first, shapes), slice(own, None)) if s.shape_elements else None,
        "relaxation": _without_curves(c, slice(shapes, own)) if own > shapes else None,
        "dry friction": c._replace(slip_force=np.zeros(s.slips)) if s.slips else None,
        "drag": c._replace(drag=0.0) if s.drag else None,
        "end stops": c._replace(stops=np.empty(0)) if s.stops else None,
    }


def _without_curves(c: Coefficients, *rows: int | slice) -> Coefficients:
    curves = c.curves.copy()
    for row in rows:
        curves[row] = 0.0
    return c._replace(curves=curves)


def _accelerations(c: Coefficients, states: FloatArray, inputs: FloatArray) -> FloatArray:
    """ṗ [1/s²] at the states (N, 2 + L + D) under acting inputs (N, K), shape (N,)."""
    elements = 2 + len(c.rates)
    rates = trace(
        lambda x, slip, u: {"dx": free_rates(c, x, slip, u)}, x=elements, slip=len(c.slip_force), u=inputs.shape[1]
    )
    return np.asarray(rates.evaluate(x=states[:, :elements], slip=states[:, elements:], u=inputs)["dx"][:, 1])
