"""Every model has one true name, and older names are told from the present ones."""

import pytest

from pipeline.errors import CorruptArtifactError, InputError
from pipeline.model_list import AUTO, ENTRIES, entry, names
from pipeline.models.hybrid.model import HybridModel
from pipeline.models.kind import Kind, kind, model_from_tree


def test_each_entry_leads_to_a_kind_and_names_are_unique() -> None:
    assert len({one.name for one in ENTRIES}) == len(ENTRIES)
    assert AUTO not in {one.name for one in ENTRIES}
    for one in ENTRIES:
        assert isinstance(kind(one.name), Kind)
    assert set(names("identify")) == {"hybrid", "rbf", "rbf-paper"}
    assert HybridModel.name == "hybrid" and entry("hybrid") is not None


def test_an_unknown_name_is_answered_with_those_that_are_there() -> None:
    with pytest.raises(InputError, match=r"no model 'sindi'.*hybrid.*sindy"):
        kind("sindi")


def test_a_hybrid_joint_of_an_older_run_is_refused_by_its_old_name() -> None:
    with pytest.raises(CorruptArtifactError, match=r"older debist .* `hybrid`: run `debist run PROTOTYPE.toml -o RUN`"):
        model_from_tree("rbf", {"kind": "hybrid"})
