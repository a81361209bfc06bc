"""Margins of the loop at the unstable equilibrium, against the loop as it is simulated."""

from collections import deque
from functools import lru_cache

import numpy as np
import pytest
from control_joints import designed

from pipeline.control.controller import begin_control, control, move
from pipeline.control.design import condensed_joint_law
from pipeline.control.estimator import PERIOD
from pipeline.control.law import CONTROLLER_STATE, NUMBERS, Law
from pipeline.control.margins import FACTOR, Margins, margins
from pipeline.control.plant import wells_and_saddle
from pipeline.models.hybrid.kernels import INDEX, prepare


@lru_cache(maxsize=1)
def margins_of_the_model() -> Margins:
    plant, law = designed()
    found = margins(plant, law, wells_and_saddle(plant)[1].q)
    assert found is not None
    return found


def with_friction(factor: float) -> Law:
    """The joint of the model with a factor on its friction that sticks."""
    plant, _ = designed()
    k = plant.constants.k.copy()
    k[[i for name, i in INDEX.items() if name.startswith(("stop_force", "layer_force"))]] *= factor
    law = condensed_joint_law(plant, (3e-3, 3e-3))
    return law._replace(prepared=prepare(k[None])[0])


def sliding(law: Law) -> Law:
    """The same with friction that never sticks, and so resists nothing."""
    travels = np.array([name.startswith("travel") for name in NUMBERS])
    return law._replace(numbers=np.where(travels, 1e9, law.numbers))


def grows(law: Law, joint: Law, gain: float = 1.0, delay: int = 0) -> bool:
    """Whether a motion of a micrometre about the unstable equilibrium grows in 6 s, with a gain and a delay [periods].

    Both act on what the voltages change by.
    """
    saddle = wells_and_saddle(designed()[0])[1].q
    s, truth, v = np.zeros(CONTROLLER_STATE), np.zeros(CONTROLLER_STATE), np.zeros(2)
    begin_control(saddle, law, s)
    begin_control(saddle, joint, truth)
    distances, waiting = [], deque([np.zeros(2)] * (delay + 1))
    for i in range(10_000):
        control(s, truth[0] + law.number("offset"), saddle, law, v)
        if i < 4000:
            rest = v.copy()
            move(truth, v, joint)
            continue
        truth[1] += 1e-5 * (i == 4000)
        waiting.append(v - rest)
        waiting.popleft() if len(waiting) > delay + 1 else None
        move(truth, np.maximum(rest + gain * waiting[0], 0.0), joint)
        distances.append(abs(truth[0] + law.number("offset") - saddle))
    return max(distances[-1000:]) > max(distances[:500])


def lost(gain: float = 1.0, delay: int = 0) -> bool:
    """Whether one of the three loops that the margins are of is unstable."""
    law = designed()[1]
    free, sticks = sliding(with_friction(0.0)), with_friction(1.0)
    loops = ((sliding(law), free), (law, free), (law, sticks))
    return any(grows(controller, joint, gain, delay) for controller, joint in loops)


@pytest.mark.parametrize("end", [pytest.param("gain_low", marks=pytest.mark.long), "gain_high"])
def test_the_loop_stands_a_gain_up_to_its_margin_and_none_beyond(end: str) -> None:
    margin = getattr(margins_of_the_model(), end)
    assert 1.0 / FACTOR < margin < FACTOR
    assert not lost(gain=margin**0.9)
    assert lost(gain=margin**1.15)


def test_the_loop_stands_a_delay_up_to_its_margin_and_none_beyond() -> None:
    periods = margins_of_the_model().delay_s / PERIOD
    assert not lost(delay=int(0.9 * periods))
    assert lost(delay=int(np.ceil(1.1 * periods)))


def test_the_loop_stands_friction_up_to_its_margin() -> None:
    margin, law = margins_of_the_model().friction_high, designed()[1]
    assert margin > 2.0
    assert not grows(law, with_friction(0.9 * margin))
