"""Elements that resist the tip's motion: each names its constants, its memory and its equation.

The file has drag of the air on the frame, and friction whose level sets in with the speed: Coulomb's, without its step
at rest.
"""

from collections.abc import Callable
from dataclasses import dataclass
from importlib import import_module
from typing import Any

import casadi as ca

Term = Callable[[Any, Any, Any, dict[str, Any]], Any]
"""(q [m], q̇ [m/s], states of the element, its constants by name) → an expression in CasADi."""


@dataclass(frozen=True)
class Constant:
    """A positive constant that no parameter set holds.

    Attributes
    ----------
    name : str
    typical : float
        Its typical value [SI].
    prior_std : float
        Standard deviation of the prior of its logarithm.
    unit : str
        A name in :data:`pipeline.units.units.POWERS`, for devices of another size.
    """

    name: str
    typical: float
    prior_std: float
    unit: str


@dataclass(frozen=True)
class ElementState:
    """A state of an element, proportional to q after a long rest.

    Attributes
    ----------
    name, unit : str
    at_rest : float
        State over q at rest: 1 for what follows q, 0 for a strain that decays.
    rate : callable
        Its rate.
    """

    name: str
    unit: str
    at_rest: float
    rate: Term


@dataclass(frozen=True)
class TipElement:
    """An element on q.

    Attributes
    ----------
    constants : tuple of Constant
    resistance : callable
        The force [N] that resists. Without memory it only takes energy if it has the sign of q̇.
    states : tuple of ElementState
    level : str
        Name of the constant that is a dry friction's level, which is no part of the damping curve; empty otherwise.
    """

    constants: tuple[Constant, ...]
    resistance: Term
    states: tuple[ElementState, ...] = ()
    level: str = ""


TIP_ELEMENTS = (
    "equations.tip_elements:DRAG",
    "equations.tip_elements:SLIDING",
)  # fmt: skip
"""Place of each element; `python -m pipeline.equations.write` writes it into every kernel, fit and export."""


def tip_elements() -> list[TipElement]:
    """The elements."""
    places = (place.split(":") for place in TIP_ELEMENTS)
    return [getattr(import_module(f"..{module}", __package__), name) for module, name in places]


DRAG = TipElement((Constant("drag", 0.02, 1.2, "N·s²/m²"),), lambda q, p, w, k: k["drag"] * ca.fabs(p) * p)

SLIDING = TipElement(
    (Constant("sliding_force", 0.1e-3, 1.2, "N"), Constant("sliding_speed", 6e-3, 0.5, "m/s")),
    lambda q, p, w, k: k["sliding_force"] * p / ca.sqrt(p * p + k["sliding_speed"] * k["sliding_speed"]),
    level="sliding_force",
)
