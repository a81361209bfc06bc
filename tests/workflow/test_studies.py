"""A study is made again when anything changes that it reads."""

import pytest

from pipeline.settings.prototype import Prototype, parse_prototype
from pipeline.workflow.studies.study import study_task

PLAIN = {
    "name": "d",
    "logs": {"train": ["log.csv"], "validation": ["other.csv"]},
    "channels": {key: {"channel": key, "unit": unit} for key, unit in (("q", "m"), ("v1", "V"), ("v2", "V"))},
}

CHANGES = {
    "inputs": {"plant": {"inputs": "linear"}},
    "inputs_before": {"plant": {"inputs_before": "zero"}},
    "mass": {"plant": {"mass": {"value": 0.04, "unit": "kg"}}},
    "basis_functions": {"identify": {"basis_functions": 12}},
    "smoothing": {"identify": {"smoothing": 0.7}},
    "order": {"differentiate": {"order": 2}},
    "models": {"identify": {"models": ["rbf"]}},
}

READ = {
    "alpha": {"order"},
    "basis": {"inputs", "inputs_before", "mass"},
    "data": {"inputs", "inputs_before", "mass", "basis_functions", "smoothing", "order"},
    "online": {"inputs", "inputs_before", "mass", "basis_functions", "smoothing"},
}


def recipe(name: str, prototype: Prototype) -> object:
    return study_task(prototype, name, 1).settings  # type: ignore[arg-type]


@pytest.mark.parametrize("name", READ)
def test_its_recipe_holds_what_it_reads_and_nothing_else(name):
    before = recipe(name, parse_prototype(PLAIN, "d.toml"))
    changed = {key for key, more in CHANGES.items() if recipe(name, parse_prototype(PLAIN | more, "d.toml")) != before}
    assert changed == READ[name]
