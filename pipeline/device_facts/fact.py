"""One line of a datasheet."""

from dataclasses import dataclass


@dataclass(frozen=True)
class Fact:
    """One line of the datasheet, in SI; None where it does not exist or is not known.

    Attributes
    ----------
    low, high : float or None
        Central 90 % by the model's posterior.
    measured, measured_spread : float or None
        The same seen in the data without any model, and its standard deviation over the events.
    events : int
        How many events were seen.
    """

    key: str
    title: str
    unit: str
    value: float | None
    low: float | None = None
    high: float | None = None
    measured: float | None = None
    measured_spread: float | None = None
    events: int = 0
