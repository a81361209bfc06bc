"""The table of a fleet: a few numbers of every prototype, as columns for the page's script."""

import base64
import math
import zlib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from pipeline.numerics.arrays import FloatArray
from pipeline.reporting.distribution_charts import WIDE

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
GRADES = ("", "good", "fair", "poor", "failed")
_KEPT_BITS = 0xFFFFFC00
"""Of a 32-bit float: 13 bits of the fraction, a relative step of 1.2e-4, of which tables show three digits."""


@dataclass(frozen=True, slots=True)
class Summary:
    """What the page shows of one prototype of a fleet.

    Attributes
    ----------
    name : str
    reason : str
        Why its run failed; empty if it did not.
    link : str or None
        Its page relative to the fleet's page; None if there is none.
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


def failed(name: str, reason: str) -> Summary:
    """A prototype without a datasheet."""
    return Summary(name, reason, None, False, "", "", False, float("nan"), float("nan"), {}, ())


def summary(name: str, sheet: Mapping[str, Any], link: str | None) -> Summary:
    """The numbers of a prototype's ``datasheet.json`` that the page shows."""
    scores, judged = sheet["scores"], sheet["judged_model"]
    return Summary(
        name,
        "",
        link,
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


@dataclass(frozen=True)
class Quantity:
    """One column: a fact or an error of every member, in the unit that is shown; NaN where unknown."""

    title: str
    unit: str
    values: "np.ndarray[tuple[int], np.dtype[np.float64]]"
    outliers: "np.ndarray[tuple[int], np.dtype[np.bool_]]"


def fleet_columns(members: Sequence[Summary], quantities: Sequence[Quantity]) -> dict[str, Any]:
    """The table as JSON values; what is long is deflated and in base 64.

    ``names``: all of them, a line each; ``reasons``: a line for each that failed, in order; ``grades``: a byte each for
    data, model, whether a page exists and whether the model diverged; ``suffix``: what a link adds to a name; and for
    each quantity ``values`` (four byte planes of 32-bit floats, NaN where unknown), ``outliers`` (a byte each) and
    ``decimals``.
    """
    grade = {text: code for code, text in enumerate(GRADES)}
    failed = [member for member in members if member.reason]
    flags = [
        (grade.get(m.data, 0), 4 if m.reason else grade.get(m.model, 0), 1 if m.link else 0, 1 if m.diverged else 0)
        for m in members
    ]
    suffixes = {m.link.removeprefix(m.name) for m in members if m.link is not None}
    return {
        "count": len(members),
        "names": _deflated("\n".join(_line(m.name) for m in members).encode()),
        "reasons": _deflated("\n".join(_line(m.reason) for m in failed).encode()),
        "grades": _deflated(np.array(flags, dtype=np.uint8).T.tobytes()),
        "suffix": suffixes.pop() if len(suffixes) == 1 else "",
        "quantities": [
            {
                "values": _floats(q.values),
                "outliers": _deflated(q.outliers.astype(np.uint8).tobytes()),
                "decimals": decimals(q.values),
            }
            for q in quantities
        ],
    }


def decimals(values: FloatArray) -> int | None:
    """Of a column whose values are of one size, so that its points stand under one another; else None."""
    known = np.abs(values[np.isfinite(values)])
    if not known.size or known.min() <= 0.0 or known.max() > WIDE * known.min():
        return None
    return max(0, 2 - math.floor(math.log10(float(np.median(known)))))


def _line(text: str) -> str:
    return " ".join(text.split())


def _floats(values: FloatArray) -> str:
    bits = (values.astype("<f4").view("<u4") + np.uint32(0x200)) & np.uint32(_KEPT_BITS)
    bits[~np.isfinite(values)] = 0x7FC00000
    return _deflated(bits.view(np.uint8).reshape(-1, 4).T.tobytes())


def _deflated(content: bytes) -> str:
    return base64.b64encode(zlib.compress(content, 6)).decode("ascii")
