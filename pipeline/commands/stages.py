"""The stages of a run, each alone."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from ..system.names import Typeface
from . import outcome
from .console import Details, Form, Json, Output, Progress, PrototypeFile, Quiet, Run

if TYPE_CHECKING:
    from ..workflow.engine import TaskStatus
    from ..workflow.run import StageName


def ingest(prototype: PrototypeFile, output: Output = None, as_json: Json = False, quiet: Quiet = False) -> None:
    """Read the raw logs into uniform records in SI units (signals.parquet: s, m, V).

    Example: debist ingest P1.toml -o runs/P1
    """
    from ..store.run_folder import in_snapshot
    from ..workflow.place import place_of
    from ..workflow.report_data import ingested
    from ..workflow.run import run_prototype

    place = place_of(prototype, output)
    with Progress(quiet=quiet) as progress:
        done = run_prototype(place, None, progress, only="ingest")
    outcome.emit_tasks(done, as_json=as_json, results=in_snapshot(place.root, ingested))


def differentiate(run: Run, as_json: Json = False, quiet: Quiet = False) -> None:
    """Velocity [m/s] and acceleration [m/s²] by regularised differentiation (kinematics.parquet).

    Example: debist differentiate runs/P1
    """
    from ..store.run_folder import in_snapshot
    from ..workflow.report_data import differentiated

    done = _done(run, "differentiate", quiet)
    outcome.emit_tasks(done, as_json=as_json, results=in_snapshot(run, differentiated))


def identify(run: Run, as_json: Json = False, quiet: Quiet = False) -> None:
    """Identify the models on the training logs (model.h5).

    Example: debist identify runs/P1
    """
    from ..store.run_folder import in_snapshot
    from ..workflow.report_data import identified

    done = _done(run, "identify", quiet)
    outcome.emit_tasks(done, as_json=as_json, results=in_snapshot(run, identified))


def validate(
    run: Run, form: Form = "text", details: Details = False, as_json: Json = False, quiet: Quiet = False
) -> None:
    """Free run of the identified models on every log, and the NRMSE table (scores.parquet).

    NRMSE is the root mean square error over the measured range (eq. 41), printed in percent, a fraction in JSON.
    Example: debist validate runs/P1
    """
    _done(run, "validate", quiet)
    outcome.emit_scores(run, as_json=as_json, form=form, details=details)


def compare(
    run: Run, form: Form = "text", details: Details = False, as_json: Json = False, quiet: Quiet = False
) -> None:
    """Fit the baselines (SINDy, analytical, black boxes) on the same logs and add them to the scores.

    NRMSE in percent. Example: debist compare runs/P1
    """
    _done(run, "compare", quiet)
    outcome.emit_scores(run, as_json=as_json, form=form, details=details)


def report(
    run: Run,
    figures: Annotated[
        Typeface | None, typer.Option("--figures", help="Also every figure as SVG and PDF, in this typeface.")
    ] = None,
    as_json: Json = False,
    quiet: Quiet = False,
) -> None:
    """Page (report.html) and datasheet (datasheet.json), from what the run holds; figures for a paper on request.

    Lengths in mm, voltages in kV, errors in percent; SI in the JSON. Example: debist report runs/P1 --figures serif
    """
    outcome.emit_tasks(_done(run, "report", quiet, figures), as_json=as_json)
    if not as_json:
        outcome.emit_verdict(run)


def _done(run: Path, stage: "StageName", quiet: bool, figures: Typeface | None = None) -> "list[TaskStatus]":
    """Bring one stage of a run up to date."""
    from ..workflow.run import run_stage

    with Progress(quiet=quiet) as progress:
        return run_stage(run, stage, progress, figures=figures)
