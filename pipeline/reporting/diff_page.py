"""The page of any number of runs side by side: what differs, their curves over one another, and their free runs."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

from pipeline.numerics.arrays import FloatArray
from pipeline.reporting.canvas import page_chart
from pipeline.reporting.figure import Figure, Line, Panel
from pipeline.reporting.legend import swatches
from pipeline.reporting.page import render

CURVES = {"F": "restoring force F", "d": "damping d", "dC1_dq": "∂C₁/∂q", "dC2_dq": "∂C₂/∂q"}
"""Curves that are drawn, and their names."""


@dataclass(frozen=True)
class DiffTable:
    """What differs in one part: its title, the heading of its keys, and a row of texts for each key."""

    title: str
    head: str
    rows: Sequence[Sequence[str]]


@dataclass(frozen=True)
class DrawnRun:
    """What is drawn of a run.

    Attributes
    ----------
    name : str
    displacement : str
        Unit of q.
    q : FloatArray, shape (n,)
        Where the curves are given.
    curves : mapping of str to FloatArray, shape (n,)
        F, d, dC1_dq, dC2_dq of the headline, as far as it has them.
    units : mapping of str to str
        Of the curves.
    logs : mapping of (str, str) to (FloatArray, FloatArray, FloatArray)
        Time, measured displacement and that of the free run for each log; the key has its title and its content hash.
    """

    name: str
    displacement: str
    q: FloatArray
    curves: Mapping[str, FloatArray]
    units: Mapping[str, str]
    logs: Mapping[tuple[str, str], tuple[FloatArray, FloatArray, FloatArray]]


def diff_page(names: Sequence[str], tables: Sequence[DiffTable], runs: Sequence[DrawnRun]) -> str:
    """The page as HTML; the same runs give the same bytes."""
    figures = [*_curves(runs), *_free_runs(runs)]
    charts = [
        {"figure": each, "drawings": page_chart(each, names), "legend": swatches(each, names, marks=True)}
        for each in figures
    ]
    return render("diff.html.j2", (), {"names": names, "tables": tables, "charts": charts})


def _curves(runs: Sequence[DrawnRun]) -> Iterator[Figure]:
    panels = []
    for key, title in CURVES.items():
        having = [run for run in runs if key in run.curves]
        for unit in dict.fromkeys(run.units[key] for run in having):  # forces per unit mass are no forces
            lines = (Line(run.name, run.name, run.q, run.curves[key]) for run in having if run.units[key] == unit)
            panels.append(Panel(title, unit, tuple(lines)))
    if panels:
        caption = "Of the headline model of each run, over the range of its training logs."
        yield Figure("curves", "Characteristic curves", caption, "q", runs[0].displacement, tuple(panels), columns=2)


def _free_runs(runs: Sequence[DrawnRun]) -> Iterator[Figure]:
    for number, key in enumerate(dict.fromkeys(key for run in runs for key in run.logs)):
        having = [run for run in runs if key in run.logs]
        t, measured, _ = having[0].logs[key]
        lines = [Line("measured", "measured", t, measured, wide=True)]
        lines += [Line(run.name, run.name, run.logs[key][0], run.logs[key][2]) for run in having]
        panel = Panel("q", having[0].displacement, tuple(lines))
        yield Figure(f"log-{number}", f"Free runs of the {key[0]}", "Measured and simulated.", "t", "s", (panel,))
