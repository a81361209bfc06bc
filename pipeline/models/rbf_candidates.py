"""What the data-driven joint may consist of: the structures among which its inner validation chooses."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Any, Literal

from pipeline.identification.joint_parameters import JointStructure

FrictionLaw = Literal["viscous", "lag", "lags", "maxwell-slip", "lag+slip", "lags+slip"]

FRICTION: dict[FrictionLaw, dict[str, Any]] = {
    "viscous": {"rates": (), "shape_elements": 0, "slips": 0},
    "lag": {"rates": (1.5,), "shape_elements": 0, "slips": 0},
    "lags": {"rates": (10.0, 1.5, 0.18, 0.02), "shape_elements": 2, "slips": 0},
    "maxwell-slip": {"rates": (), "shape_elements": 0, "slips": 3},
    "lag+slip": {"rates": (1.5,), "shape_elements": 0, "slips": 1},
    "lags+slip": {"rates": (10.0, 1.5, 0.18, 0.02), "shape_elements": 2, "slips": 1},
}
"""Hidden elements of each law beside the viscous damping d(q) q̇, rates in units of the joint's frequency scale."""

OFFERED: tuple[FrictionLaw, ...] = ("lag", "lags", "maxwell-slip", "lag+slip", "lags+slip")
OFFERED_TO_ONE_INPUT: tuple[FrictionLaw, ...] = ("lag", "maxwell-slip", "lag+slip")
"""Laws that compete where none is decided; a single actuator has no hidden shape that its input would feel."""

SYMMETRY = 0.1
"""Relative standard deviation of left/right differences where mirror symmetry is believed."""


@dataclass(frozen=True)
class Candidate:
    """A structure with its prior: caution on the noise level, left/right symmetry (None for none)."""

    label: str
    structure: JointStructure
    caution: float = 3.0
    symmetry: float | None = None


@dataclass(frozen=True)
class RbfChoice:
    """What the user decides of the data-driven joint; None leaves it to the inner validation.

    Attributes
    ----------
    friction : str, optional
        One of `FRICTION`.
    basis_functions : int, optional
        Gaussians M per curve.
    smoothing : float, optional
        σ_n.
    """

    friction: FrictionLaw | None = None
    basis_functions: int | None = None
    smoothing: float | None = None


def candidate(structure: JointStructure, symmetry: float | None = None) -> Candidate:
    """A candidate that is called by what it consists of."""
    elements = {name: getattr(structure, name) for name in ("rates", "shape_elements", "slips")}
    friction = next((name for name, parts in FRICTION.items() if parts == elements), "own friction")
    words = [friction, f"M = {structure.basis_functions}", f"sigma_n = {structure.smoothing:g}"]
    words += ["turning arm"] * structure.turning_arm + ["lagged input"] * structure.input_lag
    return Candidate(", ".join(words + ["mirror-symmetric"] * (symmetry is not None)), structure, symmetry=symmetry)


def first_candidate(inputs: int, choice: RbfChoice, *, angle: bool) -> Candidate:
    """Where the search starts: what is decided, and the usual for the rest.

    Two inputs are taken for the two sides of a bistable joint, whose tip moves on an arc unless q is an angle; one
    input for an actuated arm or slider, whose weight turns with it where q is an angle.
    """
    elements = FRICTION[choice.friction or ("lag" if inputs > 1 else "maxwell-slip")]
    structure = JointStructure(
        basis_functions=choice.basis_functions or (12 if inputs > 1 else 8),
        smoothing=choice.smoothing or 1.0,
        arc=inputs > 1 and not angle,
        turning_arm=inputs == 1 and angle,
        **elements,
    )
    return candidate(structure)


Question = Callable[[Candidate], Sequence[Candidate]]
"""From the best candidate so far to those that could be better."""


def questions(inputs: int, choice: RbfChoice) -> list[Question]:
    """What the inner validation asks, in turn, each with the answers so far: lag, friction, symmetry, M, σ_n."""

    def changed(name: str, values: Sequence[Any]) -> Question:
        return lambda best: [
            candidate(replace(best.structure, **{name: value}), best.symmetry)
            for value in values
            if value != getattr(best.structure, name)
        ]

    def frictions(best: Candidate) -> list[Candidate]:
        laws = [FRICTION[law] for law in (OFFERED if inputs > 1 else OFFERED_TO_ONE_INPUT)]
        others = [candidate(replace(best.structure, **parts), best.symmetry) for parts in laws]
        return [other for other in others if other.structure != best.structure]

    asked: list[Question] = []
    if inputs == 1:
        asked.append(changed("input_lag", [True]))
    if choice.friction is None:
        asked.append(frictions)
    if inputs > 1:
        asked.append(lambda best: [candidate(best.structure, SYMMETRY)])
    if choice.basis_functions is None:
        asked.append(changed("basis_functions", [8, 16] if inputs > 1 else [5, 12]))
    if choice.smoothing is None:
        asked.append(changed("smoothing", [0.8, 1.3]))
    return asked
