"""The figures of control show what the documents hold, and every one can be drawn."""

import numpy as np

from pipeline.reporting.control_figures import control_figures
from pipeline.reporting.plotted import paper_figure


def documents() -> dict[str, dict[str, object]]:
    f, t = np.geomspace(0.1, 100.0, 20).tolist(), np.linspace(0.0, 1.0, 50).tolist()
    bode = {name: f for name in ("f_Hz", "left_dB", "left_deg", "right_dB", "right_deg")}
    q = [0.01 * x for x in t]
    predicted = {"t_s": t, "q_m": q, "low_m": q, "high_m": q}
    volts = [[3000.0, 0.0]] * 50
    chances = [[0.0, 0.5], [0.95, 1.0]]
    pulse = {
        "to": "right", "t_s": t, "v_V": volts, "predicted": predicted, "settling_s": 0.2, "switching_probability": 1.0,
    }  # fmt: skip
    loop = {"steps": [], "t_s": t, "q_m": q, "target_m": q, "v_V": volts}
    return {
        "linear": {"equilibria": [{"q_m": 0.01, "stable": True, "bode": bode}]},
        "map": {"maps": [{"to": "left", "probability": chances, "durations": [0.1, 0.2], "voltages": [1e3, 2e3]}]},
        "pulse-to-right": pulse,
        "design": {"predicted": loop},
    }


def test_every_document_has_its_figure_and_each_is_drawn() -> None:
    found = control_figures(documents())
    assert list(found) == ["control-map-left", "control-bode-1", "control-pulse-right", "control-loop"]
    cells = found["control-map-left"].panels[0].cells
    assert cells is not None
    assert cells.index.tolist() == [[3, 3], [3, 3]]  # an edge everywhere
    motion, volts = (panel.lines[0] for panel in found["control-pulse-right"].panels)
    assert (volts.y.max(), volts.y[-1], volts.x[-1]) == (3000.0, 0.0, motion.x[-1])
    for figure in found.values():
        assert len(paper_figure(figure, ("hybrid",), "svg")[0]) > 1000
