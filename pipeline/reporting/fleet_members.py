"""What the page of a fleet keeps of every prototype: a few numbers, so that a hundred thousand fit into memory."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

FACTS = (
    "well_left",
    "well_right",
    "barrier_left",
    "barrier_right",
    "switch_v1_to_right",
    "switch_v1_to_left",
    "switch_v2_to_right",
    "switch_v2_to_left",
    "frequency_left",
    "frequency_right",
    "damping_left",
    "damping_right",
)


@dataclass(frozen=True)
class Member:
    """One prototype of a fleet.

    Attributes
    ----------
    name : str
    reason : str
        Why its run failed; empty if it did not.
    datasheet : mapping or None
        Its ``datasheet.json``; None if it has none.
    link : str or None
        Its page relative to the fleet's page; None if there is none.
    """

    name: str
    reason: str
    datasheet: Mapping[str, Any] | None
    link: str | None


@dataclass(frozen=True, slots=True)
class Summary:
    """A member without its datasheet.

    Attributes
    ----------
    name, reason, link
        See `Member`.
    done : bool
        Whether it has a datasheet.
    data, model : str
        Grades of the verdict; empty if it has none.
    diverged : bool
        Whether the judged model diverged on a log.
    error, switches : float
        Worst NRMSE of q and worst switch accuracy of the judged model; NaN if undefined.
    facts : dict of str to (float, str)
        Value [SI] and unit of every known one of `FACTS`.
    validation : tuple of (str, float or None)
        Model and NRMSE of q of every validation log.
    """

    name: str
    reason: str
    link: str | None
    done: bool
    data: str
    model: str
    diverged: bool
    error: float
    switches: float
    facts: dict[str, tuple[float, str]]
    validation: tuple[tuple[str, float | None], ...]


def summary(member: Member) -> Summary:
    """The numbers of a member that the page shows."""
    sheet = member.datasheet
    if sheet is None:
        nan = float("nan")
        return Summary(member.name, member.reason, member.link, False, "", "", False, nan, nan, {}, ())
    scores, judged = sheet["scores"], sheet["judged_model"]
    return Summary(
        member.name,
        member.reason,
        member.link,
        True,
        str(sheet["verdict"]["data"]),
        str(sheet["verdict"]["model"]),
        any(s["status"] == "diverged" for s in scores if s["model"] == judged),
        _headline(scores, judged, "nrmse"),
        _headline(scores, judged, "switch_accuracy"),
        {fact["key"]: (_value(fact), str(fact["unit"])) for fact in sheet["facts"] if fact["key"] in FACTS},
        tuple((s["model"], s["nrmse"]) for s in scores if s["signal"] == "q" and s["role"] == "validation"),
    )


def _value(fact: Mapping[str, Any]) -> float:
    value = fact["value"] if fact["value"] is not None else fact["measured"]
    return float("nan") if value is None else float(value)


def _headline(scores: Any, judged: str, key: str) -> float:
    """The worst score of q of the judged model: on validation logs, else on those of training; NaN if undefined."""
    rows = [s for s in scores if s["signal"] == "q" and s["model"] == judged]
    values = [s[key] for s in [s for s in rows if s["role"] == "validation"] or rows]
    if not values or any(value is None for value in values):
        return float("nan")
    return float(min(values) if key == "switch_accuracy" else max(values))
