"""The analytical model for designers: statics, characteristic curves, motions, modes, reduction, calibration."""

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from ...device.parameters import QUANTITIES, JointParameters, parameter_file
from ...errors import InputError
from ...models.analytical.bifurcation import SHOWN
from ...models.analytical.calibration import Calibration, calibrate as fit
from ...models.analytical.reduced_order import Motions, pulse_sequence, simulate_both
from ...models.analytical.statics import static_path
from ...numerics.arrays import FloatArray
from ...signals.log import Log, log_of, voltages
from ...store.outputs import new_outputs
from ...store.tables import Table, read_table
from ..run_contents import between


def energy_over_q(
    joint: JointParameters, *, v1: float, v2: float, force: float
) -> tuple[FloatArray, FloatArray] | None:
    """Displacement q [m] and the total potential U − ½ΣC_i v_i² − F q [J] of the joint whose tip is held at q.

    None where the beam snaps although its tip is held: no curve over q exists then.

    Parameters
    ----------
    joint : JointParameters
        The joint.
    v1, v2 : float
        Voltages [V] of the left and the right membrane.
    force : float
        External force along q [N].
    """
    try:
        path = static_path(joint, SHOWN, np.array([v1, v2]))
    except InputError:
        return None
    return path.q, path.energy - force * path.q


def _columns(path: Path, *needed: str) -> Table:
    """A table of a run that has these columns."""
    if path.suffix != ".parquet" or not path.is_file():
        raise InputError(f"{path}: no table of a run; name one such as runs/P1/train/LOG/kinematics.parquet")
    table = read_table(path)
    if missing := [name for name in needed if name not in table]:
        raise InputError(f"{path}: has no column {missing[0]!r}; {', '.join(needed)} are needed")
    return table


def simulate(parameters: JointParameters, voltage: float, signals: Path | None = None) -> Motions:
    """The full-order and the reduced model under the voltages of a run, or under pulses of `voltage` [V].

    The motion starts at rest: at the first valid q of the run's `signals.parquet`, or in the left well.

    Raises
    ------
    InputError
        The table lacks a voltage.
    """
    if signals is None:
        return simulate_both(parameters, *pulse_sequence(voltage))
    table = _columns(signals, "t", "v1", "v2")
    q = table["q"][np.isfinite(table["q"])] if "q" in table else np.empty(0)
    return simulate_both(parameters, table["t"], voltages(table), q0=float(q[0]) if q.size else None)


def calibrate(
    kinematics: Sequence[Path],
    parameters: JointParameters,
    *,
    names: Sequence[str],
    jobs: int,
    report: Callable[[str, float], None] | None = None,
) -> Calibration:
    """Fit the named parameters to the gap-free segments of `kinematics.parquet` files.

    Voltages between the samples come from the ``record.parquet`` beside each, where there is one.

    Parameters
    ----------
    kinematics : sequence of Path
        Tables of runs.
    parameters : JointParameters
        Set to start from.
    names : sequence of str
        Parameters that are fitted.
    jobs : int
        Threads.
    report : callable, optional
        Receives what is done, and its share.

    Raises
    ------
    InputError
        A table lacks a column, or none has a segment of motion.
    """

    def motion(path: Path) -> Log:
        """A log, with the voltages between its samples where the run's record is beside it."""
        table = _columns(path, "t", "q", "qdot", "qddot", "v1", "v2", "segment")
        record = path.with_name("record.parquet")
        return log_of(table, between(table["t"], _columns(record, "t", "v1", "v2")) if record.is_file() else None)

    motions = [segment for path in kinematics for segment in motion(path).segments()]
    if not motions:
        raise InputError("there is nothing to calibrate on; name kinematics.parquet files with valid samples")
    return fit(motions, parameters, names=names, jobs=jobs, report=report)


def write_parameters(fit: Calibration, target: Path) -> None:
    """Write a calibrated set as TOML with its standard errors as comments; errors as for `new_outputs`."""
    errors = {name: f"± {error:.2g}" for name, error in zip(fit.names, fit.standard_errors, strict=True)}
    with new_outputs(target.parent, "physics calibrate", force=None, names=(target.name,)) as staged:
        (staged / target.name).write_text(parameter_file(fit.parameters, errors), encoding="utf-8", newline="\n")


def calibration_document(fit: Calibration) -> dict[str, Any]:
    """The result of a calibration for `--json`: values and standard errors in SI units."""
    return {
        "parameters": [
            {"name": name, "value": value, "standard_error": error, "unit": QUANTITIES[name].unit}
            for name, value, error in zip(fit.names, fit.values, fit.standard_errors, strict=True)
        ],
        "correlation": fit.correlation,
        "at_bound": list(fit.at_bound),
        "rmse": fit.rmse,
        "converged": fit.converged,
        "evaluations": fit.evaluations,
    }
