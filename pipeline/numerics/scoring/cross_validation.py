"""k-fold cross-validation over blocks of time or over logs, scored by free runs."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from pipeline.errors import DebistError
from pipeline.numerics.arrays import FloatArray
from pipeline.numerics.identification.trajectory import Trajectory
from pipeline.numerics.rivals.inner_validation import held_out_blocks
from pipeline.numerics.scoring.data_study import Identify, held_out_error


@dataclass(frozen=True)
class CrossValidation:
    """Held-out errors of one method.

    Attributes
    ----------
    errors : FloatArray, shape (folds,)
        Free-run NRMSE of q on each fold, 1 for a run that diverged or missed everything, NaN where the data without
        the fold were refused.
    """

    errors: FloatArray

    @property
    def mean(self) -> float | None:
        """Mean over the folds fitted; None if there is none."""
        fitted = self.errors[np.isfinite(self.errors)]
        return float(fitted.mean()) if fitted.size else None

    @property
    def standard_error(self) -> float | None:
        """Of the mean; None with fewer than two folds. Folds share training data, so it is a little too small."""
        fitted = self.errors[np.isfinite(self.errors)]
        return float(fitted.std(ddof=1) / np.sqrt(fitted.size)) if fitted.size > 1 else None


def cross_validate_blocks(trajectories: Sequence[Trajectory], identify: Identify, folds: int) -> CrossValidation:
    """Fit on all blocks of time but those of one fold, run freely over these, for each fold.

    Parameters
    ----------
    trajectories : sequence of Trajectory
        All data; cut into about `folds` blocks, never across a gap.
    identify : callable
        The method.
    folds : int
        At least 2.
    """
    blocks = held_out_blocks(trajectories, folds)
    errors = []
    for fold in sorted({b.fold for b in blocks}):
        kept: list[Trajectory] = []
        left_out: list[Trajectory] = []
        for b in blocks:
            x = trajectories[b.source]
            (left_out if b.fold == fold else kept).append(_rows(x, b.start, b.stop))
        errors.append(_error(kept, left_out, identify))
    return CrossValidation(np.array(errors))


def cross_validate_logs(logs: Sequence[Sequence[Trajectory]], identify: Identify) -> CrossValidation:
    """Fit on all logs but one, run freely over that one, for each log; each log is a sequence of stretches."""
    errors = []
    for k, left_out in enumerate(logs):
        kept = [x for i, log in enumerate(logs) if i != k for x in log]
        errors.append(_error(kept, left_out, identify))
    return CrossValidation(np.array(errors))


def _error(kept: Sequence[Trajectory], left_out: Sequence[Trajectory], identify: Identify) -> float:
    try:
        model = identify(kept)
    except DebistError:
        return float("nan")
    return held_out_error(model, left_out)


def _rows(x: Trajectory, start: int, stop: int) -> Trajectory:
    rows = slice(start, stop)
    return Trajectory(x.t[rows], x.q[rows], x.qdot[rows], x.qddot[rows], x.v[rows])
