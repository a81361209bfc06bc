"""What is written out of pysindy and scikit-learn gives what they give."""

import warnings

import numpy as np
import pytest

from pipeline.baselines.narx_fit import matching_pursuit
from pipeline.baselines.polynomial_dynamics import FIRST_INPUT, QDOT, Q
from pipeline.baselines.sindy_default import fit_default_sindy
from pipeline.baselines.sparse_regression import sr3, stlsq
from pipeline.numerics.arrays import FloatArray
from pipeline.signals.trajectory import Trajectory


def _regression(seed: int) -> tuple[FloatArray, FloatArray]:
    rng = np.random.default_rng(seed)
    library = rng.standard_normal((60, 14)) @ (np.eye(14) + 0.6 * rng.standard_normal((14, 14)))
    library[:, 13] = library[:, 12] + 1e-3 * rng.standard_normal(60)  # nearly the same term twice
    sparse = np.where(rng.random(14) < 0.4, rng.standard_normal(14), 0.0)
    return library, library @ sparse + 0.3 * rng.standard_normal(60)


@pytest.mark.parametrize("threshold", [0.0, 0.05, 0.3, 1.5, 100.0])
@pytest.mark.parametrize("seed", range(4))
def test_stlsq_is_that_of_pysindy(threshold: float, seed: int) -> None:
    import pysindy

    library, target = _regression(seed)
    theirs = pysindy.STLSQ(threshold=threshold, alpha=1e-3, max_iter=50)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", UserWarning)
        theirs.fit(library, target[:, None])
    assert stlsq(library, target, threshold, 1e-3) == pytest.approx(theirs.coef_[0], rel=1e-8, abs=1e-12)


@pytest.mark.parametrize("threshold", [0.0, 0.05, 0.3, 1.5, 100.0])
@pytest.mark.parametrize("seed", range(4))
def test_sr3_is_that_of_pysindy(threshold: float, seed: int) -> None:
    import pysindy

    library, target = _regression(seed)
    theirs = pysindy.SR3(reg_weight_lam=threshold**2 / 2.0, relax_coeff_nu=1.0, max_iter=300, unbias=True)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", UserWarning)
        theirs.fit(library, target[:, None])
    assert sr3(library, target, threshold) == pytest.approx(theirs.coef_[0], rel=1e-6, abs=1e-9)


@pytest.mark.parametrize("squared", [True, False])
@pytest.mark.parametrize("logs", [1, 2])
def test_the_defaults_are_those_of_pysindy(squared: bool, logs: int) -> None:
    import pysindy

    length, volt = 1e-3, 1e3
    motions = []
    for seed in range(logs):
        t, rng = 0.01 * np.arange(600), np.random.default_rng(seed)
        v = 2000.0 * np.abs(np.sin(np.outer(t, [1.3, 0.7]) + seed)) * (np.sin(np.outer(t, [3.0, 2.0])) > 0.0)
        q = 0.008 * np.sin(9.0 * t) + 0.002 * np.cos(4.0 * t + seed) + 1e-5 * rng.standard_normal(t.size)
        motions.append(Trajectory(t, q, np.gradient(q, t), np.gradient(np.gradient(q, t), t), v))
    ours = fit_default_sindy(motions, squared=squared, units=(length, volt))
    model = pysindy.SINDy()
    scale = volt**2 if squared else volt
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", UserWarning)
        model.fit(
            [np.column_stack([x.q, x.qdot]) / length for x in motions],
            t=0.01,
            u=[(x.v**2 if squared else x.v) / scale for x in motions],
        )
    theirs = {
        tuple(row): column for row, column in zip(model.feature_library.powers_, model.coefficients().T, strict=True)
    }
    used = {power: column for power, column in theirs.items() if np.any(column != 0.0)}
    inputs = range(FIRST_INPUT, FIRST_INPUT + 2)
    found = {
        tuple(row[[Q, QDOT, *inputs]]): c / length for row, c in zip(ours.exponents, ours.coefficients.T, strict=True)
    }
    assert used and found.keys() == used.keys()
    for power, column in used.items():
        assert found[power] == pytest.approx(column, rel=1e-6, abs=1e-9)


@pytest.mark.parametrize("seed", range(4))
def test_the_pursuit_is_that_of_scikit_learn(seed: int) -> None:
    from sklearn.linear_model import orthogonal_mp_gram

    library, target = _regression(seed)
    library = library / np.linalg.norm(library, axis=0)
    gram, right = library.T @ library, library.T @ target
    theirs = orthogonal_mp_gram(gram, right, n_nonzero_coefs=9, return_path=True)
    assert matching_pursuit(gram, right, 9) == pytest.approx(np.asarray(theirs).T, rel=1e-7, abs=1e-10)
    library[:, 13] = library[:, 12]  # ends before it takes both
    gram, right = library.T @ library, library[:, :2] @ np.ones(2) @ library
    assert matching_pursuit(gram, right, 14)[-1] == pytest.approx([1.0, 1.0] + 12 * [0.0], abs=1e-6)
    assert (matching_pursuit(gram, np.zeros(14), 3) == 0.0).all()
