"""What is read back from a run has the entries, kinds and columns that its readers take from it."""

import json
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from pipeline.errors import CorruptArtifactError
from pipeline.store import layout
from pipeline.store.documents import read_document
from pipeline.store.schemas import misfit

MAP = {
    "maps": [{"to": "right", "voltages": [1.0], "durations": [0.1], "probability": [[0.5]], "lowest": []}],
    "more": 1.5,
}


class Held:
    """Stands in for a run that holds one document."""

    def __init__(self, content: bytes) -> None:
        self.content = content

    def read_bytes(self, name: str) -> bytes:
        return self.content

    def path(self, name: str) -> Path:
        return Path("run", name)


def read(name: str, content: bytes) -> dict:
    return read_document(Held(content), name)  # type: ignore[arg-type]


@pytest.mark.parametrize(
    "content",
    [
        b"", b"[]", b"null", b"{", b"\xff", b"[" * 100_000, b'{"maps": 1}', b'{"maps": [{}]}',
        json.dumps(MAP).replace("0.5", "NaN").encode(), json.dumps(MAP).replace("1.5", "1e999").encode(),
        json.dumps(MAP).replace("1.5", "NaN").encode(), json.dumps(MAP).replace('"right"', '"up"').encode(),
        json.dumps(MAP).replace("[[0.5]]", "[0.5]").encode(),
    ],
)  # fmt: skip
def test_a_document_of_another_kind_is_refused_in_one_line(content: bytes) -> None:
    with pytest.raises(CorruptArtifactError, match=r"^run/control/map\.json: .*debist control map") as refused:
        read(layout.control("map"), content)
    assert "\n" not in str(refused.value)


@settings(max_examples=30, deadline=None)
@given(
    st.recursive(st.none() | st.floats() | st.text() | st.booleans(), st.lists) | st.dictionaries(st.text(), st.text())
)
def test_any_json_is_refused_or_read(value: object) -> None:
    for name in ("linear", "map", "design", "pulse-to-left"):
        with pytest.raises(CorruptArtifactError):
            read(layout.control(name), json.dumps(value).encode())


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
