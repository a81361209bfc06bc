"""The population prior that comes with the package; `benchmarks/joint_population.py` estimates it anew."""

from functools import cache
from pathlib import Path

import numpy as np

from pipeline.identification.population import Population

ASSET = Path(__file__).with_name("assets") / "joint_population.npz"


@cache
def population() -> Population:
    """The population of 70 joints of the virtual rig, half of each physics."""
    with np.load(ASSET, allow_pickle=False) as held:
        blocks = dict(zip(held["blocks"].tolist(), held["lengths"].tolist(), strict=True))
        return Population(blocks, float(held["smoothing"]), held["mean"], held["root"].astype(np.float64))
