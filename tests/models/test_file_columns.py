"""Every entry of a model's file has a unit and a meaning, as attributes in HDF5."""

from pathlib import Path

import h5py
import numpy as np
import pytest

from pipeline.models.paper.model import RbfPaperModel
from pipeline.store.hashing import flatten
from pipeline.store.trees import read_tree, write_tree
from tests.file_columns import columns


def test_units_and_meanings_stand_beside_the_numbers_and_do_not_count_in_the_hash(tmp_path: Path) -> None:
    model = RbfPaperModel(
        centres=np.linspace(-1e-2, 1e-2, 5),
        smoothing=1.0,
        weights=np.ones((4, 5)),
        lag_s=0.01,
        diagnostics={"rank": 20},
    )
    tree = {"rbf-paper": model.to_tree(), "units": {"q": "m"}}
    assert write_tree(tmp_path / "a.h5", tree, columns(model)) == write_tree(tmp_path / "b.h5", tree)
    with h5py.File(tmp_path / "a.h5") as file:
        told = {name: tuple(file[name].attrs[key] for key in ("unit", "meaning")) for name, _ in flatten(tree)}
    assert told["rbf-paper/weights"][0] == "N/m, N·s/m, N/V²"
    assert told["rbf-paper/width"] == ("m", "Width σ of the basis functions")
    assert told["rbf-paper/lag_s"][0] == "s"
    assert read_tree(tmp_path / "a.h5")["rbf-paper"]["width"] == pytest.approx(model.width)
