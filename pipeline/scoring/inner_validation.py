"""Hyperparameters from training data alone: free runs over held-out blocks, simplest within one standard error."""

import itertools
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TypeVar

import numpy as np

from pipeline.numerics.arrays import FloatArray
from pipeline.numerics.metrics import rmse
from pipeline.signals.trajectory import Trajectory

FOLDS = 4
NEGLIGIBLE = 1e-5  # of the range of q; smaller errors are no reason to prefer a choice, a laser resolves about as much

Choice = TypeVar("Choice")


@dataclass(frozen=True)
class HeldOutBlock:
    """Rows `start:stop` of the trajectory number `source`, in fold `fold`."""

    source: int
    start: int
    stop: int
    fold: int


def held_out_blocks(trajectories: Sequence[Trajectory], folds: int = FOLDS) -> list[HeldOutBlock]:
    """Blocks of about 1/folds of all samples, dealt to the folds in turn; no block crosses a gap.

    A trajectory shorter than that is one block. With a single trajectory every fold holds one block.
    """
    total = sum(len(x.t) for x in trajectories)
    spans = []
    for source, x in enumerate(trajectories):
        edges = np.linspace(0, len(x.t), max(1, round(folds * len(x.t) / total)) + 1).astype(int)
        spans += [(source, int(a), int(b)) for a, b in itertools.pairwise(edges)]
    return [HeldOutBlock(*span, fold=i % folds) for i, span in enumerate(spans)]


def free_run_error(measured: FloatArray, calculated: FloatArray, span: float) -> float:
    """RMS error of q over `span`, at most 1: a run that diverged or missed everything counts as 1."""
    error = rmse(measured, calculated)
    return 1.0 if error is None else min(1.0, error / span)


def simplest_within_one_standard_error(errors: Mapping[Choice, FloatArray], terms: Mapping[Choice, int]) -> Choice:
    """Of the choices whose mean error is within one standard error of the lowest, the one with the fewest terms.

    Breiman et al., Classification and Regression Trees (1984), section 3.4.3. Equal numbers of terms are decided by the
    mean error.

    Parameters
    ----------
    errors : mapping of choice to FloatArray, shape (folds,)
        Error in each fold.
    terms : mapping of choice to int
        Complexity.
    """
    means = {choice: float(values.mean()) for choice, values in errors.items()}
    best = min(means, key=means.__getitem__)
    spread = errors[best]
    limit = means[best] + (float(spread.std(ddof=1)) / np.sqrt(spread.size) if spread.size > 1 else 0.0)
    return min((c for c in errors if means[c] <= max(limit, NEGLIGIBLE)), key=lambda c: (terms[c], means[c]))
