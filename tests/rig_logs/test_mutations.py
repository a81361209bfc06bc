"""Mutated logs of every format through the guarded child: data or one line, and never a hang."""

import time

import numpy as np
import pytest

from pipeline.errors import InputError
from pipeline.rig_logs import Limits, read_recording

MUTATIONS = {"mat": 300, "mat73": 300, "h5": 300, "csv": 300, "parquet": 300, "mf4": 60}


@pytest.mark.long
@pytest.mark.parametrize("kind", MUTATIONS)
def test_mutations_are_read_or_refused(logs, tmp_path, kind):
    original = logs[kind].read_bytes()
    rng = np.random.default_rng(11)
    path = tmp_path / f"log.{kind}"
    refused, slowest = 0, 0.0
    for i in range(MUTATIONS[kind]):
        mutated = bytearray(original[: rng.integers(1, len(original))] if rng.random() < 0.2 else original)
        # Half of the mutations hit the first 3 kB, where headers are.
        reach = len(mutated) if i % 2 else min(len(mutated), 3000)
        for place in rng.integers(0, reach, rng.integers(1, 8)):
            mutated[place] = rng.integers(256)
        path.write_bytes(mutated)
        start = time.monotonic()
        try:
            recording = read_recording(path, limits=Limits(processor_seconds=20))
        except InputError as error:
            refused += 1
            assert str(error).startswith(str(path)) and "\n" not in str(error)
        else:
            assert all(channel.samples.dtype == np.float64 for channel in recording.channels)
        slowest = max(slowest, time.monotonic() - start)
    assert refused > MUTATIONS[kind] // 10
    assert slowest < 100.0
