"""Killed at any moment, and at every call that changes a file: old or new, never half, and mended by a rerun."""

import os
import random
import time

import pytest

from pipeline.artifacts.manifest import MANIFEST, NEXT_MANIFEST, load_manifest
from pipeline.stages.run import verify_run
from tests.faults.traced import Call, changing_calls, traced

KILLED = -9
FEW = 4


def check_whole(run):
    """Whatever has its name is recorded, and has the bytes that are recorded."""
    if not (run / MANIFEST).exists() and not (run / NEXT_MANIFEST).exists():
        assert not [path for path in run.rglob("*") if path.is_file() and not path.name.startswith(".")]
        return
    problems, _ = verify_run(run)
    assert not problems
    recorded = load_manifest(run).artifacts
    for path in run.rglob("*"):
        name = path.relative_to(run).as_posix()
        if path.is_file() and not path.name.startswith(".") and not name.startswith((MANIFEST, "stages/")):
            assert name in recorded


def check_mended(bench):
    """A rerun has every artifact with the hashes of a run that nobody disturbed, and nothing is left lying about."""
    bench.make()
    assert load_manifest(bench.run).artifacts.keys() == bench.expected.keys()
    assert {name: record.content_hash for name, record in load_manifest(bench.run).artifacts.items()} == bench.expected
    assert not [path.name for path in bench.run.rglob(".*") if path.name != ".lock"]
    assert not list(bench.run.rglob("*.corrupt-*"))


def kill_at(bench, call: Call) -> None:
    ended = traced(bench.make, f"trace={call.name}", f"inject={call.name}:signal=SIGKILL:when={call.number}")
    assert ended.code == KILLED, ended
    check_whole(bench.run)
    check_mended(bench)


def changed_settings(bench):
    """From a run with other settings to the wanted one: everything from the derivatives on is replaced."""
    bench.start_intact()
    text = bench.prototype.read_text()
    bench.prototype.write_text(text + "[differentiate]\nalpha = 1e-6\n")
    bench.make()
    bench.prototype.write_text(text)


def every_call(bench, start):
    """The calls of a run from that start, for `kill_at`."""
    start(bench)
    return changing_calls(bench.make, bench.run)


@pytest.mark.usefixtures("strace")
def test_killed_at_some_calls_of_a_first_run(bench):
    calls = every_call(bench, lambda bench: bench.start_fresh())
    for call in random.Random(1).sample(calls, FEW):
        bench.start_fresh()
        kill_at(bench, call)


@pytest.mark.usefixtures("strace")
def test_killed_at_some_calls_while_results_are_replaced(bench):
    changed_settings(bench)
    calls = changing_calls(bench.make, bench.run)
    for call in random.Random(2).sample(calls, 1):
        changed_settings(bench)
        kill_at(bench, call)


@pytest.mark.long
@pytest.mark.usefixtures("strace")
@pytest.mark.parametrize("start", [lambda bench: bench.start_fresh(), changed_settings], ids=["fresh", "changed"])
def test_killed_at_every_call(bench, start, record_property):
    calls = every_call(bench, start)
    for call in calls:
        start(bench)
        kill_at(bench, call)
    record_property("kills", len(calls))
    print(f"{len(calls)} calls, killed at each")


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


@pytest.mark.parametrize("count", [3, pytest.param(100, marks=pytest.mark.long)])
def test_killed_at_random_moments(bench, count):
    bench.start_fresh()
    began = time.monotonic()
    bench.make()
    whole, moments, killed = time.monotonic() - began, random.Random(count), 0
    for _ in range(count):
        bench.start_fresh()
        killed += kill_after(bench, moments.uniform(0.0, whole)) == KILLED
        check_whole(bench.run) if bench.run.exists() else None
        check_mended(bench)
    assert killed >= count // 2
    print(f"{killed} of {count} killed before they had ended")
