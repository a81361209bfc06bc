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

from .elements import Expression, Term, dahl_move, dahl_rate, gaussian, lag_rate, maxwell_rate, term

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


def element(coupling: Any, p: Any, rate: Any, load: Any) -> Expression:
    """Rate of an element that relaxes.

    A Maxwell branch whose strain is a function S(x), with the coupling h = S', relaxes at one rate, and its load e is
    its state w. A shape element is an overdamped second coordinate, the slope that the beam's tip has beside its
    displacement: it relaxes at a rate r(x), and the inputs pull at it as the capacitances change with it, by β_k(x).
    All follow from the energy ½ w² − Σ β_k(x) u_k w: e is its derivative by w, its derivative by x acts on the joint,
    and the same coupling stands in both equations. So no element can create energy.

    Parameters
    ----------
    coupling, p, rate, load : expression
        h, velocity ẋ, relaxation, and load e.
    """
    return maxwell_rate(coupling * p, rate, load)


def kernels() -> dict[str, Term]:
    """The terms, with exact derivatives along what the sensitivities of a run need."""
    of_bell, bells = term(bell, "value", "inside")
    return {
        "POWERS": term(powers, "value", "x"),
        "TURNING_ARM": term(turning_arm, "value", "x", arm=2),
        "CLIPPED": term(clipped, "value", "x"),
        "CONFINED_FORCE": term(confined_force, "value", "x", "force", "at_ends", at_ends=2),
        "BENT": term(bent, "value", "drive", "bend"),
        "PAST_ZONE": term(past_zone, "value", "drive", "zone"),
        "BELL": (of_bell, bells | {"curvature": ca.jacobian(bells["slopes"], of_bell["inside"])}),
        "ACCELERATION": term(acceleration, "value", "p", "curves", "push", "arm", "arc", "drag", curves=2),
        "ELEMENT": term(element, "value", "coupling", "p", "rate", "load"),
        "DAHL_MOVE": term(dahl_move, "value", "state", "travel", "length"),
        "STOP_FORCE": term(stop_force, "value", "x", "p", "stops", stops=4),
        "DAHL_RATE": term(dahl_rate, "rate"),
    }


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


def lagged_kernels() -> dict[str, Term]:
    """The terms of the lagged models."""
    return {
        "LAGGED_RATES": term(lagged_rates, "rates", curves=2),
        "POLYNOMIAL_VARIABLES": term(polynomial_variables, "variables", scales=3),
        "LAG": term(lag_rate, "rate"),
    }
