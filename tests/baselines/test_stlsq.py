"""The written-out STLSQ gives what pysindy's gives."""

import warnings

import numpy as np
import pytest

from pipeline.baselines.sparse_regression import stlsq


@pytest.mark.parametrize("threshold", [0.0, 0.05, 0.3, 1.5, 100.0])
@pytest.mark.parametrize("seed", range(4))
def test_it_is_that_of_pysindy(threshold: float, seed: int) -> None:
    import pysindy

    rng = np.random.default_rng(seed)
    library = rng.standard_normal((60, 14)) @ (np.eye(14) + 0.6 * rng.standard_normal((14, 14)))
    library[:, 13] = library[:, 12] + 1e-3 * rng.standard_normal(60)  # nearly the same term twice
    sparse = np.where(rng.random(14) < 0.4, rng.standard_normal(14), 0.0)
    target = library @ sparse + 0.3 * rng.standard_normal(60)
    theirs = pysindy.STLSQ(threshold=threshold, alpha=1e-3, max_iter=50)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", UserWarning)
        theirs.fit(library, target[:, None])
    assert stlsq(library, target, threshold, 1e-3) == pytest.approx(theirs.coef_[0], rel=1e-8, abs=1e-12)
