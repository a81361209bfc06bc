"""One line of a datasheet, and whether the model's facts agree with what was measured without any model."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace

import numpy as np

from pipeline.device_facts.quality import THRESHOLDS, Check
from pipeline.si_prefix import quantity

NINETY = 1.645
"""Standard deviations of half a central 90 % interval."""
LEAST_EVENTS = 3
"""Events below which a spread says nothing."""
LEAST_SPREAD = 0.05
"""Of the measured value: rests creep and ring-downs depend on their size by so much."""


@dataclass(frozen=True)
class Fact:
    """One line of the datasheet, in SI; None where it does not exist or is not known.

    Attributes
    ----------
    low, high : float or None
        Central 90 % by the model's posterior.
    measured, measured_spread : float or None
        The same seen in the data without any model, and its standard deviation over the events.
    events : int
        How many events were seen.
    """

    key: str
    title: str
    unit: str
    value: float | None
    low: float | None = None
    high: float | None = None
    measured: float | None = None
    measured_spread: float | None = None
    events: int = 0


def fact_checks(facts: Iterable[Fact], in_free_run: Mapping[str, float] | None = None) -> list[Check]:
    """One finding for each fact whose modelled value lies far outside the measured ones; one good one if none does.

    The distance is counted in standard deviations: that of the measured events and that of the model together.
    `in_free_run` holds the same quantities seen in the model's own free runs over the logs: where these agree with the
    measurement, the modelled value is that of another size of motion.
    """
    compared = [(fact, distance(fact)) for fact in facts]
    known = [(fact, apart) for fact, apart in compared if apart is not None]
    if not known:
        return []
    limit = THRESHOLDS["measured_facts"]
    found = [
        Check(
            "model",
            "measured_facts",
            limit.grade(apart),
            f"{fact.title} is {_shown(fact, fact.value, _half(fact))} by the model, but was measured as "
            f"{_shown(fact, fact.measured, fact.measured_spread)} ({fact.events} times)",
            _advice(fact, (in_free_run or {}).get(fact.key)),
        )
        for fact, apart in known
        if limit.grade(apart) != "good"
    ]
    if found:
        return found
    largest = max(apart for _, apart in known)
    text = f"the {len(known)} modelled facts that were measured too lie within {largest:.1f} standard deviations"
    return [Check("model", "measured_facts", "good", text, "")]


def _advice(fact: Fact, seen: float | None) -> str:
    if seen is None:
        return "trust the measured value, and mistrust what follows from the modelled one"
    shown = _shown(fact, seen, None)
    if THRESHOLDS["measured_facts"].grade(distance(replace(fact, value=seen, low=None, high=None)) or 0.0) == "good":
        return f"the model's free runs show {shown} in the same events: its value is that of smaller motion"
    return f"the model's free runs show {shown} in the same events: train on longer rests without voltage"


def distance(fact: Fact) -> float | None:
    """Distance of model and measurement in standard deviations; None where there is nothing to compare."""
    if fact.value is None or fact.measured is None or fact.measured_spread is None or fact.events < LEAST_EVENTS:
        return None
    half = _half(fact) or 0.0
    floor = LEAST_SPREAD * abs(fact.measured)
    return abs(fact.value - fact.measured) / float(np.hypot(max(fact.measured_spread, floor), half / NINETY))


def _half(fact: Fact) -> float | None:
    return None if fact.low is None or fact.high is None else (fact.high - fact.low) / 2.0


def _shown(fact: Fact, value: float | None, spread: float | None) -> str:
    return quantity(value, fact.unit, spread, abs(fact.measured or 0.0))
