"""Writes the figures of docs/paper.md anew: a simulated joint after the drawing, `debist paper`, and its SVG files.

python benchmarks/paper_gallery.py [FOLDER]    one minute; FOLDER keeps the logs and the run
"""

import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

FIGURES = Path(__file__).resolve().parents[1] / "docs" / "figures" / "paper"
DEBIST = Path(sys.executable).with_name("debist")


def main(folder: Path) -> None:
    rig = ("rig", "simulate", "-o", folder / "rig", "--kind", "nominal", "--rate", "2000")
    paper = ("paper", folder / "rig" / "nominal-1.toml", "-o", folder / "paper")
    for command in (rig, paper):
        subprocess.run([DEBIST, *command], check=True)
    FIGURES.mkdir(parents=True, exist_ok=True)
    for figure in sorted((folder / "paper" / "paper").glob("*.svg")):
        shutil.copy(figure, FIGURES / figure.name)


if __name__ == "__main__":
    if len(sys.argv) > 1:
        main(Path(sys.argv[1]))
    else:
        with tempfile.TemporaryDirectory() as work:
            main(Path(work))
