"""Which models a run holds, and why the main model was chosen."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from pipeline.errors import InputError
from pipeline.models.hybrid.parameters import NAMES
from pipeline.settings.prototype import Prototype, parse_prototype
from pipeline.signals.log import Log
from pipeline.store.manifest import Recipe
from pipeline.store.run_folder import RunFolder
from pipeline.workflow.run_contents import compared_models, identified_models, model_artifact, subject_on
from tests.export.joints import hybrid, pulses

CHANNELS = {name: {"channel": name, "unit": unit} for name, unit in (("q", "mm"), ("v1", "kV"), ("v2", "kV"))}


@pytest.fixture
def run(tmp_path: Path) -> tuple[RunFolder, Prototype]:
    prototype = parse_prototype({"name": "P", "logs": {"train": ["a.csv"]}, "channels": CHANNELS}, "P.toml")
    return RunFolder.create(tmp_path / "run", prototype.model_dump(mode="json"), tmp_path / "P.toml"), prototype


def _commit(folder: RunFolder, name: str, notes: dict[str, object]) -> None:
    folder.commit(Recipe("test", "1", {}, {}), {name: folder.write_tree(name, {"x": 1.0}, notes)})


def test_the_chosen_model_has_its_true_name_and_is_the_headline(run: tuple[RunFolder, Prototype]) -> None:
    _commit(run[0], "model.h5", {"identified": ["rbf", "rbf-paper"]})
    _commit(run[0], "baselines/sindy.h5", {})
    assert identified_models(*run) == ("rbf", "rbf-paper")
    assert compared_models(*run) == ("sindy",)
    assert model_artifact(*run, None) == ("rbf", "model.h5")
    assert model_artifact(*run, "sindy") == ("sindy", "baselines/sindy.h5")
    with pytest.raises(InputError, match=r"no model 'hybrid'; it holds rbf, rbf-paper, sindy"):
        model_artifact(*run, "hybrid")


def test_an_export_does_not_depend_on_the_clock_of_its_log(run: tuple[RunFolder, Prototype]) -> None:
    """A joint softens while it is used; its log may begin at any time of the recorder."""
    model = hybrid(centres=0)
    theta = model.theta.copy()
    theta[NAMES.index("softening")] = 3.0
    model, (t, v) = replace(model, theta=theta), pulses(4.0)
    path = model.simulate(t, v, -0.0105, 0.0)
    log = Log(t, path.q, path.qdot, path.qddot, v)
    late = replace(log, t=t + 12.345)
    subjects = [subject_on(each, model, run[1], [each], "hybrid", "origin") for each in (log, late)]
    runs = [model.simulate(each.t, each.v, *each.start).q for each in subjects]
    assert np.abs(runs[1] - runs[0]).max() < 1e-9
    assert np.abs(model.simulate(late.t, v, *subjects[1].start).q - runs[0]).max() > 1e-5
