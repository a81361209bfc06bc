"""Contents of a run for its report and for the lines of a command; what an older or partial run lacks is left out."""

import json
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from ..device.device import Device, device
from ..diagnostics.run_data import WHY, LogData, RunData, Study
from ..errors import DebistError
from ..models.base import DynamicModel
from ..models.model_type import model_from_tree
from ..numerics.arrays import FloatArray
from ..settings.logs import LogPart, Role
from ..settings.prototype import Prototype
from ..signals.log import log_of
from ..store import layout, schemas
from ..store.columns import StudyName
from ..store.manifest import TIMES
from ..store.run_folder import RunFolder, in_snapshot
from ..system.names import log_title, true_name
from ..units.units import ALPHA_UNIT
from .prior_knowledge import named_files
from .run_contents import identified_models
from .steps.identify import CHOICE, IDENTIFIED


def read_run(
    run: RunFolder,
    prototype: Prototype,
    models: Sequence[str],
    studies: Sequence[StudyName] = (),
    control: Sequence[str] = (),
) -> RunData:
    """Read logs, free runs, models and scores, every artifact checked against the manifest.

    Parameters
    ----------
    run : RunFolder
        The run.
    prototype : Prototype
        Its settings.
    models : sequence of str
        Models that are shown, the main model first.
    studies : sequence of str
        Studies that are shown.
    control : sequence of str
        Titles of the control documents that are shown.
    """
    plant = device(prototype)
    loaded, unreadable = _models(run, prototype, models)
    return RunData(
        prototype=prototype,
        device=plant,
        logs=tuple(_log(run, models, *log) for log in layout.logs(prototype)),
        models=loaded,
        descriptions={name: _description(run, prototype, name) | unreadable.get(name, {}) for name in models},
        scores=tuple(row for row in run.read_records(layout.SCORES) if row["model"] in models),
        provenance=provenance(run, prototype),
        accepted=_accepted(run, prototype),
        # A run of before they were made has no checks.
        log_checks=tuple(run.read_document(layout.CHECK)["rows"]) if layout.CHECK in run.manifest.artifacts else (),
        choice=run.record(layout.MODELS).notes.get(CHOICE),
        studies=tuple(read_study(run, name, plant) for name in studies),
        measured_curves=measured_curves(run, prototype),
        instruments=_instruments(run),
        control={title: run.read_document(layout.control(title)) for title in control},
    )


def _instruments(run: RunFolder) -> tuple[dict[str, Any], ...]:
    """The errors of instruments; none in a run of before they were measured."""
    return tuple(run.read_records(layout.INSTRUMENTS)) if layout.INSTRUMENTS in run.manifest.artifacts else ()


def measured_curves(run: RunFolder, prototype: Prototype) -> dict[str, FloatArray]:
    """Curves measured on a test stand, for comparison or as prior knowledge; both below each other where given."""
    named = [artifact for _, artifact, _ in named_files(prototype) if artifact != layout.SIBLINGS]
    tables = [run.read_table(artifact) for artifact in named]
    names = dict.fromkeys(name for table in tables for name in table)
    return {
        name: np.concatenate([table.get(name, np.full(len(table["q"]), np.nan)) for table in tables]) for name in names
    }


def _accepted(run: RunFolder, prototype: Prototype) -> tuple[str, ...]:
    """Findings that the quality gates let pass by the settings, those of the logs first."""
    accepted = [
        f"{log_title(role, name)}: {text}"
        for role, name, _ in layout.logs(prototype)
        for text in run.record(layout.record(role, name)).notes.get("accepted", ())
    ]
    held = [artifact for artifact in (layout.CHECK, layout.MODELS) if artifact in run.manifest.artifacts]
    return (*accepted, *(text for artifact in held for text in run.record(artifact).notes.get("accepted", ())))


def read_study(run: RunFolder, name: StudyName, plant: Device) -> Study:
    """A study in SI units, but for the regularisation parameter, which is in the unit that the settings take."""
    columns = run.read_table(layout.study(name))
    units = {column.key: column.unit for column in schemas.schema_of(schemas.STUDIES[name], plant).columns}
    if name == "alpha":
        symbol, factor = ALPHA_UNIT[plant.displacement.symbol]
        columns["alpha"] = columns["alpha"] / factor
        units["alpha"] = f"{symbol}·s^{run.record(layout.study(name)).notes['order']}"
    return Study(name, columns, units)


def _models(
    run: RunFolder, prototype: Prototype, names: Sequence[str]
) -> tuple[dict[str, DynamicModel], dict[str, dict[str, str]]]:
    """The models that can be loaded, and why others cannot: a run of an older version still has a report."""
    loaded: dict[str, DynamicModel] = {}
    unreadable: dict[str, dict[str, str]] = {}
    for name in names:
        artifact = layout.MODELS if name in identified_models(run, prototype) else layout.baseline(name)
        if artifact not in run.manifest.artifacts:
            continue
        tree = run.read_tree(artifact, name)
        try:
            loaded[name] = model_from_tree(name, tree)
        except DebistError as error:
            unreadable[name] = {"not_loaded": str(error)}
    return loaded, unreadable


def _description(run: RunFolder, prototype: Prototype, name: str) -> dict[str, Any]:
    if name in identified_models(run, prototype):
        described = run.record(layout.MODELS).notes.get(name, {})
    else:
        record = run.manifest.artifacts.get(layout.baseline(name))
        described = record.notes if record else {}
    facts = choice_facts(run.record(layout.MODELS).notes.get(CHOICE), name)
    return {key: value for key, value in described.items() if key != TIMES} | facts


def choice_facts(choice: Mapping[str, Any] | None, name: str) -> dict[str, Any]:
    """Reasons why "auto" chose the model `name`, for readers; empty where it chose another or was not used."""
    if choice is None or choice["chosen"] != name:
        return {}
    facts: dict[str, Any] = {WHY: choice["reason"]}
    facts |= {f"held-out error of {model} [%]": 100.0 * error for model, error in choice["held_out_error"].items()}
    if (excess := choice["excess_of_the_other"]) is not None:
        low, high = (f"{100.0 * excess[end]:.2f}" for end in ("low", "high"))
        facts["the other's error is higher by, 95 % interval"] = f"{low} to {high} % of the range"
    return facts


def _log(run: RunFolder, models: Sequence[str], role: Role, name: str, source: str) -> LogData:
    made = {m: a for m in models if (a := layout.predictions(role, name, m)) in run.manifest.artifacts}
    return LogData(
        role=role,
        name=name,
        source=source,
        record=run.read_table(layout.record(role, name)),
        motion=log_of(run.read_table(layout.kinematics(role, name))),
        predictions={m: run.read_table(artifact) for m, artifact in made.items()},
        outcomes={m: run.record(artifact).notes for m, artifact in made.items()},
        record_notes=run.record(layout.record(role, name)).notes,
        kinematics_notes=run.record(layout.kinematics(role, name)).notes,
    )


def provenance(run: RunFolder, prototype: Prototype) -> dict[str, Any]:
    """Provenance of every number: settings, raw logs, artifacts, versions. No times, no machine's paths."""
    return {
        "prototype": json.loads(prototype.model_dump_json()),
        "prototype_file": run.manifest.prototype_file.rpartition("/")[2],
        "versions": dict(run.manifest.versions),
        "artifacts": [
            {
                "artifact": artifact,
                "stage": record.recipe.stage,
                "algorithm": record.recipe.algorithm,
                "content_hash": record.content_hash,
                "bytes": record.bytes,
            }
            for artifact, record in sorted(run.manifest.artifacts.items())
            if record.recipe.stage != "report"
        ],
        "sources": [
            {"log": log_title(role, name), "file": path, "sha256": digest}
            for role, name, path in layout.logs(prototype)
            for digest in run.record(layout.record(role, name)).recipe.inputs.values()
        ],
    }


def load_scores(root: Path) -> list[dict[str, Any]]:
    """The score rows of a run as records, null where a value is undefined."""
    return in_snapshot(root, lambda run: run.read_records(layout.SCORES))


def instruments_shown(root: Path) -> tuple[list[dict[str, Any]], Mapping[tuple[str, str], LogPart], str]:
    """The errors of the instruments of a run's logs, the settings of each log, and the unit of q."""
    return in_snapshot(
        root,
        lambda run: (
            list(_instruments(run)),
            dict[tuple[str, str], LogPart](((role, log), part) for role, log, part in layout.log_parts(run.prototype)),
            device(run.prototype).displacement.symbol,
        ),
    )


def load_datasheet(root: Path) -> dict[str, Any]:
    """The document ``datasheet.json`` of a run, checked against the manifest.

    Raises
    ------
    InputError
        It was not made yet.
    CorruptArtifactError
        It is damaged.
    """
    return in_snapshot(root, lambda run: run.read_document(layout.DATASHEET))


def ingested(run: RunFolder) -> list[dict[str, Any]]:
    """Ingest results of each log: rows of its uniform record, their interval [s], masked rows, and gaps in time."""
    return [
        {
            "log": log_title(role, true_name(path)),
            "rows": notes["rows"],
            "masked_rows": notes["masked_rows"],
            "interval_s": notes["interval"],
            "gaps": notes["gaps_in_time"],
        }
        for role, log, path in layout.logs(run.prototype)
        for notes in [run.record(layout.signals(role, log)).notes]
    ]


def differentiated(run: RunFolder) -> list[dict[str, Any]]:
    """Method of each log, with α and the noise of each of its segments, in units that the settings have α in."""
    unit = ALPHA_UNIT[device(run.prototype).displacement.symbol][0]
    results = []
    for role, log, path in layout.logs(run.prototype):
        notes = run.record(layout.kinematics(role, log)).notes
        of_velocity = notes["of"] == "velocity"
        regularised = notes["method"] == "tvregdiff"
        results.append(
            {
                "log": log_title(role, true_name(path)),
                "method": notes["method"],
                "of": notes["of"],
                "alphas": [segment["alpha"] for segment in notes["stretches"]] if regularised else [],
                "alpha_unit": f"{unit}·s^{notes['order'] - of_velocity}" if regularised else "",
                "noises": [segment["noise_std"] for segment in notes["stretches"]],
                "noise_unit": f"{unit}/s" if of_velocity else unit,
            }
        )
    return results


def identified(run: RunFolder) -> list[dict[str, Any]]:
    """Processor time [s] of each identified model, whether it is the main model, and why where "auto" chose it."""
    notes = run.record(layout.MODELS).notes
    choice = notes.get(CHOICE, {})
    return [
        {
            "model": model,
            "headline": k == 0,
            "fit_s": notes[model].get(TIMES, {}).get("fit_s"),
            "reason": choice["reason"] if model == choice.get("chosen") else "",
        }
        for k, model in enumerate(notes[IDENTIFIED])
    ]
