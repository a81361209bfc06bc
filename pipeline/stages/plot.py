"""Plot: one figure of one or several runs, drawn for a paper or a quick look."""

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Literal

from pipeline.artifacts.atomic import write_bytes
from pipeline.artifacts.run_folder import RunFolder
from pipeline.errors import InputError
from pipeline.settings import parse_prototype
from pipeline.stages.report import made_studies, prepare
from pipeline.stages.scores import scored_models

if TYPE_CHECKING:
    from pipeline.reporting.figure import Figure

ENDINGS = (".svg", ".pdf", ".png")


def figure_names(root: Path) -> list[tuple[str, str]]:
    """Name and title of every figure that a run can be plotted as."""
    figures, _ = _figures(root)
    return [(figure.name, figure.title) for figure in figures.values()]


def draw_figure(
    root: Path, name: str, form: Literal["svg", "pdf", "png"], *, start: float | None = None, stop: float | None = None
) -> bytes:
    """Draw one figure of a run.

    Parameters
    ----------
    root : Path
        Run folder.
    name : str
        As `figure_names` gives it.
    form : {"svg", "pdf", "png"}
        Kind of the bytes.
    start, stop : float, optional
        Stretch of the horizontal axis, in SI (times in s); every sample in it is drawn, or its bucket's extremes.

    Raises
    ------
    InputError
        No such figure, or an empty stretch.
    """
    from pipeline.reporting.figure import window, x_range
    from pipeline.reporting.paper import paper_figure

    figures, models = _figures(root)
    if name not in figures:
        raise InputError(f"{root}: has no figure {name!r}; it has {', '.join(figures)}")
    figure = figures[name]
    if start is not None or stop is not None:
        low, high = x_range(figure)
        first, last = low if start is None else start, high if stop is None else stop
        if not max(low, first) < min(high, last):
            raise InputError(f"figure {name!r} spans {low:.6g} to {high:.6g}; choose a stretch inside")
        figure = window(figure, first, last)
    return paper_figure(figure, models, form)[0]


def plot_figure(root: Path, name: str, target: Path, *, start: float | None = None, stop: float | None = None) -> Path:
    """Draw one figure of a run into a file that ends in .svg, .pdf or .png; otherwise as `draw_figure`.

    Raises
    ------
    InputError
        No such figure, another ending, or an empty stretch.
    """
    if target.suffix not in ENDINGS:
        raise InputError(f"{target}: figures are written as {', '.join(ENDINGS)}")
    form: Literal["svg", "pdf", "png"] = target.suffix[1:]  # type: ignore[assignment]
    write_bytes(target, draw_figure(root, name, form, start=start, stop=stop))
    return target


def plot_runs(
    roots: Sequence[Path], name: str, output: Path | None, *, start: float | None = None, stop: float | None = None
) -> list[Path]:
    """The same figure of one or several runs.

    `output` names the file of a single run; else it is the folder that gets ``PROTOTYPE-FIGURE.svg`` of each.
    """
    if len(roots) == 1 and output is not None and output.suffix in ENDINGS:
        return [plot_figure(roots[0], name, output, start=start, stop=stop)]
    if output is not None and output.suffix in ENDINGS:
        raise InputError(f"{output}: {len(roots)} runs do not go into one file; name a folder")
    folder = output or Path()
    return [
        plot_figure(root, name, folder / f"{_prototype(root)}-{name}.svg", start=start, stop=stop) for root in roots
    ]


def _prototype(root: Path) -> str:
    return str(RunFolder.open(root).manifest.prototype["name"])


def _figures(root: Path) -> "tuple[dict[str, Figure], tuple[str, ...]]":
    run = RunFolder.open(root)
    prototype = parse_prototype(run.manifest.prototype, f"{root}/manifest.json")
    made = prepare(run, prototype, scored_models(run, prototype), made_studies(run))
    return dict(made.figures), made.data.model_names
