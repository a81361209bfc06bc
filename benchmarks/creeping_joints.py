"""Joints whose wells creep: `python benchmarks/creeping_joints.py FOLDER COUNT SEED`.

Foreign joints of the virtual rig with four Maxwell branches of 0.06 to 0.13 MPa and 0.05 to 60 s, as of `debist rig
fleet --kind foreign`. A snap shifts their wells by up to 1.6 mm. For `control_disturbances.py` and `control_pulses.py`.
"""

import sys
from pathlib import Path

import numpy as np

from pipeline.rig import random_joint
from pipeline.rig.fleet import Experiment, simulate_fleet
from pipeline.rig.parameters import RigParameters

FOREIGN = random_joint._DRAWN["foreign"]


def creeping(rng: np.random.Generator) -> RigParameters:
    """A foreign joint with stiffer and slower branches."""
    joint = FOREIGN(rng)
    moduli = np.outer(rng.uniform(0.95, 1.05, 2), rng.uniform(0.06e6, 0.13e6, 4))
    return joint._replace(branch_modulus=moduli, branch_time=np.geomspace(0.05, 60.0, 4) * rng.uniform(0.7, 1.4, 4))


if __name__ == "__main__":
    folder, count, seed = sys.argv[1:]
    random_joint._DRAWN["foreign"] = creeping
    experiment = Experiment(kind="foreign", format="parquet", rate=10_000.0)
    for prototype in simulate_fleet(Path(folder), int(count), experiment, seed=int(seed)):
        print(prototype, flush=True)
