"""Progress of long work: the callback that reports it, and the finished pieces that a restarted run goes on from.

The caller decides where finished pieces are stored.
"""

from collections.abc import Callable
from typing import Any

OnProgress = Callable[[str, float], None]
"""Told what is going on and which share of it, 0 to 1, is done."""


def silent(what: str, share: float) -> None:
    """Tell nobody."""


StoredResult = dict[str, Any]
"""Numbers, texts, arrays of floats, and lists of these."""

Keep = Callable[[str, Callable[[], StoredResult]], StoredResult]
"""Returns the result of a piece of work by its unique name: from the store, or computed and stored."""


def make_anew(name: str, make: Callable[[], StoredResult]) -> StoredResult:
    """Keeps nothing."""
    return make()


def kept_under(keep: Keep, title: str) -> Keep:
    """A keeper with a title before each name."""
    return lambda name, make: keep(f"{title}: {name}", make)
