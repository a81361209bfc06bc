"""Figure of docs/how-to/excitation.md: `python benchmarks/excitation_figure.py`; 15 s of processor time."""

from pathlib import Path
from typing import Any

import matplotlib
import matplotlib.pyplot as plt
import numpy as np

from pipeline.device.parameters import NOMINAL
from pipeline.fitting.information import Coverage
from pipeline.reporting.figure import FIXED
from pipeline.rig.excitation import Burst, alternating_pulses, command
from pipeline.workflow.studies.excitation_design import (
    Design,
    Requirements,
    Simulator,
    design_excitation,
    drawn_simulators,
)

TARGET = Path(__file__).resolve().parents[1] / "docs" / "figures" / "excitation.svg"
STYLE: Any = {"svg.hashsalt": "debist", "font.size": 8, "axes.spines.top": False, "axes.spines.right": False}


def draw(
    axes: np.ndarray, title: str, bursts: list[Burst], design: Design, simulate: Simulator, visits: Coverage
) -> None:
    """Voltages, state plane, and samples per centre of one sequence, in a row of three."""
    t = 0.01 * np.arange(3750.0)
    u = command(bursts, t)
    q, qdot = simulate(t, u)
    for column, name, side in zip(u.T, ("v1", "v2"), (1, -1), strict=True):
        axes[0].fill_between(t, side * 1e-3 * column, color=FIXED[name], linewidth=0, rasterized=True)
    axes[0].set(title=f"{title}: left up, right down [kV]", xlim=(0, 37.5), ylim=(-3.3, 3.3))
    axes[1].plot(1e3 * q, qdot, linewidth=0.4, color="#000000", rasterized=True)
    axes[1].set(title="q̇ [m/s] over q [mm]", xlim=(-30, 30), ylim=(-0.35, 0.35))
    places = 1e3 * design.weights.centres
    width = 0.27 * (places[1] - places[0])
    rows = ((visits.visits, "all", FIXED["raw"]), (visits.driven[0], "left on", FIXED["v1"]))
    for shift, (counts, label, colour) in enumerate((*rows, (visits.driven[1], "right on", FIXED["v2"])), start=-1):
        axes[2].bar(places + shift * width, np.maximum(counts, 0.5), width, color=colour, label=label)
    axes[2].axhline(20, color="0.4", linewidth=0.7, dashes=(4, 2))
    axes[2].set(title="samples per centre [mm]", yscale="log", ylim=(0.5, 8000))


def main() -> None:
    rng = np.random.default_rng(1)
    simulators = drawn_simulators(NOMINAL, rng, 4)
    design = design_excitation(simulators, rng, Requirements())
    plain = alternating_pulses()
    with plt.rc_context(STYLE):
        figure, axes = plt.subplots(2, 3, figsize=(7.5, 3.8), layout="constrained", sharex="col")
        draw(axes[0], "alternating", plain, design, simulators[0], design.plain.visits)
        draw(axes[1], "designed", design.bursts, design, simulators[0], design.designed.visits)
        axes[1, 0].set_xlabel("time [s]")
        axes[1, 1].set_xlabel("q [mm]")
        axes[1, 2].set_xlabel("q [mm]")
        axes[0, 2].legend(fontsize=6, frameon=False, ncols=3)
        figure.savefig(TARGET, metadata={"Date": None}, dpi=150)


if __name__ == "__main__":
    matplotlib.use("svg")
    main()
