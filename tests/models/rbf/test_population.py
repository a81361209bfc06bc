"""A population is learnt from what its members' logs tell, and knows units, mirror images and exchanged inputs."""

from dataclasses import replace

import numpy as np
import pytest

from benchmarks.population_estimate import estimate_symmetric_population
from pipeline.fitting.population import Information
from pipeline.models.rbf.candidates import FRICTION, first_candidate
from pipeline.models.rbf.identify import identify_rbf
from pipeline.models.rbf.model import RbfModel
from pipeline.models.rbf.parameter_layout import ParameterLayout
from pipeline.models.rbf.prior import Population, mirror_image, population
from pipeline.models.rbf.structure import JointScales
from pipeline.numerics.arrays import FloatArray
from tests.models.rbf.test_rbf import log

USUAL = replace(first_candidate(FRICTION["lags+slip"], pair=True, angle=False, fine=False).structure, arc=True)
SCALES = JointScales(0.0, 0.02, 3000.0, 40.0)


def layout(scales: JointScales = SCALES, signs: tuple[int, int] = (1, -1)) -> ParameterLayout:
    return ParameterLayout(USUAL, scales, "squared", signs)


def joint(seed: int) -> FloatArray:
    """Dimensionless θ near the middle of the population, its sides not alike."""
    learnt = population()
    rng = np.random.default_rng(seed)
    found: FloatArray = learnt.mean + 0.3 * np.linalg.solve(learnt.root, rng.standard_normal(len(learnt.mean)))
    return found


def run(p: ParameterLayout, phi: FloatArray, t: FloatArray, v: FloatArray, q: float) -> FloatArray:
    offset, scale = p.dimensionless
    none = np.zeros((p.count, 1))
    found = RbfModel(p, offset + scale * phi, none, none, 1.0).simulate(t, v, q, 0.0)
    assert found.status == "ok"
    return found.q


def drive(n: int = 400) -> tuple[FloatArray, FloatArray]:
    t, v = 0.01 * np.arange(n), np.zeros((n, 2))
    v[50:100, 0], v[180:260, 1], v[300:350, 0] = 2600.0, 2900.0, 1500.0
    return t, v


def test_mean_and_covariance_of_a_population_are_recovered_from_members_that_tell_little() -> None:
    """Each of 1500 members tells of two of four directions only, with noise; the second is odd in the mirror."""
    rng = np.random.default_rng(5)
    image = np.diag([1.0, -1.0, 1.0, 1.0])
    root = np.array([[1.0, 0, 0, 0], [0, 0.5, 0, 0], [0.8, 0, 0.6, 0], [-0.3, 0, 0.5, 0.2]])
    mean = np.array([2.0, 0.0, -1.0, 0.5])
    joints = []
    for _ in range(1500):
        member = mean + root @ rng.standard_normal(4)
        seen = rng.standard_normal((2, 4))
        readings = seen @ member / 0.1 + rng.standard_normal(2)
        joints.append(Information(seen.T @ seen / 0.01, seen.T @ readings / 0.1))
    found, covariance = estimate_symmetric_population(joints, image, np.zeros(4), np.eye(4))
    assert found == pytest.approx(mean, abs=0.1)
    assert covariance == pytest.approx(root @ root.T, abs=0.1)
    assert np.allclose(image @ covariance @ image.T, covariance)


def test_the_joint_in_the_mirror_moves_as_the_mirror_image() -> None:
    p, (t, v) = layout(), drive()
    image, phi = mirror_image(p), joint(1)
    assert np.allclose(image @ image, np.eye(p.count))
    q = run(p, phi, t, v, -0.011)
    assert np.ptp(q) > 0.02
    assert run(p, image @ phi, t, v[:, ::-1], 0.011) == pytest.approx(-q, abs=1e-9)
    assert not np.allclose(image @ phi, phi)


def test_the_same_numbers_are_a_joint_of_another_size_and_speed() -> None:
    t, v = drive()
    q = run(layout(), joint(2), t, v, -0.011)
    larger = JointScales(0.0, 0.05, 1000.0, 4.0 * SCALES.stiffness)  # twice as fast
    assert run(layout(larger), joint(2), t / 2.0, v / 3.0, -0.0275) == pytest.approx(2.5 * q, abs=1e-8)


@pytest.mark.long
def test_a_joint_that_is_like_others_is_predicted_better_for_it(monkeypatch: pytest.MonkeyPatch) -> None:
    """From 12 s of log, free runs over another one: half the error that smooth curves leave (geometric mean)."""
    errors = []
    for seed in (11, 12):
        p, none = layout(), np.zeros((layout().count, 1))
        offset, scale = p.dimensionless
        device = RbfModel(p, offset + scale * joint(seed), none, none, 1.0)
        train, fresh = log(device, seed, n=1200), log(device, seed + 100, n=1200)
        for learnt in (True, False):
            with monkeypatch.context() as patch:
                if not learnt:
                    patch.setattr(Population, "knows", lambda *_: False)
                model = identify_rbf([train])
            assert str(model.diagnostics["chosen"]).endswith("population prior") == learnt
            found = model.simulate(fresh.t, fresh.v, fresh.q[0], 0.0)
            errors.append(float(np.sqrt(np.mean((found.q - fresh.q) ** 2)) / np.ptp(fresh.q)))
    gains = np.log(errors[::2]) - np.log(errors[1::2])
    assert gains.mean() < np.log(0.5), errors
