"""The model as one JSON document: parameters, units, validity range."""

import json
from pathlib import Path
from typing import Any

from pipeline import __version__
from pipeline.artifacts.atomic import write_text
from pipeline.artifacts.manifest import plain
from pipeline.export.subject import Exported, Subject


def write_json(subject: Subject, folder: Path) -> Exported:
    """Write ``IDENTIFIER.json``."""
    target = folder / f"{subject.identifier}.json"
    write_text(target, json.dumps(document(subject), indent=1, ensure_ascii=False, allow_nan=False) + "\n")
    return Exported([target])


def document(subject: Subject) -> dict[str, Any]:
    """The document; every number in SI, units beside the numbers or in the keys."""
    facts: dict[str, Any] = plain(
        {
            "prototype": subject.prototype,
            "model": subject.name,
            "origin": {"model.h5": subject.origin, "debist": __version__},
            "validity": vars(subject.validity),
            "description": subject.model.describe(),
        }
    )
    return facts
