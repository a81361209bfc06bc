"""A run of the condensed joint and its derivatives by the estimated numbers: exactly those of its Runge-Kutta steps.

The run leaves its states at all stages. Then the columns, the derivatives by each number, move side by side through the
same steps (`pipeline.models.hybrid.variational`). They are by the kernel's constants, not θ, which acts through them.
"""

import numpy as np

from ...fitting.descent import PARAMETER_STEP
from ...generated.condensed_joint import STATES, STOPS
from ...numerics.arrays import FloatArray, IntArray, SingleArray
from ...numerics.fixed_step import workspace
from .kernels import COLUMNS, CURVES, STEP_STAGES, VALUES, prepare
from .runs import JointCoefficients, Joints, Stepping, integrate_joints
from .statics import rest_at_reading
from .variational import INSTRUMENTS, Driven, columns_of, propagate

_SHIFT = 1e-8
"""Step of the differences by which the state at rest depends on the place [m]."""


def sensitivities(
    coefficients: JointCoefficients,
    scale: FloatArray,
    widths: FloatArray,
    offset: float,
    driven: Driven,
    stepping: Stepping,
) -> tuple[FloatArray, FloatArray, FloatArray]:
    """The run of one joint from rest, as in `run_joints`, and its derivatives.

    Parameters
    ----------
    coefficients : JointCoefficients
        Of one joint: constants (len(CONSTANTS),), weights (9, M).
    scale : FloatArray, shape (len(CONSTANTS),)
        By how much each constant may change; zero for those whose derivatives are not asked.
    widths : FloatArray, shape (9,)
        The same of the weights.
    offset : float
        Of the laser [m]: reading = q + offset.
    driven : Driven
        Voltages and observer.
    stepping : Stepping
        As in `run_joints`.

    Returns
    -------
    q : FloatArray, shape (N,)
        Reading [m] at the samples without the laser's offset.
    columns : FloatArray, shape (N, C + 5)
        Its derivatives by the constants that have a scale, then by laser offset [1], and by delay, charging time and
        probes in units of θ.
    by_weights : FloatArray, shape (N, 9, M)
        Its derivatives by the weights of the corrections.

    Notes
    -----
    Cost: 1.4 µs a stage for 104 constants, 2.3 with corrections; 37.5 s at two steps in 10 ms take 43 and 70 ms.
    """
    k, weights, basis = coefficients
    dt, substeps, wall, lead, reading = stepping
    steps = (len(driven.squares) - 1) // 2
    active = np.flatnonzero(scale)
    x, z, starts, stops = _starts(coefficients, scale, active, widths, offset, driven, stepping)
    points = np.empty((steps + 1, STEP_STAGES, STATES))
    slips = np.empty((steps + 1, STOPS))
    system = Joints(
        slots=(0,),
        p=prepare(k[None])[0],
        c=np.zeros(VALUES),
        own=np.zeros(VALUES),
        z=z,
        start=np.zeros(3),
        u=np.zeros(2),
        now=np.zeros(3),
        squares=driven.squares[None],
        variant=np.zeros(1, dtype=np.int64),
        basis=basis,
        weights=weights[None],
        offset=np.array([offset]),
        observed=driven.observed,
        pole=driven.pole,
        wall=wall,
        lead=lead,
        reading=reading,
        points=points,
        slips=slips,
    )
    integrate_joints(system, x, np.empty((steps + 1, 3, 1)), workspace(x), 1, dt / substeps, -np.inf, np.inf)
    displacements = np.empty((steps // substeps + 1, len(starts) * COLUMNS))
    propagate((points, slips), driven, coefficients, stepping, columns_of(active), starts, stops, displacements)
    first = len(active) + INSTRUMENTS
    count = weights.shape[1]
    by_weights = displacements[:, first : first + CURVES * count].reshape(len(displacements), CURVES, count)
    q = reading[0] * points[::substeps, 0, 0] + reading[1] * points[::substeps, 0, 2]
    return q, displacements[:, :first], by_weights


def _starts(
    coefficients: JointCoefficients,
    scale: FloatArray,
    active: IntArray,
    widths: FloatArray,
    offset: float,
    driven: Driven,
    stepping: Stepping,
) -> tuple[FloatArray, FloatArray, SingleArray, SingleArray]:
    """State and stop operators at rest, and the columns' derivatives of them, (blocks, rows, COLUMNS)."""
    k, weights, basis = coefficients
    start = driven.start
    u = driven.squares[0]
    by_instruments = driven.by_instruments[:, 0]
    q = start[0] - offset
    first = len(active) + INSTRUMENTS
    blocks = -(-(first + weights.size) // COLUMNS)
    starts, stops = (np.zeros((blocks, rows, COLUMNS), dtype=np.float32) for rows in (STATES, STOPS))
    x, z = rest_at_reading(q, stepping.reading, u, k, prepare(k[None])[0], basis, weights, start[2])
    steps = np.concatenate(
        [
            PARAMETER_STEP * scale[active],
            [-_SHIFT],
            1e-6 * max(float(u.max()), 1.0) / np.maximum(np.abs(by_instruments).max(axis=1), 1e-12),
            PARAMETER_STEP * np.repeat(widths, weights.shape[1]),
        ]
    )
    # Displacement [m], squared voltages [V²], constants and weights of a joint at rest, each column moved by its step
    moved = [
        *((q, u, k + step * unit, weights) for step, unit in zip(steps, np.eye(len(k))[active], strict=False)),
        (q + _SHIFT, u, k, weights),
        *((q, u + step * by, k, weights) for step, by in zip(steps[len(active) + 1 :], by_instruments, strict=False)),
        *(
            (q, u, k, weights + step * unit.reshape(weights.shape))
            for step, unit in zip(steps[first:], np.eye(weights.size), strict=True)
        ),
    ]
    for column, (step, (place, voltages, constants, changed)) in enumerate(zip(steps, moved, strict=True)):
        there, slipped = rest_at_reading(
            place, stepping.reading, voltages, constants, prepare(constants[None])[0], basis, changed, start[2]
        )
        starts[column // COLUMNS, :, column % COLUMNS] = (there - x) / step
        stops[column // COLUMNS, :, column % COLUMNS] = (slipped - z) / step
    x[1] = start[1]
    x[3] = stepping.reading[1] * stepping.lead**2 * start[1]
    return x, z, starts, stops
