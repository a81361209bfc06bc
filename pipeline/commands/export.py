"""`debist export`: the identified model for other tools."""

from pathlib import Path
from typing import Annotated, Literal

import typer

from pipeline.commands.options import Force, Json, run_of

Target = Literal["c", "controller", "crate", "fmu", "json", "matlab"]


def export(
    run: Annotated[Path, typer.Argument(metavar="RUN", help="Run folder.", callback=run_of)],
    target: Annotated[Target, typer.Option("--to", help="Form of the export.")],
    model: Annotated[
        str | None, typer.Option("--model", "-m", help="Model that is exported [default: the headline].")
    ] = None,
    output: Annotated[
        Path | None, typer.Option("-o", "--output", metavar="DIR", help="Folder of the files [default: RUN/exports].")
    ] = None,
    force: Force = False,
    as_json: Json = False,
) -> None:
    """Write the identified model for another tool, or the run with all its inputs as an RO-Crate (`--to crate`).

    Units (SI) and validity range travel along with a model. `--to controller` writes the controller that
    `debist control design` made, as C99, as a MATLAB function and as an FMU.

    Example: debist export runs/P1 --to fmu
    """
    from pipeline.commands.console import emit_json
    from pipeline.tools.export import export_run

    made = export_run(run, target, model=model, output=output, force=force)
    if as_json:
        emit_json(vars(made))
        return
    typer.echo("\n".join(map(str, made.written)))
    for note in made.notes:
        typer.echo(f"note: {note}", err=True)
