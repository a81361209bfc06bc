"""The condensed joint against the energies and the full-order simulation, and its own promises."""

import numba
import numpy as np
import pytest
from scipy.interpolate import CubicSpline

from pipeline.codegen.numba_writer import kernel
from pipeline.device.parameters import NOMINAL, TABLE1, JointParameters
from pipeline.generated import analytical_joint as kernels, condensed_joint as generated
from pipeline.generated.condensed_joint import (
    AT_REST,
    FIRST_ELEMENT,
    STATES,
    STOP_ELEMENTS,
    STOPS,
)
from pipeline.models.analytical import full_order
from pipeline.models.hybrid import parameters as condensed_parameters
from pipeline.models.hybrid.kernels import (
    CURVES as CORRECTIONS,
    INDEX,
    VALUES,
    corrections_at,
    joint_rates,
    mass_matrix,
    prepare,
)
from pipeline.models.hybrid.runs import BATCH, Driving, Followed, JointCoefficients, Stepping, run_joints
from pipeline.models.hybrid.statics import static_curves, substeps
from pipeline.numerics.arrays import FloatArray

UNEQUAL = NOMINAL.with_values(
    {"left.b": 23.4e-3, "right.Y": 1.1e6, "right.eps_r": 3.0, "left.e_z": 15e-3, "kappa0": 0.3}
)
NO_BASIS, NO_WEIGHTS = np.zeros(3), np.zeros((CORRECTIONS, 0))
BASIS = np.array([-0.02, 0.01, 0.008])
RATIO = 1.26
NOTHING = np.zeros(0)
FRICTIONLESS = condensed_parameters.nominal_deviations()


def deviating(seed: int, width: float = 0.25) -> FloatArray:
    """Constants of a joint somewhat off the drawing."""
    drawn = width * np.random.default_rng(seed).standard_normal(len(condensed_parameters.NAMES))
    return condensed_parameters.constants(NOMINAL, drawn, RATIO)


def drawn_weights(seed: int) -> FloatArray:
    """Weights of corrections as large as their prior widths."""
    widths = condensed_parameters.correction_prior_std(NOMINAL)[:, None]
    return np.random.default_rng(seed).standard_normal((CORRECTIONS, 5)) * widths


def run(
    k: FloatArray, u: FloatArray, q0: float, poles: FloatArray, steps: int, observed: FloatArray = NOTHING,
    weights: FloatArray = NO_WEIGHTS,
) -> FloatArray:  # fmt: skip
    """q, q̇, q̈ of one joint through perfect instruments."""
    lead = RATIO / float(k[INDEX["l"]])
    return run_joints(
        JointCoefficients(k[None], weights[None], BASIS),
        Driving(u[None], np.zeros(1, dtype=np.int64), np.zeros(1), np.array([q0, 0.0, 0.0])),
        Followed(observed, poles),
        Stepping(0.01, steps, 0.045, lead),
    )[0]


def prepared(k: FloatArray) -> FloatArray:
    return prepare(k[None])[0]


def corrections(q: float, basis: FloatArray, weights: FloatArray) -> FloatArray:
    found = np.empty(VALUES)
    corrections_at(q, basis, weights, found)
    return found


def body_rates(
    x: FloatArray, u1: float, u2: float, z: FloatArray, start: FloatArray, k: FloatArray, basis: FloatArray,
    weights: FloatArray, rates: FloatArray,
) -> None:  # fmt: skip
    """Rates of the state x whose stop operators were z at the state `start`."""
    c = corrections(x[0], basis, weights)
    joint_rates(x, np.array([u1, u2]), c, z, start[[0, 2, 4]], prepared(k), rates)


def inertia_at(k: FloatArray, q: float, tau: float, beta: float = 0.0) -> FloatArray:
    """The mass matrix of (q, τ, β)."""
    x, upper = np.zeros(STATES), np.empty(6)
    x[[0, 2, 4]] = q, tau, beta
    mass_matrix(x, prepared(k), upper)
    return upper[[[0, 1, 3], [1, 2, 4], [3, 4, 5]]]


def energy_gradient(joint: JointParameters, shape: FloatArray, v: FloatArray, u0: float) -> FloatArray:
    """∂U/∂(q, τ, β) [N, J, J] from the generated kernels, at (Q, τ, β) = `shape` and the axial displacement u0."""
    l = joint.l
    ritz = np.array([[3.0, -1.0, 1.0], [-2.0, 1.0, -2.0], [0.0, 0.0, 1.0]]) / np.array([[l], [l**2], [l**3]])
    gradient = np.empty(4)
    kernels.statics(np.append(ritz @ shape, u0), v**2, joint.vector(), gradient, np.empty((4, 4)))
    return (gradient[:3] @ ritz) / np.array([l, 1.0, 1.0])


@pytest.mark.parametrize("joint", [NOMINAL, UNEQUAL])
def test_forces_are_the_gradient_of_the_energies(joint: JointParameters) -> None:
    k = condensed_parameters.constants(joint, FRICTIONLESS, RATIO)
    u0 = joint.left.e_x - k[INDEX["left_e_x"]]
    random, v = np.random.default_rng(1), np.array([2500.0, 1200.0])
    for shape in random.uniform(-1.0, 1.0, (6, 3)) * [0.2, 0.25, 0.5]:
        x, rates = np.zeros(STATES), np.zeros(STATES)
        x[0], x[2], x[4], x[FIRST_ELEMENT:] = joint.l * shape[0], shape[1], shape[2], joint.l * shape[0]
        body_rates(x, v[0] ** 2, v[1] ** 2, np.zeros(STOPS), x, k, NO_BASIS, NO_WEIGHTS, rates)
        forces = inertia_at(k, *x[[0, 2, 4]]) @ rates[[1, 3, 5]]
        np.testing.assert_allclose(forces, -energy_gradient(joint, shape, v, u0), rtol=1e-3, atol=1e-5)


def test_a_switching_pulse_is_that_of_the_full_order_model() -> None:
    t = np.arange(301) * 0.01
    v = np.zeros((301, 2))
    v[20:120, 0] = 2900.0
    q0 = -0.01119
    full = full_order.simulate(NOMINAL, t, v, full_order.rest_state(NOMINAL, q0, 0.0, v[0]))
    k = condensed_parameters.constants(NOMINAL, FRICTIONLESS, condensed_parameters.static_slope_ratio(NOMINAL))
    steps = substeps(k, NO_BASIS, NO_WEIGHTS, 0.01)
    fine = np.linspace(0.0, t[-1], 2 * steps * 300 + 1)
    u = np.column_stack([np.interp(fine, t, v[:, i]) for i in (0, 1)]) ** 2
    q = run(k, u, q0, np.zeros(301), steps)[:, 0]
    assert full.q.max() > 0.018
    # Inertia of the shapes and the course of u0 are what the slow coordinates leave out.
    assert np.sqrt(np.mean((q - full.q) ** 2)) < 0.025 * np.ptp(full.q)


@pytest.mark.parametrize("seed", range(4, 8))  # those whose wells are near the drawing's
@pytest.mark.parametrize("corrected", [False, True])
def test_without_voltage_every_motion_ends_at_rest(seed: int, corrected: bool) -> None:
    k, samples = deviating(seed), 3001
    weights = drawn_weights(seed) if corrected else NO_WEIGHTS
    steps = substeps(k, BASIS, weights, 0.01)
    still = np.zeros((2 * steps * (samples - 1) + 1, 2))
    motion = run(k, still, 0.022, np.zeros(samples), steps, weights=weights)
    assert np.abs(motion[:, 0]).max() < 0.024
    assert np.abs(motion[-100:, 1]).max() < 1e-4 < np.abs(motion[:100, 1]).max()


@pytest.mark.parametrize("seed", range(12))
def test_no_motion_in_any_direction_gains_energy_however_low_its_losses_are_corrected(seed: int) -> None:
    """Against the speeds the forces take power, also of joints whose slope and clamp are far off the drawing's."""
    random, k = np.random.default_rng(seed), deviating(seed, 1.0)
    k[[INDEX["sliding_force"], *(INDEX[f"stop_force_{i}"] for i in set(STOP_ELEMENTS))]] = 0.0
    p, c, x, mass = prepare(k[None])[0], np.zeros(VALUES), np.zeros(STATES), np.empty(6)
    c[generated.CORRECTIONS.index("loss")] = -1e9
    x[[0, 2, 4]] = 0.01, 0.15, 0.3
    mass_matrix(x, p, mass)
    matrix = mass[[0, 1, 3, 1, 2, 4, 3, 4, 5]].reshape(3, 3)
    for _ in range(200):
        speeds, rates = random.standard_normal(3) * np.array([1e-3, 1e-2, 1e-2]), np.empty((2, STATES))
        for sign, found in zip((1.0, -1.0), rates, strict=True):
            x[[1, 3, 5]] = sign * speeds
            joint_rates(x, np.zeros(2), c, np.zeros(STOPS), x[[0, 2, 4]], p, found)
        odd = matrix @ (rates[0] - rates[1])[[1, 3, 5]]
        assert speeds @ odd < 0.0


@pytest.mark.parametrize("seed", [5, 9, 10, 14])  # those which stay within their range, as a joint on a rig does
def test_the_step_is_fine_enough(seed: int) -> None:
    k, samples = deviating(seed), 301
    runs = []
    for steps in (substeps(k, NO_BASIS, NO_WEIGHTS, 0.01), 24):
        u = np.zeros((2 * steps * (samples - 1) + 1, 2))
        u[:, 0] = 2500.0**2
        runs.append(run(k, u, -0.011, np.zeros(samples), steps)[:, 0])
    assert np.abs(runs[0] - runs[1]).max() < 2e-4 * np.ptp(runs[1])


@pytest.mark.parametrize("pole", [5.0, 20.0])
def test_the_observer_holds_the_joint_to_its_own_motion(pole: float) -> None:
    """Disturbed at the start, it comes back to its own measurement, also where the free joint is unstable."""
    k, samples, steps = deviating(5), 601, 12
    t = 0.01 * np.arange(samples)
    fine = np.linspace(0.0, t[-1], 2 * steps * (samples - 1) + 1)
    u = np.zeros((len(fine), 2))
    u[:, 0] = np.where((fine > 0.5) & (fine < 1.5), 2900.0**2, 0.0)
    u[:, 1] = np.where((fine > 2.5) & (fine < 2.9), 2000.0**2, 0.0)
    truth = run(k, u, -0.011, np.zeros(samples), steps)
    assert np.ptp(truth[:, 0]) > 0.02
    followed = CubicSpline(t, truth[:, 0])(fine)
    held = run(k, u, -0.009, np.full(samples, pole), steps, followed)
    assert np.abs(held[300:, 0] - truth[300:, 0]).max() < 3e-5


@pytest.mark.parametrize(("width", "single"), [(1, False), (BATCH, False), (BATCH, True)])
def test_kernels_are_the_graph_of_the_equations(width: int, *, single: bool) -> None:
    """One joint and several side by side, in random states, against the graph's operations by numpy."""
    random, compiled = np.random.default_rng(5), kernel(generated.RATES, width, single=single)
    real = np.float32 if single else np.float64

    @numba.njit(error_model="numpy")
    def run(x, u, c, z, start, p, dx):  # type: ignore[no-untyped-def]
        compiled((x, u, c, z, start, p, dx))

    scale = np.array([0.01, 0.1, 0.1, 2.0, 0.05, *(STATES - 5) * [0.01]])
    worst = 0.0
    for _ in range(200 // width):
        x, moved = random.standard_normal((2, width, STATES)) * scale
        weights = [drawn_weights(int(random.integers(1000))) for _ in range(width)]
        arrays = {
            "x": x,
            "u": random.uniform(0.0, 9e6, (width, 2)),
            "c": np.array([corrections(q, BASIS, w) for q, w in zip(x[:, 0], weights, strict=True)]),
            "z": random.uniform(-1.0, 1.0, (width, STOPS)),
            "start": moved[:, [0, 2, 4]],
            "p": generated.PREPARE.evaluate(k=np.array([deviating(int(i)) for i in random.integers(0, 50, width)]))[
                "p"
            ],
        }
        expected = generated.RATES.evaluate(**arrays)["rates"]
        found = np.empty(STATES * width, dtype=real)
        run(*(np.ascontiguousarray(arrays[name].T, dtype=real).ravel() for name in generated.RATES.inputs), found)
        # Forces of 1e4 m/s² cancel in an acceleration: errors are counted against the largest rate of its kind.
        size = np.abs(expected).max() * np.array([1.0, 1e-2, 1.0, 1.0, *(STATES - 4) * [1.0]])
        worst = max(worst, float(np.max(np.abs(found.reshape(STATES, width).T - expected) / size)))
    assert worst < (1e-5 if single else 1e-12)


def test_joints_side_by_side_move_as_each_alone() -> None:
    k, samples, steps = np.array([deviating(j) for j in range(BATCH + 3)]), 41, 3  # one of them is chaotic
    weights = np.array([drawn_weights(j) for j in range(len(k))])
    u = np.zeros((1, 2 * steps * (samples - 1) + 1, 2))
    u[0, 100:, 0] = 2500.0**2
    rest = Followed(np.zeros(0), np.zeros(samples)), Stepping(0.01, steps, 0.045, 14.0)

    def moved(chosen: slice) -> FloatArray:
        count = len(k[chosen])
        one = np.zeros(count, dtype=np.int64)
        driving = Driving(u, one, np.zeros(count), np.array([-0.011, 0.0, 0.0]))
        return run_joints(JointCoefficients(k[chosen], weights[chosen], BASIS), driving, *rest)

    together = moved(slice(None))
    for j in range(len(k)):
        np.testing.assert_allclose(together[j], moved(slice(j, j + 1))[0], rtol=1e-9, atol=1e-12)


def test_corrections_of_the_shape_are_gradients_of_a_potential() -> None:
    """Around a closed path of (q, τ) at rest, under constant voltage, they do no work."""
    k, u, weights = deviating(1), (6e6, 2e6), drawn_weights(2)
    weights[:4] = 0.0  # these are curves of q alone
    angle = np.linspace(0.0, 2.0 * np.pi, 2001)
    q, tau = 0.012 * np.cos(angle), 0.2 * np.cos(angle - 0.7)
    works = []
    for at in (weights, np.zeros_like(weights)):
        forces = np.array([generalised(k, a, b, u, at) for a, b in zip(q, tau, strict=True)])
        steps = np.diff(np.column_stack([q, tau]), axis=0)
        works.append(np.sum(0.5 * (forces[1:] + forces[:-1]) * steps, axis=1))
    added = works[0] - works[1]
    assert np.abs(added).sum() > 1e-6
    assert abs(added.sum()) < 1e-5 * np.abs(added).sum()


def generalised(k: FloatArray, q: float, tau: float, u: tuple[float, float], weights: FloatArray) -> FloatArray:
    """Force [N] and moment [N·m] on the joint at rest at (q, τ)."""
    x, rates = np.zeros(STATES), np.zeros(STATES)
    x[0], x[2], x[FIRST_ELEMENT:] = q, tau, np.array(AT_REST) * q
    body_rates(x, *u, np.zeros(STOPS), x, k, BASIS, weights, rates)
    return (inertia_at(k, q, tau) @ rates[[1, 3, 5]])[:2]


def drawn_motion(seed: int) -> tuple[FloatArray, FloatArray]:
    """(q, τ, β) within a joint's range and their rates as in a snap."""
    random = np.random.default_rng(seed)
    return random.uniform(-1.0, 1.0, 3) * [0.02, 0.4, 1.0], random.standard_normal(3) * [0.3, 6.0, 60.0]


@pytest.mark.parametrize("seed", range(4))
def test_kinetic_energy_changes_by_the_work_of_the_forces_alone(seed: int) -> None:
    k, place, v = deviating(seed), *drawn_motion(seed)

    def acceleration(v: FloatArray) -> FloatArray:
        x, rates = np.zeros(STATES), np.zeros(STATES)
        x[[0, 2, 4]], x[[1, 3, 5]], x[FIRST_ELEMENT:] = place, v, np.array(AT_REST) * place[0]
        body_rates(x, 0.0, 0.0, np.zeros(STOPS), x, k, NO_BASIS, NO_WEIGHTS, rates)
        return rates[[1, 3, 5]]

    # Losses are odd in the velocity; what is even is inertia, and at rest there are the potentials alone.
    even, step = 0.5 * (acceleration(v) + acceleration(-v)), 1e-6
    ahead, behind = (inertia_at(k, *(place + s * v)) for s in (step, -step))
    matrix = inertia_at(k, *place)
    gained = v @ matrix @ even + 0.5 * v @ (ahead - behind) @ v / (2.0 * step)
    worked = v @ matrix @ acceleration(np.zeros(3))
    assert abs(v @ matrix @ (even - acceleration(np.zeros(3)))) > 1e-4 * abs(worked)
    np.testing.assert_allclose(gained, worked, rtol=1e-6)
    assert np.all(np.linalg.eigvalsh(matrix) > 0.0)


@pytest.mark.parametrize("seed", range(4))
def test_the_mass_matrix_is_that_of_the_frame_as_a_rigid_body(seed: int) -> None:
    k, place, v = deviating(seed), *drawn_motion(seed)

    def of(name: str) -> float:
        return float(k[INDEX[name]])

    def pose(at: FloatArray) -> FloatArray:
        """Centre of mass [m] and angle of the frame."""
        q, tau, beta = at
        angle = np.arcsin(tau / np.sqrt(1.0 + of("rotation") * tau**2))
        squares = of("rise_qq") * q * q + of("rise_tt") * tau * tau + of("rise_bb") * beta * beta
        products = of("rise_qt") * q * tau + of("rise_qb") * q * beta + of("rise_tb") * tau * beta
        up = -0.5 * squares - products + of("offset") * (np.cos(angle) - 1.0)
        return np.array([q + of("offset") * np.sin(angle), up, angle])

    step = 1e-6
    across, up, turning = (pose(place + step * v) - pose(place - step * v)) / (2.0 * step)
    twice = of("mass") * (across**2 + up**2) + of("gyration") * turning**2 + 2.0 * of("cross") * v[0] * v[1]
    twice += of("inertia") * v[1] ** 2 + of("interior_inertia") * v[2] ** 2
    np.testing.assert_allclose(v @ inertia_at(k, *place) @ v, twice, rtol=1e-7)


@pytest.mark.parametrize("joint", [NOMINAL, TABLE1])
def test_curves_are_those_of_the_energies(joint: JointParameters) -> None:
    k = condensed_parameters.constants(joint, FRICTIONLESS, RATIO)
    q = np.linspace(-0.02, 0.02, 41)
    restoring, damping, left, right = static_curves(q, k, NO_BASIS, NO_WEIGHTS)
    # A symmetric joint: odd force, even damping, mirrored actuation.
    np.testing.assert_allclose(restoring, -restoring[::-1], atol=1e-9)
    np.testing.assert_allclose(damping, damping[::-1], rtol=1e-5)
    np.testing.assert_allclose(left, -right[::-1], rtol=1e-5, atol=1e-14)
    assert np.all(damping > 0.0)
    assert np.all(left > 0.0)
    # The check values' wells: q± = ±11.19 mm and ±13.77 mm.
    well = {NOMINAL: 11.19e-3, TABLE1: 13.77e-3}[joint]
    at_well = static_curves(np.array([well]), k, NO_BASIS, NO_WEIGHTS)[0][0]
    slope = (np.interp(well + 1e-3, q, restoring) - np.interp(well - 1e-3, q, restoring)) / 2e-3
    assert abs(at_well / slope) < 0.15e-3
