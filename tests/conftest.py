"""Fixtures shared by all tests; as in the program, numerical libraries take one thread (`pipeline.system.machine`)."""

import gc
import os
import sys
from collections.abc import Iterator
from functools import cache
from pathlib import Path

import pytest
import typer.main

from pipeline.system.isolation import preload
from pipeline.system.machine import settle_machine

settle_machine()  # before a test module loads NumPy
preload(["pipeline.workflow.preloaded", "asammdf"])  # once for all processes that tests have forked
gc.disable()  # while tests are collected: what is imported stays, and looking it through took a seventh of that time
typer.main.get_command = cache(typer.main.get_command)  # else each call of a command assembles all of them
os.environ.pop("COLUMNS", None)  # set by tests side by side, which have no terminal either

SHARED = Path(__file__).resolve().parents[2] / "shared"


def pytest_collection_finish() -> None:
    gc.enable()


def pytest_runtest_teardown(item: pytest.Item, nextitem: pytest.Item | None) -> None:
    """Certify new kernels after each file: programs that tests start would take those without a digest for damaged."""
    if nextitem is not None and nextitem.path == item.path:
        return
    if (compiled := sys.modules.get("pipeline.numerics.compiled")) is not None:
        compiled.keep_kernels()


@pytest.fixture(scope="session")
def shared_folder() -> Path:
    """The folder with the example logs; tests that need it are skipped where it is missing."""
    if not SHARED.is_dir():
        pytest.skip(f"the example logs are not here ({SHARED})")
    return SHARED


@pytest.fixture
def read_once() -> Iterator[None]:
    """Logs with equal content are parsed by a child once in all tests that ask for this."""
    from tests.prototypes import logs_read_once

    with logs_read_once():
        yield


@pytest.fixture
def without_binaries(monkeypatch: pytest.MonkeyPatch) -> None:
    """FMUs hold sources alone, in tests of other things: to compile one takes a second."""
    monkeypatch.setattr("pipeline.export.fmu.COMPILERS", {})
