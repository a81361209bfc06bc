"""Units at the edges: from logs and settings to SI, by pint; the program inside has SI only."""

import math
import re
from contextlib import suppress
from dataclasses import dataclass
from functools import cache
from typing import Any

from ..errors import InputError

FILL_IN = "FILL IN"
"""Stands in a first settings file where the user has to choose; no channel and no unit is called so."""

# Allowed quantities, by their SI unit.
DISPLACEMENT = ("m", "rad", "V")
"""V for an electronic circuit that stands for a mechanical device."""
VELOCITY = {"m": "m/s", "rad": "rad/s", "V": "V/s"}
"""SI unit of a velocity, by the unit of the displacement."""
ACCELERATION = ("m/s²", "rad/s²")
SIGNALS = ("q", "phi", "qdot", "qddot")
"""Signals by which models are scored, in the order of tables and figures."""
HORIZONS = {"one_step": (0.0, "one step"), "100ms": (0.1, "0.1 s"), "1s": (1.0, "1 s")}
"""Horizons of the scores from a measured state: in s (one sample at least), and in words."""
INPUT = ("V", "A", "N", "N·m", "Pa", "1", *ACCELERATION)
TIME = ("s",)


MASS = {"m": "kg", "rad": "kg·m²", "V": "kg"}
"""SI unit of a mass or an inertia, by the unit of the displacement."""

# The units of most logs, as pint resolves them: setting it up takes 0.2 s, a test compares.
PLAIN = {
    "m": (1.0, "m"),
    "mm": (1e-3, "m"),
    "um": (1e-6, "m"),
    "µm": (1e-6, "m"),
    "rad": (1.0, "rad"),
    "deg": (math.pi / 180.0, "rad"),
    "s": (1.0, "s"),
    "ms": (1e-3, "s"),
    "min": (60.0, "s"),
    "h": (3600.0, "s"),
    "V": (1.0, "V"),
    "kV": (1e3, "V"),
    "mV": (1e-3, "V"),
    "kg": (1.0, "kg"),
    "g": (1e-3, "kg"),
    "V/um": (1e6, "V/m"),
    "V/µm": (1e6, "V/m"),
}


ALPHA_UNIT = {"m": ("mm", 1e-3), "rad": ("deg", math.pi / 180.0), "V": ("mV", 1e-3)}
"""Unit of q, and its SI value, that the regularisation parameters of TVRegDiff are given in, by the SI unit of q."""

_MISLEADING = {
    **dict.fromkeys(("grad", "Grad"), "write 'deg' for degrees (360 to a turn), or 'gradian' for gons (400)"),
    **dict.fromkeys(("dB", "dBV", "dBm", "Np"), "a level is no linear measure; export V, A or another unit"),
    "gr": "write 'g' for grams, or 'grain' for grains (64.8 mg)",
    **dict.fromkeys(("px", "pixel"), "a pixel has no length of its own; give one as `scale`, in a unit such as 'mm'"),
}
"""Units that users and pint understand differently (giga-radians, a 96th of an inch, grains), and what to write."""

POWERS = {
    "1": (0, 0, 0, 0),
    "rad": (0, 0, 0, 0),
    "m": (0, 1, 0, 0),
    "1/m": (0, -1, 0, 0),
    "m/s": (0, 1, -1, 0),
    "s": (0, 0, 1, 0),
    "1/s": (0, 0, -1, 0),
    "V": (0, 0, 0, 1),
    "kg": (1, 0, 0, 0),
    "kg·m": (1, 1, 0, 0),
    "kg·m²": (1, 2, 0, 0),
    "N": (1, 1, -2, 0),
    "N/m": (1, 0, -2, 0),
    "N/V²": (1, 1, -2, -2),
    "N·s/m": (1, 0, -1, 0),
    "N·s²/m²": (1, -1, 0, 0),
    "N·m": (1, 2, -2, 0),
    "N·m/V²": (1, 2, -2, -2),
    "N·m·s": (1, 2, -1, 0),
    "J": (1, 2, -2, 0),
    "Pa": (1, -1, -2, 0),
    "Pa·s": (1, -1, -1, 0),
    "F": (1, 2, -2, -2),
}
"""Powers of kg, m, s and V in units of the joint's quantities; a test compares them with pint's."""

SECONDS = {"s": 1.0, "ms": 1e-3, "us": 1e-6, "ns": 1e-9, "min": 60.0, "h": 3600.0, "day": 86_400.0}
"""Seconds per unit of time, by pint's names."""
_TIME_WORDS = {
    "s": "sec secs second seconds sekunde sekunden с сек 秒", "ms": "msec millisecond milliseconds мс 毫秒 ミリ秒",
    "ns": "nanosecond nanoseconds", "us": "µs μs usec microsecond microseconds",
    "min": "mins minute minutes", "h": "hr hour hours", "day": "d days",
}  # fmt: skip
_TIME_NAMES = {word: unit for unit, words in _TIME_WORDS.items() for word in (unit, *words.split())}

_LONGEST = 60
# One name, and a whole power of one digit: all that a unit needs; pint would take long powers without end.
_FACTOR = r"(?:1|%|°[CF]?|[^\W\d_][^\W\d]*)(?:(?:\*\*|\^)[+-]?[1-9]|[⁺⁻]?[¹²³⁴-⁹])?"
_UNIT = re.compile(rf"\s*{_FACTOR}(?:\s*[*/·⋅ ]\s*{_FACTOR})*\s*")

_NUMBER = re.compile(r"\s*[-+]?(\d+\.?\d*|\.\d+)(e[-+]?\d+)?", re.IGNORECASE)


@dataclass(frozen=True)
class SiUnit:
    """A unit's way to SI: ``si_value = factor * value``, in the SI unit `symbol`."""

    factor: float
    symbol: str


@cache
def _registry() -> Any:
    import pint

    return pint.UnitRegistry()


def time_unit(text: str) -> str:
    """Pint's name of a unit of time as logs write it, as ``[ms]`` or ``seconds since 1970-01-01``; "" for others."""
    return _TIME_NAMES.get(text.strip().partition(" since ")[0].strip("[]() ").casefold(), "")


def to_si(unit: str, allowed: tuple[str, ...], where: str) -> SiUnit:
    """Resolve a unit string.

    Parameters
    ----------
    unit : str
        In pint's notation, e.g. ``mm``, ``kV``, ``deg``, ``%``: names, products and quotients of them, and whole
        powers of one digit; nothing else reaches pint, which works out whatever it is given.
    allowed : tuple of str
        The SI units that the quantity may have.
    where : str
        Place for the error, e.g. ``P1.toml: [channels] q``.

    Raises
    ------
    InputError
        The unit is unknown, carries an offset, or measures something else.
    """
    factor, symbol = PLAIN.get(unit, (0.0, ""))
    if symbol in allowed:
        return SiUnit(factor, symbol)
    if unit == FILL_IN:
        raise InputError(f"{where}: is still to be filled in, as with 'mm', 'kV', 's', 'deg', '%'")
    if unit in _MISLEADING:
        raise InputError(f"{where}: unit {unit!r} is not clear; {_MISLEADING[unit]}")
    if len(unit) > _LONGEST or not _UNIT.fullmatch(unit):
        way = _meant(unit[:_LONGEST], allowed) or "write names and whole powers as in 'mm', 'kV', 'N*s/m**2'"
        raise InputError(f"{where}: unknown unit {unit[:_LONGEST]!r}; {way}")
    registry = _registry()
    try:
        factor, base = registry.get_base_units(registry.Unit(unit))
    except Exception as error:  # pint raises its own errors, AttributeError and tokenizer errors alike
        way = _meant(unit, allowed) or "write it as in 'mm', 'kV', 's', 'deg', '%'"
        raise InputError(f"{where}: unknown unit {unit!r}; {way}") from error
    for symbol in allowed:
        target_factor, target_base = registry.get_base_units(registry.Unit(symbol))
        if base == target_base:
            return SiUnit(float(factor / target_factor), symbol)
    needed = f"unit {unit!r} does not measure what is needed here ({' or '.join(dict.fromkeys(allowed))})"
    velocity = any(base == registry.get_base_units(registry.Unit(rate))[1] for rate in VELOCITY.values())
    meant = _meant(unit, allowed)
    raise InputError(f"{where}: {needed}{f'; {meant}' if meant else _instead(unit, allowed, velocity=velocity)}")


def _meant(unit: str, allowed: tuple[str, ...]) -> str:
    """The question for a unit of these that is written otherwise, as Volt, KV, [mm] or Sekunden; "" without one."""
    bare = re.sub(r"^[\[(]([^\s\[\]()]*)[\])]$", r"\1", unit).strip(". ")
    alike = [plain for plain in PLAIN if plain.casefold() == bare.casefold()]
    others = (other for other in (bare, time_unit(bare), *alike, bare.lower()) if other not in ("", unit))
    return next((f"did you mean {other!r}?" for other in others if _measures(other, allowed)), "")


def _measures(unit: str, allowed: tuple[str, ...]) -> bool:
    """True if the unit converts to one of these SI units."""
    if unit in PLAIN or not _UNIT.fullmatch(unit):
        return unit in PLAIN and PLAIN[unit][1] in allowed
    with suppress(Exception):  # pint raises its own errors, AttributeError and tokenizer errors alike
        registry = _registry()
        bases = [registry.get_base_units(registry.Unit(symbol))[1] for symbol in allowed]
        return registry.get_base_units(registry.Unit(unit))[1] in bases
    return False


def _instead(unit: str, allowed: tuple[str, ...], *, velocity: bool) -> str:
    """Advice in place of a unit of another dimension, such as that of a velocity."""
    if unit.endswith("Nm") and "N·m" in allowed:
        return f"; write {unit.replace('Nm', 'N*m')!r}"
    if allowed == DISPLACEMENT and velocity:
        return "; a velocity is no q: integrate it, or give it as `qdot` beside a measured q"
    return {
        DISPLACEMENT: "; if these are steps or volts of a sensor, give `scale` too: the length or angle of one, in "
        "that unit; a temperature or another quantity goes as 'V', which stands for it",
        (MASS["rad"],): ": q is an angle; for that of a joint set plant.parameters too, else give the inertia in "
        "'g*m^2', or leave the mass out",
        INPUT: "; write '1' for the numbers of any other input",
    }.get(allowed, "")


def parse_quantity(text: str, allowed: tuple[str, ...], where: str) -> float:
    """A number with its unit, such as ``23mm`` or ``3 kV``, in SI.

    Raises
    ------
    InputError
        No number, no unit, or a unit of another kind.
    """
    if (number := _NUMBER.match(text)) is None:
        raise InputError(f"{where}: {text!r} is no number with a unit, such as '23mm' or '3 kV'")
    value = float(number[0])
    unit = text[number.end() :].strip()
    if not unit:
        if allowed == ("1",) or value == 0.0:
            return value
        raise InputError(f"{where}: {text!r} has no unit; write for example '{number[0]} {allowed[0]}'")
    if unit.startswith(","):
        raise InputError(
            f"{where}: {text!r} has a comma; numbers have a decimal point, as {text.replace(',', '.', 1)!r}"
        )
    return value * to_si(unit, allowed, where).factor


def signal_units(displacement: str) -> dict[str, str]:
    """SI unit of each of `SIGNALS`, by that of the displacement."""
    return {"q": displacement, "phi": "rad", "qdot": f"{displacement}/s", "qddot": f"{displacement}/s²"}


def column_suffix(symbol: str) -> str:
    """A unit as the end of a column's name: ``N·s/m`` → ``N_s_per_m``, ``m/(s²·V²)`` → ``m_per_s2_V2``."""
    plain = symbol.replace(")²", ")_squared").replace("/", "_per_").replace("·", "_")
    return plain.translate(str.maketrans("²³⁴", "234", "^()"))
