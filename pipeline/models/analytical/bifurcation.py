"""Equilibrium diagram over z_b, over a voltage or over a force; z_b,min, z_b,max, switching voltage (figs. 3 to 5)."""

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from ...device.parameters import B_MAX, VECTOR_NAMES, JointParameters
from ...errors import InputError
from ...generated.analytical_joint import capacitance, static_sensitivity, statics
from ...numerics.arrays import FloatArray
from ...numerics.continuation import Branch, Residual, SpecialPoint, trace_branch
from ...numerics.stiff import RITZ
from .statics import (
    FULL_VOLTAGE,
    TYPICAL_SHAPE,
    StaticPath,
    describe_path,
    equilibria,
    find_equilibria,
    length_scales,
    static_path,
    tip_values,
)

_SEEDS = 7
_HIGHEST = 2.0 * FULL_VOLTAGE
SHOWN = np.linspace(-0.02, 0.02, 161)
"""Displacements [m] at which curves over q are shown."""


@dataclass(frozen=True)
class Family:
    """Joints and loads that depend on one parameter λ.

    Attributes
    ----------
    at : callable
        λ → (parameter vector (41,), voltages (2,) [V], force [N]).
    slope : callable
        (q_m, λ) → derivative of the static gradient ∂U/∂q_m − F ∂q/∂q_m with respect to λ, shape (4,).
    unit : float
        Change of λ that continuation takes for large.
    """

    at: Callable[[float], tuple[FloatArray, FloatArray, float]]
    slope: Callable[[FloatArray, float], FloatArray]
    unit: float


def screw_height(parameters: JointParameters) -> float:
    """z_b = b_max − b [m] (eq. 17), with the mean b of both sides."""
    return B_MAX - 0.5 * (parameters.left.b + parameters.right.b)


def with_screw_height(parameters: JointParameters, z_b: float) -> JointParameters:
    """The joint with both mounts moved until their mean is at z_b [m]; a difference between them stays."""
    shift = screw_height(parameters) - z_b
    return parameters.with_values({"left.b": parameters.left.b + shift, "right.b": parameters.right.b + shift})


def over_screw(parameters: JointParameters, v: FloatArray) -> Family:
    """λ = z_b [m] under constant voltages (figure 3)."""
    columns = [VECTOR_NAMES.index("left.b"), VECTOR_NAMES.index("right.b")]
    drawn = parameters.vector()
    own_height = screw_height(parameters)

    def vector(z_b: float) -> FloatArray:
        """Parameters of the joint whose mounts are at z_b [m]."""
        p = drawn.copy()
        p[columns] += own_height - z_b
        return p

    def slope(qm: FloatArray, z_b: float) -> FloatArray:
        """Derivative of the static gradient by z_b."""
        sensitivity = np.empty((RITZ, len(VECTOR_NAMES)))
        static_sensitivity(qm, v**2, vector(z_b), sensitivity)
        return np.asarray(-sensitivity[:, columns].sum(axis=1))

    return Family(lambda z_b: (vector(z_b), v, 0.0), slope, 0.01)


def over_voltage(parameters: JointParameters, side: int) -> Family:
    """λ = voltage [V] of one side (0 left, 1 right), the other zero."""
    p = parameters.vector()

    def slope(qm: FloatArray, value: float) -> FloatArray:
        """Derivative of the static gradient by the voltage."""
        farads = np.empty(2)
        jacobian = np.empty((2, RITZ))
        capacitance(qm, p, farads, jacobian)
        return np.asarray(-jacobian[side] * value)

    return Family(lambda value: (p, value * np.eye(2)[side], 0.0), slope, FULL_VOLTAGE)


def over_force(parameters: JointParameters, v: FloatArray) -> Family:
    """λ = external force [N] under constant voltages (figure 4)."""
    levers = parameters.levers
    p = parameters.vector()
    return Family(lambda force: (p, v, force), lambda qm, force: -levers, 0.1)


def _residual(family: Family, scale: FloatArray) -> Residual:
    """The scaled static gradient: y = q_m / scale, λ in units of `family.unit`."""
    gradient = np.empty(RITZ)
    hessian = np.empty((RITZ, RITZ))
    outer = np.outer(scale, scale)

    def residual(y: FloatArray, value: float) -> tuple[FloatArray, FloatArray, FloatArray]:
        """Scaled gradient, its derivatives by y and by the scaled parameter."""
        p, v, force = family.at(value * family.unit)
        qm = y * scale
        statics(qm, v**2, p, gradient, hessian)
        levers = np.append(p[0] ** np.arange(2, 5), 0.0)
        slope = family.slope(qm, value * family.unit) * family.unit
        return scale * (gradient - force * levers), hessian * outer, scale * slope

    return residual


def branch_through(family: Family, qm: FloatArray, value: float, bounds: tuple[float, float]) -> Branch:
    """The curve of equilibria through (q_m, λ); its `y` are q_m, its parameters λ.

    Parameters
    ----------
    family : Family
        The joints and their loads.
    qm : FloatArray, shape (4,)
        Ritz coordinates of an equilibrium.
    value : float
        Its λ, in the unit of the family.
    bounds : (float, float)
        Range of λ.
    """
    scale = TYPICAL_SHAPE * length_scales(float(family.at(value)[0][0]))
    unit = family.unit
    raw = trace_branch(_residual(family, scale), qm / scale, value / unit, bounds=(bounds[0] / unit, bounds[1] / unit))
    special = tuple(SpecialPoint(s.kind, s.parameter * unit, s.y * scale) for s in raw.special)
    return Branch(raw.parameter * unit, raw.y * scale, raw.stable, special)


def equilibrium_diagram(family: Family, bounds: tuple[float, float]) -> list[Branch]:
    """All branches over λ in `bounds`, those included that are not connected to the others; `y` are q [m] and φ [rad].

    At seven values of λ, the bounds among them, all equilibria are found by `equilibria`; each that lies on no traced
    branch starts one. A branch that begins in a fold between two of them and leaves through a bound is found there.
    Cost: 20 ms for each value, 20 to 50 ms for each branch.
    """
    branches: list[Branch] = []
    for value in np.linspace(*bounds, _SEEDS):
        p, v, force = family.at(float(value))
        scale = TYPICAL_SHAPE * length_scales(float(p[0]))
        for seed in find_equilibria(p, v, force):
            if not any(_lies_on(branch, seed.qm, float(value), scale, family.unit) for branch in branches):
                branches.append(branch_through(family, seed.qm, float(value), bounds))
    return [_with_tip(branch, family) for branch in branches]


def _lies_on(branch: Branch, qm: FloatArray, value: float, scale: FloatArray, unit: float) -> bool:
    """True if (q_m, λ) is within the chord error of a traced curve."""
    x = np.column_stack([branch.y / scale, branch.parameter / unit])
    along = np.diff(x, axis=0)
    target = np.append(qm / scale, value / unit)
    lengths = np.maximum((along**2).sum(axis=1), 1e-300)
    share = np.clip(((target - x[:-1]) * along).sum(axis=1) / lengths, 0.0, 1.0)
    return bool(np.min(np.linalg.norm(x[:-1] + share[:, None] * along - target, axis=1)) < 2e-3)


def _with_tip(branch: Branch, family: Family) -> Branch:
    p = family.at(float(branch.parameter[0]))[0]
    return replace(branch, y=np.array([tip_values(qm, p)[:2] for qm in branch.y]))


def bistable_from(parameters: JointParameters) -> float | None:
    """z_b,min [m]: where the joint without voltage becomes bistable; None if it does not up to 10 mm.

    The pitchfork of a symmetric joint, the fold of its second well in an asymmetric one.
    """
    return _smallest_with_two_wells(parameters, np.zeros(2), 0.01)


def switchable_to(parameters: JointParameters, voltage: float = FULL_VOLTAGE) -> float | None:
    """z_b,max [m]: the largest z_b at which `voltage` [V] on either side leaves one well; None if beyond 15 mm."""
    limits = [_smallest_with_two_wells(parameters, v, 0.015) for v in voltage * np.eye(2)]
    return min((limit for limit in limits if limit is not None), default=None)


def _smallest_with_two_wells(parameters: JointParameters, v: FloatArray, highest: float) -> float | None:
    """The special point up to `highest` [m] behind which there are two stable equilibria for the first time."""
    diagram = equilibrium_diagram(over_screw(parameters, v), (0.0, highest))
    for candidate in sorted({0.0, *(point.parameter for branch in diagram for point in branch.special)}):
        behind = with_screw_height(parameters, candidate + 1e-5)
        if sum(e.stable for e in equilibria(behind, v)) >= 2:
            return float(candidate)
    return None


@dataclass(frozen=True)
class SwitchingVoltage:
    """Lowest quasi-static voltages [V] that empty a well; None where 6 kV do not or where there is no second well."""

    left: float | None
    right: float | None

    @property
    def both_ways(self) -> float | None:
        """The voltage that switches in both directions."""
        return None if self.left is None or self.right is None else max(self.left, self.right)


def switching_voltage(parameters: JointParameters) -> SwitchingVoltage:
    """The left voltage at which the left well vanishes in a fold, and the right one at which the right does."""
    wells = [e for e in equilibria(parameters, np.zeros(2)) if e.stable]
    if len(wells) < 2:
        return SwitchingVoltage(None, None)
    branches = [
        branch_through(over_voltage(parameters, side), well.qm, 0.0, (0.0, _HIGHEST))
        for side, well in ((0, wells[0]), (1, wells[-1]))
    ]
    # v² is even in v: a branch runs to both signs, and only its upward half is looked at.
    folds = ([s.parameter for s in branch.special if s.kind == "fold" and s.parameter > 0.0] for branch in branches)
    return SwitchingVoltage(*(min(upward, default=None) for upward in folds))


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
    diagrams : dict of str to list of Branch
        Equilibria over z_b under each of `VOLTAGE_STATES`.
    """

    z_b_min: float | None
    z_b_max: float | None
    switching: SwitchingVoltage
    barrier: float | None
    paths: dict[str, StaticPath]
    diagrams: dict[str, list[Branch]]


def characteristics(parameters: JointParameters, *, voltage: float = FULL_VOLTAGE) -> Characteristics:
    """Equilibrium diagram, F(q), C_i(q) and what they say as numbers, at a driving voltage [V]."""
    rest = equilibria(parameters, np.zeros(2))
    wells = [e.energy for e in rest if e.stable]
    saddles = [e.energy for e in rest if not e.stable]
    states = {name: voltage * np.array(state) for name, state in VOLTAGE_STATES.items()}
    return Characteristics(
        z_b_min=bistable_from(parameters),
        z_b_max=switchable_to(parameters, voltage),
        switching=switching_voltage(parameters),
        barrier=min(saddles) - max(wells) if len(wells) > 1 and saddles else None,
        paths={name: _held_joint(parameters, v) for name, v in states.items()},
        diagrams={name: equilibrium_diagram(over_screw(parameters, v), (0.0, 0.01)) for name, v in states.items()},
    )


def _held_joint(parameters: JointParameters, v: FloatArray) -> StaticPath:
    """F(q) and C(q) over ±20 mm; along the branch, q turning back, where the beam snaps with its tip held."""
    try:
        return static_path(parameters, SHOWN, v)
    except InputError:
        shapes = branch_through(over_force(parameters, v), equilibria(parameters, v)[0].qm, 0.0, (-1.0, 1.0)).y
        return describe_path(parameters, shapes[np.abs(shapes @ parameters.levers) <= SHOWN[-1]], v)
