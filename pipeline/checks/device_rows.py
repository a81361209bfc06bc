"""Rows on two logs beside one another: the gain of the inputs, and whether both are of one device."""

from dataclasses import replace

import numpy as np

from pipeline.checks import limits
from pipeline.checks.declared import Declared
from pipeline.checks.log_facts import LogFacts
from pipeline.checks.log_gain import LogGain, log_gain
from pipeline.checks.misfit import Misfit, misfit
from pipeline.checks.rows import CheckRow, State, in_si
from pipeline.checks.weak_form import WeakTerms, scales_of, weak_terms
from pipeline.scoring.wells import Wells
from pipeline.settings import CheckGate
from pipeline.si_prefix import quantity, significant

_ANOTHER_DEVICE = "a log of another device, or the device was changed in between (clamping, pre-strain, load)"


def device_rows(first: LogFacts, other: LogFacts, declared: Declared) -> list[CheckRow]:
    """The rows on a log beside the first training log."""
    gain = _gain(first, other, declared)
    if gain is not None and not _gain_explains(first, other, declared, gain):
        gain = None
    return [
        *_gain_rows(first, other, gain),
        *_clock_rows(first, other, declared),
        _device_row(first, other, declared, gain),
    ]


def _terms(first: LogFacts, other: LogFacts, declared: Declared) -> tuple[WeakTerms, WeakTerms] | None:
    """The weak forms of two logs under the scales of the first."""
    scales = scales_of(first.signals, squared=declared.squared)
    a, b = (
        weak_terms(fact.signals, declared.sample_interval, scales, squared=declared.squared) for fact in (first, other)
    )
    return None if a is None or b is None else (a, b)


def _gain(first: LogFacts, other: LogFacts, declared: Declared) -> LogGain | None:
    """The gain of a log's inputs against the first log, where both show what the inputs do."""
    unseen = any(
        each is None or abs(each.push.value) <= limits.SIGN_CERTAINTY * each.push.error for each in first.inputs
    )
    unseen |= any(each is None for each in other.inputs)
    terms = None if unseen else _terms(first, other, declared)
    return None if terms is None else log_gain(*terms, squared=declared.squared)


def _off(gain: LogGain | None) -> list[tuple[str, float, float]]:
    """The inputs whose gain is surely off, with factor and standard error."""
    if gain is None:
        return []
    least, sure = limits.GAIN_OF_ALL if gain.together else limits.GAIN_OF_ONE
    names = ["voltages"] if gain.together else [f"v{k + 1}" for k in range(gain.factors.size)]
    measured = zip(names, gain.factors.tolist(), gain.errors.tolist(), strict=True)
    return [(name, g, error) for name, g, error in measured if abs(g - 1.0) > max(least, sure * error)]


def _gain_rows(first: LogFacts, other: LogFacts, gain: LogGain | None) -> list[CheckRow]:
    """A log whose inputs are all too small or too large: another probe, another range of the amplifier."""
    rows = []
    for name, factor, error in _off(gain):
        percent, side = 100.0 * (1.0 / factor - 1.0), "low" if factor > 1.0 else "high"
        measured = f"{quantity(abs(percent), '%', 100.0 * error / factor**2)} {side}"
        advice = (
            f"against {first.signals.name}, the {name} of this log look {measured}: correct its probe ratio (times "
            f"{significant(factor, 3)}), or leave the log out"
        )
        wrong = abs(factor - 1.0) > limits.WRONG_GAIN
        state: State = "wrong" if wrong else "note"
        what = f"gain of {name}"
        gate: CheckGate | None = "scale" if wrong else None
        values = in_si("gain", "1", factor, error)
        rows.append(CheckRow(other.signals.name, what, measured, "± 3 %", state, gate, advice, values=values))
    return rows


def _clock_rows(first: LogFacts, other: LogFacts, declared: Declared) -> list[CheckRow]:
    """A log whose q answers later or earlier than in the first log: its recorders were not started together.

    Of the joint alone: the lag of another law's answer depends on frequency and amplitude.
    """
    if not declared.joint:
        return []
    delays = [
        (there.delay.value - here.delay.value, float(np.hypot(here.delay.error, there.delay.error)))
        for here, there in zip(first.inputs, other.inputs, strict=True)
        if here is not None and there is not None and not (here.at_the_end or there.at_the_end)
    ]
    if not delays:
        return []
    later, errors = (np.array(column) for column in zip(*delays, strict=True))
    weights = 1.0 / np.maximum(errors, np.finfo(float).tiny) ** 2
    mean, error = float(weights @ later / weights.sum()), float(weights.sum() ** -0.5)
    limit = limits.OTHER_CLOCK * declared.sample_interval
    if abs(mean) <= max(limit, limits.SIGN_CERTAINTY * error):
        return []
    measured = f"{quantity(abs(mean), 's', error)} {'later' if mean > 0.0 else 'earlier'}"
    advice = (
        f"against {first.signals.name}, q of this log answers {measured}: its recorders were not started together; "
        f"{'delay' if mean > 0.0 else 'advance'} its inputs by that time, or leave the log out"
    )
    values = in_si("later", "s", mean, error)
    allowed = f"± {quantity(limit, 's')}"
    return [CheckRow(other.signals.name, "answer of q", measured, allowed, "note", None, advice, values=values)]


def _gain_explains(first: LogFacts, other: LogFacts, declared: Declared, gain: LogGain) -> bool:
    """Whether two logs show one device once the inputs of one are multiplied by a gain that is surely off.

    Another device, or a sensor that was zeroed anew, changes what inputs do too; but no gain mends it.
    """
    if not _off(gain):
        return False
    corrected = replace(other, signals=replace(other.signals, v=other.signals.v * gain.factors))
    terms = _terms(first, corrected, declared)
    measured = None if terms is None else misfit(*terms)
    return measured is not None and measured.ratio <= limits.MOST_MISFIT


def _device_row(first: LogFacts, other: LogFacts, declared: Declared, gain: LogGain | None) -> CheckRow:
    """Whether a log shows the device of the first training log."""
    terms = _terms(first, other, declared)
    measured = None if terms is None else misfit(*terms)
    what = "same device"
    if measured is None:
        return CheckRow(other.signals.name, what, "too little in common to tell", "", "not seen")
    if not declared.joint:
        return _of_other_device(other.signals.name, what, measured, gain)
    same, lasts = measured.ratio <= limits.MOST_MISFIT, min(float(np.ptp(fact.signals.t)) for fact in (first, other))
    sure = measured.ratio > limits.SURELY_MISFIT and measured.unexplained <= limits.MOST_UNEXPLAINED
    coarsest = max(fact.signals.interval for fact in (first, other)) / declared.sample_interval
    sure = sure and lasts > limits.SURE_LENGTH * declared.sample_interval and coarsest < limits.SURE_INTERVAL
    sure = sure and _driven_alike(first, other)
    values = in_si("misfit", "1", measured.ratio)
    if not same and gain is not None:
        advice = "it is one device, but for the gain of this log's inputs"
        return CheckRow(
            other.signals.name, what, f"{significant(measured.ratio, 2)} × misfit", f"≤ {limits.MOST_MISFIT:g}", "note",
            None, advice, values=values,
        )  # fmt: skip
    state: State = "ok" if same else "wrong" if sure else "note"
    return CheckRow(
        other.signals.name,
        what,
        f"{significant(measured.ratio, 2)} × misfit",
        f"≤ {limits.MOST_MISFIT:g}",
        state,
        "device" if state == "wrong" else None,
        ""
        if same
        else f"this {'is' if state == 'wrong' else 'may be'} {_ANOTHER_DEVICE}{_moved(first, other, declared)}",
        "; ".join(_side_by_side(first, other, declared)),
        values,
    )


def _of_other_device(log: str, what: str, measured: Misfit, gain: LogGain | None) -> CheckRow:
    """The row for a device that is no joint: its law may be another, so weights in common are judged, if any."""
    shown, limit = f"{significant(100.0 * measured.together, 2)} % unexplained together", limits.MOST_TOGETHER
    values = in_si("unexplained_together", "1", measured.together)
    if measured.unexplained > limits.MOST_UNEXPLAINED:
        text = f"a second-order law leaves {significant(100.0 * measured.unexplained, 2)} % of one log alone"
        return CheckRow(log, what, text, "", "not seen", values=values)
    same = measured.together <= limit
    advice = "" if same else f"this may be {_ANOTHER_DEVICE}"
    if not same and gain is not None:
        advice = "it is one device, but for the gain of this log's inputs"
    state: State = "ok" if same else "note"
    return CheckRow(log, what, shown, f"≤ {100.0 * limit:g} %", state, None, advice, values=values)


def _moved(first: LogFacts, other: LogFacts, declared: Declared) -> str:
    """What both rests of two logs say where they lie equally far apart: that of a sensor which was zeroed anew."""
    if not isinstance(first.wells, Wells) or not isinstance(other.wells, Wells):
        return ""
    left, right = other.wells.left - first.wells.left, other.wells.right - first.wells.right
    if abs(left - right) > limits.ZEROED_ANEW * abs(left + right):
        return ""
    moved = quantity(0.5 * (left + right), declared.displacement)
    return f"; both rests have moved by {moved}: if the sensor was zeroed anew, take that off q in this log"


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
