"""Figures 3 to 7 of the paper from the analytical model, drawn with matplotlib."""

from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from pipeline.errors import InputError
from pipeline.reporting.palette import MODEL_COLOURS

if TYPE_CHECKING:
    from pipeline.joint.calibration import Calibration
    from pipeline.joint.characteristic_curves import Characteristics
    from pipeline.joint.equilibria import Equilibrium
    from pipeline.joint.model_comparison import Motions
    from pipeline.joint.modes import BeamModes
    from pipeline.joint.parameters import JointParameters

STATE_COLOURS = {"off": "#000000", "left": MODEL_COLOURS[1], "right": MODEL_COLOURS[2], "both": MODEL_COLOURS[0]}
FORMATS = (".svg", ".pdf", ".png")


def _figure(rows: int, columns: int, width: float = 7.0, height: float = 3.0) -> tuple[Any, Any]:
    from matplotlib.figure import Figure

    figure = Figure(figsize=(width, height * rows), layout="constrained")
    return figure, figure.subplots(rows, columns, squeeze=False)


def _save(figure: Any, target: Path) -> None:
    import matplotlib as mpl

    if target.suffix not in FORMATS:
        raise InputError(f"{target}: figures are written as {', '.join(FORMATS)}")
    metadata = {".svg": {"Date": None}, ".pdf": {"CreationDate": None}}.get(target.suffix)
    # A fixed salt and no date: the same numbers give the same file.
    with mpl.rc_context({"svg.hashsalt": "debist", "svg.fonttype": "path"}):
        figure.savefig(target, metadata=metadata, dpi=150)


def _label(axes: Any, x: str, y: str, title: str) -> None:
    axes.set_xlabel(x)
    axes.set_ylabel(y)
    axes.set_title(title, fontsize="medium", loc="left")
    axes.grid(visible=True, linewidth=0.3)


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
    _label(axes, "q [mm]", "z_b [mm]", f"Equilibria; bistable {start}")


def draw_force(axes: Any, result: "Characteristics") -> None:
    """Figure 4: F(q)."""
    for name, path in result.paths.items():
        _by_stability(axes, 1e3 * path.q, 1e3 * path.force, path.stable, STATE_COLOURS[name], name)
    axes.axhline(0.0, color="#8C8C8C", linewidth=0.7)
    axes.set_ylim(-100.0, 100.0)
    axes.legend(fontsize="x-small", title="voltage on", title_fontsize="x-small", loc="lower right")
    _label(axes, "q [mm]", "F [mN]", "Force that holds the tip")


def draw_energy(axes: Any, result: "Characteristics") -> None:
    """Double-well energy without voltage."""
    path = result.paths["off"]
    _by_stability(axes, 1e3 * path.q, 1e6 * (path.energy - path.energy.min()), path.stable, "#000000", "off")
    text = "no barrier" if result.barrier is None else f"barrier {1e6 * result.barrier:.0f} µJ"
    _label(axes, "q [mm]", "U [µJ]", f"Energy without voltage: {text}")


def draw_capacitance(capacitance: Any, slope: Any, result: "Characteristics") -> None:
    """Figure 5: C_i(q) and dC_i/dq."""
    path = result.paths["off"]
    for side, name in enumerate(("left", "right")):
        capacitance.plot(1e3 * path.q, 1e12 * path.capacitance[:, side], color=STATE_COLOURS[name], label=name)
        slope.plot(1e3 * path.q, 1e9 * path.capacitance_slope[:, side], color=STATE_COLOURS[name], label=name)
    capacitance.legend(fontsize="small")
    _label(capacitance, "q [mm]", "C [pF]", "Capacitance")
    _label(slope, "q [mm]", "dC/dq [nF/m]", "Its derivative")


def save_characteristics(target: Path, result: "Characteristics") -> None:
    """Figures 3 to 5 and the double well on one page."""
    figure, axes = _figure(3, 2, height=2.8)
    draw_equilibrium_diagram(axes[0, 0], result)
    draw_force(axes[0, 1], result)
    draw_energy(axes[1, 0], result)
    path = result.paths["off"]
    axes[1, 1].plot(1e3 * path.q, np.degrees(path.phi), color="#000000")
    _label(axes[1, 1], "q [mm]", "φ [deg]", "Pitch angle on the static path")
    draw_capacitance(axes[2, 0], axes[2, 1], result)
    _save(figure, target)


def save_equilibria(target: Path, joint: "JointParameters", found: "list[Equilibrium]") -> None:
    """The beam's shape in every equilibrium; dotted where it is unstable."""
    from pipeline.joint.modes import beam_shapes

    figure, ((axes,),) = _figure(1, 1, width=3.5, height=4.0)
    for index, equilibrium in enumerate(found):
        x, w = beam_shapes(equilibrium.qm[None, :], joint.l)
        colour = MODEL_COLOURS[index % len(MODEL_COLOURS)]
        label = f"q = {1e3 * equilibrium.q:.2f} mm"
        axes.plot(1e3 * w[0], 1e3 * x, color=colour, linestyle="-" if equilibrium.stable else ":", label=label)
    axes.legend(fontsize="small")
    _label(axes, "w [mm]", "x [mm]", "Beam in its equilibria")
    _save(figure, target)


def save_modes(target: Path, joint: "JointParameters", modes: "BeamModes") -> None:
    """Figure 6a: shapes and amplitudes of the beam's modes; figure 6b: the static path q_m(q)."""
    from pipeline.joint.static_path import unactuated_path

    figure, axes = _figure(2, 2, height=2.8)
    for number in range(3):
        label = f"mode {number + 1}: {100 * modes.energy_share[number]:.3g} %"
        axes[0, 0].plot(1e3 * modes.x, modes.shapes[number], color=MODEL_COLOURS[number], label=label)
        axes[0, 1].plot(1e3 * modes.amplitudes[:, number], color=MODEL_COLOURS[number], linewidth=0.8)
    axes[0, 0].legend(fontsize="small")
    _label(axes[0, 0], "x [mm]", "shape [1]", "Modes of the motion")
    _label(axes[0, 1], "sample", "amplitude [mm]", "Their amplitudes")
    path = unactuated_path(joint)
    inside = np.abs(path.q) <= 0.02
    for column, (name, power) in enumerate((("q2 l²", 2), ("q3 l³", 3), ("q4 l⁴", 4))):
        shape = 1e3 * path.qm[inside, column] * joint.l**power
        axes[1, 0].plot(1e3 * path.q[inside], shape, color=MODEL_COLOURS[column], label=name)
    axes[1, 0].legend(fontsize="small")
    _label(axes[1, 0], "q [mm]", "contribution to w(l) [mm]", "Static path: bending")
    axes[1, 1].plot(1e3 * path.q[inside], 1e6 * path.qm[inside, 3], color="#000000")
    _label(axes[1, 1], "q [mm]", "u0 [µm]", "Static path: axial")
    _save(figure, target)


def save_motion(target: Path, motions: "Motions") -> None:
    """Figure 7: full-order and reduced motion under the same voltages."""
    figure, axes = _figure(3, 1, height=1.8)
    full, reduced = motions.full, motions.reduced
    for side, name in enumerate(("left", "right")):
        axes[0, 0].plot(full.t, 1e-3 * motions.v[:, side], color=STATE_COLOURS[name], label=name, linewidth=0.9)
    axes[0, 0].legend(fontsize="small", loc="upper right")
    _label(axes[0, 0], "", "v [kV]", "Voltages")
    panels = ((full.q, reduced.q, "q [mm]", "Displacement"), (full.q_dot, reduced.q_dot, "dq/dt [mm/s]", "Velocity"))
    for row, (a, b, unit, title) in enumerate(panels, start=1):
        axes[row, 0].plot(full.t, 1e3 * a, color="#000000", linewidth=1.1, label="full order, 10 states")
        axes[row, 0].plot(full.t, 1e3 * b, color=MODEL_COLOURS[1], linewidth=0.9, linestyle="--", label="reduced to q")
        _label(axes[row, 0], "t [s]" if row == 2 else "", unit, title)
    axes[1, 0].legend(fontsize="small", loc="upper right")
    _save(figure, target)


def save_calibration(target: Path, start: "JointParameters", fit: "Calibration") -> None:
    """How far the fitted parameters moved from where they started, with standard errors, and their correlations.

    A parameter that starts at zero (curvature, friction) has no relative change and stands in the correlations only.
    """
    from pipeline.joint.parameters import VECTOR_NAMES

    figure, axes = _figure(1, 2, width=10.0, height=4.5)
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
    _label(moved, "change [%]", "", "Fitted against start, ± standard error")
    picture = matrix.imshow(fit.correlation, vmin=-1.0, vmax=1.0, cmap="PuOr")
    matrix.set_xticks(range(len(fit.names)), fit.names, rotation=90)
    matrix.set_yticks(range(len(fit.names)), fit.names)
    matrix.set_title("Correlations of the estimates", fontsize="medium", loc="left")
    figure.colorbar(picture, ax=matrix, shrink=0.8)
    _save(figure, target)
