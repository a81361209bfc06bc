"""`debist rig`: raw logs of simulated prototypes with their truth beside them, and voltage sequences for a real rig."""

from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from ..system.names import shell_word
from ..units.quantity import prefixed
from ..units.units import parse_quantity
from .boundary import group, with_options
from .console import Json, Parameters, Quiet, StatusLine, emit_json, emit_text

if TYPE_CHECKING:
    from ..rig.fleet import Experiment

app = group("The virtual rig: raw logs of simulated prototypes, with the truth beside them; excitation design.")

Folder = Annotated[Path, typer.Option("-o", metavar="FOLDER", help="Folder to write into; made if missing.")]
Seed = Annotated[int, typer.Option(help="Draws everything that is random.", min=0)]
Format = Annotated[str, typer.Option("--format", help="mat, mf4, csv, csv-de, parquet.")]
Rate = Annotated[float, typer.Option(help="Samples per second [Hz], a multiple of 2000.")]


@dataclass(frozen=True)
class SimulatedLogs:
    """Options for the logs of a simulated prototype."""

    kind: Annotated[
        str,
        typer.Option(help="same, foreign (the analytical physics, or other), worn (yields, softens), nominal, table1."),
    ] = "same"
    form: Format = "mat"
    rate: Rate = 30_000.0
    duration: Annotated[float, typer.Option(help="Length of each log [s].")] = 37.5
    file: Annotated[
        Path | None,
        typer.Option("--experiment", metavar="FILE", help="TOML file with faults, number of logs, excitation, age."),
    ] = None

    def experiment(self) -> "Experiment":
        """The experiment on the virtual rig."""
        from ..rig.fleet import Experiment, ExperimentFile
        from ..settings.file import read_options

        rare = dict(read_options(self.file, ExperimentFile))
        if self.file is not None and rare["play"] is not None:
            rare["play"] = str(self.file.parent / rare["play"])
        return Experiment(kind=self.kind, format=self.form, rate=self.rate, duration=self.duration, **rare)


@dataclass(frozen=True)
class FleetLogs(SimulatedLogs):
    """Options for the logs of many simulated prototypes: smaller files."""

    form: Format = "parquet"
    rate: Rate = 10_000.0


@app.command()
@with_options
def simulate(
    logs: SimulatedLogs,
    output: Folder = Path("virtual"),
    seed: Seed = 1,
    as_json: Json = False,
    quiet: Quiet = False,
) -> None:
    """Simulate one prototype and write its raw logs, its TOML and the truth.

    Displacements in mm or µm and voltages in kV or V, as the format's rig names them; truth in SI units.
    Example: debist rig simulate -o virtual --format csv-de --rate 2000 --seed 7
    """
    from ..rig.fleet import simulate_prototype

    experiment = logs.experiment()
    day = "" if experiment.age_days is None else f"-day{experiment.age_days:g}"
    name = f"{logs.kind}-{seed}{day}"
    count = experiment.training_logs + experiment.validation_logs
    with StatusLine(f"simulating {count} logs of {logs.duration:g} s at {logs.rate:g} Hz", quiet=quiet):
        prototype = simulate_prototype(output, name, experiment, seed=seed)
    if as_json:
        emit_json({"prototype": prototype, "truth": output / "truth" / "truth.json"})
    else:
        typer.echo(f"{prototype}: simulated logs; next: debist run {shell_word(prototype)}")


@app.command()
@with_options
def fleet(
    logs: FleetLogs,
    count: Annotated[int, typer.Argument(help="Number of prototypes.", min=1, max=10_000)] = 10,
    output: Folder = Path("fleet"),
    seed: Seed = 1,
    as_json: Json = False,
    quiet: Quiet = False,
) -> None:
    """Simulate many prototypes, one folder each; with `--kind same` every second one has foreign physics.

    Rate in Hz, duration in s. Example: debist rig fleet 24 -o fleet --seed 7
    """
    from ..rig.fleet import simulate_fleet

    prototypes = []
    for prototype in simulate_fleet(output, count, logs.experiment(), seed=seed):
        prototypes.append(prototype)
        if not quiet:
            typer.echo(f"{prototype}", err=True)
    if as_json:
        emit_json({"prototypes": prototypes})
    else:
        typer.echo(f"{count} simulated prototypes in {output}; next: debist batch {shell_word(output)} -o runs")


@app.command()
def excite(
    max_voltage: Annotated[str, typer.Option(help="Largest voltage of a converter, with its unit.")] = "3 kV",
    duration: Annotated[str, typer.Option(help="Length with its unit.")] = "37.5 s",
    file: Annotated[
        Path | None,
        typer.Option("--design", metavar="FILE", help="TOML file with kinds of bursts, rate, rest, field, joints."),
    ] = None,
    parameters: Parameters = "nominal",
    output: Annotated[Path, typer.Option("-o", metavar="FILE", help="Sequence to write: .csv or .mat.")] = Path(
        "excitation.csv"
    ),
    as_json: Json = False,
    quiet: Quiet = False,
) -> None:
    """Design a voltage sequence that visits every basis centre in both wells and determines the curves best.

    Voltages in V, times in s in the file; its description (JSON, SI units) is written beside it.
    Example: debist rig excite -o excitation.csv --duration 60s --max-voltage 2.8kV
    """
    from ..settings.file import read_options
    from ..workflow.studies import excitation
    from .inspection import emit_design

    rare = read_options(file, excitation.DesignFile)
    with StatusLine("designing", quiet=quiet) as line:
        design, files = excitation.excite(
            output,
            parameters,
            rare,
            duration=parse_quantity(duration, ("s",), "--duration"),
            voltage=parse_quantity(max_voltage, ("V",), "--max-voltage"),
            report=partial(line.show, "designing"),
        )
    if as_json:
        emit_json({"files": files, **excitation.description(design)})
    else:
        emit_design(design, files)


@dataclass(frozen=True)
class LoopOptions:
    """Reference, disturbances and instruments of a closed loop."""

    target: Annotated[
        str, typer.Option(help="Reference: VALUE or TIME:VALUE,… with units or left, right, saddle; or a file.")
    ] = "0s:left,0.5s:right,2.5s:left"
    duration: Annotated[str, typer.Option(help="Length with its unit.")] = "5 s"
    controller: Annotated[
        Path | None,
        typer.Option("--controller", metavar="RUN", help="Run whose controller (`debist control design`) acts."),
    ] = None
    play: Annotated[
        Path | None, typer.Option("--play", metavar="FILE", help="Play voltages instead (CSV or MAT, in V).")
    ] = None
    scenario: Annotated[
        Path | None,
        typer.Option("--scenario", metavar="FILE", help="TOML file with pushes, drag, lost readings, noise, format."),
    ] = None


@app.command("closed-loop")
@with_options
def closed_loop(
    joint: Annotated[
        str,
        typer.Argument(
            metavar="JOINT", help="Folder of `debist rig`, or nominal, table1, same:SEED, foreign:SEED, worn:SEED."
        ),
    ],
    loop: LoopOptions,
    output: Annotated[
        Path, typer.Option("-o", metavar="FILE", help="Raw log to write; its ending follows the format.")
    ] = Path("closed-loop"),
    as_json: Json = False,
    quiet: Quiet = False,
) -> None:
    """Run the controller of a run against a simulated joint at 1 kHz; write a raw log with the reference in it.

    Voltages 0 to 3 kV, displacements in m or mm. The controller is the one of `debist export RUN --to controller`.

    Example: debist rig closed-loop virtual --controller runs/P1 --target 0s:left,0.5s:right --scenario pushed.toml
    """
    from ..settings.file import read_options
    from ..workflow.studies.closed_loop import ScenarioFile, closed_loop_log

    seconds = parse_quantity(loop.duration, ("s",), "--duration")
    rare = read_options(loop.scenario, ScenarioFile)
    with StatusLine(f"simulating {loop.duration} at 1 kHz", quiet=quiet):
        files, summary = closed_loop_log(
            joint, loop.controller, loop.play, output, target=loop.target, duration=seconds, options=rare
        )
    if as_json:
        emit_json({"files": files, **summary})
    else:
        _emit_loop(files, summary)


def _emit_loop(files: list[Path], summary: dict[str, Any]) -> None:
    """Print how each step of the target was followed, and the files."""
    for what, count in (("were no numbers", "not_finite"), ("lay beyond the converters' range", "clipped")):
        if summary[f"commands_{count}"]:
            typer.echo(f"warning: {summary[f'commands_{count}']} commands of the controller {what}", err=True)
    for step in summary["steps"]:
        ended = (
            "did not settle" if step["settling_s"] is None else f"settled in {prefixed(step['settling_s'], 'm', 0)} ms"
        )
        beyond = "" if step["settling_s"] is None else f", overshoot {prefixed(step['overshoot_m'], 'm', 2)} mm"
        at = f"{step['t_s']:.2f} s: target {1e3 * step['target_m']:+.2f} mm"
        emit_text(f"{at}, {ended}{beyond}, then RMS {prefixed(step['rms_m'], 'm', 3)} mm")
    if "rms_m" in summary:
        emit_text(f"moving reference: RMS error {prefixed(summary['rms_m'], 'm', 3)} mm")
    typer.echo("\n".join(map(str, files)))
