"""The controller that a run holds."""

import json
from collections.abc import Sequence
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


TITLES = ("linear", "map", "pulse-to-right", "pulse-to-left", "design")


def made_control(run: RunFolder) -> tuple[str, ...]:
    """Titles of what `debist control` made of the present model of a run."""
    known = run.manifest.artifacts
    if layout.MODELS not in known:
        return ()
    present = run.record(layout.MODELS).content_hash
    names = ((title, layout.control(title)) for title in TITLES)
    return tuple(t for t, name in names if name in known and present in known[name].recipe.inputs.values())


def control_documents(run: RunFolder, titles: Sequence[str]) -> dict[str, dict[str, Any]]:
    """What was made, by title."""
    return {title: json.loads(run.read_bytes(layout.control(title))) for title in titles}
