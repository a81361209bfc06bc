"""Rows on two logs beside one another: what they differ by, and whether both are of one device."""

import numpy as np

from pipeline.checks import limits
from pipeline.checks.declared import Declared
from pipeline.checks.difference_rows import Differences, difference_rows, differences, mended, weak_forms
from pipeline.checks.log_facts import LogFacts
from pipeline.checks.misfit import Misfit, misfit
from pipeline.checks.rows import CheckRow, State, in_si
from pipeline.scoring.wells import Wells
from pipeline.si_prefix import quantity, significant

_ANOTHER_DEVICE = "a log of another device, or the device was changed in between (clamping, pre-strain, load)"


def device_rows(first: LogFacts, other: LogFacts, declared: Declared) -> list[CheckRow]:
    """The rows on a log beside the first training log."""
    differs = differences(first, other, declared)
    return [*difference_rows(first, other, differs, declared), _device_row(first, other, declared, differs)]


def _device_row(first: LogFacts, other: LogFacts, declared: Declared, differs: Differences) -> CheckRow:
    """Whether a log shows the device of the first training log."""
    terms = weak_forms(first, other.signals, declared)
    measured = None if terms is None else misfit(*terms)
    what = "same device"
    if measured is None:
        return CheckRow(other.signals.name, what, "too little in common to tell", "", "not seen")
    if not declared.joint:
        return _of_other_device(other.signals.name, what, measured, differs)
    lasts, costs = min(float(np.ptp(fact.signals.t)) for fact in (first, other)), measured.together
    same = measured.ratio <= limits.MOST_MISFIT or costs <= limits.MOST_COST * measured.unexplained
    sure = measured.ratio > limits.SURELY_MISFIT and costs > limits.SURE_COST * measured.unexplained
    sure = sure and measured.unexplained <= limits.MOST_UNEXPLAINED
    coarsest = max(fact.signals.interval for fact in (first, other)) / declared.sample_interval
    long = lasts > limits.SURE_LENGTH * declared.sample_interval
    sure = sure and long and coarsest < limits.SURE_INTERVAL and _driven_alike(first, other)
    values = in_si("misfit", "1", measured.ratio)
    if not same and differs.names and mended(first, differs.corrected, declared):
        advice = _but_for(differs)
        return CheckRow(
            other.signals.name, what, f"{significant(measured.ratio, 2)} × misfit", f"≤ {limits.MOST_MISFIT:g}", "note",
            None, advice, values=values,
        )  # fmt: skip
    if not (same or long):
        return CheckRow(other.signals.name, what, "too short to tell", "", "not seen", values=values)
    state: State = "ok" if same else "wrong" if sure else "note"
    return CheckRow(
        other.signals.name,
        what,
        f"{significant(measured.ratio, 2)} × misfit",
        f"≤ {limits.MOST_MISFIT:g}",
        state,
        "device" if state == "wrong" else None,
        "" if same else f"this {'is' if state == 'wrong' else 'may be'} {_ANOTHER_DEVICE}",
        "; ".join(_side_by_side(first, other, declared)),
        values,
    )


def _of_other_device(log: str, what: str, measured: Misfit, differs: Differences) -> CheckRow:
    """The row for a device that is no joint: its law may be another, so weights in common are judged, if any."""
    shown, limit = f"{significant(100.0 * measured.together, 2)} % unexplained together", limits.MOST_TOGETHER
    values = in_si("unexplained_together", "1", measured.together)
    if measured.unexplained > limits.MOST_UNEXPLAINED:
        text = f"a second-order law leaves {significant(100.0 * measured.unexplained, 2)} % of one log alone"
        return CheckRow(log, what, text, "", "not seen", values=values)
    same = measured.together <= limit
    advice = "" if same else f"this may be {_ANOTHER_DEVICE}"
    if not same and differs.gain is not None:
        advice = _but_for(differs)
    state: State = "ok" if same else "note"
    return CheckRow(log, what, shown, f"≤ {100.0 * limit:g} %", state, None, advice, values=values)


def _but_for(differs: Differences) -> str:
    return f"it is one device, but for {' and '.join(differs.names)} in this log"


def _driven_alike(first: LogFacts, other: LogFacts) -> bool:
    """Whether two logs were driven by the same inputs about as strongly: what hidden states do differs with that."""
    both = zip(first.inputs, other.inputs, first.peaks.tolist(), other.peaks.tolist(), strict=True)
    return all((a is None) == (b is None) and max(p, q) <= limits.ALIKE * min(p, q) for a, b, p, q in both)


def _side_by_side(first: LogFacts, other: LogFacts, declared: Declared) -> list[str]:
    texts = []
    if isinstance(first.wells, Wells) and isinstance(other.wells, Wells):
        for side, here, there in (
            ("left", first.wells.left, other.wells.left),
            ("right", first.wells.right, other.wells.right),
        ):
            unit = declared.displacement
            own, theirs = quantity(there, unit, like=here), quantity(here, unit, like=there)
            texts.append(f"rests {side} at {own}, {first.signals.name} at {theirs}")
    if first.ring is not None and other.ring is not None:
        own, theirs = quantity(other.ring, "Hz"), quantity(first.ring, "Hz")
        texts.append(f"rings at {own}, {first.signals.name} at {theirs}")
    return texts
