"""Neural state space: `neural`, a black box for comparison that is trained by deepSI where it is installed.

    x_{k+1} = f(x_k, u_k),   q_k = h(x_k),   x_k = ψ(q_{k−n}, …, q_{k−1}, u_{k−n}, …, u_{k−1})

f, h and the encoder ψ have a linear part and one hidden layer of tanh, between variables of mean 0 and spread 1. They
are trained together on free runs over short windows, each from the state that the encoder takes from the samples before
(Beintema, Schoukens & Tóth 2023, doi:10.1016/j.automatica.2023.111210). The weights that err least in a free run over
the last fifth of the training logs are taken. Only training needs deepSI and PyTorch: a free run is NumPy.
"""

import importlib.util
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from functools import partial
from typing import Annotated, Any, ClassVar, Literal, Self

import numpy as np
from pydantic import model_validator

from pipeline.errors import DataRefusedError, InputError
from pipeline.fitting.regression import input_signal
from pipeline.models.base import FreeRun, checked
from pipeline.models.difference_equation import check_interval, sampled_run
from pipeline.models.kind import Kind
from pipeline.models.model_file import FilePart, ModelFile, Positive, Real, Sizes, Span, Table
from pipeline.numerics.arrays import FloatArray, IntArray
from pipeline.numerics.progress import OnProgress, silent
from pipeline.scoring.cross_validation import free_run_error
from pipeline.signals.trajectory import Trajectory, operating_range
from pipeline.solvers.fixed_step import escape_bounds

STATES, HIDDEN, PAST = 6, 32, 10
"""States, units of each hidden layer, samples that the encoder sees. Few: the logs hold some thousand samples."""

WINDOW, BATCH, STEPS, CHECKED = 100, 64, 2_000, 250
"""Samples of a training window, windows of a step, steps of Adam, and steps after which the held-out error is taken."""

RATE, LAST_RATE, STEEPEST = 2e-3, 6e-5, 1.0
"""Learning rate, which falls as a cosine, and largest norm of a gradient."""

HELD_OUT = 0.2
"""Share at the end of each stretch that is not fitted."""


class Network(FilePart):
    """A linear part and one hidden layer: A z + b + W tanh(V z + c).

    Attributes
    ----------
    linear, bias : FloatArray, shape (Y, X) and (Y,)
        A and b.
    inner, inner_bias : FloatArray, shape (H, X) and (H,)
        V and c.
    outer : FloatArray, shape (Y, H)
        W.
    """

    sizes: ClassVar[Sizes] = {"X": (1, 1000), "Y": (1, 1000), "H": (1, 1000)}
    linear: Annotated[FloatArray, Table("Y X")]
    bias: Annotated[FloatArray, Table("Y")]
    inner: Annotated[FloatArray, Table("H X")]
    inner_bias: Annotated[FloatArray, Table("H")]
    outer: Annotated[FloatArray, Table("Y H")]

    def __call__(self, z: FloatArray) -> FloatArray:
        """Values at z, shape (…, X): of shape (…, Y)."""
        hidden = np.tanh(z @ self.inner.T + self.inner_bias)
        return z @ self.linear.T + self.bias + hidden @ self.outer.T


class NeuralModel(ModelFile):
    """A state space at a fixed sample interval; its file holds the same entries.

    Attributes
    ----------
    step, output, encoder : Network
        f, h and ψ. The encoder takes the inputs before the displacements, the oldest first.
    middle, spread : float
        Mean and standard deviation of q [m] in training.
    input_middle, input_spread : FloatArray, shape (K,)
        The same of the inputs.
    interval_s : float
        Sample interval [s].
    inputs : {"squared", "linear"}
        Whether u = v² or u = v.
    bounds : FloatArray, shape (2,)
        Displacement [m] outside of which a run counts as diverged.
    diagnostics : dict
        How it was trained.
    """

    name: ClassVar[str] = "neural"
    fine_voltages: ClassVar[bool] = False
    step: Network
    output: Network
    encoder: Network
    middle: Real
    spread: Positive
    input_middle: Annotated[FloatArray, Table("K")]
    input_spread: Annotated[FloatArray, Table("K", 1e-30)]
    interval_s: Positive
    inputs: Literal["squared", "linear"]
    bounds: Span

    @model_validator(mode="after")
    def _networks(self) -> Self:
        states, inputs = len(self.step.linear), self.input_count
        past, rest = divmod(self.encoder.linear.shape[1], 1 + inputs)
        shapes = [network.linear.shape for network in (self.step, self.output, self.encoder)]
        if rest or past < 1 or shapes != [(states, states + inputs), (1, states), (states, past * (1 + inputs))]:
            raise ValueError(f"networks of the shapes {shapes} do not fit {inputs} inputs")
        return self

    @property
    def input_count(self) -> int:
        """Number of voltages that it takes."""
        return len(self.input_spread)

    @property
    def past(self) -> int:
        """Samples that the encoder sees."""
        return int(self.encoder.linear.shape[1]) // (1 + self.input_count)

    def to_tree(self) -> dict[str, Any]:
        """The contents as nested dictionaries of arrays, numbers and texts."""
        networks = {name: dict(getattr(self, name)) for name in ("step", "output", "encoder")}
        return super().to_tree() | networks

    @checked
    def simulate(self, t: FloatArray, v: FloatArray, q0: float, qdot0: float) -> FreeRun:
        """Free run; see `pipeline.models.base.DynamicModel.simulate`.

        Before the first sample q followed a line of slope q̇0 under the first inputs. q̇ and q̈ are differences of sixth
        order of the simulated q. Cost: some 10 µs per sample.

        Raises
        ------
        InputError
            The record has another sample interval than the model.
        """
        check_interval(t, self.interval_s, self.name)
        u = self._scaled_inputs(v)
        past = q0 + qdot0 * self.interval_s * np.arange(-self.past, 0, dtype=np.float64)
        state = self._encoded(np.repeat(u[:1], self.past, axis=0)[None], past[None])[0]
        q, reached = self._run(state, u)
        q[0] = q0
        return sampled_run(t, q, reached, self.interval_s)

    def predict(
        self, t: FloatArray, v: FloatArray, seen: FloatArray, speed: FloatArray, starts: IntArray, ahead: IntArray
    ) -> Iterator[FloatArray]:
        """Predictions from the measured past that the encoder sees; see `pipeline.models.base.Predicts`."""
        check_interval(t, self.interval_s, self.name)
        u, rows = self._scaled_inputs(v), np.arange(len(seen))
        unmeasured = np.maximum.accumulate(np.where(np.isfinite(seen), -1, rows))
        for start, count in zip(starts.tolist(), ahead.tolist(), strict=True):
            before = np.arange(start - self.past, start)
            line = seen[start] + speed[start] * self.interval_s * (before - start)
            past = np.where(before > unmeasured[start], seen[np.maximum(before, 0)], line)
            state = self._encoded(u[np.maximum(before, 0)][None], past[None])[0]
            run, _ = self._run(state, u[start : start + count + 1])
            run[0] = seen[start]
            yield run

    @checked
    def accelerate(self, t: FloatArray, v: FloatArray, q: FloatArray, qdot: FloatArray) -> FloatArray:
        """Acceleration [m/s²] of the next two samples from each encoded past; `qdot` is not used."""
        check_interval(t, self.interval_s, self.name)
        if len(q) <= self.past + 2:
            raise InputError(f"the record has {len(q)} samples; this model needs {self.past + 3}")
        u, windows = self._scaled_inputs(v), np.lib.stride_tricks.sliding_window_view
        first = np.arange(len(q) - self.past - 1)
        states = self._encoded(windows(u, self.past, axis=0).swapaxes(1, 2)[first], windows(q, self.past)[first])
        ahead = [states]
        for n in range(2):
            ahead.append(self.step(np.hstack([ahead[-1], u[np.minimum(first + self.past + n, len(u) - 1)]])))
        bend = np.diff([self.spread * self.output(x)[:, 0] for x in ahead], 2, axis=0)[0] / self.interval_s**2
        return np.pad(bend, (self.past + 1, 0), mode="edge")

    def _scaled_inputs(self, v: FloatArray) -> FloatArray:
        """Inputs of mean 0 and spread 1 in training, shape (N, K)."""
        return (input_signal(v, self.inputs) - self.input_middle) / self.input_spread

    def _encoded(self, u: FloatArray, q: FloatArray) -> FloatArray:
        """States, shape (B, n), behind scaled inputs (B, past, K) and displacements [m] (B, past)."""
        return self.encoder(np.hstack([u.reshape(len(u), -1), (q - self.middle) / self.spread]))

    def _run(self, state: FloatArray, u: FloatArray) -> tuple[FloatArray, int]:
        """Displacement [m] under scaled inputs, NaN after a divergence, and the samples within the bounds."""
        states, n, f = np.empty((len(u), len(state))), len(state), self.step
        direct, driven = u @ f.linear[:, n:].T + f.bias, u @ f.inner[:, n:].T + f.inner_bias
        linear, inner = f.linear[:, :n], f.inner[:, :n]
        for k in range(len(u)):
            states[k] = state
            state = linear @ state + direct[k] + f.outer @ np.tanh(inner @ state + driven[k])
        q = self.middle + self.spread * self.output(states)[:, 0]
        beyond = np.flatnonzero(~((q >= self.bounds[0]) & (q <= self.bounds[1])))
        reached = int(beyond[0]) if beyond.size else len(q)
        q[reached:] = np.nan
        return q, reached

    def describe(self) -> dict[str, Any]:
        """Structure and how it was trained."""
        return {
            "structure": "neural state space with a subspace encoder",
            "sample_interval_s": self.interval_s,
            "states": len(self.step.linear),
            "hidden_units": len(self.step.inner),
            "past_samples": self.past,
            **self.diagnostics,
        }


def identify_neural(
    trajectories: Sequence[Trajectory],
    *,
    inputs: Literal["squared", "linear"] = "squared",
    steps: int = STEPS,
    on_progress: OnProgress = silent,
) -> NeuralModel:
    """Train on free runs over windows of the training data; the same data give the same model on one machine.

    Parameters
    ----------
    trajectories : sequence of Trajectory
        Gap-free stretches of the training logs, all of one sample interval; only q and v are used.
    inputs : {"squared", "linear"}
        Whether v² or v enters.
    steps : int
        Steps of Adam. Cost: each runs `BATCH` windows of `WINDOW` samples forth and back, about 30 ms.
    on_progress : callable
        Called with the held-out error and the share of the steps that are done.

    Raises
    ------
    InputError
        deepSI is not installed, differing sample intervals or inputs, stretches that are too short.
    DataRefusedError
        Training never followed the held-out data.
    """
    for needed in ("torch", "deepSI"):
        if importlib.util.find_spec(needed) is None:
            raise InputError(
                'neural is trained by deepSI, which is not installed: `pip install "debist[neural]"`, or leave neural '
                "out of [compare] models"
            )
    first, least = trajectories[0], PAST + WINDOW
    if any(x.v.shape[1] != first.v.shape[1] or abs(x.interval / first.interval - 1) > 1e-3 for x in trajectories):
        raise InputError("the training logs differ in inputs or sample interval; a neural model needs one interval")
    long = [x for x in trajectories if (1.0 - HELD_OUT) * len(x.t) >= least]
    if not long:
        most = max(len(x.t) for x in trajectories)
        raise InputError(
            f"the longest training stretch has {most} samples, a neural model needs {round(least / (1.0 - HELD_OUT))}; "
            "give longer logs or leave neural out"
        )
    scales, ends = _scales(long, inputs), [int((1.0 - HELD_OUT) * len(x.t)) for x in long]
    held_out = [x.part(end - PAST, len(x.t)) for x, end in zip(long, ends, strict=True)]
    span = float(np.ptp(operating_range(trajectories)))
    best, least_error = None, 1.0
    for done, networks in _training([x.part(0, end) for x, end in zip(long, ends, strict=True)], scales, steps):
        model = NeuralModel.model_validate(networks | scales)
        error = float(np.mean([_error(model, x, span) for x in held_out]))
        on_progress(f"neural: {100.0 * error:.3g} % on held-out data", done)
        if error < least_error:
            best, least_error = model, error
    if best is None:
        raise DataRefusedError("no neural model follows the training logs; check q and its unit, or leave neural out")
    weights = sum(array.size for network in (best.step, best.output, best.encoder) for _, array in network)
    return best.model_copy(update={"diagnostics": {"inner_validation_nrmse": least_error, "parameters": weights}})


def _scales(trajectories: Sequence[Trajectory], inputs: Literal["squared", "linear"]) -> dict[str, Any]:
    """The entries of the model that are not trained."""
    q = np.concatenate([x.q for x in trajectories])
    u = np.concatenate([input_signal(x.v, inputs) for x in trajectories])
    spread = u.std(axis=0)
    return {
        "middle": float(q.mean()),
        "spread": float(q.std()),
        "input_middle": u.mean(axis=0),
        "input_spread": np.where(spread > 0.0, spread, 1.0),
        "interval_s": trajectories[0].interval,
        "inputs": inputs,
        "bounds": np.array(escape_bounds(*operating_range(trajectories))),
    }


def _training(
    trajectories: Sequence[Trajectory], scales: dict[str, Any], steps: int
) -> Iterator[tuple[float, dict[str, dict[str, FloatArray]]]]:
    """Every `CHECKED` steps of Adam the share of them that are done, and the networks; one thread, one seed."""
    import deepSI
    import torch
    from deepSI.networks import MLP_res_net

    network = partial(MLP_res_net, n_hidden_layers=1, n_hidden_nodes=HIDDEN)
    count = len(scales["input_spread"])
    logs = [
        deepSI.Input_output_data(
            u=(input_signal(x.v, scales["inputs"]) - scales["input_middle"]) / scales["input_spread"],
            y=(x.q - scales["middle"]) / scales["spread"],
        )
        for x in trajectories
    ]
    with torch.random.fork_rng(devices=[]), _one_thread():
        torch.manual_seed(0)
        subnet = deepSI.SUBNET(
            count, "scalar", None, nx=STATES, nb=PAST, na=PAST, f=network(STATES + count, STATES),
            h=network(STATES, "scalar"), encoder=network(PAST * (1 + count), STATES),
        )  # fmt: skip
        windows, starts = subnet.create_arrays(logs, T=WINDOW)
        optimiser = torch.optim.Adam(subnet.parameters(), lr=RATE)
        slower = torch.optim.lr_scheduler.CosineAnnealingLR(optimiser, steps, eta_min=LAST_RATE)
        rng = np.random.default_rng(0)
        for done in range(1, steps + 1):
            chosen = rng.choice(starts, BATCH)
            batch = [part[chosen].contiguous() for part in windows]
            loss = torch.mean((subnet(*batch) - batch[-1]) ** 2)
            if not torch.isfinite(loss):
                break
            optimiser.zero_grad()
            torch.autograd.backward(loss)
            torch.nn.utils.clip_grad_norm_(subnet.parameters(), STEEPEST)
            optimiser.step()
            slower.step()
            if done % CHECKED == 0 or done == steps:
                networks = {"step": subnet.f, "output": subnet.h, "encoder": subnet.encoder}
                yield done / steps, {name: _weights(network) for name, network in networks.items()}


@contextmanager
def _one_thread() -> Iterator[None]:
    """One thread of PyTorch's own; the number before is restored."""
    import torch

    threads = torch.get_num_threads()
    torch.set_num_threads(1)
    try:
        yield
    finally:
        torch.set_num_threads(threads)


def _weights(network: Any) -> dict[str, FloatArray]:
    """The arrays of a trained network."""
    linear, (inner, _, outer) = network.net_res, network.net_nonlin
    parts = {
        "linear": linear.weight, "bias": linear.bias + outer.bias, "inner": inner.weight, "inner_bias": inner.bias,
        "outer": outer.weight,
    }  # fmt: skip
    return {name: part.detach().numpy().astype(np.float64) for name, part in parts.items()}


def _error(model: NeuralModel, x: Trajectory, span: float) -> float:
    """Of a free run from the first encoded state of a stretch, over a span [m]."""
    [predicted] = model.predict(x.t, x.v, x.q, x.qdot, np.array([PAST]), np.array([len(x.t) - 1 - PAST]))
    return free_run_error(x.q[PAST:], predicted, span)


NEURAL = Kind(
    lambda data: identify_neural(data.stretches, inputs=data.inputs, on_progress=data.on_progress),
    partial(NeuralModel.read, name="neural", command="compare"),
)
