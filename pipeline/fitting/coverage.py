"""Coverage of the training data: visits per basis centre, and the share of another log outside them."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ..numerics.arrays import FloatArray, IntArray

FEW = 20
"""Visits below which a centre's weights rest on the prior or on chance."""

CELLS = 24
"""Cells of the state plane an axis, over the training range; a cell next to a visited one counts as visited."""

ACTING = 0.1
"""Share of its largest value above which an input acts."""


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

    @property
    def poorly_visited(self) -> IntArray:
        """Numbers of the centres with fewer than `FEW` visits."""
        return np.flatnonzero(self.visits < FEW)


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
    inputs = v[0].shape[1]
    edges = 0.5 * (centres[1:] + centres[:-1])
    visits = np.zeros(m, dtype=np.int64)
    driven = np.zeros((inputs, m), dtype=np.int64)
    peaks = np.max([np.abs(x).max(axis=0) for x in v], axis=0)
    for position, volts in zip(q, v, strict=True):
        nearest = np.searchsorted(edges, position)
        visits += np.bincount(nearest, minlength=m)
        for k in range(inputs):
            acting = np.abs(volts[:, k]) > ACTING * peaks[k]
            driven[k] += np.bincount(nearest[acting], minlength=m)
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
    seen = np.zeros((CELLS + 4, CELLS + 4), dtype=bool)
    for i in range(3):
        for j in range(3):
            seen[1 + i : 1 + i + CELLS, 1 + j : 1 + j + CELLS] |= counts > 0
    at = []
    for edge, x in zip(edges, (q, qdot), strict=True):
        cell = np.floor((x - edge[0]) / (edge[1] - edge[0]))
        at.append(np.clip(cell, -2, CELLS + 1).astype(np.int64) + 2)
    return float(np.mean(~seen[at[0], at[1]]))
