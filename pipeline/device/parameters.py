"""Parameters of the joint (Table 1): frozen sets by name and from files, with SI unit and meaning of every number.

A name without a prefix (``E``, ``b``) means the beam, the mass, or both membranes; ``left.b`` and ``right.b`` mean one
side. A real joint is asymmetric; the paper's analytical model is not.
"""

import difflib
import math
import tomllib
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, fields, replace
from functools import cached_property
from operator import attrgetter
from pathlib import Path
from typing import Any, Literal

import numpy as np

from ..errors import InputError
from ..numerics.arrays import FloatArray
from ..settings.prototype import Prototype
from ..system.plain_files import read_toml
from ..units.units import parse_quantity

VACUUM_PERMITTIVITY = 8.854e-12
"""ε0 [As/Vm], with the digits of Table 1."""

BEAM_DAMPING_FACTOR = 2.0
"""The 2 of 2ηI in eq. 12; η is a fitted number, so another factor only rescales it."""


Sign = Literal["positive", "zero or positive", "of either sign"]

_ALLOWED: dict[Sign, Callable[[float], bool]] = {
    "positive": lambda value: value > 0.0,
    "zero or positive": lambda value: value >= 0.0,
    "of either sign": lambda _: True,
}
B_MAX = 30e-3
"""b_max [m] of eq. 17: z_b = b_max − b is how far the mounts are screwed together."""


def _quantity(unit: str, meaning: str, default: float | None = None, *, sign: Sign = "positive") -> Any:
    metadata = {"unit": unit, "meaning": meaning, "sign": sign}
    return field(metadata=metadata) if default is None else field(metadata=metadata, default=default)


@dataclass(frozen=True, kw_only=True)
class Membrane:
    """One n-layer dielectric-elastomer membrane and where it is held (figure 1)."""

    a: float = _quantity("m", "arm of the upper mount along the tilted frame")
    b: float = _quantity("m", "height of the upper mount on the tilted frame; smaller b, more pre-strain")
    a0: float = _quantity("m", "offset of the frame from the beam's tip, along the beam")
    e_x: float = _quantity("m", "height of the lower mount", sign="of either sign")
    e_z: float = _quantity("m", "distance of the lower mount from the beam")
    l0: float = _quantity("m", "length of the undeformed membrane")
    n: float = _quantity("1", "number of layers")
    d0: float = _quantity("m", "thickness of one undeformed layer")
    A0: float = _quantity("m²", "area of the undeformed membrane")
    beta: float = _quantity("1", "electrode area over membrane area")
    eps_r: float = _quantity("1", "relative permittivity")
    Y: float = _quantity("Pa", "Young's modulus")
    Y_MW: float = _quantity("Pa", "modulus of the Maxwell element", sign="zero or positive")
    eta_MW: float = _quantity("Pa·s", "viscosity of the Maxwell element")
    eta_v: float = _quantity("Pa·s", "Kelvin-Voigt viscosity", sign="zero or positive")

    @property
    def volume(self) -> float:
        """V_DE [m³]."""
        return float(volume(self.n, self.A0, self.d0))

    @property
    def capacitance(self) -> float:
        """C0 [F] undeformed."""
        return float(capacitance(self.n, self.eps_r, self.beta, self.A0, self.d0))

    @property
    def relaxation(self) -> float:
        """Rate [1/s] at which the Maxwell element relaxes."""
        return self.Y_MW / self.eta_MW


def volume(n: Any, A0: Any, d0: Any) -> Any:
    """V_DE = n A0 d0, of numbers or of symbols."""
    return n * A0 * d0


def capacitance(n: Any, eps_r: Any, beta: Any, A0: Any, d0: Any) -> Any:
    """C0 = n ε0 εr β A0 / d0 (eq. 11), of numbers or of symbols.

    Parameters
    ----------
    n : number
        Number of layers.
    eps_r : number
        Relative permittivity.
    beta : number
        Share of the electrodes' area.
    A0 : number
        Area of the undeformed film [m²].
    d0 : number
        Thickness of the undeformed film [m].
    """
    return n * VACUUM_PERMITTIVITY * eps_r * beta * A0 / d0


@dataclass(frozen=True, kw_only=True)
class JointParameters:
    """All parameters of the analytical model of a joint."""

    l: float = _quantity("m", "length of the beam")
    A: float = _quantity("m²", "cross-section of the beam")
    I: float = _quantity("m⁴", "area moment of inertia of the beam")
    E: float = _quantity("Pa", "Young's modulus of the beam")
    rho: float = _quantity("kg/m³", "density of the beam", sign="zero or positive")
    eta: float = _quantity("Pa·s", "viscosity of the beam", sign="zero or positive")
    m: float = _quantity("kg", "moving mass at the tip")
    left: Membrane
    right: Membrane
    g: float = _quantity("m/s²", "gravity", 9.81, sign="of either sign")
    kappa0: float = _quantity("1/m", "curvature of the unloaded beam, + bends to the right", 0.0, sign="of either sign")
    F_c: float = _quantity("N", "Coulomb level of the friction along q (0: none)", 0.0, sign="zero or positive")
    s_c: float = _quantity("m", "pre-sliding displacement of the friction", 1e-4)

    def __post_init__(self) -> None:
        for value, name in zip(self._values if self.left and self.right else (), VECTOR_NAMES, strict=False):
            quantity = QUANTITIES[name]
            if not (math.isfinite(value) and _ALLOWED[quantity.sign](value)):
                raise InputError(
                    f"parameter {name} = {value:g} {quantity.unit}: must be a finite number, {quantity.sign}"
                )

    def value(self, name: str) -> float:
        """The value [SI] of one entry of `VECTOR_NAMES`."""
        side, _, attribute = name.rpartition(".")
        return float(getattr(getattr(self, side) if side else self, attribute))

    @property
    def levers(self) -> FloatArray:
        """∂q/∂(q2, q3, q4, u0), shape (4,), of the tip (eq. 6): [l², l³, l⁴, 0]."""
        return np.append(self.l ** np.arange(2, 5), 0.0)

    @property
    def slopes(self) -> FloatArray:
        """∂(tan φ)/∂(q2, q3, q4, u0), shape (4,), of the tip: [2 l, 3 l², 4 l³, 0]."""
        return np.append(np.arange(2, 5) * self.l ** np.arange(1, 4), 0.0)

    def vector(self) -> FloatArray:
        """All values [SI] in the order of `VECTOR_NAMES`, shape (41,): what the kernels take."""
        return np.array(self._values)

    @cached_property
    def _values(self) -> tuple[float, ...]:
        return tuple(map(float, _READ(self)))

    def with_values(self, values: Mapping[str, float]) -> "JointParameters":
        """A set with some values [SI] replaced; ``b`` replaces both sides, ``left.b`` one, later ones win.

        Raises
        ------
        InputError
            An unknown name, with the nearest known ones, or an impossible value.
        """
        shared: dict[str, float] = {}
        sides: dict[str, dict[str, float]] = {"left": {}, "right": {}}
        for name, value in values.items():
            quantity_of(name)
            side, _, attribute = name.rpartition(".")
            if side:
                sides[side][attribute] = float(value)
            elif attribute in _MEMBRANE_NAMES:
                sides["left"][attribute] = sides["right"][attribute] = float(value)
            else:
                shared[attribute] = float(value)
        left, right = (replace(getattr(self, side), **sides[side]) for side in ("left", "right"))
        return replace(self, left=left, right=right, **shared)


@dataclass(frozen=True)
class ParameterQuantity:
    """Unit (SI) and meaning of a parameter, and which signs its values may have."""

    unit: str
    meaning: str
    sign: Sign


_MEMBRANE_NAMES = tuple(entry.name for entry in fields(Membrane))
_SHARED_NAMES = tuple(entry.name for entry in fields(JointParameters) if entry.name not in ("left", "right"))
VECTOR_NAMES = (
    *_SHARED_NAMES,
    *(f"left.{name}" for name in _MEMBRANE_NAMES),
    *(f"right.{name}" for name in _MEMBRANE_NAMES),
)
"""Order of the kernels' parameter vector."""
_READ = attrgetter(*VECTOR_NAMES)

_OWN = {
    entry.name: ParameterQuantity(**entry.metadata)
    for entry in (*fields(JointParameters), *fields(Membrane))
    if entry.metadata
}
QUANTITIES = {name: _OWN[name.rpartition(".")[2]] for name in (*VECTOR_NAMES, *_MEMBRANE_NAMES)}
"""Unit and meaning by name, for every name that `JointParameters.with_values` accepts."""


def quantity_of(name: str) -> ParameterQuantity:
    """Unit and meaning of a parameter.

    Raises
    ------
    InputError
        There is no such parameter; the text suggests the nearest names.
    """
    if name in QUANTITIES:
        return QUANTITIES[name]
    near = difflib.get_close_matches(name, QUANTITIES, n=3, cutoff=0.4) or sorted(_OWN)
    raise InputError(f"unknown parameter {name!r}; did you mean {', '.join(near)}?")


_MEMBRANE = Membrane(
    a=32e-3, b=23e-3, a0=11e-3, e_x=7e-3, e_z=16e-3, l0=51e-3,
    n=8.0, d0=50e-6, A0=1326e-6, beta=1.0, eps_r=2.8,
    Y=1.2e6, Y_MW=0.31e6, eta_MW=83.5e3, eta_v=0.3e3,
)  # fmt: skip

TABLE1 = JointParameters(
    l=90e-3, A=11e-6, I=1.1e-12, E=1.62e9, rho=1200.0, eta=3.64e6, m=40e-3, left=_MEMBRANE, right=_MEMBRANE
)
"""Table 1 with its corrections: E is 1.62 GPa where MPa is printed (PETG; with MPa the beam carries no load),
a0 belongs to the geometry, and β = 1 and g = 9.81 m/s², which the table does not give."""

NOMINAL = replace(TABLE1, E=1.76e9)
"""Table 1 with E = 1.76 GPa: inside the paper's range of PETG; it reproduces the statements on figures 3 to 5."""

PARAMETER_SETS = {"table1": TABLE1, "nominal": NOMINAL}
"""The sets that ship with the program, by name."""


def joint_parameters(name: str, *, folder: Path | None = None, overrides: Sequence[str] = ()) -> "JointParameters":
    """A parameter set by name or from a TOML file, with single values replaced.

    Parameters
    ----------
    name : str
        ``table1``, ``nominal``, or a path that ends in ``.toml``.
    folder : Path, optional
        Base of a relative path; the working folder if left out.
    overrides : sequence of str
        ``name=value unit``, e.g. ``E=1.8 GPa`` or ``left.b=23.2 mm``.

    Raises
    ------
    InputError
        No such set, file or parameter; a value without a unit or with one of another kind.
    """
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
    try:
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
            yield prefix + key, _in_si(prefix + key, str(value), f"{path}: {prefix}{key}")


def _override(text: str) -> tuple[str, float]:
    name, equals, value = text.partition("=")
    if not equals:
        raise InputError(f"--set {text!r}: write name=value with its unit, such as 'E=1.8 GPa' or 'left.b=23 mm'")
    return name.strip(), _in_si(name.strip(), value, f"--set {name.strip()}")


def _in_si(name: str, text: str, where: str) -> float:
    return parse_quantity(text, (quantity_of(name).unit,), where)


def parameter_values(parameters: "JointParameters | None") -> dict[str, float] | None:
    """The values [SI] that enter an artifact's recipe, so that an edited parameter file is noticed."""
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


def parameter_set(prototype: Prototype, prototype_file: Path) -> "JointParameters | None":
    """The parameter set of a DE joint, paths being relative to the settings file; None for another device.

    Raises
    ------
    InputError
        No such set or file.
    """
    name = prototype.plant.parameters
    return None if name is None else joint_parameters(name, folder=prototype_file.parent)
