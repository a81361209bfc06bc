"""Progress of long work: the callback that reports it."""

from collections.abc import Callable

OnProgress = Callable[[str, float], None]
"""Called with the present step and the share, 0 to 1, that is done."""


def silent(what: str, share: float) -> None:
    """Report nothing."""
