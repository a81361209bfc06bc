"""The analytical model for designers: statics, characteristic curves, motions, modes, reduction, calibration."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from pipeline.errors import InputError
from pipeline.numerics.arrays import FloatArray

if TYPE_CHECKING:
    from pipeline.physics.bifurcation import EquilibriumBranch, SwitchingVoltage
    from pipeline.physics.calibration import Calibration
    from pipeline.physics.equilibria import Equilibrium
    from pipeline.physics.full_order import Trajectory as Motion
    from pipeline.physics.modes import BeamModes
    from pipeline.physics.parameters import JointParameters
    from pipeline.physics.reduced_order import ReducedMotion
    from pipeline.physics.static_path import StaticPath

VOLTAGE_STATES = {"off": (0.0, 0.0), "left": (1.0, 0.0), "right": (0.0, 1.0), "both": (1.0, 1.0)}
"""Voltage states of figures 3 to 5, in units of the driving voltage."""


def equilibria(
    parameters: "JointParameters", *, b: float | None = None, v1: float = 0.0, v2: float = 0.0, force: float = 0.0
) -> "list[Equilibrium]":
    """All equilibria under v1 (left), v2 (right) [V] and a force [N], with both mounts at b [m] if given."""
    from pipeline.physics.bifurcation import with_screw_height
    from pipeline.physics.equilibria import equilibria as find
    from pipeline.physics.parameters import B_MAX

    joint = parameters if b is None else with_screw_height(parameters, B_MAX - b)
    return find(joint, np.array([v1, v2]), force)


@dataclass(frozen=True)
class Characteristics:
    """Figures 3 to 5 as numbers.

    Attributes
    ----------
    z_b_min, z_b_max : float or None
        Range of z_b [m] in which the joint is bistable and can be switched; None: not within 0 to 15 mm.
    switching : SwitchingVoltage
        Lowest quasi-static voltages [V] at the set's own b.
    barrier : float or None
        Energy [J] from the shallower well up to the saddle between the wells; None without two wells.
    paths : dict of str to StaticPath
        Held joint under each of `VOLTAGE_STATES`.
    diagrams : dict of str to list of EquilibriumBranch
        Equilibria over z_b under each of `VOLTAGE_STATES`.
    """

    z_b_min: float | None
    z_b_max: float | None
    switching: "SwitchingVoltage"
    barrier: float | None
    paths: "dict[str, StaticPath]"
    diagrams: "dict[str, list[EquilibriumBranch]]"


def characteristics(
    parameters: "JointParameters", *, voltage: float = 3000.0, reach: float = 0.02, count: int = 161
) -> Characteristics:
    """Equilibrium diagram, F(q), C_i(q) and what they say as numbers, at a driving voltage [V], over ±reach [m]."""
    from pipeline.physics import bifurcation
    from pipeline.physics.equilibria import equilibria as find
    from pipeline.physics.static_path import static_path

    rest = find(parameters, np.zeros(2))
    wells, saddles = [e.energy for e in rest if e.stable], [e.energy for e in rest if not e.stable]
    paths, diagrams = {}, {}
    for name, state in VOLTAGE_STATES.items():
        v = voltage * np.array(state)
        paths[name] = static_path(parameters, np.linspace(-reach, reach, count), v)
        diagrams[name] = bifurcation.equilibrium_diagram(bifurcation.over_screw(parameters, v), (0.0, 0.01))
    return Characteristics(
        bifurcation.bistable_from(parameters),
        bifurcation.switchable_to(parameters, voltage),
        bifurcation.switching_voltage(parameters),
        min(saddles) - max(wells) if len(wells) > 1 and saddles else None,
        paths,
        diagrams,
    )


def pulse_sequence(
    voltage: float = 3000.0, *, pulse: float = 0.5, pause: float = 1.0, count: int = 4, dt: float = 1e-3
) -> tuple[FloatArray, FloatArray]:
    """Times [s] and voltages (N, 2) [V]: left, right, left … pulses of `pulse` [s] with pauses, as in figure 7."""
    period = pulse + pause
    t = np.arange(round(count * period / dt) + 1) * dt
    v = np.zeros((t.size, 2))
    number = np.minimum((t / period).astype(int), count - 1)
    on = (t - number * period >= 0.5 * pause) & (t - number * period < 0.5 * pause + pulse)
    v[on, number[on] % 2] = voltage
    return t, v


def measured_voltages(signals: Path) -> tuple[FloatArray, FloatArray, float | None]:
    """Times [s], voltages (N, 2) [V] and the first valid q [m] of a run's `signals.parquet`.

    Raises
    ------
    InputError
        The table lacks a voltage.
    """
    from pipeline.artifacts.tables import read_table

    table = read_table(signals)
    if missing := [name for name in ("t", "v1", "v2") if name not in table]:
        raise InputError(f"{signals}: has no column {missing[0]!r}; both voltages are needed")
    q = table["q"][np.isfinite(table["q"])] if "q" in table else np.empty(0)
    return table["t"], np.column_stack([table["v1"], table["v2"]]), float(q[0]) if q.size else None


@dataclass(frozen=True)
class Motions:
    """The same motion by the full and the reduced model, with the processor time [s] of each."""

    v: FloatArray
    full: "Motion"
    reduced: "ReducedMotion"
    full_seconds: float
    reduced_seconds: float

    @property
    def nrmse(self) -> dict[str, float | None]:
        """NRMSE (eq. 41) of the reduced against the full model; None where one of them diverged."""
        pairs = {
            "q": (self.full.q, self.reduced.q),
            "qdot": (self.full.q_dot, self.reduced.q_dot),
            "qddot": (self.full.q_ddot, self.reduced.q_ddot),
        }
        whole = self.full.diverged_at is None and self.reduced.diverged_at is None
        return {
            name: float(np.sqrt(np.mean((a - b) ** 2)) / np.ptp(a)) if whole else None for name, (a, b) in pairs.items()
        }


def simulate(
    parameters: "JointParameters", t: FloatArray, v: FloatArray, *, q0: float | None = None, tolerance: float = 1e-5
) -> Motions:
    """Free run of the full-order and the reduced model from rest at q0 [m], or in the left well."""
    import time

    from pipeline.physics.equilibria import equilibria as find
    from pipeline.physics.full_order import rest_state
    from pipeline.physics.full_order import simulate as run_full
    from pipeline.physics.reduced_order import simulate_reduced
    from pipeline.physics.reduction import reduce_joint

    start = q0 if q0 is not None else next(e.q for e in find(parameters, v[0]) if e.stable)
    state, reduced = rest_state(parameters, start, 0.0, v[0]), reduce_joint(parameters)
    # The first calls load compiled code; the times are those of the simulations.
    run_full(parameters, t[:2], v[:2], state)
    simulate_reduced(reduced, t[:2], v[:2], start, 0.0)
    clock = [time.process_time()]
    full = run_full(parameters, t, v, state, tolerance=tolerance)
    clock.append(time.process_time())
    short = simulate_reduced(reduced, t, v, start, 0.0)
    clock.append(time.process_time())
    return Motions(v, full, short, clock[1] - clock[0], clock[2] - clock[1])


def modes(parameters: "JointParameters", motion: "Motion") -> "BeamModes":
    """Modes of the beam in a simulated motion (figure 6a)."""
    from pipeline.physics.modes import beam_modes

    return beam_modes(motion.qm, parameters.l)


def calibrate(
    kinematics: Sequence[Path],
    parameters: "JointParameters",
    *,
    names: Sequence[str],
    starts: int,
    seed: int,
    jobs: int,
    report: Callable[[str, float], None] | None = None,
) -> "Calibration":
    """Fit the named parameters to the gap-free stretches of `kinematics.parquet` files."""
    from pipeline.artifacts.tables import read_table
    from pipeline.physics.calibration import calibrate as fit
    from pipeline.stages.trajectories import trajectories

    motions = [motion for path in kinematics for motion in trajectories(read_table(path))]
    if not motions:
        raise InputError("there is nothing to calibrate on; name kinematics.parquet files with valid samples")
    return fit(motions, parameters, np.random.default_rng(seed), names=names, starts=starts, jobs=jobs, report=report)


def calibration_document(fit: "Calibration") -> dict[str, Any]:
    """The result of a calibration for `--json`: values and standard errors in SI units."""
    from pipeline.physics.parameters import QUANTITIES

    rows = zip(fit.names, fit.values, fit.standard_errors, strict=True)
    return {
        "parameters": [
            {"name": name, "value": value, "standard_error": error, "unit": QUANTITIES[name].unit}
            for name, value, error in rows
        ],
        "correlation": fit.correlation,
        "at_bound": list(fit.at_bound),
        "rmse": fit.rmse,
        "converged": fit.converged,
        "evaluations": fit.evaluations,
        "start_rmse": fit.start_costs,
    }
