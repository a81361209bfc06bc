"""A small run, made once, with everything compiled and drawn."""

import os
import shutil
from pathlib import Path

import pytest

from tests.faults import traced
from tests.faults.small_run import content, drawn_once, make, write_prototype
from tests.fuzz.forked import forked_children


class Bench:
    """The small run's settings file, where runs of it are made, an intact one, and its content hashes."""

    def __init__(self, prototype: Path, run: Path, intact: Path) -> None:
        self.prototype, self.run, self.intact = prototype, run, intact
        self.expected = content(intact)

    def start_fresh(self) -> None:
        """No run at all."""
        shutil.rmtree(self.run, ignore_errors=True)

    def start_intact(self) -> None:
        """The intact run."""
        self.start_fresh()
        shutil.copytree(self.intact, self.run)

    def make(self) -> None:
        """Bring the run up to date."""
        make(self.prototype, self.run)


@pytest.fixture(scope="package")
def bench(tmp_path_factory):
    """The small run, the report computed once."""
    folder = tmp_path_factory.mktemp("faults")
    prototype = write_prototype(folder)
    with drawn_once(), forked_children():
        make(prototype, folder / "intact")
        yield Bench(prototype, folder / "run", folder / "intact")


@pytest.fixture(scope="session")
def strace():
    """Skips where strace is missing or may not attach."""
    if not traced.available():
        pytest.skip("strace is not here, or may not attach to processes")


@pytest.fixture
def as_root():
    """Skips where file systems cannot be mounted."""
    if os.geteuid() != 0:
        pytest.skip("needs root, to mount a file system")
