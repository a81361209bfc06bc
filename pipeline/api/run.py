"""A run for notebooks and scripts: scores, signals, models, free runs, figures.

Everything is in SI units. Libraries are loaded when they are first needed.

Examples
--------
>>> import debist
>>> run = debist.open_run("runs/P1")  # doctest: +SKIP
>>> run.scores()  # doctest: +SKIP
>>> run.simulate("hybrid", "validation").plot("t_s", ["q_m", "q_measured_m"])  # doctest: +SKIP
"""

from collections.abc import Sequence
from functools import cached_property, partial
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

from ..system.machine import one_thread
from .logs import check, compare, differentiate, read_log
from .model import Model, identify

if TYPE_CHECKING:
    import pandas as pd
    from matplotlib.axes import Axes

    from ..control.linear import LinearModel
    from ..settings.prototype import Prototype
    from ..store.run_folder import RunFolder
    from ..workflow.plot import RunFigures

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
        from ..store import layout

        return [log for _, log, _ in layout.logs(self._prototype)]

    @property
    def models(self) -> list[str]:
        """Names of the identified models, the main model first, and of the baselines that the run holds."""
        from ..workflow.run_models import compared_models, identified_models

        source = (self._folder, self._prototype)
        return [*identified_models(*source), *compared_models(*source)]

    @property
    def figures(self) -> dict[str, str]:
        """Title of each figure by its name."""
        return self._figures.titles

    def scores(self) -> "pd.DataFrame":
        """One row per log, model and signal; `nrmse` is a fraction."""
        import pandas as pd

        from ..workflow.report_data import load_scores

        return pd.DataFrame(load_scores(self.root))

    @property
    def instruments(self) -> "pd.DataFrame":
        """Errors of the instruments of each log, one row per log, model and quantity."""
        import pandas as pd

        from ..workflow.report_data import load_instruments

        return pd.DataFrame(load_instruments(self.root))

    def log(self, name: str) -> "pd.DataFrame":
        """Signals of a log: t_s, q_m (q_rad), v1_V, v2_V, segment, qdot_m_per_s, qddot_m_per_s2; NaN where masked.

        `Model.score` scores it as the report does, gaps included.

        Where a training and a validation log share a name it is that of the validation log.

        Raises
        ------
        InputError
            The run has no such log.
        """
        from ..store import layout
        from .in_memory import OF_RUN, frame

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
        from ..workflow.run_models import load_run_model, subject

        source = self._folder, self._prototype, name
        return Model(load_run_model(*source), self._prototype, subject=partial(subject, *source))

    @one_thread
    def simulate(
        self, model: str | None = None, log: str | None = None, *, tube: bool = False
    ) -> "pd.DataFrame":  # fmt: skip
        """Free run of a model, by default the main one, under the measured voltages of a log, by default the last one.

        Parameters
        ----------
        model, log : str, optional
            Their names.
        tube : bool
            With the 90 % tubes of q, for a model that has them (`hybrid`).

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
        from ..models.free_runs import drawn_runs, free_run, wanted_tubes
        from ..workflow.logs import load_motion
        from .in_memory import frame

        name = log or self.logs[-1]
        measured = load_motion(self._folder, self._prototype, self._role(name), name)
        core = self.model(model).core
        run = free_run(measured, core)
        columns = {"t": run.t, "q": run.q, "qdot": run.qdot, "qddot": run.qddot}
        if tube:
            columns |= wanted_tubes(run.q, drawn_runs(measured, core), core)
        columns |= {f"v{k}": column for k, column in enumerate(measured.v.T, start=1)}
        result = frame(columns | {"q_measured": measured.q}, *self._units)
        result.attrs = {"status": run.status, "diverged_at_s": run.diverged_at_s}
        return result

    def datasheet(self) -> dict[str, Any]:
        """The document ``datasheet.json``."""
        from ..workflow.report_data import load_datasheet

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

        from ..workflow.plot import Excerpt

        return self._figures.plot(figure, pyplot.figure, Excerpt(start, stop, models, typeface))

    def linear_models(self, v1: float = 0.0, v2: float = 0.0) -> "list[LinearModel]":
        """Equilibria under constant voltages [V], from left to right, with the linear model about each.

        `LinearModel.state_space` gives one to python-control. Needs the model 'hybrid'. Cost: 20 ms.
        """
        from ..workflow.studies.controlled_run import linear_models

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
    def _folder(self) -> "RunFolder":
        from ..store.run_folder import RunFolder

        return RunFolder.open(self.root)

    @cached_property
    def _figures(self) -> "RunFigures":
        from ..workflow.plot import run_figures

        return run_figures(self.root)

    @cached_property
    def _prototype(self) -> "Prototype":
        return self._folder.prototype

    @property
    def _units(self) -> tuple[str, str]:
        """SI symbols of the displacement and of the inputs."""
        from .in_memory import si_symbols

        return si_symbols(self._prototype)

    def _role(self, log: str) -> Literal["train", "validation"]:
        from ..errors import InputError
        from ..store import layout

        for role, name, _ in reversed(layout.logs(self._prototype)):
            if name == log:
                return role
        raise InputError(f"{self.root}: has no log {log!r}; it has {', '.join(self.logs)}")
