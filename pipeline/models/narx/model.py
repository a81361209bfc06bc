"""The polynomial NARX black box behind the model interface."""

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Annotated, Any, ClassVar, Literal, Self

import numpy as np
from pydantic import model_validator

from pipeline.errors import InputError
from pipeline.models.base import FreeRun, checked
from pipeline.models.kind import Kind
from pipeline.models.model_file import MOST_INPUTS, Exponents, ModelFile, Positive, PositiveRow, Sizes, Span, Table
from pipeline.models.narx.equation import NarxEquation, NarxStructure, fit_narx, narx_run
from pipeline.numerics.arrays import FloatArray, IntArray, sample_interval
from pipeline.numerics.linear_filters import finite_difference
from pipeline.signals.trajectory import Trajectory
from pipeline.solvers.fixed_step import run_status

MOST_LAGS = 64
"""Increments, or lags of an input."""


class _File(ModelFile):
    sizes: ClassVar[Sizes] = {"P": (1, 500), "X": (2, 1 + MOST_LAGS * (1 + MOST_INPUTS))}
    structure: Annotated[IntArray, Table("4", 0, MOST_LAGS, whole=True)]
    exponents: Exponents
    coefficients: Annotated[FloatArray, Table("P")]
    scales: PositiveRow
    interval_s: Positive
    inputs: Literal["squared", "linear"]
    bounds: Span

    @model_validator(mode="after")
    def _lags(self) -> Self:
        _, increments, input_lags, inputs = self.structure.tolist()
        if increments < 1 or not 1 <= inputs <= MOST_INPUTS or len(self.scales) != 1 + increments + inputs * input_lags:
            raise ValueError(f"structure {self.structure.tolist()} does not fit the {len(self.scales)} variables")
        return self


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
        theta, _, first = self.equation.regression(q, v)
        change = theta @ self.equation.coefficients / self.equation.interval**2
        return np.pad(change, (first, 1), mode="edge")  # rows whose lags reach beyond the record repeat their neighbour

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
        e = self.equation
        return {
            "structure": np.array(e.structure, dtype=np.int64),
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
            An entry is missing, of another kind or shape, or beyond its range.
        """
        file = _File.read(tree, "narx", "compare")
        equation = NarxEquation(
            NarxStructure(*file.structure.tolist()), file.exponents, file.coefficients, file.scales, file.interval_s,
            file.inputs == "squared", *file.bounds.tolist(),
        )  # fmt: skip
        return cls(equation, file.diagnostics)


def identify_narx(
    trajectories: Sequence[Trajectory], *, inputs: Literal["squared", "linear"] = "squared", most: int | None = None
) -> NarxModel:
    """Polynomial NARX chosen on the training data: see `pipeline.models.narx.equation.fit_narx`.

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
        No data, a constant displacement, differing sample intervals or inputs, or stretches that are too short.
    """
    return NarxModel(*fit_narx(trajectories, squared=inputs == "squared", most=most))


NARX = Kind(
    lambda data: identify_narx(data.stretches, inputs=data.inputs, most=data.compare.candidates), NarxModel.from_tree
)
