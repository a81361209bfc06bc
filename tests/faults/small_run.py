"""A run of a fifth of a second with artifacts of every kind: Parquet, HDF5, JSON, HTML, SVG, PDF."""

import json
import os
from collections.abc import Callable, Iterator, Mapping
from contextlib import ExitStack, contextmanager
from dataclasses import replace
from pathlib import Path
from typing import Any
from unittest.mock import patch

import numpy as np

from pipeline.rig.double_well import DoubleWell
from pipeline.rig.excitation import command, random_excitation
from pipeline.rig_logs import guarded
from pipeline.runs.engine import Task
from pipeline.runs.manifest import load_manifest
from pipeline.runs.run_folder import RunFolder, Written
from pipeline.stages import report
from pipeline.stages.run import run_prototype, run_stage

_RATE, _DURATION = 200.0, 10.0
_TOML = """\
name = "small"
[logs]
train = ["train.csv"]
validation = ["validation.csv"]
[channels]
time = { channel = "time", unit = "s" }
q = { channel = "q", unit = "mm" }
v1 = { channel = "v1", unit = "kV" }
v2 = { channel = "v2", unit = "kV" }
[identify]
models = ["rbf-paper"]
[compare]
models = []
"""


class Silent:
    """An observer that listens only."""

    def started(self, task: Task, reasons: list[str]) -> None: ...

    def finished(self, task: Task, seconds: float) -> None: ...

    def skipped(self, task: Task) -> None: ...

    def warned(self, task: Task, warning: str) -> None: ...

    def progressed(self, task: Task, what: str, share: float) -> None: ...


def write_prototype(folder: Path) -> Path:
    """Two short logs of a double well, and their settings file."""
    t, device = np.arange(_RATE * _DURATION) / _RATE, DoubleWell()
    for name, seed in (("train", 1), ("validation", 2)):
        rng = np.random.default_rng(seed)
        v = command(random_excitation(rng, duration=_DURATION, excitation="training"), t)
        q = device.simulate(v, 1.0 / _RATE) + rng.normal(0.0, 3e-6, t.size)
        table = np.column_stack([t, q * 1e3, v * 1e-3])
        np.savetxt(folder / f"{name}.csv", table, fmt="%.6f", delimiter=",", header="time,q,v1,v2", comments="")
    prototype = folder / "small.toml"
    prototype.write_text(_TOML, encoding="utf-8")
    return prototype


def make(prototype: Path, run: Path) -> None:
    """Bring the run up to date, the report with it, and the figures for a paper."""
    run_prototype(prototype, run, Silent())
    run_stage(run, "report", Silent(), figures="sans")


def content(run: Path) -> dict[str, str]:
    """Content hash of every artifact."""
    return {name: record.content_hash for name, record in load_manifest(run).artifacts.items()}


@contextmanager
def few_figures(*kinds: str) -> Iterator[None]:
    """Within, the figures for a paper are these of each log and the curves, since all are written alike."""
    from pipeline.reporting import log_figures

    draw = report._drawings

    def draw_some(run: RunFolder, made: report.Prepared, typeface: Any) -> Mapping[str, Written]:
        some = {name: figure for name, figure in made.figures.items() if name.endswith((*kinds, "curves"))}
        return draw(run, replace(made, figures=some), typeface)

    with patch.object(log_figures, "LOG_FIGURES", kinds), patch.object(report, "_drawings", draw_some):
        yield


@contextmanager
def drawn_once() -> Iterator[None]:
    """Within, the report's page and few figures are computed at most once; they are written every time."""
    from pipeline.reporting import canvas, log_figures, run_report

    with ExitStack() as patches:
        patches.enter_context(few_figures(log_figures.LOG_FIGURES[0]))
        for module, name in ((report, "prepare"), (run_report, "run_report"), (canvas, "paper_figure")):
            patches.enter_context(patch.object(module, name, _once(getattr(module, name))))
        yield


@contextmanager
def read_once() -> Iterator[None]:
    """Within, a log is parsed by a guarded child once; later its answer and its samples are given again."""
    first, known = guarded._run_child, dict[str, tuple[Any, bytes]]()

    def run_child(request: dict[str, Any], timeout: float) -> Any:
        key = json.dumps([request["path"], request["channels"]])
        if key not in known:
            done = first(request, timeout)
            known[key] = done, os.pread(request["data_fd"], os.fstat(request["data_fd"]).st_size, 0)
        else:
            os.pwrite(request["data_fd"], known[key][1], 0)
        return known[key][0]

    with patch("pipeline.rig_logs.guarded._run_child", run_child):
        yield


def _once(function: Callable[..., Any]) -> Callable[..., Any]:
    """The function, computed once for each value of its first argument; of one run folder there is one state."""
    known: dict[Any, Any] = {}

    def remembered(first: Any, *others: Any, **named: Any) -> Any:
        key = "run" if isinstance(first, RunFolder) else id(first)
        if key not in known:
            known[key] = first, function(first, *others, **named)  # what is kept keeps its identity
        return known[key][1]

    return remembered
