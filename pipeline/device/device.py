"""The device by its settings: units, action of the inputs, mass and limits, in SI."""

from dataclasses import dataclass, replace
from typing import Literal

import numpy as np

from ..errors import InputError
from ..numerics.arrays import FloatArray
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
    to_si,
)

_PLAUSIBLE_SPANS = {"m": (1e-5, 0.5), "rad": (1e-3, 20.0), "V": (0.5, 5e4)}
"""Spans (largest minus smallest value) that a joint's signals have, by SI unit, with room on both sides."""


@dataclass(frozen=True)
class Device:
    """Units and inputs of a prototype, in SI.

    Attributes
    ----------
    time : SiUnit or None
        None where the format carries its own time base.
    displacement : SiUnit
        To m or rad: the unit in which a run computes.
    inputs : tuple of SiUnit
        To V, or whatever the inputs measure; one or two.
    action : {"squared", "linear"}
        Action of the inputs.
    known_mass : float or None
        Moving mass [kg] or inertia [kg·m²], if the settings state it.
    velocity : SiUnit or None
        To m/s or rad/s; None where the velocity was not measured.
    film_thickness, field_limit : float
        Thickness of the undeformed film [m], and the largest field in it [V/m].
    angle : SiUnit or None
        To rad, where the log has the angle of a joint in place of its displacement: the kinematics of its parameter set
        make the one of the other.
    """

    time: SiUnit | None
    displacement: SiUnit
    inputs: tuple[SiUnit, ...]
    action: Literal["squared", "linear"]
    known_mass: float | None
    velocity: SiUnit | None = None
    film_thickness: float = 1e-6 * FILM_THICKNESS
    field_limit: float = 1e6 * FIELD_LIMIT
    angle: SiUnit | None = None

    @property
    def logged(self) -> SiUnit:
        """Unit of q in the log, or of the angle that stands in its place."""
        return self.angle or self.displacement

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
        """SI units of characteristic curves: restoring force ``F``, damping ``d``, an input's ``g``, and ``dC`` = 2 g.

        Of a squared voltage, g is half the slope of a capacitance. Without a known mass (or inertia), and where the
        displacement is that of an electronic device, curves are per unit mass.
        """
        displacement = self.displacement.symbol
        voltage = self.inputs[0].symbol
        symbol = f"({voltage})" if "/" in voltage or "·" in voltage else voltage
        power = f"{symbol}²" if self.squared else symbol
        if self.known_mass is None or displacement not in ("m", "rad"):
            force = f"{displacement}/s²"
            gain = force if voltage == "1" else f"{displacement}/(s²·{power})"
            return {"F": force, "d": "1/s", "dC": gain, "g": gain}
        force = "N" if displacement == "m" else "N·m"
        gain = force if voltage == "1" else f"{force}/{power}"
        slope = f"F/{displacement}" if self.squared and voltage == "V" else gain
        return {"F": force, "d": f"{force}·s/{displacement}", "dC": slope, "g": gain}

    @property
    def energy_unit(self) -> str:
        """SI unit of the integral of its restoring force over q."""
        of_unit_mass = "J/kg" if self.displacement.symbol == "m" else f"{self.displacement.symbol}²/s²"
        return of_unit_mass if self.known_mass is None else "J"

    @property
    def input_word(self) -> str:
        """Noun for an input: a voltage only where it is one."""
        return "voltage" if self.inputs[0].symbol == "V" else "input"

    @property
    def joint(self) -> bool:
        """True if the device can be the bistable joint: two squared voltages on a length.

        A device with one well, or one that turns to the other side, is no fault.
        """
        return self.squared and self.displacement.symbol == "m" and self.input_symbols == ("V", "V")

    @property
    def squared(self) -> bool:
        """True if the inputs act by their squares."""
        return self.action == "squared"

    @property
    def input_symbols(self) -> tuple[str, ...]:
        """SI units of its inputs."""
        return tuple(unit.symbol for unit in self.inputs)

    def acting(self, v: FloatArray) -> FloatArray:
        """Acting inputs: the squares of v, or v itself."""
        squares: FloatArray = np.square(v)
        return squares if self.squared else v

    @property
    def under_other_action(self) -> "Device":
        """The device if its inputs acted by the other action."""
        return replace(self, action="linear" if self.squared else "squared")

    def peaks(self, v: FloatArray) -> FloatArray:
        """Largest magnitude of each input, shape (K,), against which its steps and rests are seen.

        The voltages of the joint are of one kind, so both have the larger one. Another device has each input's own, but
        not less than a twentieth of the largest: the noise of an unused input is then no step.
        """
        own: FloatArray = np.max(np.abs(v), axis=0, initial=0.0)
        largest = float(np.max(own, initial=0.0))
        return np.full_like(own, largest) if self.joint else np.maximum(own, 0.05 * largest)

    def plausible_span(self, symbol: str) -> tuple[float, float] | None:
        """Least and largest span [SI] of its signals of this unit; None for a unit without known spans.

        Of a device that is no joint any span is plausible.
        """
        return _PLAUSIBLE_SPANS.get(symbol) if self.joint else None


JOINT = Device(None, SiUnit(1e-3, "m"), (SiUnit(1e3, "V"), SiUnit(1e3, "V")), "squared", None)
"""The bistable joint, of unknown mass."""


def device(prototype: Prototype) -> Device:
    """Resolve the units of the settings.

    Raises
    ------
    InputError
        A unit is unknown or measures something else; an acceleration would act by its square; or a parameter set is for
        a joint, but q is neither a length nor an angle. The text names the key.
    """
    channels = prototype.channels
    plant = prototype.plant
    mass = plant.mass

    def unit(key: str, stated: LogColumn | Quantity, *allowed: str) -> SiUnit:
        """The unit that a key states, if it is allowed there."""
        return to_si(stated.unit, allowed, f"{prototype.name}: {key}.unit")

    logged = unit("channels.q", channels.q, *DISPLACEMENT)
    inputs = tuple(unit(f"channels.v{i}", channel, *INPUT) for i, channel in enumerate(channels.inputs, start=1))
    if plant.inputs == "squared" and any(channel.symbol in ACCELERATION for channel in inputs):
        raise InputError(
            f'{prototype.name}: an acceleration acts by itself, not by its square; set [plant] inputs = "linear"'
        )
    if plant.parameters is not None and logged.symbol not in ("m", "rad"):
        raise InputError(
            f"{prototype.name}: plant.parameters: q of the joint is a length or its angle, and this device's is in "
            f"{channels.q.unit}; leave the set out for another device"
        )
    angle = logged if plant.parameters is not None and logged.symbol == "rad" else None
    displacement = to_si("mm", ("m",), "") if angle else logged
    return Device(
        time=unit("channels.time", channels.time, *TIME) if channels.time else None,
        displacement=displacement,
        inputs=inputs,
        action=plant.inputs,
        known_mass=mass.value * unit("plant.mass", mass, MASS[displacement.symbol]).factor if mass else None,
        velocity=unit("channels.qdot", channels.qdot, VELOCITY[logged.symbol]) if channels.qdot else None,
        film_thickness=plant.film_thickness.value * unit("plant.film_thickness", plant.film_thickness, "m").factor,
        field_limit=plant.field_limit.value * unit("plant.field_limit", plant.field_limit, "V/m").factor,
        angle=angle,
    )
