"""The joint reduced to one coordinate (eq. 26): its curves over q are inputs."""

from dataclasses import dataclass, replace
from typing import Any

import casadi as ca

from pipeline.equations.elements import maxwell_rate

Expression = Any


@dataclass(frozen=True)
class Symbols:
    """q̇ [m/s]; Maxwell strains e (2,); values and slopes along q of the curves m_q, d, f, λ_{3,1}, λ_{3,2}, C_1, C_2;
    v² (2,) [V²]; other forces [N]; V_DE Y_MW (2,) [J] and Y_MW/η_MW (2,) [1/s].
    """

    q_dot: Expression
    e: Expression
    curves: Expression
    slopes: Expression
    v_squared: Expression
    load: Expression
    gain: Expression
    rate: Expression


def symbols() -> Symbols:
    """Fresh symbols."""
    sizes = {"q_dot": 1, "e": 2, "curves": 7, "slopes": 7, "v_squared": 2, "load": 1, "gain": 2, "rate": 2}
    return Symbols(**{name: ca.SX.sym(name, size) for name, size in sizes.items()})


def rates(s: Symbols) -> Expression:
    """q̈ [m/s²] and ė (2,) [1/s] of m q̈ + ½ m' q̇² + d q̇ + f + Σ k̄_i e_i = ½ Σ C_i' v_i² + load."""
    creep = s.slopes[3:5]
    force = s.load + 0.5 * ca.dot(s.slopes[5:], s.v_squared) - ca.dot(s.gain * creep, s.e)
    force -= s.curves[1] * s.q_dot + s.curves[2] + 0.5 * s.slopes[0] * s.q_dot**2
    strains = [maxwell_rate(creep[i] * s.q_dot, s.rate[i], s.e[i]) for i in range(2)]
    return ca.vertcat(force / s.curves[0], *strains)


def cubics(pieces: Any, s: Any) -> Expression:
    """Values of seven curves at s [m] past a breakpoint; `pieces` (28,): ascending powers, four rows of seven."""
    rows = [pieces[7 * i : 7 * (i + 1)] for i in range(4)]
    return ((rows[3] * s + rows[2]) * s + rows[1]) * s + rows[0]


def kernels() -> dict[str, tuple[dict[str, Expression], dict[str, Expression]]]:
    """Inputs and outputs of each law."""
    s, pieces, past = symbols(), ca.SX.sym("pieces", 28), ca.SX.sym("s")
    curves = cubics(pieces, past)
    slopes, others = ca.jacobian(curves, past), {k: v for k, v in vars(s).items() if k not in ("curves", "slopes")}
    moved = rates(replace(s, curves=curves, slopes=slopes))
    return {
        "REDUCED_RATES": (dict(vars(s)), {"rates": rates(s)}),
        "CUBICS": ({"pieces": pieces, "s": past}, {"curves": curves, "slopes": slopes}),
        "REDUCED_MOTION": ({"pieces": pieces, "s": past} | others, {"rates": moved}),
    }
