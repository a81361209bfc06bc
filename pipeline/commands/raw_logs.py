"""Raw logs before there is a run: a first settings file, and what a log holds."""

from pathlib import Path
from typing import Annotated

import typer

from pipeline.commands.console import Json, emit_json
from pipeline.commands.inspection import emit_inspection, inspection_document

LogArgument = Annotated[Path, typer.Argument(metavar="LOG", help="Raw log: MAT, MDF4, CSV, Parquet or HDF5.")]


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
