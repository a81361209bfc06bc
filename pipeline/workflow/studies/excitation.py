"""Excitation (§5.1): a designed voltage sequence, written as CSV or MAT with its description beside it."""

from collections.abc import Callable
from pathlib import Path
from typing import Any, ClassVar

import numpy as np
from pydantic import Field

from ...device.parameters import joint_parameters
from ...errors import InputError
from ...rig.excitation import BURSTS, ENDINGS, BurstKind, Sequence, command, save_sequence
from ...settings.logs import Number, SettingsTable, Whole
from ...settings.models import CENTRES
from ...settings.prototype import FIELD_LIMIT
from ...store.outputs import check_places, new_outputs, rebased
from .excitation_design import Assessment, Design, Requirements, design_excitation, drawn_simulators

_COMMAND = "rig excite"


class DesignFile(SettingsTable):
    """Rare settings of a design: the TOML file of `debist rig excite --design`."""

    gone: ClassVar = {"model": "leave it out: a sequence is designed for the joint of --parameters"}
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
    parameters: str,
    options: DesignFile,
    *,
    duration: float,
    voltage: float,
    report: Callable[[float], None] | None = None,
) -> tuple[Design, tuple[Path, ...]]:
    """Design a sequence within the limits and write it with its description beside it.

    Parameters
    ----------
    output : Path
        The sequence.
    parameters : str
        Parameter set of the joint as drawn; others are made after the drawing with tolerances.
    options : DesignFile
        The rare settings.
    duration : float
        Length [s].
    voltage : float
        Largest voltage of a converter [V].
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
    drawing = joint_parameters(parameters)
    thickness = min(drawing.left.d0, drawing.right.d0)
    wanted = Requirements(
        duration=duration,
        rest=options.rest_s,
        voltage=min(voltage, thickness * (1e6 * options.max_field_V_per_um)),
        kinds=options.kinds,
        candidates=options.candidates,
        basis_functions=options.basis_functions,
    )
    rng = np.random.default_rng(options.seed)
    design = design_excitation(drawn_simulators(drawing, rng, options.joints), rng, wanted, report=report)
    t = np.arange(round(duration * options.rate_Hz)) / options.rate_Hz
    about = description(design) | {
        "simulated_with": parameters,
        "seed": options.seed,
        "rate_hz": options.rate_Hz,
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
