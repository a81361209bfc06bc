"""Figures of `debist control`: frequency responses, switching maps, snaps with their prediction, the closed loop."""

from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np

from ..units.quantity import prefixed
from .figure import Band, Cells, Figure, Line, Panel

_LIKELY = (0.1, 0.9)


def control_figures(documents: Mapping[str, Mapping[str, Any]]) -> dict[str, Figure]:
    """The figures of a run's control, by name.

    Parameters
    ----------
    documents : mapping of str to mapping
        ``linear``, ``map``, ``pulse-to-left``, ``pulse-to-right``, ``design``, as far as they were made.
    """
    figures = (
        *(_map(drawn) for drawn in (documents["map"]["maps"] if "map" in documents else ())),
        *(_bode(documents["linear"]) if "linear" in documents else ()),
        *(_pulse(documents[name]) for name in ("pulse-to-right", "pulse-to-left") if name in documents),
        *([_loop(documents["design"])] if "design" in documents else ()),
    )
    return {figure.name: figure for figure in figures}


def _bode(document: Mapping[str, Any]) -> Iterator[Figure]:
    for number, equilibrium in enumerate(document["equilibria"][:3], start=1):
        bode = {name: np.array(values) for name, values in equilibrium["bode"].items()}
        sides = (("left membrane", "v1", "left"), ("right membrane", "v2", "right"))
        panels = tuple(
            Panel(
                name, unit, tuple(Line(label, role, bode["f_Hz"], bode[f"{side}_{key}"]) for label, role, side in sides)
            )
            for name, unit, key in (("gain", "dB re 1 nm/V²", "dB"), ("phase", "°", "deg"))
        )
        kind = "stable" if equilibrium["stable"] else "unstable"
        yield Figure(
            f"control-bode-{number}",
            f"Bode plot at q = {prefixed(equilibrium['q_m'], 'm', 2)} mm ({kind})".replace("-", "−"),
            caption="From the squared voltage of each membrane to the displacement, friction left out.",
            x_name="frequency",
            x_unit="Hz",
            panels=panels,
            x_log=True,
            half=True,
        )


def _map(drawn_map: Mapping[str, Any]) -> Figure:
    from scipy.ndimage import maximum_filter, minimum_filter

    probability = np.array(drawn_map["probability"])
    # At an edge the map does not resolve which draws switch: the band is at least as wide as the step of its grid.
    most = maximum_filter(probability, 3, mode="nearest")
    least = minimum_filter(probability, 3, mode="nearest")
    index = np.select([most < _LIKELY[0], least > _LIKELY[1]], [0, 2], 3).astype(np.int8)
    return Figure(
        f"control-map-{drawn_map['to']}",
        title=f"Does a pulse switch to the {drawn_map['to']}?",
        caption="Share of the posterior draws that a plain pulse switches, from rest; where it may, the log does not "
        "decide.",
        x_name="duration",
        x_unit="s",
        panels=(
            Panel(
                "voltage",
                "V",
                cells=Cells(
                    ("hardly ever switches", "", "nearly always switches", "may switch: 10 to 90 % of the draws"),
                    np.array(drawn_map["durations"]),
                    np.array(drawn_map["voltages"]),
                    index,
                ),
            ),
        ),
        x_log=True,
        half=True,
    )


def _pulse(document: Mapping[str, Any]) -> Figure:
    t = np.array(document["t_s"])
    predicted = {k: np.array(v) for k, v in document["predicted"].items()}
    v = np.array(document["v_V"])
    shown = predicted["t_s"] <= max(3.0 * t[-1], 0.6)
    at = predicted["t_s"][shown]
    motion = Panel(
        "q",
        "m",
        (Line("predicted", "measured", at, predicted["q_m"][shown]),),
        (Band("90 % of the draws", "measured", at, predicted["low_m"][shown], predicted["high_m"][shown]),),
    )
    t, v = np.append(t, max(t[-1], at[-1])), np.vstack([v, np.zeros(2)])  # off for the rest of the motion
    volts = Panel("voltage", "V", (Line("left", "v1", t, v[:, 0]), Line("right", "v2", t, v[:, 1])))
    settled = document["settling_s"]
    settling = "does not settle" if settled is None else f"settles within 5 % after {prefixed(settled, 'm', 0)} ms"
    return Figure(
        f"control-pulse-{document['to']}",
        f"Snap to the {document['to']}",
        caption=f"Feedforward; {settling}, switches with probability {document['switching_probability']:.2f}.",
        x_name="time",
        x_unit="s",
        panels=(motion, volts),
        half=True,
    )


def _loop(document: Mapping[str, Any]) -> Figure:
    run = {name: np.array(values) for name, values in document["predicted"].items() if name != "steps"}
    t = run["t_s"]
    return Figure(
        "control-loop",
        "Closed loop",
        caption="The designed controller on the identified model: to the right, to the left, to the unstable "
        "equilibrium.",
        x_name="time",
        x_unit="s",
        panels=(
            Panel("q", "m", (Line("target", "reference", t, run["target_m"]), Line("q", "measured", t, run["q_m"]))),
            Panel("voltage", "V", (Line("left", "v1", t, run["v_V"][:, 0]), Line("right", "v2", t, run["v_V"][:, 1]))),
        ),
    )
