"""The calibrated quantities of the hybrid model as a table for people."""

from collections.abc import Sequence
from dataclasses import dataclass

from pipeline.device_facts.calibrated import Calibrated, calibrated
from pipeline.device_facts.datasheet import Datasheet
from pipeline.device_facts.run_data import RunData
from pipeline.si_prefix import quantity


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
    """Which model the headline is, how many basis functions act, and what they change, in one sentence or two."""
    model, known = sheet.headline, data.descriptions.get(sheet.headline, {})
    count = known.get("basis_functions")
    if count is None:
        return ""
    if model != "hybrid":
        return f"{model} is identified from data alone, with {count} basis functions in each curve."
    if not count:
        return (
            "hybrid is the analytical joint with the calibrated quantities below. No basis function acts: the "
            "calibrated equations follow the training logs so closely that corrections were not needed, or held-out "
            "data spoke against them."
        )
    text = (
        f"hybrid is the analytical joint with the calibrated quantities below and {count} basis functions in each of "
    )
    text += "its corrections."
    before, after = known.get("inner_body_m"), known.get("inner_corrected_m")
    if before is None or after is None:
        return text
    unit = data.displacement
    return (
        f"{text} On held-out training data they change the error from {quantity(before, unit)} to "
        f"{quantity(after, unit, like=before)}."
    )


def _known(found: Sequence[Calibrated]) -> list[Calibrated]:
    """Without pure numbers of the beam's higher terms, whose names say nothing outside the equations."""
    return [one for one in found if one.unit != "1" or one.nominal == 1.0]


def _row(one: Calibrated) -> CalibratedRow:
    half = (one.high - one.low) / 2.0
    nominal = "–" if one.nominal is None else quantity(one.nominal, one.unit, like=one.value)
    moved = one.nominal is not None and not one.low <= one.nominal <= one.high
    return CalibratedRow(one.name, nominal, quantity(one.value, one.unit, half), moved)
