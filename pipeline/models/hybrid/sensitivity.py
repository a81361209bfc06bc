"""Derivatives of a run of the condensed joint by the estimated numbers: exactly those of its Runge-Kutta steps.

The run leaves its states at all stages. Then the columns, the derivatives by each number, move side by side through the
same steps. They are by the kernel's constants, not θ, which acts through them. A column δx moves with the rates' own
derivatives:

    δẋ = ∂f/∂x δx + ∂f/∂z δz + ∂f/∂(the number by which the column is the derivative),

z being the stop operators, which follow the play or stick. The rates' derivatives come from the generated graphs
(`pipeline.generated.condensed_joint_jacobian`), for the eight stages of two steps side by side.

Columns are in single precision, right to 1e-5 of a column's size (the worst to 1e-3) in two thirds of the time. A step
of least squares needs no more digits: a run in double precision judges its result.
"""

from typing import NamedTuple

import numpy as np

from ...codegen.numba_writer import formula, kernel
from ...fitting.descent import PARAMETER_STEP
from ...generated.condensed_joint import CONSTANTS, FIRST_STRAIN, STATES, STOP_DIRECTIONS, STOP_ELEMENTS, STOPS
from ...generated.condensed_joint_jacobian import BY_CONSTANTS, JACOBIAN, PREPARE
from ...generated.terms import BELL_SHAPE, STOP_OPERATOR
from ...numerics.arrays import FloatArray, IntArray, SingleArray
from ...numerics.compiled import compiled, inner
from ...numerics.fixed_step import STAGE_NODES, workspace
from .kernels import (
    COLUMNS,
    CURVED,
    CURVES,
    ENTRIES,
    INDEX,
    PLAY_WEIGHTS,
    SLOTS,
    STAGES,
    STEP_SLOTS,
    STEP_STAGES,
    VALUES,
    move_columns,
    prepare,
)
from .runs import JointCoefficients, Joints, Stepping, integrate_joints, observer
from .statics import rest_at_reading

INSTRUMENTS = 5
"""Columns of laser offset, delay, charging time and the two probes."""
_CONSTANTS = len(CONSTANTS)
_ROW = SLOTS * COLUMNS
_BLOCK = ENTRIES * _ROW
"""Numbers that act on a block of columns: row by row, in each slot, on each column."""
_ELEMENTS = max(STOP_ELEMENTS) + 1
_ELEMENT = np.array(STOP_ELEMENTS)
_DIRECTION = np.array(STOP_DIRECTIONS)
_TRAVEL = INDEX["stop_travel_0"]
_ARM = INDEX["friction_arm"]
_LENGTH = INDEX["l"]
_PLACE = 2**31 - 1
"""Mask of a place in an array, from which the compiler sees that it is not negative."""


_bell = formula(BELL_SHAPE)
_stop = formula(STOP_OPERATOR)
_prepare = kernel(PREPARE)
_PREPARED = PREPARE.outputs["p"]
_jacobian = kernel(JACOBIAN, STAGES, single=True)
_by_constants = kernel(BY_CONSTANTS, STAGES, single=True)
_BY_CONSTANTS = np.array(
    [
        divmod(operation.place[1], _CONSTANTS)
        for operation in BY_CONSTANTS.operations
        if operation.name == "store" and operation.place[1] < STATES * _CONSTANTS
    ]
)
"""Rows and constants of ∂f/∂k that are not zero."""


_SHIFT = 1e-8
"""Step of the differences by which the state at rest depends on the place [m]."""


Columns = tuple[IntArray, IntArray, IntArray, IntArray, int]
"""Places of the numbers that act on columns.

Entries of ∂f/∂k in the kernel's output, and their places; places (elements + 2,) where travels, the friction's arm and
the beam's length act on stop operators, −1 for constants without a column; those of the instruments (INSTRUMENTS,); and
the first column of the weights."""


def columns_of(active: IntArray) -> Columns:
    """The columns of the `active` constants, then of the instruments, then of the weights."""
    places = np.arange(len(active) + INSTRUMENTS)
    places = places // COLUMNS * _BLOCK + places % COLUMNS
    of_constant = np.full(_CONSTANTS, -1)
    of_constant[active] = places[: len(active)]
    row, constant = _BY_CONSTANTS[of_constant[_BY_CONSTANTS[:, 1]] >= 0].T
    stops = of_constant[[*range(_TRAVEL, _TRAVEL + _ELEMENTS), _ARM, _LENGTH]]
    return (
        (row * _CONSTANTS + constant) * STAGES,
        of_constant[constant] + row * _ROW,
        np.where(stops >= 0, stops + STATES * _ROW, -1),
        places[len(active) :],
        len(places),
    )


class Driven(NamedTuple):
    """Voltages and observer of one joint along a log.

    Attributes
    ----------
    squares : FloatArray, shape (H, 2)
        Squared voltages [V²] on the half steps.
    by_instruments : FloatArray, shape (4, H, 2)
        Their derivatives by delay, charging time and probes, in units of θ.
    observed, pole : FloatArray, shape (H,) or (0,)
        As in `pipeline.models.hybrid.runs.Joints`.
    start : FloatArray, shape (3,)
        Reading [m] and its rate [m/s] at the first sample, and the time [s] since the recording began.
    """

    squares: FloatArray
    by_instruments: FloatArray
    observed: FloatArray
    pole: FloatArray
    start: FloatArray


@compiled
def propagate(
    run: tuple[FloatArray, FloatArray],
    driven: Driven,
    coefficients: JointCoefficients,
    stepping: Stepping,
    columns: Columns,
    starts: SingleArray,
    stops: SingleArray,
    displacements: FloatArray,
) -> None:
    """Derivatives of the reading at the samples by all columns, `displacements` (N, columns), from those at the start.

    Parameters
    ----------
    run : (FloatArray, FloatArray), shapes (steps + 1, 4, STATES) and (steps + 1, STOPS)
        The run about which columns are linear: states at all stages, and stop operators at the start of each step.
    driven : Driven
        What drives it.
    coefficients : JointCoefficients
        Constants and corrections of the joint.
    stepping : Stepping
        As in the run.
    columns : Columns
        Places of the numbers that act.
    starts, stops : SingleArray, shapes (blocks, STATES, COLUMNS) and (blocks, STOPS, COLUMNS)
        Derivatives of the first state and of the first stop operators; those at the end (output).
    displacements : FloatArray, shape (N, blocks · COLUMNS)
        Derivatives of the reading at the samples (output).
    """
    sources, targets, own, instruments, corrected = columns
    points, _ = run
    squares, by_instruments, _, pole, _ = driven
    k, weights, basis = coefficients
    dt, substeps, _, lead, reading = stepping
    steps = len(points) - 1
    centres = weights.shape[1]
    prepared = np.empty(_PREPARED)
    x = _zeros(STATES * STAGES)
    u = _zeros(2 * STAGES)
    z = _zeros(STOPS * STAGES)
    c = _zeros(VALUES * STAGES)
    c_q = _zeros(VALUES * STAGES)
    f = _zeros(ENTRIES * STAGES)
    a = _zeros(ENTRIES * ENTRIES * STAGES)
    b = _zeros(ENTRIES * 2 * STAGES)
    by_c = _zeros(ENTRIES * VALUES * STAGES)
    by_k = _zeros(ENTRIES * _CONSTANTS * STAGES)
    _prepare((k, prepared))
    p = _zeros(_PREPARED * STAGES)
    w = np.zeros((2, PLAY_WEIGHTS), np.float32)
    drive = _zeros(len(starts) * _BLOCK)
    for i in range(_PREPARED * STAGES):
        p[i] = prepared[i // STAGES]
    bells = np.zeros((STAGES, 2, max(centres, 1)))
    w[:, 0], w[:, 1], w[:, 2] = k[_ARM], dt / substeps, k[_LENGTH]
    for column in range(displacements.shape[1]):
        of_column = starts[column // COLUMNS, :, column % COLUMNS]
        displacements[0, column] = reading[0] * of_column[0] + reading[1] * of_column[2]
    for first in range(0, steps, 2):
        for slot in range(SLOTS):
            _act_by_play(run, first, slot, k, z, w, drive, own)
        for stage_lane in range(STAGES):
            step = min(first + stage_lane // STEP_STAGES, steps - 1)
            stage = stage_lane % STEP_STAGES
            for i in range(STATES):
                x[i * STAGES + stage_lane] = points[step, stage, i]
            for i in range(2):
                u[i * STAGES + stage_lane] = squares[2 * step + STAGE_NODES[stage], i]
            if centres > 0:
                _corrections(points[step, stage, 0], basis, weights, stage_lane, c, c_q, bells)
        _jacobian((x, u, c, z, c_q, p, f, a, b, by_c))
        _by_constants((x, u, c, z, p, by_k))
        for i in range(len(sources)):
            source = sources[i] & _PLACE
            target = targets[i] & _PLACE
            for stage_lane in range(STAGES):
                drive[target + (stage_lane + stage_lane // STEP_STAGES) * COLUMNS] = by_k[source + stage_lane]
        for stage_lane in range(STAGES):
            step = min(first + stage_lane // STEP_STAGES, steps - 1)
            stage = stage_lane % STEP_STAGES
            pull = observer(-1.0, pole[2 * step] if len(pole) > 0 else 0.0, lead)
            node = 2 * step + STAGE_NODES[stage]
            _act_by_instruments(by_instruments[:, node], pull, reading, stage_lane, instruments, a, b, drive)
            if centres > 0:
                _act_by_weights(bells, by_c, stage_lane, centres, corrected, drive)
        _advance((first, min(first + 2, steps)), points, stepping, (a, w, drive), (starts, stops, displacements))


@inner
def _zeros(count: int) -> SingleArray:
    return np.zeros(count, dtype=np.float32)


@compiled(inline="always")
def _advance(
    between: tuple[int, int],
    points: FloatArray,
    stepping: Stepping,
    acting: tuple[SingleArray, SingleArray, SingleArray],
    moving: tuple[SingleArray, SingleArray, FloatArray],
) -> None:
    """All columns from one step to another, at most two later; starts and stops move, displacements are filled."""
    first, stop = between
    a, w, drive = acting
    starts, stops, displacements = moving
    by_q, by_tau = stepping.reading
    for step in range(first, stop):
        of_step = a[STEP_STAGES * (step - first) :]
        weights = w[step - first]
        confined = abs(points[step + 1, 0, 0]) >= stepping.wall
        for block in range(len(starts)):
            here = starts[block].ravel()
            slip = stops[block].ravel()
            at = block * _BLOCK + STEP_SLOTS * COLUMNS * (step - first)
            move_columns((of_step, weights, here, slip, drive[at:], here, slip))
            if confined:
                here[: 2 * COLUMNS] = 0.0
            if (step + 1) % stepping.substeps == 0:
                for column_lane in range(COLUMNS):
                    displacements[(step + 1) // stepping.substeps, block * COLUMNS + column_lane] = (
                        by_q * here[column_lane] + by_tau * here[2 * COLUMNS + column_lane]
                    )


@compiled(inline="always")
def _act_by_play(
    run: tuple[FloatArray, FloatArray],
    first: int,
    slot: int,
    k: FloatArray,
    z: SingleArray,
    w: SingleArray,
    drive: SingleArray,
    own: IntArray,
) -> None:
    """Weights of a slot, its stop operators, and how travels, arm and length act on these themselves."""
    points, slips = run
    half = slot // STEP_SLOTS
    stage = slot % STEP_SLOTS
    step = min(first + half, len(points) - 2)
    at = (step, stage) if stage < STEP_STAGES else (step + 1, 0)
    moved = points[at[0], at[1], 0] - points[step, 0, 0]
    turned = points[at[0], at[1], 2] - points[step, 0, 2]
    bowed = points[at[0], at[1], 4] - points[step, 0, 4]
    for i in range(STOPS):
        place = 3 + 2 * STOPS * stage + i
        element = _ELEMENT[i]
        by_arm = _DIRECTION[i, 1] * turned
        by_length = _DIRECTION[i, 2] * turned + _DIRECTION[i, 3] * bowed
        play = _DIRECTION[i, 0] * moved + k[_ARM] * by_arm + k[_LENGTH] * by_length
        share, follows, by_play, by_travel = _stop((slips[step, i], play, k[_TRAVEL + element]))
        if stage < STEP_STAGES:
            z[i * STAGES + STEP_STAGES * half + stage] = share
        w[half, place], w[half, place + STOPS] = follows, by_play
        at_stop = i * _ROW + slot * COLUMNS
        if own[_ELEMENTS] >= 0:
            drive[own[_ELEMENTS] + at_stop] = by_arm * by_play
        if own[_ELEMENTS + 1] >= 0:
            drive[own[_ELEMENTS + 1] + at_stop] = by_length * by_play
        if own[element] >= 0:
            drive[own[element] + at_stop] = by_travel


@compiled(inline="always")
def _corrections(
    q: float,
    basis: FloatArray,
    weights: FloatArray,
    stage_lane: int,
    c: SingleArray,
    c_q: SingleArray,
    bells: FloatArray,
) -> None:
    """The corrections at q, their slopes along q, and the bells with theirs, `bells` (STAGES, 2, M)."""
    for i in range(VALUES):
        c[i * STAGES + stage_lane] = c_q[i * STAGES + stage_lane] = 0.0
    for j in range(weights.shape[1]):
        bell, slope, bend = _bell((q, basis[0] + j * basis[1], basis[1], basis[2]))
        bells[stage_lane, 0, j], bells[stage_lane, 1, j] = bell, slope
        for i in range(CURVES):
            c[i * STAGES + stage_lane] += weights[i, j] * bell
            c_q[i * STAGES + stage_lane] += weights[i, j] * slope
        for i in range(VALUES - CURVES):
            c[(CURVES + i) * STAGES + stage_lane] += weights[CURVED.start + i, j] * slope
            c_q[(CURVES + i) * STAGES + stage_lane] += weights[CURVED.start + i, j] * bend


@compiled(inline="always")
def _act_by_instruments(
    inputs: FloatArray,
    pull: tuple[float, float, float, float],
    reading: tuple[float, float],
    stage_lane: int,
    places: IntArray,
    a: SingleArray,
    b: SingleArray,
    drive: SingleArray,
) -> None:
    """Add the observer's terms to ∂f/∂x, and the derivatives of the rates by the instruments.

    `inputs` (4, 2) are those of the squared voltages; `pull` is the observer's, on each rate for 1 m of the `reading`.
    """
    q, speed, tau, turning = pull
    for state, share in ((0, reading[0]), (2, reading[1])):
        at = state * STAGES + stage_lane
        a[at], a[2 * ENTRIES * STAGES + at] = share * q, share * tau
        a[ENTRIES * STAGES + at] += share * speed
        a[3 * ENTRIES * STAGES + at] += share * turning
    for i in range(INSTRUMENTS):
        at = places[i] + (stage_lane + stage_lane // STEP_STAGES) * COLUMNS
        if i == 0:
            drive[at], drive[at + _ROW] = q, speed
            drive[at + 2 * _ROW], drive[at + 3 * _ROW] = tau, turning
        else:
            left = inputs[i - 1, 0]
            right = inputs[i - 1, 1]
            for row in range(FIRST_STRAIN):
                drive[at + row * _ROW] = (
                    left * b[2 * row * STAGES + stage_lane] + right * b[(2 * row + 1) * STAGES + stage_lane]
                )


@compiled(inline="always")
def _act_by_weights(
    bells: FloatArray, by_c: SingleArray, stage_lane: int, centres: int, first: int, drive: SingleArray
) -> None:
    """Derivatives of the accelerations by the weights of the corrections."""
    for curve in range(CURVES):
        for row in range(1, FIRST_STRAIN, 2):
            value = by_c[(row * VALUES + curve) * STAGES + stage_lane]
            slope = 0.0
            if CURVED.start <= curve < CURVED.stop:
                slope = by_c[(row * VALUES + CURVES + curve - CURVED.start) * STAGES + stage_lane]
            for j in range(centres):
                column = first + curve * centres + j
                at = (
                    column // COLUMNS * _BLOCK
                    + column % COLUMNS
                    + row * _ROW
                    + (stage_lane + stage_lane // STEP_STAGES) * COLUMNS
                )
                drive[at] = value * bells[stage_lane, 0, j] + slope * bells[stage_lane, 1, j]


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
        Its derivatives by the constants, of which those without a scale are left out, then by laser offset [1], and by
        delay, charging time and probes in units of θ.
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
