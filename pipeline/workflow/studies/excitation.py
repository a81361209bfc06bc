"""Excitation: a designed voltage sequence for a rig, from a parameter set, to CSV or MAT."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from itertools import islice
from pathlib import Path
from typing import Any

import numpy as np
from pydantic import Field

from ...device.parameters import JointParameters, joint_parameters
from ...errors import InputError
from ...models.analytical.reduced_order import reduce_joint, simulate_reduced
from ...models.analytical.statics import equilibria
from ...numerics.arrays import FloatArray
from ...rig.excitation import BURSTS, ENDINGS, BurstKind, Sequence, command, save_sequence
from ...settings.logs import Number, SettingsTable, Whole
from ...settings.models import CENTRES
from ...settings.prototype import FIELD_LIMIT
from ...store.outputs import check_places, new_outputs, rebased
from .excitation_design import Assessment, Design, Requirements, Simulator, design_excitation

_COMMAND = "rig excite"


@dataclass(frozen=True)
class ExcitationSource:
    """The joints that simulate the design.

    Attributes
    ----------
    parameters : str
        Parameter set.
    joints : int
        The joint as drawn, and others made after the drawing with tolerances.
    seed : int
        Draws the tolerances and the candidates.
    """

    parameters: str = "nominal"
    joints: int = 4
    seed: int = 1


class DesignFile(SettingsTable):
    """Rare settings of a design: the TOML file of `debist rig excite --design`."""

    joints: Whole = Field(default=4, ge=1, le=20)
    """Joints with workshop tolerances to design for at once."""
    seed: Whole = Field(default=1, ge=0)
    """Draws the tolerances and the candidates."""
    max_field_V_per_um: Number = Field(default=FIELD_LIMIT, gt=0.0)
    """Largest field in the undeformed film."""
    rest_s: Number = Field(default=1.0, ge=0.0)
    """Rest before the first burst."""
    rate_Hz: Number = Field(default=1000.0, ge=100.0, le=100e3)
    """Rate of the written samples."""
    kinds: tuple[BurstKind, ...] = Field(default=BURSTS, min_length=1)
    """Bursts to use."""
    basis_functions: Whole = Field(default=CENTRES, ge=2, le=50)
    """Basis functions of each curve."""
    candidates: Whole = Field(default=24, ge=1, le=1000)
    """Bursts tried for each place."""


def excite(
    output: Path,
    source: ExcitationSource,
    wanted: Requirements,
    rate: float,
    *,
    voltage: float,
    field: float,
    report: Callable[[float], None] | None = None,
) -> tuple[Design, tuple[Path, ...]]:
    """Design a sequence within the limits and write it at `rate` [Hz] with its description beside it.

    Parameters
    ----------
    output : Path
        The sequence.
    source : ExcitationSource
        Joints that it is designed for.
    wanted : Requirements
        Duration, bursts and candidates.
    rate : float
        Sampling rate of the file [Hz].
    voltage : float
        Largest voltage of a converter [V].
    field : float
        Largest field in an undeformed film [V/m].
    report : callable, optional
        Receives the share that is done.

    Returns
    -------
    Design
        The sequence with its assessment.
    tuple of Path
        The files written.

    Raises
    ------
    InputError
        A limit, rate, file ending or source that is not usable, or a file of others where it shall be written.
    """
    if output.suffix.lower() not in ENDINGS:
        raise InputError(f"{output}: a sequence is written as {' or '.join(ENDINGS)}; name the file so")
    check_places(output.parent, (output.name, output.with_suffix(".json").name), _COMMAND, force=None)
    parameters = joint_parameters(source.parameters)
    thickness = min(parameters.left.d0, parameters.right.d0)
    wanted = replace(wanted, voltage=min(voltage, thickness * field))
    rng = np.random.default_rng(source.seed)
    simulators = drawn_simulators(parameters, rng, source.joints)
    design = design_excitation(simulators, rng, wanted, report=report)
    t = np.arange(round(wanted.duration * rate)) / rate
    about = description(design) | {
        "simulated_with": source.parameters,
        "seed": source.seed,
        "rate_hz": rate,
        "largest_field_v_per_m": wanted.voltage / thickness,
    }
    with new_outputs(output.parent, _COMMAND, force=None) as staged:
        files = save_sequence(staged / output.name, Sequence(t, command(design.bursts, t)), about)
    return design, tuple(rebased(file, staged, output.parent) for file in files)


def description(design: Design) -> dict[str, Any]:
    """The design as plain numbers in SI units: for `--json` and beside the sequence."""
    return {
        "format": "debist-excitation/1",
        "channels": {"time": "s", "v1": "V, command to the left converter", "v2": "V, command to the right converter"},
        "duration_s": design.wanted.duration,
        "largest_voltage_v": design.wanted.voltage,
        "bursts": [vars(burst) for burst in design.bursts],
        "relative_d_efficiency": design.efficiency,
        "centres_m": design.weights.centres,
        "designed": _figures(design.designed),
        "alternating_pulses": _figures(design.plain),
    }


def _figures(assessment: Assessment) -> dict[str, Any]:
    return {
        "log_information_per_weight": assessment.log_information,
        "log_det_unit_columns_per_weight": assessment.conditioning.log_det,
        "condition": assessment.conditioning.condition,
        "silent_weights": assessment.conditioning.silent,
        "covered_share": assessment.covered,
        "samples_per_centre": assessment.visits.visits,
        "samples_per_centre_driven": assessment.visits.driven,
        "crossings": assessment.crossings,
    }


_RELATIVE = 0.03  # of the stiffness, rubber and permittivity, uniform
_FREE_LENGTH = 0.3e-3  # m, of each membrane, uniform
_MOST_DRAWS = 40


def drawn_simulators(parameters: JointParameters, rng: np.random.Generator, count: int) -> list[Simulator]:
    """The joint as drawn, and `count` − 1 joints with tolerances that still rest in two wells.

    Raises
    ------
    InputError
        The drawing has no two wells, or too few of the joints made after it have.

    Notes
    -----
    Cost: some 50 ms a joint; a run of 37.5 s takes 4 ms.
    """
    if (first := _simulator(parameters)) is None:
        raise InputError("the parameter set has no two wells at zero voltage; see `debist physics equilibria`")
    made = (_simulator(_made(parameters, rng)) for _ in range(_MOST_DRAWS))
    simulators = [first, *islice((simulator for simulator in made if simulator is not None), count - 1)]
    if len(simulators) < count:
        raise InputError(
            f"only {len(simulators)} of {_MOST_DRAWS} joints made after the drawing have two wells; "
            "take fewer `joints`, or a drawing that is less near the edge"
        )
    return simulators


def _made(parameters: JointParameters, rng: np.random.Generator) -> JointParameters:
    """A joint as a workshop makes it: both membranes each with its own tolerances."""
    names = ("E", "left.Y", "right.Y", "left.eps_r", "right.eps_r")
    values = {name: parameters.value(name) * (1.0 + rng.uniform(-_RELATIVE, _RELATIVE)) for name in names}
    lengths = ("left.l0", "right.l0")
    values |= {name: parameters.value(name) + rng.uniform(-_FREE_LENGTH, _FREE_LENGTH) for name in lengths}
    return parameters.with_values(values)


def _simulator(parameters: JointParameters) -> Simulator | None:
    """Motion of the reduced joint from rest in its left well; None without two wells."""
    stable = [rest.q for rest in equilibria(parameters, np.zeros(2)) if rest.stable]
    if len(stable) < 2:
        return None
    reduced = reduce_joint(parameters)
    start = min(stable)

    def simulate(t: FloatArray, v: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Displacement [m] and velocity [m/s], shape (N,), at t [s] under the voltages v [V], shape (N, 2)."""
        motion = simulate_reduced(reduced, t, v, start, 0.0)
        return motion.q, motion.qdot

    return simulate
