"""Figure of README.md: `python benchmarks/readme_figure.py RUN`, from the run of `debist demo -o RUN`.

The drawing is the joint with the paper's drawn parameters at rest in both wells, to scale. Beside it is the free run of
the run's first model over its validation log.
"""

import sys
from pathlib import Path
from typing import Any

import matplotlib
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.axes import Axes

import debist
from pipeline.device.parameters import NOMINAL
from pipeline.models.analytical.reduced_order import beam_shapes
from pipeline.models.analytical.statics import JointEquilibrium, equilibria
from pipeline.reporting.figure import FIXED

TARGET = Path(__file__).resolve().parents[1] / "docs" / "figures" / "joint-and-free-run.svg"
STYLE: Any = {"svg.hashsalt": "debist", "font.size": 8, "axes.spines.top": False, "axes.spines.right": False}
WINDOW = (3.0, 18.0)
"""Part of the log that is drawn [s]."""


def draw_joint(ax: Axes, rest: JointEquilibrium, opacity: float) -> None:
    """Beam, frame and membranes [mm] in one well: clamp at the bottom, q to the right."""
    place, w = beam_shapes(rest.qm[np.newaxis], NOMINAL.l)
    height = place * (1.0 + rest.u_y / NOMINAL.l)
    ax.plot(1e3 * w[0], 1e3 * height, color="#000000", linewidth=2.2, alpha=opacity, zorder=3)
    tip = np.array([rest.q, NOMINAL.l + rest.u_y])
    along = np.array([np.sin(rest.phi), np.cos(rest.phi)])
    across = np.array([along[1], -along[0]])
    for sign, membrane, colour in ((-1.0, NOMINAL.left, FIXED["v1"]), (1.0, NOMINAL.right, FIXED["v2"])):
        top = tip + membrane.a0 * along
        corner = top + sign * membrane.a * across
        upper = corner - membrane.b * along
        lower = np.array([sign * membrane.e_z, membrane.e_x])
        ax.plot(*(1e3 * np.array([tip, top, corner, upper]).T), color="0.45", linewidth=1.6, alpha=opacity)
        ax.plot(*(1e3 * np.array([upper, lower]).T), color=colour, linewidth=4.0, alpha=opacity, solid_capstyle="butt")


def joint_panel(ax: Axes) -> None:
    """Both wells; the joint rests in the left one."""
    wells = [rest for rest in equilibria(NOMINAL, np.zeros(2)) if rest.stable]
    draw_joint(ax, wells[-1], 0.22)
    draw_joint(ax, wells[0], 1.0)
    for side in (-1.0, 1.0):
        ax.plot([0.0, side * 16, side * 16], [0, 0, 7], color="0.45", linewidth=2)
    ax.annotate("", (1e3 * wells[-1].q, 112), (1e3 * wells[0].q, 112), arrowprops={"arrowstyle": "<->", "lw": 0.8})
    ax.text(0, 114, "q", ha="center", va="bottom")
    ax.text(-29, 24, "left membrane\nv1", color="#2277AA", ha="right", va="center")
    ax.text(29, 24, "right membrane\nv2", color="#996600", ha="left", va="center")
    ax.annotate("beam", (0.5, 8), (-12, -14), arrowprops={"arrowstyle": "-", "lw": 0.5}, ha="center", va="center")
    ax.set(aspect="equal", xlim=(-78, 78), ylim=(-18, 124))
    ax.axis("off")


def free_run_panel(signal: Axes, inputs: Axes, run: debist.Run) -> None:
    """Measured q, its free run, and the two voltages below."""
    log = run.logs[-1]
    measured, free = (table[table.t_s.between(*WINDOW)] for table in (run.log(log), run.simulate(run.models[0], log)))
    error = run.scores().query(f"log == '{log}' and signal == 'q' and model == '{run.models[0]}'").nrmse.iloc[0]
    signal.plot(measured.t_s, 1e3 * measured.q_m, color="0.72", linewidth=3.2, label="measured (simulated rig)")
    label = f"{run.models[0]} in free run, error {100 * error:.2g} % of the range"
    signal.plot(free.t_s, 1e3 * free.q_m, color="#000000", linewidth=0.9, label=label)
    signal.legend(frameon=False, ncols=2, loc="lower center", bbox_to_anchor=(0.5, 1.0))
    signal.set(ylabel="q [mm]", xlim=WINDOW)
    for side, key in (("v1", "v1_V"), ("v2", "v2_V")):
        inputs.fill_between(measured.t_s, 1e-3 * measured[key], color=FIXED[side], linewidth=0, label=side)
    inputs.set(ylabel="v1, v2 [kV]", xlabel="time [s]")


def main() -> None:
    run = debist.open_run(sys.argv[1])
    with plt.rc_context(STYLE):
        figure = plt.figure(figsize=(8.4, 2.9), layout="constrained")
        axes = figure.subplot_mosaic(
            [["joint", "q"], ["joint", "v"]], width_ratios=(1.0, 2.5), height_ratios=(2.6, 1.0)
        )
        joint_panel(axes["joint"])
        axes["v"].sharex(axes["q"])
        axes["q"].tick_params(labelbottom=False)
        free_run_panel(axes["q"], axes["v"], run)
        figure.savefig(TARGET, metadata={"Date": None}, dpi=150)


if __name__ == "__main__":
    matplotlib.use("svg")
    main()
