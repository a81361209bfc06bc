"""The variational equations of a run of the condensed joint: columns that move along with its Runge-Kutta steps.

A column δx is the derivative of the state by one of the kernel's constants. It moves with the rates' own derivatives:

    δẋ = ∂f/∂x δx + ∂f/∂z δz + ∂f/∂(the number by which the column is the derivative),

z being the stop operators, which follow the play or stick. The rates' derivatives come from the generated graphs
(`pipeline.generated.condensed_joint_jacobian`), for the eight stages of two steps side by side.

Columns are in single precision, right to 1e-5 of a column's size (the worst to 1e-3) in two thirds of the time. A step
of least squares needs no more digits: a run in double precision judges its result.
"""

from typing import NamedTuple

import numpy as np

from ...codegen.numba_writer import formula, kernel
from ...generated.condensed_joint import CONSTANTS, FIRST_STRAIN, STATES, STOP_DIRECTIONS, STOP_ELEMENTS, STOPS
from ...generated.condensed_joint_jacobian import BY_CONSTANTS, JACOBIAN, PREPARE
from ...generated.terms import BELL_SHAPE, STOP_OPERATOR
from ...numerics.arrays import FloatArray, IntArray, SingleArray
from ...numerics.compiled import compiled, inner
from ...numerics.fixed_step import STAGE_NODES
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
)
from .runs import JointCoefficients, Stepping, observer

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
_PREPARED = PREPARE.outputs["p"]
_PLACE = 2**31 - 1
"""Mask of a place in an array, from which the compiler sees that it is not negative."""

_BY_CONSTANTS = np.array(
    [
        divmod(operation.place[1], _CONSTANTS)
        for operation in BY_CONSTANTS.operations
        if operation.name == "store" and operation.place[1] < STATES * _CONSTANTS
    ]
)
"""Rows and constants of ∂f/∂k that are not zero."""

_bell = formula(BELL_SHAPE)
_stop = formula(STOP_OPERATOR)
_prepare = kernel(PREPARE)
_jacobian = kernel(JACOBIAN, STAGES, single=True)
_by_constants = kernel(BY_CONSTANTS, STAGES, single=True)


class Columns(NamedTuple):
    """Places of the numbers that act on columns.

    Attributes
    ----------
    sources, targets : IntArray, shape (n,)
        Entries of ∂f/∂k in the kernel's output, and their places.
    stops : IntArray, shape (elements + 2,)
        Places where travels, the friction's arm and the beam's length act on stop operators; −1 for constants without
        a column.
    instruments : IntArray, shape (INSTRUMENTS,)
        Places of the instruments.
    first_weight : int
        First column of the weights.
    """

    sources: IntArray
    targets: IntArray
    stops: IntArray
    instruments: IntArray
    first_weight: int


def columns_of(active: IntArray) -> Columns:
    """The columns of the `active` constants, then of the instruments, then of the weights."""
    places = np.arange(len(active) + INSTRUMENTS)
    places = places // COLUMNS * _BLOCK + places % COLUMNS
    of_constant = np.full(_CONSTANTS, -1)
    of_constant[active] = places[: len(active)]
    row, constant = _BY_CONSTANTS[of_constant[_BY_CONSTANTS[:, 1]] >= 0].T
    stops = of_constant[[*range(_TRAVEL, _TRAVEL + _ELEMENTS), _ARM, _LENGTH]]
    return Columns(
        sources=(row * _CONSTANTS + constant) * STAGES,
        targets=of_constant[constant] + row * _ROW,
        stops=np.where(stops >= 0, stops + STATES * _ROW, -1),
        instruments=places[len(active) :],
        first_weight=len(places),
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
    points, _ = run
    squares, by_instruments, _, pole, _ = driven
    constants, weights, basis = coefficients
    dt, substeps, _, lead, reading = stepping
    steps = len(points) - 1
    centres = weights.shape[1]
    prepared = np.empty(_PREPARED)
    states = _zeros(STATES * STAGES)
    voltages = _zeros(2 * STAGES)
    stop_shares = _zeros(STOPS * STAGES)
    corrections = _zeros(VALUES * STAGES)
    correction_slopes = _zeros(VALUES * STAGES)
    rates = _zeros(ENTRIES * STAGES)
    by_state = _zeros(ENTRIES * ENTRIES * STAGES)
    by_voltage = _zeros(ENTRIES * 2 * STAGES)
    by_correction = _zeros(ENTRIES * VALUES * STAGES)
    by_constant = _zeros(ENTRIES * _CONSTANTS * STAGES)
    _prepare((constants, prepared))
    prepared_lanes = _zeros(_PREPARED * STAGES)
    play_weights = np.zeros((2, PLAY_WEIGHTS), np.float32)
    drive = _zeros(len(starts) * _BLOCK)
    for i in range(_PREPARED * STAGES):
        prepared_lanes[i] = prepared[i // STAGES]
    bells = np.zeros((STAGES, 2, max(centres, 1)))
    play_weights[:, 0] = constants[_ARM]
    play_weights[:, 1] = dt / substeps
    play_weights[:, 2] = constants[_LENGTH]
    for column in range(displacements.shape[1]):
        of_column = starts[column // COLUMNS, :, column % COLUMNS]
        displacements[0, column] = reading[0] * of_column[0] + reading[1] * of_column[2]
    for first in range(0, steps, 2):
        for slot in range(SLOTS):
            _act_by_play(run, first, slot, constants, stop_shares, play_weights, drive, columns.stops)
        for stage_lane in range(STAGES):
            step = min(first + stage_lane // STEP_STAGES, steps - 1)
            stage = stage_lane % STEP_STAGES
            for i in range(STATES):
                states[i * STAGES + stage_lane] = points[step, stage, i]
            for i in range(2):
                voltages[i * STAGES + stage_lane] = squares[2 * step + STAGE_NODES[stage], i]
            if centres > 0:
                _corrections(points[step, stage, 0], basis, weights, stage_lane, corrections, correction_slopes, bells)
        _jacobian(
            (
                states,
                voltages,
                corrections,
                stop_shares,
                correction_slopes,
                prepared_lanes,
                rates,
                by_state,
                by_voltage,
                by_correction,
            )
        )
        _by_constants((states, voltages, corrections, stop_shares, prepared_lanes, by_constant))
        for i in range(len(columns.sources)):
            source = columns.sources[i] & _PLACE
            target = columns.targets[i] & _PLACE
            for stage_lane in range(STAGES):
                drive[target + (stage_lane + stage_lane // STEP_STAGES) * COLUMNS] = by_constant[source + stage_lane]
        for stage_lane in range(STAGES):
            step = min(first + stage_lane // STEP_STAGES, steps - 1)
            stage = stage_lane % STEP_STAGES
            pull = observer(-1.0, pole[2 * step] if len(pole) > 0 else 0.0, lead)
            node = 2 * step + STAGE_NODES[stage]
            _act_by_instruments(
                by_instruments[:, node], pull, reading, stage_lane, columns.instruments, by_state, by_voltage, drive
            )
            if centres > 0:
                _act_by_weights(bells, by_correction, stage_lane, centres, columns.first_weight, drive)
        _advance(
            (first, min(first + 2, steps)),
            points,
            stepping,
            (by_state, play_weights, drive),
            (starts, stops, displacements),
        )


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
    by_state, play_weights, drive = acting
    starts, stops, displacements = moving
    by_q, by_tau = stepping.reading
    for step in range(first, stop):
        of_step = by_state[STEP_STAGES * (step - first) :]
        weights = play_weights[step - first]
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
    constants: FloatArray,
    stop_shares: SingleArray,
    play_weights: SingleArray,
    drive: SingleArray,
    places: IntArray,
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
        play = _DIRECTION[i, 0] * moved + constants[_ARM] * by_arm + constants[_LENGTH] * by_length
        share, follows, by_play, by_travel = _stop((slips[step, i], play, constants[_TRAVEL + element]))
        if stage < STEP_STAGES:
            stop_shares[i * STAGES + STEP_STAGES * half + stage] = share
        play_weights[half, place] = follows
        play_weights[half, place + STOPS] = by_play
        at_stop = i * _ROW + slot * COLUMNS
        if places[_ELEMENTS] >= 0:
            drive[places[_ELEMENTS] + at_stop] = by_arm * by_play
        if places[_ELEMENTS + 1] >= 0:
            drive[places[_ELEMENTS + 1] + at_stop] = by_length * by_play
        if places[element] >= 0:
            drive[places[element] + at_stop] = by_travel


@compiled(inline="always")
def _corrections(
    q: float,
    basis: FloatArray,
    weights: FloatArray,
    stage_lane: int,
    corrections: SingleArray,
    slopes: SingleArray,
    bells: FloatArray,
) -> None:
    """The corrections at q, their slopes along q, and the bells with theirs, `bells` (STAGES, 2, M)."""
    for i in range(VALUES):
        corrections[i * STAGES + stage_lane] = 0.0
        slopes[i * STAGES + stage_lane] = 0.0
    for j in range(weights.shape[1]):
        bell, slope, bend = _bell((q, basis[0] + j * basis[1], basis[1], basis[2]))
        bells[stage_lane, 0, j] = bell
        bells[stage_lane, 1, j] = slope
        for i in range(CURVES):
            corrections[i * STAGES + stage_lane] += weights[i, j] * bell
            slopes[i * STAGES + stage_lane] += weights[i, j] * slope
        for i in range(VALUES - CURVES):
            corrections[(CURVES + i) * STAGES + stage_lane] += weights[CURVED.start + i, j] * slope
            slopes[(CURVES + i) * STAGES + stage_lane] += weights[CURVED.start + i, j] * bend


@compiled(inline="always")
def _act_by_instruments(
    inputs: FloatArray,
    pull: tuple[float, float, float, float],
    reading: tuple[float, float],
    stage_lane: int,
    places: IntArray,
    by_state: SingleArray,
    by_voltage: SingleArray,
    drive: SingleArray,
) -> None:
    """Add the observer's terms to ∂f/∂x, and the derivatives of the rates by the instruments.

    `inputs` (4, 2) are those of the squared voltages; `pull` is the observer's, on each rate for 1 m of the `reading`.
    """
    q, speed, tau, turning = pull
    for state, share in ((0, reading[0]), (2, reading[1])):
        at = state * STAGES + stage_lane
        by_state[at] = share * q
        by_state[2 * ENTRIES * STAGES + at] = share * tau
        by_state[ENTRIES * STAGES + at] += share * speed
        by_state[3 * ENTRIES * STAGES + at] += share * turning
    for i in range(INSTRUMENTS):
        at = places[i] + (stage_lane + stage_lane // STEP_STAGES) * COLUMNS
        if i == 0:
            for row in range(4):
                drive[at + row * _ROW] = pull[row]
        else:
            for row in range(FIRST_STRAIN):
                drive[at + row * _ROW] = (
                    inputs[i - 1, 0] * by_voltage[2 * row * STAGES + stage_lane]
                    + inputs[i - 1, 1] * by_voltage[(2 * row + 1) * STAGES + stage_lane]
                )


@compiled(inline="always")
def _act_by_weights(
    bells: FloatArray, by_correction: SingleArray, stage_lane: int, centres: int, first: int, drive: SingleArray
) -> None:
    """Derivatives of the accelerations by the weights of the corrections."""
    for curve in range(CURVES):
        for row in range(1, FIRST_STRAIN, 2):
            value = by_correction[(row * VALUES + curve) * STAGES + stage_lane]
            slope = 0.0
            if CURVED.start <= curve < CURVED.stop:
                slope = by_correction[(row * VALUES + CURVES + curve - CURVED.start) * STAGES + stage_lane]
            for j in range(centres):
                column = first + curve * centres + j
                at = (
                    column // COLUMNS * _BLOCK
                    + column % COLUMNS
                    + row * _ROW
                    + (stage_lane + stage_lane // STEP_STAGES) * COLUMNS
                )
                drive[at] = value * bells[stage_lane, 0, j] + slope * bells[stage_lane, 1, j]
