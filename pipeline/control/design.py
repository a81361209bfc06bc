"""Design of the controller on the identified joint: its numbers, and the tables of targets and braking curves."""

import math
from dataclasses import dataclass

import numpy as np

from ..codegen.numba_writer import kernel
from ..errors import InputError
from ..generated.condensed_joint import STOP_ELEMENTS
from ..generated.condensed_joint_jacobian import PREPARE
from ..models.hybrid.kernels import INDEX, tabulate
from ..models.hybrid.statics import rest_state
from ..numerics.arrays import FloatArray
from ..numerics.compiled import compiled
from ..numerics.metrics import BAND
from .controller import PERIOD
from .design_tables import braking_curves, moments_per_square, reached, target_table
from .law import BEYOND, NUMBERS, REACHES, RESTS, SIDES, TARGETS, Law
from .plant import ASSUMED_LAG, ControlledJoint, inertia, wells_and_saddle

WEIGHT = 0.2
"""Share of what a state reaches in a snap that weighs as the largest moment does in the regulators."""
NEAR = 0.07
"""Distance, over that of the wells, within which the regulator begins; it stops at twice that distance."""
STEEPNESS = 2.0
"""Share of the largest moment for a speed off the braking curve that is the largest one of a snap."""
SETTLES = 0.14
"""Part of a snap's time after which a brake has taken hold: the slope has followed the moment."""
READING = 1.5e-4
"""Standard deviation of a reading over the wells' distance: noise, resolution, and the laser's linearity as it changes
with the motion."""
PUSH = 1.2e-4
WALK = 1e-2
"""Standard deviations of a white force on q [√s], over the largest moment through the wells' distance, and of the
random walk of the unknown moment [1/√s], over the largest one."""
BOUND = 10.0
"""Magnitude that no estimate passes, over what it reaches in a snap, or over the largest moment."""
NODES = 2
"""Points of the table of the corrections in a width σ."""


@dataclass(frozen=True)
class Settings:
    """What a user may choose.

    Attributes
    ----------
    highest : float
        Largest voltage [V].
    lags : tuple of float
        Time constants of the left and the right converter [s].
    slew, average : float or None
        Largest rate [V/s] of each voltage, and its largest mean over `MEMORY` [V]; None is no limit.
    """

    highest: float
    lags: tuple[float, float] = (ASSUMED_LAG, ASSUMED_LAG)
    slew: float | None = None
    average: float | None = None


def design(plant: ControlledJoint, settings: Settings) -> Law:
    """The controller of a plant.

    Raises
    ------
    InputError
        The joint is not bistable, or the voltage limit is no voltage of the trained range, or moves nothing.

    Notes
    -----
    Cost: 0.5 s.
    """
    if not 0.0 < settings.highest <= plant.highest * (1.0 + 1e-9):
        raise InputError(
            f"a largest voltage of {settings.highest:g} V lies outside the trained range 0 to {plant.highest:.0f} V"
        )
    wells = wells_and_saddle(plant)
    left, saddle, right = (float(well.x[0]) for well in wells)
    between = TARGETS - 1 - 2 * BEYOND
    places: FloatArray = left + (right - left) / between * np.arange(-BEYOND, between + BEYOND + 1.0)
    lags = acting_lags(plant, settings)
    distance = right - left
    mass = inertia(wells[1].x, plant.constants.p)
    slew = min(settings.highest, np.inf if settings.slew is None else PERIOD * settings.slew)
    law = condensed_joint_law(plant, lags)
    reach = np.maximum(
        reached(law, wells[0].x, right, np.array([plant.highest, 0.0])),
        reached(law, wells[2].x, left, np.array([0.0, plant.highest])),
    )
    fastest = float(reach[1])
    a_snap = distance / float(reach[1])
    targets, slow = target_table(plant, wells, places, settings.highest, sum(lags) / 2.0, WEIGHT * reach)
    moment = float(np.mean(moments_per_square(plant, wells[1].x, np.zeros(2)))) * plant.highest**2
    scale = np.append(reach, moment)
    unknown = np.append(READING * distance, scale[1:])
    numbers = dict(zip(NUMBERS, law.numbers.tolist(), strict=True)) | {
        "highest": settings.highest,
        "first": places[0],
        "per_step": 1.0 / (places[1] - places[0]),
        "per_reach": (REACHES - 1) / distance,
        "steepness": STEEPNESS / fastest,
        "saddle": saddle,
        "pumped_right": float(slow[0] > settings.highest),
        "pumped_left": float(slow[1] > settings.highest),
        "near": NEAR * distance,
        "lever": mass[0, 1] / mass[0, 0],
        "settles": SETTLES * a_snap / PERIOD + settings.highest / slew - 1.0,
        "slew": slew,
        "allowed": min(settings.highest, np.inf if settings.average is None else settings.average),
        "fade": PERIOD / a_snap,
        "slow": BAND * fastest,
        "band": BAND * distance,
        "same": BAND * distance / (places[1] - places[0]),
        "reading_variance": (READING * distance) ** 2,
        "push": (PUSH * moment / distance) ** 2,
        "walk": (WALK * moment) ** 2,
        **{f"unknown_{i}": value**2 for i, value in enumerate(unknown)},
        **{f"bound_{i}": BOUND * value for i, value in enumerate(scale)},
    }
    slope = plant.constants.k[INDEX["slope_ratio"]] / plant.constants.k[INDEX["l"]]
    law = law._replace(numbers=np.array([numbers[name] for name in NUMBERS], dtype=np.float64), targets=targets)
    braking = [braking_curves(law, wells, slope, places, side, settings.highest, fastest) for side in (0, 1)]
    return law._replace(braking=np.concatenate([curves for pair in zip(*braking, strict=True) for curves in pair]))


def condensed_joint_law(plant: ControlledJoint, lags: tuple[float, float]) -> Law:
    """What motion needs of a plant whose converters have the time constants `lags` [s], without tables."""
    k, p, basis, weights = plant.constants
    farthest = 0.9 * plant.wall
    decays = [math.exp(-PERIOD / lag) for lag in lags]
    grid = np.linspace(-farthest, farthest, RESTS)
    rests = []
    for q in grid:
        x, z = rest_state(q, np.zeros(2), k, p, basis, weights, 0.0)
        rests.append((x[2], x[4], z[0]))
    first, per_metre, curves = tabulate(basis, weights, NODES)
    numbers = {
        "offset": plant.offset, "wall": plant.wall, "farthest": farthest,
        **{f"kept_{side}": left for side, left in zip(SIDES, decays, strict=True)},
        **{f"kept_mean_{x}": (1.0 - left) * lag / PERIOD for x, left, lag in zip(SIDES, decays, lags, strict=True)},
        "arm": k[INDEX["friction_arm"]], "length": k[INDEX["l"]],
        **{f"travel_{i}": k[INDEX[f"stop_travel_{i}"]] for i in set(STOP_ELEMENTS)},
        "curve_first": first, "curve_per_metre": per_metre, "curve_last": len(curves) - 1.0,
        "rest_per_metre": 1.0 / (grid[1] - grid[0]),
    }  # fmt: skip
    return Law(
        np.array([numbers.get(name, 0.0) for name in NUMBERS], dtype=np.float64),
        p, prepare_slopes(k), np.ascontiguousarray(curves), np.array(rests),
        np.zeros((TARGETS, 0)), np.zeros((4 * TARGETS, 0)),
    )  # fmt: skip


@compiled
def prepare_slopes(k: FloatArray) -> FloatArray:
    """Constants prepared for the Jacobian of a joint with the constants k."""
    slopes = np.empty(_SLOPES)
    _prepare_slopes((k, slopes))
    return slopes


_SLOPES = PREPARE.outputs["p"]
_prepare_slopes = kernel(PREPARE)


def acting_lags(plant: ControlledJoint, settings: Settings) -> tuple[float, float]:
    """Time constants [s] from command to force: the converters', and delay and charging time of the identification."""
    left, right = (max(lag + plant.delay + plant.charging, 0.5 * PERIOD) for lag in settings.lags)
    return left, right
