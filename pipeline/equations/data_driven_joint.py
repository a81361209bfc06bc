"""Terms of the models that data alone give: the data-driven joint, the paper's lagged model, polynomial models.

The data-driven joint, in the dimensionless displacement x (±1 spans the training data) and its velocity p, with inputs
u:

    ẋ = p,
    μ(x) ṗ = F(x) − (d(x) + κ |p|) p − ½ μ'(x) p²
             + Σ_k g_k(x) u_k − Σ_l h_l(x) e_l + Σ_lk β_lk'(x) u_k w_l − Σ_j f_j s_j + stops
    ẇ_l = h_l(x) p − r_l(x) e_l,   e_l = w_l − Σ_k β_lk(x) u_k
    ds_j = (dx − |dx| s_j)/δ_j

Each term here is of one curve, element or friction state, whose numbers are inputs. Sums over as many as a joint has
are taken by `pipeline.models.rbf.dynamics` in runs and by `pipeline.export.data_driven` in C and MATLAB.

The lagged models have q, q̇ and one lagged velocity: the paper's (eqs. 37 to 40), and polynomial ones. Curves of the
paper's model are sums over basis functions at q, the right side of a polynomial model is one of monomials. The sums are
taken where the model runs, so their number enters nothing here.
"""

from typing import Any

import casadi as ca

from .elements import Expression, dahl_move, dahl_rate, gaussian, lag_rate, maxwell_rate

WALL = 0.1
"""Half ranges past the data at which the wall of a turning arm is as strong as the cubic at their ends."""

FADE = 0.15
"""Half ranges past the reach of the curves within which a restoring force that leads away has turned back."""

TOUCH = 0.01
"""Half ranges within which an end stop sets in, and share of the largest drive within which a dead zone ends."""


def powers(x: Any) -> Expression:
    """1, x, x², x³: the basis functions before the Gaussians. The cubic keeps the joint confined."""
    return ca.vertcat(1.0, x, x * x, x * x * x)


def turning_arm(x: Any, arm: Any) -> Expression:
    """1, sin q, cos q and x³ with a wall past the data, for an arm at the angle q = arm[0] + arm[1] x [rad].

    They hold the torque of any weight on it. Such a torque falls beyond 90°, where a run that has left the data would
    not come back but for the wall.
    """
    q = arm[0] + arm[1] * x
    past = (x - clipped(x, -1.0, 1.0)) / WALL
    return ca.vertcat(1.0, ca.sin(q), ca.cos(q), x * x * x + past * past * past)


def confined_force(x: Any, force: Any, at_ends: Any, low: Any, high: Any) -> Expression:
    """Restoring force, outside [low, high] never less restoring than at that end.

    A force that leads away at an end falls from there and has turned back after `FADE`. So no extrapolation has a place
    of rest farther out; one that restores more than this is left as it is.

    Parameters
    ----------
    x : expression
        Displacement, dimensionless.
    force : expression
        Restoring force at x by the curve.
    at_ends : expression, shape (2,)
        The curve's values at `low` and `high`.
    low, high : expression
        Reach of the curve.
    """
    left = at_ends[0] + ca.fmax(0.0, -at_ends[0]) / FADE * (low - x)
    right = at_ends[1] - ca.fmax(0.0, at_ends[1]) / FADE * (x - high)
    return ca.if_else(x < low, ca.fmax(force, left), ca.if_else(x > high, ca.fmin(force, right), force))


def stop_force(x: Any, p: Any, stops: Any) -> Expression:
    """Force of two end stops at the displacements stops[0] < stops[1], springs of the stiffness stops[2] that resist
    motion by stops[3] while they are touched. They set in within `TOUCH`, so that the force has a derivative.
    """
    left = stops[0] - x
    right = x - stops[1]
    push = stops[2] * (_beyond(left) - _beyond(right))
    return push - stops[3] * (_touched(left) + _touched(right)) * p


def _beyond(way: Any) -> Expression:
    """`way` where it is positive and 0 elsewhere, smoothly."""
    return 0.5 * (way + ca.sqrt(way * way + TOUCH * TOUCH))


def _touched(way: Any) -> Expression:
    """1 where `way` is positive and 0 elsewhere: the slope of `_beyond`."""
    return 0.5 * (1.0 + way / ca.sqrt(way * way + TOUCH * TOUCH))


def bell(inside: Any, centre: Any, bend: Any) -> Expression:
    """A Gaussian at x `clipped` to its range, outside of which it goes on as a constant; bend = 1/(2σ²)."""
    distance = inside - centre
    return gaussian(2.0 * bend * distance * distance)


def acceleration(p: Any, curves: Any, push: Any, arm: Any, arc: Any, drag: Any) -> Expression:
    """Acceleration ṗ for F, d in `curves`, the sum of all other forces, and the drag κ of a fluid.

    The inertia is μ = 1 + arc·arm² of a tip on an arc, with arm = x − x₀.

    Parameters
    ----------
    p : expression
        Velocity ẋ.
    curves : expression, shape (2,)
        Restoring force F and damping d at x.
    push : expression
        Sum of the forces of inputs, elements, friction and stops.
    arm, arc : expression
        x − x₀ and the curvature of the arc.
    drag : expression
        κ.
    """
    inertia = 1.0 + arc * arm * arm
    return (curves[0] - (curves[1] + drag * ca.fabs(p)) * p - arc * arm * p * p + push) / inertia


def bent(drive: Any, bend: Any) -> Expression:
    """Effect of a drive (1 where it is largest) that is not proportional to it: monotonous through 0 and ±1.

    It rises e^bend times as steeply at zero as a line: an amplifier, valve or motor that saturates, or for bend < 0 one
    that answers late. Beyond the largest drive it goes on as the line through it, so that it has no pole.
    """
    steeper = ca.exp(bend)
    return drive * steeper / (1.0 + (steeper - 1.0) * ca.fmin(ca.fabs(drive), 1.0))


def past_zone(drive: Any, zone: Any) -> Expression:
    """Drive past a dead zone of ± `zone`, in which an amplifier or a valve does nothing; smooth."""
    return _beyond(drive - zone) - _beyond(-drive - zone)


def clipped(x: Any, low: Any, high: Any) -> Expression:
    """The value x within [low, high]."""
    return ca.fmin(high, ca.fmax(low, x))


def kernels() -> dict[str, tuple[dict[str, Expression], dict[str, Expression]]]:
    """Inputs and outputs of each term, with exact derivatives along what the sensitivities of a run need."""
    x, arm, centre, bend, low, high = (ca.SX.sym(name) for name in ("x", "arm", "centre", "bend", "low", "high"))
    angle = ca.SX.sym("angle", 2)
    curves = ca.SX.sym("curves", 2)
    p, push, arc, coupling, rate, load = map(ca.SX.sym, ("p", "push", "arc", "coupling", "rate", "load"))
    state, travel, length, drive = (ca.SX.sym(name) for name in ("state", "travel", "length", "drive"))
    drag, stops, force, at_ends = (ca.SX.sym(*of) for of in (("drag",), ("stops", 4), ("force",), ("at_ends", 2)))
    slope = ca.jacobian(bell(x, centre, bend), x)
    moved = acceleration(p, curves, push, arm, arc, drag)
    # A Maxwell branch whose strain is a function S(x), with the coupling h = S', relaxes at one rate, and its load e is
    # its state w. A shape element is an overdamped second coordinate, the slope that the beam's tip has beside its
    # displacement: it relaxes at a rate r(x), and the inputs pull at it as the capacitances change with it, by β_k(x).
    # All follow from the energy ½ w² − Σ β_k(x) u_k w: e is its derivative by w, its derivative by x acts on the joint,
    # and the same coupling stands in both equations. So no element can create energy.
    relaxing = maxwell_rate(coupling * p, rate, load)
    return {
        "POWERS": ({"x": x}, _with_slopes(powers(x), x)),
        "TURNING_ARM": ({"x": x, "arm": angle}, _with_slopes(turning_arm(x, angle), x)),
        "CLIPPED": ({"x": x, "low": low, "high": high}, _with_slopes(clipped(x, low, high), x)),
        "CONFINED_FORCE": (
            {"x": x, "force": force, "at_ends": at_ends, "low": low, "high": high},
            _with_slopes(confined_force(x, force, at_ends, low, high), ca.vertcat(x, force, at_ends)),
        ),
        "BENT": ({"drive": drive, "bend": bend}, _with_slopes(bent(drive, bend), ca.vertcat(drive, bend))),
        "PAST_ZONE": ({"drive": drive, "zone": bend}, _with_slopes(past_zone(drive, bend), ca.vertcat(drive, bend))),
        "BELL": (
            {"inside": x, "centre": centre, "bend": bend},
            _with_slopes(bell(x, centre, bend), x) | {"curvature": ca.jacobian(slope, x)},
        ),
        "ACCELERATION": (
            {"p": p, "curves": curves, "push": push, "arm": arm, "arc": arc, "drag": drag},
            _with_slopes(moved, ca.vertcat(p, curves, push, arm, arc, drag)),
        ),
        "ELEMENT": (
            {"coupling": coupling, "p": p, "rate": rate, "load": load},
            _with_slopes(relaxing, ca.vertcat(coupling, p, rate, load)),
        ),
        "DAHL_MOVE": (
            {"state": state, "travel": travel, "length": length},
            _with_slopes(dahl_move(state, travel, length), ca.vertcat(state, travel, length)),
        ),
        "STOP_FORCE": (
            {"x": x, "p": p, "stops": stops},
            _with_slopes(stop_force(x, p, stops), ca.vertcat(x, p, stops)),
        ),
        "DAHL_RATE": ({"p": p, "state": state, "length": length}, {"rate": dahl_rate(p, state, length)}),
    }


def _with_slopes(value: Expression, along: Expression) -> dict[str, Expression]:
    return {"value": value, "slopes": ca.jacobian(value, along)}


def lagged_rates(q: Any, q_dot: Any, z: Any, curves: Any, push: Any, lag: Any) -> Expression:
    """q̈ = −c q − d z + push and ż = (q̇ − z)/T, with c, d in `curves` and Σ g_k u_k in `push`, all over the mass.

    Parameters
    ----------
    q, q_dot : expression
        Displacement [m] and velocity [m/s].
    z : expression
        Lagged velocity [m/s].
    curves : expression, shape (2,)
        c [1/s²] and d [1/s] at q.
    push : expression
        Acceleration by the inputs [m/s²].
    lag : expression
        T [s].
    """
    return ca.vertcat(push - curves[0] * q - curves[1] * z, lag_rate(q_dot, z, lag))


def polynomial_variables(q: Any, q_dot: Any, scales: Any) -> Expression:
    """Factors of monomials: q and q̇ over their scales, and tanh(q̇/w); w is the last of the scales.

    Models of a turning arm have sin q and cos q beside them.
    """
    return ca.vertcat(q / scales[0], q_dot / scales[1], ca.tanh(q_dot / scales[2]))


def lagged_kernels() -> dict[str, tuple[dict[str, Expression], dict[str, Expression]]]:
    """Inputs and outputs of each term."""
    q, q_dot, z, push, lag = (ca.SX.sym(name) for name in ("q", "q_dot", "z", "push", "lag"))
    curves = ca.SX.sym("curves", 2)
    scales = ca.SX.sym("scales", 3)
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
