"""The page of two runs side by side: what differs, and both headline models' free runs and curves over each other."""

from collections.abc import Collection
from dataclasses import dataclass
from typing import Any

import numpy as np

from pipeline.device_facts.characteristics import POINTS, Curves, curves_from
from pipeline.device_facts.run_data import RunData
from pipeline.errors import InputError
from pipeline.models.base import HasCurves
from pipeline.names import log_title
from pipeline.reporting.canvas import page_chart
from pipeline.reporting.figure import Figure, Line, Panel
from pipeline.reporting.legend import swatches
from pipeline.reporting.log_figures import FIT, fit_note
from pipeline.reporting.page import json_for_script, render, viewer_data
from pipeline.reporting.tables import HEADINGS
from pipeline.runs.comparison import Change, RunDifference
from pipeline.si_prefix import percent

_COMPARED = ("q", "qdot", "qddot")
LONGEST_TEXT = 60


@dataclass(frozen=True)
class DiffRow:
    """Texts of one row; `apart` marks it."""

    cells: tuple[str, ...]
    apart: bool = False


def diff_page(found: RunDifference, one: RunData, other: RunData) -> str:
    """The page as HTML."""
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


def change_row(change: Change) -> DiffRow:
    """One key with both values."""
    return DiffRow((change.key, _text(change.one), _text(change.other)))


def score_rows(found: RunDifference) -> list[DiffRow]:
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


def notes(found: RunDifference) -> list[str]:
    """What only one of the runs has, in sentences."""
    sentences = [
        f"Only {name} has the models {', '.join(models)}."
        for name, models in zip(found.names, found.only, strict=True)
        if models
    ]
    if not found.scores:
        sentences.append("No log and model are in both runs, so there are no free runs to compare.")
    missing = sum(c.state == "missing" for c in found.artifacts)
    return sentences + ([f"{missing} artifacts are in one of the runs only."] if missing else [])


def artifact_rows(found: RunDifference) -> list[DiffRow]:
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
                note = fit_note(each.kinematics["q"], free)
                lines.append(Line(f"{name}, {model}: {note}", name, each.kinematics["t"], free))
        panel = Panel("q", one.displacement, tuple(lines))
        caption = f"Free runs of the headline models; {FIT}."
        figures.append(Figure(f"{log.key}-overlay", log.title.capitalize(), caption, "time", "s", (panel,)))
    return figures


def curves_figure(one: RunData, other: RunData, names: tuple[str, str]) -> Figure | None:
    """Restoring force, damping and forces of the inputs of both headline models over the range that both have seen."""
    q = [np.concatenate([log.kinematics["q"] for log in data.role("train")]) for data in (one, other)]
    grid = np.linspace(max(map(np.nanmin, q)), min(map(np.nanmax, q)), POINTS)
    curves = [_curves(data, grid) for data in (one, other)]
    units = one.curve_units
    if curves[0] is None or curves[1] is None or units != other.curve_units or grid[-1] <= grid[0]:
        return None
    panels = [("restoring force F", units["F"], [c.force for c in curves if c])]
    if all(c is not None and c.damping is not None for c in curves):
        panels.append(("damping d", units["d"], [c.damping for c in curves if c and c.damping is not None]))
    for k in range(min(len(c.pushes) for c in curves if c)):
        title = f"force per v{k + 1}{'²' if curves[0].squared else ''}"
        panels.append((title, units["g"], [c.pushes[k] for c in curves if c]))
    drawn = tuple(
        Panel(title, unit, tuple(Line(name, name, grid, y) for name, y in zip(names, values, strict=True)))
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
