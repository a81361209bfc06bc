"""Plot: one figure of a run, drawn for a paper or a quick look."""

import difflib
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from ..errors import InputError
from ..reporting.figure import Figure, of_models, window, x_range
from ..reporting.plotted import form_of, paper_figure, paper_look, plotted
from ..store.atomic import write_bytes
from ..store.outputs import new_outputs
from ..store.run_folder import RunFolder, in_snapshot
from ..system.names import Typeface
from .run_models import made_control
from .stage_report import made_studies, prepare
from .stage_validate import scored_models

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure as Canvas


@dataclass(frozen=True)
class Excerpt:
    """Part of a figure to draw, and its typography.

    Attributes
    ----------
    start, stop : float, optional
        Segment of the horizontal axis, in SI (times in s); every sample in it is drawn, or its bucket's extremes.
    models : sequence of str
        The models that are drawn; without any those that the report shows.
    typeface : {"sans", "serif"}
    """

    start: float | None = None
    stop: float | None = None
    models: Sequence[str] = ()
    typeface: Typeface = "sans"


WHOLE = Excerpt()


@dataclass(frozen=True)
class RunFigures:
    """The figures of a run, made once.

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
    figures: Mapping[str, Figure]
    models: tuple[str, ...]

    @property
    def titles(self) -> dict[str, str]:
        """Title of each figure by its name."""
        return {name: figure.title for name, figure in self.figures.items()}

    def plot(self, name: str, make: "Callable[[], Canvas]", part: Excerpt = WHOLE) -> "list[Axes]":
        """Draw one figure on a canvas that `make` makes, such as ``pyplot.figure``; its axes; raises as `figure`."""
        figure = self.figure(name, part)
        return plotted(figure, self.models, paper_look(figure, part.typeface), make()).axes

    def figure(self, name: str, part: Excerpt = WHOLE) -> Figure:
        """Part of a figure, cut to its models and its segment.

        Raises
        ------
        InputError
            No such figure or model, or an empty segment.
        """
        if name not in self.figures:
            close = difflib.get_close_matches(name, self.figures, n=1)
            hint = f"did you mean {close[0]!r}? " if close else ""
            raise InputError(f"{self.root}: has no figure {name!r}; {hint}it has {', '.join(self.figures)}")
        if unknown := [model for model in part.models if model not in self.models]:
            raise InputError(f"{self.root}: has no model {unknown[0]!r}; it has {', '.join(self.models)}")
        figure = self.figures[name]
        figure = of_models(figure, self.models, part.models) if part.models else figure
        if part.start is None and part.stop is None:
            return figure
        low, high = x_range(figure)
        first = low if part.start is None else part.start
        last = high if part.stop is None else part.stop
        if first >= last and part.start is not None and part.stop is not None:
            raise InputError(f"--from {first:g} is not below --to {last:g}; exchange them")
        if not max(low, first) < min(high, last):
            raise InputError(f"figure {name!r} spans {low:.6g} to {high:.6g}; choose a segment inside")
        return window(figure, first, last)


def run_figures(root: Path) -> RunFigures:
    """Read a run and make its figures. Cost: 1 to 2 s, as for the report."""

    def read(run: RunFolder) -> RunFigures:
        """All figures of a run as it is now."""
        prototype = run.prototype
        prepared = prepare(run, prototype, scored_models(run, prototype), made_studies(run), made_control(run))
        return RunFigures(root, prepared.figures, prepared.data.model_names)

    return in_snapshot(root, read)


def plot_figure(root: Path, name: str, output: Path | None, part: Excerpt = WHOLE, *, force: bool = False) -> Path:
    """Draw one figure of a run into a file that ends in .svg, .pdf or .png; otherwise as `RunFigures.figure`.

    Parameters
    ----------
    root : Path
        Run folder.
    name : str
        Name of the figure.
    output : Path or None
        The file; ``PROTOTYPE-FIGURE.svg`` if None.
    part : Excerpt
        Part to draw, and its typography.
    force : bool
        True if a file of others may be replaced.

    Raises
    ------
    InputError
        No such figure or model, another ending, an empty segment, or a file of others there and no `force`.
    """
    target = output or Path(f"{RunFolder.open(root).prototype.name}-{name}.svg")
    form = form_of(target)
    with new_outputs(target.parent, "plot", force=force, names=(target.name,)) as staged:
        run = run_figures(root)
        drawn = paper_figure(run.figure(name, part), run.models, form, typeface=part.typeface)
        write_bytes(staged / target.name, drawn[0])
    return target
