"""NRMSE against its definition, its invariances and its undefined cases."""

from collections.abc import Callable

import numpy as np
import pytest
from hypothesis import given, strategies as st

from pipeline.errors import InputError
from pipeline.numerics.metrics import fit_percent, nrmse, rmse, signal_range

finite = st.floats(-1e6, 1e6, allow_nan=False, width=64)


def test_nrmse_of_a_constant_offset_is_the_offset_over_the_range() -> None:
    measured = np.array([0.0, 4.0, 1.0, 3.0])
    assert nrmse(measured, measured + 0.2) == pytest.approx(0.05, rel=1e-12)


def test_rmse_by_hand() -> None:
    assert rmse(np.array([0.0, 0.0]), np.array([3.0, 4.0])) == pytest.approx(np.sqrt(12.5))


@given(st.lists(st.tuples(finite, finite), min_size=2, max_size=30), st.floats(1e-3, 1e3), finite)
def test_nrmse_does_not_depend_on_unit_or_origin(pairs: list[tuple[float, float]], unit: float, origin: float) -> None:
    measured, calculated = (np.array(column) for column in zip(*pairs, strict=True))
    plain = nrmse(measured, calculated)
    if plain is None or signal_range(measured) < 1e-2:  # below, the shift itself rounds the range away
        return
    moved = nrmse(unit * measured + origin, unit * calculated + origin)
    assert moved == pytest.approx(plain, rel=1e-4, abs=1e-4)


def test_masked_rows_are_left_out_whatever_was_calculated_there() -> None:
    measured = np.array([0.0, np.nan, 1.0, np.nan])
    calculated = np.array([0.1, 1e9, 0.9, np.nan])
    assert nrmse(measured, calculated) == pytest.approx(0.1)


@pytest.mark.parametrize(
    ("measured", "calculated"),
    [
        ([1.0, 1.0], [1.0, 2.0]),
        ([1.0, 2.0], [1.0, np.nan]),
        ([1.0, 2.0], [1.0, np.inf]),
        ([np.nan, np.nan], [1.0, 2.0]),
        ([], []),
    ],
    ids=["constant", "nan", "inf", "all masked", "empty"],
)
def test_undefined_is_none_and_never_nan(measured: list[float], calculated: list[float]) -> None:
    assert nrmse(np.array(measured), np.array(calculated)) is None


def test_huge_and_tiny_errors_neither_overflow_nor_vanish() -> None:
    assert rmse(np.zeros(3), np.full(3, 1e200)) == pytest.approx(1e200)
    assert rmse(np.zeros(3), np.full(3, 1e-200)) == pytest.approx(1e-200)


@pytest.mark.parametrize("measure", [rmse, nrmse, fit_percent])
def test_unequal_lengths_are_refused(measure: Callable[..., float | None]) -> None:
    for calculated in (np.zeros(4), np.zeros((3, 1))):
        with pytest.raises(InputError, match="equally long"):
            measure(np.zeros(3), calculated)


def test_the_fit_is_that_of_matlabs_compare() -> None:
    measured = np.array([0.0, 4.0, np.nan, 1.0, 3.0])
    known = measured[np.isfinite(measured)]
    away = np.linalg.norm(known - known.mean())
    assert fit_percent(measured, np.nan_to_num(measured)) == 100.0
    assert fit_percent(measured, np.full(5, known.mean())) == pytest.approx(0.0, abs=1e-12)
    assert fit_percent(measured, measured + 2.0) == pytest.approx(100.0 * (1.0 - 4.0 / away))
    assert fit_percent(np.ones(3), np.zeros(3)) is None  # a constant has no spread
    assert fit_percent(np.full(7, 0.1), np.zeros(7)) is None  # though its computed spread is 1e-17
    assert fit_percent(measured, np.full(5, np.inf)) is None
