"""Which files a command opens below the current folder: those that it was told, and none that a library looks for."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

from pipeline.workflow.run import run_prototype
from tests.faults.small_run import write_prototype
from tests.prototypes import Silent

DECOYS = (
    ".numba_config.yaml", "matplotlibrc", ".pylintrc", "numpy.py", ".h5py", "pandas.py", "setup.cfg", "pyproject.toml",
    ".pint", "sitecustomize.py", "usercustomize.py", ".coveragerc", "tox.ini", "pytest.ini", ".env", "pipeline.py",
    "cli.py", "debist.toml", ".debist.toml", "json.py", "typing.py", "scipy.py", "numba.py", "pyarrow.py", "h5py.py",
    "matplotlib.py", "pydantic.py", "logging.conf", ".gitignore", "pint.py", "jinja2.py", "mplstyle", ".jinja2",
)  # fmt: skip
WATCHED = """
import os, sys
home, log = os.getcwd(), os.open({log!r}, os.O_WRONLY | os.O_CREAT | os.O_APPEND)
def watch(event, arguments):
    if event == "open" and isinstance(arguments[0], (str, bytes)):
        path = os.path.abspath(os.fsdecode(arguments[0]))
        if path.startswith(home + os.sep) and os.path.lexists(path):  # else it is relative to a descriptor
            os.write(log, (os.path.relpath(path, home) + "\\n").encode())
sys.addaudithook(watch)
import cli
sys.argv = ["debist", *{arguments!r}]
cli.app()
"""


@pytest.fixture(scope="module")
def made(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with the logs, the settings and the run of a prototype, below it a current folder with decoys."""
    folder = tmp_path_factory.mktemp("opened")
    run_prototype(write_prototype(folder), folder / "run", Silent(), with_report=False)
    here = folder / "here"
    here.mkdir()
    for name in DECOYS:
        (here / name).write_text("raise SystemExit('a decoy was read')\n", encoding="utf-8")
    return here


def opened(here: Path, *arguments: str) -> set[str]:
    """What a command opens below the current folder."""
    log = here.parent / "opened.txt"
    log.unlink(missing_ok=True)
    environment = {k: v for k, v in os.environ.items() if not k.startswith(("COV_", "COVERAGE", "PYTEST"))}
    code = WATCHED.format(log=str(log), arguments=list(arguments))
    done = subprocess.run(
        [sys.executable, "-P", "-c", code], cwd=here, env=environment, capture_output=True, text=True, timeout=300
    )
    assert done.returncode == 0, done.stderr
    return set(log.read_text(encoding="utf-8").splitlines()) if log.exists() else set()


@pytest.mark.parametrize(
    "arguments",
    [
        ("run", "../small.toml", "-o", "../run"),  # and the report, which is missing
        pytest.param(("inspect", "../train.csv"), marks=pytest.mark.long),
        pytest.param(("verify", "../run"), marks=pytest.mark.long),
        # The report comes before what reads its datasheet.
        pytest.param(("report", "../run", "--figures", "sans"), marks=pytest.mark.long),
        pytest.param(("show", "../run"), marks=pytest.mark.long),
        pytest.param(("export", "../run", "--to", "fmu", "-o", "../out"), marks=pytest.mark.long),
        pytest.param(("export", "../run", "--to", "matlab", "-o", "../out"), marks=pytest.mark.long),
        pytest.param(("export", "../run", "--to", "crate", "-o", "../out"), marks=pytest.mark.long),
        pytest.param(
            ("rig", "simulate", "-o", "../rig", "--kind", "nominal", "--duration", "2"), marks=pytest.mark.long
        ),
    ],
    ids=lambda arguments: " ".join(arguments[:1] + arguments[3:4]) if arguments[0] == "export" else arguments[0],
)
def test_no_command_opens_what_it_was_not_told(made: Path, arguments: tuple[str, ...]) -> None:
    assert opened(made, *arguments) == set()
    assert {each.name for each in made.iterdir()} == set(DECOYS)


def test_what_a_command_was_told_is_all_that_it_opens(made: Path) -> None:
    """Named files below the current folder are seen by the watch, and only those."""
    names = {"small.toml", *(path.name for path in made.parent.glob("*.csv"))}
    for name in names:
        (made / name).write_bytes((made.parent / name).read_bytes())
    try:
        assert opened(made, "run", "small.toml", "-o", "../other", "--dry-run") == names
    finally:
        for name in names:
            (made / name).unlink()
