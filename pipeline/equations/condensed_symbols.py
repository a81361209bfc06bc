"""What the condensed joint is written in: its states, constants and corrections.

State x: q [m], q̇ [m/s], τ [1], τ̇ [1/s], β [1], β̇ [1/s]; e1, e2 [1] of each Maxwell branch; `ELEMENT_STATES`: one creep
displacement [m] per creep element, and the states of further elements on q (`pipeline.equations.tip_elements`).
"""

from dataclasses import dataclass
from itertools import combinations_with_replacement

import casadi as ca

from pipeline.equations.beam import Expression
from pipeline.equations.tip_elements import tip_elements

STOPS, CREEPS, BRANCHES = 4, 2, 3
"""Stop operators; creep elements on q; Maxwell elements of each membrane: the paper's, a slow one and a fast one."""
ELEMENT_STATES = (
    *((f"creep_{i}", "m") for i in range(CREEPS)),
    *((state.name, state.unit) for element in tip_elements() for state in element.states),
)
"""Name and unit of the states from `FIRST_ELEMENT` on."""
AT_REST = (
    *(1.0 for _ in range(CREEPS)),
    *(state.at_rest for element in tip_elements() for state in element.states),
)
"""Their values over q at rest."""
FIRST_STRAIN = 6
FIRST_ELEMENT = FIRST_STRAIN + 2 * BRANCHES
STATES = FIRST_ELEMENT + len(ELEMENT_STATES)

TIP_CONSTANTS = tuple((c.name, c.typical, c.prior_std, c.unit) for element in tip_elements() for c in element.constants)
"""Name, typical value [SI], prior width of the logarithm and unit of the constants of elements on q."""
DRY_LEVELS = tuple(element.level for element in tip_elements() if element.level)
"""Those which are levels of dry friction."""
_SIDE = ("a", "c", "e_z", "e_x", "l0", "elastic", "hardening", "hardening_slope", "electric", "electric_slope",
         "maxwell_0", "maxwell_1", "maxwell_2", "viscous")  # fmt: skip
QUARTICS = tuple("".join(powers) for powers in combinations_with_replacement("qtb", 4))
"""Quartic terms of the beam's energy in Q, τ and β, beside those of eq. 9."""
SEXTICS = tuple("".join(powers) + "bbb" for powers in combinations_with_replacement("qtb", 3))
"""Sextic terms: those with β³, as β carries most of the bending. They predict as well as all 28 do."""
SHORTENINGS = tuple(powers for powers in QUARTICS if powers.count("b") < 2)
"""Quartic terms of the shortening. With the other six joints are predicted no better."""
CONSTANTS = (
    "l", "bending", "bending_loss", "steepening", "stiffening", "curvature",
    "slope_by_q", "slope_by_tau", "slope_by_beta", "rotation",
    *(f"quartic_{powers}" for powers in QUARTICS),
    *(f"sextic_{powers}" for powers in SEXTICS),
    *(f"shortening_{powers}" for powers in SHORTENINGS),
    "mass", "cross", "inertia", "gyration", "interior_inertia",
    "rise_qq", "rise_qt", "rise_tt", "rise_qb", "rise_tb", "rise_bb", "weight", "offset", "side_force",
    "relaxation_0", "relaxation_1", "relaxation_2", "strain_slope",
    "viscosity", *(name for name, *_ in TIP_CONSTANTS), "friction_arm",
    *(f"left_{name}" for name in _SIDE),
    *(f"right_{name}" for name in _SIDE),
    *(f"stop_force_{i}" for i in range(STOPS)),
    *(f"stop_travel_{i}" for i in range(STOPS)),
    *(f"creep_stiffness_{i}" for i in range(CREEPS)),
    *(f"creep_rate_{i}" for i in range(CREEPS)),
    "slope_ratio",
)  # fmt: skip
"""Constants, all SI; `pipeline.joint.condensed_parameters` says how each is made."""

CORRECTIONS = (
    "force", "damping", "left", "right", "moment", "stiffness", "left_moment", "right_moment", "loss",
    "moment_q", "stiffness_q", "left_moment_q", "right_moment_q",
)  # fmt: skip
"""Values of the correction curves at q [N, N·s/m, N/V², N/V², N·m, N·m, N·m/V², N·m/V², N·m·s], then the slopes along q
of four of them [per m]."""


@dataclass(frozen=True)
class Symbols:
    """Independent variables: state, stop operators at the start of a step, (q, τ) there, squared voltages [V²],
    constants, corrections.
    """

    x: Expression
    z: Expression
    start: Expression
    u: Expression
    k: Expression
    c: Expression

    def constant(self, name: str) -> Expression:
        """The symbol of one constant."""
        return self.k[CONSTANTS.index(name)]

    def correction(self, name: str) -> Expression:
        """The symbol of one correction."""
        return self.c[CORRECTIONS.index(name)]

    @property
    def shape(self) -> Expression:
        """The coordinates (q, τ, β) of the beam's shape, (3,)."""
        return ca.vertcat(self.x[0], self.x[2], self.x[4])

    @property
    def speeds(self) -> Expression:
        """Their rates, (3,)."""
        return ca.vertcat(self.x[1], self.x[3], self.x[5])


def symbols() -> Symbols:
    """Fresh symbols."""
    sizes = {"x": STATES, "z": STOPS, "start": 2, "u": 2, "k": len(CONSTANTS), "c": len(CORRECTIONS)}
    return Symbols(**{name: ca.SX.sym(name, size) for name, size in sizes.items()})
