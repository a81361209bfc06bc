"""Pulses of joints of the virtual rig: what their predictions hold, and feedback beside them, misses included.

`python benchmarks/control_pulses.py RIG=RUN …`, arguments and output as of `control_disturbances.py`: for each joint
the pulses of `debist control pulse` played on the joint itself, its snaps by feedback, the lowest voltages of plain
pulses, and snaps with less voltage than a slow ramp needs. About 100 s of processor time a joint.
"""

from collections.abc import Iterator

import numpy as np
from control_disturbances import Row, Tested, main

from pipeline.control.design import Settings, design as design_law
from pipeline.control.pulses import design_pulse
from pipeline.control.switching_map import lowest_voltage, pulses, switching_map
from pipeline.errors import DebistError
from pipeline.numerics.arrays import FloatArray
from pipeline.numerics.metrics import Step, one_step
from pipeline.rig.joint import rest
from pipeline.rig.loop import ClosedLoop, Scenario, played, run_loop
from pipeline.system.names import Goal, Well
from pipeline.workflow.studies.closed_loop import designed
from pipeline.workflow.studies.control import with_draws

TOP = 3000.0  # V
LENGTHS = (0.1, 0.2)  # s, of the pulses whose lowest voltage is looked for
REACH, HALVINGS = 0.06, 8  # of its logarithm
SLOWER, MORE = 1.05, 1.3  # wanted at most: settling over the pulse's, and charge over a plain pulse's
BORDER, DOUBT = 8, 0.1  # cells of a map on each side of its border, and the largest Brier score there
RAMP, SHARE = 60.0, 0.85  # s to 3 kV, and the share of the voltage at which such a ramp switches
WAYS: tuple[Well, Well] = ("right", "left")


def play(one: Tested, u: FloatArray, to: Well) -> ClosedLoop:
    """The joint from rest under commands, shape (N, 2) [V], at 1 kHz."""
    t, side = np.arange(float(len(u))) * 1e-3, -1 if to == "right" else 1
    if (side, 1.0) not in one.starts:
        one.starts[side, 1.0] = rest(one.joint.parameters, side=side)
    scenario = Scenario(np.zeros(1), np.zeros(1), float(t[-1]), side=side, seed=7)
    return run_loop(one.joint.parameters, one.joint.bench, scenario, played(t, u), one.starts[side, 1.0])


def snaps(one: Tested) -> Iterator[Row]:
    """Both pulses to each well, their intervals, and feedback over the pulse of least time."""
    left, _, right = one.places
    for to, start, end in (("right", left, right), ("left", right, left)):
        joint = with_draws(one.model, one.converters, one.places, to)  # type: ignore[arg-type]
        goals: tuple[Goal, ...] = ("time", "energy")
        for goal in goals:
            name = f"pulse of least {goal} to the {to}"
            try:
                pulse = design_pulse(joint, start, end, right - left, TOP, goal)
            except DebistError:
                yield f"{name}, settling", np.inf, False
                continue
            u = np.zeros((1500, 2))
            u[: len(pulse.v)] = pulse.v
            run = play(one, u, to)  # type: ignore[arg-type]
            step = one_step(run.t, run.true_q, end, right - left)
            seconds = _seconds(step)
            yield f"{name}, settling", seconds, bool(np.isfinite(seconds))
            low, high = pulse.settling_low_s, pulse.settling_high_s
            yield f"{name}, its interval: upper end over lower", high / low, low <= seconds <= high
            if goal == "time":
                run = one.run({0.0: start, 0.3: end}, 1.8, -1 if to == "right" else 1)
                part = run.t >= 0.3
                ratio = _seconds(one_step(run.t[part], run.true_q[part], end, right - left)) / seconds
                yield f"feedback over pulse to the {to}, settling", ratio, ratio <= SLOWER
            else:
                charge = np.maximum(np.diff(pulse.v**2, axis=0, prepend=0.0), 0.0).sum() / TOP**2
                yield f"{name}, charge over that of 3 kV", float(charge), charge <= MORE


def _seconds(step: Step) -> float:
    return np.inf if step.settling_s is None else step.settling_s


def thresholds(one: Tested) -> Iterator[Row]:
    """Error of the lowest voltage of plain pulses, in its deviations; right where the band of 90 % holds it."""
    for side, to in enumerate(WAYS):
        for length in LENGTHS:
            predicted = lowest_voltage(one.model, one.converters, one.places, to, length)
            if predicted is None or predicted.voltage * np.exp(REACH) > TOP:
                continue
            low, high = np.log(predicted.voltage) - REACH, np.log(predicted.voltage) + REACH
            for _ in range(HALVINGS):
                middle = 0.5 * (low + high)
                end = play(one, pulses(np.exp([middle]), np.array([length]), side)[0], to).true_q[-1]
                low, high = (low, middle) if (end > 0.0) == (to == "right") else (middle, high)
            found = np.exp(0.5 * (low + high))
            deviation = np.log(predicted.high / predicted.low) / (2.0 * 1.645)
            error = float(np.log(found / predicted.voltage) / deviation)
            yield f"lowest voltage, {length} s to the {to}: error", abs(error), predicted.low <= found <= predicted.high


def maps(one: Tested) -> Iterator[Row]:
    """Brier score of the map of plain pulses, in cells on both sides of its border."""
    for side, to in enumerate(WAYS):
        joint = with_draws(one.model, one.converters, one.places, to)
        chart = switching_map(joint, one.places, to)
        border = np.argwhere(np.diff(chart.probability > 0.5, axis=0))
        below = np.random.default_rng(7).permutation(border)[:BORDER]
        errors = []
        for volts, length in np.concatenate([below, below + np.array([1, 0])]):
            u = pulses(chart.voltages[[volts]], chart.durations[[length]], side)[0]
            switched = (play(one, u, to).true_q[-1] > 0.0) == (to == "right")
            errors.append((chart.probability[volts, length] - switched) ** 2)
        score = float(np.mean(errors))
        yield f"map to the {to}, Brier score at its border", score, score < DOUBT


def swings(one: Tested) -> Iterator[Row]:
    """Time [s] in which feedback switches with less voltage than a slow ramp does."""
    for side, to in enumerate(WAYS):
        u = np.zeros((round(1e3 * RAMP), 2))
        u[:, side] = np.linspace(0.0, TOP, len(u))
        run = play(one, u, to)
        over = (run.true_q > 0.0) == (to == "right")
        top = SHARE * u[min(int(np.argmax(over)) // 2, len(u) - 1), side] if over.any() else SHARE * TOP
        law = design_law(one.plant, Settings(top, one.converters.lags))
        start, end = one.places[2 * side], one.places[2 - 2 * side]
        where = -1 if to == "right" else 1
        scenario = Scenario(np.zeros(1), np.array([end]), 6.0, side=where, seed=7)
        run = run_loop(one.joint.parameters, one.joint.bench, scenario, designed(law), one.starts[where, 1.0])
        seconds = _seconds(one_step(run.t, run.true_q, end, abs(end - start)))
        yield f"switched to the {to} by {100 * SHARE:.0f} % of a ramp's voltage, settling", seconds, seconds < 6.0


if __name__ == "__main__":
    main((snaps, thresholds, maps, swings))
