"""A small run, made once, with everything compiled and drawn."""

import gc
import os
import random
import shutil
import sys
from functools import cached_property
from pathlib import Path
from typing import Any

import pytest

from pipeline.store.manifest import load_manifest
from tests.faults import intercepted
from tests.faults.intercepted import Answer, Call, Ended
from tests.faults.small_run import drawn_once, make, write_prototype
from tests.faults.system_calls import CHANGING, Kind
from tests.prototypes import content, logs_read_once


class Bench:
    """The small run: where it is made, an intact one, the states from which it can start, and its content hashes.

    A run can start ``fresh``, from nothing; ``changed``, from one with other settings, so that everything from the
    derivatives on is replaced; ``damaged``, from one of which every artifact has a flipped bit, so that all are set
    aside and made anew.
    """

    def __init__(self, folder: Path) -> None:
        self.prototype, self.run, self.intact = write_prototype(folder), folder / "run", folder / "intact"
        make(self.prototype, self.intact)
        self.expected = content(self.intact)
        self._calls: dict[tuple[str, ...], list[Call]] = {}

    @cached_property
    def changed(self) -> Path:
        """The run with other settings."""
        other, text = self.prototype.with_name("changed"), self.prototype.read_text()
        shutil.copytree(self.intact, other)
        self.prototype.write_text(text + "[differentiate]\nalpha = 1e-6\n")
        make(self.prototype, other)
        self.prototype.write_text(text)
        return other

    @cached_property
    def damaged(self) -> Path:
        """The run with a flipped bit in every artifact."""
        other, rng = self.prototype.with_name("damaged"), random.Random(5)
        shutil.copytree(self.intact, other)
        for name in self.expected:
            spoil(other / name, rng)
        return other

    def start(self, name: str) -> None:
        """Go back to a state to start from: ``fresh``, ``changed``, ``damaged`` or ``intact``."""
        shutil.rmtree(self.run, ignore_errors=True)
        if name != "fresh":
            shutil.copytree(getattr(self, name), self.run)

    def make(self) -> None:
        """Bring the run up to date."""
        make(self.prototype, self.run)

    def intercepted(self, answer: Answer, kinds: dict[str, Kind] = CHANGING) -> Ended:
        """The same in its own process; `answer` decides on each call that touches the run, its settings or its logs."""
        return intercepted.intercepted(self.make, self.prototype.parent, answer, kinds)

    def calls(self, start: str, kinds: dict[str, Kind] = CHANGING) -> list[Call]:
        """Those calls, when nothing is disturbed; counted once."""
        key = start, *kinds
        if key not in self._calls:
            self.start(start)
            ended = self.intercepted(lambda _: 0, kinds)
            assert ended.code == 0, ended.text
            self._calls[key] = ended.calls
        return self._calls[key]

    def check_mended(self) -> None:
        """A rerun has every artifact with the hashes of an undisturbed run, and nothing is left lying about."""
        self.make()
        recorded = load_manifest(self.run).artifacts
        assert {name: record.content_hash for name, record in recorded.items()} == self.expected
        assert not [path.name for path in self.run.rglob(".*") if path.name != ".lock"]


def spoil(path: Path, rng: random.Random) -> None:
    """Flip one bit of a file."""
    content = bytearray(path.read_bytes())
    content[rng.randrange(len(content))] ^= 1 << rng.randrange(8)
    path.write_bytes(content)


@pytest.fixture(scope="session")
def kept() -> dict[str, dict[Any, Any]]:
    """What this process has made: side by side, it comes back to this folder several times, after tests of others."""
    return {"drawn": {}, "bench": {}}


@pytest.fixture(scope="package")
def bench(kept, tmp_path_factory):
    """The small run; its logs are parsed and its report is computed once."""
    with drawn_once(kept["drawn"]), logs_read_once():
        if not kept["bench"]:
            kept["bench"]["small"] = Bench(tmp_path_factory.mktemp("faults"))
        bench = kept["bench"]["small"]
        gc.freeze()  # forks leave these pages alone
        yield bench
        gc.unfreeze()


@pytest.fixture(scope="session")
def interception():
    """Skips where the system calls of a process cannot be intercepted."""
    if sys.gettrace() is not None:
        pytest.skip("what measures coverage writes a file of its own in the copy, which would wait for ever")
    if not intercepted.available():
        pytest.skip("system calls cannot be intercepted here (Linux 5.5 or later on x86-64, seccomp permitted)")


@pytest.fixture
def as_root():
    """Skips where file systems cannot be mounted."""
    if os.geteuid() != 0:
        pytest.skip("needs root, to mount a file system")
