"""Copies of a warm process: one that crashes, hangs or soils its surroundings leaves the others alone."""

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from pipeline.batch.worker import SACRIFICED, Outcome, Workers
from pipeline.child_processes import died_of
from pipeline.process_copies import CAN_COPY

pytestmark = pytest.mark.skipif(not CAN_COPY, reason="processes cannot be copied here")

_APP = """
import os, pathlib, random, signal, sys, time
marks = []

def app():
    assert sys.argv[1] == "run"
    name = pathlib.Path(sys.argv[2]).stem
    if name == "crash":
        os.kill(os.getpid(), signal.SIGSEGV)
    if name == "hang":
        time.sleep(60)
    if name == "killer":
        if "process_copies" in pathlib.Path(f"/proc/{os.getppid()}/cmdline").read_text():
            os.kill(os.getppid(), signal.SIGKILL)
            time.sleep(60)
    if name.startswith("soil"):
        found = [list(marks), os.environ.get("SOILED"), os.getcwd(), random.getstate()[1][:2] == soiled_state[1][:2]]
        marks.append(name)
        os.environ["SOILED"] = name
        os.chdir("/")
        print("noise on standard output")
        sys.exit(f"debist: {found}")
    if name == "bomb":
        import resource
        resource.setrlimit(resource.RLIMIT_AS, (1 << 28, 1 << 28))
        held = []
        while True:
            held.append(b"x" * (1 << 24))
    if name == "badness":
        sys.exit("debist: " + pathlib.Path("/proc/self/oom_score_adj").read_text().strip())
    if name == "parent":
        sys.exit(f"debist: {os.getppid()}")

app.work = app
soiled_state = random.getstate()
"""


@pytest.fixture
def workers(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Workers:
    (tmp_path / "cli.py").write_text(_APP)
    monkeypatch.syspath_prepend(str(tmp_path))
    monkeypatch.setattr("pipeline.child_processes.import_path", lambda: [str(tmp_path), *sys.path[1:]])
    with Workers("cli:app", warm=False) as made:
        yield made


def run(workers: Workers, name: str, time_limit: float | None = None) -> Outcome:
    return workers.run(name, Path(f"{name}.toml"), Path("runs"), time_limit=time_limit)


def test_each_meets_a_process_that_nobody_has_touched(workers: Workers) -> None:
    first, second = (run(workers, name) for name in ("soil-a", "soil-b"))
    assert first.reason == second.reason
    assert first.reason.startswith("[[], None, ")
    assert run(workers, "parent").reason == run(workers, "parent").reason  # copied from the same process
    assert run(workers, "fine").exit_code == 0


def test_a_crash_and_a_hang_end_one_prototype(workers: Workers) -> None:
    assert run(workers, "fine").exit_code == 0
    crash = run(workers, "crash")
    assert (crash.exit_code, crash.reason) == (-signal.SIGSEGV, died_of(signal.SIGSEGV))
    began = time.monotonic()
    hang = run(workers, "hang", time_limit=0.5)
    assert hang.exit_code == -signal.SIGKILL and "time limit of 0.5 s" in hang.reason
    assert time.monotonic() - began < 30.0
    assert run(workers, "fine").exit_code == 0


def test_memory_that_runs_out_ends_the_one_that_asked(workers: Workers) -> None:
    assert run(workers, "badness").reason == SACRIFICED  # the kernel takes it first, and its parents last
    bomb = run(workers, "bomb")
    assert (bomb.exit_code, bomb.reason) == (1, "MemoryError")
    assert run(workers, "fine").exit_code == 0


def test_the_death_of_the_copied_process_is_survived(workers: Workers) -> None:
    before = run(workers, "parent").reason
    assert run(workers, "killer").exit_code == 0  # repeated by an interpreter of its own
    assert run(workers, "fine").exit_code == 0
    assert run(workers, "parent").reason not in (before, "")


def test_a_copy_ends_with_its_batch(tmp_path: Path) -> None:
    (tmp_path / "cli.py").write_text(
        "import os, pathlib, time\ndef app():\n"
        f"    pathlib.Path({str(tmp_path / 'pid')!r}).write_text(str(os.getpid()))\n"
        "    time.sleep(60)\napp.work = app\n"
    )
    program = (
        "import sys; from pathlib import Path; from pipeline import child_processes; "
        f"child_processes.import_path = lambda: [{str(tmp_path)!r}, *sys.path]; "
        "from pipeline.batch.worker import Workers; Workers('cli:app', warm=False).run('x', Path('x.toml'), Path())"
    )
    batch = subprocess.Popen([sys.executable, "-c", program])
    pid = _wait_for(lambda: (tmp_path / "pid").read_text() if (tmp_path / "pid").exists() else "", 60.0)
    batch.kill()
    batch.wait()
    assert _wait_for(lambda: _is_gone(int(pid)), 20.0)


def _wait_for(condition, seconds):
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        if found := condition():
            return found
        time.sleep(0.01)
    pytest.fail("it did not come")


def _is_gone(pid: int) -> bool:
    try:
        os.kill(pid, 0)
        return Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()[0] == "Z"
    except (ProcessLookupError, FileNotFoundError):
        return True
