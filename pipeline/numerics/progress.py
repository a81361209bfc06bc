"""How long work tells how far it has come."""

from collections.abc import Callable

OnProgress = Callable[[str, float], None]
"""Told what is going on and which share of it, 0 to 1, is done."""


def silent(what: str, share: float) -> None:
    """Tell nobody."""
