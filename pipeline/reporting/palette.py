"""Colours after Okabe and Ito (2008), which people with any colour vision tell apart; dashes repeat what they say.

A seventh and an eighth model get a violet and a brown, told from the others by their dashes too.
"""

from collections.abc import Sequence

# Class on the page, colour on paper, dash pattern (on, off in points). Order: models as they come.
MODEL_COLOURS = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#7A4FA3", "#8C6D31")
MODEL_DASHES: tuple[tuple[float, ...], ...] = (
    (),
    (6, 2),
    (2, 2),
    (7, 2, 2, 2),
    (4, 1),
    (1, 1.5),
    (9, 2, 2, 2, 2, 2),
    (3, 4),
)
# Black but for a trace: matplotlib writes no colour for a black inside, which the page then could not replace.
FIXED = {"measured": "#010101", "raw": "#8C8C8C", "v1": "#0072B2", "v2": "#D55E00", "reference": "#8C8C8C"}


def slot(role: str, models: Sequence[str]) -> str:
    """Name of the colour class of a role: ``measured``, ``raw``, ``v1`` … or ``m0`` to ``m7`` for models."""
    if role in FIXED:
        return role
    return f"m{models.index(role) % len(MODEL_COLOURS)}" if role in models else "reference"


def slot_colour(name: str) -> str:
    """Colour of a slot on paper."""
    return FIXED[name] if name in FIXED else MODEL_COLOURS[int(name[1:])]


def slot_dashes(name: str) -> tuple[float, ...]:
    """Dash pattern of a slot; empty for a solid line."""
    if name in FIXED:
        return (5, 2) if name == "v2" else ()
    return MODEL_DASHES[int(name[1:])]


def dashes(role: str, models: Sequence[str]) -> tuple[float, ...]:
    """Dash pattern of a role."""
    return slot_dashes(slot(role, models))
