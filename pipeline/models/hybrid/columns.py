"""Columns, which are derivatives of the condensed joint's state, move side by side through its Runge-Kutta steps.

A column δx moves by the steps of the run with the rates' own derivatives:

    δẋ = ∂f/∂x δx + ∂f/∂z δz + ∂f/∂(the number by which the column is the derivative),

z being the stop operators, which follow the play or stick. The rates' derivatives come from the generated graphs
(`pipeline.generated.condensed_joint_jacobian`), for the eight stages of two steps side by side.

All of it is in single precision, right to 1e-5 of a column's size (the worst to 1e-3) in two thirds of the time. A step
of least squares needs no more digits: a run in double precision judges its result.
"""

from functools import partial, reduce
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ...codegen.graph import Builder, Graph, Operation, reachable, text_of
from ...codegen.numba_writer import formula, kernel
from ...generated.condensed_joint import CONSTANTS, FIRST_STRAIN, STATES, STOP_DIRECTIONS, STOP_ELEMENTS, STOPS
from ...generated.condensed_joint_jacobian import BY_CONSTANTS, JACOBIAN, PREPARE
from ...generated.terms import BELL_SHAPE, STOP_OPERATOR
from ...numerics.arrays import FloatArray, SingleArray
from ...numerics.compiled import compiled, inner
from ...numerics.fixed_step import AHEAD, ALL_SHARES, SHARES, STAGE_NODES
from .kernels import CURVED, CURVES, INDEX, VALUES
from .runs import JointCoefficients, Stepping, observer

BATCH = 16
"""Columns side by side."""
STEP_STAGES = len(SHARES)
"""Stages of a step."""
STAGES = 2 * STEP_STAGES
"""Stages side by side: those of two steps."""
INSTRUMENTS = 5
"""Columns of laser offset, delay, charging time and the two probes."""
_ALL = STATES + STOPS
_CONSTANTS = len(CONSTANTS)
_WEIGHTS = 3 + 2 * STOPS * (STEP_STAGES + 1)
_STEP_SLOTS = STEP_STAGES + 1
"""The stages of a step, and its end."""
_SLOTS = 2 * _STEP_SLOTS
_ROW = _SLOTS * BATCH
_BLOCK = _ALL * _ROW
"""Numbers that act on a block of columns: row by row, in each slot, on each column."""
_ELEMENTS = max(STOP_ELEMENTS) + 1
_ELEMENT = np.array(STOP_ELEMENTS)
_DIRECTION = np.array(STOP_DIRECTIONS)
_TRAVEL = INDEX["stop_travel_0"]
_ARM = INDEX["friction_arm"]
_LENGTH = INDEX["l"]
_PLACE = 2**31 - 1
"""Mask of a place in an array, from which the compiler sees that it is not negative."""


def _step() -> Graph:
    """A Runge-Kutta step of one column: its state `x` and stop operators `z` move to `x_found` and `z_found`.

    `a` are ∂f/∂(x, z) of all entries in `STAGES` stages, of which the first four count; `b` what acts on the column
    itself, row by row in `_SLOTS` slots, of which the first four and the end count. `w` are the friction's arm, the
    step [s], the beam's length, and for each of these five which stop operators follow the play, and by how much.
    """
    build = Builder()
    add = build.add
    acting = {
        operation.place[1]
        for operation in JACOBIAN.operations
        if operation.name == "store" and operation.place[0] == "a"
    }
    acting |= {0, 2, 2 * _ALL, 2 * _ALL + 2}  # an observer pulls at q and τ, by what is read of them
    x = [build.input("x", i) for i in range(STATES)]
    h = build.input("w", 1)
    y = x
    total = x
    for stage in range(len(SHARES)):
        z = _slipped(build, x, y, stage)
        slopes = list[int]()
        for i in range(STATES):
            row = [j for j in range(_ALL) if _ALL * i + j in acting]
            terms = [add("mul", build.input("a", STAGES * (_ALL * i + j) + stage), [*y, *z][j]) for j in row]
            slopes.append(reduce(partial(add, "add"), [build.input("b", _SLOTS * i + stage), *terms]))
        share, ahead = (add("mul", h, build.constant(x)) for x in (SHARES[stage] / ALL_SHARES, AHEAD[stage]))
        total = [add("add", total[i], add("mul", share, slopes[i])) for i in range(STATES)]
        y = [add("add", x[i], add("mul", ahead, slopes[i])) for i in range(STATES)]
    outputs = {"x_found": total, "z_found": _slipped(build, x, total, 4)}
    stores = [
        Operation("store", (operation,), (name, i))
        for name, many in outputs.items()
        for i, operation in enumerate(many)
    ]
    sizes = {"a": _ALL * _ALL * STAGES, "w": _WEIGHTS, "x": STATES, "z": STOPS, "b": _ALL * _SLOTS}
    return Graph(
        sizes, {name: len(many) for name, many in outputs.items()}, text_of(reachable(build.operations, stores))
    )


def _slipped(build: Builder, x: list[int], y: list[int], slot: int) -> list[int]:
    """The stop operators at y: those that follow have moved with the play since x."""
    add = build.add
    moved, turned, bowed = (add("sub", y[i], x[i]) for i in (0, 2, 4))
    slipped = []
    plays = dict[tuple[float, ...], int]()
    for i, direction in enumerate(STOP_DIRECTIONS):
        if direction not in plays:
            q, _, tau, beta = map(build.constant, direction)
            arm = build.input("w", 0)
            length = build.input("w", 2)
            lever = arm if direction[1] else add("mul", length, tau)
            play = add("add", add("mul", q, moved), add("mul", lever, turned))
            plays[direction] = add("add", play, add("mul", add("mul", length, beta), bowed)) if direction[3] else play
        at = 3 + 2 * STOPS * slot + i
        unmoved = add("add", build.input("z", i), build.input("b", _SLOTS * (STATES + i) + slot))
        follows = add("mul", build.input("w", at + STOPS), plays[direction])
        slipped.append(add("add", add("mul", build.input("w", at), unmoved), follows))
    return slipped


_bell = formula(BELL_SHAPE)
_stop = formula(STOP_OPERATOR)
_prepare = kernel(PREPARE)
_PREPARED = PREPARE.outputs["p"]
_jacobian = kernel(JACOBIAN, STAGES, single=True)
_by_constants = kernel(BY_CONSTANTS, STAGES, single=True)
_move = kernel(_step(), BATCH, common=("a", "w"), single=True)
_BY_CONSTANTS = np.array(
    [
        divmod(operation.place[1], _CONSTANTS)
        for operation in BY_CONSTANTS.operations
        if operation.name == "store" and operation.place[1] < STATES * _CONSTANTS
    ]
)
"""Rows and constants of ∂f/∂k that are not zero."""


class Columns(NamedTuple):
    """Places of the numbers that act on columns.

    `sources`, `targets`: entries of ∂f/∂k in the kernel's output, and their places; `stops` (elements + 2,): places
    where travels, the friction's arm and the beam's length act on stop operators, −1 for constants without a column;
    `instruments` (INSTRUMENTS,): their places; `corrected`: the first column of the weights.
    """

    sources: NDArray[np.int64]
    targets: NDArray[np.int64]
    stops: NDArray[np.int64]
    instruments: NDArray[np.int64]
    corrected: int


def columns_of(active: NDArray[np.int64]) -> Columns:
    """The columns of the `active` constants, then of the instruments, then of the weights."""
    places = np.arange(len(active) + INSTRUMENTS)
    places = places // BATCH * _BLOCK + places % BATCH
    of_constant = np.full(_CONSTANTS, -1)
    of_constant[active] = places[: len(active)]
    row, constant = _BY_CONSTANTS[of_constant[_BY_CONSTANTS[:, 1]] >= 0].T
    stops = of_constant[[*range(_TRAVEL, _TRAVEL + _ELEMENTS), _ARM, _LENGTH]]
    return Columns(
        (row * _CONSTANTS + constant) * STAGES,
        of_constant[constant] + row * _ROW,
        np.where(stops >= 0, stops + STATES * _ROW, -1),
        places[len(active) :],
        len(places),
    )


def blocks(count: int) -> int:
    """Blocks of `BATCH` columns."""
    return -(-count // BATCH)


class Path(NamedTuple):
    """A run of one joint, about which the columns are linear.

    Attributes
    ----------
    points : FloatArray, shape (steps + 1, 4, STATES)
        States at all stages.
    slips : FloatArray, shape (steps + 1, STOPS)
        Stop operators at the start of each step.
    squares, by_instruments, pole : FloatArray
        As in `pipeline.models.hybrid.sensitivity.Driven`.
    """

    points: FloatArray
    slips: FloatArray
    squares: FloatArray
    by_instruments: FloatArray
    pole: FloatArray


@compiled
def propagate(
    path: Path,
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
    path : Path
        The run.
    coefficients : JointCoefficients
        Constants and corrections of the joint.
    stepping : Stepping
        As in the run.
    columns : Columns
        Places of the numbers that act.
    starts, stops : SingleArray, shapes (blocks, STATES, BATCH) and (blocks, STOPS, BATCH)
        Derivatives of the first state and of the first stop operators; those at the end (output).
    displacements : FloatArray, shape (N, blocks · BATCH)
        Derivatives of the reading at the samples (output).
    """
    sources, targets, own, instruments, corrected = columns
    points, slips, squares, by_instruments, pole = path
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
    f = _zeros(_ALL * STAGES)
    a = _zeros(_ALL * _ALL * STAGES)
    b = _zeros(_ALL * 2 * STAGES)
    by_c = _zeros(_ALL * VALUES * STAGES)
    by_k = _zeros(_ALL * _CONSTANTS * STAGES)
    _prepare((k, prepared))
    p = _zeros(_PREPARED * STAGES)
    w = np.zeros((2, _WEIGHTS), np.float32)
    drive = _zeros(len(starts) * _BLOCK)
    for i in range(_PREPARED * STAGES):
        p[i] = prepared[i // STAGES]
    bells = np.zeros((STAGES, 2, max(centres, 1)))
    w[:, 0], w[:, 1], w[:, 2] = k[_ARM], dt / substeps, k[_LENGTH]
    for column in range(displacements.shape[1]):
        of_column = starts[column // BATCH, :, column % BATCH]
        displacements[0, column] = reading[0] * of_column[0] + reading[1] * of_column[2]
    for first in range(0, steps, 2):
        for slot in range(_SLOTS):
            _act_by_play((points, slips), first, slot, k, z, w, drive, own)
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
                drive[target + (stage_lane + stage_lane // STEP_STAGES) * BATCH] = by_k[source + stage_lane]
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
            at = block * _BLOCK + _STEP_SLOTS * BATCH * (step - first)
            _move((of_step, weights, here, slip, drive[at:], here, slip))
            if confined:
                here[: 2 * BATCH] = 0.0
            if (step + 1) % stepping.substeps == 0:
                for column_lane in range(BATCH):
                    displacements[(step + 1) // stepping.substeps, block * BATCH + column_lane] = (
                        by_q * here[column_lane] + by_tau * here[2 * BATCH + column_lane]
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
    own: NDArray[np.int64],
) -> None:
    """Weights of a slot, its stop operators, and how travels, arm and length act on these themselves."""
    points, slips = run
    half = slot // _STEP_SLOTS
    stage = slot % _STEP_SLOTS
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
        at_stop = i * _ROW + slot * BATCH
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
    places: NDArray[np.int64],
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
        a[at], a[2 * _ALL * STAGES + at] = share * q, share * tau
        a[_ALL * STAGES + at] += share * speed
        a[3 * _ALL * STAGES + at] += share * turning
    for i in range(INSTRUMENTS):
        at = places[i] + (stage_lane + stage_lane // STEP_STAGES) * BATCH
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
                    column // BATCH * _BLOCK
                    + column % BATCH
                    + row * _ROW
                    + (stage_lane + stage_lane // STEP_STAGES) * BATCH
                )
                drive[at] = value * bells[stage_lane, 0, j] + slope * bells[stage_lane, 1, j]
