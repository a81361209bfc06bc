"""What makes training data unfit: places, inputs or wells of which they say nothing, so that curves would be invented.

The training logs of thirty joints and a quarter drone have at least 4 samples at each of ten centres and a condition
number of at most 81; the bounds leave room below and above.
"""

import numpy as np

from pipeline.errors import DataRefusedError, InputError
from pipeline.identification.excitation import Excitation, examine_excitation
from pipeline.identification.rbf import InputLaw
from pipeline.numerics.arrays import FloatArray, IntArray
from pipeline.scoring.wells import NoWells
from pipeline.signals.quality_gates import Finding
from pipeline.signals.signal_quality import noise_level

LEAST_VISITS = 3
"""Samples nearest to a basis centre, below which its weight is the ridge's choice."""
LARGEST_CONDITION = 1e4
"""Of the regressor on unit-norm columns: beyond it, an error of 0.01 % in the data is one of 100 % in some weight."""
IDLE_NOISES = 12.0
"""A span of as many standard deviations of the noise as that of 10⁶ normal samples is no motion."""


def excitation_findings(
    q: FloatArray,
    v: FloatArray,
    segment: IntArray,
    interval: float,
    *,
    inputs: InputLaw,
    basis_functions: int,
    smoothing: float,
    bistable: bool,
) -> list[Finding]:
    """What speaks against a model from these training data.

    Parameters
    ----------
    q : FloatArray, shape (N,)
        Displacement of all training logs, one after the other; NaN where masked.
    v : FloatArray, shape (N, K)
        Inputs.
    segment : IntArray, shape (N,)
        Number of the gap-free stretch, different for each log; negative where masked.
    interval : float
        Sample interval [s].
    inputs : {"squared", "linear"}
        How the inputs act.
    basis_functions, smoothing : int, float
        M and σ_n of the curves that are to be identified.
    bistable : bool
        Whether the device is known to have two wells.

    Raises
    ------
    DataRefusedError
        No stretch is long enough to identify anything.

    Notes
    -----
    Cost: one pass of the regressor, O(N M²).
    """
    valid = (segment >= 0) & np.isfinite(q)
    if not valid.any() or _idle(q[valid]):
        advice = "drive the device through its whole stroke"
        return [Finding("idle", "the displacement shows nothing but noise: no excitation", advice)]
    undriven = [k for k in range(v.shape[1]) if _idle(v[valid, k])]
    found = [
        Finding(
            "undriven",
            f"input v{k + 1} never changes by more than its noise: nothing is known of its gain",
            f"drive it, or leave it out of [channels] (v{k + 1})",
        )
        for k in undriven
    ]
    try:
        excitation = examine_excitation(
            q, v, segment, interval, inputs=inputs, basis_functions=basis_functions, smoothing=smoothing
        )
    except InputError as error:
        raise DataRefusedError(str(error)) from error
    return found + _of_places(excitation, basis_functions, conditioned=not undriven, bistable=bistable)


def _of_places(excitation: Excitation, centres: int, *, conditioned: bool, bistable: bool) -> list[Finding]:
    found = []
    fewest, condition = int(excitation.visits.visits.min()), excitation.conditioning
    if fewest < LEAST_VISITS:
        place = excitation.centres[int(np.argmin(excitation.visits.visits))]
        found.append(
            Finding(
                "visits",
                f"the basis centre at q = {place:.4g} (SI) has {fewest} of at least {LEAST_VISITS} training samples",
                f"excite that place, or set fewer than {centres} [identify] basis_functions",
            )
        )
    if conditioned and (condition.silent or condition.condition > LARGEST_CONDITION):
        text = f"condition number {condition.condition:.3g} (at most {LARGEST_CONDITION:g}), {condition.silent} zero"
        found.append(
            Finding("rank", f"the regressor's columns cannot be told apart: {text}", "vary the inputs independently")
        )
    if bistable and isinstance(excitation.wells, NoWells) and excitation.wells.one_cluster:
        text = "only one well is visited: of the other half of every curve the data say nothing"
        found.append(
            Finding("one-well", text, "add pulses that snap the joint to the other side (`debist rig excite`)")
        )
    return found


def _idle(samples: FloatArray) -> bool:
    return bool(np.ptp(samples) <= IDLE_NOISES * noise_level(samples))
