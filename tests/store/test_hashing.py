"""Content hashes depend on the content and on nothing else."""

import hashlib
import json
import struct
from pathlib import Path
from typing import Any

import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq
import pytest
from hypothesis import given, strategies as st
from hypothesis.extra.numpy import arrays

from pipeline.device.device import JOINT
from pipeline.errors import CorruptArtifactError
from pipeline.store import tables
from pipeline.store.hashing import ColumnDigest, table_hash, tree_hash
from pipeline.store.schemas import SIGNALS, Schema, schema_of

SCHEMA = schema_of(SIGNALS, JOINT)


def _signals(n: int = 5000) -> dict[str, np.ndarray]:
    rng = np.random.default_rng(1)
    columns = {name: rng.normal(size=n) for name in ("t", "q", "v1", "v2")}
    columns["q"][3] = np.nan
    return columns | {"segment": np.zeros(n, dtype=np.int32)}


def _content_hash(schema: Schema, columns: dict[str, np.ndarray]) -> str:
    return table_hash((c.key, c.dtype, c.unit, columns[c.key]) for c in schema.columns)


@given(arrays(np.float64, 7, elements=st.floats(allow_nan=True)))
def test_one_nan_and_one_zero(values: np.ndarray) -> None:
    other = values.copy()
    other[np.isnan(other)] = -np.nan
    other[other == 0.0] = -0.0
    assert ColumnDigest(other).hexdigest() == ColumnDigest(values).hexdigest()


@given(arrays(np.float64, 7, elements=st.floats(-1e300, 1e300)), st.integers(0, 6))
def test_the_smallest_change_shows(values: np.ndarray, index: int) -> None:
    other = values.copy()
    other[index] = np.nextafter(other[index], np.inf)
    changed = other[index] != values[index]
    assert (ColumnDigest(other).hexdigest() != ColumnDigest(values).hexdigest()) == changed


def test_order_of_columns_does_not_matter_but_units_do() -> None:
    a, b = ("a", "float64", "m", np.ones(3)), ("b", "float64", "s", np.zeros(3))
    assert table_hash([a, b]) == table_hash([b, a])
    assert table_hash([a]) != table_hash([("a", "float64", "mm", np.ones(3))])


def test_the_content_hash_is_what_the_description_says() -> None:
    """Worked out here from the description alone, so that no version of a library can move it unnoticed."""

    def digest(content: bytes) -> str:
        return hashlib.sha256(content).hexdigest()

    q = digest(struct.pack("<4d", 1.5, 0.0, 0.0, float("nan")))
    n = digest(struct.pack("<4q", 0, 1, -2, 3))
    name = digest(b"".join(struct.pack("<Q", len(text)) + text for text in (b"a", "ß".encode(), b"", b"b")))
    document = [["n", "int32", "1", [4], n], ["name", "string", "1", [4], name], ["q", "float64", "m", [4], q]]
    expected = digest(json.dumps(document, separators=(",", ":")).encode())
    assert expected == table_hash(
        [
            ("q", "float64", "m", np.array([1.5, -0.0, 0.0, -np.nan])),
            ("name", "string", "1", np.array(["a", "ß", "", "b"])),
            ("n", "int32", "1", np.array([0, 1, -2, 3], dtype=np.int32)),
        ]
    )


@pytest.mark.parametrize("size", [1, 999, 5000])
def test_neither_file_nor_hash_depends_on_the_pieces_it_was_written_in(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, size: int
) -> None:
    monkeypatch.setattr(tables, "_ROW_GROUP", 1700)
    columns = _signals()
    whole = tables.write_pieces(tmp_path / "whole.parquet", SCHEMA, [columns])
    pieces = ({name: column[i : i + size] for name, column in columns.items()} for i in range(0, 5000, size))
    assert tables.write_pieces(tmp_path / "pieces.parquet", SCHEMA, pieces) == whole
    assert (tmp_path / "pieces.parquet").read_bytes() == (tmp_path / "whole.parquet").read_bytes()
    assert pq.ParquetFile(tmp_path / "whole.parquet").num_row_groups == 3


_REWRITES: list[dict[str, Any]] = [
    {"compression": "snappy"},
    {"compression": "none"},
    {"row_group_size": 100},
    {"use_dictionary": True},
    {"version": "1.0", "data_page_version": "2.0"},
    {"use_byte_stream_split": ["q"], "use_dictionary": False},
]


@pytest.mark.parametrize("options", _REWRITES, ids=str)
def test_the_hash_survives_another_codec_layout_and_other_row_groups(tmp_path: Path, options: dict[str, Any]) -> None:
    path = tmp_path / "signals.parquet"
    written = tables.write_pieces(path, SCHEMA, [_signals()])
    pq.write_table(pq.read_table(path), tmp_path / "other.parquet", **options)
    assert (tmp_path / "other.parquet").read_bytes() != path.read_bytes()
    assert _content_hash(SCHEMA, tables.read_table(tmp_path / "other.parquet")) == written


def test_trees_hash_by_path_and_value() -> None:
    tree = {"rbf": {"centres": np.arange(3.0), "lag_s": 0.02}, "units": {"q": "m"}}
    assert tree_hash(tree) == tree_hash({"units": {"q": "m"}, "rbf": {"lag_s": 0.02, "centres": np.arange(3.0)}})
    assert tree_hash(tree) != tree_hash({**tree, "units": {"q": "rad"}})


@pytest.mark.parametrize("kind", ["nulls", "one long text"])
def test_a_table_that_declares_more_than_it_holds_is_refused_unread(tmp_path: Path, kind: str) -> None:
    """Nulls, and rows that all name one long text, take next to no bytes."""
    path = tmp_path / "t.parquet"
    text = pa.DictionaryArray.from_arrays(np.zeros(10**5, "i4"), ["x" * 10**4])
    pq.write_table(pa.table({"x": pa.nulls(10**8, pa.float64()) if kind == "nulls" else text}), path)
    assert path.stat().st_size < 10**6
    with pytest.raises(CorruptArtifactError, match=r"t\.parquet: damaged \(declares .* MB in a file of"):
        tables.read_table(path)
