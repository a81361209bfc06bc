"""Options and arguments that commands share."""

from pathlib import Path
from typing import Annotated

import typer


def run_of(given: Path) -> Path:
    """The run folder that an argument means: itself, or that of a settings file."""
    if given.suffix.lower() != ".toml" or not given.is_file():
        return given
    from pipeline.stages.belonging import run_folder

    return run_folder(given)


def runs_of(given: list[Path]) -> list[Path]:
    """The run folders that some arguments mean."""
    return [run_of(one) for one in given]


Run = Annotated[
    Path,
    typer.Argument(metavar="RUN", help="Run folder, or the settings file of a run in runs/NAME.", callback=run_of),
]
Runs = Annotated[
    list[Path],
    typer.Argument(metavar="RUN...", help="Run folders, or settings files of runs in runs/NAME.", callback=runs_of),
]
PrototypeFile = Annotated[
    Path, typer.Argument(metavar="PROTOTYPE.toml", help="Settings of one prototype, or the folder of its run.")
]
Json = Annotated[bool, typer.Option("--json", help="Print one JSON document on stdout and nothing else there.")]
Quiet = Annotated[bool, typer.Option("--quiet", "-q", help="No progress on stderr.")]
Force = Annotated[bool, typer.Option("--force", help="Replace files that others wrote or changed; never a log.")]
