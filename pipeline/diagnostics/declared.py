"""What the settings say of the device, as checks need it."""

from dataclasses import dataclass

from ..settings.prototype import FIELD_LIMIT, FILM_THICKNESS
from ..units.units import of_joint


@dataclass(frozen=True)
class Declared:
    """What the settings say of the device.

    Attributes
    ----------
    squared : bool
        Whether inputs act by their squares.
    displacement, inputs : str, tuple of str
        SI units.
    mass : float or None
        Moving mass [kg], if stated.
    sample_interval : float
        Of the identification [s].
    film_thickness, field_limit : float
        Thickness of the undeformed film of a joint [m], and the largest field in it [V/m].
    """

    squared: bool
    displacement: str
    inputs: tuple[str, ...]
    mass: float | None
    sample_interval: float
    film_thickness: float = 1e-6 * FILM_THICKNESS
    field_limit: float = 1e6 * FIELD_LIMIT

    @property
    def joint(self) -> bool:
        """Whether it can be the joint: two squared voltages on a length. Others are checked as far as that applies."""
        return of_joint(self.displacement, self.inputs, squared=self.squared)
