"""Where a command meets the world: full outputs, odd names, other people's caches, what the environment says."""

import json
import os
import shutil
import signal
import subprocess
import sys
from pathlib import Path

import pytest
from typer.testing import CliRunner

import debist as library
from cli import app
from pipeline.errors import InputError
from pipeline.numerics.kernel_cache import check_private
from pipeline.system.machine import ONE_THREAD

DEBIST = [sys.executable, "-P", "-c", "from cli import app; app()"]


def debist(*arguments: object, **options):
    return subprocess.run(
        [*DEBIST, *map(os.fsdecode, map(os.fspath, arguments))], stderr=subprocess.PIPE, check=False, **options
    )


@pytest.mark.parametrize(
    "arguments",
    [
        ("status", "{run}", "--json"),
        *(pytest.param(each, marks=pytest.mark.long) for each in (("--help",), ("status", "{run}"))),
    ],
)
def test_a_reader_that_has_gone_ends_a_command_as_other_programs(bench, arguments):
    """`debist show RUN | head -1`: no message, and the exit code of SIGPIPE."""
    bench.start("intact")
    read, write = os.pipe()
    os.close(read)
    with os.fdopen(write, "wb") as pipe:
        done = debist(*(part.format(run=bench.run) for part in arguments), stdout=pipe)
        failed = debist("status", bench.run / "none", "--json", stdout=pipe)
    assert (done.returncode, done.stderr) == (141, b""), done.stderr
    assert failed.returncode == 2 and b"no run here" in failed.stderr


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="needs /dev/full")
@pytest.mark.parametrize("arguments", [("--help",), ("verify", "{run}")])
def test_an_output_that_takes_nothing_is_a_line(bench, arguments):
    bench.start("intact")
    with Path("/dev/full").open("w") as full:
        done = debist(*(part.format(run=bench.run) for part in arguments), stdout=full)
    lines = done.stderr.decode().splitlines()
    assert (done.returncode, len(lines)) == (2, 1), lines
    assert "the output cannot be written: No space left on device" in lines[0]


@pytest.mark.skipif(os.name == "nt", reason="the shell's redirections")
@pytest.mark.parametrize(
    ("closed", "code"),
    [(">&-", 0), *(pytest.param(*each, marks=pytest.mark.long) for each in (("2>&-", 0), ("<&-", 0))), (">&-", 4)],
)
def test_streams_that_are_closed_change_no_exit_code(bench, closed, code):
    bench.start("intact")
    (bench.run / "manifest.json").write_text("{}") if code else None
    ended = subprocess.run(
        ["sh", "-c", f'"$@" {closed}', "sh", *DEBIST, "verify", str(bench.run)], capture_output=True, check=False
    )
    assert ended.returncode == code, ended.stderr


@pytest.mark.parametrize("command", [pytest.param("run", marks=pytest.mark.long), "batch"])
def test_a_current_folder_that_was_deleted_is_a_line(bench, tmp_path, command):
    (tmp_path / "gone").mkdir()
    script = f'cd {tmp_path}/gone && rmdir {tmp_path}/gone && exec "$@" -q --no-report'
    arguments = [command, str(bench.prototype), "-o", str(tmp_path / "new")]
    ended = subprocess.run(["sh", "-c", script, "sh", *DEBIST, *arguments], capture_output=True, text=True, check=False)
    assert ended.returncode in (0, 2) and "Traceback" not in ended.stderr, ended.stderr


@pytest.mark.parametrize(
    ("number", "line"), [(signal.SIGINT, "debist: interrupted"), (signal.SIGTERM, "debist: ended by SIGTERM")]
)
def test_a_signal_to_end_is_a_line(number, line):
    program = (
        "import os, signal, pipeline.workflow.run; signal.signal(signal.SIGINT, signal.default_int_handler); "
        f"pipeline.workflow.run.run_status = lambda *_, **__: os.kill(os.getpid(), {number:d}); "
        "from cli import app; app()"
    )
    ended = subprocess.run([*DEBIST[:-1], program, "status", "."], capture_output=True, text=True, check=False)
    assert ended.returncode == 128 + number
    assert ended.stderr.startswith(line) and len(ended.stderr.splitlines()) == 1, ended.stderr


def test_memory_that_ends_is_a_line():
    program = (
        "import pipeline.workflow.run\ndef fail(*_, **__): bytes(1 << 62)\n"
        "pipeline.workflow.run.run_status = fail\nfrom cli import app; app()"
    )
    ended = subprocess.run([*DEBIST[:-1], program, "status", "."], capture_output=True, text=True, check=False)
    assert ended.returncode == 2 and ended.stderr.startswith("debist: not enough memory; "), ended.stderr
    assert len(ended.stderr.splitlines()) == 1


def test_a_folder_whose_name_is_not_utf_8_is_a_line(bench, tmp_path):
    folder = tmp_path / os.fsdecode(b"caf\xe9")
    try:
        shutil.copytree(
            bench.prototype.parent, folder, ignore=shutil.ignore_patterns("run", "intact", "changed", "damaged")
        )
    except OSError:
        pytest.skip("this file system has no such names")
    shutil.copy(bench.prototype, folder)
    done = debist("run", folder / bench.prototype.name, "-o", tmp_path / "run", stdout=subprocess.PIPE)
    (line,) = done.stderr.decode().splitlines()
    assert done.returncode == 2 and "its path is not UTF-8" in line and "caf\\udce9" in line
    bench.start("intact")
    shutil.copytree(bench.run, folder / "run")
    done = debist("verify", folder / "run", "--json", stdout=subprocess.PIPE)
    assert done.returncode == 0 and json.loads(done.stdout), done.stderr


@pytest.mark.parametrize("command", ["run", "batch", "demo", "rig simulate", "export"])
def test_an_output_that_is_a_file_is_a_line(bench, tmp_path, command):
    bench.start("intact")
    place = tmp_path / "file"
    place.write_text("mine")
    arguments = {
        "run": ("run", bench.prototype, "-o", place),
        "batch": ("batch", bench.prototype, "-o", place),
        "demo": ("demo", "-o", place / "x"),
        "rig simulate": ("rig", "simulate", "-o", place, "--duration", "2", "--rate", "2000"),
        "export": ("export", bench.run, "--to", "json", "-o", place),
    }[command]
    done = CliRunner().invoke(app, [str(argument) for argument in arguments])
    lines = done.stderr.splitlines()
    assert (done.exit_code, len(lines)) == (2, 1), lines
    assert str(place) in lines[0] and place.read_text() == "mine"


def _told(program: str, **environment: str) -> str:
    done = subprocess.run(
        [sys.executable, "-P", "-c", program],
        capture_output=True,
        text=True,
        check=False,
        env=os.environ | environment,
        timeout=60,
    )
    assert done.returncode == 0, done.stderr
    return done.stdout


def test_threads_of_a_program_that_imports_debist_change_no_result_and_stay_its_own():
    """NumPy is loaded first, as in most notebooks."""
    program = (
        "import numpy as np, scipy.linalg, threadpoolctl, hashlib, debist\n"
        "from pipeline.system.machine import one_thread\n"
        "def work():\n"
        "    a = np.random.default_rng(1).normal(size=(400, 400)); q, r = np.linalg.qr(a @ a.T)\n"
        "    return hashlib.sha256(q.tobytes() + r.tobytes()).hexdigest()\n"
        "print(one_thread(work)(), [pool['num_threads'] for pool in threadpoolctl.threadpool_info()])"
    )
    alone, two = (_told(program, **dict.fromkeys(ONE_THREAD, count)).split() for count in "12")
    assert alone[0] == two[0]
    threads = {entry.strip("[],") for entry in two[1:]}
    assert threads == {str(min(2, os.cpu_count() or 1))}, "a notebook's own threads were taken away"
    for computing in (library.identify, library.Model.simulate, library.Model.score, library.Run.simulate):
        assert hasattr(computing, "__wrapped__"), f"{computing} would take the program's threads"


@pytest.mark.skipif(os.geteuid() != 0, reason="needs root, to give a folder away")
@pytest.mark.parametrize(("owner", "mode"), [(12345, 0o755), (0, 0o775)])
def test_kernels_are_loaded_from_nobody_elses_folder(tmp_path, owner, mode):
    """Nor from one into which another group can write."""
    (tmp_path / "theirs").mkdir()
    os.chown(tmp_path / "theirs", owner, 12345)
    (tmp_path / "theirs").chmod(mode)
    with pytest.raises(InputError, match="others can write into"):
        check_private(tmp_path / "theirs")
