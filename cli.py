"""The `debist` command: each command translates its options, calls one stage and prints one summary.

Heavy imports stand inside the commands, so that `debist --help` answers at once.
"""

import gc
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal

import typer

from pipeline.choices import Typeface
from pipeline.commands import control, integrity, outcome, physics, results, rig
from pipeline.commands.boundary import ErrorBoundary, Program
from pipeline.commands.console import Force, Json, Progress, PrototypeFile, Quiet, Run, Runs, emit_json, emit_table
from pipeline.commands.inspection import check, emit_inspection, inspection_document
from pipeline.errors import BatchFailedError, InputError
from pipeline.machine import settle_machine

if TYPE_CHECKING:
    from pipeline.runs.engine import TaskStatus
    from pipeline.stages.run import StageName

app = Program(
    name="debist",
    cls=ErrorBoundary,
    no_args_is_help=True,
    rich_markup_mode=None,
    pretty_exceptions_enable=False,
    help="From the raw rig log of a bistable dielectric-elastomer joint to a validated dynamic model.",
    epilog="Exit codes: 0 done, 1 a bug of debist, 2 usage or bad input, 3 data refused, 4 corrupt artifact, "
    "5 run locked, 6 some prototypes of a batch failed, 130 interrupted, 128 + n ended by signal n.",
)

app.add_typer(control.app, name="control")
app.add_typer(physics.app, name="physics")
app.add_typer(rig.app, name="rig")
app.add_typer(results.study, name="study")
app.command()(check)
app.command()(results.diff)
app.command()(results.export)
app.command()(integrity.verify)
app.command()(integrity.repair)
app.command()(integrity.sign)
app.command()(results.paper)

LogArgument = Annotated[Path, typer.Argument(metavar="LOG", help="Raw log: MAT, MDF4, CSV, Parquet or HDF5.")]
Output = Annotated[
    Path | None,
    typer.Option("-o", "--output", metavar="RUN", help="Run folder [default: runs/NAME]."),
]
TableFormat = Literal["text", "csv", "latex", "markdown"]
Form = Annotated[TableFormat, typer.Option("--format", help="Form of the table.")]
Report = Annotated[bool, typer.Option("--report/--no-report", help="Make the report of each prototype.")]
Details = Annotated[
    bool, typer.Option("--details", help="The whole tables: every log, intervals, horizons, switching times.")
]


def _version(requested: bool) -> None:
    if requested:
        from pipeline import __version__

        typer.echo(f"debist {__version__}")
        raise typer.Exit()


@app.callback()
def main(
    version: Annotated[
        bool, typer.Option("--version", callback=_version, is_eager=True, help="Print the version.")
    ] = False,
) -> None:
    """From the raw rig log of a bistable dielectric-elastomer joint to a validated dynamic model."""
    settle_machine()
    # A tenth of the time of figures and compilation goes into looking for cycles that are hardly ever there.
    gc.set_threshold(100_000, 20, 20)


def _done(run: Path, stage: "StageName", quiet: bool, figures: Typeface | None = None) -> "list[TaskStatus]":
    """Bring one stage of a run up to date."""
    from pipeline.stages.run import run_stage

    with Progress(quiet=quiet) as progress:
        return run_stage(run, stage, progress, figures=figures)


@app.command()
def init(
    logs: Annotated[
        list[Path], typer.Argument(metavar="LOG...", help="Raw logs of one device: MAT, MDF4, CSV, Parquet or HDF5.")
    ],
    as_json: Json = False,
) -> None:
    """Print a starting settings file for raw logs; what cannot be known is left for you to fill in.

    Units are those of the logs where they state them; which log is for validation is proposed by its name.
    Example: debist init train.mat validation.mat > P1.toml
    """
    from pipeline.rig_logs.draft import toml_draft
    from pipeline.rig_logs.inspection import inspect_log

    draft = toml_draft([inspect_log(log) for log in logs], [str(log) for log in logs])
    if as_json:
        emit_json({"toml": draft})
    else:
        typer.echo(draft, nl=False)


@app.command()
def inspect(
    log: LogArgument,
    settings: Annotated[
        Path | None,
        typer.Option("--settings", metavar="PROTOTYPE.toml", help="Which channel is what [default: by name and unit]."),
    ] = None,
    as_json: Json = False,
) -> None:
    """Channels, units, rates, gaps, saturation and hum of a raw log; what it does not excite, and what to add.

    Times in s, rates in Hz, values in the log's own units. Example: debist inspect train.mat
    """
    from pipeline.tools.inspection import inspect as inspect_stage

    inspection, excitation = inspect_stage(log, settings)
    if as_json:
        emit_json(inspection_document(inspection, excitation))
    else:
        emit_inspection(inspection, excitation)


@app.command()
def ingest(prototype: PrototypeFile, output: Output = None, as_json: Json = False, quiet: Quiet = False) -> None:
    """Read the raw logs into uniform records in SI units (signals.parquet: s, m, V).

    Example: debist ingest P1.toml -o runs/P1
    """
    from pipeline.stages.run import run_prototype

    with Progress(quiet=quiet) as progress:
        done = run_prototype(prototype, output, progress, only="ingest")
    outcome.emit_tasks(done, as_json=as_json)


@app.command()
def differentiate(run: Run, as_json: Json = False, quiet: Quiet = False) -> None:
    """Velocity [m/s] and acceleration [m/s²] by regularised differentiation (kinematics.parquet).

    Example: debist differentiate runs/P1
    """
    outcome.emit_tasks(_done(run, "differentiate", quiet), as_json=as_json)


@app.command()
def identify(run: Run, as_json: Json = False, quiet: Quiet = False) -> None:
    """Identify the models on the training logs (model.h5).

    Example: debist identify runs/P1
    """
    outcome.emit_tasks(_done(run, "identify", quiet), as_json=as_json)


@app.command()
def validate(
    run: Run, form: Form = "text", details: Details = False, as_json: Json = False, quiet: Quiet = False
) -> None:
    """Free run of the identified models on every log, and the NRMSE table (scores.parquet).

    NRMSE is the root mean square error over the measured range (eq. 41), printed in percent, a fraction in JSON.
    Example: debist validate runs/P1
    """
    _done(run, "validate", quiet)
    outcome.emit_scores(run, as_json=as_json, form=form, details=details)


@app.command()
def compare(
    run: Run, form: Form = "text", details: Details = False, as_json: Json = False, quiet: Quiet = False
) -> None:
    """Fit the baselines (SINDy, analytical, black boxes) on the same logs and add them to the scores.

    NRMSE in percent. Example: debist compare runs/P1
    """
    _done(run, "compare", quiet)
    outcome.emit_scores(run, as_json=as_json, form=form, details=details)


@app.command()
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
        typer.echo(f"open {run / 'report.html'}")


@app.command()
def plot(
    runs: Runs,
    figure: Annotated[
        str | None, typer.Option("-f", "--figure", help="Name of the figure [default: list them].")
    ] = None,
    output: Annotated[
        Path | None,
        typer.Option("-o", "--output", help="File (.svg, .pdf, .png), or a folder for several runs [default: here]."),
    ] = None,
    start: Annotated[float | None, typer.Option("--from", help="Start of the stretch, in s or SI.")] = None,
    stop: Annotated[float | None, typer.Option("--to", help="End of the stretch, in s or SI.")] = None,
    typeface: Annotated[Typeface, typer.Option("--typeface", help="Typeface of the figure.")] = "sans",
    model: Annotated[
        list[str] | None, typer.Option(help="A model to draw; repeat for more [default: as in the report].")
    ] = None,
    force: Force = False,
    as_json: Json = False,
) -> None:
    """One figure of one or several runs as SVG, PDF or PNG; without --figure the names of all figures.

    Times in s. Example: debist plot runs/P1 -f validation-validation-models -o models.pdf --from 18 --to 24
    """
    from pipeline.tools.plot import Excerpt, plot_runs, run_figures

    if figure is None:
        names = list(run_figures(runs[0]).titles.items())
        if as_json:
            emit_json({"figures": [{"name": name, "title": title} for name, title in names]})
        else:
            emit_table(f"figures of {runs[0]}", ("figure", "shows"), names, numeric_from=2)
        return
    written = plot_runs(runs, figure, output, Excerpt(start, stop, model or (), typeface), force=force)
    if as_json:
        emit_json({"written": written})
    else:
        typer.echo("\n".join(map(str, written)))


@app.command()
def show(run: Run, as_json: Json = False) -> None:
    """Datasheet of a run: wells, barriers, switching voltages, ring-down, and the verdict on data and model.

    Lengths in mm, voltages in kV; SI in the JSON. Example: debist show runs/P1
    """
    from pipeline.loading.report_data import load_datasheet
    from pipeline.reporting.datasheet_rows import show_datasheet

    document = load_datasheet(run)
    if as_json:
        emit_json(document)
        return
    shown = show_datasheet(document)
    emit_table(f"{shown.title}; ring-downs of small motion", ("quantity", "model", "90 % interval"), shown.facts)
    if shown.seen:
        emit_table("the same events of the logs", ("quantity", "free run of the model", "measured"), shown.seen)
    emit_table(f"verdict: {shown.verdict}", ("about", "grade", "finding", "what to do"), shown.checks, numeric_from=4)


@app.command("run")
def run_command(
    prototype: PrototypeFile,
    output: Output = None,
    with_report: Report = True,
    details: Details = False,
    only_plan: Annotated[bool, typer.Option("--dry-run", help="Only say what would be done, and why.")] = False,
    replace: Annotated[
        bool, typer.Option("--replace", help="Take over the folder of another prototype's run, overwriting it.")
    ] = False,
    as_json: Json = False,
    quiet: Quiet = False,
) -> None:
    """All stages from the raw logs to the NRMSE table; what is up to date is skipped.

    NRMSE in percent. Example: debist run P1.toml -o runs/P1
    """
    from pipeline.stages.belonging import place_of
    from pipeline.stages.run import dry_run, run_prototype

    place = place_of(prototype, output)
    if only_plan:
        outcome.emit_status(f"plan for {place.root}", dry_run(place, replace=replace), as_json=as_json)
        return
    with Progress(quiet=quiet) as progress:
        results = run_prototype(place, None, progress, with_report=with_report, replace=replace)
    outcome.emit_scores(place.root, as_json=as_json, details=details)
    if not as_json:
        if with_report:
            outcome.emit_verdict(place.root)
        typer.echo(outcome.summary(results))
    outcome.emit_stale_exports(place.root)


@app.command()
def demo(output: Output = None, force: Force = False, as_json: Json = False, quiet: Quiet = False) -> None:
    """Simulated logs of a virtual prototype, then the whole run on them; needs no file and no network.

    NRMSE in percent. Example: debist demo -o runs/demo
    """
    from pipeline.rig.demo import write_demo_logs
    from pipeline.stages.run import run_prototype

    folder = output or Path("runs/demo")
    with Progress(quiet=quiet) as progress:
        results = run_prototype(write_demo_logs(folder, force=force), folder, progress)
    outcome.emit_scores(folder, as_json=as_json)
    if not as_json:
        outcome.emit_verdict(folder)
        typer.echo(f"{outcome.summary(results)}; the logs are simulated. Next: debist status {folder}")


@app.command()
def status(
    runs: Runs,
    brief_form: Annotated[bool, typer.Option("--brief", help="One line for each run, as always for several.")] = False,
    as_json: Json = False,
) -> None:
    """What is stale in a run, and why: its artifacts against the logs and the settings file of today.

    Example: debist status runs/P1
    """
    from pipeline.stages.run import fleet_status, missing_settings, run_status

    if brief_form or len(runs) > 1:
        outcome.emit_fleet_status(fleet_status(runs), as_json=as_json)
        return
    outcome.emit_status(f"{runs[0]}", run_status(runs[0]), as_json=as_json)
    outcome.emit_stale_exports(runs[0])
    if said := missing_settings(runs[0]):
        typer.echo(f"note: {said}", err=True)


@app.command()
def batch(
    fleet: Annotated[list[Path], typer.Argument(metavar="FLEET...", help="Settings files, folders, or a fleet file.")],
    output: Annotated[Path, typer.Option("-o", "--output", metavar="DIR", help="Folder for the runs and the tables.")],
    jobs: Annotated[int, typer.Option("--jobs", "-j", min=1, help="Processes at a time.")] = 1,
    fail_fast: Annotated[bool, typer.Option("--fail-fast/--keep-going", help="Start no more after a failure.")] = False,
    collect: Annotated[bool, typer.Option("--collect", help="Only the fleet tables, from the runs in DIR.")] = False,
    time_limit: Annotated[
        str, typer.Option("--time-limit", help="Wall time after which a prototype is stopped and has failed.")
    ] = "4 h",
    with_report: Report = True,
    as_json: Json = False,
) -> None:
    """Run many prototypes, one process each; a rerun does only what is missing or stale.

    Writes fleet.parquet and fleet.csv (NRMSE as fractions). Example: debist batch prototypes/ -o runs --jobs 2
    """
    from pipeline.batch.batch import collect_batch, named_prototypes, prototype_files, run_batch
    from pipeline.units import parse_quantity

    named, limit = named_prototypes(prototype_files(fleet)), parse_quantity(time_limit, ("s",), "--time-limit")
    if not 1.0 <= limit <= 1e7:
        raise InputError(f"--time-limit {time_limit}: a prototype may take 1 s to 1e7 s (16 weeks)")
    if collect:
        outcomes = collect_batch(named, output)
    else:
        with outcome.BatchProgress(len(named)) as progress:
            outcomes = run_batch(
                named, output, jobs, progress, program="cli:app", fail_fast=fail_fast, report=with_report,
                time_limit=limit,
            )  # fmt: skip
    outcome.emit_outcomes(outcomes, output, as_json=as_json)
    failed = [one.name for one in outcomes if one.failed]
    if failed:
        raise BatchFailedError(f"{len(failed)} of {len(outcomes)} prototypes failed: {', '.join(failed)}")
