"""Received model files: whatever one entry says, the model is used or refused; a short run here, more when long."""

import warnings

import pytest
from hypothesis import HealthCheck, Phase, given, seed as hypothesis_seed, settings

from tests.fuzz.model_files import MODELS, changes, tally

SHORT, LONG = 8, 500


def _fuzz(name: str, count: int, *, exported: bool) -> None:
    warnings.simplefilter("ignore")  # of numbers that overflow, in forks
    hold, counts, entries = tally(name, exported=exported)

    @hypothesis_seed(5)
    @settings(
        max_examples=count,
        deadline=None,
        database=None,
        phases=(Phase.generate, Phase.shrink),
        suppress_health_check=list(HealthCheck),
    )
    @given(changed=changes(entries))
    def run(changed):
        hold(changed)

    run()
    assert counts["refused"] > count // 8, counts


@pytest.mark.parametrize("name", MODELS)
def test_a_changed_model_file_is_used_or_refused(name):
    _fuzz(name, SHORT, exported=False)


@pytest.mark.long
@pytest.mark.parametrize("name", MODELS)
def test_many_changed_model_files_are_used_or_refused(name):
    _fuzz(name, LONG, exported=True)
