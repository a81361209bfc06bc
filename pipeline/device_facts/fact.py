"""One line of a datasheet, and whether the model's facts agree with what was measured without any model."""

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np

from pipeline.device_facts.quality import THRESHOLDS, Check
from pipeline.si_prefix import quantity

NINETY = 1.645
"""Standard deviations of half a central 90 % interval."""
LEAST_EVENTS = 3
"""Events below which a spread says nothing."""
LEAST_SPREAD = 0.05
"""Of the measured value: no rest and no ring-down repeats better than that."""


@dataclass(frozen=True)
class Fact:
    """One line of the datasheet, in SI; None where it does not exist or is not known.

    Attributes
    ----------
    value : float or None
        By the model's curves; of a ring-down that of a small motion, as the whole model simulates it.
    low, high : float or None
        Central 90 % by the model's posterior.
    measured, measured_spread : float or None
        The same seen in the data without any model, and its standard deviation over the events.
    events : int
        How many events were seen.
    free_run : float or None
        The same seen in the model's own free runs over the logs: like with like, whatever the size of the motion.
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
    free_run: float | None = None


def fact_checks(facts: Iterable[Fact]) -> list[Check]:
    """One finding for each fact whose modelled value lies far outside the measured ones; one good one if none does.

    Compared is what the model's free runs show in the same events, by the same estimator: damping depends on the size
    of the motion, and a rest on how long ago the joint came there. Without a free run it is the model's own value.
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
            f"{fact.title} is {_modelled(fact)}, but was measured as "
            f"{_shown(fact, fact.measured, fact.measured_spread)} ({fact.events} times)",
            "train on longer rests without voltage, and trust the measured value until then",
        )
        for fact, apart in known
        if limit.grade(apart) != "good"
    ]
    if found:
        return found
    largest = max(apart for _, apart in known)
    text = f"the {len(known)} modelled facts that were measured too lie within {largest:.1f} standard deviations"
    return [Check("model", "measured_facts", "good", text, "")]


def _modelled(fact: Fact) -> str:
    if fact.free_run is not None:
        return f"{_shown(fact, fact.free_run, None)} in the model's free runs"
    return f"{_shown(fact, fact.value, _half(fact))} by the model"


def distance(fact: Fact) -> float | None:
    """Distance of model and measurement in standard deviations; None where there is nothing to compare.

    They are those of the measured events, and of the model where its own value is compared.
    """
    if fact.measured is None or fact.measured_spread is None or fact.events < LEAST_EVENTS:
        return None
    spread = max(fact.measured_spread, LEAST_SPREAD * abs(fact.measured))
    if fact.free_run is not None:
        return abs(fact.free_run - fact.measured) / spread
    if fact.value is None:
        return None
    return abs(fact.value - fact.measured) / float(np.hypot(spread, (_half(fact) or 0.0) / NINETY))


def _half(fact: Fact) -> float | None:
    return None if fact.low is None or fact.high is None else (fact.high - fact.low) / 2.0


def _shown(fact: Fact, value: float | None, spread: float | None) -> str:
    return quantity(value, fact.unit, spread, abs(fact.measured or 0.0))
