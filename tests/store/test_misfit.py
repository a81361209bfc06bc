"""Tables that are read back from a run have the columns that their readers take from them."""

import numpy as np
import pytest

from pipeline.errors import CorruptArtifactError
from pipeline.store.schemas import SCORES, Document, misfit


def table() -> dict[str, np.ndarray]:
    return {
        "t": np.arange(3.0), "q": np.zeros(3), "v1": np.zeros(3), "segment": np.zeros(3, dtype=np.int32),
    }  # fmt: skip


@pytest.mark.parametrize(
    ("change", "text"),
    [
        ({}, None),
        ({"q": None}, "lacks the column q"),
        ({"extra": np.zeros(3)}, "that no record has"),
        ({"q": np.array(["1", "2", "3"], dtype=object)}, "q does not hold float64"),
        ({"segment": np.zeros(3)}, "segment does not hold int32"),
        ({"t": np.array([0.0, 0.0, 1.0])}, "t does not rise"),
        ({"t": np.array([0.0, np.nan, 1.0])}, "t does not rise"),
    ],
)
def test_a_table_of_other_columns_is_refused(change: dict, text: str | None) -> None:
    changed = {name: column for name, column in (table() | change).items() if column is not None}
    found = misfit("train/a/record.parquet", changed)
    assert found is None if text is None else found is not None and text in found


def test_tables_without_a_schema_hold_numbers_where_they_are_read() -> None:
    """Studies of earlier releases are compared, not read."""
    names = {"q": np.zeros(2), "model": np.array(["rbf", "sindy"], dtype=object)}
    assert misfit("curves.parquet", names) == "model does not hold numbers"
    assert misfit("studies/folds.parquet", names) is None


def test_scores_of_earlier_releases_have_more_columns() -> None:
    empty = {"float64": np.zeros(0), "int64": np.zeros(0, dtype=np.int64), "bool": np.zeros(0, dtype=object)}
    scores = {column.key: empty.get(column.dtype, empty["bool"]) for column in SCORES.columns}
    assert misfit("scores.parquet", scores | {"rise_error_s": np.zeros(0)}) is None
    assert misfit("scores.parquet", scores | {"extra": np.zeros(0)}) is not None


def test_a_missing_key_of_a_document_names_file_key_and_remedy() -> None:
    document = Document({"rows": [{"log": "a"}], "grades": {"data": "good"}}, "run/check.json", "`debist run` makes it")
    assert document["grades"] == {"data": "good"} and document.get("model") is None
    with pytest.raises(
        CorruptArtifactError, match=r"^run/check\.json\.rows\.0: state is missing; `debist run` makes it$"
    ):
        document["rows"][0]["state"]
