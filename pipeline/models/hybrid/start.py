"""Start of an identification of the hybrid joint: similarity of the device, and prior of deviations.

The logs show the device's size, speed and sensitivity beside the joint of a parameter set. Length follows from the
distance of the two wells, time from the frequency of small motions in them, and voltage from the acceleration that the
inputs add there. A few percent are enough: the identification goes on from there.

The prior states how wide deviations and corrections are, and how alike the two sides. A joint is built to be its own
mirror image. So errors of its equations are nearly the same on both sides, and errors of a parameter set are common to
both membranes. Only a workshop's tolerances are each side's own.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ...device.device import JOINT
from ...device.parameters import JointParameters
from ...errors import DataRefusedError
from ...fitting.population import NormalPopulation
from ...generated.condensed_joint import CORRECTIONS
from ...numerics.arrays import FloatArray, IntArray
from ...scoring.wells import SHORT_PAUSE, NoWells, Wells, find_wells
from ...signals.log import Log
from .kernels import CURVES, INDEX
from .log_reading import Similarity
from .parameters import NAMES, constants, moving_mass, nominal_deviations, static_slope_ratio
from .statics import static_curves

NEAR = 0.4
"""Share of half the distance of the wells within which a motion counts as one about a well."""

SHIFTED = 0.3
"""Share of half the distance of the wells by which their middle may differ from the reading zero of a joint that is
only asymmetric; beyond it the laser's zero is taken to be elsewhere."""

WELLS_DIFFER = 0.1
"""Share by which frequency and sensitivity of an asymmetric joint's two wells differ; errors below it weigh alike."""
OWN_MATERIAL = 0.045
OWN_MOUNT = 0.45
"""Shares of variance that are each side's own: in moduli and capacitance, as both membranes are cut from one film, and
in the places of the mounts."""
ALIKE = 0.9
"""Correlation of a correction with its mirror image."""
_EVEN = ("damping", "stiffness", "loss")
"""Corrections that a mirrored joint has with the same sign at −q; generalised forces have the other one."""


@dataclass(frozen=True)
class _SmallMotion:
    """Small motions near a well.

    Attributes
    ----------
    place : float
        The well [m].
    stiffness : float
        Squared frequency [1/s²].
    gains : FloatArray, shape (2,)
        Acceleration by each squared voltage [m/(s²·V²)].
    stiffness_error, gain_error : float
        Standard errors of the squared frequency and of the difference of the gains.
    """

    place: float
    stiffness: float
    gains: FloatArray
    stiffness_error: float = 0.0
    gain_error: float = 0.0


def similar_joint(records: Sequence[Log], parameters: JointParameters, mass: float | None = None) -> Similarity:
    """The device of the training logs in units of a parameter set's joint.

    Parameters
    ----------
    records : sequence of Log
        Training logs with two voltages, q in metres.
    parameters : JointParameters
        The set.
    mass : float, optional
        Moving mass [kg] of the device; 1 kg if it is unknown, so that forces are per unit mass.

    Returns
    -------
    Similarity
        Cost: two regressions over the samples near the wells.

    Raises
    ------
    DataRefusedError
        The joint's equations are no candidate for the device.
    """
    wells = _wells(records)
    if not isinstance(wells, Wells):
        raise DataRefusedError(f"no two wells: {wells.reason}")
    half = 0.5 * (wells.right - wells.left)
    measured = (_measured(records, place, NEAR * half) for place in (wells.left, wells.right))
    motions = [motion for motion in measured if motion is not None]
    if not motions:
        raise DataRefusedError("no small motion about a well is seen, so the joint's time scale is unknown")
    gain = _weighted([(motion.gains[0] - motion.gains[1], motion.gain_error) for motion in motions])
    stiffness = _weighted([(motion.stiffness, motion.stiffness_error) for motion in motions])
    if np.isnan(gain + stiffness):
        raise DataRefusedError("no voltage drives a small motion about a well, so the joint's scales are unknown")
    if gain <= 0.0:
        raise DataRefusedError(
            "v1 pushes to smaller q and v2 to larger, against the sides of a joint; are they exchanged?"
        )
    reference = _reference_motion(parameters)
    length = half / reference.place
    time = float(np.sqrt(reference.stiffness / stiffness))
    voltage = float(np.sqrt(length / time**2 * (reference.gains[0] - reference.gains[1]) / gain))
    return Similarity(length, time, voltage, mass_factor(parameters, mass), _shift(wells))


def shift_of(records: Sequence[Log]) -> float:
    """Reading [m] in the middle of the wells where that is far from zero, else 0; also where no wells are seen."""
    wells = _wells(records)
    return _shift(wells) if isinstance(wells, Wells) else 0.0


def _wells(records: Sequence[Log]) -> Wells | NoWells:
    logs = [(np.where(r.valid, r.q, np.nan), r.v, r.interval) for r in records]
    wells = find_wells(logs, plant=JOINT)
    return wells if isinstance(wells, Wells) else find_wells(logs, SHORT_PAUSE, plant=JOINT)


def _shift(wells: Wells) -> float:
    middle = 0.5 * (wells.right + wells.left)
    return middle if abs(middle) > SHIFTED * (0.5 * (wells.right - wells.left)) else 0.0


def mass_factor(parameters: JointParameters, mass: float | None) -> float:
    """The device's moving mass [kg], 1 kg if it is unknown, over that of the set's joint."""
    return (1.0 if mass is None else mass) / moving_mass(parameters, static_slope_ratio(parameters))


def _measured(records: Sequence[Log], place: float, reach: float) -> _SmallMotion | None:
    """Regression of the acceleration near a well on displacement, velocity and squared voltages."""
    near = np.concatenate([r.valid & (np.abs(r.q - place) < reach) for r in records])
    q, qdot, target, v = (
        np.concatenate([getattr(r, name) for r in records])[near] for name in ("q", "qdot", "qddot", "v")
    )
    x = q - place
    matrix = np.column_stack([np.ones(len(x)), x, x**2, qdot, v**2])
    if len(target) <= matrix.shape[1]:
        return None
    scale = np.abs(matrix).max(axis=0)
    scale[scale == 0.0] = 1.0
    scaled = matrix / scale
    solution = np.linalg.lstsq(scaled, target, rcond=1e-9)[0]
    if solution[1] >= 0.0:
        return None
    variance = (
        np.sum((target - scaled @ solution) ** 2)
        / (len(target) - len(solution))
        * np.diag(np.linalg.pinv(scaled.T @ scaled))
        / scale**2
    )
    variance = np.where(variance > 0.0, variance, np.inf)  # rounding alone is left of what the rows do not determine
    return _SmallMotion(
        place=place,
        stiffness=-float(solution[1] / scale[1]),
        gains=solution[4:] / scale[4:],
        stiffness_error=float(np.sqrt(variance[1])),
        gain_error=float(np.sqrt(variance[4:].sum())),
    )


def _weighted(estimates: Sequence[tuple[float, float]]) -> float:
    """Mean of estimates with standard errors: of the two wells, one may hardly have been visited, or never driven.

    NaN where none is known.
    """
    value, error = np.array(estimates).T
    if np.isinf(error).all():
        return np.nan
    weight = 1.0 / (error**2 + (WELLS_DIFFER * np.abs(value).min()) ** 2)
    return float(weight @ value / weight.sum())


def _reference_motion(parameters: JointParameters) -> _SmallMotion:
    """Small motions of the parameter set's joint, from its static curves."""
    k = constants(parameters, nominal_deviations(), static_slope_ratio(parameters))
    q = np.linspace(0.02, 0.24, 111) * parameters.l
    force, _, left, right = static_curves(q, k, np.zeros(3), np.zeros((CURVES, 0)))
    rest = int(np.flatnonzero((force[:-1] < 0.0) & (force[1:] >= 0.0))[-1])
    share = -force[rest] / (force[rest + 1] - force[rest])
    mass = float(k[INDEX["mass"]])
    return _SmallMotion(
        place=float(q[rest] + share * (q[1] - q[0])),
        stiffness=float((force[rest + 1] - force[rest]) / (q[1] - q[0]) / mass),
        gains=np.array([left[rest], right[rest]]) / mass,
    )


def prior_root(
    centres: int, rows: Sequence[int] = range(CURVES), siblings: NormalPopulation | None = None
) -> FloatArray:
    """Matrix A of the prior ‖A (θ − m)‖²/2 of deviations and corrections, both in widths, shape (P, P).

    Parameters
    ----------
    centres : int
        Number of Gaussians of each correction, symmetric about q = 0.
    rows : sequence of int
        The corrections whose weights θ holds, rows of `pipeline.models.hybrid.kernels.CURVES`.
    siblings : NormalPopulation, optional
        Of the deviations, where joints of the same drawing are known.
    """
    covariance = np.eye(len(NAMES) + CURVES * centres)
    for i, name in enumerate(NAMES):
        if name.startswith("left."):
            j = NAMES.index("right." + name.removeprefix("left."))
            covariance[i, j] = covariance[j, i] = 1.0 - (OWN_MATERIAL if "log" in name else OWN_MOUNT)
    if siblings is not None:
        covariance[: len(NAMES), : len(NAMES)] = siblings.covariance
    for row, name in enumerate(CORRECTIONS[:CURVES]):
        side, *rest = name.split("_")
        image = CORRECTIONS.index("_".join([{"left": "right", "right": "left"}.get(side, side), *rest]))
        sign = 1.0 if name in _EVEN else -1.0
        for n in range(centres):
            i, j = (len(NAMES) + r * centres + m for r, m in ((row, n), (image, centres - 1 - n)))
            if i != j:
                covariance[i, j] = sign * ALIKE
    places = theta_places(centres, rows)
    return np.asarray(np.linalg.inv(np.linalg.cholesky(covariance[np.ix_(places, places)])), dtype=np.float64)


def theta_places(centres: int, rows: Sequence[int]) -> IntArray:
    """Places in θ of the deviations and of the weights of some corrections."""
    weights = len(NAMES) + centres * np.asarray(rows, dtype=np.int64)[:, None] + np.arange(centres)
    return np.concatenate([np.arange(len(NAMES)), weights.ravel()])
