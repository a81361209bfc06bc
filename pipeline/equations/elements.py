"""Laws of the elements that joints are built of: Maxwell branch, stop operator, Dahl friction, creep, lag.

A new element is one function here and one line where a joint lists its elements.
"""

from typing import Any

import casadi as ca

Expression = Any


def maxwell_rate(strain_rate: Any, relaxation: Any, strain: Any) -> Expression:
    """ė of the spring of a Maxwell branch (eq. 19): what is applied less what the damper takes, r = Y/η [1/s]."""
    return strain_rate - relaxation * strain


def stop_operator(z: Any, play: Any, travel: Any) -> Expression:
    """Share of its capacity in [−1, 1] after a move `play` [m].

    Generalised Maxwell slip: F. Al-Bender, V. Lampaert and J. Swevers, IEEE Trans. Autom. Control 50 (2005) 1883,
    doi:10.1109/TAC.2005.858676.
    """
    return ca.fmin(1.0, ca.fmax(-1.0, _unbounded(z, play, travel)))


def _unbounded(z: Any, play: Any, travel: Any) -> Expression:
    return z + play / travel


def stop_rate(z: Any, speed: Any, travel: Any) -> Expression:
    """ż [1/s] of the stop operator: it follows the speed [m/s] but does not leave [−1, 1]."""
    held = ca.logic_or(ca.logic_and(z >= 1.0, speed > 0.0), ca.logic_and(z <= -1.0, speed < 0.0))
    return ca.if_else(held, 0.0, speed / travel)


def dahl_rate(speed: Any, state: Any, travel: Any) -> Expression:
    """ζ̇ = (q̇ − |q̇| ζ)/s_c: P. R. Dahl, "A solid friction model", 1968 (doi:10.21236/ada041920)."""
    return (speed - ca.fabs(speed) * state) / travel


def dahl_move(state: Any, travel: Any, length: Any) -> Expression:
    """State of Dahl's friction after a monotonous `travel`, exactly: it goes to ±1 exponentially in the distance."""
    side = ca.if_else(travel >= 0.0, 1.0, -1.0)
    return side + (state - side) * ca.exp(-side * travel / length)


def creep_rate(rate: Any, displacement: Any, crept: Any) -> Expression:
    """Rate [m/s] of a creep element that follows the displacement with its `rate` [1/s]."""
    return rate * (displacement - crept)


def lag_rate(value: Any, lagged: Any, time: Any) -> Expression:
    """ż = (q̇ − z)/T (eq. 37)."""
    return (value - lagged) / time


def kernels() -> dict[str, tuple[dict[str, Expression], dict[str, Expression]]]:
    """Laws that runs call by themselves, with their slopes along the inputs; an element at its stop counts as held."""
    z, play, travel = (ca.SX.sym(name) for name in ("z", "play", "travel"))
    free = _unbounded(z, play, travel)
    slopes = ca.if_else(ca.fabs(free) < 1.0, ca.jacobian(free, ca.vertcat(z, play, travel)), 0.0)
    found = {"value": stop_operator(z, play, travel), "slopes": slopes}
    return {"STOP_OPERATOR": ({"z": z, "play": play, "travel": travel}, found)}
