"""HDF5 trees come back as they were written."""

import time
from pathlib import Path

import h5py
import numpy as np
import pytest

from pipeline.errors import CorruptArtifactError
from pipeline.store.hashing import tree_hash
from pipeline.store.trees import read_tree, write_tree

TREE = {
    "rbf": {
        "centres": np.linspace(-1.0, 1.0, 7),
        "weights": np.eye(3),
        "empty": np.empty(0),
        "lag_s": 0.02,
        "rank": 40,
        "converged": True,
    },
    "names": np.array(["c", "d"]),
    "note": "m·s² <script>",
}


def test_round_trip(tmp_path: Path) -> None:
    digest = write_tree(tmp_path / "m.h5", TREE)
    back = read_tree(tmp_path / "m.h5")
    assert tree_hash(back) == digest == tree_hash(TREE)
    np.testing.assert_array_equal(back["rbf"]["weights"], np.eye(3))
    assert back["note"] == TREE["note"]
    assert back["rbf"]["lag_s"] == 0.02
    assert list(back["names"]) == ["c", "d"]


def test_equal_trees_are_equal_bytes(tmp_path: Path) -> None:
    write_tree(tmp_path / "a.h5", TREE)
    write_tree(tmp_path / "b.h5", TREE)
    assert (tmp_path / "a.h5").read_bytes() == (tmp_path / "b.h5").read_bytes()


def _dataset(**options):
    return lambda file: file.create_dataset("x", **options)


def _paths(file) -> None:
    """Each group leads twice to the next one: 2⁶⁰ paths."""
    group = file.create_group("g")
    for _ in range(60):
        inner = group.create_group("a")
        group["b"] = inner
        group = inner


def _itself(file) -> None:
    file["me"] = file["/"]


BOMBS = {
    "chunks never written": (
        _dataset(shape=(3 * 10**9,), dtype="f8", chunks=(1 << 20,), compression="gzip"),
        "declares",
    ),
    "space never written": (_dataset(shape=(3 * 10**9,), dtype="f8"), "declares"),
    "one huge chunk": (
        _dataset(shape=(9,), maxshape=(None,), dtype="f8", chunks=(4 * 10**8,), compression="gzip"),
        "declares",
    ),
    "packed zeros": (_dataset(data=np.zeros(40_000_000), compression="gzip", shuffle=True), "declares 320 MB"),
    "other filters": (_dataset(data=np.zeros(2000), compression="lzf"), "packed"),
    "packed texts": (_dataset(data=["a"] * 9, dtype=h5py.string_dtype(), compression="gzip"), "of type"),
    "records": (_dataset(data=np.zeros(3, dtype=[("a", "f8")])), "of type"),
    "another file": (_dataset(shape=(10,), dtype="u1", external=[("/etc/passwd", 0, 10)]), "other files"),
    "paths": (_paths, "more entries"),
    "a circle": (_itself, "more entries"),
}


@pytest.mark.parametrize("name", BOMBS)
def test_a_file_that_declares_more_than_it_holds_is_refused_unread(tmp_path: Path, name: str) -> None:
    make, reason = BOMBS[name]
    with h5py.File(tmp_path / "m.h5", "w") as file:
        make(file)
    began = time.process_time()
    with pytest.raises(CorruptArtifactError, match=rf"m\.h5: damaged.*{reason}"):
        read_tree(tmp_path / "m.h5")
    assert time.process_time() - began < 2.0


def test_links_are_refused(tmp_path: Path) -> None:
    with h5py.File(tmp_path / "m.h5", "w") as file:
        file["x"] = h5py.ExternalLink("/etc/passwd", "/")
    with pytest.raises(CorruptArtifactError, match="link"):
        read_tree(tmp_path / "m.h5")


def test_a_truncated_file_is_named(tmp_path: Path) -> None:
    write_tree(tmp_path / "m.h5", TREE)
    whole = (tmp_path / "m.h5").read_bytes()
    (tmp_path / "m.h5").write_bytes(whole[: len(whole) // 2])
    with pytest.raises(CorruptArtifactError, match=r"m\.h5"):
        read_tree(tmp_path / "m.h5")
