"""Parameters of the data-driven joint: names, order, and their way into the equation of motion.

Quantities that must be positive are carried as logarithms (damping, gains of a squared input up to their sign, the
confining cubic, rates, friction, inertia), so every parameter vector is a passive, confined joint and the
estimation needs no constraints.
"""

from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

import numpy as np

from pipeline.identification import relaxing_joint as joint
from pipeline.identification.regressor import InputLaw
from pipeline.numerics.arrays import FloatArray
from pipeline.numerics.lag import first_order_lag

OVERHANG = 0.05
"""Outermost centres past the data, as a share of half the range; the curves stay constant a little further on."""

SLIP_FLOOR = 2e-3
"""Shortest Dahl length, as a share of half the range: shorter ones are a spring too stiff for the integration step."""


@dataclass(frozen=True)
class JointStructure:
    """What the data-driven joint consists of.

    Attributes
    ----------
    basis_functions : int
        Gaussians M per curve.
    smoothing : float
        σ_n.
    rates : tuple of float
        Relaxation rates of the L hidden elements to start from, in units of the joint's own frequency scale.
    shape_elements : int
        The first so many elements also feel the inputs (a hidden shape coordinate).
    slips : int
        Dahl friction states.
    arc : bool
        Whether the inertia may vary with the displacement (a tip on an arc).
    input_lag : bool
        Whether the inputs act through a first-order lag (a propeller, a slow drive).
    turning_arm : bool
        Whether q is the angle of an arm on which weight acts: sin q and cos q instead of x and x² in the basis.
    """

    basis_functions: int = 12
    smoothing: float = 1.0
    rates: tuple[float, ...] = (10.0, 1.5, 0.18, 0.02)
    shape_elements: int = 2
    slips: int = 1
    arc: bool = True
    input_lag: bool = False
    turning_arm: bool = False


@dataclass(frozen=True)
class Scales:
    """Units of the dimensionless joint: middle and half range of q, largest |v|, RMS of q̈ over half range [1/s²]."""

    middle: float
    half: float
    volts: float
    stiffness: float

    @property
    def frequency(self) -> float:
        """Frequency scale of the joint [rad/s]."""
        return float(np.sqrt(2.0 * self.stiffness))


@dataclass(frozen=True)
class JointParameters:
    """The parameter vector of one structure.

    Attributes
    ----------
    structure : JointStructure
    scales : Scales
    law : {"squared", "linear"}
    signs : tuple of int
        Sign of each input's gain where it cannot change (squared inputs), 0 where the gain is free.
    """

    structure: JointStructure
    scales: Scales
    law: InputLaw
    signs: tuple[int, ...]
    centres: FloatArray = field(init=False)

    def __post_init__(self) -> None:
        ends = 1.0 + OVERHANG
        object.__setattr__(self, "centres", np.linspace(-ends, ends, self.structure.basis_functions))

    @property
    def bend(self) -> float:
        """1/(2σ²) of the dimensionless Gaussians."""
        return 0.5 / (self.structure.smoothing * float(self.centres[1] - self.centres[0])) ** 2

    @property
    def arm(self) -> FloatArray:
        """The angle of a turning arm as a line in x, shape (2,); zeros for another joint."""
        return np.array([self.scales.middle, self.scales.half]) * float(self.structure.turning_arm)

    @cached_property
    def slices(self) -> dict[str, slice]:
        """Where each block of the vector lies."""
        s, k, m = self.structure, len(self.signs), self.structure.basis_functions
        sizes = {"force": joint.POLYNOMIALS + m, "damping": m}
        sizes |= {f"input{i}": m for i in range(k)}
        sizes |= {f"lever{i}": m for i in range(len(s.rates))}
        sizes |= {"rate": len(s.rates), "coupling": s.shape_elements * k, "slip_force": s.slips}
        sizes |= {"slip_length": s.slips, "inertia": int(s.arc), "inertia_centre": int(s.arc)}
        sizes |= {"input_offset": k if self.law == "squared" else 0, "input_lag": int(s.input_lag)}
        ends = np.cumsum(list(sizes.values()))
        return {name: slice(int(e) - n, int(e)) for (name, n), e in zip(sizes.items(), ends, strict=True)}

    @property
    def count(self) -> int:
        """Number of parameters."""
        return int(max(s.stop for s in self.slices.values()))

    def coefficients(self, theta: FloatArray) -> joint.Coefficients:
        """The equation of motion for a parameter vector."""
        s, k = self.structure, len(self.signs)
        part = {name: theta[where] for name, where in self.slices.items()}
        curves = np.zeros((joint.INPUT + k + len(s.rates), joint.POLYNOMIALS + s.basis_functions))
        curves[joint.FORCE] = part["force"]
        curves[joint.FORCE, joint.POLYNOMIALS - 1] = -np.exp(part["force"][joint.POLYNOMIALS - 1])
        curves[joint.DAMPING, joint.POLYNOMIALS :] = np.exp(part["damping"])
        for i, sign in enumerate(self.signs):
            gain = part[f"input{i}"]
            curves[joint.INPUT + i, joint.POLYNOMIALS :] = sign * np.exp(gain) if sign else gain
        for i in range(len(s.rates)):
            curves[joint.INPUT + k + i, joint.POLYNOMIALS :] = part[f"lever{i}"]
        coupling = np.zeros((len(s.rates), k))
        coupling[: s.shape_elements] = part["coupling"].reshape(s.shape_elements, k)
        inertia = np.array([np.exp(part["inertia"][0]), part["inertia_centre"][0]]) if s.arc else np.zeros(2)
        end = 1.0 + 3.0 * OVERHANG
        slip_length = SLIP_FLOOR + np.exp(part["slip_length"])
        return joint.Coefficients(
            curves, np.exp(part["rate"]), coupling, np.exp(part["slip_force"]), slip_length, inertia,
            self.centres, self.bend, -end, end, self.arm,
        )  # fmt: skip

    def directions(self, theta: FloatArray) -> joint.Directions:
        """What the sensitivities are taken with respect to: all parameters, in order."""
        kind, first, second = (np.zeros(self.count, dtype=np.int64) for _ in range(3))
        factor, k = np.ones(self.count), len(self.signs)
        rows = {"force": joint.FORCE, "damping": joint.DAMPING}
        rows |= {f"input{i}": joint.INPUT + i for i in range(k)}
        rows |= {f"lever{i}": joint.INPUT + k + i for i in range(len(self.structure.rates))}
        for name, row in rows.items():
            where = self.slices[name]
            first[where] = row
            second[where] = np.arange(where.stop - where.start) + (0 if name == "force" else joint.POLYNOMIALS)
        cubic = self.slices["force"].start + joint.POLYNOMIALS - 1
        factor[cubic] = -np.exp(theta[cubic])
        factor[self.slices["damping"]] = np.exp(theta[self.slices["damping"]])
        for i, sign in enumerate(self.signs):
            if sign:
                factor[self.slices[f"input{i}"]] = sign * np.exp(theta[self.slices[f"input{i}"]])
        for name, code in _KINDS.items():
            where = self.slices[name]
            kind[where] = code
            first[where] = np.arange(where.stop - where.start)
        coupling = self.slices["coupling"]
        pairs = np.arange(coupling.stop - coupling.start)
        first[coupling], second[coupling] = pairs // k, pairs % k
        length = np.exp(theta[self.slices["slip_length"]])
        factor[self.slices["slip_length"]] = length / (SLIP_FLOOR + length)
        factor[self.slices["inertia"]] = np.exp(theta[self.slices["inertia"]])
        first[self.slices["input_lag"]] = self.slices["input_offset"].stop - self.slices["input_offset"].start
        return joint.Directions(kind, first, second, factor)

    def inputs(self, v: FloatArray, interval: float, steps: int, theta: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Inputs at every half step and their derivatives with respect to offsets and lag (see `observed_run`).

        Voltages are linear between samples; they pass the lag, solved exactly, and are squared after that, because it
        is the drive (the propeller's speed, the electrodes' charge) that lags and its square that pulls.
        """
        half = interval / steps / 2.0
        samples = np.arange(len(v)) * interval
        nodes = half * np.arange(2 * steps * (len(v) - 1) + 1)
        volts = np.column_stack([np.interp(nodes, samples, column) for column in v.T]) / self.scales.volts
        offset = theta[self.slices["input_offset"]]
        by_lag = np.zeros_like(volts)
        if self.structure.input_lag:
            lag = float(np.exp(theta[self.slices["input_lag"]][0]))
            for i in range(v.shape[1]):
                volts[:, i], by_lag[:, i] = first_order_lag(np.ascontiguousarray(volts[:, i]), half, lag)
        if self.law == "linear":
            return np.ascontiguousarray(volts), by_lag[None][: int(self.structure.input_lag)]
        volts = volts - offset
        du = np.zeros((len(offset) + int(self.structure.input_lag), *volts.shape))
        for i in range(len(offset)):
            du[i, :, i] = -2.0 * volts[:, i]
        if self.structure.input_lag:
            du[-1] = 2.0 * volts * by_lag
        return np.ascontiguousarray(volts * volts), du

    def to_tree(self) -> dict[str, Any]:
        """Structure and scales as plain values."""
        return {
            "structure": {**vars(self.structure), "rates": np.array(self.structure.rates)},
            "scales": dict(vars(self.scales)),
            "law": self.law,
            "signs": np.array(self.signs, dtype=np.int64),
        }

    @classmethod
    def from_tree(cls, tree: dict[str, Any]) -> "JointParameters":
        """Back from `to_tree`."""
        s = tree["structure"]
        structure = JointStructure(
            int(s["basis_functions"]), float(s["smoothing"]), tuple(float(r) for r in s["rates"]),
            int(s["shape_elements"]), int(s["slips"]), bool(s["arc"]), bool(s["input_lag"]),
            bool(s.get("turning_arm", False)),
        )  # fmt: skip
        scales = Scales(**{name: float(tree["scales"][name]) for name in ("middle", "half", "volts", "stiffness")})
        return cls(structure, scales, tree["law"], tuple(int(sign) for sign in tree["signs"]))


_KINDS = {
    "rate": joint.RATE,
    "coupling": joint.COUPLING,
    "slip_force": joint.SLIP_FORCE,
    "slip_length": joint.SLIP_LENGTH,
    "inertia": joint.INERTIA,
    "inertia_centre": joint.INERTIA_CENTRE,
    "input_offset": joint.INPUT_SHAPE,
    "input_lag": joint.INPUT_SHAPE,
}
