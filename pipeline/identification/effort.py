"""A time limit that counts evaluations: the same data and settings end at the same point on every machine.

The clock of one machine decides nothing. Simulations cost by a model of a reference machine (one core of a 2.5 GHz
server) with other work beside it. Fits of a circuit, a propeller and a joint took 0.8 to 1.2 times what it says.
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
        """Count a simulation of so many integration steps, with so many sensitivities and perhaps a delay."""
        per_step = PER_STEP + PER_SENSITIVITY * sensitivities + PER_DELAYED_STEP * delayed
        self.spent += PER_SIMULATION + steps * per_step

    def exhausted(self, share: float = 1.0) -> bool:
        """Whether a share of the limit is spent."""
        return self.spent >= share * self.limit
