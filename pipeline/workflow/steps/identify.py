"""Identify: models of the training logs, the main one first."""

import time
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from typing import Any

import numpy as np

from ...device.device import device
from ...device.parameters import JointParameters
from ...diagnostics.sentences import judge, sentences
from ...errors import DataRefusedError
from ...fitting.population import NormalPopulation
from ...models.choose import Choice, choose, main_model
from ...models.model_type import KnownCurves, StoredModel, Training, model_type
from ...settings.models import AUTO, ENTRIES
from ...settings.prototype import Prototype
from ...signals.findings import Finding
from ...signals.log import EDGE, Log
from ...store.manifest import TIMES
from ...store.tables import Table
from ...system.worker_pool import OnProgress, meanwhile, silent

_LEAST_PART = 5 * EDGE
"""Valid samples of a part of a log that is no more than its beginning."""
IDENTIFIED = "identified"
"""Note of ``model.h5``: names of its models, the main model first."""
CHOICE = "choice"
"""Note of ``model.h5``: the decision of "auto", as `pipeline.models.choose.Choice.to_json` writes it."""
EQUATIONS = "equations"
"""Note of ``model.h5``: name of the joint that "auto" fitted and did not choose; control is designed on it."""
SEARCH_CUT = (
    "the search for the structure of {model} ended at its time limit, after {tried} structures; raise [identify] "
    "time_limit, or say what is known (friction, force, damping, gain, drive, effect, stops)"
)


@dataclass(frozen=True)
class PriorKnowledge:
    """Inputs of a fit beside the logs: measured characteristic curves, and a prior from other joints."""

    curves: Table | None = None
    siblings: NormalPopulation | None = None


def training(
    logs: Sequence[Log],
    prototype: Prototype,
    parameters: JointParameters | None,
    prior_knowledge: PriorKnowledge | None = None,
    on_progress: OnProgress = silent,
) -> Training:
    """The training data of a prototype.

    Parameters
    ----------
    logs : sequence of Log
        The training logs.
    prototype : Prototype
        Settings.
    parameters : JointParameters or None
        Parameter set of the analytical joint.
    prior_knowledge : PriorKnowledge, optional
        Knowledge beside the logs.
    on_progress : callable
        Receives what a fit is doing.
    """
    from ...models.analytical.statics import rotation_nodes

    plant = device(prototype)
    beside = prior_knowledge or PriorKnowledge()
    return Training(
        segments=tuple(segment for log in logs for segment in log.segments()),
        records=tuple(part.to_fit() for part in _long_enough([part for log in logs for part in log.parts()])),
        device=plant,
        parameters=parameters,
        known_curves=None if beside.curves is None else _known_curves(beside.curves, len(plant.inputs)),
        siblings=beside.siblings,
        identify=prototype.identify,
        compare=prototype.compare,
        inputs_before=prototype.plant.inputs_before,
        rotation=None if plant.angle is None or parameters is None else rotation_nodes(parameters),
        on_progress=on_progress,
    )


def _long_enough(parts: Sequence[Log]) -> list[Log]:
    """The parts of logs that hold more than their beginning, or else the longest of them."""
    long_enough = [part for part in parts if np.count_nonzero(part.valid) > _LEAST_PART]
    return long_enough or [max(parts, key=lambda part: len(part.t))]


def fitted_parts(log: Log) -> list[Log]:
    """The parts of a log as fits take them."""
    return [part.to_fit() for part in _long_enough(log.parts())]


def _known_curves(table: Table, inputs: int) -> KnownCurves:
    slopes = [table.get(f"dC{k}_dq") for k in range(1, inputs + 1)]
    return KnownCurves(table["q"], table.get("F"), tuple(None if slope is None else 0.5 * slope for slope in slopes))


def identified(
    data: list[Log],
    prototype: Prototype,
    parameters: JointParameters | None,
    prior_knowledge: PriorKnowledge | None = None,
    on_progress: OnProgress = silent,
    jobs: int = 1,
) -> tuple[dict[str, StoredModel], dict[str, Any]]:
    """Models of logs by name, the main model first, and notes on how they came about.

    Where "auto" fits the joint's equations and chooses the network, both are among the models; only the network is
    named in the note `IDENTIFIED`. An `rbf` beside "auto" that the training logs refuse is left out, with a warning.

    Parameters
    ----------
    data : list of Log
        Training logs.
    prototype : Prototype
        Settings.
    parameters : JointParameters or None
        Parameter set of the analytical joint.
    prior_knowledge : PriorKnowledge, optional
        Curves and prior beside the logs.
    on_progress : callable
        Receives what a fit is doing, and its share.
    jobs : int
        Processes at a time: with more than one `rbf` is fitted beside the main model.

    Raises
    ------
    DataRefusedError
        The training logs do not show what the models need.
    """
    findings = _findings(data, prototype)
    remarks = judge("training logs", findings, prototype.quality, *_stands_in(_wanted(prototype)))
    # What even a network does not need is no fault of the data.
    needless = set(_stands_in({"rbf"})[0]) - set(prototype.quality.accept)
    accepted = [text for finding, text in zip(findings, remarks, strict=True) if finding.gate not in needless]
    notes: dict[str, Any] = {"warnings": list(remarks), "accepted": accepted}
    models: dict[str, StoredModel] = {}
    beside: dict[str, StoredModel] = {}
    whole = training(data, prototype, parameters, prior_knowledge, on_progress)
    network = partial(_fitted, "rbf", replace(whole, on_progress=silent), data, prototype)
    with meanwhile(network, on_progress, jobs if "rbf" in prototype.identify.models[1:] else 1) as rbf:
        for wanted in prototype.identify.models:
            if wanted in notes.get(IDENTIFIED, ()):  # it was chosen already
                continue
            if wanted == AUTO:
                began = time.process_time()
                choice = _choose(whole, data, prototype)
                seconds: float | None = time.process_time() - began
                model = choice.model
                notes[CHOICE] = choice.to_json()
                if not choice.held_out and whole.device.displacement.symbol == "rad" and prototype.may_be_a_joint:
                    notes["warnings"].append(choice.reason)
                if choice.other is not None:
                    beside[choice.other.name] = choice.other
            elif wanted in beside:
                model, seconds = beside[wanted], None
            else:
                fit = rbf if wanted == "rbf" else partial(_fitted, wanted, whole, data, prototype, on_progress)
                try:
                    model, seconds = fit()
                except DataRefusedError as refused:
                    if wanted != "rbf" or AUTO not in prototype.identify.models:
                        raise
                    notes["warnings"].append(f"rbf is not among the models: {refused}")
                    continue
            facts = model.describe()
            models[model.name] = model
            notes["warnings"] += _unfinished(model.name, facts)
            notes[model.name] = {**facts, TIMES: {"fit_s": seconds}}
            notes.setdefault(IDENTIFIED, []).append(model.name)
    if prototype.identify.models[0] == AUTO:
        _put_first(models, whole, notes)
    if "hybrid" in beside:
        notes[EQUATIONS] = "hybrid"
        models.setdefault("hybrid", beside["hybrid"])
    return models, notes


def _unfinished(model: str, facts: Mapping[str, Any]) -> Iterator[str]:
    """Warnings on a fit that did not converge, or a search for a structure that was cut."""
    if facts.get("converged") is False:
        yield "; ".join(sentences(Finding("converged", "fair", subject=model)))
    if facts.get("search_complete") is False:
        yield SEARCH_CUT.format(model=model, tried=len(facts["candidates"]))


def _put_first(models: Mapping[str, StoredModel], whole: Training, notes: dict[str, Any]) -> None:
    """The main model first in the note `IDENTIFIED`, and why in the note `CHOICE` where the fits decided otherwise."""
    names = notes[IDENTIFIED]
    best, reason = main_model({name: models[name] for name in names}, whole)
    if best == names[0]:
        return
    if names[0] == "hybrid":
        notes[EQUATIONS] = "hybrid"
    notes[CHOICE] |= {"chosen": best, "reason": reason}
    notes[IDENTIFIED] = [best, *(name for name in names if name != best)]


def _wanted(prototype: Prototype) -> set[str]:
    """The models that the settings ask for, with those among which one is chosen."""
    offered = ("hybrid", "rbf") if prototype.may_be_a_joint else ("rbf",)
    return {wanted for name in prototype.identify.models for wanted in (offered if name == AUTO else (name,))}


def _stands_in(models: Collection[str]) -> tuple[tuple[str, ...], str]:
    """The gates that need not hold because one of the models knows better, and what of it does."""
    knowledge = {"hybrid": "the joint's equations", "rbf": "the priors of rbf"}
    gates = dict.fromkeys(gate for model in ENTRIES if model.name in models for gate in model.stands_in)
    return tuple(gates), " or ".join(what for name, what in knowledge.items() if name in models)


def _fitted(
    wanted: str, given: Training, data: list[Log], prototype: Prototype, on_progress: OnProgress
) -> tuple[StoredModel, float]:
    """A model that the settings name, and the processor time [s] of its fit."""
    began = time.process_time()
    given = replace(given, on_progress=on_progress)
    beside_auto = wanted == "rbf" and AUTO in prototype.identify.models
    model = _network(given, data, prototype) if beside_auto else model_type(wanted).fit(given)
    return model, time.process_time() - began


def _choose(given: Training, data: list[Log], prototype: Prototype) -> Choice:
    if given.known_curves is not None:
        return Choice(_network(given, data, prototype), "only rbf keeps the measured curves of plant.curves", {})
    return choose(given, model_type("hybrid").fit, lambda part: _network(part, data, prototype))


def _network(given: Training, data: list[Log], prototype: Prototype) -> StoredModel:
    """The data-driven model; the data must show what the joint's equations would know."""
    judge("training logs", _findings(data, prototype), prototype.quality, *_stands_in({"rbf"}))
    return model_type("rbf").fit(given)


def _findings(data: list[Log], prototype: Prototype) -> list[Finding]:
    """Findings against the training logs, taken together."""
    from ...fitting.excitation import excitation_findings

    numbers = [log.segment for log in data]
    first = np.cumsum([0, *(segment.max() + 1 for segment in numbers[:-1])])
    segments = [np.where(segment < 0, -1, segment + k) for segment, k in zip(numbers, first, strict=True)]
    return excitation_findings(
        np.concatenate([log.q for log in data]),
        np.concatenate([log.v for log in data]),
        np.concatenate(segments),
        prototype.ingest.sample_interval,
        device(prototype),
        basis_functions=prototype.identify.basis_functions,
        smoothing=prototype.identify.smoothing,
        bistable=prototype.plant.parameters is not None,
    )
