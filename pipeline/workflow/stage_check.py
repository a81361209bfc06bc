"""Check of every log against the settings, before anything is differentiated or fitted."""

from collections.abc import Mapping
from dataclasses import asdict
from functools import partial
from typing import Any, get_args

from ..device.device import device
from ..diagnostics.check import check_logs, check_rows, refusing, remarks
from ..diagnostics.copies import shared_recordings
from ..diagnostics.log_facts import LogSignals
from ..diagnostics.log_sentences import shared_spans
from ..diagnostics.sentences import accepted_settings, judge
from ..errors import InputError
from ..settings.prototype import CheckGate, Prototype
from ..signals.findings import Finding
from ..signals.log import voltages
from ..store import layout
from ..store.run_folder import RunFolder, Written
from ..store.tables import Table
from ..system.names import log_title, true_name
from .engine import Task

ALGORITHM = "28"


def tasks(prototype: Prototype) -> list[Task]:
    """One task for all logs."""
    plant = device(prototype)
    return [
        Task(
            stage="check",
            title="logs against settings",
            algorithm=ALGORITHM,
            settings={
                "mass": plant.known_mass,
                "inputs": plant.action,
                "sample_interval": prototype.ingest.sample_interval,
                "film_thickness": plant.film_thickness,
                "field_limit": plant.field_limit,
                **accepted_settings(prototype.quality, get_args(CheckGate)),
            },
            inputs=tuple(layout.record(role, log) for role, log, _ in layout.logs(prototype)),
            outputs=(layout.CHECK,),
            work=partial(_check, prototype=prototype),
        )
    ]


def _check(run: RunFolder, prototype: Prototype) -> Mapping[str, Written]:
    findings = examine(run, prototype)
    accepted = assess(findings, prototype)
    document = {"rows": [asdict(row) for row in check_rows(findings)], "accepted": accepted}
    notes = {"warnings": [*remarks(findings), *accepted], "accepted": accepted}
    return {layout.CHECK: run.write_json(layout.CHECK, document, notes)}


def examine(run: RunFolder, prototype: Prototype) -> list[Finding]:
    """Look at the ingested logs of a run; nothing is written.

    Raises
    ------
    InputError
        A validation log holds a recording that a training log holds too.
    """
    logs = signals(run, prototype)
    shared = shared_recordings(logs)
    named = layout.logs(prototype)
    for i, k, finding in shared:
        if named[i][0] != named[k][0]:
            raise InputError(
                f"logs.validation: {named[k][2]!r} holds the recording of the training log {named[i][2]!r}: "
                f"{shared_spans(finding)}; validate on a recording of its own, or cut what both hold"
            )
    return [
        *check_logs(logs, device(prototype), prototype.ingest.sample_interval),
        *(finding for _, _, finding in shared),
    ]


def signals(run: RunFolder, prototype: Prototype) -> list[LogSignals]:
    """The ingested logs of a run as the checks take them."""
    records = {layout.record(role, log): log_title(role, true_name(path)) for role, log, path in layout.logs(prototype)}
    return [log_signals(title, run.read_table(name), run.record(name).notes) for name, title in records.items()]


def log_signals(name: str, table: Table, notes: Mapping[str, Any]) -> LogSignals:
    """A uniform record as the checks take it, with what was noted when it was ingested."""
    return LogSignals(
        name=name,
        t=table["t"],
        q=table["q"],
        v=voltages(table),
        raw_step=notes["raw_step"],
        noise=notes.get("noise"),
        resolution=notes.get("resolution"),
        held=notes.get("held", 1),
        sketch=tuple((int(value), float(stamp)) for value, stamp in notes.get("sketch", ())),
    )


def assess(findings: list[Finding], prototype: Prototype) -> list[str]:
    """Accepted findings among those that would make the model wrong, as texts.

    Raises
    ------
    DataRefusedError
        Something is not accepted.
    """
    return judge(prototype.name, refusing(findings), prototype.quality)
