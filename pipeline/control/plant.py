"""The identified joint as a plant: forces, instruments and limits, equilibria and the linear models about them."""

import importlib
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from ..codegen.numba_writer import formula, kernel
from ..errors import InputError
from ..generated.condensed_joint import BRANCHES, DRY_LEVELS, ELEMENT_STATES, SHAPE, STATES, STOPS
from ..generated.condensed_joint_jacobian import JACOBIAN, PREPARE
from ..generated.terms import BELL_SHAPE
from ..models.hybrid.kernels import CURVES, INDEX, VALUES, corrections_at, mass_matrix, prepare, rest_forces
from ..models.hybrid.statics import rest_state, still
from ..numerics.arrays import FloatArray
from ..numerics.compiled import compiled
from ..numerics.continuation import outermost_pair

if TYPE_CHECKING:
    from ..models.hybrid.log_reading import Instruments
    from ..models.hybrid.model import HybridModel


NAMES = (
    "q", "q_dot", "tau", "tau_dot", "beta", "beta_dot",
    *(f"strain_{side}_{i}" for i in range(BRANCHES) for side in ("left", "right")),
    *(name for name, _ in ELEMENT_STATES),
)  # fmt: skip
"""States of the joint, see `pipeline.equations.condensed_joint`."""
UNITS = ("m", "m/s", "1", "1/s", "1", "1/s", *("1",) * (2 * BRANCHES), *(unit for _, unit in ELEMENT_STATES))


ASSUMED_LAG = 4e-3
"""Assumed time constant [s] of unknown converters."""
_SAME = 1e-5  # m, between two equilibria that are one
_BEYOND = 0.5
"""Margin beyond the measured rests within which equilibria are sought, as a share of their distance. If the logs show
no rests: the limit, as a share of the wall. A beam's identified length is no measure: other parameters offset it."""
_PREPARED = PREPARE.outputs["p"]
_RATES = JACOBIAN.outputs["f"]
_BY_CORRECTIONS = JACOBIAN.outputs["by_c"]
_ITERATIONS = 40  # steps of Newton's method
_LONGEST = 2e4  # of a move, in steps of the differences
_TOLERANCE = 1e-3  # of the last move, in the same steps


class Constants(NamedTuple):
    """Arguments of the kernels for one joint: constants, prepared constants, RBF basis and weights."""

    k: FloatArray
    p: FloatArray
    basis: FloatArray
    weights: FloatArray


@dataclass(frozen=True)
class ControlledJoint:
    """One identified joint, or one draw from its posterior.

    Attributes
    ----------
    constants : Constants
        Of the joint.
    instruments : Instruments
        Offset of the laser, delay of the voltages, charging of the membranes.
    highest : float
        Largest trained voltage [V].
    wall : float
        Displacement [m] that no motion of the joint passes: half its length. The model's free runs end nearer.
    rests : tuple of float or None
        Readings [m] at which the logs show the joint at rest, left and right; None where they show no two wells.
    """

    constants: Constants
    instruments: "Instruments"
    highest: float
    wall: float
    rests: tuple[float, float] | None = None

    def reading(self, q: float) -> float:
        """Reading of the laser [m] at the displacement q [m]."""
        return q + self.instruments.offset


def plant_of(model: "HybridModel", rests: tuple[float, float] | None = None) -> ControlledJoint:
    """The plant of an identified hybrid joint, whose logs show these rests (readings [m])."""
    theta = model.theta
    condensed = model.joint
    k = condensed.in_use(theta)
    constants = Constants(k, prepare(k[None])[0], condensed.basis, condensed.weights(theta))
    return ControlledJoint(
        constants=constants,
        instruments=condensed.instruments(theta),
        highest=condensed.largest_voltage,
        wall=0.5 * condensed.length,
        rests=rests,
    )


@compiled
def inertia(x: FloatArray, p: FloatArray) -> FloatArray:
    """The mass matrix of (q, τ, β) at the state x, shape (3, 3) [kg, kg·m, kg·m²]; p are the prepared constants."""
    upper = np.zeros(6)
    mass_matrix(x, p, upper)
    return np.array([[upper[0], upper[1], upper[3]], [upper[1], upper[2], upper[4]], [upper[3], upper[4], upper[5]]])


@compiled
def forces(x: FloatArray, u: FloatArray, c: Constants) -> FloatArray:
    """Generalised forces on (q, τ, β) at rest [N, N·m, J], shape (3,), friction left out.

    Parameters
    ----------
    x : FloatArray, shape (STATES,)
        State.
    u : FloatArray, shape (2,)
        Squared voltages of left and right [V²].
    c : Constants
        Of the joint.
    """
    values = np.zeros(VALUES)
    out = np.empty(3)
    corrections_at(x[0], c.basis, c.weights, values)
    rest_forces(x, u, values, c.p, out, np.empty(6))
    return out


_prepare = kernel(PREPARE)
_slopes = kernel(JACOBIAN)
_bell = formula(BELL_SHAPE)


@dataclass(frozen=True)
class LinearModel:
    """ẋ = A (x − x₀) + B (v − v₀), reading − q₀ = C (x − x₀) + D (v − v₀), friction left out.

    Attributes
    ----------
    q : float
        Reading of the laser at the equilibrium [m].
    v : FloatArray, shape (2,)
        Constant voltages [V].
    x : FloatArray, shape (STATES,)
        State at the equilibrium.
    a, b, c, d : FloatArray, shapes (STATES, STATES), (STATES, 2), (1, STATES), (1, 2)
        Inputs are the voltages [V], the output is the laser's reading [m].
    b_squared : FloatArray, shape (STATES, 2)
        B for the squared voltages [V²]: the voltages' own B is zero at zero voltage.
    """

    q: float
    v: FloatArray
    x: FloatArray
    a: FloatArray
    b: FloatArray
    c: FloatArray
    d: FloatArray
    b_squared: FloatArray

    @property
    def poles(self) -> "np.ndarray[Any, np.dtype[np.complex128]]":
        """Eigenvalues of A [1/s], shape (STATES,), the slowest first."""
        eigenvalues = np.linalg.eigvals(self.a).astype(np.complex128)
        return eigenvalues[np.lexsort((eigenvalues.imag, np.abs(eigenvalues)))]

    @property
    def stable(self) -> bool:
        """True if the joint stays there."""
        return bool(self.poles.real.max() < 0.0)

    @property
    def ringing(self) -> tuple[float, float] | None:
        """Frequency [Hz] and damping ratio of the slowest oscillation; None if there is none."""
        slowest = min((p for p in self.poles if p.imag > 1.0), key=abs, default=None)
        if slowest is None:
            return None
        return float(slowest.imag / (2.0 * np.pi)), float(-slowest.real / abs(slowest))

    def state_space(self, *, squared: bool = False) -> Any:
        """A ``StateSpace`` of python-control: inputs are the voltages [V], or their squares [V²]; the output is q [m].

        Raises
        ------
        InputError
            python-control is not installed.
        """
        try:
            state_space = importlib.import_module("control").StateSpace
        except ImportError as error:
            raise InputError(
                "StateSpace is of python-control, which is not installed; `pip install control`"
            ) from error
        return state_space(self.a, self.b_squared if squared else self.b, self.c, self.d)

    def to_json(self) -> dict[str, Any]:
        """Everything as numbers and lists, SI."""
        ringing = self.ringing
        return {
            "q_m": self.q,
            "v_V": self.v.tolist(),
            "stable": self.stable,
            "frequency_Hz": None if ringing is None else ringing[0],
            "damping_ratio": None if ringing is None else ringing[1],
            "poles_1_s": [[float(p.real), float(p.imag)] for p in self.poles],
            "states": list(NAMES),
            "state_units": list(UNITS),
            "x0": self.x.tolist(),
            "A": self.a.tolist(),
            "B": self.b.tolist(),
            "C": self.c.tolist(),
            "D": self.d.tolist(),
            "B_squared": self.b_squared.tolist(),
        }


def jacobian(x: FloatArray, u: FloatArray, c: Constants) -> tuple[FloatArray, FloatArray]:
    """∂ẋ/∂x, shape (STATES, STATES), and ∂ẋ/∂(v²), shape (STATES, 2), friction left out, from the generated graph.

    Cost: 10 µs.
    """
    a, b = full_jacobian(x, u, c)
    return a[:STATES, :STATES].copy(), b


def full_jacobian(x: FloatArray, u: FloatArray, c: Constants) -> tuple[FloatArray, FloatArray]:
    """Jacobians of the rates by states and held stop operators, (STATES, STATES + STOPS), and by squared voltages."""
    rows = STATES + STOPS
    a = np.zeros((rows, rows))
    b = np.zeros((rows, 2))
    _differentiate(x, u, c, a.reshape(-1), b.reshape(-1))
    return a[:STATES], b[:STATES]


@compiled
def prepare_slopes(k: FloatArray) -> FloatArray:
    """Constants prepared for the Jacobian of a joint with the constants k."""
    prepared = np.empty(_PREPARED)
    _prepare((k, prepared))
    return prepared


@compiled
def _differentiate(x: FloatArray, u: FloatArray, c: Constants, a: FloatArray, b: FloatArray) -> None:
    """Fill derivatives by states and stop operators, and by squared voltages, row by row."""
    values = np.zeros(VALUES)
    slopes = np.zeros(VALUES)
    for i in range(c.weights.shape[1]):
        bell, slope, bend = _bell((x[0] - i * c.basis[1], c.basis[0], c.basis[1], c.basis[2]))
        for row in range(CURVES):
            values[row] += c.weights[row, i] * bell
            slopes[row] += c.weights[row, i] * slope
        for row in range(VALUES - CURVES):
            values[CURVES + row] += c.weights[4 + row, i] * slope
            slopes[CURVES + row] += c.weights[4 + row, i] * bend
    room = np.empty(_RATES), a, b, np.empty(_BY_CORRECTIONS)
    _slopes((x, u, values, np.zeros(STOPS), slopes, prepare_slopes(c.k), *room))


def linearise(plant: ControlledJoint, x: FloatArray, v: FloatArray) -> LinearModel:
    """The linear model about the equilibrium `x`, shape (STATES,), under the voltages `v`, shape (2,) [V].

    Dry friction whose level sets in with the speed is left out with the stop operators. It sets in within a few
    millimetres per second, and its slope there is a damping that no motion of a millimetre meets.
    """
    k = plant.constants.k.copy()
    k[[INDEX[name] for name in DRY_LEVELS]] = 0.0
    a, b_squared = jacobian(x, v**2, plant.constants._replace(k=k, p=prepare(k[None])[0]))
    return LinearModel(
        q=plant.reading(float(x[0])),
        v=v,
        x=x,
        a=a,
        b=2.0 * b_squared * v,
        c=np.eye(1, STATES),
        d=np.zeros((1, 2)),
        b_squared=b_squared,
    )


def equilibria(plant: ControlledJoint, v: FloatArray) -> list[LinearModel]:
    """Every equilibrium about the rests of the logs under the voltages `v`, shape (2,) [V], from left to right.

    Newton's method on the forces on q, slope and interior shape, from a grid of displacements with the shape at rest
    there, and with the slope of slow motions: a buckled beam has several slopes at one displacement.
    """
    u = v**2
    places = list[FloatArray]()
    c = plant.constants
    low, high = _window(plant)
    for q in np.linspace(low, high, 25):
        relaxed, _ = rest_state(q, u, c.k, c.p, c.basis, c.weights, 0.0)
        for shape in (relaxed, still(q, float(c.k[INDEX["slope_ratio"]]) * q / float(c.k[INDEX["l"]]), 0.0)):
            x = newton(plant, shape, u)
            if x is not None and low <= x[0] <= high and not any(abs(x[0] - y[0]) < _SAME for y in places):
                places.append(x)
    return [linearise(plant, x, v) for x in sorted(places, key=lambda x: float(x[0]))]


def _window(plant: ControlledJoint) -> tuple[float, float]:
    """Range of displacements [m] in which equilibria are searched."""
    if plant.rests is None:
        return -_BEYOND * plant.wall, _BEYOND * plant.wall
    left, right = (reading - plant.instruments.offset for reading in plant.rests)
    return left - _BEYOND * (right - left), right + _BEYOND * (right - left)


def _root(left: Callable[[FloatArray], FloatArray], start: FloatArray, steps: FloatArray) -> FloatArray | None:
    """Root of three functions of three unknowns by Newton's method, shape (3,); None if it fails.

    Slopes are by central differences with `steps`, in whose units moves are limited and errors small.
    """
    at = start
    for _ in range(_ITERATIONS):
        slopes = np.array([left(at + d) - left(at - d) for d in np.diag(steps)]).T / (2.0 * steps)
        move = np.linalg.solve(slopes, -left(at))
        size = float(np.abs(move / steps).max())
        at = at + move * min(1.0, _LONGEST / max(size, _TOLERANCE))
        if not np.all(np.isfinite(at)):
            return None
        if size < _TOLERANCE:
            return at
    return None


def newton(plant: ControlledJoint, near: FloatArray, u: FloatArray) -> FloatArray | None:
    """The equilibrium near a state under the squared voltages `u`, shape (2,) [V²]; None if Newton's method fails."""
    steps = np.array([1e-7, 1e-6, 1e-6])  # m, 1, 1
    root = _root(lambda at: np.asarray(forces(still(*at), u, plant.constants)), near[SHAPE], steps)
    return None if root is None or abs(root[0]) > plant.wall else still(*root)


def held(
    plant: ControlledJoint, near: FloatArray, base: FloatArray, direction: FloatArray
) -> tuple[FloatArray, float] | None:
    """Equilibrium at a state's displacement under the squared voltages base + u·direction, and u; None without one.

    Parameters
    ----------
    plant : ControlledJoint
        The joint.
    near : FloatArray, shape (STATES,)
        The displacement, and the shape at which the search starts.
    base, direction : FloatArray, shape (2,)
        Squared voltages [V²] and the direction in which they may change.

    Returns
    -------
    x : FloatArray, shape (STATES,)
    u : float
        [V²].
    """
    q = float(near[0])

    def left(at: FloatArray) -> FloatArray:
        """Forces that are left at a slope, an interior shape and a squared voltage [kV²]: zero at rest."""
        return np.asarray(forces(still(q, at[0], at[1]), base + 1e6 * at[2] * direction, plant.constants))

    root = _root(left, np.array([near[2], near[4], 0.0]), np.array([1e-6, 1e-6, 1e-3]))
    return None if root is None else (still(q, root[0], root[1]), 1e6 * float(root[2]))


def wells_and_saddle(plant: ControlledJoint) -> list[LinearModel]:
    """Left well, unstable equilibrium between, right well, without voltage.

    The wells are the stable equilibria next to the rests of the logs, or the outermost ones where the logs show none. A
    joint has further equilibria between, of other shapes; the one nearest to the middle of the wells is taken for the
    highest.

    Raises
    ------
    InputError
        The joint has not two wells with one unstable equilibrium between them.
    """
    models = equilibria(plant, np.zeros(2))
    stable = [model for model in models if model.stable]
    if plant.rests is not None and stable:
        wells = [stable[int(np.argmin([abs(model.q - rest) for model in stable]))] for rest in plant.rests]
        models = [model for model in models if wells[0].q <= model.q <= wells[1].q]
        stable = wells
    middle = 0.5 * (stable[0].q + stable[-1].q) if stable else 0.0
    pair = outermost_pair([model.stable for model in models], [-abs(model.q - middle) for model in models])
    if pair is None:
        places = [f"{1e3 * model.q:.2f} mm ({'' if model.stable else 'un'}stable)" for model in models]
        raise InputError(
            "the identified joint has not two wells; there is nothing to switch between: it has equilibria at "
            f"{', '.join(places) or 'no place'}"
        )
    return [models[i] for i in pair]


def held_at(plant: ControlledJoint, q: float, saddle: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Equilibrium at q [m], shape (STATES,), and the squared voltages [V²] that hold it, shape (2,).

    Where the beam has several shapes at one displacement, the one that needs the least voltage.
    """
    c = plant.constants
    relaxed, _ = rest_state(q, np.zeros(2), c.k, c.p, c.basis, c.weights, 0.0)
    equilibria_held = [
        (answer[0], answer[1] * side)
        for start in (relaxed, still(q, float(saddle[2]), float(saddle[4])))
        for side in np.eye(2)
        if (answer := held(plant, start, np.zeros(2), side)) is not None and answer[1] >= 0.0
    ]
    return min(equilibria_held, key=lambda each: float(each[1].sum()), default=(relaxed, np.zeros(2)))
