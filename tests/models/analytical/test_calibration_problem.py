"""The search of a calibration: along a curved valley, at a bound, and within its limit of simulations."""

from types import SimpleNamespace

import numpy as np
import pytest
from scipy.optimize import minimize

from pipeline.models.analytical import calibration_problem
from pipeline.models.analytical.calibration_problem import LOSS_SCALE, Ended, search


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

    def cost(self, x: np.ndarray) -> float:
        """Soft-L1 loss of the residuals."""
        return float(LOSS_SCALE**2 * (np.sqrt(1.0 + (self.residuals(x) / LOSS_SCALE) ** 2) - 1.0).sum())


def searched(valley: Valley, start: list[float], limit: int, tolerance: float) -> Ended:
    """End of a search in the valley."""
    return search(valley, np.array(start), limit, tolerance, lambda: None)  # type: ignore[arg-type]


@pytest.mark.parametrize("upper", [9.0, 1.5])
@pytest.mark.parametrize("curvature", [5.0, 30.0])
@pytest.mark.parametrize("start", [[1.0, 1.0, 1.0], [0.0, 0.0, 0.0]])
def test_it_finds_the_optimum_within_the_bounds(
    upper: float, start: list[float], curvature: float, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(calibration_problem, "SMALLEST_STEP", 1e-10)  # a calibration ends earlier
    valley = Valley(upper, curvature)
    bounds = list(zip(valley.problem.lower, valley.problem.upper, strict=True))
    known = minimize(
        valley.cost, np.array(start), bounds=bounds, method="SLSQP", options={"ftol": 1e-14, "maxiter": 2000}
    )
    found = searched(valley, start, 2000, 1e-9)
    assert found.converged and found.cost == pytest.approx(known.fun, rel=1e-6)
    assert found.x == pytest.approx(known.x, abs=1e-4)
    assert (found.x >= valley.problem.lower).all() and (found.x <= valley.problem.upper).all()


def test_it_ends_after_so_many_simulations_and_more_of_them_reach_further() -> None:
    costs = []
    for limit in (1, 12):
        valley = Valley(9.0, 30.0)
        found = searched(valley, [0.5, 2.0, 0.0], limit, 1e-12)
        assert not found.converged and found.evaluations == valley.problem.evaluations == limit
        costs.append(found.cost)
    assert costs[1] < costs[0]
