"""Rows on what a log differs by from the first: clock, rest levels and gain of its inputs, and the zero of its q."""

from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np

from pipeline.checks import limits
from pipeline.checks.declared import Declared
from pipeline.checks.log_differences import LogDifferences, log_differences
from pipeline.checks.log_facts import Estimate, LogFacts
from pipeline.checks.misfit import Misfit, misfit
from pipeline.checks.rest_level import rest_level
from pipeline.checks.rows import CheckRow, State, in_si, short_quantity
from pipeline.checks.weak_form import LogSignals, WeakTerms, weak_terms
from pipeline.numerics.arrays import FloatArray
from pipeline.settings import CheckGate
from pipeline.si_prefix import quantity, significant
from pipeline.signals.signal_quality import takes_both_signs


@dataclass(frozen=True)
class Differences:
    """What a log surely differs by from the first, and the log without that.

    Attributes
    ----------
    clock : Estimate or None
        By how much later q answers its inputs [s].
    levels : tuple of (float, float) or None
        Of each input, its level at rest here and in the first log.
    gain : LogDifferences or None
        What its inputs are to be multiplied by.
    zero : Estimate or None
        By how much its q is higher [m].
    corrected : LogSignals
        The log without all of these.
    """

    clock: Estimate | None
    levels: tuple[tuple[float, float] | None, ...]
    gain: LogDifferences | None
    zero: Estimate | None
    corrected: LogSignals

    @property
    def names(self) -> list[str]:
        """What is not as in the first log, in words."""
        named = {
            "the clock": self.clock, "the zero of its probes": any(self.levels), "the gain of its inputs": self.gain,
            "the zero of its q": self.zero,
        }  # fmt: skip
        return [name for name, differs in named.items() if differs]


def differences(first: LogFacts, other: LogFacts, declared: Declared) -> Differences:
    """Clock and rest levels as each log shows them; gain and zero of q as they mend what the first log predicts.

    A gain or a zero counts only where the log without it shows the device of the first one: another device, too,
    changes what inputs do, but no gain mends that.
    """
    clock = _clock(first, other, declared)
    levels = _levels(first, other, declared)
    signals = _shifted(other.signals, clock)
    driven = _without_levels(signals, levels)
    measured = _measured(first, other, driven, declared)
    if (
        _biased(other, levels)
        and _off(measured, declared)
        and not _off(_measured(first, other, signals, declared), declared)
    ):
        levels, driven = (None,) * len(levels), signals
        measured = _measured(first, other, driven, declared)
    zero = _zero(first, measured, declared)
    moved = driven if zero is None else replace(driven, q=driven.q - zero.value)
    if zero is not None:  # a large one is found in two steps
        measured = _measured(first, other, moved, declared)
        again = 0.0 if measured is None else measured.zero
        zero, moved = replace(zero, value=zero.value + again), replace(moved, q=moved.q - again)
    gain = measured if _off(measured, declared) else None
    corrected = moved if gain is None else replace(moved, v=moved.v * gain.factors)
    if (gain or zero) and not _helps(first, driven, corrected, declared):
        gain, zero, corrected = None, None, driven
    return Differences(clock, levels, gain, zero, corrected)


def difference_rows(first: LogFacts, other: LogFacts, differs: Differences, declared: Declared) -> list[CheckRow]:
    """One row for each difference."""
    log, beside = other.signals.name, first.signals.name
    rows = list(_gain_rows(log, beside, differs.gain, declared))
    if differs.clock is not None:
        rows.append(_clock_row(log, beside, differs.clock, declared))
    for i, levels in enumerate(differs.levels):
        if levels is not None:
            rows.append(_level_row(log, beside, i, levels, other, declared))
    if differs.zero is not None:
        rows.append(_zero_row(log, beside, differs.zero, first, declared))
    return rows


def weak_forms(first: LogFacts, other: LogSignals, declared: Declared) -> tuple[WeakTerms, WeakTerms] | None:
    """The weak forms of two logs under the scales of the first."""
    if first.terms is None:
        return None
    terms = weak_terms(other, declared.sample_interval, first.terms.scales, squared=declared.squared)
    return None if terms is None else (first.terms, terms)


def mended(first: LogFacts, corrected: LogSignals, declared: Declared) -> bool:
    """Whether a corrected log shows the device of the first one."""
    measured = _misfit(first, corrected, declared)
    return measured is not None and measured.ratio <= limits.MOST_MISFIT


def _misfit(first: LogFacts, log: LogSignals, declared: Declared) -> Misfit | None:
    terms = weak_forms(first, log, declared)
    return None if terms is None else misfit(*terms)


def _helps(first: LogFacts, driven: LogSignals, corrected: LogSignals, declared: Declared) -> bool:
    """Whether a log without gain and zero shows the device of the first one, and weights in common leave less of it."""
    before, after = (_misfit(first, log, declared) for log in (driven, corrected))
    if before is None or after is None:
        return False
    return after.ratio <= limits.MOST_MISFIT and after.together < before.together


def _measured(first: LogFacts, other: LogFacts, signals: LogSignals, declared: Declared) -> LogDifferences | None:
    """Gain and zero of a log against the first log, where both show what the inputs do."""
    unseen = any(
        each is None or abs(each.push.value) <= limits.SIGN_CERTAINTY * each.push.error for each in first.inputs
    )
    unseen |= any(each is None for each in other.inputs)
    terms = None if unseen else weak_forms(first, signals, declared)
    return None if terms is None else log_differences(*terms, squared=declared.squared)


def _clock(first: LogFacts, other: LogFacts, declared: Declared) -> Estimate | None:
    """By how much later q answers than in the first log, if surely so: the recorders were not started together.

    Of the joint alone: the lag of another law's answer depends on frequency and amplitude, as it does behind electrodes
    that charge slowly.
    """
    delays = [
        (there.delay.value - here.delay.value, float(np.hypot(here.delay.error, there.delay.error)))
        for here, there in zip(first.inputs, other.inputs, strict=True)
        if here is not None and there is not None and not (here.at_the_end or there.at_the_end)
    ]
    if not delays or not declared.joint or first.lag or other.lag:
        return None
    later, errors = (np.array(column) for column in zip(*delays, strict=True))
    weights = 1.0 / np.maximum(errors, np.finfo(float).tiny) ** 2
    mean, error = float(weights @ later / weights.sum()), float(weights.sum() ** -0.5)
    sure = abs(mean) > max(limits.OTHER_CLOCK * declared.sample_interval, limits.SIGN_CERTAINTY * error)
    return Estimate(mean, error) if sure else None


def _levels(first: LogFacts, other: LogFacts, declared: Declared) -> tuple[tuple[float, float] | None, ...]:
    """Levels at rest that differ, of a joint's voltages of one sign."""
    result: list[tuple[float, float] | None] = []
    for k, (one_side, other_side) in enumerate(zip(first.signals.v.T, other.signals.v.T, strict=True)):
        both = [(float(np.min(v)), float(np.max(v))) for v in (one_side, other_side)]
        there, here = rest_level(one_side), rest_level(other_side)
        if not declared.joint or any(takes_both_signs(*ends) for ends in both) or there is None or here is None:
            result.append(None)
            continue
        least = limits.OTHER_LEVEL * max(float(first.peaks[k]), float(other.peaks[k]))
        result.append((here, there) if abs(here - there) > least else None)
    return tuple(result)


def _biased(other: LogFacts, levels: tuple[tuple[float, float] | None, ...]) -> bool:
    """Whether levels at rest differ by so much that the drive itself may have been biased in one of the logs."""
    pairs = zip(levels, other.peaks.tolist(), strict=True)
    return any(level is not None and abs(level[0] - level[1]) > limits.BIAS * peak for level, peak in pairs)


def _zero(first: LogFacts, measured: LogDifferences | None, declared: Declared) -> Estimate | None:
    """The shift of a joint's q, if it is sure; that of another device may be an offset of its input."""
    if measured is None or not declared.joint:
        return None
    least = limits.OTHER_ZERO * float(np.nanstd(first.signals.q))
    sure = abs(measured.zero) > max(least, limits.SURE_ZERO * measured.zero_error)
    return Estimate(measured.zero, measured.zero_error) if sure else None


def _shifted(log: LogSignals, clock: Estimate | None) -> LogSignals:
    """The log with its inputs as much later as q answers later."""
    if clock is None:
        return log
    rows = np.arange(len(log.v)) - round(clock.value / log.interval)
    return replace(log, v=np.ascontiguousarray(log.v[np.clip(rows, 0, len(log.v) - 1)]))


def _without_levels(log: LogSignals, levels: tuple[tuple[float, float] | None, ...]) -> LogSignals:
    moved: FloatArray = np.array([0.0 if level is None else level[0] - level[1] for level in levels])
    return replace(log, v=log.v - moved) if moved.any() else log


def _off(gain: LogDifferences | None, declared: Declared) -> list[tuple[str, float, float]]:
    """The inputs whose gain is surely off, with factor and standard error."""
    if gain is None:
        return []
    least, sure = limits.GAIN_OF_ALL if gain.together else limits.GAIN_OF_ONE
    names = ["voltages"] if gain.together else [f"v{k + 1}" for k in range(gain.factors.size)]
    measured = zip(names, gain.factors.tolist(), gain.errors.tolist(), strict=True)
    off = [(name, g, error) for name, g, error in measured if abs(g - 1.0) > max(least, sure * error)]
    usual = (1.0, 1.0) if declared.joint else (1.0 / limits.GAIN_OF_OTHER, limits.GAIN_OF_OTHER)
    return [each for each in off if not usual[0] <= each[1] <= usual[1]]


def _gain_rows(log: str, beside: str, gain: LogDifferences | None, declared: Declared) -> Iterator[CheckRow]:
    """A log whose inputs are all too small or too large: another probe, another range of the amplifier."""
    allowed = "± 3 %" if declared.joint else f"1/{limits.GAIN_OF_OTHER:g} … {limits.GAIN_OF_OTHER:g}"
    for name, factor, error in _off(gain, declared):
        percent, side = 100.0 * (1.0 / factor - 1.0), "low" if factor > 1.0 else "high"
        measured = f"{quantity(abs(percent), '%', 100.0 * error / factor**2)} {side}"
        advice = (
            f"against {beside}, the {name} of this log look {measured}: correct its probe ratio (times "
            f"{significant(factor, 3)}), or leave the log out"
        )
        wrong = declared.joint and abs(factor - 1.0) > limits.WRONG_GAIN
        state: State = "wrong" if wrong else "note"
        gate: CheckGate | None = "scale" if wrong else None
        values = in_si("gain", "1", factor, error)
        yield CheckRow(log, f"gain of {name}", measured, allowed, state, gate, advice, values=values)


def _clock_row(log: str, beside: str, clock: Estimate, declared: Declared) -> CheckRow:
    measured = f"{quantity(abs(clock.value), 's', clock.error)} {'later' if clock.value > 0.0 else 'earlier'}"
    advice = (
        f"against {beside}, q of this log answers {measured}: its recorders were not started together; "
        f"{'delay' if clock.value > 0.0 else 'advance'} its inputs by that time, or leave the log out"
    )
    allowed = f"± {quantity(limits.OTHER_CLOCK * declared.sample_interval, 's')}"
    values = in_si("later", "s", clock.value, clock.error)
    return CheckRow(log, "answer of q", measured, allowed, "note", None, advice, values=values)


def _level_row(
    log: str, beside: str, i: int, levels: tuple[float, float], other: LogFacts, declared: Declared
) -> CheckRow:
    unit, (here, there) = declared.inputs[i], levels
    measured = f"{quantity(abs(here - there), unit)} {'higher' if here > there else 'lower'}"
    shown = [quantity(level, unit, like=here - there) for level in levels]
    advice = (
        f"v{i + 1} of this log rests at {shown[0]}, that of {beside} at {shown[1]}: where the drive was off, that is "
        "the probe's error, to be taken off in each log"
    )
    allowed = f"± {short_quantity(limits.OTHER_LEVEL * float(other.peaks[i]), unit)}"
    values = in_si("level", unit, here) | in_si("level_of_first", unit, there)
    return CheckRow(log, f"rest level of v{i + 1}", measured, allowed, "note", None, advice, values=values)


def _zero_row(log: str, beside: str, zero: Estimate, first: LogFacts, declared: Declared) -> CheckRow:
    unit, size = declared.displacement, float(np.nanstd(first.signals.q))
    higher = zero.value > 0.0
    amount = quantity(abs(zero.value), unit, zero.error)
    wrong = abs(zero.value) > max(limits.WRONG_ZERO * size, limits.SIGN_CERTAINTY * zero.error)
    advice = (
        f"against {beside}, q of this log looks {amount} {'high' if higher else 'low'}: if the sensor was zeroed anew, "
        f"{'take that off q in this log' if higher else 'add that to q in this log'}, or leave the log out"
    )
    return CheckRow(
        log, "zero of q", f"{amount} {'high' if higher else 'low'}",
        f"± {short_quantity(limits.OTHER_ZERO * size, unit)}", "wrong" if wrong else "note",
        "device" if wrong else None, advice, values=in_si("zero", unit, zero.value, zero.error),
    )  # fmt: skip
