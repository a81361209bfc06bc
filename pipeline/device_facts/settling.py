"""Where a model ends from many states, let go without any input: the hybrid joint eight at a time."""

import numpy as np

from pipeline.joint.condensed_runs import run_joints
from pipeline.models.base import Model
from pipeline.models.hybrid import HybridModel
from pipeline.numerics.arrays import FloatArray


def settled(model: Model, starts: FloatArray, seconds: float, step: float, inputs: int) -> FloatArray:
    """Displacement after a free run without input.

    Parameters
    ----------
    model : Model
        Any; of the hybrid joint eight runs go at once.
    starts : FloatArray, shape (n, 2)
        Displacement [m or rad] and its rate of each run.
    seconds, step : float
        Length of the runs and sample interval [s].
    inputs : int
        Number of the model's inputs.

    Returns
    -------
    FloatArray, shape (n,)
        NaN where the run diverged.

    Notes
    -----
    Cost of the hybrid joint: 0.2 ms for a run of 2.5 s; of other models as many free runs.
    """
    t = np.arange(0.0, seconds, step)
    if isinstance(model, HybridModel):
        return _settled_joint(model, starts, len(t), step)
    v = np.zeros((len(t), inputs))
    runs = (model.simulate(t, v, float(q), float(rate)) for q, rate in starts)
    return np.array([run.q[-1] if run.status == "ok" else np.nan for run in runs])


def _settled_joint(model: HybridModel, starts: FloatArray, samples: int, step: float) -> FloatArray:
    body, seen = model.body, model.body.instruments(model.theta)
    constants, count = body.constants(model.theta), len(starts)
    steps = body.substeps(model.theta, step)
    # Probes have an offset, so that no measured voltage is not no voltage.
    u = np.tile(np.asarray(seen.probe, dtype=np.float64) ** 2, (1, 2 * steps * (samples - 1) + 1, 1))
    runs = run_joints(
        np.tile(constants, (count, 1)),
        np.tile(body.weights(model.theta), (count, 1, 1)),
        body.basis,
        u,
        np.zeros(count, dtype=np.int64),
        np.tile([seen.gain, seen.offset], (count, 1)),
        starts,
        np.zeros(0),
        np.zeros(samples),
        step,
        steps,
        body.q_stop,
        body.lead,
    )
    return np.asarray(runs[:, -1, 0])
