"""Parameters of the data-driven joint: names, order, and their way into the equation of motion.

Quantities that must be positive are carried as logarithms: damping, gains of a squared input up to their sign, the
confining cubic, rates, friction, inertia. So every parameter vector is a passive, confined joint, and the estimation
needs no constraints.
"""

from functools import cached_property
from typing import Annotated

import numpy as np
from pydantic import BeforeValidator, Field, dataclasses as stored

from ...fitting.regression import InputAction
from ...generated.terms import BENT, PAST_ZONE
from ...numerics.arrays import FloatArray, IntArray
from ..model_file import MOST_INPUTS, STORED, Unit, listed
from .dynamics import (
    ARC,
    CENTRE,
    DRAG,
    FORCE,
    INPUT,
    INPUT_SHAPE,
    NUMBER,
    POLYNOMIALS,
    RATE,
    SLIP_FORCE,
    SLIP_LENGTH,
    STOPS,
    WEIGHT,
    Coefficients,
    SensitivityParameters,
    basis_rows,
)
from .structure import JointScales, JointStructure, drive_at_nodes, lagged

OVERHANG = 0.05
"""Outermost centres past the data, as a share of half the range; the curves stay constant a little further on."""

SLIP_FLOOR = 2e-3
"""Shortest Dahl length, as a share of half the range: shorter ones are a spring too stiff for the integration step."""


MOST_REFINED = 1024
"""Times as many integration steps that a model may take; what needs more is no smooth motion."""


@stored.dataclass(frozen=True, config=STORED)
class ParameterLayout:
    """The parameter vector of one structure."""

    structure: JointStructure
    scales: JointScales
    law: InputAction
    """Action of the inputs: squared or linear."""
    signs: Annotated[
        tuple[Annotated[int, Field(ge=-1, le=1)], ...],
        BeforeValidator(listed), Field(min_length=1, max_length=MOST_INPUTS), Unit("1"),
    ]  # fmt: skip
    """Sign of each input's force; 0 if it may change."""
    refinement: Annotated[int, Field(ge=1, le=MOST_REFINED), Unit("1")] = 1
    """Times as many integration steps as the pace needs."""

    @cached_property
    def centres(self) -> FloatArray:
        """Centres of the dimensionless Gaussians."""
        ends = 1.0 + OVERHANG
        return np.linspace(-ends, ends, self.structure.basis_functions)

    @property
    def units(self) -> JointScales:
        """Units of forces and rates; those of the observer and of the steps are `scales` whatever the structure."""
        return self.scales.overdamped if self.structure.overdamped else self.scales

    @property
    def pace(self) -> float:
        """Rate [rad/s] that integration steps resolve, at least the frequency scale.

        A joint between two membranes rests between its motions. RMS slope of the velocity over RMS velocity is the
        angular frequency of its vibrations, however long it rests. Other devices move all the time, and their sensors
        may be noisy.
        """
        rests = self.signs in ((1, -1), (-1, 1)) and self.scales.speed > 0.0
        return max(self.scales.frequency, self.scales.slope / self.scales.speed) if rests else self.scales.frequency

    @property
    def bend(self) -> float:
        """1/(2σ²) of the dimensionless Gaussians."""
        return 0.5 / (self.structure.smoothing * float(self.centres[1] - self.centres[0])) ** 2

    @property
    def cubic(self) -> int:
        """Place of the logarithm of the confining cubic's weight, where the force is no mere offset."""
        return int(self.slices["force"].start) + POLYNOMIALS - 1

    @property
    def arm(self) -> FloatArray:
        """The angle of a turning arm as a line in x, shape (2,); zeros for another joint."""
        return np.array([self.scales.middle, self.scales.half]) * float(self.structure.turning_arm)

    @cached_property
    def slices(self) -> dict[str, slice]:
        """Slice of each block of the vector."""
        s = self.structure
        k = len(self.signs)
        m = self.structure.basis_functions
        # Of each shape element its relaxation, then the pulls of the inputs
        shapes = (
            name for i in range(s.shape_elements) for name in (f"relaxation{i}", *(f"pull{i}_{n}" for n in range(k)))
        )
        sizes = {
            "force": {"curve": POLYNOMIALS + m, "polynomial": POLYNOMIALS, "offset": 1}[s.force],
            "damping": 1 if s.constant_damping else m,
            **{f"input{i}": 1 if s.constant_gain else m for i in range(k)},
            **{f"coupling{i}": m for i in range(len(s.rates))},
            **dict.fromkeys(shapes, m),
            "rate": len(s.rates),
            "slip_force": s.slips,
            "slip_length": s.slips,
            "inertia": int(s.arc),
            "inertia_centre": int(s.arc),
            "drag": int(s.drag),
            "stops": 4 * int(s.stops),
            "input_offset": k if self.law == "squared" else 0,
            "input_lag": int(s.input_lag),
            "input_delay": int(s.input_delay),
            "input_bend": int(s.bent_input),
            "input_zone": int(s.dead_zone),
        }
        ends = np.cumsum(list(sizes.values()))
        return {name: slice(int(e) - n, int(e)) for (name, n), e in zip(sizes.items(), ends, strict=True)}

    @cached_property
    def rows(self) -> dict[str, int]:
        """Row of each block of weights in `dynamics.Coefficients.curves`."""
        names = list(self.slices)
        return {name: row for row, name in enumerate(names[: names.index("rate")])}

    @cached_property
    def dimensionless(self) -> tuple[FloatArray, FloatArray]:
        """Offset and scale of each parameter, shapes (P,), by which (θ − offset)/scale has no units."""
        offset = np.zeros(self.count)
        scale = np.ones(self.count)
        stiffness = self.units.stiffness
        offsets = dict.fromkeys(("damping", "relaxation", "rate"), np.log(self.units.frequency))
        offsets |= dict.fromkeys(("input", "slip_force"), np.log(stiffness))
        scales = {"force": stiffness, "coupling": np.sqrt(stiffness), "pull": np.sqrt(stiffness)}
        for name, where in self.slices.items():
            offset[where] = offsets.get(kind_of(name), 0.0)
            scale[where] = scales.get(kind_of(name), 1.0)
        if self.structure.force != "offset":
            scale[self.cubic], offset[self.cubic] = 1.0, np.log(stiffness)
        return offset, scale

    @property
    def count(self) -> int:
        """Number of parameters."""
        return int(max(s.stop for s in self.slices.values()))

    @np.errstate(over="ignore")  # a step of a descent that goes too far is infinite, and its run is refused
    def coefficients(self, theta: FloatArray) -> Coefficients:
        """The equation of motion for a parameter vector."""
        s = self.structure
        part = {name: theta[where] for name, where in self.slices.items()}
        positive = ("damping", *(f"relaxation{i}" for i in range(s.shape_elements)))
        curves = np.zeros((len(self.rows), POLYNOMIALS + s.basis_functions))
        for name, row in self.rows.items():
            curves[row, self.basis_of(name)] = np.exp(part[name]) if name in positive else part[name]
        if s.force != "offset":
            curves[FORCE, POLYNOMIALS - 1] = -np.exp(part["force"][POLYNOMIALS - 1])
        for i, sign in enumerate(self.signs):
            if sign:
                curves[INPUT + i, self.basis_of(f"input{i}")] = sign * np.exp(part[f"input{i}"])
        inertia = np.array([np.exp(part["inertia"][0]), part["inertia_centre"][0]]) if s.arc else np.zeros(2)
        low = -1.0 - 3.0 * OVERHANG
        high = 1.0 + 3.0 * OVERHANG
        c = Coefficients(
            curves=curves,
            rates=np.exp(part["rate"]),
            slip_force=np.exp(part["slip_force"]),
            slip_length=SLIP_FLOOR + np.exp(part["slip_length"]),
            inertia=inertia,
            centres=self.centres,
            bend=self.bend,
            low=low,
            high=high,
            arm=self.arm,
            drag=float(np.exp(part["drag"]).sum()),
            stops=np.concatenate((part["stops"][:2], np.exp(part["stops"][2:]))),  # places; stiffness, resistance
            ends=np.zeros((2, curves.shape[1])),
            at_ends=np.zeros(2),
        )
        ends = basis_rows(np.array([low, high]), c)
        return c._replace(ends=ends, at_ends=ends @ curves[FORCE])

    @np.errstate(over="ignore")
    def sensitivity_parameters(self, theta: FloatArray) -> SensitivityParameters:
        """Map of the parameters, block by block: the kind of coefficient that they move, where it stands, its slope."""
        factor = np.ones(self.count)
        if self.structure.force != "offset":
            factor[self.cubic] = -np.exp(theta[self.cubic])
        at = self.slices
        for name in ("damping", *(f"relaxation{i}" for i in range(self.structure.shape_elements)), "inertia", "drag"):
            factor[at[name]] = np.exp(theta[at[name]])
        for i, sign in enumerate(self.signs):
            if sign:
                factor[at[f"input{i}"]] = sign * np.exp(theta[at[f"input{i}"]])
        length = np.exp(theta[at["slip_length"]])
        factor[at["slip_length"]] = length / (SLIP_FLOOR + length)
        factor[at["inertia_centre"]] = -1.0  # of the arm, which counts from there
        factor[at["stops"]][2:] = np.exp(theta[at["stops"]][2:])
        return SensitivityParameters(*self._blocks, factor)

    @cached_property
    def _blocks(self) -> tuple[IntArray, IntArray, IntArray, IntArray]:
        """Kind, first place, first column and first parameter of each block that has parameters."""
        shape = self.slices["input_offset"].start
        blocks = []
        filled = {name: where for name, where in self.slices.items() if where.start < where.stop}
        for name, where in filled.items():
            kind = _KINDS.get(name, WEIGHT)
            if kind == WEIGHT:
                first = self.rows[name]
                column = self.basis_of(name).start
            else:
                first = where.start - shape if kind == INPUT_SHAPE else _PLACES.get(name, 0)
                column = 0
            blocks.append((kind, first, column, where.start))
        kind, first, column, start = np.array(blocks, dtype=np.int64).T
        return kind.copy(), first.copy(), column.copy(), np.append(start, self.count)

    def basis_of(self, curve: str) -> slice:
        """Basis functions of a curve: all from the constant on for the force, else the Gaussians or a constant."""
        where = self.slices[curve]
        count = where.stop - where.start
        first = 0 if curve == "force" or count == 1 else POLYNOMIALS
        return slice(first, first + count)

    @property
    def held(self) -> bool:
        """True if the acting inputs jump at the samples and are constant between them."""
        return self.structure.hold == "zero" and not self.structure.input_lag

    @property
    def squares_first(self) -> bool:
        """True if the squares of the inputs act before any lag, so that the record's nodes are those of squares."""
        return self.law == "squared" and (self.structure.effect_lags or not self.structure.input_lag)

    def delay(self, theta: FloatArray) -> float:
        """Delay of the inputs [s]."""
        return float(np.exp(theta[self.slices["input_delay"]][0])) if self.structure.input_delay else 0.0

    def inputs(self, v: FloatArray, interval: float, steps: int, theta: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Inputs at every half step and their derivatives by offsets, lag, delay and bend (see `observed_run`).

        Parameters
        ----------
        v, interval, steps
            As in `drive_at_nodes`.
        theta : FloatArray, shape (P,)
            Parameters.

        Notes
        -----
        They pass delay and lag, solved exactly, and are bent and squared after that: the drive lags, as a propeller's
        speed or the electrodes' charge does, and its square pulls. Where the effect lags, as heat does, they are bent
        and squared first.
        """
        drive = drive_at_nodes(v, interval, steps, self.structure.hold, self.delay(theta), squared=self.squares_first)
        return self.acting(drive / self.scales.volts, interval / steps / 2.0, theta)

    def acting(self, volts: FloatArray, half: float, theta: FloatArray) -> tuple[FloatArray, FloatArray]:
        """`inputs` from the scaled and delayed drive at every half step [s]."""
        s = self.structure
        by_lag = np.empty((0, *volts.shape))
        by_delay = np.empty((0, *volts.shape))
        if s.input_delay:
            by_delay = -np.exp(theta[self.slices["input_delay"]]) * np.gradient(volts, half, axis=0)[None]
        if s.input_lag and not s.effect_lags:
            by_delay, _ = self._behind(by_delay, half, theta, rest_at_zero=True)
            (volts,), by_lag = self._behind(volts[None], half, theta, rest_at_zero=s.rest_at_zero)
        u, slope, by_shape = self._effect(volts, theta)
        by_offset = np.zeros((len(theta[self.slices["input_offset"]]), *volts.shape))
        for i in range(len(by_offset)):
            by_offset[i, :, i] = -slope[:, i]
        by_lag, by_delay = slope * by_lag, slope * by_delay
        if s.input_lag and s.effect_lags:
            by_offset, by_delay, by_shape = (
                self._behind(change, half, theta, rest_at_zero=s.rest_at_zero)[0]
                for change in (by_offset, by_delay, by_shape)
            )
            (u,), by_lag = self._behind(u[None], half, theta, rest_at_zero=s.rest_at_zero)
        return np.ascontiguousarray(u), np.concatenate([by_offset, by_lag, by_delay, by_shape])

    def _behind(
        self, values: FloatArray, half: float, theta: FloatArray, *, rest_at_zero: bool
    ) -> tuple[FloatArray, FloatArray]:
        """Values (m, n, K) at every half step [s] behind the lag, and their derivatives by its logarithm."""
        lag = float(np.exp(theta[self.slices["input_lag"]][0]))
        held = self.structure.hold == "zero"
        parts = [lagged(each, half, lag, held=held, rest_at_zero=rest_at_zero) for each in values]
        behind, by_lag = (np.array([part[i] for part in parts]).reshape(values.shape) for i in (0, 1))
        return behind, by_lag

    def _effect(self, volts: FloatArray, theta: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
        """Effect of the drives, freed of offset, bent, past a dead zone, squared; its derivatives by the drive, and by
        bend and zone.
        """
        offset = theta[self.slices["input_offset"]]
        drive = volts - offset if len(offset) else volts
        slope = np.ones_like(drive)
        by_shape = np.empty((0, *drive.shape))
        if self.structure.bent_input:
            outputs = BENT.evaluate(drive=drive[..., None], bend=theta[self.slices["input_bend"]])
            drive = outputs["value"][..., 0]
            slope = outputs["slopes"][..., 0]
            by_shape = outputs["slopes"][None, ..., 1]
        if self.structure.dead_zone:
            zone = np.exp(theta[self.slices["input_zone"]])
            outputs = PAST_ZONE.evaluate(drive=drive[..., None], zone=zone)
            drive = outputs["value"][..., 0]
            steep = outputs["slopes"][..., 0]
            slope = slope * steep
            by_shape = np.concatenate((by_shape * steep, zone * outputs["slopes"][None, ..., 1]))
        if self.law == "squared":
            size = np.abs(drive) if self.structure.hold == "record" and self.squares_first else drive
            return size * drive, 2.0 * size * slope, 2.0 * size * by_shape
        return drive, slope, by_shape

    def full_effect(self, theta: FloatArray) -> FloatArray:
        """Effect of the largest inputs beyond that of none, shape (K,): 1, but for offsets and dead zones."""
        return np.asarray(np.ptp(self._effect(np.outer([0.0, 1.0], np.ones(len(self.signs))), theta)[0], axis=0))

    def at_rest(self, u: FloatArray, theta: FloatArray, *, begins: bool = True) -> FloatArray:
        """Inputs under which hidden elements rested before the first sample, shape (K,); `begins`: of a whole log."""
        if not (self.structure.rest_at_zero and begins):
            return np.ascontiguousarray(u[0])
        if self.structure.effect_lags:
            return np.zeros(u.shape[1])
        return np.ascontiguousarray(self._effect(np.zeros((1, u.shape[1])), theta)[0][0])


def kind_of(block: str) -> str:
    """The name of a block of θ without the numbers of its element and input."""
    return block.rstrip("0123456789_")


_PLACES = {"inertia": ARC, "inertia_centre": CENTRE, "drag": DRAG, "stops": STOPS}
"""Places of the derivatives by numbers of the equation, see `dynamics.NUMBER`."""
_KINDS = {
    "rate": RATE,
    "slip_force": SLIP_FORCE,
    "slip_length": SLIP_LENGTH,
    "inertia": NUMBER,
    "inertia_centre": NUMBER,
    "drag": NUMBER,
    "stops": NUMBER,
    "input_offset": INPUT_SHAPE,
    "input_lag": INPUT_SHAPE,
    "input_delay": INPUT_SHAPE,
    "input_bend": INPUT_SHAPE,
    "input_zone": INPUT_SHAPE,
}
