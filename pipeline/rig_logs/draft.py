"""A first settings file for a raw log: what is certain is filled in, everything else is left to the user."""

import re
from collections.abc import Sequence
from itertools import chain
from pathlib import Path
from typing import Literal

import numpy as np

from ..errors import InputError
from ..settings.prototype import Ingest
from ..signals.findings import COARSEST_STEP, MOST_REPEATED, UNTOLD_STEP
from ..signals.noise import LEAST_PER_PERIOD, advised_interval
from ..signals.signal_quality import BOTH_SIGNS, SignalQuality, takes_both_signs
from ..signals.timebase import seldom
from ..system.names import check_log_name, check_name, log_name, slug, true_name
from ..units.units import DISPLACEMENT, FILL_IN, SECONDS, to_si
from .attributes import monitor_ratio, rates_beside
from .channel_roles import Role, Suggestion, suggested_unit
from .inspection import NO_CHANNEL, InspectedChannel, Inspection
from .source import as_other_logs

Purpose = Literal["train", "validation", "test", ""]

_BETWEEN_WORDS = re.compile(r"[\W\d_]+|(?<=[a-zäöüß])(?=[A-ZÄÖÜ])")
"""What separates words: other characters, or the place between a small and a large letter, as in ``trainData``."""
_OF_DATA = "(data|daten|set|log|logs|run|lauf)?"
_WORDS: dict[Purpose, re.Pattern[str]] = {
    "validation": re.compile(rf"val{_OF_DATA}|valid\w*", re.IGNORECASE),
    "test": re.compile(rf"test{_OF_DATA}|tests|testing|prüf\w*|pruef\w*|check|holdout|unseen", re.IGNORECASE),
    "train": re.compile(r"train\w*|ident|identif\w*|fit|lern\w*", re.IGNORECASE),
}
_HELD_OUT: tuple[set[Purpose], ...] = ({"validation", "test"}, {"validation"})
_WAYS_OUT = {
    "time": "; without one, leave this line out and see sample_rate",
    "q": "; a length, an angle, or V of a circuit",
}
"""What stands behind a role that no channel has."""
_MOST_LISTED = 100
_MOST_NAMED = 5
_LONGEST = 80
"""Letters of a description that are shown."""
_MONITOR = 12.0
"""Largest voltage [V] of a monitor, beyond the 10 V of its full range."""
_ALIKE = 0.8
"""Smaller over larger magnitude of an input's two signs from which it takes both alike."""
_VELOCITY = re.compile(r"dot$|(?<!le)vel|speed|geschw|_dt$", re.IGNORECASE)
_RATE = re.compile(r"(?<!/s)/s$|^rpm$", re.IGNORECASE)
_BETWEEN = re.compile(r"[_\-. ]+|(?<=[a-zäöüß])(?=[A-ZÄÖÜ])")  # words of a file's name


def purpose_of(word: str) -> Purpose:
    """Purpose of data that a word names, "" for any other word."""
    return next((purpose for purpose, pattern in _WORDS.items() if pattern.fullmatch(word)), "")


def purposes(name: str) -> set[Purpose]:
    """Purposes of data that the words of a name state."""
    return {purpose_of(word) for word in _BETWEEN_WORDS.split(name)} - {""}


def toml_draft(inspections: Sequence[Inspection], logs: Sequence[str] | None = None, folder: str = "this file") -> str:
    """The text of a prototype file for these logs of one device.

    Parameters
    ----------
    inspections : sequence of Inspection
        Contents of the logs; the channels are taken from the first.
    logs : sequence of str, optional
        The logs' paths as they shall stand in the file, relative to where the file is saved; their names by default.
    folder : str
        Base of these relative paths, in words.

    Returns
    -------
    str
        TOML. Every channel is listed in comments. A role with one candidate is filled in and marked as a suggestion. A
        role with several, and every unit that the log does not state, holds `FILL_IN`, which no log and no unit
        registry knows.

    Raises
    ------
    InputError
        The first log holds no channel, or another one lacks channels of it: they are not of one recorder.
    """
    first = inspections[0]
    if not first.channels:
        raise InputError(": ".join((f"{first.path}: {NO_CHANNEL}", *filter(None, ["; ".join(first.notes)]))))
    by_name = {channel.name: channel for channel in first.channels}
    _check_same_channels(inspections)
    train, validation = proposed_roles(logs or [inspection.path.name for inspection in inspections])
    named = " and ".join(quoted(inspection.path.name) for inspection in inspections)
    own = "suggested" if len(inspections) > 1 else "a log that no identification sees; record one"
    lines = [
        f"# A starting point for {named} ({first.format}).",
        f'# Nothing here has been decided: replace every "{FILL_IN}" and check what is marked as suggested.',
        "# `debist check` then says whether the logs are what this file says.",
        "#",
        "# Channels of the log:",
        *_listings(first),
        "",
        f"name = {quoted(_prototype_name(first.path))}",
        "",
        f"[logs]                                        # paths relative to {folder}",
        f"train = [{', '.join(map(quoted, train))}]",
        f"validation = [{', '.join(map(quoted, validation))}]  # {own}",
        *_refused_names(train, validation),
        "",
        "[channels]                                    # channel in the log, and the unit of its numbers",
    ]
    if first.own_time:
        lines.append("# time is left out: the format carries its own time base")
    for suggestion in first.suggestions:
        if suggestion.role == "time" and not suggestion.candidates and (first.rates or not _left_over(first)):
            lines.append(
                f"# time is left out: the log {'states its rate' if first.rates else 'has none'}; see sample_rate"
            )
        else:
            lines += _role_lines(suggestion, by_name, first)
    lines += _velocity_lines(first)
    # What a log holds is quoted where TOML reads it; in comments its control characters are written out, as here.
    return "\n".join(map(_plain_line, [*lines, "", *_plant_lines(first), *_ingest_lines(first)])) + "\n"


def _refused_names(*roles: Sequence[str]) -> list[str]:
    """Comment lines on names of logs that a run would refuse."""
    lines = []
    for logs in roles:
        names = [log_name(log).casefold() for log in logs]
        twice = [log for log, name in zip(logs, names, strict=True) if names.count(name) > 1]
        lines += (
            [f"# {_plain(' and '.join(twice))} have one name, by which a run files them: rename one"] if twice else []
        )
    for log in chain.from_iterable(roles):
        try:
            check_log_name(log)
        except ValueError as error:
            lines.append(f"# {_plain(f'{error}')}")
    return lines


def _check_same_channels(inspections: Sequence[Inspection]) -> None:
    """Refuse logs that lack channels of the first one."""
    first = {channel.name for channel in inspections[0].channels}
    for other in inspections[1:]:
        names = [channel.name for channel in other.channels]
        if lacking := sorted(first.difference(names)):
            way_out = as_other_logs(lacking[0], names) or "give both the same header, or make a settings file for each"
            raise InputError(
                f"{other.path}: has no channel {lacking[0]!r}, which {inspections[0].path} has; a settings file is for "
                f"logs with the same channels: {way_out}"
            )


def _listings(log: Inspection) -> list[str]:
    """The channels of a log, and what its reader found out."""
    lines = [_listing(channel) for channel in log.channels[:_MOST_LISTED]]
    if len(log.channels) > _MOST_LISTED:
        lines.append(f"#   … and {len(log.channels) - _MOST_LISTED} more")
    return [*lines, *(f"# {_plain(note)}" for note in log.notes)]


def _left_over(log: Inspection) -> list[str]:
    """Channels of the record that no role is suggested for."""
    taken = {name for suggestion in log.suggestions for name in suggestion.candidates}.union(log.apart)
    return [channel.name for channel in log.channels if channel.name not in taken]


def _velocity_lines(log: Inspection) -> list[str]:
    """A channel that is called a velocity, left out: derivatives and fits would rest on it as well."""
    taken = {suggestion.only for suggestion in log.suggestions}.union(log.apart)
    units = {channel.name: channel.unit.strip("[]() ") for channel in log.channels if channel.name not in taken}
    called = [name for name, unit in units.items() if _RATE.search(unit) or (not unit and _VELOCITY.search(name))]
    return [
        f"# {_entry('qdot', name, units[name] or FILL_IN)}  # where that is q's measured velocity"
        for name in called[:1]
    ]


def proposed_roles(logs: Sequence[str]) -> tuple[list[str], list[str]]:
    """Training logs and validation logs, by the words of their names; else the last validates.

    Where every log is called a test, only those validate that are called validation logs; where all are called so, all
    but the first.
    """
    by_log = [purposes(true_name(log)) for log in logs]
    called = [[log for log, each in zip(logs, by_log, strict=True) if each & wanted] for wanted in _HELD_OUT]
    validation = next((some for some in called if len(some) < len(logs)), list(logs[1:]))
    if not validation and len(logs) > 1 and "train" not in by_log[-1]:
        validation = [logs[-1]]
    return [log for log in logs if log not in validation], validation


def _plant_lines(log: Inspection) -> list[str]:
    """The mass stays open, and the parameter set out: the model is as good without one, for any joint.

    An input that takes both signs may act by its square or in proportion; one that takes both alike hardly by its
    square, under which they would be the same.
    """
    names = {suggestion.only for suggestion in log.suggestions if suggestion.role in ("v1", "v2")}
    inputs = [channel.quality for channel in log.channels if channel.name in names]
    largest = max((each.span for each in inputs), default=0.0)
    inputs = [each for each in inputs if each.span > BOTH_SIGNS * largest]  # noise takes both signs too
    both_signs = any(takes_both_signs(each.smallest, each.largest) for each in inputs)
    alike = any(min(-each.smallest, each.largest) >= _ALIKE * max(-each.smallest, each.largest) for each in inputs)
    action = "linear" if alike else "squared"
    why = "the input takes both signs: `debist check` compares the two" if both_signs else "a force-like input"
    return [
        "[plant]",
        '# mass = { value = 40.5, unit = "g" }         # moving mass, for forces in newtons; else per kilogram',
        f'{f"inputs = {quoted(action)}":<46}# "squared" (electrostatic) or "linear" ({why})',
        '# parameters = "nominal"                      # the DE joint as drawn: analytical models, φ, or q from φ',
    ]


def _ingest_lines(log: Inspection) -> list[str]:
    """The rate of a log without time, and the step of one that is slower than the usual sample interval."""
    time = next((suggestion for suggestion in log.suggestions if suggestion.role == "time"), None)
    coarse = any(base.repeated > MOST_REPEATED * base.n for base in log.time_bases)
    if coarse or (time is not None and not time.candidates):
        return ["", "[ingest]", *_rate_lines(log)]
    channel = None if time is None else next((each for each in log.channels if each.name == time.only), None)
    if channel is not None and suggested_unit(channel.name, channel.unit) not in SECONDS:
        return []
    lines = _interval_lines(log, min((base.step for base in log.time_bases), default=np.nan))
    return ["", "[ingest]", *lines] if lines else []


def _interval_lines(log: Inspection, step: float) -> list[str]:
    """The sample interval where a log's step [s] is longer than the usual one, or q moves too fast for that."""
    usual = Ingest().sample_interval
    most = _cycles_per_sample(log) / step
    if step > UNTOLD_STEP * usual:
        interval = float(f"{step:.4g}")
        why = "the log's step"
    elif most * usual * LEAST_PER_PERIOD > 1.0:
        interval = advised_interval(most, step)
        why = f"q moves up to {most:.3g} Hz"
    else:
        return []
    return [f"{f'sample_interval = {interval:g}':<46}# s, suggested: {why}"]


def _cycles_per_sample(log: Inspection) -> float:
    """Bandwidth of the channel suggested for q, in cycles per sample; NaN where none is, or it is only noise."""
    q = next((suggestion.only for suggestion in log.suggestions if suggestion.role == "q"), None)
    channel = next((each for each in log.channels if each.name == q), None)
    if channel is None or channel.quality.idle:
        return float("nan")
    return channel.quality.band.most * (1.0 if channel.time_base is None else log.time_bases[channel.time_base].step)


def _rate_lines(log: Inspection) -> list[str]:
    """The sample rate that the log states beside q, or that is to be filled in."""
    where = "Hz; for a log without time, in place of `time` under [channels]"
    if not log.rates:
        rate = f"sample_rate = {quoted(FILL_IN)}"
        return [f"{f'# {rate}' if _left_over(log) else rate:<46}# {where}"]
    stated = rates_beside(next((each.only for each in log.suggestions if each.role == "q"), None) or "", log.rates)
    if len(set(stated.values())) > 1:
        rates = ", ".join(f"{name} says {rate:.9g}" for name, rate in list(stated.items())[:_MOST_NAMED])
        return [f"{f'sample_rate = {quoted(FILL_IN)}':<46}# Hz; {_plain(rates)}"]
    name, hertz = next(iter(stated.items()))
    return [
        f"{f'sample_rate = {hertz:.9g}':<46}# Hz, suggested: what {_plain(name)} in the log says",
        *_interval_lines(log, 1.0 / hertz),
    ]


def _listing(channel: InspectedChannel) -> str:
    quality = channel.quality
    unit = f" [{_plain(channel.unit)}]" if channel.unit else ""
    described = f" ({_plain(channel.description[:_LONGEST])})" if channel.description else ""
    spans = f"{quality.n} samples, {quality.smallest:.6g} … {quality.largest:.6g}"
    return "; ".join((f"#   {quoted(channel.name)}{unit}{described}: {spans}", *channel.remarks))


def _role_lines(suggestion: Suggestion, by_name: dict[str, InspectedChannel], log: Inspection) -> list[str]:
    names = suggestion.candidates
    role = suggestion.role
    if role == "v2" and not names:
        taken = {each.only for each in log.suggestions}.union(log.apart)
        others = [quoted(name) for name in by_name if name not in taken][:_MOST_NAMED]
        more = f" Other channels: {', '.join(others)}" if others else ""
        return [f"# v2 is left out: a device with one input?{more}"]
    if suggestion.only is not None:
        return _suggested_lines(suggestion, by_name[suggestion.only], by_name, log)
    if role == "time" and any(each.clock for each in log.suggestions):
        return [f"# time is left out: each channel has its own, of {', '.join(map(quoted, names))}"]
    wanted = f"one of {', '.join(map(quoted, names))}" if names else f"none stands out{_WAYS_OUT.get(role, '')}"
    return [f"{_entry(role, FILL_IN, FILL_IN)}  # {wanted}"]


def _suggested_lines(
    suggestion: Suggestion, channel: InspectedChannel, by_name: dict[str, InspectedChannel], log: Inspection
) -> list[str]:
    """The lines of a role that one channel suits, with the time of its own if it has one."""
    role = suggestion.role
    unit, origin = _unit(channel, role)
    entry = _entry(role, channel.name, unit)
    monitor = ""
    if channel.codes:
        entry = _with(entry, f"missing = [{', '.join(f'{code:.9g}' for code in channel.codes)}]")
    if suggestion.clock:
        clock = by_name[suggestion.clock]
        entry = _with(entry, f"time = {_entry('', clock.name, _unit(clock, 'time')[0]).removeprefix(' = ')}")
    if role in ("v1", "v2"):
        entry, monitor = _of_monitor(entry, unit, channel, log)
        if _seldom(channel, log):
            return [
                f"{_with(entry, 'on_change = true')}  # suggested; unit {origin}; few samples, far apart: recorded "
                "when it changed?"
            ]
    return [f"{entry}  # suggested; unit {origin}{monitor}", *_signed_monitor(entry, channel, log)]


def _of_monitor(entry: str, unit: str, channel: InspectedChannel, log: Inspection) -> tuple[str, str]:
    """The entry of a voltage with the scale of its monitor where the log states that, and a remark on the monitor."""
    ratio = monitor_ratio(channel.description, channel.name, log.heading)
    if ratio > 1.0 and unit == "V":
        return _with(entry, f"scale = {ratio:g}"), f"; a monitor of 1:{ratio:g} by the log"
    if ratio > 1.0 and unit == FILL_IN:
        return entry, f"; the log names 1:{ratio:g}: V of a monitor take scale = {ratio:g}"
    if unit == "V" and _may_be_a_monitor(channel.quality):
        return entry, "; of a 1:1000 monitor? then also scale = 1000"
    return entry, ""


def _may_be_a_monitor(quality: SignalQuality) -> bool:
    """True if a voltage is as small as the monitor of a high-voltage amplifier and has one sign."""
    both_signs = takes_both_signs(quality.smallest, quality.largest)  # as a motor's voltage
    return not both_signs and max(-quality.smallest, quality.largest) <= _MONITOR


def _with(entry: str, more: str) -> str:
    """An entry with one more key."""
    return entry.removesuffix(" }") + f", {more} }}"


def _signed_monitor(entry: str, channel: InspectedChannel, log: Inspection) -> list[str]:
    """Settings lines that split a single input of both signs into two membranes; empty for others."""
    quality = channel.quality
    single = all(each.role != "v2" or not each.candidates for each in log.suggestions)
    if not entry.startswith("v1") or not single or not takes_both_signs(quality.smallest, quality.largest):
        return []
    left, right = (_with(entry, f'part = "{part}"') for part in ("positive", "negative"))
    return [f"# {left}  # a signed monitor of both membranes?", f"# {right.replace('v1', 'v2', 1)}"]


def _seldom(channel: InspectedChannel, log: Inspection) -> bool:
    """True if a channel may have been recorded on change only."""
    if channel.every > 1:
        return False
    quality = channel.quality
    base = None if channel.time_base is None else log.time_bases[channel.time_base]
    step, lasts = (1.0, quality.n) if base is None else (base.step, base.stop - base.start)
    finest = max(Ingest().sample_interval, min((each.step for each in log.time_bases), default=0.0))
    return (base is not None and step > COARSEST_STEP * finest) or seldom(quality.n - quality.not_finite, step, lasts)


def _unit(channel: InspectedChannel, role: Role) -> tuple[str, str]:
    """The unit of a channel as far as it is known, and how."""
    unit = suggested_unit(channel.name, channel.unit)
    if not unit or (role == "time" and unit not in SECONDS):
        return FILL_IN, "not stated"
    try:
        to_si(unit, DISPLACEMENT, role)
    except InputError:
        if role == "q":
            return FILL_IN, f"by the log {unit}: no length or angle; 'V' may stand for it"
    return unit, "by the log" if channel.unit.strip("[]() ") else "by its name"


def _entry(role: str, channel: str, unit: str) -> str:
    return f"{role} = {{ channel = {quoted(channel)}, unit = {quoted(unit)} }}"


def quoted(text: str) -> str:
    """A TOML basic string; control characters, and what is invisible or turns the line around, are escaped."""
    return '"' + "".join(_escaped(character) for character in text) + '"'


def _escaped(character: str) -> str:
    if character in '"\\':
        return "\\" + character
    if character.isprintable():
        return character
    # A lone surrogate (an undecodable byte) has no TOML escape at all.
    return "\ufffd" if 0xD800 <= ord(character) < 0xE000 else f"\\U{ord(character):08X}"


def _plain(text: str) -> str:
    return quoted(text)[1:-1]


def _plain_line(line: str) -> str:
    return "".join(character if character.isprintable() else _escaped(character) for character in line)


def _prototype_name(log: Path) -> str:
    """A name that the settings allow: the log's without its purpose, or its folder's if that leaves nothing."""
    stem = log.stem
    if purposes(stem):
        stem = "_".join(part for part in _BETWEEN.split(stem) if part and not purpose_of(part.strip("0123456789")))
        if not stem or purposes(stem):
            stem = log.absolute().parent.name
    try:
        return check_name(stem)
    except ValueError:
        return slug(stem)
