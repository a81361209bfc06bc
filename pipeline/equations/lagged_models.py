"""Models of q, q̇ and one lagged velocity: the paper's (eqs. 37 to 40), and polynomial ones.

Curves of the paper's model are sums over basis functions at q, the right side of a polynomial model one of monomials.
The sums are taken where the model runs, so their number enters nothing here.
"""

from typing import Any

import casadi as ca

from pipeline.equations.elements import lag_rate

Expression = Any


def lagged_rates(q: Any, q_dot: Any, z: Any, curves: Any, push: Any, lag: Any) -> Expression:
    """q̈ = −c q − d z + push and ż = (q̇ − z)/T, with c, d in `curves` and Σ g_k u_k in `push`, all over the mass."""
    return ca.vertcat(push - curves[0] * q - curves[1] * z, lag_rate(q_dot, z, lag))


def polynomial_variables(q: Any, q_dot: Any, scales: Any) -> Expression:
    """Q and q̇ over their scales, and tanh(q̇/w): factors of monomials; w is the last of the scales.

    Models of a turning arm have sin q and cos q beside them.
    """
    return ca.vertcat(q / scales[0], q_dot / scales[1], ca.tanh(q_dot / scales[2]))


def kernels() -> dict[str, tuple[dict[str, Expression], dict[str, Expression]]]:
    """Inputs and outputs of each law."""
    q, q_dot, z, push, lag = (ca.SX.sym(name) for name in ("q", "q_dot", "z", "push", "lag"))
    curves, scales = ca.SX.sym("curves", 2), ca.SX.sym("scales", 3)
    rates = lagged_rates(q, q_dot, z, curves, push, lag)
    state = {"q": q, "q_dot": q_dot, "z": z}
    return {
        "LAGGED_RATES": (state | {"curves": curves, "push": push, "lag": lag}, {"rates": rates}),
        "POLYNOMIAL_VARIABLES": (
            {"q": q, "q_dot": q_dot, "scales": scales},
            {"variables": polynomial_variables(q, q_dot, scales)},
        ),
        "LAG": ({"value": q_dot, "lagged": z, "lag": lag}, {"rate": lag_rate(q_dot, z, lag)}),
    }
