"""The feedback law: push, brake on a curve that was simulated beforehand, then a linear-quadratic regulator.

Two membranes that only attract act as one moment of either sign on the beam's slope: one side at a time, its squared
voltage as large as the moment needs. With the target at q* and the distance s = q* − q

* far from the target the joint is pushed towards it with the full moment. The push lasts until the mass centre is as
  fast as a simulated joint that a brake, begun now, still stops at the target. Then it is braked with a share of the
  full moment, and the rest takes the speed's error against the simulated brake away (after M. L. Workman's proximate
  time-optimal servomechanism, dissertation, Stanford 1987). The braking moment at first accelerates the tip, but not
  the mass centre, so the mass centre's speed is judged;
* where the largest voltage cannot push the joint over its barrier, it is pushed along its own velocity, towards the
  barrier and away from it in turn: every half swing then adds energy;
* near a target that is held a linear-quadratic regulator with the whole estimated state, with the equilibrium and gains
  of the target, acts about it. What the estimator calls an unknown moment is balanced. At an unstable target both sides
  are charged: they pull less at the beam together, so that it leaves the target more slowly, and both act linearly;
* in a well nothing is held: creep and loads move the well, and a bistable joint rests there without voltage. A target
  that stands still within the band in which a joint counts as settled means the well. The same regulator then damps
  motions about their own mean, and the joint is let go once it is slow and the moment is small;
* a target that is not reached for long is given up.

Traced into a graph as the estimator is (`pipeline.control.estimator`).
"""

import math
from typing import Any

from ..codegen.graph import choose, clip, fetch, function
from ..generated.condensed_joint import STATES
from .estimator import MEMORY, PERIOD, RAMP, Numbers, Outputs, State, Values, joined, row
from .law import REACHES, TARGET_COLUMNS, TARGETS, WELLS

RESERVE = 0.8
"""Share of the largest moment with which the joint brakes; the rest is left to the feedback."""
STALLED = 0.5
"""Time [s] without coming near a target after which the joint is pumped although its model needs no pump."""
DEAD = 0.02
"""Share of the largest moment below which the joint is let go in a well."""
INTEGRAL = 3.0
"""Time constant [s] of the slow moment at a target that is held."""
ENOUGH = 1.0 - math.exp(-1.0)
"""Share of the time far from a target, over `estimator.MEMORY`, at which it is given up: after that time on end."""
_WIDTH = max(place.stop for place in TARGET_COLUMNS.values())


def tabulated(name: str, place: Any) -> Values:
    """Columns of the table of targets at a place that is counted in rows."""
    lower, share = row(place, TARGETS)
    index = float(_WIDTH) * lower
    columns = TARGET_COLUMNS[name]
    return [
        fetch("targets", i, index) * (1.0 - share) + fetch("targets", i + _WIDTH, index) * share
        for i in range(columns.start, columns.stop)
    ]


def braking_speeds(place: Any, distance: Any, from_right: Any, n: dict[str, Any]) -> Values:
    """Speeds [m/s] at a distance [m] from a target: with the first a pushed joint is braked, the second braking has.

    Parameters
    ----------
    place : value
        Of the target, in rows.
    distance : value
        To the target [m].
    from_right : value
        1 if it comes from the right, else 0.
    n : dict[str, Any]
        `NUMBERS` by name.
    """
    lower, share = row(place, TARGETS)
    part, more = row(distance * n["per_reach"], REACHES)
    index = (lower + float(TARGETS) * from_right) * float(REACHES) + part
    speeds = []
    for first in (0, 2 * TARGETS * REACHES):
        nearer, farther = (
            fetch("braking", first + i, index) * (1.0 - more) + fetch("braking", first + i + 1, index) * more
            for i in (0, REACHES)
        )
        speeds.append(nearer * (1.0 - share) + farther * share)
    return speeds


def regulated(now: dict[str, Values], acting: Any, hold: Any, place: Any) -> Any:
    """Moment [N·m] of the linear-quadratic regulator of a target, beside the one that holds it.

    Parameters
    ----------
    now : dict[str, Values]
        Parts of the controller's state.
    acting : value
        Moment that acts [N·m].
    hold : value
        Moment that holds the target [N·m].
    place : value
        Of the target, in rows.
    """
    there = tabulated("rests", place)
    gains = tabulated("gains", place)
    moment = -gains[STATES] * (acting - hold)
    for i in range(STATES):
        moment = moment - gains[i] * (now["x"][i] - there[i])
    return moment


def shares(moment: Any, left: Any, right: Any, common: Any) -> Any:
    """Difference of the shares of both sides that makes a moment [N·m], given their moments at the largest voltage.

    Parameters
    ----------
    moment : value
        [N·m].
    left : value
        Moment of the left side at the largest voltage [N·m].
    right : value
        Of the right side [N·m].
    common : value
        Mean share of both.
    """
    alone = moment / choose(function("lt", moment, 0.0), right, left)
    together = (moment - common * (left - right)) / (0.5 * (left + right))
    return choose(function("lt", function("abs", together), 2.0 * common), together, alone)


def _both(every: Any, *others: Any) -> Any:
    for other in others:
        every = function("and", every, other)
    return every


def far(now: dict[str, Values], n: dict[str, Any], place: Any) -> tuple[Any, Any, Any, Any]:
    """Push far from the target as a share of the largest moment, −1 to 1; phase, dwell and brakes of the new state."""
    q = now["x"][0]
    speed = now["x"][1]
    target = now["target"][0]
    right = function("lt", q, target)
    towards = choose(right, 1.0, -1.0)
    begins, lasts = braking_speeds(place, function("abs", target - q), choose(right, 0.0, 1.0), n)
    # The speed of the mass centre, which a moment on the slope does not change at once as it does that of the tip.
    centre = (speed + n["lever"] * now["x"][3]) * towards
    since = now["brakes"][0]
    correction = choose(function("lt", n["settles"], since), n["steepness"] * (lasts - centre), 0.0)
    goes_on = _both(function("lt", 0.5, since), function("lt", 0.0, centre), function("lt", correction, RESERVE))
    brakes = function("or", goes_on, function("lt", begins, centre))
    braked = choose(brakes, correction - RESERVE, 1.0) * towards
    before = (n["saddle"] - q) * towards
    over = (target - n["saddle"]) * towards
    weak = function("lt", 0.5, choose(right, n["pumped_right"], n["pumped_left"]))
    needed = function("or", weak, function("lt", STALLED / MEMORY, now["tried"][0]))
    pumped = _both(needed, function("lt", 0.0, before), function("lt", 0.0, over))
    phase = now["phase"][0]
    dwell = now["dwell"][0] + n["fade"]
    turns = _both(function("lt", 1.0, dwell), function("lt", speed * towards * phase, n["slow"]))
    phase = choose(turns, -phase, phase)
    push = clip(choose(pumped, phase * towards, braked), -1.0, 1.0)
    brakes = choose(function("or", pumped, function("not", brakes)), 0.0, since + 1.0)
    return push, choose(pumped, phase, 1.0), choose(pumped, choose(turns, 0.0, dwell), 0.0), brakes


def _regulates(now: dict[str, Values], well: Any, n: dict[str, Any]) -> Any:
    """1 from where the joint comes near its target until it is far away, 2 where it is let go, else 0.

    Far away from a well is beyond the saddle.
    """
    target = now["target"][0]
    away = function("abs", target - now["x"][0])
    caught = function("lt", away, n["near"])
    left = choose(well, function("abs", target - n["saddle"]), 2.0 * n["near"])
    return choose(function("lt", left, away), 0.0, choose(caught, function("max", 1.0, now["near"][0]), now["near"][0]))


def _is_well(now: dict[str, Values], place: Any, n: dict[str, Any]) -> Any:
    """True if the target, in rows of the table, stands still and within the band of a well: then it means the well."""
    away = function("min", *(function("abs", place - row) for row in WELLS))
    return _both(function("le", away, n["same"]), function("le", 1.0, now["stood"][0]))


def _voltages(push: Any, common: Any, top: Any, n: dict[str, Any]) -> Values:
    """Voltages [V] of a difference of shares and a mean share of the largest squared voltage."""
    left = function("max", function("max", common + 0.5 * push, push), 0.0)
    left = function("min", function("min", left, 1.0), 1.0 + push)
    return [
        function("min", n["highest"], top * function("sqrt", clip(share, 0.0, 1.0))) for share in (left, left - push)
    ]


def limited(volts: Values, now: dict[str, Values], n: dict[str, Any]) -> Values:
    """Voltages [V] whose change in a period and whose means stay within the limits.

    A voltage above its largest mean falls in time: the mean grows by (v − allowed)² / 2 over the slew limit meanwhile.
    """
    periods = MEMORY / PERIOD
    within = []
    for wanted, last, mean in zip(volts, now["commanded"], now["average"], strict=True):
        room = function("max", n["allowed"] - mean, 0.0)
        falling = n["allowed"] + function("max", function("sqrt", periods * n["slew"] * room) - n["slew"], 0.0)
        most = function("min", falling, mean + periods * room)
        within.append(clip(function("min", wanted, most), last - n["slew"], last + n["slew"]))
    return [clip(value, 0.0, n["highest"]) for value in within]


def decide(now: State, n: Numbers, targets: Values, braking: Values) -> Outputs:
    """The voltages of a period, shape (2,) [V]: within the limits, ramped down without a reading.

    Parameters
    ----------
    now : dict
        The controller's state by parts.
    n : dict
        `NUMBERS` by name.
    targets : list
        Table of targets.
    braking : list
        Braking curves.
    """
    x = now["x"]
    place = (now["target"][0] - n["first"]) * n["per_step"]
    well = _is_well(now, place, n)
    regulates = function("lt", 0.5, _regulates(now, well, n))
    rests = _both(regulates, well)
    holds = _both(regulates, function("not", well))
    left, right = tabulated("moments", (x[0] - n["first"]) * n["per_step"])
    pull_left, pull_right = (volts * volts for volts in now["volts"])
    acting = (left * pull_left - right * pull_right) / (n["highest"] * n["highest"])
    (common,) = tabulated("common", place)
    (hold,) = tabulated("holding", place)
    stiffness, *_ = tabulated("gains", place)
    largest = 0.5 * (left + right)
    level = now["level"][0]
    mean = now["mean"][0]
    still = choose(well, 0.0, hold - now["moment"][0] + level)
    motion = regulated(now, acting, still, place)
    limited_motion = clip(motion, -largest, largest)
    share = shares(still + choose(well, limited_motion - mean, motion), left, right, common)
    slow = function("lt", function("abs", x[1]), n["slow"])  # it swings less than the band in which it is settled
    small = function("or", function("lt", function("abs", share), DEAD), function("lt", 1.5, now["near"][0]))
    free = _both(rests, slow, small)
    share = choose(free, 0.0, clip(share, -1.0, 1.0))
    push, phase, dwell, brakes = far(now, n, place)
    push = choose(regulates, share, push)
    common = choose(holds, common, 0.0)
    lost = function("lt", 0.5, now["lost"][0])
    tried = now["tried"][0]
    tried = choose(lost, tried, tried + (choose(regulates, 0.0, 1.0) - tried) * (PERIOD / MEMORY))
    refused = choose(function("lt", ENOUGH, tried), 1.0, now["refused"][0])
    stopped = function("lt", 0.5, refused)
    slower = level - PERIOD / INTEGRAL * stiffness * (x[0] - now["target"][0])
    updated = {
        "near": [choose(regulates, choose(free, 2.0, 1.0), 0.0)],
        "level": [choose(holds, clip(slower, -largest, largest), 0.0)],
        "mean": [choose(rests, mean + n["fade"] * (limited_motion - mean), 0.0)],
        "tried": [tried],
        "refused": [refused],
        "phase": [choose(regulates, now["phase"][0], phase)],
        "dwell": [choose(regulates, now["dwell"][0], dwell)],
        "brakes": [choose(regulates, 0.0, brakes)],
    }
    top = n["highest"] * (RAMP - now["lost"][0]) / RAMP
    volts = _voltages(choose(stopped, 0.0, push), choose(stopped, 0.0, common), top, n)
    return {"v": limited(volts, now, n), "s": joined(now | updated)}
