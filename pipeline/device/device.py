"""The device by its settings: units, law of the inputs, mass and limits, in SI."""

from dataclasses import dataclass
from typing import Literal

import numpy as np

from ..errors import InputError
from ..settings.logs import LogColumn
from ..settings.prototype import FIELD_LIMIT, FILM_THICKNESS, Prototype, Quantity
from ..units.units import (
    ACCELERATION,
    DISPLACEMENT,
    INPUT,
    MASS,
    TIME,
    VELOCITY,
    SiUnit,
    curve_units,
    of_joint,
    to_si,
)


@dataclass(frozen=True)
class Device:
    """Units and inputs of a prototype, in SI.

    Attributes
    ----------
    time : SiUnit or None
        None where the format carries its own time base.
    displacement : SiUnit
        To m or rad.
    inputs : tuple of SiUnit
        To V, or whatever the inputs measure; one or two.
    action : {"squared", "linear"}
        How the inputs act.
    known_mass : float or None
        Moving mass [kg] or inertia [kg·m²], if the settings state it.
    velocity : SiUnit or None
        To m/s or rad/s; None where the velocity was not measured.
    film_thickness, field_limit : float
        Thickness of the undeformed film [m], and the largest field in it [V/m].
    """

    time: SiUnit | None
    displacement: SiUnit
    inputs: tuple[SiUnit, ...]
    action: Literal["squared", "linear"]
    known_mass: float | None
    velocity: SiUnit | None = None
    film_thickness: float = 1e-6 * FILM_THICKNESS
    field_limit: float = 1e6 * FIELD_LIMIT

    @property
    def voltage_limit(self) -> float:
        """Largest voltage [V] that the film of a joint stands; infinite for another device."""
        return self.field_limit * self.film_thickness if self.joint else np.inf

    @property
    def mass(self) -> float:
        """The mass, 1 if it is unknown: curves are then per unit mass."""
        return 1.0 if self.known_mass is None else self.known_mass

    @property
    def curve_units(self) -> dict[str, str]:
        """SI units of its characteristic curves, see `pipeline.units.units.curve_units`."""
        return curve_units(
            self.displacement.symbol, self.inputs[0].symbol, squared=self.action == "squared",
            mass_known=self.known_mass is not None,
        )  # fmt: skip

    @property
    def energy_unit(self) -> str:
        """SI unit of the integral of its restoring force over q."""
        if self.known_mass is not None:
            return "J"
        return "J/kg" if self.displacement.symbol == "m" else f"{self.displacement.symbol}²/s²"

    @property
    def input_word(self) -> str:
        """Noun for an input: a voltage only where it is one."""
        return "voltage" if self.inputs[0].symbol == "V" else "input"

    @property
    def joint(self) -> bool:
        """Whether it can be the bistable joint."""
        units = [unit.symbol for unit in self.inputs]
        return of_joint(self.displacement.symbol, units, squared=self.action == "squared")


def device(prototype: Prototype) -> Device:
    """Resolve the units of the settings.

    Raises
    ------
    InputError
        A unit is unknown or measures something else, an acceleration would act by its square, or a parameter set is for
        a joint and q is no length; the text names the key.
    """
    channels = prototype.channels
    plant = prototype.plant
    mass = prototype.plant.mass

    def unit(key: str, stated: LogColumn | Quantity, *allowed: str) -> SiUnit:
        """The unit that is stated under a key, of what is allowed there."""
        return to_si(stated.unit, allowed, f"{prototype.name}: {key}.unit")

    displacement = unit("channels.q", channels.q, *DISPLACEMENT)
    inputs = tuple(unit(f"channels.v{i}", channel, *INPUT) for i, channel in enumerate(channels.inputs, start=1))
    if prototype.plant.inputs == "squared" and any(channel.symbol in ACCELERATION for channel in inputs):
        raise InputError(
            f'{prototype.name}: an acceleration acts by itself, not by its square; set [plant] inputs = "linear"'
        )
    if prototype.plant.parameters is not None and displacement.symbol != "m":
        raise InputError(
            f"{prototype.name}: plant.parameters: q of the joint is a length, and this device's is in "
            f"{channels.q.unit}; leave the set out for another device"
        )
    return Device(
        time=unit("channels.time", channels.time, *TIME) if channels.time else None,
        displacement=displacement,
        inputs=inputs,
        action=prototype.plant.inputs,
        known_mass=mass.value * unit("plant.mass", mass, MASS[displacement.symbol]).factor if mass else None,
        velocity=unit("channels.qdot", channels.qdot, VELOCITY[displacement.symbol]) if channels.qdot else None,
        film_thickness=plant.film_thickness.value * unit("plant.film_thickness", plant.film_thickness, "m").factor,
        field_limit=plant.field_limit.value * unit("plant.field_limit", plant.field_limit, "V/m").factor,
    )
