"""The `debist` command, assembled from `pipeline.commands`.

Each command translates its options, makes one call and prints one summary. Heavy imports stand inside the commands, so
that `debist --help` answers at once. `batch` stands here, for its processes run this program.
"""

import gc
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated

import typer

from pipeline.commands import control, fleet, inspection, integrity, outcome, physics, results, rig, stages, whole_run
from pipeline.commands.boundary import ErrorBoundary, Program, with_options
from pipeline.commands.console import Json, Quiet, Report, emit_json
from pipeline.errors import BatchFailedError, InputError
from pipeline.machine import settle_machine

app = Program(
    name="debist",
    cls=ErrorBoundary,
    no_args_is_help=True,
    rich_markup_mode=None,
    pretty_exceptions_enable=False,
    help="From the raw rig log of a bistable dielectric-elastomer joint to a validated dynamic model.",
    epilog="Exit codes: 0 done, 1 a bug of debist, 2 usage or bad input, 3 data refused, 4 corrupt artifact, "
    "5 run locked, 6 some prototypes of a batch failed. Also 130 interrupted, 128 + n ended by signal n.",
)

app.add_typer(control.app, name="control")
app.add_typer(fleet.app, name="fleet")
app.add_typer(physics.app, name="physics")
app.add_typer(rig.app, name="rig")
app.add_typer(results.study, name="study")
app.command()(inspection.check)
app.command()(results.diff)
app.command()(fleet.series)
app.command()(results.export)
app.command()(integrity.verify)
app.command()(integrity.repair)
app.command()(results.paper)
app.command()(inspection.init)
app.command()(inspection.inspect)
app.command()(stages.ingest)
app.command()(stages.differentiate)
app.command()(stages.identify)
app.command()(stages.validate)
app.command()(stages.compare)
app.command()(stages.report)
app.command()(whole_run.plot)
app.command()(whole_run.show)
app.command("run")(whole_run.run_command)
app.command()(whole_run.demo)
app.command()(whole_run.status)
app.command()(whole_run.warmup)


def _version(requested: bool) -> None:
    if requested:
        from pipeline import __version__

        typer.echo(f"debist {__version__}")
        raise typer.Exit()


def _capabilities(requested: bool) -> None:
    if requested:
        from pipeline.capabilities import capabilities

        emit_json(capabilities())
        raise typer.Exit()


@app.callback()
def main(
    version: Annotated[
        bool, typer.Option("--version", callback=_version, is_eager=True, help="Print the version.")
    ] = False,
    capabilities: Annotated[
        bool,
        typer.Option("--capabilities", callback=_capabilities, help="Print what goes in, what comes out, as JSON."),
    ] = False,
    as_json: Annotated[bool, typer.Option("--json", hidden=True)] = False,
) -> None:
    """From the raw rig log of a bistable dielectric-elastomer joint to a validated dynamic model."""
    settle_machine()
    # A tenth of the time of figures and compilation goes into looking for cycles that are hardly ever there.
    gc.set_threshold(500_000, 20, 20)


def debist(arguments: list[str]) -> None:
    """Be the command with these arguments, as each process of a batch is."""
    app(arguments)


@dataclass(frozen=True)
class BatchOptions:
    """Which prototypes of a batch run, and how."""

    jobs: Annotated[int, typer.Option("--jobs", "-j", min=1, help="Processes at a time.")] = 1
    fail_fast: Annotated[bool, typer.Option("--fail-fast/--keep-going", help="Start no more after a failure.")] = False
    collect: Annotated[
        bool, typer.Option("--collect", help="Only the fleet tables, from the runs in DIR; joins all shards.")
    ] = False
    shard: Annotated[
        str | None,
        typer.Option("--shard", metavar="I/N", help="Only part I of N, from 1; which one is decided by the name."),
    ] = None
    siblings: Annotated[
        Path | None, typer.Option("--siblings", metavar="FILE", help="Prior of `debist fleet learn` for all of them.")
    ] = None
    time_limit: Annotated[
        str, typer.Option("--time-limit", help="Wall time after which a prototype is stopped and has failed.")
    ] = "4 h"


@app.command()
@with_options
def batch(
    prototypes: Annotated[
        list[Path], typer.Argument(metavar="FLEET...", help="Settings files, folders, or a fleet file.")
    ],
    output: Annotated[Path, typer.Option("-o", "--output", metavar="DIR", help="Folder for the runs and the tables.")],
    options: BatchOptions,
    with_report: Report = True,
    as_json: Json = False,
    quiet: Quiet = False,
) -> None:
    """Run many prototypes, one process each; a rerun does only what is missing or stale.

    Writes fleet.parquet and fleet.csv (NRMSE as fractions); a shard leaves them to --collect. While it works,
    `debist status DIR` shows how far it is. Example: debist batch prototypes/ -o runs --jobs 2
    """
    from pipeline.batch.batch import Execution, collect_batch, named_prototypes, prototype_files, run_batch
    from pipeline.batch.journal import Shard
    from pipeline.batch.matrix import with_siblings
    from pipeline.units import parse_quantity

    named, limit = (
        named_prototypes(prototype_files(prototypes)),
        parse_quantity(options.time_limit, ("s",), "--time-limit"),
    )
    if options.siblings is not None and not options.collect:
        named = with_siblings(named, options.siblings, output)
    if not 1.0 <= limit <= 1e7:
        raise InputError(f"--time-limit {options.time_limit}: a prototype may take 1 s to 1e7 s (16 weeks)")
    shard = None if options.shard is None else Shard.parse(options.shard)
    if options.collect:
        if shard is not None:
            raise InputError("--collect joins all shards; give it without --shard")
        outcomes = collect_batch(named, output)
    else:
        count = sum(shard is None or shard.holds(name) for name, _ in named)
        with outcome.BatchProgress(count, quiet=quiet) as progress:
            execution = Execution(options.jobs, with_report, options.fail_fast, limit)
            outcomes = run_batch(named, output, progress, debist, execution, shard)
    outcome.emit_outcomes(outcomes, output, as_json=as_json)
    failed = [result.name for result in outcomes if result.failed]
    if failed:
        raise BatchFailedError(f"{len(failed)} of {len(outcomes)} prototypes failed: {', '.join(failed)}")


@results.study.command("settings")
def study_settings(
    prototype: Annotated[Path, typer.Argument(metavar="PROTOTYPE.toml", help="Settings that are varied.")],
    sets: Annotated[
        list[str], typer.Option("--set", metavar="KEY=V,V", help="A key and its values; repeat for more keys.")
    ],
    output: Annotated[Path, typer.Option("-o", "--output", metavar="DIR", help="Folder for the runs and the tables.")],
    jobs: Annotated[int, typer.Option("--jobs", "-j", min=1, help="Processes at a time.")] = 1,
    as_json: Json = False,
    quiet: Quiet = False,
) -> None:
    """Run one prototype with every combination of some settings, and compare the runs: NRMSE of q in percent.

    Example: debist study settings P1.toml --set identify.basis_functions=6,8 --set differentiate.alpha=auto,0.01 -o m
    """
    from pipeline.batch.batch import Execution, named_prototypes, run_batch
    from pipeline.batch.matrix import matrix_rows, write_matrix

    variants = write_matrix(prototype, sets, output)
    named = named_prototypes([variant.path for variant in variants])
    with outcome.BatchProgress(len(named), quiet=quiet or as_json) as progress:
        outcomes = run_batch(named, output, progress, debist, Execution(jobs, report=False))
    runs = {variant.name: output / run.name for variant, run in zip(variants, outcomes, strict=True) if not run.failed}
    results.emit_matrix(matrix_rows(runs, variants), as_json=as_json)
    if failed := [result for result in outcomes if result.failed]:
        raise BatchFailedError(f"{len(failed)} of {len(outcomes)} runs failed: {failed[0].name}: {failed[0].reason}")
