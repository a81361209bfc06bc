"""The power fails at any call that changes a file: old or new, never half, and mended by a rerun."""

import copy
import os
import random

import pytest

from tests.faults.intercepted import intercepted
from tests.faults.power_loss import Disk
from tests.faults.test_crash import check_set_aside, check_whole

STARTS = ["fresh", "changed", "damaged"]


def states(bench, start: str, wanted: int | None, rng: random.Random) -> list[tuple[Disk, int]]:
    """The disk at some of the calls of an undisturbed run, or at all of them."""
    bench.start(start)
    disk, seen = Disk(bench.run), list[tuple[Disk, int]]()

    def watch(call):
        if wanted is None or rng.random() < 0.05:
            seen.append((copy.deepcopy(disk), call.number))
        disk.take(call)
        return 0

    ended = bench.intercepted(watch)
    assert ended.code == 0, ended.text
    seen.append((copy.deepcopy(disk), len(ended.calls)))
    return seen if wanted is None else rng.sample(seen, min(wanted, len(seen)))


def lose_power(bench, start: str, wanted: int | None) -> int:
    """Lay out what the disk may hold at these calls, with nothing and with something of what was not synced.

    Most calls add nothing to what is safe: a state that was tried is not tried again. Gives the number of states.
    """
    rng, tried = random.Random(11), set[int]()
    for disk, _ in states(bench, start, wanted, rng):
        for luck in (None, random.Random(rng.random()), random.Random(rng.random())):
            held = disk.after_a_failure(luck)
            if (state := hash(frozenset(held.items()))) in tried:
                continue
            tried.add(state)
            disk.lay_out(held)
            check_whole(bench.run, damaged=start == "damaged") if bench.run.exists() else None
            bench.check_mended()
            check_set_aside(bench, start)
    return len(tried)


@pytest.mark.usefixtures("interception")
@pytest.mark.parametrize("start", STARTS)
def test_the_power_fails_at_some_calls(bench, start):
    assert lose_power(bench, start, 1)


@pytest.mark.long
@pytest.mark.usefixtures("interception")
@pytest.mark.parametrize("start", STARTS)
def test_the_power_fails_at_every_call(bench, start, count):
    count.append(f"{lose_power(bench, start, None)} states of the disk")


@pytest.mark.usefixtures("interception")
def test_the_model_loses_what_was_not_synced(tmp_path):
    """A file that is written and moved into place, as `atomic` does it, with one of its steps left out at a time."""

    def save(*, file_synced: bool, folder_synced: bool) -> None:
        descriptor = os.open(tmp_path / "new", os.O_WRONLY | os.O_CREAT)
        os.write(descriptor, b"content")
        if file_synced:
            os.fsync(descriptor)
        os.rename(tmp_path / "new", tmp_path / "name")  # noqa: PTH104
        if folder_synced:
            folder = os.open(tmp_path, os.O_RDONLY)
            os.fsync(folder)

    for file_synced, folder_synced, expected in ((True, True, b"content"), (False, True, b""), (True, False, None)):
        for path in tmp_path.iterdir():
            path.unlink()
        disk = Disk(tmp_path)
        ended = intercepted(
            lambda f=file_synced, s=folder_synced: save(file_synced=f, folder_synced=s),
            tmp_path,
            lambda call, disk=disk: disk.take(call) or 0,
        )
        assert ended.code == 0, ended.text
        assert disk.after_a_failure(None).get(str(tmp_path / "name")) == expected
