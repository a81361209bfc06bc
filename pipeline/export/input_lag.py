"""Inputs behind a first-order lag for export, exact in each half step (`pipeline.numerics.linear_filters`)."""

from typing import Any

from pipeline.codegen.graph import choose, function

Values = list[Any]


def lagged_nodes(
    lagged: Values, before: Values, within: Values, after: Values, h: Any, lag: float
) -> tuple[Values, Values]:
    """Lagged inputs at the middle and the end of a step of h [s] whose inputs go on lines between its three nodes.

    The lag [s] may be far shorter than the step.
    """
    half = 0.5 * h
    middles = [_behind(half, lag, *interval) for interval in zip(lagged, before, within, strict=True)]
    return middles, [_behind(half, lag, *interval) for interval in zip(middles, within, after, strict=True)]


def _behind(h: Any, lag: float, lagged: Any, before: Any, after: Any) -> Any:
    """Lagged input after h [s] in which the input goes on a line."""
    ratio = h / lag
    positive = function("lt", 0.0, ratio)
    share = choose(positive, -function("expm1", -ratio) / choose(positive, ratio, 1.0), 1.0)
    decay = function("exp", -ratio)
    return decay * lagged + (share - decay) * before + (1.0 - share) * after
