"""Elements that resist the tip's motion by a force of q and q̇: each a file that names its constants and its law."""

import importlib
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True)
class TipElement:
    """An element on q.

    Attributes
    ----------
    constants : tuple of (str, float, float)
        Name of each constant, its typical value [SI], and the prior standard deviation of its logarithm: a constant is
        positive, and the parameter set says nothing of it.
    resistance : callable
        (q [m], q̇ [m/s], constants by name) → the force [N] that resists, in CasADi. With the sign of q̇ it only takes
        energy.
    """

    constants: tuple[tuple[str, float, float], ...]
    resistance: Callable[[Any, Any, dict[str, Any]], Any]


TIP_ELEMENTS = (
    "pipeline.equations.drag:DRAG",
)  # fmt: skip
"""Where each element is; `python -m pipeline.equations.write` gives it to every kernel, fit and export."""


def tip_elements() -> list[TipElement]:
    """The elements."""
    places = [place.split(":") for place in TIP_ELEMENTS]
    return [getattr(importlib.import_module(module), name) for module, name in places]
