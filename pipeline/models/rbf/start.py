"""Start of the estimation of the data-driven joint: a convex fit of accelerations.

The start is a bounded linear least squares problem (convex, one minimum): curves F, d ≥ 0 and gains g_k of one sign,
with a ridge. It knows nothing of hidden states; they start small and typical.
"""

from collections.abc import Mapping, Sequence
from itertools import product

import numpy as np
from scipy.optimize import lsq_linear

from ...errors import InputError
from ...fitting.regression import InputAction, input_signal
from ...generated.terms import BELL, STOP_FORCE
from ...numerics.arrays import FloatArray
from ...numerics.metrics import rms
from ...signals.log import Log, operating_range
from .dynamics import FORCE, POLYNOMIALS, basis_rows, slid
from .parameter_layout import ParameterLayout
from .structure import OVERDAMPED, JointScales, JointStructure

TIMES = ("input_lag", "input_delay")
"""Blocks of θ that hold times of the drive."""

RIDGE = 2e-2
SOFT, STIFF = 0.15, 0.25  # stiffness of plain and of shape elements to start from, in units of the stiffness scale
START_RELAXATION, START_PULL = 3.0, 0.25  # rate of shape elements and the inputs' pull, in units of the scales
LAGS = tuple(np.geomspace(0.05, 8.0, 12))  # of the inputs, tried in units of the inverse frequency scale
DELAYS = LAGS[::3]
START_SLIP_FORCE, START_SLIP_LENGTH = 7.5e-3, 0.01  # of dry friction, in units of stiffness scale and half ranges
SLIP_LENGTHS = (START_SLIP_LENGTH, 0.03, 0.1, 0.3, 1.0)  # of friction states, from dry to one over a long way
CLEARLY = 0.9  # share of the misfit of dry friction below which another is taken first
START_DRAG = 0.05  # over half ranges
ZONE = 0.1  # of a dead zone to start from, a share of the largest drive
STOP_PLACES = (0.7, 0.8, 0.88, 0.94, 0.98)
STOP_LEAST = 1.0
"""Places at which end stops are tried [half ranges]; least stiffness and resistance at the start [scales]."""
PLACES = 201  # where the sign of the force is looked at


def data_scales(
    records: Sequence[Log], *, centred: bool, reach: tuple[float, float] = (np.inf, -np.inf)
) -> JointScales:
    """Units of the dimensionless joint.

    Parameters
    ----------
    records : sequence of Log
        The training logs.
    centred : bool
        True if x = 0 is q = 0 (a symmetric device) instead of the middle of the data.
    reach : (float, float)
        Smallest and largest displacement that the joint shall span beside the data.

    Raises
    ------
    InputError
        No data, a displacement that never changes, or inputs that are always zero.
    """
    low, high = operating_range(records)
    low, high = min(low, reach[0]), max(high, reach[1])
    volts = max(float(np.abs(r.v).max()) for r in records)
    if volts == 0.0:
        raise InputError("all inputs are zero in all training logs; the joint was never driven")
    centred = centred and low < 0.0 < high
    half = max(-low, high) if centred else 0.5 * (high - low)
    speed, acceleration = (
        rms(np.concatenate([getattr(r, name)[r.valid] for r in records])) / half for name in ("qdot", "qddot")
    )
    slopes = np.concatenate([np.gradient(np.where(r.valid, r.qdot, np.nan), r.interval) for r in records])
    return JointScales(
        middle=0.0 if centred else 0.5 * (low + high),
        half=half,
        volts=volts,
        stiffness=acceleration,
        speed=speed,
        slope=rms(slopes[np.isfinite(slopes)]) / half,
    )


def starting_joint(
    records: Sequence[Log],
    structure: JointStructure,
    action: InputAction,
    *,
    centred: bool,
    known_signs: Mapping[int, int] | None = None,
    reach: tuple[float, float] = (np.inf, -np.inf),
    timing: Mapping[str, FloatArray] | None = None,
) -> tuple[ParameterLayout, FloatArray]:
    """Parameterisation and start vector from the training logs.

    Parameters
    ----------
    records : sequence of Log
        Training logs.
    structure : JointStructure
        Its terms.
    action : {"squared", "linear"}
        Squared inputs have gains of one sign, found by a fit without bounds; those of linear ones stay free.
    centred, reach
        As in `data_scales`.
    known_signs : mapping of int to int, optional
        Signs of gains by the number of the input.
    timing : mapping of str to FloatArray, optional
        Start values of the blocks of lag and delay; they decide the signs.
    """
    measured = data_scales(records, centred=centred, reach=reach)
    inputs = records[0].v.shape[1]
    provisional = ParameterLayout(structure, measured, action, (0,) * inputs)
    scales = provisional.units
    motion, target = _motion(records, provisional)
    timed = _timed(provisional, timing) if timing else _best_timing(records, provisional, motion, target)
    columns = _columns(records, provisional, timed, motion)
    signs = (0,) * inputs
    if action == "squared":  # the signs of the mean forces of a fit without bounds
        weights = _bounded_fit(columns, target, structure, signs)
        means = [np.mean(basis @ w) for basis, w in zip(columns[2:], weights[2:], strict=True)]
        signs = tuple((known_signs or {}).get(i, 1 if mean >= 0.0 else -1) for i, mean in enumerate(means))
    parameters = ParameterLayout(structure, measured, action, signs)
    fitted = _bounded_fit(columns, target, structure, signs)
    pairs = zip(columns[2:], fitted[2:], strict=True)
    start = _start_vector(parameters, fitted, [_typical_gain(basis, gain, scales) for basis, gain in pairs])
    at = parameters.slices
    if structure.slips:
        forces: FloatArray | float = START_SLIP_FORCE * scales.stiffness / structure.slips
        lengths = np.array(SLIP_LENGTHS[: structure.slips])
        if not structure.rates:  # whose memory would be taken for friction
            forces, lengths = _best_slips(records, scales, columns, target, structure.slips)
        start[at["slip_force"]] = np.log(forces)
        start[at["slip_length"]] = np.log(lengths)
    if structure.stops:
        start[at["stops"]] = _best_stops(records, scales, columns, target)
    for name in TIMES:
        start[at[name]] = timed[at[name]]
    return parameters, start


def bistable_signs(records: Sequence[Log], action: InputAction) -> tuple[int, ...]:
    """Signs of the inputs' pushes at a device with two wells, 0 for linear inputs; empty for any other device.

    The convex fit of the accelerations shows: without inputs its force must cross zero rising, near the middle of the
    range, between two places where it falls.

    Cost: one convex fit, 40 ms for 4,000 samples.
    """
    p, start = starting_joint(
        records, JointStructure(rates=(), shape_elements=0, slips=0, arc=False), action, centred=False
    )
    coefficients = p.coefficients(start)
    x = np.linspace(-1.0, 1.0, PLACES)
    force = basis_rows(x, coefficients) @ coefficients.curves[FORCE]
    turns = np.flatnonzero(np.diff(np.sign(force)))
    if not np.array_equal(np.sign(force[turns]), [1.0, -1.0, 1.0]):
        return ()
    left, saddle, right = np.abs(x[turns])
    return p.signs if saddle < min(left, right) else ()


def looks_overdamped(records: Sequence[Log], action: InputAction) -> bool:
    """True if displacement and inputs explain more of the velocity than all three explain of the acceleration.

    Shares of the mean squares that a convex fit explains are compared. Cost: two of them, 2 ms for 4,000 samples.
    """

    def explained(*, overdamped: bool) -> float:
        """Share of what is fitted that a cubic spring, a damper and constant gains explain."""
        plain = JointStructure(
            rates=(),
            shape_elements=0,
            slips=0,
            arc=False,
            force="polynomial",
            constant_damping=True,
            constant_gain=True,
            overdamped=overdamped,
        )
        p = ParameterLayout(plain, data_scales(records, centred=False), action, (0,) * records[0].v.shape[1])
        motion, target = _motion(records, p)
        return 1.0 - _misfit(_columns(records, p, np.zeros(p.count), motion), target) / float(target @ target)

    return explained(overdamped=True) > explained(overdamped=False)


def _best_timing(
    records: Sequence[Log], p: ParameterLayout, motion: list[FloatArray], target: FloatArray
) -> FloatArray:
    """`_timed` θ with the lag and the delay at which the accelerations are fitted best.

    The accelerations are linear in the curves, so only the two times are searched (variable projection). A descent
    alone would end where a slow drive is taken for a strongly damped device.
    """
    s = p.structure
    tried = [
        _timed(p, dict(zip(TIMES, np.log(np.array(times) / p.units.frequency), strict=True)))
        for times in product(LAGS if s.input_lag else (1.0,), DELAYS if s.input_delay else (1.0,))
    ]

    def misfit(theta: FloatArray) -> float:
        """Rest of the convex fit with the drive of θ."""
        return _misfit(_columns(records, p, theta, motion), target)

    return min(tried, key=misfit) if len(tried) > 1 else tried[0]


def _timed(p: ParameterLayout, timing: Mapping[str, FloatArray]) -> FloatArray:
    """θ with the logarithms of lag and delay [s], all else zero but that of a dead zone: zero would be one as wide as
    the largest drive.
    """
    theta = np.zeros(p.count)
    theta[p.slices["input_zone"]] = np.log(ZONE)
    for name, times in timing.items():
        theta[p.slices[name]] = times
    return theta


def _best_slips(
    records: Sequence[Log], scales: JointScales, columns: list[FloatArray], target: FloatArray, count: int
) -> tuple[FloatArray, FloatArray]:
    """Forces [1/s²] and rising lengths of `count` friction states to start from, each of shape (count,).

    Along the measured path a friction state is known for each length, and the accelerations are linear in its force.
    One length after the other is taken, the one that fits best beside those before: a descent from dry friction alone
    would not find a hysteresis. The first is dry unless another fits clearly better.

    Cost: for each length a pass over the samples, and for each of `count` steps at most five normal equations.
    """
    paths = [np.interp(r.t, r.t[r.valid], r.q[r.valid]) / scales.half for r in records]
    # Resisting forces at the valid samples, shape (N, 1)
    states = {
        length: -np.concatenate([slid(path, length)[r.valid] for path, r in zip(paths, records, strict=True)])[:, None]
        for length in SLIP_LENGTHS
    }
    chosen = list[float]()

    def misfit(length: float) -> float:
        """Rest of the fit with friction of this length beside that of those chosen."""
        return _misfit([*columns, *(states[each] for each in (*chosen, length))], target)

    while len(chosen) < count:
        best = min((length for length in SLIP_LENGTHS if length not in chosen), key=misfit)
        dry = not chosen and misfit(best) > CLEARLY * misfit(START_SLIP_LENGTH)
        chosen.append(START_SLIP_LENGTH if dry else best)
    chosen.sort()
    matrix = np.column_stack([*columns, *(states[length] for length in chosen)])
    forces = np.linalg.lstsq(matrix, target, rcond=None)[0][-count:]
    return np.maximum(forces, START_SLIP_FORCE * scales.stiffness / count), np.array(chosen)


def _best_stops(
    records: Sequence[Log], scales: JointScales, columns: list[FloatArray], target: FloatArray
) -> FloatArray:
    """Places of two end stops, and logarithms of stiffness [1/s²] and resistance [1/s], to start from, shape (4,).

    The places are tried; the accelerations are linear in what stands there.
    """
    x = np.concatenate([(r.q[r.valid] - scales.middle) / scales.half for r in records])
    p = np.concatenate([r.qdot[r.valid] / scales.half for r in records])

    def stop_forces(left: float, right: float) -> FloatArray:
        """Force per stiffness and per resistance at the valid samples, shape (N, 2)."""
        stops = (np.array([left, right, *each]) for each in ((1.0, 0.0), (0.0, 1.0)))
        return np.hstack([STOP_FORCE.evaluate(x=x[:, None], p=p[:, None], stops=each)["value"] for each in stops])

    pairs = product(-np.array(STOP_PLACES), STOP_PLACES)
    places = min(pairs, key=lambda ends: _misfit([*columns, stop_forces(*ends)], target))
    matrix = np.column_stack([*columns, stop_forces(*places)])
    stiffness, resistance = np.linalg.lstsq(matrix, target, rcond=None)[0][-2:]
    stiffness = max(stiffness, STOP_LEAST * scales.stiffness)
    return np.array([*places, np.log(stiffness), np.log(max(resistance, STOP_LEAST * scales.frequency))])


def _driven(records: Sequence[Log], p: ParameterLayout, timing: FloatArray) -> FloatArray:
    """Inputs behind lag and delay at the valid samples, shape (N, K)."""
    if not (p.structure.input_lag or p.structure.input_delay):
        return np.concatenate([input_signal(r.v[r.valid] / p.scales.volts, p.law) for r in records])
    parts = []
    for r in records:
        inputs = r.v if r.past is None else np.concatenate((r.past if r.past.ndim == 2 else r.past[:, 0], r.v))
        parts.append(p.inputs(inputs, r.interval, 1, timing)[0][2 * (len(inputs) - len(r.v)) :: 2][r.valid])
    return np.concatenate(parts)


def _motion(records: Sequence[Log], p: ParameterLayout) -> tuple[list[FloatArray], FloatArray]:
    """Columns of F, of d and of the gains before they act on inputs, each (N, functions), and the accelerations.

    An overdamped device has no measurable acceleration: the force that balances its damping stands in its place.
    """
    s = p.units
    x = np.concatenate([(r.q[r.valid] - s.middle) / s.half for r in records])
    speed = np.concatenate([r.qdot[r.valid] / s.half for r in records])
    target = np.concatenate([r.qddot[r.valid] / s.half for r in records])
    basis = basis_rows(x, p.coefficients(np.zeros(p.count)))
    damping = -speed[:, None] * basis[:, p.basis_of("damping")]
    if p.structure.overdamped:
        damping = np.zeros_like(damping)
        target = OVERDAMPED * s.frequency * speed
    return [basis[:, p.basis_of("force")], damping, basis[:, p.basis_of("input0")]], target


def _columns(
    records: Sequence[Log], p: ParameterLayout, theta: FloatArray, motion: list[FloatArray]
) -> list[FloatArray]:
    """Columns of F, of d and of each g_k, which are those of `_motion` times u_k with the drive of θ."""
    return [*motion[:2], *(signal[:, None] * motion[2] for signal in _driven(records, p, theta).T)]


def _misfit(columns: list[FloatArray], target: FloatArray) -> float:
    """Residual of a fit of the accelerations without bounds."""
    matrix = np.column_stack(columns)
    matrix = matrix / (np.linalg.norm(matrix, axis=0) + np.finfo(float).tiny)
    gram = matrix.T @ matrix
    gram[np.diag_indices_from(gram)] += 1e-8
    right = matrix.T @ target
    return float(target @ target - right @ np.linalg.solve(gram, right))


def _bounded_fit(
    columns: list[FloatArray], target: FloatArray, structure: JointStructure, signs: tuple[int, ...]
) -> list[FloatArray]:
    """Weights of F, d ≥ 0 and g_k of their signs, with a ridge on unit-norm columns; the cubic of F confines."""
    matrix = np.column_stack(columns)
    norms = np.linalg.norm(matrix, axis=0)
    norms[norms == 0.0] = 1.0
    size = float(np.linalg.norm(target)) + np.finfo(float).tiny
    ends = np.cumsum([basis.shape[1] for basis in columns])
    low = np.full(ends[-1], -np.inf)
    high = np.full(ends[-1], np.inf)
    if structure.force != "offset":
        high[POLYNOMIALS - 1] = 0.0
    low[ends[0] : ends[1]] = 0.0
    for first, last, sign in zip(ends[1:], ends[2:], signs, strict=False):
        low[first:last] = 0.0 if sign > 0 else -np.inf
        high[first:last] = 0.0 if sign < 0 else np.inf
    # The triangular factor has the normal equations' size but not their squared condition number.
    q, r = np.linalg.qr(np.vstack((matrix / norms, RIDGE * np.eye(matrix.shape[1]))))
    solution = lsq_linear(r, q[: len(target)].T @ (target / size), (low, high)).x / norms * size
    return list(np.split(solution, ends[:-1]))


def _typical_gain(basis: FloatArray, gain: FloatArray, scales: JointScales) -> float:
    """Size of the weights that gives the mean force of an input; that of the springs if it never acted."""
    drive = float(np.sum(np.abs(basis)))
    return max(abs(float(np.sum(basis @ gain))) / drive if drive > 0.0 else 0.0, 0.05 * scales.stiffness)


def _start_vector(p: ParameterLayout, fitted: list[FloatArray], typical: list[float]) -> FloatArray:
    """θ from the convex fit; gains of one sign start at their typical size everywhere.

    Where an input never acted the convex fit does not determine its gain; a constant is the better guess there.
    """
    theta = np.zeros(p.count)
    at = p.slices
    s = p.units
    force, damping, *gains = fitted
    theta[at["force"]] = force
    if p.structure.force != "offset":
        theta[p.cubic] = np.log(max(-force[POLYNOMIALS - 1], 0.05 * s.stiffness))
    overlap = BELL.evaluate(inside=np.zeros(1), centre=p.centres[:, None], bend=np.array([p.bend]))["value"].sum()
    theta[at["damping"]] = np.log(np.maximum(damping, 0.3 * np.median(damping) + 0.015 * s.frequency))
    if p.structure.overdamped:
        theta[at["damping"]] = np.log(OVERDAMPED * s.frequency / (1.0 if p.structure.constant_damping else overlap))
    for i, gain in enumerate(gains):
        theta[at[f"input{i}"]] = np.log(typical[i]) if p.signs[i] else gain
    for i in range(len(p.structure.rates)):
        share = STIFF if i < p.structure.shape_elements else SOFT
        theta[at[f"coupling{i}"]] = np.sqrt(share * s.stiffness) / overlap
    for i in range(p.structure.shape_elements):
        theta[at[f"relaxation{i}"]] = np.log(START_RELAXATION * s.frequency / overlap)
        for k, sign in enumerate(p.signs):
            theta[at[f"pull{i}_{k}"]] = sign * START_PULL * np.sqrt(s.stiffness) / overlap
    theta[at["rate"]] = np.log(np.array(p.structure.rates) * s.frequency)
    theta[at["inertia"]] = np.log(0.1)
    theta[at["drag"]] = np.log(START_DRAG)
    theta[at["input_zone"]] = np.log(ZONE)
    return theta
