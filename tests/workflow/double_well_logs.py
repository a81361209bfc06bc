"""A prototype whose curves are known: a double well on a rig with drives, laser and probes."""

import json
from dataclasses import asdict
from pathlib import Path

import numpy as np

from pipeline.numerics.arrays import FloatArray
from pipeline.rig.bench import Converter, Laser, Probe
from pipeline.rig.excitation import command, random_excitation
from pipeline.rig.log import write_mat5
from pipeline.store.atomic import write_text
from tests.double_well import DoubleWell

RATE = 3000.0  # Hz
DURATION = 37.5  # s
SEED = 35
"""Of the first 60, the seed whose pulses hinge least on their height: with all voltages off by 2 % the truth's own run
leaves the measured one by 5 % at most. With most others a pulse ends so near the separatrix that no model can tell."""

_TOML = """\
name = "demo"

[logs]
train = ["train.mat"]
validation = ["validation.mat"]

[channels]
q  = {{ channel = "Laser_q",  unit = "mm" }}
v1 = {{ channel = "HV1_meas", unit = "kV" }}
v2 = {{ channel = "HV2_meas", unit = "kV" }}

[plant]
mass = {{ value = {mass}, unit = "kg" }}
inputs = "squared"
"""


def write_logs(folder: Path, *, seed: int = SEED) -> Path:
    """Write what a rig would leave of one prototype: two raw logs and its TOML; and, beside them, the truth.

    Parameters
    ----------
    folder : Path
        Made if missing. Gets ``demo.toml``, ``train.mat``, ``validation.mat`` (3 kHz, 37.5 s, ControlDesk
        layout) and ``truth.json`` with the planted parameters.
    seed : int
        Draws the excitation and the errors of the instruments.

    Returns
    -------
    Path
        The prototype's TOML.
    """
    folder.mkdir(parents=True, exist_ok=True)
    truth, converter, laser, probe = DoubleWell(), Converter(), Laser(linearity=0.0), Probe()
    t = np.arange(round(DURATION * RATE)) / RATE
    for role, rng in zip(("training", "validation"), np.random.default_rng(seed).spawn(2), strict=True):
        bursts = random_excitation(
            rng, duration=DURATION, excitation="training" if role == "training" else "validation"
        )
        u = command(bursts, t)
        v: FloatArray = np.stack([converter.drive(u[:, side], 1 / RATE) for side in (0, 1)], axis=1)
        channels = {
            "Laser_q": (laser.read(t, truth.simulate(v, 1 / RATE), rng) * 1e3, "mm"),
            "HV1_meas": (probe.read(t, v[:, 0], rng) * 1e-3, "kV"),
            "HV2_meas": (probe.read(t, v[:, 1], rng) * 1e-3, "kV"),
        }
        write_mat5(folder / f"{'train' if role == 'training' else role}.mat", t, channels)
    planted = {
        "seed": seed,
        "units": "SI",
        "double_well": asdict(truth),
        "converter": asdict(converter),
        "laser": asdict(laser),
        "probe": asdict(probe),
    }
    (folder / "truth.json").write_text(json.dumps(planted, indent=2) + "\n", encoding="utf-8")
    prototype = folder / "demo.toml"
    write_text(prototype, _TOML.format(mass=truth.mass))  # last and whole: where it is there, so are the logs
    return prototype
