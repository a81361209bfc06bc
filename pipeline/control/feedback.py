"""The feedback law: push, brake on a curve that was simulated beforehand, then a linear-quadratic regulator.

Two membranes that only attract act as one moment of either sign on the beam's slope: one side at a time, its squared
voltage as large as the moment needs. With the target at q* and the distance s = q* − q

* far from the target the joint is pushed towards it with the full moment, until its mass centre is as fast as a
  simulated joint that a brake, begun now, still stops at the target. Then it is braked with a share of the full moment,
  and the speed's error against the simulated brake is taken away by the rest (after M. L. Workman's proximate
  time-optimal servomechanism, dissertation, Stanford 1987). The braking moment at first accelerates the tip, but not
  the mass centre, so the mass centre's speed is judged;
* where the largest voltage does not suffice to push the joint over its barrier, it is pushed towards the
  barrier and away from it in turn, along its own velocity: every half swing then adds energy;
* near the target a linear-quadratic regulator with the whole estimated state, with the equilibrium and gains of the
  target, holds it. What the estimator calls an unknown moment is balanced. At an unstable target both sides are
  charged: they pull less at the beam together, so that it leaves the target more slowly, and both act linearly.
* a stable target needs no voltage against a small offset. A slow moment takes a larger one away; where it does not
  help, it is given up. The regulator damps motions about the place where the joint then rests, so an error of
  the model's statics changes no voltage at rest. A target that is not reached for long is given up.

Traced into a graph as the estimator is (`pipeline.control.estimator`).
"""

from typing import Any

from pipeline.codegen.graph import choose, clip, fetch, function
from pipeline.control.estimator import MEMORY, PERIOD, RAMP, Outputs, Values, joined, named, parts, row
from pipeline.control.law import REACHES, TARGET_COLUMNS, TARGETS
from pipeline.generated.condensed_joint import STATES

STILL = 5e-3
"""Speed [m/s] below which a joint that is pumped has come to the end of its swing."""
DWELL, PATIENCE = 80.0, 500.0
"""Periods that a push of the pump lasts at least, so that it gets the joint moving; the second past the saddle."""
RESERVE = 0.8
"""Share of the largest moment with which the joint brakes; the rest is left to the feedback."""
STALLED = 0.5
"""Time [s] without coming near a target after which the joint is pumped although its model needs no pump."""
PAST = 0.3
"""Share of the way from the saddle to the target on which a joint that is pumped is still pushed."""
DEAD = 0.02
"""Share of the largest moment that the regulator leaves out: at rest in a well noise moves no voltage."""
FREE, LEFT = 0.15e-3, 0.05e-3
"""Offset [m] from a well that takes no voltage, and what is left of a larger one and of one from another target."""
SLOW, INTEGRAL, LEAK = 0.35, 3.0, 3.0
"""Time constants [s] of the slow moment at a well, of that at an unstable target, and of its decay where the offset is
small."""
ENGAGED, STIFFENS, TIRED = 0.035, 0.1, 0.8
"""Shares of the largest moment above which the slow moment is on, above which the regulator holds the place too, and at
which the attempt is given up."""
LEAST_STIFF = 30.0
"""Least share of the largest moment that moves a rest by a metre: a model may invert the statics beyond its wells."""
FADES = 0.2
"""Time constant [s] with which the mean of a stable target's regulator is taken away."""
ENOUGH, SWINGS = 4.0, 16.0
"""Time [s] after which a target that is not reached is given up, and how much more is given to the pump."""
EARLY = 1.5
"""Twice the share of the slew limit with which a voltage falls to its largest mean."""
FORGIVEN = 0.1
"""Part of this time that each second near the target takes away [s]."""
_WIDTH = max(place.stop for place in TARGET_COLUMNS.values())


def tabulated(name: str, place: Any) -> Values:
    """Columns of the table of targets at a place that is counted in rows."""
    lower, share = row(place, TARGETS)
    index, columns = float(_WIDTH) * lower, TARGET_COLUMNS[name]
    return [
        fetch("targets", i, index) * (1.0 - share) + fetch("targets", i + _WIDTH, index) * share
        for i in range(columns.start, columns.stop)
    ]


def braking_speeds(place: Any, distance: Any, from_right: Any, n: dict[str, Any]) -> Values:
    """Speeds [m/s] at a distance [m] from a target: with the first a pushed joint is braked, the second braking has."""
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


def slope(name: str, place: Any, n: dict[str, Any]) -> Any:
    """Change of a column of the table of targets with the target [1/m]."""
    lower, _ = row(place, TARGETS)
    column = TARGET_COLUMNS[name].start
    index = float(_WIDTH) * lower
    return (fetch("targets", column + _WIDTH, index) - fetch("targets", column, index)) * n["per_step"]


def regulated(now: dict[str, Values], acting: Any, hold: Any, place: Any) -> Any:
    """Moment [N·m] of the linear-quadratic regulator of a target, beside the one that holds it."""
    there, gains = tabulated("rests", place), tabulated("gains", place)
    moment = -gains[STATES] * (acting - hold)
    for i in range(STATES):
        moment = moment - gains[i] * (now["x"][i] - there[i])
    return moment


def held_slowly(
    now: dict[str, Values], hold: Any, stiff: tuple[Any, Any], largest: Any, n: dict[str, Any]
) -> tuple[Any, Any]:
    """Moment [N·m] that acts at rest at a stable target, and the next slow moment [N·m].

    `stiff` is the stiffness [N·m/m] there, and the larger one of both sides.
    """
    level, away = now["level"][0], now["x"][0] - now["target"][0]
    off = function("le", function("abs", level), ENGAGED * largest)
    without = _both(function("lt", function("abs", hold), stiff[0] * n["size"] * FREE), off)
    left = choose(without, FREE, LEFT) * n["size"]
    outside = away - clip(away, -left, left)
    slow = choose(function("lt", 0.0, function("abs", outside)), -stiff[1] * outside / SLOW, -level / LEAK)
    slow = choose(function("lt", 0.5, now["refused"][0]), -level / SLOW, slow)
    return choose(without, 0.0, hold) + level, level + PERIOD * slow


def shares(moment: Any, left: Any, right: Any, common: Any) -> Any:
    """Difference of the shares of left and right that makes a moment [N·m] of those at the largest voltage."""
    alone = moment / choose(function("lt", moment, 0.0), right, left)
    together = (moment - common * (left - right)) / (0.5 * (left + right))
    return choose(function("lt", function("abs", together), 2.0 * common), together, alone)


def _both(every: Any, *others: Any) -> Any:
    for other in others:
        every = function("and", every, other)
    return every


def far(now: dict[str, Values], n: dict[str, Any], place: Any) -> tuple[Any, Any, Any, Any]:
    """Share of the largest moment far from the target, −1 to 1; the pump's phase and time, periods of braking."""
    q, speed, target = now["x"][0], now["x"][1], now["target"][0]
    right = function("lt", q, target)
    towards = choose(right, 1.0, -1.0)
    begins, lasts = braking_speeds(place, function("abs", target - q), choose(right, 0.0, 1.0), n)
    # The speed of the mass centre, which a moment on the slope does not change at once as it does that of the tip.
    centre, since = (speed + n["lever"] * now["x"][3]) * towards, now["brakes"][0]
    correction = choose(function("lt", n["settles"], since), n["steepness"] * (lasts - centre), 0.0)
    goes_on = _both(function("lt", 0.5, since), function("lt", 0.0, centre), function("lt", correction, RESERVE))
    brakes = function("or", goes_on, function("lt", begins, centre))
    braked = choose(brakes, correction - RESERVE, 1.0) * towards
    before, over = (n["saddle"] - q) * towards, (target - n["saddle"]) * towards
    weak = function("lt", 0.5, choose(right, n["pumped_right"], n["pumped_left"]))
    needed = function("or", weak, function("lt", STALLED, now["tried"][0]))
    pumped = _both(needed, function("lt", 0.0, before + PAST * over), function("lt", 0.0, over))
    phase, dwell = now["phase"][0], now["dwell"][0] + 1.0
    past = _both(function("lt", before, 0.0), function("lt", 0.0, phase))
    still = function("lt", speed * towards * phase, STILL * n["size"])
    turns = _both(function("lt", choose(past, PATIENCE, DWELL), dwell), still)
    phase, dwell = choose(turns, -phase, phase), choose(turns, 0.0, dwell)
    push = clip(choose(pumped, phase * towards, braked), -1.0, 1.0)
    brakes = choose(function("or", pumped, function("not", brakes)), 0.0, since + 1.0)
    return push, choose(pumped, phase, 1.0), choose(pumped, dwell, 0.0), brakes


def _regulates(now: dict[str, Values], n: dict[str, Any]) -> Any:
    """1 from where the joint comes near its target slowly, until it has gone twice as far."""
    away = function("abs", now["target"][0] - now["x"][0])
    caught = _both(function("lt", away, n["near"]), function("lt", function("abs", now["x"][1]), n["fast"]))
    return choose(function("lt", 2.0 * n["near"], away), 0.0, choose(caught, 1.0, now["near"][0]))


def _voltages(push: Any, common: Any, top: Any, n: dict[str, Any]) -> Values:
    """Voltages [V] of a difference of shares and a mean share of the largest squared voltage."""
    left = function("max", function("max", common + 0.5 * push, push), 0.0)
    left = function("min", function("min", left, 1.0), 1.0 + push)
    both = (left, left - push)
    return [function("min", n["highest"], top * function("sqrt", clip(share, 0.0, 1.0))) for share in both]


def limited(volts: Values, now: dict[str, Values], n: dict[str, Any]) -> Values:
    """Voltages [V] whose change in a period and whose means stay within the limits.

    A voltage above its largest mean falls in time: the mean grows by (v − allowed)² / 2 over the slew limit meanwhile.
    """
    periods, within = MEMORY / PERIOD, []
    for wanted, last, mean in zip(volts, now["commanded"], now["average"], strict=True):
        room = function("max", n["allowed"] - mean, 0.0)
        above = function("sqrt", EARLY * periods * n["slew"] * room) - n["slew"]
        falling = n["allowed"] + function("max", above, 0.0)
        most = function("min", falling, mean + periods * room)
        within.append(clip(function("min", wanted, most), last - n["slew"], last + n["slew"]))
    return [clip(value, 0.0, n["highest"]) for value in within]


def _near(now: dict[str, Values], moments: tuple[Any, Any, Any], calm: Any, place: Any, n: dict[str, Any]) -> Values:
    """Moment [N·m] near a target, the next slow moment and the next mean of the regulator.

    `moments` are the one that holds the joint there, the one that acts, and the largest; `calm` at an unstable target.
    """
    hold, acting, largest = moments
    stiff = function("max", slope("holding", place, n), largest * (LEAST_STIFF / n["size"]))
    steeper = function("max", stiff, slope("holding", place - 1.0, n))
    (stiffness, *_), level_there, mean = tabulated("gains", place), now["level"][0], now["mean"][0]
    loaded = function("lt", STIFFENS * largest, function("abs", level_there))
    moment, level = held_slowly(now, hold, (stiff, steeper + choose(loaded, stiffness, 0.0)), largest, n)
    integral = level_there - PERIOD / INTEGRAL * stiffness * (now["x"][0] - now["target"][0])
    level = clip(choose(calm, integral, level), -largest, largest)
    moment = choose(calm, hold - now["moment"][0] + level_there, moment)
    motion = regulated(now, acting, moment, place)
    # Towards the saddle a moment moves the place of rest as a model has it, beyond a well perhaps not.
    outwards = choose(function("lt", n["saddle"], now["target"][0]), hold, -hold)
    stays = function("or", function("or", calm, loaded), function("lt", outwards, -stiff * n["size"] * FREE))
    motion = choose(stays, motion, clip(motion, -largest, largest))
    fading = choose(stays, 0.0, mean + PERIOD / FADES * (motion - mean))
    return [moment + motion - choose(stays, 0.0, mean), level, fading]


def decide(s: Values, e: Values, targets: Values, braking: Values) -> Outputs:
    """The voltages of a period, shape (2,) [V]: within the limits, ramped down without a reading."""
    n, now = named(e), parts(s)
    x, place = now["x"], (now["target"][0] - n["first"]) * n["per_step"]
    regulates = function("lt", 0.5, _regulates(now, n))
    left, right = tabulated("moments", (x[0] - n["first"]) * n["per_step"])
    pull_left, pull_right = (volts * volts for volts in now["volts"])
    acting = (left * pull_left - right * pull_right) / (n["highest"] * n["highest"])
    (common,), (hold,) = tabulated("common", place), tabulated("holding", place)
    largest = 0.5 * (left + right)
    calm = _both(regulates, function("lt", 0.01, common))
    moment, level, fading = _near(now, (hold, acting, largest), calm, place, n)
    share = shares(moment, left, right, common)
    share = clip(share - choose(calm, 0.0, clip(share, -DEAD, DEAD)), -1.0, 1.0)
    push, phase, dwell, brakes = far(now, n, place)
    push = choose(regulates, share, push)
    # What the regulator takes back of the slow moment is not spent.
    spent = _both(*(function("lt", TIRED, function("abs", part)) for part in (level / largest, share)))
    refused, tried = _refused(now, n, regulates, _both(function("lt", common, 0.01), spent))
    stopped = function("lt", choose(regulates, 1.5, 0.5), refused)
    updated = {
        "near": [choose(calm, 2.0, choose(regulates, 1.0, 0.0))],
        "level": [choose(regulates, level, 0.0)],
        "mean": [choose(regulates, fading, 0.0)],
        "tried": [tried],
        "refused": [refused],
        "phase": [choose(regulates, now["phase"][0], phase)],
        "dwell": [choose(regulates, now["dwell"][0], dwell)],
        "brakes": [choose(regulates, 0.0, brakes)],
    }
    top = n["highest"] * (RAMP - now["lost"][0]) / RAMP
    volts = _voltages(choose(stopped, 0.0, push), choose(stopped, 0.0, choose(calm, common, 0.0)), top, n)
    return {"v": limited(volts, now, n), "s": joined(now | updated)}


def _refused(now: dict[str, Values], n: dict[str, Any], regulates: Any, tired: Any) -> tuple[Any, Any]:
    """What is given up, until another target comes, and the time [s] of attempts on this one."""
    right = function("lt", now["x"][0], now["target"][0])
    enough = ENOUGH + SWINGS * choose(right, n["pumped_right"], n["pumped_left"])
    waits = function("or", regulates, function("lt", 0.5, now["lost"][0]))
    tried = function("max", now["tried"][0] + choose(waits, -FORGIVEN * PERIOD, PERIOD), 0.0)
    refused = choose(_both(regulates, tired), function("max", now["refused"][0], 1.0), now["refused"][0])
    return choose(function("lt", enough, tried), 2.0, refused), function("min", tried, 2.0 * (ENOUGH + SWINGS))
