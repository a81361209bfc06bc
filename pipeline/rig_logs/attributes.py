"""Attributes of logs of any format: the unit of a channel, a sample rate, a scale."""

import math
import re
from collections.abc import Mapping
from contextlib import suppress
from typing import Any

import numpy as np

from ..errors import InputError
from ..units.units import SECONDS, parse_quantity, time_unit

NOT_APPLIED = "not applied here"
"""Words in a note on a number that looks like a calibration."""
_UNIT = re.compile(r"(?i)(eng(ineering)?[ _]?)?units?|unit[ _]?(string|label|text)|ni_unitdescription|einheit(en)?")
_OFFSET = "offset|intercept|y_?(org|origin|off|zero)"
_SCALE = re.compile(
    rf"(?i)(.*[./_])?((scale|scaling|conversion|calibration)([ _]?(factor|coefficient|slope|{_OFFSET}))?|gain|slope|"
    rf"factor|{_OFFSET}|y_?(inc(rement)?|mult)|multiplier|sensitivity|calib\w*|lsb)"
)
"""Names by which a number might have to be converted, if no convention says how."""
_DESCRIPTION = re.compile(
    r"(?i)desc(ription)?|comments?|long_?name|labels?|beschreibung|kommentar|ni_channeldescription"
)
_RATIO = re.compile(
    r"(?<![\d:.])(?:1 ?: ?(\d{3,6})|(\d{3,6}) ?: ?1)(?![\d:])|\b1 ?V ?(?:=|/|per) ?(\d*) ?kV\b|(?<![\w.])(\d*) ?kV/V\b"
)
_START = re.compile(r"(?i)(.*[./])?([tx]_?0|x_?(org|origin|zero)|((wf|x)_?)?(start|begin)(_?(time|offset))?)")

_SAMPLING = "(samp(l(e|ing))?|scan|acquisition|abtast|measuring)[_ ]?"
OF_SAMPLING = (
    "d[eio]?[ '’]([^ '’]*chantillonnage|acquisition|muestreo|campionamento|amostragem)"  # in Romance languages
)
_RATE = re.compile(
    rf"(?i)(.*[./])?(f_?s(amp(l(e|ing))?)?|s_?r|sps|((daq|data|log(ging)?|mess|record(ing)?|update)[_ ]?|s)?rate|"
    rf"samples?([_ ]?per[_ ]?|/)s(ec(ond)?)?|{_SAMPLING}(rate|freq(uency)?|frequenz)|"
    rf"(taux|cadence|ta[sx]a|fr[^ ]+) {OF_SAMPLING})"
)
_STEP = re.compile(
    rf"(?i)(.*[./])?(t_?s(amp(l(e|ing))?)?|dt|delta[_ ]?[xt]|((x|wf)[_ ]?)?increment|[tx]_?inc|"
    rf"t(ime)?[_ ]?(step|interval)|{_SAMPLING}(time|interval|period|step|cycle|intervall|zeit)|"
    rf"(interval|[pt])[^ ]+ {OF_SAMPLING})"
)
"""Names of single numbers that say how often a log was sampled …"""
_FREQUENCY = re.compile(r"(?i)(.*[./])?(freq(uency)?|frequenz)")
_PERIOD = re.compile(r"(?i)(.*[./])?period(e|endauer)?")
"""… or what happens that often …"""
_WITH_UNIT = re.compile(r"(?i)(?P<name>.*?)[_ ]+[\[(]?(?P<unit>k?hz|[mu]?s)[\])]?")
"""… and a unit behind such a name."""
GROUP_OF = re.compile(r"(^|[./])[^./]*$")
"""Last part of a name, behind its group."""
_PER_SECOND = re.compile(r"(?i)(s|sa|samples)(/| per )s(ec(ond)?)?$|sps$")  # other names of Hz


def stated_rate(name: str, number: float) -> float | None:
    """Sample rate [Hz] that a single number of this name states, as `fs` [Hz], `Ts` [s] or `dt_ms`; None for others."""
    return _rate(name, number, _RATE, _STEP)


def possible_rate(name: str, number: float) -> float | None:
    """Frequency [Hz] that a single number of this name states, as `frequency` or `period_us`; None for others."""
    return _rate(name, number, _FREQUENCY, _PERIOD)


def _rate(name: str, number: float, rates: re.Pattern[str], steps: re.Pattern[str]) -> float | None:
    if not 0.0 < number < math.inf:
        return None
    unit = _WITH_UNIT.fullmatch(name)
    if unit and not (rates.fullmatch(name) or steps.fullmatch(name)):
        name = unit["name"]
        number *= SECONDS.get(unit["unit"].lower(), 1000.0 if unit["unit"].lower() == "khz" else 1.0)
    rate = number if rates.fullmatch(name) else 1.0 / number if steps.fullmatch(name) else math.inf
    return rate if rate < math.inf else None


def note_on_rate(name: str, number: float, rate: float) -> str:
    """Note on a number that states a sample rate [Hz], which a log without a time channel needs."""
    return f"{name} is {number:g}; without a time channel perhaps [ingest] sample_rate = {rate:.9g}"


def rates_beside(channel: str, rates: Mapping[str, float]) -> Mapping[str, float]:
    """The rates that stand in the group of a channel, else in the nearest one around it; all where none does."""
    group = channel
    while group:
        group = GROUP_OF.sub("", group)
        if beside := {name: rate for name, rate in rates.items() if GROUP_OF.sub("", name) == group}:
            return beside
    return rates


def plain(value: Any) -> Any:
    """An attribute without the array of one element that may be around it, bytes as text."""
    single = np.asarray(value).reshape(-1)[0] if np.size(value) == 1 else value
    return single.decode("utf-8", "replace") if isinstance(single, bytes) else single


def unit_among(attributes: Mapping[str, Any], column: int = 0, columns: int = 1) -> str:
    """The unit that attributes state, of one of several columns where they name as many units; "" where none does."""
    for name in filter(_UNIT.fullmatch, attributes):
        value = attributes[name]
        text = plain(np.asarray(value).reshape(-1)[column] if np.size(value) == columns > 1 else value)
        if isinstance(text, str):
            return str(text)
    return ""


def description_among(attributes: Mapping[str, Any]) -> str:
    """Description of a channel among its attributes, on one line; "" where none has one."""
    texts = (plain(attributes[name]) for name in filter(_DESCRIPTION.fullmatch, attributes))
    return next((" ".join(text.split()) for text in texts if isinstance(text, str) and text.strip()), "")


def texts_among(attributes: Mapping[str, Any]) -> str:
    """All attributes that are texts, as one line."""
    return "; ".join(" ".join(text.split()) for text in map(plain, attributes.values()) if isinstance(text, str))


def monitor_ratio(*texts: str) -> float:
    """Volts that 1 V of a monitor stands for, by the first text that states it (1:1000, 1 kV/V); else 1."""
    for text in texts:
        if match := _RATIO.search(text):
            return float(match[1] or match[2] or 1000.0 * float(match[3] or match[4] or 1.0))
    return 1.0


def rates_among(attributes: Mapping[str, Any], place: str) -> dict[str, tuple[float, float]]:
    """Numbers among attributes that state or may state a sample rate, and it [Hz], by names; `place` before these."""
    rates = {}
    for name in attributes:
        rate_of = stated_rate if stated_rate(name, 1.0) is not None else possible_rate
        number = _number(attributes[name], quantity=True) if rate_of(name, 1.0) is not None else None
        if number is not None and (rate := rate_of(name, number)) is not None:
            rates[f"{place}.{name}" if place else name] = (number, rate)
    return rates


def starts_among(attributes: Mapping[str, Any], place: str) -> dict[str, float]:
    """Numbers among attributes that state when a channel begins [s], by their names; `place` stands before these."""
    return {
        f"{place}.{name}" if place else name: number
        for name in filter(_START.fullmatch, attributes)
        if (number := _number(attributes[name])) is not None
    }


def is_unit(name: str) -> bool:
    """True if an attribute of this name states a unit."""
    return bool(_UNIT.fullmatch(name))


def scales_among(attributes: Mapping[str, Any], channel: str = "") -> list[str]:
    """A note on numbers among attributes by which a channel might have to be converted; none where there are none."""
    named = []
    for name in filter(_SCALE.fullmatch, attributes):
        number = _number(attributes[name])
        neutral = 0.0 if re.search(_OFFSET, name, re.IGNORECASE) else 1.0
        named += [f"{name} = {plain(attributes[name])}"] if number != neutral else []
    what = f"{', '.join(named)}, {NOT_APPLIED}" + (f" to {channel!r}" if channel else "")
    return [f"{what}: see scale and offset in [channels]"] if named else []


def _number(value: Any, *, quantity: bool = False) -> float | None:
    """A number, which may be a text; as a quantity also one with a unit of frequency or time, in Hz or s."""
    text = plain(value)
    if quantity and isinstance(text, str):
        return number_with_unit(text, "") or None
    try:
        return float(text)
    except (ValueError, TypeError):
        return None


def number_with_unit(text: str, unit: str) -> float:
    """A number, in Hz or s if it or its name has a unit; 0 for anything else."""
    bare = _PER_SECOND.sub("Hz", text.strip().replace(",", "."))
    for written in (f"{bare} {time_unit(unit) or unit}", bare):
        with suppress(InputError):
            return parse_quantity(written, ("Hz", "s"), "")
    try:
        return float(bare)
    except ValueError:
        return 0.0
