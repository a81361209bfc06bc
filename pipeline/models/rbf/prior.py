"""Priors of the data-driven joint: smooth curves, small hidden states, equal sides, and a population of joints.

The mirror image of a joint exchanges its left and right sides. The population prior of a bistable joint is a normal
distribution of θ over simulated joints, in units of each joint's own scales. `benchmarks/population_estimate.py`
estimates the distribution, `benchmarks/joint_population.py` writes the file of the package, and
docs/explanation/identification.md states its value.

A curve that was measured on a test stand enters the prior, too: rows say that the curve passes each measured point,
within a small share of its largest value (§4.2). Elsewhere the data decide.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path

import numpy as np

from ...fitting.descent import Prior
from ...numerics.arrays import FloatArray, IntArray
from ..model_type import KnownCurves
from .dynamics import POLYNOMIALS, basis_rows
from .parameter_layout import ParameterLayout, kind_of
from .structure import JointScales, JointStructure

GAIN_SPREAD = 0.7  # of the logarithm of a gain about its typical size
SLOW_DAMPING = 0.05  # mean of the damping, in units of the frequency scale
ARM_BUMP = 0.2  # how much less than another joint a turning arm is expected to deviate from its sine
LOG_SPREAD = 1.0  # of the logarithm of a number that the start knows to a factor of e
STOP_SPREAD = 0.1  # of the places of end stops [half ranges]
SPREADS = {"rate": 0.5, "inertia_centre": 0.3, "input_offset": 0.01}
"""Prior standard deviations of single numbers about where they start, where it is not `LOG_SPREAD`."""

_LOGARITHMS = ("slip_force", "slip_length", "inertia", "drag", "input_lag", "input_delay", "input_bend", "input_zone")

UNLIKENESS = {"force": 2.5, "damping": 2.0}
"""Prior distance of these curves from their mirror images, over that of other curves."""


def joint_prior(p: ParameterLayout, start: FloatArray, symmetry: float | None) -> Prior:
    """Gaussian prior of the parameters: smooth curves, small hidden states, and mirror symmetry if asked for.

    Parameters
    ----------
    p : ParameterLayout
        Names and scales.
    start : FloatArray, shape (P,)
        The mean of gains, rates, friction and inertia.
    symmetry : float, optional
        Relative standard deviation of left/right differences about q = 0: F odd, d even, g_2(x) = −g_1(−x).
        None for a device without a mirror plane.
    """
    rows = _PriorRows(p.count)
    at = _places(p)
    s = p.units
    size = 2.5 * s.stiffness
    force = at["force"]
    rows.each(force[: POLYNOMIALS - 1], 0.0, 3.0 * size)
    rows.each(force[POLYNOMIALS - 1 : POLYNOMIALS], np.log(s.stiffness), LOG_SPREAD)
    bump = size * (ARM_BUMP if p.structure.turning_arm else 1.0)
    rows.each(force[POLYNOMIALS:], 0.0, 0.5 * bump)
    rows.smooth(force[POLYNOMIALS:], 0.3 * bump)
    damping = at["damping"]
    rows.smooth(damping, 0.7)
    rows.each(damping, start[damping] if p.structure.overdamped else np.log(SLOW_DAMPING * s.frequency), 2.0)
    for k, sign in enumerate(p.signs):
        gain = at[f"input{k}"]
        unit = 1.0 if sign else float(np.abs(start[gain]).max())
        rows.smooth(gain, 0.3 * unit)
        rows.each(gain, start[gain], GAIN_SPREAD * unit)
    for i in range(len(p.structure.rates)):
        spread = 0.5 if i < p.structure.shape_elements else 0.3
        rows.smooth(at[f"coupling{i}"], 0.1 * np.sqrt(s.stiffness))
        rows.each(at[f"coupling{i}"], 0.0, spread * np.sqrt(s.stiffness))
    for i in range(p.structure.shape_elements):
        # Shape elements relax about as fast as they start, and inputs pull little at them.
        relaxation = at[f"relaxation{i}"]
        rows.smooth(relaxation, 0.3)
        rows.each(relaxation, start[relaxation], 1.0)
        for k in range(len(p.signs)):
            rows.smooth(at[f"pull{i}_{k}"], 0.1 * np.sqrt(s.stiffness))
            rows.each(at[f"pull{i}_{k}"], 0.0, 0.5 * np.sqrt(s.stiffness))
    stops = at["stops"]
    rows.each(stops[:2], start[stops[:2]], STOP_SPREAD)
    rows.each(stops[2:], start[stops[2:]], LOG_SPREAD)
    for name, spread in (SPREADS | dict.fromkeys(_LOGARITHMS, LOG_SPREAD)).items():
        rows.each(at[name], start[at[name]], spread)
    if symmetry is not None and s.middle == 0.0:
        _mirror(rows, p, symmetry)
    return Prior(np.array(rows.rows), np.array(rows.right))


def _mirror(rows: "_PriorRows", p: ParameterLayout, symmetry: float) -> None:
    """The joint is about its own mirror image; plain relaxing elements may be as they are."""
    image, (_, scale) = mirror_image(p), p.dimensionless
    blocks = ["force", "damping", "inertia_centre"]
    blocks += [f"{name}{i}" for i in range(p.structure.shape_elements) for name in ("relaxation", "coupling")]
    if p.signs in ((1, -1), (-1, 1)):
        blocks += [f"pull{i}_0" for i in range(p.structure.shape_elements)]
        _gains_alike(rows, p, symmetry)
    for name in blocks:
        spread = symmetry * UNLIKENESS.get(name, 1.0)
        for i in _places(p)[name]:
            j = int(np.argmax(np.abs(image[i])))
            if i < j:
                rows.add([i, j], [1.0, -image[i, j]], 0.0, spread * scale[i])
            elif i == j and image[i, i] < 0.0:
                rows.add([i], [1.0], 0.0, spread * scale[i])


def _gains_alike(rows: "_PriorRows", p: ParameterLayout, symmetry: float) -> None:
    """The two gains have mirrored courses; one side may be stronger than the other everywhere."""
    left, right = (_places(p)[f"input{k}"] for k in (0, 1))
    for i in range(len(left)):
        apart = np.eye(len(left))[i] - 1.0 / len(left)
        rows.add([*left, *right[::-1]], [*apart, *-apart], 0.0, symmetry)


def _places(p: ParameterLayout) -> dict[str, IntArray]:
    """Places of each block in θ."""
    return {name: np.arange(p.count)[where] for name, where in p.slices.items()}


class _PriorRows:
    """Rows of a Gaussian prior, collected one by one; each is divided by its standard deviation."""

    def __init__(self, parameters: int) -> None:
        self.parameters = parameters
        self.rows: list[FloatArray] = []
        self.right: list[float] = []

    def add(self, index: Sequence[int], factors: Sequence[float], mean: float, spread: float) -> None:
        """A weighted sum of parameters has this mean and standard deviation."""
        row = np.zeros(self.parameters)
        row[list(index)] += np.array(factors)
        self.rows.append(row / spread)
        self.right.append(mean / spread)

    def each(self, index: IntArray, means: FloatArray | float, spread: float) -> None:
        """Each of these parameters has its mean and one standard deviation."""
        for i, mean in zip(index, np.broadcast_to(means, index.shape), strict=True):
            self.add([int(i)], [1.0], float(mean), spread)

    def smooth(self, index: IntArray, spread: float) -> None:
        """Second differences along the centres are small."""
        for a, b, c in zip(index, index[1:], index[2:], strict=False):
            self.add([int(a), int(b), int(c)], [-1.0, 2.0, -1.0], 0.0, spread)


def mirror_image(p: ParameterLayout) -> FloatArray:
    """Matrix (P, P) that takes dimensionless θ to that of the joint mirrored at q = 0, its two inputs exchanged.

    A hidden shape changes its sign in the mirror, so that couplings are even and pulls change sides and sign. What
    belongs to one of one or three inputs has no image: zeros.
    """
    image = np.zeros((p.count, p.count))
    at = _places(p)

    def put(name: str, other: str, factor: float, *, turned: bool) -> None:
        """Make a block of the image from another, end for end if it is a curve along the centres."""
        image[at[name], at[other][::-1] if turned else at[other]] = factor

    for name, index in at.items():
        kind = kind_of(name)
        if kind == "force":
            powers = index[:POLYNOMIALS]
            image[powers, powers] = (-1.0, 1.0, -1.0, 1.0)[: len(powers)]  # the last is the confining cubic's logarithm
            image[index[POLYNOMIALS:], index[POLYNOMIALS:][::-1]] = -1.0
        elif kind in ("input", "pull"):
            if len(p.signs) == 2:
                put(name, _of_other_input(name), 1.0 if kind == "input" else -1.0, turned=True)
        elif name == "input_offset":
            put(name, name, 1.0, turned=True)
        else:
            factor = -1.0 if name == "inertia_centre" else 1.0
            put(name, name, factor, turned=kind in ("damping", "coupling", "relaxation"))
    return image


@dataclass(frozen=True)
class Population:
    """A normal distribution of dimensionless θ.

    Attributes
    ----------
    blocks : dict of str to int
        Names and lengths of the blocks of θ, in order.
    smoothing : float
        σ_n of its curves.
    mean : FloatArray, shape (P,)
    root : FloatArray, shape (P, P)
        A of the precision AᵀA.
    """

    blocks: dict[str, int]
    smoothing: float
    mean: FloatArray
    root: FloatArray

    def knows(self, structure: JointStructure) -> bool:
        """True if the prior is one of this structure, whose two inputs pull in opposite directions by their squares."""
        p = ParameterLayout(structure, JointScales(0.0, 1.0, 1.0, 1.0), "squared", (1, -1))
        return blocks_of(p) == self.blocks and structure.smoothing == self.smoothing and not structure.overdamped

    def prior(self, p: ParameterLayout) -> Prior:
        """The prior of a joint of a structure that it knows, whose mirror plane is q = 0."""
        offset, scale = p.dimensionless
        matrix = self.root / scale
        order = np.arange(p.count) if p.signs == (1, -1) else _exchanged(p)
        return Prior(matrix[:, order], self.root @ self.mean + matrix @ offset)


def blocks_of(p: ParameterLayout) -> dict[str, int]:
    """Names and lengths of the blocks of θ, in order."""
    return {name: where.stop - where.start for name, where in p.slices.items()}


def _of_other_input(block: str) -> str:
    """The block that means the same for the other of two inputs."""
    return f"{block[:-1]}{1 - int(block[-1])}"


def _exchanged(p: ParameterLayout) -> IntArray:
    """Place of each parameter in θ of a joint with exchanged inputs, shape (P,)."""
    order = np.arange(p.count)
    at = _places(p)
    for name in at:
        if kind_of(name) in ("pull", "input"):
            order[at[name]] = at[_of_other_input(name)]
    order[at["input_offset"]] = at["input_offset"][::-1]
    return order


ASSET = Path(__file__).with_name("assets") / "joint_population.npz"


@cache
def population() -> Population:
    """The population of 70 joints of the virtual rig, half of each physics."""
    with np.load(ASSET, allow_pickle=False) as held:
        blocks = dict(zip(held["blocks"].tolist(), held["lengths"].tolist(), strict=True))
        return Population(blocks, float(held["smoothing"]), held["mean"], held["root"].astype(np.float64))


KEPT = 5e-3
"""Standard deviation of a measured point, as a share of its curve's largest value."""

PIN_STEPS = 20
"""Gauss-Newton steps to the start of known curves; a dozen suffice."""

PINNED = 1e-3
"""Standard deviation of the logarithm of the confining cubic beside a known force. All other weights of the force are
linear. With a free logarithm the rows, which are of first order, let the ends of the curve move by 3.6 %."""


def pin_curves(p: ParameterLayout, start: FloatArray, prior: Prior, measured: KnownCurves) -> tuple[FloatArray, Prior]:
    """Start vector and prior that keep the known curves.

    Weights of one sign are carried as logarithms. So the rows are of first order in the curves at the start, and the
    start follows the measured points as far as the prior allows.

    Parameters
    ----------
    p : ParameterLayout
        Gains of known curves have their signs.
    start : FloatArray, shape (P,)
        Start of the estimation without them.
    prior : Prior
        Prior without them.
    measured : KnownCurves
        Per unit mass.
    """
    start = start.copy()
    _, scale = p.dimensionless
    for _ in range(PIN_STEPS):
        pinned = _pinned(p, start, prior, measured)
        free = np.any(pinned.matrix[len(prior.right) :] != 0.0, axis=0)
        unit = scale[free]
        step = np.linalg.lstsq(pinned.matrix[:, free] * unit, pinned.right - pinned.matrix @ start, rcond=None)[0]
        start[free] += unit * np.clip(step, -1.0, 1.0)
    pinned = _pinned(p, start, prior, measured)
    if measured.force is None:
        return start, pinned
    row = (np.arange(p.count) == p.cubic) / PINNED
    return start, Prior(np.vstack([pinned.matrix, row]), np.append(pinned.right, start[p.cubic] / PINNED))


def _pinned(p: ParameterLayout, theta: FloatArray, prior: Prior, measured: KnownCurves) -> Prior:
    """The prior with a row for each measured point, of first order at θ."""
    c = p.coefficients(theta)
    factor = p.sensitivity_parameters(theta).factor
    rows = [prior.matrix]
    right = [prior.right]
    volts = p.scales.volts**2 if p.law == "squared" else p.scales.volts
    curves = [("force", measured.force, -1.0, 1.0)]
    curves += [(f"input{k}", gain, volts, float(p.full_effect(theta)[k])) for k, gain in enumerate(measured.gains)]
    for name, curve, unit, effect in curves:
        if curve is not None:
            finite = np.isfinite(curve)
            where = p.slices[name]
            y = curve[finite] * unit / p.scales.half
            basis = basis_rows(np.ascontiguousarray((measured.q[finite] - p.scales.middle) / p.scales.half), c)
            values = basis @ c.curves[p.rows[name]]
            block = np.zeros((len(y), p.count))
            block[:, where] = effect * basis[:, p.basis_of(name)] * factor[where]
            if name != "force" and p.law == "squared":
                # The effect is 1 - 2 o.
                block[:, p.slices["input_offset"].start + int(name.removeprefix("input"))] = -2.0 * values
            spread = KEPT * np.abs(y).max()
            rows.append(block / spread)
            right.append((y - effect * values + block @ theta) / spread)
    return Prior(np.vstack(rows), np.concatenate(right))
