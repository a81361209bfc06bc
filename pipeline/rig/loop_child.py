"""The child that runs a foreign controller: what it crashes or hangs is not the parent.

The request is one JSON document on standard input, the answer one on standard output; arrays go through files.
"""

import json
import os
import resource
from dataclasses import fields
from pathlib import Path
from typing import Any

import numpy as np

from pipeline.errors import DebistError
from pipeline.rig.bench import Bench, Converter, Laser, Probe
from pipeline.rig.controllers import limit, load_controller, played
from pipeline.rig.loop import Scenario, run_loop
from pipeline.rig.parameters import from_json

_GRACE, _MEMORY = 2, 8 << 30
_WORDS, _BYTES = 64 << 20, 400
"""Bytes that a controller may print, and bytes of a log for each sample, amply."""


def main(request: dict[str, Any]) -> None:
    """Run the loop of a request, save the log, answer."""
    answers = os.fdopen(os.dup(1), "w", encoding="utf-8")
    os.dup2(2, 1)  # what a controller prints must not mix with the answer
    limit(resource.RLIMIT_CPU, int(request["seconds"]), _GRACE)  # the signal of the first limit can be ignored
    limit(resource.RLIMIT_CORE, 0)
    limit(resource.RLIMIT_AS, _MEMORY)
    samples = request["scenario"]["duration"] * request["bench"]["rate"]
    limit(resource.RLIMIT_FSIZE, _WORDS + int(_BYTES * samples))
    arrays = np.load(request["arrays"])
    try:
        controller = (
            played(arrays["play_t"], arrays["play_u"])
            if request["controller"] is None
            else load_controller(request["controller"])
        )
        scenario = Scenario(t=arrays["t"], target=arrays["target"], **_tuples(request["scenario"]))
        made = run_loop(from_json(request["joint"]), bench_from_json(request["bench"]), scenario, controller)
        np.savez(Path(request["out"]), **vars(made))
        answer: dict[str, Any] = {}
    except DebistError as error:
        answer = {"error": " ".join(str(error).split())}
    json.dump(answer, answers)
    answers.flush()


def _tuples(entries: dict[str, Any]) -> dict[str, Any]:
    return {k: tuple(tuple(each) for each in v) if isinstance(v, list) else v for k, v in entries.items()}


def scenario_json(scenario: Scenario) -> dict[str, Any]:
    """A scenario without its arrays."""
    return {f.name: getattr(scenario, f.name) for f in fields(scenario) if f.name not in ("t", "target")}


def bench_from_json(values: dict[str, Any]) -> Bench:
    """The bench back from `dataclasses.asdict`."""
    left, right = (Converter(**each) for each in values["converters"])
    first, second = (Probe(**each) for each in values["probes"])
    return Bench(values["rate"], (left, right), Laser(**values["laser"]), (first, second))
