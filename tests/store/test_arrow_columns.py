"""Columns made from buffers are those that pyarrow makes."""

from typing import Any

import pyarrow as pa
import pytest

from pipeline.store.arrow_columns import from_numpy

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
