"""A run for notebooks and scripts: scores, signals, models, free runs, figures.

Everything is in SI units; matplotlib is loaded with the first figure.

Examples
--------
>>> import debist
>>> run = debist.open_run("runs/P1")  # doctest: +SKIP
>>> run.scores()  # doctest: +SKIP
>>> run.simulate("hybrid", "validation").plot("t_s", ["q_m", "q_measured_m"])  # doctest: +SKIP
"""

import difflib
from collections.abc import Sequence
from dataclasses import asdict
from functools import cached_property, partial
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

import numpy as np
import pandas as pd

from ..device.parameters import parameter_set
from ..diagnostics.check import check_rows
from ..errors import InputError
from ..models.base import real_numbers
from ..models.free_runs import drawn_runs, free_run, wanted_tubes
from ..settings.prototype import Prototype
from ..signals.differentiate import differentiate as differentiated
from ..store import layout
from ..store.run_folder import RunFolder, in_snapshot
from ..system.machine import one_thread
from ..workflow.engine import Unheard
from ..workflow.inspection import check as check_tool
from ..workflow.place import load_settings
from ..workflow.report_data import instruments_shown, load_datasheet, load_scores
from ..workflow.run_contents import (
    compared_models,
    identified_models,
    load_motion,
    load_run_model,
    made_control,
    subject,
)
from ..workflow.si_log import read_si
from ..workflow.stage_validate import scored_models
from .in_memory import OF_RUN, frame, free_run_frame, seconds, si_symbols
from .model import Model, identify

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from numpy.typing import ArrayLike

    from ..control.plant import LinearModel
    from ..reporting.figure import Figure
    from ..workflow.stage_report import Prepared


_EVEN = 1e-3
"""Share of the interval by which a step of uniform times may differ from it."""


def read_log(log: str | Path, settings: str | Path) -> pd.DataFrame:
    """A raw log of any format that debist reads, by the channels and units of a settings file.

    Parameters
    ----------
    log : str or Path
        The log; it need not be one of the settings.
    settings : str or Path
        Settings file of a prototype, as `debist init` drafts it.

    Returns
    -------
    pandas.DataFrame
        Columns t_s, q_m (q_rad), v1_V and v2_V at the stamps of q, as `identify` and `Model.score` take them; q_m of
        a joint whose angle is logged. Inputs
        with stamps of their own are interpolated; rows in which a value is missing are left out, and nothing is masked.

    Raises
    ------
    InputError
        The settings have mistakes, or the log cannot be read or lacks a channel.
    """
    prototype = load_settings(Path(settings))
    signals = read_si(Path(log), prototype, parameter_set(prototype, Path(settings)))
    t, q = signals.q
    columns = {"t": t, "q": q}
    for name, (own, samples) in signals.beside.items():
        finite = np.isfinite(own) & np.isfinite(samples)
        columns[name] = samples if own is t else np.interp(t, own[finite], samples[finite], left=np.nan, right=np.nan)
    columns.pop("velocity", None)
    return frame({name: np.asarray(column) for name, column in columns.items()}, *si_symbols(prototype)).dropna(
        ignore_index=True
    )


@one_thread
def check(place: str | Path) -> pd.DataFrame:
    """Findings of `debist check` in the logs of a settings file, or of a run folder.

    Returns
    -------
    pandas.DataFrame
        A row for each check: log, what, found, limit, state (ok, note, wrong, not seen), gate, advice, more,
        values, a dict of numbers with the SI unit in the key, and the code of the finding.

    Raises
    ------
    DebistError
        Bad settings, or a log that cannot be read or that ingest refuses.
    """
    _, findings = check_tool(Path(place), Unheard())
    return pd.DataFrame([asdict(row) for row in check_rows(findings)])


@one_thread
def differentiate(
    t: "ArrayLike",
    q: "ArrayLike",
    *,
    method: Literal["tvregdiff", "savitzky-golay"] = "tvregdiff",
    order: Literal[1, 2, 3, 4] = 3,
    alpha: float | None = None,
    epsilon: float | None = None,
) -> pd.DataFrame:
    """Velocity and acceleration of a displacement at uniform times, as a run differentiates it.

    Parameters
    ----------
    t, q : array_like, shape (N,)
        Uniform times [s] and displacement [m, or any unit], without gaps.
    method, order, alpha, epsilon
        As of `pipeline.signals.differentiate.differentiate`; α and ε are chosen by the noise if both are left out.

    Returns
    -------
    pandas.DataFrame
        Columns t_s, q (smoothed), qdot and qddot, in the unit of q, per s and per s²; ``attrs`` hold alpha, epsilon
        and the noise.

    Raises
    ------
    InputError
        Columns that differ in length, times that are not uniform, or samples that are not finite.
    """
    times = seconds(t)
    samples = real_numbers(q, "q")
    if times.ndim != 1 or times.shape != samples.shape or times.size < 2:
        raise InputError(f"t has the shape {times.shape}, q {samples.shape}; give columns of one length, shape (N,)")
    interval = float(times[-1] - times[0]) / (times.size - 1)
    if not np.all(np.abs(np.diff(times) - interval) <= _EVEN * interval):
        raise InputError("t is not uniform; interpolate q, or split it at its gaps")
    rates = differentiated(samples, interval, method=method, order=order, alpha=alpha, epsilon=epsilon)
    table = pd.DataFrame({"t_s": times, "q": rates.q_smooth, "qdot": rates.qdot, "qddot": rates.qddot})
    table.attrs = {"alpha": rates.alpha, "epsilon": rates.epsilon, "noise_std": rates.noise_std}
    return table


def compare(models: Sequence[Model], log: Any) -> pd.DataFrame:
    """Scores of several models on one log, a DataFrame as `Model.score` takes it; the column model comes first.

    Raises
    ------
    InputError
        No model, or a log that does not fit one of them.
    """
    if not isinstance(models, Sequence) or not models or not all(isinstance(model, Model) for model in models):
        raise InputError(f"models is {models!r}; give a list of the models that are compared, as [first, second]")
    tables = [model.score(log) for model in models]
    for model, table in zip(models, tables, strict=True):
        table.insert(0, "model", model.name)
    return pd.concat(tables, ignore_index=True)


__all__ = ["Model", "Run", "check", "compare", "differentiate", "identify", "open_run", "read_log"]


def open_run(folder: str | Path) -> "Run":
    """Open a run folder.

    Raises
    ------
    InputError
        There is no run in the folder.
    """
    run = Run(Path(folder))
    _ = run._folder
    return run


class Run:
    """A run folder; made by `open_run`.

    Parameters
    ----------
    root : Path
        The folder.
    """

    def __init__(self, root: Path) -> None:
        self.root = root

    def __repr__(self) -> str:
        return f"Run({str(self.root)!r}, logs={self.logs}, models={self.models})"

    @property
    def name(self) -> str:
        """Name of the prototype."""
        return self._prototype.name

    @property
    def logs(self) -> list[str]:
        """Names of the logs, training logs first."""
        return [log for _, log, _ in layout.logs(self._prototype)]

    @property
    def models(self) -> list[str]:
        """Names of the identified models, the main model first, and of the baselines that the run holds."""
        source = (self._folder, self._prototype)
        return [*identified_models(*source), *compared_models(*source)]

    @property
    def figures(self) -> dict[str, str]:
        """Title of each figure by its name."""
        return {name: figure.title for name, figure in self._report.figures.items()}

    def scores(self) -> pd.DataFrame:
        """One row per log, model and signal; `nrmse` is a fraction."""
        return pd.DataFrame(load_scores(self.root))

    @property
    def instruments(self) -> pd.DataFrame:
        """Errors of the instruments of each log, one row per log, model and quantity."""
        return pd.DataFrame(instruments_shown(self.root)[0])

    def log(self, name: str) -> pd.DataFrame:
        """Signals of a log: t_s, q_m (q_rad), v1_V, v2_V, segment, qdot_m_per_s, qddot_m_per_s2; NaN where masked.

        `Model.score` scores it as the report does, gaps included.

        Where a training and a validation log share a name it is that of the validation log.

        Raises
        ------
        InputError
            The run has no such log.
        """
        role = self._role(name)
        table = frame(self._folder.read_table(layout.kinematics(role, name)), *self._units)
        table.attrs[OF_RUN] = (str(self.root.absolute()), role, name)
        return table

    def model(self, name: str | None = None) -> Model:
        """A model, the main model if none is named.

        Raises
        ------
        InputError
            The run holds no such model.
        """
        source = self._folder, self._prototype, name
        return Model(load_run_model(*source), self._prototype, subject=partial(subject, *source))

    @one_thread
    def simulate(self, model: str | None = None, log: str | None = None, *, tube: bool = False) -> pd.DataFrame:
        """Free run of a model, by default the main one, under the measured voltages of a log, by default the last one.

        Parameters
        ----------
        model, log : str, optional
            Their names.
        tube : bool
            With the 90 % tubes of q, for a model that has them (`hybrid`, `rbf`).

        Returns
        -------
        pandas.DataFrame
            t_s, q_m, qdot_m_per_s, qddot_m_per_s2 (rad for an angle), the voltages, and q_measured_m; NaN after a
            divergence. With tubes q_low_m, q_high_m, and q_other_low_m, q_other_high_m where the model is not sure of
            the well. ``attrs`` holds ``status`` and ``diverged_at_s``.

        Raises
        ------
        InputError
            No such model or log, or a model without tubes.
        """
        name = log or self.logs[-1]
        measured = load_motion(self._folder, self._prototype, self._role(name), name)
        core = self.model(model).core
        run = free_run(measured, core)
        tubes = wanted_tubes(run.q, drawn_runs(measured, core), core) if tube else {}
        return free_run_frame(run, tubes, measured.v, self._units, q_measured=measured.q)

    def datasheet(self) -> dict[str, Any]:
        """The document ``datasheet.json``."""
        return load_datasheet(self.root)

    def plot(
        self,
        figure: str,
        *,
        start: float | None = None,
        stop: float | None = None,
        models: Sequence[str] = (),
        typeface: Literal["sans", "serif"] = "sans",
    ) -> "list[Axes]":
        """One of the report's figures, which `figures` names, as matplotlib's axes, from the top.

        Parameters
        ----------
        figure : str
            Its name.
        start, stop : float, optional
            Segment of the horizontal axis, in SI (times in s).
        models : sequence of str
            The models that are drawn; without any those that the report shows.
        typeface : {"sans", "serif"}
            Typeface of the figure.

        Raises
        ------
        InputError
            No such figure or model, or an empty segment.

        Notes
        -----
        ``axes[0].figure.savefig("figure.pdf")`` writes it. Cost: 2 s for the first figure, 0.1 to 0.4 s for others.
        """
        from matplotlib import pyplot

        from ..reporting.figure import of_models
        from ..reporting.plotted import paper_look, plotted

        figures = self._report.figures
        if figure not in figures:
            close = difflib.get_close_matches(figure, figures, n=1)
            hint = f"did you mean {close[0]!r}? " if close else ""
            raise InputError(f"{self.root}: has no figure {figure!r}; {hint}it has {', '.join(figures)}")
        names = self._report.data.model_names
        if unknown := [model for model in models if model not in names]:
            raise InputError(f"{self.root}: has no model {unknown[0]!r}; it has {', '.join(names)}")
        part = _segment(of_models(figures[figure], names, models) if models else figures[figure], start, stop)
        return plotted(part, names, paper_look(part, typeface), pyplot.figure()).axes

    def linear_models(self, v1: float = 0.0, v2: float = 0.0) -> "list[LinearModel]":
        """Equilibria under constant voltages [V], from left to right, with the linear model about each.

        `LinearModel.state_space` gives one to python-control. Needs the model 'hybrid'. Cost: 20 ms.
        """
        from ..workflow.studies.control import linear_models

        return linear_models(self.root, (v1, v2))

    def export(
        self,
        target: Literal["c", "controller", "crate", "fmu", "json", "matlab"],
        *,
        model: str | None = None,
        output: str | Path | None = None,
    ) -> list[Path]:
        """Write a model, by default the main one, for another tool and return the files; see `debist export`."""
        from ..workflow.export import export_run

        return export_run(self.root, target, model=model, output=None if output is None else Path(output)).written

    @cached_property
    def _folder(self) -> RunFolder:
        return RunFolder.open(self.root)

    @cached_property
    def _report(self) -> "Prepared":
        """The run as its report shows it. Cost: 1 to 2 s."""
        from ..workflow.stage_report import made_studies, prepare

        def read(run: RunFolder) -> "Prepared":
            """The run as it is now."""
            prototype = run.prototype
            return prepare(run, prototype, scored_models(run, prototype), made_studies(run), made_control(run))

        return in_snapshot(self.root, read)

    @cached_property
    def _prototype(self) -> Prototype:
        return self._folder.prototype

    @property
    def _units(self) -> tuple[str, str]:
        """SI symbols of the displacement and of the inputs."""
        return si_symbols(self._prototype)

    def _role(self, log: str) -> Literal["train", "validation"]:
        for role, name, _ in reversed(layout.logs(self._prototype)):
            if name == log:
                return role
        raise InputError(f"{self.root}: has no log {log!r}; it has {', '.join(self.logs)}")


def _segment(figure: "Figure", start: float | None, stop: float | None) -> "Figure":
    """The figure between two places of its horizontal axis, in SI; up to its ends where one is None."""
    from ..reporting.figure import window, x_range

    if start is None and stop is None:
        return figure
    low, high = x_range(figure)
    first = low if start is None else start
    last = high if stop is None else stop
    if first >= last and start is not None and stop is not None:
        raise InputError(f"start {start:g} is not below stop {stop:g}; exchange them")
    if not max(low, first) < min(high, last):
        raise InputError(f"figure {figure.name!r} spans {low:.6g} to {high:.6g}; choose a segment inside")
    return window(figure, first, last)
