"""The search of a calibration finds what SciPy's finds, also along a curved valley and at a bound."""

from types import SimpleNamespace

import numpy as np
import pytest
from scipy.optimize import least_squares

from pipeline.models.analytical.calibration_search import LOSS_SCALE, search


class Valley:
    """Residuals of a curved valley (Rosenbrock's), with outliers that the loss takes as such."""

    def __init__(self, upper: float, curvature: float) -> None:
        self.problem = SimpleNamespace(lower=np.full(3, -3.0), upper=np.array([upper, 9.0, 9.0]), evaluations=0)
        self.curvature = curvature

    def residuals(self, x: np.ndarray) -> np.ndarray:
        self.problem.evaluations += 1
        valley = self.curvature * np.array([x[1] - x[0] ** 2, x[2] - x[1] ** 2])
        return np.concatenate([valley, [2.0 - x[0], x[2] - 40.0], 0.05 * x])

    def jacobian(self, x: np.ndarray) -> np.ndarray:
        valley = self.curvature * np.array([[-2.0 * x[0], 1.0, 0.0], [0.0, -2.0 * x[1], 1.0]])
        return np.vstack([valley, [[-1.0, 0.0, 0.0], [0.0, 0.0, 1.0]], 0.05 * np.eye(3)])


@pytest.mark.parametrize("upper", [9.0, 1.5])
@pytest.mark.parametrize("curvature", [5.0, 30.0])
@pytest.mark.parametrize("start", [[1.0, 1.0, 1.0], [0.0, 0.0, 0.0]])
def test_it_finds_the_optimum_that_scipy_finds(upper: float, start: list[float], curvature: float) -> None:
    valley, at = Valley(upper, curvature), np.array(start)
    found = search(valley, at, 500, 1e-12, lambda: None)  # type: ignore[arg-type]
    bounds = (valley.problem.lower, valley.problem.upper)
    known = least_squares(
        valley.residuals, at, valley.jacobian, bounds=bounds, loss="soft_l1", f_scale=LOSS_SCALE, ftol=1e-14,
        xtol=1e-14, gtol=1e-14, max_nfev=5000,
    )  # fmt: skip
    assert found.converged and found.cost == pytest.approx(known.cost, rel=1e-6)
    assert found.x == pytest.approx(known.x, abs=1e-4)
    assert (found.x >= bounds[0]).all() and (found.x <= bounds[1]).all()


def test_it_ends_after_so_many_simulations_or_where_a_rival_is_far_ahead() -> None:
    def ended(limit: int, rival: float = np.inf) -> tuple[int, float]:
        """Simulations made, and the cost that they reached."""
        valley = Valley(9.0, 30.0)
        found = search(valley, np.array([0.5, 2.0, 0.0]), limit, 1e-12, lambda: None, rival)  # type: ignore[arg-type]
        assert not found.converged and found.evaluations == valley.problem.evaluations
        return found.evaluations, found.cost

    begin, whole = ended(1), ended(12)
    assert begin[0] == 1 and whole[0] == 12 and whole[1] < begin[1]
    assert ended(12, 1e-3)[0] < 12 and ended(12, whole[1]) == whole
