"""All checks of a prototype's logs without a model: findings, and their table."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Literal

import numpy as np

from ..device.device import Device
from ..device.parameters import NOMINAL
from ..numerics.arrays import FloatArray
from ..scoring.wells import Wells
from ..settings.prototype import Gate
from ..signals.findings import Finding, Number, Severity, scale_suspicion
from ..signals.noise import is_idle, noise_level
from ..signals.signal_quality import takes_both_signs, usual_span
from ..units.units import column_suffix
from . import log_sentences
from .log_facts import FIELD, SURE, InputForce, LogFacts, LogSignals, log_facts

LATE = 2.5
"""Sample intervals from which on q answers its inputs late. Drives, probes, sensors and the creep of the membranes
shift it by up to 1.3 intervals in honest logs; two recorders that start one after the other by far more."""

WRAPPED = 0.7
"""Share of the range of an angle of about one turn that it runs through within three samples where it wraps: one that
is kept within a turn jumps from end to end."""

CORRELATED = 0.999
"""Correlation of the two inputs, as they act, from which on they are one."""

RATIO = 30.0
"""Factor to either side of the coupling of the joint as drawn: half way, in powers of ten, to the 1,000 of a wrong
prefix. A joint built n times as large couples as strongly (capacitance grows as length)."""

UNSTATED_RATIO = 1e5
"""The same where no mass is stated and that of the drawing is taken: a joint of 1 mm and 100 V is 1,800 times off; kV
read as V make 10⁶."""

SIDES = 2.5
"""Factor between the couplings of the two sides that is shown. Membranes are cut from one film: 0.65 to 1.4 in 66 logs
of 15 joints. The square of a wrong probe ratio is in it, 4 for twice the voltage. Shown is what exceeds it by `SURE`
standard errors of the ratio, which chirps of 20 s leave uncertain by an eighth."""

REST_LEVEL = 0.02
"""Share of an input's largest magnitude above which the level at which it rests is shown, and within which it rests."""

OTHER_ACTION = 0.9
"""Times what the weak form leaves of the accelerations, below which the other action of the inputs is shown. Declared
rightly, logs of 16 devices have 0.99 to 1.5."""

DRAWN_COUPLING = 8.5e-9
"""N/V², half the slope of a membrane's capacitance over q, of the joint as drawn."""

RESOLUTION = 0.01
"""Step of the converter, in ranges of q: beyond, velocities come in steps of a few per cent."""
ROUNDING = 1e-9
"""Range of q over its largest value up to which it is constant but for the rounding of its unit."""
_MOST_BESIDE = 2  # logs that the table shows side by side


def input_findings(fact: LogFacts, plant: Device) -> Iterator[Finding]:
    """The findings on the inputs of a log."""
    for i, force in enumerate(fact.input_forces):
        yield _unseen_force(fact, i) if force is None else _force(fact, i, force, plant)
    yield from (_noise(fact, i, plant) for i in range(len(fact.input_forces)))
    yield from (*_correlated(fact, plant), *_input_actions(fact, plant))
    if plant.joint:
        yield from (*_late(fact, plant), _field(fact, plant), *_rest_levels(fact, plant), *_scale(fact, plant))
        yield from _sides(fact)


def _unseen_force(fact: LogFacts, i: int) -> Finding:
    """Finding on an input whose force the log does not show: it is never on, or hardly ever changes."""
    v = fact.signals.v[:, i]
    idle = np.ptp(v) > 0.0 and is_idle(v)
    code = "idle_input" if idle else "never_on" if fact.peaks[i] == 0.0 else "hardly_changes"
    return Finding(code, "unseen" if code == "hardly_changes" else "fair", fact.signals.name, f"v{i + 1}")


def _force(fact: LogFacts, i: int, force: InputForce, plant: Device) -> Finding:
    """Direction of an input's force; its size depends on the motion, so the table has the direction alone."""
    name = fact.signals.name
    numbers = {"push": Number(force.value, f"{plant.displacement.symbol}/s²")}
    if not force.sure:
        return Finding("unsure_push", "unseen", name, f"v{i + 1}", numbers)
    if not plant.joint:
        return Finding("push", "good", name, f"v{i + 1}", numbers)
    right = (force.value > 0.0) == (i == 0)  # v1 is of the left membrane, which pushes to the right
    return Finding("side", "good" if right else "poor", name, f"v{i + 1}", numbers, None if right else "sides")


def _noise(fact: LogFacts, i: int, plant: Device) -> Finding:
    """Noise of an input that is measured; a command has none, and an amplifier need not follow it."""
    noise = noise_level(fact.signals.v[:, i])
    if noise <= np.finfo(np.float32).eps * fact.peaks[i]:
        return Finding("command", "good", fact.signals.name, f"v{i + 1}")
    return Finding(
        "input_noise", "good", fact.signals.name, f"v{i + 1}", {"noise": Number(noise, plant.input_symbols[i])}
    )


def _late(fact: LogFacts, plant: Device) -> Iterator[Finding]:
    """A joint that answers its inputs surely late, or before they change; another device may do so by its nature.

    The angle of a joint does too: voltages turn its tip before it moves.
    """
    most = LATE * fact.sample_interval
    if abs(fact.late) >= most and not plant.angle:
        yield Finding(
            "late_answer", "fair", fact.signals.name, "q", {"late": Number(fact.late, "s"), "most": Number(most, "s")}
        )


def _scale(fact: LogFacts, plant: Device) -> Iterator[Finding]:
    """Findings on mass and units by the coupling of a membrane, half the slope of its capacitance over q."""
    subject, mass, allowed = (
        ("drawn", NOMINAL.m, UNSTATED_RATIO) if plant.known_mass is None else ("stated", plant.known_mass, RATIO)
    )
    ratios = [mass * each / DRAWN_COUPLING for each in _couplings(fact)]
    if ratios:
        ratio = max(ratios, key=lambda r: max(r, 1.0 / r))
        numbers = {
            "coupling": Number(ratio * DRAWN_COUPLING, "N/V²"),
            "ratio": Number(ratio),
            "most": Number(allowed),
            "mass": Number(mass, "kg"),
        }
        wrong = max(ratio, 1.0 / ratio) > allowed
        yield Finding(
            "coupling", "poor" if wrong else "good", fact.signals.name, subject, numbers, "scale" if wrong else None
        )


def _couplings(fact: LogFacts) -> list[float]:
    """Acceleration over the squared peak of every input with a sure direction [m/s²/V²]."""
    return [
        abs(force.value) / peak**2
        for force, peak in zip(fact.input_forces, fact.peaks.tolist(), strict=True)
        if force is not None and force.sure
    ]


def _sides(fact: LogFacts) -> Iterator[Finding]:
    """Findings on the ratio of both couplings: membranes of one joint couple about equally, within their errors."""
    couplings = _couplings(fact)
    if len(couplings) > 1 and isinstance(fact.wells, Wells):
        ratio = couplings[0] / couplings[1]
        error = np.linalg.norm([force.error / force.value for force in fact.input_forces if force is not None])
        alike = abs(np.log(ratio)) <= np.log(SIDES) + SURE * error
        yield Finding(
            "coupling_ratio",
            "good" if alike else "fair",
            fact.signals.name,
            numbers={"ratio": Number(ratio), "most": Number(SIDES)},
        )


def _correlated(fact: LogFacts, plant: Device) -> Iterator[Finding]:
    """Finding on two inputs that act in proportion, so that their effects cannot be separated."""
    if None not in fact.input_forces and len(fact.input_forces) > 1:
        acting = plant.acting(fact.signals.v)
        correlation = float(np.asarray(np.corrcoef(acting[np.isfinite(acting).all(axis=1)].T))[0, 1])
        if abs(correlation) >= CORRELATED:
            yield Finding(
                "correlated",
                "fair",
                fact.signals.name,
                numbers={"correlation": Number(correlation), "most": Number(CORRELATED)},
            )


def _field(fact: LogFacts, plant: Device) -> Finding:
    """The largest field in the undeformed film, at the larger voltage that three samples reach: noise alone is none."""
    largest = max(abs(end) for column in fact.signals.v.T for end in usual_span(column))
    field = largest / plant.film_thickness
    limit = plant.field_limit
    of_units = not limit / RATIO < field < limit * RATIO and largest > 0.0
    return Finding(
        "field_units" if of_units else "field",
        "fair" if of_units or field > FIELD * limit else "good",
        fact.signals.name,
        numbers={
            "field": Number(field, "V/m"),
            "limit": Number(limit, "V/m"),
            "film": Number(plant.film_thickness, "m"),
        },
    )


def _rest_levels(fact: LogFacts, plant: Device) -> Iterator[Finding]:
    """Findings on voltages of one sign whose lowest level is not zero; one of two signs may switch between them.

    What drives another device, as a fan, need never have been off, and an offset would bend the law of its square.
    """
    for i, (peak, unit) in enumerate(zip(fact.peaks.tolist(), plant.input_symbols, strict=True)):
        level = rest_level(fact.signals.v[:, i])
        most = REST_LEVEL * peak
        if level is not None and abs(level) > most:
            yield Finding(
                "rest_level",
                "fair",
                fact.signals.name,
                f"v{i + 1}",
                {"level": Number(level, unit), "most": Number(most, unit)},
            )


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
    return sign * level if high - low <= REST_LEVEL * float(np.max(np.abs(v))) else None


def _input_actions(fact: LogFacts, plant: Device) -> Iterator[Finding]:
    """Test of the inputs' stated action, squared or linear, by the residuals of the accelerations under both."""
    own = fact.unexplained
    other = fact.under_other_action
    signed = fact.as_signed_monitor
    if own is not None and other is not None:
        actions = ("squared", "linear") if plant.squared else ("linear", "squared")
        numbers = {f"left_by_{actions[0]}": Number(own), f"left_by_{actions[1]}": Number(other)}
        if signed is not None and signed < OTHER_ACTION * min(own, other):
            numbers["left_by_membranes"] = Number(signed)
            yield Finding("signed_monitor", "fair", fact.signals.name, actions[1], numbers)
        else:
            as_stated = other >= OTHER_ACTION * own
            yield Finding("law", "good" if as_stated else "fair", fact.signals.name, actions[1], numbers)


def motion_findings(fact: LogFacts, plant: Device) -> Iterator[Finding]:
    """The findings on the motion of a log."""
    name = fact.signals.name
    unit = plant.displacement.symbol
    yield from (*_ranges(fact, plant), _resolution(fact, plant))
    yield Finding("sampling_rate", "good", name, numbers={"rate": Number(1.0 / fact.signals.raw_step, "Hz")})
    if fact.signals.held > 1:  # a sensor or a bus that is slower than the recorder makes a staircase of the motion
        held = fact.signals.held
        numbers = {"held": Number(held), "rate": Number(1.0 / (held * fact.signals.raw_step), "Hz")}
        yield Finding("held", "fair", name, "q", numbers)
    jumps = _turns(fact, plant)
    if jumps:
        yield Finding(
            "wrapped", "poor", name, "q", {"jumps": Number(jumps), "turn": Number(fact.span, "rad")}, "wrapped"
        )
    yield _rests(fact, plant)
    if fact.drift is not None:
        moved = Number(abs(fact.drift) * float(np.ptp(fact.signals.t)), unit)
        yield Finding("drift", "fair", name, "q", {"drift": Number(fact.drift, f"{unit}/s"), "moved": moved})


def starts(facts: Sequence[LogFacts]) -> list[Finding]:
    """The findings on logs that leave a rest though no input changes; none where that is seen once in all.

    No log of 16 prototypes has one; P1 to P3 have 2 to 5 in each log where one of their voltages is left out.
    """
    if sum(len(fact.starts) for fact in facts) < 2:
        return []
    return [
        Finding(
            "undriven_starts",
            "fair",
            fact.signals.name,
            "q",
            {
                "starts": Number(len(fact.starts)),
                "first": Number(fact.starts[0], "s"),
                "inputs": Number(len(fact.input_forces)),
            },
        )
        for fact in facts
        if fact.starts
    ]


def _ranges(fact: LogFacts, plant: Device) -> Iterator[Finding]:
    """Ranges of q and of the inputs against those that a device can have."""
    if plant.angle:
        yield Finding("from_angle", "good", fact.signals.name, "q")
    for name, span, unit in [
        ("q", fact.span, plant.displacement.symbol),
        *((f"v{i}", *each) for i, each in enumerate(zip(fact.peaks.tolist(), plant.input_symbols, strict=True), 1)),
    ]:
        allowed = plant.plausible_span(unit)
        times = scale_suspicion(span, allowed)
        still = name == "q" and span <= ROUNDING * float(np.nanmax(np.abs(fact.signals.q)))
        # A voltage too small may be one that is not used; if it acts all the same, the coupling shows it.
        judged = plant.joint and (still or (times is not None and (name == "q" or times > 1.0)))
        severity: Severity = "poor" if judged else "fair" if still or times is not None else "good"
        numbers = {"range": Number(span, unit)}
        if allowed is not None:
            numbers |= {"least": Number(allowed[0], unit), "most": Number(allowed[1], unit)}
        if times is not None:
            numbers["times"] = Number(times)
        yield Finding(
            "still" if still else "range", severity, fact.signals.name, name, numbers, "scale" if judged else None
        )


def _resolution(fact: LogFacts, plant: Device) -> Finding:
    log = fact.signals
    unit = plant.displacement.symbol
    numbers = {} if log.noise is None else {"noise": Number(log.noise, unit)}
    if log.resolution is None:
        return Finding("resolution", "good", log.name, "q", numbers)
    most = RESOLUTION * fact.span
    numbers |= {"resolution": Number(log.resolution, unit), "most": Number(most, unit)}
    return Finding("resolution", "good" if log.resolution <= most else "fair", log.name, "q", numbers)


def _turns(fact: LogFacts, plant: Device) -> int:
    """Number of jumps of an angle by a turn, where it leaves the interval that it is kept in."""
    if plant.displacement.symbol != "rad" or round(fact.span / (2.0 * np.pi)) != 1:
        return 0
    q = fact.signals.q
    return int(np.count_nonzero(np.diff((np.abs(q[3:] - q[:-3]) > WRAPPED * fact.span).astype(np.int8)) > 0))


def _rests(fact: LogFacts, plant: Device) -> Finding:
    if not isinstance(fact.wells, Wells):
        return Finding("no_rests", "unseen", fact.signals.name, fact.wells.reason.partition(":")[0])
    left, right = (Number(place, plant.displacement.symbol) for place in (fact.wells.left, fact.wells.right))
    severity: Severity = "good" if left.value < 0.0 < right.value or not plant.joint else "fair"
    return Finding("rests", severity, fact.signals.name, "q", {"left": left, "right": right})


def check_logs(logs: Sequence[LogSignals], plant: Device, sample_interval: float) -> list[Finding]:
    """Findings on every log; readings are compared between logs by the fitted model, not here.

    Parameters
    ----------
    logs : sequence of LogSignals
        The logs.
    plant : Device
        Its inputs, and whether it is the joint.
    sample_interval : float
        Sample interval [s] of the identification.

    Notes
    -----
    Cost: 0.06 s of processor time for each log of 40,000 samples.
    """
    facts = [log_facts(log, sample_interval, plant) for log in logs]
    findings = [finding for fact in facts for finding in (*motion_findings(fact, plant), *input_findings(fact, plant))]
    seen = {finding.subject for finding in findings if finding.code in ("side", "push")}  # in some log
    judged = (
        replace(finding, severity="unseen")
        if finding.code in ("idle_input", "never_on") and finding.subject in seen
        else finding
        for finding in findings
    )
    return [*judged, *starts(facts)]


def refusing(findings: Sequence[Finding]) -> list[Finding]:
    """Findings that would make the model wrong: the first of each gate."""
    first = {finding.gate: finding for finding in reversed(findings) if finding.gate is not None}
    return [first[gate] for gate in dict.fromkeys(finding.gate for finding in findings if finding.gate is not None)]


State = Literal["not seen", "ok", "note", "wrong"]
"""ok: within the limit; note: look at it; wrong: the model would be wrong; not seen: the log does not show it."""

STATES: dict[Severity, State] = {"unseen": "not seen", "good": "ok", "fair": "note", "poor": "wrong"}


@dataclass(frozen=True)
class CheckRow:
    """A finding of the check in words, as tables, `check.json` and the page show it.

    Attributes
    ----------
    log : str
        Title of the log.
    what : str
        Subject of the check.
    found, limit : str
        The number, and what it may be; the limit may be empty.
    state : State
    gate : Gate or None
        The name under which the settings can accept it.
    advice : str
        Advice unless the state is ok.
    more : str
        Other numbers that speak for or against it.
    values : mapping of str to float
        The numbers of the finding in SI, the unit at the end of the key, as in ``delay_s``.
    code : str
        That of the finding; empty in runs of earlier releases.
    """

    log: str
    what: str
    found: str
    limit: str
    state: State = "ok"
    gate: Gate | None = None
    advice: str = ""
    more: str = ""
    values: Mapping[str, float] = field(default_factory=dict)
    code: str = ""

    @property
    def remark(self) -> str:
        """Log, numbers, limit and advice in one line."""
        return f"{log_sentences.line(self.log, self.what, self.found, self.more, self.limit)}: {self.advice}"


def check_rows(findings: Sequence[Finding]) -> list[CheckRow]:
    """The findings of a check as rows."""
    return [
        CheckRow(
            log=finding.log,
            what=shown.what,
            found=shown.found,
            limit=shown.limit,
            state=STATES[finding.severity],
            gate=finding.gate,
            advice=shown.advice if finding.severity in ("fair", "poor") else "",
            more=shown.more,
            values=_in_si(finding),
            code=finding.code,
        )
        for finding, shown in zip(findings, map(log_sentences.row, findings), strict=True)
    ]


def remarks(findings: Sequence[Finding]) -> list[str]:
    """Sentences for findings that deserve a look and do not make the model wrong."""
    return [": ".join(log_sentences.of_row(finding)) for finding in findings if finding.severity == "fair"]


def beside(rows: Sequence[CheckRow]) -> tuple[tuple[str, ...], list[tuple[str, ...]]]:
    """The rows as a table: the logs as columns where there are two at most, else the most remarkable of all logs.

    Returns
    -------
    header : tuple of str
    table : list of tuple of str
        Subject, finding, limit; a (!) marks remarkable ones.
    """
    logs = list(dict.fromkeys(row.log for row in rows))
    table = []
    for what in dict.fromkeys(row.what for row in rows):
        kind = [row for row in rows if row.what == what]
        worst = max(kind, key=lambda row: list(STATES.values()).index(row.state))
        of_log = {row.log: row for row in reversed(kind)}
        shown = [worst] if len(logs) > _MOST_BESIDE else [of_log.get(log) for log in logs]
        table.append((what, *map(_cell, shown), kind[0].limit))
    columns = logs if len(logs) <= _MOST_BESIDE else [f"most remarkable of {len(logs)} logs"]
    return ("checked", *columns, "limit"), table


def _cell(row: CheckRow | None) -> str:
    if row is None:
        return ""
    return f"{row.found} (!)" if row.state in ("wrong", "note") else row.found


def _in_si(finding: Finding) -> dict[str, float]:
    """Numbers under keys with their SI units, and their standard errors."""
    ends = {
        unit: "" if unit == "1" else f"_{column_suffix(unit)}"
        for unit in {number.unit for number in finding.numbers.values()}
    }
    return {
        f"{name}{kind}{ends[number.unit]}": float(value)
        for name, number in finding.numbers.items()
        for kind, value in (("", number.value), ("_error", number.error))
        if value is not None and np.isfinite(value)
    }
