"""Equations of the elements of joints, and the terms of the models that data alone give.

Maxwell branch, stop operator, Dahl friction, creep, lag, membrane, bell: a new element is one function here and one
line where a joint lists its elements. The membrane's equations are those of one dielectric elastomer and of the frame
that stretches it.

The data-driven joint, in the dimensionless displacement x (±1 spans the training data) and its velocity p, with inputs
u:

    ẋ = p,
    μ(x) ṗ = F(x) − (d(x) + κ |p|) p − ½ μ'(x) p²
             + Σ_k g_k(x) u_k − Σ_l h_l(x) e_l + Σ_lk β_lk'(x) u_k w_l − Σ_j f_j s_j + stops
    ẇ_l = h_l(x) p − r_l(x) e_l,   e_l = w_l − Σ_k β_lk(x) u_k
    ds_j = (dx − |dx| s_j)/δ_j

Each of its terms here is of one curve, element or friction state, whose numbers are inputs. Sums over as many as a
joint has are taken by `pipeline.models.rbf.dynamics` in runs and by `pipeline.export.data_driven` in C and MATLAB.

The lagged models have q, q̇ and one lagged velocity: the paper's (eqs. 37 to 40), and polynomial ones. Curves of the
paper's model are sums over basis functions at q, the right side of a polynomial model is one of monomials. The sums are
taken where the model runs, so their number enters nothing here.
"""

from collections.abc import Callable
from inspect import signature
from typing import Any

import casadi as ca

Expression = Any
Term = tuple[dict[str, Expression], dict[str, Expression]]
"""Inputs and outputs by name."""


def term(function: Callable[..., Expression], output: str = "value", *along: str, **sizes: int) -> Term:
    """A function as a term: its parameters as inputs, its value, and the exact slopes along some of them.

    Parameters
    ----------
    function : callable
        Of expressions.
    output : str
        Name of its value.
    along : str
        Parameters of the slopes; without any there are none.
    sizes : int
        Lengths of parameters that are no numbers.
    """
    inputs = {name: ca.SX.sym(name, sizes.get(name, 1)) for name in signature(function).parameters}
    outputs = {output: function(**inputs)}
    if along:
        outputs["slopes"] = ca.jacobian(outputs[output], ca.vertcat(*(inputs[name] for name in along)))
    return inputs, outputs


def maxwell_rate(strain_rate: Any, relaxation: Any, strain: Any) -> Expression:
    """ė of the spring of a Maxwell branch (eq. 19): the applied rate less the damper's, r = Y/η [1/s]."""
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


def dahl_rate(p: Any, state: Any, length: Any) -> Expression:
    """ζ̇ = (q̇ − |q̇| ζ)/s_c: P. R. Dahl, "A solid friction model", 1968 (doi:10.21236/ada041920)."""
    return (p - ca.fabs(p) * state) / length


def dahl_move(state: Any, travel: Any, length: Any) -> Expression:
    """State of Dahl's friction after a monotonous `travel`, exactly: it goes to ±1 exponentially in the distance."""
    side = ca.if_else(travel >= 0.0, 1.0, -1.0)
    return side + (state - side) * ca.exp(-side * travel / length)


def creep_rate(rate: Any, displacement: Any, crept: Any) -> Expression:
    """Rate [m/s] of a creep element that follows the displacement with its `rate` [1/s]."""
    return rate * (displacement - crept)


def softening_rate(rate: Any, softened: Any) -> Expression:
    """Rate [1/s] of the share D of a rubber's softening that has come: Ḋ = rate (1 − D).

    Rubber softens in its first cycles: L. Mullins, Rubber Chem. Technol. 42 (1969) 339, doi:10.5254/1.3539210. Under
    steady excitation that is a matter of time, as is its warming.
    """
    return rate * (1.0 - softened)


def lag_rate(value: Any, lagged: Any, lag: Any) -> Expression:
    """ż = (q̇ − z)/T (eq. 37)."""
    return (value - lagged) / lag


Four = tuple[Expression, Expression, Expression, Expression]


def length(sign: float, mounts: Four, l: Any, tip: Four) -> tuple[Expression, Expression, Expression]:
    """Length [m] between the two mounts (eqs. 4, 5) and its components x, y.

    Parameters
    ----------
    sign : float
        −1 for the left membrane, +1 for the right one.
    mounts : (a, c, e_z, e_x)
        Places of the membrane's mounts [m] (figure 2); c = b − a0.
    l : expression
        Length of the beam [m].
    tip : (q, sin φ, cos φ, u_y)
        Displacement [m] of the beam's tip, its rotation, and its axial displacement [m].

    Notes
    -----
    The signs of x_i, y_i and a0 cos φ as printed in eq. 5 are no rigid frame with eq. 4. With the signs
    used here λ = 1.43 at b = 23 mm (the text: strains below 50 %) and the pre-strain grows as b shrinks (§3.3.3);
    as printed λ = 2.09 and it shrinks.
    """
    a, c, e_z, e_x = mounts
    q, sin, cos, u_y = tip
    x = -sign * (a * cos - e_z) + c * sin - q
    y = e_x - l - u_y + c * cos + sign * a * sin
    return ca.sqrt(x * x + y * y), x, y


def thickness_stretch(stretch: Any) -> Expression:
    """λ3 = λ^(−1/2): uniaxial and incompressible (eq. 6)."""
    return 1.0 / ca.sqrt(stretch)


def thickness_slope(thickness: Any) -> Expression:
    """∂λ3/∂λ = −½ λ3³."""
    return -0.5 * thickness * thickness * thickness


def neo_hooke(stretch: Any) -> Expression:
    """λ² + 2/λ − 3; times V Y / 6 it is the energy (eq. 11).

    Eq. 11 prints λ² + 1/λ² − 2, the pure-shear state; the uniaxial state of eq. 6 gives this. As printed there is no
    z_b,min inside 0 to 10 mm.
    """
    return stretch * stretch + 2.0 / stretch - 3.0


def neo_hooke_slope(stretch: Any, inverse: Any) -> Expression:
    """Derivative 2λ − 2/λ², with `inverse` = 1/λ."""
    return 2.0 * stretch - 2.0 * inverse * inverse


def power(slope: Any, excess: Any, reference: float) -> Expression:
    """(λ/reference)^n to second order in the `excess` λ − reference, by its `slope` n/reference there.

    Capacitances go as λ in the paper and as λ² if the film's sides are clamped; strains as λ3 or as Hencky's ln λ.
    """
    return 1.0 + (slope + 0.5 * slope * (slope - 1.0 / reference) * excess) * excess


def gaussian(square: Any) -> Any:
    """φ of ((q − ξ)/σ)², a bell about the centre ξ (eq. 38); eq. 35 prints it without the minus sign that it needs.

    It is the exponential of a multiple of the square, so bells of equidistant centres follow from each other. With
    r = (q − ξ)/σ and s = Δξ/σ, the next one is φ((r − s)²) = φ(r²) φ(s² − 2 r s), and that ratio shrinks by φ(2 s²)
    from one centre to the next.
    """
    return ca.exp(-0.5 * square)


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
    """A Gaussian at x `clipped` to its range, so constant outside; bend = 1/(2σ²)."""
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
    force = curves[0] - (curves[1] + drag * ca.fabs(p)) * p - arc * arm * p * p + push
    return force / (1.0 + arc * arm * arm)


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
    displacement. It relaxes at a rate r(x), and the inputs pull at it as the capacitances change with it, by β_k(x).
    All follow from the energy ½ w² − Σ β_k(x) u_k w: e is its derivative by w, its derivative by x acts on the joint,
    and the same coupling stands in both equations. So no element can create energy.

    Parameters
    ----------
    coupling, p, rate, load : expression
        h, velocity ẋ, relaxation, and load e.
    """
    return maxwell_rate(coupling * p, rate, load)


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


def kernels() -> dict[str, Term]:
    """The terms that runs call, with the exact slopes that their sensitivities need.

    A stop operator at its stop counts as held.
    """
    of_stop, stops = term(stop_operator)
    free = _unbounded(**of_stop)
    slopes = ca.if_else(ca.fabs(free) < 1.0, ca.jacobian(free, ca.vertcat(*of_stop.values())), 0.0)
    of_bell, bells = term(bell, "value", "inside")
    return {
        "STOP_OPERATOR": (of_stop, stops | {"slopes": slopes}),
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
        **_bells(),
        "LAGGED_RATES": term(lagged_rates, "rates", curves=2),
        "POLYNOMIAL_VARIABLES": term(polynomial_variables, "variables", scales=3),
        "LAG": term(lag_rate, "rate"),
    }


def _bells() -> dict[str, Term]:
    """The Gaussian, and bells of a basis (first centre, distance Δξ, width σ): the first at q, and from one the next.

    A bell is r, φ, the ratio of the next one to it, and by what that ratio shrinks. `slope` is φ' along q, and
    `shape` φ, φ' and φ'' of the first bell.
    """
    q = ca.SX.sym("q")
    basis = ca.SX.sym("basis", 3)
    bell = ca.SX.sym("bell", 4)
    square = ca.SX.sym("square")
    r, value, ratio, shrink = ca.vertsplit(bell)
    first = (q - basis[0]) / basis[2]
    step = basis[1] / basis[2]
    at_first = gaussian(first * first)
    ratios = (gaussian(step * (step - 2.0 * first)), gaussian(2.0 * step * step))
    exponent = ca.substitute(ca.gradient(gaussian(square), square), square, 0.0)
    by_q = ca.gradient(at_first, q)
    return {
        "GAUSSIAN": term(gaussian, "found"),
        "BELL_SHAPE": ({"q": q, "basis": basis}, {"shape": ca.vertcat(at_first, by_q, ca.gradient(by_q, q))}),
        "FIRST_BELL": ({"q": q, "basis": basis}, {"bell": ca.vertcat(first, at_first, *ratios)}),
        "NEXT_BELL": (
            {"bell": bell, "basis": basis},
            {
                "slope": 2.0 * exponent * r / basis[2] * value,
                "next": ca.vertcat(r - step, value * ratio, ratio * shrink, shrink),
            },
        ),
    }
