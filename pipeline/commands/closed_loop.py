"""`debist rig closed-loop`: a controller on a virtual joint."""

from pathlib import Path
from typing import Annotated

import typer


def closed_loop(
    joint: Annotated[
        str,
        typer.Argument(metavar="JOINT", help="Folder of `debist rig`, or nominal, table1, same:SEED, foreign:SEED."),
    ],
    controller: Annotated[
        str | None,
        typer.Option("--controller", "-c", metavar="CONTROLLER", help="FILE.c, MODULE:NAME or FILE.py:NAME."),
    ] = None,
    play: Annotated[
        Path | None, typer.Option("--play", metavar="FILE", help="Play voltages instead (CSV or MAT, in V).")
    ] = None,
    target: Annotated[
        str,
        typer.Option(help="Reference: VALUE or TIME:VALUE,… with units or left, right, saddle; or a file."),
    ] = "0s:left,0.5s:right,2.5s:left",
    start: Annotated[
        str | None, typer.Option("--from", help="Well it rests in: left, right [default: nearest the first target].")
    ] = None,
    duration: Annotated[str, typer.Option(help="Length with its unit.")] = "5 s",
    output: Annotated[
        Path, typer.Option("-o", "--output", metavar="FILE", help="Raw log to write; its ending follows the format.")
    ] = Path("closed-loop"),
    form: Annotated[str, typer.Option("--format", help="mat, mat73, mf4, csv, csv-de, parquet.")] = "mat",
    lag: Annotated[str | None, typer.Option(help="Time constant of the converters [default: the joint's].")] = None,
    highest: Annotated[str, typer.Option(help="Largest voltage of the converters.")] = "3 kV",
    push: Annotated[str, typer.Option(help="Forces on the tip: START:FORCE:LENGTH,… e.g. 2s:50mN:20ms.")] = "",
    lost: Annotated[str, typer.Option(help="The laser gives no value: START:LENGTH,… e.g. 3s:0.2s.")] = "",
    barrier: Annotated[float, typer.Option(help="Change of the energy barrier to the end, in percent.")] = 0.0,
    noise: Annotated[float, typer.Option(help="Factor on the laser's noise.", min=0.0)] = 1.0,
    seed: Annotated[int, typer.Option(help="Draws the noise.", min=0)] = 1,
    as_json: Annotated[bool, typer.Option("--json", help="Print one JSON document on stdout.")] = False,
) -> None:
    """Run a controller against a simulated joint at 1 kHz and write a raw log with the reference in it.

    Voltages 0 to 3 kV, displacements in m or mm. The C interface is that of `debist export RUN --to controller`.

    Example: debist rig closed-loop virtual --controller controller.c --target 0s:left,0.5s:right --push 2s:50mN:20ms
    """
    from pipeline.commands.console import emit_json, emit_text
    from pipeline.tools.closed_loop import ClosedLoopOptions, closed_loop_log

    options = ClosedLoopOptions(target, duration, form, lag, highest, push, lost, barrier, noise, seed, start)
    files, summary = closed_loop_log(joint, controller, play, output, options)
    if as_json:
        emit_json({"files": files, **summary})
        return
    for step in summary["steps"]:
        ended = "did not settle" if step["settling_s"] is None else f"settled in {1e3 * step['settling_s']:.0f} ms"
        emit_text(
            f"{step['t_s']:.2f} s: target {1e3 * step['target_m']:+.2f} mm, {ended}, overshoot "
            f"{1e3 * step['overshoot_m']:.2f} mm, then RMS {1e3 * step['rms_m']:.3f} mm"
        )
    typer.echo("\n".join(map(str, files)))
