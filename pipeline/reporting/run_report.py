"""The page of one run."""

import json
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from functools import partial
from typing import Any

from ..diagnostics.calibrated import calibrated
from ..diagnostics.check import CheckRow, beside
from ..diagnostics.datasheet import Datasheet
from ..diagnostics.grades import OF_WELLS, THRESHOLDS, Check
from ..diagnostics.run_data import WHY, RunData, judged_log
from ..scoring.wells import Wells
from ..system.names import ROLE_WORDS, shell_word, with_true_names
from ..system.worker_pool import in_processes
from ..units.quantity import counted, short
from .control_figures import control_figures
from .datasheet_rows import (
    NOT_USED,
    Described,
    calibrated_row,
    described,
    element_rows,
    sheet_rows,
    structure_summary,
)
from .device_figures import device_figures
from .figure import MARKS, Figure, swatch, swatches
from .log_figures import LOG_FIGURES, log_figures, overlay
from .page import json_for_script, render, viewer_data
from .plotted import chart
from .tables import BEST, HEADINGS, TIED, NrmseTable, TableCell, behaviour_table, main_table, nrmse_table

SECTION_TITLES = {
    "derivatives": "Derivatives",
    "models": "Measured against models",
    "residuals": "Residuals",
}


SCORES_OF_WELLS = ("well_agreement", "switch_accuracy", "outcomes")
"""Columns of the scores that only two wells give a meaning."""


def figures_of(data: RunData, sheet: Datasheet) -> dict[str, Figure]:
    """Every figure of a run by its name: those of the logs in their order, then those of the device."""
    figures = (
        overlay(data, judged_log(data), sheet.wells),
        *(figure for log in data.logs for figure in log_figures(data, log, sheet.wells).values()),
        *device_figures(data, sheet).values(),
        *control_figures(data.control).values(),
    )
    return {figure.name: figure for figure in figures}


def run_report(data: RunData, sheet: Datasheet, figures: Mapping[str, Figure], jobs: int = 1) -> str:
    """The page as HTML; the same data give the same bytes.

    Parameters
    ----------
    data : RunData
        The run.
    sheet : Datasheet
        Its datasheet.
    figures : mapping of str to Figure
        From `figures_of`.
    jobs : int
        Processes that draw the figures.
    """
    models = data.model_names
    judged = judged_log(data)
    first = figures[f"{judged.key}-overlay"]
    views = {
        f"{log.key}-{kind}": _without_q(figures[f"{log.key}-{kind}"]) for kind in SECTION_TITLES for log in data.logs
    }
    shown = {first.name, *(f"{log.key}-{kind}" for kind in LOG_FIGURES for log in data.logs)}
    charts = _charts({name: figure for name, figure in figures.items() if name not in shown}, models, jobs)
    rows = sheet_rows(sheet.facts)
    log_checks = [CheckRow(**row) for row in data.log_checks]
    check_header, check_rows = beside(log_checks)
    judged_by = {check.name for check in sheet.checks}
    two_wells = isinstance(sheet.wells, Wells)
    return render(
        "report.html.j2",
        ("uplot.min.js", "tables.js", "series.js", "viewer.js"),
        {
            "name": data.prototype.name,
            "subtitle": " · ".join((*_lengths(data), f"models {', '.join(models)}")),
            "main_model": sheet.main_model,
            "assessment": assessment(sheet.checks),
            "data_grade": sheet.grades["data"],
            "model_grade": sheet.grades["model"],
            "checks": sheet.checks,
            "facts": rows,
            "two_wells": any(len(row.cells) == 2 for row in rows),
            # Limits of wells only where there are two, or a check needs them.
            "thresholds": {
                name: limit
                for name, limit in THRESHOLDS.items()
                if two_wells or name in judged_by or name not in OF_WELLS
            },
            "facts_caption": _facts_caption(sheet),
            "log_checks": {
                "header": check_header,
                "rows": check_rows,
                "remarks": [row.remark for row in log_checks if row.state == "note"],
            },
            **_scores(data, sheet),
            "overlay": _view(first, models, judged.key),
            # Pure numbers of the beam's higher terms are left out: their names mean nothing outside the equations.
            "calibrated": [
                calibrated_row(fitted)
                for fitted in calibrated(data.models.get(sheet.main_model))
                if fitted.unit != "1" or fitted.nominal == 1.0
            ],
            "structure": structure_summary(data, sheet),
            "elements": element_rows(sheet.elements(data)),
            "timelines": [_timeline(data, views, kind) for kind in SECTION_TITLES],
            "charts": charts[""],
            "residuals": charts["residual"],
            "studies": charts["study"],
            "control": charts["control"],
            "described": [_model(data, name) for name in models],
            **_provenance(data),
            "sections": [
                ("overview", "Overview"),
                ("datasheet", "Datasheet"),
                ("logs", "Logs"),
                ("errors", "Errors"),
                *SECTION_TITLES.items(),
                ("device", "Device"),
                *([("control", "Control")] if charts["control"] else []),
                ("models-described", "Models"),
                *([("studies", "Studies")] if charts["study"] else []),
                ("provenance", "Provenance"),
            ],
            "viewer_json": json_for_script(viewer_data([first, *views.values()], models)),
        },
    )


def _charts(figures: Mapping[str, Figure], models: Sequence[str], jobs: int) -> dict[str, list[dict[str, Any]]]:
    """The figures drawn in `jobs` processes, by the kind with which their names begin; "" for those of the device."""
    charts: dict[str, list[dict[str, Any]]] = {kind: [] for kind in ("residual", "study", "control", "")}
    drawn = in_processes(partial(chart, models=models), list(figures.values()), jobs)
    for name, made in zip(figures, drawn, strict=True):
        kind = name.partition("-")[0]
        charts[kind if kind in charts else ""].append(made)
    return charts


def _lengths(data: RunData) -> Iterator[str]:
    """Number and length of the training logs, then of the validation logs."""
    for role in ("train", "validation"):
        logs = data.role(role)
        if logs:
            seconds = sum(float(log.motion.t[-1] - log.motion.t[0]) for log in logs)
            yield f"{counted(len(logs), f'{ROLE_WORDS[role]} log')}, {short(seconds, 4)} s"


def assessment(checks: Sequence[Check]) -> str:
    """The assessment in one sentence: the first of the worst findings, or that there are none."""
    for grade in ("poor", "fair"):
        if failing := [check for check in checks if check.grade == grade]:
            rest = len([check for check in checks if check.grade != "good"]) - 1
            more = f" And {rest} more below." if rest else ""
            return f"{failing[0].statement[:1].upper()}{failing[0].statement[1:]}: {failing[0].advice}.{more}"
    return "All checks are within their limits."


def _facts_caption(sheet: Datasheet) -> str:
    if sheet.model is None:
        return "Measured: mean ± standard deviation over the rests and ring-downs of all logs."
    band = "± half of its central 90 %" if sheet.model in sheet.draws else "which states no uncertainty"
    name = f"{sheet.model}{NOT_USED}" if sheet.refused else sheet.model
    return f"By {name}, {band}. Grey: measured, mean ± standard deviation · how often, and in the model's free runs."


def _scores(data: RunData, sheet: Datasheet) -> dict[str, Any]:
    """The tables of the scores; without wells, the columns on wells are left out."""
    none = {} if isinstance(sheet.wells, Wells) else dict.fromkeys(SCORES_OF_WELLS)
    scores = with_true_names(({**row, **none} for row in data.scores), [(log.role, log.source) for log in data.logs])
    tables: list[dict[str, Any]] = []
    for role in ("validation", "train"):
        rows = [row for row in scores if row["role"] == role and row["signal"] != "phi"]  # which is computed from q
        for name, table in (("nrmse", nrmse_table(rows)), ("behaviour", behaviour_table(rows))) if rows else ():
            shown = _score_table(name, table)
            if role == "train" and tables:
                title = "Errors" if name == "nrmse" else "Horizons and switches"
                shown |= {"name": f"{name}-train", "caption": "", "repeats": f"{title} on the training logs"}
            tables.append(shown)
    return {
        "score_tables": tables,
        "worst": main_table([row for row in scores if row["model"] in data.model_names]),
    }


def _score_table(name: str, table: NrmseTable) -> dict[str, Any]:
    rows = []
    for row in table.rows:
        cells = [_cell(cell) for cell in row.cells]
        for cell in cells[1 : len(table.signals)]:
            if cell["bad"]:
                cell |= {"number": "–", "interval": ""}  # when it diverged stands in the first cell
        rows.append({"log": row.log, "model": row.model, "cells": cells})
    errors = ((f"{HEADINGS[s]} [%]", "") for s in table.signals)
    return {
        "name": name,
        "headings": [("log", ""), ("model", ""), *errors, *((column.heading, column.help) for column in table.extras)],
        "rows": rows,
        "caption": table.explanation,
        "repeats": "",
    }


def _cell(cell: TableCell) -> dict[str, Any]:
    return {
        "number": cell.number + (BEST if cell.best else TIED * cell.tied),
        "interval": cell.interval,
        "best": cell.best,
        "bad": cell.diverged,
        "value": cell.number if cell.is_number else "",
    }


def _without_q(figure: Figure) -> Figure:
    """The figure as the page has it: q is drawn at its top and with the residuals, and nowhere else."""
    if figure.name.endswith("-residuals"):
        return figure
    return replace(figure, panels=tuple(panel for panel in figure.panels if panel.name != "q"))


def _timeline(data: RunData, figures: Mapping[str, Figure], kind: str) -> dict[str, Any]:
    views, repeats = (
        [_view(figures[f"{log.key}-{kind}"], data.model_names, log.key) for log in data.role(role)]
        for role in ("validation", "train")
    )
    open_views, folded = (views, repeats) if views else (repeats, [])
    return {"id": kind, "title": SECTION_TITLES[kind], "views": open_views, "repeats": folded}


def _view(figure: Figure, models: Sequence[str], axis: str) -> dict[str, Any]:
    return {
        "figure": figure,
        "legend": swatches(figure, models),
        "axis": axis,
        "events": [swatch(name, MARKS[name]) for name in figure.marks if name in MARKS],
    }


def _model(data: RunData, name: str) -> Described:
    # Deviations are the coordinates of the fit; what they mean stands among the calibrated quantities.
    hidden = {"deviations"} if data.why_chosen else {"deviations", WHY}
    facts = {key: value for key, value in data.descriptions.get(name, {}).items() if key not in hidden}
    return described(name, facts, data.device.displacement.symbol, mass_known=data.device.known_mass is not None)


def _provenance(data: RunData) -> dict[str, Any]:
    provenance = data.provenance
    # The page does not name its own folder: equal runs have equal pages wherever they lie.
    studies = [f"debist study {study.name} RUN" for study in data.studies]
    # A study is drawn by the report that follows it.
    again = [*studies, "debist report RUN"] if studies else []
    return {
        "commands": [f"debist run {shell_word(provenance['prototype_file'])} -o RUN", *again, "debist verify RUN"],
        "sources": provenance["sources"],
        "artifacts": provenance["artifacts"],
        "versions": sorted(provenance["versions"].items()),
        "version": provenance["versions"].get("debist", "of unknown version"),
        "settings": json.dumps(provenance["prototype"], indent=1, ensure_ascii=False),
    }
