"""The report's figures one by one, and the model written for other tools."""

import sys
from pathlib import Path

import debist

run = debist.open_run(sys.argv[1] if len(sys.argv) > 1 else "runs/demo")
for name, title in run.figures.items():
    print(f"{name}: {title}")
axes = run.plot("excitation")  # a notebook shows them by itself
axes[0].figure.savefig("excitation.svg")
for path in run.export("c", output=Path("exports")) + run.export("json", output=Path("exports")):
    print(path)
