"""Rows on the inputs of one log: side, delay, law, scale and level of each, and whether they act apart."""

import numpy as np

from pipeline.checks import limits
from pipeline.checks.declared import Declared
from pipeline.checks.log_facts import InputFacts, LogFacts
from pipeline.checks.rest_level import rest_level
from pipeline.checks.rows import CheckRow, State, in_si, short_quantity, times_text
from pipeline.scoring.wells import Wells
from pipeline.si_prefix import quantity, significant
from pipeline.signals.noise import is_idle, noise_level
from pipeline.signals.signal_quality import takes_both_signs, usual_span

_SIDES = ("right (+)", "left (−)")

_ACCEPT_SIDES = (
    "v1 is the left membrane and pushes q to the right, v2 to the left: swap v1 and v2 in [channels], or give q "
    "scale = -1 there; only if this device is wired the other way round, accept it"
)

ROUGHLY, SELDOM = 0.01, 0.05
"""Of an input's largest value: within so much of its median it has one value. And the share of samples outside of that
up to which it hardly ever changes."""


def input_rows(fact: LogFacts, declared: Declared) -> list[CheckRow]:
    """The rows on the inputs of a log."""
    rows = []
    for i, driven in enumerate(fact.inputs):
        if driven is None:
            rows.append(_unseen_push_row(fact, i))
            continue
        rows += [_push_row(fact, i, driven, declared), _delay_row(fact, i, driven, declared)]
    rows += [*_correlated_rows(fact, declared), *_law_rows(fact, declared)]
    if declared.joint:
        rows += [_field_row(fact, declared), *_rest_level_rows(fact, declared)]
        rows += [*_scale_rows(fact, declared), *_side_rows(fact)]
    return rows


def _unseen_push_row(fact: LogFacts, i: int) -> CheckRow:
    """Of an input whose push the log does not show: as it is never on, hardly ever changes, or does all the same."""
    name, what = fact.signals.name, f"push of v{i + 1}"
    v, peak = fact.signals.v[:, i], float(fact.peaks[i])
    if np.ptp(v) > 0.0 and is_idle(float(np.ptp(v)), noise_level(v)):
        advice = f"where no training log drives v{i + 1}, leave it out of [channels]: nothing is known of its gain"
        return CheckRow(name, what, "nothing but noise", "", "note", None, advice)
    if peak > 0.0 and np.mean(np.abs(v - np.median(v)) > ROUGHLY * peak) > SELDOM:
        advice = "larger changes of the input, or a longer log, show what it does"
        return CheckRow(name, what, "cannot be told apart from the motion", "", "not seen", None, advice)
    advice = "name the channel that drives the device, or leave it out for a device with one input"
    if peak > 0.0:
        return CheckRow(name, what, "hardly ever changes", "", "not seen", None, advice)
    return CheckRow(name, what, "hardly ever on", "", "note", None, advice)


def _push_row(fact: LogFacts, i: int, driven: InputFacts, declared: Declared) -> CheckRow:
    push, what = driven.push, f"push of v{i + 1}"
    unit = f"{declared.displacement}/s²"
    measured, values = quantity(push.value, unit, push.error), in_si("push", unit, push.value, push.error)
    if abs(push.value) <= limits.SIGN_CERTAINTY * push.error:
        state: State = "note" if declared.joint and driven.hardly_moves else "not seen"
        advice = f"v{i + 1} hardly moves q: is it the channel that drives this device?"
        return CheckRow(fact.signals.name, what, measured, "", state, None, advice, values=values)
    if not declared.joint:
        return CheckRow(fact.signals.name, what, measured, "", values=values)
    right = (push.value > 0.0) == (i == 0)
    return CheckRow(
        fact.signals.name,
        what,
        measured,
        _SIDES[i],
        "ok" if right else "wrong",
        None if right else "sides",
        "" if right else _ACCEPT_SIDES,
        values=values,
    )


def _delay_row(fact: LogFacts, i: int, driven: InputFacts, declared: Declared) -> CheckRow:
    delay, what = driven.delay, f"delay of q after v{i + 1}"
    reached = " or more" if driven.at_the_end else ""
    measured = f"{quantity(delay.value, 's', delay.error, like=declared.sample_interval)}{reached}"
    values = in_si("delay", "s", delay.value, delay.error)
    if not declared.joint:
        return CheckRow(fact.signals.name, what, measured, "", values=values)
    intervals = abs(delay.value) / declared.sample_interval
    sure = abs(delay.value) > limits.SIGN_CERTAINTY * delay.error
    unsure = abs(driven.push.value) <= limits.SIGN_CERTAINTY * driven.push.error
    noted = sure and intervals > limits.NOTED_DELAY
    if noted and fact.lag is not None and 0.0 < delay.value < limits.OF_LAG * fact.lag:
        advice = (
            f"a lag of about {short_quantity(fact.lag, 's')} explains it better than any delay, as of electrodes that "
            'charge slowly: hybrid estimates it, rbf with drive = "lag" in [identify.structure]'
        )
        return CheckRow(fact.signals.name, what, measured, "", "note", None, advice, values=values)
    late = sure and intervals > limits.MOST_DELAY
    advice = f"v{i + 1} hardly moves q: see first whether it is the channel that drives this device; then " * unsure
    advice += (
        "bring the recorders to one clock: shift the voltages by that time, and record both with one trigger; if the "
        "inputs do act late (a filter, a slow drive, electrodes that charge slowly), hybrid estimates by how much, and "
        'rbf with drive = "lag" or "delay" in [identify.structure]'
    )
    if delay.value > 0.0:
        window = f"average = {significant(2.0 * delay.value, 2)} in [channels] q"
        advice += f"; if the sensor of q averages over a window, give that, of twice the delay: {window}"
    return CheckRow(
        fact.signals.name,
        what,
        measured,
        f"± {short_quantity((limits.MOST_DELAY if late else limits.NOTED_DELAY) * declared.sample_interval, 's')}",
        "wrong" if late and not unsure else "note" if noted else "ok",
        "delay" if late and not unsure else None,
        advice if noted else "",
        values=values,
    )


def _scale_rows(fact: LogFacts, declared: Declared) -> list[CheckRow]:
    """Mass and units: what they make of the coupling of a membrane, half the slope of its capacitance over q."""
    pushes = [
        abs(driven.push.value) / float(peak) ** 2
        for driven, peak in zip(fact.inputs, fact.peaks, strict=True)
        if driven is not None and abs(driven.push.value) > limits.SIGN_CERTAINTY * driven.push.error
    ]
    if not pushes:
        return []
    mass = limits.DRAWN_MASS if declared.mass is None else declared.mass
    allowed = limits.UNSTATED_RATIO if declared.mass is None else limits.MOST_RATIO
    ratio = max((mass * push / limits.DRAWN_COUPLING for push in pushes), key=lambda r: max(r, 1.0 / r))
    coupling, off = ratio * limits.DRAWN_COUPLING, max(ratio, 1.0 / ratio)
    state: State = "wrong" if off > allowed else "ok"
    if declared.mass is None:
        what, advice = f"coupling if of {1e3 * limits.DRAWN_MASS:g} g", "check the units of the channels"
    else:
        shown = quantity(1e3 * mass, "g") if mass < 1.0 else f"{significant(mass)} kg"
        what, advice = f"coupling with {shown}", "check the unit of plant.mass, then those of the channels"
    stiffness = "" if fact.ring is None else quantity(mass * (2.0 * np.pi * fact.ring) ** 2, "N/m")
    low, high = limits.DRAWN_COUPLING / allowed, limits.DRAWN_COUPLING * allowed
    return [
        CheckRow(
            fact.signals.name,
            what,
            f"{significant(1e9 * coupling)} nN/V²",
            f"{significant(1e9 * low, 2)} … {significant(1e9 * high, 2)} nN/V²",
            state,
            "scale" if state == "wrong" else None,
            "" if state == "ok" else f"that is {times_text(ratio)} the coupling of the joint as drawn: {advice}",
            f"stiffness in the wells {stiffness}" if stiffness else "",
            in_si("coupling", "N/V²", coupling),
        )
    ]


def _side_rows(fact: LogFacts) -> list[CheckRow]:
    """Membranes of one joint couple about as strongly."""
    driven = [each for each in fact.inputs if each is not None]
    unsure = any(abs(each.push.value) <= limits.SIGN_CERTAINTY * each.push.error for each in driven)
    if len(driven) < 2 or unsure or not isinstance(fact.wells, Wells):
        return []
    left, right = (abs(each.push.value) / float(peak) ** 2 for each, peak in zip(driven, fact.peaks, strict=True))
    ratio = left / right
    off = max(ratio, 1.0 / ratio)
    state: State = "wrong" if off > limits.MOST_SIDES else "note" if off > limits.NOTED_SIDES else "ok"
    most = limits.MOST_SIDES if state == "wrong" else limits.NOTED_SIDES
    advice = (
        "" if state == "ok"
        else f"voltages wrong by {significant(off**0.5, 2)} on one side do that: check the unit and `scale` of both "
        "channels, and the ratio of both probes"
    )  # fmt: skip
    return [
        CheckRow(
            fact.signals.name, "coupling of v1 over v2", significant(ratio, 3),
            f"1/{most:g} … {most:g}", state, "scale" if state == "wrong" else None, advice,
            values=in_si("ratio", "1", ratio),
        )
    ]  # fmt: skip


def _correlated_rows(fact: LogFacts, declared: Declared) -> list[CheckRow]:
    """Two inputs of which one says all that the other does."""
    if None in fact.inputs or len(fact.inputs) < 2:
        return []
    acting = np.square(fact.signals.v) if declared.squared else fact.signals.v
    correlation = float(np.corrcoef(acting[np.isfinite(acting).all(axis=1)].T)[0, 1])
    if abs(correlation) < limits.MOST_CORRELATED:
        return []
    advice = (
        "v1 and v2 go together all the time, so what each does cannot be told apart: drive them apart, or leave v2 out"
    )
    measured, limit = f"correlation {correlation:.4f}", f"< {limits.MOST_CORRELATED:g}"
    values = in_si("correlation", "1", correlation)
    return [CheckRow(fact.signals.name, "v2 beside v1", measured, limit, "note", None, advice, values=values)]


def _field_row(fact: LogFacts, declared: Declared) -> CheckRow:
    """The largest field in the undeformed film, at the larger voltage that three samples reach: noise alone is none."""
    largest = max(abs(end) for column in fact.signals.v.T for end in usual_span(column))
    field, limit = largest / declared.film_thickness, declared.field_limit
    above, film = field > limits.MOST_OF_FIELD * limit, quantity(declared.film_thickness, "m")
    limit_shown = f"{significant(1e-6 * limit)} (+{100.0 * (limits.MOST_OF_FIELD - 1.0):.0f} %)"
    advice = f"a film of {film} may break down: lower the voltage, or give film_thickness and field_limit in [plant]"
    advice = _implausible_film(declared) or (advice if above else "")
    return CheckRow(
        fact.signals.name, "largest field", f"{significant(1e-6 * field)} V/µm", f"≤ {limit_shown} V/µm",
        "note" if advice else "ok", None, advice, values=in_si("field", "V/m", field),
    )  # fmt: skip


def _implausible_film(declared: Declared) -> str:
    """What to do of a thickness or a field limit that no film has, as by a slip of its unit; nothing of others."""
    for key, value, unit, (low, high) in (
        ("film_thickness", declared.film_thickness, "m", limits.FILMS),
        ("field_limit", declared.field_limit, "V/m", limits.FIELDS),
    ):
        if not low <= value <= high:
            stated, least, most = (short_quantity(each, unit) for each in (value, low, high))
            return f"plant.{key} is {stated}, which of films is {least} to {most}: check its unit"
    return ""


def _rest_level_rows(fact: LogFacts, declared: Declared) -> list[CheckRow]:
    """A joint's voltage of one sign whose lowest level is not zero; one of two signs may switch between them.

    What drives another device, as a fan, need never have been off, and an offset would bend the law of its square.
    """
    rows = []
    for i, (peak, unit) in enumerate(zip(fact.peaks.tolist(), declared.inputs, strict=True)):
        if takes_both_signs(float(np.min(fact.signals.v[:, i])), float(np.max(fact.signals.v[:, i]))):
            continue
        level = rest_level(fact.signals.v[:, i])
        if level is not None and abs(level) > limits.REST_LEVEL * peak:
            measured, against = quantity(level, unit), quantity(-level, unit)
            advice = (
                f"v{i + 1} never returns to zero: if its drive was off at some time, that is the probe's error; add "
                f"{against} to its `offset` in [channels]"
            )
            limit = f"≤ {short_quantity(limits.REST_LEVEL * peak, unit)}"
            values, what = in_si("level", unit, level), f"rest level of v{i + 1}"
            rows.append(CheckRow(fact.signals.name, what, measured, limit, "note", None, advice, values=values))
    return rows


def _law_rows(fact: LogFacts, declared: Declared) -> list[CheckRow]:
    """Whether the inputs act as the settings say; of inputs of one sign only where the other law explains more."""
    own, other = fact.unexplained, fact.under_other_law
    if own is None or other is None:
        return []
    laws = ("squared", "linear") if declared.squared else ("linear", "squared")
    measured = f"{laws[0]} leaves {significant(100.0 * own, 2)} %, {laws[1]} {significant(100.0 * other, 2)} %"
    values = in_si(f"left_by_{laws[0]}", "1", own) | in_si(f"left_by_{laws[1]}", "1", other)
    if fact.as_signed_monitor is not None and fact.as_signed_monitor < limits.OTHER_LAW * min(own, other):
        measured += f", two membranes {significant(100.0 * fact.as_signed_monitor, 2)} %"
        advice = (
            'it looks like the signed monitor of two membranes: give it to v1 with part = "positive" and to v2 with '
        )
        advice += 'part = "negative", and set inputs = "squared" in [plant]'
        return [CheckRow(fact.signals.name, "law of the inputs", measured, "", "note", None, advice, values=values)]
    fits = other >= (limits.OTHER_LAW if fact.both_signs else limits.OTHER_LAW_OF_ONE_SIGN) * own
    if fits:
        return (
            [CheckRow(fact.signals.name, "law of the inputs", measured, "", values=values)] if fact.both_signs else []
        )
    why = "an input takes both signs and explains" if fact.both_signs else "the inputs explain"
    advice = f'{why} more so: set inputs = "{laws[1]}" (in [plant], or as an argument)'
    return [CheckRow(fact.signals.name, "law of the inputs", measured, "", "note", None, advice, values=values)]
