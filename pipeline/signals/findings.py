"""Findings: measurements on a log or a model, as a code with numbers, and what speaks against one log.

The bounds are five times and more what the worst of twelve measured and simulated logs shows: jitter of 0.06 steps,
displacement at its extremes in 0.4 % of the samples, masked rows 1 %, no hum above the noise. Else they are where half
of a log is no measurement.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import partial
from typing import Literal

import numpy as np

from ..settings.prototype import Gate
from ..units.quantity import moment, percent, quantity, scale, short, significant
from .columns import Missing
from .noise import LOST_PER_PERIOD, advised_interval
from .signal_quality import SignalQuality
from .timebase import TimeQuality

Severity = Literal["unseen", "good", "fair", "poor"]
SEVERITIES: tuple[Severity, ...] = ("unseen", "good", "fair", "poor")


@dataclass(frozen=True)
class Number:
    """A number with its SI unit (``1`` for shares and ratios) and its standard error, where it has one."""

    value: float
    unit: str = "1"
    error: float | None = None

    def __format__(self, form: str) -> str:
        """The number with its unit, or by one of `_FORMS` or a format of floats; ``short`` is round, with its unit."""
        if form == "short":
            shown, factor = scale(self.unit, self.value)
            return f"{short(self.value * factor)} {shown}"
        if form in _FORMS:
            return _FORMS[form](self.value)
        return format(self.value, form) if form else quantity(self.value, self.unit, self.error)


def share(value: float) -> str:
    """A share in percent, or in words that there is none."""
    return percent(value) if value > 0.0 else "none"


_FORMS: dict[str, Callable[[float], str]] = {
    "percent": percent, "share": share, "moment": moment, "digits": partial(significant, digits=2),
}  # fmt: skip


@dataclass(frozen=True)
class Finding:
    """Measured numbers with their severity and their log.

    Attributes
    ----------
    code : str
        Name of the finding in snake case, as tests and users of the datasheet compare it.
    severity : Severity
        Unseen: the data do not show it.
    log : str
        The log as tables show it (`names.log_title`); empty where it is of the whole run.
    subject : str
        The channel, model or fact that it is about, for instance ``v1``; may be empty.
    numbers : mapping of str to Number
        Measured numbers by name.
    gate : Gate or None
        The name under which the settings accept it, where it refuses the data.
    """

    code: str
    severity: Severity
    log: str = ""
    subject: str = ""
    numbers: Mapping[str, Number] = field(default_factory=dict)
    gate: Gate | None = None

    def value(self, name: str) -> float:
        """A number of the finding, in SI."""
        return self.numbers[name].value

    def filled(self, template: str) -> str:
        """A text with the finding's log, subject and numbers in its places, as in ``{log} after {time:moment}``."""
        return template.format(log=self.log, subject=self.subject, **self.numbers)


@dataclass(frozen=True)
class Remark:
    """A sentence that warns of a raw log.

    Attributes
    ----------
    text : str
        The sentence.
    dealt_with : bool
        True on rows that fits and scores leave out, and on decisions of the user.
    """

    text: str
    dealt_with: bool = False

    def of(self, name: str) -> "Remark":
        """The remark as one on a signal or a channel, by its name."""
        return Remark(f"{name}: {self.text}", self.dealt_with)


def refusal(gate: Gate, code: str, numbers: Mapping[str, Number] | None = None, subject: str = "") -> Finding:
    """A finding that refuses the data.

    Parameters
    ----------
    gate : Gate
        The name under which the settings accept it.
    code, numbers, subject : str, mapping of str to Number, str
        As in `Finding`.
    """
    return Finding(code, "poor", subject=subject, numbers=numbers or {}, gate=gate)


MOST_MISSING = 0.1
"""Share of a signal that may be missing."""
MOST_REPEATED = 0.05
"""Share of the time stamps that may repeat the one before."""
_MOST: dict[Gate, float] = {
    "masked": 0.5, "missing": MOST_MISSING, "repeated": MOST_REPEATED, "dropped": 0.2, "jitter": 0.3, "rails": 0.05,
    "hum": 0.05,
}  # fmt: skip
"""Largest share by gate."""
COARSEST_STEP = 3.0
"""Steps of a log in sample intervals of the settings: beyond, most uniform samples would be made up."""

UNTOLD_STEP = 1.2
"""The same, up to which there is no remark."""


def log_findings(time: TimeQuality, q: SignalQuality, masked: float, few: Sequence[str] = ()) -> list[Finding]:
    """Findings against one log.

    Parameters
    ----------
    time : TimeQuality
        Of the displacement's time base.
    q : SignalQuality
        Of the displacement.
    masked : float
        Share of the uniform rows that are masked or cut off at the log's ends, for whatever reason.
    few : sequence of str
        Inputs that have far fewer samples than their step and length give, as if recorded on change only.

    Notes
    -----
    Samples at rails that are masked are kept out of the fit, but the motion beyond the sensor's range is missing all
    the same.
    """
    span = q.largest - q.smallest
    hum = max(q.hum, key=lambda line: line.amplitude, default=None)
    shares = {
        "masked": masked,
        "missing": q.lost / q.n,
        "repeated": time.repeated / time.n,
        "dropped": time.dropped / (time.n + time.dropped),
        "jitter": time.jitter / time.step,
        "rails": 0.0 if q.constant else q.low_rail + q.high_rail,
        "hum": hum.amplitude / span if hum is not None and span > 0.0 else 0.0,
    }
    notes = {
        "masked": {name: Number(1.0) for name in few},
        "hum": {"frequency": Number(hum.frequency if hum else 0.0, "Hz")},
    }
    return [
        refusal(gate, f"{gate}_share", {"share": Number(shares[gate]), "most": Number(most), **notes.get(gate, {})})
        for gate, most in _MOST.items()
        if shares[gate] > most
    ]


def missing_findings(beside: Mapping[str, Missing]) -> list[Finding]:
    """Refusals of signals that are missing for too much of the displacement."""
    return [
        refusal(
            "missing",
            "signal_missing",
            {
                "share": Number(lacks.share),
                "most": Number(MOST_MISSING),
                "not_finite": Number(lacks.not_finite),
            },
            name,
        )
        for name, lacks in beside.items()
        if lacks.share > MOST_MISSING
    ]


def coarse_inputs(steps: Mapping[str, float], interval: float) -> list[Finding]:
    """Inputs whose own steps [s] are longer than `COARSEST_STEP` sample intervals [s]."""
    return [
        refusal("rate", "coarse_input", {"step": Number(step, "s"), "interval": Number(interval, "s")}, name)
        for name, step in steps.items()
        if step > COARSEST_STEP * interval
    ]


def unshown(time: TimeQuality, q: SignalQuality, interval: float, frequency: float, least: float) -> bool:
    """True if a frequency has few samples a period, and would have more in a finer record of the log.

    Parameters
    ----------
    time, q : TimeQuality, SignalQuality
        Of the displacement.
    interval : float
        Interval of the record [s].
    frequency : float
        The frequency [Hz]; NaN is never unshown.
    least : float
        Samples a period that are enough.
    """
    return frequency * interval * least > 1.0 and not q.idle and interval > UNTOLD_STEP * time.step


def rate_findings(time: TimeQuality, q: SignalQuality, sample_interval: float) -> list[Finding]:
    """Findings where log and sample interval do not go together.

    A log is too coarse where its unit of time is wrong, and too fine where decimation leaves little of its motion.
    """
    if unshown(time, q, sample_interval, q.band.half, LOST_PER_PERIOD):
        numbers = {
            "half": Number(q.band.half, "Hz"),
            "interval": Number(sample_interval, "s"),
            "advised": Number(advised_interval(q.band.most, time.step), "s"),
        }
        return [refusal("rate", "fast_motion", numbers)]
    if time.step <= COARSEST_STEP * sample_interval:
        return []
    numbers = {
        "step": Number(time.step, "s"),
        "lasts": Number(time.stop - time.start, "s"),
        "interval": Number(sample_interval, "s"),
        "most": Number(COARSEST_STEP),
    }
    return [refusal("rate", "coarse_log", numbers)]


def scale_suspicion(span: float, plausible: tuple[float, float] | None) -> float | None:
    """Factor by which numbers look too large, if a unit prefix seems to be wrong.

    Parameters
    ----------
    span : float
        Largest minus smallest value, in SI.
    plausible : (float, float) or None
        Least and largest span that such signals show (`Device.plausible_span`).

    Returns
    -------
    float or None
        1000.0: looks 1000 times too large; 0.001: 1000 times too small, and so on; None where the span is
        plausible, zero, or nothing is known of it.
    """
    low, high = plausible or (0.0, np.inf)
    if not 0.0 < span < np.inf or low <= span <= high:
        return None
    factor = prefix = 1000.0 if span > high else 1.0 / 1000.0
    while max(low * factor / span, span / (high * factor)) > 1.0 and max(factor, 1.0 / factor) < 1e9:
        factor *= prefix
    return factor
