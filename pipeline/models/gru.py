"""The recurrent black box (GRU) behind the model interface; PyTorch is needed for training only."""

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any, Literal

import numpy as np

from pipeline.baselines.gru import GruWeights, gru_run, gru_steps
from pipeline.baselines.gru_training import GruSeries, train_gru
from pipeline.errors import CorruptArtifactError, InputError
from pipeline.models.base import FreeRun
from pipeline.models.checked import checked
from pipeline.models.kind import Kind, Training
from pipeline.numerics.arrays import FloatArray
from pipeline.numerics.stencils import finite_difference
from pipeline.signals.trajectory import Trajectory

HELD_OUT = 0.2  # share at the end of the training data that picks the weights


@dataclass(frozen=True)
class GruModel:
    """A trained network with the scales of its signals.

    Attributes
    ----------
    weights : GruWeights
        The network.
    interval : float
        Sample interval [s] that it steps at.
    state_scales : FloatArray, shape (2,)
        Of q [m] and q̇ [m/s].
    input_scales : FloatArray, shape (K,)
        Of the inputs [V² or V].
    squared : bool
        Whether u = v² or u = v.
    diagnostics : dict
        How training went.
    """

    weights: GruWeights
    interval: float
    state_scales: FloatArray
    input_scales: FloatArray
    squared: bool
    diagnostics: dict[str, Any] = field(default_factory=dict)

    name = "gru"
    fine_voltages = False

    @property
    def input_count(self) -> int:
        """Number of voltages that it takes."""
        return self.input_scales.size

    @checked
    def simulate(self, t: FloatArray, v: FloatArray, q0: float, qdot0: float) -> FreeRun:
        """Free run; see `pipeline.models.base.Model.simulate`. A bounded network cannot diverge, only be wrong.

        q̇ is read out like q, q̈ is its difference of sixth order.

        Raises
        ------
        InputError
            The record has another sample interval than the training data.
        """
        self._check(t)
        states = gru_run(self.weights, self._inputs(v), np.array([q0, qdot0]) / self.state_scales) * self.state_scales
        return FreeRun(
            t, states[:, 0].copy(), states[:, 1].copy(), finite_difference(states[:, 1], self.interval, 1), "ok"
        )

    @checked
    def accelerate(self, t: FloatArray, v: FloatArray, q: FloatArray, qdot: FloatArray) -> FloatArray:
        """Change of q̇ over one sample, per interval, from each measured state; the last row repeats its neighbour."""
        self._check(t)
        states = np.column_stack([q, qdot]) / self.state_scales
        change = gru_steps(self.weights, self._inputs(v), states)[:, 1] * self.state_scales[1] / self.interval
        padded: FloatArray = np.pad(change, (0, 1), mode="edge")
        return padded

    def _inputs(self, v: FloatArray) -> FloatArray:
        u: FloatArray = (np.square(v) if self.squared else v) / self.input_scales
        return u

    def _check(self, t: FloatArray) -> None:
        interval = float((t[-1] - t[0]) / (len(t) - 1))
        if abs(interval / self.interval - 1.0) > 1e-3:
            raise InputError(f"the GRU steps at {self.interval:g} s, the record at {interval:g} s; resample the log")

    def describe(self) -> dict[str, Any]:
        """Structure and how training went."""
        weights = sum(int(np.size(x)) for x in vars(self.weights).values())
        return {"structure": "GRU", "units": self.weights.units, "weights": weights, **self.diagnostics}

    def to_tree(self) -> dict[str, Any]:
        """The model as a dictionary of arrays, numbers and texts."""
        return {
            **vars(self.weights),
            "interval_s": self.interval,
            "state_scales": self.state_scales,
            "input_scales": self.input_scales,
            "inputs": "squared" if self.squared else "linear",
            "diagnostics": dict(self.diagnostics),
        }

    @classmethod
    def from_tree(cls, tree: dict[str, Any]) -> "GruModel":
        """The model back from `to_tree`.

        Raises
        ------
        CorruptArtifactError
            An entry is missing or the arrays do not fit each other.
        """
        try:
            names = GruWeights.__dataclass_fields__
            weights = GruWeights(**{name: np.asarray(tree[name], dtype=np.float64) for name in names})
            state_scales = np.asarray(tree["state_scales"], dtype=np.float64)
            input_scales = np.asarray(tree["input_scales"], dtype=np.float64)
            interval, squared = float(tree["interval_s"]), str(tree["inputs"]) == "squared"
        except KeyError as missing:
            raise CorruptArtifactError(f"the model gru lacks {missing}; run `debist compare` again") from None
        h, k = weights.units, input_scales.size
        shapes = [np.shape(x) for x in vars(weights).values()]
        if shapes != [(3 * h, k), (3 * h,), (3 * h, h), (3 * h,), (h, 3), (2, h + 1)] or state_scales.shape != (2,):
            raise CorruptArtifactError("the arrays of the model gru do not fit each other; run `debist compare` again")
        return cls(weights, interval, state_scales, input_scales, squared, dict(tree.get("diagnostics", {})))


def identify_gru(
    trajectories: Sequence[Trajectory],
    *,
    inputs: Literal["squared", "linear"] = "squared",
    time_limit: float = np.inf,
    rng: np.random.Generator | None = None,
    **training: Any,
) -> GruModel:
    """Train a GRU on the training logs alone: gradients on the first 80 %, weights picked by the last 20 %.

    Parameters
    ----------
    trajectories : sequence of Trajectory
        Gap-free stretches, all of one sample interval.
    inputs : {"squared", "linear"}
        Whether v² or v enters.
    time_limit : float
        Processor time [s] after which training stops; what was reached is kept and said.
    rng : numpy.random.Generator, optional
        Initial weights and windows; seeded with 0 by default.
    **training
        `units` and `iterations` of `pipeline.baselines.gru_training.train_gru`.

    Raises
    ------
    InputError
        PyTorch is missing, no data, stretches that are too short, or differing sample intervals or inputs.
    """
    if not trajectories:
        raise InputError("there is no training data; name at least one training log with valid samples")
    interval, squared = trajectories[0].interval, inputs == "squared"
    if len({x.v.shape[1] for x in trajectories}) != 1 or any(
        abs(x.interval / interval - 1) > 1e-3 for x in trajectories
    ):
        raise InputError("the training logs differ in inputs or sample interval; a GRU needs one interval")
    acting = [np.square(x.v) if squared else x.v for x in trajectories]
    input_scales = np.max([np.abs(u).max(axis=0) for u in acting], axis=0)
    input_scales[input_scales == 0.0] = 1.0
    state_scales = np.max([[np.abs(x.q).max(), np.abs(x.qdot).max()] for x in trajectories], axis=0)
    state_scales[state_scales == 0.0] = 1.0
    series = [
        GruSeries(u / input_scales, np.column_stack([x.q, x.qdot]) / state_scales)
        for x, u in zip(trajectories, acting, strict=True)
    ]
    result = train_gru(
        *_split(series), time_limit=time_limit, rng=rng if rng is not None else np.random.default_rng(0), **training
    )
    notes = {
        "iterations": result.iterations,
        "best_iteration": result.best_iteration,
        "held_out_rms_of_scaled_q": result.held_out_error,
        "training_status": result.status,
        "training_cpu_s": result.seconds,
    }
    return GruModel(result.weights, interval, state_scales, input_scales, squared, notes)


def _split(series: list[GruSeries]) -> tuple[list[GruSeries], list[GruSeries]]:
    """The first 80 % of all samples and the rest, cut inside a stretch where need be."""
    left = round((1.0 - HELD_OUT) * sum(len(s.u) for s in series))
    first, last = [], []
    for s in series:
        cut = min(max(left, 0), len(s.u))
        left -= len(s.u)
        if cut >= 2:
            first.append(GruSeries(s.u[:cut], s.states[:cut]))
        if len(s.u) - cut >= 2:
            last.append(GruSeries(s.u[cut:], s.states[cut:]))
    return first, last


def _fit(training: Training) -> GruModel:
    return identify_gru(training.stretches, inputs=training.inputs, time_limit=training.compare.time_limit)


GRU = Kind(_fit, GruModel.from_tree)
