"""Killed at any moment, and at every call that changes a file: old or new, never half, and mended by a rerun."""

import os
import random
import time

import pytest

from pipeline.store.manifest import MANIFEST, NEXT_MANIFEST, load_manifest
from pipeline.workflow.verify import verify_everything
from tests.faults.intercepted import KILL

STARTS = ["fresh", "changed", "damaged"]
FEW, MANY = 2, 60


def check_whole(run, *, damaged: bool = False):
    """Whatever has its name is recorded, and has the bytes that are recorded, unless it was damaged before."""
    if not (run / MANIFEST).exists() and not (run / NEXT_MANIFEST).exists():
        assert not [path for path in run.rglob("*") if path.is_file() and not path.name.startswith(".")]
        return
    problems = verify_everything(run).problems
    recorded = load_manifest(run).artifacts
    assert damaged or not problems
    for path in run.rglob("*"):
        name = path.relative_to(run).as_posix()
        if path.is_file() and not path.name.startswith(".") and not name.startswith((MANIFEST, "stages/")):
            assert name in recorded or (damaged and name.partition(".corrupt-")[0] in recorded)


def kill_at(bench, start: str, number: int) -> None:
    bench.start(start)
    ended = bench.intercepted(lambda call: KILL if call.number == number else 0)
    assert ended.code == KILL, ended
    check_whole(bench.run, damaged=start == "damaged")
    bench.check_mended()
    check_set_aside(bench, start)


def check_set_aside(bench, start: str) -> None:
    """What was damaged is kept under a name of its own, each once; nothing else is."""
    aside = sorted(path.relative_to(bench.run).as_posix() for path in bench.run.rglob("*.corrupt-*"))
    assert [name.partition(".corrupt-")[0] for name in aside] == (sorted(bench.expected) if start == "damaged" else [])


@pytest.mark.usefixtures("interception")
@pytest.mark.parametrize(
    ("start", "wanted"), [("damaged", FEW), *(pytest.param(start, MANY, marks=pytest.mark.long) for start in STARTS)]
)
def test_killed_at_some_calls(bench, start, wanted):
    calls = bench.calls(start)
    for call in random.Random(wanted).sample(calls, wanted):
        kill_at(bench, start, call.number)


def kill_after(bench, seconds: float) -> int:
    """Kill a run after some time; its exit code."""
    pid = os.fork()
    if pid == 0:
        try:
            bench.make()
        finally:
            os._exit(0)
    time.sleep(seconds)
    os.kill(pid, 9)
    return os.waitstatus_to_exitcode(os.waitpid(pid, 0)[1])


@pytest.mark.parametrize("wanted", [2, pytest.param(100, marks=pytest.mark.long)])
def test_killed_at_random_moments(bench, wanted):
    """Half of the runs start from nothing, half replace results; one that had ended before its kill does not count."""
    durations = {start: _duration(bench, start) for start in ("fresh", "changed")}
    moments, killed, tried = random.Random(wanted), 0, 0
    while killed < wanted:
        start = ("fresh", "changed")[tried % 2]
        bench.start(start)
        killed += kill_after(bench, moments.uniform(0.0, durations[start])) == KILL
        tried += 1
        check_whole(bench.run) if bench.run.exists() else None
        bench.check_mended()
        assert tried <= 3 * wanted + 20, "most runs end before they are killed"


def _duration(bench, start: str) -> float:
    bench.start(start)
    began = time.monotonic()
    bench.make()
    return time.monotonic() - began
