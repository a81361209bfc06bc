"""`debist control`: from the identified joint to linear models, snaps, a switching map and a controller."""

from dataclasses import dataclass, replace
from pathlib import Path
from typing import Annotated, Any

import typer

from ..errors import InputError
from ..system.names import Goal, Well, shell_word
from ..units.quantity import prefixed
from ..units.units import parse_quantity
from .boundary import group, with_options
from .console import Force, Json, Progress, Quiet, emit_json, emit_table, emit_text, run_of

app = group("From the identified model to control: linear models, snaps, switching map, controller.")


@dataclass(frozen=True)
class Snap:
    """Start and target of a pulse, and the quantity that it minimises."""

    to: Annotated[Well, typer.Option(help="Well to bring the joint to.")]
    start: Annotated[Well | None, typer.Option("--from", help="Well it rests in [default: the other one].")] = None
    minimise: Annotated[Goal, typer.Option(help="Quantity that the pulse minimises.")] = "time"


Run = Annotated[
    Path, typer.Argument(metavar="RUN", help="Run folder with an identified joint of two membranes.", callback=run_of)
]
Lag = Annotated[
    str | None,
    typer.Option(help="Time constant of both converters, with its unit [default: from voltage steps of the logs]."),
]
Most = Annotated[
    str | None, typer.Option("--max-voltage", help="Largest voltage, with its unit [default: as trained and allowed].")
]


@app.command()
def linearise(
    run: Run,
    v1: Annotated[str, typer.Option(help="Constant voltage of the left membrane, with its unit.")] = "0 V",
    v2: Annotated[str, typer.Option(help="Constant voltage of the right membrane, with its unit.")] = "0 V",
    output: Annotated[
        Path | None, typer.Option("-o", metavar="DIR", help="Folder of the files [default: RUN/exports].")
    ] = None,
    force: Force = False,
    quiet: Quiet = False,
    as_json: Json = False,
) -> None:
    """Equilibria (both wells, the unstable one) and the linear models A, B, C, D about them.

    States in SI; writes linear.json and linear.mat. Measured ring-downs stand beside the poles.
    Example: debist control linearise runs/P1 --v1 1kV
    """
    from ..workflow.studies import control

    voltages = (parse_quantity(v1, ("V",), "--v1"), parse_quantity(v2, ("V",), "--v2"))
    with Progress(quiet=quiet) as progress:
        linear = control.linearise(run, voltages, progress)
    files = control.write_linear(run, linear, output, force=force)
    if as_json:
        emit_json({"files": files, **linear})
        return
    rows = []
    for point in linear["equilibria"]:
        side = "left" if point is linear["equilibria"][0] else "right"
        rests = point["stable"] and not any(voltages)  # ring-downs were measured without voltage
        measured = linear["measured"][side] if rests else {"frequency_Hz": None, "damping_ratio": None}
        poles = point["poles_1_s"]
        # The unstable pole, and the slowest pair that rings.
        telling = [*(pole for pole in poles if pole[0] > 0.0), *[pole for pole in poles if pole[1] > 1.0][:1]]
        rows.append(
            (
                prefixed(point["q_m"], "m", 3),
                "stable" if point["stable"] else "unstable",
                prefixed(point["frequency_Hz"], "", 2),
                prefixed(measured["frequency_Hz"], "", 2),
                prefixed(point["damping_ratio"], "", 3),
                prefixed(measured["damping_ratio"], "", 3),
                ", ".join(f"{re:.2f}" if abs(im) < 1e-9 else f"{re:.2f} ± {im:.2f}i" for re, im in telling),
            )
        )
    emit_table(
        f"{run}: equilibria at {v1}, {v2}",
        ("q [mm]", "", "f [Hz]", "measured", "damping", "measured", "poles [1/s]"),
        rows,
        numeric_from=2,
    )
    typer.echo("\n".join(map(str, files)))


@app.command("map")
def switching_map(run: Run, lag: Lag = None, quiet: Quiet = False, as_json: Json = False) -> None:
    """P(switch | voltage, duration) of plain pulses from rest, both ways: the share of draws of the model that switch.

    With the lowest voltage that switches, and its band. In kV and s; in the report as a figure. Example: debist control
    map runs/P1
    """
    from ..workflow.studies import control

    with Progress(quiet=quiet) as progress:
        document = control.switching_maps(run, _settings(None, lag), progress)
    if as_json:
        emit_json(document)
        return
    for drawn in document["maps"]:
        durations = drawn["durations"]
        columns = range(0, len(durations), 8)
        emit_table(
            f"{run}: probability of switching to the {drawn['to']}",
            ("kV", *(f"{durations[j]:.3f} s" for j in columns)),
            [
                (prefixed(drawn["voltages"][i], "k", 2), *(f"{drawn['probability'][i][j]:.2f}" for j in columns))
                for i in range(0, len(drawn["voltages"]), 4)
            ],
        )
        for pulse in drawn["lowest"]:
            volts, low, high = (1e-3 * pulse[name] for name in ("voltage", "low", "high"))
            band = f"{low:.3f} to {high:.3f} kV with 90 %"
            top = pulse["until"]
            reach = "on" if top is None else f"to below {prefixed(top, 'k', 2)} kV, where the joint swings back"
            typer.echo(f"pulses of {pulse['duration']:g} s switch from {volts:.3f} kV ({band}) {reach}")


@app.command()
@with_options
def pulse(
    run: Run,
    snap: Snap,
    output: Annotated[
        Path | None,
        typer.Option("-o", metavar="FILE", help="CSV and MAT [default: RUN/exports/pulse-to-….csv]."),
    ] = None,
    max_voltage: Most = None,
    lag: Lag = None,
    force: Force = False,
    quiet: Quiet = False,
    as_json: Json = False,
) -> None:
    """A feedforward snap from well to well: push, brake, catch, optimised on the model and robust over its posterior.

    Voltages in V at 1 kHz, for `debist rig closed-loop --play` and test benches.
    Example: debist control pulse runs/P1 --to right -o snap.csv
    """
    from ..store import layout
    from ..workflow.studies import control

    if output is not None:
        control.check_pulse_name(output)
    with Progress(quiet=quiet) as progress:
        design = control.pulse(run, snap.to, snap.start, snap.minimise, _settings(max_voltage, lag), progress)
    files = control.write_pulse(run, design, output or run / layout.EXPORTS / f"pulse-to-{snap.to}.csv", force=force)
    if as_json:
        emit_json({"files": files, **design})
    else:
        low, high = design["settling_90_s"]
        emit_text(
            f"to the {snap.to}: {_settles(design['settling_s'])} (90 % of the draws: {_ms(low)} to {_ms(high)}), "
            f"overshoot {prefixed(design['overshoot_m'], 'm', 2)} mm, switches with probability "
            f"{design['switching_probability']:.2f}, peak {prefixed(design['largest_voltage_V'], 'k', 2)} kV"
        )
        typer.echo("\n".join(map(str, files)))


@app.command()
def design(
    run: Run,
    max_voltage: Most = None,
    slew: Annotated[
        str | None, typer.Option(help="Largest rate of each voltage, such as 100kV/s [default: no limit].")
    ] = None,
    average_voltage: Annotated[
        str | None, typer.Option(help="Largest mean of each voltage over 10 s, with its unit [default: no limit].")
    ] = None,
    lag: Lag = None,
    quiet: Quiet = False,
    as_json: Json = False,
) -> None:
    """Design the controller: estimator and feedback that snaps, settles, holds and tracks; kept in the run.

    `debist export RUN --to controller` writes it as C99. With a --max-voltage (V) below the switching voltage it pumps.
    Example: debist control design runs/P1 --max-voltage 2kV
    """
    from ..workflow.studies import control

    with Progress(quiet=quiet) as progress:
        document = control.design(
            run,
            replace(
                _settings(max_voltage, lag),
                slew=_limit(slew, "V/s", "--slew"),
                average=_limit(average_voltage, "V", "--average-voltage"),
            ),
            progress,
        )
    if as_json:
        emit_json(document)
        return
    places = document["places_m"]
    predicted = document["predicted"]["steps"]
    left, saddle, right = (prefixed(places[name], "m", 2) for name in ("left", "saddle", "right"))
    lags = " and ".join(prefixed(lag, "m", 1) for lag in document["lags_s"])
    emit_text(
        "\n".join(
            (
                f"model {document['model']}: wells at {left} and {right} mm, unstable equilibrium at {saddle} mm; at "
                f"most {prefixed(document['largest_voltage_V'], 'k', 2)} kV",
                f"the converters' lags: {lags} ms, {document['lags_known']}",
                *(
                    f"on the model, {target}: {_settles(step['settling_s'])}, overshoot "
                    f"{prefixed(step['overshoot_m'], 'm', 2)} mm, RMS {prefixed(step['rms_m'], 'm', 3)} mm then"
                    for target, step in zip(
                        ("to the right", "to the left", "to the unstable equilibrium"), predicted, strict=True
                    )
                ),
                _margins(document["margins"]),
                *(f"warning: {warning}" for warning in document["warnings"]),
                f"next: debist export {shell_word(run)} --to controller",
            )
        )
    )


def _margins(margins: Any) -> str:
    """Stability margins of the loop at the unstable equilibrium, in a line."""
    if margins is None:
        return "margins: none, the unstable equilibrium is not held on the linear model"
    return (
        f"margins at the unstable equilibrium: {margins['gain_low']:.2f} to {margins['gain_high']:.1f} times the gain, "
        f"{prefixed(margins['delay_s'], 'm', 1)} ms more delay, 0 to {margins['friction_high']:.0f} times the friction"
    )


def _limit(text: str | None, unit: str, name: str) -> float | None:
    """A limit of a controller in SI."""
    number = None if text is None else parse_quantity(text, (unit,), name)
    if number is not None and not 0.0 < number < float("inf"):
        raise InputError(f"{name} {text}: give a value above 0")
    return number


def _settings(max_voltage: str | None, lag: str | None) -> Any:
    from ..workflow.studies.controlled_run import ControlSettings

    most = None if max_voltage is None else parse_quantity(max_voltage, ("V",), "--max-voltage")
    seconds = None if lag is None else parse_quantity(lag, ("s",), "--lag")
    if seconds is not None and not 0.0 <= seconds <= 20e-3:
        raise InputError(f"--lag {lag}: a converter's time constant is 0 to 20 ms")
    return ControlSettings(most, seconds)


def _settles(seconds: float | None) -> str:
    return "does not settle" if seconds is None else f"settles in {_ms(seconds)}"


def _ms(seconds: float | None) -> str:
    return "not at all" if seconds is None else f"{prefixed(seconds, 'm', 0)} ms"
