"""Columns made from buffers are those that pyarrow makes."""

from typing import Any

import numpy as np
import pyarrow as pa
import pytest

from pipeline.store.arrow_columns import from_numpy, to_numpy

MIXED: list[tuple[list[Any], Any]] = [
    ([1.5, None, -0.0, float("inf")], pa.float64()),
    ([3, None, -7], pa.int32()),
    ([2**40, None, 0], pa.int64()),
    ([True, None, False, *[True] * 9], pa.bool_()),
    (["well", None, "", "µm · Weg"], pa.string()),
]


@pytest.mark.parametrize(("values", "kind"), MIXED)
def test_lists_with_and_without_null(values: list[Any], kind: Any) -> None:
    for entries in (values, [entry for entry in values if entry is not None], [None], []):
        made = from_numpy(entries, kind)
        made.validate(full=True)
        assert made.equals(pa.array(entries, type=kind))
        assert made.null_count == entries.count(None)


def test_arrays() -> None:
    assert from_numpy(np.array([1.0, np.nan]), pa.float64()).null_count == 0
    assert from_numpy(np.array([True, False]), pa.bool_()).to_pylist() == [True, False]
    assert from_numpy(np.array(["a", "bc"], dtype=object), pa.string()).to_pylist() == ["a", "bc"]
    back = to_numpy(pa.chunked_array([from_numpy(np.arange(5), pa.int64())]))
    assert back.tolist() == [0, 1, 2, 3, 4]


def test_another_type_is_refused() -> None:
    with pytest.raises(TypeError, match="date32"):
        from_numpy([None], pa.date32())
