"""A run of a fifth of a second with artifacts of every kind: Parquet, HDF5, JSON, HTML, SVG, PDF."""

from collections.abc import Callable, Iterator, Mapping
from contextlib import ExitStack, contextmanager
from dataclasses import replace
from pathlib import Path
from typing import Any
from unittest.mock import patch

from pipeline.store.run_folder import RunFolder, Written
from pipeline.workflow import stage_report as report
from pipeline.workflow.run import run_prototype, run_stage
from tests.prototypes import Silent, motion, settings, write_csv


def write_prototype(folder: Path) -> Path:
    """Two short logs of a double well, and their settings file."""
    for name, seed in (("train", 1), ("validation", 2)):
        write_csv(folder / f"{name}.csv", *motion(10.0, 200.0, seed, noise=3e-6))
    prototype = folder / "small.toml"
    prototype.write_text(settings(name="small", train="train.csv", validation="validation.csv"), encoding="utf-8")
    return prototype


def make(prototype: Path, run: Path) -> None:
    """Bring the run up to date, the report with it, and the figures for a paper."""
    run_prototype(prototype, run, Silent())
    run_stage(run, "report", Silent(), figures="sans")


@contextmanager
def few_figures(*kinds: str) -> Iterator[None]:
    """Within, the figures for a paper are these of each log and the curves, since all are written alike."""
    from pipeline.reporting import log_figures

    draw = report._drawings

    def draw_some(
        run: RunFolder, *, prepared: Callable[[RunFolder], report.Prepared], typeface: Any
    ) -> Mapping[str, Written]:
        made = prepared(run)
        some = {name: figure for name, figure in made.figures.items() if name.endswith((*kinds, "curves"))}
        return draw(run, prepared=lambda _: replace(made, figures=some), typeface=typeface)

    with patch.object(log_figures, "LOG_FIGURES", kinds), patch.object(report, "_drawings", draw_some):
        yield


@contextmanager
def drawn_once(known: dict[Any, Any] | None = None) -> Iterator[None]:
    """Within, the report's page and few figures are computed at most once; they are written every time.

    `known` keeps them for the next time that this is entered for the same run.
    """
    from pipeline.reporting import log_figures, plotted, run_report

    kept = {} if known is None else known
    with ExitStack() as patches:
        patches.enter_context(few_figures(log_figures.LOG_FIGURES[0]))
        for module, name in ((report, "prepare"), (run_report, "run_report"), (plotted, "paper_figure")):
            patches.enter_context(patch.object(module, name, once(getattr(module, name), kept)))
        yield


def once(function: Callable[..., Any], known: dict[Any, Any]) -> Callable[..., Any]:
    """The function, computed once for each value of its first argument; of one run folder there is one state."""

    def remembered(first: Any, *others: Any, **named: Any) -> Any:
        key = function.__name__, "run" if isinstance(first, RunFolder) else id(first)
        if key not in known:
            known[key] = first, function(first, *others, **named)  # what is kept keeps its identity
        return known[key][1]

    return remembered
