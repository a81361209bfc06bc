"""What must hold of every damaged log: data or one line, in bounded time, and nothing wrong that a checksum covers."""

import time
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from pipeline.errors import InputError
from pipeline.rig_logs import Limits, Recording, read_recording
from tests.fuzz.edits import Edit, apply
from tests.fuzz.seeds import Seed

LIMITS = Limits()
SLOWEST = 60.0
"""Most wall time [s] of one read, where only processor time ends the reader of a small log, after 20 s."""


@dataclass
class Tally:
    """How the damaged logs of one format went: counts by outcome, and the most wall time that one took [s]."""

    outcomes: Counter[str] = field(default_factory=Counter)
    slowest: float = 0.0


class Target:
    """One seed to damage, with what it holds when it is intact."""

    def __init__(self, seed: Seed, folder: Path, tally: Tally) -> None:
        self.seed, self.tally = seed, tally
        self._path = folder / f"damaged-{seed.name}"
        self._intact = self._read(seed.data)

    def check(self, edits: Sequence[Edit]) -> None:
        """Damage the seed, read it, judge."""
        began = time.monotonic()
        try:
            found = self._read(apply(self.seed.data, edits))
        except InputError as error:
            text = str(error)
            assert text.startswith(str(self._path)) and "\n" not in text and len(text) < 2500, text
            outcome = (
                "died, contained" if " died of " in text else "failed" if "its reader failed" in text else "refused"
            )
        else:
            outcome = "as it was" if _same(self._intact, found) else "differs"
        took = time.monotonic() - began
        self.tally.slowest = max(self.tally.slowest, took)
        self.tally.outcomes[outcome] += 1
        assert took < SLOWEST, f"the read took {took:.1f} s"
        if outcome == "differs":
            changes = all(edit.within(self.seed.protected) and edit.value in self.seed.values for edit in edits)
            # A cell that became a word, such as OVER, is a missing value with a warning, and a row that became a remark
            # is left out with one.
            if changes and not _with_gaps(found, self._intact):
                assert _without_a_row(found, self._intact), "wrong data where the format lets one know"
            if [edit.what for edit in edits] == ["cut"]:
                assert _part_of(found, self._intact), "a truncated log gave samples that it never held"

    def _read(self, data: bytes) -> Recording:
        self._path.write_bytes(data)
        recording = read_recording(self._path, limits=LIMITS)
        for channel in recording.channels:
            assert channel.samples.dtype == np.float64
            assert channel.time is None or channel.time.ndim == 1
        return recording


def _same(one: Recording, other: Recording) -> bool:
    """Equal in everything that matters to a result; notes may differ."""
    return len(one.channels) == len(other.channels) and all(
        (a.name, a.unit) == (b.name, b.unit)
        and np.array_equal(a.samples, b.samples, equal_nan=True)
        and (a.time is None) == (b.time is None)
        and (a.time is None or np.array_equal(a.time, np.asarray(b.time), equal_nan=True))
        for a, b in zip(one.channels, other.channels, strict=True)
    )


def _with_gaps(found: Recording, intact: Recording) -> bool:
    """Whether a warning names missing values, and all others are those of the intact log."""
    noted = any("missing values" in note for note in found.warnings)
    same = [(c.name, c.unit, len(c.samples)) for c in found.channels]
    if not noted or same != [(c.name, c.unit, len(c.samples)) for c in intact.channels]:
        return False
    pairs = [(a.samples, b.samples) for a, b in zip(found.channels, intact.channels, strict=True)]
    return all(np.all(np.isnan(a) | (a == b)) for a, b in pairs)


def _without_a_row(found: Recording, intact: Recording) -> bool:
    """Whether a warning names a line that is left out, and all other rows are those of the intact log."""
    if [c.name for c in found.channels] != [c.name for c in intact.channels]:
        return False
    pairs = [(a.samples, b.samples) for a, b in zip(found.channels, intact.channels, strict=True)]
    return any("1 line left out" in note for note in found.warnings) and any(
        all(np.array_equal(a, np.delete(b, row)) for a, b in pairs) for row in range(len(pairs[0][1]))
    )


def _part_of(found: Recording, intact: Recording) -> bool:
    """Whether every channel found is one of the intact log, whole or up to some sample."""
    whole = {channel.name: channel.samples for channel in intact.channels}
    return all(np.array_equal(c.samples, whole[c.name][: c.samples.size], equal_nan=True) for c in found.channels)
