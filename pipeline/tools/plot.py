"""Plot: one figure of one or several runs, drawn for a paper or a quick look."""

import difflib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Literal

from pipeline.errors import InputError
from pipeline.runs.atomic import write_bytes
from pipeline.runs.outputs import new_outputs
from pipeline.runs.run_folder import RunFolder, in_snapshot
from pipeline.settings import parse_prototype
from pipeline.stages.report import made_studies, prepare
from pipeline.stages.scores import scored_models

if TYPE_CHECKING:
    from pipeline.reporting.figure import Figure

Form = Literal["svg", "pdf", "png"]

ENDINGS = (".svg", ".pdf", ".png")


@dataclass(frozen=True)
class RunFigures:
    """The figures of a run, made once; each draws in milliseconds.

    Attributes
    ----------
    root : Path
        Run folder.
    figures : mapping of str to Figure
        By name.
    models : tuple of str
        All models of the run.
    """

    root: Path
    figures: "Mapping[str, Figure]"
    models: tuple[str, ...]

    @property
    def titles(self) -> dict[str, str]:
        """Title of each figure by its name."""
        return {name: figure.title for name, figure in self.figures.items()}

    def draw(
        self,
        name: str,
        form: Form,
        *,
        start: float | None = None,
        stop: float | None = None,
        models: Sequence[str] = (),
    ) -> bytes:
        """Draw one figure.

        Parameters
        ----------
        name : str
            As `titles` gives it.
        form : {"svg", "pdf", "png"}
            Kind of the bytes.
        start, stop : float, optional
            Stretch of the horizontal axis, in SI (times in s); every sample in it is drawn, or its bucket's extremes.
        models : sequence of str
            The models that are drawn; without any those that the report shows.

        Raises
        ------
        InputError
            No such figure or model, or an empty stretch.
        """
        from pipeline.reporting.figure import of_models, window, x_range
        from pipeline.reporting.paper import paper_figure

        if name not in self.figures:
            close = difflib.get_close_matches(name, self.figures, n=1)
            hint = f"did you mean {close[0]!r}? " if close else ""
            raise InputError(f"{self.root}: has no figure {name!r}; {hint}it has {', '.join(self.figures)}")
        figure = self.figures[name]
        if unknown := [model for model in models if model not in self.models]:
            raise InputError(f"{self.root}: has no model {unknown[0]!r}; it has {', '.join(self.models)}")
        figure = of_models(figure, self.models, models) if models else figure
        if start is not None or stop is not None:
            low, high = x_range(figure)
            first, last = low if start is None else start, high if stop is None else stop
            if not max(low, first) < min(high, last):
                raise InputError(f"figure {name!r} spans {low:.6g} to {high:.6g}; choose a stretch inside")
            figure = window(figure, first, last)
        return paper_figure(figure, self.models, form)[0]


def run_figures(root: Path) -> RunFigures:
    """Read a run and make its figures. Cost: 1 to 2 s, as for the report."""
    return in_snapshot(root, _figures)


def _figures(run: RunFolder) -> RunFigures:
    root = run.root
    prototype = parse_prototype(run.manifest.prototype, f"{root}/manifest.json")
    made = prepare(run, prototype, scored_models(run, prototype), made_studies(run))
    return RunFigures(root, made.figures, made.data.model_names)


def figure_names(root: Path) -> list[tuple[str, str]]:
    """Name and title of every figure that a run can be plotted as."""
    return list(run_figures(root).titles.items())


def plot_figure(
    root: Path,
    name: str,
    target: Path,
    *,
    start: float | None = None,
    stop: float | None = None,
    models: Sequence[str] = (),
    force: bool = False,
) -> Path:
    """Draw one figure of a run into a file that ends in .svg, .pdf or .png; otherwise as `RunFigures.draw`.

    Raises
    ------
    InputError
        No such figure, another ending, an empty stretch, or a file of others there and no `force`.
    """
    if target.suffix not in ENDINGS:
        raise InputError(f"{target}: figures are written as {', '.join(ENDINGS)}")
    form: Form = target.suffix[1:]  # type: ignore[assignment]
    with new_outputs(target.parent, "plot", force=force, names=(target.name,)) as staged:
        content = run_figures(root).draw(name, form, start=start, stop=stop, models=models)
        write_bytes(staged / target.name, content)
    return target


def plot_runs(
    roots: Sequence[Path],
    name: str,
    output: Path | None,
    *,
    start: float | None = None,
    stop: float | None = None,
    models: Sequence[str] = (),
    force: bool = False,
) -> list[Path]:
    """The same figure of one or several runs.

    `output` names the file of a single run; else it is the folder that gets ``PROTOTYPE-FIGURE.svg`` of each.
    """
    draw = partial(plot_figure, start=start, stop=stop, models=models, force=force)
    if len(roots) == 1 and output is not None and output.suffix in ENDINGS:
        return [draw(roots[0], name, output)]
    if output is not None and output.suffix in ENDINGS:
        raise InputError(f"{output}: {len(roots)} runs do not go into one file; name a folder")
    folder = output or Path()
    if folder.suffix[1:].isalpha() and not folder.is_dir():
        raise InputError(f"{output}: figures are written as {', '.join(ENDINGS)}; a folder's name has no such ending")
    return [draw(root, name, folder / f"{_prototype(root)}-{name}.svg") for root in roots]


def _prototype(root: Path) -> str:
    return str(RunFolder.open(root).manifest.prototype["name"])
