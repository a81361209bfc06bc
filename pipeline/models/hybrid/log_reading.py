"""A log as the equations of the joint read it: in units of the parameter set, by its angle if that was logged, and by
the voltages that act.

Equal equations in other units describe devices of other sizes: with lengths × a, times × b, voltages × c and masses × d
every constant of the equations is multiplied by d^i a^j b^k c^l, its dimension being kg^i m^j s^k V^l.

The log of an angle has φ as a displacement q, by φ(q) of the joint at rest without voltage. In motion φ follows the
slope τ of the beam's tip, φ = arctan τ (eq. 1), which voltages and viscosity move beside q (2 to 4 mm RMS on simulated
joints of 50 mm range). The equations therefore read y = τ / (dτ/dq of slow motions), a length and linear in their
state.

Voltages act late, behind the electrodes, and squared, on the half steps of the joint's integrator. A membrane of
capacitance C behind electrodes of resistance R charges with the time constant T = R C: T V̇ = v − V for its voltage V
under the measured v, from rest under the first one. What pulls is V².
"""

import dataclasses
from functools import cached_property
from typing import Annotated, Any

import numpy as np
from pydantic import Field, dataclasses as stored
from scipy.interpolate import CubicSpline

from ...errors import InputError
from ...generated.condensed_joint import BRANCHES, CONSTANTS, CREEPS, STOP_ELEMENTS, TIP_CONSTANTS
from ...numerics.arrays import FloatArray
from ...numerics.compiled import compiled, inner
from ...signals.log import Log
from ...units.units import POWERS
from ..model_file import STORED, Real, Unit

_UNITS = {
    "l": "m", "bending": "J", "bending_loss": "N·m·s", "mass": "kg", "cross": "kg·m", "inertia": "kg·m²",
    "gyration": "kg·m²", "interior_inertia": "kg·m²", "rise_qq": "1/m", "rise_tt": "m", "rise_tb": "m", "rise_bb": "m",
    "weight": "N", "offset": "m", "side_force": "N", "viscosity": "N·s/m", "friction_arm": "m",
    **{name: unit for name, _, _, unit in TIP_CONSTANTS},
    **{f"relaxation_{i}": "1/s" for i in range(BRANCHES)},
    **{f"{side}_{name}": "m" for side in ("left", "right") for name in ("a", "c", "e_z", "e_x", "l0")},
    **{f"{side}_elastic": "J" for side in ("left", "right")},
    **{f"{side}_electric": "F" for side in ("left", "right")},
    **{f"{side}_maxwell_{i}": "J" for side in ("left", "right") for i in range(BRANCHES)},
    **{f"{side}_viscous": "N·m·s" for side in ("left", "right")},
    **{f"stop_force_{i}": "N" for i in set(STOP_ELEMENTS)},
    **{f"stop_travel_{i}": "m" for i in set(STOP_ELEMENTS)},
    **{f"creep_stiffness_{i}": "N/m" for i in range(CREEPS)},
    **{f"creep_rate_{i}": "1/s" for i in range(CREEPS)},
    "softening_rate": "1/s",
}  # fmt: skip
"""Units of the constants of the kernels; what is not named is a number."""

DIMENSIONS = np.array([POWERS[_UNITS.get(name, "1")] for name in CONSTANTS])
"""Powers of kg, m, s and V in each of them, shape (len(CONSTANTS), 4)."""
_WEIGHTS = np.array(
    [POWERS[unit] for unit in ("N", "N·s/m", "N/V²", "N/V²", "N·m", "N·m", "N·m/V²", "N·m/V²", "N·m·s")]
)
"""Units of the weights of the corrections, rows as in `pipeline.models.hybrid.kernels`."""


_Size = Annotated[float, Field(ge=1e-3, le=1e3)]
ANGLE_IS_READ = (
    "{name} was identified from the angle of the joint, and {what} of it take a measured displacement; {way_out}"
)
"""Message with which uses of a model that read q alone refuse it."""
_NEWTON = 4
"""Steps from linear interpolation of 0.25 mm to rounding."""


@stored.dataclass(frozen=True, config=STORED)
class Similarity:
    """Size of the device over that of the parameter set."""

    length: _Size = 1.0
    time: _Size = 1.0
    voltage: _Size = 1.0
    mass: _Size = 1.0
    origin: Annotated[Real, Unit("m")] = 0.0
    """Reading of the laser that corresponds to q = 0 of the parameter set."""

    @property
    def _units(self) -> FloatArray:
        return np.array([self.mass, self.length, self.time, self.voltage])

    @cached_property
    def constants(self) -> FloatArray:
        """Factors on the kernel's constants, shape (len(CONSTANTS),)."""
        return np.asarray(np.prod(self._units**DIMENSIONS, axis=1))

    @cached_property
    def weights(self) -> FloatArray:
        """Factors on the rows of the corrections' weights, shape (CURVES,)."""
        return np.asarray(np.prod(self._units**_WEIGHTS, axis=1))

    def in_reference_units(self, record: Log) -> Log:
        """A log of the device as one of the set's joint."""
        speed = self.length / self.time
        return dataclasses.replace(
            record,
            t=record.t / self.time,
            q=(record.q - self.origin) / self.length,
            qdot=record.qdot / speed,
            qddot=record.qddot / (speed / self.time),
            v=record.v / self.voltage,
            fine=None if record.fine is None else record.fine / self.voltage,
            past=None if record.past is None else record.past / self.voltage,
            velocity=None if record.velocity is None else record.velocity / speed,
        )


SAME = Similarity()
"""The set's own joint."""


@dataclasses.dataclass(frozen=True)
class AngleReading:
    """Conversion between the displacement of a log and the reading of the equations.

    Attributes
    ----------
    rotation : FloatArray, shape (K, 2)
        Nodes of rising q [m] and φ [rad], by which the log was made; linear beyond.
    lead : float
        dτ/dq [1/m] of slow motions.
    """

    rotation: FloatArray
    lead: float

    @cached_property
    def _phi(self) -> Any:
        return CubicSpline(self.rotation[:, 0], self.rotation[:, 1])

    def _angle(self, q: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
        """φ of q, and its first and second derivative."""
        low, high = self.rotation[[0, -1], 0]
        inside = np.clip(q, low, high)
        slope = self._phi(inside, 1)
        return self._phi(inside) + slope * (q - inside), slope, np.where(q == inside, self._phi(inside, 2), 0.0)

    def read(self, q: FloatArray, qdot: FloatArray, qddot: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
        """Reading [m] and its derivatives, of a displacement of the log and its derivatives."""
        phi, slope, bend = self._angle(q)
        tau = np.tan(phi)
        stretch = 1.0 + tau**2
        first = stretch * slope / self.lead
        second = stretch * (2.0 * tau * slope**2 + bend) / self.lead
        return tau / self.lead, first * qdot, first * qddot + second * qdot**2

    def shown(self, y: FloatArray, ydot: FloatArray, yddot: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
        """Displacement of the log [m] and its derivatives, of a reading and its derivatives."""
        phi = np.arctan(self.lead * y)
        q = np.interp(phi, self.rotation[:, 1], self.rotation[:, 0])
        for _ in range(_NEWTON):
            there, slope, _ = self._angle(q)
            q = q - (there - phi) / slope
        zero = np.zeros_like(q)
        first = self.read(q, zero + 1.0, zero)[1]
        qdot = ydot / first
        return q, qdot, (yddot - self.read(q, qdot, zero)[2]) / first

    def log(self, log: Log) -> Log:
        """A log with the reading in place of its displacement."""
        q, qdot, qddot = self.read(log.q, log.qdot, log.qddot)
        velocity = None if log.velocity is None else self.read(log.q, log.velocity, log.qddot)[1]
        return dataclasses.replace(log, q=q, qdot=qdot, qddot=qddot, velocity=velocity)


@dataclasses.dataclass(frozen=True)
class Instruments:
    """Instruments between the joint and the log: laser, probes, electrodes."""

    offset: float
    """Laser reading [m] at q = 0."""
    delay: float
    """Time [s] by which the voltages act later than measured."""
    charging: float
    """Time constant [s] with which the membranes charge through their electrodes."""
    probe: FloatArray
    """Readings [V] of the two probes at zero voltage, shape (2,)."""


class DrivingVoltages:
    """Measured voltages of the two membranes between the samples of a log; `refined` if they are known there.

    Parameters
    ----------
    v : FloatArray, shape (N, 2) or (N, r, 2)
        Voltages [V] at the samples, or at r evenly spaced times of each sample interval, from the sample itself on.
    dt : float
        Sample interval [s].

    Raises
    ------
    InputError
        There are not two voltages.
    """

    def __init__(self, v: FloatArray, dt: float) -> None:
        if v.shape[-1] != 2:
            raise InputError(f"the hybrid joint has two membranes; the log gives {v.shape[-1]} voltage(s)")
        self._samples = len(v)
        self._dt = dt
        self._per_sample = v.shape[1] if v.ndim == 3 else 1
        self.refined = self._per_sample > 1
        self._v = np.ascontiguousarray(v.reshape(-1, 2)[: self._per_sample * (len(v) - 1) + 1])
        self._spline = None if self.refined else CubicSpline(dt * np.arange(len(v)), self._v)
        self._largest = float(np.abs(self._v).max())

    def squared(self, steps: int, seen: Instruments, largest: float) -> FloatArray:
        """Squared voltages [V²] on the half steps, shape (2 steps (N−1) + 1, 2).

        Parameters
        ----------
        steps : int
            Runge-Kutta steps in a sample interval.
        seen : Instruments
            Delay, charging time, and what the probes read at zero voltage.
        largest : float
            Largest trained voltage [V]; above twice that, where the film breaks down, the force is held.

        Notes
        -----
        Voltages known at the samples only are a cubic spline. It restores an anti-aliased edge of a pulse far better
        than straight lines, whose square takes 1.7 ms from it at a sample interval of 10 ms. Finer ones are straight
        lines. Each half step sees the mean of their square around it, so that no edge falls between half steps. From
        the 1 ms record two free runs were within 0.013 % of the range of those with steps of 0.4 ms. Cost for 37.5 s at
        three steps in 10 ms: 0.2 ms from samples, 0.4 ms from a 1 ms record.
        """
        limit = 2.0 * largest
        half = self._dt / (2 * steps)
        count = 2 * steps * (self._samples - 1) + 1
        if self._spline is not None:
            return _spline_squares(self._spline.c, self._dt, count, half, seen.delay, seen.charging, seen.probe, limit)
        v = self._v
        probe = seen.probe
        spacing = self._dt / self._per_sample
        if self._largest + np.abs(probe).max() > limit:
            v, probe = np.clip(v - probe, -limit, limit), np.zeros(2)
        v, areas = _charged(v, spacing, seen.charging)
        return _mean_squares(v, areas, spacing, count, half, seen.delay, probe)


@compiled
def _spline_squares(
    c: FloatArray,
    spacing: float,
    count: int,
    width: float,
    delay: float,
    charging: float,
    probe: FloatArray,
    limit: float,
) -> FloatArray:
    """Squares of voltages behind their electrodes at i·width, shape (count, K).

    Measured are cubic splines, `delay` earlier, without `probe` and held at ± `limit`; `c` (4, N − 1, K) holds their
    coefficients of (t − t_n)³, …, 1. Between the nodes they go on lines. Cost: 4 ns each.
    """
    cells = c.shape[1]
    columns = c.shape[2]
    out = np.empty((count, columns))
    remaining, mean = _shares(width / charging)
    for j in range(columns):
        charged = before = 0.0
        for i in range(count):
            t = min(max(i * width - delay, 0.0), spacing * cells)
            cell = min(int(t / spacing), cells - 1)
            s = t - cell * spacing
            v = ((c[0, cell, j] * s + c[1, cell, j]) * s + c[2, cell, j]) * s + c[3, cell, j] - probe[j]
            v = min(max(v, -limit), limit)
            charged = v if i == 0 else remaining * charged + (mean - remaining) * before + (1.0 - mean) * v
            before = v
            out[i, j] = charged * charged
    return out


@inner
def _shares(ratio: float) -> tuple[float, float]:
    """Remaining share of a lagged value after `ratio` time constants, and the mean share until then.

    A step of a lag z behind x on a line: z⁺ = kept z + (mean − kept) x + (1 − mean) x⁺, see
    `pipeline.numerics.linear_filters`.
    """
    return np.exp(-ratio), -np.expm1(-ratio) / ratio


@compiled
def _charged(v: FloatArray, spacing: float, lag: float) -> tuple[FloatArray, FloatArray]:
    """Lines through `v` behind a lag, exact at their ends, (N, K), and integrals from the first end, (2, K, N).

    The integrals are those of the lines through what is found, and of their squares. Cost: 3 ns each.
    """
    charged = np.empty_like(v)
    areas = np.zeros((2, v.shape[1], len(v)))
    remaining, mean = _shares(spacing / lag)
    earlier = mean - remaining
    later = 1.0 - mean
    half = spacing / 2.0
    third = spacing / 3.0
    for column in range(v.shape[1]):
        charged[0, column] = v[0, column]
    for i in range(len(v) - 1):
        for column in range(v.shape[1]):
            a = charged[i, column]
            b = remaining * a + earlier * v[i, column] + later * v[i + 1, column]
            charged[i + 1, column] = b
            areas[0, column, i + 1] = areas[0, column, i] + half * (a + b)
            areas[1, column, i + 1] = areas[1, column, i] + third * (a * a + a * b + b * b)
    return charged, areas


@compiled
def _mean_squares(
    v: FloatArray, areas: FloatArray, spacing: float, count: int, width: float, delay: float, probe: FloatArray
) -> FloatArray:
    """Means of the squares of lines through `v` − `probe` over windows of `width` at i·width − delay, shape (count, K).

    Before the first and after the last value of `v`, which are `spacing` apart, it is constant. The means are
    differences of the integrals from its beginning (`_charged`), right to 1e-11 of the largest square. Cost: 3 ns for
    each window.
    """
    last = len(v) - 1
    columns = v.shape[1]
    per_second = 1.0 / spacing
    per_window = 1.0 / width
    out = np.empty((count, columns))
    for column in range(columns):
        lines = areas[0, column]
        squares = areas[1, column]
        off = probe[column]
        before = 0.0
        for i in range(count + 1):
            t = (i - 0.5) * width - delay
            knot = min(max(int(t * per_second), 0), last)
            s = t - knot * spacing
            a = v[knot, column]
            slope = 0.0 if t < 0.0 or knot == last else (v[knot + 1, column] - a) * per_second
            line = lines[knot] + s * (a + 0.5 * slope * s)
            here = squares[knot] + s * (a * a + slope * s * (a + 1.0 / 3.0 * slope * s)) - 2.0 * off * line
            if i > 0:
                out[i - 1, column] = (here - before) * per_window + off * off
            before = here
    return out
