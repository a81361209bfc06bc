"""Records the demo's logs, the asset of `pipeline.rig.fleet`: ``python -m tests.rig.record_demo``."""

import json
from dataclasses import asdict

import numpy as np

from pipeline.rig.bench import Readings
from pipeline.rig.fleet import INTERVAL, RECORDING, STEPS, Experiment, draw, moving_mass
from pipeline.rig.joint import wells
from pipeline.rig.parameters import as_json

SEED = 1
"""The first there is."""
EXPERIMENT = Experiment(kind="same", format="mat", rate=2000.0, excitation="alternating")
"""The paper's: full pulses on alternating sides (figures 11 and 15), on a joint of Table 1's size with tolerances."""
EVERY = round(INTERVAL * EXPERIMENT.rate)  # the recorder keeps every second sample


def record() -> tuple[dict[str, Readings], str]:
    """Simulate the demo's logs, by name, and the truth behind them (JSON); half a minute with compilation."""
    joint, bench, drawn = draw(EXPERIMENT, np.random.default_rng(SEED))
    logs = {
        log.stem: Readings(*(getattr(log.record, name)[::EVERY] for name in ("t", "q", "v1", "v2"))) for log in drawn
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


def store(logs: dict[str, Readings], truth: str) -> None:
    counts = {
        f"{name}.{key}": np.diff(np.rint(getattr(log, key) / step).astype(np.int32), prepend=0).astype(np.int32)
        for name, log in logs.items()
        for key, step in STEPS.items()
    }
    RECORDING.parent.mkdir(exist_ok=True)
    np.savez_compressed(RECORDING, truth=np.array(truth), allow_pickle=False, **counts)


if __name__ == "__main__":
    store(*record())
