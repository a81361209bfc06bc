"""One line of a datasheet."""

from dataclasses import dataclass


@dataclass(frozen=True)
class Fact:
    """One line of the datasheet, in SI; None where it does not exist or is not known.

    Attributes
    ----------
    value : float or None
        By the model's curves; of a ring-down that of a small motion, as the whole model simulates it.
    low, high : float or None
        Central 90 % by the model's posterior.
    measured, measured_spread : float or None
        The same seen in the data without any model, and its standard deviation over the events.
    events : int
        How many events were seen.
    free_run : float or None
        The same seen in the model's own free runs over the logs: like with like, whatever the size of the motion.
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
    free_run: float | None = None
