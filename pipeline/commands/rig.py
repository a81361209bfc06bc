"""`debist rig`: raw logs of simulated prototypes with their truth beside them, and voltage sequences for a real rig."""

from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from pipeline.commands.boundary import group, with_options
from pipeline.commands.console import Force, Json, Quiet, emit_json, emit_text, progress_report, working
from pipeline.errors import InputError
from pipeline.names import shell_word
from pipeline.units import parse_quantity

if TYPE_CHECKING:
    from pipeline.rig.fleet import Experiment
    from pipeline.tools.closed_loop import ClosedLoopOptions
    from pipeline.tools.excitation import ExcitationLimits, ExcitationSource
    from pipeline.tools.excitation_design import Requirements

app = group("The virtual rig: raw logs of simulated prototypes, with the truth beside them; excitation design.")

Folder = Annotated[
    Path, typer.Option("-o", "--output", metavar="FOLDER", help="Folder to write into; made if missing.")
]
Seed = Annotated[int, typer.Option(help="Draws everything that is random.", min=0)]
Format = Annotated[str, typer.Option("--format", help="mat, mf4, csv, csv-de, parquet.")]
Rate = Annotated[float, typer.Option(help="Samples per second [Hz], a multiple of 2000.")]


@dataclass(frozen=True)
class SimulatedLogs:
    """What the logs of a simulated prototype are like."""

    kind: Annotated[
        str,
        typer.Option(help="same, foreign (the analytical physics, or other), worn (yields, softens), nominal, table1."),
    ] = "same"
    form: Format = "mat"
    rate: Rate = 30_000.0
    duration: Annotated[float, typer.Option(help="Length of each log [s].")] = 37.5
    faults: Annotated[str, typer.Option(help="Any of gaps,dropouts,saturation,nan,repeats; comma-separated.")] = ""
    charging: Annotated[
        str,
        typer.Option("--charging-time", help="Time constant of each membrane behind its electrodes, with its unit."),
    ] = "0 s"
    size: Annotated[float, typer.Option(help="Factor on the joint's lengths, which moves alike.")] = 1.0

    def experiment(self, **more: Any) -> "Experiment":
        """The experiment on the virtual rig."""
        from pipeline.rig.fleet import Experiment
        from pipeline.rig.log import parse_faults

        return Experiment(
            self.kind, self.form, self.rate, self.duration, faults=parse_faults(self.faults),
            charging=parse_quantity(self.charging, ("s",), "--charging-time"), size=self.size, **more,
        )  # fmt: skip


@dataclass(frozen=True)
class FleetLogs(SimulatedLogs):
    """What the logs of many simulated prototypes are like: smaller files."""

    form: Format = "parquet"
    rate: Rate = 10_000.0


@dataclass(frozen=True)
class LogRoles:
    """How many logs a prototype has, and which voltages drive it in them."""

    train: Annotated[int, typer.Option(help="Number of training logs.", min=1, max=99)] = 1
    validation: Annotated[int, typer.Option(help="Number of validation logs.", min=0, max=99)] = 1
    excitation: Annotated[
        str | None,
        typer.Option(
            help="pulses, alternating (the paper's), chirps, both, steps, multisine, mixed, training, validation "
            "[default: as the role]."
        ),
    ] = None
    play: Annotated[
        Path | None, typer.Option("--play", metavar="FILE", help="Voltages (CSV or MAT, in V) for the training logs.")
    ] = None


@dataclass(frozen=True)
class Ageing:
    """How old a simulated prototype is, and what changes in it."""

    age: Annotated[
        float | None, typer.Option(help="Days since it was made: the same joint with other logs.", min=0.0)
    ] = None
    drift: Annotated[
        str | None,
        typer.Option(
            metavar="NAME=CHANGE,…",
            help="What changes in a day: capacitance, stiffness (%), charging (s), laser (m), or none "
            "[default: capacitance=-0.1%,stiffness=-0.05%,charging=20us,laser=2um].",
        ),
    ] = None

    def fields(self) -> dict[str, Any]:
        """The same for an experiment."""
        from pipeline.rig.random_joint import USUAL, parse_drift

        if self.age is None:
            if self.drift is not None:
                raise InputError("--drift: changes come with the age; give --age DAYS, too")
            return {}
        return {"age": self.age, "drift": parse_drift(self.drift or USUAL)}


@app.command()
@with_options
def simulate(
    logs: SimulatedLogs,
    roles: LogRoles,
    ageing: Ageing,
    output: Folder = Path("virtual"),
    seed: Seed = 1,
    force: Force = False,
    as_json: Json = False,
    quiet: Quiet = False,
) -> None:
    """Simulate one prototype and write its raw logs, its TOML and the truth.

    Displacements in mm or µm and voltages in kV or V, as the format's rig names them; truth in SI units.
    Example: debist rig simulate -o virtual --format csv-de --rate 2000 --faults gaps,nan
    """
    from pipeline.rig.fleet import simulate_prototype

    experiment = logs.experiment(
        training_logs=roles.train,
        validation_logs=roles.validation,
        excitation=roles.excitation,
        play=None if roles.play is None else str(roles.play),
        **ageing.fields(),
    )
    name = f"{logs.kind}-{seed}" if ageing.age is None else f"{logs.kind}-{seed}-day{ageing.age:g}"
    count = roles.train + roles.validation
    with working(f"simulating {count} logs of {logs.duration:g} s at {logs.rate:g} Hz", quiet=quiet):
        prototype = simulate_prototype(output, name, experiment, seed=seed, force=force)
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
    force: Force = False,
    as_json: Json = False,
    quiet: Quiet = False,
) -> None:
    """Simulate many prototypes, one folder each; with `--kind same` every second one has foreign physics.

    Rate in Hz, duration in s. Example: debist rig fleet 24 -o fleet --seed 7
    """
    from pipeline.rig.fleet import simulate_fleet

    prototypes = []
    for prototype in simulate_fleet(output, count, logs.experiment(), seed=seed, force=force):
        prototypes.append(prototype)
        if not quiet:
            typer.echo(f"{prototype}", err=True)
    if as_json:
        emit_json({"prototypes": prototypes})
    else:
        typer.echo(f"{count} simulated prototypes in {output}; next: debist batch {shell_word(output)} -o runs")


@dataclass(frozen=True)
class SimulatedWith:
    """What the motions under a designed sequence are simulated with."""

    parameters: Annotated[
        str, typer.Option("--parameters", "-p", metavar="SET", help="table1, nominal, or a TOML file with units.")
    ] = "nominal"
    run: Annotated[
        Path | None, typer.Option("--run", metavar="RUN", help="Design the log after those of this run.")
    ] = None
    programme: Annotated[
        str | None,
        typer.Option(
            metavar="KIND|FILE",
            help="Free runs of --run that shall become more certain: an excitation or voltages [default: validation].",
        ),
    ] = None
    model: Annotated[str | None, typer.Option(help="Which model of the run [default: the headline].")] = None
    joints: Annotated[
        int, typer.Option(help="Joints with workshop tolerances to design for at once.", min=1, max=20)
    ] = 4
    seed: Seed = 1

    def source(self) -> "ExcitationSource":
        """The same for the design."""
        from pipeline.tools.excitation import ExcitationSource

        return ExcitationSource(**vars(self))


@dataclass(frozen=True)
class SequenceLimits:
    """What a designed sequence must not exceed."""

    max_voltage: Annotated[str, typer.Option(help="Largest voltage of a converter, with its unit.")] = "3 kV"
    max_field: Annotated[
        str | None,
        typer.Option(help="Largest field in the undeformed film, with its unit [default: the run's, or 60 V/um]."),
    ] = None

    def limits(self) -> "ExcitationLimits":
        """The same in SI units."""
        from pipeline.tools.excitation import ExcitationLimits

        field = None if self.max_field is None else parse_quantity(self.max_field, ("V/m",), "--max-field")
        return ExcitationLimits(parse_quantity(self.max_voltage, ("V",), "--max-voltage"), field)


@dataclass(frozen=True)
class SequenceForm:
    """What a designed sequence is made of."""

    duration: Annotated[str, typer.Option(help="Length with its unit.")] = "37.5 s"
    rest: Annotated[str, typer.Option(help="Rest before the first burst, with its unit.")] = "1 s"
    rate: Annotated[str, typer.Option(help="Rate of the written samples, with its unit.")] = "1 kHz"
    kinds: Annotated[
        str, typer.Option(help="Bursts to use: any of pulse,both,chirp,steps,multisine; comma-separated.")
    ] = "pulse,both,chirp,steps,multisine"
    basis_functions: Annotated[int, typer.Option(help="Basis functions of each curve.", min=2, max=50)] = 10
    candidates: Annotated[int, typer.Option(help="Bursts tried for each place.", min=1, max=1000)] = 24

    def requirements(self) -> "Requirements":
        """The same in SI units."""
        from pipeline.rig.log import listed
        from pipeline.tools.excitation_design import Requirements

        return Requirements(
            duration=parse_quantity(self.duration, ("s",), "--duration"),
            rest=parse_quantity(self.rest, ("s",), "--rest"),
            kinds=listed(self.kinds),
            candidates=self.candidates,
            basis_functions=self.basis_functions,
        )


@app.command()
@with_options
def excite(
    joint: SimulatedWith,
    limits: SequenceLimits,
    form: SequenceForm,
    output: Annotated[
        Path, typer.Option("--file", "-o", "--output", metavar="FILE", help="Sequence to write: .csv or .mat.")
    ] = Path("excitation.csv"),
    force: Force = False,
    as_json: Json = False,
    quiet: Quiet = False,
) -> None:
    """Design a voltage sequence that visits every basis centre in both wells and determines the curves best.

    With `--run` and its model `hybrid`, the one after which its free run in a programme is expected to be surest.

    Voltages in V, times in s in the file; its description (JSON, SI units) is written beside it.
    Example: debist rig excite --file excitation.csv --duration 60s --max-voltage 2.8kV
    """
    from pipeline.commands.inspection import emit_design
    from pipeline.tools.excitation import description, excite

    requirements, rate = form.requirements(), parse_quantity(form.rate, ("Hz",), "--rate")
    with progress_report("designing", quiet=quiet) as report:
        design, files = excite(
            output, joint.source(), requirements, limits.limits(), rate,
            report=None if report is None else partial(report, "designing"), force=force,
        )  # fmt: skip
    if as_json:
        emit_json({"files": files, **description(design)})
    else:
        emit_design(design, files)


@dataclass(frozen=True)
class LoopScenario:
    """What happens in a closed loop."""

    target: Annotated[
        str, typer.Option(help="Reference: VALUE or TIME:VALUE,… with units or left, right, saddle; or a file.")
    ] = "0s:left,0.5s:right,2.5s:left"
    start: Annotated[
        str | None, typer.Option("--from", help="Well it rests in: left, right [default: nearest the first target].")
    ] = None
    duration: Annotated[str, typer.Option(help="Length with its unit.")] = "5 s"
    form: Format = "mat"
    lag: Annotated[str | None, typer.Option(help="Time constant of the converters [default: the joint's].")] = None
    highest: Annotated[str, typer.Option(help="Largest voltage of the converters.")] = "3 kV"
    push: Annotated[str, typer.Option(help="Forces on the tip: START:FORCE:LENGTH,… e.g. 2s:50mN:20ms.")] = ""
    hand: Annotated[str, typer.Option(help="A hand pushes and lets go: START:FORCE:LENGTH,… e.g. 2s:10mN:1s.")] = ""
    shake: Annotated[
        str, typer.Option(help="The table shakes: START:FORCE:FREQUENCY:LENGTH,… e.g. 2s:5mN:10Hz:1s.")
    ] = ""
    drag: Annotated[str, typer.Option(help="Force of a wire that is dragged along, with its unit.")] = "0 N"
    friction: Annotated[float, typer.Option(help="Factor on the joint's own friction.", min=0.0)] = 1.0
    lost: Annotated[str, typer.Option(help="The laser gives no value: START:LENGTH,… e.g. 3s:0.2s.")] = ""
    frozen: Annotated[str, typer.Option(help="The laser gives its last value: START:LENGTH,…")] = ""
    barrier: Annotated[float, typer.Option(help="Change of the energy barrier to the end, in percent.")] = 0.0
    noise: Annotated[float, typer.Option(help="Factor on the laser's noise.", min=0.0)] = 1.0
    seed: Annotated[int, typer.Option(help="Draws the noise.", min=0)] = 1

    def options(self) -> "ClosedLoopOptions":
        """The same for the virtual rig."""
        from pipeline.tools.closed_loop import ClosedLoopOptions

        return ClosedLoopOptions(**vars(self))


@app.command("closed-loop")
@with_options
def closed_loop(
    joint: Annotated[
        str,
        typer.Argument(
            metavar="JOINT", help="Folder of `debist rig`, or nominal, table1, same:SEED, foreign:SEED, worn:SEED."
        ),
    ],
    scenario: LoopScenario,
    controller: Annotated[
        Path | None,
        typer.Option("--controller", "-c", metavar="RUN", help="Run whose controller (`debist control design`) acts."),
    ] = None,
    play: Annotated[
        Path | None, typer.Option("--play", metavar="FILE", help="Play voltages instead (CSV or MAT, in V).")
    ] = None,
    output: Annotated[
        Path,
        typer.Option(
            "--file", "-o", "--output", metavar="FILE", help="Raw log to write; its ending follows the format."
        ),
    ] = Path("closed-loop"),
    force: Force = False,
    as_json: Json = False,
    quiet: Quiet = False,
) -> None:
    """Run the controller of a run against a simulated joint at 1 kHz; write a raw log with the reference in it.

    Voltages 0 to 3 kV, displacements in m or mm. The controller is the one of `debist export RUN --to controller`.

    Example: debist rig closed-loop virtual --controller runs/P1 --target 0s:left,0.5s:right --push 2s:50mN:20ms
    """
    from pipeline.tools.closed_loop import closed_loop_log

    with working(f"simulating {scenario.duration} at 1 kHz", quiet=quiet):
        files, summary = closed_loop_log(joint, controller, play, output, scenario.options(), force=force)
    if as_json:
        emit_json({"files": files, **summary})
        return
    for what, count in (("were no numbers", "not_finite"), ("lay beyond the converters' range", "clipped")):
        if summary[f"commands_{count}"]:
            typer.echo(f"warning: {summary[f'commands_{count}']} commands of the controller {what}", err=True)
    for step in summary["steps"]:
        ended = "did not settle" if step["settling_s"] is None else f"settled in {1e3 * step['settling_s']:.0f} ms"
        beyond = "" if step["settling_s"] is None else f", overshoot {1e3 * step['overshoot_m']:.2f} mm"
        at = f"{step['t_s']:.2f} s: target {1e3 * step['target_m']:+.2f} mm"
        emit_text(f"{at}, {ended}{beyond}, then RMS {1e3 * step['rms_m']:.3f} mm")
    if "rms_m" in summary:
        emit_text(f"moving reference: RMS error {1e3 * summary['rms_m']:.3f} mm")
    typer.echo("\n".join(map(str, files)))
