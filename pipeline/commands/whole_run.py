"""A run: made as a whole or stage by stage, looked at."""

from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from ..system.machine import cores
from ..system.names import Typeface, shell_word
from . import outcome
from .boundary import with_options
from .console import (
    Details,
    Force,
    Json,
    NoReport,
    Output,
    Progress,
    PrototypeFile,
    Quiet,
    Run,
    Runs,
    StatusLine,
    emit_json,
    emit_table,
)

if TYPE_CHECKING:
    from ..workflow.engine import TaskStatus
    from ..workflow.run import StageName


def show(run: Run, as_json: Json = False) -> None:
    """Datasheet of a run: wells, barriers, switching voltages, ring-down, and the assessment of data and model.

    Lengths in mm, voltages in kV; SI in the JSON. Example: debist show runs/P1
    """
    from ..reporting.datasheet_rows import datasheet_tables
    from ..workflow.report_data import load_datasheet

    document = load_datasheet(run)
    if as_json:
        emit_json(document)
    else:
        facts, *more, assessment = datasheet_tables(document)
        for table in (facts, *(table for table in more if table[-1])):
            emit_table(*table)
        outcome.emit_instruments(run)
        emit_table(*assessment, numeric_from=None)


@dataclass(frozen=True)
class Making:
    """Options for the execution of a run."""

    only_plan: Annotated[bool, typer.Option("--dry-run", help="Only say what would be done, and why.")] = False
    replace: Annotated[
        bool, typer.Option("--replace", help="Take over the folder of another prototype's run, overwriting it.")
    ] = False
    jobs: Annotated[int | None, typer.Option("--jobs", min=1, help="Processes [default: all cores].")] = None


@with_options
def run_command(
    prototype: PrototypeFile,
    making: Making,
    output: Output = None,
    no_report: NoReport = False,
    details: Details = False,
    as_json: Json = False,
    quiet: Quiet = False,
) -> None:
    """All stages from the raw logs to the NRMSE table; what is up to date is skipped.

    NRMSE in percent. Example: debist run P1.toml -o runs/P1
    """
    from ..workflow.place import place_of
    from ..workflow.run import dry_run, run_prototype

    place = place_of(prototype, output)
    if making.only_plan:
        outcome.emit_status(f"plan for {place.root}", dry_run(place, replace=making.replace), as_json=as_json)
        return
    _announce_compilation(quiet)
    with Progress(quiet=quiet) as progress:
        results = run_prototype(
            place, None, progress, with_report=not no_report, replace=making.replace, jobs=making.jobs or cores()
        )
    outcome.emit_scores(place.root, as_json=as_json, details=details, with_report=not no_report)
    if not as_json:
        outcome.emit_instruments(place.root)
        if not no_report:
            outcome.emit_assessment(place.root)
        typer.echo(outcome.summary(results))
    outcome.emit_stale_exports(place.root)


def demo(output: Output = None, force: Force = False, as_json: Json = False, quiet: Quiet = False) -> None:
    """The paper's experiment on a virtual joint, then the whole run on its logs; needs no file and no network.

    Pulses of 3 kV on alternating sides train and validate, as in figures 11 and 15; NRMSE in percent.
    Example: debist demo -o runs/demo
    """
    from ..reporting.paper_page import table_2
    from ..rig.fleet import write_demo_logs
    from ..store.run_folder import holds_run
    from ..workflow.report_data import load_scores
    from ..workflow.run import run_prototype

    folder = output or Path("runs/demo")
    holds_run(folder)  # refuses the files of others, before the rig writes its logs
    _announce_compilation(quiet)
    with Progress(quiet=quiet) as progress:
        results = run_prototype(write_demo_logs(folder, force=force), folder, progress, jobs=cores())
    outcome.emit_scores(folder, as_json=as_json, with_report=True)
    if not as_json:
        outcome.emit_table_2(table_2(load_scores(folder)))
        outcome.emit_assessment(folder)
        typer.echo(f"{outcome.summary(results)}; the logs are simulated. Next: debist status {shell_word(folder)}")


def _announce_compilation(quiet: bool) -> None:
    from ..numerics.kernel_cache import has_kernels
    from ..workflow.warmup import COST

    if not quiet and not has_kernels():
        typer.echo(
            f"compiling once, about {COST:.0f} s of processor time; `debist warmup` does this ahead of a run", err=True
        )


def status(
    runs: Runs,
    brief_form: Annotated[bool, typer.Option("--brief", help="One line for each run, as always for several.")] = False,
    as_json: Json = False,
) -> None:
    """List what is stale in a run, and why; for the folder of a batch: what is done, running, stopped or failed.

    A run's artifacts are compared with the logs and the settings file of today. Example: debist status runs/P1
    """
    from ..workflow.progress import fleet_progress, is_fleet

    if len(runs) == 1 and is_fleet(runs[0]):
        outcome.emit_fleet_progress(runs[0], fleet_progress(runs[0]), as_json=as_json)
        return
    from ..workflow.run import fleet_status, missing_settings, run_status

    if brief_form or len(runs) > 1:
        outcome.emit_fleet_status(fleet_status(runs), as_json=as_json)
        return
    outcome.emit_status(f"{runs[0]}", run_status(runs[0]), as_json=as_json)
    outcome.emit_stale_exports(runs[0])
    if note := missing_settings(runs[0]):
        typer.echo(f"note: {note}", err=True)


def warmup(
    jobs: Annotated[int, typer.Option("--jobs", min=1, help="Processes at a time.")] = 2, as_json: Json = False
) -> None:
    """Compile the kernels once per installation, so that no later command has to.

    Without it the first commands compile what they need. Example: debist warmup
    """
    from ..numerics.kernel_cache import has_kernels
    from ..workflow.warmup import COST, warm_up

    if not has_kernels():
        typer.echo(f"compiling the kernels, once: about {COST:.0f} s of processor time", err=True)
    with StatusLine("compiling") as line:
        seconds = warm_up(jobs, partial(line.show, "compiling"))
    if as_json:
        emit_json({"compiled_in_s": seconds})
    else:
        typer.echo(f"kernels are compiled ({seconds:.0f} s)")


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
        done = run_prototype(place, None, progress, only="ingest", jobs=cores())
    outcome.emit_tasks(done, as_json=as_json, results=in_snapshot(place.root, ingested))


def differentiate(run: Run, as_json: Json = False, quiet: Quiet = False) -> None:
    """Velocity [m/s] and acceleration [m/s²] by regularised differentiation (kinematics.parquet).

    Example: debist differentiate runs/P1
    """
    from ..store.run_folder import in_snapshot
    from ..workflow.report_data import differentiated

    outcome.emit_tasks(_done(run, "differentiate", quiet), as_json=as_json, results=in_snapshot(run, differentiated))


def identify(run: Run, as_json: Json = False, quiet: Quiet = False) -> None:
    """Identify the models on the training logs (model.h5).

    Example: debist identify runs/P1
    """
    from ..store.run_folder import in_snapshot
    from ..workflow.report_data import identified

    outcome.emit_tasks(_done(run, "identify", quiet), as_json=as_json, results=in_snapshot(run, identified))


def validate(run: Run, details: Details = False, as_json: Json = False, quiet: Quiet = False) -> None:
    """Free run of the identified models on every log, and the NRMSE table (scores.parquet).

    NRMSE is the root mean square error over the measured range (eq. 41), printed in percent, a fraction in JSON.
    Example: debist validate runs/P1
    """
    _done(run, "validate", quiet)
    outcome.emit_scores(run, as_json=as_json, details=details)


def compare(run: Run, details: Details = False, as_json: Json = False, quiet: Quiet = False) -> None:
    """Fit the baselines (SINDy, analytical, black boxes) on the same logs and add them to the scores.

    NRMSE in percent. Example: debist compare runs/P1
    """
    _done(run, "compare", quiet)
    outcome.emit_scores(run, as_json=as_json, details=details)


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
        outcome.emit_assessment(run)


def _done(run: Path, stage: "StageName", quiet: bool, figures: Typeface | None = None) -> "list[TaskStatus]":
    """Bring one stage of a run up to date, on all cores but for the report, which is one task."""
    from ..workflow.run import run_stage

    with Progress(quiet=quiet) as progress:
        return run_stage(run, stage, progress, figures=figures, jobs=1 if stage == "report" else cores())
