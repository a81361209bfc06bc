"""Finished pieces of a long computation, so that one that is killed goes on from there; where, the caller says."""

from collections.abc import Callable
from typing import Any

Parts = dict[str, Any]
"""Numbers, texts, arrays of floats, and lists of these."""

Keep = Callable[[str, Callable[[], Parts]], Parts]
"""Gives what a piece of work makes, by the name that it alone has: as it was kept, or made now and kept."""


def make_anew(name: str, make: Callable[[], Parts]) -> Parts:
    """Keeps nothing."""
    return make()


def kept_under(keep: Keep, title: str) -> Keep:
    """The same with a title before each name."""
    return lambda name, make: keep(f"{title}: {name}", make)
