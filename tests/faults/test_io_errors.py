"""A full, a failing, a read-only disk: said in a line with the path; nothing old is touched, nothing is half."""

import random
import shutil
import subprocess
from contextlib import contextmanager

import pytest

from pipeline.errors import InputError
from tests.faults.test_crash import changed_settings, check_mended, check_whole
from tests.faults.traced import Call, changing_calls, traced

FEW = 3
TOLD = (0, 2)  # done nevertheless (what failed was a courtesy), or said in a line


def fail_at(bench, call: Call, error: str, *, on: str = "") -> None:
    """The call fails with that error, `on` says how often; then the disk is well again."""
    ended = traced(bench.make, f"trace={call.name}", f"inject={call.name}:error={error}:when={call.number}{on}")
    assert ended.code in TOLD, f"{call}: {ended.text}"
    if ended.code:
        assert "\n" not in ended.text
        assert "cannot be" in ended.text and str(bench.run) in ended.text, ended.text
    check_whole(bench.run)
    check_mended(bench)


@pytest.mark.usefixtures("strace")
@pytest.mark.parametrize(("error", "on"), [("EIO", ""), ("ENOSPC", "+")])
@pytest.mark.parametrize("count", [FEW, pytest.param(None, marks=pytest.mark.long)])
def test_a_failing_call(bench, error, on, count):
    bench.start_fresh()
    calls = changing_calls(bench.make, bench.run)
    for call in random.Random(3).sample(calls, count or len(calls)):
        bench.start_fresh()
        fail_at(bench, call, error, on=on)
    print(f"{count or len(calls)} of {len(calls)} calls answered with {error}")


@pytest.mark.usefixtures("strace")
def test_a_disk_that_fails_while_results_are_replaced_leaves_the_old_ones(bench):
    changed_settings(bench)
    calls = [call for call in changing_calls(bench.make, bench.run) if call.name in ("write", "pwrite64")]
    for call in random.Random(4).sample(calls, 1):
        changed_settings(bench)
        fail_at(bench, call, "EIO")


@contextmanager
def mounted(folder, options):
    folder.mkdir()
    try:
        subprocess.run(["mount", "-t", "tmpfs", "-o", options, "tmpfs", folder], check=True, capture_output=True)
    except (OSError, subprocess.CalledProcessError):
        pytest.skip("no file system can be mounted here")
    try:
        yield folder
    finally:
        subprocess.run(["umount", "-l", folder], check=True)


@pytest.mark.usefixtures("as_root")
def test_a_small_disk(bench, tmp_path):
    """Full at some point; then it is made larger, and the run goes on."""
    with mounted(tmp_path / "disk", "size=4k") as disk:
        for kilobytes in (4, 40, 120, 300, 700):
            subprocess.run(["mount", "-o", f"remount,size={kilobytes}k", disk], check=True)
            with pytest.raises(InputError, match=r"cannot be (written|locked).*No space left") as caught:
                _make_there(bench, disk / "run")
            assert str(disk) in str(caught.value) and "\n" not in str(caught.value)
            check_whole(disk / "run") if (disk / "run").exists() else None
        subprocess.run(["mount", "-o", "remount,size=64m", disk], check=True)
        _make_there(bench, disk / "run")
        check_whole(disk / "run")


@pytest.mark.usefixtures("as_root")
def test_a_read_only_disk(bench, tmp_path):
    with mounted(tmp_path / "disk", "size=64m") as disk:
        shutil.copytree(bench.intact, disk / "run")
        subprocess.run(["mount", "-o", "remount,ro", disk], check=True)
        with pytest.raises(InputError, match=r"cannot be locked for writing: .*Read-only"):
            _make_there(bench, disk / "run")
        with pytest.raises(InputError, match=r"cannot be locked for writing: .*Read-only"):
            _make_there(bench, disk / "new")
        check_whole(disk / "run")  # reading and verifying need no writing


def _make_there(bench, run):
    from tests.faults.small_run import make

    make(bench.prototype, run)
