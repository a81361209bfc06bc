"""The program without what only POSIX has.

What is simulated: to the modules of debist, and to them alone, the modules, functions and constants in `TAKEN` are
missing, in every process, and processes are spawned, as on Windows and macOS. The standard library and other packages
keep them, because on those systems they use others. Not simulated are paths, file locks and consoles of Windows.
"""

import os
import signal
import subprocess
import sys

import pytest

from pipeline.rig.bench import Readings
from pipeline.rig.log import LAYOUTS
from tests.prototypes import motion, settings, write_csv

TAKEN = """
MODULES = {"fcntl", "resource", "pwd", "grp", "termios", "pty"}
NAMES = {
    "os": {
        "fork", "forkpty", "pidfd_open", "memfd_create", "wait4", "O_DIRECTORY", "O_NOFOLLOW", "O_PATH", "getuid",
        "geteuid", "getegid", "getgid", "fwalk", "fchmod", "fchown", "chown", "killpg", "sched_getaffinity", "pread",
        "preadv", "pwrite", "mkfifo", "posix_fadvise", "supports_dir_fd", "supports_fd", "getpgid", "setsid", "uname",
    },
    "signal": {"SIGKILL", "SIGHUP", "SIGXCPU", "SIGCHLD", "SIGQUIT", "SIGALRM", "alarm", "pthread_sigmask"},
    "socket": {"AF_UNIX", "send_fds", "recv_fds", "socketpair"},
    "select": {"poll", "epoll"},
    "time": {"tzset"},
    "mmap": {"MADV_DONTNEED", "MADV_SEQUENTIAL", "MADV_WILLNEED"},
    "mmap": {"MADV_DONTNEED", "MADV_SEQUENTIAL", "MADV_WILLNEED"},
}
"""
CUSTOMISED = f"""{TAKEN}
import builtins, importlib, socket, types
del socket.CMSG_LEN  # nothing is forked where descriptors cannot be handed on

def without(name):
    module = importlib.import_module(name)
    less = types.ModuleType(name)
    vars(less).update({{key: value for key, value in vars(module).items() if key not in NAMES[name]}})
    return less

less = {{name: without(name) for name in NAMES}}
original = builtins.__import__

def importing(name, globals=None, locals=None, fromlist=(), level=0):
    ours = str((globals or {{}}).get("__name__", "")).partition(".")[0] in ("pipeline", "cli", "debist")
    if ours and level == 0:
        if name in MODULES:
            raise ModuleNotFoundError(f"No module named {{name!r}}", name=name)
        if name in less:
            return less[name]
    return original(name, globals, locals, fromlist, level)

builtins.__import__ = importing
"""
PROGRAM = "import signal; signal.signal(signal.SIGINT, signal.default_int_handler); from cli import app; app()"


@pytest.fixture(scope="module")
def surroundings(tmp_path_factory):
    folder = tmp_path_factory.mktemp("without")
    (folder / "sitecustomize.py").write_text(CUSTOMISED)
    paths = [str(folder), *filter(None, [os.environ.get("PYTHONPATH")])]
    return os.environ | {"PYTHONPATH": os.pathsep.join(paths)}


@pytest.fixture
def fleet(tmp_path):
    """Three prototypes of a double well."""
    (tmp_path / "fleet").mkdir()
    for name in "abc":
        write_csv(tmp_path / "fleet" / f"{name}.csv", *motion(10.0, 200.0, 1, noise=3e-6))
        (tmp_path / "fleet" / f"{name}.toml").write_text(settings(name=name, train=f"{name}.csv"))
    return tmp_path


def _debist(surroundings, folder, *arguments):
    command = [sys.executable, "-P", "-c", PROGRAM, *arguments]
    return subprocess.run(command, cwd=folder, env=surroundings, capture_output=True, text=True, check=False)


def test_what_is_taken_away_is_gone_for_debist_alone(surroundings):
    program = (
        "import os, signal, resource; os.fork, signal.SIGKILL\n"
        "import pipeline.system.isolation as ours; assert ours.resource is None\n"
        "assert not hasattr(ours.os, 'fork') and not hasattr(ours.signal, 'SIGKILL')\n"
        "assert ours.process_context().get_start_method() == 'spawn'\n"
        "import mmap; assert mmap.MADV_DONTNEED\n"
    )
    command = [sys.executable, "-P", "-c", program]
    ended = subprocess.run(command, env=surroundings, capture_output=True, text=True, check=False)
    assert ended.returncode == 0, ended.stderr


def test_every_module_can_be_imported(surroundings):
    program = (
        "import importlib, pkgutil, cli, debist, pipeline\n"
        "for module in pkgutil.walk_packages(pipeline.__path__, 'pipeline.'): importlib.import_module(module.name)\n"
    )
    command = [sys.executable, "-P", "-c", program]
    ended = subprocess.run(command, env=surroundings, capture_output=True, text=True, check=False)
    assert ended.returncode == 0, ended.stderr


@pytest.mark.parametrize("layout", ["mat", "mf4"])
def test_a_log_is_read(surroundings, tmp_path, layout):
    t, q, v = motion(10.0, 200.0, 1)
    name = f"log{LAYOUTS[layout].suffix}"
    LAYOUTS[layout].save(Readings(t, q, *v.T), tmp_path / name)
    ended = _debist(surroundings, tmp_path, "inspect", name)
    assert ended.returncode == 0 and "2000" in ended.stdout, ended.stderr


@pytest.mark.long
def test_the_demo(surroundings, tmp_path):
    ended = _debist(surroundings, tmp_path, "demo", "-o", "demo", "-q")
    assert ended.returncode == 0, ended.stderr
    assert (tmp_path / "demo" / "report.html").is_file()


def test_a_batch_with_a_broken_log_and_its_rerun(surroundings, fleet):
    log = fleet / "fleet" / "b.csv"
    whole = log.read_bytes()
    log.write_bytes(b"t,q\n")
    arguments = ("batch", "fleet/a.toml", "fleet/b.toml", "-o", "runs", "--jobs", "2", "--no-report")
    ended = _debist(surroundings, fleet, *arguments)
    assert ended.returncode == 6 and "1 of 2 prototypes failed: b" in ended.stderr, ended.stderr
    log.write_bytes(whole)
    ended = _debist(surroundings, fleet, *arguments)
    assert ended.returncode == 0 and "a: up to date" in ended.stderr, ended.stderr


@pytest.mark.long
def test_an_interrupted_batch_goes_on(surroundings, fleet):
    arguments = ("batch", "fleet", "-o", "runs", "--no-report")
    command = [sys.executable, "-P", "-c", PROGRAM, *arguments]
    said, sent = "", False
    with subprocess.Popen(
        command, cwd=fleet, env=surroundings, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True
    ) as batch:
        assert batch.stderr is not None
        for line in batch.stderr:
            said += line
            if "[1/3]" in line and not sent:
                batch.send_signal(signal.SIGINT)
                sent = True
    assert batch.returncode == 130 and "interrupted; 1 of 3 prototypes are done" in said, said
    ended = _debist(surroundings, fleet, *arguments)
    assert ended.returncode == 0 and "a: up to date" in ended.stderr, ended.stderr
