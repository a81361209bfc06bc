"""Which channel might be what, by unit and name; suggestions for a person, nothing decides on them."""

import re
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

Role = Literal["time", "q", "v1", "v2"]

TIME_UNITS = {"s": 1.0, "sec": 1.0, "ms": 1e-3, "us": 1e-6, "µs": 1e-6, "μs": 1e-6, "ns": 1e-9, "min": 60.0}
"""Seconds per unit of a time column."""
_DISPLACEMENT_UNITS = ("m", "mm", "cm", "um", "µm", "μm", "nm", "deg", "°", "rad", "mrad")
_INPUT_UNITS = ("v", "kv", "mv", "a", "ma", "%", "pct", "n")
_PINT_NAMES = {"pct": "percent", "%": "percent", "°": "deg", "μm": "um", "sec": "s", "μs": "us"}
_WORDS: dict[str, re.Pattern[str]] = {
    "time": re.compile(r"^(t|time|zeit|tempo|temps|timestamp)([ _.\[(].*)?$", re.IGNORECASE),
    "q": re.compile(
        r"(laser|weg|dist|displ|posi|angle|angul|winkel|saida|ild|^q$|[ _.]q$|^q[ _.])",
        re.IGNORECASE,
    ),
    "v": re.compile(r"(^hv|volt|spannung|tens|^u[ _\d]|control|[ _.]u$|umeas|^v\d|^u$)", re.IGNORECASE),
}
_LEFT = re.compile(r"(left|links|[^\d]1([^\d]|$))", re.IGNORECASE)
_RIGHT = re.compile(r"(right|rechts|[^\d]2([^\d]|$))", re.IGNORECASE)
_NAME_SUFFIX = re.compile(r"[_ ](?P<unit>[A-Za-zµμ%°]+)$")


@dataclass(frozen=True)
class Suggestion:
    """Channels that might play a role.

    Attributes
    ----------
    role : {"time", "q", "v1", "v2"}
        The role in the settings.
    candidates : tuple of str
        Names of the channels that might be meant; exactly one if there is no doubt.
    """

    role: Role
    candidates: tuple[str, ...]

    @property
    def only(self) -> str | None:
        """The one candidate, None where there are none or several."""
        return self.candidates[0] if len(self.candidates) == 1 else None


def suggested_unit(name: str, unit: str) -> str:
    """The log's unit, or what a suffix of the name says (``angulo_deg``), in pint's notation; "" if neither does."""
    bare = unit.strip("[]() ")
    if not bare:
        match = _NAME_SUFFIX.search(name)
        known = (*TIME_UNITS, *_DISPLACEMENT_UNITS, *_INPUT_UNITS)
        bare = match["unit"] if match and match["unit"].lower() in known else ""
    return _PINT_NAMES.get(bare.lower(), bare)


def suggest(channels: Sequence[tuple[str, str]], *, own_time: bool) -> tuple[Suggestion, ...]:
    """Suggestions for the roles.

    Parameters
    ----------
    channels : sequence of (name, unit)
        The channels of the log, time bases left out where the format has them.
    own_time : bool
        Whether the format carries its own time base, so that none has to be named.
    """
    units = {name: suggested_unit(name, unit) for name, unit in channels}
    names = list(units)
    times = tuple(name for name in names if _WORDS["time"].search(name) and units[name] in ("", *TIME_UNITS))
    rest = [name for name in names if name not in times]
    found = [] if own_time else [Suggestion("time", times)]
    found.append(Suggestion("q", _best(rest, units, _DISPLACEMENT_UNITS, "q")))
    inputs = _best(rest, units, _INPUT_UNITS, "v")
    left = tuple(name for name in inputs if _LEFT.search(name) and not _RIGHT.search(name))
    right = tuple(name for name in inputs if _RIGHT.search(name) and not _LEFT.search(name))
    if len(left) == 1 and len(right) == 1:
        return (*found, Suggestion("v1", left), Suggestion("v2", right))
    return (*found, Suggestion("v1", inputs), Suggestion("v2", () if len(inputs) == 1 else inputs))


def _best(names: list[str], units: dict[str, str], wanted: tuple[str, ...], word: str) -> tuple[str, ...]:
    """Channels with a fitting unit and a fitting name; else with either."""
    pint_names = {_PINT_NAMES.get(unit, unit).lower() for unit in wanted}
    by_unit = [name for name in names if units[name].lower() in pint_names]
    by_name = [name for name in names if _WORDS[word].search(name)]
    both = [name for name in by_unit if name in by_name]
    return tuple(both or by_unit or by_name)
