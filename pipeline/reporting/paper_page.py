"""The page "the paper and this joint": figures and tables under the paper's numbers, printed beside computed values."""

import base64
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

from ..device.parameters import QUANTITIES, JointParameters
from ..diagnostics.run_data import RunData
from ..units.quantity import prefixed
from ..units.units import SIGNALS, to_si
from .page import render

_ANALYTICAL = {"q": 0.057, "phi": 0.056, "qdot": 0.104, "qddot": 0.108}
PRINTED = {
    "analytical": _ANALYTICAL,
    "analytical-calibrated": _ANALYTICAL,
    "rbf-paper": {"q": 0.021, "phi": 0.020, "qdot": 0.041, "qddot": 0.050},
}
"""Table 2 of the paper, as fractions: of its training log; its logs and its prototype are others than these. It
does not state how far its analytical model was fitted to the prototype."""

PRINTED_PARAMETERS = (
    ("l", "mm", "90"), ("A", "mm²", "11"), ("I", "mm⁴", "1.1"), ("E", "GPa", "1.62 MPa"),
    ("rho", "g/cm³", "1.2"), ("eta", "MPa·s", "3.64"), ("m", "g", "40"), ("left.a", "mm", "32"),
    ("left.b", "mm", "23"), ("left.a0", "mm", "11, under the beam"), ("left.e_x", "mm", "7"),
    ("left.e_z", "mm", "16"), ("left.l0", "mm", "51"), ("left.n", "1", "8"),
    ("left.d0", "µm", "50"), ("left.A0", "mm²", "1326"), ("left.eps_r", "1", "2.8"),
    ("left.beta", "1", "not given"), ("g", "m/s²", "not given"), ("left.Y", "MPa", "1.2"),
    ("left.Y_MW", "MPa", "0.31"), ("left.eta_MW", "kPa·s", "83.5"), ("left.eta_v", "kPa·s", "0.3"),
)  # fmt: skip
"""Table 1: name, unit, and the value as printed."""

CORRECTIONS = (
    ("Table 1, § 3.3", "E = 1.62 MPa", "1.62 GPa", "PETG has 1.6 to 2.1 GPa; with MPa the beam carries no load"),
    ("eq. 2", "∂w²/∂x", "(∂w/∂x)²", "axial shortening of a bent beam"),
    ("eq. 5", "signs of x_i, y_i and a0 cos φ", "those of a rigid frame with eq. 4", "pre-strain grows as b shrinks"),
    ("eq. 9", "∫ EI w''² (1 + w'²)", "½ ∫ EI w''² (1 + w'²)", "without ½ the beam never buckles at b = 20 to 30 mm"),
    ("eq. 11", "λ² + 1/λ² − 2", "λ² + 2/λ − 3", "the uniaxial state of eq. 6"),
    ("eq. 22", "first row q_m", "q̇_m", "a rate"),
    ("eq. 35", "exp(E/2σ²)", "exp(−E/2σ²)", "eq. 38 has the minus"),
    ("eq. 37", "½ g v² with g = ½ ∂C/∂q", "g v²", "the ½ stands once (eqs. 33, 40)"),
    ("Table 2", "columns q, φ, q, q", "q, φ, q̇, q̈", "dots lost"),
)
"""Corrections of the print; docs/explanation/analytical-model.md derives them."""

NOT_DRAWN = "Figures 1a, 2, 9 and 10 are drawings and photographs of the device, the network and the rig."


def table_1(parameters: JointParameters) -> list[dict[str, str]]:
    """Table 1: each parameter as printed and as used."""
    return [
        {
            "name": name.removeprefix("left."),
            "unit": unit,
            "printed": printed,
            "used": f"{parameters.value(name) / to_si(unit, (QUANTITIES[name].unit,), name).factor:.5g}",
        }
        for name, unit, printed in PRINTED_PARAMETERS
    ]


def table_2(scores: Iterable[Mapping[str, Any]]) -> list[dict[str, Any]]:
    """Table 2 from the rows of the scores.

    For each log, model and signal the NRMSE (a fraction; None: diverged), and the printed one if any.

    The paper prints errors of its training log (figure 12) and none of its validation log.
    """
    rows: dict[tuple[str, str, str], dict[str, Any]] = {}
    for score in scores:
        key = (str(score["role"]), str(score["log"]), str(score["model"]))
        row = rows.setdefault(key, dict(zip(("role", "log", "model"), key, strict=True)))
        row[str(score["signal"])] = None if score["nrmse"] is None else float(score["nrmse"])
    for row in rows.values():
        printed = PRINTED.get(row["model"], {}) if row["role"] == "train" else {}
        row |= {f"printed_{signal}": printed.get(signal) for signal in SIGNALS}
    order = {"train": 0, "validation": 1}
    return sorted(rows.values(), key=lambda row: (order[row["role"]], row["log"]))


def paper_page(
    name: str,
    pictures: Mapping[str, bytes],
    parameters: Sequence[Mapping[str, str]],
    scores: Sequence[Mapping[str, Any]],
    data: RunData,
    parameter_set: str,
) -> str:
    """The page of a run with the set that the settings call `parameter_set`.

    `pictures` are SVG files by title, which are shown as images, so that nothing in them can run.

    Parameters
    ----------
    name : str
        Name of the prototype.
    pictures : mapping of str to bytes
        SVG files by title.
    parameters : sequence of mapping
        Rows of `table_1`.
    scores : sequence of mapping
        Rows of `table_2`.
    data : RunData
        The run of the recipe.
    parameter_set : str
        Name of the parameter set in the settings.
    """
    images = [
        {"title": title, "source": f"data:image/svg+xml;base64,{base64.b64encode(svg).decode()}"}
        for title, svg in pictures.items()
    ]
    network = data.descriptions["rbf-paper"]
    return render(
        "paper.html.j2",
        (),
        {
            "name": name,
            "parameter_set": parameter_set,
            "images": images,
            "parameters": parameters,
            "rows": [table_2_row(row) for row in scores],
            "corrections": CORRECTIONS,
            "not_drawn": NOT_DRAWN,
            "lag_ms": f"{1e3 * float(network['lag_s']):.3g}",
            "rank": f"{network['rank']} of {network['parameters']}",
            "condition": f"{float(network['condition']):.3g}",
        },
    )


def table_2_row(row: Mapping[str, Any]) -> dict[str, Any]:
    """A row of Table 2 in percent, as texts: log, model, and for each signal the computed and the printed error.

    The printed one is empty where the paper has none.
    """
    return {
        "log": f"{row['role']}, {row['log']}",
        "model": row["model"],
        "cells": [
            (prefixed(row[signal], "%", 2, "diverged"), prefixed(row[f"printed_{signal}"], "%", 1, ""))
            for signal in SIGNALS
            if signal in row
        ],
    }
