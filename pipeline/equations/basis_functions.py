"""What a radial basis function is, and all that `pipeline.model_list` names."""

import importlib
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from pipeline.model_list import BASIS_FUNCTIONS


@dataclass(frozen=True)
class BasisFunction:
    """A bell about a centre ξ.

    Attributes
    ----------
    law : callable
        ((q − ξ)/σ)² → φ in CasADi; 1 at the centre.
    reach : float
        |q − ξ|/σ from which φ may be left out of a sum; infinite where it has no end.
    """

    law: Callable[[Any], Any]
    reach: float


def basis_functions() -> dict[str, BasisFunction]:
    """The basis functions by name."""
    places = {name: place.split(":") for name, place in BASIS_FUNCTIONS}
    return {name: getattr(importlib.import_module(module), law) for name, (module, law) in places.items()}
