"""Rows on the inputs of one log: side, law, scale and level of each, whether they act apart, and late answers."""

import numpy as np

from ..device.parameters import NOMINAL
from ..numerics.arrays import FloatArray
from ..scoring.wells import Wells
from ..signals.noise import is_idle, noise_level
from ..signals.signal_quality import takes_both_signs, usual_span
from ..units.quantity import quantity, significant
from . import limits
from .declared import Declared
from .log_facts import LogFacts, Push
from .rows import CheckRow, State, in_si, short_quantity, times_text

_SIDES = ("right (+)", "left (−)")

_ACCEPT_SIDES = (
    "v1 is the left membrane and pushes q to the right, v2 to the left: swap v1 and v2 in [channels], or give q "
    "scale = -1 there; only if this device is wired the other way round, accept it"
)


def input_rows(fact: LogFacts, declared: Declared) -> list[CheckRow]:
    """The rows on the inputs of a log."""
    rows = [
        _unseen_push_row(fact, i) if push is None else _push_row(fact, i, push, declared)
        for i, push in enumerate(fact.pushes)
    ]
    rows += [_noise_row(fact, i, declared) for i in range(len(fact.pushes))]
    rows += [*_correlated_rows(fact, declared), *_law_rows(fact, declared)]
    if declared.joint:
        rows += [*_late_rows(fact, declared), _field_row(fact, declared), *_rest_level_rows(fact, declared)]
        rows += [*_scale_rows(fact, declared), *_side_rows(fact)]
    return rows


def _unseen_push_row(fact: LogFacts, i: int) -> CheckRow:
    """Of an input whose push the log does not show: as it is never on, or hardly ever changes."""
    name = fact.signals.name
    what = f"push of v{i + 1}"
    v = fact.signals.v[:, i]
    if np.ptp(v) > 0.0 and is_idle(v):
        advice = f"where no training log drives v{i + 1}, leave it out of [channels]: nothing is known of its gain"
        return CheckRow(name, what, "nothing but noise", "", "note", None, advice)
    advice = "name the channel that drives the device, or leave it out for a device with one input"
    if fact.peaks[i] == 0.0:
        return CheckRow(name, what, "never on", "", "note", None, advice)
    return CheckRow(name, what, "hardly ever changes", "", "not seen", None, advice)


def _push_row(fact: LogFacts, i: int, push: Push, declared: Declared) -> CheckRow:
    """To which side an input pushes; how strongly depends on the motion, so the number is left to `values`."""
    what = f"push of v{i + 1}"
    values = in_si("push", f"{declared.displacement}/s²", push.value)
    if not push.sure:
        return CheckRow(fact.signals.name, what, "not sure", "", "not seen", values=values)
    side = _SIDES[0] if push.value > 0.0 else _SIDES[1]
    if not declared.joint or side == _SIDES[i]:
        return CheckRow(fact.signals.name, what, side, _SIDES[i] if declared.joint else "", values=values)
    return CheckRow(fact.signals.name, what, side, _SIDES[i], "wrong", "sides", _ACCEPT_SIDES, values=values)


def _noise_row(fact: LogFacts, i: int, declared: Declared) -> CheckRow:
    """Noise of an input that is measured; a command has none, and an amplifier need not follow it."""
    v = fact.signals.v[:, i]
    noise = noise_level(v)
    if noise <= np.finfo(np.float32).eps * fact.peaks[i]:
        return CheckRow(
            fact.signals.name,
            f"noise of v{i + 1}",
            "none: a command?",
            "",
            more="a measurement has noise; an amplifier need not follow a command",
        )
    values = in_si("noise", declared.inputs[i], noise)
    return CheckRow(fact.signals.name, f"noise of v{i + 1}", quantity(noise, declared.inputs[i]), "", values=values)


def _late_rows(fact: LogFacts, declared: Declared) -> list[CheckRow]:
    """A joint that answers its inputs surely late, or before they change; another device may do so by its nature."""
    if abs(fact.late) < limits.LATE * declared.sample_interval:
        return []
    later = fact.late > 0.0
    about = short_quantity(abs(fact.late), "s")
    advice = "q moves before its inputs: start both recorders by one trigger"
    if later:
        advice = (
            "start both recorders by one trigger; if the sensor of q averages over a window, give that as `average` in "
            "[channels] q; if the inputs do act late (a filter, a slow drive, electrodes that charge slowly), hybrid "
            'estimates by how much, and rbf with drive = "lag" or "delay" in [identify.structure]'
        )
    return [
        CheckRow(
            fact.signals.name, "answer of q", f"about {about} {'late' if later else 'early'}",
            f"± {short_quantity(limits.LATE * declared.sample_interval, 's')}", "note", None, advice,
            values=in_si("late", "s", fact.late),
        )
    ]  # fmt: skip


def _scale_rows(fact: LogFacts, declared: Declared) -> list[CheckRow]:
    """Mass and units: what they make of the coupling of a membrane, half the slope of its capacitance over q."""
    couplings = _couplings(fact)
    if not couplings:
        return []
    mass = NOMINAL.m if declared.mass is None else declared.mass
    allowed = limits.UNSTATED_RATIO if declared.mass is None else limits.RATIO
    ratio = max((mass * each / limits.DRAWN_COUPLING for each in couplings), key=lambda r: max(r, 1.0 / r))
    state: State = "wrong" if max(ratio, 1.0 / ratio) > allowed else "ok"
    what = f"coupling if of {1e3 * mass:g} g"
    advice = "check the units of the channels"
    if declared.mass is not None:
        shown = quantity(1e3 * mass, "g") if mass < 1.0 else f"{significant(mass)} kg"
        what = f"coupling with {shown}"
        advice = "check the unit of plant.mass, then those of the channels"
    return [
        CheckRow(
            fact.signals.name, what, f"{significant(ratio, 2)} × as drawn",
            f"{1.0 / allowed:.2g} … {allowed:g}", state, "scale" if state == "wrong" else None,
            "" if state == "ok" else f"that is {times_text(ratio)} the coupling of the joint as drawn: {advice}",
            values=in_si("coupling", "N/V²", ratio * limits.DRAWN_COUPLING),
        )
    ]  # fmt: skip


def _couplings(fact: LogFacts) -> list[float]:
    """Push over the squared peak of every input that surely pushes [m/s²/V²]."""
    return [
        abs(push.value) / peak**2
        for push, peak in zip(fact.pushes, fact.peaks.tolist(), strict=True)
        if push is not None and push.sure
    ]


def _side_rows(fact: LogFacts) -> list[CheckRow]:
    """Membranes of one joint couple about as strongly."""
    couplings = _couplings(fact)
    if len(couplings) < 2 or not isinstance(fact.wells, Wells):
        return []
    ratio = couplings[0] / couplings[1]
    off = max(ratio, 1.0 / ratio)
    state: State = "note" if off > limits.SIDES else "ok"
    advice = (
        "" if state == "ok"
        else f"voltages wrong by {significant(off**0.5, 2)} on one side do that: check the unit and `scale` of both "
        "channels, and the ratio of both probes"
    )  # fmt: skip
    return [
        CheckRow(
            fact.signals.name, "coupling of v1 over v2", significant(ratio, 2),
            f"1/{limits.SIDES:g} … {limits.SIDES:g}", state, None, advice, values=in_si("ratio", "1", ratio),
        )
    ]  # fmt: skip


def _correlated_rows(fact: LogFacts, declared: Declared) -> list[CheckRow]:
    """Two inputs of which one says all that the other does."""
    if None in fact.pushes or len(fact.pushes) < 2:
        return []
    acting = np.square(fact.signals.v) if declared.squared else fact.signals.v
    correlation = float(np.corrcoef(acting[np.isfinite(acting).all(axis=1)].T)[0, 1])
    if abs(correlation) < limits.CORRELATED:
        return []
    advice = (
        "v1 and v2 go together all the time, so what each does cannot be told apart: drive them apart, or leave v2 out"
    )
    measured = f"correlation {correlation:.4f}"
    limit = f"< {limits.CORRELATED:g}"
    values = in_si("correlation", "1", correlation)
    return [CheckRow(fact.signals.name, "v2 beside v1", measured, limit, "note", None, advice, values=values)]


def _field_row(fact: LogFacts, declared: Declared) -> CheckRow:
    """The largest field in the undeformed film, at the larger voltage that three samples reach: noise alone is none."""
    largest = max(abs(end) for column in fact.signals.v.T for end in usual_span(column))
    field = largest / declared.film_thickness
    limit = declared.field_limit
    film = quantity(declared.film_thickness, "m")
    advice = ""
    if field > limits.FIELD * limit:
        advice = (
            f"a film of {film} may break down: lower the voltage, or give film_thickness and field_limit in [plant]"
        )
    if not limit / limits.RATIO < field < limit * limits.RATIO and largest > 0.0:
        stated = quantity(limit, "V/m")
        advice = f"check the units of plant.film_thickness ({film}) and plant.field_limit ({stated})"
    return CheckRow(
        fact.signals.name, "largest field", f"{significant(1e-6 * field)} V/µm",
        f"≤ {significant(1e-6 * limit)} (+{100.0 * (limits.FIELD - 1.0):.0f} %) V/µm", "note" if advice else "ok",
        None, advice, values=in_si("field", "V/m", field),
    )  # fmt: skip


def _rest_level_rows(fact: LogFacts, declared: Declared) -> list[CheckRow]:
    """A joint's voltage of one sign whose lowest level is not zero; one of two signs may switch between them.

    What drives another device, as a fan, need never have been off, and an offset would bend the law of its square.
    """
    rows = []
    for i, (peak, unit) in enumerate(zip(fact.peaks.tolist(), declared.inputs, strict=True)):
        level = rest_level(fact.signals.v[:, i])
        if level is not None and abs(level) > limits.REST_LEVEL * peak:
            measured = quantity(level, unit)
            against = quantity(-level, unit)
            advice = (
                f"v{i + 1} never returns to zero: if its drive was off at some time, that is the probe's error; add "
                f"{against} to its `offset` in [channels]"
            )
            limit = f"≤ {short_quantity(limits.REST_LEVEL * peak, unit)}"
            values = in_si("level", unit, level)
            what = f"rest level of v{i + 1}"
            rows.append(CheckRow(fact.signals.name, what, measured, limit, "note", None, advice, values=values))
    return rows


def rest_level(v: FloatArray) -> float | None:
    """The lowest level at which an input of one sign rests for a tenth of the log; None where there is none.

    Parameters
    ----------
    v : FloatArray, shape (N,)
        The input, finite. Of a negative one its magnitude counts.
    """
    if takes_both_signs(float(np.min(v)), float(np.max(v))):
        return None
    sign = -1.0 if -np.min(v) > np.max(v) else 1.0
    low, level, high = np.quantile(sign * v, (0.01, 0.05, 0.1)).tolist()
    rests = high - low <= limits.REST_LEVEL * float(np.max(np.abs(v)))
    return sign * level if rests else None


def _law_rows(fact: LogFacts, declared: Declared) -> list[CheckRow]:
    """Whether the inputs act as the settings say, by what each law leaves of the accelerations."""
    own = fact.unexplained
    other = fact.under_other_law
    if own is None or other is None:
        return []
    laws = ("squared", "linear") if declared.squared else ("linear", "squared")
    measured = f"{significant(100.0 * own, 2)} % ({laws[1]} {significant(100.0 * other, 2)} %)"
    values = in_si(f"left_by_{laws[0]}", "1", own) | in_si(f"left_by_{laws[1]}", "1", other)
    if fact.as_signed_monitor is not None and fact.as_signed_monitor < limits.OTHER_LAW * min(own, other):
        measured += f", two membranes {significant(100.0 * fact.as_signed_monitor, 2)} %"
        advice = (
            'it looks like the signed monitor of two membranes: give it to v1 with part = "positive" and to v2 with '
        )
        advice += 'part = "negative", and set inputs = "squared" in [plant]'
        return [CheckRow(fact.signals.name, "left by the law", measured, "", "note", None, advice, values=values)]
    if other >= limits.OTHER_LAW * own:
        return [CheckRow(fact.signals.name, "left by the law", measured, "", values=values)]
    advice = f'they explain more so: set inputs = "{laws[1]}" (in [plant], or as an argument)'
    return [CheckRow(fact.signals.name, "left by the law", measured, "", "note", None, advice, values=values)]
