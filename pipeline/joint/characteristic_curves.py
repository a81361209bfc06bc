"""Figures 3 to 5 as numbers and curves: where the joint is bistable, what switches it, F(q) and C_i(q)."""

from dataclasses import dataclass

import numpy as np

from pipeline.errors import InputError
from pipeline.joint import bifurcation
from pipeline.joint.bifurcation import EquilibriumBranch, SwitchingVoltage
from pipeline.joint.equilibria import equilibria
from pipeline.joint.parameters import JointParameters
from pipeline.joint.static_path import StaticPath, describe_path, static_path
from pipeline.numerics.arrays import FloatArray

VOLTAGE_STATES = {"off": (0.0, 0.0), "left": (1.0, 0.0), "right": (0.0, 1.0), "both": (1.0, 1.0)}
"""Voltage states of figures 3 to 5, in units of the driving voltage."""


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
    switching: SwitchingVoltage
    barrier: float | None
    paths: dict[str, StaticPath]
    diagrams: dict[str, list[EquilibriumBranch]]


def characteristics(
    parameters: JointParameters, *, voltage: float = 3000.0, reach: float = 0.02, count: int = 161
) -> Characteristics:
    """Equilibrium diagram, F(q), C_i(q) and what they say as numbers, at a driving voltage [V], over ±reach [m]."""
    rest = equilibria(parameters, np.zeros(2))
    wells, saddles = [e.energy for e in rest if e.stable], [e.energy for e in rest if not e.stable]
    paths, diagrams = {}, {}
    for name, state in VOLTAGE_STATES.items():
        v = voltage * np.array(state)
        paths[name] = _held_joint(parameters, v, reach, count)
        diagrams[name] = bifurcation.equilibrium_diagram(bifurcation.over_screw(parameters, v), (0.0, 0.01))
    return Characteristics(
        bifurcation.bistable_from(parameters),
        bifurcation.switchable_to(parameters, voltage),
        bifurcation.switching_voltage(parameters),
        min(saddles) - max(wells) if len(wells) > 1 and saddles else None,
        paths,
        diagrams,
    )


def _held_joint(parameters: JointParameters, v: FloatArray, reach: float, count: int) -> StaticPath:
    """F(q) and C(q) over ±reach [m]; along the branch, q turning back, where the beam snaps with its tip held."""
    try:
        return static_path(parameters, np.linspace(-reach, reach, count), v)
    except InputError:
        family, start = bifurcation.over_force(parameters, v), equilibria(parameters, v)[0]
        branch = bifurcation.branch_through(family, start.qm, 0.0, (-1.0, 1.0))
        q = branch.y[:, :3] @ parameters.l ** np.arange(2, 5)
        return describe_path(parameters, branch.y[np.abs(q) <= reach], v)
