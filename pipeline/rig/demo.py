"""The demo prototype: a recording of the virtual rig that comes with the program, so no kernel of the rig is compiled.

`python -m pipeline.rig.demo` records it anew, from a drawn joint of the analytical model's physics.
"""

import json
from dataclasses import asdict
from pathlib import Path

import numpy as np

from pipeline.numerics.arrays import FloatArray, IntArray
from pipeline.rig.fleet import Experiment, moving_mass, prototype_toml, replay
from pipeline.rig.joint import wells
from pipeline.rig.log import LAYOUTS, RawLog
from pipeline.rig.parameters import as_json
from pipeline.runs.atomic import write_text
from pipeline.runs.outputs import new_outputs, rebased

RECORDING = Path(__file__).with_name("assets") / "demo.npz"
SEED = 9
"""Of the first twelve and within the laser's range, the joint whose pulses depend least on their height: with all
voltages off by 2 % the truth's own motion leaves the recorded one by an NRMSE of 6 %. So it is an easy joint."""
EXPERIMENT = Experiment("same", "mat", rate=2000.0)
_EVERY = 2  # the recorder keeps every second sample: 1 kHz
_STEPS = {"q": 0.3e-6, "v1": 0.2, "v2": 0.2}
"""Of the recorder [m, V]: a third of the instruments' noise."""


def record() -> tuple[dict[str, RawLog], str]:
    """Simulate the demo's logs, by name, and the truth behind them (JSON); half a minute with compilation."""
    joint, bench, records = replay(EXPERIMENT, seed=SEED)
    logs = {
        name: RawLog(*(column[::_EVERY] for column in (found.t, found.q, found.v1, found.v2)))
        for name, found in records.items()
    }
    truth = {
        "seed": SEED,
        "units": "SI",
        "moving_mass": moving_mass(joint),
        "wells": wells(joint),
        "joint": as_json(joint),
        "bench": asdict(bench),
    }
    return logs, json.dumps(truth, indent=1)


def recorded() -> tuple[dict[str, RawLog], str]:
    """The demo's logs, by name, and the truth behind them, as they come with the program."""
    with np.load(RECORDING) as stored:
        names = dict.fromkeys(key.partition(".")[0] for key in stored if "." in key)
        interval = _EVERY / EXPERIMENT.rate
        logs = {}
        for name in names:
            q, v1, v2 = (_column(stored[f"{name}.{key}"], step) for key, step in _STEPS.items())
            logs[name] = RawLog(np.linspace(0.0, (q.size - 1) * interval, q.size), q, v1, v2)
        return logs, str(stored["truth"])


def _column(counts: IntArray, step: float) -> FloatArray:
    column: FloatArray = np.cumsum(counts, dtype=np.int64).astype(np.float64) * step
    return column


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
    (folder / "truth.json").write_text(f"{truth}\n", encoding="utf-8")
    mass = float(json.loads(truth)["moving_mass"])
    prototype = folder / "demo.toml"
    write_text(prototype, prototype_toml("demo", mass, {name: [f"{name}.mat"] for name in logs}, "mat"))
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


def _store(logs: dict[str, RawLog], truth: str) -> None:
    counts = {
        f"{name}.{key}": np.diff(np.rint(getattr(log, key) / step).astype(np.int32), prepend=0).astype(np.int32)
        for name, log in logs.items()
        for key, step in _STEPS.items()
    }
    RECORDING.parent.mkdir(exist_ok=True)
    np.savez_compressed(RECORDING, truth=np.array(truth), allow_pickle=False, **counts)


if __name__ == "__main__":
    _store(*record())
