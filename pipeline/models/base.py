"""The one interface of all models, and the result of a free run."""

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any, Literal, Protocol

from pipeline.errors import CorruptArtifactError
from pipeline.numerics.arrays import FloatArray


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
        Whether the whole record was simulated within the model's bounds.
    diverged_at_s : float or None
        Time [s] at which the state left the bounds or stopped being finite.
    """

    t: FloatArray
    q: FloatArray
    qdot: FloatArray
    qddot: FloatArray
    status: Literal["ok", "diverged"]
    diverged_at_s: float | None = None


class Model(Protocol):
    """A dynamic model of a joint with one displacement and one or two voltages."""

    @property
    def name(self) -> str:
        """The name under which predictions and scores are filed, e.g. ``rbf-paper``."""

    @property
    def input_count(self) -> int:
        """Number of voltages that it takes."""

    @property
    def fine_voltages(self) -> bool:
        """Whether it takes voltages between the samples, of shape (N, r, n_inputs), where they are known."""

    def simulate(self, t: FloatArray, v: FloatArray, q0: float, qdot0: float) -> FreeRun:
        """Simulate freely from ``(q0, qdot0)``, with hidden states as after a long rest at the first sample.

        Parameters
        ----------
        t : FloatArray, shape (N,)
            Uniform time base [s].
        v : FloatArray, shape (N, n_inputs)
            Measured voltages [V], linear between samples. With `fine_voltages` also of shape (N, r, n_inputs): at r
            evenly spaced times of each sample interval, the first of which is the sample itself.
        q0, qdot0 : float
            Initial displacement [m] and velocity [m/s].

        Raises
        ------
        InputError
            Signals of other lengths, shapes or numbers of inputs, samples that are not finite, a time base that is
            not uniform; every model is `pipeline.models.checked`.
        """

    def accelerate(self, t: FloatArray, v: FloatArray, q: FloatArray, qdot: FloatArray) -> FloatArray:
        """Acceleration [m/s²] along a measured trajectory, shape (N,): the one-step prediction."""

    def describe(self) -> dict[str, Any]:
        """What a person wants to know: structure, hyperparameters, diagnostics, with units in the keys."""


def predict(model: Model, t: FloatArray, v: FloatArray, q: FloatArray, qdot: FloatArray) -> FloatArray:
    """Displacement [m] from a measured state on, the voltages after it being known.

    A model with hidden states takes them from the measurement before, if it has a method ``predict`` with the same
    arguments; the others begin as in a free run.

    Parameters
    ----------
    model : Model
        What predicts.
    t, v : FloatArray, shapes (N,) and (N, n_inputs)
        As for `Model.simulate`.
    q, qdot : FloatArray, shape (M,)
        Measured displacement [m] and velocity [m/s] of the first M rows, without gaps.

    Returns
    -------
    FloatArray, shape (N − M + 1,)
        From row M − 1 on; NaN after a divergence.
    """
    own = getattr(model, "predict", None)
    if own is not None:
        found: FloatArray = own(t, v, q, qdot)
        return found
    start = len(q) - 1
    return model.simulate(t[start:], v[start:], float(q[-1]), float(qdot[-1])).q


@contextmanager
def stored(name: str, command: str) -> Iterator[None]:
    """Read the tree of the model `name`; what it lacks is said, with the `command` that writes it anew.

    Raises
    ------
    CorruptArtifactError
        An entry is missing.
    """
    try:
        yield
    except KeyError as missing:
        raise CorruptArtifactError(f"the model {name} lacks {missing}; run `debist {command}` again") from None
