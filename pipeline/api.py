"""A run for notebooks and scripts: scores, signals, models, free runs, figures.

Everything is in SI units. Libraries are loaded when they are first needed.

Examples
--------
>>> from pipeline.api import open_run
>>> run = open_run("runs/P1")  # doctest: +SKIP
>>> run.scores()  # doctest: +SKIP
>>> run.simulate(log="validation").plot("t", ["q", "q_measured"])  # doctest: +SKIP
"""

from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

if TYPE_CHECKING:
    import pandas as pd

    from pipeline.models.base import Model
    from pipeline.runs.run_folder import RunFolder
    from pipeline.settings import Prototype
    from pipeline.tools.plot import RunFigures

__all__ = ["Drawing", "Run", "open_run"]


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


@dataclass(frozen=True)
class Drawing:
    """A figure: shown by notebooks, or saved.

    Attributes
    ----------
    svg : str
        The figure as SVG.
    """

    svg: str

    def _repr_svg_(self) -> str:
        return self.svg

    def save(self, target: str | Path) -> Path:
        """Write the figure as an SVG file and return its path."""
        from pipeline.runs.atomic import write_text

        write_text(Path(target), self.svg)
        return Path(target)


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
        from pipeline.runs import layout

        return [log for _, log, _ in layout.logs(self._prototype)]

    @property
    def models(self) -> list[str]:
        """Names of the identified models, the headline first, and of the rivals that the run holds."""
        from pipeline.loading.identified import compared_models, identified_models

        made = (self._folder, self._prototype)
        return [*identified_models(*made), *compared_models(*made)]

    @property
    def figures(self) -> dict[str, str]:
        """Title of each figure by its name."""
        return self._figures.titles

    def scores(self) -> "pd.DataFrame":
        """One row per log, model and signal; `nrmse` is a fraction (columns: `data/README.md`)."""
        import pandas as pd

        from pipeline.stages.scores import load_scores

        return pd.DataFrame(load_scores(self.root))

    def log(self, name: str) -> "pd.DataFrame":
        """Signals of a log: t [s], q [m], v1, v2 [V], qdot [m/s], qddot [m/s²], segment.

        Raises
        ------
        InputError
            The run has no such log.
        """
        import pandas as pd

        from pipeline.runs import layout

        return pd.DataFrame(self._folder.read_table(layout.kinematics(self._role(name), name)))

    def model(self, name: str | None = None) -> "Model":
        """A model, the headline if none is named.

        ``simulate(t, v, q0, qdot0)`` runs it freely, ``curves(q)`` gives its characteristic curves.

        Raises
        ------
        InputError
            The run holds no such model.
        """
        from pipeline.tools.export import load_run_model

        return load_run_model(self._folder, self._prototype, name)

    def simulate(self, model: str | None = None, log: str | None = None) -> "pd.DataFrame":
        """Free run of a model over a log under its measured voltages; of the headline, over the last log, if left out.

        Returns
        -------
        pandas.DataFrame
            t [s], q [m], qdot [m/s], qddot [m/s²], v1, v2 [V], and q_measured [m]; NaN after a divergence.
        """
        import pandas as pd

        from pipeline.loading.trajectories import load_motion
        from pipeline.stages.predict import free_run

        name = log or self.logs[-1]
        table = load_motion(self._folder, self._role(name), name)
        found = free_run(table, self.model(model))
        columns = {"t": found.t, "q": found.q, "qdot": found.qdot, "qddot": found.qddot}
        columns |= {key: table[key] for key in ("v1", "v2") if key in table}
        return pd.DataFrame(columns | {"q_measured": table["q"]})

    def datasheet(self) -> dict[str, Any]:
        """The document ``datasheet.json``."""
        from pipeline.tools.show import load_datasheet

        return load_datasheet(self.root)

    def plot(self, figure: str, *, start: float | None = None, stop: float | None = None) -> Drawing:
        """One of the report's figures; `figures` names them. Times in s. The first takes 1 to 2 s, any further none.

        Raises
        ------
        InputError
            No such figure, or an empty stretch.
        """
        return Drawing(self._figures.draw(figure, "svg", start=start, stop=stop).decode())

    def export(
        self,
        target: Literal["c", "crate", "fmu", "json", "matlab"],
        *,
        model: str | None = None,
        output: str | Path | None = None,
    ) -> list[Path]:
        """Write a model, the headline if none is named, for another tool and return the files; see `debist export`."""
        from pipeline.tools.export import export_run

        return export_run(self.root, target, model=model, output=None if output is None else Path(output)).written

    @cached_property
    def _folder(self) -> "RunFolder":
        from pipeline.runs.run_folder import RunFolder

        return RunFolder.open(self.root)

    @cached_property
    def _figures(self) -> "RunFigures":
        from pipeline.tools.plot import run_figures

        return run_figures(self.root)

    @cached_property
    def _prototype(self) -> "Prototype":
        from pipeline.settings import parse_prototype

        return parse_prototype(self._folder.manifest.prototype, f"{self.root}/manifest.json")

    def _role(self, log: str) -> Literal["train", "validation"]:
        from pipeline.errors import InputError
        from pipeline.runs import layout

        for role, name, _ in reversed(layout.logs(self._prototype)):
            if name == log:
                return role
        raise InputError(f"{self.root}: has no log {log!r}; it has {', '.join(self.logs)}")
