"""Parameter sets of the analytical joint: by name, from a file, as a file, and as the settings name them."""

import difflib
import tomllib
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from ..errors import InputError
from ..settings.prototype import Prototype
from ..system.plain_files import read_toml
from ..units.units import parse_quantity

if TYPE_CHECKING:
    from .parameters import JointParameters

LARGEST_FILE = 100_000
"""Bytes; a parameter file has a few hundred."""


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
    from .parameters import PARAMETER_SETS

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
    from .parameters import PARAMETER_SETS

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
    from .parameters import quantity_of

    return parse_quantity(text, (quantity_of(name).unit,), where)


def parameter_values(parameters: "JointParameters | None") -> dict[str, float] | None:
    """The values [SI] that enter an artifact's recipe, so that an edited parameter file is noticed."""
    from .parameters import VECTOR_NAMES

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
    from .parameters import QUANTITIES, VECTOR_NAMES

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
