"""What a fit may spend: time that is counted in evaluations, not taken by a clock.

So the same data and settings end at the same point on every machine. Simulations cost by a model of a reference machine
(one core of a 2.5 GHz server) with other work beside it, and of kernels that were slower: searches for a propeller and
a soft arm take 0.5 and 0.6 times what it says, fits of a DE joint 0.9 to 1.1 times.
"""

from dataclasses import dataclass

PER_SIMULATION = 0.7e-3
"""Cost of a simulation beside its steps: inputs, sums, the solution of the normal equations [s]."""

PER_STEP = 0.45e-6
"""Cost of a step of the data-driven joint [s]."""

PER_DELAYED_STEP = 0.35e-6
"""Cost of a step's inputs where a delay makes them anew for each run [s]."""

PER_SENSITIVITY = 0.054e-6
"""Cost of a step per parameter that is derived by [s]."""


def simulation_effort(steps: int, sensitivities: int = 0, *, delayed: bool = False) -> float:
    """Seconds of a simulation of so many integration steps, with so many sensitivities and perhaps a delay."""
    return PER_SIMULATION + steps * (PER_STEP + PER_SENSITIVITY * sensitivities + PER_DELAYED_STEP * delayed)


@dataclass
class Effort:
    """What may be spent and what was, in seconds of processor time by the cost model.

    Attributes
    ----------
    limit : float
        Seconds after which work that can wait is left out.
    spent : float
        Seconds so far.
    """

    limit: float = float("inf")
    spent: float = 0.0

    def spend(self, steps: int, sensitivities: int = 0, *, delayed: bool = False) -> None:
        """Count a simulation, as `simulation_effort`."""
        self.spent += simulation_effort(steps, sensitivities, delayed=delayed)

    def exhausted(self, share: float = 1.0) -> bool:
        """Whether a share of the limit is spent."""
        return self.spent >= share * self.limit
