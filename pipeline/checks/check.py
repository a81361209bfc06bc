"""All checks of a prototype's logs, as rows."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from pipeline.checks import limits
from pipeline.checks.log_facts import InputFacts, LogFacts, log_facts
from pipeline.checks.log_gain import LogGain, log_gain
from pipeline.checks.misfit import misfit
from pipeline.checks.rest_drift import RestDrift
from pipeline.checks.rows import CheckRow, State
from pipeline.checks.weak_form import LogSignals, WeakTerms, scales_of, weak_terms
from pipeline.scoring.wells import Wells
from pipeline.settings import FIELD_LIMIT, FILM_THICKNESS, CheckGate
from pipeline.si_prefix import quantity, scale, short, significant
from pipeline.signals.bandwidth import advised_interval
from pipeline.signals.noise import below_resolution, is_idle, noise_level
from pipeline.signals.plausible_spans import plausible_span, scale_suspicion
from pipeline.signals.signal_quality import takes_both_signs
from pipeline.units import column_suffix, of_joint

_SIDES = ("right (+)", "left (−)")
_ACCEPT_SIDES = (
    "v1 is the left membrane and pushes q to the right, v2 to the left: swap v1 and v2 in [channels], or give q "
    "scale = -1 there; only if this device is wired the other way round, accept it"
)
_ANOTHER_DEVICE = "a log of another device, or the device was changed in between (clamping, pre-strain, load)"


ROUNDING = 1e-9
"""Range of q over its largest value up to which it is constant but for the rounding of its unit."""

ROUGHLY, SELDOM = 0.01, 0.05
"""Of an input's largest value: within so much of its median it has one value. And the share of samples outside of that
up to which it hardly ever changes."""


@dataclass(frozen=True)
class Declared:
    """What the settings say of the device.

    Attributes
    ----------
    squared : bool
        Whether inputs act by their squares.
    displacement, inputs : str, tuple of str
        SI units.
    mass : float or None
        Moving mass [kg], if stated.
    sample_interval : float
        Of the identification [s].
    film_thickness, field_limit : float
        Thickness of the undeformed film of a joint [m], and the largest field in it [V/m].
    """

    squared: bool
    displacement: str
    inputs: tuple[str, ...]
    mass: float | None
    sample_interval: float
    film_thickness: float = 1e-6 * FILM_THICKNESS
    field_limit: float = 1e6 * FIELD_LIMIT

    @property
    def joint(self) -> bool:
        """Whether it can be the joint: two squared voltages on a length. Others are checked as far as that applies."""
        return of_joint(self.displacement, self.inputs, squared=self.squared)


def check_logs(logs: Sequence[LogSignals], declared: Declared) -> list[CheckRow]:
    """Look at every log, then compare each with the first, which is a training log.

    Cost: 0.3 s of processor time for each log of 40,000 samples.
    """
    facts = [log_facts(log, declared.sample_interval, squared=declared.squared, joint=declared.joint) for log in logs]
    lags = [fact.lag for fact in facts if fact.lag is not None]  # what one log tells of a device is so in all
    facts = [replace(fact, lag=lags[0]) if lags and fact.lag is None else fact for fact in facts]
    rows = [row for fact in facts for row in _of_log(fact, declared)]
    if sum(len(fact.starts) for fact in facts) >= limits.UNDRIVEN_STARTS:
        rows += [_start_row(fact) for fact in facts if fact.starts]
    for other in facts[1:]:
        gain = _gain(facts[0], other, declared)
        if gain is not None and not _gain_explains(facts[0], other, declared, gain):
            gain = None
        rows += _gain_rows(facts[0], other, gain)
        rows.append(_device_row(facts[0], other, declared, gain))
    return rows


def _of_log(fact: LogFacts, declared: Declared) -> list[CheckRow]:
    rows = [*_unit_rows(fact, declared), _resolution_row(fact, declared), *_rate_rows(fact, declared)]
    rows += [*_wrapped_rows(fact, declared), _natural_row(fact, declared), _ring_row(fact), _rest_row(fact, declared)]
    if fact.drift is not None:
        rows.append(_drift_row(fact, fact.drift, declared))
    if fact.undriven >= limits.UNDRIVEN_SNAPS:
        rows.append(_undriven_row(fact))
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


def _unit_rows(fact: LogFacts, declared: Declared) -> list[CheckRow]:
    rows = []
    names = ("q", *(f"v{i + 1}" for i in range(fact.peaks.size)))
    spans, units = (fact.span, *fact.peaks.tolist()), (declared.displacement, *declared.inputs)
    for name, span, unit in zip(names, spans, units, strict=True):
        circuit = declared.displacement == "V"  # which is built for whatever voltages it was built for
        allowed = None if circuit else plausible_span(unit, joint=declared.joint)
        limit = " … ".join(_short(end, unit) for end in allowed) if allowed else ""
        wrong = None if circuit else scale_suspicion(span, unit, joint=declared.joint)
        still, advice = name == "q" and span <= ROUNDING * float(np.nanmax(np.abs(fact.signals.q))), ""
        if still:
            advice = "q does not move: name the channel of its sensor, and see whether that has its target"
        elif wrong:
            advice = f"check the unit of {name} in [channels]: its numbers look {_times(wrong)} as large as a joint's"
        # A voltage too small may be one that is not used; if it pushes all the same, the coupling tells.
        judged = declared.joint and (still or (wrong is not None and (name == "q" or wrong > 1.0)))
        state: State = "wrong" if judged else "note" if still or wrong is not None else "ok"
        gate: CheckGate | None = "scale" if state == "wrong" else None
        values = _values("range", unit, span)
        measured = quantity(span, unit)
        rows.append(
            CheckRow(fact.signals.name, f"range of {name}", measured, limit, state, gate, advice, values=values)
        )
    return rows


def _resolution_row(fact: LogFacts, declared: Declared) -> CheckRow:
    log, unit = fact.signals, declared.displacement
    noise = "" if log.noise is None else f"noise {quantity(log.noise, unit)}"
    if log.noise is not None and below_resolution(log.noise, log.resolution):
        noise = "noise below that"
    if log.resolution is None:
        return CheckRow(log.name, "resolution of q", "no steps", "", more=noise)
    fine = log.resolution <= limits.MOST_RESOLUTION * fact.span
    limit = f"≤ {_short(limits.MOST_RESOLUTION * fact.span, unit)}"
    state: State = "ok" if fine else "note"
    advice = "" if fine else "velocities come in steps: use the sensor's finer range, or average before recording"
    values = _values("resolution", unit, log.resolution) | _values("noise", unit, log.noise)
    measured = quantity(log.resolution, unit)
    return CheckRow(log.name, "resolution of q", measured, limit, state, None, advice, noise, values)


def _rate_rows(fact: LogFacts, declared: Declared) -> list[CheckRow]:
    log, interval = fact.signals, declared.sample_interval
    rate = 1.0 / log.raw_step
    rates = [CheckRow(log.name, "sampling rate", quantity(rate, "Hz"), "", values=_values("rate", "Hz", rate))]
    if fact.ring is None:
        return rates
    per_period = 1.0 / (fact.ring * interval)
    enough = per_period >= limits.LEAST_PER_PERIOD
    measured, limit = f"{per_period:.{0 if per_period >= 2.0 else 1}f} samples", f"≥ {limits.LEAST_PER_PERIOD:g}"
    finer = advised_interval(fact.ring, log.raw_step)
    advice = "" if enough or finer >= interval else f"set [ingest] sample_interval = {finer:g}"
    values = _values("samples_per_period", "1", per_period)
    state: State = "ok" if enough else "note"
    return [*rates, CheckRow(log.name, "uniform, a period", measured, limit, state, None, advice, values=values)]


def _ring_row(fact: LogFacts) -> CheckRow:
    name = fact.signals.name
    if fact.ring is None or fact.damping is None:
        return CheckRow(name, "ring-down", "no clear ring-down after a switch-off", "", "not seen")
    measured = f"{quantity(fact.ring, 'Hz')}, ζ = {significant(fact.damping, 2)}"
    values = _values("frequency", "Hz", fact.ring) | _values("damping_ratio", "1", fact.damping)
    return CheckRow(name, "ring-down", measured, "", values=values)


def _drift_row(fact: LogFacts, drift: RestDrift, declared: Declared) -> CheckRow:
    unit, lasts = declared.displacement, float(np.ptp(fact.signals.t))
    advice = (
        f"the places of rest move by {quantity(drift.rate * lasts, unit)} over the log: let the sensor warm up, fix "
        "its mount, or take the drift off q"
    )
    measured = f"{quantity(drift.rate, f'{unit}/s', drift.error)} over {drift.rests} rests"
    values = _values("drift", f"{unit}/s", drift.rate, drift.error)
    return CheckRow(fact.signals.name, "drift of the rests", measured, "", "note", None, advice, values=values)


def _undriven_row(fact: LogFacts) -> CheckRow:
    named = "the input is" if len(fact.inputs) == 1 else "all inputs are"
    measured = str(fact.undriven)
    return CheckRow(fact.signals.name, f"snaps while {named} off", measured, "", "note", None, _not_named(fact))


def _start_row(fact: LogFacts) -> CheckRow:
    places = ", ".join(f"{start:.4g}" for start in fact.starts[: limits.MOST_PLACES])
    measured = f"{len(fact.starts)}, at {places}{' …' if len(fact.starts) > limits.MOST_PLACES else ''} s"
    return CheckRow(
        fact.signals.name, "leaves rest though no input changes", measured, "", "note", None, _not_named(fact)
    )  # fmt: skip


def _not_named(fact: LogFacts) -> str:
    missing = (
        "name the second input as v2 (in [channels], or as an argument)" if len(fact.inputs) == 1
        else "find out what does"
    )  # fmt: skip
    return f"what moves q there is not among the inputs: {missing}"


def _natural_row(fact: LogFacts, declared: Declared) -> CheckRow:
    name, what = fact.signals.name, "natural frequency"
    if fact.natural is None:
        return CheckRow(name, what, "no stable rest in the motion", "", "not seen")
    measured, values = quantity(fact.natural, "Hz"), _values("frequency", "Hz", fact.natural)
    if not declared.joint:
        return CheckRow(name, what, measured, "", values=values)
    low, high = limits.DRAWN_RING_DOWN / limits.MOST_RATIO, limits.DRAWN_RING_DOWN * limits.MOST_RATIO
    limit = f"{significant(low, 1)} … {significant(high, 2)} Hz"
    if low <= fact.natural <= high:
        return CheckRow(name, what, measured, limit, values=values)
    advice = "check the unit of time in [channels] and the recorder's clock"
    return CheckRow(name, what, measured, limit, "wrong", "time-base", advice, values=values)


def _push_row(fact: LogFacts, i: int, driven: InputFacts, declared: Declared) -> CheckRow:
    push, what = driven.push, f"push of v{i + 1}"
    unit = f"{declared.displacement}/s²"
    measured, values = quantity(push.value, unit, push.error), _values("push", unit, push.value, push.error)
    if abs(push.value) <= limits.SIGN_CERTAINTY * push.error:
        state: State = "note" if declared.joint else "not seen"
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
    values = _values("delay", "s", delay.value, delay.error)
    if not declared.joint:
        return CheckRow(fact.signals.name, what, measured, "", values=values)
    intervals = abs(delay.value) / declared.sample_interval
    sure = abs(delay.value) > limits.SIGN_CERTAINTY * delay.error
    unsure = abs(driven.push.value) <= limits.SIGN_CERTAINTY * driven.push.error
    noted = sure and intervals > limits.NOTED_DELAY
    if noted and fact.lag is not None and 0.0 < delay.value < limits.OF_LAG * fact.lag:
        advice = (
            f"a lag of about {_short(fact.lag, 's')} explains it better than any delay, as of electrodes that charge "
            'slowly: hybrid estimates it, rbf with drive = "lag" in [identify]'
        )
        return CheckRow(fact.signals.name, what, measured, "", "note", None, advice, values=values)
    late = sure and intervals > limits.MOST_DELAY
    advice = f"v{i + 1} hardly moves q: see first whether it is the channel that drives this device; then " * unsure
    advice += (
        "bring the recorders to one clock: shift the voltages by that time, and record both with one trigger; if the "
        "inputs do act late (a filter, a slow drive, electrodes that charge slowly), hybrid estimates by how much, and "
        'rbf with drive = "lag" or "delay" in [identify]'
    )
    if delay.value > 0.0:
        window = f"average = {significant(2.0 * delay.value, 2)} in [channels] q"
        advice += f"; if the sensor of q averages over a window, give that, of twice the delay: {window}"
    return CheckRow(
        fact.signals.name,
        what,
        measured,
        f"± {_short((limits.MOST_DELAY if late else limits.NOTED_DELAY) * declared.sample_interval, 's')}",
        "wrong" if late and not unsure else "note" if noted else "ok",
        "delay" if late and not unsure else None,
        advice if noted else "",
        values=values,
    )


def _wrapped_rows(fact: LogFacts, declared: Declared) -> list[CheckRow]:
    """An angle that jumps by a turn where it leaves the interval that it is kept in."""
    turns = fact.span / (2.0 * np.pi)
    if declared.displacement != "rad" or not limits.WRAPPED[0] < turns < limits.WRAPPED[1]:
        return []
    q = fact.signals.q
    jumps = int(np.count_nonzero(np.diff((np.abs(q[3:] - q[:-3]) > limits.TURN * fact.span).astype(np.int8)) > 0))
    if not jumps:
        return []
    advice = "unwrap it before it is logged or read (numpy.unwrap, MATLAB's unwrap): a turn is no motion of the device"
    measured = f"{jumps} by {_short(fact.span, 'rad')}"
    return [CheckRow(fact.signals.name, "jumps of the angle", measured, "none", "wrong", "wrapped", advice)]


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
    state: State = "wrong" if off > allowed else "note" if off > limits.NOTED_RATIO else "ok"
    if declared.mass is None:
        what, advice = f"coupling if of {1e3 * limits.DRAWN_MASS:g} g", "check the units of the channels"
    else:
        shown = quantity(1e3 * mass, "g") if mass < 1.0 else f"{significant(mass)} kg"
        what, advice = f"coupling with {shown}", "check the unit of plant.mass, then those of the channels"
    stiffness = "" if fact.ring is None else quantity(mass * (2.0 * np.pi * fact.ring) ** 2, "N/m")
    most = limits.NOTED_RATIO if state == "note" else allowed
    low, high = limits.DRAWN_COUPLING / most, limits.DRAWN_COUPLING * most
    return [
        CheckRow(
            fact.signals.name,
            what,
            f"{significant(1e9 * coupling)} nN/V²",
            f"{significant(1e9 * low, 2)} … {significant(1e9 * high, 2)} nN/V²",
            state,
            "scale" if state == "wrong" else None,
            "" if state == "ok" else f"that is {_times(ratio)} the coupling of the joint as drawn: {advice}",
            f"stiffness in the wells {stiffness}" if stiffness else "",
            _values("coupling", "N/V²", coupling),
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
            values=_values("ratio", "1", ratio),
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
    values = _values("correlation", "1", correlation)
    return [CheckRow(fact.signals.name, "v2 beside v1", measured, limit, "note", None, advice, values=values)]


def _field_row(fact: LogFacts, declared: Declared) -> CheckRow:
    """The largest field in the undeformed film, at the larger voltage."""
    field, limit = float(fact.peaks.max()) / declared.film_thickness, declared.field_limit
    above, film = field > limits.MOST_OF_FIELD * limit, quantity(declared.film_thickness, "m")
    limit_shown = f"{significant(1e-6 * limit)} (+{100.0 * (limits.MOST_OF_FIELD - 1.0):.0f} %)"
    advice = f"a film of {film} may break down: lower the voltage, or give film_thickness and field_limit in [plant]"
    return CheckRow(
        fact.signals.name, "largest field", f"{significant(1e-6 * field)} V/µm", f"≤ {limit_shown} V/µm",
        "note" if above else "ok", None, advice if above else "", values=_values("field", "V/m", field),
    )  # fmt: skip


def _rest_level_rows(fact: LogFacts, declared: Declared) -> list[CheckRow]:
    """A joint's voltage of one sign whose lowest level is not zero; one of two signs may switch between them.

    What drives another device, as a fan, need never have been off, and an offset would bend the law of its square.
    """
    rows = []
    for i, (peak, unit) in enumerate(zip(fact.peaks.tolist(), declared.inputs, strict=True)):
        if takes_both_signs(float(np.min(fact.signals.v[:, i])), float(np.max(fact.signals.v[:, i]))):
            continue
        size = np.abs(fact.signals.v[:, i])
        level = float(np.quantile(size, limits.OFF_SHARE))
        rests = float(np.mean(size <= level + limits.REST_LEVEL * peak)) >= limits.REST_SHARE
        if level > limits.REST_LEVEL * peak and rests:
            signed = float(np.copysign(level, np.median(fact.signals.v[size <= level + limits.REST_LEVEL * peak, i])))
            measured, against = quantity(signed, unit), quantity(-signed, unit)
            advice = (
                f"v{i + 1} never returns to zero: if its drive was off at some time, that is the probe's error; add "
                f"{against} to its `offset` in [channels]"
            )
            limit = f"≤ {_short(limits.REST_LEVEL * peak, unit)}"
            values, what = _values("level", unit, signed), f"lowest level of v{i + 1}"
            rows.append(CheckRow(fact.signals.name, what, measured, limit, "note", None, advice, values=values))
    return rows


def _law_rows(fact: LogFacts, declared: Declared) -> list[CheckRow]:
    """Whether the inputs act as the settings say; of inputs of one sign only where the other law explains more."""
    own, other = fact.unexplained, fact.under_other_law
    if own is None or other is None:
        return []
    laws = ("squared", "linear") if declared.squared else ("linear", "squared")
    measured = f"{laws[0]} leaves {significant(100.0 * own, 2)} %, {laws[1]} {significant(100.0 * other, 2)} %"
    values = _values(f"left_by_{laws[0]}", "1", own) | _values(f"left_by_{laws[1]}", "1", other)
    fits = other >= (limits.OTHER_LAW if fact.both_signs else limits.OTHER_LAW_OF_ONE_SIGN) * own
    if fits:
        return (
            [CheckRow(fact.signals.name, "law of the inputs", measured, "", values=values)] if fact.both_signs else []
        )
    why = "an input takes both signs and explains" if fact.both_signs else "the inputs explain"
    advice = f'{why} more so: set inputs = "{laws[1]}" (in [plant], or as an argument)'
    return [CheckRow(fact.signals.name, "law of the inputs", measured, "", "note", None, advice, values=values)]


def _values(name: str, unit: str, value: float | None, error: float | None = None) -> dict[str, float]:
    """A number for `CheckRow.values` under a key with its SI unit, and its standard error; nothing where it is none."""
    end = "" if unit == "1" else f"_{column_suffix(unit)}"
    numbers = {f"{name}{end}": value, f"{name}_error{end}": error}
    return {key: float(number) for key, number in numbers.items() if number is not None and np.isfinite(number)}


def _short(value: float, unit: str) -> str:
    """A round number with its unit."""
    shown, factor = scale(unit, value)
    return f"{short(value * factor)} {shown}"


def _times(ratio: float | None) -> str:
    if ratio is None:
        return ""
    return f"{significant(ratio, 2)} times" if ratio >= 1.0 else f"1/{significant(1.0 / ratio, 2)}"


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
        values = _values("gain", "1", factor, error)
        rows.append(CheckRow(other.signals.name, what, measured, "± 3 %", state, gate, advice, values=values))
    return rows


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
    same, lasts = measured.ratio <= limits.MOST_MISFIT, min(float(np.ptp(fact.signals.t)) for fact in (first, other))
    sure = declared.joint and measured.ratio > limits.SURELY_MISFIT and measured.unexplained <= limits.MOST_UNEXPLAINED
    coarsest = max(fact.signals.interval for fact in (first, other)) / declared.sample_interval
    sure = sure and lasts > limits.SURE_LENGTH * declared.sample_interval and coarsest < limits.SURE_INTERVAL
    sure = sure and _driven_alike(first, other)
    values = _values("misfit", "1", measured.ratio)
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


def _rest_row(fact: LogFacts, declared: Declared) -> CheckRow:
    name, unit = fact.signals.name, declared.displacement
    if not isinstance(fact.wells, Wells):
        reason = fact.wells.reason if declared.joint else fact.wells.reason.partition(":")[0]
        return CheckRow(name, "rests", reason, "", "not seen")
    measured = f"{quantity(fact.wells.left, unit)}, {quantity(fact.wells.right, unit)}"
    values = _values("left", unit, fact.wells.left) | _values("right", unit, fact.wells.right)
    if not declared.joint or fact.wells.left < 0.0 < fact.wells.right:
        return CheckRow(name, "rests", measured, "", values=values)
    middle = quantity(-0.5 * (fact.wells.left + fact.wells.right), unit)
    advice = (
        "both wells are on one side of zero, where a joint, its parameter set and its mirror plane have the middle: "
        f"zero the sensor, or give `offset` in [channels] q (about {middle})"
    )
    return CheckRow(name, "rests", measured, "left < 0 < right", "note", None, advice, values=values)


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
