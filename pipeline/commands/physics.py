"""`debist physics`: the analytical model as a design tool."""

from dataclasses import dataclass
from math import degrees
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from ..errors import InputError
from ..units.quantity import prefixed
from ..units.units import parse_quantity
from .boundary import group, with_options
from .console import Parameters, Quiet, StatusLine, emit_json, emit_table

if TYPE_CHECKING:
    from collections.abc import Callable

    from ..device.parameters import JointParameters
    from ..models.analytical.reduced_order import Motions

app = group("The analytical model (§ 3): equilibria, characteristic curves, motions, modes, reduction, calibration.")

Json = Annotated[bool, typer.Option("--json", help="Print one JSON document (SI units) on stdout, nothing else there.")]


def _free_place(place: Path | None) -> Path | None:
    """The file of a figure, unless one of others lies there."""
    if place is not None:
        from ..reporting.plotted import form_of
        from ..store.outputs import check_places

        form_of(place)
        check_places(place.parent, (place.name,), _FIGURE, force=None)
    return place


_FIGURE = "physics --figure"
Figure = Annotated[
    Path | None,
    typer.Option("--figure", metavar="FILE", callback=_free_place, help="Write a figure: .svg, .pdf or .png."),
]
Voltage = Annotated[str, typer.Option("--voltage", help="Driving voltage with its unit.")]


@dataclass(frozen=True)
class JointSet:
    """The parameters of a joint."""

    parameters: Parameters = "nominal"
    overrides: Annotated[
        list[str] | None,
        typer.Option("--set", metavar="NAME=VALUE", help="Replace a parameter, e.g. 'E=1.8 GPa', 'left.b=23.2 mm'."),
    ] = None

    def joint(self) -> "JointParameters":
        """The parameters in SI units."""
        from ..device.parameters import joint_parameters

        return joint_parameters(self.parameters, overrides=self.overrides or ())


def _draw(place: Path | None, name: str, *drawn: Any) -> None:
    """Draw a figure of `paper_figures` into a file, if one is wanted."""
    if place is not None:
        from ..reporting import paper_figures
        from ..reporting.plotted import form_of, paper_figure
        from ..store.outputs import new_outputs

        figure = getattr(paper_figures, name)(*drawn)
        with new_outputs(place.parent, _FIGURE, force=None) as staged:
            (staged / place.name).write_bytes(paper_figure(figure, paper_figures.COLOURED, form_of(place))[0])


@app.command()
@with_options
def equilibria(
    parameters: JointSet,
    b: Annotated[str | None, typer.Option("--b", help="Height of the mounts with its unit [default: of SET].")] = None,
    v1: Annotated[str, typer.Option("--v1", help="Left voltage with its unit.")] = "0 V",
    v2: Annotated[str, typer.Option("--v2", help="Right voltage with its unit.")] = "0 V",
    force: Annotated[str, typer.Option("--force", help="External force along q with its unit.")] = "0 N",
    figure: Figure = None,
    as_json: Json = False,
) -> None:
    """All equilibria with their stability: q in mm, tip rotation in deg, energy in µJ above the lowest.

    Example: debist physics equilibria --b 23mm --v1 3kV
    """
    import numpy as np

    from ..device.parameters import B_MAX
    from ..models.analytical import bifurcation, statics
    from ..workflow.studies import physics

    joint = parameters.joint()
    if b is not None:
        joint = bifurcation.with_screw_height(joint, B_MAX - parse_quantity(b, ("m",), "--b"))
    left = parse_quantity(v1, ("V",), "--v1")
    right = parse_quantity(v2, ("V",), "--v2")
    pull = parse_quantity(force, ("N",), "--force")
    held = statics.equilibria(joint, np.array([left, right]), pull)
    if figure is not None:
        _draw(figure, "equilibria_figure", joint, held, physics.energy_over_q(joint, v1=left, v2=right, force=pull))
    if as_json:
        emit_json(
            {"equilibria": [{"q_m": e.q, "phi_rad": e.phi, "stable": e.stable, "energy_J": e.energy} for e in held]}
        )
        return
    lowest = min((e.energy for e in held), default=0.0)
    emit_table(
        "Equilibria",
        ("q [mm]", "φ [deg]", "energy [µJ]", "stable"),
        [
            (
                prefixed(e.q, "m", 3),
                f"{degrees(e.phi):z.2f}",
                prefixed(e.energy - lowest, "µ", 1),
                "yes" if e.stable else "no",
            )
            for e in held
        ],
        numeric_from=0,
    )


@app.command()
@with_options
def curves(parameters: JointSet, voltage: Voltage = "3 kV", figure: Figure = None, as_json: Json = False) -> None:
    """Bistable range of z_b, switching voltage, F(q), C(q): lengths in mm, force in mN, capacitance in pF.

    Example: debist physics curves --set "E=1.7 GPa" --figure curves.svg
    """
    from ..models.analytical.bifurcation import characteristics

    result = characteristics(parameters.joint(), voltage=parse_quantity(voltage, ("V",), "--voltage"))
    path = result.paths["off"]
    _draw(figure, "characteristics_figure", result)
    if as_json:
        emit_json(
            {
                "z_b_min_m": result.z_b_min,
                "z_b_max_m": result.z_b_max,
                "switching_voltage_V": result.switching.both_ways,
                "q_m": path.q,
                "force_N": path.force,
                **{f"C{k}_F": column for k, column in enumerate(path.capacitance.T, start=1)},
            }
        )
        return
    emit_table(
        "The joint",
        ("quantity", "value"),
        [
            ("bistable from z_b [mm]", prefixed(result.z_b_min, "m", 3, "none")),
            (f"switchable by {voltage} up to z_b [mm]", prefixed(result.z_b_max, "m", 3, "none")),
            ("switching voltage, left to right [kV]", prefixed(result.switching.left, "k", 3, "none")),
            ("switching voltage, right to left [kV]", prefixed(result.switching.right, "k", 3, "none")),
            ("energy barrier [µJ]", prefixed(result.barrier, "µ", 1, "none")),
        ],
    )
    emit_table(
        "Without voltage",
        ("q [mm]", "F [mN]", "C1 [pF]", "C2 [pF]"),
        [
            (
                prefixed(path.q[i], "m", 1),
                prefixed(path.force[i], "m", 2),
                *(prefixed(c, "p", 1) for c in path.capacitance[i]),
            )
            for i in range(0, path.q.size, 16)
        ],
        numeric_from=0,
    )


def _command_on_motions(show: "Callable[[JointParameters, Motions, Path | None, bool], None]") -> None:
    """Make a command, named and explained as `show`, that shows motions of the full and the reduced model."""

    def command(
        parameters: JointSet,
        signals: Annotated[
            Path | None,
            typer.Option(
                "--signals", metavar="FILE", help="signals.parquet of a run, for its voltages [default: pulses]."
            ),
        ] = None,
        voltage: Voltage = "3 kV",
        figure: Figure = None,
        as_json: Json = False,
    ) -> None:
        """Move the joint, and show it."""
        from ..workflow.studies import physics

        joint = parameters.joint()
        show(joint, physics.simulate(joint, parse_quantity(voltage, ("V",), "--voltage"), signals), figure, as_json)

    app.command(show.__name__, help=show.__doc__)(with_options(command))


@_command_on_motions
def simulate(joint: "JointParameters", motions: "Motions", figure: Path | None, as_json: bool) -> None:
    """Simulate the full-order model under pulses or measured voltages: q in mm, time in s; SI units in JSON.

    Example: debist physics simulate --signals runs/P1/train/train/signals.parquet --json
    """
    motion = motions.full
    _draw(figure, "motion_figure", motions)
    stop = motion.t.size if motion.diverged_at_s is None else int((motion.t < motion.diverged_at_s).sum())
    q = motion.q[:stop]
    if as_json:
        emit_json(
            {
                "diverged_at_s": motion.diverged_at_s,
                "t_s": motion.t[:stop],
                "q_m": q,
                "qdot_m_per_s": motion.qdot[:stop],
                "qddot_m_per_s2": motion.qddot[:stop],
                "phi_rad": motion.phi[:stop],
            }
        )
        return
    emit_table(
        "Full-order simulation",
        ("quantity", "value"),
        [
            ("duration [s]", f"{motion.t[-1] - motion.t[0]:.2f}"),
            ("q from, to [mm]", f"{prefixed(q[0], 'm', 2)}, {prefixed(q[-1], 'm', 2)}"),
            ("smallest, largest q [mm]", f"{prefixed(q.min(), 'm', 2)}, {prefixed(q.max(), 'm', 2)}"),
            ("steps, rejected", f"{motion.accepted}, {motion.rejected}"),
            ("processor time [s]", f"{motions.full_seconds:.3f}"),
            ("diverged at [s]", prefixed(motion.diverged_at_s, "", 2, "none")),
        ],
    )


@_command_on_motions
def modes(joint: "JointParameters", motions: "Motions", figure: Path | None, as_json: bool) -> None:
    """Modes of the beam in a motion: energy share in percent, largest amplitude in mm (figure 6a).

    Example: debist physics modes --voltage 2.5kV --figure modes.svg
    """
    from ..models.analytical.reduced_order import beam_modes

    if motions.full.diverged_at_s is not None:
        raise InputError(f"the motion diverges at {motions.full.diverged_at_s:.2f} s: lower the voltage")
    result = beam_modes(motions.full.qm, joint.l)
    _draw(figure, "modes_figure", joint, result, motions.full.t)
    peaks = abs(result.amplitudes).max(axis=0)
    if as_json:
        emit_json(
            {
                "energy_share": result.energy_share,
                "largest_amplitude_m": peaks,
                "x_m": result.x,
                "shapes": result.shapes,
            }
        )
    else:
        emit_table(
            "Modes of the beam",
            ("mode", "energy share [%]", "largest amplitude [mm]"),
            [
                (str(number), prefixed(share, "%", 5), prefixed(peak, "m", 4))
                for number, (share, peak) in enumerate(zip(result.energy_share, peaks, strict=True), start=1)
            ],
        )


@_command_on_motions
def reduce(joint: "JointParameters", motions: "Motions", figure: Path | None, as_json: bool) -> None:
    """Reduce the joint to q and compare with the full model: NRMSE in percent, processor time in s (figure 7).

    Example: debist physics reduce --parameters table1
    """
    _draw(figure, "motion_figure", motions)
    if as_json:
        emit_json(
            {
                "nrmse": motions.nrmse,
                "processor_time_s": {"full": motions.full_seconds, "reduced": motions.reduced_seconds},
            }
        )
    else:
        emit_table(
            "Reduced against full model",
            ("quantity", "value"),
            [
                *((f"NRMSE of {name} [%]", prefixed(value, "%", 2, "none")) for name, value in motions.nrmse.items()),
                ("processor time, full [s]", f"{motions.full_seconds:.3f}"),
                ("processor time, reduced [s]", f"{motions.reduced_seconds:.4f}"),
            ],
        )


@app.command()
def calibrate(
    kinematics: Annotated[list[Path], typer.Argument(metavar="KINEMATICS…", help="kinematics.parquet of runs.")],
    parameters: Parameters = "nominal",
    paper: Annotated[
        bool, typer.Option("--paper", help="Only the paper's seven parameters: no asymmetry, no friction.")
    ] = False,
    jobs: Annotated[int, typer.Option("--jobs", min=1, help="Threads.")] = 2,
    output: Annotated[Path | None, typer.Option("-o", metavar="FILE", help="Write the calibrated set as TOML.")] = None,
    as_json: Json = False,
    quiet: Quiet = False,
) -> None:
    """Fit parameters to logs (§ 3.3): values and standard errors in SI units, error of q in mm.

    Example: debist physics calibrate runs/P1/train/train/kinematics.parquet -o P1-joint.toml
    """
    from ..device.parameters import QUANTITIES, joint_parameters
    from ..models.analytical.calibration import ASYMMETRIC_NAMES, FRICTION_NAMES, PAPER_NAMES
    from ..workflow.studies import physics

    names = PAPER_NAMES if paper else ASYMMETRIC_NAMES + FRICTION_NAMES
    joint = joint_parameters(parameters)
    with StatusLine("calibrating", quiet=quiet) as line:
        fit = physics.calibrate(kinematics, joint, names=names, jobs=jobs, report=line.show)
    if output is not None:
        physics.write_parameters(fit, output)
    if as_json:
        emit_json(physics.calibration_document(fit))
        return
    emit_table(
        f"Calibrated; error of q {prefixed(fit.rmse, 'm', 3)} mm",
        ("parameter", "value", "±", "unit"),
        [
            (name, f"{value:.5g}", f"{error:.2g}", QUANTITIES[name].unit)
            for name, value, error in zip(fit.names, fit.values, fit.standard_errors, strict=True)
        ],
    )
