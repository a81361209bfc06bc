"""Parameters of a full-order virtual joint, one flat tuple that the compiled kernels read."""

from collections.abc import Mapping
from typing import Any, NamedTuple

import numpy as np

from ..numerics.arrays import FloatArray

# Beam theories
RITZ = 0
CHAIN = 1
# Rubber laws
NEO_HOOKEAN = 0
GENT = 1
MOONEY_RIVLIN = 2
OGDEN = 3
# Strain that the viscous branches see: thickness stretch λ3 (§3.2.4), or Hencky strain ln λ1
THICKNESS = 0
HENCKY = 1
# Friction laws
MAXWELL_SLIP = 0
LUGRE = 1
BOUC_WEN = 2
DAHL = 3

EPS0 = 8.854e-12  # A s/(V m)
LAYERS, FILM, AREA, PERMITTIVITY = 8, 50e-6, 1326e-6, 2.8  # Table 1: n, d0 [m], A0 [m²], εr
VOLUME = LAYERS * AREA * FILM  # m³
CAPACITANCE = LAYERS * EPS0 * PERMITTIVITY * AREA / FILM  # F


class RigParameters(NamedTuple):
    """A joint with its own left and right membrane; SI units; pairs are (left, right).

    The beam is either a Ritz polynomial with four coordinates (`beam` = ``RITZ``, eqs. 1–13) or a chain of
    rigid links on rotational springs (``CHAIN``), which converges to the geometrically exact inextensible
    elastica. Fields of the theory not chosen are ignored.
    """

    beam: int
    length: float  # l [m]
    mass: float  # moving mass [kg]
    frame_inertia: float  # of the frame about its centre [kg m²]
    frame_offset: float  # of its centre beyond the beam's tip, along the beam [m]
    gravity: float  # [m/s²]
    line_density: float  # ρA [kg/m]
    line_inertia: float  # ρI [kg m]
    bending: float  # EI [N m²]
    axial: float  # EA [N]
    bending_loss: float  # 2ηI [N m² s]
    curvature: float  # natural curvature of the beam as printed [1/m]
    hinge_stiffness: FloatArray  # (links,) [N m/rad]
    hinge_loss: FloatArray  # (links,) [N m s/rad]
    hinge_cubic: float  # relative stiffening k(1 + c·Δθ²) [1/rad²]
    arm: FloatArray  # (2,) a [m]
    drop: FloatArray  # (2,) b − a0 [m]
    anchor_x: FloatArray  # (2,) e_z [m]
    anchor_y: FloatArray  # (2,) e_x [m]
    free_length: FloatArray  # (2,) l0 [m]
    volume: FloatArray  # (2,) [m³]
    modulus: FloatArray  # (2,) Y [Pa]
    rubber: int
    rubber_shape: FloatArray  # (2,) constants of the rubber law, see membrane.py
    capacitance: FloatArray  # (2,) C0 [F]
    capacitance_exponent: float  # γ in C = C0 λ1^γ
    kelvin_voigt: float  # η_v [Pa s]
    strain: int
    branch_modulus: FloatArray  # (2, branches) [Pa]
    branch_time: FloatArray  # (branches,) [s]
    friction: int
    friction_arm: float  # r in the sliding coordinate q + r φ [m]
    slip_stiffness: FloatArray  # (elements,) [N/m]
    slip_force: FloatArray  # (elements,) [N]
    friction_shape: FloatArray  # (4,) constants of the friction law, see friction.py
    plastic_share: FloatArray  # (layers,) share of the hinges' stiffness in layers that yield
    plastic_yield: FloatArray  # (layers,) curvature at which they do [1/m]
    softening: float  # share of the rubber's modulus that is lost with use
    softening_time: float  # [s]


def nominal(*, links: int = 5) -> RigParameters:
    """The designer's drawing: Table 1 as corrected with E = 1.76 GPa, symmetric, without friction and creep."""
    pair = np.ones(2)
    length = 90e-3
    modulus = 1.76e9
    second_moment = 1.1e-12
    section = 11e-6
    density = 1200.0
    link = length / links
    hinge = np.full(links, modulus * second_moment / link)
    hinge[0] *= 2.0  # the clamp's half cell
    loss = 2 * 3.64e6 * second_moment
    return RigParameters(
        beam=RITZ,
        length=length,
        mass=40e-3,
        frame_inertia=0.0,
        frame_offset=0.0,
        gravity=9.81,
        line_density=density * section,
        line_inertia=density * second_moment,
        bending=modulus * second_moment,
        axial=modulus * section,
        bending_loss=loss,
        curvature=0.0,
        hinge_stiffness=hinge,
        hinge_loss=hinge * loss / (modulus * second_moment),
        hinge_cubic=0.0,
        arm=32e-3 * pair, drop=12e-3 * pair, anchor_x=16e-3 * pair, anchor_y=7e-3 * pair,
        free_length=51e-3 * pair,
        volume=VOLUME * pair,
        modulus=1.2e6 * pair,
        rubber=NEO_HOOKEAN, rubber_shape=np.zeros(2),
        capacitance=CAPACITANCE * pair,
        capacitance_exponent=1.0,
        kelvin_voigt=300.0, strain=THICKNESS,
        branch_modulus=np.full((2, 1), 0.31e6),
        branch_time=np.array([83.5e3 / 0.31e6]),
        friction=MAXWELL_SLIP,
        friction_arm=0.0,
        slip_stiffness=np.zeros(1),
        slip_force=np.ones(1),
        friction_shape=np.zeros(4),
        plastic_share=np.zeros(1), plastic_yield=np.ones(1),
        softening=0.0, softening_time=1.0,
    )  # fmt: skip


def table1() -> RigParameters:
    """Table 1 as printed, corrected: E = 1.62 GPa; it needs at least 2.4 kV to switch."""
    p = nominal()
    ratio = 1.62 / 1.76
    return p._replace(bending=p.bending * ratio, axial=p.axial * ratio, hinge_stiffness=p.hinge_stiffness * ratio)


_POWERS = {
    **dict.fromkeys(("length", "frame_offset", "arm", "drop", "anchor_x", "anchor_y", "free_length", "modulus",
                     "branch_modulus", "friction_arm"), 1.0),
    **dict.fromkeys(("branch_time", "softening_time"), 0.5), "kelvin_voigt": 1.5,
    **dict.fromkeys(("line_density", "slip_stiffness"), 2.0),
    **dict.fromkeys(("mass", "axial", "volume", "slip_force"), 3.0),
    **dict.fromkeys(("line_inertia", "hinge_stiffness", "capacitance"), 4.0), "hinge_loss": 4.5,
    **dict.fromkeys(("frame_inertia", "bending"), 5.0), "bending_loss": 5.5,
    **dict.fromkeys(("curvature", "plastic_yield"), -1.0),
}  # fmt: skip
"""Powers of the size: lengths by the first, times by the half, masses by the third, so that gravity stays."""


def sized(p: RigParameters, size: float) -> RigParameters:
    """A joint `size` times as long that moves alike, slower by the root of it, under the same voltages.

    The constants of friction beyond its force stay.
    """
    return p._replace(**{name: getattr(p, name) * size**power for name, power in _POWERS.items()})


def coordinates(p: RigParameters) -> int:
    """How many generalised coordinates the beam has."""
    return 4 if p.beam == RITZ else p.hinge_stiffness.size


_BEAMS = ("ritz", "chain")
_RUBBERS = ("neo-hookean", "gent", "mooney-rivlin", "ogden")
_STRAINS = ("thickness", "hencky")
_FRICTIONS = ("maxwell-slip", "lugre", "bouc-wen", "dahl")
_LAWS = {"beam": _BEAMS, "rubber": _RUBBERS, "strain": _STRAINS, "friction": _FRICTIONS}


def as_json(p: RigParameters) -> dict[str, object]:
    """`p` as plain numbers and lists, laws by name."""
    values: dict[str, object] = {
        key: value.tolist() if isinstance(value, np.ndarray) else value for key, value in p._asdict().items()
    }
    return values | {key: names[getattr(p, key)] for key, names in _LAWS.items()}


_SINCE_WORN = ("plastic_share", "plastic_yield", "softening", "softening_time")
"""Entries that files of earlier versions lack: no layer yields there, and no rubber softens."""


def from_json(values: Mapping[str, Any]) -> RigParameters:
    """The joint back from `as_json`, of this or an earlier version.

    Raises
    ------
    KeyError, ValueError, TypeError
        An entry is missing, or no number or law.
    """
    drawing = nominal()
    entries = {key: values[key] for key in drawing._fields if key in values or key not in _SINCE_WORN}
    arrays: dict[str, Any] = {key: np.array(x) if isinstance(x, list) else x for key, x in entries.items()}
    return drawing._replace(**arrays | {key: names.index(values[key]) for key, names in _LAWS.items()})
