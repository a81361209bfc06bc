"""The page of two runs side by side, and the page "the paper and this joint".

The latter has figures and tables under the paper's numbers, printed values beside computed ones.
"""

import base64
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from pipeline.device_facts.characteristics import POINTS, Curves, curves_from
from pipeline.device_facts.run_data import RunData
from pipeline.errors import InputError
from pipeline.joint.parameters import JointParameters
from pipeline.models.base import HasCurves
from pipeline.names import log_title
from pipeline.numerics.metrics import fit_percent
from pipeline.reporting.canvas import page_chart
from pipeline.reporting.figure import Figure, Line, Panel
from pipeline.reporting.legend import swatches
from pipeline.reporting.page import json_for_script, render, viewer_data
from pipeline.reporting.tables import HEADINGS
from pipeline.si_prefix import percent
from pipeline.units import SIGNALS

_COMPARED = ("q", "qdot", "qddot")
LONGEST_TEXT = 60


@dataclass(frozen=True)
class DiffRow:
    """Texts of one row; `apart` marks it."""

    cells: tuple[str, ...]
    apart: bool = False


def diff_page(found: Any, one: RunData, other: RunData) -> str:
    """The page as HTML; `found` is the comparison (`pipeline.tools.diff.RunDifference`)."""
    names = found.names
    unlike = {change.key for change in found.sources if None not in (change.one, change.other)}
    figures = overlays(one, other, names, unlike)
    charts = [f for f in (curves_figure(one, other, names),) if f is not None]
    context = {
        "title": f"{names[0]} and {names[1]}",
        "notes": [
            *notes(found),
            *(f"Free runs on {x} are not drawn: the raw logs differ." for x in sorted(unlike)),
        ],
        "tables": [
            ("Settings", ("key", *names), [change_row(change) for change in found.settings]),
            ("Versions", ("package", *names), [change_row(change) for change in found.versions]),
            ("Raw logs (SHA-256)", ("log", *names), [change_row(change) for change in found.sources]),
            ("NRMSE of free runs", ("log", "model", "signal", *names, "ratio"), score_rows(found)),
            ("Artifacts that differ", ("artifact", "state", "deviation", "in"), artifact_rows(found)),
        ],
        "views": [{"figure": f, "legend": swatches(f, names), "axis": f.name} for f in figures],
        "charts": [{"figure": f, "drawings": page_chart(f, names), "legend": swatches(f, names)} for f in charts],
        "viewer_json": json_for_script(viewer_data(figures, names)),
    }
    return render("diff.html.j2", ("series.js", "viewer.js"), context)


def change_row(change: Any) -> DiffRow:
    """One key with both values."""
    return DiffRow((change.key, _text(change.one), _text(change.other)))


def score_rows(found: Any) -> list[DiffRow]:
    """The scores that differ by more than rounding, as rows of texts."""
    rows = []
    for pair in found.scores:
        changed = pair.one != pair.other and (pair.ratio is None or abs(pair.ratio - 1.0) > 1e-6)
        if pair.signal in _COMPARED and changed:
            place = (log_title(pair.role, pair.log), pair.model, HEADINGS[pair.signal])
            ratio = "–" if pair.ratio is None else f"{pair.ratio:.3g}"
            apart = pair.ratio is None or not 0.9 < pair.ratio < 1.1
            rows.append(DiffRow((*place, percent(pair.one), percent(pair.other), ratio), apart))
    return rows


def notes(found: Any) -> list[str]:
    """What only one of the runs has, in sentences."""
    sentences = [
        f"Only {name} has the models {', '.join(models)}."
        for name, models in zip(found.names, found.only, strict=True)
        if models
    ]
    missing = sum(c.state == "missing" for c in found.artifacts)
    return sentences + ([f"{missing} artifacts are in one of the runs only."] if missing else [])


def artifact_rows(found: Any) -> list[DiffRow]:
    """The artifacts of both runs whose content differs, as rows of texts."""
    return [
        DiffRow(
            (c.artifact, c.state, "" if c.deviation is None else f"{c.deviation:.1e}", c.column), c.state == "differs"
        )
        for c in found.artifacts
        if c.state not in ("equal", "missing", "drawn")
    ]


def _text(value: Any) -> str:
    if value is None:
        return "–"
    text = ", ".join(map(str, value)) if isinstance(value, list | tuple) else str(value)
    return text if len(text) <= LONGEST_TEXT else f"{text[:LONGEST_TEXT]}…"


def overlays(one: RunData, other: RunData, names: tuple[str, str], unlike: Collection[str]) -> list[Figure]:
    """Measured q with the free runs of both headline models, for every log that both have and that is not `unlike`."""
    known = {(log.role, log.name): log for log in other.logs}
    figures = []
    for log in one.logs:
        twin = known.get((log.role, log.name))
        if twin is None or f"{log.role}/{log.name}" in unlike:
            continue
        lines = [Line("measured", "measured", log.kinematics["t"], log.kinematics["q"], wide=True)]
        for name, data, each in ((names[0], one, log), (names[1], other, twin)):
            model = data.model_names[0]
            if model in each.predictions:
                free = each.predictions[model]["q"]
                fit = fit_percent(each.kinematics["q"], free)
                note = "diverged" if fit is None else f"fit {fit:.1f} %"
                lines.append(Line(f"{name}, {model}: {note}", name, each.kinematics["t"], free))
        panel = Panel("q", one.displacement, tuple(lines))
        caption = "Free runs of the headline models; fit = 100 (1 − ‖error‖/‖q − mean‖) %."
        figures.append(Figure(f"{log.key}-overlay", log.title.capitalize(), caption, "time", "s", (panel,)))
    return figures


def curves_figure(one: RunData, other: RunData, names: tuple[str, str]) -> Figure | None:
    """Restoring force, damping and forces of the inputs of both headline models over the range that both have seen."""
    q = [np.concatenate([log.kinematics["q"] for log in data.role("train")]) for data in (one, other)]
    grid = np.linspace(max(map(np.nanmin, q)), min(map(np.nanmax, q)), POINTS)
    curves = [_curves(data, grid) for data in (one, other)]
    if curves[0] is None or curves[1] is None or curves[0].squared != curves[1].squared or grid[-1] <= grid[0]:
        return None
    panels = [("restoring force F", "N", [c.force for c in curves if c])]
    if all(c is not None and c.damping is not None for c in curves):
        panels.append(("damping d", "N s/m", [c.damping for c in curves if c and c.damping is not None]))
    for k in range(min(len(c.pushes) for c in curves if c)):
        unit = "N/V²" if curves[0].squared else "N/V"
        title = f"force per v{k + 1}{'²' if curves[0].squared else ''}"
        panels.append((title, unit, [c.pushes[k] for c in curves if c]))
    drawn = tuple(
        Panel(title, unit if one.mass_known and one.displacement == "m" else "1",
              tuple(Line(name, name, grid, y) for name, y in zip(names, values, strict=True)))
        for title, unit, values in panels
    )  # fmt: skip
    caption = "Headline models over the range of q that both training sets have."
    return Figure("curves", "Characteristic curves", caption, "q", one.displacement, drawn, columns=2)


def _curves(data: RunData, grid: Any) -> Curves | None:
    model = data.models.get(data.model_names[0])
    if model is None or not isinstance(model, HasCurves):
        return None
    try:
        return curves_from(model.curves(grid), grid)
    except (InputError, KeyError):
        return None


PRINTED = {
    "analytical-calibrated": {"q": 0.057, "phi": 0.056, "qdot": 0.104, "qddot": 0.108},
    "rbf-paper": {"q": 0.021, "phi": 0.020, "qdot": 0.041, "qddot": 0.050},
}
"""Table 2 of the paper, as fractions; its logs and its prototype are others than these."""

PRINTED_PARAMETERS = (
    ("l", "mm", 1e3, "90"), ("A", "mm²", 1e6, "11"), ("I", "mm⁴", 1e12, "1.1"), ("E", "GPa", 1e-9, "1.62 MPa"),
    ("rho", "g/cm³", 1e-3, "1.2"), ("eta", "MPa·s", 1e-6, "3.64"), ("m", "g", 1e3, "40"), ("left.a", "mm", 1e3, "32"),
    ("left.b", "mm", 1e3, "23"), ("left.a0", "mm", 1e3, "11, under the beam"), ("left.e_x", "mm", 1e3, "7"),
    ("left.e_z", "mm", 1e3, "16"), ("left.l0", "mm", 1e3, "51"), ("left.n", "1", 1.0, "8"),
    ("left.d0", "µm", 1e6, "50"), ("left.A0", "mm²", 1e6, "1326"), ("left.eps_r", "1", 1.0, "2.8"),
    ("left.beta", "1", 1.0, "not given"), ("g", "m/s²", 1.0, "not given"), ("left.Y", "MPa", 1e-6, "1.2"),
    ("left.Y_MW", "MPa", 1e-6, "0.31"), ("left.eta_MW", "kPa·s", 1e-3, "83.5"), ("left.eta_v", "kPa·s", 1e-3, "0.3"),
)  # fmt: skip
"""Table 1: name, unit, factor from SI, and the value as printed."""

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
"""Where the print is not followed; the derivations stand in docs/explanation/analytical-model.md."""

NOT_DRAWN = "Figures 1a, 2, 9 and 10 are drawings and photographs of the device, the network and the rig."


def table_1(parameters: JointParameters) -> list[dict[str, str]]:
    """Table 1: each parameter as printed and as used."""
    return [
        {
            "name": name.removeprefix("left."),
            "unit": unit,
            "printed": printed,
            "used": f"{factor * parameters.value(name):.5g}",
        }
        for name, unit, factor, printed in PRINTED_PARAMETERS
    ]


def table_2(data: RunData) -> list[dict[str, Any]]:
    """Table 2: for each log, model and signal the NRMSE (a fraction; None: diverged), and the printed one if any."""
    rows: dict[tuple[str, str, str], dict[str, Any]] = {}
    for score in data.scores:
        key = (str(score["role"]), str(score["log"]), str(score["model"]))
        row = rows.setdefault(key, dict(zip(("role", "log", "model"), key, strict=True)))
        row[str(score["signal"])] = None if score["nrmse"] is None else float(score["nrmse"])
    for row in rows.values():
        printed = PRINTED.get(row["model"], {})
        row |= {f"printed_{signal}": printed.get(signal) for signal in SIGNALS}
    order = {"train": 0, "validation": 1}
    return sorted(rows.values(), key=lambda row: (order[row["role"]], row["log"]))


def paper_page(
    name: str,
    pictures: Mapping[str, bytes],
    parameters: Sequence[Mapping[str, str]],
    scores: Sequence[Mapping[str, Any]],
    data: RunData,
) -> str:
    """The page; `pictures` are SVG files by title, which are shown as images, so that nothing in them can run."""
    images = [
        {"title": title, "source": f"data:image/svg+xml;base64,{base64.b64encode(svg).decode()}"}
        for title, svg in pictures.items()
    ]
    network = data.descriptions["rbf-paper"]
    context = {
        "name": name,
        "parameter_set": data.provenance["prototype"]["plant"]["parameters"],
        "images": images,
        "parameters": parameters,
        "rows": [_shown(row) for row in scores],
        "corrections": CORRECTIONS,
        "not_drawn": NOT_DRAWN,
        "lag_ms": f"{1e3 * float(network['lag_s']):.3g}",
        "rank": f"{network['rank']} of {network['parameters']}",
        "condition": f"{float(network['condition']):.3g}",
    }
    return render("paper.html.j2", (), context)


def _shown(row: Mapping[str, Any]) -> dict[str, Any]:
    cells = []
    for value, printed in ((row[signal], row[f"printed_{signal}"]) for signal in SIGNALS if signal in row):
        computed = "diverged" if value is None else f"{100.0 * value:.2f}"
        cells.append((computed, "" if printed is None else f"{100.0 * printed:.1f}"))
    return {"log": f"{row['role']}, {row['log']}", "model": row["model"], "cells": cells}
