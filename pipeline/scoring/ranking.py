"""Which models a record tells apart: errors against the lowest one, resampled at the same places."""

from collections.abc import Mapping

import numpy as np

from pipeline.numerics.arrays import FloatArray
from pipeline.scoring.intervals import Interval, rms_difference_interval


def excess_over_lowest(errors: Mapping[str, FloatArray], block: int, seed: int) -> dict[str, Interval | None]:
    """Paired bootstrap intervals of each model's RMS error less that of the model with the lowest.

    An interval that reaches zero says that the record does not tell the model from the lowest. The lowest is chosen on
    the same record, so a lead that just excludes zero deserves the doubt of any choice among several.

    Parameters
    ----------
    errors : mapping of model to FloatArray, shape (N,)
        Calculated minus measured; NaN where masked, the same rows for all.
    block : int
        Block length in samples.
    seed : int
        Of the bootstrap.

    Returns
    -------
    mapping of model to Interval or None
        Of all models but the lowest; None for a record of less than three blocks. Empty for fewer than two models.
        Cost: one bootstrap of two series per model.
    """
    if len(errors) < 2:
        return {}
    squares = {model: float(np.nanmean(np.square(error))) for model, error in errors.items()}
    lowest = min(squares, key=squares.__getitem__)
    return {
        model: rms_difference_interval(error, errors[lowest], block, np.random.default_rng(seed))
        for model, error in errors.items()
        if model != lowest
    }
