"""Settings of earlier releases: what to write in place of a key that is gone, and stored ones by today's keys."""

from collections.abc import Mapping
from typing import Any

STRUCTURE = ("friction", "force", "damping", "drag", "stops", "gain", "drive", "effect", "hold")
"""Keys of `[identify]` that became the table `[identify.structure]`."""

GATES = ("delay", "time-base", "device")
"""Gates of `[quality] accept` that refuse nothing any more."""

_DEFAULTS: dict[str, dict[str, Any]] = {
    "differentiate": {"reweighted": True, "rate": "record"},
    "identify": {"basis": "gaussian", "rbf_basis_functions": "auto", "rbf_smoothing": "auto", "rbf_prior": "auto"},
}
"""Keys that are gone, and the value that the program has now in any case."""

_GONE = {
    "differentiate.reweighted": "leave it out: the penalty is always lifted where the acceleration jumps",
    "differentiate.rate": 'leave it out; for "signals" give [ingest] record_interval the value of sample_interval',
    "differentiate.method": 'write method = "savitzky-golay", or leave it out',
    "identify.basis": "leave it out: `rbf-paper` has Gaussians",
    "identify.rbf_basis_functions": "leave it out: inner validation chooses the number",
    "identify.rbf_smoothing": "leave it out: inner validation chooses the width",
    "identify.rbf_prior": "leave it out: inner validation chooses the prior",
}


def replacement(key: str, value: Any) -> str | None:
    """The line for a key, or value, that an earlier release had; None where none had it."""
    table, _, name = key.partition(".")
    if table == "identify" and name in STRUCTURE:
        return f"{key} is gone; write [identify.structure], and {name} = {value!r:.60} below it".replace("'", '"')
    if key == "differentiate.method" and value != "rts":
        return None
    return f"{key} is gone; {_GONE[key]}" if key in _GONE else None


def translated(stored: Mapping[str, Any], *, used: bool = False) -> dict[str, Any]:
    """Settings that an earlier release stored, by today's keys; those of today as they are.

    Parameters
    ----------
    stored : mapping
        Tables of settings, as JSON values; some may be absent.
    used : bool
        Whether an artifact was made with them. Then a value that no setting has any more stays, so that it counts as a
        change.
    """
    tables = {name: dict(table) if isinstance(table, Mapping) else table for name, table in stored.items()}
    for name, defaults in _DEFAULTS.items():
        table = tables.get(name)
        if not isinstance(table, dict):
            continue
        for key in defaults.keys() & table.keys():
            if not used or table[key] == defaults[key]:
                del table[key]
    if isinstance(prototype := tables.get("prototype"), dict):
        tables["prototype"] = translated(prototype, used=used)
    quality = tables.get("quality")
    if not used and isinstance(quality, dict) and isinstance(accepted := quality.get("accept"), list | tuple):
        quality["accept"] = [gate for gate in accepted if gate not in GATES]
    differentiate = tables.get("differentiate")
    identify = tables.get("identify")
    if not used and isinstance(differentiate, dict) and differentiate.get("method") == "rts":
        del differentiate["method"]
    if isinstance(identify, dict) and (moved := {key: identify.pop(key) for key in STRUCTURE if key in identify}):
        identify["structure"] = moved
    return tables
