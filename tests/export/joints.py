"""Models with every element that the exports must carry, and a way to run compiled C beside them."""

import ctypes
import shutil
import subprocess
import zlib
from dataclasses import replace
from pathlib import Path

import numpy as np
from scipy.interpolate import CubicSpline

from pipeline.device.device import JOINT
from pipeline.device.parameters import NOMINAL
from pipeline.export.sources import c_sources
from pipeline.export.subject import Subject, Validity
from pipeline.models.base import DynamicModel
from pipeline.models.hybrid import parameters as condensed_parameters
from pipeline.models.hybrid.kernels import CURVES as CORRECTIONS
from pipeline.models.hybrid.model import HybridModel
from pipeline.models.hybrid.problem import CondensedJoint
from pipeline.models.paper.model import RbfPaperModel
from pipeline.models.polynomial_dynamics import FIRST_INPUT, QDOT, Lag, PolynomialDynamics
from pipeline.models.rbf.model import RbfModel
from pipeline.models.rbf.parameter_layout import ParameterLayout
from pipeline.models.rbf.structure import JointScales, JointStructure, drive_at_nodes
from pipeline.models.sindy.model import SindyModel
from pipeline.numerics.arrays import FloatArray
from pipeline.units.units import SiUnit

COMPILER = shutil.which("gcc")
OCTAVE = shutil.which("octave-cli")
INTERVAL = 0.01
STRICT = ("-std=c99", "-Wall", "-Wextra", "-Werror", "-pedantic", "-Wshadow")


def hybrid(centres: int = 5, delay: float = 0.5) -> HybridModel:
    """Asymmetric, with friction, creep, corrections, a laser and probes that are off, and a delay [widths]."""
    basis = np.array([-0.02, 0.01, 0.008])
    condensed = CondensedJoint(NOMINAL, basis, centres, 3000.0, condensed_parameters.static_slope_ratio(NOMINAL))
    theta = condensed.start()
    planted = {
        "left.log C0": 1.0,
        "log eta": 0.8,
        "log stop force 0": 0.8,
        "delay": delay,
        "laser offset": 0.7,
        "probe 1": 1.0,
    }
    for name, value in planted.items():
        theta[condensed_parameters.NAMES.index(name)] = value
    theta[len(condensed_parameters.NAMES) :] = 0.4 * np.random.default_rng(4).standard_normal(CORRECTIONS * centres)
    return HybridModel.of(condensed, theta, *2 * (np.zeros((len(theta), 1)),))


def data_driven(
    law: str = "squared",
    inputs: int = 2,
    lag: float | None = None,
    *,
    rest_at_zero: bool = False,
    effect_lags: bool = False,
) -> RbfModel:
    """A double well with hidden elements, friction and an arc; with `lag` [s] of its inputs, or of what they do."""
    structure = JointStructure(
        basis_functions=8,
        rates=(6.0, 0.2),
        shape_elements=1,
        input_lag=lag is not None,
        rest_at_zero=rest_at_zero,
        effect_lags=effect_lags,
    )
    signs = (1, -1)[:inputs] if law == "squared" else (0,) * inputs
    p = ParameterLayout(structure, JointScales(0.001, 0.022, 3000.0, 50.0), law, signs)
    theta, at = np.zeros(p.count), p.slices
    theta[at["force"]][:4] = 2.0, 70.0, 5.0, np.log(230.0)
    theta[at["damping"]] = np.log(0.4)
    for i, (sign, gain) in enumerate(zip(signs, (15.0, 14.0), strict=False)):
        theta[at[f"input{i}"]] = np.log(gain) if sign else gain
    theta[at["coupling0"]], theta[at["coupling1"]] = 3.0, np.linspace(1.0, 3.0, 8)
    theta[at["rate"]], theta[at["pull0_0"]] = np.log([60.0, 3.0]), 0.5
    theta[at["slip_force"]], theta[at["slip_length"]] = np.log(0.4), np.log(0.01)
    theta[at["inertia"]] = np.log(0.15)
    theta[at["input_offset"]] = 0.01
    theta[at["input_lag"]] = np.log(lag or 1.0)
    return RbfModel(p, theta, *np.zeros((2, p.count, 1)), 0.04)


def turning_arm() -> RbfModel:
    """A propeller's arm: one lagged input that saturates, weight that turns with it."""
    structure = JointStructure(
        6,
        rates=(),
        shape_elements=0,
        arc=False,
        input_lag=True,
        bent_input=True,
        turning_arm=True,
        drag=True,
        stops=True,
        dead_zone=True,
    )
    p = ParameterLayout(structure, JointScales(0.8, 0.7, 60.0, 20.0), "squared", (1,))
    theta, at = np.zeros(p.count), p.slices
    theta[at["force"]][:4] = 1.0, -12.0, 2.0, np.log(3.0)
    theta[at["damping"]], theta[at["input0"]] = np.log(0.6), np.log(12.0)
    theta[at["slip_force"]], theta[at["slip_length"]] = np.log(0.3), np.log(0.02)
    theta[at["input_lag"]], theta[at["input_bend"]], theta[at["drag"]] = np.log(0.08), 0.6, np.log(0.2)
    theta[at["input_zone"]] = np.log(0.07)
    theta[at["stops"]] = -0.9, 0.8, np.log(400.0), np.log(4.0)
    return RbfModel(p, theta, *np.zeros((2, p.count, 1)), 1.0)


PLAIN = JointStructure(
    5,
    rates=(),
    shape_elements=0,
    slips=0,
    arc=False,
    force="polynomial",
    constant_damping=True,
    constant_gain=True,
)
"""A mass on a spring."""


def held_slider(delay: float | None = None) -> RbfModel:
    """A mass on a spring with friction, driven by a force that is held between the samples; `delay` [s] later."""
    structure = replace(PLAIN, slips=1, hold="zero", input_delay=delay is not None)
    p = ParameterLayout(structure, JointScales(0.0, 0.01, 1.0, 20.0), "linear", (0,))
    theta, at = np.zeros(p.count), p.slices
    theta[at["force"]] = 0.0, -60.0, 0.0, np.log(20.0)
    theta[at["damping"]], theta[at["input0"]] = np.log(2.0), 40.0
    theta[at["slip_force"]], theta[at["slip_length"]] = np.log(3.0), np.log(0.1)
    theta[at["input_delay"]] = np.log(delay or 1.0)
    return RbfModel(p, theta, *np.zeros((2, p.count, 1)))


def overdamped() -> RbfModel:
    """What hardly shows its inertia: a velocity decays in an eighth of a sample interval, so that steps are short."""
    p = ParameterLayout(replace(PLAIN, overdamped=True), JointScales(0.0, 0.01, 3000.0, 20.0, 1.0), "squared", (1, -1))
    theta, at = np.zeros(p.count), p.slices
    theta[at["force"]] = 0.0, -3000.0, 0.0, np.log(20.0)
    theta[at["damping"]] = np.log(800.0)
    theta[at["input0"]], theta[at["input1"]] = np.log(2000.0), np.log(1500.0)
    return RbfModel(p, theta, *np.zeros((2, p.count, 1)))


def paper() -> RbfPaperModel:
    """A double well of seven basis functions."""
    centres = np.linspace(-0.022, 0.024, 7)
    stiffness = 40.0 * ((centres / 0.012) ** 2 - 1.0)
    weights = np.array([stiffness, np.full(7, 0.1), np.full(7, 3e-8), np.full(7, -3e-8)])
    return RbfPaperModel(
        centres=centres, smoothing=0.8, weights=weights, lag_s=0.02, mass_kg=0.04, spread=0.01 * weights.reshape(-1, 1)
    )


def sindy() -> SindyModel:
    """q̈ of a cubic double well with lagged friction, a tanh and two inputs, one of them lagged."""
    rows = [
        [0, 1, 0, 0, 0, 0, 0, 0, 0],
        [1, 0, 0, 0, 0, 0, 0, 0, 0],
        [3, 0, 0, 0, 0, 0, 0, 0, 0],
        [0, 0, 0, 0, 0, 0, 0, 1, 0],
        [0, 0, 1, 0, 0, 0, 0, 0, 0],
        [0, 0, 0, 0, 0, 1, 0, 0, 0],
        [1, 0, 0, 0, 0, 0, 1, 0, 0],
        [0, 0, 0, 0, 0, 0, 0, 0, 1],
    ]
    coefficients = np.zeros((2, len(rows)))
    coefficients[0, 0] = 0.3
    coefficients[1, 1:] = 1.2, -4.0, -1.0, -0.2, 1.5, 0.3, -1.4
    scales = np.array([0.022, 0.3, 0.03, 1.0, 1.0, 9e6, 9e6])
    lags = (Lag(QDOT, 0.02), Lag(FIRST_INPUT + 1, 0.05))
    dynamics = PolynomialDynamics(np.array(rows), coefficients, scales, lags, True, -0.1, 0.1)
    return SindyModel.of(dynamics, JOINT)


def pulses(seconds: float, inputs: int = 2, peak: float = 3000.0) -> tuple[FloatArray, FloatArray]:
    """Smooth-edged pulses on alternating sides: both wells, a few switches."""
    random, t = np.random.default_rng(1), np.arange(round(seconds / INTERVAL) + 1) * INTERVAL
    v, start, side = np.zeros((len(t), inputs)), 0.3, 0
    while start < seconds - 0.3:
        length = random.uniform(0.4, 0.9)
        edges = np.tanh((t - start) / 0.01) - np.tanh((t - start - length) / 0.01)
        v[:, side % inputs] += 0.5 * random.uniform(0.8 * peak, peak) * edges
        start, side = start + length + random.uniform(0.3, 0.6), side + 1
    return t, v


def subject(
    model: DynamicModel, seconds: float = 4.0, *, inputs: int = 2, peak: float = 3000.0, unit: str = "m"
) -> Subject:
    """A model with a log of pulses as its check."""
    t, v = pulses(seconds, inputs, peak)
    validity = Validity((-0.02, 0.02), (-0.3, 0.3), ((0.0, peak),) * inputs, INTERVAL, unit, ("V",) * inputs)
    units = replace(JOINT, displacement=SiUnit(1.0, unit), known_mass=1.0).curve_units
    return Subject("demo-1", model.name, model, validity, "0" * 64, t, v, (-0.0105, 0.0), units)


class CompiledModel:
    """An exported model, compiled to a shared library and called step by step."""

    def __init__(self, what: Subject, folder: Path, *, single: bool = False, flags: tuple[str, ...] = ()) -> None:
        self.subject, self.realisation = what, what.realisation()
        for name, text in c_sources(what, self.realisation).items():
            (folder / name).write_text(text, encoding="utf-8")
        # A name of its own: a process loads each path only once.
        library = folder / f"{'single' if single else 'double'}-{zlib.crc32(repr(flags).encode())}.so"
        precision = (f"-D{what.identifier.upper()}_SINGLE",) if single else ()
        source = folder / f"{what.identifier}.c"
        subprocess.run(
            [COMPILER, *STRICT, "-O2", *flags, *precision, "-shared", "-fPIC", source, "-o", library, "-lm"], check=True
        )
        self._library = ctypes.CDLL(str(library))
        self._real, self._dtype = (ctypes.c_float, np.float32) if single else (ctypes.c_double, np.float64)
        r = self.realisation
        self.state = (self._real * (len(r.states) + max(1, len(r.hysteresis_states)) + r.inputs))()

    def call(self, name: str, *arguments: object) -> int:
        """Call a function with the state, then numbers and arrays."""
        function = self._library[f"{self.subject.identifier}_{name}"]
        passed = [a.ctypes.data_as(ctypes.c_void_p) if isinstance(a, np.ndarray) else self._real(a) for a in arguments]
        return int(function(self.state, *passed))

    def array(self, values: object) -> np.ndarray:
        """An array in the precision of the library."""
        return np.ascontiguousarray(values, dtype=self._dtype)

    def free_run(self, half_steps: FloatArray) -> FloatArray:
        """q, q̇, q̈ at the samples for voltages on the half steps, shape (N, 3)."""
        steps = round(self.subject.validity.sample_interval / self.realisation.step)
        held = self.realisation.between == "zero"
        v, y = self.array(half_steps), self.array(np.zeros(3))
        samples = (len(v) - 1) // (2 * steps) + 1
        found = np.empty((samples, 3))
        self.call("start", *self.subject.start, v[0])
        for n in range(samples):
            self.call("read", y)
            found[n] = y
            if n < samples - 1:
                for place in range(2 * n * steps, 2 * (n + 1) * steps, 2):
                    if held:  # advance() cannot tell of a jump at a sample
                        self.call("step", v[place + 2])
                    else:
                        self.call("advance", v[place + 1], v[place + 2], self.realisation.step)
        return found


def half_steps(what: Subject, parts: int = 1) -> FloatArray:
    """The subject's voltages on the half steps of its model's integrator, as debist itself interpolates them.

    With `parts`, on the half steps of so many parts of its steps.
    """
    r = what.realisation()
    t = what.t - what.t[0]
    steps = parts * round(what.validity.sample_interval / r.step)
    fine = np.linspace(0.0, t[-1], 2 * steps * (len(t) - 1) + 1)
    if r.between == "cubic":
        return np.asarray(CubicSpline(t, what.v)(np.clip(fine - r.delay, 0.0, t[-1])))
    if r.between == "zero":  # a delay that ends within a step leaves the mean of what is held over it
        return drive_at_nodes(what.v, what.validity.sample_interval, steps, "zero", r.delay)
    return np.column_stack([np.interp(fine - r.delay, t, column) for column in what.v.T])
