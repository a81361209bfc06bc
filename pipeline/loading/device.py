"""What the settings say of the device: units, inputs, mass and parameter set, in SI, and its tables' schemas."""

import difflib
import tomllib
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

from pipeline.errors import InputError
from pipeline.models.file_columns import column_of
from pipeline.numerics.arrays import FloatArray
from pipeline.plain_files import read_toml
from pipeline.runs.schemas import Schema, resolve
from pipeline.settings import Channel, Prototype, Quantity
from pipeline.units import ACCELERATION, DISPLACEMENT, INPUT, MASS, TIME, VELOCITY, SiUnit, curve_units, of_joint, to_si

if TYPE_CHECKING:
    from pipeline.joint.parameters import JointParameters


LARGEST_FILE = 100_000
"""Bytes; a parameter file has a few hundred."""
RotationMap = Callable[[FloatArray], FloatArray]


def joint_parameters(name: str, *, folder: Path | None = None, overrides: Sequence[str] = ()) -> "JointParameters":
    """A parameter set by name or from a TOML file, with single values replaced.

    Parameters
    ----------
    name : str
        ``table1``, ``nominal``, or a path that ends in ``.toml``.
    folder : Path, optional
        What a relative path is relative to; the working folder if left out.
    overrides : sequence of str
        ``name=value unit``, e.g. ``E=1.8 GPa`` or ``left.b=23.2 mm``.

    Raises
    ------
    InputError
        No such set, file or parameter; a value without a unit or with one of another kind.
    """
    from pipeline.joint.parameters import PARAMETER_SETS

    if name in PARAMETER_SETS:
        parameters = PARAMETER_SETS[name]
    elif name.endswith(".toml"):
        parameters = _from_file(Path(name) if folder is None else folder / name)
    else:
        close = difflib.get_close_matches(name, PARAMETER_SETS, n=1)
        hint = f"did you mean {close[0]!r}?" if close else f"there are {', '.join(PARAMETER_SETS)}, or a .toml file"
        raise InputError(f"no parameter set {name!r} (plant.parameters, or --parameters); {hint}")
    return parameters.with_values(dict(_override(text) for text in overrides))


def _from_file(path: Path) -> "JointParameters":
    """A TOML file: ``base`` names a shipped set, the rest are ``name = "value unit"``, sides in [left] and [right]."""
    from pipeline.joint.parameters import PARAMETER_SETS

    try:
        if path.stat().st_size > LARGEST_FILE:
            raise InputError(f"{path}: is no parameter file (over {LARGEST_FILE} bytes)")
        content = read_toml(path)
    except (OSError, UnicodeDecodeError, tomllib.TOMLDecodeError) as error:
        raise InputError(f"{path}: cannot be read as a parameter file ({error})") from error
    base = content.pop("base", "nominal")
    if base not in PARAMETER_SETS:
        raise InputError(f"{path}: base = {base!r} is no parameter set; there are {', '.join(PARAMETER_SETS)}")
    return PARAMETER_SETS[base].with_values(dict(_entries(content, path)))


def _entries(content: Mapping[str, Any], path: Path, prefix: str = "") -> Iterator[tuple[str, float]]:
    # Values for both sides first, so that [left] and [right] win wherever they stand in the file.
    for key, value in sorted(content.items(), key=lambda item: isinstance(item[1], Mapping)):
        if isinstance(value, Mapping) and not prefix and key in ("left", "right"):
            yield from _entries(value, path, f"{key}.")
        else:
            yield prefix + key, _quantity(prefix + key, str(value), f"{path}: {prefix}{key}")


def _override(text: str) -> tuple[str, float]:
    name, equals, value = text.partition("=")
    if not equals:
        raise InputError(f"--set {text!r}: write name=value with its unit, such as 'E=1.8 GPa' or 'left.b=23 mm'")
    return name.strip(), _quantity(name.strip(), value, f"--set {name.strip()}")


def _quantity(name: str, text: str, where: str) -> float:
    from pipeline.joint.parameters import quantity_of
    from pipeline.units import parse_quantity

    return parse_quantity(text, (quantity_of(name).unit,), where)


def parameter_values(parameters: "JointParameters | None") -> dict[str, float] | None:
    """The values [SI] that enter an artifact's recipe, so that an edited parameter file is noticed."""
    from pipeline.joint.parameters import VECTOR_NAMES

    return None if parameters is None else {name: parameters.value(name) for name in VECTOR_NAMES}


def parameter_file(parameters: "JointParameters", comments: Mapping[str, str] | None = None) -> str:
    """The text of a parameter file (SI units) that `joint_parameters` reads back to the same set.

    Parameters
    ----------
    parameters : JointParameters
        The set.
    comments : mapping of str to str, optional
        Comments by parameter name, e.g. standard errors.
    """
    from pipeline.joint.parameters import QUANTITIES, VECTOR_NAMES

    lines: list[str] = []
    section = ""
    for name in VECTOR_NAMES:
        side, _, attribute = name.rpartition(".")
        if side != section:
            lines += ["", f"[{side}]"]
            section = side
        note = f"  # {comments[name]}" if comments and name in comments else ""
        lines.append(f'{attribute} = "{parameters.value(name)!r} {QUANTITIES[name].unit}"{note}')
    return "\n".join(lines) + "\n"


def rotation_map(parameters: "JointParameters | None") -> RotationMap | None:
    """φ [rad] of q [m], NaN where q is NaN; None for a device without a parameter set."""
    if parameters is None:
        return None
    from pipeline.joint.static_path import static_rotation

    return lambda q: static_rotation(q, parameters)


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

    @property
    def curve_units(self) -> dict[str, str]:
        """SI units of its characteristic curves, see `pipeline.units.curve_units`."""
        return curve_units(
            self.displacement.symbol, self.inputs[0].symbol, squared=self.action == "squared",
            mass_known=self.known_mass is not None,
        )  # fmt: skip

    @property
    def joint(self) -> bool:
        """Whether it can be the bistable joint."""
        units = [unit.symbol for unit in self.inputs]
        return of_joint(self.displacement.symbol, units, squared=self.action == "squared")

    def schema(self, schema: Schema, *, phi: bool = False) -> Schema:
        """The schema with this device's units and inputs."""
        inputs = tuple(unit.symbol for unit in self.inputs)
        return resolve(
            schema, displacement=self.displacement.symbol, inputs=inputs, phi=phi, velocity=self.velocity is not None
        )

    def model_column(self, path: str) -> tuple[str, str]:
        """Unit and meaning of an entry of a model's file, by its path there."""
        mass = ("kg" if self.displacement.symbol == "m" else "kg·m²") if self.known_mass is not None else "1"
        stiffness = {"N": "N/m", "N·m": "N·m/rad"}.get(self.curve_units["F"], "1/s²")
        units = {"q": self.displacement.symbol, "v": self.inputs[0].symbol, "m": mass, "c": stiffness}
        return column_of(path, units | self.curve_units)


def device(prototype: Prototype) -> Device:
    """Resolve the units of the settings.

    Raises
    ------
    InputError
        A unit is unknown or measures something else, an acceleration would act by its square, or a parameter set is for
        a joint and q is no length; the text names the key.
    """
    channels, mass = prototype.channels, prototype.plant.mass

    def unit(key: str, stated: Channel | Quantity, *allowed: str) -> SiUnit:
        """The unit that is stated under a key, of what is allowed there."""
        return to_si(stated.unit, allowed, f"{prototype.name}: {key}.unit")

    displacement = unit("channels.q", channels.q, *DISPLACEMENT)
    inputs = tuple(unit(f"channels.v{i}", channel, *INPUT) for i, channel in enumerate(channels.inputs, start=1))
    if prototype.plant.inputs == "squared" and any(one.symbol in ACCELERATION for one in inputs):
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
