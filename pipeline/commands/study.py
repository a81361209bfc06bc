"""`debist study`: what a parameter does to the result."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal

import typer

from pipeline.commands.boundary import group
from pipeline.commands.console import Progress, emit_json, emit_table, emit_text
from pipeline.commands.options import Json, run_of

if TYPE_CHECKING:
    from pipeline.tools.study import Sweep

app = group("Studies of alpha, the RBF basis, the data, and cross-validation.")

Run = Annotated[Path, typer.Argument(metavar="RUN", help="Run folder with kinematics.", callback=run_of)]
Jobs = Annotated[int, typer.Option("--jobs", "-j", min=1, help="Processes at a time.")]


@app.command()
def alpha(run: Run, as_json: Json = False) -> None:
    """Over- and under-smoothing against alpha (figure 11c), in SI units; writes studies/alpha.parquet and .svg.

    Example: debist study alpha runs/P1
    """
    _study(run, "alpha", 1, as_json)


@app.command()
def basis(run: Run, jobs: Jobs = 1, as_json: Json = False) -> None:
    """Number M and width of the basis functions of rbf-paper (figure 11b); errors in SI units and fractions.

    Example: debist study basis runs/P1 --jobs 2
    """
    _study(run, "basis", jobs, as_json)


@app.command()
def data(run: Run, as_json: Json = False) -> None:
    """Free-run NRMSE (a fraction) of rbf-paper against the amount of training data and added noise [m].

    Example: debist study data runs/P1
    """
    _study(run, "data", 1, as_json)


@app.command()
def online(run: Run, as_json: Json = False) -> None:
    """Online identification (§ 4.1): recursive least squares over the training logs; errors as fractions, time in s.

    How fast the curves converge, and how they follow a planted drift of 10 %. Example: debist study online runs/P1
    """
    _study(run, "online", 1, as_json)


@app.command()
def folds(
    run: Run,
    by: Annotated[Literal["blocks", "logs"], typer.Option(help="Leave out blocks of time, or whole logs.")] = "blocks",
    count: Annotated[int | None, typer.Option("--folds", help="Folds [default: 5 blocks, or every log once].")] = None,
    model: Annotated[list[str] | None, typer.Option(help="A model of the run; repeat for more [default: all].")] = None,
    jobs: Jobs = 1,
    as_json: Json = False,
) -> None:
    """k-fold cross-validation: every model fitted anew without each fold of all logs, and run freely over it.

    NRMSE in percent (fractions in the JSON). Example: debist study folds runs/P1 --folds 4 --model rbf --model sindy
    """
    from pipeline.reporting.error_tables import FOLD_EXPLANATION, fold_table
    from pipeline.runs.manifest import plain
    from pipeline.tools.folds import run_folds

    with Progress(quiet=as_json) as progress:
        result = run_folds(run, progress, by=by, folds=count, models=model or (), jobs=jobs)
    if as_json:
        emit_json(plain(vars(result)))
        return
    emit_table(f"{result.notes['count']} folds over {result.notes['by']}", *fold_table(result.notes["summary"]))
    emit_text(f"{FOLD_EXPLANATION}\nfigure: {result.figure}")


def _study(run: Path, name: "Sweep", jobs: int, as_json: bool) -> None:
    from pipeline.runs.manifest import plain
    from pipeline.tools.study import run_study

    with Progress(quiet=as_json) as progress:
        result = run_study(run, name, progress, jobs=jobs)
    if as_json:
        emit_json(plain(vars(result)))
        return
    header = [f"{column} [{unit}]" for column, unit in result.units.items()]
    rows = [[f"{value:.4g}" for value in row] for row in zip(*result.columns.values(), strict=True)]
    emit_table(f"Study of {name}", header, rows, numeric_from=0)
    emit_text(f"figure: {result.figure}")
