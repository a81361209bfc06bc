"""A full, a failing, a read-only disk: said in a line with the path; nothing old is touched, nothing is half."""

import errno
import random
import shutil
import subprocess
from contextlib import contextmanager

import pytest

from pipeline.errors import InputError
from pipeline.workflow.verify import verify_everything
from tests.faults.intercepted import Answer, intercepted
from tests.faults.small_run import make
from tests.faults.system_calls import NEEDS_SPACE, READING
from tests.faults.test_crash import FEW, MANY, STARTS, check_set_aside, check_whole

TOLD = (0, 2)  # done nevertheless (what failed was a courtesy), or said in a line


def io_error(number: int) -> Answer:
    """That call fails, and no other."""
    return lambda call: errno.EIO if call.number == number else 0


def no_space(number: int) -> Answer:
    """From that call on the disk is full."""
    return lambda call: errno.ENOSPC if call.number >= number and call.name in NEEDS_SPACE else 0


ERRORS = {"EIO": io_error, "ENOSPC": no_space}


def fail_at(bench, start: str, answer: Answer) -> None:
    """The run meets these answers; then the disk is well again."""
    bench.start(start)
    ended = bench.intercepted(answer)
    assert ended.code in TOLD, ended.text
    if ended.code:
        assert "\n" not in ended.text
        assert "cannot be" in ended.text and str(bench.run) in ended.text, ended.text
    check_whole(bench.run, damaged=start == "damaged") if bench.run.exists() else None
    bench.check_mended()
    check_set_aside(bench, start)


def places(calls, error: str) -> list[int]:
    """The calls at which that error can begin."""
    return [call.number for call in calls if error != "ENOSPC" or call.name in NEEDS_SPACE]


@pytest.mark.usefixtures("interception")
@pytest.mark.parametrize(
    ("start", "error", "wanted"),
    [
        ("fresh", "ENOSPC", FEW),
        ("damaged", "EIO", FEW),
        *(pytest.param(start, error, MANY, marks=pytest.mark.long) for start in STARTS for error in ERRORS),
    ],
)
def test_some_failing_calls(bench, error, start, wanted):
    numbers = places(bench.calls(start), error)
    for number in random.Random(wanted).sample(numbers, wanted):
        fail_at(bench, start, ERRORS[error](number))


def unread_at(bench, start: str, number: int) -> None:
    """A call that only reads fails: of the settings, the logs, the run."""
    bench.start(start)
    ended = bench.intercepted(io_error(number), READING)
    assert ended.code in TOLD, ended.text
    assert "\n" not in ended.text and "damaged" not in ended.text, ended.text
    if ended.code:
        assert " cannot be " in ended.text and str(bench.prototype.parent) in ended.text, ended.text
    check_whole(bench.run) if bench.run.exists() else None
    bench.check_mended()


@pytest.mark.usefixtures("interception")
@pytest.mark.parametrize("wanted", [3, pytest.param(200, marks=pytest.mark.long)])
def test_failing_reads(bench, wanted):
    calls = bench.calls("changed", READING)
    for call in random.Random(wanted).sample(calls, wanted):
        unread_at(bench, "changed", call.number)


@pytest.mark.usefixtures("interception")
def test_verify_lists_what_the_disk_refuses_and_goes_on(bench):
    bench.start("intact")

    def verify():
        found = verify_everything(bench.run)
        assert found.checked == len(bench.expected)
        assert [problem["artifact"] for problem in found.problems] == ["model.h5"]
        assert "model.h5: cannot be read: Input/output error" in found.problems[0]["problem"]

    failing = lambda call: errno.EIO if call.path.endswith("/model.h5") else 0  # noqa: E731
    ended = intercepted(verify, bench.run, failing, {"read": READING["read"]})
    assert ended.code == 0, ended.text


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
        for kilobytes in (4, 40, 120, 250, 400):
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
    make(bench.prototype, run)
