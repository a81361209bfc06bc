"""The calibrated quantities of the hybrid model as a table for people."""

from collections.abc import Sequence
from dataclasses import dataclass

from pipeline.device_facts.calibrated import Calibrated, calibrated
from pipeline.device_facts.datasheet import Datasheet
from pipeline.device_facts.run_data import RunData
from pipeline.si_prefix import interval, percent, quantity

WIDE = 2.0
"""Ratio of the ends of an interval beyond which it is written by its ends."""


@dataclass(frozen=True)
class CalibratedRow:
    """Texts of one quantity; `moved` if its nominal value lies outside its interval."""

    name: str
    nominal: str
    value: str
    moved: bool


def calibrated_rows(data: RunData, sheet: Datasheet) -> list[CalibratedRow]:
    """One row for each quantity that the hybrid model's fit moves; none of another headline."""
    return [_row(one) for one in _known(calibrated(data.models.get(sheet.headline)))]


def structure_summary(data: RunData, sheet: Datasheet) -> str:
    """Which model the headline is, why, how many basis functions act, and what they change."""
    known = data.descriptions.get(sheet.headline, {})
    count = known.get("basis_functions")
    if count is None:
        return ""
    sentences = [_WHAT.get((sheet.headline, bool(count)), "").format(count=count)]
    choice = data.choice or {}
    if choice.get("chosen") == sheet.headline and choice.get("reason"):
        sentences.append(f"Why this model: {choice['reason']}.")
    ablation = [
        f"{_PARTS[name]} {percent(error)}"
        for name, error in choice.get("ablation", {}).items()
        if error is not None and name in _PARTS
    ]
    if ablation:
        sentences.append(
            f"Errors over the last quarters of the training logs, of the operating range: {', '.join(ablation)}."
        )
    return " ".join(sentence for sentence in sentences if sentence)


_WHAT = {
    ("hybrid", True): "hybrid is the analytical joint with the calibrated quantities below and RBF corrections of "
    "{count} basis functions each.",
    ("hybrid", False): "hybrid is the analytical joint with the calibrated quantities below; no basis function acts.",
    ("rbf", True): "rbf is identified from data alone, with {count} basis functions in each curve.",
    ("rbf-paper", True): "rbf-paper is the published recipe, with {count} basis functions in each curve.",
}
_PARTS = {
    "equations_alone": "equations alone",
    "equations_with_rbf": "with basis functions",
    "rbf_alone": "rbf from data alone",
}
"""What was left out (`pipeline.models.choose.ABLATION`), in words."""


def _known(found: Sequence[Calibrated]) -> list[Calibrated]:
    """Without pure numbers of the beam's higher terms, whose names say nothing outside the equations."""
    return [one for one in found if one.unit != "1" or one.nominal == 1.0]


def _row(one: Calibrated) -> CalibratedRow:
    half = (one.high - one.low) / 2.0
    nominal = "–" if one.nominal is None else quantity(one.nominal, one.unit, like=one.value)
    moved = one.nominal is not None and not one.low <= one.nominal <= one.high
    if one.low > 0.0 and one.high > WIDE * one.low:  # the interval of a logarithm, far from even
        value, ends = interval(one.value, one.low, one.high, one.unit)
        return CalibratedRow(one.name, nominal, f"{value} ({ends})", moved)
    return CalibratedRow(one.name, nominal, quantity(one.value, one.unit, half), moved)
