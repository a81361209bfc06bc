"""`debist paper`: the paper's recipe, figures and tables on a prototype's logs."""

from pathlib import Path
from typing import Annotated

import typer

from pipeline.commands.options import Json, Quiet


def paper(
    source: Annotated[Path, typer.Argument(metavar="RUN|PROTOTYPE.toml", help="Run folder, or settings file.")],
    output: Annotated[
        Path | None,
        typer.Option("-o", "--output", metavar="DIR", help="Folder of the recipe's run [default: RUN-paper]."),
    ] = None,
    as_json: Json = False,
    quiet: Quiet = False,
) -> None:
    """Every figure and table of the paper under its number, printed values beside computed ones (NRMSE in percent).

    Differentiates, identifies and simulates by the recipe of the paper in a run of its own; writes paper.html, and the
    figures as paper/*.svg and *.pdf. Example: debist paper runs/P1
    """
    from pipeline.commands.console import Progress, emit_json, emit_table
    from pipeline.reporting.paper_page import SIGNALS
    from pipeline.tools.paper import run_paper

    with Progress(quiet=quiet or as_json) as progress:
        made = run_paper(source, output, progress)
    if as_json:
        emit_json({"page": str(made.page), "figures": str(made.root / "paper"), "table_2": made.table})
        return

    def cell(row: dict[str, float | None], signal: str) -> str:
        """The computed error, and in brackets the printed one."""
        value, printed = row.get(signal), row.get(f"printed_{signal}")
        text = "diverged" if value is None else f"{100.0 * value:.2f}"
        return text if printed is None else f"{text} ({100.0 * printed:.1f})"

    rows = [
        (f"{row['role']}, {row['log']}", row["model"], *(cell(row, signal) for signal in SIGNALS)) for row in made.table
    ]
    emit_table(
        "Table 2: NRMSE in %, in brackets as printed", ("log", "model", "q", "φ", "q̇", "q̈"), rows, numeric_from=2
    )
    typer.echo(f"page: {made.page}\nfigures: {made.root / 'paper'}")
