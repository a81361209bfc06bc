import numpy as np
import pytest

from pipeline.fitting.regression import pseudo_inverse_fit, triangular_factor


def blocks(matrix, right, rows):
    stacked = np.column_stack((matrix, right))
    return [stacked[i : i + rows].copy() for i in range(0, len(stacked), rows)]


@pytest.mark.parametrize("rows", [3, 17, 500])
def test_blockwise_fit_equals_numpy_lstsq_although_the_columns_differ_by_twelve_decades(rows):
    rng = np.random.default_rng(3)
    matrix = rng.standard_normal((400, 6)) * np.logspace(-6, 6, 6)
    right = rng.standard_normal(400)
    fit = pseudo_inverse_fit(*triangular_factor(blocks(matrix, right, rows)))
    scaled = np.linalg.lstsq(matrix / np.logspace(-6, 6, 6), right, rcond=None)[0] / np.logspace(-6, 6, 6)
    assert fit.weights == pytest.approx(scaled, rel=1e-10)
    assert fit.rank == 6
    assert fit.samples == 400
    covariance = np.linalg.inv((matrix / np.logspace(-6, 6, 6)).T @ (matrix / np.logspace(-6, 6, 6)))
    scales = np.logspace(-6, 6, 6)
    assert fit.spread @ fit.spread.T * np.outer(scales, scales) == pytest.approx(covariance, rel=1e-8, abs=1e-12)
    assert fit.residual_rms == pytest.approx(np.sqrt(np.mean((right - matrix @ scaled) ** 2)), rel=1e-12)


def test_equal_columns_share_the_weight_and_lower_the_rank():
    rng = np.random.default_rng(4)
    column = rng.standard_normal(50)
    fit = pseudo_inverse_fit(*triangular_factor(blocks(np.column_stack((column, column)), 2 * column, 8)))
    assert fit.rank == 1
    assert fit.weights == pytest.approx([1.0, 1.0])
    assert fit.condition > 1e12
