"""The second process of a first run: it leaves kernels in the cache, and is not started where they are there."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

from pipeline import first_run


@pytest.mark.long
def test_what_it_compiles_is_found_by_a_run(tmp_path: Path) -> None:
    code = (
        "from pipeline.first_run import compile_kernels; compile_kernels(); "
        "from pipeline.{module} import {kernel}; print(sum({kernel}.stats.cache_hits.values()))"
    )
    found = []
    for module, kernel in (
        ("joint.sensitivity", "integrate_sensitivities"),
        ("joint.condensed_curves", "curves_at"),
        ("identification.lag_search", "pair_products"),
    ):
        program = code.format(module=module, kernel=kernel)
        environment = os.environ | {"NUMBA_CACHE_DIR": str(tmp_path)}
        done = subprocess.run([sys.executable, "-c", program], env=environment, capture_output=True, check=True)
        found.append(int(done.stdout))
    assert found == [0, 1, 1]  # the first process compiled, the others loaded


def test_it_is_started_once_and_not_where_the_kernels_are(monkeypatch: pytest.MonkeyPatch) -> None:
    started: list[object] = []
    monkeypatch.setattr(first_run, "_started", [])
    monkeypatch.setattr(subprocess, "Popen", lambda *_, **__: started.append(None))
    monkeypatch.setattr(first_run, "_processors", lambda: 2)
    for cached, prepared, expected in ((True, False, 0), (False, True, 0), (False, False, 1), (False, False, 1)):
        monkeypatch.setattr(first_run, "is_cached", lambda _, cached=cached: cached)
        monkeypatch.setattr(first_run, "is_prepared", lambda _, prepared=prepared: prepared)
        first_run.compile_ahead()
        assert len(started) == expected


def test_one_processor_has_no_second_process(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(subprocess, "Popen", lambda *_, **__: pytest.fail("a second process"))
    monkeypatch.setattr(first_run, "_processors", lambda: 1)
    for answer in ("is_cached", "is_prepared"):
        monkeypatch.setattr(first_run, answer, lambda _: False)
    monkeypatch.setattr(first_run, "_started", [])
    first_run.compile_ahead()
