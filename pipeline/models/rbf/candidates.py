"""Candidates for the structure of a data-driven joint.

The structure of a bistable joint, and those among which inner validation chooses for any other device.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Any

from ...settings.prototype import Structure
from .structure import ForceShape, JointStructure

FRICTION: dict[str, dict[str, Any]] = {
    "viscous": {"rates": (), "shape_elements": 0, "slips": 0},
    "coulomb": {"rates": (), "shape_elements": 0, "slips": 1},
    "lag": {"rates": (1.5,), "shape_elements": 0, "slips": 0},
    "lags": {"rates": (0.15, 1.5, 0.05), "shape_elements": 2, "slips": 0},
    "maxwell-slip": {"rates": (), "shape_elements": 0, "slips": 3},
    "lag+slip": {"rates": (1.5,), "shape_elements": 0, "slips": 1},
    "lags+slip": {"rates": (0.15, 1.5, 0.05), "shape_elements": 2, "slips": 1},
}
"""Hidden elements of each friction model beside the damping d(q) q̇, rates in units of the joint's frequency scale."""

OFFERED = ("viscous", "coulomb", "lag", "maxwell-slip", "lag+slip")
"""Friction models that compete where none is decided; a single actuator has no hidden shape that its input acts on."""

SYMMETRIES = (0.03, 0.1, None)
"""Relative standard deviations of left/right differences about q = 0, from sides that are alike to any sides."""


POPULATION_INFLATION = 8.0
"""Inflation of the noise level beside the prior that simulated joints teach: it knows more than that of curves."""


@dataclass(frozen=True)
class Candidate:
    """A structure with its prior: inflation of the noise level, left/right symmetry (None for none), and whether it is
    the prior that simulated joints teach (`prior.Population`) instead of that of smooth curves.
    """

    label: str
    structure: JointStructure
    noise_inflation: float = 3.0
    symmetry: float | None = None
    population: bool = False


FORCES: tuple[ForceShape, ...] = ("curve", "polynomial", "offset")

DRIVE: dict[str, dict[str, Any]] = {
    "direct": {"input_lag": False, "input_delay": False, "effect_lags": False},
    "lag": {"input_lag": True, "input_delay": False, "effect_lags": False},
    "delay": {"input_lag": False, "input_delay": True, "effect_lags": False},
    "lag+delay": {"input_lag": True, "input_delay": True, "effect_lags": False},
    "effect-lag": {"input_lag": True, "input_delay": False, "effect_lags": True},
}
"""Paths of an input to the joint."""

EFFECT: dict[str, dict[str, Any]] = {
    "plain": {"bent_input": False, "dead_zone": False},
    "bent": {"bent_input": True, "dead_zone": False},
    "dead-zone": {"bent_input": False, "dead_zone": True},
}
"""Effects of an input on the joint."""


_ELEMENTS: dict[str, dict[str, dict[str, Any]]] = {
    "friction": FRICTION,
    "damping": {"curve": {"constant_damping": False}, "constant": {"constant_damping": True}},
    "drag": {"none": {"drag": False}, "quadratic": {"drag": True}},
    "stops": {"none": {"stops": False}, "both": {"stops": True}},
    "gain": {"curve": {"constant_gain": False}, "constant": {"constant_gain": True}},
    "drive": DRIVE,
    "effect": EFFECT,
}
"""Fields of the structure by the words of the settings; others have the same names and values in both."""


def decided_fields(settings: Structure, inputs_before: str = "auto") -> dict[str, Any]:
    """Fields of the structure that the user decided, and how inputs were before a log."""
    fields: dict[str, Any] = {} if inputs_before == "auto" else {"rest_at_zero": inputs_before == "zero"}
    for name, value in settings.model_dump().items():
        if value != "auto":
            fields |= _ELEMENTS[name][value] if name in _ELEMENTS else {name: value}
    return fields


def candidate(structure: JointStructure, symmetry: float | None = None, *, population: bool = False) -> Candidate:
    """A candidate that is called by what it consists of, with the prior of curves or of the `population`."""
    elements = {name: getattr(structure, name) for name in ("rates", "shape_elements", "slips")}
    friction = next((name for name, parts in FRICTION.items() if parts == elements), "own friction")
    smooth = structure.force == "curve" or not (structure.constant_damping and structure.constant_gain)
    words = [
        friction,
        *[f"M = {structure.basis_functions}", f"sigma_n = {structure.smoothing:g}"] * smooth,
        *{"curve": [], "polynomial": ["polynomial force"], "offset": ["no restoring force"]}[structure.force],
        *["tip on an arc"] * structure.arc,
        *["constant damping"] * structure.constant_damping,
        *["constant gain"] * structure.constant_gain,
        *["drag"] * structure.drag,
        *["end stops"] * structure.stops,
        *["overdamped"] * structure.overdamped,
        *["turning arm"] * structure.turning_arm,
        *["lagged effect" if structure.effect_lags else "lagged input"] * structure.input_lag,
        *["delayed input"] * structure.input_delay,
        *["bent input"] * structure.bent_input,
        *["dead zone"] * structure.dead_zone,
        *["rest without input"] * (structure.rest_at_zero and (structure.input_lag or structure.shape_elements > 0)),
        *{"linear": [], "zero": ["held input"], "cubic": ["spline input"], "record": ["fine input"]}[structure.hold],
        *([] if symmetry is None else [f"mirror-symmetric to {100.0 * symmetry:g} %"]),
        *["population prior"] * population,
    ]
    return Candidate(
        label=", ".join(words),
        structure=structure,
        noise_inflation=POPULATION_INFLATION if population else Candidate.noise_inflation,
        symmetry=symmetry,
        population=population,
    )


def first_candidate(decided: dict[str, Any], *, pair: bool, angle: bool, fine: bool) -> Candidate:
    """First candidate of the search: the user's settings, and the usual ones for the rest.

    It has as few elements as can be. All but a bistable joint is an actuated arm or slider, whose weight turns with it
    where q is an angle.

    Parameters
    ----------
    decided : dict
        Fields that the user decided.
    pair : bool
        True if two inputs pull at the two sides of a bistable joint.
    angle : bool
        True if q is an angle.
    fine : bool
        True if the inputs are known between the samples.
    """
    usual: dict[str, Any] = {
        **FRICTION["viscous"],
        "basis_functions": 12 if pair else 8,
        "smoothing": 1.0,
        "arc": False,
        "turning_arm": not pair and angle,
        "constant_damping": not pair,
        "constant_gain": not pair,
        "hold": "record" if fine else "linear",
    }
    return candidate(JointStructure(**usual | decided))


Offer = Callable[[Candidate], Sequence[Candidate]]
"""From the best candidate so far to those that could be better."""


@dataclass(frozen=True)
class _Change:
    """Offers changes that leave alone what is decided."""

    decided: dict[str, Any]

    def to(self, *fields: dict[str, Any]) -> Offer:
        """The best candidate so far with each of these changes."""

        def offered(best: Candidate) -> list[Candidate]:
            """The best candidate so far with each change that is free and changes it."""
            free = [change for change in fields if not any(self.decided.get(k, v) != v for k, v in change.items())]
            others = [candidate(replace(best.structure, **change), best.symmetry) for change in free]
            return [other for other in others if other.structure != best.structure]

        return offered

    def each(self, name: str, values: Sequence[Any]) -> Offer:
        """One field with each of these values."""
        return self.to(*({name: value} for value in values))


def joint_offers(
    decided: dict[str, Any], *, angle: bool, mirrored: bool, knows: Callable[[JointStructure], bool]
) -> tuple[list[Offer], list[Offer]]:
    """Offers to a bistable joint in turn: friction or relaxation, hidden shapes, both, and sides that are alike.

    Elements are offered with any sides: sides that are taken for too much alike would ask for elements.

    Parameters
    ----------
    decided : dict
        Fields that are decided and not offered.
    angle : bool
        True if q is an angle: else the tip may move on an arc, as that of a beam with hidden shapes does.
    mirrored : bool
        True if q = 0 is within its range and so may be its mirror plane.
    knows : callable
        True if simulated joints teach a prior of a structure.

    Returns
    -------
    list of Offer
        Those that are made once.
    list of Offer
        Empty: none is made again.
    """
    change = _Change(decided)
    shapes = change.to(FRICTION["lags+slip"] | {"arc": not angle})

    def taught(best: Candidate) -> list[Candidate]:
        """Hidden shapes, or what is decided, as simulated joints have them."""
        structures = [each.structure for each in (best, *shapes(best)) if mirrored and knows(each.structure)]
        return [candidate(structure, population=True) for structure in structures]

    def untaught(best: Candidate) -> list[Candidate]:
        """Hidden shapes of any other joint."""
        return [candidate(best.structure, SYMMETRIES[1])] if best.population else list(shapes(best))

    def alike(best: Candidate) -> list[Candidate]:
        """Sides that are alike."""
        return [candidate(best.structure, each) for each in SYMMETRIES if mirrored and not best.population]

    return [
        change.to(FRICTION["coulomb"], FRICTION["lag"]),
        taught,
        untaught,
        change.to(FRICTION["lag+slip"]),
        change.to({"arc": not angle}),
        alike,
    ], []


def offers(
    decided: dict[str, Any], *, fine: bool, slow: bool, driven: bool, squared: bool = False
) -> tuple[list[Offer], list[Offer]]:
    """Offers of the inner validation in turn, each as changes of the best candidate so far.

    Parameters
    ----------
    decided : dict
        Fields that are decided and not offered.
    fine : bool
        True if the inputs are known between the samples.
    slow : bool
        True if the device looks overdamped.
    driven : bool
        True if an input acts at the first sample: else a lag rested without inputs either way.
    squared : bool
        True if inputs act by their squares: else it is the same whether they or what they do lag.

    Returns
    -------
    list of Offer
        Those that are made once.
    list of Offer
        Those that are made again and again after them, as long as one is taken: by then other fields have changed.
    """
    change = _Change(decided)
    usual = decided.get("rest_at_zero", False)
    resting = [
        *(DRIVE["lag"] | {"rest_at_zero": at_zero} for at_zero in ((False, True) if driven else (usual,))),
        *[DRIVE["effect-lag"] | {"rest_at_zero": usual}] * squared,
    ]
    drives = change.to(DRIVE["direct"], *resting, DRIVE["delay"])
    hold = change.each("hold", ["linear", "zero", "cubic", *(["record"] if fine else [])])
    friction = change.to(*(FRICTION[name] for name in OFFERED))
    effect = change.to(*EFFECT.values())
    drag, stops = (change.each(name, [False, True]) for name in ("drag", "stops"))
    plain = [FRICTION["viscous"], FRICTION["coulomb"], *[FRICTION["viscous"] | {"overdamped": True}] * slow]
    late = {"constant_gain": True, "overdamped": False}
    together = DRIVE["lag"] | EFFECT["plain"] | {"constant_gain": False}
    once = [
        # Each force with and without dry friction, of a mass and, where the device looks slow, without
        change.to(*(option | {"force": force} for option in plain for force in FORCES)),
        # A gain by place. A mass that nothing restores is the same everywhere: that its gain is not, is offered later.
        _restored(change.to(*(FRICTION["viscous"] | {"force": force, "constant_gain": False} for force in FORCES[:2]))),
        hold,
        # A slow drive in place of what would take its part: a gain by place, much damping, hidden forces and friction
        _restored(
            change.to(
                *(
                    FRICTION[name] | {"force": force} | late | drive
                    for name in OFFERED[:2]
                    for force in FORCES[:2]
                    for drive in (*resting, DRIVE["delay"])
                )
            )
        ),
        stops,
        friction,
        drag,
        drives,
        effect,
        # A slow drive, a slow force and a gain by place, which may each take the others' parts, so that none is missed
        change.to(*(FRICTION[name] | together for name in OFFERED[:3])),
    ]
    curves = change.to(*({"constant_damping": d, "constant_gain": g} for d in (False, True) for g in (False, True)))
    again = [
        curves,
        change.each("force", FORCES),
        hold,
        drives,
        friction,
        drag,
        change.each("stops", [False]),
        effect,
        change.each("basis_functions", [5, 12]),
        change.each("smoothing", [0.8, 1.3]),
    ]
    return once, [change.each("overdamped", [False, True]), *again] if slow else again


def _restored(offer: Offer) -> Offer:
    """The offer to a device that something restores: a free mass gets none."""
    return lambda best: [] if best.structure.force == "offset" else offer(best)
