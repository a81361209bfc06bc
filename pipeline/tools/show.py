"""Show: a run's datasheet as text."""

import json
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from pipeline.errors import CorruptArtifactError
from pipeline.runs import layout
from pipeline.runs.run_folder import in_snapshot

Rows = list[tuple[str, ...]]


@dataclass(frozen=True)
class Shown:
    """A datasheet for the terminal: facts, what the logs show of them, checks, and the verdict in a line."""

    title: str
    facts: Rows
    seen: Rows
    checks: Rows
    verdict: str


def load_datasheet(root: Path) -> dict[str, Any]:
    """The document ``datasheet.json`` of a run, checked against the manifest.

    Raises
    ------
    InputError
        It was not made yet.
    CorruptArtifactError
        It is damaged.
    """
    content = in_snapshot(root, lambda run: run.read_bytes(layout.DATASHEET))
    path = root / layout.DATASHEET
    try:
        return dict(json.loads(content))
    except ValueError as error:
        raise CorruptArtifactError(f"{path}: damaged ({error}); `debist report {root}` rebuilds it") from error


def show_datasheet(document: dict[str, Any]) -> Shown:
    """The datasheet as text; where the logs show a fact too, beside what the model's free runs over them show."""
    from pipeline.si_prefix import interval, quantity

    alike: dict[str, float] = {}
    for fact in document["facts"]:
        ends = (abs(fact[key] or 0.0) for key in ("value", "low", "high"))
        alike[_kind(fact)] = max(alike.get(_kind(fact), 0.0), *ends)
    facts: Rows = []
    known: Rows = []
    for fact in document["facts"]:
        factor = 100.0 if fact["unit"] == "%" else 1.0
        value, low, high, seen, spread, own = (
            None if fact.get(key) is None else factor * fact[key]
            for key in ("value", "low", "high", "measured", "measured_spread", "free_run")
        )
        model, limits = quantity(value, fact["unit"]), "–"
        if low is not None and high is not None:
            model, limits = interval(value, low, high, fact["unit"], alike[_kind(fact)])
        facts.append((fact["title"], model, limits))
        if fact["events"]:
            measured = f"{quantity(seen, fact['unit'], spread)} ({fact['events']}×)"
            known.append((fact["title"], quantity(own, fact["unit"]), measured))
    verdict = document["verdict"]
    checks: Rows = [
        (check["about"], check["grade"], check["statement"], "" if check["grade"] == "good" else check["advice"])
        for check in verdict["checks"]
    ]
    line = f"data {verdict['data']}, model {document['judged_model']} {verdict['model']}"
    source = f"facts from {document['facts_from']}" if document["facts_from"] else "no model has curves"
    return Shown(f"{document['name']}: {source}", facts, known, checks, line)


def _kind(fact: dict[str, Any]) -> str:
    """Facts of one kind share their unit: both wells, and the saddle between them."""
    return {"saddle": "well"}.get(fact["key"], str(fact["key"]).partition("_")[0])
