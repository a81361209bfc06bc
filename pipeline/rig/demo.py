"""The demo prototype: a recording of the virtual rig that comes with the program, so no kernel of the rig is compiled.

`tests/rig/record_demo.py` records it anew: the paper's experiment on a drawn joint of the analytical model's physics.
"""

import json
from pathlib import Path

import numpy as np

from ..store.atomic import write_text
from ..store.outputs import new_outputs, rebased
from .bench import Readings
from .fleet import prototype_toml
from .log import LAYOUTS

RECORDING = Path(__file__).with_name("assets") / "demo.npz"
INTERVAL = 1e-3
"""Interval of the recording [s]."""
_SET = 'parameters = "nominal"  # the drawing, from which the simulated joint differs by workshop tolerances\n'
_COMPARED = '\n[compare]\nmodels = ["analytical", "sindy", "narx"]\n'
STEPS = {"q": 0.3e-6, "v1": 0.2, "v2": 0.2}
"""Resolution of the recorder [m, V]: a third of the instruments' noise."""


def recorded() -> tuple[dict[str, Readings], str]:
    """The demo's logs, by name, and the truth behind them, as they come with the program."""
    with np.load(RECORDING) as stored:
        names = dict.fromkeys(key.partition(".")[0] for key in stored if "." in key)
        logs = {}
        for name in names:
            q, v1, v2 = (
                np.cumsum(stored[f"{name}.{key}"], dtype=np.int64).astype(np.float64) * step
                for key, step in STEPS.items()
            )
            logs[name] = Readings(np.linspace(0.0, (q.size - 1) * INTERVAL, q.size), q, v1, v2)
        return logs, str(stored["truth"])


def write_demo(folder: Path) -> Path:
    """Write what a rig would leave of the prototype: two raw logs and its TOML; and, beside them, the truth.

    Parameters
    ----------
    folder : Path
        Made if missing. Gets ``demo.toml``, ``train.mat``, ``validation.mat`` (1 kHz, 37.5 s, ControlDesk layout) and
        ``truth.json``.

    Returns
    -------
    Path
        The prototype's TOML.
    """
    folder.mkdir(parents=True, exist_ok=True)
    logs, truth = recorded()
    for name, log in logs.items():
        LAYOUTS["mat"].save(log, folder / f"{name}.mat")
    (folder / "truth.json").write_text(f"{truth}\n", encoding="utf-8", newline="\n")
    mass = float(json.loads(truth)["moving_mass"])
    prototype = folder / "demo.toml"
    settings = prototype_toml("demo", mass, {name: [f"{name}.mat"] for name in logs}, "mat", more=_SET)
    write_text(prototype, settings + _COMPARED)
    return prototype  # written last and whole: where it is there, so are the logs


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
    with new_outputs(folder, "demo", force=force, names=("train.mat", "validation.mat", "truth.json")) as staged:
        prototype = write_demo(staged)
    return rebased(prototype, staged, folder)
