"""Information that a motion carries about the weights of eq. 40: the regressor's matrix and its criteria.

Signals are divided by fixed full scales: half the operating range, a reference velocity, the squared largest input. So
matrices of different motions of one device can be added and compared. The ratio of two determinants does not depend on
the scales (Atkinson, Donev & Tobias, Optimum Experimental Designs, 2007, ch. 11).
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view

from ..numerics.arrays import FloatArray, IntArray
from ..numerics.linear_filters import first_order_lag
from ..numerics.metrics import rms
from ..settings.models import CENTRES, LAG_START, SMOOTHING
from .regression import (
    InputAction,
    basis_centres,
    basis_values,
    basis_width,
    curve_signals,
    input_signal,
    regressor,
)

FLOOR = 1e-2
"""Information that stands for none, in samples at full scale: keeps the determinant of an unvisited centre finite."""
FEW = 20
"""Visits below which a centre's weights rest on the prior or on chance."""
CELLS = 24
"""Cells of the state plane an axis, over the training range; a cell next to a visited one counts as visited."""
ACTING = 0.1
"""Share of its largest value above which an input acts."""


@dataclass(frozen=True)
class ScaledRegressor:
    """The regressor of eq. 40 over an operating range, its signals divided by their full scales.

    Attributes
    ----------
    centres : FloatArray, shape (M,)
        Basis centres [m] over the operating range.
    width : float
        Standard deviation of the bells [m].
    scales : FloatArray, shape (2 + K,)
        Full scale of q [m], of the lagged velocity [m/s], and of each input signal.
    inputs : {"squared", "linear"}
        Action of the inputs.
    """

    centres: FloatArray
    width: float
    scales: FloatArray
    inputs: InputAction = "squared"

    @classmethod
    def over(
        cls,
        q: FloatArray,
        qdot: FloatArray,
        largest: FloatArray,
        *,
        basis_functions: int = CENTRES,
        smoothing: float = SMOOTHING,
        inputs: InputAction = "squared",
    ) -> "ScaledRegressor":
        """The regressor over the range of a motion q, q̇, shape (N,), with the `largest` input on each side, shape (K,).

        Parameters
        ----------
        q, qdot : FloatArray, shape (N,)
            A motion over the operating range [m, m/s].
        largest : FloatArray, shape (K,)
            Largest magnitude of each input.
        basis_functions, smoothing : int, float
            M and σ_n.
        inputs : {"squared", "linear"}
            Action of the inputs.

        Raises
        ------
        InputError
            The displacement never changes.
        """
        low = float(q.min())
        high = float(q.max())
        centres = basis_centres(low, high, basis_functions)
        acting = np.where(largest > 0.0, input_signal(largest, inputs), 1.0)
        scales = np.array([0.5 * (high - low), rms(qdot) or 1.0, *acting])
        return cls(centres, basis_width(centres, smoothing), scales, inputs)

    def information(self, q: FloatArray, qdot: FloatArray, v: FloatArray, interval: float) -> FloatArray:
        """XᵀX of the scaled regressor, shape (p, p).

        Parameters
        ----------
        q, qdot : FloatArray, shape (N,)
            A motion [m, m/s].
        v : FloatArray, shape (N, K)
            Inputs.
        interval : float
            Sample interval [s].

        Returns
        -------
        FloatArray, shape (p, p)
            Cost: N p² multiplications and N M exponentials; 2 ms for N = 3750, p = 40.
        """
        z, _ = first_order_lag(np.ascontiguousarray(qdot), interval, LAG_START)
        signals = curve_signals(q, z, input_signal(v, self.inputs))
        rows = regressor(basis_values(q, self.centres, self.width), signals / self.scales)
        return np.asarray(rows.T @ rows)


def log_information(information: FloatArray) -> float:
    """D-criterion: log det(XᵀX + floor) per weight, in nats, of motions with the same `ScaledRegressor`."""
    _, value = np.linalg.slogdet(information + FLOOR * np.eye(len(information)))
    return float(value) / len(information)


@dataclass(frozen=True)
class Conditioning:
    """Conditioning of the weights, on unit-norm columns.

    Attributes
    ----------
    log_det : float
        log det XᵀX on unit-norm columns per weight [nats]: 0 for orthogonal columns, −∞ where one depends on others.
    condition : float
        Ratio of the largest to the smallest singular value of X on unit-norm columns.
    silent : int
        Columns that are zero: weights that the motion does not show.
    """

    log_det: float
    condition: float
    silent: int


def conditioning(information: FloatArray) -> Conditioning:
    """Conditioning of the regressor whose XᵀX is `information`, shape (p, p); zero columns are counted, not judged."""
    diagonal = np.diag(information)
    heard = diagonal > 0.0
    norms = np.sqrt(diagonal[heard])
    correlations = information[np.ix_(heard, heard)] / np.outer(norms, norms)
    values = np.maximum(np.linalg.eigvalsh(correlations), len(norms) * np.finfo(float).eps)
    return Conditioning(
        log_det=float(np.mean(np.log(values))),
        condition=float(np.sqrt(values[-1] / values[0])),
        silent=int(np.count_nonzero(~heard)),
    )


@dataclass(frozen=True)
class Coverage:
    """Range and density of the training data.

    Attributes
    ----------
    visits : IntArray, shape (M,)
        Samples nearest to each centre.
    driven : IntArray, shape (K, M)
        Those of them in which input k acted.
    """

    visits: IntArray
    driven: IntArray

    @property
    def table(self) -> IntArray:
        """Visits of each centre, all of them and those under each input, shape (M, 1 + K)."""
        return np.column_stack([self.visits, self.driven.T])


def coverage(centres: FloatArray, q: Sequence[FloatArray], v: Sequence[FloatArray]) -> Coverage:
    """Count the visits of training logs.

    Parameters
    ----------
    centres : FloatArray, shape (M,)
        Basis centres, ascending, in the unit of q.
    q : sequence of FloatArray, shape (N,)
        Valid samples of each log.
    v : sequence of FloatArray, shape (N, K)
        Inputs at these samples; an input acts above a tenth of its largest value, 1 % of a squared force.
    """
    m = len(centres)
    edges = 0.5 * (centres[1:] + centres[:-1])
    visits = np.zeros(m, dtype=np.int64)
    driven = np.zeros((v[0].shape[1], m), dtype=np.int64)
    peaks = np.max([np.abs(x).max(axis=0) for x in v], axis=0)
    for position, volts in zip(q, v, strict=True):
        nearest = np.searchsorted(edges, position)
        visits += np.bincount(nearest, minlength=m)
        for k in range(len(driven)):
            driven[k] += np.bincount(nearest[np.abs(volts[:, k]) > ACTING * peaks[k]], minlength=m)
    return Coverage(visits, driven)


def share_outside(q: FloatArray, qdot: FloatArray, trained_q: FloatArray, trained_qdot: FloatArray) -> float:
    """Share of samples (q, q̇) in cells of the state plane that no training sample entered.

    Parameters
    ----------
    q, qdot : FloatArray, shape (N,)
        The log to judge.
    trained_q, trained_qdot : FloatArray, shape (T,)
        All training samples.
    """
    edges = [np.linspace(x.min(), x.max(), CELLS + 1) for x in (trained_q, trained_qdot)]
    counts, _, _ = np.histogram2d(trained_q, trained_qdot, edges)
    seen = np.any(sliding_window_view(np.pad(counts > 0, 3), (3, 3)), axis=(2, 3))  # with a margin of two cells
    places = [np.floor((x - edge[0]) / (edge[1] - edge[0])) for edge, x in zip(edges, (q, qdot), strict=True)]
    row, column = 2 + np.clip(places, -2, CELLS + 1).astype(np.int64)
    return float(np.mean(~seen[row, column]))
