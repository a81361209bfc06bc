"""The table of a fleet: a few numbers of every prototype, and how each is distributed."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from ..numerics.arrays import FloatArray
from ..store.columns import FACT_COLUMNS
from ..system.names import slug
from .figure import Band, Figure, Line, Panel, Points

FACTS = {column.key: column.fleet for column in FACT_COLUMNS if column.fleet}
"""Facts of the fleet's table and their headings."""
WIDE = 20.0
"""Ratio of the largest to the least value beyond which an axis is logarithmic, and numbers have own decimals."""


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
        Grades of the assessment; empty if it has none.
    why : str
        The finding that decides the lower of both grades, and how many more there are; empty where both are good.
    diverged : bool
        Whether the judged model diverged on a log.
    error, switches : float
        Worst NRMSE of q and worst switch accuracy of the judged model; NaN if undefined.
    training : bool
        Whether these are of the training logs, as there is no other.
    facts : dict of str to (float, str)
        Value [SI] and unit of every known one of `FACTS`.
    instruments : float
        Largest error of an instrument of any log over its limit; NaN where none was measured.
    off : bool
        Whether one is beyond its limit, or a log is of another device.
    """

    name: str
    reason: str
    link: str | None = None
    done: bool = False
    data: str = ""
    model: str = ""
    why: str = ""
    diverged: bool = False
    error: float = float("nan")
    switches: float = float("nan")
    training: bool = False
    facts: dict[str, tuple[float, str]] = field(default_factory=dict)
    instruments: float = float("nan")
    off: bool = False


def summary(name: str, sheet: Mapping[str, Any], link: str | None) -> Summary:
    """The numbers of a prototype's ``datasheet.json`` that the page shows."""
    scores = sheet["scores"]
    judged = sheet["judged_model"]
    return Summary(
        name,
        "",
        link,
        True,
        str(sheet["verdict"]["data"]),
        str(sheet["verdict"]["model"]),
        _why(sheet["verdict"].get("checks", ())),
        any(s["status"] == "diverged" for s in scores if s["model"] == judged),
        _headline(scores, judged, "nrmse"),
        _headline(scores, judged, "switch_accuracy"),
        {s["role"] for s in _of_headline(scores, judged)} == {"train"},
        {fact["key"]: (_value(fact), str(fact["unit"])) for fact in sheet["facts"] if fact["key"] in FACTS},
        *_instruments([row for row in sheet.get("instruments", ()) if row["model"] == judged]),
    )


def _instruments(rows: Sequence[Mapping[str, Any]]) -> tuple[float, bool]:
    """`Summary.instruments` and `Summary.off`."""
    errors = [abs(row["estimate"]) / row["limit"] for row in rows if row["estimate"] is not None]
    off = any(row["beyond"] or row["status"] == "another device" for row in rows)
    return max(errors, default=float("nan")), off


def _why(checks: Sequence[Mapping[str, Any]]) -> str:
    failing = [check for grade in ("poor", "fair") for check in checks if check["grade"] == grade]
    more = f" (and {len(failing) - 1} more)" if failing[1:] else ""
    return f"{failing[0]['about']}: {failing[0]['statement']}{more}" if failing else ""


def _value(fact: Mapping[str, Any]) -> float:
    value = fact["value"] if fact["value"] is not None else fact["measured"]
    return float("nan") if value is None else float(value)


def _of_headline(scores: Any, judged: str) -> list[Mapping[str, Any]]:
    return [s for s in scores if s["signal"] == "q" and s["model"] == judged]


def _headline(scores: Any, judged: str, key: str) -> float:
    """The worst score of q of the judged model: on validation logs, else on those of training; NaN if undefined."""
    rows = _of_headline(scores, judged)
    values = [s[key] for s in [s for s in rows if s["role"] == "validation"] or rows]
    defined = [float(value) for value in values if value is not None]
    if key == "switch_accuracy":  # a log without pulses has none
        return min(defined, default=float("nan"))
    return max(defined) if defined and len(defined) == len(values) else float("nan")


@dataclass(frozen=True)
class FleetColumn:
    """One column: a fact or a score of every member, in the unit that is shown (NaN: unknown), and what stands out.

    Scores of training logs are marked, and left out of distributions.
    """

    title: str
    unit: str
    values: np.ndarray[tuple[int], np.dtype[np.float64]]
    outliers: np.ndarray[tuple[int], np.dtype[np.bool_]]
    scored: bool = False

    @property
    def heading(self) -> str:
        """Title and unit."""
        return f"{self.title} in {self.unit}" if self.unit not in ("", "1") else self.title


def decimals(values: FloatArray) -> int | None:
    """Of a column whose values are of one size, so that its points stand under one another; else None."""
    sizes = np.abs(values[np.isfinite(values)])
    if not sizes.size or sizes.min() <= 0.0 or sizes.max() > WIDE * sizes.min():
        return None
    return max(0, 2 - math.floor(math.log10(float(np.median(sizes)))))


def distribution(column: FleetColumn) -> Figure:
    """The histogram of a column, with its median and the odd values; on a logarithmic axis where sizes differ much."""
    finite = np.isfinite(column.values)
    values = column.values[finite]
    odd = values[column.outliers[finite]]
    log = bool(values.min() > 0.0 and values.max() > WIDE * values.min())
    edges = np.histogram_bin_edges(np.log10(values) if log else values, "sturges")
    edges = 10.0**edges if log else edges
    counts = np.histogram(values, edges)[0].astype(np.float64)
    of_odd = counts[np.clip(np.searchsorted(edges, odd, side="right") - 1, 0, counts.size - 1)]
    outline = np.repeat(counts, 2)
    middle = float(np.median(values))
    highest = float(counts.max())
    panel = Panel(
        "prototypes",
        "1",
        lines=(Line("median", "reference", np.array([middle, middle]), np.array([0.0, highest]), dash="solid"),),
        bands=(Band("prototypes", "v1", np.repeat(edges, 2)[1:-1], np.zeros_like(outline), outline),),
        points=(Points("odd", "v2", odd, of_odd, marker="ring"),) if odd.size else (),
        whole=True,
    )
    return Figure(slug(column.title), column.title, "", column.title, column.unit, (panel,), x_log=log, half=True)
