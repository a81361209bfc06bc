"""A run is meant by its folder or by its settings file; commands take either."""

from pathlib import Path


def run_of(given: Path) -> Path:
    """The run folder that an argument means."""
    if given.suffix.lower() != ".toml" or not given.is_file():
        return given
    from pipeline.stages.belonging import run_folder

    return run_folder(given)


def runs_of(given: list[Path]) -> list[Path]:
    """The run folders that some arguments mean."""
    return [run_of(one) for one in given]
