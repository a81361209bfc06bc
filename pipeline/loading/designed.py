"""The controller that a run holds."""

import json
from typing import Any

from pipeline.errors import InputError
from pipeline.runs import layout
from pipeline.runs.run_folder import RunFolder


def load_design(run: RunFolder) -> dict[str, Any]:
    """The designed controller of a run.

    Raises
    ------
    InputError
        None was designed for the present model.
    """
    name = layout.control("design")
    if name not in run.manifest.artifacts:
        raise InputError(f"{run.root}: no controller was designed yet; `debist control design {run.root}` does it")
    document: dict[str, Any] = json.loads(run.read_bytes(name))
    if document["origin"] != run.record(layout.MODELS).content_hash:
        raise InputError(
            f"{run.root}: its controller was designed for another model; `debist control design {run.root}` renews it"
        )
    return document
