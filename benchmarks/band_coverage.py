"""Whether the bands of the identified curves hold the truth: `python benchmarks/band_coverage.py FLEET RUNS`.

FLEET is a folder of `debist rig fleet`, RUNS what `debist batch FLEET -o RUNS` made of it. The true restoring force
F(q) and slopes ∂C/∂q come from the simulated joint itself: its coordinates of least energy under a held tip. Where
those jump (near q = 0 a beam has two mirrored S shapes of equal energy) there is no curve. Printed is
for each curve the median error as a share of the curve's largest value, the share of points within the 95 % band of
`hybrid`, and the factor by which the bands would have to be widened to hold 95 % of the points. Where the settings say
nothing of the mass, curves are per unit mass and are compared as such. About ten seconds a joint.
"""

import argparse
import json
from pathlib import Path

import numpy as np
from scipy.optimize import minimize, root

from debist import open_run
from pipeline.models.hybrid.model import HybridModel
from pipeline.numerics.arrays import FloatArray
from pipeline.rig.fleet import Experiment, draw, moving_mass
from pipeline.rig.joint import membrane_capacitances, potential, rest, tip_displacement
from pipeline.rig.parameters import RigParameters

POINTS, STEP = 33, 5e-5
LEVEL = (2.5, 97.5)
DRAWS = 200
NUDGE, UNBALANCED = 1e-5, 1e-6
"""Step of the slopes of energy and tip; what may be left of their balance [mJ, mm]."""
JUMP = 5.0
"""Times the usual move of the coordinates between neighbouring places that is a jump."""
UNIT = 1e-9
"""Distance [kg] of a model's mass from 1 kg that says that no mass was given."""
CURVES = {"F": "F", "dC1_dq": "∂C₁/∂q", "dC2_dq": "∂C₂/∂q"}


def true_curves(joint: RigParameters, q: FloatArray) -> dict[str, FloatArray]:
    """F [N] and ∂C/∂q [F/m] along the path of least energy at q [m], by central differences."""
    x = rest(joint, side=-1)
    energy, capacitance, moved = np.empty((len(q), 2)), np.empty((len(q), 2, 2)), np.empty(len(q))
    for i, middle in enumerate(q):
        for j, at in enumerate((middle - STEP, middle + STEP)):
            before, (x, found) = x, held_at(joint, x, at)
            moved[i] = np.abs(x - before).max() if found else np.inf
            energy[i, j] = potential(joint, x, np.zeros(2))
            capacitance[i, j] = membrane_capacitances(joint, x)
    slopes = (capacitance[:, 1] - capacitance[:, 0]) / (2.0 * STEP)
    force = (energy[:, 1] - energy[:, 0]) / (2.0 * STEP)
    smooth = np.where(moved < JUMP * np.median(moved), 1.0, np.nan)
    return {"F": force * smooth, "dC1_dq": slopes[:, 0] * smooth, "dC2_dq": slopes[:, 1] * smooth}


def held_at(joint: RigParameters, x: FloatArray, at: float) -> tuple[FloatArray, bool]:
    """Coordinates of least energy with the tip at `at` [m], from `x` on, and whether they are found.

    The minimiser finds the valley, but stops short of its floor or gives up; what is left is solved for.
    """
    none = np.zeros(2)

    def energy_of(x: FloatArray) -> float:
        return 1e3 * potential(joint, x, none)

    def off(x: FloatArray) -> float:
        return 1e3 * (tip_displacement(joint, x) - at)

    found = minimize(energy_of, x, method="SLSQP", constraints={"type": "eq", "fun": off})

    def unbalanced(z: FloatArray) -> FloatArray:
        beside = [z[:-1] + step for step in np.vstack([NUDGE * np.eye(len(x)), -NUDGE * np.eye(len(x))])]
        energy = np.array([potential(joint, x, none) for x in beside]).reshape(2, -1)
        tip = np.array([tip_displacement(joint, x) for x in beside]).reshape(2, -1)
        balance = (energy[0] - energy[1] - z[-1] * (tip[0] - tip[1])) / (2.0 * NUDGE)
        return np.append(1e3 * balance, 1e3 * (tip_displacement(joint, z[:-1]) - at))

    solved = root(unbalanced, np.append(found.x, 0.0), tol=1e-12)
    balanced = np.abs(solved.fun).max() < UNBALANCED
    return (solved.x[:-1], True) if balanced else (found.x, False)


def joint_of(path: Path) -> RigParameters:
    """The joint that a truth was drawn from."""
    truth = json.loads(path.read_text(encoding="utf-8"))
    return draw(Experiment(**truth["experiment"]), np.random.default_rng(truth["seed"]))[0]


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("fleet", type=Path)
    parser.add_argument("runs", type=Path)
    given = parser.parse_args()
    errors: dict[str, list[FloatArray]] = {f"{kind} {name}": [] for kind in ("same", "foreign") for name in CURVES}
    halves: dict[str, list[FloatArray]] = {name: [] for name in errors}
    sizes: dict[str, list[float]] = {name: [] for name in errors}
    for path in sorted(given.fleet.glob("*/truth/truth.json")):
        name = path.parent.parent.name
        run = open_run(given.runs / name)
        model = run.model().core
        if not isinstance(model, HybridModel):
            continue
        measured = run.log("train")["q_m"].dropna().to_numpy()
        least, most = np.percentile(measured, [1.0, 99.0])
        q = np.linspace(least, most, POINTS)
        joint = joint_of(path)
        truth, found, drawn = true_curves(joint, q), model.curves(q), model.curve_ensemble(q, DRAWS)
        unit = moving_mass(joint) if abs(model.mass - 1.0) < UNIT else 1.0
        truth = {curve: values / unit for curve, values in truth.items()}
        for curve in CURVES:
            key = f"{name.partition('-')[0]} {curve}"
            low, high = np.nanpercentile(drawn[curve], LEVEL, axis=0)
            errors[key].append(np.abs(found[curve] - truth[curve]))
            halves[key].append(0.5 * (high - low))
            sizes[key].append(float(np.nanmax(np.abs(truth[curve]))))
    print(f"{'':16s}{'joints':>8s}{'median error %':>16s}{'within 95 % band':>18s}{'widen by':>10s}")
    for key, misses in errors.items():
        if misses:
            error, half = np.array(misses), np.array(halves[key])
            share, kept = 100.0 * np.nanmedian(error / np.array(sizes[key])[:, None]), np.isfinite(error)
            inside, factor = 100.0 * np.mean((error < half)[kept]), np.percentile((error / half)[kept], 95)
            print(f"{key:16s}{len(misses):8d}{share:16.2f}{inside:17.0f} %{factor:10.1f}")


if __name__ == "__main__":
    main()
