"""The lowest peak voltage with which any controller could switch a joint: the best programme of both voltages.

The squared voltages act linearly, so the best ones are zero or the largest at almost every instant. A programme holds
both of them, as shares of the largest square, in cells of 20 ms over 1.6 s, the last of which may push on as long as
they like. It is improved along the gradient of the furthest displacement in the last 0.3 s, cells with the largest
gradient first, from swings of several lengths; no other structure is prescribed. A share of the voltage is reached
where the joint ends beyond half of the way from the saddle to the other well. The state is known, nothing is
estimated, and the voltages see the same lag as a controller's.
"""

from collections.abc import Callable, Iterator

import numpy as np

from pipeline.numerics.arrays import FloatArray

CELL, COUNT = 0.02, 80  # s, cells of a programme
LATE = 0.3  # s, the end in which the furthest displacement counts
NUDGE = 0.15  # of a share, for the gradient
Furthest = Callable[[FloatArray], FloatArray]
"""Furthest displacement towards the other well [m], shape (P,), under commands (P, M, 2) [V]."""


def commands(programmes: FloatArray, side: int, volts: float) -> FloatArray:
    """Commands (P, M, 2) [V] at 1 kHz of programmes (P, COUNT, 2): shares towards the other well, and away from it."""
    shares = np.repeat(programmes, round(1e3 * CELL), axis=1)
    return volts * np.sqrt(shares if side == 0 else shares[..., ::-1])


def swings(length: float, last: float) -> FloatArray:
    """Pushes to and fro of `length` [s] and a last push towards the other well of `last` [s], shape (COUNT, 2)."""
    left = CELL * (COUNT - np.arange(COUNT)) - last
    towards = (left < 1e-9) | (np.floor(left / length) % 2 == 1)
    return np.column_stack([towards, ~towards]).astype(np.float64)


def improved(
    furthest: Furthest, side: int, volts: float, programme: FloatArray, goal: float
) -> tuple[float, FloatArray]:
    """The furthest displacement [m] and the programme after at most 15 steps along the gradient; it ends at `goal`."""
    size = programme.size
    best = float(furthest(commands(programme[None], side, volts))[0])
    for _ in range(15):
        if best > goal:
            break
        nudge = np.where(programme < 0.5, NUDGE, -NUDGE)
        tried = programme + (np.eye(size) * nudge.ravel()).reshape(size, *programme.shape)
        gradient = ((furthest(commands(tried, side, volts)) - best) / nudge.ravel()).reshape(programme.shape)
        bang = (gradient > 0.0).astype(np.float64)
        gain = np.abs(gradient * (bang - programme))
        order = np.sort(gain.ravel())[::-1]
        steps = [programme + share * (bang - programme) for share in (1.0, 0.3, 0.1, 0.03)]
        steps += [np.where(gain >= max(order[int(size * part)], 1e-12), bang, programme) for part in _PARTS]
        reached = furthest(commands(np.array(steps), side, volts))
        if reached.max() < best + 1e-6:
            break
        best, programme = float(reached.max()), steps[int(np.argmax(reached))]
    return best, programme


_PARTS = (0.01, 0.02, 0.05, 0.1, 0.2, 0.4)


def lowest_programmes(
    furthest: Furthest, side: int, static: float, goal: float, first: float
) -> Iterator[tuple[float, FloatArray]]:
    """Shares of `static` [V] and programmes that pass `goal` [m], by 1 % from `first` down, or up if need be."""
    programme: FloatArray | None = None
    share = first
    while 0.4 < share < 1.1:
        begun = [swings(a, b) for a in (0.15, 0.19) for b in (0.26, 0.44)] if programme is None else [programme]
        best, found = max((improved(furthest, side, share * static, one, goal) for one in begun), key=lambda x: x[0])
        if best > goal:
            programme = found
            yield share, found
            share -= 0.01
        elif programme is None:
            share += 0.02
        else:
            return
