"""Levenberg-Marquardt with several dampings at once finds minima of curved valleys."""

import numpy as np
import pytest

from pipeline.fitting.descent import ParallelDescent, Prior
from pipeline.fitting.homotopy import Callbacks, Schedule, fit_homotopy
from pipeline.numerics.arrays import FloatArray


class Valley:
    """Rosenbrock's valley as a least-squares problem with the minimum at (1, 1); lost where x < −2."""

    def residual(self, theta: FloatArray, gain: float) -> FloatArray | None:
        return self.residuals(theta[None], gain)[0]

    def residuals(self, thetas: FloatArray, gain: float) -> FloatArray:
        x, y = thetas.T
        found = np.column_stack([10.0 * (y - x**2), 1.0 - x])
        found[x < -2.0] = np.nan
        return found

    def jacobian(self, theta: FloatArray, gain: float) -> tuple[FloatArray, FloatArray]:
        return self.residuals(theta[None], gain)[0], np.array([[-20.0 * theta[0], 10.0], [-1.0, 0.0]])


@pytest.mark.parametrize("start", [(-1.2, 1.0), (1.9, -4.0), (-1.9, 3.0)])
def test_the_minimum_of_a_curved_valley_is_found(start: tuple[float, float]) -> None:
    weak = Prior(1e-6 * np.eye(2), np.zeros(2))
    fit = fit_homotopy(
        Valley(), np.array(start), weak, Schedule((0.0,), last_iterations=60), descent=ParallelDescent
    )  # fmt: skip
    np.testing.assert_allclose(fit.theta, [1.0, 1.0], atol=1e-3)
    assert fit.reached_last


def test_the_prior_decides_where_data_say_nothing() -> None:
    class Blind(Valley):
        def residuals(self, thetas: FloatArray, gain: float) -> FloatArray:
            return np.column_stack([thetas[:, 0] - 3.0, 0.0 * thetas[:, 1] + 1.0])

        def jacobian(self, theta: FloatArray, gain: float) -> tuple[FloatArray, FloatArray]:
            return self.residuals(theta[None], gain)[0], np.array([[1.0, 0.0], [0.0, 0.0]])

    prior = Prior(1e-3 * np.eye(2), np.array([0.0, 1e-3 * 0.7]))
    fit = fit_homotopy(Blind(), np.zeros(2), prior, Schedule((0.0,), last_iterations=20), descent=ParallelDescent)
    np.testing.assert_allclose(fit.theta, [3.0, 0.7], atol=1e-3)


@pytest.mark.parametrize(("lost_from", "levels", "reached"), [(9, 3, True), (2, 2, False), (1, 1, False)])
def test_the_last_level_is_reached_only_where_a_run_comes_to_its_end(
    lost_from: int, levels: int, reached: bool
) -> None:
    """Also where the last gain stands twice and the simulation is lost at the second of the two."""
    begun: list[float] = []

    class Lost(Valley):
        def residual(self, theta: FloatArray, gain: float) -> FloatArray | None:
            return None if len(begun) > lost_from else super().residual(theta, gain)

    fit = fit_homotopy(
        Lost(), np.array([0.5, 0.5]), Prior(1e-6 * np.eye(2), np.zeros(2)), Schedule((8.0, 0.0, 0.0)),
        callbacks=Callbacks(begin=lambda theta, gain: begun.append(gain)),
    )  # fmt: skip
    assert (len(fit.levels), fit.reached_last) == (levels, reached)
    assert not (fit.converged and not reached)
