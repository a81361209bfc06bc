"""Demo: raw logs of a virtual prototype, written as a rig would."""

from pathlib import Path

from pipeline.rig.demo import write_demo
from pipeline.runs.outputs import new_outputs, rebased

_NAMES = ("train.mat", "validation.mat", "truth.json")


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
