"""The one interface of all models, the result of a free run, and the check of its inputs."""

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from functools import wraps
from inspect import signature
from typing import Annotated, Any, Literal, Protocol, TypeVar, cast, runtime_checkable

import numpy as np
from pydantic import Field, dataclasses as stored

from ..errors import InputError
from ..numerics.arrays import FloatArray, IntArray
from ..scoring.scores import Predict
from ..signals.log import Log
from ..signals.timebase import is_uniform
from .model_file import STORED, Unit


@dataclass(frozen=True)
class FreeRun:
    """A simulation from an initial state under measured voltages, nothing fed back.

    Attributes
    ----------
    t : FloatArray, shape (N,)
        Time [s].
    q, qdot, qddot : FloatArray, shape (N,)
        Displacement, velocity and acceleration [m, m/s, m/s²] ([rad …] for an angle).
        After `diverged_at_s` they are NaN.
    status : {"ok", "diverged"}
        "ok" if the whole record was simulated within the model's bounds.
    diverged_at_s : float or None
        Time [s] at which the state left the bounds or stopped being finite.
    """

    t: FloatArray
    q: FloatArray
    qdot: FloatArray
    qddot: FloatArray
    status: Literal["ok", "diverged"]
    diverged_at_s: float | None = None


class DynamicModel(Protocol):
    """A dynamic model of a joint with one displacement and one or two voltages."""

    @property
    def name(self) -> str:
        """The name under which predictions and scores are filed, e.g. ``rbf-paper``."""

    @property
    def input_count(self) -> int:
        """Number of voltages that it takes."""

    @property
    def fine_voltages(self) -> bool:
        """True if the model takes voltages between the samples, of shape (N, r, n_inputs), where they are known."""

    def simulate(self, t: FloatArray, v: FloatArray, q0: float, qdot0: float) -> FreeRun:
        """Simulate freely from ``(q0, qdot0)``, with hidden states as after a long rest at the first sample.

        Parameters
        ----------
        t : FloatArray, shape (N,)
            Uniform time base [s].
        v : FloatArray, shape (N, n_inputs)
            Measured voltages [V], linear between samples. With `fine_voltages` also of shape (N, r, n_inputs): at r
            evenly spaced times of each sample interval, from the sample itself on.
        q0, qdot0 : float
            Initial displacement [m] and velocity [m/s].

        Raises
        ------
        InputError
            Signals of other lengths, shapes or numbers of inputs, samples that are not finite, a time base that is
            not uniform; see `checked`.
        """

    def describe(self) -> dict[str, Any]:
        """Description for readers: structure, hyperparameters, diagnostics, with units in the keys."""


@runtime_checkable
class Predicts(Protocol):
    """A model that takes its hidden states from a measurement before it predicts."""

    def predict(
        self, t: FloatArray, v: FloatArray, seen: FloatArray, speed: FloatArray, starts: IntArray, ahead: IntArray
    ) -> Iterable[FloatArray]:
        """Displacement after each of several measured rows, nothing later being fed back.

        Parameters
        ----------
        t, v
            As for `DynamicModel.simulate`.
        seen, speed : FloatArray, shape (N,)
            Measured displacement [m] and velocity [m/s]; NaN where masked, but not in the first row and the starts.
        starts, ahead : IntArray, shape (S,)
            Rising rows, and how many samples each prediction reaches.

        Returns
        -------
        iterable of FloatArray, shape (ahead + 1,)
            q [m] from each start on; NaN after a divergence.
        """


@runtime_checkable
class HasCurves(Protocol):
    """A model whose forces are curves over q."""

    def curves(self, q: FloatArray) -> dict[str, FloatArray]:
        """Characteristic curves at q, each of the shape of q: F, d, and dC1_dq … or g1 … of the inputs."""


@runtime_checkable
class HasCurveDraws(Protocol):
    """A model with error bands of its curves."""

    def curve_ensemble(self, q: FloatArray, count: int = 64) -> dict[str, FloatArray]:
        """The curves of `count` draws from the posterior, each (count, n)."""


@runtime_checkable
class HasDraws(DynamicModel, Protocol):
    """A model that simulates draws from the posterior of its parameters."""

    def simulate_draws(
        self, t: FloatArray, v: FloatArray, q0: float, qdot0: float, *, count: int = 32
    ) -> tuple[FloatArray, FloatArray]:
        """Free runs of `count` draws, q of shape (count, N), and the draws.

        Parameters
        ----------
        t, v, q0, qdot0
            As for `DynamicModel.simulate`.
        count : int
            Number of draws.
        """


@runtime_checkable
class HasOutcomeDraws(Protocol):
    """A model whose every prediction has error bands, hidden states and friction included."""

    def outcome_ensemble(self, outcome: Callable[[Any], FloatArray], count: int = 64) -> FloatArray:
        """Outcomes of draws from the posterior of its parameters, shape (count, n).

        Parameters
        ----------
        outcome : callable
            Such a model → numbers, shape (n,), NaN where there is none.
        count : int
            Number of draws.
        """


_NotNegative = Annotated[float, Field(ge=0.0, le=1e6)]


@stored.dataclass(frozen=True, config=STORED)
class TubeScale:
    """Scale of a model's tubes, also in its file; with a factor of zero the model has no tubes."""

    factor: _NotNegative = 0.0
    """Half width of the tubes over the spread of the draws."""
    floor: Annotated[_NotNegative, Unit("{q}")] = 0.0
    """Least spread: the error on the training data."""
    apart: Annotated[_NotNegative, Unit("{q}")] = 0.0
    """Distance from which on a draw is in another well."""


NO_TUBES = TubeScale()
"""Scale of a model that has no tubes."""


@runtime_checkable
class HasTubes(HasDraws, Protocol):
    """A model with uncertainty bands of its free runs on other logs."""

    @property
    def tube(self) -> TubeScale:
        """Scale of the bands; its factor is zero where they are not known."""


@runtime_checkable
class SimulatesMany(Protocol):
    """A model that simulates several free runs at less than the cost of each."""

    def simulate_many(self, t: FloatArray, v: FloatArray, starts: FloatArray) -> FloatArray:
        """Displacement [m] of free runs under one v, shape (n, N), NaN where one is lost.

        `starts`, shape (n, 2), has their displacements [m] and velocities [m/s].
        """


def from_first(model: DynamicModel, record: Log) -> FreeRun:
    """The free run of a model over a whole record from its first sample, gaps included."""
    v = record.drive_of(fine=model.fine_voltages)
    return model.simulate(record.t, v, float(record.q[0]), float(record.qdot[0]))


def gain_curves(gains: Iterable[FloatArray], *, squared: bool) -> dict[str, FloatArray]:
    """Gains g_k of the inputs by the names of their curves: dC1_dq … = 2 g_k (eq. 33) where `squared`, else g1 …."""
    return {f"dC{k}_dq" if squared else f"g{k}": 2.0 * g if squared else g for k, g in enumerate(gains, start=1)}


def predictor(model: DynamicModel) -> Predict:
    """The predictions of a model as `Predicts` has them; where it has none, each begins as a free run does."""
    if isinstance(model, Predicts):
        return model.predict

    def predict(
        t: FloatArray, v: FloatArray, seen: FloatArray, speed: FloatArray, starts: IntArray, ahead: IntArray
    ) -> Iterator[FloatArray]:
        """A free run from each start."""
        for start, count in zip(starts.tolist(), ahead.tolist(), strict=True):
            rows = slice(start, start + count + 1)
            yield model.simulate(t[rows], v[rows], float(seen[start]), float(speed[start])).q

    return predict


MethodT = TypeVar("MethodT", bound=Callable[..., Any])


def checked(method: MethodT) -> MethodT:
    """Have a method of a model refuse signals that do not fit the model or each other.

    Parameters are recognised by name: ``t``, ``v``, initial values ``q0``, ``qdot0``, ``starts`` of several runs.

    Raises
    ------
    InputError
        A time base that is not one column of at least two finite, rising, evenly spaced samples; voltages of another
        length or number than the time base and the model have; an initial value that is no number; anything that is
        not finite. The text names it and what was expected.

    Notes
    -----
    Cost: 65 µs for 3,750 samples.
    """
    form = signature(method)

    @wraps(method)
    def call(model: DynamicModel, *args: Any, **options: Any) -> Any:
        """The method with its arguments checked and as arrays."""
        given = form.bind(model, *args, **options)
        values = given.arguments
        values["t"] = time = _time(values["t"])
        values["v"] = _voltages(values["v"], model, len(time))
        for name in (name for name in ("q0", "qdot0") if name in values):
            state = _floats(values[name], name)
            if state.shape != ():
                raise InputError(f"{name} has the shape {state.shape}; give one number to start from")
            values[name] = float(state)
        if "starts" in values:
            values["starts"] = starts = _floats(values["starts"], "starts")
            if starts.ndim != 2 or starts.shape[1] != 2:
                raise InputError(f"starts has the shape {starts.shape}; give a row of q and q̇ for each run, (n, 2)")
        return method(*given.args, **given.kwargs)

    return cast(MethodT, call)


def kind_of(values: Any) -> str:
    """NumPy's letter for the kind of values, as m of durations and M of time stamps; " " where they have none."""
    return str(getattr(getattr(values, "dtype", None), "kind", " "))


def real_numbers(values: Any, name: str) -> FloatArray:
    """Anything that consists of real numbers as an array; NaN where it is masked.

    Raises
    ------
    InputError
        Text, complex numbers, time stamps, rows of unlike length.
    """
    try:
        if np.iscomplexobj(values) or kind_of(values) in "mM":
            raise TypeError
        numbers: FloatArray = np.ma.filled(np.ma.asarray(values, dtype=np.float64), np.nan)
    except (TypeError, ValueError):
        raise InputError(f"{name} does not consist of numbers") from None
    return numbers


def _time(t: FloatArray) -> FloatArray:
    time = _floats(t, "t")
    if time.ndim != 1 or len(time) < 2:
        raise InputError(f"t has the shape {time.shape}; give one column of at least 2 time stamps [s], shape (N,)")
    if not is_uniform(time):
        raise InputError("t is not uniform and rising; resample the signals to one sample interval [s] first")
    return time


def _voltages(v: FloatArray, model: DynamicModel, count: int) -> FloatArray:
    voltages = _floats(v, "v")
    inputs = model.input_count
    if voltages.ndim == 3 and not model.fine_voltages:
        raise InputError(f"v has the shape {voltages.shape}; this model takes voltages at the samples only, (N, K)")
    if voltages.ndim not in (2, 3) or voltages.shape[-1] != inputs or 0 in voltages.shape:
        raise InputError(
            f"v has the shape {voltages.shape}; this model has {inputs} input(s): give ({count}, {inputs}), "
            "a row for each time stamp and a column for each input"
        )
    if len(voltages) != count:
        raise InputError(f"v has {len(voltages)} rows, but t has {count} time stamps; give one row for each")
    return voltages


def _floats(values: Any, name: str) -> FloatArray:
    array = np.asarray(real_numbers(values, name), order="C")
    if not np.all(np.isfinite(array)):
        raise InputError(f"{name} holds samples that are not finite; mask or interpolate them first")
    return array
