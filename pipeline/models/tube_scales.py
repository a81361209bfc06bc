"""Scale of a model's tubes (`pipeline.scoring.tubes`): measured on the training logs, kept in the model's file."""

from collections.abc import Sequence
from dataclasses import replace
from typing import Annotated

import numpy as np
from pydantic import Field

from ..scoring.tubes import TubeScale, tube_scale
from ..signals.log import MOST_SAMPLES, Log, operating_range, within
from .base import DrawnModel
from .model_file import FilePart, Unit

_NotNegative = Annotated[float, Field(ge=0.0, le=1e6)]


class TubePart(FilePart):
    """`TubeScale` in a file; without one the model has no tubes."""

    factor: _NotNegative = 0.0
    """Half width of the tubes over the spread of the draws."""
    floor: Annotated[_NotNegative, Unit("{q}")] = 0.0
    """Least spread: the error on the training data."""
    apart: Annotated[_NotNegative, Unit("{q}")] = 0.0
    """Distance from which on a draw is in another well."""

    def scale(self) -> TubeScale:
        """The scale."""
        return TubeScale(**dict(self))


def scale_on(records: Sequence[Log], model: DrawnModel, floor: float, margin: float, least: float = 0.0) -> TubeScale:
    """Scale of the tubes, from the errors on the training logs. Cost: 33 runs of each log.

    Parameters
    ----------
    records : sequence of Log
        The training logs.
    model : DrawnModel
        What was fitted to them.
    floor : float
        RMS error of q [m or rad] on the training data.
    margin : float
        Errors on another log over those on the training data.
    least : float
        Smallest κ.
    """
    parts = []
    for record in within(records, MOST_SAMPLES):
        v = record.drive if model.fine_voltages else record.v
        given = record.t, v, float(record.q[0]), float(record.qdot[0])
        ensemble, _ = model.simulate_draws(*given)
        parts.append((model.simulate(*given).q, ensemble, np.where(record.valid, record.q, np.nan)))
    free, drawn_q, q = (np.concatenate(each, axis=-1) for each in zip(*parts, strict=True))
    low, high = operating_range(records)
    scale = tube_scale(free, drawn_q, q, floor, margin, high - low)
    return replace(scale, factor=max(scale.factor, least))
