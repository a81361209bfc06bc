"""State estimator: an extended Kalman filter on the identified joint, fed by the laser once in a period.

The estimate holds the joint's state x, its stop operators z (exact in a step), and a moment d on the slope. It also
holds the voltages of both converters, which lag behind their commands. d stands for everything outside the model:
external forces, friction of another kind, a drifting barrier. The voltages act as such a moment, so that they can
balance it. d changes as a random walk, so that the estimate of q has no steady error.

Readings correct displacement, slope, interior shape, their rates and d. Their covariance P moves with the exact
Jacobian at the estimate. About the saddle a beam's slope may be unstable at a given displacement, and then the sign of
the correction changes. Maxwell strains and creep follow from the motion alone: their own dynamics forget every error.

The functions are traced into graphs (`pipeline.codegen.graph`): lists of numbers in, dictionaries of lists out. `now`
is the controller's state by parts (`law.PLACES`), `n` its `NUMBERS` by name: in the graphs the arrays `s` and `e`. A
table is a parameter that makes it an input of the graph; `fetch` reads it by its name.
"""

from collections.abc import Callable
from inspect import signature
from typing import Any

from ..codegen.graph import Graph, Value, apply, choose, clip, fetch, function, inline, trace
from ..generated.condensed_joint import (
    AT_REST,
    FIRST_ELEMENT,
    INERTIA,
    PREPARE,
    RATES,
    SHAPE,
    SHAPE_RATES,
    SLIPS,
    STATES,
    STOP_DIRECTIONS,
    STOP_ELEMENTS,
    STOPS,
)
from ..generated.condensed_joint_jacobian import JACOBIAN, PREPARE as PREPARE_SLOPES
from ..generated.terms import STOP_OPERATOR
from ..models.hybrid.kernels import CURVED, CURVES
from ..numerics.fixed_step import ALL_SHARES, SHARES
from .law import CONTROLLER_STATE, CORRECTED, FILTER, NUMBERS, PLACES, RESTS, SIDES, TARGETS

Values = list[Any]
Outputs = dict[str, Values]
State = dict[str, Values]
Numbers = dict[str, Any]

PERIOD = 1e-3
"""Period of the controller [s]."""
RAMP = 40.0
"""Periods in which the voltages of a controller without readings go to zero."""
MEMORY = 10.0
"""Time constant [s] of the voltages' means."""
PERSISTENT = 15.0
"""Periods of readings outside the settling band about the estimate after which it begins anew. Such a reading corrects
nothing: corrected by a part of so large an innovation, the shape's rates were wrong, and the Maxwell strains for
seconds after them."""
STATUS = ("ok", "recovering", "lost signal", "given up")
"""Meaning of the status: readings lie outside the settling band about the estimate; readings are missing, so
the voltages go to zero; the target was not reached, so the voltages are zero until the next one."""
ESTIMATED = STATES + STOPS + 4
"""Numbers of an estimate."""
SIZES = {
    "s": CONTROLLER_STATE, "signals": 2, "v": 2, "e": len(NUMBERS), "u": 2, "um": 2,
    **dict.fromkeys(("y", "dx", "k1", "k2", "k3", "k4"), STATES),
    "prepared": PREPARE.outputs["p"], "slopes": PREPARE_SLOPES.outputs["p"],
    **dict.fromkeys(("curves", "rests", "targets", "braking"), 0),
}  # fmt: skip
"""Lengths of the arrays that the functions take; 0 of tables, which have any length."""


def graph_of(function: Callable[..., Outputs]) -> Graph:
    """The graph of a function: the state's parts `now` are its input `s`, the numbers `n` by name its input `e`."""

    def traced(**arrays: Any) -> Outputs:
        """The function with state and numbers taken apart."""
        if "s" in arrays:
            state = arrays.pop("s")
            arrays["now"] = {name: state[place] for name, place in PLACES.items()}
        if "e" in arrays:
            arrays["n"] = dict(zip(NUMBERS, arrays.pop("e"), strict=True))
        return function(**arrays)

    names = ({"now": "s", "n": "e"}.get(name, name) for name in signature(function).parameters)
    return trace(traced, **{name: SIZES[name] for name in names})


def joined(state: dict[str, Values]) -> Values:
    """The state from its parts."""
    return [value for name in PLACES for value in state[name]]


def row(place: Any, count: int) -> tuple[Any, Any]:
    """Lower row of the two about `place`, counted in rows, and the share of the upper; held beyond the ends."""
    inside = clip(place, 0.0, count - 1.0)
    lower = function("min", function("floor", inside), count - 2.0)
    return lower, inside - lower


def rest(q: Any, n: dict[str, Any]) -> State:
    """The state after a long rest at q [m] without voltage: friction balances the remaining force."""
    lower, share = row((q + n["farthest"]) * n["rest_per_metre"], RESTS)
    tau, beta, stuck = (
        fetch("rests", i, 3.0 * lower) * (1.0 - share) + fetch("rests", 3 + i, 3.0 * lower) * share for i in range(3)
    )
    state = {name: [0.0] * (place.stop - place.start) for name, place in PLACES.items()} | {
        "x": [q, 0.0, tau, 0.0, beta, *[0.0] * (FIRST_ELEMENT - 5), *(x * q for x in AT_REST)],
        "z": [stuck] * SLIPS + [0.0] * (STOPS - SLIPS),
        "target": [q],
        "phase": [1.0],
    }
    for i in range(FILTER):
        state["spread"][_packed(i, i)] = n[f"unknown_{i}"]
    return state


def begin(signals: Values, n: Numbers, rests: Values) -> Outputs:
    """The state after the first reading at zero voltages; a reading that is not finite is a lost sensor."""
    q, finite = _reading(signals, n)
    return {"s": joined(rest(clip(q, -n["farthest"], n["farthest"]), n) | {"lost": [choose(finite, 0.0, RAMP)]})}


def listen(now: State, signals: Values, n: Numbers, rests: Values) -> Outputs:
    """Correct the estimate by a reading, or count a missing one; take the target over.

    Parameters
    ----------
    now : dict
        The controller's state by parts.
    signals : list, length 2
        Reading and target [m].
    n : dict
        `NUMBERS` by name.
    rests : list
        Table of rests.
    """
    q, finite = _reading(signals, n)
    again = function("and", finite, function("le", RAMP, now["lost"][0]))
    strayed = function("and", finite, function("le", PERSISTENT, now["strayed"][0]))
    fresh = rest(q, n) | {name: now[name] for name in ("volts", "commanded", "average")}
    of_target = ("target", "stood", "lost", "refused", "phase", "dwell", "tried")
    anew = fresh | {name: now[name] for name in of_target}
    restarted = {
        name: [choose(again, a, choose(strayed, b, c)) for a, b, c in zip(fresh[name], anew[name], old, strict=True)]
        for name, old in now.items()
    }
    corrected = _corrected(restarted, q, n)
    updated = {
        name: [choose(finite, a, b) for a, b in zip(corrected[name], restarted[name], strict=True)]
        for name in corrected
    }
    updated["lost"] = [choose(finite, 0.0, function("min", RAMP, restarted["lost"][0] + 1.0))]
    wanted = choose(function("finite", signals[1]), signals[1], n["offset"]) - n["offset"]
    last = n["first"] + (TARGETS - 1.0) / n["per_step"]
    target = choose(function("finite", signals[1]), clip(wanted, n["first"], last), restarted["target"][0])
    other = function("lt", 0.0, function("abs", target - restarted["target"][0]))
    updated |= {
        "target": [target],
        "stood": [choose(other, 0.0, function("min", restarted["stood"][0] + n["fade"], 1.0))],
        **{name: [choose(other, 0.0, restarted[name][0])] for name in ("tried", "refused", "near")},
    }
    return {"s": joined(restarted | updated)}


def _reading(signals: Values, n: dict[str, Any]) -> tuple[Any, Any]:
    """Displacement q [m] by the sensor, and whether the reading is finite."""
    finite = function("finite", signals[0])
    q = choose(finite, signals[0], n["offset"]) - n["offset"]
    return q, function("and", finite, function("lt", function("abs", q), n["farthest"]))


def _corrected(now: dict[str, Values], q: Any, n: dict[str, Any]) -> dict[str, Values]:
    """Estimate and covariance after a reading q [m]."""
    innovation = q - now["x"][0]
    outside = function("lt", n["band"], function("abs", innovation))
    miss = choose(outside, 0.0, innovation)
    column = [now["spread"][_packed(i, 0)] for i in range(FILTER)]
    share = [value / (column[0] + n["reading_variance"]) for value in column]
    moved = [
        clip(old + miss * share[i], -n[f"bound_{i}"], n[f"bound_{i}"])
        for i, old in enumerate([*now["x"][:CORRECTED], *now["moment"]])
    ]
    x = [*moved[:CORRECTED], *now["x"][CORRECTED:]]
    spread = [now["spread"][_packed(i, j)] - column[j] * share[i] for i in range(FILTER) for j in range(i + 1)]
    return {
        "strayed": [choose(outside, now["strayed"][0] + 1.0, 0.0)],
        "x": x,
        "moment": moved[CORRECTED:],
        "spread": spread,
        "z": _stops(now["z"], now["x"], x, n),
    }


def _packed(i: int, j: int) -> int:
    """Place of an entry of the covariance in its stored lower triangle."""
    return max(i, j) * (max(i, j) + 1) // 2 + min(i, j)


def _stops(z: Values, before: Values, after: Values, n: dict[str, Any]) -> Values:
    """Stop operators after a move."""
    moved = [after[i] - before[i] for i in SHAPE]
    slides = [sum(by * move for by, move in zip(direction(i, n), moved, strict=True)) for i in range(STOPS)]
    return [apply(STOP_OPERATOR, z[i], slides[i], travel(i, n))[0] for i in range(STOPS)]


def direction(stop: int, n: dict[str, Any]) -> tuple[Any, Any, Any]:
    """Slopes of the coordinate of a stop operator along (q, τ, β) [1, m, m]."""
    q, by_arm, tau, beta = STOP_DIRECTIONS[stop]
    return q, by_arm * n["arm"] + tau * n["length"], beta * n["length"]


def travel(stop: int, n: dict[str, Any]) -> Any:
    """Travel of a stop operator [m]."""
    return n[f"travel_{STOP_ELEMENTS[stop]}"]


def lag(now: State, v: Values, n: Numbers) -> Outputs:
    """Squared voltages [V²] that act during the period under the commands, `u`, and the means for the filter, `um`."""
    u = []
    mean = []
    for side, old, command in zip(SIDES, now["volts"], v, strict=True):
        middle, end = (command + (old - command) * n[f"{name}_{side}"] for name in ("kept_mean", "kept"))
        u.append(middle * middle)
        mean.append(0.5 * (old * old + end * end))
    return {"u": u, "um": mean}


def corrections(q: Any, n: dict[str, Any]) -> tuple[Values, Values]:
    """Values of the corrections at q and their slopes along q, each of 13."""
    place = clip((q - n["curve_first"]) * n["curve_per_metre"], 0.0, n["curve_last"])
    cell = function("floor", place)
    t = place - cell
    scale = n["curve_per_metre"]
    index = 6.0 * CURVES * cell
    values = []
    slopes = []
    bends = []
    for curve in range(CURVES):
        c = [fetch("curves", CURVES * power + curve, index) for power in range(6)]
        values.append(_horner(c, t))
        slopes.append(scale * _horner([(i + 1.0) * c[i + 1] for i in range(5)], t))
        bends.append(scale * scale * _horner([(i + 1.0) * (i + 2.0) * c[i + 2] for i in range(4)], t))
    return [*values, *slopes[CURVED]], [*slopes, *bends[CURVED]]


def _horner(coefficients: Values, t: Any) -> Any:
    value = coefficients[-1]
    for coefficient in reversed(coefficients[:-1]):
        value = value * t + coefficient
    return value


def _pushed(x: Values, prepared: Values) -> tuple[dict[int, Any], dict[int, Any]]:
    """Columns of the inverse mass matrix for a moment on the slope and a force on q: on q̇ (1), τ̇ (3) and β̇ (5)."""
    qq, qt, tt, qb, tb, bb = inline(INERTIA, x=x, p=prepared)["mass"]
    first = tt * bb - tb * tb
    second = qb * tb - qt * bb
    third = qt * tb - qb * tt
    over = 1.0 / (qq * first + qt * second + qb * third)
    moment = {1: second * over, 3: (qq * bb - qb * qb) * over, 5: (qt * qb - qq * tb) * over}
    return moment, {1: first * over, 3: second * over, 5: third * over}


def rates(now: State, y: Values, u: Values, prepared: Values, n: Numbers, curves: Values) -> Outputs:
    """Rates of the state y under squared voltages and the unknown moment.

    Parameters
    ----------
    now : dict
        The state where the step began, by parts.
    y : list, length STATES
        State of the joint.
    u : list, length 2
        Squared voltages [V²].
    prepared : list
        Constants of the joint.
    n : dict
        `NUMBERS` by name.
    curves : list
        Table of corrections.
    """
    c, _ = corrections(y[0], n)
    derivatives = inline(RATES, x=y, u=u, c=c, z=now["z"], start=[now["x"][i] for i in SHAPE], p=prepared)["rates"]
    twist, _ = _pushed(y, prepared)
    for i, on in twist.items():
        derivatives[i] = derivatives[i] + now["moment"][0] * on
    return {"dx": derivatives}


def ahead(share: float) -> Any:
    """The state after a share of a period with the rates `dx`."""
    return lambda now, dx: {"y": [x + share * PERIOD * rate for x, rate in zip(now["x"], dx, strict=True)]}


def finish(now: State, v: Values, k1: Values, k2: Values, k3: Values, k4: Values, n: Numbers) -> Outputs:
    """The state after a period, by the rates of the four stages; a wall ends every motion.

    Parameters
    ----------
    now : dict
        The state where the step began, by parts.
    v : list, length 2
        Commands [V].
    k1, k2, k3, k4 : list, length STATES
        Rates of the stages.
    n : dict
        `NUMBERS` by name.
    """
    totals = [
        sum(share * rate for share, rate in zip(SHARES, k, strict=True)) for k in zip(k1, k2, k3, k4, strict=True)
    ]
    x = [old + PERIOD / ALL_SHARES * total for old, total in zip(now["x"], totals, strict=True)]
    beyond = function("lt", n["wall"], function("abs", x[0]))
    x[0], x[1] = clip(x[0], -n["wall"], n["wall"]), choose(beyond, 0.0, x[1])
    moved = {
        "volts": [
            command + (old - command) * n[f"kept_{side}"]
            for side, old, command in zip(SIDES, now["volts"], v, strict=True)
        ],
        "commanded": v,
        "average": [mean + (u - mean) * (PERIOD / MEMORY) for mean, u in zip(now["average"], v, strict=True)],
        "x": x,
        "z": _stops(now["z"], now["x"], x, n),
    }
    return {"s": joined(now | moved)}


def spread(now: State, um: Values, slopes: Values, prepared: Values, n: Numbers, curves: Values) -> Outputs:
    """Move the covariance over the period: P ← F P Fᵀ + Q, F the exponential of the Jacobian to the third order.

    Parameters
    ----------
    now : dict
        The controller's state by parts.
    um : list, length 2
        Means of the squared voltages [V²].
    slopes : list
        Constants of the joint, for the Jacobian.
    prepared : list
        Constants of the joint.
    n : dict
        `NUMBERS` by name.
    curves : list
        Table of corrections.
    """
    a, push = _jacobian(now, um, slopes, prepared, n)
    size = range(FILTER)
    step = [[a[i][j] / 3.0 if _nonzero(a[i][j]) else 0.0 for j in size] for i in size]
    for share in (0.5, 1.0):
        product = _product(a, step)
        step = [[share * (a[i][j] + product[i][j]) for j in size] for i in size]
    for i in size:
        step[i][i] = step[i][i] + 1.0
    p = [[now["spread"][_packed(i, j)] for j in size] for i in size]
    half = _product(step, p)
    covariance = [
        sum(half[i][m] * step[j][m] for m in size if _nonzero(step[j][m])) for i in size for j in range(i + 1)
    ]
    for i, j in ((i, j) for i in push for j in push if i >= j):
        covariance[_packed(i, j)] = covariance[_packed(i, j)] + PERIOD * n["push"] * push[i] * push[j]
    covariance[-1] = covariance[-1] + PERIOD * n["walk"]
    return {"s": joined(now | {"spread": covariance})}


def _nonzero(value: Any) -> bool:
    """True if an entry of a matrix is traced, or a constant that is not zero."""
    return isinstance(value, Value) or value != 0.0


def _product(left: list[Values], right: list[Values]) -> list[Values]:
    size = range(FILTER)
    return [
        [sum(left[i][m] * right[m][j] for m in size if _nonzero(left[i][m]) and _nonzero(right[m][j])) for j in size]
        for i in size
    ]


def _jacobian(
    now: dict[str, Values], u: Values, slopes: Values, prepared: Values, n: dict[str, Any]
) -> tuple[list[Values], dict[int, Any]]:
    """PERIOD × ∂(rates)/∂(filter's numbers), and the change of the velocities by a force."""
    x = now["x"]
    z = now["z"]
    c, c_q = corrections(x[0], n)
    full = inline(JACOBIAN, x=x, u=u, c=c, c_q=c_q, z=z, p=slopes)["a"]
    width = STATES + STOPS
    a: list[Values] = [[0.0] * FILTER for _ in range(FILTER)]
    for place, i in zip(SHAPE, SHAPE_RATES, strict=True):
        a[place][i] = PERIOD
        for j in range(CORRECTED):
            a[i][j] = PERIOD * full[width * i + j]
        for stop in range(STOPS):  # a stop operator that slips does not resist
            held = function("lt", function("abs", z[stop]), 1.0)
            by = choose(held, PERIOD * full[width * i + STATES + stop] / travel(stop, n), 0.0)
            for j, along in zip(SHAPE, direction(stop, n), strict=True):
                a[i][j] = a[i][j] + along * by
    twist, push = _pushed(x, prepared)
    for i, on in twist.items():
        a[i][CORRECTED] = PERIOD * on
    return a, push


def check(now: State, v: Values, n: Numbers, rests: Values) -> Outputs:
    """Reaction to a number that is not finite: zero voltages, and a new start with the next reading.

    Parameters
    ----------
    now : dict
        The controller's state by parts.
    v : list, length 2
        Commands [V].
    n : dict
        `NUMBERS` by name.
    rests : list
        Table of rests.
    """
    whole = joined(now)
    sound = function("finite", whole[0])
    for value in whole[1:]:
        sound = function("and", sound, function("finite", value))
    blank = rest(0.0 * n["offset"], n) | {"lost": [RAMP]}
    return {
        "s": [choose(sound, old, new) for old, new in zip(whole, joined(blank), strict=True)],
        "v": [choose(sound, volts, 0.0) for volts in v],
    }


def heed(v: Values, n: Numbers) -> Outputs:
    """Measured voltages [V], limited to 0 … the largest; 0 in place of numbers that are not finite."""
    return {"v": [clip(choose(function("finite", volts), volts, 0.0), 0.0, n["highest"]) for volts in v]}


def known_state(now: State, n: Numbers) -> Outputs:
    """`ESTIMATED` numbers of the state: reading of the laser, rest of x, z, voltages, moment, and the status."""
    q, *others = now["x"]
    status = choose(function("lt", 0.5, now["strayed"][0]), 1.0, 0.0)
    status = choose(function("lt", 0.5, now["refused"][0]), 3.0, status)
    status = choose(function("lt", 0.5, now["lost"][0]), 2.0, status)
    return {"estimate": [q + n["offset"], *others, *now["z"], *now["volts"], *now["moment"], status]}
