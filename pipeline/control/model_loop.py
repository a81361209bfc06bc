"""The controller on the identified joint itself: what the design predicts of a closed loop, before any real joint."""

import numpy as np

from pipeline.compiled import compiled
from pipeline.control.law import CONTROLLER_STATE, Law, begin_control, control
from pipeline.control.observer import Observer, estimate_from_rest, predict
from pipeline.generated.condensed_joint import STATES, STOPS
from pipeline.numerics.arrays import FloatArray


@compiled
def closed_on_model(law: Law, joint: Observer, start: float, target: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Run a controller on a joint of the model's class from rest.

    Parameters
    ----------
    law : Law
        The controller.
    joint : Observer
        Constants of the joint that is controlled; it need not be the one that the controller was designed for.
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

    Notes
    -----
    Cost: 10 µs a period.
    """
    s, x, z, d = np.zeros(CONTROLLER_STATE), np.zeros(STATES), np.zeros(STOPS), np.zeros(1)
    volts, q, v = np.zeros(2), np.empty(target.size), np.empty((target.size, 2))
    estimate_from_rest(start, joint, x, z, d)
    begin_control(start, law, s)
    for i in range(target.size):
        q[i] = joint.gain * x[0] + joint.offset
        control(s, q[i], target[i], law, v[i])
        predict(x, z, d, volts, v[i], joint)
    return q, v
