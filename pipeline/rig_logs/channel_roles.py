"""Suggested roles of a log's channels, by name, unit and length.

Suggestions are for a person; nothing decides on them.
"""

import re
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Literal

from ..units.units import SECONDS, time_unit
from .attributes import GROUP_OF

Role = Literal["time", "q", "v1", "v2"]

_DISPLACEMENT_UNITS = ("m", "mm", "cm", "um", "µm", "μm", "nm", "deg", "°", "rad", "mrad")
_INPUT_UNITS = ("V", "kV", "mV", "A", "mA", "%", "pct", "N")
_PINT_NAMES = {
    "pct": "percent", "%": "percent", "°": "deg", "degree": "deg", "degrees": "deg", "μm": "um",
    "volt": "V", "volts": "V", "ampere": "A", "amperes": "A",
}  # fmt: skip
_SIGNAL = r"(^|[./]){}(_?(dat|data|id|ident|train|meas|val|valid|test)|(?-i:[A-Z])\w*|\d*)([(\[]:,\d+[)\]])?$"
"""The output y and the input u of identification, such as ``data.ydat(:,1)``, ``yEst``, ``run/u``."""
_WORDS: dict[str, re.Pattern[str]] = {
    "time": re.compile(r"^(t|time|zeit|tempo|temps|timestamp|clock|uhr|x[ _]value)\d?([ _.\[(/].*)?$", re.IGNORECASE),
    "q": re.compile(
        r"(laser|weg|dist|displ|pos|angle|angul|winkel|saida|ild|theta|phi|tilt|pitch|level|pegel|height|gap|stroke|"
        r"encoder|^[xyq]$|[ _.]q$|^q[ _./]|" + _SIGNAL.format("y") + ")",
        re.IGNORECASE,
    ),
    "v": re.compile(
        r"(^hv|volt|spannung|tens|^u[ _/\d]|control|[ _.]u$|umeas|^v\d|^[uvi]( \(\d+\))?$|pwm|duty|"
        r"cmd|command|current|strom|"
        r"torque|throttle|motor|pump|valve|ventil|heater|" + _SIGNAL.format("u") + ")",
        re.IGNORECASE,
    ),
}
_WANTED = re.compile(r"(ref|soll|set.?point|target|desired)", re.IGNORECASE)
"""Names of what a controller wants: neither a displacement nor an input."""
_LEFT = re.compile(r"(left|links|[^\d]1([^\d]|$)|[ _.-]l$)", re.IGNORECASE)
_RIGHT = re.compile(r"(right|rechts|[^\d]2([^\d]|$)|[ _.-]r$)", re.IGNORECASE)
_MOST_INPUTS = 2
_CLOCK = re.compile(r"t|time|zeit|timestamp|clock|xvalue", re.IGNORECASE)
"""Rest of the name of a clock that is named after its channel …"""
_BETWEEN_WORDS = re.compile(r"[\W_]+")
"""… without this."""
_NAME_SUFFIX = re.compile(r"(?:[_ \[(]|\s*/\s*)(?P<unit>[A-Za-zµμ%°]+)[\])]?$")


@dataclass(frozen=True)
class Suggestion:
    """Channels that might play a role.

    Attributes
    ----------
    role : {"time", "q", "v1", "v2"}
        The role in the settings.
    candidates : tuple of str
        Names of the channels that might be meant; exactly one if there is no doubt.
    clock : str
        Its own column of time, where the log has several; "" where it has not.
    """

    role: Role
    candidates: tuple[str, ...]
    clock: str = ""

    @property
    def only(self) -> str | None:
        """The one candidate, None where there are none or several."""
        return self.candidates[0] if len(self.candidates) == 1 else None


def suggested_unit(name: str, unit: str) -> str:
    """The log's unit, or the one behind the name (``q_mm``, ``q [mm]``), in pint's notation; "" without any."""
    match = _NAME_SUFFIX.search(name)
    bare = unit.strip("[]() ") or (_spelt(match["unit"]) if match else "")
    return time_unit(bare) or _PINT_NAMES.get(bare.lower(), bare)


def _spelt(unit: str) -> str:
    """A unit that stands at the end of a name, in its right letters (KV is kV); "" where it is none."""
    units = (*SECONDS, *_DISPLACEMENT_UNITS, *_INPUT_UNITS)
    if unit in units:
        return unit
    return next(
        (
            spelling
            for spelling in units
            if spelling.lower() == unit.lower() and (len(spelling) > 1 or spelling.isupper())
        ),
        "",
    )


def suggest(
    channels: Sequence[tuple[str, str]],
    *,
    own_time: bool,
    rising: Sequence[str] = (),
    counts: Mapping[str, int] | None = None,
    described: Mapping[str, str] | None = None,
) -> tuple[Suggestion, ...]:
    """Suggestions for the roles.

    Parameters
    ----------
    channels : sequence of (name, unit)
        The channels of the log, time bases left out where the format has them.
    own_time : bool
        True if the format carries its own time base, so that none has to be named.
    rising : sequence of str
        Channels that rise by equal steps; a single one may be the time, if no other is called so.
    counts : mapping of str to int, optional
        Samples of each channel where they are all of one raster: those of one record have equally many.
    described : mapping of str to str, optional
        Text of the log beside a channel, which counts where no name suffices.
    """
    words = {name: (described or {}).get(name, "") for name, _ in channels}
    sizes = dict.fromkeys((name for name, _ in channels), 0) | dict(counts or {})
    units = {name: suggested_unit(name, unit) for name, unit in channels}
    names = list(units)
    times = _times(channels, units, rising)
    clocks = _clocks(names, times, sizes)
    several = len(set(clocks.values())) > 1
    spare = [time for time in times if time not in clocks.values() and sizes[time] in map(sizes.get, clocks.values())]
    times = tuple(time for time in times if time in clocks.values() or time in spare)
    rest = [name for name in names if name in clocks and name not in rising and not _WANTED.search(name)]
    suggestions = [] if own_time else [Suggestion("time", times)]
    q = _best(rest, units, _DISPLACEMENT_UNITS, "q", words)
    alike = [name for name in rest if len(q) == 1 and sizes[name] == sizes[q[0]]]
    rest = [name for name in rest if name in alike or not alike or clocks[name] != clocks[q[0]]]
    inputs = _best([name for name in rest if q != (name,)], units, _INPUT_UNITS, "v", words)
    left_over = tuple(name for name in rest if name not in (*q, *inputs) and not units[name])
    if not q and len(left_over) == 1:
        q = left_over
    elif not inputs and len(left_over) <= _MOST_INPUTS and len(q) == 1:
        inputs = left_over
    left = _on_side(inputs, _LEFT, _RIGHT, words)
    right = _on_side(inputs, _RIGHT, _LEFT, words)
    if len(left) == 1 and len(right) == 1 and (q or len(inputs) == _MOST_INPUTS):
        suggestions += [Suggestion("q", q), Suggestion("v1", left), Suggestion("v2", right)]
    else:
        suggestions += [
            Suggestion("q", q),
            Suggestion("v1", inputs),
            Suggestion("v2", () if len(inputs) == 1 else inputs),
        ]
    if not several or spare:
        return tuple(suggestions)
    return tuple(replace(each, clock=clocks.get(each.only or "", "")) for each in suggestions)


def _times(channels: Sequence[tuple[str, str]], units: Mapping[str, str], rising: Sequence[str]) -> tuple[str, ...]:
    """Columns that might be a time: rising ones with such names and units, else the only one that rises."""
    called = [
        name
        for name, unit in channels
        if is_called("time", name) and (units[name] in ("", *SECONDS) or (name in rising and not unit))
    ]
    times = called or [name for name in units if units[name] in SECONDS]
    times = [name for name in times if name in rising] or times  # T beside t is a temperature
    return tuple(times or ([name for name in rising if not units[name]] if len(rising) == 1 else []))


def _clocks(names: Sequence[str], times: Sequence[str], sizes: Mapping[str, int]) -> dict[str, str]:
    """The time column over which each channel may run, of as many samples.

    It is the one that is called after the channel (``t_q``, ``q_time``), else that of its group, else the last before.
    Where the columns end with a time and do not begin with one, it is the first behind instead of the last before.
    """
    clocks: dict[str, str] = {}
    behind = len(times) > 1 and names[0] not in times and names[-1] in times
    for i, name in enumerate(names):
        alike = [time for time in times if sizes[time] == sizes[name]]
        grouped = [
            time for time in alike if GROUP_OF.sub("", name) and GROUP_OF.sub("", time) == GROUP_OF.sub("", name)
        ]
        near = [time for time in alike if time in names[i:]][:1] if behind else [t for t in alike if t in names[:i]]
        called = [time for time in alike if _after(time, name)]
        if name not in times and (alike or not times):
            clocks[name] = (called[-1:] or grouped[-1:] or near[-1:] or alike[:1] or [""])[0]
    return clocks


def clocks_beside(names: Sequence[str], time: str, in_time: Collection[str] = ()) -> dict[str, str]:
    """The column of time over which each channel may run; empty where there are fewer than two.

    They are called so or as `time`, or are of those `in_time` units. One behind all channels may be that of each.
    """
    times = [
        name
        for name in names
        if is_called("time", name)
        or name in in_time
        or time in (name, name.rpartition(" (")[0])
        or any(_after(name, o) for o in names)
    ]
    clocks = _clocks(names, times, dict.fromkeys(names, 0)) if len(times) > 1 else {}
    return dict.fromkeys(clocks, times[-1]) if {*clocks.values()} == {time} else clocks


def _after(clock: str, channel: str) -> bool:
    """True if a column is named after a channel as its time."""
    rest = _BETWEEN_WORDS.sub("", clock.casefold().replace(channel.casefold(), "", 1))
    return channel != clock and channel.casefold() in clock.casefold() and bool(_CLOCK.fullmatch(rest))


def _on_side(
    names: Sequence[str], side: re.Pattern[str], other: re.Pattern[str], words: Mapping[str, str]
) -> tuple[str, ...]:
    """The inputs of one side, by their names, else by the texts beside them."""

    def of(texts: Mapping[str, str]) -> tuple[str, ...]:
        """The inputs whose text names this side only."""
        return tuple(name for name in names if side.search(texts[name]) and not other.search(texts[name]))

    by_name = of({name: name for name in names})
    return by_name if len(by_name) == 1 else of(words) or by_name


def _best(
    names: list[str], units: dict[str, str], wanted: tuple[str, ...], word: str, words: Mapping[str, str]
) -> tuple[str, ...]:
    """Channels with a fitting unit and a fitting name, else with a fitting text beside them, else with either."""
    pint_names = {_PINT_NAMES.get(unit, unit).lower() for unit in wanted}
    by_unit = [name for name in names if units[name].lower() in pint_names]
    by_name = [name for name in names if is_called(word, name)]
    by_name = by_name or [name for name in names if words[name] and is_called(word, words[name])]
    return tuple([name for name in by_unit if name in by_name] or by_unit or by_name)


def is_called(word: str, name: str) -> bool:
    """True if a channel, or the last part of its path, has a usual name of "time", "q" or "v"."""
    return any(map(_WORDS[word].search, (name, re.split(r"[./]", name)[-1])))
