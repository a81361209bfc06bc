"""What ends a command at once is told in a line by its parent, which hands on every signal and is never outlived."""

import os
import pty
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from pipeline.batch.worker import run_worker
from pipeline.child_processes import died_of, isolated
from tests.checks.first_hour import write_logs
from tests.prototypes import write_program

_WATCH = "import ctypes, os, signal, time; from pipeline.commands.boundary import watch; watch(); "
_TELL = """
from pipeline.commands.boundary import watch
import os, time
watch()
try:
    print(os.getpid(), flush=True)
    time.sleep(30)
except KeyboardInterrupt:
    print("interrupted", flush=True)
    time.sleep(0.3)
    os._exit(130)
"""


@pytest.fixture(autouse=True)
def signals_of_a_terminal():
    """A job in the background, or under nohup, ignores some signals, and so would what it starts."""
    usual = {signal.SIGINT: signal.default_int_handler, signal.SIGQUIT: signal.SIG_DFL, signal.SIGHUP: signal.SIG_DFL}
    before = {number: signal.signal(number, handler) for number, handler in usual.items()}
    yield
    for number, handler in before.items():
        signal.signal(number, handler)


def _state(pid: int) -> str:
    """One letter of the kernel: R or S at work, T stopped; empty when it is gone."""
    try:
        return Path(f"/proc/{pid}/stat").read_text().rpartition(") ")[2][0].replace("Z", "")
    except OSError:
        return ""


def _becomes(pid: int, states: str) -> bool:
    for _ in range(200):
        if _state(pid) in (list(states) or [""]):
            return True
        time.sleep(0.02)
    return False


@pytest.mark.parametrize("number", [signal.SIGABRT, signal.SIGSEGV, signal.SIGBUS, signal.SIGKILL])
def test_a_death_is_a_line_and_an_exit_code_of_its_own(number):
    ended = subprocess.run(isolated(f"{_WATCH} os.kill(os.getpid(), {number:d})"), capture_output=True, check=False)
    assert (ended.returncode, ended.stderr.decode()) == (128 + number, f"debist: {died_of(number)}\n")
    assert "memory" in died_of(number) and signal.Signals(number).name in died_of(number)


@pytest.mark.skipif(sys.platform != "linux", reason="the library of C++ has another name")
def test_the_words_of_a_library_stand_above_the_line():
    end = "ctypes.CDLL('libstdc++.so.6')._ZSt9terminatev()"
    ended = subprocess.run(isolated(_WATCH + end), capture_output=True, text=True, check=False)
    assert ended.returncode == 128 + signal.SIGABRT
    assert ended.stderr == f"terminate called without an active exception\ndebist: {died_of(signal.SIGABRT)}\n"


@pytest.mark.parametrize("code", [0, 1, 3, 6, 130])
def test_exit_codes_and_output_are_those_of_the_work(code):
    ended = subprocess.run(isolated(f"{_WATCH} print('x'); sys.exit({code})"), capture_output=True, check=False)
    assert (ended.returncode, ended.stdout, ended.stderr) == (code, b"x\n", b"")


@pytest.mark.parametrize("code", [0, 4])
def test_an_output_that_is_closed_changes_no_exit_code(bench, code):
    """As by ``debist … >&-``."""
    bench.start("intact")
    (bench.run / "manifest.json").write_text("{}") if code else None
    command = [*isolated("from cli import app; app()"), "verify", str(bench.run)]
    ended = subprocess.run(["sh", "-c", '"$@" >&-', "sh", *command], stderr=subprocess.PIPE, check=False)
    assert ended.returncode == code, ended.stderr


def test_a_worker_of_a_batch_is_told_with_the_same_words(tmp_path, monkeypatch):
    monkeypatch.syspath_prepend(tmp_path)
    program = write_program(tmp_path, "import os; os.abort()")
    assert run_worker(program, "a", tmp_path / "a.toml", tmp_path).reason == died_of(signal.SIGABRT)


@pytest.fixture
def working():
    """A watched process in a group of its own, and the number of the child that does the work."""
    with subprocess.Popen(
        isolated(_TELL), stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, process_group=0
    ) as parent:
        assert parent.stdout
        child = int(parent.stdout.readline())
        assert child != parent.pid
        yield parent, child
        parent.kill()


@pytest.mark.parametrize("number", [signal.SIGTERM, signal.SIGHUP, signal.SIGQUIT])
@pytest.mark.parametrize("group", [False, True], ids=["parent", "group"])
def test_a_signal_to_end_ends_both_without_a_word(working, number, group):
    parent, child = working
    (os.killpg if group else os.kill)(parent.pid, number)
    assert parent.wait(10) == -number
    assert parent.stderr.read() == "" and _becomes(child, "")


@pytest.mark.parametrize("group", [False, True], ids=["parent", "group"])
def test_an_interruption_comes_once(working, group):
    """As a terminal sends it, to both, or as `kill -INT` does."""
    parent, _ = working
    (os.killpg if group else os.kill)(parent.pid, signal.SIGINT)
    assert parent.wait(10) == 130
    assert (parent.stdout.read(), parent.stderr.read()) == ("interrupted\n", "")


def test_an_interruption_that_comes_again_while_the_child_is_taken_down_changes_nothing():
    end = "signal.signal(signal.SIGINT, signal.SIG_DFL); os.kill(os.getpid(), signal.SIGINT)"
    ended = subprocess.run(isolated(_WATCH + end), capture_output=True, check=False)
    assert (ended.returncode, ended.stderr) == (130, b"")


def test_what_is_ignored_stays_ignored():
    """As under `nohup`, and in the background of a script."""
    ignoring = (
        "import signal; signal.signal(signal.SIGHUP, signal.SIG_IGN); signal.signal(signal.SIGINT, signal.SIG_IGN); "
    )
    with subprocess.Popen(isolated(ignoring + _WATCH + "print(); time.sleep(0.3)"), stdout=subprocess.PIPE) as parent:
        assert parent.stdout and parent.stdout.readline()
        parent.send_signal(signal.SIGHUP)
        parent.send_signal(signal.SIGINT)
    assert parent.returncode == 0


def test_both_stop_and_go_on(working):
    parent, child = working
    os.kill(parent.pid, signal.SIGTSTP)
    assert _becomes(child, "T") and _becomes(parent.pid, "T")
    os.kill(parent.pid, signal.SIGCONT)
    assert _becomes(child, "RS") and _becomes(parent.pid, "RS")


def test_no_work_goes_on_without_its_parent(working):
    parent, child = working
    parent.kill()
    assert _becomes(child, "")


def test_threads_keep_the_work_in_one_process():
    thread = "import os, threading; threading.Thread(target=threading.Event().wait, daemon=True).start(); "
    program = f"{thread} before = os.getpid(); {_WATCH} print(os.getpid() == before)"
    assert subprocess.run(isolated(program), capture_output=True, check=True).stdout == b"True\n"


def test_ctrl_c_in_a_terminal_is_one_line(tmp_path):
    """The terminal sends it to both processes; what is shown is what one of them says."""
    write_logs(tmp_path)
    pid, terminal = pty.fork()
    if pid == 0:
        os.chdir(tmp_path)
        command = isolated("from cli import app; app()")
        os.execv(command[0], [*command, "run", "P.toml", "-o", "run", "--no-report"])  # noqa: S606
    said, pressed = b"", False
    while True:
        try:
            part = os.read(terminal, 4096)
        except OSError:  # the other side is closed
            break
        said += part
        if b"training log" in said and not pressed:
            os.write(terminal, b"\x03")
            pressed = True
    os.close(terminal)
    assert os.waitstatus_to_exitcode(os.waitpid(pid, 0)[1]) == 130, said
    assert said.count(b"debist: interrupted;") == 1 and b"Traceback" not in said, said
