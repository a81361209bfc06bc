"""The population prior that comes with the package; `benchmarks/joint_population.py` estimates it anew."""

from functools import cache
from pathlib import Path

import numpy as np

from pipeline.identification.parameter_layout import ParameterLayout
from pipeline.identification.population import Population, blocks_of
from pipeline.numerics.arrays import FloatArray

ASSET = Path(__file__).with_name("assets") / "joint_population.npz"


@cache
def population() -> Population:
    """The population of 70 joints of the virtual rig, half of each physics."""
    with np.load(ASSET, allow_pickle=False) as held:
        blocks = dict(zip(held["blocks"].tolist(), held["lengths"].tolist(), strict=True))
        return Population(blocks, float(held["smoothing"]), held["mean"], held["root"].astype(np.float64))


def write_population(path: Path, p: ParameterLayout, mean: FloatArray, covariance: FloatArray) -> None:
    """Write the population of joints of a structure; the root in single precision."""
    blocks = blocks_of(p)
    root = np.linalg.cholesky(np.linalg.inv(covariance)).T
    path.parent.mkdir(parents=True, exist_ok=True)
    np.savez_compressed(
        path, blocks=np.array(list(blocks)), lengths=np.array(list(blocks.values())),
        smoothing=np.array(p.structure.smoothing), mean=mean, root=root.astype(np.float32),
    )  # fmt: skip
