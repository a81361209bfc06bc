"""The hybrid joint as a model: the analytical joint with asymmetries and friction, RBF networks as correction.

Equations: `pipeline.equations.condensed_joint`. Estimation: `pipeline.models.hybrid.identify`.
"""

from collections.abc import Iterator, Sequence
from dataclasses import field, replace
from functools import cached_property, lru_cache
from typing import Annotated, Any, ClassVar, Self

import numpy as np
from pydantic import Field, dataclasses as stored, model_validator
from scipy.interpolate import CubicSpline

from ...fitting.posterior import first_order_curves, posterior_draws
from ...generated.condensed_joint import CONSTANTS
from ...numerics.arrays import FloatArray, IntArray, bridged, sample_interval
from ...numerics.fixed_step import run_status
from ...signals.log import Log
from ...signals.resampling import filtered_samples
from ..base import NO_TUBES, FreeRun, TubeScale, checked
from ..model_file import STORED, Facts, JointSet, Positive, Real, Sizes, Table, Unit, tree_of
from .kernels import CURVES
from .log_reading import DrivingVoltages, Similarity
from .parameters import DEVIATIONS, NAMES, PRIOR_STD, moving_mass
from .problem import POLES, CondensedJoint, CondensedProblem, age_at, simulate
from .runs import BATCH, Driving, Followed, JointCoefficients, continued_runs
from .statics import static_curves, substeps

SEED = 20252  # of the posterior draws: the same model gives the same draws

MOVED = 0.2
"""Largest standard deviation [widths] of the draws in a direction of the posterior. The probabilities of 814 outcomes
on 84 logs of 28 simulated joints had a Brier score of 0.0046 without a bound (47 called ambiguous). With bounds of
0.3 to 0.1 it was 0.0016 to 0.0019 (8 to 4), and none of those called sure was wrong. With a bound of 0.02 two were."""


_FARTHEST = 300.0
"""Largest magnitude of an entry of theta [widths]; exponentials of more overflow."""


@stored.dataclass(frozen=True, config=STORED)
class HybridModel:
    """An identified hybrid joint, and its file.

    `early`, which is not filed, is the same fitted to the first three quarters of each training log.
    """

    sizes: ClassVar[Sizes] = {
        "P": (1, 5000),
        "R": (1, 5000),
        "B": (1, 5000),
        "K": (0, 5000),
        "C": (1, 10_000),
        "S": (1, 5000),
    }
    parameters: JointSet
    basis: Annotated[FloatArray, Table("3", -1e3, 1e3), Unit("{q}")]
    """First centre, distance of the centres and width σ of the Gaussians of the corrections."""
    centres: Annotated[int, Field(ge=0, le=200)]
    """Number of Gaussians of each correction."""
    largest_voltage_V: Annotated[Positive, Unit("V")]
    """Largest voltage of the training logs; held above twice that."""
    slope_ratio: Real
    """Slope of the beam at rest over q/l, from which the search for a rest starts."""
    similarity: Similarity
    theta: Annotated[FloatArray, Table("P", -_FARTHEST, _FARTHEST)]
    """Fitted parameters in widths of their priors."""
    spread: Annotated[FloatArray, Table("P R")]
    """Factor S, a row for each entry of theta, of the covariance S Sᵀ of theta, from which outcomes are drawn."""
    band_spread: Annotated[FloatArray, Table("P B")]
    """Factor S, a row for each entry of theta, of the covariance S Sᵀ of theta, as the training data show it."""
    curve_spread: Annotated[FloatArray, Table("C S")]
    """Factor S, a row for each entry of theta, of the covariance S Sᵀ of theta, for the bands of the curves; with
    corrections that are left open."""
    rotation: Annotated[FloatArray, Table("K 2", -1e3, 1e3), Unit("SI")] = field(
        default_factory=lambda: np.empty((0, 2))
    )
    """q [m] and angle [rad] at rest, by which a measured angle was converted to a displacement; else empty."""
    diagnostics: Facts = field(default_factory=dict)
    tube: TubeScale = NO_TUBES
    constants: str = " | ".join(CONSTANTS)
    """Names of the constants of the equations, in order."""
    deviations: str = " | ".join(NAMES)
    """Names of the first entries of theta: deviations from the set; weights follow."""
    prior_std: Annotated[FloatArray, Table("D"), Unit("SI")] = field(default_factory=lambda: PRIOR_STD)
    """Standard deviations of the deviations' priors, in which theta counts."""
    early: Annotated[Any, Field(exclude=True)] = field(default=None, repr=False)

    name = "hybrid"
    fine_voltages = True
    input_count = 2

    @model_validator(mode="after")
    def _fit(self) -> Self:
        named = (" | ".join(CONSTANTS), " | ".join(NAMES)) == (self.constants, self.deviations)
        if not (named and np.array_equal(self.prior_std, PRIOR_STD)):
            raise ValueError("the parameters belong to another version of debist")
        if self.basis[1:].min() <= 0.0:
            raise ValueError("distance and width in basis are not positive")
        if len(self.theta) != len(self.joint.start()):
            raise ValueError(f"theta has {len(self.theta)} entries for {self.centres} Gaussians")
        more = len(self.curve_spread) - len(self.theta)
        if more < 0 or more % CURVES:
            raise ValueError(f"curve_spread has {len(self.curve_spread)} rows for {len(self.theta)} parameters")
        return self

    @classmethod
    def of(
        cls,
        joint: CondensedJoint,
        theta: FloatArray,
        spread: FloatArray,
        band_spread: FloatArray,
        curve_spread: FloatArray | None = None,
        **more: Any,
    ) -> "HybridModel":
        """The model of a joint.

        Parameters
        ----------
        joint : CondensedJoint
            Parameter set and RBF basis.
        theta : FloatArray, shape (P,)
            Deviations and weights in prior widths.
        spread : FloatArray, shape (P, R)
            Factor S of the posterior covariance S Sᵀ of θ.
        band_spread : FloatArray, shape (P, B)
            Factor of the covariance that the training data show (`pipeline.fitting.posterior.robust_spread`).
        curve_spread : FloatArray, shape (P + 9 M, S), optional
            The same for the bands of the curves, of the θ of `of_curves`; that of `band_spread` if left out.
        more
            Diagnostics, tube and early fit.
        """
        return cls(
            parameters=joint.parameters,
            basis=joint.basis,
            centres=joint.centres,
            largest_voltage_V=joint.largest_voltage,
            slope_ratio=joint.slope_ratio,
            similarity=joint.similarity,
            theta=theta,
            spread=spread,
            band_spread=band_spread,
            curve_spread=band_spread if curve_spread is None else curve_spread,
            rotation=joint.rotation,
            **more,
        )

    @cached_property
    def joint(self) -> CondensedJoint:
        """Parameter set and RBF basis."""
        return CondensedJoint(
            parameters=self.parameters,
            basis=self.basis,
            centres=self.centres,
            largest_voltage=self.largest_voltage_V,
            slope_ratio=self.slope_ratio,
            similarity=self.similarity,
            rotation=self.rotation,
        )

    @property
    def mass_kg(self) -> float:
        """Moving mass [kg]."""
        return moving_mass(self.parameters, self.slope_ratio) * self.similarity.mass

    @checked
    def simulate(self, t: FloatArray, v: FloatArray, q0: float, qdot0: float) -> FreeRun:
        """Free run; see `pipeline.models.base.DynamicModel.simulate`.

        Voltages between samples are a cubic spline, or as fine as they are given (`DrivingVoltages`); they are held at
        twice the largest trained one. A wall confines the run (`CondensedJoint.q_stop`), so it is bounded for any
        input.
        """
        states = self._simulate(None, t, v, np.array([q0, qdot0]))[0]
        q, qdot, qddot = np.ascontiguousarray(states.T)
        return FreeRun(t, q, qdot, qddot, *run_status(t, int(np.count_nonzero(np.isfinite(q)))))

    def predict(
        self, t: FloatArray, v: FloatArray, seen: FloatArray, speed: FloatArray, starts: IntArray, ahead: IntArray
    ) -> Iterator[FloatArray]:
        """Predictions after an observer has held the joint; see `pipeline.models.base.Predicts`.

        The observer's pole is one over the sample interval; where nothing was measured it rests.
        """
        joint = self.joint
        angle = joint.angle
        measured = np.isfinite(seen)
        if angle:
            seen, speed, _ = angle.read(seen, speed, np.zeros_like(seen))
        instruments = joint.instruments(self.theta)
        dt = sample_interval(t)
        steps = joint.substeps(self.theta, dt)
        fine = np.linspace(0.0, dt * (len(t) - 1), 2 * steps * (len(t) - 1) + 1)
        u = DrivingVoltages(v, dt).squared(steps, instruments, joint.largest_voltage)
        followed = Followed(
            reading=CubicSpline(t - t[0], bridged(seen, measured))(fine),
            pole=(measured & np.append(measured[1:], False)) / dt,
        )
        driving = Driving(
            squares=u[None],
            variant=np.zeros(1, np.int64),
            offset=np.array([instruments.offset]),
            start=np.array([seen[0], speed[0], age_at(t)]),
        )
        coefficients = JointCoefficients(
            joint.constants(self.theta)[None], joint.weights(self.theta)[None], joint.basis
        )
        runs = continued_runs(coefficients, driving, followed, joint.stepping(dt, steps), starts, ahead)
        return runs if angle is None else (angle.shown(run, np.zeros_like(run), np.zeros_like(run))[0] for run in runs)

    @checked
    def simulate_draws(
        self, t: FloatArray, v: FloatArray, q0: float, qdot0: float, *, count: int = 32
    ) -> tuple[FloatArray, FloatArray]:
        """Free runs of an ensemble drawn from the parameters' posterior, which show what the data leave open.

        Parameters
        ----------
        t : FloatArray, shape (N,)
            Times [s].
        v : FloatArray, shape (N, 2) or (N, r, 2)
            Voltages [V] at the samples, or at r times of each interval.
        q0 : float
            Displacement at the first sample [m].
        qdot0 : float
            Velocity there [m/s].
        count : int
            Number of draws.

        Returns
        -------
        q : FloatArray, shape (count, N)
            Displacement [m].
        theta : FloatArray, shape (count, P)
            The draws.
        """
        draws = self.draws(count)
        return self._simulate(draws, t, v, np.array([q0, qdot0]))[:, :, 0], draws

    @checked
    def simulate_many(self, t: FloatArray, v: FloatArray, starts: FloatArray) -> FloatArray:
        """Free runs from several states; see `pipeline.models.base.SimulatesMany`. Eight of them go at once."""
        return self._simulate(None, t, v, starts)[:, :, 0]

    def curves(self, q: FloatArray) -> dict[str, FloatArray]:
        """Characteristic curves at q [m], shape (n,) (fig. 14): F [N], d [N·s/m], dC1_dq, dC2_dq [F/m].

        Along the static path without voltage, friction and creep left out; see `pipeline.models.hybrid.statics`.
        """
        return self._curves(self.theta, q)

    def curve_ensemble(self, q: FloatArray, count: int = 64) -> dict[str, FloatArray]:
        """Curves drawn from the covariance that the training data show, each (count, n), θ acting to first order."""
        wide = self.of_curves
        return first_order_curves(
            lambda theta: wide._curves(theta, q), wide.theta, self.curve_spread, count, SEED, ("d",)
        )

    @property
    def of_curves(self) -> "HybridModel":
        """Model for the curves: the same with the corrections that their bands leave open, zero where none acts."""
        more = len(self.curve_spread) - len(self.theta)
        return replace(self, centres=self.centres + more // CURVES, theta=np.append(self.theta, np.zeros(more)))

    @property
    def coupling(self) -> float:
        """Observer pole [1/s] at which each sample stands nearly alone."""
        return POLES[1] / self.joint.similarity.time

    def observed(self, parts: Sequence[Log]) -> CondensedProblem:
        """The joint coupled to the parts of a log."""
        return CondensedProblem(self.joint, [self.joint.reading(part) for part in parts], from_start=True)

    def draws(self, count: int) -> FloatArray:
        """Parameter vectors that the data allow, shape (count, P); always the same for the same model.

        They are from the posterior, but move by at most `MOVED` in its directions. Directions of which the data show
        little hardly act on a run. Far along them a draw would leave the curved valley that fits the data.
        """
        values, vectors = np.linalg.eigh(self.spread @ self.spread.T)
        moved = vectors * np.minimum(np.sqrt(np.maximum(values, 0.0)), MOVED) @ vectors.T
        return posterior_draws(self.theta, moved, count, SEED)

    def describe(self) -> dict[str, Any]:
        """Structure, every deviation in its unit with its standard deviation, and diagnostics."""
        sd = np.sqrt(np.sum(self.spread**2, axis=1))
        return {
            "structure": "analytical joint in (q, tau, beta) with two sides, Maxwell slip and creep; RBF corrections",
            "origin": "equations of the joint and data",
            "basis_functions": self.joint.centres,
            "mass_kg": self.mass_kg,
            "over the parameter set": {
                name: getattr(self.joint.similarity, name) for name in ("length", "time", "voltage")
            },
            "inputs": "squared",
            "parameters": len(self.theta),
            "physical_parameters": len(DEVIATIONS),
            "deviations": {
                f"{entry.name} [{'1' if entry.logarithm else entry.unit}]": [
                    float(self.theta[j] * entry.prior_std),
                    float(sd[j] * entry.prior_std),
                ]
                for j, entry in enumerate(DEVIATIONS)
            },
            **self.diagnostics,
        }

    def to_tree(self) -> dict[str, Any]:
        """The model as a dictionary of arrays, numbers and texts."""
        return {name: entry for name, entry in tree_of(self).items() if name != "rotation" or self.joint.angle}

    def _simulate(self, thetas: FloatArray | None, t: FloatArray, v: FloatArray, start: FloatArray) -> FloatArray:
        """Free runs of several θ (None: the fit's) from one state, shape (2,), or of one from several, shape (B, 2).

        Shape (B, N, 3).
        """
        dt = sample_interval(t)
        angle = self.joint.angle
        if angle:
            q, qdot, _ = angle.read(start[..., 0], start[..., 1], np.zeros_like(start[..., 0]))
            start = np.stack([q, qdot], axis=-1)
        start = np.concatenate([start, np.full((*start.shape[:-1], 1), age_at(t))], axis=-1)
        driving = DrivingVoltages(v, dt)
        built = self._best if thetas is None else (self.joint.constants(thetas), self.joint.weights(thetas))
        thetas = self.theta[None] if thetas is None else thetas
        numbers = (array.tobytes() for array in (built[0], self.joint.basis, built[1]))
        steps = _substeps(*numbers, len(thetas), dt, self.joint.similarity.time)
        if start.ndim > 1:
            thetas, *parts = (np.repeat(each, len(start), axis=0) for each in (thetas, *built))
            built = parts[0], parts[1]

        def runs_of(rows: slice, *, every_step: bool) -> FloatArray:
            """Runs of some of them, as the log shows their displacement."""
            begin = start if start.ndim == 1 else start[rows]
            read = simulate(
                self.joint,
                thetas[rows],
                lambda seen: driving.squared(steps, seen, self.joint.largest_voltage),
                begin,
                Followed(np.zeros(0), np.zeros(len(t))),
                self.joint.stepping(dt, steps),
                every_step=every_step,
                built=(built[0][rows], built[1][rows]),
            )
            return np.stack(angle.shown(*np.moveaxis(read, -1, 0)), axis=-1) if angle else read

        if not driving.refined:
            return runs_of(slice(None), every_step=False)
        # Samples of a log that is known between them have been low-pass filtered, so these are too.
        blocks = (slice(first, first + BATCH) for first in range(0, len(thetas), BATCH))  # every step of all is much
        return np.concatenate([filtered_samples(runs_of(rows, every_step=True), steps) for rows in blocks])

    @cached_property
    def _best(self) -> tuple[FloatArray, FloatArray]:
        """Constants and weights of the fit, which restarts along a log simulate hundreds of times."""
        return self.joint.constants(self.theta[None]), self.joint.weights(self.theta[None])

    def _curves(self, theta: FloatArray, q: FloatArray) -> dict[str, FloatArray]:
        joint = self.joint
        inner = np.ascontiguousarray(q - joint.instruments(theta).offset)
        force, damping, left, right = static_curves(inner, joint.constants(theta), joint.basis, joint.weights(theta))
        return {"F": force, "d": damping, "dC1_dq": 2.0 * left, "dC2_dq": 2.0 * right}


@lru_cache(maxsize=128)
def _substeps(constants: bytes, basis: bytes, weights: bytes, count: int, dt: float, slowness: float) -> int:
    """Runge–Kutta steps of several joints in a sample interval, kept: a map of basins runs the same joint often."""
    k, centres, rows = (np.frombuffer(text, dtype=np.float64).copy() for text in (constants, basis, weights))
    return substeps(k.reshape(count, -1), centres, rows.reshape(count, CURVES, -1), dt, slowness)
