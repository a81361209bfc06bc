"""Constants of the slow-coordinate joint from a parameter set and deviations with stated widths.

A deviation is counted in prior standard deviations, so that the ridge of every estimate is the unit matrix. The widths
are those of a joint without a drawing. It is larger, slower or less sensitive by a tenth to a fifth, its mounts are
elsewhere by half a millimetre, its moduli differ by a fifth. Laser and probes are taken as right at full scale: another
scale would be another length or voltage of the joint, and nothing else.
"""

from dataclasses import dataclass
from functools import lru_cache
from itertools import combinations_with_replacement
from typing import Any

import numpy as np

from ...device.parameters import BEAM_DAMPING_FACTOR, JointParameters, Membrane
from ...generated.condensed_joint import (
    BENDS,
    CONSTANTS,
    CREEPS,
    LAYERS,
    QUARTICS,
    SEXTICS,
    SHAPES,
    SHORTENINGS,
    SLIPS,
    SLOPES,
    TIP_CONSTANTS,
    UPRIGHT,
)  # fmt: skip
from ...numerics.arrays import FloatArray
from .kernels import CURVES, INDEX, prepare
from .log_reading import DIMENSIONS
from .statics import rest_state

_ELEMENTS = (*(f"stop {{}} {i}" for i in range(SLIPS)), *(f"layer {{}} {i}" for i in range(LAYERS)))
"""Names of the slips of friction and of the layers of the beam that yield, for their forces and travels."""
_FORCES = (*SLIPS * (0.5e-3,), *LAYERS * (0.15e-3,))
"""Their typical forces [N]."""
CHARGING_TIME = 1e-3
"""Typical time constant [s] of a membrane behind its electrodes: some 10 nF behind some 100 kΩ."""
_TRAVELS = np.array([0.06e-3, 0.2e-3, 0.7e-3, 2.2e-3, 2e-3, 8e-3])  # typical ones of the stops
_CREEP_TIMES = np.array([0.06, 1.0])  # s
_SLOW_TIME, _FAST_TIME = 8.0, 0.05  # s
_LEAST_INERTIA = 2e-7  # kg·m²
_FASTEST = 440.0
"""Rate [1/s] of slope and interior mode against the beam's loss that least inertias allow: two or three steps in 10 ms
are then enough, and a mode faster than any that the logs show replaces one that is faster still."""


@dataclass(frozen=True)
class Deviation:
    """One number that is estimated, about its prior mean.

    Attributes
    ----------
    name : str
        Of the quantity; ``log`` before it where its logarithm is estimated.
    prior_std : float
        Prior standard deviation, in the unit or of the logarithm.
    unit : str
        SI unit of the quantity, a name in :data:`pipeline.units.units.POWERS`.
    typical : float or None
        Prior mean of a logarithm for which the parameter set has no value.
    """

    name: str
    prior_std: float
    unit: str
    typical: float | None = None

    @property
    def logarithm(self) -> bool:
        """True if the logarithm of the quantity is estimated."""
        return self.name.rpartition(".")[2].startswith("log ")

    @property
    def quantity(self) -> str:
        """The quantity's name, ``left.`` or ``right.`` before it where each side has its own."""
        side, dot, name = self.name.rpartition(".")
        return f"{side}{dot}{name.removeprefix('log ')}"


def _sides(name: str, prior_std: float, unit: str) -> list[Deviation]:
    return [Deviation(f"{side}.{name}", prior_std, unit) for side in ("left", "right")]


def _unknown(name: str, typical: float, unit: str, prior_std: float = 1.2) -> Deviation:
    """Deviation of the logarithm of a positive number whose order of magnitude alone is given."""
    return Deviation(f"log {name}", prior_std, unit, typical)


DEVIATIONS: tuple[Deviation, ...] = (
    Deviation("log length", 0.2, "m"),
    Deviation("log time", 0.1, "s"),
    Deviation("log voltage", 0.1, "V"),
    Deviation("log E", 0.22, "Pa"),
    Deviation("log eta", 0.6, "Pa·s"),
    Deviation("log eta_v", 1.0, "Pa·s"),
    *_sides("log Y", 0.22, "Pa"),
    *_sides("log C0", 0.3, "F"),
    *_sides("log Y_MW", 0.75, "Pa"),
    Deviation("log relaxation", 0.5, "1/s"),
    _unknown("slow modulus", 20e3, "Pa"),
    Deviation("log slow time", 0.5, "s"),
    _unknown("fast modulus", 20e3, "Pa"),
    Deviation("log fast time", 0.5, "s"),
    Deviation("strain slope", 0.4, "1"),
    *_sides("b", 0.6e-3, "m"),
    *_sides("e_z", 0.45e-3, "m"),
    *_sides("a", 0.45e-3, "m"),
    Deviation("e_x", 0.45e-3, "m"),
    Deviation("tilt", 0.02, "rad"),
    Deviation("curvature", 0.02, "1"),
    Deviation("steepening", 0.5, "1"),
    _unknown("stiffening", 0.05, "1"),
    Deviation("slope by q", 0.25, "1"),
    Deviation("slope by tau", 0.25, "1"),
    Deviation("slope by beta", 0.05, "1"),
    Deviation("shortening qq", 0.1, "1"),
    Deviation("shortening qt", 0.1, "1"),
    Deviation("shortening tt", 0.1, "1"),
    Deviation("shortening qb", 0.02, "1"),
    Deviation("shortening tb", 0.02, "1"),
    Deviation("shortening bb", 0.005, "1"),
    *(Deviation(f"quartic {powers}", 5.0 * 0.3 ** powers.count("b"), "1") for powers in QUARTICS),
    *(Deviation(f"sextic {powers}", 30.0 * 0.3 ** powers.count("b"), "1") for powers in SEXTICS),
    *(Deviation(f"shortening {powers}", 0.25 * 0.3 ** powers.count("b"), "1") for powers in SHORTENINGS),
    Deviation("rotation", 0.5, "1"),
    Deviation("log weight", 0.3, "N"),
    Deviation("offset", 4e-3, "m"),
    _unknown("radius", 10e-3, "m", 0.7),
    Deviation("hardening", 0.6, "1"),
    Deviation("hardening slope", 1.0, "1"),
    Deviation("electric slope", 0.4, "1"),
    _unknown("viscosity", 5e-3, "N·s/m"),
    *(_unknown(name.replace("_", " "), typical, unit, prior_std) for name, typical, prior_std, unit in TIP_CONSTANTS),
    Deviation("friction arm", 5e-3, "m"),
    *(_unknown(name.format("force"), force, "N") for name, force in zip(_ELEMENTS, _FORCES, strict=True)),
    *(Deviation(f"log {name.format('travel')}", 0.5, "m") for name in _ELEMENTS),
    *(_unknown(f"creep stiffness {i}", 0.04, "N/m") for i in range(CREEPS)),
    Deviation("softening", 0.02, "1"),
    _unknown("softening rate", 0.02, "1/s", 1.0),
    Deviation("laser offset", 0.15e-3, "m"),
    Deviation("delay", 6e-3, "s"),
    _unknown("charging time", CHARGING_TIME, "s", 1.5),
    Deviation("probe 1", 10.0, "V"),
    Deviation("probe 2", 10.0, "V"),
)
"""Everything in which a real joint and its instruments may differ from the parameter set, its size first: the
whole joint in other units of length, time and voltage (`pipeline.models.hybrid.log_reading`). What cannot be
negative is a logarithm. A square has no slope at zero, and an estimate that came near it would stay there: of fourteen
simulated joints four lost a relaxation or the frame's inertia so, with three to six times the error held at the log."""

NAMES = tuple(entry.name for entry in DEVIATIONS)
PRIOR_STD = np.array([entry.prior_std for entry in DEVIATIONS])
"""Standard deviations of their priors, in which θ counts."""
_LOGARITHMS = np.array([entry.typical is not None for entry in DEVIATIONS])
_TYPICAL = np.array([entry.typical or 0.0 for entry in DEVIATIONS])
_KEYS = tuple(e.name if e.typical is None else e.name.removeprefix("log ") for e in DEVIATIONS)
OF_INSTRUMENTS = [NAMES.index(name) for name in ("laser offset", "delay", "log charging time", "probe 1", "probe 2")]


def nominal_deviations() -> FloatArray:
    """Deviations of the parameter set itself, shape (P,): no friction, no creep, nothing that it does not name."""
    return np.array([0.0 if entry.typical is None else -50.0 for entry in DEVIATIONS])


def static_slope_ratio(parameters: JointParameters) -> float:
    """τ / Q of the beam at rest at q = l/8: the shape in which tip and beam move slowly."""
    q = parameters.l / 8.0
    k = constants(parameters, nominal_deviations(), 1.25)  # any ratio: corrections alone read it
    x, _ = rest_state(q, np.zeros(2), k, prepare(k[None])[0], np.zeros(3), np.zeros((CURVES, 0)), 0.0)
    return float(x[2] * parameters.l / q)


def moving_mass(p: JointParameters, ratio: float) -> float:
    """Mass [kg] that moves with q slowly: the frame and ∫(h1 + ratio h2)² of the beam's mass."""
    slow = np.array([1.0, ratio, 0.0])
    return p.m + float(slow @ SHAPES @ slow) * p.rho * p.A * p.l


def constants(p: JointParameters, deviations: FloatArray, ratio: float) -> FloatArray:
    """Constants of the kernels (`pipeline.generated.condensed_joint.CONSTANTS`), shape (…, len(CONSTANTS)).

    Parameters
    ----------
    p : JointParameters
        The parameter set.
    deviations : FloatArray, shape (…, P)
        In widths, in the order of `DEVIATIONS`.
    ratio : float
        τ / Q of slow motions, from `static_slope_ratio`: the corrections take the shape's deviation from there.
        Cost: 0.3 ms, and 1 µs more for each of many joints.
    """
    d = _values(deviations)
    values = _beam_and_frame(p, d) | {"slope_ratio": ratio}
    for name in ("softening", "softening_rate", *(name for name, *_ in TIP_CONSTANTS)):
        values[name] = d[name.replace("_", " ")]
    for kind, terms in (("quartic", QUARTICS), ("sextic", SEXTICS), ("shortening", SHORTENINGS)):
        values |= {f"{kind}_{powers}": d[f"{kind} {powers}"] for powers in terms}
    for side, membrane in (("left", p.left), ("right", p.right)):
        values |= {f"{side}_{name}": value for name, value in _side(membrane, side, d).items()}
    for i, name in enumerate(_ELEMENTS):
        travel = _TRAVELS[i] * np.exp(d[f"log {name.format('travel')}"])
        values |= {f"stop_force_{i}": d[name.format("force")], f"stop_travel_{i}": travel}
    for i in range(CREEPS):
        values |= {f"creep_stiffness_{i}": d[f"creep stiffness {i}"], f"creep_rate_{i}": 1.0 / _CREEP_TIMES[i]}
    k = np.empty((*np.shape(deviations)[:-1], len(CONSTANTS)))
    for name, value in values.items():
        k[..., INDEX[name]] = value
    # The load changes little when the beam is bent, so the axial strain u0 of eq. 9 that it causes can be a constant.
    k[..., [INDEX["left_e_x"], INDEX["right_e_x"]]] += UPRIGHT.evaluate(k=k)["load"] / (p.E * p.A / p.l)
    size = np.stack([d["log length"], d["log time"], d["log voltage"]], axis=-1)
    return np.asarray(k * np.exp(size @ DIMENSIONS[:, 1:].T))


def _beam_and_frame(p: JointParameters, d: dict[str, Any]) -> dict[str, Any]:
    """Constants of the beam, the frame and what resists the tip."""
    # ∫ over the beam in the scaled coordinate leaves 1/l.
    loss = BEAM_DAMPING_FACTOR * p.eta * np.exp(d["log eta"]) * p.I / p.l
    beam = p.rho * p.A * p.l
    by_q = d["slope by q"]
    by_tau = 1.0 + d["slope by tau"]
    by_beta = d["slope by beta"]
    least = _LEAST_INERTIA + BENDS[1][1] * loss * by_tau**2 / _FASTEST
    mass = p.m + SHAPES[0][0] * beam
    weight = p.m * p.g * np.exp(d["log weight"])
    return _rises(d, (by_q, by_tau, by_beta), p.l) | {
        "l": p.l,
        "bending": p.E * np.exp(d["log E"]) * p.I / p.l,
        "bending_loss": loss,
        "steepening": 1.0 + d["steepening"],
        "stiffening": d["stiffening"],
        "curvature": p.kappa0 * p.l + d["curvature"],
        "slope_by_q": by_q,
        "slope_by_tau": by_tau,
        "slope_by_beta": by_beta,
        "rotation": 1.0 + d["rotation"],
        "mass": mass,
        "cross": SHAPES[0][1] * beam * p.l,
        "inertia": least + SHAPES[1][1] * beam * p.l**2,
        "gyration": mass * d["radius"] ** 2,
        "interior_inertia": SHAPES[2][2] * beam * p.l**2 + BENDS[2][2] * loss / _FASTEST,
        "weight": weight,
        "offset": d["offset"],
        "side_force": weight * np.sin(d["tilt"]),
        "relaxation_0": 0.5 * (p.left.relaxation + p.right.relaxation) * np.exp(d["log relaxation"]),
        "relaxation_1": np.exp(-d["log slow time"]) / _SLOW_TIME,
        "relaxation_2": np.exp(-d["log fast time"]) / _FAST_TIME,
        "strain_slope": d["strain slope"],
        "viscosity": d["viscosity"],
        "friction_arm": d["friction arm"],
    }


def _rises(d: dict[str, Any], own_slope: tuple[Any, Any, Any], l: float) -> dict[str, Any]:
    """R of `pipeline.equations.condensed_parts.raised`: ∫W'² of the beam with its own slope, and the deviations."""
    slope = [[1.0, 0.0, 0.0], own_slope, [0.0, 0.0, 1.0]]
    units = (1.0, l, l)
    rises = {}
    for i, j in combinations_with_replacement(range(3), 2):
        name = "qtb"[i] + "qtb"[j]
        bent = sum(slope[m][i] * SLOPES[m][n] * slope[n][j] for m in range(3) for n in range(3))
        rises[f"rise_{name}"] = (bent + d[f"shortening {name}"]) * units[i] * units[j] / l
    return rises


@lru_cache(maxsize=32)
def correction_prior_std(p: JointParameters) -> FloatArray:
    """Prior widths of the corrections' weights, shape (9,), one for each corrected curve.

    About a tenth of what the beam and the membranes of the drawing have: 4 mN (10 % of the actuation), 0.04 N·s/m,
    4e-10 N/V² (10 % of g), 0.2 mN·m, 8 mN·m, 2e-11 N·m/V² and 160 µN·m·s.
    """
    stiffness = p.E * p.I / p.l
    loss = BEAM_DAMPING_FACTOR * p.eta * p.I / p.l
    electric = _side(p.left, "left", _values(np.zeros(len(NAMES))))["electric"] / p.left.l0
    slow = [0.017 * stiffness / p.l, 3.6 * loss / p.l**2, 7.8e-3 * electric, 7.8e-3 * electric]
    return np.array(
        [*slow, 9.2e-3 * stiffness, 0.36 * stiffness, 4.4e-3 * electric * p.l, 4.4e-3 * electric * p.l, 1.8 * loss]
    )


def _values(deviations: FloatArray) -> dict[str, Any]:
    """Every deviation in its unit by its name, and what the set does not name as itself, not as a logarithm.

    Each is a number, or an array where there are several sets of deviations.
    """
    x = deviations * PRIOR_STD
    factors = np.where(_LOGARITHMS, _TYPICAL * np.exp(_LOGARITHMS * x), x)
    return dict(zip(_KEYS, factors.tolist() if factors.ndim == 1 else np.moveaxis(factors, -1, 0), strict=True))


def _side(membrane: Membrane, side: str, d: dict[str, Any]) -> dict[str, Any]:
    return {
        "a": membrane.a + d[f"{side}.a"],
        "c": membrane.b - membrane.a0 + d[f"{side}.b"],
        "e_z": membrane.e_z + d[f"{side}.e_z"],
        "e_x": membrane.e_x + d["e_x"],
        "l0": membrane.l0,
        "elastic": membrane.volume * membrane.Y / 6.0 * np.exp(d[f"{side}.log Y"]),
        "hardening": d["hardening"],
        "hardening_slope": d["hardening slope"],
        "electric": 0.5 * membrane.capacitance * np.exp(d[f"{side}.log C0"]),
        "electric_slope": d["electric slope"],
        "maxwell_0": membrane.volume * membrane.Y_MW * np.exp(d[f"{side}.log Y_MW"]),
        "maxwell_1": membrane.volume * d["slow modulus"],
        "maxwell_2": membrane.volume * d["fast modulus"],
        "viscous": membrane.volume * membrane.eta_v * np.exp(d["log eta_v"]),
    }
