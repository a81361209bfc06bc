"""A first settings file for a raw log: what is certain is filled in, everything else is left to the user."""

import re

from pipeline.rig_logs.inspection import InspectedChannel, Inspection
from pipeline.rig_logs.suggestions import Role, Suggestion, suggested_unit

FILL_IN = "FILL IN"
"""Stands where the user has to choose; no channel and no unit is called so."""

_MOST_LISTED = 100


def toml_draft(inspection: Inspection, *, log: str | None = None) -> str:
    """The text of a prototype file for this log.

    Parameters
    ----------
    inspection : Inspection
        What is in the log.
    log : str, optional
        The log's path as it shall stand in the file, relative to where the file is saved; its name by default.

    Returns
    -------
    str
        TOML. Every channel is listed in comments. A role with one candidate is filled in and marked as a
        suggestion; one with several, and every unit that the log does not state, holds `FILL_IN`, which no
        log and no unit registry knows.
    """
    by_name = {channel.name: channel for channel in inspection.channels}
    lines = [
        f"# A starting point for {quoted(inspection.path.name)} ({inspection.format}).",
        f'# Nothing here has been decided: replace every "{FILL_IN}" and check what is marked as suggested.',
        "#",
        "# Channels of the log:",
        *(_listing(channel) for channel in inspection.channels[:_MOST_LISTED]),
    ]
    if len(inspection.channels) > _MOST_LISTED:
        lines.append(f"#   … and {len(inspection.channels) - _MOST_LISTED} more")
    lines += [
        "",
        f"name = {quoted(_prototype_name(inspection.path.stem))}",
        "",
        "[logs]                                        # paths relative to this file",
        f"train = [{quoted(log or inspection.path.name)}]",
        "validation = []                               # logs that no identification sees",
        "",
        "[channels]                                    # channel in the log, and the unit of its numbers",
    ]
    if inspection.own_time:
        lines.append("# time is left out: the format carries its own time base")
    for suggestion in inspection.suggestions:
        lines += _role_lines(suggestion, by_name)
    lines += [
        "",
        "[plant]",
        '# mass = { value = 0.041, unit = "kg" }       # leave out: curves per unit mass',
        'inputs = "squared"                            # "squared" (electrostatic) or "linear" (a force-like input)',
        '# parameters = "nominal"                      # for the analytical model; leave out for what is no DE joint',
    ]
    return "\n".join(lines) + "\n"


def _listing(channel: InspectedChannel) -> str:
    quality = channel.quality
    unit = f" [{_plain(channel.unit)}]" if channel.unit else ""
    line = f"#   {quoted(channel.name)}{unit}: {quality.n} samples, {quality.smallest:.6g} … {quality.largest:.6g}"
    return "; ".join((line, *channel.remarks))


def _role_lines(suggestion: Suggestion, by_name: dict[str, InspectedChannel]) -> list[str]:
    names, role = suggestion.candidates, suggestion.role
    if role == "v2" and not names:
        return ["# v2 is left out: a device with one input?"]
    if suggestion.only is not None:
        channel = by_name[suggestion.only]
        unit = suggested_unit(channel.name, channel.unit) or FILL_IN
        origin = "by the log" if channel.unit.strip("[]() ") else "by its name" if unit != FILL_IN else "not stated"
        return [f"{_entry(role, channel.name, unit)}  # suggested; unit {origin}"]
    found = f"one of {', '.join(map(quoted, names))}" if names else "none stands out"
    return [f"{_entry(role, FILL_IN, FILL_IN)}  # {found}"]


def _entry(role: Role, channel: str, unit: str) -> str:
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


def _prototype_name(stem: str) -> str:
    """A name that the settings allow, from the log's."""
    return re.sub(r"[^A-Za-z0-9._-]+", "-", stem).strip("-.")[:64] or "prototype"
