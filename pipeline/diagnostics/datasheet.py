"""The datasheet of a device: facts with uncertainties, from the model and, beside it, from the measurement alone."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import asdict, dataclass, field
from typing import Any

import numpy as np

from ..device.device import Device
from ..models.base import DynamicModel, HasOutcomeDraws
from ..numerics.arrays import FloatArray
from ..numerics.metrics import NORMAL_90, signal_range
from ..scoring.wells import NoWells, Wells, wells_of
from ..signals.findings import SEVERITIES, Finding, Number, Severity
from ..store.columns import FACT_COLUMNS, STABLE
from .characteristics import (
    COVERAGE,
    Curves,
    believed_wells,
    curves_from,
    device_facts,
    equilibria,
    intervals,
    model_curves,
    shares,
)
from .data_quality import data_checks
from .events import RESTS, rest_events, ring_down
from .grades import THRESHOLDS, Check, graded, of_finding
from .model_quality import model_checks
from .run_data import RunData

FORMAT = "debist-datasheet/1"
RING_TIME, RING_STEP = 2.0, 0.005  # s
RING_AMPLITUDE = 0.025  # of the range of q: small enough for one frequency, large against friction

SCATTERED = 0.1
"""Share of the range of q: rests whose standard deviation is larger are several places, as of a drive that stays
anywhere, or of a log without rests.
"""
LEAST_EVENTS = 3
"""Fewest events for a spread."""
LEAST_SPREAD = 0.05
"""Least spread of a measured value: no rest and no ring-down repeats better."""


@dataclass(frozen=True)
class DatasheetFact:
    """One line of the datasheet, in SI; None where it does not exist or is not known.

    Attributes
    ----------
    value : float or None
        By the model's curves; of a ring-down that of a small motion, as the whole model simulates it.
    low, high : float or None
        Central 90 % of what the training data leave open.
    measured, measured_spread : float or None
        The same from the data without any model, and its standard deviation over the events.
    events : int
        Number of events.
    free_run : float or None
        The same from the model's own free runs over the logs, which compares motions of the same size.
    in_draws : float or None
        Share of the draws that have the fact; there are no limits below `COVERAGE`.
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
    in_draws: float | None = None

    @property
    def doubt(self) -> str:
        """Text in place of an interval where too few draws have the fact; empty otherwise."""
        if self.low is not None or self.in_draws is None or self.in_draws >= COVERAGE:
            return ""
        return f"not certain: in {100.0 * self.in_draws:.0f} % of the draws"

    @property
    def half_width(self) -> float | None:
        """Half of the interval of `value`."""
        return None if self.low is None or self.high is None else (self.high - self.low) / 2.0


def fact_checks(facts: Iterable[DatasheetFact]) -> list[Check]:
    """One finding for each fact whose modelled value lies far outside the measured ones; one good one if none does.

    The measured values are compared with those of the model's free runs, in the same events and by the same estimator.
    Damping depends on the size of the motion, and a rest on the time since the joint came there. Without a free run
    they are compared with the model's own value.
    """
    compared = [(fact.title, *both) for fact in facts if (both := comparison(fact)) is not None]
    off = [
        graded("model", "measured_facts", apart, subject=title, numbers=numbers)
        for title, apart, numbers in compared
        if THRESHOLDS["measured_facts"].grade(apart) != "good"
    ]
    if off or not compared:
        return off
    largest = max(0.1, np.ceil(10.0 * max(apart for _, apart, _ in compared)) / 10.0)  # "within" is rounded up
    numbers = {"value": Number(float(largest)), "count": Number(len(compared))}
    return [of_finding("model", Finding("measured_facts", "good", numbers=numbers))]


def comparison(fact: DatasheetFact) -> tuple[float, dict[str, Number]] | None:
    """Distance of model and measurement in standard deviations, and the compared values; None where one is missing.

    They are those of the measured events, and of the model where its own value is compared.
    """
    free = fact.free_run is not None
    modelled = fact.free_run if free else fact.value
    half = None if free else fact.half_width
    if modelled is None or fact.measured is None or fact.measured_spread is None or fact.events < LEAST_EVENTS:
        return None
    spread = max(fact.measured_spread, LEAST_SPREAD * abs(fact.measured))
    apart = abs(modelled - fact.measured) / float(np.hypot(spread, (half or 0.0) / NORMAL_90))
    return apart, {
        "measured": Number(fact.measured, fact.unit, fact.measured_spread),
        "events": Number(fact.events),
        "free_run" if free else "model": Number(modelled, fact.unit, half),
    }


@dataclass(frozen=True)
class Datasheet:
    """Facts of a device, and grades of data and model.

    Attributes
    ----------
    model : str or None
        Name of the model that the facts come from; None if no model has curves.
    main_model : str
        Name of the model that is judged.
    curves, draws : of that model
        On the training range; draws from its posterior for bands.
    """

    name: str
    model: str | None
    main_model: str
    facts: tuple[DatasheetFact, ...]
    checks: tuple[Check, ...]
    wells: Wells | NoWells
    curves: Mapping[str, Curves]
    draws: Mapping[str, list[Curves]]

    @property
    def refused(self) -> bool:
        """True if the facts come from a model that the assessment rejects."""
        return self.model == self.main_model and is_refused([vars(check) for check in self.checks])

    @property
    def grades(self) -> dict[str, Severity]:
        """The assessment of the data and on the model: the worst grade of the checks of each."""
        return {
            about: max((c.grade for c in self.checks if c.about == about), key=SEVERITIES.index, default="good")
            for about in ("data", "model")
        }

    def elements(self, data: RunData) -> list[dict[str, Any]]:
        """Forces of the elements of the judged model along the training logs, the largest first; 0 if absent.

        The share is that of the restoring force. Empty for a model whose elements are not known.
        """
        forces: Mapping[str, float] = data.descriptions.get(self.main_model, {}).get("elements", {})
        whole = forces.get("restoring force")
        return [
            {
                "name": name,
                "force_rms": force,
                "unit": data.device.curve_units["F"],
                "share": force / whole if whole else None,
            }
            for name, force in sorted(forces.items(), key=lambda item: -item[1])
        ]

    def to_json(self, data: RunData) -> dict[str, Any]:
        """The document that is written as ``datasheet.json``; SI units, null where unknown."""
        return {
            "format": FORMAT,
            "name": self.name,
            "facts_from": self.model,
            "judged_model": self.main_model,
            "choice": None if data.choice is None else dict(data.choice),
            "level_of_intervals": COVERAGE,
            "facts": [asdict(fact) for fact in self.facts],
            "elements": self.elements(data),
            "verdict": {**self.grades, "checks": [asdict(check) for check in self.checks]},
            "instruments": [dict(row) for row in data.instruments],
            "scores": [dict(score) for score in data.scores],
        }


def is_refused(checks: Iterable[Mapping[str, Any]]) -> bool:
    """True if the checks of an assessment, as in its JSON, reject the model: a constant does better."""
    return any(check["name"] == "constant" and check["grade"] == "poor" for check in checks)


def make_datasheet(data: RunData) -> Datasheet:
    """Evaluate curves, rests and ring-downs of a run, and judge it."""
    motions = [log.motion for log in data.logs]
    wells = wells_of(motions, plant=data.device)
    hum = {line for log in data.logs for line in log.record_notes.get("hum", ())}
    curves, draws = model_curves(data)
    source = next(iter(curves), None)
    modelled = _ModelledFacts()
    if source is not None:
        drawn = draws.get(source, [])
        modelled = _by_model(data, curves[source], drawn)
        places = equilibria(curves[source].q, curves[source].force)
        wells = believed_wells(wells, source, sum(place.stable for place in places), plant=data.device)
        rings = simulated_ring_downs(data.models[source], modelled.values, curves[source], len(data.device.inputs))
        modelled.values.update(rings)
        modelled.limits.update(
            intervals(rings, drawn_ring_downs(data.models[source], rings, curves[source], drawn, data.device))
        )
    measured = rest_events([(log.t, log.q, log.v) for log in motions], wells, hum, plant=data.device)
    in_free_run = _in_free_run(data, source, wells)
    facts = tuple(_facts(data, modelled, measured, wells, in_free_run))
    rest_errors = _rest_errors(in_free_run, modelled.values, measured, wells)
    main_model = data.model_names[0]
    return Datasheet(
        name=data.prototype.name,
        model=source,
        main_model=main_model,
        facts=facts,
        checks=(
            *data_checks(data, wells),
            *model_checks(data, main_model, rest_errors, wells),
            *fact_checks(facts),
        ),
        wells=wells,
        curves=curves,
        draws=draws,
    )


@dataclass(frozen=True)
class _ModelledFacts:
    """Facts by the judged model, their intervals, and the share of the draws that have each, by key."""

    values: dict[str, float | None] = field(default_factory=dict)
    limits: dict[str, tuple[float, float]] = field(default_factory=dict)
    in_draws: dict[str, float] = field(default_factory=dict)


def _by_model(data: RunData, curves: Curves, draws: list[Curves]) -> _ModelledFacts:
    """Facts of the curves.

    Stable states have neither interval nor share: a draw may have another number of them than the curves.
    """
    values = device_facts(curves, plant=data.device)
    own = {key: value for key, value in values.items() if not key.startswith(STABLE)}
    facts = (device_facts(draw, plant=data.device) for draw in draws)
    drawn = [{key: fact.get(key) for key in own} for fact in facts]
    return _ModelledFacts(values, intervals(own, drawn), shares(own, drawn))


def simulated_ring_downs(
    model: DynamicModel, values: Mapping[str, float | None], curves: Curves, inputs: int
) -> dict[str, float | None]:
    """Frequency [Hz] and damping ratio of a small free oscillation in each well, as the whole model simulates it.

    Parameters
    ----------
    model : DynamicModel
        The model.
    values : mapping of str to float or None
        Facts of its curves: places of rest [m or rad] and stiffnesses there.
    curves : Curves
        Its curves; the amplitude is `RING_AMPLITUDE` of their range.
    inputs : int
        Number of inputs, all zero.
    """
    facts: dict[str, float | None] = {}
    t = np.arange(0.0, RING_TIME, RING_STEP)
    amplitude = RING_AMPLITUDE * float(curves.q[-1] - curves.q[0])
    mass = float(getattr(model, "mass_kg", 1.0))
    for side, rest in RESTS.items():
        place = values.get(rest)
        stiffness = values.get(f"stiffness{side}")
        if place is None or stiffness is None:
            continue
        run = model.simulate(t, np.zeros((t.size, inputs)), place, amplitude * float(np.sqrt(stiffness / mass)))
        ring = ring_down(t, run.q) if run.status == "ok" and np.isfinite(run.q).all() else None
        facts |= {
            f"frequency{side}": ring.frequency if ring else None,
            f"damping{side}": ring.damping if ring else None,
        }
    return facts


def drawn_ring_downs(
    model: DynamicModel, rings: Mapping[str, float | None], own: Curves, draws: Sequence[Curves], plant: Device
) -> list[dict[str, float | None]]:
    """Frequencies and damping ratios of draws from a model's posterior.

    They are simulated by the whole model where it has such draws. Friction that sticks stiffens a small motion, and a
    relaxing element stiffens and damps it; neither is in the curves. Other models have those of the curves.

    Parameters
    ----------
    model : DynamicModel
        The model.
    rings : mapping of str to float or None
        Its own frequencies and damping ratios.
    own : Curves
        Its curves.
    draws : sequence of Curves
        Draws from them.
    plant : Device
        Its inputs, and whether it is the joint.
    """
    if not isinstance(model, HasOutcomeDraws):
        return [_ring_downs_by_curves(rings, own, draw, plant=plant) for draw in draws]
    keys = [key for key, value in rings.items() if value is not None]
    if not keys or not draws:
        return []

    def simulated(near: Any) -> FloatArray:
        """Ring-downs of a model near the identified one, NaN where there is none."""
        curves = curves_from(near.curves(own.q), own.q)
        rings_near = simulated_ring_downs(near, device_facts(curves, plant=plant), curves, len(own.gains))
        return np.array([rings_near.get(key) for key in keys], dtype=np.float64)

    return [
        {key: float(x) for key, x in zip(keys, row, strict=True) if np.isfinite(x)}
        for row in model.outcome_ensemble(simulated, len(draws))
    ]


def _ring_downs_by_curves(
    rings: Mapping[str, float | None], own: Curves, draw: Curves, plant: Device
) -> dict[str, float | None]:
    """Frequencies and damping ratios of a draw: to first order they go with √k and d/√k of the curves at a rest."""
    facts: dict[str, float | None] = {}
    values, drawn = (device_facts(curves, plant=plant) for curves in (own, draw))
    for side, rest in RESTS.items():
        frequency, damping = (rings.get(f"{name}{side}") for name in ("frequency", "damping"))
        stiffness, stiffness_drawn = (facts_of.get(f"stiffness{side}") for facts_of in (values, drawn))
        place, place_drawn = (facts_of.get(rest) for facts_of in (values, drawn))
        if frequency is None or damping is None or stiffness is None or stiffness_drawn is None:
            continue
        faster = float(np.sqrt(stiffness_drawn / stiffness))
        facts[f"frequency{side}"] = frequency * faster
        if own.damping is not None and draw.damping is not None and place is not None and place_drawn is not None:
            more = np.interp(place_drawn, draw.q, draw.damping) / np.interp(place, own.q, own.damping)
            facts[f"damping{side}"] = damping * float(more) / faster
    return facts


def _rest_errors(
    events: Mapping[str, float],
    values: Mapping[str, float | None],
    measured: Mapping[str, FloatArray],
    wells: Wells | NoWells,
) -> tuple[float, float] | None:
    """Modelled minus measured rest on the left and on the right; None unless all are known.

    The model's rests are those of free runs over the logs. Without free runs they are the equilibria, which friction
    and creep keep a joint from.
    """
    if isinstance(wells, NoWells):
        return None
    both = ("well_left", "well_right")
    if all(key in events and key in measured for key in both):
        return events["well_left"] - measured["well_left"].mean(), events["well_right"] - measured["well_right"].mean()
    left, right = (values.get(key) for key in both)
    return None if left is None or right is None else (left - wells.left, right - wells.right)


def _in_free_run(data: RunData, model: str | None, wells: Wells | NoWells) -> dict[str, float]:
    """Rests and ring-downs in the model's own free runs over the logs, evaluated as in the measurement."""
    logs = [log for log in data.logs if model in log.predictions]
    if model is None or not logs:
        return {}
    runs = [(log.motion.t, log.predictions[model]["q"], log.motion.v) for log in logs]
    return {key: float(np.mean(values)) for key, values in rest_events(runs, wells, plant=data.device).items()}


def _facts(
    data: RunData,
    modelled: _ModelledFacts,
    measured: Mapping[str, FloatArray],
    wells: Wells | NoWells,
    in_free_run: Mapping[str, float],
) -> Iterator[DatasheetFact]:
    """The facts that the model or the measurement has; `in_free_run` is the result of `_in_free_run`."""
    # One rest measured over several modelled ones is the mean of all, and none of them.
    several = modelled.values.get("well_left") is not None or any(key.startswith(STABLE) for key in modelled.values)
    if isinstance(wells, NoWells) and several:
        measured = {}
    span = signal_range(np.concatenate([log.motion.q for log in data.logs])) or 0.0
    if "rest" in measured and np.std(measured["rest"]) > SCATTERED * span:
        measured = {key: values for key, values in measured.items() if key != "rest"}
    q = data.device.displacement.symbol
    units = {
        "{q}": q,
        "{v}": data.device.inputs[0].symbol,
        "{U}": data.device.energy_unit,
        "{k}": "1/s²" if data.device.known_mass is None else f"{data.device.curve_units['F']}/{q}",
    }
    for key, title, unit in _listed(modelled.values):
        samples = measured.get(key, np.empty(0))
        if modelled.values.get(key) is None and not samples.size:
            continue
        low, high = modelled.limits.get(key, (None, None))
        yield DatasheetFact(
            key=key,
            title=title,
            unit=units.get(unit, unit),
            value=modelled.values.get(key),
            low=low,
            high=high,
            measured=float(np.mean(samples)) if samples.size else None,
            measured_spread=float(np.std(samples, ddof=1)) if samples.size > 1 else None,
            events=int(samples.size),
            free_run=in_free_run.get(key) if samples.size else None,
            in_draws=modelled.in_draws.get(key),
        )


def _listed(values: Mapping[str, float | None]) -> Iterator[tuple[str, str, str]]:
    """Key, title and unit of every fact that a device may have; stable states are numbered."""
    stable = [key.removeprefix(STABLE) for key in values if key.startswith(STABLE)]
    for column in FACT_COLUMNS:
        for number in stable if column.key == STABLE else ("",):
            yield column.key + number, f"{column.title} {number}".rstrip(), column.unit
