"""Parameters of a full-order virtual joint, one flat tuple that the compiled kernels read."""

from collections.abc import Mapping
from typing import Any, NamedTuple

import numpy as np

from ..device.parameters import BEAM_DAMPING_FACTOR, NOMINAL, TABLE1, JointParameters
from ..numerics.arrays import FloatArray

BEAMS = ("ritz", "chain")
RITZ, CHAIN = range(len(BEAMS))
RUBBERS = ("neo-hookean", "gent", "mooney-rivlin", "ogden")
NEO_HOOKEAN, GENT, MOONEY_RIVLIN, OGDEN = range(len(RUBBERS))
STRAINS = ("thickness", "hencky")
"""Strain that the viscous branches see: thickness stretch λ3 (§3.2.4), or Hencky strain ln λ1."""
THICKNESS, HENCKY = range(len(STRAINS))
FRICTIONS = ("maxwell-slip", "lugre", "bouc-wen", "dahl")
MAXWELL_SLIP, LUGRE, BOUC_WEN, DAHL = range(len(FRICTIONS))
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
_LAWS = {"beam": BEAMS, "rubber": RUBBERS, "strain": STRAINS, "friction": FRICTIONS}


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


def drawing(joint: JointParameters, *, links: int = 5) -> RigParameters:
    """The joint of a drawing: symmetric, without friction and creep."""
    pair = np.ones(2)
    side = joint.left
    bending = joint.E * joint.I
    hinge = np.full(links, bending * links / joint.l)
    hinge[0] *= 2.0  # the clamp's half cell
    loss = BEAM_DAMPING_FACTOR * joint.eta * joint.I
    return RigParameters(
        beam=RITZ,
        length=joint.l,
        mass=joint.m,
        frame_inertia=0.0,
        frame_offset=0.0,
        gravity=joint.g,
        line_density=joint.rho * joint.A,
        line_inertia=joint.rho * joint.I,
        bending=bending,
        axial=joint.E * joint.A,
        bending_loss=loss,
        curvature=joint.kappa0,
        hinge_stiffness=hinge,
        hinge_loss=hinge * loss / bending,
        hinge_cubic=0.0,
        arm=side.a * pair,
        drop=(side.b - side.a0) * pair,
        anchor_x=side.e_z * pair,
        anchor_y=side.e_x * pair,
        free_length=side.l0 * pair,
        volume=side.volume * pair,
        modulus=side.Y * pair,
        rubber=NEO_HOOKEAN,
        rubber_shape=np.zeros(2),
        capacitance=side.capacitance * pair,
        capacitance_exponent=1.0,
        kelvin_voigt=side.eta_v,
        strain=THICKNESS,
        branch_modulus=np.full((2, 1), side.Y_MW),
        branch_time=np.array([side.eta_MW / side.Y_MW]),
        friction=MAXWELL_SLIP,
        friction_arm=0.0,
        slip_stiffness=np.zeros(1),
        slip_force=np.ones(1),
        friction_shape=np.zeros(4),
        plastic_share=np.zeros(1),
        plastic_yield=np.ones(1),
        softening=0.0,
        softening_time=1.0,
    )


def nominal(*, links: int = 5) -> RigParameters:
    """The designer's drawing: Table 1 as corrected with E = 1.76 GPa."""
    return drawing(NOMINAL, links=links)


def table1() -> RigParameters:
    """Table 1 as printed, corrected: E = 1.62 GPa; it needs at least 2.4 kV to switch."""
    return drawing(TABLE1)


def sized(p: RigParameters, size: float) -> RigParameters:
    """A joint `size` times as long that moves alike, slower by the root of it, under the same voltages.

    The constants of friction beyond its force stay.
    """
    return p._replace(**{name: getattr(p, name) * size**power for name, power in _POWERS.items()})


def coordinates(p: RigParameters) -> int:
    """Number of the beam's generalised coordinates."""
    return 4 if p.beam == RITZ else p.hinge_stiffness.size


def as_json(p: RigParameters) -> dict[str, object]:
    """`p` as plain numbers and lists, laws by name."""
    laws = {key: names[getattr(p, key)] for key, names in _LAWS.items()}
    return {key: x.tolist() if isinstance(x, np.ndarray) else x for key, x in p._asdict().items()} | laws


def from_json(values: Mapping[str, Any]) -> RigParameters:
    """The joint back from `as_json`.

    Raises
    ------
    KeyError, ValueError, TypeError
        An entry is missing, or no number or law.
    """
    arrays: dict[str, Any] = {key: np.array(x) if isinstance(x, list) else x for key, x in values.items()}
    return RigParameters(**arrays | {key: names.index(values[key]) for key, names in _LAWS.items()})
