"""`debist rig`: raw logs of simulated prototypes, with their truth beside them."""

from pathlib import Path
from typing import Annotated

import typer

app = typer.Typer(
    no_args_is_help=True,
    rich_markup_mode=None,
    help="The virtual rig: raw logs of simulated prototypes, with the truth beside them.",
)

Folder = Annotated[
    Path, typer.Option("-o", "--output", metavar="FOLDER", help="Folder to write into; made if missing.")
]
Seed = Annotated[int, typer.Option(help="Draws everything that is random.", min=0)]
Kind = Annotated[str, typer.Option(help="like, unlike (the analytical model's physics, or others), nominal, table1.")]
Format = Annotated[str, typer.Option("--format", help="mat, mat73, mf4, csv, csv-de, parquet.")]
Rate = Annotated[float, typer.Option(help="Samples per second [Hz], a multiple of 2000.")]
Duration = Annotated[float, typer.Option(help="Length of each log [s].")]
Faults = Annotated[str, typer.Option(help="Any of gaps,dropouts,saturation,nan,repeats; comma-separated.")]
Train = Annotated[int, typer.Option(help="Number of training logs.", min=1, max=99)]
Validation = Annotated[int, typer.Option(help="Number of validation logs.", min=0, max=99)]
Json = Annotated[bool, typer.Option("--json", help="Print one JSON document on stdout and nothing else there.")]


@app.command()
def simulate(
    output: Folder = Path("virtual"),
    seed: Seed = 1,
    kind: Kind = "like",
    form: Format = "mat",
    rate: Rate = 30_000.0,
    duration: Duration = 37.5,
    train: Train = 1,
    validation: Validation = 1,
    programme: Annotated[
        str | None,
        typer.Option(help="pulses, chirps, both, steps, multisine, mixed, training, validation [default: drawn]."),
    ] = None,
    faults: Faults = "",
    as_json: Json = False,
) -> None:
    """Simulate one prototype and write its raw logs, its TOML and the truth.

    Displacements in mm or µm and voltages in kV or V, as the format's rig names them; truth in SI units.
    Example: debist rig simulate -o virtual --format csv-de --rate 2000 --faults gaps,nan
    """
    from pipeline.commands.console import emit_json
    from pipeline.rig.faults import parse_faults
    from pipeline.rig.fleet import Experiment, write_prototype

    experiment = Experiment(kind, form, rate, duration, train, validation, programme, parse_faults(faults))
    prototype = write_prototype(output, f"{kind}-{seed}", experiment, seed=seed)
    if as_json:
        emit_json({"prototype": prototype, "truth": output / "truth" / "truth.json"})
    else:
        typer.echo(f"{prototype}: simulated logs; next: debist run {prototype}")


@app.command()
def fleet(
    count: Annotated[int, typer.Argument(help="Number of prototypes.", min=1, max=10_000)] = 10,
    output: Folder = Path("fleet"),
    seed: Seed = 1,
    kind: Kind = "like",
    form: Format = "parquet",
    rate: Rate = 10_000.0,
    duration: Duration = 37.5,
    faults: Faults = "",
    as_json: Json = False,
) -> None:
    """Simulate many prototypes, one folder each; with `--kind like` every second one has unlike physics.

    Rate in Hz, duration in s. Example: debist rig fleet 24 -o fleet --seed 7
    """
    from pipeline.commands.console import emit_json
    from pipeline.rig.faults import parse_faults
    from pipeline.rig.fleet import Experiment, write_fleet

    experiment = Experiment(kind, form, rate, duration, faults=parse_faults(faults))
    prototypes = []
    for prototype in write_fleet(output, count, experiment, seed=seed):
        prototypes.append(prototype)
        typer.echo(f"{prototype}", err=True)
    if as_json:
        emit_json({"prototypes": prototypes})
    else:
        typer.echo(f"{count} simulated prototypes in {output}; next: debist batch {output} -o runs")
