"""Virtual prototypes on disk: raw logs, settings and truth, beside what lies there and never onto it."""

from collections.abc import Iterator
from pathlib import Path

from pipeline.rig.demo import write_demo
from pipeline.rig.fleet import Experiment, drawn_prototypes, log_files, write_prototype
from pipeline.runs.outputs import new_outputs, rebased

_NAMES = ("train.mat", "validation.mat", "truth.json")


def simulate_prototype(folder: Path, name: str, experiment: Experiment, *, seed: int, force: bool = False) -> Path:
    """Write a prototype as `pipeline.rig.fleet.write_prototype` does, and return its settings file.

    Raises
    ------
    InputError
        The folder holds files of the same names that were not written so.
    """
    names = [*log_files(experiment), f"{name}.toml", "truth/truth.json"]
    with new_outputs(folder, "rig simulate", force=force, names=names) as staged:
        prototype = write_prototype(staged, name, experiment, seed=seed)
    return rebased(prototype, staged, folder)


def simulate_fleet(
    folder: Path, count: int, experiment: Experiment, *, seed: int, force: bool = False
) -> Iterator[Path]:
    """Write many prototypes, one folder each, and yield their settings files; otherwise as `simulate_prototype`."""
    for name, settings, own in drawn_prototypes(count, experiment, seed=seed):
        yield simulate_prototype(folder / name, name, settings, seed=own, force=force)


def write_demo_logs(run: Path, *, force: bool = False) -> Path:
    """Write the demo's raw logs beside the run folder, once; returns the prototype's settings file.

    Raises
    ------
    InputError
        Files of the same names lie there that no demo wrote.
    """
    folder = run.with_name(f"{run.name}-rig")
    prototype = folder / "demo.toml"
    if prototype.is_file():
        return prototype
    with new_outputs(folder, "demo", force=force, names=_NAMES) as staged:
        prototype = write_demo(staged)
    return rebased(prototype, staged, folder)
