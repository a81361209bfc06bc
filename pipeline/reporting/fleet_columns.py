"""The table of a large fleet as columns of numbers for the page's script, which shows the rows in sight."""

import base64
import math
import zlib
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from pipeline.numerics.arrays import FloatArray
from pipeline.reporting.fleet_members import Summary
from pipeline.reporting.strip_chart import WIDE

GRADES = ("", "good", "fair", "poor", "failed")
_KEPT_BITS = 0xFFFFFC00
"""Of a 32-bit float: 13 bits of the fraction, a relative step of 1.2e-4, of which tables show three digits."""


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
