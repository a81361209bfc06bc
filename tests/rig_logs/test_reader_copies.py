"""Readers that are copies of one process: each meets it untouched, and its death or a hang costs no log."""

import json
import os
import signal
import subprocess
import time
from pathlib import Path

import pytest

from pipeline.process_copies import CAN_COPY, Copies
from pipeline.rig_logs import guarded

pytestmark = pytest.mark.skipif(not CAN_COPY, reason="processes cannot be copied here")

BROKEN = "tests.rig_logs.broken_readers"


def _is_gone(pid: int) -> bool:
    try:
        return Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[0] == "Z"
    except OSError:
        return True


def _wait_for_the_end_of(pid: int) -> None:
    end = time.monotonic() + 20.0
    while not _is_gone(pid):
        assert time.monotonic() < end
        time.sleep(0.01)


@pytest.fixture
def readers():
    made = Copies(guarded._environment(), guarded._CHILD, "-S")
    yield made
    made.close()


def _facts(readers: Copies, files: list[int]) -> dict:
    done = guarded._read_in_copy(readers, f"{BROKEN}:tells_of_itself", None, b"a request", files, 60.0)
    assert done is not None and (done.returncode, done.stderr) == (0, b"")
    return json.loads(done.stdout)


def test_each_meets_a_process_that_nobody_has_touched(readers, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    with (tmp_path / "spool").open("wb") as spool:
        first, second = (_facts(readers, [spool.fileno()]) for _ in range(2))
    assert first == second
    assert first["given"] == "a request" and first["here"] == str(tmp_path.resolve()) and not first["touched"]
    assert set(first["environment"]) - {"LC_CTYPE"} == {*guarded._environment(), "JE_ARROW_MALLOC_CONF"}
    assert first["open"][:4] == [0, 1, 2, 3] and len(first["open"]) == 5  # the fifth is the listing's own
    assert first["badness"] == Path("/proc/self/oom_score_adj").read_text()


def test_a_hang_is_killed_and_the_next_is_read(readers, tmp_path):
    _facts(readers, [])  # from here on a copy is a matter of milliseconds
    with pytest.raises(subprocess.TimeoutExpired):
        guarded._read_in_copy(readers, f"{BROKEN}:sleeps", None, str(tmp_path / "pid").encode(), [], 5.0)
    _wait_for_the_end_of(int((tmp_path / "pid").read_text()))
    assert _facts(readers, [])["given"] == "a request"


@pytest.mark.skipif((os.cpu_count() or 1) < 2, reason="one processor takes no thread")
def test_where_a_library_has_started_a_thread_nothing_is_copied():
    eager = {name: value for name, value in guarded._environment().items() if "NUM_THREADS" not in name}
    readers = Copies(eager | {"OPENBLAS_NUM_THREADS": "2"}, guarded._CHILD, "-S")
    assert guarded._read_in_copy(readers, f"{BROKEN}:babbles", None, b"", [], 60.0) is None
    readers.close()


def test_without_the_process_that_is_copied_a_log_is_read_all_the_same(tmp_path):
    log = tmp_path / "log.csv"
    log.write_text("t,q\n" + "".join(f"{i / 100},{i % 7}\n" for i in range(100)))
    whole = guarded.read_recording(log)
    before = guarded.start_readers()
    os.kill(before._process.pid, signal.SIGKILL)
    os.waitid(os.P_PID, before._process.pid, os.WEXITED | os.WNOWAIT)
    for _ in range(2):
        again = guarded.read_recording(log)
        assert [list(c.samples) for c in again.channels] == [list(c.samples) for c in whole.channels]
    assert guarded.start_readers() is not before


def test_it_ends_with_the_program():
    program = (
        "import os; from pipeline.rig_logs import guarded; "
        "print(guarded.start_readers()._process.pid, flush=True); os._exit(0)"
    )
    made = subprocess.run(guarded.isolated(program), stdout=subprocess.PIPE, check=True)
    _wait_for_the_end_of(int(made.stdout))
