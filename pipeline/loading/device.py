"""What the settings say of the device: units, inputs, mass and parameter set, in SI, and its tables' schemas."""

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Literal

from pipeline.errors import InputError
from pipeline.loading.joint_parameters import joint_parameters
from pipeline.runs.schemas import Schema, resolve
from pipeline.settings import Channel, Prototype
from pipeline.units import ACCELERATION, DISPLACEMENT, INPUT, MASS, TIME, VELOCITY, SiUnit, to_si

if TYPE_CHECKING:
    from pipeline.joint.parameters import JointParameters


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
    """

    time: SiUnit | None
    displacement: SiUnit
    inputs: tuple[SiUnit, ...]
    action: Literal["squared", "linear"]
    known_mass: float | None
    velocity: SiUnit | None = None

    @property
    def mass(self) -> float:
        """The mass, 1 if it is unknown: curves are then per unit mass."""
        return 1.0 if self.known_mass is None else self.known_mass

    def schema(self, schema: Schema, *, phi: bool = False) -> Schema:
        """The schema with this device's units and inputs."""
        inputs = tuple(unit.symbol for unit in self.inputs)
        return resolve(
            schema, displacement=self.displacement.symbol, inputs=inputs, phi=phi, velocity=self.velocity is not None
        )


def device(prototype: Prototype) -> Device:
    """Resolve the units of the settings.

    Raises
    ------
    InputError
        A unit is unknown or measures something else, or an acceleration would act by its square; the text names the
        key.
    """
    channels, mass = prototype.channels, prototype.plant.mass

    def unit(key: str, channel: Channel, allowed: tuple[str, ...]) -> SiUnit:
        return to_si(channel.unit, allowed, f"{prototype.name}: channels.{key}.unit")

    displacement = unit("q", channels.q, DISPLACEMENT)
    inputs = tuple(unit(f"v{i}", channel, INPUT) for i, channel in enumerate(channels.inputs, start=1))
    if prototype.plant.inputs == "squared" and any(one.symbol in ACCELERATION for one in inputs):
        raise InputError(
            f'{prototype.name}: an acceleration acts by itself, not by its square; set [plant] inputs = "linear"'
        )
    return Device(
        time=unit("time", channels.time, TIME) if channels.time else None,
        displacement=displacement,
        inputs=inputs,
        action=prototype.plant.inputs,
        known_mass=mass.value * to_si(mass.unit, MASS, f"{prototype.name}: plant.mass.unit").factor if mass else None,
        velocity=unit("qdot", channels.qdot, (VELOCITY[displacement.symbol],)) if channels.qdot else None,
    )


def parameter_set(prototype: Prototype, prototype_file: Path) -> "JointParameters | None":
    """The parameter set of a DE joint, paths being relative to the settings file; None for another device.

    Raises
    ------
    InputError
        No such set or file.
    """
    name = prototype.plant.parameters
    return None if name is None else joint_parameters(name, folder=prototype_file.parent)
