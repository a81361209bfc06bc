"""Plot: one figure of one or several runs, drawn for a paper or a quick look."""

import difflib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Literal

from pipeline.errors import InputError
from pipeline.runs.atomic import write_bytes
from pipeline.runs.run_folder import RunFolder
from pipeline.settings import parse_prototype
from pipeline.stages.report import made_studies, prepare
from pipeline.stages.scores import scored_models

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure as Canvas

    from pipeline.reporting.figure import Figure
    from pipeline.reporting.plotted import Typeface

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
        typeface: "Typeface" = "sans",
    ) -> bytes:
        """Draw one figure as a file.

        Parameters
        ----------
        name : str
            As `titles` gives it.
        form : {"svg", "pdf", "png"}
            Kind of the bytes.
        start, stop : float, optional
            Stretch of the horizontal axis, in SI (times in s); every sample in it is drawn, or its bucket's extremes.
        typeface : {"sans", "serif"}

        Raises
        ------
        InputError
            No such figure, or an empty stretch.
        """
        from pipeline.reporting.paper import paper_figure

        return paper_figure(self.figure(name, start, stop), self.models, form, typeface=typeface)[0]

    def plot(
        self,
        name: str,
        canvas: "Canvas",
        *,
        start: float | None = None,
        stop: float | None = None,
        typeface: "Typeface" = "sans",
    ) -> "list[Axes]":
        """Draw one figure on an empty canvas of matplotlib; its axes. Parameters as for `draw`."""
        from pipeline.reporting.plotted import paper_look, plotted

        figure = self.figure(name, start, stop)
        return plotted(figure, self.models, paper_look(figure, typeface), canvas).axes

    def figure(self, name: str, start: float | None = None, stop: float | None = None) -> "Figure":
        """What a figure shows, between two values of its horizontal axis."""
        from pipeline.reporting.figure import window, x_range

        if name not in self.figures:
            close = difflib.get_close_matches(name, self.figures, n=1)
            hint = f"did you mean {close[0]!r}? " if close else ""
            raise InputError(f"{self.root}: has no figure {name!r}; {hint}it has {', '.join(self.figures)}")
        figure = self.figures[name]
        if start is None and stop is None:
            return figure
        low, high = x_range(figure)
        first, last = low if start is None else start, high if stop is None else stop
        if not max(low, first) < min(high, last):
            raise InputError(f"figure {name!r} spans {low:.6g} to {high:.6g}; choose a stretch inside")
        return window(figure, first, last)


def run_figures(root: Path) -> RunFigures:
    """Read a run and make its figures. Cost: 1 to 2 s, as for the report."""
    run = RunFolder.open(root)
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
    typeface: "Typeface" = "sans",
) -> Path:
    """Draw one figure of a run into a file that ends in .svg, .pdf or .png; otherwise as `RunFigures.draw`.

    Raises
    ------
    InputError
        No such figure, another ending, or an empty stretch.
    """
    if target.suffix not in ENDINGS:
        raise InputError(f"{target}: figures are written as {', '.join(ENDINGS)}")
    form: Form = target.suffix[1:]  # type: ignore[assignment]
    write_bytes(target, run_figures(root).draw(name, form, start=start, stop=stop, typeface=typeface))
    return target


def plot_runs(
    roots: Sequence[Path],
    name: str,
    output: Path | None,
    *,
    start: float | None = None,
    stop: float | None = None,
    typeface: "Typeface" = "sans",
) -> list[Path]:
    """The same figure of one or several runs.

    `output` names the file of a single run; else it is the folder that gets ``PROTOTYPE-FIGURE.svg`` of each.
    """
    if len(roots) == 1 and output is not None and output.suffix in ENDINGS:
        return [plot_figure(roots[0], name, output, start=start, stop=stop, typeface=typeface)]
    if output is not None and output.suffix in ENDINGS:
        raise InputError(f"{output}: {len(roots)} runs do not go into one file; name a folder")
    folder = output or Path()
    if folder.suffix[1:].isalpha() and not folder.is_dir():
        raise InputError(f"{output}: figures are written as {', '.join(ENDINGS)}; a folder's name has no such ending")
    return [
        plot_figure(root, name, folder / f"{_prototype(root)}-{name}.svg", start=start, stop=stop, typeface=typeface)
        for root in roots
    ]


def _prototype(root: Path) -> str:
    return str(RunFolder.open(root).manifest.prototype["name"])
