"""Figures 3 to 7 of the paper from the analytical model, drawn with matplotlib."""

from typing import TYPE_CHECKING, Any

import numpy as np

from pipeline.reporting.canvas import label, new_figure
from pipeline.reporting.legend import MODEL_COLOURS

if TYPE_CHECKING:
    from pipeline.joint.bifurcation import Characteristics
    from pipeline.joint.calibration import Calibration
    from pipeline.joint.equilibria import Equilibrium
    from pipeline.joint.model_comparison import Motions
    from pipeline.joint.parameters import JointParameters
    from pipeline.joint.reduction import BeamModes

STATE_COLOURS = {"off": "#000000", "left": MODEL_COLOURS[1], "right": MODEL_COLOURS[2], "both": MODEL_COLOURS[0]}
MODE_COLOURS = (MODEL_COLOURS[1], MODEL_COLOURS[2], MODEL_COLOURS[0])
PATH_REACH, PATH_DEGREE = 0.02, 9
"""Displacement [m] to which figure 6b reaches, and the degree of its polynomials."""


def _by_stability(axes: Any, x: Any, y: Any, stable: Any, colour: str, label: str) -> None:
    """Solid where stable, dotted where not; the pieces share their end points."""
    edges = np.flatnonzero(np.diff(stable.astype(int))) + 1
    named = False
    for begin, end in zip((0, *edges), (*edges, stable.size), strict=True):
        piece, solid = slice(begin, min(end + 1, stable.size)), bool(stable[begin])
        axes.plot(
            x[piece], y[piece], color=colour, linestyle="-" if solid else ":", linewidth=1.3,
            label=label if solid and not named else None,
        )  # fmt: skip
        named = named or solid


def draw_equilibrium_diagram(axes: Any, result: "Characteristics") -> None:
    """Figure 3: equilibria over z_b."""
    for name, branches in result.diagrams.items():
        for index, branch in enumerate(branches):
            q, z_b = 1e3 * branch.q, 1e3 * branch.parameter
            _by_stability(axes, q, z_b, branch.stable, STATE_COLOURS[name], name if index == 0 else "_")
    for limit in (result.z_b_min, result.z_b_max):
        if limit is not None and limit <= 0.01:
            axes.axhline(1e3 * limit, color="#8C8C8C", linewidth=0.7)
    axes.set_ylim(0.0, 10.0)
    axes.set_xlim(-18.0, 18.0)
    start = "nowhere" if result.z_b_min is None else f"from {1e3 * result.z_b_min:.2f} mm"
    label(axes, "q [mm]", "z_b [mm]", f"Equilibria; bistable {start}")


def draw_force(axes: Any, result: "Characteristics") -> None:
    """Figure 4: F(q)."""
    for name, path in result.paths.items():
        _by_stability(axes, 1e3 * path.q, 1e3 * path.force, path.stable, STATE_COLOURS[name], name)
    axes.axhline(0.0, color="#8C8C8C", linewidth=0.7)
    axes.set_ylim(-100.0, 100.0)
    axes.legend(fontsize="x-small", title="voltage on", title_fontsize="x-small", loc="lower right")
    label(axes, "q [mm]", "F [mN]", "Force that holds the tip")


def draw_energy(axes: Any, result: "Characteristics") -> None:
    """Double-well energy without voltage."""
    path = result.paths["off"]
    _by_stability(axes, 1e3 * path.q, 1e6 * (path.energy - path.energy.min()), path.stable, "#000000", "off")
    text = "no barrier" if result.barrier is None else f"barrier {1e6 * result.barrier:.0f} µJ"
    label(axes, "q [mm]", "U [µJ]", f"Energy: {text}")


def draw_capacitance(capacitance: Any, slope: Any, result: "Characteristics") -> None:
    """Figure 5: C_i(q) and dC_i/dq."""
    path = result.paths["off"]
    for side, name in enumerate(("left", "right")):
        capacitance.plot(1e3 * path.q, 1e12 * path.capacitance[:, side], color=STATE_COLOURS[name], label=name)
        slope.plot(1e3 * path.q, 1e9 * path.capacitance_slope[:, side], color=STATE_COLOURS[name], label=name)
    capacitance.legend(fontsize="small")
    label(capacitance, "q [mm]", "C [pF]", "Capacitance")
    label(slope, "q [mm]", "dC/dq [nF/m]", "Its derivative")


def double_well_figure(result: "Characteristics") -> Any:
    """Figure 1b: potential energy U(q) and force F(q) = ∂U/∂q without voltage."""
    figure, ((left, right),) = new_figure(1, 2, height=2.6)
    draw_energy(left, result)
    path = result.paths["off"]
    _by_stability(right, 1e3 * path.q, 1e3 * path.force, path.stable, "#000000", "off")
    right.axhline(0.0, color="#8C8C8C", linewidth=0.7)
    label(right, "q [mm]", "F [mN]", "Its slope, the force")
    return figure


def equilibrium_figure(result: "Characteristics") -> Any:
    """Figure 3."""
    figure, ((axes,),) = new_figure(1, 1, width=4.5, height=3.4)
    draw_equilibrium_diagram(axes, result)
    axes.legend(fontsize="x-small", title="voltage on", title_fontsize="x-small", loc="lower right")
    return figure


def force_figure(result: "Characteristics") -> Any:
    """Figure 4."""
    figure, ((axes,),) = new_figure(1, 1, width=4.5, height=3.4)
    draw_force(axes, result)
    return figure


def capacitance_figure(result: "Characteristics") -> Any:
    """Figure 5."""
    figure, ((left, right),) = new_figure(1, 2, height=2.8)
    draw_capacitance(left, right, result)
    return figure


def characteristics_figure(result: "Characteristics") -> Any:
    """Figures 3 to 5 and the double well on one page."""
    figure, axes = new_figure(3, 2, height=2.8)
    draw_equilibrium_diagram(axes[0, 0], result)
    draw_force(axes[0, 1], result)
    draw_energy(axes[1, 0], result)
    path = result.paths["off"]
    axes[1, 1].plot(1e3 * path.q, np.degrees(path.phi), color="#000000")
    label(axes[1, 1], "q [mm]", "φ [deg]", "Pitch angle on the static path")
    draw_capacitance(axes[2, 0], axes[2, 1], result)
    return figure


def equilibria_figure(joint: "JointParameters", found: "list[Equilibrium]", energy: "tuple[Any, Any] | None") -> Any:
    """Statics (eqs. 13 to 15): the energy over q with its equilibria, and the beam's shape in each.

    `energy` is q [m] and the total potential [J] along the held joint; None where it snaps although it is held.
    Dotted where it is unstable.
    """
    from pipeline.joint.reduction import beam_shapes

    figure, ((left, right),) = new_figure(1, 2, height=3.6)
    lowest = min((e.energy for e in found), default=0.0)
    if energy is not None:
        left.plot(1e3 * energy[0], 1e6 * (energy[1] - lowest), color="#000000", linewidth=1.0)
    for index, equilibrium in enumerate(found):
        x, w = beam_shapes(equilibrium.qm[None, :], joint.l)
        colour = MODEL_COLOURS[index % len(MODEL_COLOURS)]
        name = f"q = {round(1e3 * equilibrium.q, 2) + 0.0:.2f} mm" + ("" if equilibrium.stable else ", unstable")
        right.plot(1e3 * w[0], 1e3 * x, color=colour, linestyle="-" if equilibrium.stable else ":", label=name)
        left.plot(
            1e3 * equilibrium.q, 1e6 * (equilibrium.energy - lowest), "o", color=colour,
            fillstyle="full" if equilibrium.stable else "none",
        )  # fmt: skip
    label(left, "q [mm]", "U − ½ΣCv² − Fq [µJ]", "Total potential and its equilibria")
    right.legend(fontsize="x-small", loc="upper left", bbox_to_anchor=(1.02, 1.0))
    right.set_aspect("equal", adjustable="box")
    label(right, "w [mm]", "x [mm]", "Beam in its equilibria")
    return figure


def draw_modes(shapes: Any, amplitudes: Any, modes: "BeamModes", t: Any) -> None:
    """Figure 6a: mode shapes with the model's response over them, and their amplitudes over time."""
    for number in range(3):
        name = f"mode {number + 1}: {100 * modes.energy_share[number]:.3g} %"
        shapes.plot(1e3 * modes.x, modes.shapes[number], color=MODE_COLOURS[number], label=name)
        amplitudes.plot(t, 1e3 * modes.amplitudes[:, number], color=MODE_COLOURS[number], linewidth=0.8)
    shapes.plot(1e3 * modes.x, modes.widest, color="#000000", linestyle="--", linewidth=1.0, label="model, widest")
    shapes.legend(fontsize="x-small")
    label(shapes, "x [mm]", "shape [1]", "Modes of the motion")
    label(amplitudes, "t [s]", "amplitude [mm]", "Their amplitudes")


def draw_static_path(bending: Any, axial: Any, joint: "JointParameters") -> None:
    """Figure 6b: the static path q_m(q) and the polynomials fitted to it (eq. 24)."""
    from numpy.polynomial.polynomial import polyval

    from pipeline.joint.reduction import polynomial_shapes
    from pipeline.joint.static_path import static_path

    path = static_path(joint, np.linspace(-PATH_REACH, PATH_REACH, 161), np.zeros(2))
    fitted = polyval(path.q / PATH_REACH, polynomial_shapes(path, PATH_DEGREE).T)
    for column, (name, power) in enumerate((("q₂ l²", 2), ("q₃ l³", 3), ("q₄ l⁴", 4))):
        factor = 1e3 * joint.l**power
        bending.plot(1e3 * path.q, factor * path.qm[:, column], color=MODE_COLOURS[column], label=name)
        bending.plot(1e3 * path.q, factor * fitted[column], color="#000000", linestyle="--", linewidth=0.8)
    axial.plot(1e3 * path.q, 1e6 * path.qm[:, 3], color=MODE_COLOURS[0], label="u₀")
    axial.plot(1e3 * path.q, 1e6 * fitted[3], color="#000000", linestyle="--", linewidth=0.8, label="polynomial")
    bending.legend(fontsize="x-small")
    axial.legend(fontsize="x-small")
    label(bending, "q [mm]", "share of w(l) [mm]", f"Static path; dashed: degree {PATH_DEGREE}")
    label(axial, "q [mm]", "u₀ [µm]", "Static path: axial")


def modes_figure(joint: "JointParameters", modes: "BeamModes", t: Any) -> Any:
    """Figure 6: modes of a motion at times t [s], and the static path with its polynomials."""
    figure, axes = new_figure(2, 2, height=2.8)
    draw_modes(axes[0, 0], axes[0, 1], modes, t)
    draw_static_path(axes[1, 0], axes[1, 1], joint)
    return figure


def motion_figure(motions: "Motions") -> Any:
    """Figure 7: full-order and reduced motion under the same voltages."""
    figure, axes = new_figure(3, 1, height=1.8)
    full, reduced = motions.full, motions.reduced
    for side, name in enumerate(("left", "right")):
        axes[0, 0].plot(full.t, 1e-3 * motions.v[:, side], color=STATE_COLOURS[name], label=name, linewidth=0.9)
    axes[0, 0].legend(fontsize="small", loc="upper right")
    label(axes[0, 0], "", "v [kV]", "Voltages")
    panels = ((full.q, reduced.q, "q [mm]", "Displacement"), (full.q_dot, reduced.q_dot, "dq/dt [mm/s]", "Velocity"))
    for row, (a, b, unit, title) in enumerate(panels, start=1):
        axes[row, 0].plot(full.t, 1e3 * a, color="#000000", linewidth=1.1, label="full order, 10 states")
        axes[row, 0].plot(full.t, 1e3 * b, color=MODEL_COLOURS[1], linewidth=0.9, linestyle="--", label="reduced to q")
        label(axes[row, 0], "t [s]" if row == 2 else "", unit, title)
    axes[1, 0].legend(fontsize="small", loc="upper right")
    return figure


def calibration_figure(start: "JointParameters", fit: "Calibration") -> Any:
    """How far the fitted parameters moved from where they started, with standard errors, and their correlations.

    A parameter that starts at zero (curvature, friction) has no relative change and stands in the correlations only.
    """
    from pipeline.joint.parameters import VECTOR_NAMES

    figure, axes = new_figure(1, 2, width=10.0, height=4.5)
    moved, matrix = axes[0]
    # A name without a side stands for both membranes, which start from one value.
    begun = [start.value(name if name in VECTOR_NAMES else f"left.{name}") for name in fit.names]
    known = [(name, value, i) for i, (name, value) in enumerate(zip(fit.names, begun, strict=True)) if value != 0.0]
    change = [100.0 * (fit.values[i] / value - 1.0) for _, value, i in known]
    error = [100.0 * abs(fit.standard_errors[i] / value) for _, value, i in known]
    rows = np.arange(len(known))
    moved.errorbar(change, rows, xerr=error, fmt="o", color=MODEL_COLOURS[0], capsize=3)
    moved.axvline(0.0, color="black", linewidth=0.8)
    moved.set_yticks(rows, [name for name, _, _ in known])
    moved.invert_yaxis()
    label(moved, "change [%]", "", "Fitted against start, ± standard error")
    picture = matrix.imshow(fit.correlation, vmin=-1.0, vmax=1.0, cmap="PuOr")
    matrix.set_xticks(range(len(fit.names)), fit.names, rotation=90)
    matrix.set_yticks(range(len(fit.names)), fit.names)
    matrix.set_title("Correlations of the estimates", fontsize="medium", loc="left")
    figure.colorbar(picture, ax=matrix, shrink=0.8)
    return figure
