"""The report's figures one by one, and the model written for other tools."""

import sys
from pathlib import Path

from pipeline.api import open_run

run = open_run(sys.argv[1] if len(sys.argv) > 1 else "runs/demo")
for name, title in run.figures.items():
    print(f"{name}: {title}")
run.plot("excitation").save("excitation.svg")  # a notebook shows the drawing by itself
for path in run.export("c", output=Path("exports")) + run.export("json", output=Path("exports")):
    print(path)
