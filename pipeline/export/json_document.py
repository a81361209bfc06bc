"""The model as one JSON document: states, constants, curves, units, validity range, and a run to check against."""

import json
from pathlib import Path
from typing import Any

from pipeline import __version__
from pipeline.errors import InputError
from pipeline.export.subject import Exported, Subject, curve_tables
from pipeline.runs.atomic import write_text
from pipeline.runs.manifest import to_json

FORMAT = "debist-model/1"
_BETWEEN = {"linear": "linear", "cubic": "cubic spline", "zero": "held"}
CHECK_SAMPLES = 500
"""Samples of the run to check against: five seconds at 10 ms."""


def write_json(subject: Subject, folder: Path) -> Exported:
    """Write ``IDENTIFIER.json``."""
    target = folder / f"{subject.identifier}.json"
    write_text(target, json.dumps(document(subject), indent=1, ensure_ascii=False, allow_nan=False) + "\n")
    return Exported([target])


def document(subject: Subject) -> dict[str, Any]:
    """The document; every number in SI, units beside the numbers or in the keys."""
    facts: dict[str, Any] = to_json(
        {
            "format": FORMAT,
            "prototype": subject.prototype,
            "model": subject.name,
            "origin": {"content": subject.origin, "debist": __version__},
            "validity": vars(subject.validity),
            "description": subject.model.describe(),
            "equations": _equations(subject),
            "curves": [vars(table) for table in curve_tables(subject)],
            "check": _check(subject),
        }
    )
    return facts


def _equations(subject: Subject) -> dict[str, Any] | None:
    """States, constants and integration; none for a model whose equations cannot be written down elsewhere."""
    try:
        realisation = subject.realisation()
    except InputError:
        return None
    return {
        "structure": realisation.structure,
        "states": [vars(state) for state in realisation.states],
        "hysteresis_states": [vars(state) for state in realisation.hysteresis_states],
        "constants_si": realisation.constants,
        "integration": {
            "scheme": "classical Runge-Kutta, fixed step",
            "step_s": realisation.step,
            "inputs_between_samples": _BETWEEN[realisation.between],
            "delay_s": realisation.delay,
        },
    }


def _check(subject: Subject) -> dict[str, Any]:
    """The start of a log with the model's own run."""
    rows = slice(0, CHECK_SAMPLES)
    t, v = subject.t[rows], subject.v[rows]
    run = subject.model.simulate(t, v, *subject.start)
    return {"t_s": t, "v": v, "q0": subject.start[0], "qdot0": subject.start[1], "q": run.q, "status": run.status}
