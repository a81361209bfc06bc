"""The `debist` command, assembled from its groups.

Each command translates its options, makes one call and prints one summary. Heavy imports stand inside the commands, so
that `debist --help` answers at once. `batch` stands here, for its processes run this program.
"""

import atexit
import gc
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated

import typer

from ..errors import BatchFailedError, InputError
from ..system.machine import load_linear_algebra, settle_machine
from . import control, inspection, outcome, physics, results, rig, whole_run
from .boundary import ErrorBoundary, Program, with_options
from .console import Json, NoReport, Quiet

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

for name, group in (
    ("control", control.app),
    ("fleet", results.fleet_group),
    ("physics", physics.app),
    ("rig", rig.app),
):
    app.add_typer(group, name=name)
for command in (
    inspection.check, inspection.init, inspection.inspect,
    results.diff, results.export, results.verify, results.paper, results.study, results.series,
    whole_run.ingest, whole_run.differentiate, whole_run.identify, whole_run.validate, whole_run.compare,
    whole_run.report, whole_run.show, whole_run.demo, whole_run.status, whole_run.warmup,
):  # fmt: skip
    app.command()(command)
app.command("run")(whole_run.run_command)


def _version(requested: bool) -> None:
    if requested:
        from ..system.package import program_version

        typer.echo(f"debist {program_version()}")
        raise typer.Exit()


@app.callback()
def main(
    version: Annotated[
        bool, typer.Option("--version", callback=_version, is_eager=True, help="Print the version.")
    ] = False,
    as_json: Annotated[bool, typer.Option("--json", hidden=True)] = False,
) -> None:
    """From the raw rig log of a bistable dielectric-elastomer joint to a validated dynamic model."""
    settle_machine()
    load_linear_algebra()
    # A tenth of the time of figures and compilation goes into looking for cycles that are hardly ever there.
    gc.set_threshold(500_000, 20, 20)
    atexit.register(gc.freeze)  # at the end of a run, looking for them once more took 0.8 s


def debist(arguments: list[str]) -> None:
    """Be the command with these arguments, as each process of a batch is."""
    app(arguments)


@dataclass(frozen=True)
class BatchOptions:
    """Selection of the prototypes of a batch, and settings of their runs."""

    base: Annotated[
        Path | None,
        typer.Option("--base", metavar="FILE", help="Settings that the rows of a table share [default: beside it]."),
    ] = None
    siblings: Annotated[
        Path | None, typer.Option("--siblings", metavar="FILE", help="Prior of `debist fleet learn` for all of them.")
    ] = None
    shard: Annotated[
        str | None,
        typer.Option("--shard", metavar="I/N", help="Only part I of N, from 1; which one is decided by the name."),
    ] = None
    jobs: Annotated[int, typer.Option("--jobs", min=1, help="Processes at a time.")] = 1
    fail_fast: Annotated[bool, typer.Option("--fail-fast", help="Start no more after a failure.")] = False
    time_limit: Annotated[
        str, typer.Option("--time-limit", help="Wall time after which a prototype is stopped and has failed.")
    ] = "4 h"
    collect: Annotated[
        bool, typer.Option("--collect", help="Only the fleet tables, from the runs in DIR; joins all shards.")
    ] = False
    listed: Annotated[bool, typer.Option("--list", help="Only name prototypes, settings files and logs.")] = False


@app.command()
@with_options
def batch(
    prototypes: Annotated[
        list[Path],
        typer.Argument(metavar="FLEET...", help="Settings files, folders, or a table (CSV, XLSX)."),
    ],
    output: Annotated[Path, typer.Option("-o", metavar="DIR", help="Folder for the runs and the tables.")],
    options: BatchOptions,
    no_report: NoReport = False,
    as_json: Json = False,
    quiet: Quiet = False,
) -> None:
    """Run many prototypes, one process each; a rerun does only what is missing or stale.

    A table has a row for each prototype: name, logs.train, logs.validation, and settings that differ. Writes
    fleet.html, fleet.parquet and fleet.csv (NRMSE as fractions); a shard leaves them to --collect. While it works,
    `debist status DIR` shows how far it is.

    Example: debist batch prototypes/ -o runs --jobs 2
    """
    from ..units.units import parse_quantity
    from ..workflow.batch import Execution, collect_batch, run_batch
    from ..workflow.members import SETTINGS, Shard, members, prototype_files, with_siblings

    limit = parse_quantity(options.time_limit, ("s",), "--time-limit")
    if not 1.0 <= limit <= 1e7:
        raise InputError(f"--time-limit {options.time_limit}: a prototype may take 1 s to 1e7 s (16 weeks)")
    shard = None if options.shard is None else Shard.parse(options.shard)
    if options.collect and shard is not None:
        raise InputError("--collect joins all shards; give it without --shard")
    files = prototype_files(prototypes, output, options.base)
    if options.siblings is not None and not options.collect:
        files = with_siblings(files, options.siblings, output / SETTINGS)
    named = [member for member in members(files) if shard is None or shard.holds(member.name)]
    if options.listed:
        outcome.emit_members(named, as_json=as_json)
        return
    if options.collect:
        outcomes = collect_batch(named, output)
    else:
        execution = Execution(options.jobs, not no_report, options.fail_fast, limit)
        with outcome.BatchProgress(len(named), quiet=quiet) as progress:
            outcomes = run_batch(named, output, progress, debist, execution, shard)
    outcome.emit_outcomes(outcomes, output, as_json=as_json)
    if failed := [result for result in outcomes if result.failed]:
        raise BatchFailedError(
            f"{len(failed)} of {len(outcomes)} prototypes failed: {', '.join(result.name for result in failed)}; "
            f"{failed[0].reason}"
        )
