"""When numbers count as close or different."""

import numpy as np
import pytest

from pipeline.workflow.studies.diff import DIGITS, RunDifferences, changes, compared_columns

UNIT = 10.0 ** (1 - DIGITS)
"""That of the last digit to which columns with a largest magnitude from 1 to 10 are compared."""


def state(one: float, other: float) -> str:
    columns = [{"x": np.array([1.0, value])} for value in (one, other)]
    return compared_columns("a", *columns).state


@pytest.mark.parametrize(
    ("apart", "expected"), [(0.2, "close"), (0.8, "close"), (1.0 - 1e-6, "close"), (1.1, "differs"), (3.0, "differs")]
)
def test_numbers_are_close_up_to_one_unit(apart: float, expected: str) -> None:
    assert state(2000.4 * UNIT, (2000.4 + apart) * UNIT) == expected


def test_no_difference_is_alarming_where_a_larger_one_is_not() -> None:
    values = 0.2 + UNIT * np.linspace(-0.5, 0.5, 41)
    for one in values:
        assert all(state(one, other) in ("equal", "close") for other in values if abs(other - one) < UNIT)


def test_runs_whose_numbers_are_close_are_equal() -> None:
    close = compared_columns("a", {"x": np.array([1.0, 2000.4 * UNIT])}, {"x": np.array([1.0, 2000.6 * UNIT])})
    assert close.state == "close" and close.deviation == pytest.approx(0.2 * UNIT)
    assert RunDifferences(("a", "b"), (), (), (), (), (), ((close,),)).equal


def test_only_keys_that_differ_by_more_than_rounding_are_changes() -> None:
    runs = [{"a": 1.0, "b": "x", "c": None}, {"a": 1.0 + 1e-8, "b": "y"}, {"a": 1.0, "b": "x", "d": 2.0}]
    assert [(row.key, row.values) for row in changes(runs)] == [("b", ("x", "y", "x")), ("d", (None, None, 2.0))]
