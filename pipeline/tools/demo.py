"""Demo: raw logs of a virtual prototype, written as a rig would."""

from pathlib import Path

from pipeline.rig.demo import write_demo


def write_demo_logs(run: Path) -> Path:
    """Write the demo's raw logs beside the run folder, once; returns the prototype's settings file."""
    folder = run.with_name(f"{run.name}-rig")
    prototype = folder / "demo.toml"
    return prototype if prototype.is_file() else write_demo(folder)
