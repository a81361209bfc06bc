"""Estimates the population prior of `rbf` anew (`pipeline/models/rbf/assets/joint_population.npz`).

`debist rig fleet 70 -o FLEET --seed 990100`, then `python benchmarks/joint_population.py FLEET`. The usual structure of
a bistable joint, its curves smooth and its sides alike to 3 %, is fitted to both logs of each joint, coupled to them;
their information makes one distribution (`population_estimate.py`). About ten seconds of processor
time a joint.
"""

import argparse
import os
from concurrent.futures import ProcessPoolExecutor
from dataclasses import replace
from pathlib import Path

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

import numpy as np
from population_estimate import estimate_symmetric_population, information_of, write_population

from pipeline.fitting.homotopy import COUPLED
from pipeline.fitting.population import Information
from pipeline.models.rbf.candidates import FRICTION, SYMMETRIES, Candidate, candidate, first_candidate
from pipeline.models.rbf.identify import identify_rbf
from pipeline.models.rbf.parameter_layout import ParameterLayout
from pipeline.models.rbf.prior import ASSET, joint_prior, mirror_image
from pipeline.models.rbf.problem import JointProblem
from pipeline.models.rbf.start import starting_joint
from pipeline.numerics.arrays import FloatArray
from pipeline.settings.prototype import load_prototype
from pipeline.signals.log import Log
from pipeline.store.run_folder import RunFolder
from pipeline.workflow.engine import Unheard
from pipeline.workflow.run import run_prototype, run_stage
from pipeline.workflow.run_contents import load_logs
from pipeline.workflow.steps.identify import training

LIMIT = 60.0
"""Time limit of a fit [s]: two logs."""

Fitted = tuple[ParameterLayout, Information, FloatArray, FloatArray]
"""Layout, what the logs of a joint tell, and mean and covariance of the prior with which they were fitted."""


def usual() -> Candidate:
    structure = replace(first_candidate(FRICTION["lags+slip"], pair=True, angle=False, fine=True).structure, arc=True)
    return candidate(structure, SYMMETRIES[0])


def records(folder: Path) -> tuple[Log, ...]:
    """Both logs of a joint, brought to 10 ms, with their derivatives."""
    plain = (folder / f"{folder.name}.toml").read_text(encoding="utf-8").partition("[plant]")[0]
    settings = folder / "both.toml"
    logs = 'train = ["train.parquet", "validation.parquet"]'
    lines = [line for line in plain.splitlines() if not line.startswith("validation")]
    settings.write_text("\n".join(logs if line.startswith("train") else line for line in lines), encoding="utf-8")
    root = folder / "run"
    run_prototype(settings, root, Unheard(), only="ingest")
    run_stage(root, "differentiate", Unheard())
    prototype = load_prototype(settings)
    return training(load_logs(RunFolder.open(root), prototype, "train"), prototype, None).records


def fitted(folder: Path) -> Fitted:
    logs, one = records(folder), usual()
    model = identify_rbf(logs, candidates=[one], time_limit=LIMIT)
    p, theta = model.parameters, model.theta
    _, start = starting_joint(logs, one.structure, "squared", centred=True)
    prior = joint_prior(p, start, one.symmetry)
    residual, jacobian = JointProblem(p, logs).jacobian(theta, COUPLED)
    noise = one.noise_inflation * float(np.sqrt(np.mean(residual**2)))
    offset, scale = p.dimensionless
    precision = scale[:, None] * (prior.matrix.T @ prior.matrix) * scale
    covariance = np.asarray(np.linalg.inv(precision), dtype=np.float64)
    mean = covariance @ (scale * (prior.matrix.T @ (prior.right - prior.matrix @ offset)))
    return p, information_of(p, theta, jacobian.T @ jacobian, noise, prior), mean, covariance


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("fleet", type=Path)
    parser.add_argument("--joints", type=int, default=70, help="only the first so many of them")
    parser.add_argument("-o", "--output", type=Path, default=ASSET)
    given = parser.parse_args()
    found = sorted((path.parent for path in given.fleet.glob("*/train.parquet")), key=lambda path: path.name[-2:])
    with ProcessPoolExecutor() as pool:
        fits = []
        for folder, fit in zip(found[: given.joints], pool.map(fitted, found[: given.joints]), strict=True):
            print(folder.name, flush=True)
            fits.append(fit)
    layouts, joints, means, covariances = zip(*fits, strict=True)
    start = np.mean(means, axis=0), np.linalg.inv(np.mean([np.linalg.inv(each) for each in covariances], axis=0))
    mean, covariance = estimate_symmetric_population(joints, mirror_image(layouts[0]), *start)
    write_population(given.output, layouts[0], mean, covariance)
    print(f"{len(fits)} joints, {len(mean)} parameters: {given.output}")


if __name__ == "__main__":
    main()
