"""The controller as sequences of graphs, and compiled: one source for numba, C99, MATLAB and the FMU."""

import numpy as np

from ..codegen.graph import GraphSequence
from ..codegen.numba_writer import sequence_kernel
from ..numerics.arrays import FloatArray
from ..numerics.compiled import compiled
from ..numerics.fixed_step import AHEAD, SHARES
from . import estimator, feedback
from .estimator import ESTIMATED, graph_of
from .law import CONTROLLER_STATE, NUMBERS, Law

_STAGES = tuple(f"k{i + 1}" for i in range(len(SHARES)))
_NEXT = {0.5: "halfway", 1.0: "ahead"}
"""Graph that leads to the next stage, by the part of the period before it."""
GRAPHS = {
    "begin": graph_of(estimator.begin),
    "listen": graph_of(estimator.listen),
    "decide": graph_of(feedback.decide),
    "lag": graph_of(estimator.lag),
    "spread": graph_of(estimator.spread),
    "rates": graph_of(estimator.rates),
    **{name: graph_of(estimator.ahead(part)) for part, name in _NEXT.items()},
    "finish": graph_of(estimator.finish),
    "check": graph_of(estimator.check),
    "heed": graph_of(estimator.heed),
    "known_state": graph_of(estimator.known_state),
}
"""Graphs of the controller."""

OFFSET = NUMBERS.index("offset")
"""Place of the laser's offset among the numbers of a law."""
TABLES = ("prepared", "slopes", "curves", "rests", "targets", "braking")
"""Arrays of a law beside its numbers `e`."""
_MOVE = (
    ("rates", {"y": "s", "dx": _STAGES[0]}),
    *(
        step
        for before, after, part in zip(_STAGES[:-1], _STAGES[1:], AHEAD[:-1], strict=True)
        for step in ((_NEXT[part], {"dx": before}), ("rates", {"dx": after}))
    ),
    ("finish", dict[str, str]()),
)
"""One step of classical Runge-Kutta; the state begins with x."""
BEGIN = GraphSequence(GRAPHS, (("begin", {}),), ("s", "signals", "e", "rests"))
MOVE = GraphSequence(GRAPHS, (("lag", {}), *_MOVE), ("s", "v", "e", "prepared", "curves"))
CONTROL = GraphSequence(
    GRAPHS,
    (("listen", {}), ("decide", {}), ("lag", {}), ("spread", {}), *_MOVE, ("check", {})),
    ("s", "signals", "v", "e", *TABLES),
)
OBSERVE = GraphSequence(
    GRAPHS,
    (("heed", {}), ("listen", {}), ("lag", {}), ("spread", {}), *_MOVE, ("check", {})),
    ("s", "signals", "v", "e", *TABLES[:4]),
)
ESTIMATE = GraphSequence(GRAPHS, (("known_state", {}),), ("s", "estimate", "e"))

_begin = sequence_kernel(BEGIN)
_move = sequence_kernel(MOVE)
_control = sequence_kernel(CONTROL)
_observe = sequence_kernel(OBSERVE)
_estimate = sequence_kernel(ESTIMATE)


@compiled
def begin_control(reading: float, law: Law, s: FloatArray) -> None:
    """Fill the controller's state, shape (CONTROLLER_STATE,), from the first reading [m], all voltages being zero."""
    _begin((s, np.array((reading, 0.0)), law.numbers, law.rests))


@compiled
def control(s: FloatArray, reading: float, target: float, law: Law, v: FloatArray) -> None:
    """One period: correct the estimate, fill the voltages `v`, shape (2,) [V], predict; `s` is the controller's state.

    Whatever reading and target are, the voltages lie within 0 … the largest. Without a reading they go to zero in
    `estimator.RAMP` periods. The estimate begins anew when readings come back. Cost: the same in every state, 3 µs.

    Parameters
    ----------
    s : FloatArray, shape (CONTROLLER_STATE,)
        The controller's state; moved on.
    reading : float
        Of the laser [m].
    target : float
        Target [m].
    law : Law
        The controller.
    v : FloatArray, shape (2,)
        Filled: voltages of left and right [V].
    """
    signals = np.array((reading, target))
    _control((s, signals, v, law.numbers, law.prepared, law.slopes, law.curves, law.rests, law.targets, law.braking))


@compiled
def observe(s: FloatArray, reading: float, v: FloatArray, law: Law) -> None:
    """One period of the estimator alone, where others command: `v`, shape (2,) [V], acts until the next reading.

    A voltage that is not a number is read as 0 V; all are limited to 0 … the largest. Cost: 3 µs.

    Parameters
    ----------
    s : FloatArray, shape (CONTROLLER_STATE,)
        The estimator's state; moved on.
    reading : float
        Of the laser [m].
    v : FloatArray, shape (2,)
        Voltages of left and right [V].
    law : Law
        The controller.
    """
    signals = np.array((reading, np.nan))
    _observe((s, signals, v.copy(), law.numbers, law.prepared, law.slopes, law.curves, law.rests))


@compiled
def estimate(s: FloatArray, law: Law) -> FloatArray:
    """Estimate for the time of the next reading, shape (estimator.ESTIMATED,).

    First the joint's state: the laser's reading [m] and its rate [m/s], slope and interior shape [1] with their rates
    [1/s], Maxwell strains [1] and creep [m]. Then stop operators [1], voltages behind the converters [V], the moment on
    the slope that the model does not explain [N·m], and the place of the status in `estimator.STATUS`.
    """
    estimated = np.empty(ESTIMATED)
    _estimate((s, estimated, law.numbers))
    return estimated


@compiled
def move(s: FloatArray, v: FloatArray, law: Law) -> None:
    """Move a joint over one period under the commands `v`, shape (2,) [V]; `s` as of a controller. Cost: 0.7 µs."""
    _move((s, v, law.numbers, law.prepared, law.curves))


def closed_on_model(law: Law, joint: Law, start: float, target: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Run a controller on a joint of the model's class from rest.

    Parameters
    ----------
    law : Law
        The controller.
    joint : Law
        Of the joint that is controlled; it need not be the one that the controller was designed for.
    start : float
        First reading [m].
    target : FloatArray, shape (N,)
        Targets [m], one in each period.

    Returns
    -------
    q : FloatArray, shape (N,)
        Readings [m].
    v : FloatArray, shape (N, 2)
        Commands [V].
    """
    s = np.zeros(CONTROLLER_STATE)
    plant = np.zeros(CONTROLLER_STATE)
    begin_control(start, joint, plant)
    begin_control(start, law, s)
    return go_on(law, s, joint, plant, target)


def go_on(law: Law, s: FloatArray, joint: Law, plant: FloatArray, target: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Go on with a closed loop as `closed_on_model` returns it.

    Parameters
    ----------
    law : Law
        The controller.
    s : FloatArray, shape (CONTROLLER_STATE,)
        The controller's state; moved on.
    joint : Law
        Of the joint that is controlled.
    plant : FloatArray, shape (CONTROLLER_STATE,)
        The joint's state; moved on.
    target : FloatArray, shape (N,)
        Targets [m], one in each period.
    """
    q = np.empty(target.size)
    v = np.empty((target.size, 2))
    for i in range(target.size):
        q[i] = plant[0] + joint.numbers[OFFSET]
        control(s, q[i], target[i], law, v[i])
        move(plant, v[i], joint)
    return q, v
