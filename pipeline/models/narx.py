"""The polynomial NARX black box behind the model interface."""

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any, Literal

import numpy as np

from pipeline.baselines.narx import NarxEquation, NarxStructure, accelerations, narx_run
from pipeline.errors import CorruptArtifactError, InputError
from pipeline.models.base import FreeRun, checked, stored
from pipeline.models.kind import Kind
from pipeline.numerics.arrays import FloatArray, sample_interval
from pipeline.numerics.stencils import finite_difference
from pipeline.signals.trajectory import Trajectory
from pipeline.solvers.free_run import run_status


@dataclass(frozen=True)
class NarxModel:
    """A difference equation for q at a fixed sample interval.

    Attributes
    ----------
    equation : NarxEquation
        Lags, terms and weights.
    diagnostics : dict
        How it was chosen.
    """

    equation: NarxEquation
    diagnostics: dict[str, Any] = field(default_factory=dict)

    name = "narx"
    fine_voltages = False

    @property
    def input_count(self) -> int:
        """Number of voltages that it takes."""
        return self.equation.structure.inputs

    @checked
    def simulate(self, t: FloatArray, v: FloatArray, q0: float, qdot0: float) -> FreeRun:
        """Free run; see `pipeline.models.base.DynamicModel.simulate`.

        Inputs are taken at the samples. q̇ and q̈ are differences of sixth order of the simulated q.

        Raises
        ------
        InputError
            The record has another sample interval than the equation.
        """
        self._check(t)
        q, reached = narx_run(self.equation, v, q0, qdot0)
        qdot, qddot = np.full((2, q.size), np.nan)
        qdot[:reached] = finite_difference(q[:reached], self.equation.interval, 1)
        qddot[:reached] = finite_difference(q[:reached], self.equation.interval, 2)
        status, diverged_at = run_status(t, reached)
        return FreeRun(t, q, qdot, qddot, status, diverged_at)

    @checked
    def predict(self, t: FloatArray, v: FloatArray, seen: FloatArray, speed: FloatArray) -> FloatArray:
        """Prediction after measured rows, whose q are the equation's past; see `pipeline.models.base.predictor`."""
        self._check(t)
        return narx_run(self.equation, v, float(seen[-1]), float(speed[-1]), seen)[0][len(seen) - 1 :]

    @checked
    def accelerate(self, t: FloatArray, v: FloatArray, q: FloatArray, qdot: FloatArray) -> FloatArray:
        """Acceleration [m/s²] of the one-step prediction along a gap-free path; `qdot` is not used."""
        self._check(t)
        return accelerations(self.equation, v, q)

    def _check(self, t: FloatArray) -> None:
        interval = sample_interval(t)
        if abs(interval / self.equation.interval - 1.0) > 1e-3:
            raise InputError(
                f"the NARX model steps at {self.equation.interval:g} s, the record at {interval:g} s; resample the log"
            )

    def describe(self) -> dict[str, Any]:
        """Structure and how it was chosen."""
        s = self.equation.structure
        return {
            "structure": "polynomial NARX",
            "sample_interval_s": self.equation.interval,
            "degree": s.degree,
            "past_displacements": s.increments + 1,
            "input_lags": s.input_lags,
            "terms_kept": len(self.equation.exponents),
            **self.diagnostics,
        }

    def to_tree(self) -> dict[str, Any]:
        """The model as a dictionary of arrays, numbers and texts."""
        e, s = self.equation, self.equation.structure
        return {
            "structure": np.array([s.degree, s.increments, s.input_lags, s.inputs], dtype=np.int64),
            "exponents": e.exponents,
            "coefficients": e.coefficients,
            "scales": e.scales,
            "interval_s": e.interval,
            "inputs": "squared" if e.squared else "linear",
            "bounds": np.array([e.low, e.high]),
            "diagnostics": dict(self.diagnostics),
        }

    @classmethod
    def from_tree(cls, tree: dict[str, Any]) -> "NarxModel":
        """The model back from `to_tree`.

        Raises
        ------
        CorruptArtifactError
            An entry is missing or the tables do not fit each other.
        """
        with stored("narx", "compare"):
            structure = NarxStructure(*(int(x) for x in tree["structure"]))
            exponents = np.asarray(tree["exponents"], dtype=np.int64)
            coefficients = np.asarray(tree["coefficients"], dtype=np.float64)
            scales = np.asarray(tree["scales"], dtype=np.float64)
            low, high = (float(x) for x in tree["bounds"])
            squared = str(tree["inputs"]) == "squared"
            equation = NarxEquation(
                structure, exponents, coefficients, scales, float(tree["interval_s"]), squared, low, high
            )
        variables = 1 + structure.increments + structure.inputs * structure.input_lags
        if scales.shape != (variables,) or exponents.shape != (coefficients.size, variables):
            raise CorruptArtifactError("the tables of the model narx do not fit each other; run `debist compare` again")
        return cls(equation, dict(tree.get("diagnostics", {})))


def identify_narx(
    trajectories: Sequence[Trajectory],
    *,
    inputs: Literal["squared", "linear"] = "squared",
    most: int | None = None,
) -> NarxModel:
    """Polynomial NARX chosen on the training data: see `pipeline.baselines.narx_fit.fit_narx`.

    Parameters
    ----------
    trajectories : sequence of Trajectory
        Gap-free stretches of the training logs, all of one sample interval.
    inputs : {"squared", "linear"}
        Whether v² or v enters.
    most : int, optional
        Candidates that the search tries, see `fit_narx`.

    Raises
    ------
    InputError
        No data, a constant displacement, or differing sample intervals or inputs.
    """
    from pipeline.baselines.narx_fit import fit_narx

    fit = fit_narx(trajectories, squared=inputs == "squared", most=most)
    return NarxModel(
        fit.equation,
        {
            "library_terms": fit.library_terms,
            "inner_validation_nrmse": float(fit.fold_errors.mean()),
            "inner_validation_nrmse_of_folds": fit.fold_errors,
            "candidates_tried": fit.candidates_tried,
            "search_status": fit.search_status,
        },
    )


NARX = Kind(
    lambda data: identify_narx(data.stretches, inputs=data.inputs, most=data.compare.candidates), NarxModel.from_tree
)
